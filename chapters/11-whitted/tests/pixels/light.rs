use super::seen;
use shading::Rgb;

/// Straight down on a floor, with a light above it; what is between them comes after.
const FLOOR: &str = "ambient = [0.5, 0.5, 0.5]
background = [1, 1, 1]
[camera]
eye = [0, 1, 0]
forward = [0, -1, 0]
up = [0, 0, -1]
[[light]]
position = [0, 8, 0]
intensity = [2, 1, 0.5]
[material.floor]
color = [0.5, 1.0, 0.25]
ambient = 0.25
diffuse = 0.5
specular = 0.125
shininess = 7
[material.clear]
ambient = 0
diffuse = 0
transmit = 1
ior = 1.5
[[object]]
plane = { point = [0, 0, 0], normal = [0, 1, 0] }
material = \"floor\"
";

/// r_a I_a C = (1/16, 1/8, 1/32). n⃗ = s⃗ = c⃗ = m⃗, so that r_d I C = (1/2, 1/2, 1/16) and r_s I = (1/4,
/// 1/8, 1/16).
#[test]
fn straight_down_every_cosine_is_1() {
    let lit = [0.0625 + 0.5 + 0.25, 0.125 + 0.5 + 0.125, 0.03125 + 0.0625 + 0.0625];
    assert_eq!(seen(FLOOR), [Rgb(lit); 2]);
}

/// What is transparent casts a shadow, too: V is 0 or 1.
#[test]
fn glass_casts_a_shadow() {
    let under =
        format!("{FLOOR}[[object]]\nsphere = {{ center = [0, 4, 0], radius = 1 }}\nmaterial = \"clear\"\n");
    assert_eq!(seen(&under), [Rgb([0.0625, 0.125, 0.03125]); 2]);
    // beyond the light it casts none
    let beyond = under.replace("[0, 4, 0]", "[0, 9.5, 0]");
    assert_eq!(seen(&beyond), seen(FLOOR));
}

/// 3-4-5: a light with n⃗·s⃗ = 3/5, and a mirror direction m⃗ with c⃗·m⃗ = 3/5. E = r_a I_a C + r_d I C 3/5 +
/// r_s I (3/5)².
#[test]
fn a_light_from_the_side() {
    let side = FLOOR
        .replace("position = [0, 8, 0]", "position = [8, 6, 0]")
        .replace("shininess = 7", "shininess = 2");
    let lit = [
        0.0625 + 0.5 * 0.6 + 0.25 * 0.36,
        0.125 + 0.5 * 0.6 + 0.125 * 0.36,
        0.03125 + 0.0625 * 0.6 + 0.0625 * 0.36,
    ];
    let [double, single] = seen(&side);
    for (channel, lit) in lit.into_iter().enumerate() {
        // a dozen roundings of numbers below 1
        assert!((double.0[channel] - lit).abs() < 12.0 * f64::EPSILON, "{double:?}");
        assert!((single.0[channel] - lit).abs() < 12.0 * f64::from(f32::EPSILON), "{single:?}");
    }
}

/// Slip 17: under the floor's horizon no light is seen, nor its highlight.
#[test]
fn a_light_below_the_floor_adds_nothing() {
    let below = FLOOR.replace("position = [0, 8, 0]", "position = [0, -8, 0]");
    assert_eq!(seen(&below), [Rgb([0.0625, 0.125, 0.03125]); 2]);
}

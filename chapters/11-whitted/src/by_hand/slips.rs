//! What the page's pseudo-code and its E would see if they were taken at their word, and what they mean.

use super::*;

const DOWN_Z: [f64; 3] = [0.0, 0.0, -1.0];

/// The page's "Ig = Ispec + Irefr", its variables set only where something is computed: elsewhere they are
/// what they were.
#[derive(Default)]
struct AsPrinted {
    spec: f64,
    refr: f64,
}

impl AsPrinted {
    fn global(&mut self, mirrored: Option<f64>, refracted: Option<f64>) -> f64 {
        self.spec = mirrored.unwrap_or(self.spec);
        self.refr = refracted.unwrap_or(self.refr);
        self.spec + self.refr
    }
}

/// Slip 18. A mirror, r_g = 0.5, that sees a matte ball, and after it that ball itself, with r_a = 0.1 both
/// and without a light. By hand the mirror brings 0.5 · 0.1, and the ball nothing.
#[test]
fn as_printed_a_matte_surface_mirrors_what_was_mirrored_before() {
    let mut printed = AsPrinted::default();
    let mirrored = printed.global(Some(0.5 * 0.1), None);
    assert_eq!(mirrored, 0.05);
    assert_eq!(printed.global(None, None), 0.05, "nothing was traced, and it is as bright as before");

    let materials = "[material.m]\n[material.mirror]\nmirror = 0.5\n";
    let floor = of("mirror", "plane = { point = [0, 0, 0], normal = [0, 0, 1] }");
    let scene = [materials, &floor, &sphere([0.0, 0.0, 9.0], 1.0)].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [0.1 + mirrored; 3]);
    assert_sees([0.0, 0.0, 5.0], [0.0, 0.0, 1.0], &scene, [0.1; 3]);
}

/// Slip 26: E = r_a I_a + … + r_g I_spec. A clear pane adds nothing of its own: as printed it is black, and
/// by the page's own pseudo-code what is behind it is seen.
#[test]
fn as_printed_a_clear_pane_is_black() {
    let (r_a, r_d, r_g, r_t, background) = (0.0, 0.0, 0.0, 0.75, 0.5);
    let printed: f64 = r_a + r_d + r_g * background;
    assert_eq!(printed, 0.0);
    let sky = format!("background = [{background}, {background}, {background}]\n");
    let clear = format!("{sky}[material.m]\nambient = {r_a:?}\ndiffuse = {r_d:?}\ntransmit = {r_t}\n");
    let scene = [&clear, &plane([0.0; 3], [0.0, 0.0, 1.0])[..]].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [printed + r_t * background; 3]);
}

/// Slip 26: findFirstHit(ā, b⃗) intersects "ray r⃗_ij(λ) and object", the pixel's ray whatever ā and b⃗ are.
/// So a mirror sees in itself what the eye sees, the mirror, and not what is before it.
#[test]
fn as_printed_a_mirror_sees_itself() {
    let (r_a, r_g, background) = (0.1, 0.5, 1.0);
    let by_hand =
        |depth: i32| (0..depth).map(|bounce| r_a * math::portable::pow(r_g, bounce.into())).sum::<f64>();
    assert_eq!(by_hand(3), 0.1 + 0.05 + 0.025);
    let mirror = format!("max_depth = 3\nbackground = [1, 1, 1]\n[material.m]\nmirror = {r_g}\n");
    let scene = [&mirror, &plane([0.0; 3], [0.0, 0.0, 1.0])[..]].concat();
    let meant = r_a + r_g * background;
    assert!((meant - by_hand(3)).abs() > 0.4);
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [meant; 3]);
}

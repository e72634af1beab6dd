use super::{seen, tree};
use glam::DVec3;
use shading::Rgb;

/// A ball of radius 1 at the origin, which a ray along −z meets `off` its middle.
fn ball(ior: f64, off: f64) -> String {
    format!(
        "max_depth = 5
background = [0.3, 0.6, 0.9]
[camera]
eye = [{off}, 0, 4]
forward = [0, 0, -1]
[material.glass]
ambient = 0
diffuse = 0
transmit = 1
ior = {ior:?}
[[object]]
sphere = {{ center = [0, 0, 0], radius = 1 }}
material = \"glass\"
"
    )
}

/// 1 · (1 · background), and no direction is bent: to the last bit.
#[test]
fn a_ball_of_air_cannot_be_seen() {
    for off in [0.0, 0.1, 0.5, 0.75, 0.99, 1.5] {
        assert_eq!(seen(&ball(1.0, off)), [Rgb([0.3, 0.6, 0.9]); 2], "{off}");
        let tree = tree::<f64>(&ball(1.0, off));
        assert_eq!(tree.nodes.len(), if off < 1.0 { 3 } else { 1 });
        assert!(tree.nodes.iter().all(|node| node.sent.ray.direction == DVec3::NEG_Z), "{off}");
    }
}

/// θ1 = 0 passes unbent.
#[test]
fn through_the_middle_nothing_is_bent() {
    for ior in [0.5, 1.0, 1.33, 1.5, 2.42] {
        let tree = tree::<f64>(&ball(ior, 0.0));
        assert_eq!(tree.nodes.len(), 3);
        assert!(tree.nodes.iter().all(|node| node.sent.ray.direction == DVec3::NEG_Z), "{ior}");
        assert_eq!(tree.nodes[0].e, Rgb([0.3, 0.6, 0.9]));
    }
}

/// Off the middle by b = sin θ1 a ray is bent twice by θ1 − θ2, toward the axis, with sin θ2 = b / n.
#[test]
fn a_ball_bends_twice_by_the_same_angle() {
    for (ior, off) in [(1.33, 0.25), (1.5, 0.5), (1.5, 0.9), (2.42, 0.75)] {
        let tree = tree::<f64>(&ball(ior, off));
        let out = tree.nodes[2].sent.ray.direction;
        let turn = 2.0 * (off.asin() - (off / ior).asin());
        let expected = DVec3::new(-turn.sin(), 0.0, -turn.cos());
        // two refractions and two hits, each a few roundings of numbers up to 4
        assert!((out - expected).length() < 64.0 * f64::EPSILON, "{ior} {off}: {out} {expected}");
    }
}

/// A slab 2 thick: a cylinder's two caps. At 45° in and out again, a little to the side.
#[test]
fn a_slab_only_shifts() {
    let text = "max_depth = 5
[camera]
eye = [-4, 0, 5]
forward = [1, 0, -1]
[material.glass]
transmit = 1
ior = 1.5
[[object]]
cylinder = {}
transform = [{ scale = [50, 50, 1] }]
material = \"glass\"
";
    let tree = tree::<f64>(text);
    let [eye, out] = [0, 2].map(|node| tree.nodes[node].sent.ray);
    let along = eye.direction.normalize();
    assert!((out.direction - along).length() < 16.0 * f64::EPSILON, "{out:?}");
    // it would have come out at the depth times tan θ1; it does at tan θ2, with sin θ2 = sin θ1 / n
    let theta2 = (0.5_f64.sqrt() / 1.5).asin();
    let expected = DVec3::new(0.0 + 2.0 * theta2.tan(), 0.0, -1.0);
    assert!((out.origin - expected).length() < 64.0 * f64::EPSILON, "{out:?} {expected}");
}

/// From within water to its surface, at θ1.
fn under_water(theta1: f64) -> String {
    let (sin, cos) = theta1.to_radians().sin_cos();
    format!(
        "max_depth = 2
background = [1, 1, 1]
[camera]
eye = [0, 0, 0]
forward = [{sin:?}, 0, {cos:?}]
up = [0, 1, 0]
[material.water]
ambient = 0.25
diffuse = 0
transmit = 0.5
ior = 1.33
[[object]]
cylinder = {{}}
transform = [{{ scale = [200, 200, 1] }}]
material = \"water\"
"
    )
}

/// The critical angle of water is 48.75°: before it r_a I_a C + r_t times the sky, beyond it the sky is lost
/// (slip 18).
#[test]
fn beyond_the_critical_angle_nothing_comes_in() {
    for (theta1, e) in [(10.0, 0.75), (48.7, 0.75), (48.8, 0.25), (70.0, 0.25)] {
        assert_eq!(seen(&under_water(theta1)), [Rgb([e; 3]); 2], "{theta1}");
    }
}

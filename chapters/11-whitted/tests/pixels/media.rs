//! The indices on both sides of every surface that a ray comes to, straight through the middle of balls.

use super::indices;

/// Balls on the z axis, as (center, radius, index), seen from `eye` along −z.
fn balls(eye: f64, all: &[(f64, f64, f64)]) -> String {
    let mut text = format!("max_depth = 20\n[camera]\neye = [0, 0, {eye:?}]\nforward = [0, 0, -1]\n");
    for (at, (center, radius, ior)) in all.iter().enumerate() {
        text += &format!(
            "[material.m{at}]
transmit = 1
ior = {ior:?}
[[object]]
sphere = {{ center = [0, 0, {center:?}], radius = {radius:?} }}
material = \"m{at}\"
"
        );
    }
    text
}

const NESTED: [(f64, f64, f64); 3] = [(0.0, 3.0, 1.5), (0.0, 2.0, 1.2), (0.0, 1.0, 1.8)];

#[test]
fn nested_balls_one_after_the_other_in_and_out() {
    let expected = [(1.0, 1.5), (1.5, 1.2), (1.2, 1.8), (1.8, 1.2), (1.2, 1.5), (1.5, 1.0)];
    assert_eq!(indices(&balls(9.0, &NESTED)), expected);
    // whatever their order in the file
    let mut turned = NESTED;
    turned.reverse();
    assert_eq!(indices(&balls(9.0, &turned)), expected);
}

/// The ray's line, followed from behind, entered the outer ball first.
#[test]
fn an_eye_inside_of_all_of_them() {
    let expected = [(1.8, 1.2), (1.2, 1.5), (1.5, 1.0)];
    assert_eq!(indices(&balls(0.5, &NESTED)), expected);
    assert_eq!(indices(&balls(1.5, &NESTED)), [(1.2, 1.8), (1.8, 1.2), (1.2, 1.5), (1.5, 1.0)]);
}

/// Into the first, into the second, out of the first (the second is on top of it and stays so), out of the
/// second.
#[test]
fn balls_that_overlap() {
    let all = [(1.0, 1.5, 1.5), (-1.0, 1.5, 1.3)];
    assert_eq!(indices(&balls(9.0, &all)), [(1.0, 1.5), (1.5, 1.3), (1.3, 1.3), (1.3, 1.0)]);
    // where both are: the one entered last is on top
    assert_eq!(indices(&balls(0.0, &all)), [(1.3, 1.3), (1.3, 1.0)]);
}

/// One after the other, with air between them.
#[test]
fn balls_apart() {
    let all = [(2.0, 1.0, 1.5), (-2.0, 1.0, 1.3)];
    assert_eq!(indices(&balls(9.0, &all)), [(1.0, 1.5), (1.5, 1.0), (1.0, 1.3), (1.3, 1.0)]);
}

/// A surface without an inside changes no medium: a sheet of glass within a ball of water.
#[test]
fn a_sheet_within_a_ball() {
    let sheet = "
[material.sheet]
transmit = 1
ior = 1.8
[[object]]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
material = \"sheet\"
";
    let text = balls(9.0, &[(0.0, 1.0, 1.33)]) + sheet;
    assert_eq!(indices(&text), [(1.0, 1.33), (1.33, 1.33), (1.33, 1.0)]);
}

use super::*;

const DARK: [f64; 3] = [0.1; 3];
/// 0.1 + 0.9 n·s with n·s = 1.
const BRIGHT: [f64; 3] = [1.0; 3];
const DOWN_Z: [f64; 3] = [0.0, 0.0, -1.0];

#[test]
fn a_light_at_the_eye() {
    let scene = [MATTE, &sphere([0.0; 3], 1.0), &light([0.0, 0.0, 5.0])].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, BRIGHT);
}

/// The unit sphere is hit at (0, 0, 1).
#[test]
fn a_light_at_the_very_point_is_not_seen() {
    let at = |position| [MATTE, &sphere([0.0; 3], 1.0), &light(position)].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &at([0.0, 0.0, 1.0]), DARK);
    // elsewhere on the sphere it is below the point's horizon
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &at([0.6, 0.0, 0.8]), DARK);
}

#[test]
fn a_light_in_the_plane_that_it_would_light() {
    let scene = [MATTE, &plane([0.0; 3], [0.0, 0.0, 1.0]), &light([2.0, 1.0, 0.0])].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, DARK);
}

/// A light above the floor's origin, by a sphere from z = 2 to z = 4. "Strictly between p and the light."
#[test]
fn a_light_on_another_surface_is_seen_from_its_own_side() {
    let at = |z: f64| {
        let floor = plane([0.0; 3], [0.0, 0.0, 1.0]);
        [MATTE, &floor, &sphere([0.0, 0.0, 3.0], 1.0), &light([0.0, 0.0, z])].concat()
    };
    let sees = |z, expected| assert_sees([4.0, 0.0, 4.0], [-1.0, 0.0, -1.0], &at(z), expected);
    sees(1.0, BRIGHT);
    sees(2.0, BRIGHT);
    sees(3.0, DARK);
    sees(4.0, DARK);
    sees(5.0, DARK);
}

/// From without the light at the center is behind the surface; from within it is straight ahead of it.
#[test]
fn a_light_inside_an_object() {
    let scene = [MATTE, &sphere([0.0; 3], 1.0), &light([0.0; 3])].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, DARK);
    assert_sees([0.0, 0.0, 0.5], [0.0, 0.0, 1.0], &scene, BRIGHT);
}

/// "An object, transparent or not, and the object itself included."
#[test]
fn what_lets_light_through_has_a_shadow_all_the_same() {
    let glass = "[material.m]\ntransmit = 1\nior = 1.5\n[material.floor]\n";
    let floor = of("floor", "plane = { point = [0, 0, 0], normal = [0, 0, 1] }");
    let scene = [glass, &floor, &sphere([0.0, 0.0, 3.0], 1.0), &light([0.0, 0.0, 5.0])].concat();
    assert_sees([4.0, 0.0, 4.0], [-1.0, 0.0, -1.0], &scene, DARK);
    let matte = [MATTE, &sphere([0.0; 3], 1.0), &light([0.0, 0.0, 5.0])].concat();
    // the eye within sees the wall from behind: the sphere itself stands before the light
    assert_sees([0.0, 0.0, 0.5], [0.0, 0.0, 1.0], &matte, DARK);
}

/// The earlier one is seen, and none of them is in the other's light.
#[test]
fn coincident_surfaces() {
    let colors = "[material.red]\ncolor = [1, 0, 0]\n[material.green]\ncolor = [0, 1, 0]\n";
    let shapes = [
        "plane = { point = [0, 0, 0], normal = [0, 0, 1] }",
        "plane = { point = [3, 7, 0], normal = [0, 0, -2] }",
        "polygon = { vertices = [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]] }",
        "triangle = { vertices = [[-9, -9, 0], [20, -9, 0], [-9, 20, 0]] }",
    ];
    for (first, second) in shapes.iter().flat_map(|a| shapes.iter().map(move |b| (a, b))) {
        let scene = [colors, &of("red", first), &of("green", second), &light([0.0, 0.0, 3.0])].concat();
        assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [1.0, 0.0, 0.0]);
        let scene = [colors, &of("green", first), &of("red", second), &light([0.0, 0.0, 3.0])].concat();
        assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [0.0, 1.0, 0.0]);
    }
    let ball = "sphere = { center = [0, 0, 0], radius = 1 }";
    let scene = [colors, &of("red", ball), &of("green", ball), &light([0.0, 0.0, 3.0])].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &scene, [1.0, 0.0, 0.0]);
}

/// What is infinite is white, and what is far away is seen.
#[test]
fn numbers_at_the_end_of_their_range() {
    let bright = "[[light]]\nposition = [0, 0, 5]\nintensity = [1e308, 1, 1]\n".repeat(3);
    let scene = [MATTE, &sphere([0.0; 3], 1.0), &bright].concat();
    for tree in trees::<f64>([0.0, 0.0, 5.0], DOWN_Z, &scene) {
        assert_eq!((tree.sum, tree.nodes[0].e), (tree.nodes[0].e, tree.sum));
        assert_eq!(tree.sum.0[0], f64::INFINITY);
        assert_eq!(stage::Color::from_linear(tree.sum.0).0, [255; 3]);
    }
    let far = [MATTE, &sphere([0.0, 0.0, -1e12], 1e11), &light([0.0, 0.0, 1e12])].concat();
    assert_sees([0.0, 0.0, 5.0], DOWN_Z, &far, BRIGHT);
}

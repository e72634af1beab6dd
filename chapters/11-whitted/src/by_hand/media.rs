use super::*;

/// Three materials of clear glass, `m1` to `m3`, with these indices.
fn glasses(iors: [f64; 3]) -> String {
    let one = |(place, ior): (usize, f64)| {
        format!("[material.m{}]\nambient = 0\ndiffuse = 0\ntransmit = 1\nior = {ior}\n", place + 1)
    };
    iors.into_iter().enumerate().map(one).collect()
}

fn ball(material: &str, center: [f64; 3], radius: f64) -> String {
    of(material, &format!("sphere = {{ center = {center:?}, radius = {radius} }}"))
}

/// (n1, n2) at every surface that the ray goes through, in order. It is the same in every way.
fn passed(eye: [f64; 3], forward: [f64; 3], text: &str) -> Vec<(f64, f64)> {
    let of = |tree: &Tree<f64>| -> Vec<(f64, f64)> {
        let refractions = tree.nodes.iter().filter_map(|node| Some(node.landed.as_ref()?.refraction?.0));
        refractions.map(|refraction| (refraction.n1, refraction.n2)).collect()
    };
    let text = format!("max_depth = 9\nbackground = [0.25, 0.5, 1.0]\n{text}");
    let all: Vec<_> = trees::<f64>(eye, forward, &text).iter().map(of).collect();
    assert!(all.iter().all(|one| *one == all[0]), "{all:?}");
    // straight on, and nothing is lost on the way
    assert_sees(eye, forward, &text, [0.25, 0.5, 1.0]);
    all[0].clone()
}

const UP_Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Spheres of radius 1, 2 and 3 about the eye, in any order in the file: the outermost was entered first.
#[test]
fn an_eye_inside_nested_solids() {
    let balls = [ball("m1", [0.0; 3], 1.0), ball("m2", [0.0; 3], 2.0), ball("m3", [0.0; 3], 3.0)];
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0], [1, 0, 2]] {
        let scene = glasses([1.5, 1.2, 1.33]) + &order.map(|place| balls[place].clone()).concat();
        for forward in [UP_Z, [0.3, -0.2, -1.0]] {
            assert_eq!(passed([0.0; 3], forward, &scene), [(1.5, 1.2), (1.2, 1.33), (1.33, 1.0)]);
        }
    }
}

/// Two that overlap, z from −2 to 2 and from −1 to 3: which one the eye's ray entered last depends on where
/// it looks, and the first to be left is not the last that was entered.
#[test]
fn an_eye_where_two_solids_overlap() {
    let scene = glasses([1.5, 1.2, 1.0]) + &ball("m1", [0.0; 3], 2.0) + &ball("m2", [0.0, 0.0, 1.0], 2.0);
    assert_eq!(passed([0.0, 0.0, 0.5], UP_Z, &scene), [(1.2, 1.2), (1.2, 1.0)]);
    assert_eq!(passed([0.0, 0.0, 0.5], [0.0, 0.0, -1.0], &scene), [(1.5, 1.5), (1.5, 1.0)]);
    // from outside
    assert_eq!(passed([0.0, 0.0, -9.0], UP_Z, &scene), [(1.0, 1.5), (1.5, 1.2), (1.2, 1.2), (1.2, 1.0)]);
}

/// A drop of water in glass, and a bubble of air in it: entering pushes, leaving takes out.
#[test]
fn solids_in_solids() {
    let scene = glasses([1.5, 1.33, 1.0])
        + &ball("m1", [0.0; 3], 3.0)
        + &ball("m2", [0.0; 3], 2.0)
        + &ball("m3", [0.0; 3], 1.0);
    let expected = [(1.0, 1.5), (1.5, 1.33), (1.33, 1.0), (1.0, 1.33), (1.33, 1.5), (1.5, 1.0)];
    assert_eq!(passed([0.0, 0.0, 9.0], [0.0, 0.0, -1.0], &scene), expected);
}

/// An eye on a solid that looks into it enters it, at λ = 0; one that looks away was never in it.
#[test]
fn an_eye_on_a_solid() {
    let scene = glasses([1.5, 1.0, 1.0]) + &ball("m1", [0.0; 3], 1.0);
    assert_eq!(passed([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], &scene), [(1.0, 1.5), (1.5, 1.0)]);
    assert_eq!(passed([0.0, 0.0, 1.0], UP_Z, &scene), [(1.0, 1.0)]);
}

/// What has no inside bends nothing, whatever its index, and does not belong to the media.
#[test]
fn surfaces_are_passed_unbent() {
    let pane = of("m2", "plane = { point = [0, 0, 0], normal = [1, 0, 2] }");
    let scene = glasses([1.5, 1.8, 1.0]) + &ball("m1", [0.0; 3], 2.0) + &pane;
    let expected = [(1.0, 1.5), (1.5, 1.5), (1.5, 1.0)];
    assert_eq!(passed([0.0, 0.0, 9.0], [0.0, 0.0, -1.0], &scene), expected);
}

/// Cylinders and cones are solids too. The eye is in both, the cylinder from z = −1 to 1, the cone from 0 to
/// 1.
#[test]
fn an_eye_in_a_cylinder_and_a_cone() {
    let scene = glasses([1.5, 1.2, 1.0]) + &of("m2", "cone = {}") + &of("m1", "cylinder = {}");
    // by hand: up the axis the cone's apex is on the cylinder's cap, so aside: the cone ends at x = 0.25 for
    // z = 0.5
    assert_eq!(passed([0.0, 0.0, 0.5], [1.0, 0.0, 0.0], &scene), [(1.2, 1.5), (1.5, 1.0)]);
}

/// Coincident glass: the earlier surface is met, the other is passed with it.
#[test]
fn coincident_solids_let_light_through() {
    let scene = glasses([1.5, 1.2, 1.0]) + &ball("m1", [0.0; 3], 1.0) + &ball("m2", [0.0; 3], 1.0);
    assert_eq!(passed([0.0, 0.0, 9.0], [0.0, 0.0, -1.0], &scene), [(1.0, 1.5), (1.5, 1.0)]);
}

/// By hand: in glass of 1.5 the critical angle is 41.8°; from (0, 0, 0.8) sideways sin θ1 = 0.8: nothing is
/// refracted, and the mirror term stays as it is, 0.25 of the local term 0.1 of the next hit, and so on to
/// depth 3.
#[test]
fn total_internal_reflection_loses_what_would_be_refracted() {
    let glass = "max_depth = 3\nbackground = [9, 9, 9]\n[material.m]\ndiffuse = 0\nmirror = 0.25\ntransmit = 0.75\nior = 1.5\n";
    let scene = [glass, &sphere([0.0; 3], 1.0)].concat();
    let e = 0.1 + 0.25 * (0.1 + 0.25 * 0.1);
    assert_sees([0.0, 0.0, 0.8], [1.0, 0.0, 0.0], &scene, [e; 3]);
    for tree in trees::<f64>([0.0, 0.0, 0.8], [1.0, 0.0, 0.0], &scene) {
        assert_eq!((tree.counts.mirror, tree.counts.refracted), (2, 0));
    }
}

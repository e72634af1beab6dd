use super::*;
use shading::Rgb;

const FORTH: [f64; 3] = [0.0, 0.0, 1.0];

/// Two mirrors that face each other, the eye between them.
fn hall(depth: u32, material: &str) -> String {
    let walls = plane([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]) + &plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]);
    format!("max_depth = {depth}\n[material.m]\ndiffuse = 0\n{material}\n{walls}")
}

/// By hand: each of the 1000 rays brings r_a I_a C = 0.001, with a weight of 1.
#[test]
fn a_thousand_rays_between_two_mirrors() {
    let scene = hall(1000, "ambient = 0.001\nmirror = 1");
    assert_sees([0.0; 3], FORTH, &scene, [1.0; 3]);
    for tree in trees::<f64>([0.0; 3], FORTH, &scene) {
        assert_eq!((tree.counts.mirror, tree.nodes.len()), (999, 1000));
        let deepest = tree.nodes.last().unwrap();
        assert_eq!((deepest.sent.depth, deepest.weight, deepest.children.len()), (1000, 1.0, 0));
    }
}

/// By hand: 1 + ½ + ¼ + … = 2 (1 − 2⁻¹⁰), which is exact.
#[test]
fn the_contributions_add_up_to_what_is_seen() {
    for tree in trees::<f64>([0.0; 3], FORTH, &hall(10, "ambient = 1\nmirror = 0.5")) {
        let by_ray =
            tree.nodes.iter().map(|node| tree.contribution(node)).fold(Rgb::BLACK, |sum, it| sum + it);
        let exact = Rgb([2.0 - 1.0 / 512.0; 3]);
        assert_eq!((tree.nodes[0].e, tree.sum, by_ray), (exact, exact, exact));
    }
}

/// "Traced only while depth < max_depth and only if their coefficient is not 0."
#[test]
fn depth_one_is_local_shading_only() {
    for tree in trees::<f64>([0.0; 3], FORTH, &hall(1, "ambient = 0.25\nmirror = 1\ntransmit = 1\nior = 1.5"))
    {
        assert_eq!((tree.counts.rays(), tree.sum), (1, Rgb([0.25; 3])));
    }
}

/// Coefficients whose sum exceeds 1 are taken as they are: 1 + 1 (background 0.5) + 1 (background 0.5).
#[test]
fn more_light_may_leave_than_comes_in() {
    let wall =
        "background = [0.5, 0.5, 0.5]\n[material.m]\nambient = 1\ndiffuse = 1\nmirror = 1\ntransmit = 1\n";
    let scene = [wall, &plane([0.0; 3], [0.0, 0.0, 1.0])].concat();
    assert_sees([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], &scene, [2.0; 3]);
}

/// Four half-transparent mirrors at z = ±1 and ±2: nearly every ray becomes two, and not all of them are
/// kept. What comes of it follows along the line, without geometry: `gap` counts the walls below the ray.
#[test]
fn rays_that_are_not_kept_are_added_up() {
    fn e(gap: i32, up: bool, depth: u32) -> (f64, u64) {
        let beyond = if up { gap + 1 } else { gap - 1 };
        if !(0..=4).contains(&beyond) {
            return (0.0, 1);
        }
        if depth == 24 {
            return (0.25, 1);
        }
        let (mirrored, through) = (e(gap, !up, depth + 1), e(beyond, up, depth + 1));
        (0.25 + 0.5 * mirrored.0 + 0.5 * through.0, 1 + mirrored.1 + through.1)
    }
    let walls: String = [-2.0, -1.0, 1.0, 2.0].map(|z| plane([0.0, 0.0, z], [0.0, 0.0, 1.0])).concat();
    let material = "[material.m]\ndiffuse = 0\nambient = 0.25\nmirror = 0.5\ntransmit = 0.5\n";
    let (expected, rays) = e(2, true, 1);
    for tree in trees::<f64>([0.0; 3], FORTH, &format!("max_depth = 24\n{material}{walls}")) {
        assert_eq!(tree.counts.rays(), rays);
        assert!(rays > Tree::<f64>::MOST as u64 && tree.nodes.len() == Tree::<f64>::MOST);
        assert!((tree.sum.0[0] - expected).abs() < 1e-12 && (tree.nodes[0].e.0[0] - expected).abs() < 1e-12);
    }
}

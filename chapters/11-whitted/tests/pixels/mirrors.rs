use bounds::Bounded;
use shading::Rgb;
use whitted::render::render;
use whitted::{Requirements, Tracer};

use super::{scene, seen, tree};

/// Straight down on a mirror under a sky.
fn floor(depth: u32) -> String {
    format!(
        "max_depth = {depth}
background = [0.5, 0.25, 4.0]
[camera]
eye = [0, 2, 0]
forward = [0, -1, 0]
up = [0, 0, -1]
[material.floor]
color = [1.0, 0.5, 0.25]
ambient = 0.25
diffuse = 0.5
mirror = 0.5
[[object]]
plane = {{ point = [0, 0, 0], normal = [0, 1, 0] }}
material = \"floor\"
"
    )
}

/// r_a I_a C, and r_g times the sky from depth 2 on. The sky is brighter than 1, and nothing is clamped.
#[test]
fn a_mirror_shows_the_sky() {
    assert_eq!(seen(&floor(1)), [Rgb([0.25, 0.125, 0.0625]); 2]);
    assert_eq!(seen(&floor(2)), [Rgb([0.25 + 0.25, 0.125 + 0.125, 0.0625 + 2.0]); 2]);
    assert_eq!(seen(&floor(9)), seen(&floor(2)));
}

/// A ray that meets nothing.
#[test]
fn nothing_is_the_background() {
    let sky = "background = [0.3, 7.0, 0.0]\n[camera]\neye = [0, 0, 0]\nforward = [0, 0, -1]\n";
    assert_eq!(seen(sky), [Rgb([0.3, 7.0, 0.0]); 2]);
}

/// Between two mirrors.
fn hall(depth: u32) -> String {
    format!(
        "max_depth = {depth}
background = [9, 9, 9]
[camera]
eye = [0.25, 0, 0]
forward = [1, 0, 0]
[material.mirror]
ambient = 0.25
diffuse = 0
mirror = 0.5
[[object]]
plane = {{ point = [1, 0, 0], normal = [1, 0, 0] }}
material = \"mirror\"
[[object]]
plane = {{ point = [-1, 0, 0], normal = [1, 0, 0] }}
material = \"mirror\"
"
    )
}

/// L + r L + … + r^(D − 1) L = L (1 − r^D) / (1 − r), with L = 1/4 and r = 1/2: (1 − 2^−D) / 2. Every sum is
/// a number of f64 down to depth 52.
#[test]
fn between_two_mirrors_a_geometric_series() {
    for depth in [1, 2, 3, 10, 50] {
        let tree = tree::<f64>(&hall(depth));
        assert_eq!(tree.nodes.len(), depth as usize, "rays");
        let sum = 0.5 * (1.0 - 0.5_f64.powi(depth as i32));
        assert_eq!(tree.nodes[0].e, Rgb([sum; 3]), "depth {depth}");
        // each ray adds half of what the one before it adds
        let added: Vec<f64> = tree.nodes.iter().map(|node| tree.contribution(node).0[0]).collect();
        assert!(added.windows(2).all(|pair| pair[1] == pair[0] / 2.0));
    }
}

/// So deep the threads of a picture have room for.
#[test]
fn a_thousand_times_to_and_fro() {
    let scene = scene::<f64>(&hall(1000));
    let requirements = Requirements::of(&scene, 2);
    let bounded = Bounded::new(&scene.lit.geometry, requirements.bounds());
    let tracer = Tracer::new(&scene, &bounded, &requirements, None);
    let rendered = render(&tracer, (1, 1), 1, Some(1), None).unwrap();
    // 2^−1000 of the last one is no digit of the sum
    assert_eq!((rendered.counts.mirror, rendered.radiance[0]), (999, Rgb([0.5; 3])));
}

//! Whole pixels whose color or rays can be worked out by hand.

mod glass;
mod light;
mod media;
mod mirrors;

use std::path::Path;

use bounds::{Bounded, Method};
use math::Real;
use shading::Rgb;
use whitted::{Path as RayPath, Requirements, Scene, Tracer, Tree, from_file};

/// The scene of a text. What is said of the camera goes between the eye and the objects; a picture of one
/// pixel, so that its ray goes straight ahead.
fn scene<R: Real>(text: &str) -> Scene<R> {
    let file = scene_file::Scene::from_toml("a test", text, Path::new("")).unwrap();
    from_file::scene::<R>(&file, Some((1, 1)), None).unwrap()
}

/// All rays of the pixel.
fn tree<R: Real>(text: &str) -> Tree<R> {
    let scene = scene::<R>(text);
    let parts = Bounded::new(&scene.lit.geometry, Method::None).parts();
    let requirements = Requirements::of(&scene, parts);
    let bounded = Bounded::new(&scene.lit.geometry, requirements.bounds());
    let tracer = Tracer::new(&scene, &bounded, &requirements, None);
    let mut tree = Tree::new();
    let e = tracer.pixel((0, 0), 1, &mut RayPath::default(), &mut tree);
    assert_eq!(tree.nodes[0].e, e, "the root of the tree is what the pixel shows");
    tree
}

/// What the pixel shows, in f64 and in f32.
fn seen(text: &str) -> [Rgb; 2] {
    [tree::<f64>(text).nodes[0].e, tree::<f32>(text).nodes[0].e]
}

/// The indices of refraction (n1, n2) in the order in which the rays come to surfaces.
fn indices(text: &str) -> Vec<(f64, f64)> {
    let tree = tree::<f64>(text);
    let landed = tree.nodes.iter().filter_map(|node| node.landed.as_ref());
    landed
        .filter_map(|landed| landed.refraction.map(|(refraction, _)| (refraction.n1, refraction.n2)))
        .collect()
}

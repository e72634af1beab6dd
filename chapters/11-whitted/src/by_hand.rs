//! What the contract says of one ray, by hand, where it is easy to get wrong.

mod lights;
mod media;
mod mirrors;
mod slips;

use bounds::Parts;
use math::Real;
use signature::Method;

use crate::{Requirements, Tracer, Tree, from_file, render};

/// All rays of a picture of one pixel, looking along `forward`; with what the scene requires, and with
/// everything.
fn trees<R: Real>(eye: [f64; 3], forward: [f64; 3], text: &str) -> Vec<Tree<R>> {
    let up = if forward[1] == 0.0 { [0, 1, 0] } else { [0, 0, 1] };
    let camera = format!("[camera]\neye = {eye:?}\nforward = {forward:?}\nup = {up:?}\nsize = [1, 1]\n");
    let text = format!("{text}{camera}");
    let file = scene_file::Scene::from_toml("by-hand.toml", &text, std::path::Path::new("")).unwrap();
    let scene = from_file::scene::<R>(&file, None, None).unwrap();
    let required = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
    let mut trees = Vec::new();
    for method in Method::ALL {
        for requirements in [required, required.everything()] {
            let bounded = requirements.bounded(method, &scene.lit.geometry);
            let tracer = Tracer::new(&scene, &bounded, &requirements, None);
            trees.push(render::tree(&tracer, (0, 0), 1).unwrap());
        }
    }
    trees
}

/// What such a pixel sees, in every way and precision: all three channels, within rounding.
fn assert_sees(eye: [f64; 3], forward: [f64; 3], text: &str, expected: [f64; 3]) {
    let mut seen: Vec<_> = trees::<f64>(eye, forward, text).iter().map(|tree| tree.nodes[0].e.0).collect();
    seen.extend(trees::<f32>(eye, forward, text).iter().map(|tree| tree.nodes[0].e.0));
    for seen in seen {
        for (seen, expected) in seen.into_iter().zip(expected) {
            assert!((seen - expected).abs() < 1e-6, "{seen} is not {expected}:\n{text}");
        }
    }
}

/// An object of the material `m`.
fn sphere(center: [f64; 3], radius: f64) -> String {
    of("m", &format!("sphere = {{ center = {center:?}, radius = {radius} }}"))
}

fn plane(point: [f64; 3], normal: [f64; 3]) -> String {
    of("m", &format!("plane = {{ point = {point:?}, normal = {normal:?} }}"))
}

fn of(material: &str, shape: &str) -> String {
    format!("[[object]]\nmaterial = \"{material}\"\n{shape}\n")
}

fn light(position: [f64; 3]) -> String {
    format!("[[light]]\nposition = {position:?}\nintensity = [1, 1, 1]\n")
}

/// r_a = 0.1 and r_d = 0.9, as they are when nothing is said.
const MATTE: &str = "[material.m]\n";

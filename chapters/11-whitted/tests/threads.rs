//! The same picture and the same counts for every number of threads.

use bounds::{Bounded, Method};
use math::Real;
use whitted::render::{Rendered, render};
use whitted::scenes::SCENES;
use whitted::{Requirements, Tolerance, Tracer, from_file};

/// Columns and rows that no tile divides.
const SIZE: (u32, u32) = (75, 67);

fn rendered<R: Real>(file: &scene_file::Scene, e: Option<f64>, threads: usize) -> Rendered {
    let scene = from_file::scene::<R>(file, Some(SIZE), None).unwrap();
    let parts = Bounded::new(&scene.lit.geometry, Method::None).parts();
    let requirements = Requirements::of(&scene, parts);
    let bounded = Bounded::new(&scene.lit.geometry, requirements.bounds());
    let tracer = Tracer::new(&scene, &bounded, &requirements, e.map(|e| Tolerance::new(&scene, e)));
    render(&tracer, SIZE, 1, Some(threads), None).unwrap()
}

#[test]
fn one_two_three_and_seven_threads_see_the_same() {
    for built_in in SCENES {
        let file = built_in.file().unwrap();
        let one = rendered::<f64>(&file, None, 1);
        assert_eq!(one.counts.eye, u64::from(SIZE.0 * SIZE.1));
        // there is something to see: the colors are not all one
        assert!(one.radiance.iter().any(|e| *e != one.radiance[0]), "{}", built_in.name);
        for threads in [2, 3, 7] {
            assert_eq!(rendered::<f64>(&file, None, threads), one, "{}, {threads} threads", built_in.name);
        }
    }
}

#[test]
fn in_f32_and_with_a_tolerance_too() {
    let file = SCENES[0].file().unwrap();
    let one = rendered::<f32>(&file, Some(0.01), 1);
    assert!(one.counts.left_out > 0);
    assert_eq!(rendered::<f32>(&file, Some(0.01), 7), one);
}

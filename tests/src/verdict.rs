//! The oracle, asked for any stage that has exact answers.

use lab::oracle::{self, UnitObject, Verdict};

use crate::stage_named;

/// What the oracle says of a stage's case, its numbers in the order of the columns, before it is rounded.
/// Panics where the stage has no oracle.
pub fn exact_verdict(stage: &str, case: &[f64]) -> Verdict {
    match stage {
        "ray-wall" => oracle::exact_wall(case.try_into().unwrap()),
        "ray-plane" => oracle::exact_plane(case.try_into().unwrap()),
        "ray-sphere" => oracle::exact_sphere(case.try_into().unwrap()),
        "triangle" => oracle::exact_triangle(case.try_into().unwrap()),
        "quadric" => {
            let (shape, case) = shape_apart(stage, case);
            oracle::exact_quadric(shape, case)
        }
        "affine" => {
            let (shape, case) = shape_apart(stage, case);
            oracle::exact_affine(shape, case)
        }
        _ => panic!("{stage} has exact answers: it needs an oracle here"),
    }
}

/// The shape and the other numbers of a case of `quadric` or `affine`, where it stands after the ray.
fn shape_apart<const N: usize>(stage: &str, case: &[f64]) -> (UnitObject, [f64; N]) {
    let words = stage_named(stage).unwrap().about().words[0].1;
    let word = words[case[6] as usize];
    let shape = UnitObject::ALL.into_iter().find(|shape| shape.name() == word).unwrap();
    (shape, [&case[..6], &case[7..]].concat().try_into().unwrap())
}

//! The kinds of ray and deformed object, and what the notes' methods lose in each.
//!
//! Almost every regime is a ray aimed at a point in an object or near it (`scene`), so that about half of the rays hit,
//! and a matrix that turns, stretches along three axes, and turns again. Its condition is the longest of the three
//! over the shortest. What varies over a scale is drawn log-uniformly.

mod draw;
mod scene;

use lab::Notes::{Hold, LoseDigits, Misjudge};
use lab::Regime;
use stage::Precision::{F32, F64};

use crate::Object::{Cone, Cylinder, Plane, Sphere, Triangle};
use draw::{
    axis_scale, behind, bits, direction_extreme, far, grazing, inside, mirrored, near_parallel, on_surface,
    ordinary, ordinary_of, parallel, scale_extreme, shifted, special, squashed, subnormal, tangent,
    triangle_edge, unnormalized,
};

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, the place of the object in `Object::ALL`, A row by row, and t.
pub fn regimes() -> Vec<Regime<19>> {
    vec![
        Regime {
            name: "ordinary",
            what: "sphere, cylinder or cone, condition up to 10, within 10, origin 5 to 40 away, unit direction",
            draw: |draw| ordinary(draw).numbers(),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "unnormalized",
            what: "ordinary, with a direction of length 1e-6 to 1e6",
            draw: unnormalized,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "behind",
            what: "ordinary, turned round: the object is behind the origin",
            draw: behind,
            notes: Hold("every λ is far below zero"),
        },
        Regime {
            name: "inside",
            what: "ordinary, the origin well within the object",
            draw: inside,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "mirrored",
            what: "ordinary, with a matrix that mirrors: det A < 0",
            draw: mirrored,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "condition-1",
            what: "a sphere turned, of radius 1",
            draw: |draw| squashed(draw, Sphere, 1.0),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "condition-1e3",
            what: "a sphere squashed a thousand times",
            draw: |draw| squashed(draw, Sphere, 1e3),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "condition-1e6",
            what: "a sphere squashed a million times",
            draw: |draw| squashed(draw, Sphere, 1e6),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "condition-1e9",
            what: "a sphere squashed 1e9 times (f32: 1e6)",
            draw: |draw| squashed(draw, Sphere, 1e9),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "condition-1e12",
            what: "a sphere squashed 1e12 times (f32: 1e6)",
            draw: |draw| squashed(draw, Sphere, 1e12),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "axis-scale",
            what: "a sphere scaled along each axis by 1e-3 to 1e3",
            draw: axis_scale,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "cylinder-1e6",
            what: "a cylinder squashed a million times",
            draw: |draw| squashed(draw, Cylinder, 1e6),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-1e6",
            what: "a cone squashed a million times",
            draw: |draw| squashed(draw, Cone, 1e6),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-1e12",
            what: "a cone squashed 1e12 times (f32: 1e6)",
            draw: |draw| squashed(draw, Cone, 1e12),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "plane",
            what: "ordinary, of the plane",
            draw: |draw| ordinary_of(draw, Plane),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "plane-1e6",
            what: "the plane by a matrix of condition 1e6",
            draw: |draw| squashed(draw, Plane, 1e6),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "triangle",
            what: "ordinary, of the triangle",
            draw: |draw| ordinary_of(draw, Triangle),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "triangle-1e6",
            what: "a triangle squashed a million times",
            draw: |draw| squashed(draw, Triangle, 1e6),
            notes: Misjudge("notes", F32),
        },
        Regime {
            name: "triangle-edge",
            what: "through an edge or a corner of a triangle in whole numbers; three in four with a number up to 3 ulps off",
            draw: triangle_edge,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "parallel",
            what: "along a plane or a triangle of whole numbers, apart from it or within it",
            draw: parallel,
            notes: Hold("parallel is decided exactly, by every method"),
        },
        Regime {
            name: "near-parallel",
            what: "all but along a plane or a triangle: by 1e-2 to 1e-15 (f32: 1e-7)",
            draw: near_parallel,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "shifted",
            what: "ordinary, everything moved 1e5 to 1e9 (f32: 1e3 to 1e5)",
            draw: shifted,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "far",
            what: "ordinary, from 1e4 to 1e10 away (f32: 1e2 to 1e5)",
            draw: far,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "grazing",
            what: "past a sphere at 1 ± 1e-3 to 1 ± 1e-15 (f32: 1e-7) in its own space",
            draw: grazing,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "tangent",
            what: "touching a sphere exactly, in whole numbers; three in four with a number up to 3 ulps off",
            draw: tangent,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "on-surface",
            what: "ordinary, the origin a rounded point of the surface: a secondary ray",
            draw: on_surface,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "direction-extreme",
            what: "ordinary, with a direction of length 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: direction_extreme,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "scale-extreme",
            what: "ordinary, all lengths times 1e±60 to 1e±290 (f32: 1e±10 to 1e±30)",
            draw: scale_extreme,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, scaled until every length is subnormal; every other direction too",
            draw: subnormal,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "special",
            what: "any object, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "bits",
            what: "any object, the other numbers of any bits",
            draw: bits,
            notes: Misjudge("notes", F64),
        },
    ]
}

//! The kinds of ray and triangle, and what the notes' methods lose in each.
//!
//! Almost every regime is a ray aimed at a point of a triangle's plane: how large is the triangle, how far
//! away, how near to an edge is the point? What varies over a scale is drawn log-uniformly. Where nothing else is
//! said, half of the rays hit.

mod draw;

use lab::Notes::{Hold, LoseDigits, Misjudge};
use lab::Regime;
use stage::Precision::{F32, F64};

use draw::{
    behind, bits, direction_extreme, edge, edge_exact, far, grazing, huge, on_plane, ordinary, parallel,
    scale_extreme, shifted, sliver, special, subnormal, tiny, unnormalized, vertex,
};

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, and the triangle's three corners.
pub fn regimes() -> Vec<Regime<15>> {
    vec![
        Regime {
            name: "ordinary",
            what: "size 0.1 to 5, within 10, origin 5 to 40 away, unit direction",
            draw: |draw| ordinary(draw).numbers(),
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "unnormalized",
            what: "ordinary, with a direction of length 1e-6 to 1e6",
            draw: unnormalized,
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "behind",
            what: "ordinary, turned round: the triangle is behind the origin",
            draw: behind,
            notes: Hold("λ is far below zero"),
        },
        Regime {
            name: "edge",
            what: "ordinary, aimed at a rounded point of an edge",
            draw: edge,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "vertex",
            what: "ordinary, aimed at a corner, the direction rounded",
            draw: vertex,
            notes: Misjudge("half-planes", F64),
        },
        Regime {
            name: "edge-exact",
            what: "exactly through an edge or a corner, in whole numbers: all hit",
            draw: edge_exact,
            notes: Hold(
                "small whole numbers are not rounded, and of α and β that sum to 1 the roundings cancel",
            ),
        },
        Regime {
            name: "sliver-1e3",
            what: "a thousand times as long as high (f32: a hundred times)",
            draw: |draw| sliver(draw, 1e3, 1e2),
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "sliver-1e6",
            what: "a million times as long as high (f32: a thousand times)",
            draw: |draw| sliver(draw, 1e6, 1e3),
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "sliver-1e9",
            what: "a billion times as long as high (f32: ten thousand times)",
            draw: |draw| sliver(draw, 1e9, 1e4),
            notes: Misjudge("half-planes", F64),
        },
        Regime {
            name: "grazing",
            what: "all but along the plane: off by 1e-2 to 1e-12 (f32: 1e-6) of its length",
            draw: grazing,
            notes: Misjudge("matrix", F32),
        },
        Regime {
            name: "parallel",
            what: "along the plane or within it, in whole numbers; three in four with a number up to 3 ulps off",
            draw: parallel,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "far",
            what: "1e2 to 1e8 sizes away (f32: 1e2 to 1e4)",
            draw: far,
            notes: Misjudge("matrix", F32),
        },
        Regime {
            name: "tiny",
            what: "size 1e-9 to 1e-3, origin 5 to 40 away",
            draw: tiny,
            notes: Misjudge("matrix", F32),
        },
        Regime {
            name: "huge",
            what: "size 1e3 to 1e9, origin 5 to 40 from the point that it is aimed at",
            draw: huge,
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "shifted",
            what: "ordinary, everything moved 1e5 to 1e12 (f32: 1e3 to 1e5)",
            draw: shifted,
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "on-plane",
            what: "the origin a rounded point of the plane, any direction: a secondary ray",
            draw: on_plane,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "direction-extreme",
            what: "ordinary, with a direction of length 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: direction_extreme,
            notes: LoseDigits("matrix", F64),
        },
        Regime {
            name: "scale-extreme",
            what: "ordinary, all lengths times 1e±87 to 1e±290 (f32: 1e±12 to 1e±30)",
            draw: scale_extreme,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, scaled until every length is subnormal; every other direction too",
            draw: subnormal,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "special",
            what: "ordinary, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Misjudge("matrix", F64),
        },
        Regime {
            name: "bits",
            what: "fifteen numbers of any bits",
            draw: bits,
            notes: Misjudge("matrix", F64),
        },
    ]
}

//! The kinds of ray and sphere, and what the notes' methods lose in each.
//!
//! Almost every regime is a ray aimed at a sphere (`aimed`): how large is the sphere, how far away, how
//! near to its rim does the ray pass? What varies over a scale is drawn log-uniformly. Where a ray is
//! aimed it passes the center at any part of 1.5 radii, so that it misses a third of the time.

mod draw;

use lab::Notes::{Hold, LoseDigits, Misjudge};
use lab::Regime;
use stage::Precision::{F32, F64};

use draw::{
    behind, bits, direction_extreme, far, far_beyond, grazing, grazing_far, ground, huge, inside, moved,
    moved_anywhere, on_surface, on_surface_exact, ordinary, scale_extreme, special, subnormal, tangent, tiny,
    tiny_of_any_size, unnormalized,
};
pub(crate) use draw::{ordinary_that, passing};

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, and the sphere's center and radius.
pub fn regimes() -> Vec<Regime<10>> {
    vec![
        Regime {
            name: "ordinary",
            what: "radius 0.1 to 5, center within 10, origin 5 to 40 from it, unit direction",
            draw: |draw| ordinary(draw).numbers(),
            notes: LoseDigits("quadratic", F64),
        },
        Regime {
            name: "unnormalized",
            what: "ordinary, with a direction of length 1e-6 to 1e6",
            draw: unnormalized,
            notes: LoseDigits("quadratic", F64),
        },
        Regime {
            name: "behind",
            what: "ordinary, turned round: the sphere is behind the origin",
            draw: behind,
            notes: Hold("both roots are far below zero"),
        },
        Regime {
            name: "inside",
            what: "radius 1 to 5, the origin within 0.9 radii of the center",
            draw: inside,
            notes: Hold("t is never below a tenth of the radius: one digit cancels, not more"),
        },
        Regime {
            name: "far-1e2",
            what: "a hundred radii away",
            draw: |draw| far(draw, 1e2),
            notes: LoseDigits("quadratic", F64),
        },
        Regime {
            name: "far-1e4",
            what: "ten thousand radii away",
            draw: |draw| far(draw, 1e4),
            notes: Misjudge("quadratic", F32),
        },
        Regime {
            name: "far-1e6",
            what: "a million radii away",
            draw: |draw| far(draw, 1e6),
            notes: Misjudge("half-quadratic", F32),
        },
        Regime {
            name: "far-1e8",
            what: "a hundred million radii away",
            draw: |draw| far(draw, 1e8),
            notes: Misjudge("half-quadratic", F64),
        },
        Regime {
            name: "far-beyond",
            what: "1e8 to 1e15 radii away",
            draw: far_beyond,
            notes: Misjudge("half-quadratic", F64),
        },
        Regime {
            name: "tiny-1e-8",
            what: "radius 1e-8, origin 5 to 40 away",
            draw: |draw| tiny(draw, 1e-8),
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "tiny",
            what: "radius 1e-12 to 1e-3, origin 5 to 40 away",
            draw: tiny_of_any_size,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "huge-1e8",
            what: "radius 1e8, the eye 5 to 40 above it, looking anywhere",
            draw: huge,
            notes: LoseDigits("closest-approach", F64),
        },
        Regime {
            name: "ground",
            what: "radius 1e6, the eye one unit above it, looking to the horizon",
            draw: ground,
            notes: LoseDigits("closest-approach", F64),
        },
        Regime {
            name: "grazing",
            what: "impact/radius 1 ± 1e-3 to 1 ± 1e-15 (f32: 1e-7)",
            draw: grazing,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "grazing-far",
            what: "grazing, 1e2 to 1e6 radii away (f32: 1e1 to 1e3)",
            draw: grazing_far,
            notes: Misjudge("closest-approach", F64),
        },
        Regime {
            name: "tangent",
            what: "touching exactly, in whole numbers; three in four with a number up to 3 ulps off",
            draw: tangent,
            notes: Misjudge("closest-approach", F64),
        },
        Regime {
            name: "on-surface",
            what: "the origin a rounded point of the sphere, any direction: a secondary ray",
            draw: on_surface,
            notes: Misjudge("closest-approach", F64),
        },
        Regime {
            name: "on-surface-exact",
            what: "the origin a point of the sphere in whole numbers, any direction",
            draw: on_surface_exact,
            notes: Misjudge("closest-approach", F64),
        },
        Regime {
            name: "shifted-1e6",
            what: "ordinary, everything moved 1e6 away from the world's origin",
            draw: |draw| moved(draw, 1e6),
            notes: LoseDigits("closest-approach", F64),
        },
        Regime {
            name: "shifted",
            what: "ordinary, everything moved 1e5 to 1e12 (f32: 1e4 to 1e7)",
            draw: moved_anywhere,
            notes: Misjudge("closest-approach", F32),
        },
        Regime {
            name: "direction-extreme",
            what: "ordinary, with a direction of length 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: direction_extreme,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "scale-extreme",
            what: "ordinary, all lengths times 1e±87 to 1e±290 (f32: 1e±12 to 1e±30)",
            draw: scale_extreme,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, scaled until every length is subnormal; every other direction too",
            draw: subnormal,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "special",
            what: "ordinary, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Misjudge("quadratic", F64),
        },
        Regime {
            name: "bits",
            what: "ten numbers of any bits, the radius not negative",
            draw: bits,
            notes: Misjudge("quadratic", F64),
        },
    ]
}

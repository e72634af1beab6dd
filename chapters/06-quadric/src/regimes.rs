//! The kinds of ray, and what the notes' method loses in each.
//!
//! The solids stand still, so a regime is where a ray comes from and what it is aimed at. What varies over a scale is
//! drawn log-uniformly. If nothing else is said, a ray is aimed at a point in or around the solid, so that it hits
//! about two times of three.

mod draw;

use lab::Notes::{Hold, LoseDigits, Misjudge};
use lab::Regime;
use stage::Precision::{F32, F64};

use crate::Shape::{Cone, Cylinder};
use draw::{
    apex, axial, behind, bits, cap_plane, direction_extreme, far, grazing, inside, near_generator,
    on_surface, on_surface_exact, ordinary, rim, slope_exact, special, subnormal, unnormalized,
};

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, and the place of the solid in [`Shape::ALL`](crate::Shape::ALL).
pub fn regimes() -> Vec<Regime<7>> {
    vec![
        Regime {
            name: "ordinary",
            what: "cylinder or cone, from 3 to 20 away, unit direction",
            draw: ordinary,
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
            what: "ordinary, turned round: the solid is behind the origin",
            draw: behind,
            notes: Hold("every λ is far below zero"),
        },
        Regime {
            name: "cylinder-inside",
            what: "the origin inside the cylinder, a tenth from its surface",
            draw: |draw| inside(draw, Cylinder),
            notes: Hold("λ is never below a tenth: one digit cancels, not more"),
        },
        Regime {
            name: "cone-inside",
            what: "the origin inside the cone, a tenth from its surface",
            draw: |draw| inside(draw, Cone),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "cylinder-rim",
            what: "aimed at a point where wall and cap meet",
            draw: |draw| rim(draw, Cylinder),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-rim",
            what: "aimed at a point where wall and base meet",
            draw: |draw| rim(draw, Cone),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-near-axial",
            what: "1e-3 to 1e-15 (f32: 1e-7) off the axis of the cylinder",
            draw: |draw| near_generator(draw, Cylinder),
            notes: Hold("nearly every ray meets a cap, and its λ is one quotient"),
        },
        Regime {
            name: "cone-near-generator",
            what: "1e-3 to 1e-15 (f32: 1e-7) off the slope of the cone",
            draw: |draw| near_generator(draw, Cone),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-axial",
            what: "along the axis exactly, in eighths: A = 0 = B, the wall has no root",
            draw: |draw| axial(draw, Cylinder),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "cone-axial",
            what: "along the axis exactly, in eighths",
            draw: |draw| axial(draw, Cone),
            notes: Hold(
                "what is rounded, root and quotients, cancels two digits and not more: 7 comes no nearer to √50",
            ),
        },
        Regime {
            name: "cone-slope-exact",
            what: "along the slope of the cone exactly, in eighths: A = 0",
            draw: slope_exact,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-apex",
            what: "aimed at the apex, every other ray through it exactly",
            draw: apex,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-grazing",
            what: "touching the wall but for 1e-3 to 1e-15 (f32: 1e-7) of its radius",
            draw: |draw| grazing(draw, Cylinder),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-grazing",
            what: "touching the wall but for 1e-3 to 1e-15 (f32: 1e-7) of its radius",
            draw: |draw| grazing(draw, Cone),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-far",
            what: "1e3 to 1e10 away (f32: 1e6)",
            draw: |draw| far(draw, Cylinder),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-far",
            what: "1e3 to 1e10 away (f32: 1e6)",
            draw: |draw| far(draw, Cone),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-on-surface",
            what: "the origin a rounded point of the surface, any direction: a secondary ray",
            draw: |draw| on_surface(draw, Cylinder),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cone-on-surface",
            what: "the origin a rounded point of the surface, any direction: a secondary ray",
            draw: |draw| on_surface(draw, Cone),
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "cylinder-on-surface-exact",
            what: "the origin exactly on the wall or a cap, any direction: t = 0",
            draw: |draw| on_surface_exact(draw, Cylinder),
            notes: Hold("C or 1 − a_z is exactly 0, and so is its root"),
        },
        Regime {
            name: "cone-on-surface-exact",
            what: "the origin exactly on the wall or the base, any direction: t = 0",
            draw: |draw| on_surface_exact(draw, Cone),
            notes: Hold("C or a_z is exactly 0, and so is its root"),
        },
        Regime {
            name: "cylinder-cap-plane",
            what: "exactly in the plane of a cap, from outside or from the cap",
            draw: |draw| cap_plane(draw, Cylinder),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "cone-base-plane",
            what: "exactly in the plane of the base, from outside or from the base",
            draw: |draw| cap_plane(draw, Cone),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "direction-extreme",
            what: "ordinary, with a direction of length 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: direction_extreme,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, with a direction so short that every number in it is subnormal",
            draw: subnormal,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "special",
            what: "ordinary, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Misjudge("notes", F64),
        },
        Regime { name: "bits", what: "six numbers of any bits", draw: bits, notes: Misjudge("notes", F32) },
    ]
}

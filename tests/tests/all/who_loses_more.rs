//! Who loses more, and why: methods, regimes and precisions against each other, over the cases that
//! `regimes.rs` has judged.

use stage::Precision;
use stage::Precision::{F32, F64};

use crate::regimes::{JUDGED, Judged, seed};

/// A method in a regime at a precision.
struct Side {
    method: &'static str,
    regime: &'static str,
    precision: Precision,
}

/// What is compared.
#[derive(Clone, Copy, Debug)]
enum Loss {
    /// The share of wrong verdicts.
    Verdicts,
    /// Ulps of t at the worst.
    Digits,
    /// What is lost of t in the mean, as a share of it; all of it where the verdict is wrong.
    Share,
}

/// One side loses more than ten times as much as the other.
struct Ordering {
    stage: &'static str,
    loss: Loss,
    more: Side,
    less: Side,
    why: &'static str,
}

const fn side(method: &'static str, regime: &'static str, precision: Precision) -> Side {
    Side { method, regime, precision }
}

const ORDERINGS: &[Ordering] = &[
    Ordering {
        stage: "ray-wall",
        loss: Loss::Share,
        more: side("notes", "ordinary", F32),
        less: side("notes", "ordinary", F64),
        why: "two roundings and nothing to cancel: t has the digits that the precision has",
    },
    Ordering {
        stage: "ray-wall",
        loss: Loss::Verdicts,
        more: side("notes", "both-extreme", F64),
        less: side("robust", "both-extreme", F64),
        why: "a t behind the origin, so small that it vanishes, is −0 and taken for a touch; \
              robust has its sign from exponents that cannot vanish",
    },
    Ordering {
        stage: "ray-plane",
        loss: Loss::Verdicts,
        more: side("notes", "near-parallel", F32),
        less: side("notes", "near-parallel", F64),
        why: "n · u_r is wrong by a rounding of terms of about 1: most of these slopes are below that of f32, \
              none is far below that of f64",
    },
    Ordering {
        stage: "ray-plane",
        loss: Loss::Digits,
        more: side("notes", "near-parallel", F64),
        less: side("notes", "horizon", F64),
        why: "the same slopes; but where n has one component there is no sum, and nothing to cancel",
    },
    Ordering {
        stage: "ray-plane",
        loss: Loss::Verdicts,
        more: side("notes", "vectors-extreme", F64),
        less: side("notes", "vectors-any-length", F64),
        why: "the lengths of n and u_r do not matter until their products overflow or vanish",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Verdicts,
        more: side("quadratic", "far-1e4", F32),
        less: side("closest-approach", "far-1e4", F32),
        why: "at 1e4 radii r² is below the last digit of distance² in f32, and b² − 4ac is all rounding; \
              d = ‖x_close − c‖ is measured next to the sphere",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Verdicts,
        more: side("quadratic", "far-1e4", F32),
        less: side("quadratic", "far-1e4", F64),
        why: "f64 has twice the digits, and with them reaches the square of the distance",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Verdicts,
        more: side("half-quadratic", "far-1e8", F64),
        less: side("half-quadratic", "far-1e4", F64),
        why: "and f64 comes to its own end at 1e8",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Digits,
        more: side("quadratic", "far-1e6", F64),
        less: side("quadratic", "far-1e2", F64),
        why: "the digits of t go before the verdicts: what is lost of them is (distance/radius)² roundings",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Digits,
        more: side("closest-approach", "shifted-1e6", F64),
        less: side("quadratic", "shifted-1e6", F64),
        why: "x_close has the coarse digits of far away from the world's origin; \
              CO = O − C is taken first and has its own",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Verdicts,
        more: side("closest-approach", "on-surface-exact", F64),
        less: side("quadratic", "on-surface-exact", F64),
        why: "in whole numbers ⟨CO, CO⟩ − r² is exactly 0 and so is the root; \
              t_close − √(r² − d²) comes out a digit beside 0, and falls behind the origin",
    },
    Ordering {
        stage: "ray-sphere",
        loss: Loss::Digits,
        more: side("quadratic", "ground", F64),
        less: side("quadratic", "inside", F64),
        why: "an origin just above a large sphere: −b − √(b² − 4ac) cancels, and so does ⟨CO, CO⟩ − r²; \
              from inside the root adds to b",
    },
    Ordering {
        stage: "triangle",
        loss: Loss::Verdicts,
        more: side("matrix", "vertex", F64),
        less: side("robust", "vertex", F64),
        why: "α, β and α + β are rounded, and near a corner two of them are near their bounds; \
              robust has the signs of three volumes, exactly",
    },
    Ordering {
        stage: "triangle",
        loss: Loss::Verdicts,
        more: side("half-planes", "sliver-1e9", F64),
        less: side("matrix", "sliver-1e9", F64),
        why: "x is rounded to the digits of where it stands, and a sliver is thinner than these; \
              the determinants are taken from differences",
    },
    Ordering {
        stage: "triangle",
        loss: Loss::Digits,
        more: side("matrix", "grazing", F64),
        less: side("matrix", "ordinary", F64),
        why: "det M = d · n is the small difference of large products, and λ divides by it",
    },
    Ordering {
        stage: "quadric",
        loss: Loss::Verdicts,
        more: side("notes", "cone-rim", F64),
        less: side("robust", "cone-rim", F64),
        why: "at the rim the wall's test of z and the base's of x² + y² are both about nothing, and rounded",
    },
    Ordering {
        stage: "quadric",
        loss: Loss::Digits,
        more: side("notes", "cone-near-generator", F64),
        less: side("notes", "ordinary", F64),
        why: "A is nearly 0, and −B/A − √D/A the difference of two numbers of the size 1/A",
    },
    Ordering {
        stage: "quadric",
        loss: Loss::Verdicts,
        more: side("notes", "cylinder-far", F64),
        less: side("notes", "unnormalized", F64),
        why: "B² − A C subtracts squares of the distance, as for a sphere; the length of d does not matter",
    },
    Ordering {
        stage: "affine",
        loss: Loss::Digits,
        more: side("notes", "condition-1e6", F64),
        less: side("notes", "condition-1e3", F64),
        why: "A⁻¹ has an error of about the condition's times its own size, and a′ and d′ have it too",
    },
    Ordering {
        stage: "affine",
        loss: Loss::Digits,
        more: side("notes", "plane-1e6", F64),
        less: side("solved", "plane-1e6", F64),
        why: "solving leaves A a′ right to a rounding, whatever the condition; A⁻¹ (a − t) does not",
    },
    Ordering {
        stage: "affine",
        loss: Loss::Verdicts,
        more: side("solved", "condition-1e9", F64),
        less: side("robust", "condition-1e9", F64),
        why: "a sphere is decided by B² − A C of rounded numbers, however well they solve the equations",
    },
];

/// What a side loses.
fn lost(stage: &str, loss: Loss, Side { method, regime, precision }: &Side) -> f64 {
    let is_it =
        |judged: &&Judged| (judged.stage, judged.regime, judged.precision) == (stage, regime, *precision);
    let judged = JUDGED.iter().find(is_it).unwrap_or_else(|| panic!("{stage} {regime}"));
    let losses = judged.losses_of(method);
    match loss {
        Loss::Verdicts => losses.accuracy.wrong_share(),
        Loss::Digits => losses.worst_t() as f64,
        Loss::Share => losses.accuracy.error(),
    }
}

#[test]
fn who_loses_more() {
    for Ordering { stage, loss, more, less, why } in ORDERINGS {
        let [more_lost, less_lost] = [more, less].map(|side| lost(stage, *loss, side));
        assert!(
            more_lost > 10.0 * less_lost,
            "{stage}, {loss:?}, seed {}: {} {} {more_lost}, {} {} {less_lost}; yet {why}",
            seed(),
            more.method,
            more.regime,
            less.method,
            less.regime
        );
    }
}

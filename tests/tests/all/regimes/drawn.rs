//! That a seed draws the same cases everywhere, and another seed others.

use lab::Subject;
use stage::Precision;
use stage::Precision::F64;

use super::{Affine, JUDGED, Quadric, RayPlane, RaySphere, RayTriangle, RayWall, SEED};

#[test]
fn the_ordinary_regime_comes_first_and_no_name_twice() {
    for stage in ["ray-wall", "ray-plane", "ray-sphere", "triangle", "quadric", "affine"] {
        let of_stage = JUDGED.iter().filter(|judged| judged.stage == stage && judged.precision == F64);
        let mut names: Vec<&str> = of_stage.map(|judged| judged.regime).collect();
        assert_eq!(names[0], "ordinary", "{stage}");
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{stage}");
    }
}

/// FNV-1a over the bits of the first cases of every regime.
fn fingerprint<const N: usize>(subject: &impl Subject<N>) -> u64 {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for regime in subject.regimes() {
        for precision in Precision::ALL {
            for number in regime.cases(SEED, precision).take(100).flatten() {
                // which NaN it is does not matter
                let bits = if number.is_nan() { u64::MAX } else { number.to_bits() };
                hash = (hash ^ bits).wrapping_mul(0x100_0000_01b3);
            }
        }
    }
    hash
}

/// A change of a regime changes its chapter's number; another machine or another build does not.
#[test]
fn a_seed_draws_the_same_cases_everywhere() {
    let flat = [fingerprint(&RayWall), fingerprint(&RayPlane), fingerprint(&RayTriangle)];
    assert_eq!(flat, [14748765499099355065, 775726111535703518, 6915177919118423381]);
    let round = [fingerprint(&RaySphere), fingerprint(&Quadric), fingerprint(&Affine)];
    assert_eq!(round, [2388186556670858702, 1537538938291137397, 12023551860887396819]);
}

/// The first case of every regime is another one with another seed.
fn assert_seeds_differ<const N: usize>(subject: &impl Subject<N>) {
    for regime in subject.regimes() {
        for precision in Precision::ALL {
            let first = |seed| regime.cases(seed, precision).next().unwrap().map(f64::to_bits);
            assert_ne!(first(1), first(2), "{} {} {precision:?}", subject.about().name, regime.name);
        }
    }
}

#[test]
fn another_seed_draws_other_cases() {
    assert_seeds_differ(&RayWall);
    assert_seeds_differ(&RayPlane);
    assert_seeds_differ(&RaySphere);
    assert_seeds_differ(&RayTriangle);
    assert_seeds_differ(&Quadric);
    assert_seeds_differ(&Affine);
}

//! The bar: no acne and no leak by `bound`, and who else has how much.

use super::*;
use regimes::OF_THE_BAR;

const CASES: usize = 2000;

fn faults<R: Real>(regime: &Regime, seed: u64, start: Start, precision: Precision) -> Faults {
    let object = Object::<R>::of(regime, seed, precision).unwrap();
    let bounded = Bounded::new(&object.alone, bounds::Method::None);
    let cases = judged::cases(&object, &bounded, CASES);
    judged::judge(&object, &bounded, start, &cases)
}

fn both(regime: &Regime, seed: u64, start: Start) -> [Faults; 2] {
    [faults::<f32>(regime, seed, start, Precision::F32), faults::<f64>(regime, seed, start, Precision::F64)]
}

/// numerics.md's table, and every other scene: nothing shades itself, however far away or small it is.
#[test]
fn bound_has_no_acne() {
    for regime in &REGIMES {
        for seed in 0..8 {
            for found in both(regime, seed, Start::Bound) {
                assert_eq!(found.acne, 0, "{} {seed}: {found:?}", regime.name);
                assert!(found.cases > 0, "{}", regime.name);
            }
        }
    }
}

#[test]
fn bound_misses_no_shell_where_the_numbers_are_as_fine_as_it() {
    for regime in &REGIMES[..OF_THE_BAR] {
        let [single, double] = both(regime, 1, Start::Bound);
        assert_eq!(double.leaks, Some(0), "{}", regime.name);
        if regime.name == "unit-at-0" {
            assert_eq!(single.leaks, Some(0));
        }
    }
}

/// A remedy that knows nothing of the shape fails somewhere; which one, and where, the scenes tell.
#[test]
fn every_other_remedy_fails_somewhere() {
    let regime = |name: &str| REGIMES.iter().find(|regime| regime.name == name).unwrap();
    let double = |name: &str, start| both(regime(name), 1, start)[1];
    let single = |name: &str, start| both(regime(name), 1, start)[0];
    let cases = CASES as u64;
    // half of all points lie behind their surface
    assert!((cases / 3..cases * 2 / 3).contains(&double("unit-at-0", Start::None).acne));
    // 1e-3 is much in a small scene, and nothing in a large one
    assert_eq!(double("scale-1e-3", Start::Fixed).leaks, Some(cases));
    assert!(single("scale-1e6", Start::Fixed).acne > cases / 3);
    // along the surface a ray gets away from it slowly
    assert!(double("ground", Start::Scaled).acne > 0 && single("unit-at-0", Start::Scaled).acne > 0);
    // the surface itself is what a ray within a sphere has to meet
    assert_eq!(double("into-sphere", Start::Exclude).leaks, Some(cases));
    assert_eq!(double("into-sphere", Start::Bound).leaks, Some(0));
}

/// Refracted rays go into a solid: not one of them may miss its other side, nor meet the one that it came
/// through.
#[test]
fn what_enters_a_solid_meets_its_other_side() {
    let is_solid = |regime: &&Regime| {
        use regimes::Kind::{Cone, Cylinder, DeformedCone, DeformedCylinder, Ellipsoid, Sphere, Squashed};
        let small = regime.distance > 100.0 * regime.size;
        let solids = [Sphere, Cylinder, Cone, Ellipsoid, DeformedCylinder, DeformedCone, Squashed];
        solids.contains(&regime.kind) && !small
    };
    for regime in REGIMES.iter().filter(is_solid) {
        let regime = Regime { way: regimes::Way::Enters, ..*regime };
        for seed in 0..4 {
            for found in both(&regime, seed, Start::Bound) {
                assert_eq!((found.acne, found.leaks), (0, Some(0)), "{} {seed}", regime.name);
            }
        }
    }
}

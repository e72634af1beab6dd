//! "Exercise: Verify that, at the solution λ*, r̄(λ*) = A r̄′(λ*) + t." And the derivation of the normal, with its slips.

use glam::DVec3;
use lab::Draw;
use math::{Ray3, Span};
use stage::Precision;

use crate::measure::question;
use crate::regimes::regimes;
use crate::{Deformed, Matrix3, notes};

/// u = 2^−53, the error of one rounding.
const U: f64 = f64::EPSILON / 2.0;

/// A vector or a matrix without its signs.
fn sizes(v: DVec3) -> DVec3 {
    DVec3::from_array(v.to_array().map(f64::abs))
}

fn sizes_of(a: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3 { columns: a.columns.map(sizes) }
}

/// How far A r′(λ) + t may be from r(λ), for each axis, whatever λ: all that is rounded on either way, to the first
/// order in u, and a hundredth for the orders beyond.
///
/// An entry of adj A is a difference of two products: off by 2u of their sizes, P. det A is a sum of three products
/// with those: off by 5u of Σ |a| P. So their quotient A⁻¹ is off by E = u (2 P + (5 Σ|a|P + |det A|) |A⁻¹|) / |det A|.
/// a′ and d′ are products with it, of three terms and of a difference: E + 4u |A⁻¹| times |a − t| and |d|. The rest is
/// r′ (2u), A r′ + t (4u), and r (2u).
fn bound(work: &notes::Notes<'_, f64>, lambda: f64, p: DVec3) -> DVec3 {
    let Deformed { affine, inverse, .. } = work.deformed;
    let [x, y, z] = affine.a.columns.map(sizes);
    let across =
        |a: DVec3, b: DVec3| DVec3::new(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
    let products = [across(y, z), across(z, x), across(x, y)];
    let (det, sum) = (affine.a.determinant().abs(), x.dot(products[0]));
    let products = Matrix3::from_rows(products.map(|row| row.to_array()));
    let (a, inverse) = (sizes_of(&affine.a), sizes_of(inverse));
    let error_of_inverse = |v: DVec3| {
        (products.times(v) * 2.0 + inverse.times(v) * (5.0 * sum + det)) * (U / det)
            + inverse.times(v) * (4.0 * U)
    };

    let (a_minus_t, way) = (sizes(work.a_minus_t), sizes(work.ray.direction) * lambda.abs());
    let of_r_prime = error_of_inverse(a_minus_t + way)
        + (sizes(work.ray_prime.origin) + sizes(work.ray_prime.direction) * lambda.abs()) * (2.0 * U);
    let through = a.times(of_r_prime) + (a.times(sizes(p)) + sizes(affine.t)) * (4.0 * U);
    let along = (sizes(work.ray.origin) + way) * (2.0 * U);
    (through + along) * 1.01
}

/// Over thousands of cases, conditions up to 1e12: the difference is within its bound, and where the matrix is harmless
/// that is next to nothing.
#[test]
fn the_exercise_verified() {
    for name in [
        "ordinary",
        "inside",
        "mirrored",
        "condition-1e6",
        "condition-1e12",
        "axis-scale",
        "triangle",
        "shifted",
    ] {
        let regime = regimes().into_iter().find(|regime| regime.name == name).unwrap();
        let (mut verified, mut largest) = (0, 0.0_f64);
        for case in regime.cases(1, Precision::F64).take(2000) {
            let (ray, object, affine) = question(case);
            let deformed = Deformed::for_ray(&ray, object, affine).unwrap();
            let work = notes(&ray, &deformed);
            let Some(found) = work.found(Span::ahead()).unwrap() else { continue };
            let difference = sizes(found.verify(&ray, &deformed).difference);
            let bound = bound(&work, found.lambda, found.p);
            assert!(difference.cmple(bound).all(), "{name}: {difference} is beyond {bound}; {case:?}");
            verified += 1;
            largest = largest.max(difference.max_element());
        }
        assert!(verified > 500, "{name}: {verified}");
        if name == "ordinary" {
            assert!(largest < 1e-12, "{largest:e}");
        }
    }
}

/// A matrix of whole numbers whose inverse is exact: by hand, see `matrix`.
fn exact() -> (Matrix3<f64>, DVec3) {
    let a = Matrix3::from_rows([[2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [3.0, 4.0, 1.0]]);
    (a, DVec3::new(5.0, -2.0, 1.0))
}

/// Eq. (1) prints F(q̄) = f(Q⁻¹(p̄)), with the undeformed point p̄ where the deformed one, q̄ = Q(p̄), is meant (slip 21).
#[test]
fn as_printed_equation_1_tests_the_wrong_point() {
    let (a, t) = exact();
    let f = |p: DVec3| p.dot(p) - 1.0;
    let back = |q: DVec3| a.inverse().times(q - t);
    for p in [DVec3::X, DVec3::Y, -DVec3::Z] {
        let q = a.times(p) + t;
        assert_eq!(f(back(q)), 0.0, "F(q) = f(Q⁻¹(q)): q is on the deformed sphere");
        assert_ne!(f(back(p)), 0.0, "as printed");
    }
}

/// Eqs. (3) to (5), at every step, and what the page calls D without saying what it is: s · n in the undeformed space,
/// where the tangent plane is p · n = D. The deformed one is q · m = D + t · m, with m = A⁻ᵀ n.
#[test]
fn a_tangent_plane_deformed_is_a_tangent_plane() {
    let (a, t) = exact();
    let mut draw = Draw::new(1, "tangent-plane", Precision::F64);
    for _ in 0..1000 {
        let mut whole = || DVec3::new(draw.whole(-8, 8), draw.whole(-8, 8), draw.whole(-8, 8));
        let (s, n, p) = (whole(), whole(), whole());
        let (q, m) = (a.times(p) + t, a.inverse().transposed_times(n));
        // halves and small whole numbers: nothing is rounded
        assert_eq!((p - s).dot(n), (a.inverse().times(q - t) - s).dot(n), "(3) = (4)");
        assert_eq!((p - s).dot(n), (q - (a.times(s) + t)).dot(m), "(3) = (5)");
        assert_eq!((a.times(s) + t).dot(m), s.dot(n) + t.dot(m), "D + t · m");
    }
}

/// What is normal is at right angles to two steps along the surface, and A n is not.
#[test]
fn a_deformed_by_a_is_no_normal() {
    let (a, _) = exact();
    let (n, along) = (DVec3::new(1.0, 2.0, 2.0), [DVec3::new(2.0, -1.0, 0.0), DVec3::new(0.0, 1.0, -1.0)]);
    let (right, wrong) = (a.inverse().transposed_times(n), a.times(n));
    assert_eq!(along.map(|step| n.dot(step)), [0.0; 2]);
    assert_eq!(along.map(|step| right.dot(a.times(step))), [0.0; 2]);
    assert_ne!(along.map(|step| wrong.dot(a.times(step))), [0.0; 2]);
}

/// The same λ and a ray that is not made shorter: with d′ made a unit vector, λ* would be another.
#[test]
fn lambda_is_counted_in_directions_as_given() {
    let (a, t) = exact();
    let ball = Deformed::new(crate::Object::Sphere, crate::Affine { a, t }).unwrap();
    // from outside through the point that the center goes to, t
    let d = DVec3::new(3.0, 1.0, 7.0); // A (1, 1, 0): d′ = (1, 1, 0)
    let ray = Ray3::new(t - d * 4.0, d);
    let found = notes(&ray, &ball).found(Span::ahead()).unwrap().unwrap();
    // by hand: a′ = −4 (1, 1, 0), and the sphere is entered at −(1, 1, 0)/√2
    let closed_form = 4.0 - 0.5_f64.sqrt();
    assert!((found.lambda - closed_form).abs() < 1e-15);
    let shorter = (found.p - notes(&ray, &ball).ray_prime.origin).length();
    assert!((shorter - closed_form * 2.0_f64.sqrt()).abs() < 1e-14, "the way in its own space is √2 as long");
}

//! Signs first, then one root.
//!
//! The page's method works out up to four points and tests each. On paper a point of the wall has a z, and z ≤ 1 or
//! not; in floating point the point is beside the wall, and z beside its value. At the rim the wall's test and the
//! cap's may then both say no, and the ray slips through the solid; D = B² − A C cancels as it does for a sphere; at
//! A ≈ 0, along the slope of the cone, −B/A ± √D/A is a difference of enormous numbers; and through the apex D is
//! exactly zero on paper and anything in floating point.
//!
//! Here no point is tested. [`Line::verdict`] asks for signs, of numbers that are sums and products of what was
//! given: is the origin inside, is f below zero where the line crosses a plane, does it fall or rise there, is D
//! below zero? That tells which part is met; then [`Line::lambda`] works out one λ, as a quotient for a cap and as a
//! root without cancellation for the wall. Both are written once, for any kind of number that knows its error
//! ([`math::Sure`]): plain `f64` first, twice the digits next, integers as long as it takes last.

mod line;
mod verdict;

use math::wide::{exponent_of, scaled};
use math::{Bounded, Certainty, Degenerate, Exact, Hit, Ray3, Real, Span, TwoPart, Vector};

use crate::{Hit3, Shape};

pub use line::{Line, rise_to};
pub use verdict::{Place, Verdict};

/// Every number of the robust method. What is worked out with more digits is rounded for the reader.
///
/// A degenerate ray gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The solid.
    pub shape: Shape,
    /// What becomes of the ray: it misses, starts on, enters or leaves, and at which part.
    pub verdict: Verdict,
    /// With what kind of number the verdict was reached.
    pub certainty: Certainty,
    /// λ ≥ 0 of the part that is met, in lengths of the direction, off by less than a unit of its last digit;
    /// `None` for a miss.
    pub lambda: Option<R>,
    /// With what kind of number λ was worked out.
    pub lambda_certainty: Certainty,
}

/// Works out the robust method, for a direction of any length but zero.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray3<R>, shape: Shape) -> Robust<R> {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let (verdict, certainty) = match Line::<Bounded<f64>>::beside_unit(shape, o, d).verdict() {
        Some(verdict) => (verdict, Certainty::AtOnce),
        None => careful_verdict(shape, o, d),
    };
    let (lambda, lambda_certainty) = lambda_of(shape, o, d, verdict);
    Robust { ray: *ray, shape, verdict, certainty, lambda, lambda_certainty }
}

/// The verdict with twice the digits, or exactly.
#[cold]
#[inline(never)]
fn careful_verdict(shape: Shape, o: [f64; 3], d: [f64; 3]) -> (Verdict, Certainty) {
    if !o.iter().chain(&d).all(|number| number.is_finite()) {
        return (Verdict::Misses, Certainty::AtOnce);
    }
    if let Some(verdict) = Line::<Bounded<TwoPart>>::beside_unit(shape, o, d).verdict() {
        return (verdict, Certainty::TwoPart);
    }
    // No sign of an exact number is in doubt.
    let verdict = Line::<Exact>::beside_unit(shape, o, d).verdict().unwrap_or(Verdict::Misses);
    (verdict, Certainty::Exact)
}

/// λ of the verdict: for f32 plain f64 is nearly always enough, for f64 twice the digits.
#[inline(always)]
fn lambda_of<R: Real>(shape: Shape, o: [f64; 3], d: [f64; 3], verdict: Verdict) -> (Option<R>, Certainty) {
    if verdict == Verdict::Misses {
        return (None, Certainty::AtOnce);
    }
    if R::DIGITS < f64::MANTISSA_DIGITS
        && let Some(lambda) = Line::<Bounded<f64>>::beside_unit(shape, o, d).lambda(verdict)
    {
        return (Some(lambda), Certainty::AtOnce);
    }
    if let Some(lambda) = Line::<Bounded<TwoPart>>::beside_unit(shape, o, d).lambda(verdict) {
        return (Some(lambda), Certainty::TwoPart);
    }
    (exact_lambda(shape, o, d, verdict), Certainty::Exact)
}

#[cold]
#[inline(never)]
fn exact_lambda<R: Real>(shape: Shape, o: [f64; 3], d: [f64; 3], verdict: Verdict) -> Option<R> {
    Line::<Exact>::beside_unit(shape, o, d).lambda(verdict)
}

impl<R: Real> Robust<R> {
    /// A, B, C and D of the wall, rounded for a reader: f(o + λ d) = A λ² − 2 B λ + C. B has the other sign
    /// than the page's.
    pub fn quadratic(&self) -> math::Quadratic<f64> {
        let [o, d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let math::Quadratic { a, b, c, d } =
            Line::<Bounded<TwoPart>>::beside_unit(self.shape, o, d).quadratic();
        let [a, b, c, d] = [a, b, c, d].map(|number| number.value.hi);
        math::Quadratic { a, b, c, d }
    }

    /// The nearest hit in `span`: where the ray first meets the solid, or where that comes too early, as for a ray
    /// that leaves a surface and looks for t > 0, where it leaves the solid. What lies behind the origin is
    /// not looked for, whatever the span. The normal is that of [`Shape::normal`].
    ///
    /// `None` for a miss, [`Degenerate`] for a ray that asks nothing, see [`Ray3::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.ray.check()?;
        let Some(lambda) = self.lambda else { return Ok(None) };
        let (verdict, lambda) = if lambda < span.min { self.exit() } else { (self.verdict, lambda) };
        let Some(part) = verdict.part().filter(|_| span.contains(lambda)) else { return Ok(None) };
        let t = lambda + R::from(0.0); // minus zero is zero
        let at_t = self.ray.at(t);
        let point = if at_t.is_finite() { at_t } else { self.far_point(verdict) };
        Ok(Some(Hit { t, point, normal: self.shape.normal::<R>(part, point) }))
    }

    /// Where the ray meets the solid though λ, or o + λ d as it is rounded, is beyond the largest number. In the one
    /// case the direction is so short that one 2^k times as long leads to the same point, by a λ that is a number; in
    /// the other o is so large that half of everything is added up.
    #[cold]
    #[inline(never)]
    fn far_point(&self, verdict: Verdict) -> R::Vec3 {
        let [o, d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let longest = d.iter().fold(0.0, |most: f64, component| most.max(component.abs()));
        let longer = d.map(|component| scaled(component, -exponent_of(longest)));
        let (lambda, _) = lambda_of::<f64>(self.shape, o, longer, verdict);
        let half = lambda.unwrap_or(0.0) / 2.0;
        let [x, y, z] = [0, 1, 2].map(|axis| R::round_from(2.0 * (o[axis] / 2.0 + half * longer[axis])));
        R::vec3(x, y, z)
    }

    /// Where a line that meets the solid leaves it.
    #[cold]
    #[inline(never)]
    fn exit(&self) -> (Verdict, R) {
        let [o, d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let line = Line::<Bounded<TwoPart>>::beside_unit(self.shape, o, d);
        let with_two_parts = line.exit().and_then(|place| Some((place, line.lambda_where_f_rises(place)?)));
        let exactly = || {
            let line = Line::<Exact>::beside_unit(self.shape, o, d);
            line.exit().and_then(|place| Some((place, line.lambda_where_f_rises(place)?)))
        };
        let exit = with_two_parts.or_else(exactly);
        exit.map_or((Verdict::Misses, -R::INFINITY), |(place, lambda)| (Verdict::Leaves(place), lambda))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};

    #[test]
    fn a_lambda_beyond_the_largest_number_has_a_point() {
        // by hand: x = −1 is 2 away, which is 2^140 directions of 2^−139
        let direction = Vec3::X * f32::from_bits(1 << 10);
        let ray = Ray3::<f32>::new(Vec3::new(-3.0, 0.0, 0.0), direction);
        let hit = robust(&ray, Shape::Cylinder).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (f32::INFINITY, -Vec3::X, -Vec3::X));
        // and it leaves at x = 1
        let on_wall = Ray3::<f32>::new(-Vec3::X, direction);
        let beyond = Span::new(f32::MIN_POSITIVE, f32::INFINITY);
        let exit = robust(&on_wall, Shape::Cylinder).hit(beyond).unwrap().unwrap();
        assert_eq!((exit.t, exit.point, exit.normal), (f32::INFINITY, Vec3::X, Vec3::X));
    }

    /// By hand, along the slope of the cone: x² − ¼ (1 − z)² of (−½ + λ, 0, 1 − 2 λ) is ¼ − λ. Of exact numbers A is zero; of
    /// others it is so nearly, and says nothing.
    #[test]
    fn along_the_slope_there_is_one_root() {
        let (origin, direction) = ([-0.5, 0.0, 1.0], [1.0, 0.0, -2.0]);
        let exact = Line::<Exact>::beside_unit(Shape::Cone, origin, direction);
        assert_eq!(exact.lambda(exact.verdict().unwrap()), Some(0.25));
        assert_eq!(Line::<Bounded<TwoPart>>::beside_unit(Shape::Cone, origin, direction).verdict(), None);
    }

    /// From on the top down, λ is 0 / −1; into the wall, C / (B − √D) with C zero and the rest below it.
    #[test]
    fn minus_zero_is_zero() {
        for (origin, direction) in [(DVec3::Z, -DVec3::Z), (-DVec3::X, DVec3::X), (DVec3::X, -DVec3::X)] {
            let hit = robust(&Ray3::<f64>::new(origin, direction), Shape::Cylinder).hit(Span::ahead());
            assert_eq!(hit.unwrap().unwrap().t.to_bits(), 0, "{origin}");
        }
    }

    /// From the largest number there is, a rounded λ d leads beyond the largest.
    #[test]
    fn from_the_largest_number_there_is_a_point_and_a_normal() {
        for shape in Shape::ALL {
            for sign in [1.0, -1.0] {
                let x = sign * f64::MAX;
                // by hand: λ is MAX / MAX.next_down(), 1 + 2^−53 and a bit: rounded it is 1 + 2^−52
                let ray = Ray3::<f64>::new(DVec3::X * x, DVec3::X * -(sign * f64::MAX.next_down()));
                assert!(!ray.at(1.0_f64.next_up()).is_finite());
                let hit = robust(&ray, shape).hit(Span::ahead()).unwrap().unwrap();
                assert_eq!(hit.t, 1.0_f64.next_up(), "{shape:?}");
                assert!(hit.point.is_finite() && (hit.normal.length() - 1.0).abs() < 1e-15, "{hit:?}");
            }
        }
    }

    /// The verdict of the oracle, and its λ within a unit of the last digit.
    #[cfg(feature = "stage")]
    #[test]
    fn right_in_every_regime() {
        assert_eq!(lab::first_beyond(&crate::stage::Quadric, 1, 300, |_, _| 1), None);
    }

    /// Which way the rays of every regime take, and how good it is: see [`lab::tally()`].
    #[cfg(feature = "stage")]
    #[test]
    fn ways() {
        fn way<R: Real>(case: [f64; 7]) -> String {
            let (ray, shape) = crate::measure::question(case.map(R::round_from));
            let work = robust(&ray, shape);
            format!("{:?} {:?}", work.certainty, work.lambda_certainty)
        }
        insta::assert_snapshot!(lab::tally(&crate::stage::Quadric, 1, 200, [way::<f32>, way::<f64>]));
    }
}

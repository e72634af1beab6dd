//! Equation 4.2 with both dot products certain.
//!
//! t = −n · (p_r − p_0) / n · u_r is a quotient of two sums, and sums of products cancel. Near
//! parallel, n · u_r is the small difference of large products, and its few right digits are all
//! that t has; a ray exactly parallel may come out as a hit astronomically far away. With the origin
//! near the plane the same happens to n · (p_r − p_0), where even the difference p_r − p_0 was rounded.
//! The usual cure, to call |n · u_r| < 1e−6 parallel, trades the wrong digits for wrong verdicts.
//!
//! Here p_r − p_0 keeps its rounding error, products and sums carry twice the digits, and each sum is
//! accepted only if the error bound says that it is right to the last digit of an `f64`. Where it does
//! not, the sum is taken exactly ([`math::exact`]), so that "parallel" and "in the plane" are facts.

use math::two_part::two_sum;
use math::{Degenerate, Exact, Hit, Parallel, Ray3, Real, Span, TwoPart, Vector, Wide};

use crate::{Hit3, Meeting, Plane};

/// Every number of the robust method.
///
/// A degenerate ray or plane gives zeros; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The plane.
    pub plane: Plane<R>,
    /// n · (p_r − p_0)
    pub n_dot_p: CertainSum,
    /// n · u_r
    pub n_dot_u: CertainSum,
}

/// A dot product whose sign is exact and whose digits are right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertainSum {
    /// The sum rounded to `f64`.
    pub value: f64,
    /// Whether it had to be summed exactly.
    pub exact: bool,
    wide: Wide,
}

impl CertainSum {
    fn new(wide: Wide, exact: bool) -> CertainSum {
        CertainSum { value: wide.to_f64(), exact, wide }
    }

    /// How it was found.
    pub fn meaning(&self) -> &'static str {
        if self.exact { "summed exactly" } else { "two-part sum, certain by its error bound" }
    }
}

/// The rounding errors of three two-part products and two sums, each at most 2^−102 of a number no
/// larger than the sum of the magnitudes, add up to less than 2^−99 of it.
const SUM_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// What that error may be of the sum: a quarter of the last digit of an `f64`.
const HARMLESS: f64 = 1.0 / (1u64 << 55) as f64;
/// Between these, a sum of products and its errors neither overflow nor vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-200..=1e200;

/// Works out the robust method.
pub fn robust<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Robust<R> {
    let nothing = CertainSum::new(Wide::ZERO, false);
    let mut work = Robust { ray: *ray, plane: *plane, n_dot_p: nothing, n_dot_u: nothing };
    if plane.check(ray).is_err() {
        return work;
    }
    let [p_r, u_r, p_0, n] = [ray.origin, ray.direction, plane.point, plane.normal].map(Vector::in_f64::<3>);
    let from_plane = std::array::from_fn(|axis| two_sum(p_r[axis], -p_0[axis]));

    work.n_dot_p = in_two_parts(n, from_plane).unwrap_or_else(|| {
        let exact = |axis: usize| Exact::new(p_r[axis]) - Exact::new(p_0[axis]);
        exactly(n, std::array::from_fn(exact))
    });
    work.n_dot_u = in_two_parts(n, u_r.map(TwoPart::from)).unwrap_or_else(|| exactly(n, u_r.map(Exact::new)));
    work
}

/// n · v with twice the digits; `None` where the error left could matter.
fn in_two_parts(n: [f64; 3], v: [TwoPart; 3]) -> Option<CertainSum> {
    let products: [TwoPart; 3] = std::array::from_fn(|axis| v[axis] * n[axis]);
    let sum = products[0] + products[1] + products[2];
    let size: f64 = products.iter().map(|product| product.hi.abs()).sum();
    let certain = SAFE.contains(&size) && SUM_ERROR * size <= HARMLESS * sum.hi.abs();
    certain.then(|| CertainSum::new(Wide::from(sum), false))
}

/// n · v without any rounding.
fn exactly(n: [f64; 3], v: [Exact; 3]) -> CertainSum {
    CertainSum::new(Exact::dot(&n.map(Exact::new), &v).to_wide(), true)
}

impl<R: Real> Robust<R> {
    fn wide_t(&self) -> Option<Wide> {
        let (n_dot_p, n_dot_u) = (self.n_dot_p.wide, self.n_dot_u.wide);
        if n_dot_u.is_zero() { None } else { Some(-n_dot_p / n_dot_u) }
    }

    /// Where the line of the ray meets the plane; parallel is decided exactly.
    pub fn meeting(&self) -> Meeting<R> {
        match self.wide_t() {
            Some(t) => Meeting::At(t.rounded()),
            None if self.n_dot_p.wide.is_zero() => Meeting::Never(Parallel::Within),
            None => Meeting::Never(Parallel::Apart),
        }
    }

    /// The signed distance of the origin from the plane: n · (p_r − p_0) / ‖n‖.
    pub fn distance(&self) -> R {
        let length = self.normal_length();
        if length.is_zero() { R::from(0.0) } else { R::round_from((self.n_dot_p.wide / length).to_f64()) }
    }

    fn normal_length(&self) -> Wide {
        let [x, y, z] = Wide::vector::<R, 3>(self.plane.normal).map(|component| component * component);
        (x + y + z).sqrt()
    }

    /// The hit, where its t lies in `span`: t and x = p_r + t u_r in twice the digits, rounded at the end.
    /// (Where x cancels, what is left is 2^−100 of p_r, not zero.)
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.plane.check(&self.ray)?;
        let Some(wide_t) = self.wide_t() else { return Ok(None) };
        let t: R = wide_t.rounded();
        if !span.contains(t) {
            return Ok(None);
        }
        let round = |x: Wide| R::round_from(x.to_f64());
        let [p, u] = [self.ray.origin, self.ray.direction].map(Wide::vector::<R, 3>);
        let [x, y, z] = std::array::from_fn(|axis| round(p[axis] + wide_t * u[axis]));
        let t = t + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point: R::vec3(x, y, z), normal: self.plane.unit_normal() }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn exactly_parallel_is_parallel() {
        // by hand: 0.1 · 0.3 − 0.3 · 0.1 = 0, whatever 0.1 and 0.3 are rounded to
        let direction = DVec3::new(0.3, -0.1, 0.0);
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(0.1, 0.3, 0.0) };
        let ray = Ray3::<f64>::new(DVec3::new(1.0, 1.0, 1.0), direction);
        assert_eq!(robust(&ray, &plane).meeting(), Meeting::Never(Parallel::Apart));
        let within = Ray3::<f64>::new(direction * 2.0, direction);
        assert_eq!(robust(&within, &plane).meeting(), Meeting::Never(Parallel::Within));
    }

    #[test]
    fn nearly_parallel_keeps_its_digits() {
        // by hand: n · u_r = (1 + 2^−52) − 1 = 2^−52, hidden beside products of size 2^60
        let (big, tiny) = (2.0_f64.powi(60), 2.0_f64.powi(-52));
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(big, -big, 1.0) };
        let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 1.0, -tiny));
        assert_eq!(robust(&ray, &plane).meeting(), Meeting::At(1.0 / tiny));
    }

    /// The large component of the one vector meets the small one of the other, on every axis.
    #[test]
    fn products_that_vanish_are_summed_exactly() {
        let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.0, 1e-40), DVec3::new(1.0, 1e-300, 1e-300));
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(-1e-300, 1e-15, 1.0) };
        // by hand: n · u_r = −1e−300 + 1e−315 + 1e−300 = 1e−315, and t = −1e−40 / 1e−315
        let work = robust(&ray, &plane);
        assert!(work.n_dot_u.exact);
        let Meeting::At(t) = work.meeting() else { panic!("not parallel") };
        assert!((t / -1e275 - 1.0).abs() < 1e-15, "{t:e}");
        let as_printed = crate::notes(&ray, &plane).t;
        assert!((as_printed / -1e275 - 1.0).abs() > 1e-12, "as printed: {as_printed:e}");
    }

    #[test]
    fn lengths_of_the_normal_may_be_extreme() {
        let ray = Ray3::<f64>::new(DVec3::new(0.0, 3.0, 0.0), DVec3::new(0.0, -1.0, 0.0));
        for length in [1e300, 1.0, 1e-300, 5e-324] {
            let plane = Plane { point: DVec3::ZERO, normal: DVec3::Y * length };
            let work = robust(&ray, &plane);
            let hit = work.hit(Span::ahead()).unwrap().unwrap();
            assert_eq!((hit.t, hit.normal, work.distance()), (3.0, DVec3::Y, 3.0), "‖n‖ = {length:e}");
        }
    }
}

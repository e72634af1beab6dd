//! Equation 4.2 with both dot products certain.
//!
//! t = −n · (p_r − p_0) / n · u_r is a quotient of two sums, and sums of products cancel. Near
//! parallel, n · u_r is the small difference of large products, and its few right digits are all
//! that t has; a ray exactly parallel may come out as a hit astronomically far away. With the origin
//! near the plane the same happens to n · (p_r − p_0), where even the difference p_r − p_0 was rounded.
//! The usual cure, to call |n · u_r| < 1e−6 parallel, trades the wrong digits for wrong verdicts.
//!
//! Here p_r − p_0 keeps its rounding error. Four ways of taking the sums follow, each slower and surer
//! than the one before; a sum takes the first whose error bound says that what is left over can
//! matter neither to its sign nor to t.
//!
//! 1. **At once**, in plain `f64`: for a ray in `f32` that is enough nearly always, since products of
//!    `f32` are exact in `f64`.
//! 2. **In two parts**: products and sums keep their rounding errors, which are then summed in plain `f64`.
//!    So a ray in `f64` nearly always ends here.
//! 3. **In three parts**: the rounding errors keep theirs as well (`careful.rs`). That takes an origin on
//!    the plane, and rays as near to parallel as rounding makes them.
//! 4. **Exactly**, in integers as long as it takes, so that "parallel" and "in the plane" are facts.

mod careful;
mod sums;

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

use crate::{Hit3, Meeting, Plane};
use sums::{Sum, from_plane};

/// Every number of the robust method.
///
/// A degenerate ray or plane gives values that mean nothing; [`Robust::hit`] refuses it.
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
    found: Found,
}

/// A dot product whose sign is exact and whose digits are right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertainSum {
    /// The sum in `f64`.
    pub value: f64,
    /// How it was found.
    pub certainty: Certainty,
}

/// How a sum was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`.
    AtOnce,
    /// With the rounding errors of the plain sum.
    TwoPart,
    /// With the rounding errors of those.
    ThreePart,
    /// In integers.
    Exact,
}

impl CertainSum {
    /// How it was found.
    pub fn meaning(&self) -> &'static str {
        match self.certainty {
            Certainty::AtOnce => "certain at once",
            Certainty::TwoPart => "two-part sum, certain by its error bound",
            Certainty::ThreePart => "three-part sum, certain by its error bound",
            Certainty::Exact => "summed exactly",
        }
    }
}

/// What Eq. 4.2 comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Found {
    /// This t. A negative one is never zero.
    At(f64),
    /// n · u_r = 0
    Never(Parallel),
    /// A degenerate ray or plane.
    Degenerate,
}

/// Works out the robust method.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Robust<R> {
    let [p_r, u_r, p_0, n] = [ray.origin, ray.direction, plane.point, plane.normal].map(Vector::in_f64::<3>);
    let (ray, plane) = (*ray, *plane);

    let (n_dot_p, n_dot_u, certainty) = if R::DIGITS < f64::MANTISSA_DIGITS {
        let v: [f64; 3] = std::array::from_fn(|axis| p_r[axis] - p_0[axis]);
        (Sum::at_once(n, v), Sum::at_once(n, u_r), Certainty::AtOnce)
    } else {
        (
            Sum::in_two_parts(n, from_plane(p_r, p_0)),
            Sum::in_two_parts(n, u_r.map(Into::into)),
            Certainty::TwoPart,
        )
    };
    if !(n_dot_p.is_certain && n_dot_u.is_certain) {
        let (n_dot_p, n_dot_u, found) = careful::meeting(p_r, u_r, p_0, n);
        return Robust { ray, plane, n_dot_p, n_dot_u, found };
    }
    let found = Found::At(-n_dot_p.over(n_dot_u));
    let [n_dot_p, n_dot_u] = [n_dot_p, n_dot_u].map(|sum| CertainSum { value: sum.hi, certainty });
    Robust { ray, plane, n_dot_p, n_dot_u, found }
}

impl<R: Real> Robust<R> {
    /// Where the line of the ray meets the plane; parallel is decided exactly.
    ///
    /// The numbers must be finite; see [`Plane::check`].
    pub fn meeting(&self) -> Meeting<R> {
        match self.found {
            Found::At(t) => Meeting::At(R::root_from(t)),
            Found::Never(how) => Meeting::Never(how),
            Found::Degenerate => Meeting::Never(Parallel::Within),
        }
    }

    /// The signed distance of the origin from the plane: n · (p_r − p_0) / ‖n‖.
    pub fn distance(&self) -> R {
        careful::distance(&self.ray, &self.plane)
    }

    /// The hit, where its t lies in `span`: x = p_r + t u_r, and n / ‖n‖.
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let (ray, plane) = (self.ray, self.plane);
        let wide_t = match self.found {
            Found::At(t) => t,
            Found::Never(_) => return Ok(None),
            Found::Degenerate => return plane.check(&ray).map(|()| None),
        };
        let t = R::root_from(wide_t);
        if !span.contains(t) {
            return Ok(None);
        }
        let [p_r, u_r] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| p_r[axis] + wide_t * u_r[axis]);
        // Where a sum had to be exact, t may be infinite or vanish; and t u_r may overflow.
        let is_plain = [self.n_dot_p, self.n_dot_u].iter().all(|sum| sum.certainty != Certainty::Exact)
            && (x + y + z).is_finite();
        let point = match is_plain {
            true => R::vec3(R::round_from(x), R::round_from(y), R::round_from(z)),
            false => careful::point(&ray, &plane),
        };
        let t = t + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point, normal: plane.unit_normal() }))
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
        assert_eq!(work.n_dot_u.certainty, Certainty::Exact);
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

    /// One plane, n = (1, 1, 1) through the world's origin, and rays along (1, 1, 1) from next to it.
    fn from(origin: [f64; 3]) -> Robust<f64> {
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::ONE };
        robust(&Ray3::<f64>::new(origin.into(), DVec3::ONE), &plane)
    }

    #[test]
    fn each_way_takes_over_where_the_one_before_it_ends() {
        // by hand: n · p_r = 1 − 1 + 2^−k of magnitudes 2 + 2^−k, and n · u_r = 3
        for (k, certainty) in [
            (43, Certainty::TwoPart),
            (44, Certainty::ThreePart),
            (91, Certainty::ThreePart),
            (92, Certainty::Exact),
            (1074, Certainty::Exact),
        ] {
            let (rest, least) = (2.0_f64.powi(-k / 2) * 2.0_f64.powi(-k - -k / 2), 2.0_f64.powi(-52));
            let work = from([1.0, rest, -1.0]);
            assert_eq!((work.n_dot_p.value, work.n_dot_p.certainty), (rest, certainty), "2^−{k}");
            let Meeting::At(t) = work.meeting() else { panic!("not parallel") };
            assert!((t / (-rest / 3.0) - 1.0).abs() <= least || k == 1074, "2^−{k}: {t:e}");
            assert_eq!(work.hit(Span::ahead()), Ok(None), "the plane is behind by 2^−{k}");
            let hit = from([1.0, -rest, -1.0]).hit(Span::ahead()).unwrap().unwrap();
            assert!(hit.t == -t || k == 1074, "2^−{k}: {hit:?}");
        }
        let touching = from([1.0, 0.0, -1.0]);
        assert_eq!(touching.n_dot_p, CertainSum { value: 0.0, certainty: Certainty::ThreePart });
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0);
    }

    #[test]
    fn a_product_too_small_to_be_seen_is_not_zero() {
        // by hand: n · p_r = 1 − 1 ± 1e−400
        for (z, ahead) in [(1e-200, false), (-1e-200, true)] {
            let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(1.0, 1.0, 1e-200) };
            let ray = Ray3::<f64>::new(DVec3::new(1.0, -1.0, z), DVec3::X);
            let work = robust(&ray, &plane);
            assert_eq!(work.n_dot_p.certainty, Certainty::Exact);
            assert_eq!(work.hit(Span::ahead()).unwrap().is_some(), ahead);
        }
    }

    #[test]
    fn plain_f64_is_enough_for_f32_but_where_it_cancels() {
        let plane = Plane::<f32> { point: glam::Vec3::ZERO, normal: glam::Vec3::ONE };
        let from = |y| robust(&Ray3::<f32>::new(glam::Vec3::new(1.0, y, -1.0), glam::Vec3::ONE), &plane);
        // by hand: n · p_r = 1 − 2^−k − 1 of magnitudes 2 + 2^−k
        for (k, certainty) in [(21, Certainty::AtOnce), (22, Certainty::TwoPart)] {
            let rest = 2.0_f32.powi(-k);
            let work = from(-rest);
            assert_eq!((work.n_dot_p.value, work.n_dot_p.certainty), (f64::from(-rest), certainty), "2^−{k}");
            assert_eq!(work.hit(Span::ahead()).unwrap().unwrap().t, rest / 3.0);
        }
        // t is a tenth of the smallest number, and negative
        let steep = Ray3::<f32>::new(glam::Vec3::new(0.0, f32::from_bits(1), 0.0), glam::Vec3::ONE * 10.0);
        assert_eq!(robust(&steep, &plane).hit(Span::ahead()), Ok(None));
        assert_eq!(robust(&steep, &plane).meeting(), Meeting::At(-f32::SMALLEST));
    }

    #[test]
    fn what_overflows_on_the_way_does_not_matter() {
        // by hand: t = 1e300 / 1e−300; the point is where the ray, straight down, meets the ground
        let ground = Plane { point: DVec3::ZERO, normal: DVec3::Y };
        let slow = Ray3::<f64>::new(DVec3::new(1.0, 1e300, 2.0), DVec3::new(0.0, -1e-300, 0.0));
        let hit = robust(&slow, &ground).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point.x, hit.point.z), (f64::INFINITY, 1.0, 2.0));
        assert!(hit.point.y.abs() <= 1e300 * 2.0_f64.powi(-99), "{hit:?}");
        // t u_r = 2e308 is no number, and p_r + t u_r is
        let ray = Ray3::<f64>::new(DVec3::new(-1e308, 2.0, 0.0), DVec3::new(1e308, -1.0, 0.0));
        let hit = robust(&ray, &ground).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point), (2.0, DVec3::new(1e308, 0.0, 0.0)));
    }

    /// The main way finds what is degenerate by the size of its sums.
    #[test]
    fn no_degenerate_number_passes_in_any_place() {
        let good = [0.5, 1.0, 2.0, 0.25, -0.5, 0.75, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let reason = |c: [f64; 12]| {
            let v = |i: usize| DVec3::new(c[i], c[i + 1], c[i + 2]);
            let (ray, plane) = (Ray3::<f64>::new(v(0), v(3)), Plane::<f64> { point: v(6), normal: v(9) });
            let narrow = |v: DVec3| v.as_vec3();
            let narrow_ray = Ray3::<f32>::new(narrow(v(0)), narrow(v(3)));
            let narrow_plane = Plane::<f32> { point: narrow(v(6)), normal: narrow(v(9)) };
            let found = robust(&ray, &plane).hit(Span::ahead()).err();
            assert_eq!(found, robust(&narrow_ray, &narrow_plane).hit(Span::ahead()).err(), "{c:?}");
            found
        };
        assert_eq!(reason(good), None);
        for place in 0..12 {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut case = good;
                case[place] = bad;
                assert_eq!(reason(case), Some(Degenerate::NotFinite), "{bad} in place {place}");
            }
        }
        for (first, degenerate) in [(3, Degenerate::ZeroDirection), (9, Degenerate::ZeroNormal)] {
            let mut case = good;
            case[first..first + 3].fill(-0.0);
            assert_eq!(reason(case), Some(degenerate));
        }
    }
}

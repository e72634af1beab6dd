//! The same division, rounded once.
//!
//! House's t = (front − p_x) / u_x is nearly as good as it looks: the difference is rounded, then the
//! quotient, and t is off by about one unit in its last place. Only its ends are bad: front − p_x
//! overflows where both are huge and of opposite sign, though the quotient is an ordinary number,
//! and a quotient below the smallest number rounds to −0, which looks like a touch at t = 0.
//!
//! So there are two ways:
//!
//! 1. **At once.** Away from the ends of the range the plain quotient has the sign of t, which is the
//!    verdict; where a face is hit, one correction gives t its last digit (`corrected`). In `f32` not even
//!    that is needed: the quotient is computed in `f64`, whose range is wide enough for all of `f32`.
//! 2. **Carefully**, near the ends of the range: exponents that cannot overflow, and twice the digits
//!    (`careful.rs`).
//!
//! What lies behind the origin stays behind it. And since the ray hits a face, the x of the
//! point is the x of the face, whatever p_x + t u_x rounds to.

mod careful;

use math::two_part::{two_product, two_sum};
use math::{Degenerate, Hit, Ray2, Real, Roots, Span, Vector};

use crate::{Crossing, Hit2, Wall};

/// Every number of the robust method.
///
/// A degenerate ray or wall gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray2<R>,
    /// The wall.
    pub wall: Wall<R>,
    /// front − p_x and back − p_x, rounded to `f64`; infinite where they overflow.
    pub to_faces: [f64; 2],
    /// The same divided by u_x: t_front and t_back but for their last digits. `None` where that is not
    /// certain, or there is no t.
    quotients: Option<[f64; 2]>,
}

/// Between these, u_x and the quotients, neither a product nor its rounding error overflows or vanishes.
const SAFE: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// Works out the robust method, for a direction of any length but zero.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray2<R>, wall: &Wall<R>) -> Robust<R> {
    let [p_x, p_y, u_x, u_y]: [f64; 4] =
        [ray.origin.x(), ray.origin.y(), ray.direction.x(), ray.direction.y()].map(R::into);
    let [front, back]: [f64; 2] = [wall.front, wall.back].map(R::into);

    let to_faces = [front - p_x, back - p_x];
    let quotients = to_faces.map(|to_face| to_face / u_x);

    let is_safe = if R::DIGITS < f64::MANTISSA_DIGITS {
        // No difference or quotient of f32 overflows in f64, or vanishes.
        [quotients[0], quotients[1], u_x, p_y, u_y].iter().all(|number| number.is_finite())
    } else {
        let is_safe = |to_face: f64, t: f64| SAFE.contains(&t.abs()) || to_face == 0.0;
        SAFE.contains(&u_x.abs())
            && is_safe(to_faces[0], quotients[0])
            && is_safe(to_faces[1], quotients[1])
            && p_y.abs() <= *SAFE.end()
            && u_y.abs() <= *SAFE.end()
    };
    // Nothing degenerate is safe: u_x = 0 and an x that is not finite show in a quotient, or in u_x, and
    // no comparison holds for NaN.
    let quotients = (is_safe && front <= back).then_some(quotients);
    Robust { ray: *ray, wall: *wall, to_faces, quotients }
}

/// (face − p_x) / u_x to half a unit of its last digit and hardly more, from the rounded quotient q.
///
/// With u = 2^−53: the difference is known exactly, in two parts, and so are q u_x and the rest of the
/// division, but for one rounding. That rest is at most 2u of the difference, so that its rounding and that
/// of its quotient are 4u² of t. Then q + rest / u_x is rounded once.
#[inline(always)]
fn corrected(face: f64, p_x: f64, u_x: f64, q: f64) -> f64 {
    let to_face = two_sum(face, -p_x);
    let product = two_product(q, u_x);
    let rest = ((to_face.hi - product.hi) - product.lo) + to_face.lo;
    q + rest / u_x
}

impl<R: Real> Robust<R> {
    /// t of the face at x = `face`, from its quotient.
    #[inline(always)]
    fn t(&self, face: R, quotient: f64) -> f64 {
        if R::DIGITS < f64::MANTISSA_DIGITS {
            return quotient;
        }
        corrected(face.into(), self.ray.origin.x().into(), self.ray.direction.x().into(), quotient)
    }

    /// (front − p_x) / u_x, rounded, with no negative one rounded to zero; `None` where u_x = 0, and for a
    /// degenerate ray or wall.
    pub fn t_front(&self) -> Option<R> {
        Some(self.faces()?[0])
    }

    /// (back − p_x) / u_x, like [`Robust::t_front`].
    pub fn t_back(&self) -> Option<R> {
        Some(self.faces()?[1])
    }

    fn faces(&self) -> Option<[R; 2]> {
        let Some([front, back]) = self.quotients else {
            return careful::faces(&self.ray, &self.wall).map(|faces| faces.map(|t| t.rounded()));
        };
        let faces = [self.t(self.wall.front, front), self.t(self.wall.back, back)];
        Some(faces.map(|t| R::root_from(t) + R::from(0.0))) // minus zero is zero
    }

    /// Where the line of the ray meets the wall. Means nothing for what [`Wall::check`] refuses.
    pub fn crossing(&self) -> Crossing<R> {
        match self.faces() {
            Some([front, back]) => Crossing::Through(Roots::sorted(front, back)),
            None => Crossing::Along(self.wall.along(&self.ray)),
        }
    }

    /// The nearest hit in `span`. The x of the point is the face; its y is p_y + t u_y.
    ///
    /// `None` for a miss, which a ray along the wall is, too; [`Degenerate`] for a question without an
    /// answer, see [`Wall::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit2<R>>, Degenerate> {
        let (ray, wall) = (self.ray, self.wall);
        let Some([front, back]) = self.quotients else {
            return careful::hit(&ray, &wall, span);
        };
        let zero = R::from(0.0);
        // A quotient has the sign of its t: what lies behind needs no digits.
        if front < 0.0 && back < 0.0 && span.min >= zero {
            return Ok(None);
        }
        let [front, back] = [(wall.front, front), (wall.back, back)];
        let (near, far) = if ray.direction.x() > zero { (front, back) } else { (back, front) };
        let within = |(face, quotient): (R, f64)| {
            let t = self.t(face, quotient);
            span.contains(R::root_from(t)).then_some((face, t))
        };
        let enters = within(near);
        let Some((face, t)) = enters.or_else(|| within(far)) else { return Ok(None) };
        let y = ray.origin.y().into() + t * ray.direction.y().into();
        let point = R::vec2(face, R::round_from(y));
        let t = R::root_from(t) + zero; // minus zero is zero
        Ok(Some(Hit { t, point, normal: wall.normal(&ray, enters.is_none()) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn t(origin: f64, direction: f64, front: f64, back: f64) -> [Option<f64>; 2] {
        let ray = Ray2::<f64>::new(DVec2::new(origin, 0.0), DVec2::new(direction, 1.0));
        let wall = Wall { front, back };
        [crate::notes(&ray, &wall).hit(Span::ahead()), robust(&ray, &wall).hit(Span::ahead())]
            .map(|hit| hit.unwrap().map(|hit| hit.t))
    }

    #[test]
    fn a_difference_may_overflow_where_the_quotient_does_not() {
        // by hand: (1.5e308 + 1.5e308) / 1e300 = 3e8
        let [notes, robust] = t(-1.5e308, 1e300, 1.5e308, 1.6e308);
        assert_eq!(notes, Some(f64::INFINITY));
        let residual = (robust.unwrap() - 3e8).abs() / 3e8;
        assert!(residual < 1e-15, "{robust:?}");
    }

    #[test]
    fn a_wall_just_behind_stays_behind() {
        // by hand: t = −5e−324 / 1e10, behind the origin, and too small for any number
        let [notes, robust] = t(5e-324, 1e10, -1.0, 0.0);
        assert_eq!(notes, Some(0.0), "as printed it looks like a touch");
        assert_eq!(robust, None);
    }

    #[test]
    fn a_t_beyond_the_largest_number_is_a_hit_at_infinity() {
        // by hand: 1e10 / 5e−324 > 1.8e308
        assert_eq!(t(0.0, 5e-324, 1e10, 2e10), [Some(f64::INFINITY); 2]);
        let ray = Ray2::<f64>::new(DVec2::ZERO, DVec2::new(5e-324, 0.0));
        let hit = robust(&ray, &Wall { front: 1e10, back: 2e10 }).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!(hit.point, DVec2::new(1e10, 0.0), "the point is an ordinary one");
    }

    fn work(origin: f64, direction: f64, wall: Wall<f64>) -> Robust<f64> {
        robust(&Ray2::<f64>::new(DVec2::new(origin, 0.0), DVec2::new(direction, 1.0)), &wall)
    }

    #[test]
    fn both_ways_agree_where_they_meet() {
        for [inside, outside] in [[1e-100, 0.9e-100], [1e100, 1.1e100]] {
            for (direction, is_plain) in [(inside, true), (outside, false)] {
                let wall = Wall { front: 0.1, back: 0.7 };
                // the origin moved along, so that t itself is an ordinary number
                let scaled = Wall { front: wall.front * direction, back: wall.back * direction };
                let work = work(-0.3 * direction, direction, scaled);
                assert_eq!(work.quotients.is_some(), is_plain, "u_x = {direction:e}");
                let carefully = careful::faces(&work.ray, &work.wall).unwrap().map(|t| t.rounded::<f64>());
                assert_eq!([work.t_front().unwrap(), work.t_back().unwrap()], carefully);
                assert_eq!(work.hit(Span::ahead()), careful::hit(&work.ray, &work.wall, Span::ahead()));
            }
        }
    }

    #[test]
    fn one_correction_is_the_last_digit() {
        // by hand: front − p_x = 1 + 2^−54, which rounds to 1; over 3 it is 1/3 + 2^−55.6, and the float
        // 1/3 is 2^−55.6 too small
        let [tiny, third] = [2.0_f64.powi(-54), 1.0 / 3.0];
        let work = work(-tiny, 3.0, Wall { front: 1.0, back: 2.0 });
        assert_eq!((work.to_faces[0], work.quotients.unwrap()[0]), (1.0, third));
        assert_eq!(work.t_front(), Some(careful::faces(&work.ray, &work.wall).unwrap()[0].rounded()));
        assert_eq!(work.t_front(), Some(f64::next_up(third)));
    }

    #[test]
    fn all_of_f32_goes_the_plain_way() {
        let ends = [f32::MAX, 1.0, f32::MIN_POSITIVE, f32::SMALLEST];
        for x in ends {
            for u_x in ends {
                let ray = Ray2::<f32>::new(glam::Vec2::new(-x, 1.0), glam::Vec2::new(-u_x, 1.0));
                let work = robust(&ray, &Wall { front: x, back: x });
                assert!(work.quotients.is_some());
                let exact = careful::faces(&ray, &work.wall).unwrap()[0].rounded();
                assert_eq!(work.t_front(), Some(exact), "2 · {x:e} / −{u_x:e}");
                assert_eq!(work.hit(Span::ahead()), Ok(None), "behind");
            }
        }
    }

    #[test]
    fn touching_is_at_plus_zero() {
        for direction in [1.0, -1.0] {
            let touching = work(4.0, direction, Wall { front: 4.0, back: 4.5 });
            assert_eq!(touching.t_front().map(f64::to_bits), Some(0), "minus zero is zero");
            assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0);
        }
    }

    #[test]
    fn a_span_need_not_start_at_the_origin() {
        let behind = work(6.0, 1.0, Wall { front: 4.0, back: 4.5 });
        let t = |min, max| behind.hit(Span::new(min, max)).unwrap().map(|hit| (hit.t, hit.normal.x));
        assert_eq!(t(-3.0, 0.0), Some((-2.0, -1.0)), "enters");
        assert_eq!(t(-1.75, 0.0), Some((-1.5, 1.0)), "leaves");
        assert_eq!(t(-1.0, 0.0), None);
    }

    /// The plain way finds what is degenerate by its ranges.
    #[test]
    fn no_degenerate_number_passes_in_any_place() {
        let good = [0.5, 1.0, 0.25, -0.5, 4.0, 4.5];
        let reason = |[p_x, p_y, u_x, u_y, front, back]: [f64; 6]| {
            let (origin, direction) = (DVec2::new(p_x, p_y), DVec2::new(u_x, u_y));
            let found = robust(&Ray2::<f64>::new(origin, direction), &Wall { front, back });
            let narrow_ray = Ray2::<f32>::new(origin.as_vec2(), direction.as_vec2());
            let narrow = robust(&narrow_ray, &Wall { front: front as f32, back: back as f32 });
            let found = found.hit(Span::ahead()).err();
            assert_eq!(found, narrow.hit(Span::ahead()).err(), "{origin} {direction} {front} {back}");
            found
        };
        assert_eq!(reason(good), None);
        for place in 0..6 {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut case = good;
                case[place] = bad;
                assert_eq!(reason(case), Some(Degenerate::NotFinite), "{bad} in place {place}");
            }
        }
        assert_eq!(reason([0.5, 1.0, 0.0, -0.0, 4.0, 4.5]), Some(Degenerate::ZeroDirection));
        assert_eq!(reason([0.5, 1.0, 0.25, -0.5, 4.5, 4.0]), Some(Degenerate::FrontBeyondBack));
    }

    /// The verdict of the oracle, and its t rounded once but for hardly more than half a unit.
    #[cfg(feature = "stage")]
    #[test]
    fn right_in_every_regime() {
        assert_eq!(lab::first_beyond(&crate::stage::RayWall, 1, 300, |_, _| 1), None);
    }

    /// What it is worth in every regime, counted: see [`lab::tally()`].
    #[cfg(feature = "stage")]
    #[test]
    fn how_good() {
        insta::assert_snapshot!(lab::tally(&crate::stage::RayWall, 1, 200, [|_| "rays".to_string(); 2]));
    }
}

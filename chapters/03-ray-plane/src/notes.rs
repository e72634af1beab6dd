//! House 4.3, Equation 4.2.

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use crate::parallel::parallel;
use crate::{Hit3, Meeting, Plane, signed_distance};

/// Every number of House's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notes<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The plane.
    pub plane: Plane<R>,
    /// p_r − p_0, from the plane's point to the origin of the ray.
    pub from_plane: R::Vec3,
    /// n · (p_r − p_0): the signed distance of the origin, times ‖n‖.
    pub n_dot_p: R,
    /// n · u_r: how fast the ray leaves the plane, in units of ‖n‖ a length of u_r.
    pub n_dot_u: R,
    /// −n · (p_r − p_0) / n · u_r, Eq. 4.2, in lengths of u_r. Infinite or NaN where n · u_r = 0.
    pub t: R,
}

/// Works out House's method (Eq. 4.2), for a direction and a normal of any length but zero.
///
/// A degenerate ray or plane gives values that mean nothing; [`Notes::hit`] refuses them.
#[inline]
pub fn notes<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Notes<R> {
    let (p_r, u_r, p_0, n) = (ray.origin, ray.direction, plane.point, plane.normal);

    // exercise distance: How far is the origin above the plane, in lengths of n?
    // n · [(p_r + t u_r) − p_0] = 0, solved for t (Eq. 4.2)
    let from_plane = p_r - p_0;
    let n_dot_p = n.dot(from_plane);
    // end distance
    // exercise speed: How much does that change while t grows by 1?
    let n_dot_u = n.dot(u_r);
    // end speed
    // exercise t: So at which t is the distance zero?
    let t = -n_dot_p / n_dot_u;
    // end t

    Notes { ray: *ray, plane: *plane, from_plane, n_dot_p, n_dot_u, t }
}

impl<R: Real> Notes<R> {
    /// The page's questions answered: with n · u_r = 0 the ray is parallel, and lies in the plane if
    /// its origin does. That is decided exactly, see [`parallel`]; a ray that is only nearly parallel
    /// does meet the plane, at the t of Eq. 4.2.
    ///
    /// The numbers must be finite; see [`Plane::check`].
    #[inline]
    pub fn meeting(&self) -> Meeting<R> {
        // exercise meeting: Which rays meet the plane at no single t, and which of those lie within it?
        match parallel(&self.ray, &self.plane) {
            Some(how) => Meeting::Never(how),
            None => Meeting::At(self.t),
        }
        // end meeting
    }

    /// The signed distance of the origin from the plane, in units of the scene; NaN where n is zero.
    pub fn distance(&self) -> R {
        signed_distance(self.ray.origin, &self.plane).d
    }

    /// The hit, where its t lies in `span`. The normal is n / ‖n‖, on whichever side the ray comes from.
    ///
    /// `None` for a miss, which a ray within the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Plane::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.plane.check(&self.ray)?;
        let Meeting::At(t) = self.meeting() else { return Ok(None) };
        // exercise ahead: Which t are no hit?
        if !span.contains(t) {
            return Ok(None);
        }
        // end ahead
        let t = t + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point: self.ray.at(t), normal: self.plane.unit_normal() }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::Parallel;

    const GROUND: Plane<f64> = Plane { point: DVec3::ZERO, normal: DVec3::Y };

    fn work(origin: [f64; 3], direction: [f64; 3]) -> Notes<f64> {
        notes(&Ray3::new(origin.into(), direction.into()), &GROUND)
    }

    #[test]
    fn a_ray_down_to_the_ground() {
        // by hand: from height 1, falling 1/4 a length: t = 4
        let work = work([0.0, 1.0, 0.0], [0.25, -0.25, -1.0]);
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (4.0, DVec3::new(1.0, 0.0, -4.0), DVec3::Y));
        assert_eq!(work.distance(), 1.0);
    }

    /// "What happens if the ray is parallel? … How would you test for this?" (slip 6)
    #[test]
    fn the_pages_three_questions() {
        let apart = work([0.0, 1.0, 0.0], [1.0, 0.0, -1.0]);
        assert_eq!(apart.t, f64::NEG_INFINITY, "Eq. 4.2 as printed: −1 / 0");
        assert_eq!(apart.meeting(), Meeting::Never(Parallel::Apart));
        let within = work([3.0, 0.0, 2.0], [1.0, 0.0, -1.0]);
        assert!(within.t.is_nan(), "Eq. 4.2 as printed: 0 / 0");
        assert_eq!(within.meeting(), Meeting::Never(Parallel::Within));
        // a common test, |n · u_r| < 1e−6, would lose this one; it does meet the ground
        let nearly = work([0.0, 1.0, 0.0], [0.0, -1e-9, -1.0]);
        let hit = nearly.hit(Span::ahead()).unwrap().unwrap();
        assert!(hit.point.y.abs() < 1e-15 && (hit.t - 1e9).abs() < 1e-6, "{hit:?}");
    }

    #[test]
    fn behind_is_no_hit_and_touching_is() {
        assert_eq!(work([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]).hit(Span::ahead()), Ok(None));
        let touching = work([0.0, 0.0, 0.0], [0.0, 1.0, 0.0]).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!(touching.t.to_bits(), 0.0_f64.to_bits());
        let from_below = work([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]);
        assert_eq!(from_below.hit(Span::ahead()).unwrap().unwrap().t, 2.0);
        assert_eq!(from_below.distance(), -2.0);
    }

    #[test]
    fn questions_without_an_answer_are_refused() {
        let ray = Ray3::<f64>::new(DVec3::Y, DVec3::ZERO);
        assert_eq!(notes(&ray, &GROUND).hit(Span::ahead()), Err(Degenerate::ZeroDirection));
        let ray = Ray3::<f64>::new(DVec3::Y, DVec3::X);
        let flat = Plane { point: DVec3::ZERO, normal: DVec3::ZERO };
        assert_eq!(notes(&ray, &flat).hit(Span::ahead()), Err(Degenerate::ZeroNormal));
        let nowhere = Plane { point: DVec3::NAN, normal: DVec3::Y };
        assert_eq!(notes(&ray, &nowhere).hit(Span::ahead()), Err(Degenerate::NotFinite));
    }
}

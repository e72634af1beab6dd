//! The same division, rounded once.
//!
//! House's t = (front − p_x) / u_x is nearly as good as it looks: the difference is rounded, then the
//! quotient, and t is off by about one unit in its last place. Only its ends are bad: front − p_x
//! overflows where both are huge and of opposite sign, though the quotient is an ordinary number,
//! and a quotient below the smallest number rounds to −0, which looks like a touch at t = 0.
//!
//! Here the difference keeps its rounding error, exponents cannot overflow, and only the result is
//! rounded. What lies behind the origin stays behind it. And since the ray hits a face, the x of the
//! point is the x of the face, whatever p_x + t u_x rounds to.

use math::{Degenerate, Hit, Ray2, Real, Roots, Span, Vector, Wide};

use crate::{Crossing, Hit2, Wall};

/// Every number of the robust method.
///
/// A degenerate ray or wall, and one with u_x = 0, has no parameters; [`Robust::hit`] refuses the former.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray2<R>,
    /// The wall.
    pub wall: Wall<R>,
    /// front − p_x and back − p_x, to twice the digits. `None` as above.
    pub to_faces: Option<[Wide; 2]>,
    /// (front − p_x) / u_x and (back − p_x) / u_x, before they are rounded.
    faces: Option<[Wide; 2]>,
}

/// Works out the robust method.
pub fn robust<R: Real>(ray: &Ray2<R>, wall: &Wall<R>) -> Robust<R> {
    let (p_x, u_x) = (Wide::of(ray.origin.x()), Wide::of(ray.direction.x()));
    let mut work = Robust { ray: *ray, wall: *wall, to_faces: None, faces: None };
    if wall.check(ray).is_err() || u_x.is_zero() {
        return work;
    }
    let to_faces = [wall.front, wall.back].map(|x| Wide::of(x) - p_x);
    work.to_faces = Some(to_faces);
    work.faces = Some(to_faces.map(|to_face| to_face / u_x));
    work
}

impl<R: Real> Robust<R> {
    /// (front − p_x) / u_x, rounded; `None` where there is none.
    pub fn t_front(&self) -> Option<R> {
        self.faces.map(|[front, _]| front.rounded())
    }

    /// (back − p_x) / u_x, rounded; `None` where there is none.
    pub fn t_back(&self) -> Option<R> {
        self.faces.map(|[_, back]| back.rounded())
    }

    /// Where the line of the ray meets the wall.
    pub fn crossing(&self) -> Crossing<R> {
        match (self.t_front(), self.t_back()) {
            (Some(front), Some(back)) => Crossing::Through(Roots::sorted(front, back)),
            _ => Crossing::Along(self.wall.along(&self.ray)),
        }
    }

    /// The nearest hit in `span`. The x of the point is the face; t and the y p_y + t u_y are worked
    /// out with twice the digits and rounded at the end.
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit2<R>>, Degenerate> {
        self.wall.check(&self.ray)?;
        let (Some([front, back]), Crossing::Through(roots)) = (self.faces, self.crossing()) else {
            return Ok(None);
        };
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        let leaves = !span.contains(roots.near);
        let by_the_front = (self.ray.direction.x() > R::from(0.0)) != leaves;
        let (face, wide_t) = if by_the_front { (self.wall.front, front) } else { (self.wall.back, back) };
        let y = Wide::of(self.ray.origin.y()) + wide_t * Wide::of(self.ray.direction.y());
        let point = R::vec2(face, R::round_from(y.to_f64()));
        Ok(Some(Hit { t, point, normal: self.wall.normal(&self.ray, leaves) }))
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
}

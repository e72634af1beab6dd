//! House 4.2: put the x of a face into Eq. 4.1 and solve for t.

use math::{Degenerate, Hit, Ray2, Real, Roots, Span, Vector};

use crate::{Crossing, Hit2, Wall};

/// Every number of House's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notes<R: Real> {
    /// The ray.
    pub ray: Ray2<R>,
    /// The wall.
    pub wall: Wall<R>,
    /// Where the line is at x = front, in lengths of u_r: (front − p_x) / u_x. Infinite or NaN where u_x = 0.
    pub t_front: R,
    /// Where the line is at x = back, likewise.
    pub t_back: R,
}

/// Works out House's method (4.2), for a direction of any length but zero.
///
/// A degenerate ray or wall gives values that mean nothing; [`Notes::hit`] refuses them.
#[inline]
pub fn notes<R: Real>(ray: &Ray2<R>, wall: &Wall<R>) -> Notes<R> {
    let (p_x, u_x) = (ray.origin.x(), ray.direction.x());

    // exercise t: At which t is the x of the ray that of the front face, and at which that of the back face?
    // Eq. 4.1 in x alone: p_x + t u_x = front.
    let t_front = (wall.front - p_x) / u_x;
    let t_back = (wall.back - p_x) / u_x;
    // end t

    Notes { ray: *ray, wall: *wall, t_front, t_back }
}

impl<R: Real> Notes<R> {
    /// Where the line of the ray meets the wall: it is inside for t_front ≤ t ≤ t_back, or the other way
    /// round for a ray that points to −x. (The page prints "3 ≥ t ≥ 3.5", which no t satisfies.)
    ///
    /// Means nothing for what [`Wall::check`] refuses.
    #[inline]
    pub fn crossing(&self) -> Crossing<R> {
        // exercise crossing: Where does the line enter, where does it leave, and which lines do neither?
        if self.ray.direction.x() == R::from(0.0) {
            return Crossing::Along(self.wall.along(&self.ray));
        }
        Crossing::Through(Roots::sorted(self.t_front, self.t_back))
        // end crossing
    }

    /// The nearest hit in `span`: "we take t = 3". A ray that starts inside hits where it leaves; one
    /// that runs along the wall has no hit.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Wall::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit2<R>>, Degenerate> {
        self.wall.check(&self.ray)?;
        let Crossing::Through(roots) = self.crossing() else { return Ok(None) };
        // exercise first: Which of the two does the ray meet first in the span, and when is it neither?
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        // end first
        // exercise normal: Does it come in there or go out, and which way does that face look?
        let normal = self.wall.normal(&self.ray, !span.contains(roots.near));
        // end normal
        Ok(Some(Hit { t, point: self.ray.at(t), normal }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use math::Parallel;

    const WALL: Wall<f64> = Wall { front: 4.0, back: 4.5 };

    fn hit(origin: (f64, f64), direction: (f64, f64)) -> Option<Hit2<f64>> {
        notes(&Ray2::<f64>::new(origin.into(), direction.into()), &WALL).hit(Span::ahead()).unwrap()
    }

    #[test]
    fn the_page_hits_at_4_1_with_t_3() {
        let ray = Ray2::<f64>::new(DVec2::new(1.0, 1.0), DVec2::new(1.0, 0.0));
        let work = notes(&ray, &WALL);
        assert_eq!((work.t_front, work.t_back), (3.0, 3.5), "House 4.2");
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (3.0, DVec2::new(4.0, 1.0), DVec2::new(-1.0, 0.0)));
    }

    /// "the wall is hit by the ray for 3 ≥ t ≥ 3.5" (slip 1).
    #[test]
    fn as_printed_no_t_is_inside_the_wall() {
        let work = notes(&Ray2::<f64>::new(DVec2::new(1.0, 1.0), DVec2::X), &WALL);
        for t in [0.0, 3.0, 3.25, 3.5, 4.0] {
            assert!(!(work.t_front >= t && t >= work.t_back), "as printed");
            let inside = (4.0..=4.5).contains(&work.ray.at(t).x);
            assert_eq!(work.t_front <= t && t <= work.t_back, inside, "3 ≤ t ≤ 3.5, at t = {t}");
        }
    }

    /// A ray that starts inside has its front face behind it (slip 5).
    #[test]
    fn from_inside_it_hits_where_it_leaves() {
        let work = notes(&Ray2::<f64>::new(DVec2::new(4.25, 1.0), DVec2::X), &WALL);
        assert_eq!(work.t_front, -0.25, "the front face, as the page would have it, is behind");
        let out = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((out.t, out.point.x, out.normal.x), (0.25, 4.5, 1.0));
        let back = hit((4.25, 1.0), (-1.0, 0.0)).unwrap();
        assert_eq!((back.t, back.point.x, back.normal.x), (0.25, 4.0, -1.0));
    }

    #[test]
    fn from_behind_it_hits_the_back_face() {
        let hit = hit((6.0, 1.0), (-1.0, 0.0)).unwrap();
        assert_eq!((hit.t, hit.point.x, hit.normal.x), (1.5, 4.5, 1.0));
    }

    #[test]
    fn touching_counts_and_behind_does_not() {
        assert_eq!(hit((4.0, 1.0), (1.0, 0.0)).unwrap().t, 0.0);
        assert_eq!(hit((4.0, 1.0), (-1.0, 0.0)).unwrap().t, 0.0);
        assert!(hit((1.0, 1.0), (-1.0, 0.0)).is_none());
        assert!(hit((6.0, 1.0), (1.0, 0.0)).is_none());
    }

    #[test]
    fn along_the_wall_there_is_no_single_t() {
        for (x, how) in [(1.0, Parallel::Apart), (4.25, Parallel::Apart), (4.0, Parallel::Within)] {
            let work = notes(&Ray2::<f64>::new(DVec2::new(x, 1.0), DVec2::Y), &WALL);
            assert_eq!(work.crossing(), Crossing::Along(how), "x = {x}");
            assert_eq!(work.hit(Span::ahead()), Ok(None));
        }
    }

    #[test]
    fn questions_without_an_answer_are_refused() {
        let at = DVec2::new(1.0, 1.0);
        let refused = |direction, wall| notes(&Ray2::<f64>::new(at, direction), &wall).hit(Span::ahead());
        assert_eq!(refused(DVec2::ZERO, WALL), Err(Degenerate::ZeroDirection));
        assert_eq!(refused(DVec2::NAN, WALL), Err(Degenerate::NotFinite));
        assert_eq!(refused(DVec2::X, Wall { front: 2.0, back: 1.0 }), Err(Degenerate::FrontBeyondBack));
        assert!(refused(DVec2::X, Wall { front: 2.0, back: 2.0 }).unwrap().is_some(), "no thickness is fine");
    }
}

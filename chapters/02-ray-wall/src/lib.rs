//! Where does a ray hit a wall? The smallest hit there is, in the plane.
//!
//! The ray is x(t) = p_r + t u_r (Eq. 4.1). The wall is upright: everything between the face
//! x = front and the face x = back, without end in y. So only the x of the ray matters, and each face
//! is one linear equation, p_x + t u_x = front, with one division to solve it.
//!
//! [`mod@notes`] is that division. [`mod@robust`] is the same, rounded once. Both return a struct with
//! every number on the way, whose `hit(span)` is the answer. What the page leaves open (a ray that starts
//! inside, points away, or runs along a face) is decided in [`Crossing`].
//!
//! A ray that goes two to the right for each one up, and a wall four ahead:
//!
//! ```
//! use glam::DVec2;
//! use math::{Ray2, Span};
//! use ray_wall::{Wall, notes};
//!
//! let ray = Ray2::<f64>::new(DVec2::ZERO, DVec2::new(2.0, 1.0));
//! let work = notes(&ray, &Wall { front: 4.0, back: 6.0 });
//! let hit = work.hit(Span::ahead())?.expect("the wall is ahead");
//! assert_eq!((hit.t, hit.point), (2.0, DVec2::new(4.0, 2.0)));
//! # Ok::<(), math::Degenerate>(())
//! ```

#[cfg(feature = "stage")]
pub mod figure;
#[cfg(feature = "stage")]
mod measure;
pub mod notes;
#[cfg(feature = "stage")]
mod picture;
#[cfg(feature = "stage")]
pub mod regimes;
pub mod robust;
#[cfg(feature = "stage")]
pub mod stage;

use math::{Degenerate, Hit, Parallel, Ray2, Real, Roots, Span, Vector};

pub use notes::{Notes, notes};
pub use robust::{Robust, robust};

/// An upright wall: front ≤ x ≤ back, for every y (House 4.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall<R> {
    /// The x of its front face.
    pub front: R,
    /// The x of its back face, not less than `front`.
    pub back: R,
}

/// A hit in the plane.
pub type Hit2<R> = Hit<R, <R as Real>::Vec2>;

/// Where a line meets a wall, or why it has no single t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Crossing<R> {
    /// It enters by one face and leaves by the other, at these t, which may be negative.
    Through(Roots<R>),
    /// It runs along the wall: apart from the faces (inside or outside), or within one of them.
    Along(Parallel),
}

impl<R: Real> Wall<R> {
    /// Refuses a question without an answer: [`Degenerate::NotFinite`], [`Degenerate::ZeroDirection`],
    /// [`Degenerate::FrontBeyondBack`], whichever comes first.
    #[inline(always)]
    pub fn check(&self, ray: &Ray2<R>) -> Result<(), Degenerate> {
        let finite = [self.front, self.back].iter().all(|x| x.is_finite());
        if !finite || !ray.origin.is_finite() || !ray.direction.is_finite() {
            return Err(Degenerate::NotFinite);
        }
        if ray.direction.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        if self.front > self.back {
            return Err(Degenerate::FrontBeyondBack);
        }
        Ok(())
    }

    /// How a ray with u_x = 0 runs along this wall: [`Parallel::Within`] a face, or [`Parallel::Apart`] from
    /// both, inside the wall or outside. Decided on the numbers as given, so exactly.
    #[inline(always)]
    pub fn along(&self, ray: &Ray2<R>) -> Parallel {
        let p_x = ray.origin.x();
        if p_x == self.front || p_x == self.back { Parallel::Within } else { Parallel::Apart }
    }

    /// The outward unit normal of the face that the line of `ray` enters by (`far` = false) or leaves by. Its
    /// u_x must not be 0.
    #[inline(always)]
    pub fn normal(&self, ray: &Ray2<R>, far: bool) -> R::Vec2 {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        let by_the_front = (ray.direction.x() > zero) != far;
        R::vec2(if by_the_front { -one } else { one }, zero)
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// House 4.2.
    Notes,
    /// Rounded once, at the end.
    Robust,
}

impl Method {
    /// Every method.
    pub const ALL: [Method; 2] = [Method::Notes, Method::Robust];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::Notes => "notes",
            Method::Robust => "robust",
        }
    }

    /// Works the method out for one ray and one wall. Degenerate ones give values that mean nothing;
    /// [`Working::hit`] refuses them.
    pub fn work<R: Real>(self, ray: &Ray2<R>, wall: &Wall<R>) -> Working<R> {
        match self {
            Method::Notes => Working::Notes(notes(ray, wall)),
            Method::Robust => Working::Robust(robust(ray, wall)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<R: Real> {
    /// By House's method.
    Notes(Notes<R>),
    /// By the robust one.
    Robust(Robust<R>),
}

impl<R: Real> Working<R> {
    /// Where the line of the ray meets the wall. Means nothing for what [`Wall::check`] refuses.
    pub fn crossing(&self) -> Crossing<R> {
        match self {
            Working::Notes(work) => work.crossing(),
            Working::Robust(work) => work.crossing(),
        }
    }

    /// The nearest hit in `span`: for a ray that starts inside, where it leaves.
    ///
    /// `None` for a miss, which a ray along the wall is, too; [`Degenerate`] for a question without an
    /// answer, see [`Wall::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit2<R>>, Degenerate> {
        match self {
            Working::Notes(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    const WALL: Wall<f64> = Wall { front: 4.0, back: 4.5 };

    /// House 4.2, by hand: from (1, 1) along (1, ½) the faces are at t = 3 and 3½.
    #[test]
    fn every_method_enters_by_the_front_and_leaves_by_the_back() {
        let ray = Ray2::<f64>::new(DVec2::ONE, DVec2::new(1.0, 0.5));
        for method in Method::ALL {
            let work = method.work(&ray, &WALL);
            assert_eq!(
                work.crossing(),
                Crossing::Through(Roots { near: 3.0, far: 3.5 }),
                "{}",
                method.name()
            );
            let hit = |span| work.hit(span).unwrap().map(|hit| (hit.t, hit.point, hit.normal));
            assert_eq!(hit(Span::ahead()), Some((3.0, DVec2::new(4.0, 2.5), -DVec2::X)));
            assert_eq!(hit(Span::new(3.25, 9.0)), Some((3.5, DVec2::new(4.5, 2.75), DVec2::X)));
            assert_eq!(hit(Span::new(0.0, 2.75)), None);
        }
    }

    #[test]
    fn along_the_wall_no_method_has_a_t() {
        for (x, how) in [(1.0, Parallel::Apart), (4.25, Parallel::Apart), (4.5, Parallel::Within)] {
            for method in Method::ALL {
                let work = method.work(&Ray2::<f64>::new(DVec2::new(x, 1.0), DVec2::Y), &WALL);
                assert_eq!(
                    (work.crossing(), work.hit(Span::ahead())),
                    (Crossing::Along(how), Ok(None)),
                    "x = {x}"
                );
            }
        }
    }

    #[test]
    fn methods_have_the_names_that_are_asked_for() {
        assert_eq!(Method::ALL.map(Method::name), ["notes", "robust"]);
    }
}

//! Where does a ray hit a cylinder or a cone? A quadratic wall that goes on for ever, and planes that cut it off.
//!
//! The ray is a + λ d. The unit cylinder is x² + y² ≤ 1 for |z| ≤ 1, closed by two caps; the unit cone is
//! x² + y² ≤ ¼(1 − z)² for 0 ≤ z ≤ 1, its apex at z = 1, closed by its base (CSC418 11.3.5). [`mod@notes`] is the
//! page: find every point where the line meets the wall or a plane, test each, take the smallest λ. The page
//! prints x² + y² = ¼(1 − z²) for the cone, which is half an ellipsoid: [`mod@printed`] shows it. [`mod@robust`]
//! says where the tests go wrong, and asks signs first: which part is it? Then it works out one λ.
//! [`mod@open`] is the cone of a scene file: any axis, two radii, and no caps. [`scene`] is where the two
//! solids are seen from. [`Method`] lists the methods; each takes a [`Ray3`] and a [`Shape`] and returns a
//! struct with every number on the way, whose `hit(span)` is the answer.
//!
//! Down on the unit cylinder, and from the side:
//!
//! ```
//! use glam::DVec3;
//! use math::{Ray3, Span};
//! use quadric::{Shape, robust};
//!
//! let down = Ray3::<f64>::new(DVec3::new(0.5, 0.0, 4.0), -DVec3::Z);
//! let hit = robust(&down, Shape::Cylinder).hit(Span::ahead())?.expect("the cap is below");
//! assert_eq!((hit.t, hit.normal), (3.0, DVec3::Z));
//!
//! let aside = Ray3::<f64>::new(DVec3::new(3.0, 0.0, 0.0), -DVec3::X);
//! let hit = robust(&aside, Shape::Cylinder).hit(Span::ahead())?.expect("the wall is ahead");
//! assert_eq!((hit.t, hit.normal), (2.0, DVec3::X));
//! # Ok::<(), math::Degenerate>(())
//! ```

#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
mod measure;
pub mod notes;
pub mod open;
#[cfg(feature = "stage")]
mod picture;
pub mod printed;
#[cfg(feature = "stage")]
pub mod regimes;
pub mod robust;
pub mod scene;
#[cfg(feature = "stage")]
pub mod stage;

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

pub use notes::{Notes, notes};
pub use robust::{Robust, robust};

/// The unit solids of the page. Both are closed and convex: a line is inside for one stretch of λ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// x² + y² = 1 for |z| ≤ 1, with its two caps.
    Cylinder,
    /// x² + y² = ¼(1 − z)² for 0 ≤ z ≤ 1, with its base.
    Cone,
}

/// A part of the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The quadratic wall. The rim belongs to it as well as to the cap: a tie is the wall's.
    Wall,
    /// The cylinder's cap z = 1.
    Top,
    /// The cylinder's cap z = −1.
    Bottom,
    /// The cone's base z = 0.
    Base,
    /// The cone's apex (0, 0, 1), where the wall has no normal.
    Apex,
}

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

impl Shape {
    /// Both, in the order of the page. A case file's column holds a shape's place here.
    pub const ALL: [Shape; 2] = [Shape::Cylinder, Shape::Cone];

    /// The word in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Cylinder => "cylinder",
            Shape::Cone => "cone",
        }
    }

    /// The planes that cut off the wall: the caps or the base, from the top down.
    #[inline]
    pub fn caps(self) -> &'static [Part] {
        match self {
            Shape::Cylinder => &[Part::Top, Part::Bottom],
            Shape::Cone => &[Part::Base],
        }
    }

    /// What is lowest and highest: the planes z = −1 and 1 of the cylinder, the base of the cone and its apex.
    #[inline(always)]
    pub fn ends(self) -> (Part, Part) {
        match self {
            Shape::Cylinder => (Part::Bottom, Part::Top),
            Shape::Cone => (Part::Base, Part::Apex),
        }
    }

    /// The lowest and the highest z of the solid.
    #[inline]
    pub fn heights<R: Real>(self) -> (R, R) {
        match self {
            Shape::Cylinder => (R::from(-1.0), R::from(1.0)),
            Shape::Cone => (R::from(0.0), R::from(1.0)),
        }
    }

    /// The wall's f(p): x² + y² − 1 or x² + y² − ¼(1 − z)². Negative within the wall, zero on it. The wall
    /// goes on for ever: for the cone f is negative in its other nappe, too, above the apex.
    #[inline]
    pub fn wall<R: Real>(self, point: R::Vec3) -> R {
        let [x, y, z] = R::xyz(point);
        let one = R::from(1.0);
        match self {
            Shape::Cylinder => x * x + y * y - one,
            Shape::Cone => x * x + y * y - R::from(0.25) * (one - z) * (one - z),
        }
    }

    /// Half the gradient of the wall's f: (x, y, 0) or (x, y, ¼(1 − z)), not normalized. It points outward;
    /// at the apex it is zero.
    #[inline]
    pub fn half_gradient<R: Real>(self, point: R::Vec3) -> R::Vec3 {
        let [x, y, z] = R::xyz(point);
        match self {
            Shape::Cylinder => R::vec3(x, y, R::from(0.0)),
            Shape::Cone => R::vec3(x, y, R::from(0.25) * (R::from(1.0) - z)),
        }
    }

    /// The outward unit normal of a part at a point of it: ∇f / ‖∇f‖ on the wall (CSC418 11.6), ±z on a cap.
    ///
    /// At the apex the gradient is zero and the cone has no tangent plane; (0, 0, 1) is given there. On the
    /// wall a point that is not finite gives NaN.
    #[inline]
    pub fn normal<R: Real>(self, part: Part, point: R::Vec3) -> R::Vec3 {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        let up = R::vec3(zero, zero, one);
        match part {
            Part::Top | Part::Apex => up,
            Part::Bottom | Part::Base => R::vec3(zero, zero, -one),
            Part::Wall => {
                let gradient = self.half_gradient::<R>(point);
                if gradient.is_zero() { up } else { gradient.normalized() }
            }
        }
    }
}

impl Part {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Part::Wall => "wall",
            Part::Top => "top",
            Part::Bottom => "bottom",
            Part::Base => "base",
            Part::Apex => "apex",
        }
    }

    /// The z of the plane that it lies in; `None` for the wall.
    #[inline(always)]
    pub fn height(self) -> Option<f32> {
        match self {
            Part::Wall => None,
            Part::Top | Part::Apex => Some(1.0),
            Part::Bottom => Some(-1.0),
            Part::Base => Some(0.0),
        }
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// CSC418 11.3.5.
    Notes,
    /// Signs first, then one root.
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

    /// Works the method out for one ray and one solid. A degenerate ray gives values that mean nothing;
    /// [`Working::hit`] refuses it.
    pub fn work<R: Real>(self, ray: &Ray3<R>, shape: Shape) -> Working<R> {
        match self {
            Method::Notes => Working::Notes(notes(ray, shape)),
            Method::Robust => Working::Robust(robust(ray, shape)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<R: Real> {
    /// By the page's method.
    Notes(Notes<R>),
    /// By the robust one.
    Robust(Robust<R>),
}

impl<R: Real> Working<R> {
    /// The part that the ray meets first at λ ≥ 0; `None` for a miss. A degenerate ray's means nothing.
    pub fn part(&self) -> Option<Part> {
        match self {
            Working::Notes(work) => work.nearest(Span::ahead()).map(|place| work.candidates()[place].part),
            Working::Robust(work) => work.verdict.part(),
        }
    }

    /// The nearest hit in `span`, with the outward normal of [`Shape::normal`]: for a ray that starts
    /// inside, where it leaves. The robust method looks for nothing behind the origin.
    ///
    /// `None` for a miss, [`Degenerate`] for a ray that asks nothing, see [`Ray3::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Working::Notes(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// The words of a case file, and those that `--method` takes.
    #[test]
    fn names() {
        assert_eq!(Shape::ALL.map(Shape::name), ["cylinder", "cone"]);
        assert_eq!(Method::ALL.map(Method::name), ["notes", "robust"]);
    }

    /// By hand, at (2, 3, 5): 4 + 9 − 1, and 4 + 9 less a quarter of 16.
    #[test]
    fn the_equations_of_the_walls() {
        let point = DVec3::new(2.0, 3.0, 5.0);
        assert_eq!(Shape::ALL.map(|shape| shape.wall::<f64>(point)), [12.0, 9.0]);
    }
}

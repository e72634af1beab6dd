//! Which object does each pixel see? Ask every object, and keep the nearest.
//!
//! CSC418 11.4 has a scene as a list of objects with their deformations and identifiers, { obj, (A, t), objID }
//! ([`Scene`], [`Object`]), and two loops over the pixels around one over the objects. What comes out, the id of the
//! object that each pixel sees first, is the scene signature: a picture in which nothing is shaded, so that nothing
//! hides a wrong intersection. [`mod@first_hit`] is the page's inner loop and [`mod@trace_ray`] Gambetta's, which is
//! the same loop with another range of t.
//!
//! The shapes are those of the chapters before, each met by the formulas of the notes or by the robust ones
//! ([`Method`]). What puts them in their place is in [`mod@deform`]; `from_file` makes a scene of what a file
//! says.
//!
//! Two spheres, one behind the other:
//!
//! ```
//! use glam::DVec3;
//! use math::{Ray3, Span};
//! use ray_sphere::Sphere;
//! use signature::{Method, Object, Shape, first_hit};
//!
//! let at = |z| Sphere::<f64> { center: DVec3::new(0.0, 0.0, z), radius: 1.0 };
//! let objects = [9.0, 5.0].map(|z| Object { id: None, shape: Shape::Sphere(at(z)) });
//! let ray = Ray3::new(DVec3::ZERO, DVec3::Z);
//! let first = first_hit(Method::Robust, &ray, &objects, Span::ahead()).expect("both are ahead");
//! assert_eq!((first.object, first.lambda), (1, 4.0));
//! ```

pub mod deform;
#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
mod false_color;
pub mod first_hit;
#[cfg(feature = "stage")]
pub mod from_file;
#[cfg(feature = "stage")]
mod inspect;
#[cfg(all(test, feature = "stage"))]
mod judged;
#[cfg(feature = "stage")]
mod measure;
#[cfg(feature = "stage")]
mod picture;
#[cfg(feature = "stage")]
mod report;
mod shape;
#[cfg(feature = "stage")]
pub mod stage;
pub mod trace_ray;

use math::{Camera, Grid, Hit, Ray3, Real};

pub use deform::Transform;
pub use first_hit::first_hit;
pub use shape::Shape;
pub use trace_ray::trace_ray;

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

/// What is seen, and from where.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<R: Real> {
    /// The eye and the view plane.
    pub camera: Camera<R>,
    /// Where in a pixel its ray goes.
    pub grid: Grid,
    /// The picture's columns and rows.
    pub size: (u32, u32),
    /// In order: on a tie the earlier one is seen.
    pub objects: Vec<Object<R>>,
}

/// An object with its identifier, where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Object<R: Real> {
    /// The page's objID, from 1; `None` for an object past the 65535th of an NFF file.
    pub id: Option<u16>,
    /// The page's obj and (A, t) in one: see [`mod@deform`].
    pub shape: Shape<R>,
}

/// The object that a ray hits first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct First<R> {
    /// Its place among the scene's objects, from 0.
    pub object: usize,
    /// λ_ij, in lengths of the ray's direction.
    pub lambda: R,
}

impl<R: Real> Scene<R> {
    /// The ray from the eye through a pixel's point p̄_ij of the view plane: r̄(λ) = ē + λ (p̄_ij − ē).
    ///
    /// The page starts it at p̄_ij; we start at the eye, so that what stands before the view plane is seen too
    /// (slip 22). The page's λ is ours less 1. The pixel is (column, row), from the top left.
    ///
    /// Where the grid has no such point, as `edges` in a picture of one column, it is the middle of the
    /// window.
    #[inline]
    pub fn ray(&self, pixel: (u32, u32)) -> Ray3<R> {
        self.ray_within(pixel, (R::from(0.5), R::from(0.5)))
    }

    /// The same through another point of the pixel, across it and down it from 0 to 1: see
    /// [`Grid::point_within`].
    #[inline]
    pub fn ray_within(&self, pixel: (u32, u32), within: (R, R)) -> Ray3<R> {
        // A scene whose grid has no such point is refused when it is made.
        let point = self.grid.point_within(&self.camera.window, self.size, pixel, within);
        self.camera.ray(point.unwrap_or_else(|_| self.camera.window.center()))
    }
}

/// Which formulas the shapes use, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The robust method of every chapter.
    Robust,
    /// CSC418's of every chapter: `half-quadratic` for a sphere, `matrix` for a triangle and the faces of a
    /// mesh, else `notes`.
    Notes,
}

impl Method {
    /// Both, the default first.
    pub const ALL: [Method; 2] = [Method::Robust, Method::Notes];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::Robust => "robust",
            Method::Notes => "notes",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_method_has_its_own_name() {
        assert_ne!(Method::Robust.name(), Method::Notes.name());
    }
}

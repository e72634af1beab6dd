//! The page's (A, t): what puts an object in its place.
//!
//! A sphere, a cylinder and a cone that are deformed are no longer what they were; a ray meets them in their own
//! space (CSC418 11.3.4, chapter 07). What is flat stays what it is: a deformed plane is a plane, a deformed triangle a
//! triangle, so their points are moved once, before the first ray, and no ray pays for it. Where there is no
//! transform there is no (A, t) either.

use std::cmp::Ordering;

use affine::exact_sign::of_determinant;
use affine::{Affine, Deformed, Matrix3, Object};
use math::wide::{exponent_of, scaled};
use math::{Degenerate, Real, Vector, portable};
use quadric::Shape as Solid;
use ray_plane::Plane;
use ray_sphere::Sphere;

use crate::Shape;

/// One step of a transform, in double precision whatever the rays are in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// Along the three axes, each factor anything but 0.
    Scale([f64; 3]),
    /// About an axis through the origin, of any length but 0, by the right-hand rule.
    Rotate {
        /// The axis.
        axis: [f64; 3],
        /// How far.
        degrees: f64,
    },
    /// By a vector.
    Translate([f64; 3]),
    /// ȳ = A x̄, row by row, any matrix that has an inverse.
    Matrix([[f64; 3]; 3]),
}

impl Transform {
    /// The step as ȳ = A x̄ + t.
    pub fn affine(&self) -> Affine<f64> {
        let identity = Matrix3::identity();
        let linear = |a: Matrix3<f64>| Affine { a, t: f64::vec3(0.0, 0.0, 0.0) };
        match *self {
            Transform::Scale([x, y, z]) => {
                linear(Matrix3::from_rows([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]))
            }
            Transform::Rotate { axis, degrees } => linear(rotation(axis, degrees)),
            Transform::Translate([x, y, z]) => Affine { a: identity, t: f64::vec3(x, y, z) },
            Transform::Matrix(rows) => linear(Matrix3::from_rows(rows)),
        }
    }
}

/// Several steps in one, the first of them done first: A₂ (A₁ x̄ + t₁) + t₂ = (A₂ A₁) x̄ + (A₂ t₁ + t₂). Of no
/// step it is the identity. Whether the whole has an inverse is for [`Affine::check`] to say.
pub fn composed(steps: &[Transform]) -> Affine<f64> {
    let none = Affine { a: Matrix3::identity(), t: f64::vec3(0.0, 0.0, 0.0) };
    steps.iter().map(Transform::affine).fold(none, |first, next| Affine {
        a: Matrix3 { columns: first.a.columns.map(|column| next.a.times(column)) },
        t: next.apply(first.t),
    })
}

/// The rotation about k = axis / ‖axis‖ by θ, whose columns are what becomes of the three axes (Rodrigues):
/// v cos θ + (k × v) sin θ + k (k · v)(1 − cos θ).
fn rotation(axis: [f64; 3], degrees: f64) -> Matrix3<f64> {
    let k = f64::vec3(axis[0], axis[1], axis[2]).normalized();
    let (sin, cos) = sin_cos(degrees);
    let turned = |v| v * cos + f64::cross(k, v) * sin + k * (k.dot(v) * (1.0 - cos));
    Matrix3 { columns: Matrix3::<f64>::identity().columns.map(turned) }
}

/// sin and cos of an angle in degrees. A quarter turn is one exactly, which it is not in radians.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    let quarters = (turned / 90.0).round();
    let rest = (turned - quarters * 90.0).to_radians();
    let (sin, cos) = (portable::sin(rest), portable::cos(rest));
    match quarters as u32 % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// A deformation in another precision, each number rounded once: infinite where it is too large for R.
pub fn rounded<R: Real>(affine: &Affine<f64>) -> Affine<R> {
    Affine { a: Matrix3 { columns: affine.a.columns.map(vector::<R>) }, t: vector::<R>(affine.t) }
}

fn vector<R: Real>(v: <f64 as Real>::Vec3) -> R::Vec3 {
    let [x, y, z] = v.in_f64::<3>().map(R::round_from);
    R::vec3(x, y, z)
}

/// A sphere deformed: the unit sphere, made as large and put where the sphere is, then deformed.
///
/// The radius must be above 0. [`Degenerate::NotFinite`] and [`Degenerate::Singular`] as [`Affine::check`]
/// says of the whole, rounded to R.
pub fn sphere<R: Real>(sphere: &Sphere<f64>, by: &Affine<f64>) -> Result<Shape<R>, Degenerate> {
    let a = Matrix3 { columns: by.a.columns.map(|column| column * sphere.radius) };
    let whole = Affine { a, t: by.apply(sphere.center) };
    Ok(Shape::Deformed(Box::new(Deformed::new(Object::Sphere, rounded(&whole))?)))
}

/// The unit cylinder or cone deformed. Errors as [`sphere`].
pub fn solid<R: Real>(solid: Solid, by: &Affine<f64>) -> Result<Shape<R>, Degenerate> {
    let object = match solid {
        Solid::Cylinder => Object::Cylinder,
        Solid::Cone => Object::Cone,
    };
    Ok(Shape::Deformed(Box::new(Deformed::new(object, rounded(by))?)))
}

/// A plane deformed: a point of it is moved, and its normal becomes [`normal`]'s unit vector along A⁻ᵀ n
/// (CSC418 11.6.1).
pub fn plane(plane: &Plane<f64>, by: &Affine<f64>) -> Plane<f64> {
    Plane { point: by.apply(plane.point), normal: normal(plane.normal, &by.a) }
}

/// The direction of A⁻ᵀ n, a unit vector: that of adj(A)ᵀ n, turned over where A mirrors. A must have an inverse, and
/// n a direction; else it is NaN.
///
/// The products in adj(A) might overflow or vanish. So the columns of A are first made about as long as 1, by powers
/// of two S: with A = B S it is A⁻ᵀ n = B⁻ᵀ (S⁻¹ n).
pub fn normal(n: <f64 as Real>::Vec3, a: &Matrix3<f64>) -> <f64 as Real>::Vec3 {
    let exponents =
        a.columns.map(|column| column.in_f64::<3>().map(exponent_of).into_iter().max().unwrap_or(0));
    let columns = [0, 1, 2].map(|at| a.columns[at].in_f64::<3>().map(|x| scaled(x, -exponents[at])));
    let n = n.in_f64::<3>();
    let largest = (0..3).filter(|&at| n[at] != 0.0).map(|at| exponent_of(n[at]) - exponents[at]).max();
    let [x, y, z] = [0, 1, 2].map(|at| scaled(n[at], -exponents[at] - largest.unwrap_or(0)));
    let b = Matrix3::<f64> { columns: columns.map(|[x, y, z]| f64::vec3(x, y, z)) };
    let turned = b.adjugate().transposed_times(f64::vec3(x, y, z)).normalized();
    if of_determinant(a) == Ordering::Less { -turned } else { turned }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_quarter_turn_is_exact_and_right_handed() {
        let turn = |axis, degrees| Transform::Rotate { axis, degrees }.affine().a;
        let z = turn([0.0, 0.0, 7.0], 90.0);
        assert_eq!((z.times(DVec3::X), z.times(DVec3::Y)), (DVec3::Y, -DVec3::X));
        assert_eq!(turn([1.0, 0.0, 0.0], -270.0).times(DVec3::Y), DVec3::Z);
        assert_eq!(turn([0.0, 1.0, 0.0], 540.0).times(DVec3::X), -DVec3::X);
        // by hand: about (1, 1, 1) a third of a turn takes x to y, y to z, z to x
        let third = turn([1.0, 1.0, 1.0], 120.0);
        assert!((third.times(DVec3::X) - DVec3::Y).length() < 1e-15, "{third:?}");
        // sin 30° = 1/2
        assert!((turn([0.0, 0.0, 1.0], 30.0).times(DVec3::X).y - 0.5).abs() < 1e-16);
    }

    /// A quarter turn more makes of the cosine the sine and of the sine the cosine with the other sign, to the last bit.
    #[test]
    fn a_quarter_turn_more_changes_places() {
        for degrees in [10.0, 20.0, 44.0, -44.0] {
            let (sin, cos) = sin_cos(degrees);
            for (turn, want) in
                [(90.0, (cos, -sin)), (180.0, (-sin, -cos)), (270.0, (-cos, sin)), (360.0, (sin, cos))]
            {
                assert_eq!(sin_cos(degrees + turn), want, "{degrees} and {turn}");
            }
        }
    }

    /// By hand: (1, 0, 0) is scaled to (2, 0, 0), turned to (0, 2, 0), moved to (0, 2, 5).
    #[test]
    fn steps_are_done_in_the_order_written() {
        let whole = composed(&[
            Transform::Scale([2.0, 1.0, 1.0]),
            Transform::Rotate { axis: [0.0, 0.0, 1.0], degrees: 90.0 },
            Transform::Translate([0.0, 0.0, 5.0]),
        ]);
        assert_eq!(whole.apply(DVec3::X), DVec3::new(0.0, 2.0, 5.0));
        assert_eq!(whole.apply(DVec3::ZERO), DVec3::new(0.0, 0.0, 5.0));
        let moved_first = composed(&[Transform::Translate([1.0, 0.0, 0.0]), Transform::Scale([3.0; 3])]);
        assert_eq!(moved_first.apply(DVec3::ZERO), DVec3::X * 3.0);
        assert_eq!(composed(&[]).apply(DVec3::ONE), DVec3::ONE);
    }

    /// By hand: x + y = 2 stretched twofold along x is x/2 + y = 2.
    #[test]
    fn a_deformed_plane_is_a_plane() {
        let before = Plane { point: DVec3::new(1.0, 1.0, 0.0), normal: DVec3::new(1.0, 1.0, 0.0) };
        let after = plane(&before, &Transform::Scale([2.0, 1.0, 1.0]).affine());
        assert_eq!(after.point, DVec3::new(2.0, 1.0, 0.0));
        assert_eq!(after.normal, DVec3::new(1.0, 2.0, 0.0).normalize());
    }

    /// By hand: A⁻ᵀ of a scaling has the factors' inverses; the products of these factors are no numbers.
    #[test]
    fn a_normal_is_turned_whatever_the_size_of_the_deformation() {
        let by = |factors| Transform::Scale(factors).affine().a;
        for size in [1e-200, 1e200] {
            assert_eq!(normal(DVec3::Z, &by([size, size, 1.0])), DVec3::Z);
            assert_eq!(normal(DVec3::X * 1e-300, &by([size; 3])), DVec3::X);
            let askew = normal(DVec3::new(1.0, 2.0, 0.0), &by([size, 2.0 * size, size]));
            assert_eq!(askew, DVec3::new(1.0, 1.0, 0.0).normalize());
        }
        assert_eq!(
            normal(DVec3::X, &by([-1e-200, 1.0, 1.0])),
            -DVec3::X,
            "mirrored, it points the other way"
        );
        assert_eq!(normal(DVec3::Y, &by([-1e-200, 1.0, 1.0])), DVec3::Y);
    }

    /// By hand: the sphere of radius 2 about (1, 0, 0), stretched twofold along x, spans x from −2 to 6.
    #[test]
    fn a_deformed_sphere_has_its_center_and_radius() {
        use math::{Ray3, Span};
        let before = Sphere { center: DVec3::X, radius: 2.0 };
        let after = sphere::<f64>(&before, &Transform::Scale([2.0, 1.0, 1.0]).affine()).unwrap();
        let ray = Ray3::new(DVec3::new(-10.0, 0.0, 0.0), DVec3::X);
        for method in crate::Method::ALL {
            let hit = after.hit(method, &ray, Span::ahead()).unwrap();
            assert_eq!((hit.t, hit.normal), (8.0, -DVec3::X), "{method:?}");
        }
        let flat = Affine { a: Matrix3::from_rows([[1.0, 0.0, 0.0]; 3]), t: DVec3::ZERO };
        assert_eq!(sphere::<f64>(&before, &flat), Err(Degenerate::Singular));
    }
}

//! The normal, three ways (CSC418 11.6).
//!
//! Of a surface f(p̄) = 0 it is the gradient at unit length, ∇f / ‖∇f‖. Of a surface s(α, β) it is the cross
//! product of the two tangents, ∂s/∂α × ∂s/∂β, at unit length; its sign depends on the order of the
//! parameters, and outward has to be chosen (slip 27). Of a mesh it is the face's, or interpolated between
//! the corners. Where a surface can be written in all three ways they agree: the first two to the last
//! digits, the third as far as the mesh is the surface.

use math::{Real, Vector};

/// A unit shape about which the three ways can be asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Smooth {
    /// x² + y² + z² − 1 = 0
    Sphere,
    /// x² + y² − 1 = 0
    Cylinder,
    /// x² + y² − ¼(1 − z)² = 0
    Cone,
}

/// ∇f and its unit vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByGradient<R: Real> {
    /// ∇f(p̄)
    pub gradient: R::Vec3,
    /// ∇f / ‖∇f‖
    pub n: R::Vec3,
}

/// The tangents and their cross product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByTangents<R: Real> {
    /// ∂s/∂α
    pub along_alpha: R::Vec3,
    /// ∂s/∂β
    pub along_beta: R::Vec3,
    /// ∂s/∂α × ∂s/∂β
    pub cross: R::Vec3,
    /// At unit length, and outward.
    pub n: R::Vec3,
    /// The cross product pointed inward and was turned: the order of the parameters was the other one.
    pub was_turned: bool,
}

/// The first way, at a point of the shape. At the apex of the cone the gradient is zero, and n⃗ is NaN.
pub fn by_gradient<R: Real>(shape: Smooth, p: R::Vec3) -> ByGradient<R> {
    let ([x, y, z], two) = (R::xyz(p), R::from(2.0));
    // exercise gradient: How does each f change along x, along y and along z?
    let gradient: R::Vec3 = match shape {
        Smooth::Sphere => R::vec3(two * x, two * y, two * z),
        Smooth::Cylinder => R::vec3(two * x, two * y, R::from(0.0)),
        Smooth::Cone => R::vec3(two * x, two * y, R::from(0.5) * (R::from(1.0) - z)),
    };
    // end gradient
    // exercise unit: What has to be done to the gradient before it is the unit normal?
    ByGradient { gradient, n: gradient.normalized() }
    // end unit
}

/// The second way, with α around the z axis and β along it: s = (ρ cos α, ρ sin α, z), where ρ is the
/// distance from the axis. At a point on the axis, where every α is the same point, the tangents and n⃗ are
/// not numbers or zero.
///
/// - Sphere: ρ = cos β, z = sin β.
/// - Cylinder: ρ = 1, z = β.
/// - Cone: ρ = ½(1 − β), z = β.
pub fn by_tangents<R: Real>(shape: Smooth, p: R::Vec3) -> ByTangents<R> {
    let ([x, y, z], zero, one) = (R::xyz(p), R::from(0.0), R::from(1.0));
    let rho = (x * x + y * y).sqrt();
    let (cos_alpha, sin_alpha) = (x / rho, y / rho);
    // ∂s/∂α = (−ρ sin α, ρ cos α, 0)
    let along_alpha = R::vec3(-y, x, zero);
    // exercise along_beta: Where does the point of each surface go as β grows a little?
    // ∂s/∂β = (ρ′ cos α, ρ′ sin α, z′)
    let along_beta: R::Vec3 = match shape {
        Smooth::Sphere => R::vec3(-(z * cos_alpha), -(z * sin_alpha), rho),
        Smooth::Cylinder => R::vec3(zero, zero, one),
        Smooth::Cone => {
            let half = R::from(0.5);
            R::vec3(-(half * cos_alpha), -(half * sin_alpha), one)
        }
    };
    // end along_beta
    // exercise outward: Which vector is at right angles to both tangents, and does it point inward?
    let cross: R::Vec3 = R::cross(along_alpha, along_beta);
    // outward is away from the axis; at the poles of the sphere too, in the limit
    let was_turned: bool = cross.dot(R::vec3(x, y, zero)) < zero;
    // end outward
    let n = cross.normalized();
    ByTangents { along_alpha, along_beta, cross, n: if was_turned { -n } else { n }, was_turned }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Points of the three shapes by hand: 3-4-5 around the axis, at half height.
    fn points() -> [(Smooth, DVec3); 3] {
        let around = DVec3::new(0.6, 0.8, 0.0);
        [
            (Smooth::Sphere, around * 0.8 + DVec3::Z * 0.6),
            (Smooth::Cylinder, around + DVec3::Z * 0.5),
            (Smooth::Cone, around * 0.25 + DVec3::Z * 0.5),
        ]
    }

    /// The closed forms: of the sphere p̄ itself; of the cylinder the way from the axis; of the cone 2 away
    /// from the axis and 1 up.
    #[test]
    fn gradient_and_tangents_agree_with_the_closed_form() {
        for (shape, p) in points() {
            let around = DVec3::new(0.6, 0.8, 0.0);
            let want = match shape {
                Smooth::Sphere => p,
                Smooth::Cylinder => around,
                Smooth::Cone => (around * 2.0 + DVec3::Z) / 5f64.sqrt(),
            };
            assert!((by_gradient::<f64>(shape, p).n - want).length() < 4.0 * f64::EPSILON, "{shape:?}");
            assert!((by_tangents::<f64>(shape, p).n - want).length() < 4.0 * f64::EPSILON, "{shape:?}");
        }
    }

    /// Slip 27: with the parameters the other way round the product points inward.
    #[test]
    fn as_printed_the_sign_depends_on_the_order() {
        for (shape, p) in points() {
            let it = by_tangents::<f64>(shape, p);
            let other = it.along_beta.cross(it.along_alpha);
            assert_eq!(other, -it.cross);
            assert!(it.cross.dot(p) * other.dot(p) < 0.0);
        }
    }

    /// By hand: at (2⁻⁶⁰⁰, 0, ½) the product of (0, x, 0) and (0, 0, 1) is (x, 0, 0), which is away from the
    /// axis. Its scalar product with (x, 0, 0) vanishes, and that is not below zero.
    #[test]
    fn a_step_from_the_axis_is_enough_to_know_outward() {
        let it = by_tangents::<f64>(Smooth::Cylinder, DVec3::new((2.0_f64).powi(-600), 0.0, 0.5));
        assert_eq!((it.n, it.was_turned), (DVec3::X, false));
    }
}

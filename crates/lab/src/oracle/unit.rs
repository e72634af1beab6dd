//! The unit objects, and the ray in their coordinates.

use super::cone::cone;
use super::flat::{plane, triangle};
use super::round::{cylinder, sphere};
use super::{Dyadic, Verdict};

/// A shape of size 1 at the origin, of which an affine map makes all others of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitObject {
    /// ‖p‖ ≤ 1
    Sphere,
    /// x² + y² ≤ 1 and |z| ≤ 1: closed by two caps.
    Cylinder,
    /// x² + y² ≤ ¼ (1 − z)² and 0 ≤ z ≤ 1: the apex is at z = 1, the base of radius ½ at z = 0.
    Cone,
    /// z = 0
    Plane,
    /// z = 0, x ≥ 0, y ≥ 0 and x + y ≤ 1: corners at (0, 0, 0), (1, 0, 0) and (0, 1, 0).
    Triangle,
}

/// A ray p_r + t d where the unit objects are `scale` times as large, scale > 0.
///
/// The t of a hit is the same at every scale. With a scale no coordinate needs a division.
#[derive(Clone, Debug)]
pub(super) struct ScaledRay {
    pub(super) origin: [Dyadic; 3],
    pub(super) direction: [Dyadic; 3],
    pub(super) scale: Dyadic,
}

impl UnitObject {
    /// All of them.
    pub const ALL: [UnitObject; 5] =
        [UnitObject::Sphere, UnitObject::Cylinder, UnitObject::Cone, UnitObject::Plane, UnitObject::Triangle];

    /// The name in the column `shape` of a case.
    pub fn name(self) -> &'static str {
        match self {
            UnitObject::Sphere => "sphere",
            UnitObject::Cylinder => "cylinder",
            UnitObject::Cone => "cone",
            UnitObject::Plane => "plane",
            UnitObject::Triangle => "triangle",
        }
    }

    /// What is true of it and a ray, whose direction is not zero.
    pub(super) fn verdict(self, ray: &ScaledRay) -> Verdict {
        match self {
            UnitObject::Sphere => sphere(ray),
            UnitObject::Cylinder => cylinder(ray),
            UnitObject::Cone => cone(ray),
            UnitObject::Plane => plane(ray),
            UnitObject::Triangle => triangle(ray),
        }
    }
}

//! The scenes that are measured in: a shape that stands alone, of some size, somewhere.

/// A scene that is measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Regime {
    /// Its name, for `--regime`.
    pub(crate) name: &'static str,
    /// What it is, in half a sentence.
    pub(crate) what: &'static str,
    /// What stands there.
    pub(crate) kind: Kind,
    /// About its radius.
    pub(crate) size: f64,
    /// How far its center is from the origin of the world.
    pub(crate) distance: f64,
    /// Where the second ray goes.
    pub(crate) way: Way,
}

/// What stands there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A sphere.
    Sphere,
    /// A sphere of which the eye sees a little around the origin.
    Ground,
    /// A plane that leans.
    Plane,
    /// A triangle.
    Triangle,
    /// An octahedron with interpolated normals.
    Mesh,
    /// The unit cylinder.
    Cylinder,
    /// The unit cone.
    Cone,
    /// A truncated cone without caps.
    OpenCone,
    /// A sphere deformed by any matrix.
    Ellipsoid,
    /// A cylinder deformed by any matrix.
    DeformedCylinder,
    /// A cone deformed by any matrix.
    DeformedCone,
    /// A sphere squashed to a disk, 1 to 1e-3.
    Squashed,
}

/// Where a second ray goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Away from the surface, as to a light.
    Leaves,
    /// Into the solid, as a refracted one.
    Enters,
}

/// The five scenes of the bar first; then scales, distances, shapes.
pub(crate) const REGIMES: [Regime; 24] = [
    sphere("unit-at-0", "a sphere of radius 1 at the origin", 1.0, 0.0),
    sphere("small-at-7", "a sphere of radius 1e-3, 7 from the origin", 1e-3, 7.0),
    sphere("unit-at-1e3", "a sphere of radius 1, 1e3 from the origin", 1.0, 1e3),
    sphere("small-at-1e3", "a sphere of radius 1e-3, 1e3 from the origin", 1e-3, 1e3),
    of(Kind::Ground, "ground", "a sphere of radius 1e6, seen near its top at the origin", 1e6, 0.0),
    sphere("scale-1e-6", "a sphere of radius 1e-6, 3 radii from the origin", 1e-6, 3e-6),
    sphere("scale-1e-3", "a sphere of radius 1e-3, 3 radii from the origin", 1e-3, 3e-3),
    sphere("scale-1", "a sphere of radius 1, 3 radii from the origin", 1.0, 3.0),
    sphere("scale-1e3", "a sphere of radius 1e3, 3 radii from the origin", 1e3, 3e3),
    sphere("scale-1e6", "a sphere of radius 1e6, 3 radii from the origin", 1e6, 3e6),
    sphere("far-1e4", "a sphere of radius 1, 1e4 from the origin", 1.0, 1e4),
    sphere("far-1e6", "a sphere of radius 1, 1e6 from the origin", 1.0, 1e6),
    sphere("far-1e8", "a sphere of radius 1, 1e8 from the origin", 1.0, 1e8),
    Regime {
        way: Way::Enters,
        ..sphere("into-sphere", "into a sphere of radius 1, whose other side has to be met", 1.0, 3.0)
    },
    of(Kind::Plane, "plane", "a plane that leans, and one 1e-4 above it", 1.0, 10.0),
    of(Kind::Triangle, "triangle", "a triangle with a side of about 1", 1.0, 10.0),
    of(Kind::Mesh, "mesh", "an octahedron with interpolated normals", 1.0, 10.0),
    of(Kind::Cylinder, "cylinder", "the unit cylinder", 1.0, 0.0),
    of(Kind::Cone, "cone", "the unit cone", 1.0, 0.0),
    of(Kind::OpenCone, "open-cone", "a truncated cone without caps", 1.0, 10.0),
    of(Kind::Ellipsoid, "ellipsoid", "a sphere deformed by any matrix", 1.0, 10.0),
    of(Kind::DeformedCylinder, "deformed-cylinder", "a cylinder deformed by any matrix", 1.0, 10.0),
    of(Kind::DeformedCone, "deformed-cone", "a cone deformed by any matrix", 1.0, 10.0),
    of(Kind::Squashed, "squashed", "a sphere squashed to a disk of 1 to 1e-3", 1.0, 10.0),
];

/// How many of them are the scenes of the bar.
#[cfg(test)]
pub(crate) const OF_THE_BAR: usize = 5;

const fn sphere(name: &'static str, what: &'static str, size: f64, distance: f64) -> Regime {
    of(Kind::Sphere, name, what, size, distance)
}

const fn of(kind: Kind, name: &'static str, what: &'static str, size: f64, distance: f64) -> Regime {
    Regime { name, what, kind, size, distance, way: Way::Leaves }
}

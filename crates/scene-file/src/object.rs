//! What stands in a scene.

use std::sync::Arc;

use crate::{At, Place};

/// One object: its shape, where it is put, what it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Where the file describes it: the line of the shape.
    pub place: Place,
    /// For the scene signature: 1 to 65535, unique in the scene. `None`: an object of an NFF file after the 65535th,
    /// which no signature can tell.
    pub id: Option<u16>,
    /// What it is, in its own space.
    pub shape: Shape,
    /// What is done to it, in the order of the file; empty for most.
    pub transform: Vec<At<Transform>>,
    /// Its place among the scene's materials.
    pub material: usize,
}

/// A shape, as the file gives it: whether its corners lie in one plane and span an area is for whoever takes
/// it to say.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points at a distance from a center.
    Sphere {
        /// c
        center: [f64; 3],
        /// r, above 0.
        radius: f64,
    },
    /// All points x with n · (x − p) = 0.
    Plane {
        /// p
        point: [f64; 3],
        /// n, of any length but 0.
        normal: [f64; 3],
    },
    /// Three corners.
    Triangle {
        /// p̄1, p̄2, p̄3
        vertices: [[f64; 3]; 3],
    },
    /// Three corners or more in one plane.
    Polygon {
        /// In order around it.
        vertices: Vec<[f64; 3]>,
    },
    /// The unit cylinder, closed.
    Cylinder,
    /// The unit cone, closed.
    Cone,
    /// Many triangles from an OBJ file.
    Mesh {
        /// What the file holds; one file is read once.
        mesh: Arc<Mesh>,
        /// Whether the normals in between are interpolated.
        smooth: bool,
    },
    /// NFF's cone or cylinder: open at both ends, seen from both sides.
    OpenCone {
        /// The middle of one end.
        base: [f64; 3],
        /// Its radius there, from 0 up.
        base_radius: f64,
        /// The middle of the other end, another point than `base`.
        apex: [f64; 3],
        /// Its radius there, from 0 up; one of the two is above 0.
        apex_radius: f64,
    },
    /// NFF's polygonal patch: a fan with interpolated normals.
    Patch {
        /// In order around it, three or more.
        vertices: Vec<[f64; 3]>,
        /// One a vertex, of any length, 0 too.
        normals: Vec<[f64; 3]>,
    },
}

/// Triangles that share their vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Where they are.
    pub vertices: Vec<[f64; 3]>,
    /// Three places among the vertices each, from 0. A face of more corners is a fan of them.
    pub faces: Vec<[u32; 3]>,
    /// The normals (`vn`) at the corners of each face where the file has them; empty where it has none at all.
    pub normals: Vec<[Option<[f64; 3]>; 3]>,
}

/// One step of a transform, applied to the shape in the order written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// Along the three axes, each factor anything but 0.
    Scale([f64; 3]),
    /// About an axis through the origin, by the right-hand rule.
    Rotate {
        /// Of any length but 0.
        axis: [f64; 3],
        /// How far; below 0 the other way.
        degrees: f64,
    },
    /// By a vector.
    Translate([f64; 3]),
    /// ȳ = A x̄, row by row; it may have no inverse.
    Matrix([[f64; 3]; 3]),
}

//! Triangles that share their corners, and the normal of the surface that they stand for (CSC418 11.6).
//!
//! A mesh is a list of vertices and a list of faces, each of them three places in the first list. A ray meets it
//! where it meets the nearest of its faces. "For mesh surfaces, we might interpolate smoothly from face normals
//! (like we did to get normals at a vertex). Otherwise we can just use the face normal": a [`MeshHit`] has both.
//!
//! Two faces that share an edge share its two vertices to the last bit. That is what lets the robust method
//! promise that no ray slips through between them; `trade` counts for how many it does with the others.

pub mod ball;
mod normals;

use std::fmt;

use math::{Degenerate, Ray3, Real, Span, Vector};

use crate::{Hit3, Method, Triangle};

/// Vertices, and faces that name three of them each.
///
/// A face whose corners lie on one line, or are one vertex twice, may be among them: scanned and exported meshes are
/// full of such. It has no area and is never hit; the faces beside it close the surface without it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh<R: Real> {
    vertices: Vec<R::Vec3>,
    faces: Vec<[usize; 3]>,
    normals: Option<Vec<[R::Vec3; 3]>>,
}

/// Where a ray meets a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshHit<R: Real> {
    /// t, the point, and the normal of the face, not turned toward the ray.
    pub hit: Hit3<R>,
    /// Which face of [`Mesh::faces`], from 0.
    pub face: usize,
    /// α and β of the point in that face; `None` where the face is so small that the method has none to give.
    pub alpha_beta: Option<(R, R)>,
    /// The normal to shade with, of length 1: the interpolated one of a smooth mesh, that of the face of another.
    pub shading_normal: R::Vec3,
}

/// Why vertices and faces make no mesh. Everything is counted from 0, as the faces count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotAMesh {
    /// There are no faces.
    NoFaces,
    /// A coordinate of a vertex is infinite or NaN.
    NotFinite {
        /// Which vertex.
        vertex: usize,
    },
    /// A face names a vertex that there is not.
    NoSuchVertex {
        /// Which face.
        face: usize,
        /// What it names.
        vertex: usize,
        /// How many vertices there are.
        count: usize,
    },
    /// There are more or fewer normals than faces.
    NormalsMissing {
        /// For how many faces normals are given.
        given: usize,
        /// How many faces there are.
        faces: usize,
    },
}

impl fmt::Display for NotAMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotAMesh::NoFaces => write!(f, "the mesh has no faces: give it one at least"),
            NotAMesh::NotFinite { vertex } => {
                write!(f, "vertex {vertex} is infinite or not a number: give it three finite coordinates")
            }
            NotAMesh::NoSuchVertex { face, vertex, count } => write!(
                f,
                "face {face} names vertex {vertex}, and there are {count}, counted from 0: name one of them"
            ),
            NotAMesh::NormalsMissing { given, faces } => {
                write!(f, "there are normals for {given} faces of {faces}: give them for each, or for none")
            }
        }
    }
}

impl std::error::Error for NotAMesh {}

impl<R: Real> Mesh<R> {
    /// A mesh that is shaded flat, each face with its own normal, which points to where its corners run
    /// counterclockwise.
    ///
    /// A face holds the places of its corners among the vertices, from 0. [`NotAMesh`] says which vertex or
    /// face is wrong.
    pub fn new(vertices: Vec<R::Vec3>, faces: Vec<[usize; 3]>) -> Result<Mesh<R>, NotAMesh> {
        let count = vertices.len();
        if faces.is_empty() {
            return Err(NotAMesh::NoFaces);
        }
        if let Some(vertex) = vertices.iter().position(|vertex| !vertex.is_finite()) {
            return Err(NotAMesh::NotFinite { vertex });
        }
        for (face, corners) in faces.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex >= count) {
                return Err(NotAMesh::NoSuchVertex { face, vertex, count });
            }
        }
        Ok(Mesh { vertices, faces, normals: None })
    }

    /// The same mesh shaded smoothly (CSC418 11.6): at each vertex the mean of the normals of the faces
    /// that share it, each weighted by its area; in between, interpolated. Where the mean is zero, the
    /// face's own normal.
    pub fn smooth(self) -> Mesh<R> {
        let none = vec![[None; 3]; self.faces.len()];
        self.with_normals_where(&none)
    }

    /// The same mesh shaded smoothly, with normals of one's own at the corners of each face, in the order
    /// of the faces and in any length. Where a corner has none, or one without a direction (zero, or not
    /// finite), what [`Mesh::smooth`] has there stands in.
    ///
    /// [`NotAMesh::NormalsMissing`] where there are not as many as there are faces.
    pub fn with_normals(self, normals: &[[Option<R::Vec3>; 3]]) -> Result<Mesh<R>, NotAMesh> {
        let (given, faces) = (normals.len(), self.faces.len());
        if given != faces {
            return Err(NotAMesh::NormalsMissing { given, faces });
        }
        Ok(self.with_normals_where(normals))
    }

    fn with_normals_where(self, given: &[[Option<R::Vec3>; 3]]) -> Mesh<R> {
        let normals = normals::at_corners(&self, given);
        Mesh { normals: Some(normals), ..self }
    }

    /// The vertices.
    pub fn vertices(&self) -> &[R::Vec3] {
        &self.vertices
    }

    /// The faces: the places of their corners among the vertices.
    pub fn faces(&self) -> &[[usize; 3]] {
        &self.faces
    }

    /// The unit normals at the three corners of each face; `None` for a mesh that is shaded flat. A face
    /// without area may have zeros there.
    pub fn normals(&self) -> Option<&[[R::Vec3; 3]]> {
        self.normals.as_deref()
    }

    /// A face as a triangle. The face, counted from 0, must be one of the mesh; of another one it panics, as
    /// [`Mesh::hit_on`] does.
    #[inline]
    pub fn triangle(&self, face: usize) -> Triangle<R> {
        let [p1, p2, p3] = self.faces[face].map(|vertex| self.vertices[vertex]);
        Triangle { p1, p2, p3 }
    }

    /// The nearest hit in `span`, by a method of this chapter: one face after the other. On a tie the earlier face
    /// wins; at a shared edge the faces are at the same t but for rounding.
    ///
    /// `None` for a miss; [`Degenerate`] for a ray that is none. A face without area is passed over.
    pub fn hit(
        &self,
        method: Method,
        ray: &Ray3<R>,
        span: Span<R>,
    ) -> Result<Option<MeshHit<R>>, Degenerate> {
        ray.check()?;
        let mut nearest: Option<(usize, Hit3<R>)> = None;
        for face in 0..self.faces.len() {
            let Ok(Some(hit)) = method.work(ray, &self.triangle(face)).hit(span) else { continue };
            if nearest.is_none_or(|(_, nearest)| hit.t < nearest.t) {
                nearest = Some((face, hit));
            }
        }
        Ok(nearest.map(|(face, hit)| self.hit_on(method, ray, face, hit)))
    }

    /// The normal to shade with at (α, β) of a face of the mesh: the interpolated one, of length 1. `None`
    /// for a mesh that is shaded flat, and where the corners' normals cancel.
    pub fn normal_at(&self, face: usize, alpha_beta: (R, R)) -> Option<R::Vec3> {
        normals::interpolated::<R>(self.normals.as_ref()?[face], alpha_beta)
    }

    /// What there is to say of a hit on a face: where in the face it is, and the normal to shade with. The
    /// hit must be that of this ray and this face.
    pub fn hit_on(&self, method: Method, ray: &Ray3<R>, face: usize, hit: Hit3<R>) -> MeshHit<R> {
        let alpha_beta = method.work(ray, &self.triangle(face)).alpha_beta();
        let shading_normal = match (&self.normals, alpha_beta) {
            (Some(normals), Some(alpha_beta)) => {
                normals::interpolated::<R>(normals[face], alpha_beta).unwrap_or(hit.normal)
            }
            _ => hit.normal,
        };
        MeshHit { hit, face, alpha_beta, shading_normal }
    }
}

impl<R: Real> MeshHit<R> {
    /// The face's normal and the one to shade with as seen by a ray with this direction: the face is turned toward
    /// where the ray comes from, and the other turns with it. (By itself an interpolated normal might turn the
    /// other way near a silhouette, and light the face from behind.) The direction may have any length.
    pub fn turned_toward(&self, direction: R::Vec3) -> [R::Vec3; 2] {
        let normals = [self.hit.normal, self.shading_normal];
        if self.hit.normal.dot(direction) > R::from(0.0) { normals.map(|n| -n) } else { normals }
    }
}

#[cfg(test)]
mod tests;

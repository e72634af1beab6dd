//! Where a ray lands: the point, and the normals there.

use bounds::{Bounded, FirstPart, Query};
use math::{Real, Span, Vector};
use signature::{Method, Shape};

/// What findFirstHit of the page gives: the object, λ, p̄ and n⃗.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing<R: Real> {
    /// The object's place in the scene, from 0.
    pub object: usize,
    /// The part that is hit, see [`bounds::Parts`]: the object, or a face of it.
    pub part: usize,
    /// λ, in lengths of the ray's direction.
    pub lambda: R,
    /// p̄, as its method rounded it.
    pub point: R::Vec3,
    /// The unit normal of the surface as it is, outward for a solid.
    pub face_normal: R::Vec3,
    /// n⃗, the unit normal to shade with: interpolated on a smooth mesh, else the same.
    pub normal: R::Vec3,
    /// Where in its triangle the point is, if anybody asks: for a smooth mesh, and for a triangle with a texture.
    pub alpha_beta: Option<(R, R)>,
}

impl<R: Real> Landing<R> {
    /// What there is to say of the first part that answers a query. `with_place`: (α, β) is wanted.
    ///
    /// `None` where the method finds no hit up to that λ after all, which for the answer to the same query does not happen.
    #[inline]
    pub fn of(
        bounded: &Bounded<'_, R>,
        query: &Query<R>,
        first: FirstPart<R>,
        with_place: bool,
    ) -> Option<Landing<R>> {
        let (FirstPart { part, lambda }, ray) = (first, &query.ray);
        let (parts, method) = (bounded.all_parts(), bounded.formulas());
        let hit = parts.whole_hit(method, part, ray, Span::new(query.span.min, lambda))?;
        let object = parts.object(part);
        let flat = Landing {
            object,
            part,
            lambda,
            point: hit.point,
            face_normal: hit.normal,
            normal: hit.normal,
            alpha_beta: None,
        };
        let by = match method {
            Method::Robust => triangle::Method::Robust,
            Method::Notes => triangle::Method::Matrix,
        };
        match parts.shape(part) {
            Shape::Mesh(mesh) if mesh.normals().is_some() => {
                let on_face = mesh.hit_on(by, ray, parts.face(part)?, hit);
                Some(Landing { normal: on_face.shading_normal, alpha_beta: on_face.alpha_beta, ..flat })
            }
            Shape::Triangle(triangle) if with_place => {
                Some(Landing { alpha_beta: by.work(ray, triangle).alpha_beta(), ..flat })
            }
            _ => Some(flat),
        }
    }

    /// n⃗ and the face's normal as a ray with this direction sees them: the face is turned toward where the ray comes from,
    /// and n⃗ turns with it.
    #[inline(always)]
    pub fn turned_toward(&self, direction: R::Vec3) -> Turned<R> {
        let from_outside = !(self.face_normal.dot(direction) > R::from(0.0));
        match from_outside {
            true => Turned { n: self.normal, face: self.face_normal, from_outside },
            false => Turned { n: -self.normal, face: -self.face_normal, from_outside },
        }
    }
}

/// The normals as the viewer sees them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned<R: Real> {
    /// n⃗, to shade with.
    pub n: R::Vec3,
    /// The face's.
    pub face: R::Vec3,
    /// The ray came from the side to which the surface's own normal points: of a solid, from without.
    pub from_outside: bool,
}

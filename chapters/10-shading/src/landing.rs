//! Where a ray lands: the point, and the normals there.

use bounds::{Bounded, Found, Query, Tally};
use math::{Real, Vector};
use signature::{Method, Shape};
use triangle::Triangle;

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
    /// What a ray hits first, `None` where it hits nothing. `with_place`: of which objects (α, β) is wanted,
    /// by their place in the scene.
    #[inline]
    pub fn of(
        bounded: &Bounded<'_, R>,
        query: &Query<R>,
        counts: &mut impl Tally,
        with_place: impl Fn(usize) -> bool,
    ) -> Option<Landing<R>> {
        let found = bounded.find(query, counts)?;
        Landing::on(bounded, query, found, with_place)
    }

    /// The same where it is already found what is hit.
    #[inline]
    pub fn on(
        bounded: &Bounded<'_, R>,
        query: &Query<R>,
        found: Found<R>,
        with_place: impl Fn(usize) -> bool,
    ) -> Option<Landing<R>> {
        let hit = bounded.hit_of(query, found)?;
        let (part, parts, ray) = (found.part, bounded.all_parts(), &query.ray);
        let object = parts.object(part);
        let flat = Landing {
            object,
            part,
            lambda: hit.t,
            point: hit.point,
            face_normal: hit.normal,
            normal: hit.normal,
            alpha_beta: None,
        };
        let alpha_beta = |triangle: &Triangle<R>| match bounded.formulas() {
            // a color and a normal need no last digit
            Method::Robust => triangle::glance::alpha_beta(ray, triangle)
                .or_else(|| triangle::robust(ray, triangle).alpha_beta()),
            Method::Notes => triangle::matrix(ray, triangle).alpha_beta(),
        };
        match parts.shape(part) {
            Shape::Mesh(mesh) if mesh.normals().is_some() => {
                let face = parts.face(part)?;
                let alpha_beta = alpha_beta(&mesh.triangle(face));
                let normal = alpha_beta.and_then(|place| mesh.normal_at(face, place)).unwrap_or(hit.normal);
                Some(Landing { normal, alpha_beta, ..flat })
            }
            Shape::Triangle(triangle) if with_place(object) => {
                Some(Landing { alpha_beta: alpha_beta(triangle), ..flat })
            }
            _ => Some(flat),
        }
    }

    /// n⃗ and the face's normal as a ray with this direction, of any length, sees them: the face is turned
    /// toward where the ray comes from, and n⃗ turns with it. So n⃗ of a smooth mesh may still point away from
    /// there.
    #[inline(always)]
    pub fn turned_toward(&self, direction: R::Vec3) -> Turned<R> {
        let from_outside = self.face_normal.dot(direction) <= R::from(0.0);
        match from_outside {
            true => Turned { n: self.normal, face: self.face_normal, from_outside },
            false => Turned { n: -self.normal, face: -self.face_normal, from_outside },
        }
    }
}

/// The normals as the viewer sees them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned<R: Real> {
    /// n⃗, a unit vector, to shade with.
    pub n: R::Vec3,
    /// The face's, a unit vector.
    pub face: R::Vec3,
    /// The ray came from the side to which the surface's own normal points: of a solid, from without.
    pub from_outside: bool,
}

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

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use bounds::Uncounted;
    use glam::DVec3;
    use math::{Camera, Grid, Handedness, Ray3, Span, Window};
    use triangle::mesh::Mesh;

    /// A shape and nothing else, before an eye at the origin that looks along z.
    pub(crate) fn alone(shape: Shape<f64>) -> signature::Scene<f64> {
        let window = Window { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
        let objects = vec![signature::Object { id: None, shape }];
        signature::Scene { camera, grid: Grid::Centers, size: (1, 1), objects }
    }

    /// Where a ray from the origin lands, and (α, β) if `wanted`.
    pub(crate) fn landing(
        formulas: Method,
        shape: Shape<f64>,
        direction: DVec3,
        wanted: bool,
    ) -> Landing<f64> {
        let scene = alone(shape);
        let bounded = Bounded::by(formulas, &scene, bounds::Method::None);
        let query = Query::new(Ray3::new(DVec3::ZERO, direction), Span::ahead());
        Landing::of(&bounded, &query, &mut Uncounted, |_| wanted).unwrap()
    }

    /// By hand: from a corner with sides of 4 along x and along y the ray lands 1 and 2 away, so that α = 1/4
    /// and β = 1/2. A smooth mesh needs them, a flat one never does, and a triangle where it has a texture.
    #[test]
    fn a_place_in_a_triangle_is_there_if_anybody_asks() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(|[x, y]| DVec3::new(x, y, 4.0));
        let [p1, p2, p3] = corners;
        let triangle = || Shape::Triangle(Triangle { p1, p2, p3 });
        let flat = || Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
        let place = Some((0.25, 0.5));
        for formulas in Method::ALL {
            let found =
                |shape, wanted| landing(formulas, shape, DVec3::new(1.0, 2.0, 4.0), wanted).alpha_beta;
            assert_eq!([true, false].map(|wanted| found(triangle(), wanted)), [place, None]);
            assert_eq!([true, false].map(|wanted| found(Shape::Mesh(flat()), wanted)), [None; 2]);
            assert_eq!([true, false].map(|wanted| found(Shape::Mesh(flat().smooth()), wanted)), [place; 2]);
        }
    }
}

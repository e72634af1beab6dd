//! A mesh: the nearest face, its normal, and the interpolated one.

use math::{Ray3, Real, Span};
use stage::{Transcript, Value};

use crate::Method;
use crate::mesh::ball::bumpy_ball;

/// The octahedron |x| + |y| + |z| = 1, shaded smoothly, by the method.
pub(crate) fn meshes<R: Real>(transcript: &mut Transcript, method: Method) {
    let octahedron = bumpy_ball::<R>(0, [0.0; 3]).smooth();
    let v = |x, y, z| R::vec3(R::from(x), R::from(y), R::from(z));
    let ray = Ray3::<R>::new(v(0.25, 0.25, 2.0), v(0.0, 0.0, -1.0));
    let Ok(Some(found)) = octahedron.hit(method, &ray, Span::ahead()) else { return };
    let (Some((alpha, beta)), Some(normals)) = (found.alpha_beta, octahedron.normals()) else { return };
    let [n_1, n_2, n_3] = normals[found.face];
    let face = octahedron.faces()[found.face].map(|vertex| octahedron.vertices()[vertex]);
    let face = Value::Array(face.map(Value::vector::<R>).to_vec());
    transcript
        .section("A mesh of eight faces, the octahedron: which normal?", "CSC418 11.6")
        .vector::<R>("ā", "where the ray starts", ray.origin)
        .vector::<R>("d⃗", "its direction", ray.direction)
        .number("λ", "the nearest of eight faces", found.hit.t)
        .step("p̄1, p̄2, p̄3", "the corners of that face", face)
        .number("α", "the share of p̄2", alpha)
        .number("β", "the share of p̄3", beta)
        .vector::<R>("n", "n⃗ / ‖n⃗‖", found.hit.normal)
        .note("the face's: an octahedron")
        .vector::<R>("n_1", "Σ n⃗ / ‖Σ n⃗‖, the faces at p̄1", n_1)
        .note("each n⃗ as long as its face is large, twice")
        .vector::<R>("n_2", "the same at p̄2", n_2)
        .vector::<R>("n_3", "the same at p̄3", n_3)
        .vector::<R>("n", "(1 − α − β) n_1 + α n_2 + β n_3", found.shading_normal)
        .note("interpolated, made a unit vector: as if it were a ball");
}

//! Normals at the vertices from those of the faces, and in between from those at the vertices.

use math::{Real, Vector, Wide};

use super::Mesh;

/// Unit normals at the corners of every face: those given that have a direction, and the mean of the faces around
/// the vertex where there is none.
pub(super) fn at_corners<R: Real>(mesh: &Mesh<R>, given: &[[Option<R::Vec3>; 3]]) -> Vec<[R::Vec3; 3]> {
    let means = means(mesh);
    let at_face = |(face, given): (usize, &[Option<R::Vec3>; 3])| {
        let corners = mesh.faces[face];
        std::array::from_fn(|corner| {
            let own = given[corner].map(Vector::normalized).filter(|n| n.is_finite());
            let mean = means[corners[corner]].or_else(|| unit::<R>(face_normal(mesh, face)));
            // a face without area has no normal either, and is never hit
            own.or(mean).unwrap_or(R::vec3(R::from(0.0), R::from(0.0), R::from(0.0)))
        })
    };
    given.iter().enumerate().map(at_face).collect()
}

/// (1 − α − β) n_1 + α n_2 + β n_3, made a unit vector; `None` where they cancel.
pub(super) fn interpolated<R: Real>(normals: [R::Vec3; 3], (alpha, beta): (R, R)) -> Option<R::Vec3> {
    let gamma = R::from(1.0) - alpha - beta;
    let sum = normals[0] * gamma + normals[1] * alpha + normals[2] * beta;
    Some(sum.normalized()).filter(|n| n.is_finite())
}

/// For each vertex the sum of the normals of its faces, each twice as long as the face's area, made a unit vector:
/// the mean weighted by area. `None` where they cancel, or no face has the vertex.
fn means<R: Real>(mesh: &Mesh<R>) -> Vec<Option<R::Vec3>> {
    let mut sums = vec![[Wide::ZERO; 3]; mesh.vertices.len()];
    for (face, corners) in mesh.faces.iter().enumerate() {
        let n = face_normal(mesh, face);
        for &vertex in corners {
            sums[vertex] = std::array::from_fn(|axis| sums[vertex][axis] + n[axis]);
        }
    }
    sums.into_iter().map(unit::<R>).collect()
}

/// n = (p̄2 − p̄1) × (p̄3 − p̄1), in numbers whose products neither overflow nor vanish.
fn face_normal<R: Real>(mesh: &Mesh<R>, face: usize) -> [Wide; 3] {
    let [p1, p2, p3] = mesh.triangle(face).corners().map(Wide::vector::<R, 3>);
    let [e1, e2]: [[Wide; 3]; 2] = [p2, p3].map(|p| std::array::from_fn(|axis| p[axis] - p1[axis]));
    std::array::from_fn(|axis| {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        e1[i] * e2[j] - e1[j] * e2[i]
    })
}

/// The unit vector in the precision R; `None` for the zero vector.
fn unit<R: Real>(v: [Wide; 3]) -> Option<R::Vec3> {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length.is_zero() {
        return None;
    }
    let [x, y, z] = v.map(|component| R::round_from((component / length).to_f64()));
    Some(R::vec3(x, y, z))
}

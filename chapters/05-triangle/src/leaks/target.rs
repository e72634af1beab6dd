//! A closed mesh to shoot at from inside.

use lab::Vec3;
use math::{Ray3, Real, Span, Vector};

use crate::Method;
use crate::mesh::Mesh;

/// A mesh, its edges, and which faces are around each vertex.
#[derive(Clone, Debug)]
pub(crate) struct Target<R: Real> {
    mesh: Mesh<R>,
    edges: Vec<[usize; 2]>,
    around: Vec<Vec<usize>>,
}

/// A ray, and what it is aimed at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shot<R: Real> {
    ray: Ray3<R>,
    at: R::Vec3,
    /// A vertex of the edge.
    vertex: usize,
}

impl<R: Real> Target<R> {
    /// The mesh must be closed: then each edge is met once from below, as (a, b) with a < b, and once from above.
    pub(crate) fn new(mesh: Mesh<R>) -> Target<R> {
        let (mut edges, mut around) = (Vec::new(), vec![Vec::new(); mesh.vertices().len()]);
        for (face, &[a, b, c]) in mesh.faces().iter().enumerate() {
            edges.extend([[a, b], [b, c], [c, a]].into_iter().filter(|[from, to]| from < to));
            for vertex in [a, b, c] {
                around[vertex].push(face);
            }
        }
        Target { mesh, edges, around }
    }

    /// How many vertices there are.
    pub(crate) fn vertices(&self) -> usize {
        self.mesh.vertices().len()
    }

    /// The edges, each once: its two vertices.
    pub(crate) fn edges(&self) -> &[[usize; 2]] {
        &self.edges
    }

    /// A vertex, as `f64`.
    pub(crate) fn vertex(&self, vertex: usize) -> Vec3 {
        Vec3::from(self.mesh.vertices()[vertex].in_f64())
    }

    /// A ray from `start` to the point that is a share of the way along an edge; for a share of 0 it is its vertex,
    /// exactly. Both points are rounded to the precision, and so is the direction between them.
    pub(crate) fn shot_at_edge(&self, start: Vec3, [from, to]: [usize; 2], share: f64) -> Shot<R> {
        let rounded = |v: Vec3| {
            let [x, y, z] = v.to_array().map(R::round_from);
            R::vec3(x, y, z)
        };
        let along = self.vertex(from) + share * (self.vertex(to) - self.vertex(from));
        let (origin, at) = (rounded(start), rounded(along));
        Shot { ray: Ray3::new(origin, at - origin), at, vertex: from }
    }

    /// Whether a ray meets no face at all, by this method. The faces around the edge come first: most rays meet one
    /// of them, and that is enough.
    pub(crate) fn lets_through(&self, method: Method, shot: &Shot<R>) -> bool {
        let meets = |face: usize| {
            let hit = method.work(&shot.ray, &self.mesh.triangle(face)).hit(Span::ahead());
            hit.is_ok_and(|hit| hit.is_some())
        };
        let near = self.around[shot.vertex].iter().copied();
        !near.chain(0..self.mesh.faces().len()).any(meets)
    }
}

impl<R: Real> Shot<R> {
    /// What it is aimed at, from the center of the mesh.
    pub(crate) fn aimed_at(&self, center: [f64; 3]) -> Vec3 {
        Vec3::from(self.at.in_f64()) - Vec3::from(center)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::ball::bumpy_ball;

    #[test]
    fn every_edge_once() {
        let target = Target::new(bumpy_ball::<f64>(1, [0.0; 3]));
        assert_eq!((target.vertices(), target.edges().len()), (18, 48), "Euler: 18 − 48 + 32 = 2");
    }

    #[test]
    fn a_hole_is_found() {
        let ball = bumpy_ball::<f64>(1, [0.0; 3]);
        let holed = Mesh::new(ball.vertices().to_vec(), ball.faces()[1..].to_vec()).unwrap();
        let middle = ball.triangle(0).corners().into_iter().sum::<Vec3>() / 3.0;
        for (mesh, hole) in [(ball, false), (holed, true)] {
            let target = Target::new(mesh);
            let ray = Ray3::new(Vec3::ZERO, middle);
            let shot = Shot { ray, at: middle, vertex: 0 };
            assert!(Method::ALL.iter().all(|&method| target.lets_through(method, &shot) == hole));
        }
    }
}

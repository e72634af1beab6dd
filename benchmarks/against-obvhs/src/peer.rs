//! obvhs, as its documentation says that it is fastest: triangles made for tracing, in the order of the tree.

use std::time::Duration;

use glam::Vec3A;
use math::Ray3;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::{Ray, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;

/// A preset's name, and what makes it.
type Preset = (&'static str, fn() -> BvhBuildParams);

/// Its presets.
pub(crate) const PRESETS: [Preset; 6] = [
    ("fastest_build", BvhBuildParams::fastest_build),
    ("very_fast_build", BvhBuildParams::very_fast_build),
    ("fast_build", BvhBuildParams::fast_build),
    ("medium_build", BvhBuildParams::medium_build),
    ("slow_build", BvhBuildParams::slow_build),
    ("very_slow_build", BvhBuildParams::very_slow_build),
];

/// A tree and its triangles.
pub(crate) struct Peer {
    tree: Bvh2,
    triangles: Vec<RtTriangle>,
}

pub(crate) fn triangles(corners: &[[[f64; 3]; 3]]) -> Vec<Triangle> {
    let vector = |v: [f64; 3]| Vec3A::from_array(v.map(|x| x as f32));
    corners.iter().map(|&[a, b, c]| Triangle { v0: vector(a), v1: vector(b), v2: vector(c) }).collect()
}

impl Peer {
    /// The tree, and the triangles made for tracing, as ours has them too.
    pub(crate) fn build(triangles: &[Triangle], preset: BvhBuildParams) -> Peer {
        let tree = build_bvh2_from_tris(triangles, preset, &mut Duration::default());
        let order = tree.primitive_indices.iter();
        let triangles = order.map(|&place| RtTriangle::from(&triangles[place as usize])).collect();
        Peer { tree, triangles }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// How many rays hit.
    pub(crate) fn hits(&self, rays: &[Ray3<f32>]) -> usize {
        rays.iter().filter(|ray| self.closest(ray).is_some()).count()
    }

    /// The face and t of the nearest hit.
    #[inline(always)]
    pub(crate) fn closest(&self, ray: &Ray3<f32>) -> Option<(usize, f32)> {
        let vector = |v: <f32 as math::Real>::Vec3| Vec3A::new(v.x, v.y, v.z);
        let ray = Ray::new_inf(vector(ray.origin), vector(ray.direction));
        let mut hit = RayHit::none();
        self.tree.ray_traverse(ray, &mut hit, |ray, place| self.triangles[place].intersect(ray));
        (hit.t < f32::INFINITY)
            .then(|| (self.tree.primitive_indices[hit.primitive_id as usize] as usize, hit.t))
    }
}

//! Four spheres side by side, as columns: which of them may a ray meet?
//!
//! Where there are few objects a tree is not worth it, and every ray is tried on all of them. Most are spheres that it
//! misses by far, and that is seen of four at once: by chapter 04's glance, r² − P·P against its error, and by what
//! takes less: a ray that starts outside and goes away from the center does not meet it.

use math::{Ray3, Real, Vector};
use ray_sphere::Sphere;

/// How many there are in a block: one AVX2 register of `f64`.
const FOUR: usize = 4;
/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of r² − P·P in L·L + r², and more than that of L·L − r²: see [`mod@ray_sphere::glance`].
const ERROR: f64 = 64.0 * UNIT;
/// Between these, neither a square nor the errors of its products overflow or vanish.
const SAFE_SQUARE: std::ops::RangeInclusive<f64> = 1e-120..=1e120;

/// Up to four spheres whose squared radii are numbers that neither overflow nor vanish.
#[derive(Clone, Debug)]
#[repr(align(32))]
pub(crate) struct Spheres {
    center: [[f64; FOUR]; 3],
    r_r: [f64; FOUR],
    /// Which parts they are; those from `count` on stand for nothing.
    parts: [usize; FOUR],
    count: usize,
}

/// A ray, with what all spheres have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    o: [f64; 3],
    d: [f64; 3],
    one_over_a: f64,
    /// A = d · d is such that the errors are as they are bounded.
    is_safe: bool,
}

impl Line {
    #[inline(always)]
    pub(crate) fn of<R: Real>(ray: &Ray3<R>) -> Line {
        let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
        let a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        Line { o, d, one_over_a: 1.0 / a, is_safe: SAFE_SQUARE.contains(&a) }
    }
}

impl Spheres {
    /// Blocks of the spheres that may be in one, and the parts that may not.
    pub(crate) fn blocks<R: Real>(
        parts: impl Iterator<Item = (usize, Option<Sphere<R>>)>,
    ) -> (Vec<Spheres>, Vec<usize>) {
        let (mut blocks, mut rest) = (Vec::<Spheres>::new(), Vec::new());
        for (part, sphere) in parts {
            let sphere = sphere.map(|it| (it.center.in_f64::<3>(), Into::<f64>::into(it.radius)));
            match sphere.filter(|(_, r)| SAFE_SQUARE.contains(&(r * r))) {
                Some((center, r)) => {
                    if blocks.last().is_none_or(|block| block.count == FOUR) {
                        blocks.push(Spheres { center: [[0.0; FOUR]; 3], r_r: [0.0; FOUR], parts: [0; FOUR], count: 0 });
                    }
                    if let Some(block) = blocks.last_mut() {
                        let lane = block.count;
                        (0..3).for_each(|axis| block.center[axis][lane] = center[axis]);
                        (block.r_r[lane], block.parts[lane]) = (r * r, part);
                        block.count += 1;
                    }
                }
                None => rest.push(part),
            }
        }
        (blocks, rest)
    }

    /// How many there are.
    #[inline(always)]
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The part in a lane below [`Spheres::count`].
    #[inline(always)]
    pub(crate) fn part(&self, lane: usize) -> usize {
        self.parts[lane % FOUR]
    }

    /// A bit for each that is not surely missed ahead of the ray's origin.
    #[inline(always)]
    pub(crate) fn candidates(&self, line: &Line) -> u32 {
        let Line { o, d, one_over_a, is_safe } = *line;
        let [x, y, z] = &self.center;
        let mut missed = [0u64; FOUR];
        for lane in 0..FOUR {
            let l = [x[lane] - o[0], y[lane] - o[1], z[lane] - o[2]];
            let (b, l_l) = (l[0] * d[0] + l[1] * d[1] + l[2] * d[2], l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
            let t_close = b * one_over_a;
            let p = [l[0] - t_close * d[0], l[1] - t_close * d[1], l[2] - t_close * d[2]];
            let half_chord_squared = self.r_r[lane] - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            let error = ERROR * (l_l + self.r_r[lane]);
            let passes = half_chord_squared < -error;
            let leaves = (b <= 0.0) & (l_l - self.r_r[lane] > error);
            let is_safe = l_l <= 1e120;
            missed[lane] = if (passes | leaves) & is_safe { u64::MAX } else { 0 };
        }
        let mut bits = 0;
        for (lane, &missed) in missed.iter().enumerate() {
            bits |= if missed == 0 { 1 << lane } else { 0 };
        }
        let all = (1 << self.count) - 1;
        if is_safe { bits & all } else { all }
    }
}

//! Four spheres side by side, as columns: which of them may a ray meet?
//!
//! Where there are few objects a tree is not worth it, and every ray is tried on all of them. Most are
//! spheres that it misses by far, and chapter 04's glance sees that of four at once.

use math::{Glance, Real, Vector};
use ray_sphere::Sphere;
use ray_sphere::glance::{Line, Passage, is_safe};

/// How many there are in a block: one AVX2 register of `f64`.
const FOUR: usize = 4;

/// Up to four spheres whose squared radii neither overflow nor vanish.
#[derive(Clone, Debug)]
#[repr(align(32))]
pub(crate) struct Spheres {
    center: [[f64; FOUR]; 3],
    r: [f64; FOUR],
    /// Which parts they are; those from `count` on stand for nothing.
    parts: [usize; FOUR],
    count: usize,
}

/// How a ray passes four spheres.
pub(crate) struct Passages {
    t_close: [f64; FOUR],
    half_chord_squared: [f64; FOUR],
    scale: [f64; FOUR],
    is_safe: [bool; FOUR],
    /// A bit for each that may be met.
    pub(crate) candidates: u32,
}

impl Spheres {
    /// Blocks of the spheres that may be in one, and the parts that may not.
    pub(crate) fn blocks<R: Real>(
        parts: impl Iterator<Item = (usize, Option<Sphere<R>>)>,
    ) -> (Vec<Spheres>, Vec<usize>) {
        let (mut blocks, mut rest) = (Vec::<Spheres>::new(), Vec::new());
        for (part, sphere) in parts {
            let sphere = sphere.map(|it| (it.center.in_f64::<3>(), Into::<f64>::into(it.radius)));
            let Some((center, r)) = sphere.filter(|(_, r)| is_safe(*r)) else {
                rest.push(part);
                continue;
            };
            if blocks.last().is_none_or(|block| block.count == FOUR) {
                // in every lane, though the others stand for nothing yet: beside a center of zero a ray from
                // the plane y = 0 has a subnormal distance, and products of those take a hundred times as
                // long
                let center = center.map(|x| [x; FOUR]);
                blocks.push(Spheres { center, r: [r; FOUR], parts: [part; FOUR], count: 0 });
            }
            if let Some(block) = blocks.last_mut() {
                let lane = block.count;
                (0..3).for_each(|axis| block.center[axis][lane] = center[axis]);
                (block.r[lane], block.parts[lane]) = (r, part);
                block.count += 1;
            }
        }
        (blocks, rest)
    }

    /// How many there are.
    #[inline(always)]
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// A bit for each.
    #[inline(always)]
    pub(crate) fn all(&self) -> u32 {
        (1 << self.count) - 1
    }

    /// The part in a lane.
    #[inline(always)]
    pub(crate) fn part(&self, lane: usize) -> usize {
        self.parts[lane % FOUR]
    }

    /// How the line of a ray passes them.
    #[inline(always)]
    pub(crate) fn past(&self, line: &Line) -> Passages {
        let [x, y, z] = &self.center;
        let mut all = Passages {
            t_close: [0.0; FOUR],
            half_chord_squared: [0.0; FOUR],
            scale: [0.0; FOUR],
            is_safe: [false; FOUR],
            candidates: 0,
        };
        let mut is_missed = [false; FOUR];
        for lane in 0..FOUR {
            let r = self.r[lane];
            let passage = line.past([x[lane], y[lane], z[lane]], r * r);
            all.t_close[lane] = passage.t_close;
            all.half_chord_squared[lane] = passage.half_chord_squared;
            all.scale[lane] = passage.scale;
            all.is_safe[lane] = passage.is_safe;
            is_missed[lane] = passage.is_missed;
        }
        let mut bits = 0;
        for (lane, &is_missed) in is_missed.iter().enumerate() {
            bits |= u32::from(!is_missed) << lane;
        }
        all.candidates = bits & self.all();
        all
    }

    /// What a glance says of one of them.
    #[inline(always)]
    pub(crate) fn glance(line: &Line, past: &Passages, lane: usize) -> Glance {
        let lane = lane % FOUR;
        let passage = Passage {
            t_close: past.t_close[lane],
            half_chord_squared: past.half_chord_squared[lane],
            scale: past.scale[lane],
            is_missed: false,
            is_safe: past.is_safe[lane],
        };
        line.glance(&passage)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::Ray3;

    /// By hand: five balls ten apart and one whose r² is no number, and a ray through the last of the five or beside them all.
    #[test]
    fn four_are_in_a_block_and_those_that_are_met_are_candidates() {
        let ball = |x: f64, radius: f64| Some(Sphere { center: DVec3::new(x, 0.0, 5.0), radius });
        let all = (0..5).map(|part| (part, ball(10.0 * part as f64, 1.0)));
        let (blocks, rest) = Spheres::blocks(all.chain([(5, ball(0.0, 1e300)), (6, None)]));
        assert_eq!(blocks.iter().map(Spheres::count).collect::<Vec<_>>(), [4, 1]);
        assert_eq!(blocks.iter().map(Spheres::all).collect::<Vec<_>>(), [0b1111, 0b1]);
        assert_eq!(rest, [5, 6]);
        assert_eq!((0..4).map(|lane| blocks[0].part(lane)).collect::<Vec<_>>(), [0, 1, 2, 3]);
        for (x, candidates) in [(40.0, [0, 1]), (10.0, [0b10, 0]), (5.0, [0, 0])] {
            let line = Line::of(&Ray3::<f64>::new(DVec3::X * x, DVec3::Z));
            assert_eq!([0, 1].map(|block: usize| blocks[block].past(&line).candidates), candidates, "{x}");
        }
    }
}

//! Where a ray passes the plane of a polygon, against its sides: each one as carefully as it takes.
//!
//! In plain `f64` ([`mod@at_once`](super::at_once)) nearly every side is certain, and [`mod@strips`](super::strips) say
//! which ones there are to ask. What is in doubt is told exactly ([`mod@passage`](super::passage)).

use math::{Ray3, Real};

use super::at_once::AtOnce;
use super::crossing::{Relation, Way};
use super::passage::Passage;
use super::{Polygon, Rule};

/// Whether the line of a ray passes the plane within the polygon, its boundary included. The ray must be finite and
/// not parallel to the plane.
///
/// With the point in plain `f64` at hand only the sides are asked that reach its height, and only those exactly that
/// it leaves in doubt.
#[inline(always)]
pub(super) fn holds<R: Real>(
    polygon: &Polygon<R>,
    rule: Rule,
    ray: &Ray3<R>,
    point: Option<&AtOnce>,
) -> bool {
    let outline = polygon.outline.as_slice();
    let mut count = Count { polygon, ray, point, passage: None, crossed: 0, number: 0 };
    let strips = polygon.strips.as_ref().zip(point);
    let few = strips.and_then(|(strips, point)| strips.sides_between(point.low[1], point.high[1]));
    let is_on_side = match few {
        Some(few) => few.iter().any(|&side| {
            let side = side as usize;
            let next = if side + 1 < outline.len() { side + 1 } else { 0 };
            count.is_on(outline[side], outline[next])
        }),
        None => {
            let mut p = outline[outline.len() - 1];
            outline.iter().any(|&q| count.is_on(std::mem::replace(&mut p, q), q))
        }
    };
    is_on_side
        || match rule {
            Rule::EvenOdd => count.crossed % 2 == 1,
            Rule::Winding => count.number != 0,
        }
}

/// Where the point is with respect to a side, exactly.
#[cfg(test)]
pub(super) fn relation<R: Real>(polygon: &Polygon<R>, ray: &Ray3<R>, p: [f64; 2], q: [f64; 2]) -> Relation {
    Passage::of(polygon, ray).relation(p, q)
}

/// What s(t) has crossed so far.
struct Count<'a, R: Real> {
    polygon: &'a Polygon<R>,
    ray: &'a Ray3<R>,
    point: Option<&'a AtOnce>,
    /// Made when the first side is in doubt.
    passage: Option<Passage>,
    crossed: u32,
    number: i32,
}

impl<R: Real> Count<'_, R> {
    /// Whether the point is on a side; if it crosses it, that is counted.
    #[inline(always)]
    fn is_on(&mut self, p: [R; 2], q: [R; 2]) -> bool {
        let [p, q] = [p, q].map(|corner| corner.map(Into::<f64>::into));
        let at_once = self.point.and_then(|point| point.relation(p, q));
        match at_once.unwrap_or_else(|| self.exactly(p, q)) {
            Relation::Apart => {}
            Relation::OnSide => return true,
            Relation::Crosses(way) => {
                self.crossed += 1;
                self.number += if way == Way::Up { 1 } else { -1 };
            }
        }
        false
    }

    #[cold]
    #[inline(never)]
    fn exactly(&mut self, p: [f64; 2], q: [f64; 2]) -> Relation {
        let passage = self.passage.get_or_insert_with(|| Passage::of(self.polygon, self.ray));
        passage.relation(p, q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::star::{PENTAGRAM, in_space};
    use glam::DVec3;

    /// The rule once more in whole numbers, by its definition: how often does s(t) cross, for whole corners in z = 0 and a
    /// point X/W, Y/W? `None` on the boundary.
    fn odd_in_integers(corners: &[[i128; 2]], [x, y]: [i128; 2], w: i128) -> Option<bool> {
        let mut odd = false;
        for (i, p) in corners.iter().enumerate() {
            let q = corners[(i + 1) % corners.len()];
            let (px, py, qx, qy) = (p[0] * w - x, p[1] * w - y, q[0] * w - x, q[1] * w - y);
            let cross = px * qy - py * qx;
            if cross == 0 && px * qx + py * qy <= 0 {
                return None;
            }
            // half-open: the lower end counts; the crossing is ahead where x is on the inner side
            if (py <= 0) != (qy <= 0) && (cross > 0) == (qy > py) {
                odd = !odd;
            }
        }
        Some(odd)
    }

    /// Rays from whole points to whole points that pass z = 0 at fractions, through stars with corners and sides level
    /// with each other: a third of them exactly through a side or a corner.
    #[test]
    fn a_passage_is_judged_exactly() {
        let corners: Vec<[i128; 2]> =
            vec![[0, 0], [6, 0], [6, 3], [4, 3], [4, 1], [3, 3], [2, 1], [2, 3], [0, 5], [-3, 3], [-3, 0]];
        let in_space = corners.iter().map(|&[x, y]| DVec3::new(x as f64, y as f64, 0.0)).collect();
        let polygon = Polygon::<f64>::new(in_space).unwrap();
        let mut seed = 7_u64;
        let mut below = |bound: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 33) % bound) as i128
        };
        let (mut inside, mut boundary) = (0, 0);
        for _ in 0..20_000 {
            // from (x, y, h) to (x', y', −k): at z = 0 the share h/(h + k) of the way is done
            let (from, to) = ([below(30) - 10, below(30) - 10], [below(30) - 10, below(30) - 10]);
            let (h, k) = (below(9) + 1, below(9) + 1);
            let w = h + k;
            let at = [0, 1].map(|axis| from[axis] * w + (to[axis] - from[axis]) * h);
            let truth = odd_in_integers(&corners, at, w);
            let origin = DVec3::new(from[0] as f64, from[1] as f64, h as f64);
            let direction = DVec3::new((to[0] - from[0]) as f64, (to[1] - from[1]) as f64, -(w as f64));
            for scale in [1.0, 1e-3, 1e200] {
                let ray = Ray3::new(origin, direction * scale);
                // 1e-3 and 1e200 are no powers of two: what is exactly on the boundary is only so with 1
                if scale == 1.0 || truth.is_some() {
                    for point in [None, AtOnce::of(&polygon, &ray)] {
                        let holds = holds(&polygon, Rule::EvenOdd, &ray, point.as_ref());
                        assert_eq!(holds, truth.unwrap_or(true), "{ray:?}");
                    }
                }
            }
            inside += u64::from(truth == Some(true));
            boundary += u64::from(truth.is_none());
        }
        assert!(inside > 1000 && boundary > 200, "{inside} {boundary}");
    }

    /// By hand: a pentagram goes twice around its middle, once around what is in a tip; of a point to the left of it
    /// two sides go up and two go down.
    #[test]
    fn the_winding_rule_counts_up_less_down() {
        let star = Polygon::<f64>::new(in_space::<f64>(&PENTAGRAM)).unwrap();
        for (x, y, by_winding, by_even_odd) in
            [(0.0, 0.0, true, false), (0.0, 8.0, true, true), (-12.0, 0.0, false, false)]
        {
            let ray = Ray3::new(DVec3::new(x, y, 5.0), -DVec3::Z);
            for point in [None, AtOnce::of(&star, &ray)] {
                let by = |rule: Rule| holds(&star, rule, &ray, point.as_ref());
                let found = [by(Rule::Winding), by(Rule::EvenOdd)];
                assert_eq!(found, [by_winding, by_even_odd], "({x}, {y}) {point:?}");
            }
        }
    }
}

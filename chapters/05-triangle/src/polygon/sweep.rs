//! The fast way to a verdict against the exact one: for rays anywhere, at corners, along sides and beside them by a digit.

use math::glance::First;
use math::{Ray3, Real, Span, Vector, portable};

use super::at_once::AtOnce;
use super::{Polygon, Rule, on_plane};

/// Numbers that look random, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// From −1 to 1.
    fn unit(&mut self) -> f64 {
        self.next() as f64 / (1_u64 << 30) as f64 - 1.0
    }

    fn vector(&mut self) -> [f64; 3] {
        [self.unit(), self.unit(), self.unit()]
    }
}

fn rounded<R: Real>([x, y, z]: [f64; 3]) -> R::Vec3 {
    R::vec3(R::round_from(x), R::round_from(y), R::round_from(z))
}

/// a + s b + t c
fn sum(a: [f64; 3], s: f64, b: [f64; 3], t: f64, c: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] + s * b[axis] + t * c[axis])
}

/// A star with so many corners, or a comb, whose teeth are all in one strip; in whole numbers or not, and near the world's
/// origin, far from it, or with a side through it.
fn polygon<R: Real>(numbers: &mut Numbers, count: usize) -> Option<Polygon<R>> {
    let (is_level, is_whole) = (numbers.below(2) == 0, numbers.below(2) == 0);
    let is_comb = numbers.below(4) == 0;
    let (middle, e_1, e_2) = match is_level {
        true => ([2.0, -3.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        false => (numbers.vector(), numbers.vector(), numbers.vector()),
    };
    let corner = |i: usize, radius: f64| {
        let share = i as f64 / count as f64;
        let (u, v) = match is_comb {
            true if i + 1 == count => (0.0, -20.0),
            true => (40.0 * (0.5 - share), if i.is_multiple_of(2) { 12.0 } else { -12.0 }),
            false => {
                let angle = std::f64::consts::TAU * share;
                let (sin, cos) = (portable::sin(angle), portable::cos(angle));
                (radius * cos, radius * sin)
            }
        };
        let (u, v) = if is_level && is_whole { (u.round(), v.round()) } else { (u, v) };
        sum(middle, u, e_1, v, e_2)
    };
    let mut corners: Vec<[f64; 3]> = (0..count).map(|i| corner(i, 5.0 + numbers.below(20) as f64)).collect();
    corners.dedup();
    let moved = match numbers.below(4) {
        0 => [1e5, -3e5, 7e5],
        1 => sum([0.0; 3], -0.5, corners[0], -0.5, corners[1]),
        _ => [0.0; 3],
    };
    Polygon::new(
        corners.into_iter().map(|corner| rounded::<R>(sum(corner, 1.0, moved, 0.0, moved))).collect(),
    )
    .ok()
}

/// A point of the plane to aim at: a corner, a point of a side, or anywhere around.
fn aim<R: Real>(numbers: &mut Numbers, polygon: &Polygon<R>) -> [f64; 3] {
    let corners = polygon.corners();
    let side = numbers.below(corners.len() as u64) as usize;
    let [p, q]: [[f64; 3]; 2] = [corners[side], corners[(side + 1) % corners.len()]].map(Vector::in_f64);
    let far: [f64; 3] = corners[numbers.below(corners.len() as u64) as usize].in_f64();
    let between = |a: [f64; 3], share: f64, b: [f64; 3]| sum([0.0; 3], 1.0 - share, a, share, b);
    match numbers.below(7) {
        6 => [0, 1, 2].map(|_| numbers.unit() * 1e-15),
        0 => p,
        1 => between(p, 0.5, q),
        2 => between(p, numbers.unit().abs(), q),
        3 => between(p, numbers.unit() * 2.0, q),
        4 => between(p, numbers.unit() * 1e-15, far),
        _ => between(p, numbers.unit() * 1.5, far),
    }
}

#[derive(Debug, Default)]
struct Counted {
    inside: u32,
    outside: u32,
    beside: u32,
    sides_in_doubt: u32,
    /// Glances that are not sure, of those at five spans each.
    unsure: u32,
    /// What plain numbers leave open.
    slow: u32,
}

fn sweep<R: Real>(seed: u64, rounds: u32) -> Counted {
    let (mut numbers, mut counted) = (Numbers(seed), Counted::default());
    for _ in 0..rounds {
        let count = [3, 4, 5, 8, 9, 10, 17, 40, 144][numbers.below(9) as usize];
        let Some(polygon) = polygon::<R>(&mut numbers, count) else { continue };
        for _ in 0..40 {
            let aimed = aim(&mut numbers, &polygon);
            // far, along the plane, close to it, and near
            let way = match numbers.below(5) {
                2 => sum([0.0; 3], 1e-6, numbers.vector(), 1e-6, polygon.plane().normal.in_f64()),
                0 => sum([0.0; 3], 1e4, numbers.vector(), 0.0, [0.0; 3]),
                1 => sum([0.0; 3], 1e-3, numbers.vector(), 10.0, {
                    let [p, q]: [[f64; 3]; 2] = [0, 1].map(|corner| polygon.corners()[corner].in_f64());
                    sum(p, -1.0, q, 0.0, q)
                }),
                _ => sum([0.0; 3], 8.0, numbers.vector(), 0.0, [0.0; 3]),
            };
            // at the aim for t = 1, as well as the numbers allow, or behind
            let ahead = if numbers.below(8) == 0 { 1.0 } else { -1.0 };
            let ray = Ray3::<R>::new(rounded::<R>(sum(aimed, ahead, way, 0.0, way)), rounded::<R>(way));
            judge(&polygon, &ray, &mut counted);
        }
    }
    counted
}

/// Every rule, every side, and the hit in several spans.
fn judge<R: Real>(polygon: &Polygon<R>, ray: &Ray3<R>, counted: &mut Counted) {
    let Some(point) = AtOnce::of(polygon, ray) else {
        counted.slow += 1;
        return;
    };
    let says = format!("{ray:?} {polygon:?}");
    for rule in Rule::ALL {
        let exactly = on_plane::holds(polygon, rule, ray, None);
        assert_eq!(on_plane::holds(polygon, rule, ray, Some(&point)), exactly, "{says}");
    }
    let is_inside = on_plane::holds(polygon, Rule::EvenOdd, ray, None);
    *(if is_inside { &mut counted.inside } else { &mut counted.outside }) += 1;
    if point.is_outside(polygon.rectangle) {
        counted.beside += 1;
        assert!(!is_inside, "{says}");
    }
    let outline = polygon.outline();
    for (i, p) in outline.iter().enumerate() {
        let [p, q] = [*p, outline[(i + 1) % outline.len()]].map(|corner| corner.map(Into::<f64>::into));
        match point.relation(p, q) {
            Some(relation) => {
                assert_eq!(relation, on_plane::relation(polygon, ray, p, q), "side {i}: {says}")
            }
            None => counted.sides_in_doubt += 1,
        }
    }
    let Ok(Some(on_plane)) =
        ray_plane::robust(ray, &polygon.plane()).hit(Span::new(-R::INFINITY, R::INFINITY))
    else {
        return;
    };
    let t = on_plane.t;
    let (half, twice) = (t * R::from(0.5), t * R::from(2.0));
    let (less, more) = if t < half { (twice, half) } else { (half, twice) };
    for span in
        [Span::ahead(), Span::new(less, t), Span::new(t, more), Span::new(less, less), Span::new(more, more)]
    {
        let by_plane =
            ray_plane::robust(ray, &polygon.plane()).hit(span).map(|hit| hit.filter(|_| is_inside));
        assert_eq!(polygon.hit(ray, span), by_plane, "{span:?}: {says}");
        if span.min < R::from(0.0) {
            continue;
        }
        let first = polygon.glance(ray).first_within(span);
        counted.unsure += u32::from(matches!(first, First::Unsure));
        let is_true = match (first, by_plane) {
            (First::Unsure, _) | (First::None, Ok(None)) => true,
            (First::Between(low, high), Ok(Some(hit))) => (low..=high).contains(&hit.t.into()),
            _ => false,
        };
        assert!(is_true, "{span:?}: {says}");
    }
}

#[test]
fn the_fast_way_says_what_the_exact_one_says() {
    let all = [sweep::<f64>(1, 400), sweep::<f32>(2, 400)];
    // so often, and no more often: a bound that is too wide would be right too, and slow
    insta::assert_snapshot!(format!("{all:#?}"));
    for Counted { inside, outside, beside, sides_in_doubt, .. } in all {
        assert!(inside > 1000 && outside > 1000 && beside > 100 && sides_in_doubt > 1000);
        assert!(beside < outside, "some are decided by their sides");
    }
}

/// By hand: a comb of 8 teeth from height 0 to 1 on a beam. The strips of few sides are none, those of many list a
/// side wherever it passes, and no more than four for each in all.
#[test]
fn strips_list_every_side_that_reaches_a_height() {
    use super::strips::Strips;
    assert_eq!(Strips::of(&[0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]), None);
    let comb: Vec<f64> = (0..17).map(|corner| f64::from(corner % 2)).collect();
    let stairs: Vec<f64> = (0..100).map(|corner| f64::from(corner) * 0.1).collect();
    let flat_steps: Vec<f64> = (0..100).map(|corner| f64::from(corner / 2)).collect();
    let extreme = vec![0.0, 5e-324, 0.0, 1e308, -1e308, 0.0, -1e308, 1e308, 1.0, -1.0];
    for heights in [&comb, &stairs, &flat_steps, &extreme] {
        let strips = Strips::of(heights).unwrap();
        let (mut asked, mut one) = (0, 0);
        for &height in heights {
            for (low, high) in [(height, height), (height.next_down(), height.next_up())] {
                let Some(few) = strips.sides_between(low, high) else { continue };
                (asked, one) = (asked + few.len(), one + 1);
                for side in 0..heights.len() {
                    let (p, q) = (heights[side], heights[(side + 1) % heights.len()]);
                    let reaches = p.min(q) <= high && low <= p.max(q);
                    assert!(!reaches || few.contains(&(side as u32)), "side {side} at {height}");
                }
            }
        }
        assert!(one >= heights.len(), "most are in one strip");
        assert!(heights != &stairs || asked < 6 * one, "{asked} of {one}");
    }
}

/// By hand: from the plane itself it is met at once, and from beside it never where the ray leads away.
#[test]
fn a_ray_that_leaves_the_polygon_is_told_by_two_comparisons() {
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let at_one: Vec<glam::DVec3> = square.map(|[x, y]| glam::DVec3::new(x, y, 1.0)).to_vec();
    let square = Polygon::<f64>::new(at_one).unwrap();
    let hit = |z: f64, up: f64, from: f64| {
        let ray = Ray3::<f64>::new(glam::DVec3::new(1.0, 1.0, z), glam::DVec3::Z * up);
        square.hit(&ray, Span::new(from, f64::INFINITY)).unwrap().map(|hit| hit.t)
    };
    let (above, below) = (1.0_f64.next_up(), 1.0_f64.next_down());
    for up in [1.0, -1.0] {
        assert_eq!(hit(1.0, up, 0.0), Some(0.0));
        let [toward, away] = if up > 0.0 { [below, above] } else { [above, below] };
        assert_eq!(hit(toward, up, 0.0), Some((toward - 1.0).abs()));
        assert_eq!((hit(away, up, 0.0), hit(away, up, -1.0)), (None, Some(-(away - 1.0).abs())));
    }
    // away from the plane, and no ray at all
    let none = Ray3::<f64>::new(glam::DVec3::new(f64::NAN, 1.0, 2.0), glam::DVec3::Z);
    assert_eq!(square.hit(&none, Span::ahead()), Err(math::Degenerate::NotFinite));
}

//! A batch against its scalar twin, bit by bit.

use super::packet::not_a_number;
use super::*;
use crate::half_quadratic;
use glam::DVec3;

/// What is compared: t, point and normal by their bits, the verdict and the reason by name.
type Bits = Result<Option<[u64; 7]>, Degenerate>;

fn bits<R: Real>(outcome: Result<Option<Hit3<R>>, Degenerate>) -> Bits {
    let hit = outcome?;
    Ok(hit.map(|Hit3::<R> { t, point, normal }| {
        let ([x, y, z], [nx, ny, nz]) = (point.in_f64::<3>(), normal.in_f64::<3>());
        [t.into(), x, y, z, nx, ny, nz].map(f64::to_bits)
    }))
}

/// The pairs as a batch answer what they answer one by one, by either kind of instructions.
fn same_as_alone<R: Real>(pairs: &[(Ray3<R>, Sphere<R>)], span: Span<R>) -> Vec<Bits> {
    let alone: Vec<Bits> =
        pairs.iter().map(|(ray, sphere)| bits(half_quadratic(ray, sphere).hit(span))).collect();
    let batch: Batch<R> = pairs.iter().copied().collect();
    let mut hits = Hits::new();
    for instructions in [Instructions::Baseline, Instructions::Best] {
        batch.hits_into(&mut hits, span, instructions);
        assert_eq!(hits.outcomes().count(), pairs.len());
        for (index, (outcome, alone)) in hits.outcomes().zip(&alone).enumerate() {
            let pair = pairs[index];
            assert_eq!(bits(outcome), *alone, "{instructions:?}, {span:?}, {index}: {pair:?}");
        }
    }
    alone
}

/// Numbers drawn from a seed (SplitMix64).
struct Draw(u64);

impl Draw {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From −half to half.
    fn uniform<R: Real>(&mut self, half: f64) -> R {
        R::round_from(half * ((self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0))
    }

    /// A small whole number: such rays touch their spheres, start on them, go along an axis.
    fn whole<R: Real>(&mut self) -> R {
        R::round_from((self.bits() % 5) as f64 - 2.0)
    }

    /// Of any magnitude that a number of either precision can have.
    fn any_magnitude<R: Real>(&mut self) -> R {
        let largest = if R::NAME == "f32" { 128 } else { 1024 };
        let exponent = (self.bits() % (2 * largest)) as i32 - largest as i32;
        self.uniform::<R>(1.0) * R::round_from(2.0_f64.powi(exponent))
    }

    fn special<R: Real>(&mut self) -> R {
        let largest = R::round_from(if R::NAME == "f32" { f32::MAX.into() } else { f64::MAX });
        let [zero, one] = [0.0, 1.0].map(R::from);
        let specials = [zero, R::SMALLEST, one, largest, R::INFINITY, not_a_number()];
        let special = specials[(self.bits() % 6) as usize];
        if self.bits() & 1 == 0 { special } else { -special }
    }

    fn pair<R: Real>(&mut self) -> (Ray3<R>, Sphere<R>) {
        let kind = self.bits() % 5;
        let [ox, oy, oz, dx, dy, dz, cx, cy, cz, r]: [R; 10] = std::array::from_fn(|_| match kind {
            0 | 1 => self.uniform(8.0),
            2 => self.whole(),
            3 => self.any_magnitude(),
            _ if self.bits() & 3 == 0 => self.special(),
            _ => self.whole(),
        });
        let radius = if r < R::from(0.0) && self.bits() & 7 != 0 { -r } else { r };
        let sphere = Sphere { center: R::vec3(cx, cy, cz), radius };
        (Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz)), sphere)
    }
}

fn random_pairs<R: Real>(seed: u64) {
    let number = R::from;
    let spans = [
        Span::ahead(),
        Span::from_view_plane(),
        Span::new(-R::INFINITY, R::INFINITY),
        Span::new(number(-2.0), number(0.5)),
        Span::new(number(2.0), number(1.0)),
        Span::new(not_a_number(), R::INFINITY),
    ];
    let mut draw = Draw(seed);
    let pairs: Vec<_> = (0..20_003).map(|_| draw.pair::<R>()).collect();
    let answers: Vec<Bits> = spans.iter().flat_map(|&span| same_as_alone(&pairs, span)).collect();
    // every kind of answer is there
    let count = |kind: fn(&Bits) -> bool| answers.iter().filter(|answer| kind(answer)).count();
    let counts = [
        count(|answer| matches!(answer, Ok(Some(_)))),
        count(|answer| matches!(answer, Ok(Some([t, ..])) if f64::from_bits(*t) == f64::INFINITY)),
        count(|answer| matches!(answer, Ok(None))),
        count(|answer| *answer == Err(Degenerate::NotFinite)),
        count(|answer| *answer == Err(Degenerate::ZeroDirection)),
        count(|answer| *answer == Err(Degenerate::RadiusNotPositive)),
    ];
    assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
}

#[test]
fn a_batch_has_the_bits_of_half_quadratic() {
    random_pairs::<f32>(32);
    random_pairs::<f64>(64);
}

/// What is not looked through has nothing that would be refused, and little is looked through in vain.
fn validity<R: Real>(seed: u64) {
    let surely_valid = |numbers: [R; 10]| {
        let [ox, oy, oz, dx, dy, dz, cx, cy, cz, radius] = numbers;
        let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
        let sphere = Sphere { center: R::vec3(cx, cy, cz), radius };
        let surely_valid = batched(&ray, &sphere).surely_valid();
        assert!(!surely_valid || sphere.check(&ray).is_ok(), "{ray:?} {sphere:?}");
        surely_valid
    };
    let mut draw = Draw(seed);
    let not_finite = [R::INFINITY, -R::INFINITY, not_a_number()];
    for _ in 0..10_000 {
        // whole numbers, so that A, B, C and D are zero now and then
        let mut numbers: [R; 10] = std::array::from_fn(|_| draw.whole());
        let zero_direction = numbers[3..6].iter().all(|&d| d == R::from(0.0));
        assert_eq!(surely_valid(numbers), !zero_direction && numbers[9] > R::from(0.0));
        // one, two or three of them are not finite
        for _ in 0..3 {
            numbers[(draw.bits() % 10) as usize] = not_finite[(draw.bits() % 3) as usize];
            assert!(!surely_valid(numbers), "{numbers:?}");
        }
        let kinds = draw.bits();
        surely_valid(std::array::from_fn(|index| match kinds >> index & 1 {
            0 => draw.special(),
            _ => draw.any_magnitude(),
        }));
    }
}

#[test]
fn the_quick_test_of_validity_passes_nothing_degenerate() {
    validity::<f32>(3);
    validity::<f64>(4);
}

fn every_lane<R: Real>() {
    let vec3 = |x, y, z| R::vec3(R::from(x), R::from(y), R::from(z));
    let pair = |y, d: R::Vec3, r| {
        let sphere = Sphere { center: vec3(0.0, 0.0, 5.0), radius: R::from(r) };
        (Ray3::<R>::new(vec3(0.0, y, 0.0), d), sphere)
    };
    let (hit, miss) = (pair(0.5, vec3(0.0, 0.0, 2.0), 1.0), pair(1.5, vec3(0.0, 0.0, 2.0), 1.0));
    let refused = [
        pair(0.0, vec3(0.0, -0.0, 0.0), 1.0),
        pair(0.0, vec3(0.0, 0.0, 2.0), -1.0),
        pair(f32::NAN, vec3(0.0, 0.0, 0.0), -1.0),
    ];
    for length in [0, 1, LANES - 1, LANES, LANES + 1, 3 * LANES] {
        same_as_alone(&vec![hit; length], Span::ahead());
        // one that is unlike all others, in every lane
        for lane in 0..length {
            for (one, others) in
                [(hit, miss), (miss, hit), (refused[lane % 3], hit), (hit, refused[lane % 3])]
            {
                let mut pairs = vec![others; length];
                pairs[lane] = one;
                same_as_alone(&pairs, Span::ahead());
            }
        }
    }
}

#[test]
fn a_lane_knows_nothing_of_its_neighbors() {
    every_lane::<f32>();
    every_lane::<f64>();
}

/// A batch of one is one of the methods, numbers on the way and all.
#[test]
fn one_lane_has_the_numbers_of_half_quadratic() {
    let mut draw = Draw(1);
    for _ in 0..2000 {
        let (ray, sphere) = draw.pair::<f64>();
        let (work, twin) = (batched(&ray, &sphere), half_quadratic(&ray, &sphere));
        // a NaN has no bits to count on
        let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan();
        let roots = |roots: Option<Roots<f64>>| roots.map_or([-1.0; 2], |roots| [roots.near, roots.far]);
        let numbers = [work.a, work.b, work.c, work.d].into_iter().chain(roots(work.roots()));
        let twins = [twin.a, twin.b, twin.c, twin.d].into_iter().chain(roots(twin.roots()));
        assert!(numbers.zip(twins).all(|(x, y)| same(x, y)), "{work:?} {twin:?}");
        assert_eq!(work.roots().is_some(), twin.roots().is_some());
        assert_eq!(bits(work.hit(Span::ahead())), bits(twin.hit(Span::ahead())));
    }
}

#[test]
fn three_rays_and_three_spheres_by_hand() {
    // by hand: z from 4 to 6 with d = (0, 0, 2); past it; out of its center
    let d = DVec3::new(0.0, 0.0, 2.0);
    let rays = [0.0, 3.0].map(|y| Ray3::<f64>::new(DVec3::new(0.0, y, 0.0), d));
    let rays = [rays[0], rays[1], Ray3::new(DVec3::new(0.0, 0.0, 5.0), d)];
    let sphere = |radius| Sphere::<f64> { center: DVec3::new(0.0, 0.0, 5.0), radius };
    let hits: Vec<_> = Batch::of_rays(&rays, &sphere(1.0)).hits(Span::ahead()).outcomes().collect();
    let at = |t, z, nz| Hit3::<f64> { t, point: DVec3::new(0.0, 0.0, z), normal: DVec3::new(0.0, 0.0, nz) };
    assert_eq!(hits, [Ok(Some(at(2.0, 4.0, -1.0))), Ok(None), Ok(Some(at(0.5, 6.0, 1.0)))]);

    let spheres = [1.0, -1.0, 2.0].map(sphere);
    let hits: Vec<_> = Batch::of_spheres(&rays[0], &spheres).hits(Span::ahead()).outcomes().collect();
    let refused = Err(Degenerate::RadiusNotPositive);
    assert_eq!(hits, [Ok(Some(at(2.0, 4.0, -1.0))), refused, Ok(Some(at(1.5, 3.0, -1.0)))]);
}

/// The t of a lane without a hit is NaN, also where the formula has a number: a negative radius.
#[test]
fn only_a_hit_has_a_t() {
    let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
    let spheres = [2.0, -2.0, f64::NAN].map(|radius| Sphere { center: DVec3::new(0.0, 1.0, 5.0), radius });
    assert!(batched(&ray, &spheres[1]).lambda_2 > 0.0);
    let hits = Batch::of_spheres(&ray, &spheres).hits(Span::ahead());
    let packet = hits.packets()[0];
    assert_eq!(packet.verdict[0], Verdict::Hit);
    assert_eq!(packet.verdict[1], Verdict::Refused(Degenerate::RadiusNotPositive));
    assert!(packet.t[0] > 0.0 && packet.t[1..].iter().all(|t| t.is_nan()));
}

/// Answers written over older ones, of more rays and of fewer.
#[test]
fn old_answers_are_forgotten() {
    let mut draw = Draw(2);
    let mut hits = Hits::new();
    for length in [20, 3, 0, 17] {
        let batch: Batch<f64> = (0..length).map(|_| draw.pair()).collect();
        batch.hits_into(&mut hits, Span::ahead(), Instructions::Best);
        let (again, fresh): (Vec<Bits>, Vec<Bits>) = hits
            .outcomes()
            .zip(batch.hits(Span::ahead()).outcomes())
            .map(|(a, b)| (bits(a), bits(b)))
            .unzip();
        assert_eq!((again.len(), batch.len()), (length, length));
        assert_eq!(again, fresh);
    }
}

#[test]
fn only_a_batch_of_no_rays_is_empty() {
    let pair = Draw(3).pair::<f64>();
    for (pairs, is_empty) in [(vec![], true), (vec![pair], false), (vec![pair; LANES + 1], false)] {
        let batch: Batch<f64> = pairs.into_iter().collect();
        assert_eq!(batch.is_empty(), is_empty, "{} rays", batch.len());
    }
}

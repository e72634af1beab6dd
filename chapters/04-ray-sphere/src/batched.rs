//! The fast corner: CSC418's method for many rays at once.
//!
//! A processor has wide registers: one instruction adds, divides or takes the square roots of 2, 4 or 8
//! numbers at once. [`mod@crate::half_quadratic`] cannot use them, for it decides before it goes on (is
//! D < 0?), and of two neighboring rays one hits and the other does not. Three changes, none of them to
//! the formula:
//!
//! 1. **No branch.** Both roots are always taken, then one is selected. A miss needs no test: √D is NaN
//!    for D < 0, and NaN lies in no [`Span`]. A degenerate ray goes along like the others and is refused
//!    at the end.
//! 2. **Columns.** A register is filled from neighbors in memory, so all x stand side by side, then all
//!    y: a structure of arrays, instead of an array of rays. A ray's place in them is its lane.
//! 3. **A fixed length.** [`LANES`] rays are a [`Packet`], and the loop over it is written plainly, one
//!    lane after the other. No lane asks for another's numbers, so the compiler may work on a whole
//!    register of them at once, and does.
//!
//! Every lane does what `half_quadratic` does in the same order, so verdict, t, point and normal have the
//! same bits, and the accuracy is that of the formula: [`mod@crate::robust`] tells what it loses. What is
//! paid for the speed is work thrown away, the points and normals of misses.
//!
//! A [`Batch`] holds any number of rays, and its [`hits`](Batch::hits) are the answers.
//! [`Instructions`] says which registers they are worked out in.

mod dispatch;

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

pub use dispatch::Instructions;

/// Every number of CSC418's method in one lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Batched<R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// A = d · d
    pub a: R,
    /// B = (a − c) · d
    pub b: R,
    /// C = (a − c) · (a − c) − r²
    pub c: R,
    /// D = B² − A C
    pub d: R,
    /// −B/A + √D/A, the larger root. NaN where D < 0.
    pub lambda_1: R,
    /// −B/A − √D/A, the smaller root. NaN where D < 0.
    pub lambda_2: R,
}

/// Works out CSC418's method without a branch, for a direction of any length but zero.
///
/// This is one lane, and what every lane of a batch does. A degenerate ray or sphere gives values that
/// mean nothing; [`Batched::hit`] refuses them.
#[inline(always)]
pub fn batched<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Batched<R> {
    let r = sphere.radius;
    let from_center = ray.origin - sphere.center;

    // A λ² + 2 B λ + C = 0
    let a = ray.direction.dot(ray.direction);
    let b = from_center.dot(ray.direction);
    let c = from_center.dot(from_center) - r * r;

    let d = b * b - a * c;
    let root = d.sqrt();
    let lambda_1 = -b / a + root / a;
    let lambda_2 = -b / a - root / a;

    Batched { ray: *ray, sphere: *sphere, a, b, c, d, lambda_1, lambda_2 }
}

impl<R: Real> Batched<R> {
    /// λ2 and λ1, the smaller first; `None` for a miss.
    pub fn roots(&self) -> Option<Roots<R>> {
        if self.d < R::from(0.0) { None } else { Some(Roots { near: self.lambda_2, far: self.lambda_1 }) }
    }

    /// The nearest hit in `span`: this ray goes through the machinery as a batch of one.
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let mut packet = Packet::empty();
        packet.put(0, &self.ray, &self.sphere);
        let mut hits = [PacketHits::none()];
        dispatch::run(Instructions::Best, &[packet], span, &mut hits);
        hits[0].outcome(0)
    }
}

/// How many rays a packet has: one AVX2 register of `f32`, two of `f64`. (Of 4, 8, 16 and 32 the fastest
/// in both together.)
pub const LANES: usize = 8;

/// One number of every lane.
pub type Column<R> = [R; LANES];

/// A ray and a sphere in every lane, as ten columns.
#[derive(Clone, Copy, Debug)]
pub struct Packet<R> {
    origin: [Column<R>; 3],
    direction: [Column<R>; 3],
    center: [Column<R>; 3],
    radius: Column<R>,
}

/// What became of a lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It hits.
    Hit,
    /// It misses, or hits outside the span.
    Miss,
    /// It is no question, as [`Sphere::check`] tells.
    Refused(Degenerate),
}

/// The answers of a [`Packet`], as columns.
#[derive(Clone, Copy, Debug)]
pub struct PacketHits<R> {
    /// Hit, miss or refused.
    pub verdict: Column<Verdict>,
    /// Where on the ray; NaN for all but a hit, so that no comparison takes it for one.
    ///
    /// Not infinity: a hit beyond the largest number has that t.
    pub t: Column<R>,
    /// The columns x, y, z of the points. They mean something in the lanes of hits only.
    pub point: [Column<R>; 3],
    /// The columns x, y, z of the outward normals. They mean something in the lanes of hits only.
    pub normal: [Column<R>; 3],
}

/// The whole method: [`LANES`] rays, each against its sphere.
///
/// The answers are a value of their own. Written through a reference their columns might overlap for all
/// the compiler knows; it then keeps a loop over single lanes beside the wide one, and runs that.
#[inline(always)]
fn first_hits<R: Real>(packet: &Packet<R>, span: Span<R>) -> PacketHits<R> {
    let mut hits = PacketHits::none();
    for lane in 0..LANES {
        let (ray, sphere) = packet.get(lane);
        let work = batched(&ray, &sphere);

        // The smaller root if it lies in the span, else the larger; and that one may not either.
        let t = select(span.contains(work.lambda_2), work.lambda_2, work.lambda_1);
        let verdict = verdict(&ray, &sphere, span.contains(t));

        let positive_zero = R::from(0.0);
        let t = select(verdict == Verdict::Hit, t + positive_zero, not_a_number());
        hits.put(lane, verdict, &sphere.hit_at(t, ray.at(t)));
    }
    hits
}

/// Hit or miss, but a question without an answer is refused, for the reason that [`Sphere::check`] gives.
#[inline(always)]
fn verdict<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, hits: bool) -> Verdict {
    // all of them are looked at: `&&` would stop where the answer is known, by a branch
    let finite = ray.origin.is_finite()
        & ray.direction.is_finite()
        & sphere.center.is_finite()
        & sphere.radius.is_finite();
    let zero_direction = ray.direction.is_zero();
    let radius_not_positive = sphere.radius <= R::from(0.0);

    // the check that comes first has the last word
    let verdict = select(hits, Verdict::Hit, Verdict::Miss);
    let verdict = select(radius_not_positive, Verdict::Refused(Degenerate::RadiusNotPositive), verdict);
    let verdict = select(zero_direction, Verdict::Refused(Degenerate::ZeroDirection), verdict);
    select(finite, verdict, Verdict::Refused(Degenerate::NotFinite))
}

/// `a` or `b`, both of which are there already: an instruction, not a branch.
#[inline(always)]
fn select<T>(condition: bool, a: T, b: T) -> T {
    if condition { a } else { b }
}

fn not_a_number<R: Real>() -> R {
    R::from(f32::NAN)
}

impl<R: Real> Packet<R> {
    /// Nothing in any lane: NaN, which is refused.
    fn empty() -> Self {
        let column = [not_a_number(); LANES];
        Packet { origin: [column; 3], direction: [column; 3], center: [column; 3], radius: column }
    }

    fn put(&mut self, lane: usize, ray: &Ray3<R>, sphere: &Sphere<R>) {
        put::<R>(&mut self.origin, lane, ray.origin);
        put::<R>(&mut self.direction, lane, ray.direction);
        put::<R>(&mut self.center, lane, sphere.center);
        self.radius[lane] = sphere.radius;
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> (Ray3<R>, Sphere<R>) {
        let ray = Ray3::<R>::new(get::<R>(&self.origin, lane), get::<R>(&self.direction, lane));
        let sphere = Sphere { center: get::<R>(&self.center, lane), radius: self.radius[lane] };
        (ray, sphere)
    }
}

impl<R: Real> PacketHits<R> {
    /// No lane has hit anything.
    fn none() -> Self {
        let column = [not_a_number(); LANES];
        PacketHits { verdict: [Verdict::Miss; LANES], t: column, point: [column; 3], normal: [column; 3] }
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, verdict: Verdict, hit: &Hit3<R>) {
        self.verdict[lane] = verdict;
        self.t[lane] = hit.t;
        put::<R>(&mut self.point, lane, hit.point);
        put::<R>(&mut self.normal, lane, hit.normal);
    }

    /// The answer of one lane, as every method gives it.
    fn outcome(&self, lane: usize) -> Result<Option<Hit3<R>>, Degenerate> {
        let (point, normal) = (get::<R>(&self.point, lane), get::<R>(&self.normal, lane));
        match self.verdict[lane] {
            Verdict::Hit => Ok(Some(Hit3::<R> { t: self.t[lane], point, normal })),
            Verdict::Miss => Ok(None),
            Verdict::Refused(degenerate) => Err(degenerate),
        }
    }
}

#[inline(always)]
fn put<R: Real>(columns: &mut [Column<R>; 3], lane: usize, v: R::Vec3) {
    for (axis, column) in columns.iter_mut().enumerate() {
        column[lane] = v.components()[axis];
    }
}

#[inline(always)]
fn get<R: Real>([x, y, z]: &[Column<R>; 3], lane: usize) -> R::Vec3 {
    R::vec3(x[lane], y[lane], z[lane])
}

/// Any number of rays, each with a sphere of its own. Collect them from pairs:
///
/// ```
/// # use math::{Ray3, Real, Span};
/// # use ray_sphere::{Sphere, batched::Batch};
/// # let pair = |y: f64| {
/// #     let ray = Ray3::<f64>::new(f64::vec3(0.0, y, 0.0), f64::vec3(0.0, 0.0, 1.0));
/// #     (ray, Sphere { center: f64::vec3(0.0, 0.0, 5.0), radius: 1.0 })
/// # };
/// # let pairs = [pair(0.0), pair(1.0), pair(2.0)];
/// let batch: Batch<f64> = pairs.into_iter().collect();
/// let hits = batch.hits(Span::ahead());
/// let t: Vec<_> = hits.outcomes().map(|outcome| Some(outcome.ok()??.t)).collect();
/// assert_eq!(t, [Some(4.0), Some(5.0), None]);
/// ```
#[derive(Clone, Debug)]
pub struct Batch<R> {
    len: usize,
    packets: Vec<Packet<R>>,
}

impl<R: Real> FromIterator<(Ray3<R>, Sphere<R>)> for Batch<R> {
    fn from_iter<I: IntoIterator<Item = (Ray3<R>, Sphere<R>)>>(pairs: I) -> Self {
        let mut batch = Batch { len: 0, packets: Vec::new() };
        for (ray, sphere) in pairs {
            batch.push(&ray, &sphere);
        }
        batch
    }
}

impl<R: Real> Batch<R> {
    /// Many rays against one sphere.
    pub fn of_rays(rays: &[Ray3<R>], sphere: &Sphere<R>) -> Self {
        rays.iter().map(|ray| (*ray, *sphere)).collect()
    }

    /// One ray against many spheres.
    pub fn of_spheres(ray: &Ray3<R>, spheres: &[Sphere<R>]) -> Self {
        spheres.iter().map(|sphere| (*ray, *sphere)).collect()
    }

    /// One more ray with its sphere, in the next lane.
    fn push(&mut self, ray: &Ray3<R>, sphere: &Sphere<R>) {
        let lane = self.len % LANES;
        if lane == 0 {
            self.packets.push(Packet::empty());
        }
        if let Some(last) = self.packets.last_mut() {
            last.put(lane, ray, sphere);
        }
        self.len += 1;
    }

    /// How many rays there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// There is none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The nearest hit of every ray in `span`, by the best instructions of this processor.
    pub fn hits(&self, span: Span<R>) -> Hits<R> {
        let mut hits = Hits::new();
        self.hits_into(&mut hits, span, Instructions::Best);
        hits
    }

    /// The same, into the memory of earlier answers: those are forgotten.
    pub fn hits_into(&self, hits: &mut Hits<R>, span: Span<R>, instructions: Instructions) {
        hits.len = self.len;
        hits.packets.resize(self.packets.len(), PacketHits::none());
        dispatch::run(instructions, &self.packets, span, &mut hits.packets);
    }
}

/// The answers to a [`Batch`], in its order.
#[derive(Clone, Debug)]
pub struct Hits<R> {
    len: usize,
    packets: Vec<PacketHits<R>>,
}

impl<R: Real> Default for Hits<R> {
    fn default() -> Self {
        Hits::new()
    }
}

impl<R: Real> Hits<R> {
    /// Answers to nothing yet.
    pub fn new() -> Self {
        Hits { len: 0, packets: Vec::new() }
    }

    /// Every ray's answer, as every method gives it.
    pub fn outcomes(&self) -> impl Iterator<Item = Result<Option<Hit3<R>>, Degenerate>> + '_ {
        let lanes = self.packets.iter().flat_map(|packet| (0..LANES).map(|lane| packet.outcome(lane)));
        lanes.take(self.len)
    }

    /// The same as columns. The last packet may have lanes that no ray was put in; they are refused.
    pub fn packets(&self) -> &[PacketHits<R>] {
        &self.packets
    }
}

#[cfg(test)]
mod tests {
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
        let at =
            |t, z, nz| Hit3::<f64> { t, point: DVec3::new(0.0, 0.0, z), normal: DVec3::new(0.0, 0.0, nz) };
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
        let spheres =
            [2.0, -2.0, f64::NAN].map(|radius| Sphere { center: DVec3::new(0.0, 1.0, 5.0), radius });
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
}

//! Eight rays side by side, as columns, and what became of each.

use math::{Degenerate, Ray3, Real, Span, Vector};

use super::batched;
use crate::{Hit3, Sphere};

/// How many rays a packet has: one AVX2 register of `f32`, two of `f64`. (Of 4, 8, 16 and 32 the fastest
/// in both together.)
pub const LANES: usize = 8;

/// One number of every lane.
pub type Column<R> = [R; LANES];

/// A ray and a sphere in every lane, as ten columns. A [`Batch`](super::Batch) makes and fills them.
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
    /// It hits within the span.
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
    /// Where on the ray, in lengths of its direction; NaN for all but a hit, so that no comparison takes it
    /// for one.
    ///
    /// Not infinity: a hit beyond the largest number has that t.
    pub t: Column<R>,
    /// The columns x, y, z of the points. They mean something in the lanes of hits only.
    pub point: [Column<R>; 3],
    /// The columns x, y, z of the outward unit normals. They mean something in the lanes of hits only.
    pub normal: [Column<R>; 3],
}

/// The whole method: [`LANES`] rays, each against its sphere.
#[inline(always)]
pub(super) fn first_hits<R: Real>(packet: &Packet<R>, span: Span<R>, hits: &mut PacketHits<R>) {
    let mut all_valid = true;
    for lane in 0..LANES {
        let (ray, sphere) = packet.get(lane);
        let work = batched(&ray, &sphere);

        // The smaller root if it lies in the span, else the larger; and that one may not either.
        let t = select(span.contains(work.lambda_2), work.lambda_2, work.lambda_1);

        let positive_zero = R::from(0.0);
        let t = select(span.contains(t), t + positive_zero, not_a_number());
        hits.put(lane, &sphere.hit_at(t, ray.at(t)));

        // `&&` would stop where the answer is known, by a branch
        all_valid &= work.surely_valid();
    }

    // A loop of its own, for a verdict is one byte and a number four or eight: in one loop the compiler
    // cannot tell that their columns do not overlap, and goes lane by lane.
    for lane in 0..LANES {
        // which NaN is not
        let is_number = hits.t[lane] >= -R::INFINITY;
        hits.verdict[lane] = select(is_number, Verdict::Hit, Verdict::Miss);
    }

    // a branch after all, but one for all lanes, and almost always the same way
    if !all_valid {
        hits.refuse(packet);
    }
}

/// `a` or `b`, both of which are there already: an instruction, not a branch.
#[inline(always)]
pub(super) fn select<T>(condition: bool, a: T, b: T) -> T {
    if condition { a } else { b }
}

pub(super) fn not_a_number<R: Real>() -> R {
    R::from(f32::NAN)
}

impl<R: Real> Packet<R> {
    /// Nothing in any lane: NaN, which is refused.
    pub(super) fn empty() -> Self {
        let column = [not_a_number(); LANES];
        Packet { origin: [column; 3], direction: [column; 3], center: [column; 3], radius: column }
    }

    pub(super) fn put(&mut self, lane: usize, ray: &Ray3<R>, sphere: &Sphere<R>) {
        put::<R>(&mut self.origin, lane, ray.origin);
        put::<R>(&mut self.direction, lane, ray.direction);
        put::<R>(&mut self.center, lane, sphere.center);
        self.radius[lane] = sphere.radius;
    }

    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> (Ray3<R>, Sphere<R>) {
        let ray = Ray3::<R>::new(get::<R>(&self.origin, lane), get::<R>(&self.direction, lane));
        let sphere = Sphere { center: get::<R>(&self.center, lane), radius: self.radius[lane] };
        (ray, sphere)
    }
}

impl<R: Real> PacketHits<R> {
    /// No lane has hit anything.
    pub(super) fn none() -> Self {
        let column = [not_a_number(); LANES];
        PacketHits { verdict: [Verdict::Miss; LANES], t: column, point: [column; 3], normal: [column; 3] }
    }

    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, hit: &Hit3<R>) {
        self.t[lane] = hit.t;
        put::<R>(&mut self.point, lane, hit.point);
        put::<R>(&mut self.normal, lane, hit.normal);
    }

    /// Looks through the lanes one by one, and takes back the answers to what is no question.
    #[cold]
    pub(super) fn refuse(&mut self, packet: &Packet<R>) {
        for lane in 0..LANES {
            let (ray, sphere) = packet.get(lane);
            if let Err(degenerate) = sphere.check(&ray) {
                self.verdict[lane] = Verdict::Refused(degenerate);
                self.t[lane] = not_a_number();
            }
        }
    }

    /// The answer of one lane, as every method gives it.
    pub(super) fn outcome(&self, lane: usize) -> Result<Option<Hit3<R>>, Degenerate> {
        let (point, normal) = (get::<R>(&self.point, lane), get::<R>(&self.normal, lane));
        match self.verdict[lane] {
            Verdict::Hit => Ok(Some(Hit3::<R> { t: self.t[lane], point, normal })),
            Verdict::Miss => Ok(None),
            Verdict::Refused(degenerate) => Err(degenerate),
        }
    }
}

#[inline(always)]
pub(super) fn put<R: Real>(columns: &mut [Column<R>; 3], lane: usize, v: R::Vec3) {
    for (axis, column) in columns.iter_mut().enumerate() {
        column[lane] = v.components()[axis];
    }
}

#[inline(always)]
pub(super) fn get<R: Real>([x, y, z]: &[Column<R>; 3], lane: usize) -> R::Vec3 {
    R::vec3(x[lane], y[lane], z[lane])
}

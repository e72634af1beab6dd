//! Any number of rays, in packets.

use math::{Degenerate, Ray3, Real, Span};

use super::dispatch::{self, Instructions};
use super::packet::{LANES, Packet, PacketHits};
use crate::{Hit3, Sphere};

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

    /// The same, into the memory of earlier answers, which are forgotten, and by the instructions that are
    /// asked for. Which they are changes no bit of the answers.
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

    /// Every ray's answer, as every method gives it: `None` for a miss, [`Degenerate`] where
    /// [`Sphere::check`] refuses.
    pub fn outcomes(&self) -> impl Iterator<Item = Result<Option<Hit3<R>>, Degenerate>> + '_ {
        let lanes = self.packets.iter().flat_map(|packet| (0..LANES).map(|lane| packet.outcome(lane)));
        lanes.take(self.len)
    }

    /// The same as columns. The last packet may have lanes that no ray was put in; they are refused.
    pub fn packets(&self) -> &[PacketHits<R>] {
        &self.packets
    }
}

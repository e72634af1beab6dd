//! The fast corner: CSC418's method for many rays at once.
//!
//! A processor has wide registers: one instruction adds, divides or takes the square roots of 2, 4 or 8
//! numbers at once. [`mod@crate::half_quadratic`] cannot use them, for it decides before it goes on (is
//! D < 0?), and of two neighboring rays one hits and the other does not. Three changes, none of them to
//! the formula:
//!
//! 1. **No branch.** Both roots are always taken, then one is selected. A miss needs no test: √D is NaN
//!    for D < 0, and NaN lies in no [`Span`]. A degenerate ray goes along like the others; whether there
//!    may be one is asked once for all lanes, of three numbers that are there anyway.
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

mod batch;
mod dispatch;
mod packet;
#[cfg(test)]
mod tests;

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

pub use batch::{Batch, Hits};
pub use dispatch::Instructions;
pub use packet::{Column, LANES, Packet, PacketHits, Verdict};

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
    /// −B/A + √D/A, the larger root, in lengths of d. NaN where D < 0.
    pub lambda_1: R,
    /// −B/A − √D/A, the smaller root. NaN where D < 0.
    pub lambda_2: R,
}

/// Works out CSC418's method (11.3.3) without a branch, for a direction of any length but zero.
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

    /// True only where [`Sphere::check`] refuses nothing. (It may be false there too: where A vanishes or D
    /// overflows.)
    ///
    /// A > 0 says that the direction is not zero, and D that all is finite. For an infinite or NaN number
    /// in d makes A such a number, and one in a, c or r makes C one; then A C is one too, as A is not zero
    /// and ∞ · 0 is NaN; and so is D.
    #[inline(always)]
    fn surely_valid(&self) -> bool {
        let zero = R::from(0.0);
        self.d.is_finite() & (self.a > zero) & (self.sphere.radius > zero)
    }

    /// The nearest hit in `span`: this ray goes through the machinery, in every lane of a packet.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let mut packet = Packet::empty();
        for lane in 0..LANES {
            packet.put(lane, &self.ray, &self.sphere);
        }
        let mut hits = [PacketHits::none()];
        dispatch::run(Instructions::Best, &[packet], span, &mut hits);
        hits[0].outcome(0)
    }
}

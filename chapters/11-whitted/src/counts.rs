//! Count before you time.

use bounds::Tally;
use math::Real;

use crate::{Kind, Sent, Witness};

/// The rays of a picture by kind, and the tests that they took: exact, and the same on every run and machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays from the eye.
    pub eye: u64,
    /// Rays to lights.
    pub shadow: u64,
    /// Rays in mirror directions.
    pub mirror: u64,
    /// Rays through surfaces.
    pub refracted: u64,
    /// Rays that were not sent, within the tolerance.
    pub left_out: u64,
    /// Tests of boxes and of objects.
    pub search: bounds::Counts,
}

impl Counts {
    /// All rays.
    pub fn rays(&self) -> u64 {
        self.eye + self.shadow + self.mirror + self.refracted
    }

    /// Adds the others to these.
    pub fn add(&mut self, other: &Counts) {
        self.eye += other.eye;
        self.shadow += other.shadow;
        self.mirror += other.mirror;
        self.refracted += other.refracted;
        self.left_out += other.left_out;
        self.search.boxes += other.search.boxes;
        self.search.tests += other.search.tests;
        self.search.hits += other.search.hits;
    }
}

impl Tally for Counts {
    #[inline(always)]
    fn boxes(&mut self, more: usize) {
        self.search.boxes(more);
    }
    #[inline(always)]
    fn tests(&mut self, more: usize) {
        self.search.tests(more);
    }
    #[inline(always)]
    fn hit(&mut self) {
        self.search.hit();
    }
}

impl<R: Real> Witness<R> for Counts {
    #[inline(always)]
    fn sent(&mut self, sent: &Sent<R>) {
        match sent.kind {
            Kind::Eye => self.eye += 1,
            Kind::Mirror => self.mirror += 1,
            Kind::Refracted => self.refracted += 1,
        }
    }
    #[inline(always)]
    fn shadow_rays(&mut self, more: u64) {
        self.shadow += more;
    }
    #[inline(always)]
    fn left_out(&mut self, _kind: Kind, _at_most: f64) {
        self.left_out += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_number_is_added_to_its_own() {
        let of = |one: u64| Counts {
            eye: one,
            shadow: 10 * one,
            mirror: 100 * one,
            refracted: 1000 * one,
            left_out: 10_000 * one,
            search: bounds::Counts { boxes: 100_000 * one, tests: 1_000_000 * one, hits: 10_000_000 * one },
        };
        let mut sum = of(2);
        sum.add(&of(3));
        assert_eq!((sum, sum.rays()), (of(5), 5555));
    }
}

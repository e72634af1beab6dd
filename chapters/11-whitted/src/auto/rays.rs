//! Where the rays of a pixel go, as a number.

use bounds::Tally;
use math::Real;
use shading::Fate;
use shading::lighting::Point;

use crate::{Sent, Witness};

/// What the rays of a pixel see: the eye rays' objects; and of all rays in their order objects, their colors
/// and lights. Each as one number (FNV-1a).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rays {
    pub(super) eye: u64,
    pub(super) all: u64,
    /// The depth of the latest ray.
    pub(super) depth: u32,
}

fn mixed(number: u64, word: u64) -> u64 {
    (number ^ word).wrapping_mul(0x100_0000_01b3)
}

impl Rays {
    fn mix(&mut self, word: u64) {
        self.all = mixed(self.all, word);
    }
}

impl Tally for Rays {
    fn boxes(&mut self, _more: usize) {}
    fn tests(&mut self, _more: usize) {}
    fn hit(&mut self) {}
}

impl<R: Real> Witness<R> for Rays {
    const WANTS_LANDINGS: bool = true;

    fn sent(&mut self, sent: &Sent<R>) {
        self.depth = sent.depth;
        self.mix(u64::from(sent.depth) << 2 | sent.kind as u64);
        if sent.depth == 1 {
            self.eye = mixed(self.eye, u64::MAX);
        }
    }

    fn landed(&mut self, object: usize, _lambda: R, point: Option<&Point<R>>) {
        self.mix(object as u64 + 1);
        if self.depth == 1 {
            self.eye = mixed(self.eye, object as u64 + 1);
        }
        // of a checker the colors tell where it lands
        for channel in point.iter().flat_map(|point| point.color.0) {
            self.mix(channel.to_bits());
        }
    }

    fn light(&mut self, light: usize, fate: &Fate<R>) {
        let is_lit = matches!(fate, Fate::Seen(_));
        self.mix((light as u64) << 1 | u64::from(is_lit));
    }
}

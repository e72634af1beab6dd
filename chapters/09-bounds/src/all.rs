//! Trying parts one after the other: all of them, or those in a bound.

use math::Real;

use crate::trial::Tried;
use crate::wide::{Spheres, Work};
use crate::{Nearest, Tally};

/// The loop of the scene signature, over all parts; `ANY`: until something is hit.
pub(crate) struct All<'a, R: Real, B: FnOnce() -> Tried<'a, R>, C, const ANY: bool> {
    pub(crate) spheres: &'a [Spheres],
    pub(crate) rest: &'a [usize],
    /// The ray that is to be tried.
    pub(crate) begins: B,
    pub(crate) counts: &'a mut C,
}

impl<'a, R: Real, B: FnOnce() -> Tried<'a, R>, C: Tally, const ANY: bool> Work for All<'a, R, B, C, ANY> {
    type Answer = Option<(usize, Option<R>)>;

    #[inline(always)]
    fn run(self) -> Option<(usize, Option<R>)> {
        let mut tried = (self.begins)();
        let line = tried.line();
        for block in self.spheres {
            self.counts.tests(block.count());
            let past = block.past(&line);
            let mut candidates = if tried.is_tried_on_all() { block.all() } else { past.candidates };
            while candidates != 0 {
                let lane = candidates.trailing_zeros();
                candidates &= candidates - 1;
                if tried.on_sphere(block, &past, lane as usize).is_some() {
                    self.counts.hit();
                    if ANY {
                        return tried.nearest();
                    }
                }
            }
        }
        for &part in self.rest {
            self.counts.tests(1);
            if tried.on(part).is_some() {
                self.counts.hit();
                if ANY {
                    return tried.nearest();
                }
            }
        }
        tried.nearest()
    }
}

/// The loop of the scene signature, over some parts; `ANY`: until something is hit.
#[inline(always)]
pub(crate) fn try_all<R: Real, const ANY: bool>(
    parts: impl IntoIterator<Item = usize>,
    tried: &mut Tried<'_, R>,
    nearest: &mut Nearest<R>,
    counts: &mut impl Tally,
) {
    for part in parts {
        if ANY && nearest.index.is_some() {
            return;
        }
        counts.tests(1);
        if let Some(t) = tried.on(part) {
            counts.hit();
            nearest.put(part, t);
        }
    }
}

//! Where does the ray first meet the wall? Answered by signs alone, so that with exact numbers it is exact.
//!
//! Between the planes of its ends the wall encloses a convex body: along the line f is below zero for one stretch
//! there. So f at the two ends of the ray's way between the planes, and whether it falls or rises there, tell all.

use std::cmp::Ordering::{Equal, Greater, Less};

use math::{Real, Sure};

use super::End;
use super::crossing::Crossing;
use super::line::Line;

/// What becomes of the ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It meets nothing at λ ≥ 0.
    Misses,
    /// It starts on the wall; at this end of it, if it is one.
    Starts(Option<End>),
    /// It meets the wall's very edge, or its tip, on its way through the plane of an end.
    Edge(End),
    /// It meets the outer side, or touches it.
    Outer,
    /// It meets the inner side.
    Inner,
}

impl Verdict {
    /// The end at which the ray meets the wall, if it is one.
    pub fn end(self) -> Option<End> {
        match self {
            Verdict::Starts(end) => end,
            Verdict::Edge(end) => Some(end),
            Verdict::Misses | Verdict::Outer | Verdict::Inner => None,
        }
    }

    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Verdict::Misses => "misses",
            Verdict::Starts(_) => "starts on the wall",
            Verdict::Edge(_) => "meets the edge",
            Verdict::Outer => "meets the outer side",
            Verdict::Inner => "meets the inner side",
        }
    }
}

impl<N: Sure> Line<N> {
    /// What the ray meets first at λ ≥ 0; `None` where a sign is in doubt, which with [`math::Exact`] none is.
    #[inline(always)]
    pub(super) fn verdict(&self) -> Option<Verdict> {
        let exit = match self.rises()? {
            Greater => Some(End::Apex),
            Less => Some(End::Base),
            Equal => None,
        };
        for entry in [End::Base, End::Apex] {
            if self.within(entry)? == Less {
                // From beyond an end: through its plane, or not at all.
                if exit != Some(entry.other()) {
                    return Some(Verdict::Misses);
                }
                let crossing = self.crossing(entry)?;
                return match crossing.wall {
                    Equal => Some(Verdict::Edge(entry)),
                    Less => self.inside_the_wall(exit),
                    Greater => self.outside_the_wall(Some(crossing), exit),
                };
            }
        }
        match self.c().sign()? {
            Equal => Some(Verdict::Starts(self.end_here()?)),
            Less => self.inside_the_wall(exit),
            Greater => self.outside_the_wall(None, exit),
        }
    }

    /// The end in whose plane the origin is.
    fn end_here(&self) -> Option<Option<End>> {
        Some(match (self.within(End::Base)?, self.within(End::Apex)?) {
            (Equal, _) => Some(End::Base),
            (_, Equal) => Some(End::Apex),
            _ => None,
        })
    }

    /// From a place between the planes where f < 0, on to the plane `exit`: it comes up to zero, or goes out through
    /// the open end.
    #[inline(always)]
    fn inside_the_wall(&self, exit: Option<End>) -> Option<Verdict> {
        let Some(exit) = exit else { return Some(Verdict::Inner) };
        Some(match self.crossing(exit)?.wall {
            Less => Verdict::Misses,
            Equal => Verdict::Edge(exit),
            Greater => Verdict::Inner,
        })
    }

    /// From a place between the planes where f > 0, on to the plane `exit`: does f come down to zero on the way? The
    /// place is a crossing, or else the origin.
    #[inline(always)]
    fn outside_the_wall(&self, from: Option<Crossing<N>>, exit: Option<End>) -> Option<Verdict> {
        if let Some(exit) = exit {
            let crossing = self.crossing(exit)?;
            match crossing.wall {
                // From above zero to below: once, between here and there.
                Less => return Some(Verdict::Outer),
                // It ends at zero: having come up from below, or not having been there before.
                Equal => {
                    let came_up = self.slope(&crossing)? == Greater;
                    return Some(if came_up { Verdict::Outer } else { Verdict::Edge(exit) });
                }
                Greater if self.slope(&crossing)? != Greater => return Some(Verdict::Misses),
                Greater => {}
            }
        }
        // Above zero at both ends and rising at last: it falls first, and touches zero at least.
        let falls = match from {
            None => self.b().sign()? == Greater,
            Some(crossing) => self.slope(&crossing)? == Less,
        };
        Some(if falls && self.discriminant().sign()? != Less { Verdict::Outer } else { Verdict::Misses })
    }

    /// λ of a verdict to the precision of R, off by less than a unit of its last digit. `None` for a miss, and where the
    /// numbers are not good enough for that, which [`math::Exact`] is.
    ///
    /// f falls through the root (B − √D) / A and rises through (B + √D) / A, whatever the sign of A: f′ is 2 (A λ − B).
    #[inline(always)]
    pub(super) fn t<R: Real>(&self, verdict: Verdict) -> Option<R> {
        let side = match verdict {
            Verdict::Misses => return None,
            Verdict::Starts(_) => return Some(R::from(0.0)),
            Verdict::Edge(end) => return self.to_end(end),
            Verdict::Outer => -1.0,
            Verdict::Inner => 1.0,
        };
        let quadratic = self.quadratic();
        if quadratic.a.sign() == Some(Equal) {
            // Parallel to a straight line of the wall: −2 B λ + C = 0
            return N::quotient(&quadratic.c, &(quadratic.b.clone() + quadratic.b));
        }
        N::root(&quadratic, side)
    }
}

//! Where the line crosses the planes of the two ends: what f is there, and whether it falls or rises.

use std::cmp::Ordering;

use math::{Real, Sure};

use super::End;
use super::line::Line;

/// Where the line crosses the plane of an end, everything times d·v, so that nothing is divided.
pub(super) struct Crossing<N> {
    /// The sign of f at the crossing: below zero within the wall.
    pub(super) wall: Ordering,
    /// From the middle of the end to the crossing, times d·v.
    across: [N; 3],
    end: End,
}

impl<N: Sure> Line<N> {
    /// λ of the crossing with the plane of an end, where d·v is not zero.
    #[inline(always)]
    pub(super) fn to_end<R: Real>(&self, end: End) -> Option<R> {
        match end {
            End::Base => N::quotient(&-self.height.clone(), &self.rise),
            End::Apex => N::quotient(&self.depth, &self.rise),
        }
    }

    /// The crossing with the plane of an end, where d·v is not zero; `None` in doubt.
    ///
    /// There x − middle is (p d·v − d p·v) / d·v, and that is v × (p × d) / d·v.
    #[inline(always)]
    pub(super) fn crossing(&self, end: End) -> Option<Crossing<N>> {
        let across = N::cross(&self.v, &self.moment(end));
        let radius = self.radii[end as usize].clone() * self.rise.clone();
        let wall = (N::dot(&across, &across) - radius.clone() * radius).sign()?;
        Some(Crossing { wall, across, end })
    }

    /// Whether f falls or rises along the ray where it crosses a plane; `None` in doubt.
    ///
    /// Half of the slope of the distance's square less r², times v·v (d·v)²: (v·v (across · d) − r k (d·v)²) d·v.
    #[inline(always)]
    pub(super) fn slope(&self, at: &Crossing<N>) -> Option<Ordering> {
        let radius = self.radii[at.end as usize].clone() * self.k.clone();
        let along = self.vv.clone() * N::dot(&at.across, &self.d);
        let times_rise = (along - radius * (self.rise.clone() * self.rise.clone())).sign()?;
        Some(if self.rises()? == Ordering::Less { times_rise.reverse() } else { times_rise })
    }
}

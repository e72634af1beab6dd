//! What the panels of a plot share.

use super::axis::{LogAxis, around, decade, log10};
use super::extent::Extent;
use super::trade::Panel;

/// What all panels share, so that they can be compared.
pub(super) struct Shared {
    /// The methods, in the order in which they are first named.
    pub(super) methods: Vec<String>,
    /// log₁₀ of the ends of the axis of ns.
    pub(super) ns: (f64, f64),
    /// log₁₀ of the ends of the axis of errors; 0 lies at the lower one.
    pub(super) error: (f64, f64),
}

impl Shared {
    /// What these panels share.
    pub(super) fn of(panels: &[Panel]) -> Shared {
        let mut methods: Vec<String> = Vec::new();
        let (mut fastest, mut slowest, mut least) = (f64::INFINITY, 0.0f64, 1.0f64);
        for mark in panels.iter().flat_map(|panel| &panel.marks) {
            if !methods.contains(&mark.method) {
                methods.push(mark.method.clone());
            }
            if mark.has_place() {
                (fastest, slowest) = (fastest.min(mark.ns), slowest.max(mark.ns));
                // half of it, so that no other mark is taken for a 0
                let error = if mark.error > 0.0 { (mark.error / 2.0).max(f64::MIN_POSITIVE) } else { 1.0 };
                least = least.min(error);
            }
        }
        let (low, high) = if fastest <= slowest { around(fastest, slowest) } else { (1.0, 100.0) };
        let bottom = decade(least).min(LOWEST_ERROR);
        Shared { methods, ns: (log10(low), log10(high)), error: (f64::from(bottom), 0.0) }
    }

    /// The axes of a panel whose plot has this extent: ns to the right, errors upward.
    pub(super) fn axes(&self, plot: Extent) -> (LogAxis, LogAxis) {
        let ns = LogAxis { ends: self.ns, places: (plot.left, plot.right) };
        (ns, LogAxis { ends: self.error, places: (plot.bottom, plot.top) })
    }
}

/// Where the axis of errors ends: below what a correctly rounded `f64` is off by, half of 2⁻⁵².
const LOWEST_ERROR: i32 = -17;

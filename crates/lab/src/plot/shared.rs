//! What the panels of a plot share.

use super::axis::{LogAxis, around, at_least, decade, log10};
use super::extent::Extent;
use super::trade::{Mark, TradePlot, Words};

/// What all panels share, so that they can be compared.
pub(super) struct Shared {
    /// What the figures are called.
    pub(super) words: Words,
    /// The methods, in the order in which they are first named.
    pub(super) methods: Vec<String>,
    /// The ends of the axis of ns.
    pub(super) ns: (f64, f64),
    /// Whether a mark of some panel is slower than that.
    pub(super) has_slower: bool,
    /// log₁₀ of the ends of the axis of errors; 0 lies at the lower one.
    pub(super) error: (f64, f64),
}

/// The times of a panel: an axis, and beyond it a band where what is slower stands in its order.
pub(super) struct Times {
    pub(super) axis: LogAxis,
    /// Where the band begins and ends.
    pub(super) band: Option<(f64, f64)>,
    /// The times in the band, each once, the fastest first.
    slower: Vec<f64>,
}

impl Shared {
    /// What the panels of a plot share.
    pub(super) fn of(plot: &TradePlot) -> Shared {
        let mut methods: Vec<String> = Vec::new();
        let mut times: Vec<f64> = Vec::new();
        let mut least = 1.0f64;
        for mark in plot.panels.iter().flat_map(|panel| &panel.marks) {
            if !methods.contains(&mark.method) {
                methods.push(mark.method.clone());
            }
            if mark.has_place() {
                times.push(mark.ns);
                // half of it, so that no other mark is taken for a 0
                let error = if mark.error > 0.0 { (mark.error / 2.0).max(f64::MIN_POSITIVE) } else { 1.0 };
                least = least.min(error);
            }
        }
        times.sort_by(f64::total_cmp);
        let bottom = decade(least).min(if plot.words.rounds { LOWEST_ERROR } else { LOWEST_SHARE });
        let ns = ends(&times);
        let has_slower = times.last().is_some_and(|&slowest| slowest > ns.1);
        Shared { words: plot.words, methods, ns, has_slower, error: (f64::from(bottom), 0.0) }
    }

    /// The axes of a panel with these marks, whose plot has this extent: ns to the right, errors upward.
    pub(super) fn axes(&self, plot: Extent, marks: &[Mark]) -> (Times, LogAxis) {
        let right = if self.has_slower { plot.right - BAND - BREAK } else { plot.right };
        let axis = LogAxis { ends: (log10(self.ns.0), log10(self.ns.1)), places: (plot.left, right) };
        let band = self.has_slower.then_some((plot.right - BAND, plot.right));
        let placed = marks.iter().filter(|mark| mark.has_place());
        let mut slower: Vec<f64> = placed.map(|mark| mark.ns).filter(|&ns| ns > self.ns.1).collect();
        slower.sort_by(f64::total_cmp);
        slower.dedup();
        let error = LogAxis { ends: self.error, places: (plot.bottom, plot.top) };
        (Times { axis, band, slower }, error)
    }
}

impl Times {
    /// The place of a time; in the band it tells the order alone.
    pub(super) fn at(&self, ns: f64) -> f64 {
        let rank = self.slower.iter().position(|&slower| slower == ns);
        match (self.band, rank) {
            (Some((left, right)), Some(rank)) => {
                left + (right - left) * (rank + 1) as f64 / (self.slower.len() + 1) as f64
            }
            _ => self.axis.at(ns),
        }
    }

    /// Whether a time of the panel is beyond the axis.
    pub(super) fn is_slower(&self, ns: f64) -> bool {
        self.slower.contains(&ns)
    }
}

/// Where the axis of errors ends: below what a correctly rounded `f64` is off by, half of 2⁻⁵².
const LOWEST_ERROR: i32 = -17;
/// And where it ends if it is one of shares: 1 in 100 or below.
const LOWEST_SHARE: i32 = -2;

/// How wide the band of slower marks is, and how far from the end of the axis.
const BAND: f64 = 54.0;
const BREAK: f64 = 20.0;

/// The ends of the axis of times, of which `times` are sorted.
///
/// It covers what is typical: eight times the median, and 85 of 100 times. A few that take a thousand times
/// as long would crowd all others at the left. Where one more step covers all of them, it is taken.
fn ends(times: &[f64]) -> (f64, f64) {
    let (Some(&fastest), Some(&slowest)) = (times.first(), times.last()) else { return (1.0, 100.0) };
    let most = times[(times.len() * 85).div_ceil(100) - 1];
    let typical = at_least(most.max(8.0 * times[times.len() / 2]));
    let (low, all) = around(fastest, slowest);
    (low, if slowest < around(typical, typical).1 { all } else { typical })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_of_times_ends_where_it_covers_what_is_typical() {
        let of = |times: &[f64]| ends(times).1;
        assert_eq!(of(&[]), 100.0);
        assert_eq!(of(&[3.0]), 5.0);
        // all of them lie within eight times the median
        assert_eq!(of(&[3.0, 10.0, 30.0]), 50.0);
        // one of them is far slower
        let ordinary = [3.0, 8.0, 9.0, 10.0, 10.0, 10.0, 11.0, 12.0, 15.0, 20.0];
        let with = |slower: &[f64]| [&ordinary[..], slower].concat();
        assert_eq!(of(&with(&[9e3])), 100.0);
        // the next step covers it
        assert_eq!([199.0, 200.0].map(|slowest| of(&with(&[slowest]))), [200.0, 100.0]);
        // so many are slow that they are typical
        assert_eq!(of(&with(&[900.0, 1e5])), 1000.0);
    }

    #[test]
    fn slower_marks_stand_in_their_order_beyond_the_axis() {
        let shared = Shared {
            words: Words::RAYS,
            methods: vec![],
            ns: (1.0, 100.0),
            has_slower: true,
            error: (-17.0, 0.0),
        };
        let plot = Extent { left: 0.0, top: 0.0, right: 300.0, bottom: 100.0 };
        let mark = |ns| Mark {
            method: String::new(),
            precision: stage::Precision::F64,
            ns,
            error: 0.0,
            wrong: 0,
            cases: 1,
            on_front: false,
        };
        let marks = [9e6, 10.0, 500.0, 9e6, f64::INFINITY, 100.0].map(mark);
        let (times, _) = shared.axes(plot, &marks);
        let right = 300.0 - BAND - BREAK;
        assert_eq!([1.0, 10.0, 100.0].map(|ns| times.at(ns)), [0.0, right / 2.0, right]);
        let band = [500.0, 9e6].map(|ns| times.at(ns));
        assert_eq!(band, [300.0 - BAND * 2.0 / 3.0, 300.0 - BAND / 3.0]);
        assert_eq!([100.0, 500.0, 9e6].map(|ns| times.is_slower(ns)), [false, true, true]);
    }
}

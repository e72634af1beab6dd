//! How many pixels of a picture will be visibly others because f32 puts edges elsewhere.
//!
//! Of a pixel of N × N rays one sees something else where its point of the picture lies between an edge as
//! f64 has it and the same edge as f32 has it. How much of the picture lies between them is measured on the
//! lines through the drawn pixels' middles: on a line across it is the sum of the ways that edges have moved,
//! and so on a line down. Whichever is more counts, for of an edge that is level only the one down tells.

use super::levels;
use super::sample::Edge;

/// Pixels that may be expected to be visibly others where f32 is taken. Where they come by chance, one by
/// one, the chance that there is one at all is 1 − exp(−0.05): less than one in twenty.
pub(super) const FEW: f64 = 0.05;
/// How many standard deviations a mean may lie below what it is the mean of, but in one of twenty samples: (1
/// − a)/a of their square, with a = 1/20 (Cantelli), however what is sampled is distributed.
const CANTELLI: f64 = 19.0;

/// By how much edges have moved, in one direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Moved {
    sum: f64,
    squares: f64,
}

impl Moved {
    /// Of so many drawn pixels, those without an edge included: no more than this for each pixel, with 95 %
    /// certainty.
    fn at_most(&self, drawn: f64) -> f64 {
        let mean = self.sum / drawn;
        let variance = (self.squares / drawn - mean * mean).max(0.0);
        mean + (CANTELLI * variance / drawn).sqrt()
    }
}

/// What is asked of a picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Its pixels.
    pub(super) pixels: f64,
    /// N of the N × N rays of each.
    pub(super) samples: u32,
    /// Whether its bytes are those of the sRGB curve.
    pub(super) srgb: bool,
}

impl Asked {
    /// How many pixels of the picture are visibly others because of where the edges are, with 95 % certainty
    /// at most; found beside so many `drawn` ones, in f32 and in f64.
    pub(super) fn expected(&self, drawn: usize, narrow: &[Edge], wide: &[Edge]) -> f64 {
        let mut moved = [Moved::default(); 2];
        for (narrow, wide) in narrow.iter().zip(wide).filter(|(_, wide)| self.is_visible(wide)) {
            let by = (narrow.at - wide.at).abs();
            moved[wide.way].sum += by;
            moved[wide.way].squares += by * by;
        }
        // of the points that the rays of the picture go through; more than one may be of the same pixel
        let points = self.pixels * f64::from(self.samples) * f64::from(self.samples);
        moved.map(|moved| moved.at_most(drawn as f64) * points).into_iter().fold(0.0, f64::max)
    }

    /// Whether a pixel can visibly be another because an edge moves past the points of its rays: by no more
    /// at a time than those of one row, which are one N-th of it.
    ///
    /// Of one ray the two colors are what they are, and one level may be by rounding. Of more the rest of the
    /// pixel adds to both, and what is less than a level here may be rounded to one there: all that is
    /// another byte counts.
    fn is_visible(&self, edge: &Edge) -> bool {
        let [a, b] = [0, 1].map(|side: usize| edge.sides[side].e);
        let n = f64::from(self.samples);
        let moved = |from: shading::Rgb, to: shading::Rgb| from * (1.0 - 1.0 / n) + to * (1.0 / n);
        let most = levels(a, moved(a, b), self.srgb).max(levels(b, moved(b, a), self.srgb));
        if self.samples == 1 { most > 1 } else { most > 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::Seen;
    use super::*;

    /// An edge between black and a gray of so many levels.
    fn edge(way: usize, at: f64, level: f64) -> Edge {
        let side = |level: f64| Seen { e: shading::Rgb([level / 255.0; 3]), ..Seen::default() };
        Edge { pixel: (0, 0), way, at, sides: [side(0.0), side(level)] }
    }

    const ASKED: Asked = Asked { pixels: 1e6, samples: 1, srgb: false };

    /// By hand: on every line of 100 one edge moves by 1e-6. There is no variance: 1e-6 of a million pixels.
    #[test]
    fn what_lies_between_two_edges_is_expected_to_be_another() {
        let [wide, narrow] = [0.5, 0.5 + 1e-6].map(|at| vec![edge(0, at, 100.0); 100]);
        assert!((ASKED.expected(100, &narrow, &wide) - 1.0).abs() < 1e-6);
        // down as across, and whichever is more
        let down: Vec<Edge> = narrow.iter().chain(&[edge(1, 0.5, 100.0)]).copied().collect();
        let level: Vec<Edge> = wide.iter().chain(&[edge(1, 0.25, 100.0)]).copied().collect();
        assert!(ASKED.expected(100, &down, &level) > 2500.0);
        // four points a pixel are four times as often in between
        let four = Asked { samples: 2, ..ASKED };
        assert!((four.expected(100, &narrow, &wide) - 4.0).abs() < 1e-5);
        assert_eq!(ASKED.expected(100, &[], &[]), 0.0);
    }

    /// By hand: one of 100 moves, the mean is a hundredth of it and the variance 0.01 − 0.0001; √(19 ·
    /// 0.0099/100) = 0.0434.
    #[test]
    fn a_few_edges_say_less_than_many() {
        let one = Moved { sum: 1.0, squares: 1.0 };
        assert!((one.at_most(100.0) - 0.0534).abs() < 1e-4);
    }

    /// One row of three of a pixel is a third of it: of two levels it is less than one; and of less than half
    /// of one nothing.
    #[test]
    fn an_edge_is_visible_that_changes_a_byte_by_more_than_rounding() {
        let is_visible = |samples, level| Asked { samples, ..ASKED }.is_visible(&edge(0, 0.5, level));
        assert_eq!([1.0, 2.0].map(|level| is_visible(1, level)), [false, true]);
        assert_eq!([1.4, 2.0, 9.0].map(|level| is_visible(3, level)), [false, true, true]);
    }
}

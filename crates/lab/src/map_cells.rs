//! The cells of a failure map: what becomes of a few cases drawn at every place of a plane of two
//! quantities.

use std::f64::consts::LN_10;

use math::{Real, portable};
use stage::{Precision, TradeAsk};

use crate::plot::{Cell, MapAxis, MapPanel};
use crate::threads::on_all_threads;
use crate::{Draw, Judgment, Subject, judge};

/// Judges every method at both precisions over the plane of `x` and `y`, `per_cell` cases a cell. A panel
/// a method, those of `f64` first; what `ask` leaves out is left out.
///
/// `case` draws a case at the two quantities that it is given. They lie anywhere in their cell, log-uniformly,
/// and the lab rounds the case to the precision. A cell has a source of its own: it does not depend on the
/// others, nor on the threads.
pub fn cells<const N: usize>(
    subject: &impl Subject<N>,
    ask: &TradeAsk,
    x: &MapAxis,
    y: &MapAxis,
    per_cell: usize,
    case: impl Fn(&mut Draw, f64, f64) -> [f64; N] + Sync,
) -> Vec<MapPanel> {
    let methods = subject.about().methods;
    let wanted: Vec<usize> = (0..methods.len()).filter(|method| ask.wants_method(*method)).collect();
    let places: Vec<(usize, usize)> =
        (0..y.cells).flat_map(|row| (0..x.cells).map(move |column| (column, row))).collect();
    let precisions = [Precision::F64, Precision::F32];
    let mut panels = Vec::new();
    for precision in precisions.into_iter().filter(|it| ask.wants_precision(*it)) {
        let cells_of = |&(column, row): &(usize, usize)| {
            let mut draw = Draw::new(ask.seed, &format!("map {column} {row}"), precision);
            let cases: Vec<[f64; N]> = std::iter::repeat_with(|| {
                let (at_x, at_y) = (x.draw(&mut draw, column), y.draw(&mut draw, row));
                case(&mut draw, at_x, at_y).map(|number| draw.rounded(number))
            })
            .take(per_cell)
            .collect();
            match precision {
                Precision::F32 => judge_cell::<f32, N>(subject, &wanted, precision, &cases),
                Precision::F64 => judge_cell::<f64, N>(subject, &wanted, precision, &cases),
            }
        };
        // by cell, then by method
        let cells: Vec<Vec<Cell>> = on_all_threads(&places, cells_of);
        panels.extend(wanted.iter().enumerate().map(|(place, &method)| MapPanel {
            title: format!("{} · {}", methods[method], precision.name()),
            cells: cells.iter().map(|of_methods| of_methods[place]).collect(),
        }));
    }
    panels
}

/// What becomes of the cases of a cell, for every method.
fn judge_cell<R: Real, const N: usize>(
    subject: &impl Subject<N>,
    methods: &[usize],
    precision: Precision,
    cases: &[[f64; N]],
) -> Vec<Cell> {
    let mut judgments = vec![Vec::new(); methods.len()];
    for &case in cases {
        let truth = subject.truth(case, precision);
        for (&method, judgments) in methods.iter().zip(&mut judgments) {
            let answer = subject.answer(method, case.map(R::round_from));
            judgments.push(judge(&answer, &truth, precision));
        }
    }
    judgments.iter().map(|judgments| Cell::of(judgments)).collect()
}

impl Cell {
    /// The worst of what was judged.
    fn of(judgments: &[Judgment]) -> Cell {
        let wrong = judgments.iter().filter(|judgment| matches!(judgment, Judgment::Wrong)).count();
        let ulps = judgments.iter().map(|judgment| match judgment {
            Judgment::Off { ulps, .. } => *ulps,
            _ => 0,
        });
        match ulps.max() {
            None => Cell::Empty,
            Some(_) if wrong > 0 => Cell::Wrong(wrong as f64 / judgments.len() as f64),
            Some(ulps) => Cell::Ulps(ulps as f64),
        }
    }
}

impl MapAxis {
    /// A number from one of its cells, log-uniformly.
    fn draw(&self, draw: &mut Draw, cell: usize) -> f64 {
        let (low, high) = (f64::from(self.low), f64::from(self.high));
        let share = (cell as f64 + draw.uniform(0.0, 1.0)) / self.cells as f64;
        // libm's, not the system's: the same bits on every machine
        portable::exp(LN_10 * (low + (high - low) * share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_shows_its_worst_case() {
        let off = |ulps| Judgment::Off { ulps, relative: 0.0 };
        assert_eq!(Cell::of(&[]), Cell::Empty);
        assert_eq!(Cell::of(&[Judgment::Right]), Cell::Ulps(0.0));
        assert_eq!(Cell::of(&[off(3), off(70), Judgment::Right]), Cell::Ulps(70.0));
        assert_eq!(Cell::of(&[off(70), Judgment::Wrong, off(1), off(1)]), Cell::Wrong(0.25));
    }

    #[test]
    fn numbers_lie_in_their_cell() {
        // by hand: a quarter of the way from 1 to 1e−16 is 1e−4
        let axis = MapAxis { title: String::new(), low: 0, high: -16, cells: 4 };
        let mut draw = Draw::new(1, "test", Precision::F64);
        let drawn: Vec<f64> = (0..100).map(|_| axis.draw(&mut draw, 1)).collect();
        let (least, most) =
            (drawn.iter().copied().fold(1.0, f64::min), drawn.iter().copied().fold(0.0, f64::max));
        assert!((1e-8..1e-7).contains(&least) && (1e-5..=1e-4).contains(&most), "{least:e} {most:e}");
    }
}

//! "To speed calculations, the ray-sphere intersection algorithm is usually broken into two steps": does
//! House's quick rejection pay? Time against the share of rays that hit.

use std::rc::Rc;
use std::time::Duration;

use lab::plot::{LinePlot, Series, lines_svg};
use lab::{Draw, Nanoseconds, Pass, Runner, Subject, runner, time};
use math::{Ray3, Span};
use stage::{Drawing, Precision, Sheet, TradeAsk};

use crate::measure::question;
use crate::stage::RaySphere;
use crate::{Method, Sphere, closest_approach_of_unit, regimes};

/// The shares of hits, in percent.
const SHARES: [u32; 11] = [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100];
/// How many rays are timed at each.
const RAYS: usize = 8192;
/// House's method as he has it: the direction has length 1 already.
const OF_UNIT: &str = "closest-approach, unit given";

/// Times every method at every share of hits, in f64, and draws `reject.svg`.
pub(crate) fn draw(ask: &TradeAsk) -> Drawing {
    let (rounds, allowed) = if ask.quick { (5, 0.02) } else { (101, 0.5) };
    let names: Vec<&str> = Method::ALL.map(Method::name).into_iter().chain([OF_UNIT]).collect();
    let mut series: Vec<Series> =
        names.iter().map(|name| Series { name: name.to_string(), points: Vec::new() }).collect();
    for share in SHARES {
        let cases = cases(ask.seed, share);
        let mut runners = RaySphere.runners(&cases);
        runners.push(of_unit(&cases));
        let allowed = Duration::from_secs_f64(allowed);
        let figures = time(&mut runners, Pass::Throughput, RAYS, rounds, allowed);
        for (series, Nanoseconds { low, median, high }) in series.iter_mut().zip(figures) {
            series.points.push((f64::from(share), median, low, high));
        }
    }
    let conclusion = conclusion(&series);
    let plot = LinePlot {
        title: "Does it pay to reject first?".to_string(),
        subtitle: format!(
            "f64, {RAYS} ordinary rays, hits and misses in random order; medians and quartiles over rounds in \
             which all take turns"
        ),
        x_title: "share of rays that hit (%)".to_string(),
        y_title: "ns per ray".to_string(),
        series,
        conclusion,
        powers: false,
        marks: Vec::new(),
    };
    Drawing { ending: "reject.svg", sheet: Sheet::Svg(lines_svg(&plot)) }
}

/// Ordinary cases of which such a share hits, in random order.
fn cases(seed: u64, share: u32) -> Vec<[f64; 10]> {
    let mut source = Draw::new(seed, "reject", Precision::F64);
    let case = |_| {
        let hits = source.below(100) < u64::from(share);
        regimes::ordinary_that(&mut source, hits)
    };
    (0..RAYS).map(case).collect()
}

fn of_unit(cases: &[[f64; 10]]) -> Runner<'static> {
    let questions: Rc<[(Ray3<f64>, Sphere<f64>)]> = cases.iter().map(|&case| question(case)).collect();
    runner(&questions, |(ray, sphere)| closest_approach_of_unit(ray, sphere).hit(Span::ahead()))
}

/// What the lines say of House's claim.
fn conclusion(series: &[Series]) -> String {
    let of = |name: &str| series.iter().find(|series| series.name == name);
    let (Some(house), Some(gambetta)) = (of(OF_UNIT), of(Method::Quadratic.name())) else {
        return String::new();
    };
    let at = |series: &Series, place: usize| series.points.get(place).map_or(f64::NAN, |point| point.1);
    let last = SHARES.len() - 1;
    let times = |place| format!("{:.1} and {:.1} ns", at(house, place), at(gambetta, place));
    let slowest = (0..=last).max_by(|&a, &b| at(house, a).total_cmp(&at(house, b))).unwrap_or(last);
    let guess = match SHARES[slowest] {
        100 => "at every share of hits".to_string(),
        share => format!("where the processor can guess it: at {share} % hits he is slowest"),
    };
    format!(
        "House (unit direction given) and the quadratic take {} a ray where none hits, {} where half do, {} where all do. \
         Rejecting saves House {:.0} %, {guess}.",
        times(0),
        times(last / 2),
        times(last),
        100.0 * (1.0 - at(house, 0) / at(house, last)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: House 10 ns where none hits, 30 where half do, 20 where all do; the quadratic always 15.
    #[test]
    fn what_is_saved_is_said() {
        let series = |name: &str, times: [f64; 3]| {
            let time = |place: usize| {
                if place == 5 {
                    times[1]
                } else if place < 5 {
                    times[0]
                } else {
                    times[2]
                }
            };
            let points =
                SHARES.iter().enumerate().map(|(place, &share)| (f64::from(share), time(place), 0.0, 0.0));
            Series { name: name.to_string(), points: points.collect() }
        };
        let said = conclusion(&[series(OF_UNIT, [10.0, 30.0, 20.0]), series("quadratic", [15.0; 3])]);
        assert!(
            said.contains("10.0 and 15.0 ns a ray where none hits, 30.0 and 15.0 ns where half do"),
            "{said}"
        );
        assert!(said.contains("saves House 50 %") && said.contains("at 50 % hits he is slowest"), "{said}");
    }

    #[test]
    fn as_many_rays_hit_as_are_asked_for() {
        for (share, range) in [(0, 0..=0), (50, RAYS * 45 / 100..=RAYS * 55 / 100), (100, RAYS..=RAYS)] {
            let cases = cases(7, share);
            let hits = cases.iter().filter(|case| {
                let (ray, sphere) = question(**case);
                matches!(Method::Robust.work(&ray, &sphere).hit(Span::ahead()), Ok(Some(_)))
            });
            assert!(range.contains(&hits.count()), "{share} %");
        }
    }
}

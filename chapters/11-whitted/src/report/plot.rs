//! The plot: the least error that a time can buy.

use lab::plot::{LinePlot, Series};

use super::{AIM, answer};
use crate::measure::{Entry, Measured};

/// Of one scene the front of each method and precision, with what to take ringed; of several, the front of
/// each.
pub(super) fn of(measured: &[Measured]) -> LinePlot {
    let one = if let [one] = measured { Some(one) } else { None };
    let series = match one {
        Some(one) => fronts_of_kinds(one),
        None => measured
            .iter()
            .map(|it| {
                let front: Vec<&Entry> = it.entries.iter().filter(|entry| entry.on_front).collect();
                line(it.name.clone(), it, &front)
            })
            .collect(),
    };
    let take = one.and_then(|it| Some((it, it.fastest_below(AIM)?)));
    let marks = take.map(|(it, entry)| {
        let (x, y, ..) = point(it, entry);
        let setting = entry.setting;
        (x, y, format!("{0} × {0} rays, depth {1}", setting.samples, setting.depth))
    });
    LinePlot {
        title: match one {
            Some(one) => format!("Whitted, {}: the least error that a time can buy", one.name),
            None => "Whitted: the least error that a time can buy".to_string(),
        },
        subtitle:
            "linear radiance before clamping, against 8 × 8 rays a pixel; the safest is robust f64, full \
                   depth, 4 × 4 rays"
                .to_string(),
        x_title: "time, as a share of the safest's".to_string(),
        y_title: "RMSE".to_string(),
        conclusion: match take {
            Some((it, entry)) => {
                let answer = answer(it, AIM, entry);
                format!("{}{}.", answer[..1].to_uppercase(), &answer[1..])
            }
            None => {
                "Rays buy more than digits: along each line it is their number that grows first.".to_string()
            }
        },
        series,
        powers: true,
        marks: marks.into_iter().collect(),
    }
}

/// A scene's front by every method at every precision.
fn fronts_of_kinds(it: &Measured) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for Entry { setting: kind, .. } in &it.entries {
        let name = format!("{} {}", kind.method.name(), kind.precision.name());
        if series.iter().any(|series| series.name == name) {
            continue;
        }
        let of_kind =
            |entry: &&Entry| (entry.setting.method, entry.setting.precision) == (kind.method, kind.precision);
        let entries: Vec<&Entry> = it.entries.iter().filter(of_kind).collect();
        let points: Vec<(f64, f64)> = entries.iter().map(|entry| (entry.seconds, entry.off.rmse)).collect();
        let front = lab::front(&points);
        let front: Vec<&Entry> = entries
            .into_iter()
            .zip(front)
            .filter(|(_, on_front)| *on_front)
            .map(|(entry, _)| entry)
            .collect();
        series.push(line(name, it, &front));
    }
    series
}

fn line(name: String, it: &Measured, front: &[&Entry]) -> Series {
    let mut points: Vec<(f64, f64, f64, f64)> = front.iter().map(|entry| point(it, entry)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Series { name, points }
}

fn point(it: &Measured, entry: &Entry) -> (f64, f64, f64, f64) {
    let (time, rmse) =
        (entry.seconds / it.safest().map_or(f64::NAN, |safest| safest.seconds), entry.off.rmse);
    (time, rmse, rmse, rmse)
}

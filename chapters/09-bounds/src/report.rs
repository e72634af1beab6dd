//! What was measured, as records, as a table to read, and as lines against the number of objects.

use lab::plot::{LinePlot, Series, lines_svg};
use lab::scenes;
use lab::table::{may_not_show, short, three_digits, under};
use math::portable;
use stage::{Drawing, Field, Precision, Record, Sheet, TradeAsk, Traded};

use crate::measure::{Entry, Measured};
use crate::{Counts, Method};

/// The table with what to take from it, the contract's records, and the lines: the time a ray (`trade.svg`)
/// and the tests a ray (`tests.svg`).
pub(crate) fn traded(measured: &[Measured], ask: &TradeAsk) -> Traded {
    let drawing = |ending, plot: &LinePlot| Drawing { ending, sheet: Sheet::Svg(lines_svg(plot)) };
    let drawings = vec![drawing("trade.svg", &times(measured)), drawing("tests.svg", &tests(measured))];
    let records = measured.iter().flat_map(|it| it.entries.iter().map(|entry| record(it, entry, ask.seed)));
    Traded { text: text(measured, ask.seed), records: records.collect(), drawings }
}

/// The contract's fields, those about a single hit empty; then those about bounds.
fn record(measured: &Measured, entry: &Entry, seed: u64) -> Record {
    let Entry { method, precision, ns, rays, counts, others, built, on_front } = entry;
    let Counts { boxes, tests, hits } = counts;
    let a_ray = |count: &u64| Field::Number(*count as f64 / (*rays).max(1) as f64);
    let first = scenes::record(method.name(), *precision, &measured.name, *rays, *on_front);
    let times = scenes::times("ns_per_pixel", ns);
    let rest = [
        ("parts", Field::Count(measured.parts as u64)),
        ("bounds_per_ray", a_ray(boxes)),
        ("tests_per_ray", a_ray(tests)),
        ("hits_per_test", Field::Number(*hits as f64 / (*tests).max(1) as f64)),
        ("other_hit", others.map_or(Field::Nothing, Field::Count)),
        ("ns_build", Field::Number(built * 1e6)),
        ("seed", Field::Count(seed)),
    ];
    first.into_iter().chain(times).chain(rest).collect()
}

/// Those of the scenes that differ in the number of their spheres, at f64 or else at what was measured; if
/// there are none, all.
fn lines(measured: &[Measured], value: impl Fn(&Entry) -> (f64, f64, f64)) -> Vec<Series> {
    let of_spheres = measured.iter().any(|it| it.is_of_spheres);
    let precision = shown(measured);
    let series = |method: Method| {
        let mut points: Vec<(f64, f64, f64, f64)> = measured
            .iter()
            .filter(|it| it.is_of_spheres || !of_spheres)
            .flat_map(|it| it.entries.iter().map(move |entry| (it.parts, entry)))
            .filter(|(_, entry)| entry.method == method && entry.precision == precision)
            .map(|(parts, entry)| {
                let (middle, low, high) = value(entry);
                (parts as f64, middle, low, high)
            })
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Series { name: method.name().to_string(), points }
    };
    let methods = Method::ALL.into_iter().filter(|method| *method != Method::Auto);
    methods.map(series).filter(|series| !series.points.is_empty()).collect()
}

/// The precision that is drawn.
fn shown(measured: &[Measured]) -> Precision {
    let double = measured.iter().flat_map(|it| &it.entries).any(|entry| entry.precision == Precision::F64);
    if double { Precision::F64 } else { Precision::F32 }
}

fn times(measured: &[Measured]) -> LinePlot {
    let series = lines(measured, |entry| (entry.ns.median, entry.ns.low, entry.ns.high));
    let found = crossovers(&series);
    // what is faster from the first scene on crosses nothing
    let crossing = found.iter().filter(|it| it.crosses);
    let marks = crossing.map(|it| (it.objects, it.ns, it.method.clone()));
    let said: Vec<String> =
        found.iter().map(|it| format!("{} from {} on", it.method, short(it.objects.ceil()))).collect();
    LinePlot {
        title: "Bounds: time a ray against the number of objects".to_string(),
        subtitle: format!(
            "{}, robust methods, rays of the eye; medians and quartiles over rounds in which all take turns",
            shown(measured).name()
        ),
        x_title: "objects".to_string(),
        y_title: "ns per ray".to_string(),
        conclusion: if said.is_empty() {
            "No bound pays here.".to_string()
        } else {
            format!("Faster than no bound (ringed): {}.", said.join(", "))
        },
        series,
        powers: true,
        marks: marks.collect(),
    }
}

fn tests(measured: &[Measured]) -> LinePlot {
    let a_ray = |entry: &Entry| {
        let each = (entry.counts.tests + entry.counts.boxes) as f64 / entry.rays.max(1) as f64;
        (each, each, each)
    };
    LinePlot {
        title: "Bounds: tests a ray against the number of objects".to_string(),
        subtitle: "tests of bounds and of objects together; the same on every machine".to_string(),
        x_title: "objects".to_string(),
        y_title: "tests per ray".to_string(),
        series: lines(measured, a_ray),
        conclusion: "Trying every bound is trying every object again. A tree asks for a few more where there are ten times \
                     as many."
            .to_string(),
        powers: true,
        marks: Vec::new(),
    }
}

/// From how many objects on a bound is faster than none.
struct Crossover {
    method: String,
    objects: f64,
    /// The time a ray there.
    ns: f64,
    /// Whether none was faster before.
    crosses: bool,
}

/// Where a line goes below that of `none`, between two points on a line of powers; `None` for those that
/// never do.
fn crossovers(series: &[Series]) -> Vec<Crossover> {
    let Some(none) = series.iter().find(|series| series.name == Method::None.name()) else {
        return Vec::new();
    };
    let crossover = |series: &Series| {
        let both: Vec<(f64, f64, f64)> = series
            .points
            .iter()
            .filter_map(|&(objects, ns, ..)| {
                let plain = none.points.iter().find(|point| point.0 == objects)?;
                Some((objects, ns, plain.1))
            })
            .collect();
        // from the last point on at which none is as fast
        let after = both.iter().rposition(|(_, ns, plain)| ns >= plain).map_or(0, |last| last + 1);
        let &(objects, ns, plain) = both.get(after)?;
        let method = series.name.clone();
        let Some(&(before, ns_before, plain_before)) = after.checked_sub(1).and_then(|at| both.get(at))
        else {
            return Some(Crossover { method, objects, ns, crosses: false });
        };
        // the logarithm of the ratio of the times is 0 between the two
        let (left, right) = (portable::ln(ns_before / plain_before), portable::ln(ns / plain));
        let share = left / (left - right);
        let between =
            |a: f64, b: f64| portable::exp(portable::ln(a) + (portable::ln(b) - portable::ln(a)) * share);
        let (objects, ns) = (between(before, objects), between(ns_before, ns));
        Some(Crossover { method, objects, ns, crosses: true })
    };
    series.iter().filter(|series| series.name != none.name).filter_map(crossover).collect()
}

fn text(measured: &[Measured], seed: u64) -> String {
    let mut text = format!("bounds · trade · seed {seed}\n");
    text += "ns: what a ray of the eye sees, the median and its quartiles. bounds, tests: bounds and objects (or faces) tested a \
             ray.\nhits: the share of tests that hit, nearer than before. other: rays that see another object than without \
             bounds, or at\nanother λ. ms: to make the bounds.\n★: the fastest at its precision: what all see is the same.\n";
    let fewest = measured.iter().flat_map(|it| &it.entries).map(|entry| entry.rays).min().unwrap_or(0);
    text += &may_not_show(fewest, "rays a scene");
    for it in measured {
        text += "\n";
        text += &table(it);
    }
    text + "\n" + &what_to_take(measured)
}

const HEADS: [&str; 9] = ["method", "", "ns", "", "bounds", "tests", "hits", "other", "ms"];

/// One scene: its name, what it is, and a line a method and precision.
fn table(Measured { name, what, parts, entries, .. }: &Measured) -> String {
    let cells = |entry: &Entry| {
        let Entry { method, precision, ns, rays, counts, others, built, .. } = entry;
        let a_ray = |count: u64| three_digits(count as f64 / (*rays).max(1) as f64);
        let rest = [
            a_ray(counts.boxes),
            a_ray(counts.tests),
            three_digits(counts.hits as f64 / counts.tests.max(1) as f64),
            others.map_or("–".to_string(), |others| others.to_string()),
            three_digits(*built),
        ];
        scenes::cells(method.name(), *precision, ns).into_iter().chain(rest).collect()
    };
    let lines = entries.iter().map(|entry| (cells(entry), entry.on_front));
    format!("{name}: {what} · {parts} to test\n{}", under(&HEADS, lines))
}

/// The fastest of each scene, and from how many objects on each bound pays.
fn what_to_take(measured: &[Measured]) -> String {
    let mut text = "What to take: the fastest, as all see the same\n".to_string();
    let width = measured.iter().map(|it| it.name.chars().count()).max().unwrap_or(0);
    for Measured { name, entries, .. } in measured {
        let fastest = entries.iter().filter(|entry| entry.on_front);
        let took = |it: &Entry| scenes::took(it.method.name(), it.precision, &it.ns);
        let said: Vec<String> = fastest.map(took).collect();
        text += &format!("  {name:<width$}  {}\n", said.join("; "));
    }
    let found = crossovers(&lines(measured, |entry| (entry.ns.median, entry.ns.low, entry.ns.high)));
    let said: Vec<String> =
        found.iter().map(|it| format!("{} {}", it.method, short(it.objects.ceil()))).collect();
    if !said.is_empty() {
        text += &format!("  crossover  from so many objects on faster than none: {}\n", said.join(", "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: none takes 10 n, the other 100; on a line of powers they cross at 10.
    #[test]
    fn a_crossover_lies_between_two_points() {
        let line = |name: &str, points: &[(f64, f64)]| Series {
            name: name.to_string(),
            points: points.iter().map(|&(x, y)| (x, y, y, y)).collect(),
        };
        let none = line("none", &[(1.0, 10.0), (100.0, 1000.0), (1000.0, 10_000.0)]);
        let tree = line("tree", &[(1.0, 100.0), (100.0, 100.0), (1000.0, 100.0), (1e6, 100.0)]);
        let never = line("sphere", &[(1.0, 20.0), (100.0, 2000.0)]);
        let found = crossovers(&[none, tree, never]);
        assert_eq!(found.len(), 1);
        assert!((found[0].objects - 10.0).abs() < 1e-9 && (found[0].ns - 100.0).abs() < 1e-9);
    }
}

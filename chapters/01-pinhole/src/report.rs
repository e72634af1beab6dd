//! What was measured, as records, as a table to read, and as the trade plot.

use lab::plot::{Mark, Panel, TradePlot, Words, trade_svg};
use lab::scenes;
use lab::table::{short, small, three_digits, under};
use stage::{Drawing, Field, Precision, Record, Sheet, Traded};

use crate::measure::{Entry, Measured};

/// The table with what to take from it, the contract's records, and the plot `trade.svg`.
pub(crate) fn traded(measured: &[Measured], seed: u64) -> Traded {
    let plot = Drawing { ending: "trade.svg", sheet: Sheet::Svg(trade_svg(&plot(measured, seed))) };
    let record = |it: &Measured| it.entries.iter().map(|entry| record(it.scene.name, entry, seed)).collect();
    let records = measured.iter().flat_map::<Vec<Record>, _>(record).collect();
    Traded { text: text(measured, seed), records, drawings: vec![plot] }
}

/// The contract's fields, those about rays empty; then those about points.
fn record(scene: &str, entry: &Entry, seed: u64) -> Record {
    let Entry { grid, precision, ns, off, on_front } = entry;
    let count = |count: Option<u64>| count.map_or(Field::Nothing, Field::Count);
    let first = scenes::record(grid.name(), *precision, scene, off.points, *on_front);
    let times = scenes::times("ns_per_pixel", ns);
    let rest = [
        ("pixel_error_mean", Field::Number(off.mean())),
        ("pixel_error_max", Field::Number(off.worst)),
        ("lost_pixels", Field::Count(off.lost)),
        ("xy_ulp_median", count(off.ulps.quantile(0.5))),
        ("xy_ulp_p99", count(off.ulps.quantile(0.99))),
        ("xy_ulp_max", count(off.ulps.max())),
        ("seed", Field::Count(seed)),
    ];
    first.into_iter().chain(times).chain(rest).collect()
}

fn plot(measured: &[Measured], seed: u64) -> TradePlot {
    let points = measured.first().and_then(|it| it.entries.first()).map_or(0, |entry| entry.off.points);
    let mark = |entry: &Entry| Mark {
        method: entry.grid.name().to_string(),
        precision: entry.precision,
        ns: entry.ns.median,
        error: entry.off.mean(),
        wrong: entry.off.lost,
        cases: entry.off.points,
        on_front: entry.on_front,
    };
    let panels = measured.iter().map(|it| Panel {
        name: it.scene.name.to_string(),
        what: it.scene.what.to_string(),
        marks: it.entries.iter().map(mark).collect(),
    });
    TradePlot {
        title: "Grids of pixels: speed for accuracy".to_string(),
        subtitle: format!(
            "ns a point: the median over rounds in which all grids take turns. Error: {points} pixels a scene, each \
             against its exact place on its own grid, seed {seed}."
        ),
        words: Words {
            unit: "pixel",
            error: ["error: how far a point is off, in pixels,", "on average; more than one counts as 1"],
            wrong: "points nearer to the place of another pixel",
            rounds: true,
        },
        panels: panels.collect(),
    }
}

fn text(measured: &[Measured], seed: u64) -> String {
    let mut text = format!("pinhole · trade · seed {seed}\n");
    text += "ns: a point among many, the median and its quartiles. error: how far a point is off its exact place, in pixels, \
             on average\n(more than one counts as 1) and at worst. lost/M: points nearer to the place of another pixel, in a \
             million. ulps of x and y:\nmedian, 99 %, worst; next to 0 an ulp is far less than a pixel.\n★: on the Pareto \
             front: nothing else is at least as fast and as accurate, and better in one.\n";
    for it in measured {
        text += "\n";
        text += &table(it);
    }
    text + "\n" + &what_to_take(measured)
}

const HEADS: [&str; 10] = ["method", "", "ns", "", "error", "worst", "lost/M", "ulps", "99 %", "worst"];

/// One scene: its name, what it is, and a line a grid and precision.
fn table(measured: &Measured) -> String {
    let Measured { scene, entries } = measured;
    let points = entries.first().map_or(0, |entry| entry.off.points);
    let lines = entries.iter().map(|entry| (cells(entry), entry.on_front));
    format!("{}: {} · {points} pixels\n{}", scene.name, scene.what, under(&HEADS, lines))
}

fn cells(entry: &Entry) -> Vec<String> {
    let Entry { grid, precision, ns, off, .. } = entry;
    let whole = |count: Option<u64>| count.map_or("–".to_string(), |count| short(count as f64));
    let rest = [
        small(off.mean()),
        small(off.worst),
        short(off.lost as f64 / off.points.max(1) as f64 * 1e6),
        whole(off.ulps.quantile(0.5)),
        whole(off.ulps.quantile(0.99)),
        whole(off.ulps.max()),
    ];
    scenes::cells(grid.name(), *precision, ns).into_iter().chain(rest).collect()
}

/// An edge that is so much of a pixel off its place changes what it covers of a pixel by half a step of
/// 255: less than that is not seen.
const NOT_SEEN: f64 = 0.5 / 255.0;

/// For each scene the fastest precision whose errors nobody sees.
fn what_to_take(measured: &[Measured]) -> String {
    let mut text =
        "What to take, on any of the grids (off by less than 1/510 of a pixel is not seen)\n".to_string();
    let width = measured.iter().map(|it| it.scene.name.chars().count()).max().unwrap_or(0);
    for Measured { scene, entries } in measured {
        let both = Precision::ALL.into_iter().filter_map(|precision| loss(entries, precision));
        let both: Vec<Loss> = both.collect();
        let good = both.iter().filter(|loss| loss.pixels < NOT_SEEN);
        let take = good.min_by(|a, b| a.ns.total_cmp(&b.ns)).map_or("none", |loss| loss.precision.name());
        let said = |Loss { precision, ns, pixels }: &Loss| {
            format!("{} {} ns, off by {} pixels", precision.name(), three_digits(*ns), small(*pixels))
        };
        let said: Vec<String> = both.iter().map(said).collect();
        text += &format!("  {:<width$}  {take:<4}  {}\n", scene.name, said.join("; "));
    }
    text
}

/// What a precision takes and loses in a scene.
struct Loss {
    precision: Precision,
    /// On the fastest grid.
    ns: f64,
    /// The worst point of all grids.
    pixels: f64,
}

/// `None` where the precision was not asked for.
fn loss(entries: &[Entry], precision: Precision) -> Option<Loss> {
    let here = || entries.iter().filter(|entry| entry.precision == precision);
    let ns = here().map(|entry| entry.ns.median).reduce(f64::min)?;
    let pixels = here().map(|entry| entry.off.worst).reduce(f64::max)?;
    Some(Loss { precision, ns, pixels })
}

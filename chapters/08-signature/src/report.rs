//! What was measured, as records, as a table to read, and as the trade plot.

use lab::plot::{Mark, Panel, TradePlot, Words, trade_svg};
use lab::scenes;
use lab::table::{may_not_show, short, three_digits, under};
use stage::{Drawing, Field, Record, Sheet, Traded};

use crate::measure::{Entry, Measured};

/// The table with what to take from it, the contract's records, and the plot `trade.svg`.
pub(crate) fn traded(measured: &[Measured], seed: u64) -> Traded {
    let plot = Drawing { ending: "trade.svg", sheet: Sheet::Svg(trade_svg(&plot(measured))) };
    let records = measured.iter().flat_map(|it| it.entries.iter().map(|entry| record(it, entry, seed)));
    Traded { text: text(measured, seed), records: records.collect(), drawings: vec![plot] }
}

/// The contract's fields, those about a single hit empty; then those about pixels.
fn record(measured: &Measured, entry: &Entry, seed: u64) -> Record {
    let Entry { method, precision, ns, off, on_front } = entry;
    let first = scenes::record(method.name(), *precision, &measured.name, off.pixels, *on_front);
    let times = scenes::times("ns_per_pixel", ns);
    let rest = [
        ("objects", Field::Count(measured.objects as u64)),
        ("other_object", Field::Count(off.others)),
        ("holes", Field::Count(off.holes)),
        ("seed", Field::Count(seed)),
    ];
    first.into_iter().chain(times).chain(rest).collect()
}

fn plot(measured: &[Measured]) -> TradePlot {
    let mark = |entry: &Entry| Mark {
        method: entry.method.name().to_string(),
        precision: entry.precision,
        ns: entry.ns.median,
        error: entry.off.share(),
        wrong: entry.off.others,
        cases: entry.off.pixels,
        on_front: entry.on_front,
    };
    let panels = measured.iter().map(|it| Panel {
        name: it.name.clone(),
        what: it.what.clone(),
        marks: it.entries.iter().map(mark).collect(),
    });
    TradePlot {
        title: "Scene signature: speed for accuracy".to_string(),
        subtitle: "ns a pixel, every object tried: the median over rounds in which all take turns. The reference sees \
                   with the robust methods at f64."
            .to_string(),
        words: Words {
            unit: "pixel",
            error: ["error: the share of pixels", "that see another object"],
            wrong: "pixels that see another object",
            rounds: false,
        },
        panels: panels.collect(),
    }
}

fn text(measured: &[Measured], seed: u64) -> String {
    let mut text = format!("signature · trade · seed {seed}\n");
    text += "ns: a pixel, all objects (and faces of meshes) tried, the median and its quartiles. other: pixels that see \
             another object\nthan the robust methods at f64 do, with no object and some object among them; holes: those of \
             them that see nothing at all.\n★: on the Pareto front: nothing else is at least as fast and as right, and better in one.\n";
    let fewest = measured.iter().flat_map(|it| &it.entries).map(|entry| entry.off.pixels).min().unwrap_or(0);
    text += &may_not_show(fewest, "pixels a scene");
    for it in measured {
        text += "\n";
        text += &table(it);
    }
    text + "\n" + &what_to_take(measured)
}

const HEADS: [&str; 7] = ["method", "", "ns", "", "ns/try", "other", "holes"];

/// One scene: its name, what it is, and a line a method and precision.
fn table(measured: &Measured) -> String {
    let Measured { name, what, tries, entries, .. } = measured;
    let pixels = entries.first().map_or(0, |entry| entry.off.pixels);
    let cells = |Entry { method, precision, ns, off, .. }: &Entry| {
        let rest =
            [three_digits(ns.median / *tries as f64), short(off.others as f64), short(off.holes as f64)];
        scenes::cells(method.name(), *precision, ns).into_iter().chain(rest).collect()
    };
    let lines = entries.iter().map(|entry| (cells(entry), entry.on_front));
    format!("{name}: {what} · {pixels} pixels\n{}", under(&HEADS, lines))
}

/// For each scene the fastest that sees what the reference sees.
fn what_to_take(measured: &[Measured]) -> String {
    let mut text = "What to take: the fastest that sees what the robust methods at f64 see\n".to_string();
    let width = measured.iter().map(|it| it.name.chars().count()).max().unwrap_or(0);
    for Measured { name, entries, .. } in measured {
        let right = entries.iter().filter(|entry| entry.off.others == 0);
        let take = right.min_by(|a, b| a.ns.median.total_cmp(&b.ns.median));
        let said = match take {
            Some(Entry { method, precision, ns, .. }) => scenes::took(method.name(), *precision, ns),
            None => "none of these".to_string(),
        };
        text += &format!("  {name:<width$}  {said}\n");
    }
    text
}

//! What was measured, as records, as a table to read, and as the trade plot.

use lab::front;
use lab::plot::{Mark, Panel, TradePlot, Words, trade_svg};
use lab::scenes;
use lab::table::{may_not_show, short, under};
use stage::{Drawing, Field, Record, Sheet, Traded};

use crate::measure::{Entry, Measured};

mod advice;

/// The table with what to take from it, the contract's records, and the plot `trade.svg`.
pub(crate) fn traded(measured: &[Measured], seed: u64) -> Traded {
    let plot = Drawing { ending: "trade.svg", sheet: Sheet::Svg(trade_svg(&plot(measured))) };
    let records = measured.iter().flat_map(|it| it.entries.iter().map(|entry| record(it, entry, seed)));
    Traded { text: text(measured, seed), records: records.collect(), drawings: vec![plot] }
}

/// The contract's fields, those about a single hit empty; then those about second rays.
fn record(measured: &Measured, entry: &Entry, seed: u64) -> Record {
    let Entry { start, precision, ns, faults, on_front } = entry;
    let per_million = |count: u64| Field::Number(faults.per_million(count));
    let first = scenes::record(start.name(), *precision, measured.regime.name, faults.cases, *on_front);
    let times = scenes::times("ns_per_second_ray", ns);
    let rest = [
        ("acne_per_million", per_million(faults.acne)),
        ("leaks_per_million", faults.leaks.map_or(Field::Nothing, per_million)),
        ("size", Field::Number(measured.regime.size)),
        ("distance", Field::Number(measured.regime.distance)),
        ("seed", Field::Count(seed)),
    ];
    first.into_iter().chain(times).chain(rest).collect()
}

fn plot(measured: &[Measured]) -> TradePlot {
    let mark = |entry: &Entry| Mark {
        method: entry.start.name().to_string(),
        precision: entry.precision,
        ns: entry.ns.median,
        error: entry.faults.share(),
        wrong: entry.faults.all(),
        cases: entry.faults.cases,
        on_front: false,
    };
    // a panel's line is that of the panel alone
    let marks = |entries: &[Entry]| {
        let mut marks: Vec<Mark> = entries.iter().map(mark).collect();
        let places: Vec<(f64, f64)> = marks.iter().map(|mark| (mark.ns, mark.error)).collect();
        for (mark, on_front) in marks.iter_mut().zip(front(&places)) {
            mark.on_front = on_front;
        }
        marks
    };
    let panels = measured.iter().map(|it| Panel {
        name: it.regime.name.to_string(),
        what: it.regime.what.to_string(),
        marks: marks(&it.entries),
    });
    TradePlot {
        title: "Where a second ray starts: speed for acne and leaks".to_string(),
        subtitle: "ns a second ray, from its start to what it meets: the median over rounds in which all take turns. What is \
                   true is known of a shape that stands alone."
            .to_string(),
        words: Words {
            unit: "second ray",
            error: ["the share of second rays", "with acne or a leak"],
            wrong: "second rays with acne or a leak",
            rounds: false,
        },
        panels: panels.collect(),
    }
}

fn text(measured: &[Measured], seed: u64) -> String {
    let mut text = format!("shading · trade · seed {seed}\n");
    text += "ns: a second ray, from its start to what it meets of a shape that stands alone, the median and its quartiles.\n\
             acne: per million, those that meet the surface that they leave. leaks: per million, those that miss what is 1e-4 of the\n\
             size above it all around, or the other side of the solid that they enter.\n\
             bound is judged with everything tried, and timed as it is used: what is convex and left behind is not tried again.\n\
             ★: nothing else is at least as fast here and as right over all regimes, and better in one.\n";
    let cases = measured.iter().flat_map(|it| &it.entries).map(|entry| entry.faults.cases).max().unwrap_or(0);
    text += &may_not_show(cases, "rays a shape");
    for it in measured {
        text += "\n";
        text += &table(it);
    }
    text + "\n" + &advice::sentences(measured)
}

const HEADS: [&str; 6] = ["method", "", "ns", "", "acne/M", "leaks/M"];

/// One scene: its name, what it is, and a line a method and precision.
fn table(Measured { regime, entries }: &Measured) -> String {
    let cases = entries.iter().map(|entry| entry.faults.cases).max().unwrap_or(0);
    let cells = |Entry { start, precision, ns, faults, .. }: &Entry| {
        let rest = [
            short(faults.per_million(faults.acne)),
            faults.leaks.map_or("–".to_string(), |leaks| short(faults.per_million(leaks))),
        ];
        scenes::cells(start.name(), *precision, ns).into_iter().chain(rest).collect()
    };
    let lines = entries.iter().map(|entry| (cells(entry), entry.on_front));
    format!("{}: {} · {cases} rays\n{}", regime.name, regime.what, under(&HEADS, lines))
}

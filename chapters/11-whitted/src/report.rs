//! What was measured, as records, as a table to read, and as lines of the best that a time can buy.

use lab::scenes;
use lab::table::{small, three_digits, under};
use stage::{Drawing, Field, Record, Sheet, TradeAsk, Traded};

use crate::measure::{Entry, Measured, Setting};

mod plot;

/// The table with what to take from it, the contract's records, and the plot `trade.svg`.
pub fn traded(measured: &[Measured], ask: &TradeAsk) -> Traded {
    let svg = lab::plot::lines_svg(&plot::of(measured));
    let drawings = vec![Drawing { ending: "trade.svg", sheet: Sheet::Svg(svg) }];
    // what the others are compared with is measured in any case, and a record only where it was asked for
    let is_asked_for = |entry: &&Entry| {
        let Setting { method, precision, .. } = entry.setting;
        ask.method.is_none_or(|place| signature::Method::ALL[place] == method)
            && ask.precision.is_none_or(|asked| asked == precision)
    };
    let records = measured
        .iter()
        .flat_map(|it| it.entries.iter().filter(is_asked_for).map(|entry| record(it, entry, ask.seed)));
    Traded { text: text(measured, ask.seed), records: records.collect(), drawings }
}

/// The contract's fields, those about a single hit empty; then those about pictures.
fn record(measured: &Measured, entry: &Entry, seed: u64) -> Record {
    let Entry { setting, seconds, counts, off, alone, on_front } = entry;
    let Setting { method, precision, depth, tolerance, samples } = setting;
    let pixels = f64::from(measured.size.0) * f64::from(measured.size.1);
    let first = scenes::record(method.name(), *precision, &measured.name, measured.pixels as u64, *on_front);
    let rest = [
        ("depth", Field::Count(u64::from(*depth))),
        ("tolerance", tolerance.map_or(Field::Nothing, Field::Number)),
        ("samples", Field::Count(u64::from(*samples))),
        ("ns_per_pixel", Field::Number(1e9 * seconds / pixels)),
        ("rmse", Field::Number(off.rmse)),
        ("largest", Field::Number(off.largest)),
        ("rmse_same_samples", Field::Number(alone.rmse)),
        ("largest_same_samples", Field::Number(alone.largest)),
        ("rays", Field::Count(counts.rays())),
        ("left_out", Field::Count(counts.left_out)),
        ("seed", Field::Count(seed)),
    ];
    first.into_iter().chain(rest).collect()
}

/// The errors for which it is said what to take, in linear radiance.
const ERRORS: [f64; 7] = [0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
/// The one that is said in one line: five steps of 255.
const AIM: f64 = 0.02;

fn text(measured: &[Measured], seed: u64) -> String {
    let mut text = format!("whitted · trade · seed {seed}\n");
    text += "\
ms: a whole picture of the scene's own size on one thread, by the share of the pixels that were traced; the
median over rounds in which all settings take turns. rmse, largest: linear radiance before clamping against
robust f64, full depth, 8 × 8 rays a pixel. alone: the same two against robust f64, full depth, as many rays.
Shown are the safest and the ★: on the Pareto front of time and rmse, nothing else is at least as fast and as
exact, and better in one.
";
    for it in measured {
        text += "\n";
        text += &table(it);
        for line in answers(it) {
            text += &format!("  {line}\n");
        }
    }
    text + "\n" + &what_to_take(measured)
}

const HEADS: [&str; 11] =
    ["method", "", "depth", "tolerance", "rays", "ms", "faster", "rmse", "largest", "alone", ""];

/// One scene: its name, what it is, its safest setting and those on the front, the slowest first.
fn table(measured: &Measured) -> String {
    let Measured { name, what, size, pixels, entries, .. } = measured;
    let safest = measured.safest().map_or(f64::NAN, |entry| entry.seconds);
    let mut shown: Vec<&Entry> = entries.iter().skip(1).filter(|entry| entry.on_front).collect();
    shown.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    let shown: Vec<&Entry> = measured.safest().into_iter().chain(shown).collect();
    let cells = |entry: &&Entry| {
        let Entry { setting, seconds, off, alone, .. } = entry;
        vec![
            setting.method.name().to_string(),
            setting.precision.name().to_string(),
            setting.depth.to_string(),
            setting.tolerance.map_or("–".to_string(), |e| e.to_string()),
            format!("{0} × {0}", setting.samples),
            three_digits(1e3 * seconds),
            format!("{} ×", three_digits(safest / seconds)),
            small(off.rmse),
            small(off.largest),
            small(alone.rmse),
            small(alone.largest),
        ]
    };
    let lines = shown.iter().map(|entry| (cells(entry), entry.on_front));
    let (width, height, all) = (size.0, size.1, entries.len());
    format!(
        "{name}: {what} · {pixels} pixels of {width} × {height} · {all} settings\n{}",
        under(&HEADS, lines)
    )
}

/// What to type for which error, each setting once, for the least of the errors that it stays below.
fn answers(measured: &Measured) -> Vec<String> {
    let mut answers: Vec<(&Entry, String)> = Vec::new();
    for e in ERRORS {
        let Some(entry) = measured.fastest_below(e) else { break };
        if answers.last().is_some_and(|(last, _)| last.setting == entry.setting) {
            answers.pop();
        }
        answers.push((entry, answer(measured, e, entry)));
    }
    answers.into_iter().map(|(_, answer)| answer).collect()
}

/// The answer in one line.
fn answer(measured: &Measured, e: f64, entry: &Entry) -> String {
    let safest = measured.safest().map_or(f64::NAN, |safest| safest.seconds);
    let scene = measured.path.as_ref().map_or(String::new(), |path| format!(" --scene {path}"));
    let flags = entry.setting.flags(measured.depth);
    let faster = three_digits(safest / entry.seconds);
    format!("for error below {e}: whitted{scene}{flags}, {faster} × faster than the safest")
}

/// For each scene the fastest below [`AIM`], or below the least error that is reached.
fn what_to_take(measured: &[Measured]) -> String {
    let mut text = "What to take\n".to_string();
    let width = measured.iter().map(|it| it.name.chars().count()).max().unwrap_or(0);
    for it in measured {
        let below = ERRORS.into_iter().rev().filter(|e| *e >= AIM);
        let found = below.into_iter().find_map(|e| Some((e, it.fastest_below(e)?)));
        let said = found
            .map_or("no setting comes near the reference".to_string(), |(e, entry)| answer(it, e, entry));
        text += &format!("  {:<width$}  {said}\n", it.name);
    }
    text
}

#[cfg(test)]
mod tests;

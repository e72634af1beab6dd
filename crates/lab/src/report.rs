//! What was measured, as records, as a table to read, and as the trade plot.

use stage::{Drawing, Field, Record, Sheet, Traded};

use crate::measure::{Entry, Measured, MeasuredRegime, WorstCase};
use crate::plot::{Mark, Panel, TradePlot, Words, trade_svg};
use crate::table::{may_not_show, short, small, three_digits, under};
use crate::verdict;
use crate::{Judgment, Truth, scenes};

impl Measured {
    /// The answer to `trade`: the table with what to take from it, the contract's records, and the plot
    /// `trade.svg`.
    pub fn traded(&self, title: &str) -> Traded {
        let plot = Drawing { ending: "trade.svg", sheet: Sheet::Svg(trade_svg(&self.plot(title))) };
        Traded { text: self.text(), records: self.records(), drawings: vec![plot] }
    }

    fn records(&self) -> Vec<Record> {
        let regimes = self.regimes.iter();
        regimes.flat_map(|regime| regime.entries.iter().map(|entry| self.record(regime, entry))).collect()
    }

    /// The contract's columns, then those of the lab.
    fn record(&self, regime: &MeasuredRegime, entry: &Entry) -> Record {
        let Entry { method, precision, throughput, latency, ratio, accuracy, on_front, .. } = entry;
        let count = |count: Option<u64>| count.map_or(Field::Nothing, Field::Count);
        vec![
            ("method", Field::Text(method.to_string())),
            ("precision", Field::Text(precision.name().to_string())),
            ("regime", Field::Text(regime.name.to_string())),
            ("ns_per_ray", Field::Number(throughput.median)),
            ("cases", Field::Count(accuracy.cases)),
            ("wrong_decisions", Field::Count(accuracy.wrong)),
            ("t_ulp_median", count(accuracy.ulps.quantile(0.5))),
            ("t_ulp_p99", count(accuracy.ulps.quantile(0.99))),
            ("t_ulp_max", count(accuracy.ulps.max())),
            ("pareto", Field::Flag(*on_front)),
            ("ns_low", Field::Number(throughput.low)),
            ("ns_high", Field::Number(throughput.high)),
            ("ns_latency", Field::Number(latency.median)),
            ("ns_ratio", Field::Number(*ratio)),
            ("hits", Field::Count(accuracy.hits)),
            ("error", Field::Number(accuracy.error())),
            ("residual_max", Field::Number(accuracy.residual)),
            ("normal_angle_max", accuracy.normal_angle.map_or(Field::Nothing, Field::Number)),
            ("seed", Field::Count(self.seed)),
        ]
    }

    /// How many cases of each regime were judged.
    fn cases(&self) -> u64 {
        let entry = self.regimes.first().and_then(|regime| regime.entries.first());
        entry.map_or(0, |entry| entry.accuracy.cases)
    }

    fn plot(&self, title: &str) -> TradePlot {
        let cases = self.cases();
        let panels = self.regimes.iter().map(|regime| Panel {
            name: regime.name.to_string(),
            what: regime.what.to_string(),
            marks: regime.entries.iter().map(mark).collect(),
        });
        TradePlot {
            title: title.to_string(),
            subtitle: format!(
                "ns a ray: the median over rounds in which all methods take turns. Error: {cases} cases a regime against \
                 the exact oracle, seed {}.",
                self.seed
            ),
            words: Words::RAYS,
            panels: panels.collect(),
        }
    }

    fn text(&self) -> String {
        let mut text = format!("{} · trade · seed {}\n", self.stage, self.seed);
        text += &format!(
            "ns: a ray among many, the median and its quartiles; ×: in units of {} at the same precision; \
             one by one: where a ray depends on the last.\n",
            self.baseline
        );
        text += "wrong/M: wrong verdicts in a million. ulps of t: median, 99 %, worst, of the right verdicts. error: mean relative \
                 error of t, a wrong\nverdict counting as 1. off: how far the point is from the surface, and the normal from its \
                 direction, at worst.\n★: on the Pareto front of what is shown: nothing else is at least as fast and as accurate, and \
                 better in one.\n";
        text += &may_not_show(self.cases(), "cases a regime");
        for regime in &self.regimes {
            text += "\n";
            text += &table(regime);
            text += &worst_cases(self, regime);
        }
        text + "\n" + &verdict::sentences(self)
    }
}

fn mark(entry: &Entry) -> Mark {
    Mark {
        method: entry.method.to_string(),
        precision: entry.precision,
        ns: entry.throughput.median,
        error: entry.accuracy.error(),
        wrong: entry.accuracy.wrong,
        cases: entry.accuracy.cases,
        on_front: entry.on_front,
    }
}

const HEADS: [&str; 13] = [
    "method",
    "",
    "ns",
    "",
    "×",
    "one by one",
    "wrong/M",
    "ulps",
    "99 %",
    "worst",
    "error",
    "point off",
    "normal off",
];

/// One regime: its name, what it is, and a line a method and precision.
fn table(regime: &MeasuredRegime) -> String {
    let (cases, hits) =
        regime.entries.first().map_or((0, 0), |entry| (entry.accuracy.cases, entry.accuracy.hits));
    let share = 100.0 * hits as f64 / cases.max(1) as f64;
    let title = format!("{}: {} · {cases} cases, {share:.0} % hit\n", regime.name, regime.what);
    let lines = regime.entries.iter().map(|entry| (cells(entry), entry.on_front));
    title + &under(&HEADS, lines)
}

/// Where one method at one precision was asked for, the case that it gets most wrong, for `eval`.
fn worst_cases(measured: &Measured, regime: &MeasuredRegime) -> String {
    let ([entry], Measured { stage, columns, .. }) = (&regime.entries[..], measured) else {
        return String::new();
    };
    let Some(WorstCase { judgment, row, truth }) = &entry.worst else { return String::new() };
    let what = match judgment {
        Judgment::Off { ulps, .. } => format!("t {} ulps off", short(*ulps as f64)),
        _ => "a wrong verdict".to_string(),
    };
    let truth = match truth {
        Truth::Invalid(reason) => format!("invalid, {reason}"),
        Truth::Miss("") => "a miss".to_string(),
        Truth::Miss(reason) => format!("a miss, {reason}"),
        Truth::Hit { t, .. } => format!("a hit at t = {:?}", t.nearest),
    };
    let (columns, method, precision) = (columns.join(","), entry.method, entry.precision.name());
    format!(
        "  the worst of them, {what}; in truth it is {truth}:\n  printf '%s\\n' '{columns}' '{row}' | \
         cargo run --release -q -p {stage} -- eval --method {method} --precision {precision}\n"
    )
}

/// The names of the contract's columns.
#[cfg(test)]
pub(crate) const CONTRACT: [&str; 10] = [
    "method",
    "precision",
    "regime",
    "ns_per_ray",
    "cases",
    "wrong_decisions",
    "t_ulp_median",
    "t_ulp_p99",
    "t_ulp_max",
    "pareto",
];

fn cells(entry: &Entry) -> Vec<String> {
    let Entry { method, precision, throughput, latency, ratio, accuracy, .. } = entry;
    let whole = |count: Option<u64>| count.map_or("–".to_string(), |count| short(count as f64));
    let rest = [
        format!("{ratio:.2}"),
        three_digits(latency.median),
        short(accuracy.wrong_share() * 1e6),
        whole(accuracy.ulps.quantile(0.5)),
        whole(accuracy.ulps.quantile(0.99)),
        whole(accuracy.ulps.max()),
        small(accuracy.error()),
        small(accuracy.residual),
        accuracy.normal_angle.map_or("–".to_string(), small),
    ];
    scenes::cells(method, *precision, throughput).into_iter().chain(rest).collect()
}

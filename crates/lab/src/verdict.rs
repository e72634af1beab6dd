//! "Which method do I take, at which precision, and what do I lose?" From the figures, in sentences.

use stage::Precision;

use crate::measure::{Entry, Measured};
use crate::table::{short, three_digits};

/// A t within so many ulps in every case is right for every purpose: the bar of the robust methods.
const RIGHT: u64 = 8;

/// One method at one precision over all regimes.
struct Candidate<'a> {
    /// In the first of the regimes.
    first: &'a Entry,
    /// In all of them, with their names.
    all: Vec<(&'static str, &'a Entry)>,
}

impl Candidate<'_> {
    fn name(&self) -> String {
        format!("{} {}", self.first.method, self.first.precision.name())
    }

    fn ns(&self) -> f64 {
        self.first.throughput.median
    }

    /// Every verdict is right in every regime.
    fn never_misjudges(&self) -> bool {
        self.all.iter().all(|(_, entry)| entry.accuracy.wrong == 0)
    }

    /// And t is, too.
    fn is_right(&self) -> bool {
        let within = |entry: &Entry| entry.accuracy.ulps.max().is_none_or(|ulps| ulps <= RIGHT);
        self.never_misjudges() && self.all.iter().all(|(_, entry)| within(entry))
    }

    /// The largest time of all regimes, if it is another story than the first.
    fn cliff(&self) -> String {
        let slowest = self.all.iter().max_by(|a, b| a.1.throughput.median.total_cmp(&b.1.throughput.median));
        match slowest {
            Some((regime, entry)) if entry.throughput.median > 3.0 * self.ns() => {
                format!("; up to {} ns, in {regime}", three_digits(entry.throughput.median))
            }
            _ => String::new(),
        }
    }

    /// Where it fails, or that it does not.
    fn loss(&self) -> String {
        let regimes = self.all.len();
        let wrong: Vec<_> = self.all.iter().filter(|(_, entry)| entry.accuracy.wrong > 0).collect();
        let most =
            wrong.iter().max_by(|a, b| a.1.accuracy.wrong_share().total_cmp(&b.1.accuracy.wrong_share()));
        let verdicts = match most {
            None => format!("no wrong verdict in {}", counted(regimes, "regime")),
            Some((regime, entry)) => format!(
                "wrong verdicts in {} of {}, most in {regime}: {} of {}",
                wrong.len(),
                counted(regimes, "regime"),
                entry.accuracy.wrong,
                entry.accuracy.cases,
            ),
        };
        let ulps = self.all.iter().filter_map(|(regime, entry)| Some((regime, entry.accuracy.ulps.max()?)));
        let digits = match ulps.max_by_key(|(_, ulps)| *ulps) {
            None => String::new(),
            Some((_, 0)) => "; t always the nearest number there is".to_string(),
            Some((_, 1)) => "; t at most 1 ulp off".to_string(),
            Some((regime, ulps)) => format!("; t up to {} ulps off, in {regime}", short(ulps as f64)),
        };
        verdicts + &digits + &self.cliff()
    }
}

/// "1 regime", "25 regimes".
fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

/// What to take, and what each choice loses.
pub(crate) fn sentences(measured: &Measured) -> String {
    let mut candidates = candidates(measured);
    candidates.sort_by(|a, b| a.ns().total_cmp(&b.ns()));
    let first = measured.regimes.first().map_or("", |regime| regime.name);
    let mut text = format!("What each loses, by its time in {first}\n");
    let width = candidates.iter().map(|it| it.name().chars().count()).max().unwrap_or(0);
    for candidate in &candidates {
        let ns = three_digits(candidate.ns());
        text += &format!("  {:<width$}  {ns:>5} ns  {}\n", candidate.name(), candidate.loss());
    }
    if candidates.len() < 2 {
        return text;
    }
    text += "\nWhat to take, of these\n";
    // they stand in the order of their times
    let mut line = |when: &str, is_fit: &dyn Fn(&Candidate<'_>) -> bool| {
        let fastest = candidates.iter().find(|candidate| is_fit(candidate));
        text += &format!("  {when:<58}  {}\n", fastest.map_or("none of them".to_string(), Candidate::name));
    };
    line("speed above all", &|_| true);
    line(&format!("nothing but {first}, every verdict right"), &|it| it.first.accuracy.wrong == 0);
    line("every verdict right", &|it| it.never_misjudges());
    for precision in Precision::ALL {
        if measured
            .regimes
            .iter()
            .flat_map(|regime| &regime.entries)
            .any(|entry| entry.precision == precision)
        {
            let when = format!("every verdict right, t within {RIGHT} ulps, {}", precision.name());
            line(&when, &|it| it.is_right() && it.first.precision == precision);
        }
    }
    text
}

fn candidates(measured: &Measured) -> Vec<Candidate<'_>> {
    let Some(first) = measured.regimes.first() else { return Vec::new() };
    let of = |entry| Candidate {
        first: entry,
        all: measured
            .regimes
            .iter()
            .filter_map(|regime| Some((regime.name, same(&regime.entries, entry)?)))
            .collect(),
    };
    first.entries.iter().map(of).collect()
}

/// The entry of the same method at the same precision.
fn same<'a>(entries: &'a [Entry], one: &Entry) -> Option<&'a Entry> {
    entries.iter().find(|entry| (entry.method, entry.precision) == (one.method, one.precision))
}

//! What each remedy loses over all regimes, and what to take.

use stage::Precision;

use lab::table::{short, three_digits};

use crate::measure::{Entry, Measured};

/// One remedy at one precision over all regimes, each entry with the regime's name.
struct Candidate<'a> {
    first: &'a Entry,
    all: Vec<(&'static str, &'a Entry)>,
}

impl Candidate<'_> {
    fn name(&self) -> String {
        name(self.first)
    }

    /// Neither acne nor a leak anywhere.
    fn is_right(&self) -> bool {
        self.all.iter().all(|(_, entry)| entry.faults.all() == 0)
    }

    /// The faults of one kind: in how many regimes there are some, and where they are the most; `None` where
    /// there are none.
    fn most(&self, what: &str, count: impl Fn(&Entry) -> u64) -> Option<String> {
        let share = |entry: &Entry| entry.faults.per_million(count(entry));
        let some: Vec<_> = self.all.iter().filter(|(_, entry)| count(entry) > 0).collect();
        let (regime, entry) = some.iter().max_by(|a, b| share(a.1).total_cmp(&share(b.1)))?;
        let most = match count(entry) == entry.faults.cases {
            true => "every ray".to_string(),
            false => format!("{} per million", short(share(entry))),
        };
        Some(format!("{what} in {} of {}, most in {regime}: {most}", some.len(), self.all.len()))
    }

    fn leaks(&self) -> Option<String> {
        self.most("leaks", |entry| entry.faults.leaks.unwrap_or(0))
    }

    fn acne(&self) -> Option<String> {
        self.most("acne", |entry| entry.faults.acne)
    }

    fn loss(&self) -> String {
        let acne = self.acne();
        format!(
            "{}; {}",
            acne.unwrap_or("no acne".to_string()),
            self.leaks().unwrap_or("no leak".to_string())
        )
    }
}

fn name(entry: &Entry) -> String {
    format!("{} {}", entry.start.name(), entry.precision.name())
}

fn candidates(measured: &[Measured]) -> Vec<Candidate<'_>> {
    let Some(first) = measured.first() else { return Vec::new() };
    let is_same = |one: &Entry, other: &Entry| (one.start, one.precision) == (other.start, other.precision);
    let all = |one: &Entry| {
        let of = |it: &'_ Measured| it.entries.iter().position(|entry| is_same(one, entry));
        measured.iter().filter_map(|it| Some((it.regime.name, &it.entries[of(it)?]))).collect()
    };
    first.entries.iter().map(|entry| Candidate { first: entry, all: all(entry) }).collect()
}

/// For each regime the fastest that is never wrong in it, then what each loses in others, and what that
/// leaves.
pub(super) fn sentences(measured: &[Measured]) -> String {
    let candidates = candidates(measured);
    let mut text = in_one_regime(measured, &candidates);
    if candidates.is_empty() || measured.len() < 2 {
        return text;
    }
    text += &format!("\nWhat each loses over all {} regimes\n", measured.len());
    let width = candidates.iter().map(|it| it.name().chars().count()).max().unwrap_or(0);
    for candidate in &candidates {
        text += &format!("  {:<width$}  {}\n", candidate.name(), candidate.loss());
    }
    text + &format!("\nWhat to take: over all regimes {}\n", over_all(measured, &candidates))
}

/// The fastest without a fault in each regime, at each precision; in brackets what has some elsewhere.
fn in_one_regime(measured: &[Measured], candidates: &[Candidate<'_>]) -> String {
    let mut text = "What to take in one regime alone: the fastest with neither acne nor a leak; in brackets what has some in another\n"
        .to_string();
    let width = measured.iter().map(|it| it.regime.name.chars().count()).max().unwrap_or(0);
    for Measured { regime, entries } in measured {
        let said = Precision::ALL.into_iter().filter_map(|precision| {
            let mut of_precision = entries.iter().filter(|entry| entry.precision == precision).peekable();
            of_precision.peek()?;
            let take = fastest(of_precision).map_or("none of these".to_string(), |it| {
                let said = format!("{}, {} ns", it.start.name(), three_digits(it.ns.median));
                if is_right(candidates, it) { said } else { format!("({said})") }
            });
            Some(format!("{} {take}", precision.name()))
        });
        text += &format!("  {:<width$}  {}\n", regime.name, said.collect::<Vec<_>>().join("; "));
    }
    text
}

/// The fastest of those without a fault.
fn fastest<'a>(entries: impl Iterator<Item = &'a Entry>) -> Option<&'a Entry> {
    entries.filter(|entry| entry.faults.all() == 0).min_by(|a, b| a.ns.median.total_cmp(&b.ns.median))
}

/// Whether a remedy at a precision is right in every regime.
fn is_right(candidates: &[Candidate<'_>], entry: &Entry) -> bool {
    candidates.iter().any(|it| name(it.first) == name(entry) && it.is_right())
}

/// Who is never wrong; and of those who are the one that most regimes by themselves would name.
fn over_all(measured: &[Measured], candidates: &[Candidate<'_>]) -> String {
    let right: Vec<String> = candidates.iter().filter(|it| it.is_right()).map(Candidate::name).collect();
    let said = match &right[..] {
        [] => "none of these is without acne and leaks".to_string(),
        [only] if candidates.len() > 1 => format!("{only} is the only one without acne and leaks"),
        [only] => format!("{only} is without acne and leaks"),
        several => format!("{} are without acne and leaks", several.join(", ")),
    };
    let named: Vec<String> =
        measured.iter().filter_map(|it| Some(name(fastest(it.entries.iter())?))).collect();
    let times = |candidate: &Candidate<'_>| named.iter().filter(|name| **name == candidate.name()).count();
    let wrong = candidates.iter().filter(|it| !it.is_right() && times(it) > 0);
    let tempting = wrong.max_by_key(|it| times(it)).map(|it| {
        let (regimes, name) = (times(it), it.name());
        let faults: Vec<String> = [it.acne(), it.leaks()].into_iter().flatten().collect();
        format!("; {name}, the fastest of the faultless in {regimes} of them, has {}", faults.join(", and "))
    });
    said + &tempting.unwrap_or_default()
}

#[cfg(test)]
mod tests;

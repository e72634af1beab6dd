//! How much is measured, and of what.

use std::time::Duration;

use stage::{Error, TradeAsk};

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Cases of a regime that are judged.
    pub cases: usize,
    /// Cases of a regime that are timed.
    pub timed: usize,
    /// The most rounds of timing.
    pub rounds: usize,
    /// The time for each of the two ways of timing a regime.
    pub allowed: Duration,
}

/// [`Effort::allowed`] with `--quick`: the stages have a dozen regimes or so.
const QUICK: Duration = Duration::from_millis(40);

impl Effort {
    /// What is asked for, half a minute spread over so many regimes. A quick look takes as long at a regime whether it is
    /// asked for alone or with all others.
    pub fn of(ask: &TradeAsk, regimes: usize) -> Effort {
        let share = || Duration::from_secs_f64(30.0 / (2 * regimes.max(1)) as f64);
        let (cases, timed, rounds, allowed) =
            if ask.quick { (500, 8192, 21, QUICK) } else { (20_000, 8192, 201, share()) };
        Effort { cases: ask.cases.unwrap_or(cases), timed, rounds, allowed }
    }
}

/// Those of the regimes that are asked for; all of them where none is named.
///
/// [`Error::Request`] for a name that none of them has.
pub fn asked_for<T>(ask: &TradeAsk, all: Vec<T>, name: impl Fn(&T) -> &'static str) -> Result<Vec<T>, Error> {
    if let Some(unknown) = ask.regimes.iter().find(|asked| all.iter().all(|regime| name(regime) != **asked)) {
        let names: Vec<&str> = all.iter().map(name).collect();
        return Err(Error::Request(format!(
            "there is no regime `{unknown}`; there are {}",
            names.join(", ")
        )));
    }
    let wanted = |regime: &T| ask.regimes.is_empty() || ask.regimes.iter().any(|asked| asked == name(regime));
    Ok(all.into_iter().filter(wanted).collect())
}

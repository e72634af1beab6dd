//! Acne and light leaks by every remedy, judged by what is true of a shape that stands alone, and what they cost.

pub(crate) mod judged;
pub(crate) mod object;
pub(crate) mod regimes;

use std::hint::black_box;

use bounds::{Bounded, Uncounted};
use lab::{Effort, Nanoseconds, Pass, Progress, Runner, asked_for, front, time};
use math::Real;
use stage::{Error, Precision, TradeAsk};

use crate::start::spared;
use crate::{Start, Starts};
use judged::{Case, Faults};
use object::Object;
use regimes::{REGIMES, Regime};

/// What was measured in a scene.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) regime: Regime,
    pub(crate) entries: Vec<Entry>,
}

/// One remedy at one precision.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) start: Start,
    pub(crate) precision: Precision,
    /// Nanoseconds a second ray: where it starts, and what it meets of the shape alone.
    pub(crate) ns: Nanoseconds,
    pub(crate) faults: Faults,
    /// No other is at least as fast here and as right over all regimes that were measured, and better in one of the two.
    pub(crate) on_front: bool,
}

/// Measures in the scenes that are asked for.
///
/// [`Error::Request`] where one is asked for that there is not.
pub(crate) fn measure(ask: &TradeAsk) -> Result<Vec<Measured>, Error> {
    if ask.scene.is_some() {
        let problem = "what is true of a second ray is known of shapes that stand alone only";
        return Err(Error::Request(format!("trade takes no --scene: {problem}; name one with --regime")));
    }
    let regimes = asked_for(ask, REGIMES.to_vec(), |regime| regime.name)?;
    let effort = Effort::of(ask, regimes.len());
    let progress = Progress::new(regimes.len() as u64);
    let mut all = Vec::new();
    for regime in regimes {
        progress.starts(regime.name);
        all.push(in_regime(regime, ask, effort)?);
        progress.done();
    }
    put_on_front(&mut all);
    Ok(all)
}

/// What is fast in one regime and wrong in another is not as right as what is never wrong: the faults that count are those
/// of all regimes together.
fn put_on_front(all: &mut [Measured]) {
    let over_all = |one: &Entry| -> f64 {
        let is_same = |it: &&Entry| (it.start, it.precision) == (one.start, one.precision);
        all.iter().flat_map(|it| &it.entries).filter(is_same).map(|it| it.faults.share()).sum()
    };
    let place = |entry: &Entry| (entry.ns.median, over_all(entry));
    let places: Vec<Vec<_>> = all.iter().map(|it| it.entries.iter().map(place).collect()).collect();
    for (it, places) in all.iter_mut().zip(places) {
        for (entry, on_front) in it.entries.iter_mut().zip(front(&places)) {
            entry.on_front = on_front;
        }
    }
}

fn in_regime(regime: Regime, ask: &TradeAsk, effort: Effort) -> Result<Measured, Error> {
    let mut entries = Vec::new();
    for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
        entries.extend(match precision {
            Precision::F32 => at_precision::<f32>(&regime, precision, ask, effort)?,
            Precision::F64 => at_precision::<f64>(&regime, precision, ask, effort)?,
        });
    }
    Ok(Measured { regime, entries })
}

fn at_precision<R: Real>(
    regime: &Regime,
    precision: Precision,
    ask: &TradeAsk,
    effort: Effort,
) -> Result<Vec<Entry>, Error> {
    let starts = Start::ALL.into_iter().enumerate().filter(|(place, _)| ask.wants_method(*place));
    let starts: Vec<Start> = starts.map(|(_, start)| start).collect();
    let object = Object::<R>::of(regime, ask.seed, precision)?;
    let bounded = Bounded::new(&object.alone, bounds::Method::None);
    let cases = judged::cases(&object, &bounded, effort.cases.max(effort.timed));
    let judged = &cases[..effort.cases.min(cases.len())];
    let faults = starts.iter().map(|&start| judged::judge(&object, &bounded, start, judged));
    let faults: Vec<Faults> = faults.collect();
    let timed = &cases[..effort.timed.min(cases.len())];
    let mut runners: Vec<Runner<'_>> = starts.iter().map(|&start| runner(&bounded, start, timed)).collect();
    let times = time(&mut runners, Pass::Throughput, effort.timed, effort.rounds, effort.allowed);
    let all = starts.into_iter().zip(times).zip(faults);
    Ok(all.map(|((start, ns), faults)| Entry { start, precision, ns, faults, on_front: false }).collect())
}

/// Second rays, from where they start to what they meet. By `bound` as they are used: what is convex and left behind is not
/// tried, see [`spared`].
fn runner<'a, R: Real>(bounded: &'a Bounded<'a, R>, start: Start, cases: &'a [Case<R>]) -> Runner<'a> {
    Box::new(move |_, count| {
        let cases = &cases[..count.min(cases.len())];
        for Case { landing, direction } in cases {
            let parts = bounded.all_parts();
            let (shape, face) = (parts.shape(landing.part), parts.face(landing.part));
            let mut starts = Starts::of(start, bounded.formulas(), shape, face, landing);
            if start == Start::Bound {
                starts.leaves = spared(shape, landing.part);
            }
            black_box(bounded.any_part(&starts.toward(*direction), &mut Uncounted));
        }
        cases.len()
    })
}

#[cfg(test)]
mod tests;

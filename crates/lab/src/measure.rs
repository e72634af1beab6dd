//! Everything that is measured of a subject: regime by regime, every method at every precision.

use math::Real;
use stage::{Error, Precision, Progress, TradeAsk};

use crate::effort::{Effort, asked_for};
use crate::speed::{Nanoseconds, time};
use crate::threads::on_all_threads;
use crate::{Accuracy, Answer, Judgment, Pass, Regime, Runner, Subject, Truth, pareto};

/// All that was measured of a subject.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The stage's name.
    pub stage: &'static str,
    /// The input columns of a case.
    pub columns: &'static [&'static str],
    /// The method whose time is 1.
    pub baseline: &'static str,
    /// The seed of the cases.
    pub seed: u64,
    /// The regimes that were measured in, in the subject's order.
    pub regimes: Vec<MeasuredRegime>,
}

/// What was measured in one regime.
#[derive(Clone, Debug)]
pub struct MeasuredRegime {
    /// Its name.
    pub name: &'static str,
    /// What its cases are.
    pub what: &'static str,
    /// Every method that was asked for at every precision.
    pub entries: Vec<Entry>,
}

/// One method at one precision in one regime.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The method.
    pub method: &'static str,
    /// f32 or f64.
    pub precision: Precision,
    /// Nanoseconds a ray over an array of rays.
    pub throughput: Nanoseconds,
    /// Nanoseconds a ray where one depends on the last.
    pub latency: Nanoseconds,
    /// The throughput in units of the baseline at the same precision.
    pub ratio: f64,
    /// What it gets wrong.
    pub accuracy: Accuracy,
    /// No other is at least as fast and as accurate, and better in one of the two.
    pub on_front: bool,
    /// The case that it gets most wrong; `None` where it is right to the last digit in all.
    pub worst: Option<WorstCase>,
}

/// A case that a method gets wrong.
#[derive(Clone, Debug)]
pub struct WorstCase {
    /// How wrong.
    pub judgment: Judgment,
    /// The case as a row of a case file, in numbers that read back to the same values.
    pub row: String,
    /// What is true of it.
    pub truth: Truth,
}

/// Measures a subject: judges on all threads, and times on this one. That takes up to a minute, or seconds
/// with [`TradeAsk::quick`]; how far it is, a bar on a terminal shows.
///
/// [`Error::Request`] where a regime is asked for that the subject does not have.
pub fn measure<const N: usize>(subject: &impl Subject<N>, ask: &TradeAsk) -> Result<Measured, Error> {
    let about = subject.about();
    let regimes = asked_for(ask, subject.regimes(), |regime| regime.name)?;
    let effort = Effort::of(ask, regimes.len());
    let progress = Progress::new(regimes.len() as u64);
    let mut measured = Vec::new();
    for regime in &regimes {
        progress.starts(regime.name);
        measured.push(measure_regime(subject, regime, ask, effort));
        progress.done();
    }
    Ok(Measured {
        stage: about.name,
        columns: about.inputs,
        baseline: about.methods[subject.baseline()],
        seed: ask.seed,
        regimes: measured,
    })
}

/// Judges and times a regime. The baseline is timed in any case.
fn measure_regime<const N: usize>(
    subject: &impl Subject<N>,
    regime: &Regime<N>,
    ask: &TradeAsk,
    effort: Effort,
) -> MeasuredRegime {
    let methods = subject.about().methods;
    let wanted: Vec<usize> = (0..methods.len()).filter(|method| ask.wants_method(*method)).collect();
    let mut entries = Vec::new();
    let timed = speeds(subject, regime, ask, effort);
    for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
        let accuracies = match precision {
            Precision::F32 => {
                judge_all::<f32, N>(subject, regime, &wanted, precision, ask.seed, effort.cases)
            }
            Precision::F64 => {
                judge_all::<f64, N>(subject, regime, &wanted, precision, ask.seed, effort.cases)
            }
        };
        let speed_of = |method: usize| {
            timed
                .iter()
                .find(|timed| (timed.method, timed.precision) == (method, precision))
                .map(|it| it.speed)
        };
        let baseline = speed_of(subject.baseline()).map_or(f64::NAN, |[throughput, _]| throughput.median);
        for (&method, Judged { accuracy, worst }) in wanted.iter().zip(accuracies) {
            let Some([throughput, latency]) = speed_of(method) else { continue };
            let ratio = throughput.median / baseline;
            let method = methods[method];
            let worst = worst.map(|(judgment, case)| WorstCase {
                judgment,
                row: subject.about().row_of(&case, precision),
                truth: subject.truth(case, precision),
            });
            entries.push(Entry {
                method,
                precision,
                throughput,
                latency,
                ratio,
                accuracy,
                on_front: false,
                worst,
            });
        }
    }
    let points: Vec<(f64, f64)> =
        entries.iter().map(|entry| (entry.throughput.median, entry.accuracy.error())).collect();
    for (entry, on_front) in entries.iter_mut().zip(pareto::front(&points)) {
        entry.on_front = on_front;
    }
    MeasuredRegime { name: regime.name, what: regime.what, entries }
}

/// A method at a precision, and its throughput and latency.
struct Timed {
    method: usize,
    precision: Precision,
    speed: [Nanoseconds; 2],
}

/// Times the methods at the precisions asked for, and the baseline, all in turns.
fn speeds<const N: usize>(
    subject: &impl Subject<N>,
    regime: &Regime<N>,
    ask: &TradeAsk,
    effort: Effort,
) -> Vec<Timed> {
    let wanted = |method: usize| ask.wants_method(method) || method == subject.baseline();
    let singles: Vec<[f32; N]> = cases(regime, ask.seed, Precision::F32, effort.timed);
    let doubles: Vec<[f64; N]> = cases(regime, ask.seed, Precision::F64, effort.timed);
    let mut who = Vec::new();
    let mut runners: Vec<Runner<'_>> = Vec::new();
    for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
        let all = match precision {
            Precision::F32 => subject.runners(&singles),
            Precision::F64 => subject.runners(&doubles),
        };
        for (method, runner) in all.into_iter().enumerate().filter(|(method, _)| wanted(*method)) {
            who.push((method, precision));
            runners.push(runner);
        }
    }
    let [throughput, latency] = [Pass::Throughput, Pass::Latency]
        .map(|pass| time(&mut runners, pass, effort.timed, effort.rounds, effort.allowed));
    let speeds = throughput.into_iter().zip(latency);
    let timed = |((method, precision), (throughput, latency))| Timed {
        method,
        precision,
        speed: [throughput, latency],
    };
    who.into_iter().zip(speeds).map(timed).collect()
}

/// The first cases of a regime in a precision.
fn cases<R: Real, const N: usize>(
    regime: &Regime<N>,
    seed: u64,
    precision: Precision,
    count: usize,
) -> Vec<[R; N]> {
    regime.cases(seed, precision).take(count).map(|case| case.map(R::round_from)).collect()
}

/// How many cases are drawn, then judged on all threads, at a time.
const AT_A_TIME: usize = 1 << 15;
/// Of how many cases the points and normals are judged too: the first of a regime.
pub(crate) const IN_QUALITY: usize = 1 << 14;
/// How many cases one thread takes: fixed, so that sums do not depend on the threads.
const A_SHARE: usize = 1 << 10;

/// What a method gets wrong, and where most.
#[derive(Clone, Debug)]
struct Judged<const N: usize> {
    accuracy: Accuracy,
    worst: Option<(Judgment, [f64; N])>,
}

impl<const N: usize> Default for Judged<N> {
    fn default() -> Self {
        Judged { accuracy: Accuracy::default(), worst: None }
    }
}

impl<const N: usize> Judged<N> {
    fn count(&mut self, case: [f64; N], answer: &Answer, truth: &Truth, precision: Precision) -> Judgment {
        let judgment = self.accuracy.count(answer, truth, precision);
        self.worse((judgment, case));
        judgment
    }

    fn add(&mut self, other: &Judged<N>) {
        self.accuracy.add(&other.accuracy);
        if let Some(worst) = other.worst {
            self.worse(worst);
        }
    }

    /// Keeps the first of the worst.
    fn worse(&mut self, one: (Judgment, [f64; N])) {
        let weight = |judgment: &Judgment| match judgment {
            Judgment::Right => 0,
            Judgment::Off { ulps, .. } => *ulps,
            Judgment::Wrong => u64::MAX,
        };
        if weight(&one.0) > self.worst.map_or(0, |(judgment, _)| weight(&judgment)) {
            self.worst = Some(one);
        }
    }
}

/// Judges methods over the cases of a regime.
fn judge_all<R: Real, const N: usize>(
    subject: &impl Subject<N>,
    regime: &Regime<N>,
    methods: &[usize],
    precision: Precision,
    seed: u64,
    count: usize,
) -> Vec<Judged<N>> {
    let mut source = regime.cases(seed, precision);
    let mut totals = vec![Judged::default(); methods.len()];
    let mut done = 0;
    while done < count {
        let drawn: Vec<[f64; N]> = source.by_ref().take((count - done).min(AT_A_TIME)).collect();
        let starts = (done..).step_by(A_SHARE);
        let shares: Vec<(usize, &[[f64; N]])> = starts.zip(drawn.chunks(A_SHARE)).collect();
        let judged = on_all_threads(&shares, |share| judge_share::<R, N>(subject, methods, precision, share));
        for share in &judged {
            for (total, judged) in totals.iter_mut().zip(share) {
                total.add(judged);
            }
        }
        done += drawn.len();
    }
    totals
}

fn judge_share<R: Real, const N: usize>(
    subject: &impl Subject<N>,
    methods: &[usize],
    precision: Precision,
    &(start, cases): &(usize, &[[f64; N]]),
) -> Vec<Judged<N>> {
    let mut judged = vec![Judged::default(); methods.len()];
    for &case in cases {
        let truth = subject.truth(case, precision);
        for (&method, judged) in methods.iter().zip(&mut judged) {
            let rounded = case.map(R::round_from);
            let judgment = judged.count(case, &subject.answer(method, rounded), &truth, precision);
            if start < IN_QUALITY && matches!(judgment, Judgment::Off { .. }) {
                judged.accuracy.count_quality(subject.quality(method, rounded, &truth));
            }
        }
    }
    judged
}

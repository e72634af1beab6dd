//! How long a method takes, on a machine that does other things too.
//!
//! All that is compared runs in one process and takes turns, round by round, so that whatever else the
//! machine does hurts all alike; the medians over the rounds are compared. Every answer is handed to
//! [`black_box`], so that none can be left out.

use std::hint::black_box;
use std::rc::Rc;
use std::time::{Duration, Instant};

use math::{Real, Vector};

use crate::{Outcome, Pass, Runner};

/// Nanoseconds a ray: the median over the rounds, and the quartiles around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nanoseconds {
    /// A quarter of the rounds were faster.
    pub low: f64,
    /// Half of them were.
    pub median: f64,
    /// A quarter were slower.
    pub high: f64,
}

/// A runner over questions, for a method that answers one at a time. Runners of one precision share theirs.
///
/// For [`Pass::Latency`] the next question is known only when the last t is: it is where it would have been
/// anyway, and the processor cannot know that. (A miss has no t to wait for: it is guessed, like every branch,
/// and what comes next is begun.) Both passes are one loop, so that the compiler puts the method into it.
pub fn runner<'a, Q: 'a, R: Real, V: Vector<R>>(
    questions: &Rc<[Q]>,
    hit: impl Fn(&Q) -> Outcome<R, V> + 'a,
) -> Runner<'a> {
    let questions = Rc::clone(questions);
    Box::new(move |pass, rays| {
        let questions = &questions[..rays.min(questions.len())];
        let none_of_it = black_box(0_u64);
        let mut next = 0;
        for place in 0..questions.len() {
            let outcome = hit(&questions[next]);
            black_box(&outcome);
            next = place + 1;
            if let (Pass::Latency, Ok(Some(hit))) = (pass, outcome) {
                let t: f64 = hit.t.into();
                next = (next + (t.to_bits() & none_of_it) as usize).min(questions.len() - 1);
            }
        }
        questions.len()
    })
}

/// Times runners over at most so many rays each, for about the time allowed: at least three rounds, at most
/// `rounds`. For each runner its figure.
///
/// So many rays that the processor cannot learn by heart which of them hit, as it does with a thousand, and for short
/// methods with four thousand: eight thousand are enough but for a fifth of the time. A runner that would take longer
/// for them than [`LONGEST_PASS`], or than its share of the time allowed, takes fewer, but never less than a few hundred,
/// as far as `rays` allows.
pub fn time(
    runners: &mut [Runner<'_>],
    pass: Pass,
    rays: usize,
    rounds: usize,
    allowed: Duration,
) -> Vec<Nanoseconds> {
    const FEWEST: usize = 3;
    let share_of_time = allowed / (FEWEST * runners.len().max(1)) as u32;
    let longest_pass = share_of_time.min(LONGEST_PASS).as_secs_f64();
    let timed = |runner: &mut Runner<'_>, rays: usize| {
        let start = Instant::now();
        let done = runner(pass, rays);
        start.elapsed().as_secs_f64() / done.max(1) as f64
    };
    // To warm up, and to see who is slow.
    let shares: Vec<usize> = runners
        .iter_mut()
        .map(|runner| {
            let seconds = timed(runner, A_FEW.min(rays));
            ((longest_pass / seconds) as usize).max(A_FEW).min(rays)
        })
        .collect();
    let mut rounds_of: Vec<Vec<f64>> = vec![Vec::new(); runners.len()];
    let start = Instant::now();
    for round in 0..rounds.max(FEWEST) {
        if round >= FEWEST && start.elapsed() > allowed {
            break;
        }
        for ((runner, times), &share) in runners.iter_mut().zip(&mut rounds_of).zip(&shares) {
            times.push(timed(runner, share) * 1e9);
        }
    }
    rounds_of.into_iter().map(Nanoseconds::of).collect()
}

/// How many rays tell whether a runner is slow.
const A_FEW: usize = 256;
/// How long a pass may take, but for a method that takes longer for a few hundred rays.
pub const LONGEST_PASS: Duration = Duration::from_millis(4);

impl Nanoseconds {
    /// The quartiles of some figures, of which there is at least one.
    fn of(mut figures: Vec<f64>) -> Nanoseconds {
        figures.sort_by(f64::total_cmp);
        let at = |share: f64| figures[((figures.len() - 1) as f64 * share).round() as usize];
        Nanoseconds { low: at(0.25), median: at(0.5), high: at(0.75) }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use math::Hit;

    #[test]
    fn quartiles_of_five() {
        let five = Nanoseconds::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!(five, Nanoseconds { low: 2.0, median: 3.0, high: 4.0 });
    }

    /// Both ways ask every question once, in order.
    #[test]
    fn every_question_is_asked_once() {
        let questions: Rc<[f64]> = (0..10).map(f64::from).collect();
        let asked = Cell::new(Vec::new());
        let hit = |&question: &f64| {
            let mut sofar = asked.take();
            sofar.push(question);
            asked.set(sofar);
            let miss = question % 3.0 == 0.0;
            let hit = Hit { t: question, point: glam::DVec3::ZERO, normal: glam::DVec3::ZERO };
            Ok(if miss { None } else { Some(hit) })
        };
        for pass in [Pass::Throughput, Pass::Latency] {
            assert_eq!(runner(&questions, hit)(pass, 20), 10);
            assert_eq!(asked.take(), questions.to_vec(), "{pass:?}");
            assert_eq!(runner(&questions, hit)(pass, 4), 4);
            assert_eq!(asked.take(), questions[..4], "{pass:?}");
        }
    }

    /// A microsecond a ray at least: by hand, three rounds of two runners in 6 ms leave 1 ms for a pass, 1000 rays.
    #[test]
    fn a_slow_runner_takes_fewer_rays() {
        let most = Cell::new(0);
        let slow = || {
            let most = &most;
            let runner: Runner<'_> = Box::new(move |_, rays| {
                let start = Instant::now();
                while start.elapsed() < Duration::from_micros(rays as u64) {}
                most.set(most.get().max(rays));
                rays
            });
            runner
        };
        let most_within = |allowed| {
            most.set(0);
            time(&mut [slow(), slow()], Pass::Throughput, 100_000, 3, allowed);
            most.get()
        };
        assert!((A_FEW..=1000).contains(&most_within(Duration::from_millis(6))));
        assert!((A_FEW..=4000).contains(&most_within(Duration::MAX)), "the longest pass");
        assert_eq!(most_within(Duration::ZERO), A_FEW);
    }

    #[test]
    fn runners_take_turns() {
        let turns = Cell::new(String::new());
        let turn = |name: char| {
            let turns = &turns;
            let runner: Runner<'_> = Box::new(move |_, rays| {
                turns.set(turns.take() + &name.to_string());
                rays
            });
            runner
        };
        let mut runners = [turn('a'), turn('b')];
        let figures = time(&mut runners, Pass::Throughput, 1, 4, Duration::MAX);
        assert_eq!((figures.len(), turns.take().as_str()), (2, "ababababab"), "one to warm up, then four");
    }
}

//! Turn by turn, so that whatever else the machine does hurts all alike.

use std::hint::black_box;
use std::sync::LazyLock;
use std::time::Instant;

/// Runs all in turns; the median seconds of each.
pub(crate) fn medians(rounds: usize, runs: &mut [&mut dyn FnMut() -> usize]) -> Vec<f64> {
    let mut seconds = vec![Vec::new(); runs.len()];
    for _ in 0..rounds {
        for (run, seconds) in runs.iter_mut().zip(&mut seconds) {
            let start = on_processor();
            black_box(run());
            seconds.push(on_processor() - start);
        }
    }
    seconds.iter_mut().map(|seconds| median(seconds)).collect()
}

/// Seconds that this thread has had a processor for, as Linux counts them; elsewhere seconds on the clock.
fn on_processor() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let counted = || {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    };
    counted().map_or_else(|| START.elapsed().as_secs_f64(), |nanoseconds| 1e-9 * nanoseconds)
}

fn median(of: &mut [f64]) -> f64 {
    of.sort_by(f64::total_cmp);
    of[of.len() / 2]
}

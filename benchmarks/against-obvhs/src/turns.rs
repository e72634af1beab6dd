//! Turn by turn, so that whatever else the machine does hurts all alike.

use std::hint::black_box;

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
    seconds.iter_mut().map(median).collect()
}

/// Seconds that this thread has had a processor for.
pub(crate) fn on_processor() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split_whitespace().next().and_then(|n| n.parse::<f64>().ok()).unwrap_or(0.0) * 1e-9
}

fn median(of: &mut Vec<f64>) -> f64 {
    of.sort_by(f64::total_cmp);
    of[of.len() / 2]
}

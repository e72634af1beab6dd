//! All threads at once.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::thread::ScopedJoinHandle;

/// What becomes of every item, in their order; the work is spread over all threads. A panic in one of
/// them is a panic here.
pub(crate) fn on_all_threads<T: Sync, U: Send>(items: &[T], work: impl Fn(&T) -> U + Sync) -> Vec<U> {
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get);
    let (work, share) = (&work, items.len().div_ceil(threads).max(1));
    std::thread::scope(|scope| {
        let start = |items| scope.spawn(move || -> Vec<U> { <[T]>::iter(items).map(work).collect() });
        let workers: Vec<_> = items.chunks(share).map(start).collect();
        let finish =
            |worker: ScopedJoinHandle<'_, Vec<U>>| worker.join().unwrap_or_else(|panic| resume_unwind(panic));
        workers.into_iter().flat_map(finish).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_come_in_the_order_of_the_items() {
        for count in [0, 1, 7, 1000] {
            let items: Vec<usize> = (0..count).collect();
            let doubled: Vec<usize> = items.iter().map(|item| 2 * item).collect();
            assert_eq!(on_all_threads(&items, |item| 2 * item), doubled);
        }
    }

    #[test]
    #[should_panic(expected = "the seventh")]
    fn a_panic_is_handed_on() {
        on_all_threads(&[6, 7, 8], |item| assert_ne!(*item, 7, "the seventh"));
    }
}

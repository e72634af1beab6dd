//! All threads at once.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::thread::{Builder, available_parallelism, scope};

/// What becomes of every item, in their order; the work is spread over all threads. Where a thread cannot be had its
/// share is done by this one. A panic in one of them is a panic here.
pub fn on_all_threads<T: Sync, U: Send>(items: &[T], work: impl Fn(&T) -> U + Sync) -> Vec<U> {
    let threads = available_parallelism().map_or(1, NonZero::get);
    let share = items.len().div_ceil(threads).max(1);
    let all_of = |items: &[T]| -> Vec<U> { items.iter().map(&work).collect() };
    let all_of = &all_of;
    scope(|scope| {
        let start = |items| (items, Builder::new().spawn_scoped(scope, move || all_of(items)));
        let started: Vec<_> = items.chunks(share).map(start).collect();
        let finished = started.into_iter().map(|(items, thread)| match thread {
            Ok(thread) => thread.join().unwrap_or_else(|panic| resume_unwind(panic)),
            Err(_) => all_of(items),
        });
        finished.flatten().collect()
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

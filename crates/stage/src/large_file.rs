//! A file that grows larger than a file may be is an error like any other.

/// From here on a write beyond what `ulimit -f` allows fails, and can be told and cleaned up after, where
/// it would have ended the program at once (SIGXFSZ).
///
/// It holds for this thread and those that it starts from here on, and for programs that it starts as well: a
/// program that starts others which are not to know should do without.
pub fn large_files_are_errors() {
    hold_back();
}

/// Holds the signal back: the write fails in any case. Where that cannot be arranged, all is as before.
#[cfg(unix)]
fn hold_back() {
    use nix::sys::signal::{SigSet, Signal};

    let _ = SigSet::from(Signal::SIGXFSZ).thread_block();
}

/// Elsewhere there is no such signal.
#[cfg(not(unix))]
fn hold_back() {}

//! How far the work is: a bar where standard error is a terminal, nothing elsewhere.

use std::borrow::Cow;
use std::io::{self, IsTerminal};
use std::sync::Once;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is done sooner shows no bar: it would only flicker.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar over steps that are alike, such as the regimes of a measurement or the tiles of a picture.
pub struct Progress {
    bar: ProgressBar,
    /// Since when the bar waits to be shown, where it does.
    waits: Option<Instant>,
    appears: Once,
}

impl Progress {
    /// A bar of so many steps, there at once.
    pub fn new(steps: u64) -> Progress {
        let on_terminal = io::stderr().is_terminal();
        let target = if on_terminal { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        Progress { bar: bar(steps, target), waits: None, appears: Once::new() }
    }

    /// A bar with a name, which appears when the work has taken half a second.
    pub fn patient(steps: u64, name: impl Into<Cow<'static, str>>) -> Progress {
        let bar = bar(steps, ProgressDrawTarget::hidden());
        bar.set_message(name);
        Progress { bar, waits: io::stderr().is_terminal().then(Instant::now), appears: Once::new() }
    }

    /// Names the step that begins.
    pub fn starts(&self, name: impl Into<Cow<'static, str>>) {
        self.bar.set_message(name);
        self.bar.tick();
    }

    /// One step is done.
    pub fn done(&self) {
        if self.waits.is_some_and(|since| !self.appears.is_completed() && since.elapsed() > PATIENCE) {
            self.appears.call_once(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
        self.bar.inc(1);
    }
}

/// A bar of so many steps, nameless so far.
fn bar(steps: u64, target: ProgressDrawTarget) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(steps), target);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}, {eta} left") {
        bar.set_style(style);
    }
    bar
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

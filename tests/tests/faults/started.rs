//! Runs that something happens to before they end.

use std::path::Path;
use std::process::{Child, Command, ExitStatus};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tests::Run;

use crate::command::command;
use crate::files::Files;

/// Signals are what they are by themselves, even where the tests run under nohup.
const OWN_SIGNALS: [&str; 2] = ["env", "--default-signal=HUP,INT,TERM"];

/// A run that has not ended.
pub(crate) struct Started(Child);

impl Started {
    /// Starts `NAME ARGS…` in a folder.
    pub(crate) fn new(folder: &Path, args: &[&str]) -> Started {
        Started(command(folder, &OWN_SIGNALS, args).spawn().expect("the program can be started"))
    }

    /// Waits until it is in the middle of its work: it has been at it for that long, and goes on.
    pub(crate) fn work_for(&mut self, time: Duration) {
        sleep(time);
        assert!(self.is_running(), "the work was done before anything happened");
    }

    /// Waits until it is in the middle of a file that it writes into `folder`.
    pub(crate) fn write_into(&mut self, folder: &Path) {
        let started = Instant::now();
        let half_written = || {
            let files = Files::in_folder(folder);
            files.names().any(|name| name.ends_with(".part") && !files.content(name).is_empty())
        };
        while !half_written() {
            assert!(self.is_running() && started.elapsed() < Duration::from_secs(60), "no file was begun");
            sleep(Duration::from_millis(1));
        }
    }

    /// Whether it has not ended.
    pub(crate) fn is_running(&mut self) -> bool {
        self.0.try_wait().expect("it can be asked").is_none()
    }

    /// Sends it a signal.
    pub(crate) fn signal(&self, name: &str) {
        // it may have ended
        let kill = format!("kill -{name} {} 2> /dev/null || true", self.0.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().expect("there is a shell").success());
    }

    /// How it ended, be it by a signal. What it says is read: it may be more than a pipe holds.
    pub(crate) fn ended(self) -> ExitStatus {
        self.0.wait_with_output().expect("it ends").status
    }

    /// How it ended by itself, and what it said.
    pub(crate) fn run(self) -> Run {
        Run::of(self.0.wait_with_output().expect("it ends"))
    }
}

//! Runs a program that may do anything, for so long and no longer, and reads so much and no more. What it
//! starts ends with it, and it ends with us.

use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use wait_timeout::ChildExt;

/// How a program ended.
#[derive(Debug)]
pub(crate) struct Ended {
    /// `None` where it had to be stopped.
    pub(crate) status: Option<ExitStatus>,
    /// The first of what it wrote.
    pub(crate) stdout: Vec<u8>,
    /// The first of what it said.
    pub(crate) stderr: Vec<u8>,
}

impl Ended {
    /// Whether it ended by itself and well.
    pub(crate) fn well(&self) -> bool {
        self.status.is_some_and(|status| status.success())
    }
}

/// When a program is stopped before it ends.
pub(crate) struct Patience<'a> {
    /// So long it may take.
    pub(crate) wall: Duration,
    /// So much of standard output is read; whoever writes more loses the reader. Of 0, it goes nowhere.
    pub(crate) stdout: u64,
    /// The same for standard error.
    pub(crate) stderr: u64,
    /// Asked some twenty times a second: whether it is too much.
    pub(crate) too_much: &'a dyn Fn() -> bool,
}

/// Whoever holds a pipe when the program has ended, a process that it left behind, is not waited for longer
/// than this.
const GRACE: Duration = Duration::from_secs(1);
const GLANCE: Duration = Duration::from_millis(50);

/// Runs a command with nothing to read. `Err` where it cannot be started, or where there is no thread to read what it
/// writes; then it is ended.
pub(crate) fn watch(command: &mut Command, patience: &Patience) -> io::Result<Ended> {
    // what nobody reads goes nowhere: a program would stumble over a pipe that is closed
    let pipe = |most: u64| if most == 0 { Stdio::null() } else { Stdio::piped() };
    command.stdin(Stdio::null()).stdout(pipe(patience.stdout)).stderr(pipe(patience.stderr));
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    let child = command.spawn()?;
    let leash = Leash::on(&child);
    watch_child(child, leash, patience)
}

fn watch_child(mut child: Child, leash: Leash, patience: &Patience) -> io::Result<Ended> {
    let stdout = child.stdout.take().map(|pipe| first(pipe, patience.stdout)).transpose();
    let stderr = child.stderr.take().map(|pipe| first(pipe, patience.stderr)).transpose();
    let (stdout, stderr) = match (stdout, stderr) {
        (Ok(stdout), Ok(stderr)) => (stdout, stderr),
        (Err(error), _) | (_, Err(error)) => {
            let _ = child.kill();
            let _ = child.wait();
            return Err(error);
        }
    };
    let until = Instant::now() + patience.wall;
    let status = loop {
        let left = until.saturating_duration_since(Instant::now());
        let ended = child.wait_timeout(left.min(GLANCE));
        match ended {
            Ok(Some(status)) => break Some(status),
            Ok(None) if !left.is_zero() && !(patience.too_much)() => {}
            _ => {
                let _ = child.kill();
                let _ = child.wait();
                break None;
            }
        }
    };
    drop(leash);
    Ok(Ended { status, stdout: all_of(stdout), stderr: all_of(stderr) })
}

/// Ends what is left of a child's process group when it is dropped, and also when this program ends in any
/// way, Ctrl-C included: a shell waits at the end of a pipe that nobody writes to.
struct Leash(Option<Child>);

impl Leash {
    fn on(child: &Child) -> Leash {
        #[cfg(unix)]
        {
            let mut shell = Command::new("sh");
            shell.args(["-c", "read -r end; kill -s KILL -- \"-$1\"", "sh"]).arg(child.id().to_string());
            shell.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null());
            // Ctrl-C in a terminal is for us, not for the shell
            std::os::unix::process::CommandExt::process_group(&mut shell, 0);
            Leash(shell.spawn().ok())
        }
        #[cfg(not(unix))]
        {
            let _ = child;
            Leash(None)
        }
    }
}

impl Drop for Leash {
    fn drop(&mut self) {
        if let Some(shell) = &mut self.0 {
            drop(shell.stdin.take());
            let _ = shell.wait();
        }
    }
}

/// Reads the first `most` bytes on a thread of its own, piece by piece. Then the pipe is closed, so that
/// nobody who writes on waits for a reader.
fn first(pipe: impl Read + Send + 'static, most: u64) -> io::Result<Receiver<Vec<u8>>> {
    let (sender, receiver) = channel();
    thread::Builder::new().spawn(move || {
        let mut pipe = pipe.take(most);
        let mut piece = vec![0; 1 << 16];
        while let Ok(count @ 1..) = pipe.read(&mut piece) {
            if sender.send(piece[..count].to_vec()).is_err() {
                break;
            }
        }
    })?;
    Ok(receiver)
}

fn all_of(receiver: Option<Receiver<Vec<u8>>>) -> Vec<u8> {
    let until = Instant::now() + GRACE;
    let next = |receiver: &Receiver<Vec<u8>>| {
        receiver.recv_timeout(until.saturating_duration_since(Instant::now())).ok()
    };
    let pieces = receiver.map(|receiver| std::iter::from_fn(|| next(&receiver)).flatten().collect());
    pieces.unwrap_or_default()
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn sh(script: &str, wall: u64, most: u64) -> Ended {
        let wall = Duration::from_millis(wall);
        let patience = Patience { wall, stdout: most, stderr: most, too_much: &|| false };
        watch(Command::new("sh").args(["-c", script]), &patience).unwrap()
    }

    #[test]
    fn what_ends_is_read_whole() {
        let ended = sh("echo one; echo two >&2; exit 3", 5000, 100);
        assert_eq!(ended.status.unwrap().code(), Some(3));
        assert_eq!((ended.stdout.as_slice(), ended.stderr.as_slice()), (&b"one\n"[..], &b"two\n"[..]));
    }

    #[test]
    fn what_does_not_end_is_stopped_and_what_it_wrote_is_kept() {
        let began = Instant::now();
        let ended = sh("echo one; exec sleep 60", 200, 100);
        assert!(ended.status.is_none() && began.elapsed() < Duration::from_secs(20));
        assert_eq!(ended.stdout, b"one\n");
    }

    #[test]
    fn what_writes_without_end_is_cut() {
        let began = Instant::now();
        let ended = sh("exec yes", 20_000, 1000);
        assert!(began.elapsed() < Duration::from_secs(15), "it lost its reader, and ended");
        assert_eq!(ended.stdout.len(), 1000);
    }

    #[test]
    fn what_is_left_behind_is_not_waited_for() {
        let began = Instant::now();
        let ended = sh("sleep 20 & echo one", 10_000, 100);
        assert!(ended.well() && began.elapsed() < Duration::from_secs(10));
        assert_eq!(ended.stdout, b"one\n");
    }

    /// Whoever is left behind would touch a file a second later.
    #[test]
    fn what_it_started_ends_with_it() {
        let folder = tempfile::tempdir().unwrap();
        let touch = |name: &str| format!("{{ sleep 1; echo > '{}'; }} &", folder.path().join(name).display());
        let stopped = sh(&format!("{} wait", touch("stopped")), 300, 100);
        let ended = sh(&format!("{} echo one", touch("ended")), 10_000, 100);
        thread::sleep(Duration::from_secs(2));
        assert!(stopped.status.is_none() && !folder.path().join("stopped").exists(), "it was stopped");
        assert!(ended.well() && !folder.path().join("ended").exists(), "it ended by itself");
    }
}

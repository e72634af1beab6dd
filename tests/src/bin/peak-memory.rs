//! `peak-memory FILE PROGRAM [ARGS…]` runs a program, writes into FILE how many bytes of memory it had at
//! most at a time, and ends as it did.
//!
//! The kernel keeps that figure for whoever waited for a program, and does not forget a peak that was over
//! in a moment. It counts what has been touched: pages of the program itself too, and not what was only
//! promised, as most of a thread's stack. It is the largest among all that a process has waited for, which
//! is why each program is given one of its own.

use std::process::ExitCode;

fn main() -> ExitCode {
    match measured() {
        Ok(status) => ExitCode::from(status),
        Err(cause) => {
            eprintln!("error: {cause}");
            ExitCode::from(2)
        }
    }
}

/// Runs the program; its exit status.
#[cfg(target_os = "linux")]
fn measured() -> Result<u8, Box<dyn std::error::Error>> {
    use nix::sys::resource::{UsageWho, getrusage};
    use std::process::Command;

    let mut words = std::env::args_os().skip(1);
    let file = words.next().ok_or("name a file for the figure")?;
    let program = words.next().ok_or("name a program")?;
    let ended = Command::new(program).args(words).status()?;
    // Linux counts in units of 1024 bytes
    let peak = getrusage(UsageWho::RUSAGE_CHILDREN)?.max_rss() * 1024;
    std::fs::write(file, peak.to_string())?;
    let status = ended.code().ok_or_else(|| format!("the program was ended by a signal: {ended}"))?;
    Ok(u8::try_from(status)?)
}

/// Elsewhere the figure has other units, or there is none.
#[cfg(not(target_os = "linux"))]
fn measured() -> Result<u8, Box<dyn std::error::Error>> {
    Err("memory is measured on Linux only".into())
}

//! Ctrl-C in the middle of a file.

#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio, exit};
use std::time::Duration;

/// Where the program that is interrupted writes its file; set for that program alone.
const FILE: &str = "STAGE_TEST_INTERRUPTED";

/// What the interrupted program says when half of its file is written.
const HALF: &str = "half of it";

/// The program that is interrupted: this very test once more, which never finishes its file.
fn write_half_and_wait(path: &Path) -> ! {
    stage::clean_up_when_interrupted();
    let _ = stage::write_whole(path, |file| {
        file.write_all(b"half of the ne")?;
        file.flush()?;
        println!("{HALF}");
        std::thread::sleep(Duration::from_secs(60));
        Ok(())
    });
    exit(1)
}

/// Whether the tests run under nohup, as Linux tells it: then so would the program, and would not listen.
fn under_nohup() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    // the last digit is of the signals 1 to 4, and SIGHUP is 1
    ignored.is_some_and(|mask| mask.trim().ends_with(['1', '3', '5', '7', '9', 'b', 'd', 'f']))
}

#[test]
fn an_interrupted_program_leaves_the_old_file_and_nothing_else() {
    if let Some(path) = std::env::var_os(FILE) {
        write_half_and_wait(path.as_ref());
    }
    if under_nohup() {
        return;
    }
    let folder = std::env::temp_dir().join(format!("stage-interrupted-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.txt");
    for signal in ["INT", "TERM", "HUP"] {
        fs::write(&path, "old").unwrap();
        let mut program = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "an_interrupted_program_leaves_the_old_file_and_nothing_else", "--nocapture"])
            .env(FILE, &path)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let said = BufReader::new(program.stdout.take().unwrap());
        assert!(said.lines().any(|line| line.unwrap().ends_with(HALF)));
        let count = || fs::read_dir(&folder).unwrap().count();
        assert_eq!(count(), 2, "the old file, and half of the new one");

        let kill = format!("kill -{signal} {}", program.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        assert_eq!(program.wait().unwrap().code(), Some(130), "{signal}");
        assert_eq!((count(), fs::read_to_string(&path).unwrap().as_str()), (1, "old"), "{signal}");
    }
    fs::remove_dir_all(folder).unwrap();
}

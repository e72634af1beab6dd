//! Signals in the middle of the work, and in the middle of a file.
//!
//! What asks a program to end (INT, TERM, HUP) leaves what was there before and nothing else. What does not
//! ask (KILL) may leave a hidden file, `.PID-N.part`, and the folder of a hand-out that was not ready,
//! `.hand-out-…`.

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::time::Duration;

use tests::Folder;

use crate::command::{DRAWINGS, HAND_OUT, PAGES, WHOLE_GALLERY, Writer, run};
use crate::files::{Files, OLD};
use crate::started::Started;

/// Those that ask, and the one that does not.
const SIGNALS: [&str; 4] = ["INT", "TERM", "HUP", "KILL"];

/// When something that takes longer than anybody waits is in the middle of its work.
const MIDDLE: Duration = Duration::from_millis(100);

/// A picture that takes longer than anybody waits.
const SLOW: [&str; 7] = ["whitted", "--samples", "64", "--size", "1600x1200", "--out", "picture.png"];

/// It ended by that signal: 130 where it could be told.
fn assert_ended_by(started: Started, signal: &str) {
    let ended = started.ended();
    match signal {
        "KILL" => assert_eq!(ended.signal(), Some(9)),
        _ => assert_eq!(ended.code(), Some(130), "{signal}: {ended}"),
    }
}

/// A signal comes when `middle` says: the file that is written last is the old one. The next run is not
/// disturbed by what is left.
fn assert_old_stays(quick: &Writer, slow: &[&str], last: &str, middle: impl Fn(&mut Started, &Path)) {
    for signal in SIGNALS {
        let folder = quick.folder_of_old_files();
        let mut started = Started::new(folder.path(), slow);
        middle(&mut started, folder.path());
        started.signal(signal);
        assert_ended_by(started, signal);
        let left = Files::in_folder(folder.path());
        left.assert_whole(signal == "KILL");
        assert_eq!(left.content(last), OLD.as_bytes(), "{signal} {quick:?}");

        let again = run(folder.path(), &quick.args());
        assert_eq!(again.status, 0, "{signal}: {again:?}");
        let new = Files::in_folder(folder.path());
        assert!(quick.files.names().all(|name| new.content(name) == quick.files.content(name)), "{signal}");
        assert!(signal == "KILL" || new == quick.files, "{signal}: {:?}", new.names().collect::<Vec<_>>());
    }
}

#[test]
fn in_the_middle_of_a_picture() {
    let quick = Writer::new(&["whitted", "--size", "64x48", "--out", "picture.png"]);
    assert_old_stays(&quick, &SLOW, "picture.png", |started, _| started.work_for(MIDDLE));
}

#[test]
fn in_the_middle_of_a_file() {
    let quick = Writer::new(&["ray-sphere", "--size", "32x24", "--out", "p.png", "--inspect", "page.html"]);
    let slow = ["ray-sphere", "--size", "640x480", "--out", "p.png", "--inspect", "page.html"];
    assert_old_stays(&quick, &slow, "page.html", |started, folder| started.write_into(folder));
}

#[test]
fn in_the_middle_of_a_measurement() {
    for signal in SIGNALS {
        let folder = Folder::new();
        folder.put("measured-trade.svg", OLD);
        let mut started = Started::new(folder.path(), &["ray-sphere", "trade", "--out", "measured.png"]);
        started.work_for(MIDDLE);
        started.signal(signal);
        assert_ended_by(started, signal);
        assert_eq!(folder.names(), ["measured-trade.svg"], "{signal}");
        assert_eq!(Files::in_folder(folder.path()).content("measured-trade.svg"), OLD.as_bytes());
    }
}

/// Signals at many moments of a run, whatever it does then: each file is the old one or the new one.
fn assert_whole_at_any_time(writer: &Writer, each: Duration, most: u32) {
    for signal in SIGNALS {
        for moment in 0..most {
            let folder = writer.folder_of_old_files();
            let started = Started::new(folder.path(), &writer.args());
            std::thread::sleep(each * moment);
            started.signal(signal);
            let ended = started.ended();
            let left = Files::in_folder(folder.path());
            left.assert_whole(signal == "KILL");
            for name in writer.files.names() {
                assert!(!left.content(name).is_empty(), "{writer:?}, {signal} at {moment}: {name} is gone");
            }
            if ended.success() {
                break;
            }
        }
    }
}

#[test]
fn at_any_time_of_a_gallery_or_a_picture() {
    let picture = Writer::new(&["ray-sphere", "--size", "640x480", "--out", "picture.png"]);
    assert_whole_at_any_time(&picture, Duration::from_millis(15), 8);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn at_any_time_of_all_that_is_written() {
    let large = Writer::new(&["ray-plane", "--size", "2000x1500", "--out", "picture.png"]);
    assert_whole_at_any_time(&large, Duration::from_millis(30), 25);
    assert_whole_at_any_time(&WHOLE_GALLERY, Duration::from_millis(700), 10);
    PAGES.iter().for_each(|page| assert_whole_at_any_time(page, Duration::from_millis(60), 10));
    DRAWINGS.iter().for_each(|drawing| assert_whole_at_any_time(drawing, Duration::from_millis(70), 4));
}

#[test]
fn a_hand_out_is_whole_or_not_there() {
    for signal in SIGNALS {
        for moment in 0..8 {
            let folder = Folder::new();
            let started = Started::new(folder.path(), &HAND_OUT.args());
            std::thread::sleep(Duration::from_millis(20) * moment);
            started.signal(signal);
            let ended = started.ended();
            let left = folder.names();
            let shown = || Files::in_folder(&folder.path().join("attempt"));
            let all = Files::in_folder(folder.path());
            match signal {
                "KILL" => {
                    assert!(shown().count() == 0 || shown().count() == HAND_OUT.files.count(), "{left:?}")
                }
                _ => assert!(all == Files::none() || all == HAND_OUT.files, "{signal}: {left:?}"),
            }
            if ended.success() {
                break;
            }
        }
    }
}

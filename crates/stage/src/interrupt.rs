//! An interrupted program leaves no half-written file behind.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The exit status of a program that was interrupted: 128 and the number of the signal, 2.
const INTERRUPTED: i32 = 130;

/// The files that this program has begun.
pub(crate) static UNFINISHED: UnfinishedFiles = UnfinishedFiles(Mutex::new(BTreeSet::new()));

/// From here on Ctrl-C, and what else asks the program to end (SIGTERM, SIGHUP), removes the files that are
/// not finished and ends it with status 130.
///
/// Where that cannot be arranged, and under nohup, the program works as before: an interrupt may then leave a
/// hidden `.part` file.
pub fn clean_up_when_interrupted() {
    // Under nohup a hangup is to be survived, and the handler is not told which signal it was.
    if !hangup_is_ignored(&fs::read_to_string("/proc/self/status").unwrap_or_default()) {
        when_interrupted(end);
    }
}

#[cfg(not(target_family = "wasm"))]
fn when_interrupted(end: fn()) {
    let _ = ctrlc::set_handler(end);
}

/// A page in a browser is not interrupted.
#[cfg(target_family = "wasm")]
fn when_interrupted(_: fn()) {}

/// Removes what is not finished, and ends the program.
fn end() {
    // Held to the end: nothing is begun after the others are removed, and nobody finds theirs missing.
    let mut places = UNFINISHED.places();
    remove_all(&mut places);
    std::process::exit(INTERRUPTED);
}

/// Whether the status of a process, as Linux tells it, has SIGHUP, number 1, among the signals it ignores.
fn hangup_is_ignored(status: &str) -> bool {
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 1)
}

/// Files that are not finished, by their places.
pub(crate) struct UnfinishedFiles(Mutex<BTreeSet<PathBuf>>);

impl UnfinishedFiles {
    /// Makes a folder, and knows it from the first as one that is to be removed with all that is in it.
    fn begin_folder(&self, make: impl FnOnce() -> io::Result<PathBuf>) -> io::Result<Unfinished<'_>> {
        let mut places = self.places();
        let place = make()?;
        places.insert(place.clone());
        Ok(Unfinished { place, among: self })
    }

    /// Makes an empty file that is known to be unfinished from the first, so that no interrupt comes in
    /// between. What is there already is somebody else's, and an error.
    pub(crate) fn begin(&self, place: PathBuf) -> io::Result<(Unfinished<'_>, File)> {
        let mut places = self.places();
        let file = File::create_new(&place)?;
        places.insert(place.clone());
        Ok((Unfinished { place, among: self }, file))
    }

    fn places(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        // A set of names is whole whatever became of the thread that had it.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A file that is not finished; dropped, it is removed.
pub(crate) struct Unfinished<'a> {
    place: PathBuf,
    among: &'a UnfinishedFiles,
}

impl Unfinished<'_> {
    /// Gives the file, which is complete, its name, in one step. Where that fails it is removed.
    pub(crate) fn finish(self, name: &Path) -> io::Result<()> {
        let mut places = self.among.places();
        fs::rename(&self.place, name)?;
        places.remove(&self.place);
        Ok(())
    }

    /// Removes the file.
    pub(crate) fn discard(self) -> io::Result<()> {
        let mut places = self.among.places();
        fs::remove_file(&self.place)?;
        places.remove(&self.place);
        Ok(())
    }
}

impl Drop for Unfinished<'_> {
    fn drop(&mut self) {
        let mut places = self.among.places();
        if places.remove(&self.place) {
            remove(&self.place);
        }
    }
}

/// Removes the files at all these places.
fn remove_all(places: &mut BTreeSet<PathBuf>) {
    for place in std::mem::take(places) {
        remove(&place);
    }
}

/// Removes a file, or a folder with all that is in it. It may be gone already; and what cannot be removed
/// cannot be helped.
fn remove(place: &Path) {
    if fs::remove_file(place).is_err() {
        // while another thread writes into the folder it is not empty at the end; soon nobody will
        let _ = (0..10).find(|_| fs::remove_dir_all(place).is_ok() || !place.exists());
    }
}

/// A folder for what is needed until the program ends: dropped, or where the program is interrupted, it is
/// removed with all that is in it.
pub struct Scratch(Unfinished<'static>);

impl Scratch {
    /// The folder that `make` makes and names. The error is that of `make`.
    pub fn new(make: impl FnOnce() -> io::Result<PathBuf>) -> io::Result<Scratch> {
        UNFINISHED.begin_folder(make).map(Scratch)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0.place
    }

    /// Writes into the folder, or moves what is ready out of it, by `does`, which begins no other file: an interrupt comes
    /// before it or after it. Else the folder might be made again by whoever writes when it is just removed, or be on its
    /// way out meanwhile, and arrive in part.
    pub fn uninterrupted<T>(&self, does: impl FnOnce() -> T) -> T {
        let _places = self.0.among.places();
        does()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An empty folder, and nothing unfinished in it.
    fn folder(name: &str) -> (PathBuf, UnfinishedFiles) {
        let folder = std::env::temp_dir().join(format!("interrupt-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        (folder, UnfinishedFiles(Mutex::default()))
    }

    #[test]
    fn an_interrupt_removes_what_is_unfinished_and_nothing_else() {
        let (folder, files) = folder("all");
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| folder.join(name));
        let (finished, _) = files.begin(a.clone()).unwrap();
        let (discarded, _) = files.begin(b.clone()).unwrap();
        let (dropped, _) = files.begin(c).unwrap();
        let (unfinished, _) = files.begin(d.clone()).unwrap();
        finished.finish(&folder.join("whole")).unwrap();
        discarded.discard().unwrap();
        drop(dropped);
        assert_eq!(*files.places(), BTreeSet::from([d.clone()]));
        // what has one of the names now is another's
        fs::write(&a, "").unwrap();
        fs::write(&b, "").unwrap();
        remove_all(&mut files.places());
        drop(unfinished);
        assert!(!d.exists() && a.exists() && b.exists() && folder.join("whole").exists());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_scratch_folder_goes_with_all_that_is_in_it() {
        let (folder, files) = folder("scratch");
        for interrupted in [false, true] {
            let place = folder.join("scratch");
            let scratch =
                files.begin_folder(|| fs::create_dir_all(place.join("a/b")).map(|()| place.clone())).unwrap();
            fs::write(place.join("a/b/c"), "").unwrap();
            if interrupted {
                remove_all(&mut files.places());
            }
            drop(scratch);
            assert!(!place.exists(), "interrupted: {interrupted}");
        }
        fs::remove_dir_all(folder).unwrap();
    }

    /// [`end`] removes nothing while somebody writes, and holds the list for ever after.
    #[test]
    fn no_interrupt_comes_while_a_scratch_folder_is_written_to() {
        let place = std::env::temp_dir().join(format!("interrupt-written-{}", std::process::id()));
        let scratch = Scratch::new(|| fs::create_dir_all(&place).map(|()| place.clone())).unwrap();
        scratch.uninterrupted(|| assert!(UNFINISHED.0.try_lock().is_err()));
    }

    #[test]
    fn what_cannot_be_begun_or_finished_is_not_kept() {
        let (folder, files) = folder("failed");
        assert!(files.begin(folder.join("nowhere/a")).is_err());
        fs::write(folder.join("b"), "another's").unwrap();
        assert!(files.begin(folder.join("b")).is_err());
        fs::remove_file(folder.join("b")).unwrap();
        let (file, _) = files.begin(folder.join("a")).unwrap();
        assert!(file.finish(&folder.join("nowhere/a")).is_err());
        assert_eq!((files.places().len(), fs::read_dir(&folder).unwrap().count()), (0, 0));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn nohup_is_told_from_the_status() {
        // bit 0 is signal 1
        assert!(hangup_is_ignored("Name:\tstage\nSigBlk:\t0000000000000000\nSigIgn:\t0000000000001001\n"));
        assert!(!hangup_is_ignored("SigBlk:\t0000000000000001\nSigIgn:\t0000000000001000\n"));
        assert!(!hangup_is_ignored(""));
    }
}

//! Faults that a machine has, and what a command leaves behind: the old file or the new one, whole.
//!
//! They are real: a file system that is full, a folder that may not be written to or is gone, limits of the
//! system, signals, a second run at the same time; and memory as the kernel counts it. What takes long is
//! ignored, and run in `.ci/full`. Rooms with such a disk need bubblewrap: where it is missing those tests
//! are skipped with a word, but not where `FAULTS=required` is set.

#![cfg(target_os = "linux")]

mod at_once;
mod command;
mod files;
mod full_disk;
mod limits;
mod memory;
mod read_only;
mod room;
mod signals;
mod started;
mod vanished;

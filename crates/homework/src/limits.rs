//! How much an attempt may take.

use std::ffi::OsString;
use std::time::Duration;

/// What the sandbox gives, and no more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    /// Of a processor, for each process: it is the same however busy the machine is.
    pub(crate) cpu: Duration,
    /// By the clock, for what waits in place of computing.
    pub(crate) wall: Duration,
    /// Bytes of memory that a process has for itself; with its program and what it shares, half as much
    /// again.
    pub(crate) memory: u64,
    /// Processes and threads at a time.
    pub(crate) processes: u32,
    /// Files that a process has open at a time.
    pub(crate) open_files: u32,
    /// Bytes of one file.
    pub(crate) file: u64,
    /// Bytes of all files together.
    pub(crate) disk: u64,
    /// Files and folders together.
    pub(crate) names: u32,
    /// Bytes of standard output that are read.
    pub(crate) output: u64,
}

/// Of standard error this much is read: what a compiler has to say to a person is shorter.
pub(crate) const MOST_SAID: u64 = 1 << 18;
/// Answers are shorter: a few hundred lines.
pub(crate) const MOST_ANSWERED: u64 = 1 << 20;

const MIB: u64 = 1 << 20;

/// What comes along with an exercise is built once, before anybody waits: of it nothing is hostile.
pub(crate) const BASE: Limits = Limits {
    cpu: Duration::from_secs(600),
    wall: Duration::from_secs(3600),
    memory: 3072 * MIB,
    processes: 128,
    open_files: 1024,
    file: 512 * MIB,
    disk: 1024 * MIB,
    names: 50_000,
    output: 1024 * MIB,
};

/// Compiling a student's files takes two or three seconds, and 300 MB.
pub(crate) const COMPILE: Limits = Limits {
    cpu: Duration::from_secs(40),
    wall: Duration::from_secs(240),
    memory: 1536 * MIB,
    processes: 64,
    open_files: 512,
    file: 256 * MIB,
    disk: 512 * MIB,
    names: 50_000,
    output: 64 * MIB,
};

/// All cases of an exercise take some milliseconds, and next to no memory. Whatever an attempt does, all its
/// processes together have 1.5 GiB: the address space of one, so many times.
pub(crate) const RUN: Limits = Limits {
    cpu: Duration::from_secs(5),
    wall: Duration::from_secs(20),
    memory: 128 * MIB,
    processes: 8,
    open_files: 64,
    file: 4 * MIB,
    disk: 16 * MIB,
    names: 1000,
    output: MOST_ANSWERED,
};

/// So many processes more there may be: those of the script, which can go on when an attempt has taken all of
/// its own.
const OURS: u32 = 4;

impl Limits {
    /// `prlimit` with what it sets for the command that follows.
    pub(crate) fn prlimit(&self) -> Vec<OsString> {
        let Limits { cpu, memory, processes, open_files, file, .. } = self;
        let cpu = cpu.as_secs();
        let limits = [
            // whoever does not go when asked has one second more
            format!("--cpu={cpu}:{}", cpu + 1),
            format!("--as={}", memory / 2 * 3),
            format!("--data={memory}"),
            format!("--nproc={}", processes + OURS),
            format!("--nofile={open_files}"),
            format!("--fsize={file}"),
            "--core=0".to_string(),
            "--msgqueue=0".to_string(),
            "--memlock=0".to_string(),
            "--rtprio=0".to_string(),
        ];
        let command = ["prlimit".to_string()].into_iter().chain(limits).chain(["--".to_string()]);
        command.map(OsString::from).collect()
    }

    /// The options of a file system in memory that holds so much.
    pub(crate) fn tmpfs(&self) -> String {
        format!("size={},nr_inodes={},mode=777,nosuid,nodev", self.disk, self.names)
    }
}

//! A room without windows: what runs in it sees the system's programs and what it is shown, writes into
//! memory that is limited in size and in number of files, knows no network and no other process, and goes
//! when its time is over.
//!
//! It is made by [bubblewrap](https://github.com/containers/bubblewrap) in two steps, for only whoever may
//! mount can limit the number of files:
//!
//! 1. The first `bwrap` shows the system and what belongs to the attempt, each thing read-only, mounts the
//!    limited memory at `/work`, and gives its rights away. A superuser becomes nobody there, since no limit
//!    on processes holds for a superuser.
//! 2. The second one leaves the other name spaces (users, processes, network, …), may not make new ones, has
//!    no capability left, and can write nowhere but into `/work`.
//!
//! The first one also has name spaces of its own for shared memory, of which it allows none, and for
//! processes: ended, it takes all of them along, and it ends with us. (The second one does not end with the
//! first: where it may not make new name spaces, `bwrap` 0.8 forgets `--die-with-parent`.)

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use stage::Error;

use crate::limits::{Limits, MOST_SAID, RUN};
use crate::process::{Ended, Patience, watch};

/// A sandbox that was tried.
#[derive(Debug)]
pub(crate) struct Sandbox {
    /// The folders of the system, as they are here.
    system: Vec<OsString>,
    /// What is shown nowhere, though it may lie in a folder that is shown.
    hidden: Vec<PathBuf>,
    /// Whether we are the superuser.
    superuser: bool,
}

/// A file or folder of ours and the path at which it is shown.
pub(crate) type Shown<'a> = (&'a Path, &'a str);

impl Sandbox {
    /// The sandbox of this machine, tried. Where a `hidden` folder lies in one that is shown, as a checkout
    /// below `/usr/src` does, an empty one is in its place. [`Error::Failed`] says why there is no sandbox,
    /// and what would help.
    pub(crate) fn find(hidden: &[PathBuf]) -> Result<Sandbox, Error> {
        // the folder belongs to whoever we are
        let superuser = Command::new("id").arg("-u").output().is_ok_and(|it| it.stdout == b"0\n");
        let mut hidden: Vec<PathBuf> = hidden.iter().filter_map(|path| path.canonicalize().ok()).collect();
        hidden.retain(|path| path.is_dir());
        let sandbox = Sandbox { system: system(), hidden, superuser };
        let tried = sandbox.run(&RUN, &[], "echo within");
        let why = match tried {
            Ok(ended) if ended.well() && ended.stdout == b"within\n" => return Ok(sandbox),
            Ok(ended) => {
                let said = String::from_utf8_lossy(&ended.stderr);
                said.lines().last().map_or("it does not answer".to_string(), String::from)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                "bwrap is not installed (package bubblewrap)".to_string()
            }
            Err(error) => format!("bwrap: {error}"),
        };
        Err(Error::Failed(format!("there is no sandbox here: {why}\n{REMEDY}")))
    }

    /// Runs a script of the shell within limits, with so many bytes of its standard output. `Err` where it
    /// cannot be started.
    pub(crate) fn run(&self, limits: &Limits, shown: &[Shown], script: &str) -> io::Result<Ended> {
        let patience =
            Patience { wall: limits.wall, stdout: limits.output, stderr: MOST_SAID, too_much: &|| false };
        watch(&mut self.command(limits, shown, script), &patience)
    }

    fn command(&self, limits: &Limits, shown: &[Shown], script: &str) -> Command {
        let mut first = words(
            "bwrap --unshare-pid --unshare-ipc --die-with-parent --new-session --clearenv \
             --setenv PATH /usr/bin:/bin",
        );
        if !self.superuser {
            first.extend(words("--unshare-user --uid 0 --gid 0 --cap-drop ALL"));
            // to mount, and to make a name space for users in which its own user 0 is somebody
            first.extend(words("--cap-add CAP_SYS_ADMIN --cap-add CAP_SETFCAP"));
        }
        first.extend(self.system.iter().cloned());
        for (ours, path) in shown {
            first.extend(["--ro-bind".into(), ours.as_os_str().into(), path.into()]);
        }
        let system = SYSTEM.map(|path| (Path::new(path), path));
        for cover in covers(&self.hidden, system.iter().chain(shown)) {
            first.extend(words("--perms 0755 --tmpfs").into_iter().chain([cover.clone().into()]));
            first.extend(["--remount-ro".into(), cover.into()]);
        }
        // bwrap needs a /tmp for itself; /proc has to be seen whole for another one to be mounted
        first.extend(words(
            "--bind /proc /proc --dev-bind /dev /dev --dir /work --dir /tmp --remount-ro / --",
        ));
        first.extend(["sh".into(), "-c".into(), MOUNT.into(), "sh".into(), limits.tmpfs().into()]);
        if self.superuser {
            first.extend(words("setpriv --reuid=65534 --regid=65534 --clear-groups"));
        }

        let mut second = words(
            "bwrap --unshare-user --disable-userns --unshare-pid --unshare-net --unshare-uts \
             --unshare-cgroup-try --die-with-parent --new-session --clearenv --cap-drop ALL \
             --uid 1000 --gid 1000 --hostname sandbox --chdir /work --setenv HOME /work \
             --setenv PATH /toolchain/bin:/usr/bin:/bin",
        );
        second.extend(self.system.iter().cloned());
        for (_, path) in shown {
            second.extend(["--ro-bind".into(), path.into(), path.into()]);
        }
        second
            .extend(words("--proc /proc --dev /dev --bind /work /work --remount-ro /dev --remount-ro / --"));
        second.extend(limits.prlimit());
        second.extend(["sh".into(), "-c".into(), script.into()]);

        let mut command = Command::new(&first[0]);
        command.args(&first[1..]).args(second).current_dir("/");
        command
    }

    /// Lets whoever is in the sandbox read a folder of ours: a superuser's files may be for the superuser
    /// only.
    pub(crate) fn share(&self, folder: &Path) -> io::Result<()> {
        let done = Command::new("chmod").args(["-R", "a+rX"]).arg(folder).status()?;
        if done.success() { Ok(()) } else { Err(io::Error::other("chmod failed")) }
    }
}

const REMEDY: &str = "\
It takes Linux 5.19 or newer, bubblewrap 0.8 or newer, and util-linux. Where something is not permitted, name
spaces are switched off for users: see sysctl kernel.apparmor_restrict_unprivileged_userns and
user.max_user_namespaces, and for a container --security-opt. Where each submission has a machine of its own
that is thrown away, --unsandboxed does without: then a submission can do all that you can.";

/// Mounts the limited memory, the options being the first argument, and goes on with the others. Shared
/// memory of the old kind and queues of messages belong to no process, so no limit of one holds for them:
/// there are none.
const MOUNT: &str = "mount -t tmpfs -o \"$1\" none /work && echo 0 > /proc/sys/kernel/shmmni && \
                     echo 0 > /proc/sys/kernel/msgmni && shift && exec \"$@\"";

fn words(text: &str) -> Vec<OsString> {
    text.split_whitespace().map(OsString::from).collect()
}

/// What of the system is shown.
const SYSTEM: [&str; 7] = ["/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"];

/// Where the hidden folders would be seen, the outermost of each; what is shown as a whole is meant to be.
fn covers<'a>(hidden: &[PathBuf], shown: impl Iterator<Item = &'a Shown<'a>>) -> Vec<PathBuf> {
    let mut covers = Vec::new();
    for (ours, path) in shown {
        // a link is shown as a link
        let folder = !fs::symlink_metadata(ours).is_ok_and(|it| it.is_symlink());
        let ours = ours.canonicalize().ok().filter(|_| folder);
        let within = |it: &PathBuf| it.strip_prefix(ours.as_ref()?).ok().map(Path::to_path_buf);
        let within = hidden.iter().filter_map(within).filter(|it| !it.as_os_str().is_empty());
        covers.extend(within.map(|it| Path::new(path).join(it)));
    }
    covers.sort();
    covers.dedup_by(|inner, outer| inner.starts_with(outer));
    covers
}

/// The folders of the system that programs need, as arguments of bwrap; what is a link here is a link there.
fn system() -> Vec<OsString> {
    let mut arguments = Vec::new();
    for path in SYSTEM {
        match (fs::read_link(path), Path::new(path).is_dir()) {
            (Ok(target), _) => arguments.extend(["--symlink".into(), target.into(), path.into()]),
            (Err(_), true) => arguments.extend(["--ro-bind".into(), path.into(), path.into()]),
            (Err(_), false) => {}
        }
    }
    // which of several programs a name means, and where libraries are; nothing else of /etc
    for path in ["/etc/alternatives", "/etc/ld.so.cache"].map(PathBuf::from) {
        if path.exists() {
            arguments.extend(words("--perms 0755 --dir /etc"));
            arguments.extend(["--ro-bind".into(), path.clone().into(), path.into()]);
        }
    }
    arguments
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a script says in the sandbox; `None`, and a word, where there is none.
    fn says(script: &str) -> Option<String> {
        says_without(&[], script)
    }

    fn says_without(hidden: &[PathBuf], script: &str) -> Option<String> {
        match Sandbox::find(hidden) {
            Ok(sandbox) => {
                let ended = sandbox.run(&RUN, &[], script).unwrap();
                Some(String::from_utf8_lossy(&ended.stdout).trim().to_string())
            }
            Err(error) => {
                eprintln!("skipped: {error}");
                None
            }
        }
    }

    #[test]
    fn it_shows_nothing_of_ours() {
        let Some(seen) = says("ls -d /*/ | tr '\\n' ' '") else {
            return;
        };
        let here = env!("CARGO_MANIFEST_DIR").split('/').nth(1).unwrap();
        assert!(here == "work" || !seen.contains(&format!("/{here}/")) || here == "tmp", "{seen}");
        assert!(!seen.contains("/root/ ") && !seen.contains("/home/ "), "{seen}");
    }

    #[test]
    fn what_is_hidden_in_what_is_shown_is_an_empty_folder() {
        let hidden = ["/usr/share", "/usr/share/doc", "/usr/lib/no such folder"].map(PathBuf::from);
        let script =
            "ls -A /usr/share | wc -l; echo x 2>/dev/null >/usr/share/x || echo closed; ls /usr | wc -l";
        let Some(said) = says_without(&hidden, script) else { return };
        let lines: Vec<&str> = said.lines().collect();
        assert!(lines[..2] == ["0", "closed"] && lines[2] != "0", "{said}");
    }

    #[test]
    fn a_folder_is_covered_wherever_it_would_be_seen() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().canonicalize().unwrap();
        let [secret, inner, toolchain, other] =
            ["a/secret", "a/secret/inner", "a/toolchain", "b"].map(|name| folder.join(name));
        for path in [&inner, &toolchain, &other] {
            fs::create_dir_all(path).unwrap();
        }
        let hidden = [inner.clone(), secret.clone(), folder.clone()];
        let (a, shown) = (folder.join("a"), |path| Path::new("/usr").join(path));
        let seen: [Shown; 3] = [(&a, "/usr"), (&toolchain, "/toolchain"), (&other, "/other")];
        // what is shown from within a hidden folder is meant to be
        assert_eq!(covers(&hidden, seen.iter()), [shown("secret")]);
        assert!(covers(&[], seen.iter()).is_empty());
    }

    #[test]
    fn it_has_no_rights_and_cannot_get_any() {
        let script = "grep -E 'Cap(Eff|Prm|Bnd|Amb)|NoNewPrivs' /proc/self/status | tr -d '\\t\\n'; \
                      unshare -U true 2>/dev/null || echo; echo no-new-users";
        let Some(said) = says(script) else { return };
        assert!(said.starts_with("CapPrm:0000000000000000CapEff:0000000000000000"), "{said}");
        assert!(said.contains("NoNewPrivs:1") && said.ends_with("no-new-users"), "{said}");
    }

    #[test]
    fn it_has_no_network() {
        let Some(said) =
            says("tail -n +3 /proc/net/dev | cut -d: -f1 | tr -d ' '; cat /proc/net/route | wc -l")
        else {
            return;
        };
        assert!(said == "lo\n1" || said == "1", "{said}");
    }

    #[test]
    fn it_can_write_so_much_and_so_many_and_nowhere_else() {
        let script = "for place in / /usr /tmp /dev /dev/shm /etc /proc/sys/kernel/hostname; do \
                      (echo x > $place/x) 2>/dev/null && echo wrote $place; done; \
                      i=0; while [ $i -lt 2000 ] && echo x 2>/dev/null > /work/$i; do i=$((i+1)); done; \
                      echo $i; rm -f /work/*; \
                      for i in 1 2 3 4 5 6 7 8; do head -c 4000000 /dev/zero > /work/$i; done 2>/dev/null; \
                      du -s /work | cut -f1";
        let Some(said) = says(script) else { return };
        let numbers: Vec<u64> = said.lines().filter_map(|line| line.parse().ok()).collect();
        assert_eq!(said.lines().count(), 2, "{said}");
        assert!(numbers[0] < u64::from(RUN.names) && numbers[1] * 1024 <= RUN.disk, "{said}");
    }
}

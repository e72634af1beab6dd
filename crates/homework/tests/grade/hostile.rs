//! Who wants to break out, to see what the others wrote, or to bring the machine down. In `.ci/full`.

use std::fs;
use std::net::TcpListener;
use std::path::Path;
use std::process::Command;

use crate::class::{Class, quoted};

/// Says what came of something that may fail, so that the report shows it.
fn tell(what: &str) -> String {
    format!("panic!(\"{{:?}}\", {what});")
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn nobody_reads_what_is_not_theirs() {
    let class = Class::new();
    let secret = class.right("victim").join("src/secret.rs");
    fs::write(&secret, "// the victim's own idea").unwrap();
    let checkout = Path::new(env!("CARGO_MANIFEST_DIR"));
    let reference =
        checkout.join("../../chapters/04-ray-sphere/src/closest_approach.rs").canonicalize().unwrap();
    let cargo = Path::new(env!("CARGO")).to_path_buf();
    for (name, path) in [("passwd", Path::new("/etc/passwd")), ("secret", &secret), ("reference", &reference)]
    {
        class.that(&format!("runs {name}"), &tell(&format!("std::fs::read_to_string({})", quoted(path))));
        class.with_items(
            &format!("builds {name}"),
            &format!("const _: &str = include_str!({});", quoted(path)),
        );
    }
    class.that("environment", &tell("std::env::vars().collect::<Vec<_>>()"));
    class.that("lists root", &tell("std::fs::read_dir(\"/root\").map(|it| it.count())"));
    class.that(
        "processes",
        "let all = std::fs::read_dir(\"/proc\").unwrap().flatten(); \
         let all: Vec<_> = all.filter_map(|it| \
         std::fs::read_to_string(it.path().join(\"cmdline\")).ok()).collect(); \
         panic!(\"{all:?}\");",
    );
    class.with_items(
        "builds environ",
        "const _: &[u8] = include_bytes!(\"/proc/self/environ\"); const _: u8 = 256;",
    );
    class.with_items("builds up", "#[path = \"../../../../../../etc/passwd\"] mod up;");
    class.that("builds cases", "let text = include_str!(\"../expected.txt\"); panic!(\"{}\", text.len());");

    let Some(grades) = class.grades() else { return };
    for name in ["runs passwd", "runs secret", "runs reference"] {
        grades.says(name, 0, "wrong", "NotFound");
    }
    for name in ["builds passwd", "builds secret", "builds reference", "builds up"] {
        grades.says(name, 0, "does not compile", "couldn't read");
        assert!(!grades.said(name).contains("root:"), "{}", grades.said(name));
    }
    grades.says("lists root", 0, "wrong", "NotFound");
    let environment = grades.said("environment");
    assert!(environment.contains("\"HOME\", \"/work\"") && !environment.contains("CARGO"), "{environment}");
    assert!(!environment.contains(cargo.to_str().unwrap()));
    let processes = grades.said("processes");
    assert!(processes.contains("--probe") && !processes.contains("cargo"), "{processes}");
    grades.says("builds environ", 0, "does not compile", "literal out of range");
    // what is shown to the student is all there is
    let shown = grades.said("builds cases");
    assert!(shown.contains("a panic at"), "{shown}");
    grades.says("victim", 9, "right", "");

    // without the sandbox they do read: the attack is one
    let class = Class::new();
    class.that("runs passwd", &tell("std::fs::read_to_string(\"/etc/passwd\").map(|it| it.len())"));
    let grades = class.graded(true).unwrap();
    grades.says("runs passwd", 0, "wrong", "Ok(");
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn nobody_reaches_out() {
    let class = Class::new();
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    let here = format!("std::net::TcpStream::connect((\"127.0.0.1\", {port})).is_ok()");
    class.that("calls us", &tell(&here));
    class.that("calls far", &tell("std::net::TcpStream::connect(\"1.1.1.1:53\").map_err(|it| it.kind())"));
    class.that(
        "asks for names",
        &tell(
            "std::net::UdpSocket::bind(\"0.0.0.0:0\").and_then(|it| it.send_to(b\"x\", \
            \"8.8.8.8:53\")).is_ok()",
        ),
    );
    let outside = class.path("outside");
    let places = [
        "/x",
        "/usr/x",
        "/tmp/x",
        "/dev/x",
        "/dev/shm/x",
        "/program",
        "/cases.txt",
        "/proc/sys/kernel/hostname",
    ];
    let places = places.iter().map(|it| it.to_string()).chain([outside.display().to_string()]);
    let places: Vec<String> = places.collect();
    class.that(
        "writes",
        &format!(
            "let all: Vec<_> = {places:?}.iter().filter(|it| std::fs::write(it, \"x\").is_ok()).collect(); \
                  panic!(\"wrote {{all:?}}\");"
        ),
    );
    let own = "std::process::Command::new(\"unshare\").args([\"-Urm\", \"mount\", \"-t\", \"tmpfs\", \
        \"none\", \"/work\"])";
    class.that("mounts", &tell(&format!("{own}.status().unwrap().success()")));

    let Some(grades) = class.grades() else { return };
    grades.says("calls us", 0, "wrong", "false");
    grades.says("calls far", 0, "wrong", "Err(NetworkUnreachable)");
    grades.says("asks for names", 0, "wrong", "false");
    grades.says("writes", 0, "wrong", "wrote []");
    grades.says("mounts", 0, "wrong", "false");
    assert!(!outside.exists());

    let class = Class::new();
    class.that("calls us", &tell(&here));
    class.graded(true).unwrap().says("calls us", 0, "wrong", "true");
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn nobody_takes_more_than_a_share() {
    let class = Class::new();
    class.right("neighbor");
    class.that(
        "forks",
        "let mut count = 0; while std::process::Command::new(\"sleep\").arg(\"77123\").spawn().is_ok() { \
            count += 1; } \
         panic!(\"forked {count}\");",
    );
    class.that(
        "fork bomb",
        "let _ = std::process::Command::new(\"sh\").args([\"-c\", \"b() { b | b & }; b; b\"]).status(); \
            loop {}",
    );
    class.that(
        "threads",
        "let mut count = 0; while std::thread::Builder::new().spawn(|| loop { std::thread::park() \
            }).is_ok() { count += 1 } \
         panic!(\"threads {count}\");",
    );
    class.that(
        "hoards",
        "let mut all: Vec<Vec<u8>> = Vec::new(); let mut size = 0u64; \
         loop { let mut more = Vec::new(); if more.try_reserve_exact(1 << 20).is_err() { break } \
         more.resize(1 << 20, 1); all.push(more); size += 1; } drop(all); panic!(\"hoarded {size} MB\");",
    );
    class.that(
        "hoards blindly",
        "let mut all = vec![1u8]; loop { let more = all.clone(); all.extend(more); }",
    );
    class.that(
        "recurses",
        "fn deep(n: u64) -> u64 { let a = std::hint::black_box([n; 99]); deep(n + 1) + a[7] } deep(0);",
    );
    class.that("shouts", "loop { println!(\"{}\", \"a\".repeat(100_000)); }");
    class.that(
        "fills the disk",
        "use std::io::Write; let mut bytes = 0; 'all: for name in 0.. { \
         let Ok(mut file) = std::fs::File::create(format!(\"/work/{name}\")) else { break }; \
         loop { match file.write(&[1; 65536]) { Ok(0) => break 'all, Ok(count) => bytes += count, Err(_) => \
         break } \
         if bytes % (4 << 20) == 0 { break } } if bytes == 0 || name > 5000 { break } } \
         panic!(\"filled {} MB\", bytes >> 20);",
    );
    class.that(
        "fills one file",
        "use std::io::Write; let mut file = std::fs::File::create(\"/work/one\").unwrap(); let mut bytes = \
            0usize; \
         while let Ok(count) = file.write(&[1; 65536]) { bytes += count; } panic!(\"wrote {} MB\", bytes >> \
         20);",
    );
    class.that(
        "opens files",
        "let mut all = Vec::new(); while let Ok(file) = std::fs::File::open(\"/program\") { all.push(file); \
            } \
         let count = all.len(); drop(all); panic!(\"opened {count}\");",
    );
    class.that(
        "shares memory",
        &tell(
            "std::process::Command::new(\"ipcmk\").args([\"-M\", \"1000000\"]).status().unwrap().success()",
        ),
    );
    class.that(
        "answers without end",
        "std::fs::write(\"answers\", \"step\\tx\\n\".repeat(1 << 20)).unwrap();",
    );

    let Some(grades) = class.grades() else { return };
    grades.says("neighbor", 9, "right", "");
    let number = |name: &str, before: &str| -> u64 {
        let said = grades.said(name);
        let rest = said.split(before).nth(1).unwrap_or_else(|| panic!("{name}: {said}"));
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        digits.parse().unwrap()
    };
    assert!(number("forks", "forked ") < 8, "{}", grades.said("forks"));
    assert!(number("threads", "threads ") < 8, "{}", grades.said("threads"));
    assert!((40..128).contains(&number("hoards", "hoarded ")), "{}", grades.said("hoards"));
    assert!(number("fills the disk", "filled ") <= 16, "{}", grades.said("fills the disk"));
    assert!(number("opens files", "opened ") < 64, "{}", grades.said("opens files"));
    for (name, word) in [
        ("fork bomb", "computed for 5 seconds"),
        ("hoards blindly", "aborted"),
        ("recurses", "aborted"),
        ("shouts", "computed for 5 seconds"),
        ("fills one file", "wrote too much"),
    ] {
        grades.says(name, 0, "wrong", word);
    }
    assert!(grades.said("shares memory").contains(": false"), "{}", grades.said("shares memory"));
    assert_eq!(grades.of("answers without end")["status"], "wrong");
    assert!(!running("77123"), "a process is left");
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn nobody_outlives_the_end_or_ends_the_others() {
    let class = Class::new();
    class.right("neighbor");
    class.that("ends well", "std::process::exit(0);");
    let sh = |script: &str| format!("std::process::Command::new(\"sh\").args([\"-c\", {script:?}])");
    class.that(
        "leaves something",
        &format!("{}.spawn().unwrap(); std::process::exit(0);", sh("sleep 77124 & sleep 77124")),
    );
    class.that(
        "detaches",
        &format!(
            "{}.spawn().unwrap(); std::process::exit(0);",
            sh("setsid sh -c 'trap \"\" TERM HUP; sleep 77125' &")
        ),
    );
    class.that("kills all", &format!("let _ = {}.status(); loop {{}}", sh("kill -KILL -1")));
    class.that(
        "kills its parent",
        &format!("let _ = {}.status(); loop {{}}", sh("kill -KILL $(ps -o ppid= -p $PPID) 1")),
    );
    // it can only write what it knows: what it was shown
    class.that(
        "forges",
        "let shown = include_str!(\"../expected.txt\"); let (mut text, mut row) = (String::new(), 0); \
         for line in shown.lines() { if line.starts_with(\"case\") { text += &format!(\"case\\t{row}\\n\"); \
         row += 1; } \
         if line.starts_with(\"step\") { text += line; text += \"\\n\"; } } \
         std::fs::write(\"answers\", text).unwrap(); std::process::exit(0);",
    );
    class.that(
        "says it is right",
        "std::fs::write(\"answers\", \"case\\t0\\nstep\\tu_r\\tD\\tvector\\tNaN NaN NaN\\t1e300 1e300 \
            1e300\\n\").unwrap(); \
         std::process::exit(0);",
    );
    // the compiler
    class.with_items(
        "counts at compile time",
        "const N: u64 = { let mut n = 0u64; while n < u64::MAX { n += 1; } n }; \
        #[allow(long_running_const_eval)] pub fn n() -> u64 { N }",
    );
    class.with_items(
        "counts silently",
        "#[allow(long_running_const_eval)] const N: u64 = { let mut n = 0u64; \
        while n < u64::MAX { n += 1; } n }; pub fn n() -> u64 { N }",
    );
    class.with("doubles macros", |solution| {
        format!(
            "#![recursion_limit = \"9999\"]\n{solution}\nmacro_rules! d {{ ($($x:tt)*) => {{ d!($($x)* \
            $($x)*); }} }} d!(a);\n"
        )
    });
    class.with_items(
        "doubles types",
        "struct D<T>(T); trait T1 { fn go(self); } \
        impl<T> T1 for D<T> { fn go(self) { D(D((self.0, 1))).go() } } pub fn go() { D(1).go() }",
    );
    class.that(
        "is larger than what is read",
        "static L: [u8; 80 << 20] = [1; 80 << 20]; std::hint::black_box(&L);",
    );
    class.with_items("is large", "pub static LARGE: [u8; 1 << 33] = [1; 1 << 33];");
    let nested = class.right("nested name").join("src/probe.rs");
    fs::create_dir(&nested).unwrap();
    fs::write(nested.join("a.rs"), "").unwrap();

    let Some(grades) = class.grades() else { return };
    grades.says("neighbor", 9, "right", "");
    grades.says("ends well", 0, "wrong", "the program ended before it answered");
    for name in ["leaves something", "detaches"] {
        grades.says(name, 0, "wrong", "the program ended before it answered");
    }
    for name in ["kills all", "kills its parent"] {
        assert_eq!((&grades.of(name)["score"], &grades.of(name)["status"]), (&0.into(), &"wrong".into()));
    }
    // the first of each case is not enough, except where there is only one
    let forged = grades.of("forges");
    let earned = forged["score"].as_u64().unwrap();
    assert!(earned <= 1, "{forged:#}");
    assert_eq!(grades.of("says it is right")["score"], 0);
    for name in ["counts at compile time", "doubles macros", "doubles types", "counts silently", "is large"] {
        let it = grades.of(name);
        assert_eq!(it["score"], 0, "{it:#}");
        assert!(it["status"] == "refused" || it["status"] == "does not compile", "{it:#}");
    }
    grades.says("counts silently", 0, "refused", "compiling it was stopped when it had taken 40 seconds");
    // and not the compiler's own last words, which differ from run to run
    grades.says("doubles macros", 0, "refused", "the compiler crashed over it");
    grades.says("is larger than what is read", 0, "refused", "more than 64 MiB");
    grades.says("nested name", 0, "refused", "it cannot be put in place");
    for marked in ["77124", "77125"] {
        assert!(!running(marked), "a process is left");
    }
}

/// Whether a process with this argument is there.
fn running(argument: &str) -> bool {
    let found = Command::new("pgrep").args(["-f", &format!("^sleep {argument}")]).output().unwrap();
    found.status.success()
}

use std::sync::Mutex;

mod own_flags;

use super::*;
use crate::{Case, Drawing, Row, Sheet, Shown, Traded};

/// A stage that remembers what it was asked to measure.
#[derive(Default)]
struct Fake {
    asked: Mutex<Option<TradeAsk>>,
}

impl Fake {
    /// Answers a command line: what is printed, how it ends, and what was asked.
    fn answer(&self, words: &[&str]) -> (String, Result<(), Error>, Option<TradeAsk>) {
        let mut output = Vec::new();
        let done = self.answer_on(words, &mut output);
        (String::from_utf8(output).unwrap(), done, self.asked.lock().unwrap().take())
    }

    fn answer_on(&self, words: &[&str], output: &mut dyn Write) -> Result<(), Error> {
        let words = ["fake"].iter().chain(words);
        serve(self, &command(&self.about()).try_get_matches_from(words).unwrap(), output)
    }
}

impl Stage for Fake {
    fn about(&self) -> About {
        About {
            number: 1,
            name: "fake",
            teaches: "",
            notes: "",
            methods: vec!["notes", "robust"],
            size: (2, 2),
            picture: "",
            inputs: &["x"],
            flags: &[],
            words: &[],
            results: &[],
            trade: "",
            regimes: vec![("ordinary", "as usual"), ("far", "far away")],
        }
    }

    fn show(&self, _: &Ask) -> Result<Shown, Error> {
        panic!("nobody asks for a picture")
    }

    fn eval(&self, _: &Ask, _: &Case<'_>) -> Result<Row, Error> {
        panic!("nobody asks about a case")
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        *self.asked.lock().unwrap() = Some(ask.clone());
        let drawing = |ending| Drawing { ending, sheet: Sheet::Svg("<svg/>".to_string()) };
        let drawings = ["trade.svg", "map.svg"].map(drawing).to_vec();
        Ok(Traded { text: "the numbers\n".to_string(), records: Vec::new(), drawings })
    }
}

/// An empty folder, and the picture in it that `--out` names.
fn folder(name: &str) -> (PathBuf, String) {
    let folder = std::env::temp_dir().join(format!("stage-command-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let picture = folder.join("picture.png").display().to_string();
    (folder, picture)
}

#[test]
fn the_command_line_is_well_formed() {
    command(&Fake::default().about()).debug_assert();
}

#[test]
fn what_trade_is_not_told_is_all() {
    let (folder, out) = folder("all");
    let (_, done, asked) = Fake::default().answer(&["trade", "--out", &out]);
    done.unwrap();
    let all = TradeAsk {
        method: None,
        precision: None,
        regimes: Vec::new(),
        cases: None,
        seed: TRADE_SEED,
        quick: false,
        scene: None,
    };
    assert_eq!(asked, Some(all));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn flags_of_trade_stand_before_or_after_the_verb() {
    let (folder, out) = folder("flags");
    let fake = Fake::default();
    let flags = ["--method", "notes", "--precision", "f64", "--format", "json", "--out", &out];
    let [before, after] = [[&flags[..], &["trade"]], [&["trade"], &flags[..]]].map(|words| {
        let (said, done, asked) = fake.answer(&words.concat());
        done.unwrap();
        (said, asked.unwrap())
    });
    assert_eq!(before, after);
    let (said, asked) = before;
    assert_eq!((asked.method, asked.precision), (Some(0), Some(Precision::F64)), "the defaults of show");
    assert_eq!(said, "[]\n");
    let (said, ..) = fake.answer(&["--format", "csv", "trade", "--out", &out]);
    assert_eq!(said, "");
    let (.., asked) = fake.answer(&["--method", "notes", "trade", "--method", "robust", "--out", &out]);
    assert_eq!(asked.unwrap().method, Some(1), "the later one counts");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn csv_is_for_trade() {
    for words in [&["--format", "csv"][..], &["--format", "csv", "show"], &["eval", "--format", "csv"]] {
        let (said, done, _) = Fake::default().answer(words);
        assert_eq!((said.as_str(), done.unwrap_err().status()), ("", 2));
    }
}

#[test]
fn nothing_is_measured_for_a_wrong_request_or_a_folder_that_is_not_there() {
    let (folder, _) = folder("refused");
    let missing = folder.join("missing/picture.png").display().to_string();
    for (regime, status, cause) in [
        ("nowhere", 2, "there is no regime `nowhere`; there are ordinary, far"),
        ("far", 1, "there is no folder "),
    ] {
        let words = ["trade", "--regime", "ordinary", "--regime", regime, "--out", &missing];
        let (said, done, asked) = Fake::default().answer(&words);
        let error = done.unwrap_err();
        assert_eq!((said.as_str(), error.status(), asked), ("", status, None));
        assert!(error.to_string().contains(cause), "{error}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_drawing_that_fails_costs_neither_the_numbers_nor_the_other_drawing() {
    let (folder, out) = folder("drawing");
    std::fs::create_dir(folder.join("picture-trade.svg")).unwrap();
    let (said, done, _) = Fake::default().answer(&["trade", "--out", &out]);
    let map = folder.join("picture-map.svg");
    assert_eq!(said, format!("the numbers\n\ndrawing: {}\n", map.display()));
    let error = done.unwrap_err();
    assert_eq!(error.status(), 1);
    assert!(error.to_string().contains("picture-trade.svg: it is a folder"), "{error}");
    assert!(map.is_file());
    std::fs::remove_dir_all(folder).unwrap();
}

/// An output that takes nothing.
struct Refusing(io::ErrorKind);

impl Write for Refusing {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn the_drawings_are_written_even_if_nobody_reads_the_numbers() {
    let (folder, out) = folder("unread");
    let answer =
        |kind| Fake::default().answer_on(&["trade", "--out", &out], &mut Refusing(kind)).unwrap_err();
    for (kind, status) in [(io::ErrorKind::BrokenPipe, 0), (io::ErrorKind::StorageFull, 1)] {
        assert_eq!(answer(kind).status(), status);
        for ending in ["trade.svg", "map.svg"] {
            std::fs::remove_file(folder.join(format!("picture-{ending}"))).unwrap();
        }
    }
    // A drawing that fails is a failure all the same.
    std::fs::create_dir(folder.join("picture-map.svg")).unwrap();
    assert_eq!(answer(io::ErrorKind::BrokenPipe).status(), 1);
    assert!(answer(io::ErrorKind::StorageFull).to_string().contains("standard output"));
    std::fs::remove_dir_all(folder).unwrap();
}

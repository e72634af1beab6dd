//! `trade` through its command: the contract's columns, figures that a seed decides, drawings in
//! their places, refusals. What the lab makes of answers that are known is tested in `crates/lab/tests`.

use std::sync::LazyLock;

use serde_json::Value;
use stage::Stage;
use tests::{Folder, STAGES};

use crate::assert_snapshot;
use crate::process::{Run, run};

/// The columns of the contract, in its order.
const CONTRACT: [&str; 10] = [
    "method",
    "precision",
    "regime",
    "ns_per_ray",
    "cases",
    "wrong_decisions",
    "t_ulp_median",
    "t_ulp_p99",
    "t_ulp_max",
    "pareto",
];
/// Those that are about rays that hit or miss.
const OF_RAYS: [&str; 5] = ["ns_per_ray", "wrong_decisions", "t_ulp_median", "t_ulp_p99", "t_ulp_max"];

/// The regimes of a stage, by asking for one that there is not.
fn regimes(stage: &dyn Stage) -> Vec<String> {
    let run = run(Folder::new().path(), stage.about().name, &["trade", "--regime", "nowhere"]);
    let names = run.errors.trim_end().strip_prefix("error: there is no regime `nowhere`; there are ");
    let names = names.unwrap_or_else(|| panic!("exit status {}: {}", run.status, run.errors));
    assert_eq!((run.status, run.output.as_str()), (2, ""));
    names.split(", ").map(str::to_string).collect()
}

/// Runs `trade --quick` over a few cases of the first regime.
fn trade(folder: &Folder, stage: &dyn Stage, cases: &str, args: &[&str]) -> Run {
    let first = &regimes(stage)[0];
    let quick = ["trade", "--quick", "--cases", cases, "--regime", first];
    run(folder.path(), stage.about().name, &[&quick, args].concat())
}

/// The same, in order; its records as JSON.
fn records(stage: &dyn Stage, args: &[&str]) -> Vec<Value> {
    let run = trade(&Folder::new(), stage, "60", &[&["--format", "json"], args].concat());
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    serde_json::from_str(&run.output).unwrap_or_else(|error| panic!("{error}:\n{}", run.output))
}

/// What each stage measures when nothing is said, worked out once for all the tests that look at it.
static RECORDS: LazyLock<Vec<Vec<Value>>> =
    LazyLock::new(|| STAGES.iter().map(|stage| records(*stage, &[])).collect());

/// The method and the precision of each record; of whole pictures, which are measured in many settings, each pair once, in
/// the order of the methods.
fn named(stage: &dyn Stage, records: &[Value]) -> Vec<[String; 2]> {
    let named = records.iter().map(|record| ["method", "precision"].map(|key| text(&record[key])));
    let named: Vec<[String; 2]> = named.collect();
    match stage.about().name {
        "whitted" => methods_and_precisions(stage).into_iter().filter(|pair| named.contains(pair)).collect(),
        _ => named,
    }
}

/// Every method at every precision, as a record names them.
fn methods_and_precisions(stage: &dyn Stage) -> Vec<[String; 2]> {
    let methods = stage.about().methods;
    let both = ["f32", "f64"].into_iter();
    both.flat_map(|precision| methods.iter().map(move |name| [name, precision].map(str::to_string))).collect()
}

#[test]
fn records_are_the_contracts() {
    for (stage, records) in STAGES.iter().zip(&*RECORDS) {
        let first = regimes(*stage)[0].clone();
        assert_eq!(named(*stage, records), methods_and_precisions(*stage));
        for record in records {
            assert_eq!((text(&record["regime"]), record["cases"].as_u64()), (first.clone(), Some(60)));
            assert!(record["pareto"].is_boolean(), "{record}");
            // grids of pixels, and whole scenes
            let is_of_rays = stage.about().name != "pinhole" && stage.about().number < 8;
            for key in OF_RAYS {
                let value = record.get(key).unwrap_or_else(|| panic!("no {key}: {record}"));
                assert_eq!(value.is_null(), !is_of_rays, "{key}: {record}");
            }
            let time = match stage.about().name {
                _ if is_of_rays => "ns_per_ray",
                "shading" => "ns_per_second_ray",
                _ => "ns_per_pixel",
            };
            assert!(record[time].as_f64().is_some_and(|ns| ns > 0.0), "{record}");
            assert!(!is_of_rays || record["wrong_decisions"].as_u64() <= Some(60), "{record}");
        }
        assert!(records.iter().any(|record| record["pareto"] == true), "somebody is on the front");
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_else(|| panic!("{value} is no text")).to_string()
}

/// CSV has the records of JSON, and a second run those of the first, but for the times and what
/// follows from them.
#[test]
fn csv_has_the_same_records_and_a_seed_decides_the_counts() {
    for (stage, records) in STAGES.iter().zip(&*RECORDS) {
        let run = trade(&Folder::new(), *stage, "60", &["--format", "csv", "--precision", "f32"]);
        assert_eq!((run.status, run.errors.as_str()), (0, ""));
        let mut lines = run.output.lines();
        let header: Vec<&str> = lines.next().expect("a header row").split(',').collect();
        assert_eq!(header[..CONTRACT.len()], CONTRACT);
        let records = in_f32(records);
        assert_eq!(lines.clone().count(), records.len());
        for (line, record) in lines.zip(records) {
            let fields: Vec<&str> = line.split(',').collect();
            let keys = record.as_object().expect("a record is an object");
            assert_eq!((fields.len(), keys.len()), (header.len(), header.len()), "{line}");
            for (key, field) in header.iter().zip(fields) {
                let value = keys.get(*key).unwrap_or_else(|| panic!("{key} is not in {record}"));
                if !key.starts_with("ns_") && *key != "pareto" {
                    assert!(is_the_same(value, field), "{key}: {value} is not that of {line}");
                }
            }
        }
    }
}

/// Half of the records, which is enough to see whether others are the same.
fn in_f32(records: &[Value]) -> Vec<&Value> {
    records.iter().filter(|record| record["precision"] == "f32").collect()
}

/// Whether a value of JSON is that of a field of CSV.
fn is_the_same(value: &Value, field: &str) -> bool {
    match value {
        Value::Null => field.is_empty(),
        Value::String(text) => text == field,
        Value::Bool(flag) => flag.to_string() == field,
        other => other.as_f64().is_some_and(|number| field.parse() == Ok(number)),
    }
}

/// Where the methods of a chapter differ.
const TELLING: [(&str, &[&str]); 7] = [
    ("ray-wall", &["ordinary", "both-extreme"]),
    ("ray-plane", &["ordinary", "near-parallel", "vectors-extreme"]),
    ("ray-sphere", &["ordinary", "far-1e4", "on-surface-exact"]),
    ("triangle", &["ordinary", "edge"]),
    ("quadric", &["ordinary", "cone-apex"]),
    ("affine", &["ordinary", "condition-1e6"]),
    ("shading", &["unit-at-0", "small-at-1e3", "into-sphere", "cone", "squashed"]),
];

/// Neither the machine nor its threads decide what is not a time or follows from one.
#[test]
fn what_a_seed_decides_is_the_same_everywhere() {
    for (stage, regimes) in TELLING {
        let named = regimes.iter().flat_map(|regime| ["--regime", regime]);
        let quick = ["trade", "--quick", "--cases", "50", "--format", "csv"];
        let args: Vec<&str> = quick.into_iter().chain(named).collect();
        let run = run(Folder::new().path(), stage, &args);
        assert_eq!((run.status, run.errors.as_str()), (0, ""), "{stage}");
        let columns: Vec<&str> = run.output.lines().next().expect("a header row").split(',').collect();
        let without_times = |line: &str| {
            let fields = columns.iter().zip(line.split(','));
            let decided = fields.filter(|(column, _)| !column.starts_with("ns_") && **column != "pareto");
            decided.map(|(_, field)| field).collect::<Vec<_>>().join(",") + "\n"
        };
        let text: String = run.output.lines().map(without_times).collect();
        assert_snapshot(&format!("{stage}.trade"), &text);
    }
}

#[test]
fn another_seed_measures_other_cases() {
    for (stage, first) in STAGES.iter().zip(&*RECORDS) {
        let error = match stage.about().name {
            "pinhole" => "pixel_error_mean",
            // a seed only says which pixels of the same picture are looked at, and they see the same object
            "signature" => continue,
            "bounds" => "hits_per_test",
            "shading" => "acne_per_million",
            "whitted" => "rmse",
            _ => "error",
        };
        let errors = |records: &[Value]| -> Vec<Value> {
            in_f32(records).into_iter().map(|record| record[error].clone()).collect()
        };
        let other = records(*stage, &["--seed", "1", "--precision", "f32"]);
        assert_ne!(errors(first), errors(&other), "{}", stage.about().name);
    }
}

#[test]
fn what_is_asked_for_is_all_that_is_measured() {
    for stage in STAGES {
        let method = stage.about().methods[1];
        let records = records(*stage, &["--method", method, "--precision", "f32"]);
        assert_eq!(named(*stage, &records), [[method.to_string(), "f32".to_string()]]);
    }
}

#[test]
fn the_report_says_what_to_take_and_where_the_drawings_are() {
    for stage in STAGES {
        let folder = Folder::new();
        let run = trade(&folder, *stage, "20", &["--out", "picture.png"]);
        assert_eq!((run.status, run.errors.as_str()), (0, ""));
        assert!(run.output.starts_with(&format!("{} · trade · seed ", stage.about().name)), "{}", run.output);
        assert!(run.output.contains("\nWhat to take"), "{}", run.output);
        let mut told: Vec<&str> =
            run.output.lines().filter_map(|line| line.strip_prefix("drawing: ")).collect();
        told.sort_unstable();
        assert_eq!(told, folder.names(), "and nothing else is there");
        assert!(told.contains(&"picture-trade.svg"), "{told:?}");
        for name in told {
            let path = folder.path().join(name);
            if name.ends_with(".svg") {
                assert_well_formed(&std::fs::read_to_string(path).unwrap());
            } else {
                let map = image::open(path).unwrap();
                assert!(map.width() > 1000 && map.height() > 500, "{name}");
            }
        }
    }
}

/// Every element of an SVG is closed, in the order of their opening.
fn assert_well_formed(svg: &str) {
    assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" "), "{}", &svg[..60.min(svg.len())]);
    let mut open = Vec::new();
    for tag in svg.split('<').skip(1) {
        let (tag, text) = tag.split_once('>').unwrap_or_else(|| panic!("<{tag} has no end"));
        assert!(!text.contains("NaN") && !tag.contains("NaN"), "<{tag}>{text}");
        assert!(tag.matches('"').count() % 2 == 0, "<{tag}>");
        let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or_default();
        match tag {
            _ if tag.starts_with('/') => assert_eq!(open.pop(), Some(name), "<{tag}>"),
            _ if tag.ends_with('/') => {}
            _ => open.push(name),
        }
    }
    assert!(open.is_empty(), "{open:?} not closed");
}

#[test]
fn without_a_file_named_the_drawings_go_to_out() {
    let (folder, stage) = (Folder::new(), STAGES[0]);
    let first = &regimes(stage)[0];
    let run =
        run(folder.path(), stage.about().name, &["trade", "--quick", "--cases", "1", "--regime", first]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    assert_eq!(folder.names(), ["out"]);
    assert!(run.output.ends_with("\ndrawing: out/pinhole-trade.svg\n"), "{}", run.output);
    assert!(folder.path().join("out/pinhole-trade.svg").is_file());
}

#[test]
fn what_cannot_be_measured_is_refused() {
    for stage in STAGES {
        for args in [
            &["--regime", "nowhere"][..],
            &["--regime"],
            &["--cases", "0"],
            &["--cases=-1"],
            &["--cases", "1.5"],
            &["--cases", "99999999999999999999"],
            &["--seed", "x"],
            &["--seed=-1"],
            &["--method", "guess"],
            &["--precision", "f16"],
            &["--format", "yaml"],
            &["--quick", "extra"],
            &["--out", "picture.svg"],
        ] {
            let folder = Folder::new();
            let run = run(folder.path(), stage.about().name, &[&["trade"], args].concat());
            assert_eq!((run.status, run.output.as_str()), (2, ""), "{args:?}: {}", run.errors);
            assert!(run.errors.starts_with("error: "), "{args:?}: {}", run.errors);
            assert!(folder.names().is_empty(), "{args:?}");
        }
    }
}

#[test]
fn drawings_that_cannot_be_written_are_a_failure_and_leave_nothing() {
    for stage in STAGES {
        let folder = Folder::new();
        let run = trade(&folder, *stage, "1", &["--out", "missing/picture.png"]);
        assert_eq!((run.status, run.output.as_str()), (1, ""), "{}", run.errors);
        assert!(run.errors.starts_with("error: cannot write missing/picture"), "{}", run.errors);
        assert!(folder.names().is_empty());
    }
}

//! What the chapters that measure in scenes have in common: their pixels, their records, the cells of their
//! tables.

use std::path::Path;

use stage::{Field, Precision, Record};

use crate::table::three_digits;
use crate::{Draw, Nanoseconds};

/// Pixels of the picture, column and row, none likelier than another; one may come twice. `name` and `seed`
/// decide which, and neither number of `size` may be 0.
pub fn pixels(name: &str, seed: u64, size: (u32, u32), count: usize) -> Vec<(u32, u32)> {
    let mut draw = Draw::new(seed, name, Precision::F64);
    let mut below = |bound: u32| draw.below(u64::from(bound)) as u32;
    (0..count).map(|_| (below(size.0), below(size.1))).collect()
}

/// What a scene of a file is called, the file's name without its ending; and what is said of it, its path.
pub fn file_named(path: &Path) -> (String, String) {
    (path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), path.display().to_string())
}

/// The contract's columns where no single hit is judged: those about one are empty. What a chapter measures
/// follows them.
pub fn record(method: &str, precision: Precision, regime: &str, cases: u64, on_front: bool) -> Record {
    vec![
        ("method", Field::Text(method.to_string())),
        ("precision", Field::Text(precision.name().to_string())),
        ("regime", Field::Text(regime.to_string())),
        ("ns_per_ray", Field::Nothing),
        ("cases", Field::Count(cases)),
        ("wrong_decisions", Field::Nothing),
        ("t_ulp_median", Field::Nothing),
        ("t_ulp_p99", Field::Nothing),
        ("t_ulp_max", Field::Nothing),
        ("pareto", Field::Flag(on_front)),
    ]
}

/// The columns of a time: the median, under the name of what it is for, and its quartiles.
pub fn times(name: &'static str, ns: &Nanoseconds) -> [(&'static str, Field); 3] {
    [(name, Field::Number(ns.median)), ("ns_low", Field::Number(ns.low)), ("ns_high", Field::Number(ns.high))]
}

/// The first cells of a line in the table: who, and how long it took.
pub fn cells(method: &str, precision: Precision, ns: &Nanoseconds) -> Vec<String> {
    let quartiles = format!("{}–{}", three_digits(ns.low), three_digits(ns.high));
    vec![method.to_string(), precision.name().to_string(), three_digits(ns.median), quartiles]
}

/// Who and how long, in nanoseconds, as a part of a sentence.
pub fn took(method: &str, precision: Precision, ns: &Nanoseconds) -> String {
    format!("{method} {}, {} ns", precision.name(), three_digits(ns.median))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_lie_within_the_picture_and_follow_from_the_seed() {
        let all = pixels("a scene", 1, (3, 2), 600);
        assert!(all.iter().all(|&(col, row)| col < 3 && row < 2));
        let of = |pixel| all.iter().filter(|&&other| other == pixel).count();
        assert!((0..2).all(|row| (0..3).all(|col| of((col, row)) > 60)), "a sixth of them each");
        assert_eq!(all, pixels("a scene", 1, (3, 2), 600));
        assert_ne!(all, pixels("another", 1, (3, 2), 600));
    }

    #[test]
    fn a_file_is_called_by_its_name() {
        let (name, what) = file_named(Path::new("a/ball.toml"));
        assert_eq!((name.as_str(), what.as_str()), ("ball", "a/ball.toml"));
    }

    #[test]
    fn a_time_is_told_the_same_everywhere() {
        let ns = Nanoseconds { low: 9.5, median: 10.25, high: 1234.0 };
        assert_eq!(cells("robust", Precision::F32, &ns), ["robust", "f32", "10.2", "9.50–1234"]);
        assert_eq!(took("robust", Precision::F32, &ns), "robust f32, 10.2 ns");
        let names = times("ns_per_pixel", &ns).map(|(name, _)| name);
        assert_eq!(names, ["ns_per_pixel", "ns_low", "ns_high"]);
    }

    /// Of a record about hits the names are the same, in the same order.
    #[test]
    fn what_is_not_about_hits_is_there() {
        let record = record("tree", Precision::F64, "far", 7, true);
        let names: Vec<&str> = record.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, crate::report::CONTRACT);
        let given = record.iter().filter(|(_, field)| *field != Field::Nothing).map(|(name, _)| *name);
        assert_eq!(given.collect::<Vec<_>>(), ["method", "precision", "regime", "cases", "pareto"]);
    }
}

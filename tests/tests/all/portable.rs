//! What differs between systems is taken from `math::portable`, or the bits would differ too.
//!
//! The standard library's functions of one number are the system's: their last digit is not the same everywhere. They
//! are easily typed, so the sources are read for them. Tests may use them, and so may what only shows times. `powi` is
//! not even the same at every level of optimization: 2^−1070 is zero where it is computed at run time. `mul_add` is
//! the same everywhere, and another number than the product and the sum: whoever has it must not take another way.

use std::fs;
use std::path::{Path, PathBuf};

/// Methods of `f32` and `f64` that are rounded as each system likes.
const UNFIXED: [&str; 26] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "exp2",
    "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "mul_add", "hypot", "cbrt", "gamma",
    "ln_gamma",
];

/// Where the code of a text calls one of them: the number of the line and the method. What follows `#[cfg(test)]` and
/// comments are passed over.
fn calls(text: &str) -> Vec<(usize, &'static str)> {
    let lines = text.lines().take_while(|line| line.trim() != "#[cfg(test)]");
    let code = lines.map(|line| line.split("//").next().unwrap_or_default());
    let found = (1..).zip(code).filter_map(|(number, line)| {
        let called = UNFIXED.iter().find(|name| {
            [format!(".{name}("), format!("f64::{name}"), format!("f32::{name}")].iter().any(|call| {
                line.match_indices(call.as_str()).any(|(at, _)| {
                    let next = line[at + call.len()..].chars().next();
                    call.ends_with('(') || next.is_none_or(|next| !next.is_alphanumeric() && next != '_')
                })
            })
        })?;
        Some((number, *called))
    });
    found.collect()
}

/// Every file of Rust below a folder but those of tests.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            sources(&path, found);
        } else if name.ends_with(".rs") && name != "tests.rs" && name != "portable.rs" {
            found.push(path);
        }
    }
}

#[test]
fn no_function_is_the_systems() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for group in ["chapters", "crates"] {
        for member in fs::read_dir(root.join(group)).unwrap() {
            sources(&member.unwrap().path().join("src"), &mut found);
        }
    }
    assert!(found.len() > 200, "{} files", found.len());
    let faults: Vec<String> = found
        .iter()
        // drawn for its own tests alone
        .filter(|path| !path.ends_with("polygon/sweep.rs"))
        .flat_map(|path| {
            let text = fs::read_to_string(path).unwrap();
            let place = path.strip_prefix(&root).unwrap().display().to_string();
            let fault = move |(line, name)| format!("{place}:{line}: `{name}`; take one from math::portable");
            calls(&text).into_iter().map(fault).collect::<Vec<_>>()
        })
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_call_is_found_and_a_word_like_it_is_not() {
    let text = "let a = x.sin();\n// y.cos()\nlet b = x.since(y);\nlet c = a.map(f64::sqrt).map(f64::exp);\n\
                let d = portable::tan(x);\n#[cfg(test)]\nlet e = x.cos();\n";
    assert_eq!(calls(text), [(1, "sin"), (4, "exp")]);
}

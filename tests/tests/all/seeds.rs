//! What the fuzzers of the case files start from and what they once found, under `fuzz/seeds`: each answer
//! is judged once more.

use std::fs;
use std::path::Path;

use tests::fuzzed;

use crate::exact::assert_none;

/// Judges every file of a folder, and gives how many there are.
fn replay(target: &str, judge: fn(&[u8]) -> Result<(), String>) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds").join(target);
    let (mut count, mut failures) = (0, Vec::new());
    for entry in fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let fault = judge(&fs::read(&path).unwrap()).err();
        failures.extend(fault.map(|fault| format!("{}: {fault}", path.display())));
        count += 1;
    }
    assert_none(failures);
    count
}

#[test]
fn every_case_file_is_answered_or_refused_at_its_place() {
    assert!(replay("cases", fuzzed::cases) > 20);
}

#[test]
fn every_row_of_bits_has_an_answer_that_is_true() {
    assert!(replay("eval", fuzzed::eval) > 20);
}

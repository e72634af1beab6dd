//! A row of any numbers.

use super::{Bytes, answered};
use crate::{Judge, records};

/// The first byte chooses the stage, the second the precision, the rest are the bits of all number columns;
/// in a column of words one byte chooses the word. Every method is asked, and every answer is judged.
///
/// The error says what is wrong with an answer, and how to see it again.
pub fn eval(bytes: &[u8]) -> Result<(), String> {
    let mut bytes = Bytes(bytes);
    let stage = bytes.stage();
    let precision = stage::Precision::ALL[bytes.choice() % 2];
    let about = stage.about();
    let words = |column: &str| about.words.iter().find(|(name, _)| *name == column).map(|(_, words)| words);
    let mut number = |column: &&str| match words(column) {
        Some(words) => (bytes.choice() % words.len()) as f64,
        None => bytes.number(precision),
    };
    let case: Vec<f64> = about.inputs.iter().map(&mut number).collect();
    let (header, row) = (about.inputs.join(","), about.row_of(&case, precision));
    let text = format!("{header}\n{row}\n");
    let judge = Judge::of(&about, precision, &case);
    for (place, method) in about.methods.iter().enumerate() {
        let (output, ended) = answered(stage, place, precision, text.as_bytes());
        let fault = match (ended, &records(&output)[..]) {
            (Err(error), _) => Some(format!("refused: {error}")),
            (Ok(()), [got]) => judge.fault(method, got),
            (Ok(()), rows) => Some(format!("{} rows", rows.len())),
        };
        if let Some(fault) = fault {
            let (name, precision) = (about.name, precision.name());
            return Err(format!(
                "{fault}\n{output}  printf '%s\\n' '{header}' '{row}' | \
                 cargo run -q -p {name} -- eval --method {method} --precision {precision}"
            ));
        }
    }
    Ok(())
}

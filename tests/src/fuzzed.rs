//! What a fuzzer hands over, as a question to a stage, and whether the answer is in order.
//!
//! The fuzz targets of `fuzz/` call these two functions and nothing else, and the tests call them with
//! every file under `fuzz/seeds`: what a fuzzer found is found again by `cargo test`.

mod cases;
mod eval;

pub use cases::cases;
pub use eval::eval;

use stage::{Ask, Error, Precision, Stage, answer_cases};

use crate::with_cases;

/// The name that errors give the texts of a fuzzer.
const NAME: &str = "fuzz.csv";

/// The bytes of a fuzzer, taken from the front.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    /// The next N bytes; zeros where there are none left.
    fn next<const N: usize>(&mut self) -> [u8; N] {
        let (start, rest) = self.0.split_at(N.min(self.0.len()));
        self.0 = rest;
        let mut bytes = [0; N];
        bytes[..start.len()].copy_from_slice(start);
        bytes
    }

    /// A choice from a byte, counted from the digit 0, so that a file can be written by hand.
    fn choice(&mut self) -> usize {
        let [byte] = self.next();
        usize::from(byte.wrapping_sub(b'0'))
    }

    /// A stage that has case files.
    fn stage(&mut self) -> &'static dyn Stage {
        let stages: Vec<_> = with_cases().collect();
        stages[self.choice() % stages.len()]
    }

    /// Any number of a precision, NaN and the infinities among them.
    fn number(&mut self, precision: Precision) -> f64 {
        match precision {
            Precision::F32 => f32::from_le_bytes(self.next()).into(),
            Precision::F64 => f64::from_le_bytes(self.next()),
        }
    }
}

/// What a stage writes to a text of cases, as far as it gets, and how it ends.
fn answered(
    stage: &dyn Stage,
    method: usize,
    precision: Precision,
    text: &[u8],
) -> (String, Result<(), Error>) {
    let ask = Ask { method, precision, ..Ask::default() };
    let mut output = Vec::new();
    let ended = answer_cases(stage, &ask, text, NAME, &mut output);
    (String::from_utf8_lossy(&output).into_owned(), ended)
}

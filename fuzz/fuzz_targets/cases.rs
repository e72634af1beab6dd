//! Any bytes are a case file that is answered row by row, or refused with the place of the fault.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(fault) = tests::fuzzed::cases(bytes) {
        panic!("{fault}");
    }
});

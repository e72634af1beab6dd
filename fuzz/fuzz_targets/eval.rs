//! Any numbers, to the bit, have an answer from every method that is in order, and from `robust` one that is
//! true.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(fault) = tests::fuzzed::eval(bytes) {
        panic!("{fault}");
    }
});

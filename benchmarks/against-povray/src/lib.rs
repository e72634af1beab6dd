//! Whole pictures against POV-Ray 3.7: the same scene for both programs, and what each of them says it did.
//!
//! [`mod@pov`] writes a scene of ours in POV-Ray's language. [`Statistics`] reads what POV-Ray prints about a
//! picture, [`Transcript`] what `whitted` prints about its own, and [`Measured`] sets the two side by side.
//! [`Difference`] tells whether the two pictures show the same. The script `run` beside this crate measures;
//! its `README.md` says what is compared and what differs.

mod difference;
mod measured;
pub mod pov;
mod statistics;
mod table;
mod transcript;

pub use difference::Difference;
pub use measured::{Measured, median};
pub use statistics::Statistics;
pub use table::{counts, rates};
pub use transcript::Transcript;

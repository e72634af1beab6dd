//! Speed for accuracy, measured.
//!
//! A chapter hands over its methods, its kinds of case and what is true of a case: a [`Subject`]. The lab draws
//! the cases of each [`Regime`] from a seed, judges every method at every precision against the exact
//! [`Truth`], and times them side by side: [`measure()`]. It knows no chapter and none of their methods.
//!
//! Truth comes from [`oracle`], which derives the concepts once more, from their equations and in integers: hit
//! or miss is a sign. No method is ever judged by another.
//!
//! What was found is printed as a [`table`] and drawn as a [`plot`]: speed against accuracy, or where in a
//! plane of two quantities a method fails ([`cells`]). [`scenes`] is what the chapters share that measure in
//! scenes instead of regimes. In a chapter's own tests [`first_beyond`] holds a method to what it promises, and [`tally()`]
//! counts the ways that it takes.
//!
//! A sphere of radius 5 around (0, 0, 13), touched by a ray up from (5, 0, 0), and missed by the next number's:
//!
//! ```
//! use lab::oracle::{Verdict, exact_sphere};
//!
//! let up_from = |x: f64| exact_sphere([x, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 13.0, 5.0]);
//! assert!(matches!(up_from(5.0), Verdict::Hit { .. }));
//! assert!(matches!(up_from(5.0_f64.next_up()), Verdict::Miss("")));
//! ```

mod accuracy;
mod angle;
mod beyond;
mod draw;
mod effort;
mod map_cells;
mod measure;
pub mod oracle;
mod pareto;
pub mod plot;
mod regime;
mod report;
pub mod scenes;
mod speed;
mod subject;
pub mod table;
mod tally;
mod threads;
mod truth;
mod verdict;

pub use accuracy::{Accuracy, Judgment, Ulps, judge, ulps};
pub use angle::{angle, dot};
pub use beyond::first_beyond;
pub use draw::{Draw, Vec2, Vec3};
pub use effort::{Effort, asked_for};
pub use map_cells::cells;
pub use measure::{Entry, Measured, MeasuredRegime, WorstCase, measure};
pub use pareto::front;
pub use regime::{Notes, Regime};
pub use speed::{LONGEST_PASS, Nanoseconds, runner, time};
pub use stage::Progress;
pub use subject::{Answer, Outcome, Pass, Quality, Runner, Subject};
pub use tally::{glances, tally, worth};
pub use threads::on_all_threads;
pub use truth::{Root, Truth};

//! The regimes of the chapters: what the notes' methods lose in them, judged by the exact oracle.
//!
//! The cases are the same on every run; `REGIME_SEED=7 cargo test -p tests regimes` draws others. What
//! fails is told with the seed, the regime, the precision, and a case for the stage's `eval`.

mod drawn;
mod margins;

use std::ops::RangeInclusive;
use std::sync::LazyLock;

use affine::stage::Affine;
use lab::{Accuracy, Answer, Judgment, Notes, Regime, Subject, Truth};
use math::Real;
use quadric::stage::Quadric;
use ray_plane::stage::RayPlane;
use ray_sphere::stage::RaySphere;
use ray_wall::stage::RayWall;
use stage::Precision;
use stage::Precision::{F32, F64};
use tests::{Bars, stage_named};
use triangle::stage::RayTriangle;

use crate::exact::assert_none;
use margins::Held;

/// How many cases of a regime are judged,
const CASES: usize = 2000;
/// and how many at the most, where the loss that the regime speaks of is rare.
const MOST: usize = 20 * CASES;
const SEED: u64 = 20260101;

/// More ulps of t than these are lost digits.
const LOST: u64 = 100;

/// Regimes in which every ray hits,
const ONLY_HITS: [&str; 9] = [
    "inside",
    "on-face",
    "on-plane-exact",
    "on-surface-exact",
    "edge-exact",
    "cylinder-inside",
    "cone-inside",
    "cylinder-on-surface-exact",
    "cone-on-surface-exact",
];
/// and in which none does.
const ONLY_MISSES: [&str; 2] = ["parallel", "behind"];

/// The methods of the notes.
const NOTES: [&str; 7] =
    ["notes", "closest-approach", "quadratic", "half-quadratic", "half-planes", "matrix", "solved"];

/// The seed of this run.
pub(crate) fn seed() -> u64 {
    match std::env::var("REGIME_SEED") {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("REGIME_SEED is a whole number, not `{text}`")),
        Err(_) => SEED,
    }
}

/// What became of a regime at one precision.
pub(crate) struct Judged {
    pub(crate) stage: &'static str,
    pub(crate) regime: &'static str,
    /// What the regime says of the notes' methods.
    notes: Notes,
    pub(crate) precision: Precision,
    /// What holding means for the notes' methods, where the regime says that they hold.
    held: Held,
    /// A case that has no answer.
    invalid: Option<Vec<f64>>,
    /// By method, in their order.
    losses: Vec<Losses>,
}

/// What one method lost.
pub(crate) struct Losses {
    method: &'static str,
    pub(crate) accuracy: Accuracy,
    /// How many t are farther off than what holds.
    far_off: u64,
    /// The first case with a wrong verdict,
    wrong: Option<Vec<f64>>,
    /// and the one where t is farthest off, of those with the right one.
    worst: Option<Vec<f64>>,
}

/// Everything judged once, for all the tests.
pub(crate) static JUDGED: LazyLock<Vec<Judged>> = LazyLock::new(|| {
    let subjects = [
        judged(&RayWall),
        judged(&RayPlane),
        judged(&RaySphere),
        judged(&RayTriangle),
        judged(&Quadric),
        judged(&Affine),
    ];
    subjects.into_iter().flatten().collect()
});

/// Every regime of a chapter at both precisions.
fn judged<const N: usize>(subject: &impl Subject<N>) -> Vec<Judged> {
    let regimes = subject.regimes().into_iter();
    regimes
        .flat_map(|regime| [judge::<f32, N>(subject, &regime), judge::<f64, N>(subject, &regime)])
        .collect()
}

/// All methods in one regime.
fn judge<R: Real, const N: usize>(subject: &impl Subject<N>, regime: &Regime<N>) -> Judged {
    let about = subject.about();
    let precision = if R::NAME == F32.name() { F32 } else { F64 };
    let none =
        |method| Losses { method, accuracy: Accuracy::default(), far_off: 0, wrong: None, worst: None };
    let mut judged = Judged {
        stage: about.name,
        regime: regime.name,
        notes: regime.notes,
        precision,
        held: Held::of(about.name, regime.name, precision),
        invalid: None,
        losses: about.methods.into_iter().map(none).collect(),
    };
    for (done, case) in regime.cases(seed(), precision).take(MOST).enumerate() {
        if done >= CASES && judged.has_shown_its_loss() {
            break;
        }
        let truth = subject.truth(case, precision);
        if let Truth::Invalid(_) = truth {
            judged.invalid = Some(case.to_vec());
        }
        for (method, losses) in judged.losses.iter_mut().enumerate() {
            let answer = subject.answer(method, case.map(R::round_from));
            losses.count(&case, &answer, &truth, precision, judged.held.bar);
        }
    }
    judged
}

impl Losses {
    fn count(&mut self, case: &[f64], answer: &Answer, truth: &Truth, precision: Precision, bar: u64) {
        let worst = self.worst_t();
        let judgment = self.accuracy.count(answer, truth, precision);
        self.far_off += u64::from(matches!(judgment, Judgment::Off { ulps, .. } if ulps > bar));
        match judgment {
            Judgment::Wrong if self.wrong.is_none() => self.wrong = Some(case.to_vec()),
            Judgment::Off { ulps, .. } if ulps > worst => self.worst = Some(case.to_vec()),
            _ => {}
        }
    }

    /// How far t is off at most, in ulps, where the verdict is right.
    pub(crate) fn worst_t(&self) -> u64 {
        self.accuracy.ulps.max().unwrap_or(0)
    }
}

impl Judged {
    pub(crate) fn losses_of(&self, method: &str) -> &Losses {
        let found = self.losses.iter().find(|losses| losses.method == method);
        found.unwrap_or_else(|| panic!("{}: {method} is a method", self.regime))
    }

    /// Whether the cases so far show what the regime says of this precision.
    fn has_shown_its_loss(&self) -> bool {
        match self.notes {
            Notes::Misjudge(method, precision) if precision == self.precision => {
                self.losses_of(method).accuracy.wrong > 0
            }
            Notes::LoseDigits(method, precision) if precision == self.precision => {
                self.losses_of(method).worst_t() > LOST
            }
            _ => true,
        }
    }

    /// Which regime this is, and with a case how to see it again.
    fn place(&self, method: &str, case: Option<&Vec<f64>>) -> String {
        let (stage, precision, seed) = (self.stage, self.precision.name(), seed());
        let place = format!("{stage} {}, {precision}, seed {seed}, {method}", self.regime);
        let Some(case) = case else { return place };
        let about = stage_named(stage).expect("a stage").about();
        let row = about.row_of(case, self.precision);
        format!(
            "{place}\n  printf '%s\\n' '{}' '{}' | \
             cargo run -q -p {stage} -- eval --method {method} --precision {precision}",
            about.inputs.join(","),
            row
        )
    }

    /// What is not as the regime says. What it says of one precision leaves the other open: there a method
    /// may lose as much, or nothing.
    fn contradictions(&self) -> Vec<String> {
        match self.notes {
            Notes::Misjudge(_, precision) | Notes::LoseDigits(_, precision)
                if precision != self.precision =>
            {
                Vec::new()
            }
            Notes::Misjudge(..) if self.has_shown_its_loss() => Vec::new(),
            Notes::Misjudge(method, _) => {
                vec![format!("every verdict is right; {}", self.place(method, None))]
            }
            Notes::LoseDigits(method, _) => {
                let losses = self.losses_of(method);
                let worst = (losses.worst_t() <= LOST).then(|| {
                    let place = self.place(method, losses.worst.as_ref());
                    format!("t is off by {} ulps at most; {place}", losses.worst_t())
                });
                self.wrong(losses).into_iter().chain(worst).collect()
            }
            Notes::Hold(_) => {
                let notes = self.losses.iter().filter(|losses| NOTES.contains(&losses.method));
                let fails = |losses: &&Losses| {
                    let Accuracy { cases, wrong, .. } = losses.accuracy;
                    margins::contradicts(wrong + losses.far_off, cases, &(0.0..=self.held.but))
                };
                notes.filter(fails).flat_map(|losses| self.beyond(losses, self.held.bar)).collect()
            }
        }
    }

    /// A wrong verdict, if there is one.
    fn wrong(&self, losses: &Losses) -> Option<String> {
        let case = losses.wrong.as_ref()?;
        Some(format!("a wrong verdict; {}", self.place(losses.method, Some(case))))
    }

    /// A wrong verdict, or a t that is farther off than the bar.
    fn beyond(&self, losses: &Losses, bar: u64) -> Vec<String> {
        let off = (losses.worst_t() > bar).then(|| {
            let place = self.place(losses.method, losses.worst.as_ref());
            format!("t is {} ulps off, the bar is {bar}; {place}", losses.worst_t())
        });
        self.wrong(losses).into_iter().chain(off).collect()
    }

    /// The share of hits that the regime has, in endlessly many cases.
    fn said_share(&self) -> RangeInclusive<f64> {
        match (self.stage, self.regime) {
            // A sixth of what goes by a corner is within its angle.
            ("triangle", "vertex") => 0.1..=0.3,
            // Moved by a digit, a few meet the triangle at its edge.
            ("triangle", "parallel") => 0.0..=0.05,
            (_, regime) if ONLY_HITS.contains(&regime) => 1.0..=1.0,
            (_, regime) if ONLY_MISSES.contains(&regime) => 0.0..=0.0,
            _ => 0.2..=0.9,
        }
    }

    /// The share of hits, where that is not by chance another than the regime's.
    fn contradicted_share(&self) -> Option<String> {
        let Accuracy { cases, hits, .. } = self.losses_of("robust").accuracy;
        let place =
            || format!("a share of {} hits; {}", hits as f64 / cases as f64, self.place("robust", None));
        margins::contradicts(hits, cases, &self.said_share()).then(place)
    }
}

/// The regimes of one chapter contradicted by their cases.
fn assert_notes_are_as_said(stage: &str) {
    let judged = JUDGED.iter().filter(|judged| judged.stage == stage);
    assert_none(judged.flat_map(Judged::contradictions).collect());
}

#[test]
fn every_regime_of_the_wall_says_what_the_notes_lose() {
    assert_notes_are_as_said("ray-wall");
}

#[test]
fn every_regime_of_the_plane_says_what_the_notes_lose() {
    assert_notes_are_as_said("ray-plane");
}

#[test]
fn every_regime_of_the_sphere_says_what_the_notes_lose() {
    assert_notes_are_as_said("ray-sphere");
}

#[test]
fn every_regime_of_the_triangle_says_what_the_notes_lose() {
    assert_notes_are_as_said("triangle");
}

#[test]
fn every_regime_of_the_solids_says_what_the_notes_lose() {
    assert_notes_are_as_said("quadric");
}

#[test]
fn every_regime_of_affine_objects_says_what_the_notes_lose() {
    assert_notes_are_as_said("affine");
}

#[test]
fn robust_is_right_in_every_regime() {
    let faults = |judged: &'static Judged| {
        judged.beyond(judged.losses_of("robust"), Bars::of(judged.stage).promised(judged.precision))
    };
    assert_none(JUDGED.iter().flat_map(faults).collect());
}

/// Regimes of numbers that need not be a question.
const ANYTHING: [&str; 2] = ["special", "bits"];

#[test]
fn every_case_of_a_finite_regime_has_an_answer() {
    let finite = JUDGED.iter().filter(|judged| !ANYTHING.contains(&judged.regime));
    let invalid = finite.filter_map(|judged| {
        let case = judged.invalid.as_ref()?;
        Some(format!("an invalid case; {}", judged.place("robust", Some(case))))
    });
    assert_none(invalid.collect());
}

#[test]
fn every_regime_has_hits_and_misses() {
    let finite = JUDGED.iter().filter(|judged| !ANYTHING.contains(&judged.regime));
    assert_none(finite.filter_map(Judged::contradicted_share).collect());
}

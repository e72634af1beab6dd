//! How far off the parameters of a hit may be where a method `robust` found them: one table for every test.

use stage::Precision;

/// The bars of one stage, each in ulps of f32 and of f64.
pub struct Bars {
    /// The stage.
    pub stage: &'static str,
    /// What the error bound of the method promises for every case there is.
    promised: [u64; 2],
    /// The most that is seen in the committed case files.
    seen: [u64; 2],
}

/// A bound of so many ulps from the exact root is, rounded up, one from the nearest number to it.
pub const BARS: &[Bars] = &[
    // chapters/02-ray-wall/src/robust.rs, `corrected`: half a unit of the last digit "and hardly more". In f32 the
    // quotient of f64 is rounded once.
    Bars { stage: "ray-wall", promised: [1, 1], seen: [0, 0] },
    // chapters/03-ray-plane/src/robust/sums.rs: `Sum::at_once`, a quarter of the last digit of an f32 before it is
    // rounded; `Sum::over`, 1.25 units of that of an f64.
    Bars { stage: "ray-plane", promised: [1, 2], seen: [0, 1] },
    // chapters/04-ray-sphere/src/robust/at_once.rs: `is_enough_for_f32`, a quarter of the last digit of an f32
    // before it is rounded; `OF_T`, eight units of that of an f64.
    Bars { stage: "ray-sphere", promised: [1, 8], seen: [0, 2] },
    // crates/math/src/bounded.rs, `rounded`: a quarter of the last digit before it is rounded, in all three.
    Bars { stage: "triangle", promised: [1, 1], seen: [0, 0] },
    Bars { stage: "quadric", promised: [1, 1], seen: [0, 0] },
    Bars { stage: "affine", promised: [1, 1], seen: [0, 0] },
];

impl Bars {
    /// Those of a stage. Panics where it has none.
    pub fn of(stage: &str) -> &'static Bars {
        let found = BARS.iter().find(|bars| bars.stage == stage);
        found.unwrap_or_else(|| panic!("{stage} has a method `robust`: it needs bars here"))
    }

    /// For cases that nobody has looked at.
    pub fn promised(&self, precision: Precision) -> u64 {
        self.promised[place(precision)]
    }

    /// For the committed case files. They are the same on every run, and so is every answer to them: what is
    /// farther off is a change, even where the promise is kept.
    pub fn seen(&self, precision: Precision) -> u64 {
        self.seen[place(precision)]
    }
}

/// The place of a precision in a pair of bars.
fn place(precision: Precision) -> usize {
    usize::from(precision == Precision::F64)
}

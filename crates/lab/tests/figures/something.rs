//! A subject that answers as it is told to.
//!
//! A case is one number, which says what is true of it and what the methods answer. 250 of them in a row hold
//! each of the numbers 0 to 249 of their regime once: 200 hits at t = 1, 40 misses, 10 invalid ones.

use std::cell::Cell;
use std::thread::sleep;
use std::time::Duration;

use lab::{Answer, Notes, Pass, Quality, Regime, Root, Runner, Subject, Truth};
use math::{Real, Wide};
use stage::{About, Precision};

/// Something with four methods.
pub(super) struct Something;

pub(super) const METHODS: [&str; 4] = ["right", "off", "wrong", "slow"];
pub(super) const RIGHT: usize = 0;
pub(super) const OFF: usize = 1;
pub(super) const WRONG: usize = 2;
pub(super) const SLOW: usize = 3;

/// Where `off` is off by 0 to 8 ulps, `slow` by 9 once, and nobody is wrong.
const NEAR: u64 = 1000;
/// Where `off` is off by as many ulps as the case says, but for the last hit, and `wrong` is wrong 12 times,
/// and 3000 ulps off once.
const MIXED: u64 = 2000;
/// Where nothing is hit.
const NONE: u64 = 3000;

/// So many in a row are each of a regime's cases once.
pub(super) const ALL: usize = 250;

thread_local! {
    static DRAWN: Cell<u64> = const { Cell::new(0) };
}

/// The next of the cases of a regime.
fn next(regime: u64) -> [f64; 1] {
    let drawn = DRAWN.replace(DRAWN.get() + 1);
    [(regime + drawn % ALL as u64) as f64]
}

/// Which regime a case is of, and its number in it.
fn place(case: f64) -> (u64, u64) {
    let number = case as u64 % 1000;
    (case as u64 - number, number)
}

/// How far off a method's t is, in ulps. That of `off` in MIXED is another number each time, so that no two
/// quantiles are the same.
fn off(method: usize, case: f64) -> u64 {
    match (method, place(case)) {
        (OFF, (NEAR, number)) => number % 9,
        (OFF, (MIXED, 199)) => 1000,
        (OFF, (MIXED, number)) => number,
        (WRONG, (MIXED, 199)) => 3000,
        (SLOW, (NEAR, 7)) => 9,
        _ => 0,
    }
}

/// The 12 cases of MIXED that `wrong` is wrong about: 7 hits, 3 misses, 2 invalid ones.
pub(super) fn is_wrong(method: usize, case: f64) -> bool {
    matches!((method, place(case)), (WRONG, (MIXED, 0..7 | 200..203 | 240..242)))
}

/// 1 and so many ulps.
fn beyond_one<R: Real>(ulps: u64) -> f64 {
    match R::NAME {
        "f32" => f64::from(f32::from_bits(1.0_f32.to_bits() + ulps as u32)),
        _ => f64::from_bits(1.0_f64.to_bits() + ulps),
    }
}

/// How many rays a method says it takes in a pass, which lasts a millisecond whatever it says: who says less
/// is slower. No machine is so busy that this is mistaken for a hundred times as long.
fn rays<R: Real>(method: usize, pass: Pass) -> usize {
    let rank = match (method, R::NAME) {
        (WRONG, "f32") => 7,
        (WRONG, _) => 6,
        (OFF, "f32") => 5,
        (OFF, _) => 4,
        (RIGHT, "f32") => 3,
        (RIGHT, _) => 2,
        (_, "f32") => 1,
        _ => 0,
    };
    match pass {
        Pass::Throughput => 100_usize.pow(rank),
        // who is fast among many is slow alone
        Pass::Latency => 100_usize.pow(7 - rank),
    }
}

impl Subject<1> for Something {
    fn about(&self) -> About {
        About {
            number: 0,
            name: "something",
            teaches: "",
            notes: "",
            methods: METHODS.to_vec(),
            size: (1, 1),
            picture: "",
            flags: &[],
            inputs: &["case"],
            words: &[],
            results: &["hit", "t"],
            trade: "",
            regimes: Vec::new(),
        }
    }

    fn baseline(&self) -> usize {
        OFF
    }

    fn regimes(&self) -> Vec<Regime<1>> {
        let notes = Notes::Hold("");
        vec![
            Regime { name: "near", what: "within 9 ulps", draw: |_| next(NEAR), notes },
            Regime { name: "mixed", what: "all sorts", draw: |_| next(MIXED), notes },
            Regime { name: "none", what: "no hit", draw: |_| next(NONE), notes },
        ]
    }

    fn truth(&self, [case]: [f64; 1], _: Precision) -> Truth {
        match place(case) {
            (NONE, _) | (_, 200..240) => Truth::Miss(""),
            (_, 240..) => Truth::Invalid("not a case"),
            _ => Truth::Hit { t: Root { nearest: 1.0, fine: Wide::from(1.0) }, out: None },
        }
    }

    fn answer<R: Real>(&self, method: usize, [case]: [R; 1]) -> Answer {
        let case: f64 = case.into();
        if is_wrong(method, case) {
            return match place(case).1 {
                5 => Answer::Hit(-1.0),
                6 => Answer::Hit(f64::NAN),
                200..240 => Answer::Hit(1.0),
                _ => Answer::Miss,
            };
        }
        match self.truth([case], Precision::F64) {
            Truth::Hit { .. } => Answer::Hit(beyond_one::<R>(off(method, case))),
            Truth::Miss(_) => Answer::Miss,
            Truth::Invalid(_) => Answer::Invalid,
        }
    }

    /// The point is as far off as t, and `off` has a normal. Where the verdict is wrong the point is worst, and
    /// should not be asked for.
    fn quality<R: Real>(&self, method: usize, [case]: [R; 1], _: &Truth) -> Option<Quality> {
        let case: f64 = case.into();
        let residual = if is_wrong(method, case) { f64::INFINITY } else { off(method, case) as f64 };
        Some(Quality { residual, normal_angle: (method == OFF).then_some(place(case).1 as f64 / 512.0) })
    }

    fn runners<'a, R: Real>(&self, _: &'a [[R; 1]]) -> Vec<Runner<'a>> {
        let runner = |method: usize| -> Runner<'a> {
            Box::new(move |pass, _| {
                sleep(Duration::from_millis(1));
                rays::<R>(method, pass)
            })
        };
        (0..METHODS.len()).map(runner).collect()
    }
}

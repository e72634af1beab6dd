//! How far a method's answers are from the truth.

use std::collections::BTreeMap;

use math::Wide;
use stage::Precision;

use crate::{Answer, Quality, Root, Truth};

/// What a method gets wrong over the cases of a regime at one precision.
#[derive(Clone, Debug, Default)]
pub struct Accuracy {
    /// How many cases were judged.
    pub cases: u64,
    /// How many of them are hits, in truth.
    pub hits: u64,
    /// Hits taken for misses, misses for hits, refusals where there is an answer and answers where
    /// there is none.
    pub wrong: u64,
    /// The errors of t in ulps of the precision, where the verdict is right and a hit.
    pub ulps: Ulps,
    /// The sum over hits and wrong verdicts of the relative error of t; a wrong verdict counts as 1.
    lost: f64,
    /// The largest residual of a hit point, in units of the numbers' own size.
    pub residual: f64,
    /// The largest angle between a normal and the true one, in radians; `None` where there is nothing to
    /// compare.
    pub normal_angle: Option<f64>,
}

/// How a single answer compares with the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judgment {
    /// The verdict is right and there is no t.
    Right,
    /// The verdict is right and a hit: the error of t.
    Off {
        /// In ulps of the precision.
        ulps: u64,
        /// Relative, at most 1.
        relative: f64,
    },
    /// The verdict is wrong.
    Wrong,
}

/// Compares an answer with the truth, for numbers of a precision. A hit at a t below zero, or at NaN, is
/// wrong.
pub fn judge(answer: &Answer, truth: &Truth, precision: Precision) -> Judgment {
    match (answer, truth) {
        (Answer::Invalid, Truth::Invalid(_)) | (Answer::Miss, Truth::Miss(_)) => Judgment::Right,
        (Answer::Hit(t), Truth::Hit { t: root, .. }) if *t >= 0.0 => {
            Judgment::Off { ulps: ulps(*t, root.nearest, precision), relative: relative(*t, root, precision) }
        }
        _ => Judgment::Wrong,
    }
}

/// How many values of the precision lie from one number to another, both rounded to it and neither NaN: 0 for
/// the same, 1 for neighbors. Infinity is the neighbor of the largest number.
pub fn ulps(a: f64, b: f64, precision: Precision) -> u64 {
    let place = |x: f64| match precision {
        Precision::F32 => ordered((x as f32).to_bits().into(), 1 << 31),
        Precision::F64 => ordered(x.to_bits(), 1 << 63),
    };
    place(a).abs_diff(place(b))
}

/// The place of a float in the row of all floats, from its bits: zero has the place 0.
fn ordered(bits: u64, sign: u64) -> i64 {
    let magnitude = (bits & !sign) as i64;
    if bits & sign == 0 { magnitude } else { -magnitude }
}

/// |t − root| / root, at most 1; to within a few roundings.
///
/// A number that the precision cannot have as a normal one, because it is too small or too large, is compared
/// with the nearest there is: a method is not blamed for the end of the range.
fn relative(t: f64, root: &Root, precision: Precision) -> f64 {
    let (smallest_normal, largest) = match precision {
        Precision::F32 => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)),
        Precision::F64 => (f64::MIN_POSITIVE, f64::MAX),
    };
    let leading = root.fine.to_f64();
    if root.nearest < smallest_normal || t > largest || root.nearest > largest {
        // infinity stands for the largest number
        let (t, nearest) = (t.min(largest), root.nearest.min(largest));
        return if t == nearest { 0.0 } else { ((t - nearest) / nearest).abs().min(1.0) };
    }
    let rest = (root.fine - Wide::from(leading)).to_f64();
    (((t - leading) - rest) / leading).abs().min(1.0)
}

impl Accuracy {
    /// Counts one answer, and says how it was judged.
    pub fn count(&mut self, answer: &Answer, truth: &Truth, precision: Precision) -> Judgment {
        self.cases += 1;
        self.hits += u64::from(matches!(truth, Truth::Hit { .. }));
        let judgment = judge(answer, truth, precision);
        match judgment {
            Judgment::Right => {}
            Judgment::Wrong => {
                self.wrong += 1;
                self.lost += 1.0;
            }
            Judgment::Off { ulps, relative } => {
                self.ulps.count(ulps);
                self.lost += relative;
            }
        }
        judgment
    }

    /// Counts the quality of a hit; `None` counts nothing.
    pub fn count_quality(&mut self, quality: Option<Quality>) {
        let Some(Quality { residual, normal_angle }) = quality else { return };
        self.residual = self.residual.max(residual);
        self.normal_angle = larger(self.normal_angle, normal_angle);
    }

    /// Adds what was counted elsewhere.
    pub fn add(&mut self, other: &Accuracy) {
        self.cases += other.cases;
        self.hits += other.hits;
        self.wrong += other.wrong;
        self.lost += other.lost;
        self.ulps.add(&other.ulps);
        self.residual = self.residual.max(other.residual);
        self.normal_angle = larger(self.normal_angle, other.normal_angle);
    }

    /// One number for what is lost: the mean relative error of t, a wrong verdict counting as 1. From 0 to
    /// 1; 0 where there was nothing to hit and nothing was.
    pub fn error(&self) -> f64 {
        let counted = self.ulps.total + self.wrong;
        if counted == 0 { 0.0 } else { self.lost / counted as f64 }
    }

    /// Wrong verdicts as a share of all cases, from 0 to 1; 0 where there are none.
    pub fn wrong_share(&self) -> f64 {
        self.wrong as f64 / self.cases.max(1) as f64
    }
}

fn larger(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.max(b)),
        (one, other) => one.or(other),
    }
}

/// Many errors in ulps, as counts: exact below 256, from there on rounded up to 8 leading binary digits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ulps {
    counts: BTreeMap<u64, u64>,
    total: u64,
    max: u64,
}

impl Ulps {
    /// Counts one error.
    pub fn count(&mut self, ulps: u64) {
        let dropped = (56_u32).saturating_sub(ulps.leading_zeros());
        let rounded_up = ulps | ((1 << dropped) - 1);
        *self.counts.entry(rounded_up).or_default() += 1;
        self.total += 1;
        self.max = self.max.max(ulps);
    }

    fn add(&mut self, other: &Ulps) {
        for (&ulps, &count) in &other.counts {
            *self.counts.entry(ulps).or_default() += count;
        }
        self.total += other.total;
        self.max = self.max.max(other.max);
    }

    /// The error that a share of all, from 0 to 1, does not exceed: 0.5 for the median. From 256 on it is
    /// given up to 0.8 % too high. `None` where there is none.
    pub fn quantile(&self, share: f64) -> Option<u64> {
        let wanted = ((share * self.total as f64).ceil() as u64).max(1);
        let mut seen = 0;
        self.counts.iter().find_map(|(&ulps, &count)| {
            seen += count;
            (seen >= wanted).then_some(ulps.min(self.max))
        })
    }

    /// How many errors are 0, 1, 2, and more.
    pub(crate) fn up_to_three(&self) -> [u64; 4] {
        let [zero, one, two] = [0, 1, 2].map(|ulps| self.counts.get(&ulps).copied().unwrap_or(0));
        [zero, one, two, self.total - zero - one - two]
    }

    /// The largest. `None` where there is none.
    pub fn max(&self) -> Option<u64> {
        (self.total > 0).then_some(self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(t: f64) -> Root {
        Root { nearest: t, fine: Wide::from(t) }
    }

    fn hit(t: f64) -> Answer {
        Answer::Hit(t)
    }

    #[test]
    fn neighbors_are_one_apart() {
        for (a, b, apart) in [
            (1.0, 1.0_f64.next_up(), 1),
            (5e-324, -5e-324, 2),
            (0.0, -0.0, 0),
            (f64::MAX, f64::INFINITY, 1),
            (f64::INFINITY, f64::INFINITY, 0),
        ] {
            assert_eq!(ulps(a, b, Precision::F64), apart, "{a} {b}");
        }
        assert_eq!(ulps(1.0, 1.0 + f64::from(f32::EPSILON), Precision::F32), 1);
    }

    #[test]
    fn a_wrong_verdict_counts_as_one() {
        let truth = Truth::Hit { t: root(2.0), out: None };
        let mut accuracy = Accuracy::default();
        for answer in [hit(2.0), hit(3.0), Answer::Miss, hit(f64::NAN)] {
            accuracy.count(&answer, &truth, Precision::F64);
        }
        // by hand: 0, 1/2, 1, 1
        assert_eq!((accuracy.wrong, accuracy.error()), (2, 2.5 / 4.0));
        accuracy.count(&hit(1.0), &Truth::Miss(""), Precision::F64);
        assert_eq!((accuracy.wrong, accuracy.cases, accuracy.hits), (3, 5, 4));
    }

    /// t = 1/3 to the nearest `f32` is off by what an `f32` cannot say, though it is 0 ulps off.
    #[test]
    fn the_relative_error_is_that_of_the_number_too() {
        let third = Root { nearest: f64::from(1.0_f32 / 3.0), fine: Wide::from(1.0) / Wide::from(3.0) };
        let answer = hit(third.nearest);
        let truth = Truth::Hit { t: third, out: None };
        let Judgment::Off { ulps: 0, relative } = judge(&answer, &truth, Precision::F32) else { panic!() };
        // by hand: 3 t − 1 is exact in f64, and it is (t − 1/3) / (1/3)
        let exact = f64::from(1.0_f32 / 3.0) * 3.0 - 1.0;
        assert!((relative - exact).abs() < 1e-16, "{relative:e} {exact:e}");
    }

    #[test]
    fn no_method_is_blamed_for_the_end_of_the_range() {
        let error = |t: f64, nearest: f64, fine: Wide| {
            let truth = Truth::Hit { t: Root { nearest, fine }, out: None };
            match judge(&hit(t), &truth, Precision::F64) {
                Judgment::Off { relative, .. } => relative,
                other => panic!("{other:?}"),
            }
        };
        let tiny = Wide::from(5e-324) / Wide::from(3.0);
        assert_eq!(error(0.0, 0.0, tiny), 0.0, "the nearest there is");
        assert_eq!(error(5e-324, 0.0, tiny), 1.0);
        assert_eq!(error(f64::from_bits(101), f64::from_bits(100), Wide::from(f64::from_bits(100))), 0.01);
        let huge = Wide::from(f64::MAX) + Wide::from(f64::MAX);
        assert_eq!(error(f64::INFINITY, f64::INFINITY, huge), 0.0);
        assert_eq!(error(f64::MAX, f64::INFINITY, huge), 0.0, "a digit off");
        assert_eq!(error(f64::MAX / 2.0, f64::INFINITY, huge), 0.5);
    }

    #[test]
    fn quantiles_are_what_they_say() {
        let mut ulps = Ulps::default();
        assert_eq!((ulps.quantile(0.5), ulps.max()), (None, None));
        for error in 1..=100 {
            ulps.count(error);
        }
        let shown = [ulps.quantile(0.5), ulps.quantile(0.99), ulps.quantile(1.0), ulps.max()];
        assert_eq!(shown, [Some(50), Some(99), Some(100), Some(100)]);
        ulps.count(1000);
        assert_eq!(ulps.quantile(1.0), Some(1000), "never above the largest");
        ulps.count(5000);
        assert_eq!(ulps.quantile(0.99), Some(1003), "1000 rounded up to 8 binary digits, 1111101011");
        ulps.count(u64::MAX);
        assert_eq!(ulps.max(), Some(u64::MAX));
        let top = ulps.quantile(1.0).unwrap();
        assert!(top as f64 / u64::MAX as f64 > 0.99);
    }
}

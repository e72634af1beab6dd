//! What plain `f64` tells of a ray: the verdict nearly always, and λ with one look at the place where it leads.

use std::cmp::Ordering::{Greater, Less};

use math::{Bounded, Certainty, Real, Sure};

use super::at_once::{Numbers, Wall};
use super::place::{Place, upper_half};
use super::{OpenCone, Verdict};

/// The verdict in plain `f64`, and λ with what it is off by. Only whether the origin is within the wall may take more: a ray
/// that leaves the wall starts beside it by less than plain numbers tell.
#[inline(always)]
pub(super) fn plainly(
    cone: &OpenCone<f64>,
    o: [f64; 3],
    d: [f64; 3],
) -> Option<(Wall, Verdict, Bounded<f64>)> {
    let wall = Wall::of(cone)?;
    let base = f64::xyz(cone.base);
    let mut numbers = wall.numbers(std::array::from_fn(|axis| o[axis] - base[axis]), 0.0, d)?;
    if numbers.c.sign().is_none() {
        numbers.c = Place::at(0.0, &wall, cone, [o, d])?.f;
    }
    let (verdict, lambda) = wall.verdict(&numbers)?;
    Some((wall, verdict, lambda))
}

/// λ from what it is in plain `f64`: for f32 that is enough. For f64 the origin is moved to there, and what is left of
/// the way to the wall is the small root of the same quadratic. `None` where that is not certain.
///
/// A line has one root through which f falls, and one through which it rises. So the small one is the right one if f
/// falls here, or rises, as the verdict says.
#[inline(always)]
pub(super) fn plain_t<R: Real>(
    wall: &Wall,
    cone: &OpenCone<f64>,
    [o, d]: [[f64; 3]; 2],
    verdict: Verdict,
    lambda: Bounded<f64>,
) -> Option<(Option<R>, Certainty)> {
    if R::DIGITS < f64::MANTISSA_DIGITS
        && let Some(t) = lambda.added_to(0.0)
    {
        return Some((Some(t), Certainty::AtOnce));
    }
    let lambda = upper_half(lambda.value);
    let place = Place::at(lambda, wall, cone, [o, d])?;
    let Numbers { a, b, .. } = wall.numbers(place.x, place.reach, d)?;
    let falls = verdict == Verdict::Outer;
    if b.sign() != Some(if falls { Greater } else { Less }) {
        return None;
    }
    let d = b * b - a * place.f;
    if d.sign() != Some(Greater) {
        return None;
    }
    let left = place.f / if falls { b + d.sqrt() } else { b - d.sqrt() };
    Some((Some(left.added_to(lambda)?), Certainty::TwoPart))
}

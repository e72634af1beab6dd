//! Does the point see the light? (CSC418 11.7.4)
//!
//! "Cast a ray toward the light source. If λ* at the first intersection point is 0 ≤ λ ≤ 1, then there exists a surface that
//! occludes the light source." The first one is not needed: any between p̄ and the light will do, and the search ends
//! with it.

use bounds::{Bounded, Tally};
use math::{Real, Vector};

use crate::Starts;

/// A part that stands strictly between the point and the light, the object itself included; `None` where the point sees
/// the light. Of several it is any.
#[inline(always)]
pub fn blocker<R: Real>(
    bounded: &Bounded<'_, R>,
    starts: &Starts<R>,
    light: R::Vec3,
    to_light: R::Vec3,
    counts: &mut impl Tally,
) -> Option<usize> {
    let query = starts.to(light, to_light);
    // a light at the very place from where the ray starts has nothing in between
    if query.ray.direction.is_zero() {
        return None;
    }
    bounded.any_part(&query, counts)
}

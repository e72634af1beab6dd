//! Does the point see the light? (CSC418 11.7.4)
//!
//! "Cast a ray toward the light source. If λ* at the first intersection point is 0 ≤ λ ≤ 1, then there exists a surface that
//! occludes the light source." The first one is not needed: any between p̄ and the light will do, and the search ends
//! with it. What stood before a light a moment ago often does so again, and is tried before anything else.

use bounds::{Bounded, Tally};
use math::{Real, Vector};

use crate::Starts;

/// What stood before each light last. It changes how long an answer takes, and not the answer; so that the tests are
/// counted the same on every run, a picture's tiles begin with nothing.
#[derive(Clone, Debug, Default)]
pub struct LastBlockers {
    /// By light; `usize::MAX` where there was none.
    parts: Vec<usize>,
}

impl LastBlockers {
    /// The place of what stood before a light last.
    #[inline(always)]
    fn of(&mut self, light: usize) -> &mut usize {
        if light >= self.parts.len() {
            self.parts.resize(light + 1, usize::MAX);
        }
        &mut self.parts[light]
    }
}

/// A part that stands strictly between the point and the light, the object itself included; `None` where the point sees
/// the light. Of several it is any.
///
/// `light` is the light's place in the scene and `position` l̄; `to_light` = l̄ − p̄ says to which side the ray
/// leaves. `last` is of this scene alone.
#[inline(always)]
pub fn blocker<R: Real>(
    bounded: &Bounded<'_, R>,
    starts: &Starts<R>,
    (light, position): (usize, R::Vec3),
    to_light: R::Vec3,
    last: &mut LastBlockers,
    counts: &mut impl Tally,
) -> Option<usize> {
    let query = starts.to(position, to_light);
    // a light at the very place from where the ray starts has nothing in between
    if query.ray.direction.is_zero() {
        return None;
    }
    let last = last.of(light);
    if *last != usize::MAX && bounded.hits(*last, &query, counts) {
        return Some(*last);
    }
    let blocker = bounded.any_part(&query, counts)?;
    *last = blocker;
    Some(blocker)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bounds::Leaves;
    use glam::DVec3;
    use math::{Ray3, Span};
    use ray_sphere::{Sphere, robust};

    const BALL: Sphere<f64> = Sphere { center: DVec3::ZERO, radius: 1.0 };

    /// Slip 16, by hand: the top of the unit sphere, and a light straight above it. λ = 0 is the point itself, and
    /// 0 ≤ λ ≤ 1 has it in.
    #[test]
    fn as_printed_a_point_is_in_its_own_shadow() {
        let to_light = Ray3::<f64>::new(DVec3::Y, DVec3::new(0.0, 4.0, 0.0));
        let met = |span| robust(&to_light, &BALL).hit(span).unwrap().map(|hit| hit.t);
        assert_eq!(met(Span::new(0.0, 1.0)), Some(0.0), "as printed");
        assert_eq!(met(Span::new(f64::from_bits(1), 1.0)), None, "0 < λ, as the pseudo-code has it");
    }

    /// And its other end: a light on a ball, as seen from the ground, is at λ = 1, and so is the ball.
    #[test]
    fn as_printed_a_light_on_a_surface_is_behind_it() {
        let light = DVec3::new(0.0, -1.0, 0.0);
        let from_below = Ray3::<f64>::new(DVec3::new(0.0, -3.0, 0.0), DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(robust(&from_below, &BALL).hit(Span::new(0.0, 1.0)).unwrap().map(|hit| hit.t), Some(1.0));
        let starts = Starts {
            origins: [from_below.origin; 2],
            face_normal: DVec3::Y,
            leaves: [Leaves::Unknown; 2],
            skipped: 0.0,
        };
        let span = starts.to(light, from_below.direction).span;
        assert_eq!(robust(&from_below, &BALL).hit(span).unwrap(), None);
    }
}

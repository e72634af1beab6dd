//! Numbers whose squares overflow or vanish: the same question at another scale.
//!
//! Multiplying all lengths by one power of two, and the direction by another, changes no digit and
//! no verdict; t is multiplied by their quotient. Only where the numbers of one question are so far apart that
//! some would vanish at any scale is it left to [`exact`].

use math::wide::{exponent_of, scaled};
use math::{Ray3, Real, Roots, TwoPart, Vector};

use super::{Certainty, Chord, certain, exact, point_and_normal, two_part_difference};
use crate::{Hit3, Sphere};

/// A question at a scale at which its largest length, and its largest component of the direction, are
/// between 1 and 2.
struct Scaled {
    origin: [f64; 3],
    direction: [f64; 3],
    center: [f64; 3],
    radius: f64,
    /// What lengths were multiplied by, as a power of two.
    length_power: i32,
    /// What the direction was multiplied by.
    direction_power: i32,
}

impl Scaled {
    /// The question at its own scale; `None` where a digit would be lost.
    fn of<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Option<Scaled> {
        let [origin, direction, center] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
        let radius: f64 = sphere.radius.into();
        let largest = |numbers: &[f64]| numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let length_power = -exponent_of(largest(&origin).max(largest(&center)).max(radius));
        let direction_power = -exponent_of(largest(&direction));
        let exactly = |x: f64, power: i32| {
            let there = scaled(x, power);
            (scaled(there, -power) == x).then_some(there)
        };
        let all = |v: [f64; 3], power: i32| {
            Some([exactly(v[0], power)?, exactly(v[1], power)?, exactly(v[2], power)?])
        };
        Some(Scaled {
            origin: all(origin, length_power)?,
            direction: all(direction, direction_power)?,
            center: all(center, length_power)?,
            radius: exactly(radius, length_power)?,
            length_power,
            direction_power,
        })
    }

    /// L, with what its rounding dropped.
    fn l(&self) -> [TwoPart; 3] {
        two_part_difference(self.center, self.origin)
    }

    /// The chord at this scale; `None` where it takes exact sums.
    fn chord<R: Real>(&self) -> Option<Chord> {
        certain::<R>(self.l(), self.direction, self.radius)
    }

    /// A chord of this scale as it is at that of the question.
    fn back(&self, chord: &Chord) -> Chord {
        let (length, direction) = (-self.length_power, -self.direction_power);
        let t = |x: f64| scaled(x, length - direction);
        // What lies behind the origin stays behind it, however near.
        let root = |x: f64| if x < 0.0 && t(x) == 0.0 { -f64::SMALLEST } else { t(x) };
        Chord {
            certainty: Certainty::Scaled,
            a: scaled(chord.a, 2 * direction),
            b: scaled(chord.b, length + direction),
            t_close: t(chord.t_close),
            p: chord.p.map(|x| scaled(x, length)),
            correction: t(chord.correction),
            half_chord_squared: scaled(chord.half_chord_squared, 2 * length),
            h: chord.h.map(t),
            c: chord.c.map(|c| scaled(c, 2 * length)),
            roots: chord.roots.map(|Roots { near, far }| Roots { near: root(near), far: root(far) }),
        }
    }
}

/// The chord. For a degenerate ray or sphere it is NaN: neither a miss nor a hit.
#[cold]
#[inline(never)]
pub(super) fn chord<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Chord {
    if sphere.check(ray).is_err() {
        return Chord::NONE;
    }
    let question = Scaled::of(ray, sphere);
    let chord = question.and_then(|question| Some(question.back(&question.chord::<R>()?)));
    chord.unwrap_or_else(|| exact::chord(ray, sphere))
}

/// The hit at the near root or the far one, which is `t` when rounded. The line must hit.
#[cold]
#[inline(never)]
pub(super) fn hit<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, t: R, enters: bool) -> Hit3<R> {
    let found = Scaled::of(ray, sphere).and_then(|question| {
        let chord = question.chord::<R>()?;
        let Scaled { origin, direction, center, radius, length_power, .. } = question;
        let (point, normal) = point_and_normal(origin, direction, center, radius, &chord, enters)?;
        Some((point.map(|x| scaled(x, -length_power)), normal))
    });
    let Some((point, normal)) = found else { return exact::hit(ray, sphere, t, enters) };
    let vector = |v: [f64; 3]| {
        let [x, y, z] = v.map(R::round_from);
        R::vec3(x, y, z)
    };
    Hit3::<R> { t, point: vector(point), normal: vector(normal) }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{two, work};
    use super::*;

    /// By hand: 4 away from the center of a sphere of radius 3, h = 3 and C = 4² − 3²; then all lengths times 2⁵⁰⁰, and
    /// the direction times 2¹⁰⁰.
    #[test]
    fn every_number_comes_back_to_its_scale() {
        let chord = work([0.0, 0.0, -4.0 * two(500)], [0.0, 0.0, two(100)], [0.0; 3], 3.0 * two(500)).chord;
        assert_eq!(
            chord,
            Chord {
                certainty: Certainty::Scaled,
                a: two(200),
                b: 4.0 * two(600),
                t_close: 4.0 * two(400),
                p: [0.0; 3],
                correction: 0.0,
                half_chord_squared: 9.0 * two(1000),
                h: Some(3.0 * two(400)),
                c: Some(7.0 * two(1000)),
                roots: Some(Roots { near: two(400), far: 7.0 * two(400) }),
            }
        );
    }

    /// From the center the roots are ∓2⁻¹²⁰⁰, by hand, and both vanish.
    #[test]
    fn what_vanishes_behind_the_origin_stays_behind_it() {
        let chord = work([0.0; 3], [0.0, 0.0, two(600)], [0.0; 3], two(-600)).chord;
        assert_eq!(chord.certainty, Certainty::Scaled);
        assert_eq!(chord.roots, Some(Roots { near: -f64::from_bits(1), far: 0.0 }));
    }
}

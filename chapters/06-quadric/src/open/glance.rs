//! At a glance: the verdict of [`mod@super::robust`] in plain `f64`, for who does not need the last digits of λ.
//!
//! The verdict comes with λ and a bound on what that is off by (`at_once.rs`). What robust does besides is to look
//! at the place to which λ leads, for the last digits: that is left out.

use math::{Around, Glance, Ray3, Real, Vector};

use super::plain::plainly;
use super::{OpenCone, Verdict};

/// Whether the ray meets the wall ahead, [`Glance::First`] or [`Glance::Misses`], and roughly where first.
///
/// [`Glance::Unsure`] for what happens exactly at an end, at the origin or in one point or nearly so, and
/// for a degenerate ray or cone.
#[inline(always)]
pub fn glance<R: Real>(ray: &Ray3<R>, cone: &OpenCone<R>) -> Glance {
    let (o, d) = (ray.origin.in_f64::<3>(), ray.direction.in_f64::<3>());
    match plainly(&cone.in_f64(), o, d) {
        None => Glance::Unsure,
        Some((_, Verdict::Misses, _)) => Glance::Misses,
        // twice the error, for it was added up in floating point
        Some((_, _, lambda)) => Glance::First(Around { t: lambda.value, off: 2.0 * lambda.error }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// By hand: the cylinder of radius 1 around z from 0 to 2, from x = 5 toward it, above it, and along its side.
    #[test]
    fn closed_forms() {
        let cylinder =
            OpenCone { base: DVec3::ZERO, base_radius: 1.0, apex: DVec3::Z * 2.0, apex_radius: 1.0 };
        let from = |z: f64, d: DVec3| glance(&Ray3::<f64>::new(DVec3::new(5.0, 0.0, z), d), &cylinder);
        let Glance::First(crossing) = from(0.5, -DVec3::X) else { panic!("it meets it") };
        assert!((crossing.t - 4.0).abs() <= crossing.off && crossing.off < 1e-11, "{crossing:?}");
        assert_eq!(from(2.5, -DVec3::X), Glance::Misses);
        assert_eq!(from(0.5, DVec3::X), Glance::Misses);
        assert_eq!(from(2.0, -DVec3::X), Glance::Unsure, "along the very edge");
    }
}

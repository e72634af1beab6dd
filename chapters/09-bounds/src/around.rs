//! A sphere around a box.

use math::wide::scaled;
use math::{Real, Vector};
use ray_sphere::Sphere;

use crate::Box3;

/// A sphere around all of a box: its center in the middle, its radius half the diagonal. `None` where it
/// would not be finite in R.
///
/// The middle is rounded to R, and then each corner is no farther than the farthest face on every axis, so
/// the radius is the length of those three distances; its few roundings are made up for by four units of the
/// last digit of `f64`, and then it is rounded up to R.
pub fn sphere_around<R: Real>(bounds: &Box3) -> Option<Sphere<R>> {
    let [low, high] = [bounds.low, bounds.high].map(|corner| corner.map(f64::from));
    // exercise middle: From which point is the farthest corner of the box as near as can be?
    let middle: [R; 3] = std::array::from_fn(|axis| R::round_from((low[axis] + high[axis]) / 2.0));
    // end middle
    let center = R::vec3(middle[0], middle[1], middle[2]);
    let c: [f64; 3] = center.in_f64();
    // exercise farthest: How far from the center is the farther face, on each axis?
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| (c[axis] - low[axis]).max(high[axis] - c[axis]));
    // end farthest
    // the faces are f32, so that their squares are f64 that neither overflow nor vanish
    // exercise radius: How far is it to a corner?
    let radius: f64 = (x * x + y * y + z * z).sqrt() * (1.0 + 4.0 * f64::EPSILON);
    // end radius
    let nearest = R::round_from(radius);
    let radius = if Into::<f64>::into(nearest) < radius { next_up(nearest) } else { nearest };
    let is_ball = center.is_finite() && radius.is_finite() && radius > R::from(0.0);
    is_ball.then_some(Sphere { center, radius })
}

/// A number above x > 0, by a unit of the last digit or two.
fn next_up<R: Real>(x: R) -> R {
    let unit = R::round_from(scaled(1.0, 1 - R::DIGITS as i32));
    x + x * unit + R::SMALLEST
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: the corners of the box from (0, 0, 0) to (2, 4, 4) are 3 from its middle.
    #[test]
    fn all_corners_are_within() {
        let bounds = Box3 { low: [0.0; 3], high: [2.0, 4.0, 4.0] };
        let sphere = sphere_around::<f64>(&bounds).unwrap();
        assert_eq!(sphere.center.to_array(), [1.0, 2.0, 2.0]);
        assert!((3.0..3.0 + 1e-14).contains(&sphere.radius));
        let third = Box3 { low: [-0.1, 0.1, 1.0 / 3.0], high: [0.7, 0.3, 1e6] };
        let sphere = sphere_around::<f32>(&third).unwrap();
        for corner in 0..8 {
            let at = |axis: usize| if corner >> axis & 1 == 0 { third.low[axis] } else { third.high[axis] };
            let away: f64 = (0..3)
                .map(|axis| (f64::from(at(axis)) - f64::from(sphere.center.to_array()[axis])).powi(2))
                .sum();
            assert!(away.sqrt() <= f64::from(sphere.radius));
        }
    }

    /// From the smallest number to nearly the largest: above it, and by two units of its last digit at most.
    #[test]
    fn the_next_number_up_is_above_and_near() {
        fn assert_next<R: Real>(least: i32, most: i32) {
            for power in least..most {
                for factor in [1.0, 1.5, 1.75] {
                    let x = R::round_from(factor * scaled(1.0, power));
                    let (size, off): (f64, f64) = (x.into(), (next_up(x) - x).into());
                    let digit: f64 = scaled(1.0, 1 - R::DIGITS as i32) * size;
                    assert!(off > 0.0 && off <= 2.0 * digit.max(R::SMALLEST.into()), "{size:e} {off:e}");
                }
            }
        }
        assert_next::<f32>(-149, 127);
        assert_next::<f64>(-1074, 1023);
    }

    #[test]
    fn what_has_no_sphere() {
        let endless = Box3 { low: [f32::NEG_INFINITY; 3], high: [f32::INFINITY; 3] };
        assert_eq!(sphere_around::<f64>(&endless), None);
        assert_eq!(sphere_around::<f64>(&Box3 { low: [1.0; 3], high: [1.0; 3] }), None, "a point");
    }
}

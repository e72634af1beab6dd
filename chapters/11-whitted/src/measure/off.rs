//! How far colors are from others.

use shading::Rgb;

/// How far the linear radiance of pixels, before clamping, is from what it should be; over all channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Off {
    /// The root of the mean square.
    pub rmse: f64,
    /// The largest.
    pub largest: f64,
}

impl Off {
    /// How far some colors are from others. What is no number is infinitely far from any.
    pub(super) fn of(seen: &[Rgb], exact: &[Rgb]) -> Off {
        let pairs = seen.iter().zip(exact).flat_map(|(seen, exact)| seen.0.into_iter().zip(exact.0));
        let (mut sum, mut largest, mut count) = (0.0, 0.0_f64, 0.0);
        for (seen, exact) in pairs {
            let off = (seen - exact).abs();
            let off = if off.is_nan() && seen != exact { f64::INFINITY } else { off };
            sum += off * off;
            largest = largest.max(off);
            count += 1.0;
        }
        Off { rmse: if count > 0.0 { (sum / count).sqrt() } else { 0.0 }, largest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: of six channels one is off by 3 and one by 4; √(25/6).
    #[test]
    fn two_of_six_channels_are_off() {
        let seen = [Rgb([1.0, 2.0, 3.0]), Rgb([0.0, 0.0, 9.0])];
        let exact = [Rgb([1.0, 5.0, 3.0]), Rgb([0.0, 0.0, 5.0])];
        assert_eq!(Off::of(&seen, &exact), Off { rmse: (25.0_f64 / 6.0).sqrt(), largest: 4.0 });
        assert_eq!(Off::of(&[Rgb([f64::NAN; 3])], &exact).largest, f64::INFINITY);
        assert_eq!(Off::of(&[], &[]), Off::default());
    }
}

//! A box around the wall.

use math::Real;

use super::OpenCone;

/// How much larger an extent is taken than it comes out: 16 u, with u = 2^−53 the error of one operation.
///
/// The components of v, rounded and divided, err by 2 u, their squares by 5 u, the sums of two by 6 u and of three by 7 u,
/// the quotient by 14 u, its root by 8 u, and times the radius by 9 u; making it larger adds one more.
const OUTWARD: f64 = 1.0 + 8.0 * f64::EPSILON;

/// Squares of what is less than this much of v may vanish. It is taken for what is there.
const LEAST: f64 = 1e-140;

impl<R: Real> OpenCone<R> {
    /// The corners of a box that no point of the wall is outside of, the lowest coordinates first.
    ///
    /// A circle of radius r reaches r √(1 − v_i² / v·v) from its middle along the i-th axis, and the wall is between its
    /// two circles. The box is larger than that by a few roundings; where it reaches beyond the largest number it is
    /// infinite. For measures that [`OpenCone::check`] refuses it means nothing.
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let cone = self.in_f64();
        let [base, apex] = [cone.base, cone.apex].map(f64::xyz);
        // Half of each end, for a difference that cannot overflow.
        let is_huge = |x: f64| x.abs() > 1e300;
        let half = if base.into_iter().chain(apex).any(is_huge) { 0.5 } else { 1.0 };
        let v = [0, 1, 2].map(|axis| half * apex[axis] - half * base[axis]);
        let across = across_axis(v, [0, 1, 2].map(|axis| apex[axis] == base[axis]));

        let reach = |middle: f64, radius: f64, across: f64| {
            let extent = radius * across;
            // What is exactly zero, of a radius or of a circle across the axis, is that.
            if radius == 0.0 || across == 0.0 {
                return (middle, middle);
            }
            let extent = (extent * OUTWARD).next_up();
            ((middle - extent).next_down(), (middle + extent).next_up())
        };
        let (mut low, mut high) = ([0.0; 3], [0.0; 3]);
        for axis in 0..3 {
            let (base_low, base_high) = reach(base[axis], cone.base_radius, across[axis]);
            let (apex_low, apex_high) = reach(apex[axis], cone.apex_radius, across[axis]);
            low[axis] = base_low.min(apex_low);
            high[axis] = base_high.max(apex_high);
        }
        (low, high)
    }
}

/// √(1 − v_i² / v·v) for each axis, as √((v_j² + v_k²) / v·v), which has no difference; not less than it is, but for
/// roundings. `is_none` says which components of v are zero, before any vanishes.
fn across_axis(v: [f64; 3], is_none: [bool; 3]) -> [f64; 3] {
    let longest = v.iter().fold(0.0, |most: f64, component| most.max(component.abs()));
    let squares = v.map(|component| (component / longest) * (component / longest));
    let whole = squares[0] + squares[1] + squares[2];
    [[1, 2], [2, 0], [0, 1]].map(|[j, k]| {
        if is_none[j] && is_none[k] {
            return 0.0;
        }
        ((squares[j] + squares[k]) / whole).sqrt().max(LEAST)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    type V = <f64 as Real>::Vec3;

    #[test]
    fn a_box_holds_the_wall_and_little_more() {
        // by hand: v = (3, 0, 4): across the axis 4/5 of a radius in x, all of it in y, 3/5 of it in z
        let leaning = OpenCone::new(V::new(1.0, 1.0, 1.0), 5.0, V::new(4.0, 1.0, 5.0), 10.0);
        let (low, high) = leaning.bounds();
        for (got, exact, out) in [(low, [-4.0, -9.0, -2.0], -1.0), (high, [12.0, 11.0, 11.0], 1.0)] {
            for axis in 0..3 {
                let beyond = (got[axis] - exact[axis]) * out;
                assert!((0.0..4e-14).contains(&beyond), "{low:?} {high:?}");
            }
        }
        let (low, high) = OpenCone::new(V::Z, 2.0, V::Z * 5.0, 0.0).bounds();
        assert_eq!([low[2], high[2]], [1.0, 5.0], "nothing to round along its own axis");
        // by hand: wide as the largest number, so that it ends beyond it
        let (low, high) = OpenCone::new(V::X * -f64::MAX, f64::MAX, V::X * f64::MAX, f64::MAX).bounds();
        assert_eq!((low[0], high[0]), (-f64::MAX, f64::MAX));
        assert!(low[1] <= -f64::MAX && high[1] >= f64::MAX);
        let (low, _) = OpenCone::new(V::Y * -f64::MAX, f64::MAX, V::ONE, 1.0).bounds();
        assert_eq!(low[1], f64::NEG_INFINITY, "it leans by a digit");
        // by hand: leaning by less than a square can tell
        let (low, high) = OpenCone::new(V::ZERO, 1.0, V::new(1.0, 1e-200, 0.0), 1.0).bounds();
        assert!(low[0] <= -1e-200 && high[0] >= 1.0 && high[0] < 1.0_f64.next_up().next_up());
    }

    /// By hand: v = (6, 8, 0) s is no number, 8 s being 2^1024: across it 4/5 of a radius in x, 3/5 of it in y, all of
    /// it in z.
    #[test]
    fn a_wall_may_be_longer_than_the_largest_number() {
        let s = 2.0_f64.powi(1021);
        let [base, apex] = [V::new(-3.0, -4.0, 4.0), V::new(3.0, 4.0, 4.0)].map(|middle| middle * s);
        assert!(!(apex - base).is_finite());
        let (low, high) = OpenCone::new(base, 1.25 * s, apex, 1.25 * s).bounds();
        for (got, exact, out) in [(low, [-4.0, -4.75, 2.75], -1.0), (high, [4.0, 4.75, 5.25], 1.0)] {
            for axis in 0..3 {
                // 9 u and 16 u of at most 5/4, then twice a unit of the last digit of less than 8
                let beyond = (got[axis] / s - exact[axis]) * out;
                assert!((0.0..=24.0 * f64::EPSILON).contains(&beyond), "{low:?} {high:?}");
            }
        }
    }
}

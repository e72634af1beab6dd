//! The mirror direction (CSC418 11.7.1).

use math::{Real, Vector};

/// m⃗_s = −2 (d⃗·n⃗) n⃗ + d⃗, with what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror<R: Real> {
    /// d⃗·n⃗
    pub d_dot_n: R,
    /// m⃗_s, as long as d⃗.
    pub m_s: R::Vec3,
}

/// The mirror direction of `d`, of any length, at a surface with the unit normal `n`, which may point to
/// either side.
#[inline(always)]
pub fn mirror<R: Real>(d: R::Vec3, n: R::Vec3) -> Mirror<R> {
    // exercise d_dot_n: How much of d⃗ goes along the normal?
    let d_dot_n: R = d.dot(n);
    // end d_dot_n
    // exercise m_s: Which part of d⃗ does a mirror turn over, and which does it leave as it is?
    Mirror { d_dot_n, m_s: d - n * (d_dot_n + d_dot_n) }
    // end m_s
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// By hand: down at 3-4-5 and up again.
    #[test]
    fn as_it_comes_in_so_it_goes_out() {
        let d = DVec3::new(3.0, -4.0, 0.0);
        for n in [DVec3::Y, -DVec3::Y] {
            assert_eq!(mirror::<f64>(d, n).m_s, DVec3::new(3.0, 4.0, 0.0));
        }
    }
}

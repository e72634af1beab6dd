//! Two stars of whole numbers to try the rules on, of the same five points.

use math::Real;

/// A star with ten corners, every other one a notch. It overlaps nothing; two of its sides are level, and so are
/// some of its corners: (±10, 3) with (±2, 3), and (−4, −1) with (4, −1).
pub const CONCAVE: [[f32; 2]; 10] = [
    [0.0, 10.0],
    [-2.0, 3.0],
    [-10.0, 3.0],
    [-4.0, -1.0],
    [-6.0, -8.0],
    [0.0, -4.0],
    [6.0, -8.0],
    [4.0, -1.0],
    [10.0, 3.0],
    [2.0, 3.0],
];

/// A pentagram: its five sides cross each other, and go around its middle twice.
pub const PENTAGRAM: [[f32; 2]; 5] = [[0.0, 10.0], [-6.0, -8.0], [10.0, 3.0], [-10.0, 3.0], [6.0, -8.0]];

/// The corners in the plane z = 0.
pub fn in_space<R: Real>(star: &[[f32; 2]]) -> Vec<R::Vec3> {
    star.iter().map(|&[x, y]| R::vec3(R::from(x), R::from(y), R::from(0.0))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_stars_are_their_own_mirror_images() {
        let is_in = |star: &[[f32; 2]], corner: [f32; 2]| star.contains(&corner);
        assert!(CONCAVE.iter().all(|&[x, y]| is_in(&CONCAVE, [-x, y])));
        assert!(PENTAGRAM.iter().all(|&[x, y]| is_in(&PENTAGRAM, [-x, y]) && is_in(&CONCAVE, [x, y])));
    }
}

//! A letter F to look at: its mirror image and its upside-down image are easy to tell apart.

use math::{Real, Vector};

/// The letter, five columns by seven rows, the top row first.
const F: [&str; 7] = ["#####", "#....", "#....", "####.", "#....", "#....", "#...."];

/// The letter stands upright at this distance before the eye, its middle on the axis, 1 wide and 1.4 high.
pub const DISTANCE: f64 = 2.0;
/// The side of one of its squares, in the same units.
pub const SQUARE: f64 = 0.2;

/// `shoot`: where the ray from the eye at the origin along `direction`, of any length, meets the upright
/// plane of the letter, z = [`DISTANCE`] in camera coordinates (z into the scene); `None` for a ray that
/// points away from it or runs along it.
pub fn shoot<R: Real>(direction: R::Vec3) -> Option<R::Vec3> {
    let z = direction.components()[2];
    if z <= R::from(0.0) {
        return None;
    }
    Some(direction * (R::round_from(DISTANCE) / z))
}

/// `shade`: whether the point of its plane that was hit belongs to the letter; false for a miss.
pub fn shade<R: Real>(point: Option<R::Vec3>) -> bool {
    let Some(point) = point else { return false };
    let (x, y): (f64, f64) = (point.x().into(), point.y().into());
    let (column, row) = ((x / SQUARE + 2.5).floor(), (3.5 - y / SQUARE).floor());
    let inside = (0.0..5.0).contains(&column) && (0.0..7.0).contains(&row);
    inside && F[row as usize].as_bytes()[column as usize] == b'#'
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_eye_sees_an_upright_f_and_the_film_one_on_its_head() {
        let seen = |x: f64, y: f64| shade::<f64>(shoot::<f64>(DVec3::new(x, y, 1.0)));
        // the plane in front at half the letter's distance: half its size
        assert!(seen(0.18, 0.3) && !seen(0.18, -0.3), "the bar is on top");
        // light through the pinhole reaches the film behind at the opposite point
        let on_film = |x: f64, y: f64| seen(-x, -y);
        assert!(on_film(-0.18, -0.3) && !on_film(-0.18, 0.3), "the bar is at the bottom, and left is right");
    }

    #[test]
    fn a_ray_that_points_away_hits_nothing() {
        assert_eq!(shoot::<f64>(-DVec3::Z), None);
        assert_eq!(shoot::<f64>(DVec3::X), None);
        assert!(!shade::<f64>(None));
    }
}

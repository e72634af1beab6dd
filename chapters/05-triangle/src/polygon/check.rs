//! Do these corners make a polygon, and if not, which one is to blame?

use std::fmt;

use math::{Real, Vector, Wide};
use ray_plane::Plane;

/// A corner of a polygon may be so far from its plane, in units of the longest side of the box around it: what
/// decimal places round away in a file, and much less than a reader would call bent.
const PLANAR: f64 = 1e-4;

/// Why corners make no planar polygon. Corners are counted from 1, and distances are in units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotAPolygon {
    /// There are fewer than three.
    TooFewCorners {
        /// How many there are.
        count: usize,
    },
    /// A coordinate of a corner is infinite or NaN.
    NotFinite {
        /// Which one, from 1.
        corner: usize,
    },
    /// A corner is the one before it over again; the first one, the last.
    Repeated {
        /// Which one, from 1.
        corner: usize,
    },
    /// Newell's normal is zero: the corners lie on a line, or the loops of the polygon cancel.
    NoArea,
    /// A corner is farther from the plane than a ten-thousandth of the longest side of the box around the
    /// polygon.
    NotPlanar {
        /// Which one, from 1.
        corner: usize,
        /// How far it is from the plane.
        distance: f64,
        /// How far it may be.
        allowed: f64,
    },
}

impl fmt::Display for NotAPolygon {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotAPolygon::TooFewCorners { count } => {
                write!(f, "a polygon has three corners or more, not {count}: add the missing ones")
            }
            NotAPolygon::NotFinite { corner } => {
                write!(f, "corner {corner} is infinite or not a number: give it three finite coordinates")
            }
            NotAPolygon::Repeated { corner: 1 } => {
                write!(f, "the last corner is the first one again: leave it out, a polygon closes by itself")
            }
            NotAPolygon::Repeated { corner } => {
                write!(f, "corner {corner} is the same as corner {}: leave one of them out", corner - 1)
            }
            NotAPolygon::NoArea => {
                write!(
                    f,
                    "the polygon has no area (its corners lie on a line, or its loops cancel): move a corner or split it"
                )
            }
            NotAPolygon::NotPlanar { corner, distance, allowed } => write!(
                f,
                "corner {corner} is {distance:.3e} off the plane of the polygon, and {allowed:.3e} is allowed: move it there, or \
                 split the polygon into triangles"
            ),
        }
    }
}

impl std::error::Error for NotAPolygon {}

/// Enough corners, all of them finite, none twice in a row.
pub(super) fn corners<R: Real>(corners: &[R::Vec3]) -> Result<(), NotAPolygon> {
    let count = corners.len();
    if count < 3 {
        return Err(NotAPolygon::TooFewCorners { count });
    }
    if let Some(at) = corners.iter().position(|corner| !corner.is_finite()) {
        return Err(NotAPolygon::NotFinite { corner: at + 1 });
    }
    // the second and so on against the one before it, and last the first
    let repeated = (1..=count).find(|&at| corners[at % count] == corners[at - 1]);
    repeated.map_or(Ok(()), |at| Err(NotAPolygon::Repeated { corner: at % count + 1 }))
}

/// Every corner within [`PLANAR`] of the plane. In numbers that do not overflow.
pub(super) fn planar<R: Real>(corners: &[R::Vec3], plane: &Plane<R>) -> Result<(), NotAPolygon> {
    let n = Wide::vector::<R, 3>(plane.normal);
    let p_1 = Wide::vector::<R, 3>(plane.point);
    let dot = |a: [Wide; 3], b: [Wide; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let n_length = dot(n, n).sqrt();
    let allowed = extent::<R>(corners) * Wide::from(PLANAR);
    for (at, &corner) in corners.iter().enumerate() {
        let corner = Wide::vector::<R, 3>(corner);
        let from_p_1: [Wide; 3] = std::array::from_fn(|axis| corner[axis] - p_1[axis]);
        let signed = dot(from_p_1, n) / n_length;
        let distance = if signed.is_negative() { -signed } else { signed };
        if (allowed - distance).is_negative() {
            let [distance, allowed] = [distance, allowed].map(Wide::to_f64);
            return Err(NotAPolygon::NotPlanar { corner: at + 1, distance, allowed });
        }
    }
    Ok(())
}

/// The longest side of the box around the corners.
fn extent<R: Real>(corners: &[R::Vec3]) -> Wide {
    let coordinates: Vec<[f64; 3]> = corners.iter().map(|corner| corner.in_f64()).collect();
    let side = |axis: usize| {
        let along = || coordinates.iter().map(|corner| corner[axis]);
        let (low, high) = (along().fold(f64::INFINITY, f64::min), along().fold(-f64::INFINITY, f64::max));
        Wide::from(high) - Wide::from(low)
    };
    let longer = |a: Wide, b: Wide| if (a - b).is_negative() { b } else { a };
    longer(side(0), longer(side(1), side(2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: a box of 1, 4 and 2, whichever axis each is along.
    #[test]
    fn the_extent_is_the_longest_of_the_three() {
        for turn in 0..3 {
            let turned = |mut corner: [f64; 3]| {
                corner.rotate_right(turn);
                glam::DVec3::from(corner)
            };
            let corners = [[0.0, 3.0, 5.0], [1.0, 7.0, 6.0], [0.5, 4.0, 7.0]].map(turned);
            assert_eq!(extent::<f64>(&corners).to_f64(), 4.0, "turned by {turn}");
        }
    }
}

//! Which part of the solid does the ray meet first? Answered by signs alone, so that with exact numbers it is exact.
//!
//! The solid is convex: along the line f is below zero for one stretch (the cone's f has a second stretch, above the
//! apex, but not between the planes), and z is between the planes for another. The ray is in the solid while it is
//! in both. No two λ are compared for that: f at the planes, and whether it falls or rises there, tell all.

use std::cmp::Ordering::{Equal, Greater, Less};

use math::{Real, Sure};

use super::line::{Crossing, Line};
use crate::Part;

/// What becomes of the ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It meets nothing at λ ≥ 0.
    Misses,
    /// It starts on the surface, at this part: λ = 0.
    Starts(Part),
    /// It starts outside, and enters or touches the solid here.
    Enters(Place),
    /// It starts strictly inside, and leaves the solid here.
    Leaves(Place),
}

/// Where a ray meets the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The part that it meets. A point of the rim belongs to the wall.
    pub part: Part,
    /// The part whose plane it crosses there: then λ is a quotient. `None`: λ is a root of the wall's equation.
    pub plane: Option<Part>,
}

impl Place {
    const WALL: Place = Place { part: Part::Wall, plane: None };

    /// The inner points of a cap.
    #[inline(always)]
    fn on(cap: Part) -> Place {
        Place { part: cap, plane: Some(cap) }
    }

    /// The rim of a cap; the apex is the rim of nothing and its own part.
    #[inline(always)]
    fn rim(cap: Part) -> Place {
        Place { part: if cap == Part::Apex { Part::Apex } else { Part::Wall }, plane: Some(cap) }
    }
}

impl Verdict {
    /// The part that is met; `None` for a miss.
    #[inline(always)]
    pub fn part(self) -> Option<Part> {
        match self {
            Verdict::Misses => None,
            Verdict::Starts(part) => Some(part),
            Verdict::Enters(place) | Verdict::Leaves(place) => Some(place.part),
        }
    }

    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Verdict::Misses => "misses",
            Verdict::Starts(_) => "starts on the surface",
            Verdict::Enters(_) => "starts outside and enters",
            Verdict::Leaves(_) => "starts inside and leaves",
        }
    }
}

/// Where along the line f is known to be above zero: at the ray's origin, or where it comes through a plane.
enum From<N> {
    Origin,
    Plane(Crossing<N>),
}

impl<N: Sure> Line<N> {
    /// What the ray meets first at λ ≥ 0; `None` where a sign is in doubt, which with [`math::Exact`] none is.
    #[inline(always)]
    pub fn verdict(&self) -> Option<Verdict> {
        let exit = self.exit_plane()?;
        let (bottom, top) = self.shape.ends();
        let (to_bottom, to_top) = (self.rise_to(bottom).sign()?, self.rise_to(top).sign()?);
        let entry = match (to_bottom, to_top) {
            (Greater, _) => Some(bottom),
            (_, Less) => Some(top),
            _ => None,
        };
        let Some(entry) = entry else {
            let on_plane = match (to_bottom, to_top) {
                (Equal, _) => Some(bottom),
                (_, Equal) => Some(top),
                _ => None,
            };
            return self.between_the_planes(on_plane, exit);
        };
        let Some(exit) = exit.filter(|&exit| exit != entry) else { return Some(Verdict::Misses) };
        self.beyond_a_plane(entry, exit)
    }

    /// From above or below, toward the solid: through the plane `entry`.
    #[inline(always)]
    fn beyond_a_plane(&self, entry: Part, exit: Part) -> Option<Verdict> {
        let crossing = self.crossing(entry)?;
        match crossing.wall {
            Less => Some(Verdict::Enters(Place::on(entry))),
            Equal => Some(Verdict::Enters(Place::rim(entry))),
            Greater => self.outside_the_wall(From::Plane(crossing), Some(exit)),
        }
    }

    /// From between the planes, or from one of them.
    #[inline(always)]
    fn between_the_planes(&self, on_plane: Option<Part>, exit: Option<Part>) -> Option<Verdict> {
        match (self.c().sign()?, on_plane) {
            (Greater, _) => self.outside_the_wall(From::Origin, exit),
            (Equal, Some(plane)) => Some(Verdict::Starts(Place::rim(plane).part)),
            (Equal, None) => Some(Verdict::Starts(Part::Wall)),
            (Less, Some(plane)) => Some(Verdict::Starts(plane)),
            (Less, None) => Some(Verdict::Leaves(self.leaves(exit)?)),
        }
    }

    /// Where a line that meets the solid leaves it, at an λ of either sign; `None` where a sign is in doubt.
    ///
    /// What it answers for a line that does not meet the solid means nothing.
    pub fn exit(&self) -> Option<Place> {
        self.leaves(self.exit_plane()?)
    }

    /// It leaves through the cap where f is below zero there; if it is above, it left through the wall before.
    #[inline(always)]
    fn leaves(&self, exit: Option<Part>) -> Option<Place> {
        let Some(exit) = exit else { return Some(Place::WALL) };
        Some(match self.crossing(exit)?.wall {
            Less => Place::on(exit),
            Equal => Place::rim(exit),
            Greater => Place::WALL,
        })
    }

    /// The plane that lies ahead, whichever side of it the origin is; `Some(None)` where the ray is parallel to both.
    #[inline(always)]
    fn exit_plane(&self) -> Option<Option<Part>> {
        let (bottom, top) = self.shape.ends();
        Some(match self.d[2].sign()? {
            Less => Some(bottom),
            Equal => None,
            Greater => Some(top),
        })
    }

    /// From a place between the planes where f > 0, on to the plane `exit`: does f come down to zero on the way?
    #[inline(always)]
    fn outside_the_wall(&self, from: From<N>, exit: Option<Part>) -> Option<Verdict> {
        let enters = Some(Verdict::Enters(Place::WALL));
        let rises_at_exit = match exit {
            None => true,
            Some(exit) => {
                let crossing = self.crossing(exit)?;
                match crossing.wall {
                    // From above zero to below: once, between here and there.
                    Less => return enters,
                    // It ends at zero: having come up from below, or not having been there before.
                    Equal => {
                        let slope = self.slope(&crossing)?;
                        return if slope == Greater {
                            enters
                        } else {
                            Some(Verdict::Enters(Place::rim(exit)))
                        };
                    }
                    Greater => self.slope(&crossing)? == Greater,
                }
            }
        };
        // Above zero at both ends: it falls, touches zero at least, and rises again.
        if !rises_at_exit {
            return Some(Verdict::Misses);
        }
        let falls = match from {
            From::Origin => self.b().sign()? == Greater,
            From::Plane(crossing) => self.slope(&crossing)? == Less,
        };
        if falls && self.discriminant().sign()? != Less { enters } else { Some(Verdict::Misses) }
    }

    /// λ of a verdict to the precision of R, off by less than a unit of its last digit, and never below zero. `None` for a
    /// miss, and where the numbers are not good enough for that, which [`math::Exact`] is.
    #[inline(always)]
    pub fn lambda<R: Real>(&self, verdict: Verdict) -> Option<R> {
        match verdict {
            Verdict::Misses => None,
            Verdict::Starts(_) => Some(R::from(0.0)),
            Verdict::Enters(place) => self.lambda_where_f_falls(place),
            Verdict::Leaves(place) => self.lambda_where_f_rises(place),
        }
    }

    /// λ of a place where the line enters, of either sign, to the precision of R as [`Line::lambda`] has
    /// it. `None` where the numbers are not good enough for that.
    #[inline(always)]
    pub fn lambda_where_f_falls<R: Real>(&self, place: Place) -> Option<R> {
        self.lambda_at(place, -1.0)
    }

    /// λ of a place where the line leaves, likewise.
    #[inline(always)]
    pub fn lambda_where_f_rises<R: Real>(&self, place: Place) -> Option<R> {
        self.lambda_at(place, 1.0)
    }

    /// f falls through the root (B − √D) / A and rises through (B + √D) / A, whatever the sign of A: f′ is 2 (A λ − B).
    #[inline(always)]
    fn lambda_at<R: Real>(&self, place: Place, s: f64) -> Option<R> {
        if let Some(plane) = place.plane {
            return N::quotient(&self.rise_to(plane), &self.d[2]);
        }
        let quadratic = self.quadratic();
        if quadratic.a.sign() == Some(Equal) {
            // Parallel to the slope of the cone: −2 B λ + C = 0
            return N::quotient(&quadratic.c, &(quadratic.b.clone() + quadratic.b));
        }
        N::root(&quadratic, s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape::{self, Cone, Cylinder};
    use math::Exact;

    fn verdict(shape: Shape, origin: [f64; 3], direction: [f64; 3]) -> Verdict {
        Line::<Exact>::beside_unit(shape, origin, direction).verdict().unwrap()
    }

    /// By hand: (3 − λ, 0, ±(2 − ½λ)) is at x = 1, z = ±1 at λ = 2, and (5/2 − λ, 0, −1 + ½λ) at x = ½, z = 0.
    #[test]
    fn a_rim_is_the_walls() {
        for (shape, origin, d_z, plane) in [
            (Cylinder, [3.0, 0.0, 2.0], -0.5, Part::Top),
            (Cylinder, [3.0, 0.0, -2.0], 0.5, Part::Bottom),
            (Cone, [2.5, 0.0, -1.0], 0.5, Part::Base),
        ] {
            let rim = Place { part: Part::Wall, plane: Some(plane) };
            assert_eq!(verdict(shape, origin, [-1.0, 0.0, d_z]), Verdict::Enters(rim));
            let on_rim = [origin[0] - 2.0, 0.0, origin[2] + 2.0 * d_z];
            assert_eq!(verdict(shape, on_rim, [-1.0, 0.0, d_z]), Verdict::Starts(Part::Wall));
        }
    }

    /// By hand: (2 − λ, 0, 3 − λ) is at (0, 0, 1) at λ = 2.
    #[test]
    fn the_apex_is_its_own() {
        let apex = Place { part: Part::Apex, plane: Some(Part::Apex) };
        assert_eq!(verdict(Cone, [2.0, 0.0, 3.0], [-1.0, 0.0, -1.0]), Verdict::Enters(apex));
        assert_eq!(verdict(Cone, [0.0, 0.0, 1.0], [-1.0, 0.0, -1.0]), Verdict::Starts(Part::Apex));
    }
}

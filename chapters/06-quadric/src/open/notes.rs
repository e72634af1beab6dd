//! CSC418 11.3.5 for any axis: both roots of the wall's quadratic, each tested.
//!
//! The page's cylinder stands on the z axis, where the distance of a point from the axis is √(x² + y²). From any other
//! axis, b + s v, it is what Pythagoras leaves of w = x − b:
//!
//! ```text
//! s = w·v / v·v
//! ‖w‖² − s² v·v = (r_b + s (r_a − r_b))²
//! ```
//!
//! Along the ray a + λ d both w and s are linear in λ, and so is the radius: a quadratic in λ.

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use super::OpenCone;
use crate::Hit3;

/// Every number of the method. The ray is a + λ d; B is half of the linear coefficient, as on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notes<R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The cone.
    pub cone: OpenCone<R>,
    /// v = apex − base
    pub v: R::Vec3,
    /// w = a − b
    pub w: R::Vec3,
    /// v·v
    pub vv: R,
    /// s_a = w·v / v·v, the height of the origin.
    pub s_a: R,
    /// s_d = d·v / v·v, how fast s rises.
    pub s_d: R,
    /// r = r_b + s_a k, the radius at the height of the origin, with k = r_a − r_b.
    pub r: R,
    /// r_d = s_d k, how fast it grows.
    pub r_d: R,
    /// A = d·d − s_d² v·v − r_d²
    pub a: R,
    /// B = w·d − s_a s_d v·v − r r_d
    pub b: R,
    /// C = w·w − s_a² v·v − r²
    pub c: R,
    /// D = B² − A C
    pub d: R,
    /// The points of λ1 and λ2.
    pub candidates: [Candidate<R>; 2],
}

/// A root, if there is one, and what the test says of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<R: Real> {
    /// λ, in lengths of d; `None` where there is no such root.
    pub lambda: Option<R>,
    /// s_a + λ s_d; zero where there is no λ.
    pub s: R,
    /// p(λ) = a + λ d; the origin of the ray where there is no λ.
    pub point: R::Vec3,
    /// What the test says.
    pub test: Test,
}

/// What the test of a root says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// There is none: D < 0, or A = 0 and no other root.
    NoPoint,
    /// Not 0 ≤ s ≤ 1: beyond an end; or a point whose numbers overflowed.
    BeyondEnd,
    /// r(s) < 0: the other nappe.
    OtherNappe,
    /// A point of the wall.
    OnWall,
}

/// Works out the page's method (CSC418 11.3.5) for any axis, for a direction of any length but zero.
///
/// A degenerate question gives values that mean nothing; [`Notes::hit`] refuses it.
#[inline]
pub fn notes<R: Real>(ray: &Ray3<R>, cone: &OpenCone<R>) -> Notes<R> {
    let (v, w, along) = (cone.apex - cone.base, ray.origin - cone.base, ray.direction);
    let k = cone.apex_radius - cone.base_radius;

    // s and r along the ray: s_a + λ s_d and r + λ r_d.
    let vv = v.dot(v);
    let (s_a, s_d) = (w.dot(v) / vv, along.dot(v) / vv);
    let (r, r_d) = (cone.base_radius + s_a * k, s_d * k);

    // ‖w + λ d‖² − (s_a + λ s_d)² v·v − (r + λ r_d)² = A λ² + 2 B λ + C = 0
    let a = along.dot(along) - s_d * s_d * vv - r_d * r_d;
    let b = w.dot(along) - s_a * s_d * vv - r * r_d;
    let c = w.dot(w) - s_a * s_a * vv - r * r;
    let d = b * b - a * c;

    let candidates = roots(a, b, c, d).map(|lambda| {
        let zero = R::from(0.0);
        let Some(at) = lambda else {
            return Candidate { lambda, s: zero, point: ray.origin, test: Test::NoPoint };
        };
        let (s, radius, point) = (s_a + at * s_d, r + at * r_d, ray.at(at));
        let test = match () {
            // A root that overflowed has no point to show.
            _ if !(zero <= s && s <= R::from(1.0) && point.is_finite()) => Test::BeyondEnd,
            _ if radius < zero => Test::OtherNappe,
            _ => Test::OnWall,
        };
        Candidate { lambda, s, point, test }
    });
    Notes { ray: *ray, cone: *cone, v, w, vv, s_a, s_d, r, r_d, a, b, c, d, candidates }
}

/// λ1 and λ2 of A λ² + 2 B λ + C = 0, as for the unit solids.
///
/// With A = 0, parallel to a straight line of the wall, the equation is linear: one root −C / 2B, or none. (In the wall
/// itself B and C are zero as well, and every λ is a root: the method finds none of them.)
#[inline]
fn roots<R: Real>(a: R, b: R, c: R, d: R) -> [Option<R>; 2] {
    let zero = R::from(0.0);
    if a == zero {
        let root = if b == zero { None } else { Some(-c / (b + b)) };
        return [root, None];
    }
    if d < zero {
        return [None, None];
    }
    let root = d.sqrt();
    [Some(-b / a + root / a), Some(-b / a - root / a)]
}

impl<R: Real> Notes<R> {
    /// The place among the candidates of the one with the smallest λ in `span`; on a tie the first. `None`
    /// where none of them is a point of the wall in the span.
    #[inline]
    pub fn nearest(&self, span: Span<R>) -> Option<usize> {
        let mut nearest = None;
        let mut smallest = R::INFINITY;
        for (place, candidate) in self.candidates.iter().enumerate() {
            let Some(lambda) = candidate.lambda else { continue };
            let counts = candidate.test == Test::OnWall && span.contains(lambda);
            if counts && (nearest.is_none() || lambda < smallest) {
                nearest = Some(place);
                smallest = lambda;
            }
        }
        nearest
    }

    /// The nearest hit in `span`, with the normal of [`OpenCone::normal`], away from the axis.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`OpenCone::check`]. On
    /// paper a ray that lies in the wall has A = B = C = 0: every λ is a root, and the method takes none.
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.cone.check(&self.ray)?;
        let Some(place) = self.nearest(span) else { return Ok(None) };
        let Candidate { lambda, point, .. } = self.candidates[place];
        let normal = self.cone.normal(point);
        Ok(lambda.map(|lambda| Hit { t: lambda + R::from(0.0), point, normal })) // minus zero is zero
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// By hand: along y at x = 2 a pipe of radius 2 is touched at λ = 3, by both roots.
    #[test]
    fn of_two_equal_roots_the_first_is_taken() {
        let pipe = OpenCone::<f64>::new(DVec3::ZERO, 2.0, DVec3::Z * 4.0, 2.0);
        let work = notes(&Ray3::new(DVec3::new(2.0, -3.0, 1.0), DVec3::Y), &pipe);
        assert_eq!(work.candidates.map(|candidate| candidate.lambda), [Some(3.0); 2]);
        assert_eq!(work.nearest(Span::ahead()), Some(0));
    }

    /// By hand: parallel to the far side from a place of the wall A and C are 0 and B is 4; λ is −0 / 8.
    #[test]
    fn minus_zero_is_zero() {
        let tip = OpenCone::<f64>::new(DVec3::ZERO, 2.0, DVec3::Z * 4.0, 0.0);
        let work = notes(&Ray3::new(DVec3::X * -2.0, DVec3::new(-1.0, 0.0, 2.0)), &tip);
        assert_eq!((work.a, work.b, work.c), (0.0, 4.0, 0.0));
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t.to_bits(), hit.point), (0, DVec3::X * -2.0));
    }
}

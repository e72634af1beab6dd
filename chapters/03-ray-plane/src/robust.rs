//! Equation 4.2 with both dot products certain.
//!
//! t = −n · (p_r − p_0) / n · u_r is a quotient of two sums, and sums of products cancel. Near
//! parallel, n · u_r is the small difference of large products, and its few right digits are all
//! that t has; a ray exactly parallel may come out as a hit astronomically far away. With the origin
//! near the plane the same happens to n · (p_r − p_0), where even the difference p_r − p_0 was rounded.
//! The usual cure, to call |n · u_r| < 1e−6 parallel, trades the wrong digits for wrong verdicts.
//!
//! Here p_r − p_0 keeps its rounding error. Four ways of taking the sums follow, each slower and surer
//! than the one before; a sum takes the first whose error bound says that what is left over can
//! matter neither to its sign nor to t.
//!
//! 1. **At once**, in plain `f64`: for a ray in `f32` that is enough nearly always, since products of
//!    `f32` are exact in `f64`.
//! 2. **In two parts**: products and sums keep their rounding errors, which are then summed in plain `f64`.
//!    So a ray in `f64` nearly always ends here.
//! 3. **In three parts**: the rounding errors keep theirs as well (`careful.rs`). That takes an origin on
//!    the plane, and rays as near to parallel as rounding makes them.
//! 4. **Exactly**, in integers as long as it takes, so that "parallel" and "in the plane" are facts.

mod careful;
mod sums;

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

use crate::{Hit3, Meeting, Plane};
use sums::{Sum, from_plane};

/// Every number of the robust method.
///
/// A degenerate ray or plane gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The plane.
    pub plane: Plane<R>,
    /// n · (p_r − p_0), as in [`Notes`](crate::Notes).
    pub n_dot_p: CertainSum,
    /// n · u_r, likewise.
    pub n_dot_u: CertainSum,
    found: Found,
}

/// A dot product whose sign is exact and whose digits are right to the precision of the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertainSum {
    /// The sum in `f64`; NaN for a degenerate ray or plane.
    pub value: f64,
    /// How it was found.
    pub certainty: Certainty,
}

/// How a sum was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`.
    AtOnce,
    /// With the rounding errors of the plain sum.
    TwoPart,
    /// With the rounding errors of those.
    ThreePart,
    /// In integers.
    Exact,
}

impl CertainSum {
    /// How it was found, in words for a transcript.
    pub fn meaning(&self) -> &'static str {
        match self.certainty {
            Certainty::AtOnce => "certain at once",
            Certainty::TwoPart => "two-part sum, certain by its error bound",
            Certainty::ThreePart => "three-part sum, certain by its error bound",
            Certainty::Exact => "summed exactly",
        }
    }
}

/// What Eq. 4.2 comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Found {
    /// This t. A negative one is never zero.
    At(f64),
    /// n · u_r = 0
    Never(Parallel),
    /// A degenerate ray or plane.
    Degenerate,
}

/// Works out the robust method, for a direction and a normal of any length but zero.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Robust<R> {
    let (p_r, u_r): ([f64; 3], [f64; 3]) = (ray.origin.in_f64(), ray.direction.in_f64());
    let (p_0, n): ([f64; 3], [f64; 3]) = (plane.point.in_f64(), plane.normal.in_f64());
    let (ray, plane) = (*ray, *plane);

    let (n_dot_p, n_dot_u, certainty) = if R::DIGITS < f64::MANTISSA_DIGITS {
        let v: [f64; 3] = std::array::from_fn(|axis| p_r[axis] - p_0[axis]);
        (Sum::at_once(n, v), Sum::at_once(n, u_r), Certainty::AtOnce)
    } else {
        (
            Sum::in_two_parts(n, from_plane(p_r, p_0)),
            Sum::in_two_parts(n, u_r.map(Into::into)),
            Certainty::TwoPart,
        )
    };
    if !(n_dot_p.is_certain && n_dot_u.is_certain) {
        let (n_dot_p, n_dot_u, found) = careful::meeting(p_r, u_r, p_0, n);
        return Robust { ray, plane, n_dot_p, n_dot_u, found };
    }
    let found = Found::At(-n_dot_p.over(n_dot_u));
    let [n_dot_p, n_dot_u] = [n_dot_p, n_dot_u].map(|sum| CertainSum { value: sum.hi, certainty });
    Robust { ray, plane, n_dot_p, n_dot_u, found }
}

impl<R: Real> Robust<R> {
    /// Where the line of the ray meets the plane; parallel is decided exactly.
    ///
    /// Means nothing for what [`Plane::check`] refuses.
    pub fn meeting(&self) -> Meeting<R> {
        match self.found {
            Found::At(t) => Meeting::At(R::root_from(t)),
            Found::Never(how) => Meeting::Never(how),
            Found::Degenerate => Meeting::Never(Parallel::Within),
        }
    }

    /// The signed distance of the origin from the plane, in units of the scene: n · (p_r − p_0) / ‖n‖. Zero
    /// for a degenerate ray or plane.
    pub fn distance(&self) -> R {
        careful::distance(&self.ray, &self.plane)
    }

    /// The hit, where its t lies in `span`: x = p_r + t u_r, and n / ‖n‖, on whichever side the ray comes
    /// from.
    ///
    /// `None` for a miss, which a ray within the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Plane::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let (ray, plane) = (self.ray, self.plane);
        let wide_t = match self.found {
            Found::At(t) => t,
            Found::Never(_) => return Ok(None),
            Found::Degenerate => return plane.check(&ray).map(|()| None),
        };
        let t = R::root_from(wide_t);
        if !span.contains(t) {
            return Ok(None);
        }
        let [p_r, u_r] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| p_r[axis] + wide_t * u_r[axis]);
        // Where a sum had to be exact, t may be infinite or vanish; and t u_r may overflow.
        let is_plain = [self.n_dot_p, self.n_dot_u].iter().all(|sum| sum.certainty != Certainty::Exact)
            && [x, y, z].iter().all(|number| number.is_finite());
        let point = match is_plain {
            true => R::vec3(R::round_from(x), R::round_from(y), R::round_from(z)),
            false => careful::point(&ray, &plane),
        };
        let t = t + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point, normal: plane.unit_normal() }))
    }
}

#[cfg(test)]
mod tests;

//! What an intersector answers.

use std::fmt;

/// A point where a ray meets a surface, in the coordinates of the ray. V is a vector of the plane or of
/// space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<R, V> {
    /// The parameter of the ray, in lengths of its direction as given; never negative for a span ahead.
    pub t: R,
    /// The point x_hit = p_r + t u_r.
    pub point: V,
    /// The unit normal of the surface there. A solid's points outward; none is turned toward the ray.
    pub normal: V,
}

/// A ray that runs along a surface and so has no single t: a miss with a reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parallel {
    /// It never meets the surface.
    Apart,
    /// It lies in the surface and meets it everywhere.
    Within,
}

impl Parallel {
    /// The word in a result row: `parallel` or `in-plane`.
    pub fn reason(self) -> &'static str {
        match self {
            Parallel::Apart => "parallel",
            Parallel::Within => "in-plane",
        }
    }
}

/// An input for which the question "where does this ray hit?" has no meaning.
///
/// It is an answer, not a failure: a case file with such a row yields a row `invalid` with the
/// [`reason`](Degenerate::reason).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Degenerate {
    /// A coordinate, a direction or a radius is infinite or NaN.
    NotFinite,
    /// The ray has no direction.
    ZeroDirection,
    /// The plane has no normal.
    ZeroNormal,
    /// The radius is zero or negative.
    RadiusNotPositive,
    /// The wall's front face lies behind its back face.
    FrontBeyondBack,
    /// The corners of the triangle lie on one line.
    NoArea,
    /// The base and the apex of the cone are one point.
    NoHeight,
    /// The matrix has no inverse.
    Singular,
}

impl Degenerate {
    /// The word in a result row.
    pub fn reason(self) -> &'static str {
        match self {
            Degenerate::NotFinite => "not-finite",
            Degenerate::ZeroDirection => "zero-direction",
            Degenerate::ZeroNormal => "zero-normal",
            Degenerate::RadiusNotPositive => "radius-not-positive",
            Degenerate::FrontBeyondBack => "front-beyond-back",
            Degenerate::NoArea => "no-area",
            Degenerate::NoHeight => "no-height",
            Degenerate::Singular => "singular",
        }
    }
}

impl fmt::Display for Degenerate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Degenerate::NotFinite => "a number is infinite or not a number",
            Degenerate::ZeroDirection => "the direction of the ray is zero",
            Degenerate::ZeroNormal => "the normal of the plane is zero",
            Degenerate::RadiusNotPositive => "the radius is not positive",
            Degenerate::FrontBeyondBack => "the wall's front face is beyond its back face",
            Degenerate::NoArea => "the triangle has no area",
            Degenerate::NoHeight => "the base and the apex of the cone are one point",
            Degenerate::Singular => "the matrix is singular: it has no inverse",
        })
    }
}

impl std::error::Error for Degenerate {}

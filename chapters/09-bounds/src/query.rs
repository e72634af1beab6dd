//! What is asked of a scene, and what it answers.

use math::{Ray3, Real, Span};

/// What a ray hits first, part by part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstPart<R> {
    /// Which of the [`Parts`](crate::Parts).
    pub part: usize,
    /// λ, in lengths of the ray's direction.
    pub lambda: R,
}

/// What a ray hits first, as far as the search had to know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<R> {
    /// Which of the [`Parts`](crate::Parts).
    pub part: usize,
    /// λ, if it was worked out to its last digit on the way.
    pub(crate) lambda: Option<R>,
}

/// What is asked of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query<R: Real> {
    /// The ray. It must be a ray: [`Ray3::check`].
    pub ray: Ray3<R>,
    /// Where a hit counts; it must not begin below 0.
    pub span: Span<R>,
    /// What is known of the part that the ray leaves.
    pub leaves: Leaves,
}

/// What is known of the part that a ray leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaves {
    /// Nothing: it is tried like any other.
    Unknown,
    /// The ray passes this part as if it were not there.
    Passes(usize),
    /// The same, but the part is tried, and its hit does not count: for who wants to know what that costs.
    PassesIdly(usize),
    /// It is solid, and the ray starts in it, just below its surface: where its line enters that part is behind it.
    Within(usize),
}

impl Leaves {
    /// The same, with what is passed tried all the same.
    #[inline(always)]
    pub fn tried_idly(self) -> Leaves {
        match self {
            Leaves::Passes(part) => Leaves::PassesIdly(part),
            other => other,
        }
    }
}

impl<R: Real> Query<R> {
    /// A ray that is tried on everything.
    pub fn new(ray: Ray3<R>, span: Span<R>) -> Query<R> {
        Query { ray, span, leaves: Leaves::Unknown }
    }
}

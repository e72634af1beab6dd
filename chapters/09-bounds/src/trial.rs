//! One part, one ray: is it hit?
//!
//! The robust methods say so exactly. The notes' formulas are sometimes wrong about a ray that passes by, and which
//! of the parts a ray is tried on depends on the bounds; so would then what is seen. To be the same by every bound, a
//! hit of theirs counts only where the ray is in the part's own box, and not before it enters that box: a bound in
//! which that box is leaves no such hit out.

use math::{Real, Span};
use signature::Method;

use crate::bounded::Query;
use crate::{Box3, Parts, Reach, Slabs};

/// By which formulas.
#[derive(Clone, Debug)]
pub(crate) enum Trial {
    Robust,
    /// With each part's own box; `None` for a plane.
    Notes(Vec<Option<Box3>>),
}

impl Trial {
    pub(crate) fn of<R: Real>(formulas: Method, parts: &Parts<'_, R>) -> Trial {
        match formulas {
            Method::Robust => Trial::Robust,
            Method::Notes => Trial::Notes((0..parts.count()).map(|part| parts.bounds(part)).collect()),
        }
    }

    pub(crate) fn formulas(&self) -> Method {
        match self {
            Trial::Robust => Method::Robust,
            Trial::Notes(_) => Method::Notes,
        }
    }

    /// Ready for the parts, one after the other.
    #[inline(always)]
    pub(crate) fn ready<'a, R: Real>(&'a self, parts: &'a Parts<'a, R>, query: &'a Query<R>) -> Ready<'a, R> {
        let boxes = match self {
            Trial::Robust => None,
            Trial::Notes(boxes) => Some((Slabs::new(&query.ray), boxes.as_slice())),
        };
        Ready { parts, query, without: query.without.unwrap_or(usize::MAX), boxes }
    }
}

/// A ray that is asked of one part after the other.
pub(crate) struct Ready<'a, R: Real> {
    parts: &'a Parts<'a, R>,
    query: &'a Query<R>,
    without: usize,
    boxes: Option<(Slabs, &'a [Option<Box3>])>,
}

impl<R: Real> Ready<'_, R> {
    /// The t of the nearest hit of a part in `span`.
    #[inline(always)]
    pub(crate) fn hit(&self, part: usize, span: Span<R>) -> Option<R> {
        if part == self.without {
            return None;
        }
        match &self.boxes {
            None => self.parts.hit(part, &self.query.ray, span),
            Some((slabs, boxes)) => {
                let enters = match &boxes[part] {
                    Some(bounds) => slabs.enter(bounds, Reach::of(span))?,
                    None => 0.0,
                };
                let hit = self.parts.whole_hit(Method::Notes, part, &self.query.ray, span)?;
                (Into::<f64>::into(hit.t) >= f64::from(enters)).then_some(hit.t)
            }
        }
    }
}

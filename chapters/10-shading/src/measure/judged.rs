//! What a second ray has to meet.
//!
//! Of a convex shape that stands alone that is known without any other method: a ray that leaves it meets
//! nothing, and a ray that enters a solid meets it where it leaves. What is a little above it on all sides is
//! met by every ray that leaves. (An open cone is convex to whom looks from outside; the eye's ray may come
//! in through an end, and then the other wall may be met: such landings are not taken.)

use bounds::{Bounded, Query, Uncounted};
use lab::Draw;
use math::{Real, Span, Vector};
use signature::{Method, Shape};

use super::object::Object;
use super::regimes::Way;
use crate::{Landing, Start, Starts};

/// A second ray before its remedy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case<R: Real> {
    /// Where the eye's ray landed.
    pub(crate) landing: Landing<R>,
    /// Where the second one goes: to the side of the viewer if it leaves, else to the other.
    pub(crate) direction: R::Vec3,
}

/// How many second rays went wrong, out of how many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Faults {
    /// Second rays.
    pub(crate) cases: u64,
    /// They meet the surface that they leave.
    pub(crate) acne: u64,
    /// They miss what is close above it, or the other side of a solid; `None` where there is neither.
    pub(crate) leaks: Option<u64>,
}

impl Faults {
    /// The share of rays with one fault or the other; at most 1, where a ray has both it counts once and a
    /// half at most.
    pub(crate) fn share(&self) -> f64 {
        (self.all() as f64 / self.cases.max(1) as f64).min(1.0)
    }

    /// Faults of both kinds.
    pub(crate) fn all(&self) -> u64 {
        self.acne + self.leaks.unwrap_or(0)
    }

    /// So many of a million.
    pub(crate) fn per_million(&self, count: u64) -> f64 {
        1e6 * count as f64 / self.cases.max(1) as f64
    }
}

/// So many landings with a direction each: the same for every remedy. Fewer where the rays do not find the
/// shape, which at f32 far away has no size.
pub(crate) fn cases<R: Real>(object: &Object<R>, bounded: &Bounded<'_, R>, count: usize) -> Vec<Case<R>> {
    let mut draw = object.draw();
    let mut cases = Vec::with_capacity(count);
    for _ in 0..20 * count {
        if cases.len() == count {
            break;
        }
        cases.extend(case(object, bounded, &mut draw));
    }
    cases
}

fn case<R: Real>(object: &Object<R>, bounded: &Bounded<'_, R>, draw: &mut Draw) -> Option<Case<R>> {
    let ray = object.ray(draw);
    let [x, y, z] = f64::xyz(draw.direction()).map(R::round_from);
    let direction = R::vec3(x, y, z);
    ray.check().ok()?;
    let query = Query::new(ray, Span::ahead());
    let landing = Landing::of(bounded, &query, &mut Uncounted, |_| false)?;
    let turned = landing.turned_toward(ray.direction);
    if matches!(object.shape(), Shape::OpenCone(_)) && !turned.from_outside {
        return None;
    }
    let toward_viewer = turned.face.dot(direction);
    let leaves = toward_viewer > R::from(0.0);
    if toward_viewer == R::from(0.0) {
        return None;
    }
    Some(Case {
        landing,
        direction: if leaves == (object.way == Way::Leaves) { direction } else { -direction },
    })
}

/// Counts what goes wrong with a remedy.
pub(crate) fn judge<R: Real>(
    object: &Object<R>,
    bounded: &Bounded<'_, R>,
    start: Start,
    cases: &[Case<R>],
) -> Faults {
    let (mut acne, mut leaks) = (0, 0);
    for case in cases {
        let (has_acne, leaked) = faults(object, bounded, start, case);
        acne += u64::from(has_acne);
        leaks += u64::from(leaked);
    }
    let may_leak = object.shell.is_some() || object.way == Way::Enters;
    Faults { cases: cases.len() as u64, acne, leaks: may_leak.then_some(leaks) }
}

/// Whether a second ray meets the surface that it leaves, and whether it misses what it has to meet.
pub(crate) fn faults<R: Real>(
    object: &Object<R>,
    bounded: &Bounded<'_, R>,
    start: Start,
    Case { landing, direction }: &Case<R>,
) -> (bool, bool) {
    let parts = bounded.all_parts();
    let (shape, face) = (parts.shape(landing.part), parts.face(landing.part));
    let starts = Starts::of(start, bounded.formulas(), shape, face, landing);
    let query = starts.toward(*direction);
    let met = Landing::of(bounded, &query, &mut Uncounted, |_| false);
    match object.way {
        Way::Leaves => {
            let misses = |shell: &Shape<R>| shell.hit(Method::Robust, &query.ray, query.span).is_none();
            (met.is_some(), object.shell.as_ref().is_some_and(misses))
        }
        Way::Enters => {
            // where the ray comes in it has met the surface that it started from
            let comes_in = |landing: Landing<R>| landing.face_normal.dot(*direction) < R::from(0.0);
            (met.is_some_and(comes_in), met.is_none())
        }
    }
}

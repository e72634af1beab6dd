//! The media that a ray is in.
//!
//! "Need to keep track of the speed of light in the current medium" (CSC418 11.7.3). One number would do for one solid. For
//! solids in solids it takes a stack: entering a solid pushes it, leaving takes it out, wherever it lies (two that overlap
//! are left in another order than they were entered). The medium is that of the topmost, and air where there is none.

use math::{Ray3, Real, Span, Vector};

use crate::Scene;

/// The solids that a ray is in, the latest entered on top. By their places in the scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Media {
    solids: Vec<usize>,
}

/// What to do to put the stack back as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undo {
    /// Take the topmost off.
    Entered,
    /// Put the solid back in this place.
    Left(usize, usize),
    /// Nothing: the solid that was left was not in the stack.
    Nothing,
}

impl Media {
    /// A ray in these solids, the first the outermost.
    pub fn of(solids: Vec<usize>) -> Media {
        Media { solids }
    }

    /// The solid whose medium it is; `None` for the air outside.
    #[inline(always)]
    pub fn top(&self) -> Option<usize> {
        // exercise top: Of all the solids that the ray is in, which one's medium is it in?
        self.solids.last().copied()
        // end top
    }

    /// The solids, the outermost first.
    pub fn solids(&self) -> &[usize] {
        &self.solids
    }

    /// Goes through the surface of a solid, into it or out of it.
    #[inline(always)]
    pub fn pass(&mut self, solid: usize, enters: bool) -> Undo {
        if enters {
            self.solids.push(solid);
            return Undo::Entered;
        }
        // exercise leaves: The ray leaves this solid: what becomes of the stack, and what has to be known to undo it?
        match self.solids.iter().rposition(|&it| it == solid) {
            Some(place) => {
                self.solids.remove(place);
                Undo::Left(place, solid)
            }
            None => Undo::Nothing,
        }
        // end leaves
    }

    /// Takes the latest [`Media::pass`] back, by what it returned.
    #[inline(always)]
    pub fn undo(&mut self, undo: Undo) {
        // exercise undo: How does the stack become what it was before that surface?
        match undo {
            Undo::Entered => {
                self.solids.pop();
            }
            Undo::Left(place, solid) => self.solids.insert(place, solid),
            Undo::Nothing => {}
        }
        // end undo
    }
}

/// The solids that hold the eye: solids are convex, and whoever meets one from within at λ > 0 is in it.
pub(crate) fn around_eye<R: Real>(scene: &Scene<R>) -> Vec<usize> {
    let geometry = &scene.lit.geometry;
    let ray = geometry.ray((0, 0));
    let holds = |object: &usize| {
        let hit = geometry.objects[*object].shape.hit(signature::Method::Robust, &ray, Span::ahead());
        let is_left =
            hit.is_some_and(|hit| hit.t > R::from(0.0) && hit.normal.dot(ray.direction) > R::from(0.0));
        scene.is_solid(*object) && is_left
    };
    (0..geometry.objects.len()).filter(holds).collect()
}

/// Those solids in the order in which the eye ray's line, followed from behind, entered them: the farthest behind first, on a
/// tie the earlier one.
pub(crate) fn entered_from_behind<R: Real>(scene: &Scene<R>, solids: &[usize], ray: &Ray3<R>) -> Vec<usize> {
    let back = Ray3::new(ray.origin, -ray.direction);
    let far = |solid: usize| {
        let shape = &scene.lit.geometry.objects[solid].shape;
        let hit = shape.hit(signature::Method::Robust, &back, Span::ahead());
        hit.map_or(0.0, |hit| hit.t.into())
    };
    let mut entered: Vec<(f64, usize)> = solids.iter().map(|&solid| (far(solid), solid)).collect();
    entered.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    entered.into_iter().map(|(_, solid)| solid).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: into 1, into 2, out of 1 (they overlap), out of 2.
    #[test]
    fn overlapping_solids_are_left_in_any_order() {
        let mut media = Media::default();
        let mut tops = vec![media.top()];
        let passes = [(1, true), (2, true), (1, false), (2, false)].map(|(solid, enters)| {
            let undo = media.pass(solid, enters);
            tops.push(media.top());
            undo
        });
        assert_eq!(tops, [None, Some(1), Some(2), Some(2), None]);
        for undo in passes.into_iter().rev() {
            media.undo(undo);
        }
        assert_eq!(media, Media::default());
    }

    #[test]
    fn leaving_what_was_never_entered_changes_nothing() {
        let mut media = Media::of(vec![3]);
        assert_eq!(media.pass(7, false), Undo::Nothing);
        media.undo(Undo::Nothing);
        assert_eq!(media.solids(), [3]);
    }
}

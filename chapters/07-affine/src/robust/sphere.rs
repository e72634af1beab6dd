//! The deformed sphere: ‖o″ + λ d″‖ = s.

use std::cmp::Ordering::{Equal, Greater, Less};

use math::{Quadratic, Sure};
use quadric::Part;
use quadric::robust::{Place, Verdict};

use super::line::Line;

/// A sphere is a wall and nothing else.
pub(super) const WALL: Place = Place { part: Part::Wall, plane: None };

/// ‖d″‖² − ‖w‖²: A times the square of half the chord. Below zero for a line that misses.
#[inline(always)]
pub(super) fn chord<N: Sure>(line: &Line<N>) -> N {
    N::dot(&line.d, &line.d) - N::dot(&line.w, &line.w)
}

/// A = d″·d″, B = −o″·d″, C = o″·o″ − s² and D = B² − A C = s² (‖d″‖² − ‖w‖²).
#[inline(always)]
pub(super) fn quadratic<N: Sure>(line: &Line<N>) -> Quadratic<N> {
    let Line { o, d, s, .. } = line;
    let square = s.clone() * s.clone();
    Quadratic { a: N::dot(d, d), b: -N::dot(o, d), c: N::dot(o, o) - square.clone(), d: square * chord(line) }
}

/// What the ray meets, by signs alone; `None` in doubt.
#[inline(always)]
pub(super) fn verdict<N: Sure>(line: &Line<N>) -> Option<Verdict> {
    if chord(line).sign()? == Less {
        return Some(Verdict::Misses);
    }
    let Quadratic { b, c, .. } = quadratic(line);
    Some(match c.sign()? {
        Less => Verdict::Leaves(WALL),
        Equal => Verdict::Starts(Part::Wall),
        Greater if b.sign()? == Greater => Verdict::Enters(WALL),
        Greater => Verdict::Misses,
    })
}

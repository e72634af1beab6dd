//! The deformed cylinder and cone: chapter 06's signs, asked of the solid at scale s.

use math::{Quadratic, Sure};
use quadric::Shape;
use quadric::robust::Verdict;

use super::line::Line;

/// The line as chapter 06 takes it.
#[inline(always)]
pub(super) fn beside<N: Sure>(line: &Line<N>, shape: Shape) -> quadric::robust::Line<N> {
    quadric::robust::Line::new(shape, line.o.clone(), line.d.clone(), line.s.clone())
}

/// What the ray meets, by signs alone; `None` in doubt.
#[inline(always)]
pub(super) fn verdict<N: Sure>(line: &Line<N>, shape: Shape) -> Option<Verdict> {
    beside(line, shape).verdict()
}

/// D / s² of the wall, from the moment: A − w_z² for the cylinder. For the cone ¼ (v_x² + v_y²) − v_z² with
/// v = w − e_z × d″, the moment about the apex.
#[inline(always)]
pub(super) fn chord<N: Sure>(line: &Line<N>, shape: Shape) -> N {
    let ([d_x, d_y, _], [w_x, w_y, w_z]) = (line.d.clone(), line.w.clone());
    let axial = w_z.clone() * w_z;
    let square = |x: N| x.clone() * x;
    match shape {
        Shape::Cylinder => square(d_x) + square(d_y) - axial,
        // e_z × d″ = (−d_y, d_x, 0)
        Shape::Cone => N::of(0.25) * (square(w_x + d_y) + square(w_y - d_x)) - axial,
    }
}

/// A, B and C of the wall, and D = s² times [`chord`].
#[inline(always)]
pub(super) fn quadratic<N: Sure>(line: &Line<N>, shape: Shape) -> Quadratic<N> {
    let beside = beside(line, shape);
    let square = line.s.clone() * line.s.clone();
    Quadratic { a: beside.a(), b: beside.b(), c: beside.c(), d: square * chord(line, shape) }
}

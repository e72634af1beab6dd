//! The ray in the space where the unit object is s = |det A| times as large.

use math::{Ray3, Real, Sure, Vector};

use super::stored::Scaled;
use crate::{Affine, Deformed};

/// A ray as that space has it, in one kind of number.
///
/// Its direction and its moment are all that there is to know of a line (Plücker's coordinates). Both follow from
/// those of the line in the world with one product each, d″ from d and w from (a − t) × d, and p × d″ = w holds for
/// its points p at the object's own scale: where only the line matters, o″ is not needed, and none of its digits lost.
pub(super) struct Line<N> {
    /// o″ = adj A (a − t) sgn det A
    pub(super) o: [N; 3],
    /// d″ = adj A d sgn det A
    pub(super) d: [N; 3],
    /// w = Aᵀ ((a − t) × d) sgn det A
    pub(super) w: [N; 3],
    /// s = |det A|
    pub(super) s: N,
}

impl<N: Sure> Line<N> {
    /// The ray taken there. Its numbers must be finite.
    #[inline(always)]
    pub(super) fn of<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>, scaled: Scaled<N>) -> Line<N> {
        let Affine { a, t } = deformed.affine;
        let [origin, d, t] = [ray.origin, ray.direction, t].map(Vector::in_f64::<3>);
        let columns = a.columns.map(|column| Vector::in_f64::<3>(column).map(N::of));
        let Scaled { adjugate, s } = scaled;

        let a_minus_t: [N; 3] = [0, 1, 2].map(|axis| N::difference(origin[axis], t[axis]));
        let d = d.map(N::of);
        let moment = N::cross(&a_minus_t, &d);
        let turned = |x: N| if deformed.stored.mirrors { -x } else { x };
        Line {
            o: [0, 1, 2].map(|row| N::dot(&adjugate[row], &a_minus_t)),
            d: [0, 1, 2].map(|row| N::dot(&adjugate[row], &d)),
            w: [0, 1, 2].map(|column| turned(N::dot(&columns[column], &moment))),
            s,
        }
    }
}

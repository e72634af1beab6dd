//! λ to the last digit of `f64`, from a rounded λ and what is left of f there.
//!
//! In `f64` λ may be off by many digits: o″ alone is, where A squashes much. But any number λ0 near it is as good an
//! origin as the ray's own: the point q = adj A (a − t + λ0 d) is worked out with twice the digits, f(q) is the small
//! rest that is left of the surface's equation there, and the step to the root,
//!
//! ```text
//! f(q + δ d″) = A δ² + 2 B δ + f(q) = 0,   δ = f(q) / (±√D − B),   D = B² − A f(q),
//! ```
//!
//! is so small that a few of its digits do for all of λ0 + δ. The same step leads from q to the point on the surface.

use math::{Bounded, Ray3, Real, Sure, TwoPart, Vector};
use quadric::robust::{Place, rise_to};

use super::line::Line;
use super::stored::leading;
use crate::{Affine, Deformed, Object};

/// λ, and the point on the unit object.
pub(super) struct Corrected<R> {
    pub(super) lambda: R,
    pub(super) p: [f64; 3],
}

/// By its bound, which is nearly always much too large, half of the digits of a point are right.
const HALF_THE_DIGITS: f64 = 1.0 / (1u64 << 26) as f64;

/// Whether half of the digits of a point are right, by its bound, or of s where that is larger.
#[inline(always)]
fn has_half_its_digits(p: &[Bounded<f64>; 3], s: f64) -> bool {
    p.iter().all(|p| p.error <= HALF_THE_DIGITS * (p.value.abs() + s))
}

/// λ of a place where the line enters or leaves; `None` where it takes more than this.
#[inline(always)]
pub(super) fn corrected<R: Real>(
    line: &Line<Bounded<f64>>,
    ray: &Ray3<R>,
    deformed: &Deformed<R>,
    place: Place,
    enters: bool,
) -> Option<Corrected<R>> {
    let object = deformed.object;
    let rough = rough(line, object, place, enters);
    let q = point_at(rough, ray, deformed);

    let (d, s) = (&line.d, deformed.stored.fine.s);
    let delta = match place.plane {
        Some(plane) => leading(rise_to(plane, s, q[2])) / d[2],
        None => {
            let rest = leading(surface(object, &q, &s));
            let (a, b) = slopes(object, &q.map(leading), d, &line.s);
            let root = (b * b - a * rest).sqrt();
            if enters { rest / (root - b) } else { -(rest / (root + b)) }
        }
    };
    let p = [0, 1, 2].map(|axis| leading(q[axis]) + delta * d[axis]);
    let s = line.s.value;
    if !has_half_its_digits(&p, s) {
        return None;
    }
    Some(Corrected { lambda: delta.added_to(rough)?, p: p.map(|p| p.value / s) })
}

/// q = adj A (a − t + λ0 d) sgn det A
#[inline(always)]
fn point_at<R: Real>(lambda: f64, ray: &Ray3<R>, deformed: &Deformed<R>) -> [Bounded<TwoPart>; 3] {
    let Affine { t, .. } = deformed.affine;
    let [a, d, t] = [ray.origin, ray.direction, t].map(Vector::in_f64::<3>);
    let at: [Bounded<TwoPart>; 3] = [0, 1, 2].map(|axis| {
        let a_minus_t: Bounded<TwoPart> = Sure::difference(a[axis], t[axis]);
        a_minus_t + Sure::product(lambda, d[axis])
    });
    [0, 1, 2].map(|row| Sure::dot(&deformed.stored.fine.adjugate[row], &at))
}

/// λ in plain `f64`, however many of its digits are right.
#[inline(always)]
fn rough(line: &Line<Bounded<f64>>, object: Object, place: Place, enters: bool) -> f64 {
    if let Some(plane) = place.plane {
        return line.rise_to(plane).value / line.d[2].value;
    }
    let Some(quadratic) = line.quadratic(object) else { return f64::NAN };
    let [a, b, c, d] = [quadratic.a, quadratic.b, quadratic.c, quadratic.d].map(|x| x.value);
    let root = d.max(0.0).sqrt();
    let root = if enters { -root } else { root };
    if b * root >= 0.0 { (b + root) / a } else { c / (b - root) }
}

/// f of the sphere or the wall at scale s.
#[inline(always)]
fn surface<N: Sure>(object: Object, [x, y, z]: &[N; 3], s: &N) -> N {
    let square = |x: &N| x.clone() * x.clone();
    let across = square(x) + square(y);
    match object {
        Object::Cylinder => across - square(s),
        Object::Cone => across - square(&(N::of(0.5) * (s.clone() - z.clone()))),
        Object::Sphere | Object::Plane | Object::Triangle => across + square(z) - square(s),
    }
}

/// A, and B: half of how fast f grows along d at q.
#[inline(always)]
fn slopes<N: Sure>(object: Object, [x, y, z]: &[N; 3], [d_x, d_y, d_z]: &[N; 3], s: &N) -> (N, N) {
    let product = |x: &N, y: &N| x.clone() * y.clone();
    let a = product(d_x, d_x) + product(d_y, d_y);
    let b = product(x, d_x) + product(y, d_y);
    let quarter = |x: N| N::of(0.25) * x;
    match object {
        Object::Cylinder => (a, b),
        Object::Cone => {
            let below = s.clone() - z.clone();
            (a - quarter(product(d_z, d_z)), b + quarter(product(&below, d_z)))
        }
        Object::Sphere | Object::Plane | Object::Triangle => (a + product(d_z, d_z), b + product(z, d_z)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 2⁻²⁶ of 3 + 1.
    #[test]
    fn half_of_the_digits_are_26() {
        let most = 4.0 * 2.0_f64.powi(-26);
        let has = |error: f64| {
            let off = Bounded { value: -3.0, error };
            has_half_its_digits(&[Bounded::exactly(1.0), off, Bounded::exactly(0.0)], 1.0)
        };
        assert!(has(0.0) && has(most) && !has(most.next_up()));
    }
}

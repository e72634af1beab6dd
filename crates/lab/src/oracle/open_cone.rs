//! The wall between two circles, without caps: NFF's cone and cylinder.
//!
//! With v from the base to the apex and V = v·v, a point x = b + w is at the height s = w·v / V, and
//! e = V w − (w·v) v is V times the way to it from the axis. It is on the wall where ‖e‖ = V r(s) and 0 ≤ s ≤ 1.
//! Squared that is a quadratic in t, and both of its roots are asked whether they lie between the ends; the square
//! brings in no others, for r(s) is not negative there. Where all coefficients are zero the line lies in the wall.

use math::Degenerate;
use stage::Precision;

use super::quadratic::Quadratic;
use super::stretch::Stretch;
use super::vector::{difference, dot, is_zero, vectors};
use super::{Dyadic, ExactRoot, Verdict};
use crate::Truth;

/// What is true of a ray and an open cone, from the columns `ox,oy,oz,dx,dy,dz,bx,by,bz,rb,ax,ay,az,ra`: the base
/// with its radius, the apex with its own.
///
/// t is the smallest t ≥ `from`, which must be finite, at which the ray is on the wall; a ray in the wall is
/// on it from one end to the other. There is no t_out. Invalid, whichever comes first: a number that is not
/// finite, a zero direction, a radius below zero or two that are zero, an apex that is the base.
pub fn open_cone(case: [f64; 14], from: f64, precision: Precision) -> Truth {
    exact_open_cone(case, from).written(precision)
}

/// The same before anything is rounded. Panics where `from` is not finite.
pub fn exact_open_cone(case: [f64; 14], from: f64) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let [ox, oy, oz, dx, dy, dz, bx, by, bz, base_radius, ax, ay, az, apex_radius] = case;
    let [o, d, base, apex] = vectors(&[ox, oy, oz, dx, dy, dz, bx, by, bz, ax, ay, az]);
    if is_zero(&d) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    if base_radius < 0.0 || apex_radius < 0.0 || base_radius == apex_radius && base_radius == 0.0 {
        return Verdict::Invalid(Degenerate::RadiusNotPositive.reason());
    }
    let v = difference(&apex, &base);
    if is_zero(&v) {
        return Verdict::Invalid(Degenerate::NoHeight.reason());
    }
    let [base_radius, apex_radius] = [base_radius, apex_radius].map(Dyadic::of);
    let found = Line::new(&difference(&o, &base), &d, &v, &base_radius, &apex_radius).on_the_wall();
    let from = Dyadic::of(from);
    let first = match found {
        OnTheWall::Points(roots) => roots.into_iter().find(|root| root.compared_with(&from).is_ge()),
        OnTheWall::From([near, far]) => match () {
            () if near.compared_with(&from).is_ge() => Some(near),
            () if far.compared_with(&from).is_ge() => Some(ExactRoot::quotient(from, Dyadic::of(1.0))),
            () => None,
        },
    };
    first.map_or(Verdict::Miss(""), |t| Verdict::Hit { t, out: None })
}

/// Where a line is on the wall.
enum OnTheWall {
    /// At these points, the smaller t first.
    Points(Vec<ExactRoot>),
    /// From one end of it to the other.
    From([ExactRoot; 2]),
}

/// The numbers of the line p + t d from the base, each linear in t: its value at t = 0, and how fast it grows.
struct Line {
    /// e = V w − (w·v) v
    e: [[Dyadic; 3]; 2],
    /// V r = r_b (V − w·v) + r_a w·v
    radius: [Dyadic; 2],
    /// w·v
    above_base: [Dyadic; 2],
    /// V − w·v
    below_apex: [Dyadic; 2],
}

impl Line {
    fn new(
        p: &[Dyadic; 3],
        d: &[Dyadic; 3],
        v: &[Dyadic; 3],
        base_radius: &Dyadic,
        apex_radius: &Dyadic,
    ) -> Line {
        let vv = dot(v, v);
        let above_base = [p, d].map(|w| dot(w, v));
        let below_apex = [&vv - &above_base[0], -&above_base[1]];
        let e = [(p, &above_base[0]), (d, &above_base[1])]
            .map(|(w, w_v)| std::array::from_fn(|axis| &(&vv * &w[axis]) - &(w_v * &v[axis])));
        let radius = [0, 1].map(|i| &(base_radius * &below_apex[i]) + &(apex_radius * &above_base[i]));
        Line { e, radius, above_base, below_apex }
    }

    fn on_the_wall(&self) -> OnTheWall {
        let [e, e_t] = &self.e;
        let [radius, radius_t] = &self.radius;
        // ‖e‖² − (V r)² along the line is A t² − 2 B t + C.
        let a = &dot(e_t, e_t) - &radius_t.square();
        let b = &(radius * radius_t) - &dot(e, e_t);
        let c = &dot(e, e) - &radius.square();
        let between = Stretch::common([
            Stretch::above(&self.above_base[0], &self.above_base[1]),
            Stretch::above(&self.below_apex[0], &self.below_apex[1]),
        ]);
        let Some(between) = between else { return OnTheWall::Points(Vec::new()) };
        if a.is_zero() && b.is_zero() && c.is_zero() {
            return OnTheWall::From(between.ends());
        }
        let roots: Vec<ExactRoot> = if !a.is_zero() {
            Quadratic::new(a, b, c).map_or(Vec::new(), |equation| ExactRoot::roots(equation).into())
        } else if b.is_zero() {
            Vec::new()
        } else {
            vec![ExactRoot::quotient(c, &b + &b)]
        };
        OnTheWall::Points(roots.into_iter().filter(|root| between.holds(root)).collect())
    }
}

#[cfg(test)]
mod tests;

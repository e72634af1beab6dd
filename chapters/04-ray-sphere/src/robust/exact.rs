//! The fourth way of [`robust`](super): sums that are not rounded at all.
//!
//! It is for the few rays that the others leave in doubt: a tangent, an origin exactly on the surface,
//! numbers too far apart for any scale. It is slow, and true.

use math::{Exact, Hit, Ray3, Real, Roots, Vector, Wide};

use super::{Certainty, Chord};
use crate::{Hit3, Sphere};

/// A line through the sphere, as precisely as it is known.
struct Crossing {
    roots: Roots<Wide>,
    p: [Wide; 3],
    h: Wide,
}

/// What decides: the numbers of the closest approach, seen from the center.
#[derive(Clone, Copy)]
struct Approach {
    a: Wide,
    b: Wide,
    c: Wide,
    t_close: Wide,
    p: [Wide; 3],
    half_chord_squared: Wide,
}

/// The chord. The ray and the sphere must not be degenerate.
#[cold]
#[inline(never)]
pub(super) fn chord<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Chord {
    let [p_r, d, c] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let r: f64 = sphere.radius.into();
    let approach = exactly(p_r, d, c, r);
    let crossing = crossing(&approach);
    Chord {
        certainty: Certainty::Exact,
        a: approach.a.to_f64(),
        b: approach.b.to_f64(),
        t_close: approach.t_close.to_f64(),
        p: approach.p.map(Wide::to_f64),
        correction: 0.0,
        half_chord_squared: approach.half_chord_squared.to_f64(),
        h: crossing.as_ref().map(|crossing| crossing.h.to_f64()),
        c: Some(approach.c.to_f64()),
        roots: crossing.map(|Crossing { roots: Roots { near, far }, .. }| Roots {
            near: near.rounded(),
            far: far.rounded(),
        }),
    }
}

/// Where the line enters and leaves; `None` for a miss.
fn crossing(&Approach { a, c, t_close, p, half_chord_squared, .. }: &Approach) -> Option<Crossing> {
    if half_chord_squared.is_negative() {
        return None;
    }
    // On the side where h adds, nothing cancels; the other root follows from A t₁ t₂ = C.
    let h = (half_chord_squared / a).sqrt();
    let outer = if t_close.is_negative() { t_close - h } else { t_close + h };
    let inner = if h.is_zero() { outer } else { c / (a * outer) };
    let roots = if t_close.is_negative() {
        Roots { near: outer, far: inner }
    } else {
        Roots { near: inner, far: outer }
    };
    Some(Crossing { roots, p, h })
}

/// The closest approach from exact sums: A, B, C, D = B² − A C and A P = A L − B d, each rounded once.
fn exactly(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], r: f64) -> Approach {
    let direction = direction.map(Exact::new);
    let l: [Exact; 3] = std::array::from_fn(|axis| Exact::new(center[axis]) - Exact::new(origin[axis]));
    let r = Exact::new(r);
    let a = Exact::dot(&direction, &direction);
    let b = Exact::dot(&l, &direction);
    let c = Exact::dot(&l, &l) - r.clone() * r;
    let d = b.clone() * b.clone() - a.clone() * c.clone();
    let a_p: [Exact; 3] =
        std::array::from_fn(|axis| a.clone() * l[axis].clone() - b.clone() * direction[axis].clone());
    let [a, b, c, d] = [a, b, c, d].map(|exact| exact.to_wide());
    let p = a_p.map(|component| component.to_wide() / a);
    Approach { a, b, c, t_close: b / a, p, half_chord_squared: d / a }
}

/// The hit at the near root or the far one, which is `t` when rounded: n = (∓ h d − P) / r and x are
/// worked out from exact sums, in numbers that cannot overflow, and rounded at the end; x is p_r + t d
/// or c + r n, whichever adds the smaller number. The line must hit.
#[cold]
#[inline(never)]
pub(super) fn hit<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, t: R, enters: bool) -> Hit3<R> {
    let [origin, direction, center] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let approach = exactly(origin, direction, center, sphere.radius.into());
    let Some(Crossing { roots, p, h }) = crossing(&approach) else {
        return sphere.hit_at(t, ray.at(t));
    };
    let (wide_t, h) = if enters { (roots.near, -h) } else { (roots.far, h) };
    let [p_r, d, c]: [[Wide; 3]; 3] = [ray.origin, ray.direction, sphere.center].map(Wide::vector::<R, 3>);
    let r = Wide::of(sphere.radius);
    let from_center: [Wide; 3] = std::array::from_fn(|axis| h * d[axis] - p[axis]);
    let from_origin = d.map(|component| wide_t * component);
    let origin_is_nearer = (dot_wide(from_origin, from_origin) - r * r).is_negative();

    let round = |x: Wide| R::round_from(x.to_f64());
    let [x, y, z] = std::array::from_fn(|axis| match origin_is_nearer {
        true => round(p_r[axis] + from_origin[axis]),
        false => round(c[axis] + from_center[axis]),
    });
    let [n_x, n_y, n_z] = from_center.map(|component| round(component / r));
    Hit { t, point: R::vec3(x, y, z), normal: R::vec3(n_x, n_y, n_z) }
}

fn dot_wide(a: [Wide; 3], b: [Wide; 3]) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::super::tests::{two, work};
    use super::*;
    use math::Span;

    /// By hand: 4 − 10 + 18.
    #[test]
    fn a_product_of_wide_vectors() {
        let [a, b] = [[1.0, 2.0, 3.0], [4.0, -5.0, 6.0]].map(|v: [f64; 3]| v.map(Wide::from));
        assert_eq!(dot_wide(a, b).to_f64(), 12.0);
    }

    /// A ray up the z axis, 2⁻²⁰⁰ beside it, next to a tangent to a sphere of radius 3. By hand: t is z to the last
    /// digit. At z = 2 the point is p_r + t d, with all digits of p_r; at z = 4 it is c + r n, whose y = 3 − 3 is off
    /// by what P, its sum with h d and that with c are: 2⁻¹⁰² of 3, of 3 and of 3 + 3, in all less than 2⁻⁹⁸.
    #[test]
    fn a_point_has_the_digits_of_the_nearer_of_origin_and_center() {
        let tiny = two(-200);
        for (z, off) in [(2.0, 0.0), (4.0, two(-98))] {
            let touching = work([0.0, tiny, 0.0], [0.0, 0.0, 1.0], [0.0, 3.0, z], 3.0);
            assert_eq!(touching.chord.certainty, Certainty::Exact);
            let Hit3::<f64> { t, point, .. } = touching.hit(Span::ahead()).unwrap().unwrap();
            assert_eq!((t, point.x, point.z), (z, 0.0, z));
            assert!((point.y - tiny).abs() <= off, "{:e}", point.y);
        }
    }
}

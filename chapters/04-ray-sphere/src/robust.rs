//! Why the three fail, and what to do about it.
//!
//! On paper D = B² − A C decides, and t = (B ± √D)/A. In floating point three things go wrong:
//!
//! 1. **B² − A C cancels.** Seen from afar both terms are (distance/radius)² times their difference:
//!    at 1e8 radii nothing of D is left in `f64`, and the verdict is a coin toss. House's way round
//!    avoids this: with P = c − x_close, at right angles to the ray, D = A (r² − P·P), and P is small.
//!    But x_close − c taken in world coordinates loses what a distant origin costs, and near a tangent
//!    r² − P·P cancels all the same.
//! 2. **B − √D cancels** when the sphere is near and large. Vieta's C = A t₁ t₂ gives the small root from
//!    the large one without a subtraction.
//! 3. **C = L·L − r² cancels** when the origin is near the surface, and even L = c − p_r is rounded.
//!
//! So: walk to the point of closest approach as House does, but from the center. Most rays miss by so
//! much that this is enough. For the others take L in two parts (its rounding error is a number too)
//! and twice the digits everywhere; add half the chord on the side where it adds; take the other root
//! from Vieta. Then ask whether the error that is left could matter, to the verdict, to t or to the
//! normal; the bounds are beside their constants below. Where it could, sum A, B, C and D exactly, in
//! integers as long as it takes ([`math::exact`]). The verdict is then true, not likely, and t and n
//! are good to a rounding.
//!
//! Squares of 1e±200 overflow or vanish; there the exact sums are taken straight away. `f32` is
//! computed in `f64`, where products of `f32` are exact, and rounded at the end.

use math::two_part::{dot, two_product, two_sum};
use math::{Degenerate, Exact, Hit, Ray3, Real, Roots, Span, TwoPart, Vector, Wide};

use crate::{Hit3, Sphere};

/// How the verdict was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`: a miss by more than any rounding could make up for.
    AtOnce,
    /// With twice the digits, and error bounds that exclude any other verdict.
    TwoPart,
    /// By exact sums.
    Exact,
}

impl Certainty {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Certainty::AtOnce => "certain at once",
            Certainty::TwoPart => "certain by its error bound",
            Certainty::Exact => "too close to call: summed exactly",
        }
    }
}

/// Every number of the robust method, rounded to `f64` for the reader; it is worked out with twice the
/// digits, so one line may not follow from the line above as it is printed.
///
/// A degenerate ray or sphere gives NaN after L; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// How it was decided.
    pub certainty: Certainty,
    /// L = c − p_r: the rounded difference.
    pub l: [f64; 3],
    /// What the rounding of L dropped.
    pub l_error: [f64; 3],
    /// A = d · d
    pub a: f64,
    /// B = L · d (CSC418's with the other sign)
    pub b: f64,
    /// C = L · L − r²
    pub c: f64,
    /// t_close = B / A, in lengths of the direction as given.
    pub t_close: f64,
    /// P = L − t_close d: from the point of closest approach to the center.
    pub p: [f64; 3],
    /// a² = r² − P · P, the square of half the chord; its sign, exact, is the verdict.
    pub half_chord_squared: f64,
    /// h = √(a² / A), half the chord in lengths of the direction. `None` for a miss.
    pub h: Option<f64>,
    /// The roots and half the chord before they are rounded.
    crossing: Option<Crossing>,
}

/// A line through the sphere, as precisely as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    certainty: Certainty,
}

/// How far a component of P may be off, in ‖L‖. With two-part operations that err by 2^−102 at the
/// most, a dot product is within 2^−100 of the sum of its magnitudes, t_close = B/A then within
/// 2^−99 ‖L‖/‖d‖, and P = L − t_close d within 2^−98 ‖L‖: a fourth of this.
const P_ERROR: f64 = 1.0 / (1u128 << 96) as f64;
/// How far a sum of squares, r² − P·P or L·L − r², is off on its own account, in the sum of their
/// magnitudes. (P's error adds 2 ‖P‖ P_ERROR ‖L‖ and its square to the former.)
const SUM_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// The same in plain `f64`, whose operations err by u = 2^−53: t_close is within 8u ‖L‖/‖d‖, P within
/// 11u ‖L‖, less than this.
const PLAIN_P_ERROR: f64 = 1.0 / (1u64 << 49) as f64;
/// And r² − P·P adds 4u of r² + P·P.
const PLAIN_SUM_ERROR: f64 = 1.0 / (1u64 << 51) as f64;
/// What an error may be of the number that it spoils: a quarter of the last digit of an `f64`.
const HARMLESS: f64 = 1.0 / (1u64 << 55) as f64;
/// Between these, squares and the errors of their products neither overflow nor vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Works out the robust method.
pub fn robust<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Robust<R> {
    let [origin, direction, center] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let r: f64 = sphere.radius.into();
    let l: [TwoPart; 3] = std::array::from_fn(|axis| two_sum(center[axis], -origin[axis]));
    let nan = f64::NAN;
    let mut work = Robust {
        ray: *ray,
        sphere: *sphere,
        certainty: Certainty::TwoPart,
        l: l.map(|part| part.hi),
        l_error: l.map(|part| part.lo),
        a: nan,
        b: nan,
        c: nan,
        t_close: nan,
        p: [nan; 3],
        half_chord_squared: nan,
        h: None,
        crossing: None,
    };
    if sphere.check(ray).is_err() {
        return work;
    }
    let safe = is_safe(direction, work.l, r);
    if safe && work.misses_at_once(direction, r) {
        return work;
    }
    let two_part = if safe { in_two_parts(direction, l, r) } else { None };
    let approach = two_part.unwrap_or_else(|| exactly(origin, direction, center, r));
    let Approach { a, b, c, t_close, p, half_chord_squared, certainty } = approach;
    work.certainty = certainty;
    [work.a, work.b, work.c] = [a, b, c].map(Wide::to_f64);
    [work.t_close, work.half_chord_squared] = [t_close, half_chord_squared].map(Wide::to_f64);
    work.p = p.map(Wide::to_f64);
    if half_chord_squared.is_negative() {
        return work;
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
    work.h = Some(h.to_f64());
    work.crossing = Some(Crossing { roots, p, h });
    work
}

/// The closest approach with twice the digits; `None` where the error left could matter.
fn in_two_parts(direction: [f64; 3], l: [TwoPart; 3], r: f64) -> Option<Approach> {
    let d = direction;
    let r_r = two_product(r, r);
    let (a, b, l_l) = (dot(d.map(TwoPart::from), d), dot(l, d), dot(l, l));
    let c = l_l - r_r;
    let t_close = b / a;
    let p: [TwoPart; 3] = std::array::from_fn(|axis| l[axis] - t_close * d[axis]);
    let p_p = dot(p, p);
    let half_chord_squared = r_r - p_p;

    let p_error = P_ERROR * l_l.hi.sqrt();
    let error = p_error * (2.0 * p_p.hi.sqrt() + p_error) + SUM_ERROR * (p_p.hi + r * r);
    let certain = if half_chord_squared.hi < 0.0 {
        -half_chord_squared.hi > error
    } else {
        // An error δ in a² is one of δ/2a in a. It spoils t as a share of the way to the outer root, and n
        // as a share of r; so does the error of P. That of C spoils the inner root. (And since δ is at
        // least SUM_ERROR r², a² that passes is far above its error: the line does hit.)
        let half_chord = half_chord_squared.hi.sqrt();
        let way = t_close.hi.abs() * a.hi.sqrt() + half_chord;
        let spoiled = way.min(r);
        error <= HARMLESS * half_chord * spoiled
            && p_error <= HARMLESS * spoiled
            && SUM_ERROR * (l_l.hi + r * r) <= HARMLESS * c.hi.abs()
    };
    let [a, b, c, t_close, half_chord_squared] = [a, b, c, t_close, half_chord_squared].map(Wide::from);
    let approach = Approach {
        a,
        b,
        c,
        t_close,
        p: p.map(Wide::from),
        half_chord_squared,
        certainty: Certainty::TwoPart,
    };
    certain.then_some(approach)
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
    Approach { a, b, c, t_close: b / a, p, half_chord_squared: d / a, certainty: Certainty::Exact }
}

/// Whether squares of these numbers stay well inside the range of `f64`.
fn is_safe(direction: [f64; 3], l: [f64; 3], r: f64) -> bool {
    let largest = |v: [f64; 3]| v.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    SAFE.contains(&largest(direction)) && SAFE.contains(&largest(l).max(r))
}

impl<R: Real> Robust<R> {
    /// Works the closest approach out in plain `f64`, and tells whether that is enough: most rays miss
    /// most spheres, and by far.
    fn misses_at_once(&mut self, d: [f64; 3], r: f64) -> bool {
        let l = self.l;
        let plain_dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        // Not below the length of the vector, and without a root.
        let at_least_length = |v: [f64; 3]| v[0].abs() + v[1].abs() + v[2].abs();
        let (a, b) = (plain_dot(d, d), plain_dot(l, d));
        let t_close = b / a;
        let p: [f64; 3] = std::array::from_fn(|axis| l[axis] - t_close * d[axis]);
        let p_p = plain_dot(p, p);

        let p_error = PLAIN_P_ERROR * at_least_length(l);
        let error = p_error * (2.0 * at_least_length(p) + p_error) + PLAIN_SUM_ERROR * (p_p + r * r);
        let half_chord_squared = r * r - p_p;
        if half_chord_squared >= -error {
            return false;
        }
        self.certainty = Certainty::AtOnce;
        (self.a, self.b, self.c) = (a, b, plain_dot(l, l) - r * r);
        (self.t_close, self.p, self.half_chord_squared) = (t_close, p, half_chord_squared);
        true
    }

    /// The two crossings, rounded to the precision of the ray; `None` for a miss.
    pub fn roots(&self) -> Option<Roots<R>> {
        let Roots { near, far } = self.crossing?.roots;
        Some(Roots { near: near.rounded(), far: far.rounded() })
    }

    /// The nearest hit in `span`. t, n = (∓ h d − P) / r and x are worked out with twice the digits and
    /// rounded at the end; x is p_r + t d or c + r n, whichever adds the smaller number.
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.sphere.check(&self.ray)?;
        let (Some(crossing), Some(roots)) = (self.crossing, self.roots()) else { return Ok(None) };
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        let enters = span.contains(roots.near);
        let (wide_t, h) =
            if enters { (crossing.roots.near, -crossing.h) } else { (crossing.roots.far, crossing.h) };

        let [p_r, d, c]: [[Wide; 3]; 3] =
            [self.ray.origin, self.ray.direction, self.sphere.center].map(Wide::vector::<R, 3>);
        let r = Wide::of(self.sphere.radius);
        let from_center: [Wide; 3] = std::array::from_fn(|axis| h * d[axis] - crossing.p[axis]);
        let from_origin = d.map(|component| wide_t * component);
        let origin_is_nearer = (dot_wide(from_origin, from_origin) - r * r).is_negative();

        let round = |x: Wide| R::round_from(x.to_f64());
        let [x, y, z] = std::array::from_fn(|axis| match origin_is_nearer {
            true => round(p_r[axis] + from_origin[axis]),
            false => round(c[axis] + from_center[axis]),
        });
        let [n_x, n_y, n_z] = from_center.map(|component| round(component / r));
        Ok(Some(Hit { t, point: R::vec3(x, y, z), normal: R::vec3(n_x, n_y, n_z) }))
    }
}

fn dot_wide(a: [Wide; 3], b: [Wide; 3]) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn work(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], radius: f64) -> Robust<f64> {
        robust(&Ray3::new(origin.into(), direction.into()), &Sphere { center: center.into(), radius })
    }

    /// A tangent of whole numbers is one at every scale at which they are floats.
    #[test]
    fn a_tangent_is_a_tangent_at_every_scale() {
        // by hand: the ray x = 3 in the direction of z touches the sphere of radius 3 around (0, 0, 8)
        for power in [-1000, -300, -40, 0, 40, 300, 1000] {
            let scale = 2.0_f64.powi(power);
            let [x, r, z] = [3.0, 3.0, 8.0].map(|number| number * scale);
            for length in [1.0, 1e-150, 1e150, 5e-324] {
                let touching = work([x, 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r);
                assert_eq!(touching.half_chord_squared, 0.0, "scale 2^{power}, length {length:e}");
                assert!(touching.roots().is_some_and(|roots| roots.near == roots.far));
                // one digit farther out it misses, one digit farther in it hits
                assert!(
                    work([x.next_up(), 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r).roots().is_none()
                );
                let inside = work([x.next_down(), 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r);
                assert!(inside.roots().is_some());
            }
        }
    }

    #[test]
    fn a_normal_has_length_one_however_far_the_sphere() {
        for distance in [10.0, 1e8, 1e16, 1e40, 1e200] {
            // aimed half a radius off the center, from an origin whose digits reach below the radius
            let touching = work([0.5, 0.25, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, distance], 1.0);
            let hit = touching.hit(Span::ahead()).unwrap().unwrap();
            let closed_form = DVec3::new(0.5, 0.25, -(1.0 - 0.25 - 0.0625_f64).sqrt());
            assert!((hit.normal - closed_form).length() < 1e-15, "{distance:e}: {:?}", hit.normal);
        }
    }

    /// The two roots of an exact tangent are one number, also where it lies halfway between two floats.
    #[test]
    fn a_tangent_leaves_where_it_enters() {
        let touching = work([6.0, 0.0, -1.659_619_002_541_466_4e16], [0.0, 0.0, 0.5], [0.0, 0.0, 3.0], 6.0);
        let Roots { near, far } = touching.roots().unwrap();
        assert_eq!(near, far);
    }

    #[test]
    fn a_point_near_the_eye_keeps_its_digits_beside_a_huge_sphere() {
        // the ground: y = 0 to within 1e−11 around the origin, seen from a height of 1
        let radius = 2e11;
        let hit = work([0.0, 1.0, 0.0], [0.6, -0.8, 0.0], [0.0, -radius, 0.0], radius);
        let point = hit.hit(Span::ahead()).unwrap().unwrap().point;
        // closed form: −x²/2r to the first order; x = 0.75
        let y = -0.75 * 0.75 / (2.0 * radius);
        assert!((point.y / y - 1.0).abs() < 1e-10, "{point}");
    }

    #[test]
    fn an_origin_on_the_surface_touches_at_zero() {
        // (2, 3, 6) lies on the sphere of radius 7; by hand, along −x it leaves at x = −2
        let touching = work([2.0, 3.0, 6.0], [-1.0, 0.0, 0.0], [0.0; 3], 7.0);
        assert_eq!(touching.certainty, Certainty::Exact);
        assert_eq!(touching.roots(), Some(Roots { near: 0.0, far: 4.0 }));
        // a tangent there
        let grazing = work([2.0, 3.0, 6.0], [3.0, -2.0, 0.0], [0.0; 3], 7.0);
        assert_eq!(grazing.roots(), Some(Roots { near: 0.0, far: 0.0 }));
    }
}

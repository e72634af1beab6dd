//! The slow ways of [`robust`](super): three parts, and exact sums.
//!
//! They are for the few rays that two parts leave in doubt: an origin on the plane, a ray next to
//! parallel or exactly so, numbers whose products overflow or vanish.

use math::two_part::{distilled, two_product, two_sum};
use math::{Exact, Parallel, Ray3, Real, TwoPart, Vector, Wide};

use super::sums::{SAFE, Sum, from_plane};
use super::{CertainSum, Certainty, Found};
use crate::Plane;

/// n · v, as precisely as it is known.
#[derive(Clone, Copy)]
struct WideSum {
    wide: Wide,
    certainty: Certainty,
}

/// Both sums and what Eq. 4.2 comes to.
#[cold]
#[inline(never)]
pub(super) fn meeting(
    p_r: [f64; 3],
    u_r: [f64; 3],
    p_0: [f64; 3],
    n: [f64; 3],
) -> (CertainSum, CertainSum, Found) {
    let ray = Ray3::<f64>::new(p_r.into(), u_r.into());
    let plane = Plane::<f64> { point: p_0.into(), normal: n.into() };
    if plane.check(&ray).is_err() {
        let nothing = CertainSum { value: f64::NAN, certainty: Certainty::AtOnce };
        return (nothing, nothing, Found::Degenerate);
    }
    let (n_dot_p, n_dot_u) = (n_dot_p(p_r, p_0, n), n_dot_u(u_r, n));
    let found = if !n_dot_u.wide.is_zero() {
        Found::At((-n_dot_p.wide / n_dot_u.wide).rounded())
    } else if n_dot_p.wide.is_zero() {
        Found::Never(Parallel::Within)
    } else {
        Found::Never(Parallel::Apart)
    };
    let rounded = |sum: WideSum| CertainSum { value: sum.wide.to_f64(), certainty: sum.certainty };
    (rounded(n_dot_p), rounded(n_dot_u), found)
}

fn n_dot_p(p_r: [f64; 3], p_0: [f64; 3], n: [f64; 3]) -> WideSum {
    in_parts(n, from_plane(p_r, p_0)).unwrap_or_else(|| {
        exactly(n, std::array::from_fn(|axis| Exact::new(p_r[axis]) - Exact::new(p_0[axis])))
    })
}

fn n_dot_u(u_r: [f64; 3], n: [f64; 3]) -> WideSum {
    in_parts(n, u_r.map(TwoPart::from)).unwrap_or_else(|| exactly(n, u_r.map(Exact::new)))
}

/// n · v in two parts or in three; `None` where the error left could matter.
fn in_parts(n: [f64; 3], v: [TwoPart; 3]) -> Option<WideSum> {
    let sum = Sum::in_two_parts(n, v);
    if sum.is_certain {
        let wide = Wide::from(TwoPart { hi: sum.hi, lo: sum.lo });
        return Some(WideSum { wide, certainty: Certainty::TwoPart });
    }
    let sum = in_three_parts(n, v)?;
    Some(WideSum { wide: Wide::from(sum), certainty: Certainty::ThreePart })
}

/// n · v from the twelve numbers of which the products of its parts consist, summed twice over with every
/// rounding error kept (Ogita, Rump and Oishi's SumK). `None` where the error left could matter.
///
/// With u = 2^−53 and S, the sum of their magnitudes: the errors of the first pass are at most 11u S
/// together, those of the second (11u)² S and u of the sum. Summed in plain `f64` they lose 11u of that:
/// (11u)³ S, less than 2^−148 S, and 11u² of the sum. Where the sum is at least 2^−92 S, that is u/8 of it
/// and hardly more.
fn in_three_parts(n: [f64; 3], v: [TwoPart; 3]) -> Option<TwoPart> {
    const LEAST: f64 = 1.0 / (1u128 << 92) as f64;
    let factors: [(f64, f64); 6] =
        std::array::from_fn(|i| (n[i % 3], if i < 3 { v[i].lo } else { v[i % 3].hi }));
    let products = factors.map(|(n, v)| two_product(n, v));
    let terms: [f64; 12] = std::array::from_fn(|i| if i < 6 { products[i].lo } else { products[i - 6].hi });
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    let distilled = distilled(terms);
    let [errors @ .., sum] = distilled;
    let sum = two_sum(sum, errors.iter().sum());
    let is_certain = SAFE.contains(&size) && sum.hi.abs() >= LEAST * size;
    // Whole numbers that cancel, and products by zero, leave twelve zeros: then the sum is zero, if no
    // product or error was lost.
    let is_kept = |((n, v), product): (&(f64, f64), &TwoPart)| {
        *n == 0.0 || *v == 0.0 || SAFE.contains(&product.hi.abs())
    };
    let is_zero = distilled == [0.0; 12] && factors.iter().zip(&products).all(is_kept);
    (is_certain || is_zero).then_some(sum)
}

/// n · v without any rounding.
fn exactly(n: [f64; 3], v: [Exact; 3]) -> WideSum {
    WideSum { wide: Exact::dot(&n.map(Exact::new), &v).to_wide(), certainty: Certainty::Exact }
}

/// x = p_r + t u_r in numbers that cannot overflow, rounded at the end. The ray must meet the plane.
/// (Where x cancels, what is left is 2^−100 of p_r, not zero.)
#[cold]
#[inline(never)]
pub(super) fn point<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> R::Vec3 {
    let [p_r, u_r, p_0, n] = [ray.origin, ray.direction, plane.point, plane.normal].map(Vector::in_f64::<3>);
    let t = -n_dot_p(p_r, p_0, n).wide / n_dot_u(u_r, n).wide;
    let [x, y, z] = std::array::from_fn(|axis| {
        R::round_from((Wide::from(p_r[axis]) + t * Wide::from(u_r[axis])).to_f64())
    });
    R::vec3(x, y, z)
}

/// n · (p_r − p_0) / ‖n‖; zero for a degenerate ray or plane.
pub(super) fn distance<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> R {
    if plane.check(ray).is_err() {
        return R::from(0.0);
    }
    let [p_r, p_0, n] = [ray.origin, plane.point, plane.normal].map(Vector::in_f64::<3>);
    let [x, y, z] = n.map(|component| Wide::from(component) * Wide::from(component));
    R::round_from((n_dot_p(p_r, p_0, n).wide / (x + y + z).sqrt()).to_f64())
}

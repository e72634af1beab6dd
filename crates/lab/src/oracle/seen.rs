//! What the tests of the solids ask instead of an equation: on which side of a point of the line a solid lies.

use std::cmp::Ordering;

use super::vector::dot;
use super::{Dyadic, UnitObject};

/// Where a solid is, seen from a point of the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Solid {
    /// At the point, with it strictly inside or on the boundary.
    Here {
        strictly: bool,
    },
    Ahead,
    Behind,
    /// The line passes it by.
    Nowhere,
}

/// Seen from t. Each of the solid's conditions f ≤ 0 is convex along the line: where one is not met, the sign
/// of f' tells where it is.
pub(super) fn seen_from(t: &Dyadic, shape: UnitObject, [p, d]: &[[Dyadic; 3]; 2]) -> Solid {
    let x: [Dyadic; 3] = std::array::from_fn(|axis| &p[axis] + &(t * &d[axis]));
    let one = Dyadic::of(1.0);
    let flat = |v: &[Dyadic; 3]| [v[0].clone(), v[1].clone(), Dyadic::of(0.0)];
    let ball = |x: [Dyadic; 3], d: [Dyadic; 3]| ((&dot(&x, &x) - &one).sign(), dot(&x, &d).sign());
    let conditions = match shape {
        UnitObject::Sphere => vec![ball(x, d.clone())],
        UnitObject::Cylinder => vec![
            ((&x[2] - &one).sign(), d[2].sign()),
            ((&x[2] + &one).sign().reverse(), d[2].sign().reverse()),
            ball(flat(&x), flat(d)),
        ],
        _ => vec![(x[2].sign().reverse(), d[2].sign().reverse()), wall_of_cone(&x, d)],
    };
    let outside: Vec<Ordering> =
        conditions.iter().filter(|(f, _)| f.is_gt()).map(|(_, slope)| *slope).collect();
    match &outside[..] {
        [] => Solid::Here { strictly: conditions.iter().all(|(f, _)| f.is_lt()) },
        slopes if slopes.iter().all(|slope| slope.is_lt()) => Solid::Ahead,
        slopes if slopes.iter().all(|slope| slope.is_gt()) => Solid::Behind,
        _ => Solid::Nowhere,
    }
}

/// The signs of f = 2 ρ + z − 1 with ρ² = x² + y², and of f' = 2 (x d_x + y d_y) / ρ + d_z.
fn wall_of_cone(x: &[Dyadic; 3], d: &[Dyadic; 3]) -> (Ordering, Ordering) {
    let across = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&a[0] * &b[0]) + &(&a[1] * &b[1]);
    let twice = |x: &Dyadic| x + x;
    let below = &Dyadic::of(1.0) - &x[2];
    let rho_2 = across(x, x);
    let f = if below.sign().is_lt() {
        Ordering::Greater
    } else {
        (&twice(&twice(&rho_2)) - &below.square()).sign()
    };
    // On the axis ρ has two slopes, ± the length of (d_x, d_y); f' has a sign where that of d_z prevails.
    let (u, v_2) = match rho_2.is_zero() {
        true => (Dyadic::of(0.0), &d[2].square() - &twice(&twice(&across(d, d)))),
        false => (twice(&across(x, d)), &rho_2 * &d[2].square()),
    };
    let slope = match (u.sign(), d[2].sign()) {
        (Ordering::Equal, v) => {
            if v_2.sign().is_gt() {
                v
            } else {
                Ordering::Equal
            }
        }
        (u_sign, v) if v == u_sign.reverse() => match (&u.square() - &v_2).sign() {
            Ordering::Greater => u_sign,
            Ordering::Less => v,
            Ordering::Equal => Ordering::Equal,
        },
        (u_sign, _) => u_sign,
    };
    (f, slope)
}

//! The exact answer to a case, by the root rule of the contract: the smallest root ≥ 0, touching
//! counts. A root is not computed: it is compared with floats, in integers.

use std::cmp::Ordering;

use stage::Precision;

use crate::dyadic::{Dyadic, difference, dot};

/// What is true of a case that is not invalid.
pub(crate) enum Verdict {
    /// It is hit at `t`; where the stage has a `t_out`, the line leaves at `out`.
    Hit { t: Root, out: Option<Root> },
    /// A miss, with the reason that a result row gives.
    Miss(&'static str),
}

/// A value of t.
#[derive(Clone)]
pub(crate) enum Root {
    /// n / d, with d > 0.
    Quotient(Dyadic, Dyadic),
    /// The smaller root of A t² − 2 B t + C, with A > 0 and B² ≥ A C.
    Near(Dyadic, Dyadic, Dyadic),
    /// The larger one.
    Far(Dyadic, Dyadic, Dyadic),
}

impl Root {
    fn quotient(n: &Dyadic, d: &Dyadic) -> Root {
        if d.sign().is_lt() { Root::Quotient(-n, -d) } else { Root::Quotient(n.clone(), d.clone()) }
    }

    /// How it compares with a number.
    pub(crate) fn compared_with(&self, t: f64) -> Ordering {
        let t = &Dyadic::of(t);
        match self {
            Root::Quotient(n, d) => (n - &(d * t)).sign(),
            Root::Near(a, b, c) => match (&(a * t) - b).sign() {
                Ordering::Greater => Ordering::Less,
                _ => polynomial(a, b, c, t).sign(),
            },
            Root::Far(a, b, c) => match (&(a * t) - b).sign() {
                Ordering::Less => Ordering::Greater,
                _ => polynomial(a, b, c, t).sign().reverse(),
            },
        }
    }

    /// Whether `t` is one of the numbers of the precision next to the root, the root itself, or
    /// infinite where the root is beyond the largest number.
    pub(crate) fn is_next_to(&self, t: f64, precision: Precision) -> bool {
        if t.is_nan() {
            return false;
        }
        let (below, above) = match precision {
            Precision::F32 => ((t as f32).next_down().into(), (t as f32).next_up().into()),
            Precision::F64 => (t.next_down(), t.next_up()),
        };
        let is_below = below == f64::NEG_INFINITY || self.compared_with(below).is_ge();
        let is_above = above == f64::INFINITY || self.compared_with(above).is_le();
        is_below && is_above
    }

    fn is_ahead(&self) -> bool {
        self.compared_with(0.0).is_ge()
    }
}

/// A t² − 2 B t + C
fn polynomial(a: &Dyadic, b: &Dyadic, c: &Dyadic, t: &Dyadic) -> Dyadic {
    &(&(&(a * t) - &(b + b)) * t) + c
}

/// A line that enters at one root and leaves at another, seen from t = 0.
fn through(near: Root, far: Root) -> Verdict {
    let first = if near.is_ahead() { near } else { far.clone() };
    if first.is_ahead() { Verdict::Hit { t: first, out: Some(far) } } else { Verdict::Miss("") }
}

/// The wall: (x − p_x) / u_x for both faces.
pub(crate) fn of_wall([ox, _, dx, _, front, back]: [f64; 6]) -> Verdict {
    if dx == 0.0 {
        return Verdict::Miss(if ox == front || ox == back { "in-plane" } else { "parallel" });
    }
    let [p, u, front, back] = [ox, dx, front, back].map(Dyadic::of);
    let [to_front, to_back] = [front, back].map(|x| Root::quotient(&(&x - &p), &u));
    if dx > 0.0 { through(to_front, to_back) } else { through(to_back, to_front) }
}

/// The plane: n · (p_0 − p_r) / n · u_r.
pub(crate) fn of_plane(case: [f64; 12]) -> Verdict {
    let [p_r, u_r, p_0, n] = vectors(case);
    let (above, rise) = (dot(&n, &difference(&p_0, &p_r)), dot(&n, &u_r));
    if rise.is_zero() {
        return Verdict::Miss(if above.is_zero() { "in-plane" } else { "parallel" });
    }
    let t = Root::quotient(&above, &rise);
    if t.is_ahead() { Verdict::Hit { t, out: None } } else { Verdict::Miss("") }
}

/// The sphere: A t² − 2 B t + C = 0, with B = L · d, C = L · L − r², L = c − p_r.
pub(crate) fn of_sphere([ox, oy, oz, dx, dy, dz, cx, cy, cz, r]: [f64; 10]) -> Verdict {
    let [o, d, c] = vectors([ox, oy, oz, dx, dy, dz, cx, cy, cz]);
    let l = difference(&c, &o);
    let (a, b, c) = (dot(&d, &d), dot(&l, &d), &dot(&l, &l) - &Dyadic::of(r).square());
    if (&b.square() - &(&a * &c)).sign().is_lt() {
        return Verdict::Miss("");
    }
    through(Root::Near(a.clone(), b.clone(), c.clone()), Root::Far(a, b, c))
}

/// Numbers by threes.
fn vectors<const N: usize, const VECTORS: usize>(numbers: [f64; N]) -> [[Dyadic; 3]; VECTORS] {
    std::array::from_fn(|i| std::array::from_fn(|axis| Dyadic::of(numbers[3 * i + axis])))
}

#[test]
fn roots_are_compared_exactly() {
    // by hand: the sphere of radius 5 around (0, 0, 13), the ray 3 beside its center: t = 13 ± 4
    let Verdict::Hit { t, out: Some(out) } = of_sphere([3., 0., 0., 0., 0., 1., 0., 0., 13., 5.]) else {
        panic!("a hit")
    };
    for (root, exact) in [(t, 9.0_f64), (out, 17.0)] {
        assert_eq!(root.compared_with(exact), Ordering::Equal);
        assert_eq!(root.compared_with(exact.next_down()), Ordering::Greater);
        assert_eq!(root.compared_with(exact.next_up()), Ordering::Less);
        assert!(root.is_next_to(exact.next_up(), Precision::F64));
        assert!(!root.is_next_to(exact.next_up().next_up(), Precision::F64));
        assert!(!root.is_next_to(f64::NAN, Precision::F64));
    }
    // by hand: 1e10 / 5e−324 is beyond the largest number
    let Verdict::Hit { t, .. } = of_wall([0., 0., 5e-324, 0., 1e10, 2e10]) else { panic!("a hit") };
    assert!(t.is_next_to(f64::INFINITY, Precision::F64) && !t.is_next_to(1e308, Precision::F64));
    assert!(matches!(of_wall([4., 1., 0., 1., 4., 5.]), Verdict::Miss("in-plane")));
    assert!(matches!(of_sphere([6., 0., 0., 0., 0., 1., 0., 0., 13., 5.]), Verdict::Miss("")));
}

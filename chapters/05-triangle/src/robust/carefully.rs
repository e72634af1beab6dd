//! The slow ways of [`robust`](super): the same formulas with twice the digits, and exactly.

use std::cmp::Ordering;

use math::{Bounded, Exact, Ray3, Real, Sure, TwoPart, Vector, Wide};

use super::{Certainty, Passage, Robust};
use crate::{Triangle, area};

/// The numbers of the question in `f64`: ā, d and the corners.
type Numbers = ([f64; 3], [f64; 3], [[f64; 3]; 3]);

fn numbers<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Numbers {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64);
    (o, d, triangle.corners().map(Vector::in_f64))
}

/// Works it out with as many digits as it takes.
#[cold]
#[inline(never)]
pub(super) fn robust<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Robust<R> {
    let (ray, triangle) = (*ray, *triangle);
    let nothing = Robust {
        ray,
        triangle,
        volumes: [f64::NAN; 3],
        d_dot_n: f64::NAN,
        lambda: None,
        certainty: Certainty::AtOnce,
        passage: Passage::Degenerate,
    };
    if triangle.check(&ray).is_err() {
        return nothing;
    }
    passed::<Bounded<f64>, R>(ray, triangle, Certainty::AtOnce)
        .or_else(|| passed::<Bounded<TwoPart>, R>(ray, triangle, Certainty::TwoPart))
        .or_else(|| passed::<Exact, R>(ray, triangle, Certainty::Exact))
        .unwrap_or(nothing) // exact numbers are never in doubt
}

/// The three volumes.
fn volumes<N: Sure>(o: [f64; 3], d: [f64; 3], corners: [[f64; 3]; 3]) -> [N; 3] {
    let d: [N; 3] = d.map(N::of);
    let [a, b, c]: [[N; 3]; 3] = corners.map(|p| std::array::from_fn(|axis| N::difference(p[axis], o[axis])));
    [N::dot(&d, &N::cross(&b, &c)), N::dot(&d, &N::cross(&c, &a)), N::dot(&d, &N::cross(&a, &b))]
}

/// With numbers of one kind; `None` where they leave a doubt.
fn passed<N: Sure, R: Real>(ray: Ray3<R>, triangle: Triangle<R>, certainty: Certainty) -> Option<Robust<R>> {
    let (o, d, corners) = numbers(&ray, &triangle);
    let volumes = volumes::<N>(o, d, corners);
    let [u, v, w] = volumes.clone();
    let d_dot_n = u + v + w;
    let about = (volumes.each_ref().map(N::about), d_dot_n.about());
    let passage = passage(volumes.each_ref().map(N::sign))?;
    let lambda = if passage == Passage::Through {
        let n = area::normal::<N>(corners);
        let to_p1 = std::array::from_fn(|axis| N::difference(corners[0][axis], o[axis]));
        Some(N::quotient(&N::dot(&to_p1, &n), &N::dot(&d.map(N::of), &n))?)
    } else {
        None
    };
    Some(Robust { ray, triangle, volumes: about.0, d_dot_n: about.1, lambda, certainty, passage })
}

/// By the signs of the three volumes; `None` where those that are in doubt could matter.
fn passage(signs: [Option<Ordering>; 3]) -> Option<Passage> {
    let has = |sign: Ordering| signs.contains(&Some(sign));
    if has(Ordering::Less) && has(Ordering::Greater) {
        return Some(Passage::Past);
    }
    if signs.contains(&None) {
        return None;
    }
    let is_along = !has(Ordering::Less) && !has(Ordering::Greater);
    Some(if is_along { Passage::Along } else { Passage::Through })
}

/// α and β, the second and third volume over d · n.
pub(super) fn alpha_beta<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<(R, R)> {
    triangle.check(ray).ok()?;
    shares::<Bounded<f64>, R>(ray, triangle)
        .or_else(|| shares::<Bounded<TwoPart>, R>(ray, triangle))
        .or_else(|| shares::<Exact, R>(ray, triangle))
}

fn shares<N: Sure, R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<(R, R)> {
    let (o, d, corners) = numbers(ray, triangle);
    let [_, v, w] = volumes::<N>(o, d, corners);
    let d_dot_n = N::dot(&d.map(N::of), &area::normal::<N>(corners));
    Some((N::quotient(&v, &d_dot_n)?, N::quotient(&w, &d_dot_n)?))
}

/// n / ‖n‖ in numbers that neither overflow nor vanish.
pub(super) fn unit_normal<R: Real>(triangle: &Triangle<R>) -> R::Vec3 {
    let n =
        area::normal::<Exact>(triangle.corners().map(Vector::in_f64)).map(|component| component.to_wide());
    let length = n.into_iter().fold(Wide::ZERO, |sum, component| sum + component * component).sqrt();
    let [x, y, z] = n.map(|component| R::round_from((component / length).to_f64()));
    R::vec3(x, y, z)
}

//! The slow ways of [`robust`](super): with twice the digits, and exactly.
//!
//! Each formula is written once, for any number that is [`Sure`] of its sign. A ray that is aimed at an edge leaves one volume
//! in doubt, and that one alone is then summed exactly.

use std::cmp::Ordering;

use math::{Bounded, Certainty, Exact, Ray3, Real, Sure, TwoPart, Vector, Wide};

use super::{Passage, Robust};
use crate::{Triangle, area};

/// A ray and a triangle in `f64`, which holds every `f32`.
#[derive(Clone, Copy)]
struct Question {
    o: [f64; 3],
    d: [f64; 3],
    corners: [[f64; 3]; 3],
}

impl Question {
    fn new<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Question {
        let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64);
        Question { o, d, corners: triangle.corners().map(Vector::in_f64) }
    }

    /// A corner seen from the origin of the ray.
    fn seen<N: Sure>(&self, corner: usize) -> [N; 3] {
        std::array::from_fn(|axis| N::difference(self.corners[corner][axis], self.o[axis]))
    }

    /// The volume of the edge across a corner: d · (B × C) across the first, and so on.
    fn volume<N: Sure>(&self, across: usize) -> N {
        let (from, to) = ((across + 1) % 3, (across + 2) % 3);
        N::dot(&self.d.map(N::of), &N::cross(&self.seen(from), &self.seen(to)))
    }

    /// (p̄1 − ā) · n and d · n
    fn lambda_of<N: Sure>(&self) -> [N; 2] {
        let n = area::normal::<N>(self.corners);
        [N::dot(&self.seen(0), &n), N::dot(&self.d.map(N::of), &n)]
    }
}

/// Works it out with as many digits as it takes.
#[cold]
#[inline(never)]
pub(super) fn robust<R: Real>(ray: Ray3<R>, triangle: Triangle<R>) -> Robust<R> {
    let nothing = Robust {
        ray,
        triangle,
        volumes: [f64::NAN; 3],
        d_dot_n: f64::NAN,
        lambda: None,
        certainty: Certainty::AtOnce,
        passage: Passage::Degenerate,
        fine_lambda: f64::NAN,
        n: None,
    };
    if triangle.check(&ray).is_err() {
        return nothing;
    }
    let question = Question::new(&ray, &triangle);
    let Verdict { volumes, passage, certainty } = verdict(&question);
    let [u, v, w] = volumes;
    let past = Robust { volumes, d_dot_n: u + v + w, certainty, passage, ..nothing };
    if passage != Passage::Through {
        return past;
    }
    let [above, rise] = question.lambda_of::<Bounded<TwoPart>>();
    let (fine_lambda, certainty) = match Sure::quotient::<f64>(&above, &rise) {
        Some(lambda) => (lambda + 0.0, certainty), // minus zero is zero
        None => {
            let [above, rise] = question.lambda_of::<Exact>();
            (Sure::quotient(&above, &rise).unwrap_or(f64::NAN), Certainty::Exact) // rise is not zero
        }
    };
    let d_dot_n = rise.about();
    Robust { lambda: Some(R::root_from(fine_lambda)), fine_lambda, d_dot_n, certainty, ..past }
}

/// On which sides the line passes the edges.
struct Verdict {
    volumes: [f64; 3],
    passage: Passage,
    certainty: Certainty,
}

fn verdict(question: &Question) -> Verdict {
    let volumes: [Bounded<TwoPart>; 3] = std::array::from_fn(|across| question.volume(across));
    let signs = volumes.map(|volume| volume.sign());
    let mut about = volumes.map(|volume| volume.about());
    if let Some(passage) = passage(signs) {
        return Verdict { volumes: about, passage, certainty: Certainty::TwoPart };
    }
    let signs = std::array::from_fn(|across| {
        signs[across].or_else(|| {
            let exact: Exact = question.volume(across);
            about[across] = exact.about();
            exact.sign()
        })
    });
    let passage = passage(signs).unwrap_or(Passage::Along); // no exact sign is in doubt
    Verdict { volumes: about, passage, certainty: Certainty::Exact }
}

/// By the signs of the three volumes; `None` where those that are in doubt could matter.
fn passage(signs: [Option<Ordering>; 3]) -> Option<Passage> {
    let has = |sign: Ordering| signs.contains(&Some(sign));
    let (negative, positive) = (has(Ordering::Less), has(Ordering::Greater));
    match () {
        _ if negative && positive => Some(Passage::Past),
        _ if signs.contains(&None) => None,
        _ if negative || positive => Some(Passage::Through),
        _ => Some(Passage::Along),
    }
}

/// α and β, the second and third volume over d · n.
pub(super) fn alpha_beta<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<(R, R)> {
    triangle.check(ray).ok()?;
    let question = Question::new(ray, triangle);
    shares::<Bounded<f64>, R>(&question)
        .or_else(|| shares::<Bounded<TwoPart>, R>(&question))
        .or_else(|| shares::<Exact, R>(&question))
}

fn shares<N: Sure, R: Real>(question: &Question) -> Option<(R, R)> {
    let [_, d_dot_n] = question.lambda_of::<N>();
    Some((N::quotient(&question.volume(1), &d_dot_n)?, N::quotient(&question.volume(2), &d_dot_n)?))
}

/// x = ā + λ d in numbers that cannot overflow, rounded at the end. The line of the ray must cross the plane.
#[cold]
#[inline(never)]
pub(super) fn point<R: Real>(ray: Ray3<R>, triangle: Triangle<R>) -> R::Vec3 {
    let question = Question::new(&ray, &triangle);
    let [above, rise] = question.lambda_of::<Exact>().map(|number| number.to_wide());
    let lambda = above / rise;
    let [x, y, z] = std::array::from_fn(|axis| {
        R::round_from((Wide::from(question.o[axis]) + lambda * Wide::from(question.d[axis])).to_f64())
    });
    R::vec3(x, y, z)
}

/// n / ‖n‖ of a sliver, or of any size. The triangle must have an area.
#[cold]
#[inline(never)]
pub(super) fn unit_normal<R: Real>(triangle: Triangle<R>) -> R::Vec3 {
    let corners = triangle.corners().map(Vector::in_f64);
    let n: [Wide; 3] = normal_in_two_parts(corners)
        .unwrap_or_else(|| area::normal::<Exact>(corners).map(|component| component.to_wide()));
    let length = n.into_iter().fold(Wide::ZERO, |sum, component| sum + component * component).sqrt();
    let [x, y, z] = n.map(|component| R::round_from((component / length).to_f64()));
    R::vec3(x, y, z)
}

/// n with twice the digits; `None` where too many of them cancel, or overflow.
fn normal_in_two_parts(corners: [[f64; 3]; 3]) -> Option<[Wide; 3]> {
    /// The error that a component may have, as a share of the largest.
    const OF_NORMAL: f64 = 1.0 / (1u64 << 60) as f64;
    let n = area::normal::<Bounded<TwoPart>>(corners);
    let largest = n.iter().fold(0.0, |most: f64, component| most.max(component.value.hi.abs()));
    let is_good = n.iter().all(|component| component.error <= OF_NORMAL * largest) && largest < f64::INFINITY;
    is_good.then(|| n.map(|component| Wide::from(component.value)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area::tests::{SLIVER_RISE, sliver};
    use glam::DVec3;

    /// By hand: legs of 2^k along x and y have n = (0, 0, 4^k). Of the sliver 2^−90 is left of products of 1, which
    /// are off by some 2^−101, and that is more than a 2^60th; of legs of 2^600 the product overflows.
    #[test]
    fn two_parts_are_enough_for_most_normals() {
        let legs = |power: i32| [[0.0; 3], [2.0_f64.powi(power), 0.0, 0.0], [0.0, 2.0_f64.powi(power), 0.0]];
        for power in [0, 100, -100] {
            let n = normal_in_two_parts(legs(power)).unwrap().map(Wide::to_f64);
            assert_eq!(n, [0.0, 0.0, 4.0_f64.powi(power)], "2^{power}");
        }
        assert!(normal_in_two_parts(sliver()).is_none());
        assert!(normal_in_two_parts(legs(600)).is_none());
    }

    /// By hand: see [`sliver`]. n_z (y2 − b) = SLIVER_RISE n_x. Five numbers are rounded by 2^−53 at most, the two
    /// components, y2 − b and both products, and none counts twice or more in what is left.
    #[test]
    fn the_normal_of_a_sliver_is_right_to_the_last_digit() {
        let [p1, p2, p3] = sliver().map(DVec3::from);
        let n = unit_normal::<f64>(Triangle { p1, p2, p3 });
        let off = n.z * (p2.y - p1.y) - n.x * SLIVER_RISE;
        assert!(off.abs() <= 5.0 * f64::EPSILON && n.x > 0.25, "{n} {off:e}");
    }
}

//! Where a ray passes the plane of a polygon, against one side: exactly.
//!
//! The rounded point r̄(λ*) may lie on the other side of a side than the true one, and a ray aimed at an edge that two
//! polygons share slips through between them. So the point is not worked out at all: with D = d · n and
//! N = (p̄1 − ā) · n it is ā + (N/D) d, and each question about it, multiplied by D, is the sign of a sum of products
//! of the numbers as given. [`math::Sure`] tells that sign exactly.

use std::cmp::Ordering;

use math::{Bounded, Exact, Ray3, Real, Sure, TwoPart, Vector};

use super::Polygon;
use super::crossing::{Relation, Way};

/// A ray, a plane, and the two axes on which its points are looked at.
pub(super) struct Passage {
    /// ā
    a: [f64; 3],
    d: [f64; 3],
    /// p̄1
    p_1: [f64; 3],
    n: [f64; 3],
    axes: [usize; 2],
    /// D and N in plain `f64`, which is enough for most questions.
    at_once: [Bounded<f64>; 2],
    /// The sign of D.
    rises: Ordering,
}

/// What is asked of the point x̄ = ā + (N/D) d.
#[derive(Clone, Copy)]
enum Question {
    /// The sign of D itself.
    Rise,
    /// The sign of x_i − c, times D, on one of the two axes.
    Beyond(usize, f64),
    /// The sign of (q̄ − p̄) × (x̄ − p̄), times D: is x̄ to the left of the side?
    LeftOf([f64; 2], [f64; 2]),
}

impl Passage {
    /// The ray must be finite and not parallel to the plane.
    pub(super) fn of<R: Real>(polygon: &Polygon<R>, ray: &Ray3<R>) -> Passage {
        let [a, d, p_1, n] =
            [ray.origin, ray.direction, polygon.plane.point, polygon.plane.normal].map(Vector::in_f64::<3>);
        let nothing = [0.0; 2].map(Bounded::<f64>::of);
        let mut passage =
            Passage { a, d, p_1, n, axes: polygon.axes, at_once: nothing, rises: Ordering::Equal };
        passage.at_once = passage.rise_and_way();
        passage.rises = passage.sign(Question::Rise);
        passage
    }

    /// D = d · n and N = (p̄1 − ā) · n.
    fn rise_and_way<N: Sure>(&self) -> [N; 2] {
        let n = self.n.map(N::of);
        let way: [N; 3] = std::array::from_fn(|axis| N::difference(self.p_1[axis], self.a[axis]));
        [N::dot(&self.d.map(N::of), &n), N::dot(&way, &n)]
    }

    /// What a question asks the sign of.
    fn value<N: Sure>(&self, question: Question, [rise, way]: [N; 2]) -> N {
        // D (x_i − c) = D (a_i − c) + N d_i
        let beyond = |axis: usize, c: f64| {
            let axis = self.axes[axis];
            rise.clone() * N::difference(self.a[axis], c) + way.clone() * N::of(self.d[axis])
        };
        match question {
            Question::Rise => rise,
            Question::Beyond(axis, c) => beyond(axis, c),
            Question::LeftOf(p, q) => {
                let [side_u, side_v] = [0, 1].map(|axis| N::difference(q[axis], p[axis]));
                side_u * beyond(1, p[1]) - side_v * beyond(0, p[0])
            }
        }
    }

    /// The sign that a question asks for, exactly.
    fn sign(&self, question: Question) -> Ordering {
        let at_once = self.value(question, self.at_once).sign();
        let sign = at_once.or_else(|| self.value::<Bounded<TwoPart>>(question, self.rise_and_way()).sign());
        sign.or_else(|| self.value::<Exact>(question, self.rise_and_way()).sign()).unwrap_or(Ordering::Equal)
    }

    /// The sign that a question asks for, less the sign of D in it.
    fn true_sign(&self, question: Question) -> Ordering {
        let sign = self.sign(question);
        if self.rises == Ordering::Less { sign.reverse() } else { sign }
    }

    /// Where x̄ is with respect to a side, as [`relation`](super::crossing::relation) says it for a point.
    pub(super) fn relation(&self, p: [f64; 2], q: [f64; 2]) -> Relation {
        let [over_p, over_q] = [p, q].map(|end| self.true_sign(Question::Beyond(1, end[1])));
        if over_p == over_q && over_p != Ordering::Equal {
            return Relation::Apart;
        }
        // a side along s(t) has a line to the left of nothing: x̄ is on it if it is between its ends
        if p[1] == q[1] {
            let [right_of_p, right_of_q] = [p, q].map(|end| self.true_sign(Question::Beyond(0, end[0])));
            let is_between = right_of_p != right_of_q || right_of_p == Ordering::Equal;
            return if is_between { Relation::OnSide } else { Relation::Apart };
        }
        // p_v ≤ x_v < q_v: the lower end belongs to the side, the upper one does not
        let goes_up = over_p != Ordering::Less && over_q == Ordering::Less;
        let goes_down = over_q != Ordering::Less && over_p == Ordering::Less;
        match self.true_sign(Question::LeftOf(p, q)) {
            Ordering::Equal => Relation::OnSide,
            Ordering::Greater if goes_up => Relation::Crosses(Way::Up),
            Ordering::Less if goes_down => Relation::Crosses(Way::Down),
            _ => Relation::Apart,
        }
    }
}

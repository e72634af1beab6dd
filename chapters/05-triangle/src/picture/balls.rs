//! A closed ball, shot from inside along its edges by every method.

use lab::Vec3;
use math::Real;
use stage::{Anchor, Canvas, Color};

use super::Part;
use crate::Method;
use crate::leaks::draw::{shot_ball, view};
use crate::leaks::target::{Shot, Target};
use crate::mesh::ball::bumpy_ball;

/// Fewer and larger faces than those of `trade`: 8 · 4² = 128.
const DIVISIONS: u32 = 2;
/// Where the rays start: inside, and nowhere in particular.
const START: [f64; 3] = [0.11, -0.07, 0.05];
/// Where along each edge they are aimed at; its vertex is 0.
const SHARES: [f64; 5] = [0.0, 0.2, 0.4, 0.6, 0.8];

/// A panel a method: the same rays.
pub(super) fn draw<R: Real>(canvas: &mut Canvas, parts: &[Part; 3]) {
    let target = Target::new(bumpy_ball::<R>(DIVISIONS, [0.0; 3]));
    let shots = shots(&target);
    for (part, method) in parts.iter().zip(Method::ALL) {
        let (from, to) = (part.from, (part.to.0, part.to.1 - 30.0));
        let outcome = |shot: &Shot<R>| (shot.aimed_at([0.0; 3]), target.lets_through(method, shot));
        let fired: Vec<(Vec3, bool)> = shots.iter().map(outcome).collect();
        shot_ball(canvas, &target, &view(from, to), fired.iter().copied(), 1.0);
        let leaks = fired.iter().filter(|(_, leaked)| *leaked).count();
        let middle = (part.from.0 + part.to.0) / 2.0;
        let text = format!("{}: {leaks} of {} rays leak", method.name(), fired.len());
        canvas.label((middle, part.to.1 - 9.0), Anchor::Middle, 12.0, Color::BLACK, &text);
    }
}

/// At every edge of the front half.
fn shots<R: Real>(target: &Target<R>) -> Vec<Shot<R>> {
    let in_front = |[a, b]: &&[usize; 2]| target.vertex(*a).z + target.vertex(*b).z >= 0.0;
    let edges = target.edges().iter().filter(in_front);
    let at_edge = |&edge| SHARES.map(|share| target.shot_at_edge(Vec3::from(START), edge, share));
    edges.flat_map(at_edge).collect()
}

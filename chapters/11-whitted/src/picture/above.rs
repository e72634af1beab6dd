//! The rays of a pixel from above, along the camera's up axis: the eye is at the left and looks to the right.

use bounds::Parts;
use math::{Ray3, Real, Span, Vector};
use shading::Fate;
use stage::{Anchor, Canvas, Color, Pen, View};

use super::outlines::Outline;
use super::{LETTERS, color_of, least_first, plate};
use crate::show::{ROWS, Shot};
use crate::tree::Node;
use crate::{Kind, Scene};

/// A point on the plane of the view: how far ahead of the eye, and how far to its left.
pub(super) type Place = (f64, f64);

/// A view from above between two corners of a canvas.
pub(super) fn draw<R: Real>(canvas: &mut Canvas, shot: &Shot<'_, R>, from: (f32, f32), to: (f32, f32)) {
    plate(canvas, from, to);
    let seen = From::new(shot.scene, shot.parts, (from.0 + 4.0, from.1 + 4.0), (to.0 - 4.0, to.1 - 4.0));
    seen.objects(canvas, shot);
    let rays = least_first(shot.tree);
    let shown =
        || rays.iter().map(|&place| (place, &shot.tree.nodes[place])).filter(|(place, _)| *place < ROWS);
    shown().for_each(|(_, node)| seen.shadow_rays(canvas, shot, node));
    shown().for_each(|(_, node)| seen.ray(canvas, node));
    let mut taken = Vec::new();
    rays.iter().rev().filter(|&&place| place < ROWS).for_each(|&place| {
        seen.depth(canvas, &shot.tree.nodes[place], &mut taken);
    });
    seen.names(canvas, shot);
    if let Some(eye) = shot.tree.nodes.first() {
        canvas.disc(seen.view.at(seen.place(eye.sent.ray.origin)), 4.0, Color::BLACK);
    }
    legend(canvas, (from.0 + 10.0, from.1 + 18.0));
}

/// From where and how large.
pub(super) struct From {
    pub(super) view: View,
    /// The plate: its lower left and upper right corner, on the plane.
    pub(super) corners: [Place; 2],
    e: [f64; 3],
    u: [f64; 3],
    pub(super) v: [f64; 3],
    w: [f64; 3],
}

impl From {
    /// So that the eye and all that has an extent are within the plate.
    pub(super) fn new<R: Real>(
        scene: &Scene<R>,
        parts: &Parts<'_, R>,
        from: (f32, f32),
        to: (f32, f32),
    ) -> From {
        let camera = &scene.lit.geometry.camera;
        let [e, u, v, w] = [camera.e, camera.u, camera.v, camera.w].map(Vector::in_f64::<3>);
        let any = View::new((0.0, 0.0), (1.0, 1.0), from, to);
        let mut seen = From { view: any, corners: [(0.0, 0.0); 2], e, u, v, w };
        let (mut low, mut high) = ((0.0_f64, 0.0_f64), (0.0_f64, 0.0_f64));
        let mut hold = |(x, y): Place, r: f64| {
            (low, high) = ((low.0.min(x - r), low.1.min(y - r)), (high.0.max(x + r), high.1.max(y + r)));
        };
        for object in 0..scene.lit.geometry.objects.len() {
            match seen.outline(scene, parts, object) {
                Some(Outline::Circle(place, r)) => hold(place, r),
                Some(Outline::Around(places)) => places.into_iter().for_each(|place| hold(place, 0.0)),
                None => {}
            }
        }
        let room = 0.06 * (high.0 - low.0).max(high.1 - low.1).max(f64::MIN_POSITIVE);
        let (low, high) = ((low.0 - room, low.1 - room), (high.0 + room, high.1 + room));
        seen.view = View::new(low, high, from, to);
        let corner = |x: f32, y: f32| seen.view.plane((f64::from(x), f64::from(y)));
        seen.corners = [corner(from.0, to.1), corner(to.0, from.1)];
        seen
    }

    /// Where a point is on the plane of the view.
    pub(super) fn place<V: Vector<R>, R: Real>(&self, point: V) -> Place {
        self.place_of(point.in_f64())
    }

    /// The same, for a point in `f64`.
    pub(super) fn place_of(&self, p: [f64; 3]) -> Place {
        let along = |axis: [f64; 3]| (0..3).map(|i| (p[i] - self.e[i]) * axis[i]).sum::<f64>();
        (along(self.w), -along(self.u))
    }

    /// Where a ray starts and ends on the plate; `None` where it is nowhere on it.
    pub(super) fn stretch<R: Real>(&self, node: &Node<R>) -> Option<(Place, Place)> {
        let ray = &node.sent.ray;
        let start = self.place(ray.origin);
        let end = match &node.landed {
            Some(landed) => self.place(landed.point.as_ref()?.landing.point),
            None => {
                // as far as the plate is large, and farther
                let direction: [f64; 3] = ray.direction.unit().in_f64();
                let far = 2.0 * (self.corners[1].0 - self.corners[0].0);
                let origin: [f64; 3] = ray.origin.in_f64();
                self.place_of(std::array::from_fn(|axis| origin[axis] + far * direction[axis]))
            }
        };
        clipped(start, end, self.corners)
    }

    fn ray<R: Real>(&self, canvas: &mut Canvas, node: &Node<R>) {
        if let Some((start, end)) = self.stretch(node) {
            self.view.arrow(canvas, start, end, Pen::solid(color_of(node.sent.kind), width(node.weight)));
        }
    }

    /// The depth, beside the middle of the ray, where there is room for it.
    fn depth<R: Real>(&self, canvas: &mut Canvas, node: &Node<R>, taken: &mut Vec<(f32, f32)>) {
        let Some((start, end)) = self.stretch(node) else { return };
        let (a, b) = (self.view.at(start), self.view.at(end));
        let length = View::apart(a, b);
        if length < 2.0 * LETTERS {
            return;
        }
        let aside = 0.8 * LETTERS / length;
        let middle = ((a.0 + b.0) / 2.0 + (b.1 - a.1) * aside, (a.1 + b.1) / 2.0 - (b.0 - a.0) * aside);
        if taken.iter().any(|other| View::apart(middle, *other) < LETTERS) {
            return;
        }
        taken.push(middle);
        let (place, depth) = ((middle.0, middle.1 + LETTERS / 3.0), node.sent.depth.to_string());
        canvas.label(place, Anchor::Middle, LETTERS, color_of(node.sent.kind), &depth);
    }

    /// To the lights that are seen, and to what stands before the others.
    fn shadow_rays<R: Real>(&self, canvas: &mut Canvas, shot: &Shot<'_, R>, node: &Node<R>) {
        let Some(landed) = &node.landed else { return };
        let Some(point) = &landed.point else { return };
        for (light, fate) in &landed.lights {
            let from = point.landing.point;
            let to_light = shot.scene.lit.lights[*light].position - from;
            let share = match fate {
                Fate::Seen(_) => R::from(1.0),
                Fate::Shadowed(part) => {
                    let span = Span::new(R::SMALLEST, R::from(1.0));
                    shot.parts.hit(*part, &Ray3::new(from, to_light), span).unwrap_or(R::from(0.0))
                }
                Fate::Behind | Fate::Unanswered => continue,
            };
            let (start, end) = (self.place(from), self.place(from + to_light * share));
            if let Some((start, end)) = clipped(start, end, self.corners) {
                let pen = Pen { dash: 3.0, ..Pen::dashed(Color::GREEN, 1.0) };
                self.view.line(canvas, start, end, pen);
                if matches!(fate, Fate::Shadowed(_)) {
                    canvas.cross(self.view.at(end), 2.5, Pen::solid(Color::GREEN, 1.2));
                }
            }
        }
    }
}

/// What of a line is between two corners.
fn clipped((x, y): Place, (to_x, to_y): Place, [low, high]: [Place; 2]) -> Option<(Place, Place)> {
    let (dx, dy) = (to_x - x, to_y - y);
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (p, d, low, high) in [(x, dx, low.0, high.0), (y, dy, low.1, high.1)] {
        if d == 0.0 {
            if p < low || p > high {
                return None;
            }
            continue;
        }
        let (a, b) = ((low - p) / d, (high - p) / d);
        (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
    }
    (enters < leaves).then_some(((x + enters * dx, y + enters * dy), (x + leaves * dx, y + leaves * dy)))
}

/// The width of a ray with this weight.
fn width(weight: f64) -> f32 {
    (0.8 + 1.6 * weight.clamp(0.0, 1.0).sqrt()) as f32
}

/// The kinds of rays.
fn legend(canvas: &mut Canvas, (x, y): (f32, f32)) {
    canvas.label(
        (x, y),
        Anchor::Left,
        LETTERS,
        Color::BLACK,
        "the rays of the ringed pixel from above, with their depths",
    );
    let kinds =
        [Kind::Eye, Kind::Mirror, Kind::Refracted].map(|kind| (kind.name(), Pen::solid(color_of(kind), 2.0)));
    let shadow = ("shadow", Pen { dash: 3.0, ..Pen::dashed(Color::GREEN, 1.2) });
    for (line, (name, pen)) in (1_u8..).zip(kinds.into_iter().chain([shadow])) {
        let y = y + f32::from(line) * 16.0;
        canvas.line((x, y - 4.0), (x + 22.0, y - 4.0), pen);
        canvas.label((x + 28.0, y), Anchor::Left, LETTERS, Color::BLACK, name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_cut_off_at_the_border() {
        let corners = [(0.0, 0.0), (4.0, 2.0)];
        assert_eq!(clipped((1.0, 1.0), (9.0, 1.0), corners), Some(((1.0, 1.0), (4.0, 1.0))));
        assert_eq!(clipped((-1.0, -1.0), (3.0, 3.0), corners), Some(((0.0, 0.0), (2.0, 2.0))));
        assert_eq!(clipped((-1.0, 3.0), (5.0, 3.0), corners), None);
        assert_eq!(clipped((5.0, 0.0), (9.0, 1.0), corners), None);
    }
}

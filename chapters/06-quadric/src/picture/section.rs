//! A ray in its own upright plane, with every candidate and what became of it.

use math::{Ray3, Real, Span};
use stage::{Anchor, Canvas, Color, Pen, View};

use super::area::{Area, LIST};
use super::marks::{Mark, marks, short};
use super::panels::{HEIGHT, Layout, Panel, WIDTH};
use super::slice::Slice;
use super::{captions, hue};
use crate::{Method, Part, Shape, Working};

/// Draws the section of a solid along a ray, and below it the list of what the method looks at.
pub(crate) fn section<R: Real>(
    canvas: &mut Canvas,
    layout: &Layout,
    method: Method,
    ray: &Ray3<R>,
    shape: Shape,
) {
    let panel = Panel::Section(shape);
    let corner = layout.corner(panel);
    let slice = Slice::of(ray, shape);
    let mut drawing =
        Drawing { canvas, view: panel.view(corner), area: Area::of_section(corner), shape, slice };
    drawing.solid();
    drawing.continuations();
    drawing.ray(ray);
    let work = method.work(ray, shape);
    let marks = marks(&work);
    let green = if drawing.normal(&work) { " · green: n" } else { "" };
    drawing.candidates(&marks);

    let beside = slice.beside;
    let place =
        if beside == 0.0 { "through the axis".into() } else { format!("{beside:.2} beside the axis") };
    captions(canvas, corner, ["the upright plane of the ray", &format!("z ↑, {place}{green}")]);
    list(canvas, corner, &marks);
    if let Working::Robust(work) = &work {
        let lines = [work.verdict.meaning(), work.certainty.meaning()];
        for (line, text) in (marks.len()..).zip(lines) {
            let at = list_line(corner, line);
            canvas.label((at.0 + 26.0, at.1), Anchor::Left, 10.5, Color::GRAY, text);
        }
    }
}

/// The drawing of one section, clipped to its area.
struct Drawing<'a> {
    canvas: &'a mut Canvas,
    view: View,
    area: Area,
    shape: Shape,
    slice: Slice,
}

impl Drawing<'_> {
    /// A line between two points of the plane, as far as it is within the drawing.
    fn line(&mut self, from: (f64, f64), to: (f64, f64), pen: Pen) {
        if let Some((from, to)) = self.area.clip(self.view.at(from), self.view.at(to)) {
            self.canvas.line(from, to, pen);
        }
    }

    /// The wall and its mirror image between two heights, solid.
    fn wall(&mut self, heights: (f64, f64), pen: Pen) {
        let points = self.slice.wall(heights);
        // Each segment of a curve runs on to the end of the next, which leaves no gaps between them.
        for (i, &from) in points.iter().enumerate() {
            self.both_sides(from, points[(i + 2).min(points.len() - 1)], pen);
        }
    }

    /// The same, dashed: a curve leaves every other segment out.
    fn dashed_wall(&mut self, heights: (f64, f64)) {
        let points = self.slice.wall(heights);
        let pen = if points.len() > 2 { Pen::solid(Color::GRAY, 1.0) } else { Pen::dashed(Color::GRAY, 1.0) };
        for pair in points.windows(2).step_by(2) {
            self.both_sides(pair[0], pair[1], pen);
        }
    }

    fn both_sides(&mut self, from: (f64, f64), to: (f64, f64), pen: Pen) {
        for side in [1.0, -1.0] {
            self.line((side * from.0, from.1), (side * to.0, to.1), pen);
        }
    }

    /// What of the solid lies in the plane: filled, its wall and its caps in their hues.
    fn solid(&mut self) {
        let (low, _) = self.shape.heights::<f64>();
        let heights = (self.slice.highest(), low);
        let right = self.slice.wall(heights);
        let left = right.iter().rev().map(|&(u, z)| (-u, z));
        let outline: Vec<_> = right.iter().copied().chain(left).map(|point| self.view.at(point)).collect();
        self.canvas.area(&outline, Color([236, 240, 244]));
        self.wall(heights, Pen::solid(hue(Part::Wall), 2.2));
        for &part in self.shape.caps() {
            let z = f64::from(part.height().unwrap_or(0.0));
            if let Some(u) = self.slice.half_width(z) {
                self.line((-u, z), (u, z), Pen::solid(hue(part), 2.6));
            }
        }
    }

    /// The wall beyond the bounds on z, and the planes of the caps beyond the rim: dashed.
    fn continuations(&mut self) {
        // As far as the windows reach: up and down beyond the solid, and to either side.
        const UP: f64 = 1.2;
        const ASIDE: f64 = 4.0;
        let (low, high) = self.shape.heights::<f64>();
        let top = self.slice.highest();
        // A cone's other half begins above the apex, as far as this one ends below it.
        let above = high + (high - top);
        for heights in [(low.min(top), low - UP), (above, above + UP)] {
            self.dashed_wall(heights);
        }
        for &part in self.shape.caps() {
            let z = f64::from(part.height().unwrap_or(0.0));
            let u = self.slice.half_width(z).unwrap_or(0.0);
            self.both_sides((u, z), (ASIDE, z), Pen::dashed(Color::GRAY, 1.0));
        }
    }

    /// The ray, from its origin or from where it enters the drawing, to where it leaves it.
    fn ray<R: Real>(&mut self, ray: &Ray3<R>) {
        let (from, toward) = (self.slice.flat::<R>(ray.origin), self.slice.flat::<R>(ray.direction));
        let length = (toward.0 * toward.0 + toward.1 * toward.1).sqrt();
        // Ten units are farther than any window reaches from any eye.
        let s = 10.0 / length;
        let to = (from.0 + s * toward.0, from.1 + s * toward.1);
        if let Some((from, to)) = self.area.clip(self.view.at(from), self.view.at(to)) {
            self.canvas.arrow(from, to, Pen::solid(Color::BLACK, 1.6));
        }
    }

    /// Marks the candidates: numbered discs, the hit's filled and on top.
    fn candidates<R: Real>(&mut self, marks: &[Mark<R>]) {
        for hits in [false, true] {
            for (number, mark) in (1..).zip(marks).filter(|(_, mark)| mark.is_hit == hits) {
                let at = self.view.at(self.slice.flat::<R>(mark.point));
                if mark.lambda.is_some() && self.area.holds(at) {
                    disc(self.canvas, at, number, hits);
                }
            }
        }
    }

    /// The normal at the hit; false where none is to be seen: it ends out of the drawing, or below its disc.
    fn normal<R: Real>(&mut self, work: &Working<R>) -> bool {
        let Ok(Some(hit)) = work.hit(Span::ahead()) else { return false };
        const LENGTH: f64 = 0.4;
        let (at, n) = (self.slice.flat::<R>(hit.point), self.slice.flat::<R>(hit.normal));
        let tip = (at.0 + LENGTH * n.0, at.1 + LENGTH * n.1);
        let (from, to) = (self.view.at(at), self.view.at(tip));
        let (x, y) = (to.0 - from.0, to.1 - from.1);
        let is_seen = self.area.holds(from) && self.area.holds(to) && x * x + y * y > DISC * DISC;
        if is_seen {
            self.canvas.arrow(from, to, Pen::solid(Color::GREEN, 2.0));
        }
        is_seen
    }
}

/// The radius of a candidate's disc.
const DISC: f32 = 6.5;

/// A numbered disc: filled for the hit, hollow for what was dropped.
fn disc(canvas: &mut Canvas, (x, y): (f32, f32), number: usize, is_hit: bool) {
    let (fill, ink) = if is_hit { (Color::VERMILLION, Color::WHITE) } else { (Color::WHITE, Color::BLACK) };
    canvas.disc((x, y), DISC, fill);
    canvas.circle((x, y), DISC, Pen::solid(Color::BLACK, 1.2));
    canvas.label((x, y + 3.6), Anchor::Middle, 10.0, ink, &number.to_string());
}

/// Where a line of the list begins.
fn list_line((left, top): (f32, f32), line: usize) -> (f32, f32) {
    (left, top + HEIGHT - LIST + 14.0 + 15.0 * line as f32)
}

/// What became of each, one line a candidate.
fn list<R: Real>(canvas: &mut Canvas, corner: (f32, f32), marks: &[Mark<R>]) {
    for (i, mark) in marks.iter().enumerate() {
        let (left, y) = list_line(corner, i);
        let ink = if mark.is_hit { Color::BLACK } else { Color::GRAY };
        let mut text =
            |x: f32, anchor: Anchor, text: &str| canvas.label((left + x, y), anchor, 10.5, ink, text);
        text(26.0, Anchor::Left, mark.part.name());
        text(WIDTH - 10.0, Anchor::Right, mark.word);
        match mark.lambda {
            None => text(14.0, Anchor::Middle, "–"),
            Some(lambda) => {
                text(76.0, Anchor::Left, &format!("λ = {}", short(lambda.into())));
                disc(canvas, (left + 14.0, y - 3.5), i + 1, mark.is_hit);
            }
        }
    }
}

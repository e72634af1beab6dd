//! The squashed sphere twice in the same light, with the right normal and with the wrong one.

use math::{Ray3, Real, Span};
use stage::{Anchor, Canvas, Color, View};

use super::layout::Part;
use super::light;
use crate::scene::Placed;
use crate::{Deformed, Method};

/// One of the two, seen straight on: along −z, no nearer point larger.
pub(crate) struct Pair<'a, R: Real> {
    method: Method,
    sphere: &'a Deformed<R>,
    color: [u8; 3],
    part: Part,
    right: View,
    wrong: View,
}

impl<'a, R: Real> Pair<'a, R> {
    pub(crate) fn new(method: Method, squashed: &'a Placed<R>, part: Part) -> Pair<'a, R> {
        let half = |left: f32| {
            View::new((-1.16, -1.0), (1.16, 1.0), part.at(left, 34.0), part.at(left + 132.0, 150.0))
        };
        Pair {
            method,
            sphere: &squashed.deformed,
            color: squashed.color,
            part,
            right: half(6.0),
            wrong: half(142.0),
        }
    }

    /// The color of a place of the drawing that the part holds.
    pub(crate) fn color(&self, place: (f64, f64)) -> Color {
        let middle = f64::from(self.part.from.0 + self.part.to.0) / 2.0;
        let is_right = place.0 < middle;
        let (x, y) = if is_right { self.right.plane(place) } else { self.wrong.plane(place) };
        // a step in front of the sphere, in coordinates about its center
        let [x, y, z] = [x, y, 2.0].map(R::round_from);
        let (zero, one) = (R::from(0.0), R::from(1.0));
        let ray = Ray3::new(self.sphere.affine.t + R::vec3(x, y, z), R::vec3(zero, zero, -one));
        let Ok(Some(found)) = self.method.work(&ray, self.sphere).found(Span::ahead()) else {
            return Color::WHITE;
        };
        let normal = if is_right { found.normal() } else { found.wrong_normal(self.sphere) };
        light::<R>(self.color, normal)
    }

    pub(crate) fn words(&self, canvas: &mut Canvas) {
        let part = &self.part;
        canvas.label(part.at(10.0, 17.0), Anchor::Left, 12.0, Color::BLACK, "In the same light, shaded by");
        for (left, name, meaning, color) in
            [(72.0, "A⁻ᵀ n / ‖A⁻ᵀ n‖", "right", super::RIGHT), (208.0, "A n / ‖A n‖", "wrong", super::WRONG)]
        {
            canvas.label(part.at(left, 168.0), Anchor::Middle, 12.0, color, name);
            canvas.label(part.at(left, 184.0), Anchor::Middle, 11.0, Color::BLACK, meaning);
        }
    }
}

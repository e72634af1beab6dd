//! The triangle in its barycentric colors: how much of each corner there is in a point.

use math::{Ray3, Real, Span};
use stage::{Anchor, Canvas, Color, Pen, View};

use super::{TRIANGLE, view_in};
use crate::scene::seen_at;
use crate::{Method, Triangle};

/// The view plane, as far as the panel shows it.
pub(super) fn view() -> View {
    view_in(&TRIANGLE, (-0.8, -0.44), (0.8, 0.5), 30.0, 4.0)
}

/// α, β and γ = 1 − α − β as red, green and blue; `None` for a miss.
pub(super) fn color<R: Real>(method: Method, ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<Color> {
    let work = method.work(ray, triangle);
    work.hit(Span::ahead()).ok()??;
    let (alpha, beta) = work.alpha_beta()?;
    let gamma = R::from(1.0) - alpha - beta;
    Some(Color([alpha, beta, gamma].map(|share| (255.0 * share.into()).round() as u8)))
}

/// The corners, the lines along which α, β or γ is a quarter, a half, three quarters, and the method.
pub(super) fn name_corners<R: Real>(canvas: &mut Canvas, triangle: &Triangle<R>, method: &str) {
    let view = view();
    // the point with so much of p̄1, p̄2 and p̄3
    let at = |shares: [f32; 3]| {
        let weighted =
            triangle.corners().into_iter().zip(shares).map(|(corner, share)| corner * R::from(share));
        let point = weighted.reduce(|sum, corner| sum + corner).unwrap_or(triangle.p1);
        view.at(seen_at::<R>(point))
    };
    for share in [0.25, 0.5, 0.75] {
        for corner in 0..3 {
            let on_side = |other: usize| {
                let mut shares = [0.0; 3];
                (shares[corner], shares[other]) = (share, 1.0 - share);
                at(shares)
            };
            canvas.line(on_side((corner + 1) % 3), on_side((corner + 2) % 3), Pen::solid(Color::WHITE, 0.7));
        }
    }
    let (low, high) = ((0.0, 20.0), (0.0, -9.0));
    for (shares, (dx, dy), text) in [
        ([1.0, 0.0, 0.0], low, "p₁: γ = 1, blue"),
        ([0.0, 1.0, 0.0], low, "p₂: α = 1, red"),
        ([0.0, 0.0, 1.0], high, "p₃: β = 1, green"),
    ] {
        let (x, y) = at(shares);
        let anchor = if shares[2] == 1.0 {
            Anchor::Middle
        } else if shares[0] == 1.0 {
            Anchor::Left
        } else {
            Anchor::Right
        };
        canvas.label((x + dx, y + dy), anchor, 13.0, Color::BLACK, text);
    }
    let (left, top) = TRIANGLE.from;
    let title = "α, β and γ = 1 − α − β";
    canvas.label((left + 10.0, top + 20.0), Anchor::Left, 13.0, Color::BLACK, title);
    canvas.label((TRIANGLE.to.0 - 10.0, top + 20.0), Anchor::Right, 13.0, Color::BLACK, method);
}

/// A ring around the pixel of the transcript, with its name on the side where there is room.
pub(super) fn ring(canvas: &mut Canvas, (x, y): (f32, f32)) {
    canvas.circle((x, y), 6.0, Pen::solid(Color::WHITE, 4.0));
    canvas.circle((x, y), 6.0, Pen::solid(Color::BLACK, 1.6));
    if !TRIANGLE.holds((f64::from(x), f64::from(y))) {
        return;
    }
    let middle = (TRIANGLE.from.0 + TRIANGLE.to.0) / 2.0;
    let (dx, anchor) = if x < middle { (12.0, Anchor::Left) } else { (-12.0, Anchor::Right) };
    let label_y = (y + 4.0).clamp(TRIANGLE.from.1 + 36.0, TRIANGLE.to.1 - 26.0);
    canvas.plate((x + dx, label_y), anchor, 12.0, Color::BLACK, "the ray of the transcript");
}

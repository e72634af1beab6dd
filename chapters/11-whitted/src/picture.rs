//! The picture.

use math::Real;
use stage::{Canvas, Color, Error};

use crate::render::Rendered;
use crate::show::Shot;

/// The rendering.
pub(crate) fn draw<R: Real>(rendered: &Rendered, shot: &Shot<'_, R>, _own: bool) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(rendered.size, Color::BLACK)?;
    let (width, radiance, srgb) = (rendered.size.0 as usize, &rendered.radiance, shot.srgb);
    canvas.shade(|col, row| {
        let e = radiance[row as usize * width + col as usize].0;
        if srgb { Color::from_linear_srgb(e) } else { Color::from_linear(e) }
    });
    Ok(canvas)
}

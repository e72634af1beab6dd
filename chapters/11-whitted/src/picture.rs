//! The picture: the scene; and over the floor of the chapter's own, the rays of a pixel from above and the
//! critical angle.

mod above;
mod angles;
mod outlines;
mod plan;

use math::Real;
use stage::{Canvas, Color, Error, Pen, Transcript};

use crate::render::Rendered;
use crate::show::Shot;
use crate::{Kind, Tree};

pub(crate) use plan::{Above, Plan};

/// The frame in which the chapter's own picture is drawn.
const FRAME: (f32, f32) = (960.0, 720.0);
/// The smallest letters in it.
const LETTERS: f32 = 12.0;
/// The views are drawn where letters of this size are readable, at 5 pixels: then [`LETTERS`] have 7, which
/// digits beside lines take.
const READABLE: f32 = LETTERS * 5.0 / 7.0;

/// The rendering, and whether there is more; of the chapter's own scene with what stands below it, where
/// there is room to read that.
pub(crate) fn draw<R: Real>(
    rendered: &Rendered,
    shot: &Shot<'_, R>,
    own: bool,
) -> Result<(Canvas, bool), Error> {
    let mut canvas = Canvas::new(rendered.size, Color::BLACK)?;
    let (width, radiance, srgb) = (rendered.size.0 as usize, &rendered.radiance, shot.srgb);
    canvas.shade(|col, row| {
        let e = radiance[row as usize * width + col as usize].0;
        if srgb { Color::from_linear_srgb(e) } else { Color::from_linear(e) }
    });
    canvas.fit(FRAME.0, FRAME.1);
    let has_room = own && canvas.is_readable(READABLE);
    if has_room {
        let (x, y) = canvas.place_of(shot.pixel);
        canvas.circle((x as f32, y as f32), 7.0, Pen::solid(Color::BLACK, 4.0));
        canvas.circle((x as f32, y as f32), 7.0, Pen::solid(Color::WHITE, 1.5));
        above::draw(&mut canvas, shot, (12.0, 456.0), (650.0, 708.0));
        angles::draw(&mut canvas, (662.0, 456.0), (948.0, 708.0));
    }
    Ok((canvas, has_room))
}

/// Says that the picture was too small, or too flat, for what stands below the scene.
pub(crate) fn say_that_it_is_left_out(transcript: &mut Transcript) {
    if let Some(section) = transcript.sections.iter_mut().rfind(|section| section.in_text) {
        section.remark(
            "The views of the rays are left out of the picture: at this size \
             nobody could read them; 960x720 has room.",
        );
    }
}

/// The color of a kind of ray.
fn color_of(kind: Kind) -> Color {
    match kind {
        Kind::Eye => Color::BLACK,
        Kind::Mirror => Color::BLUE,
        Kind::Refracted => Color::VERMILLION,
    }
}

/// A light plate with a frame, to draw on.
fn plate(canvas: &mut Canvas, from: (f32, f32), to: (f32, f32)) {
    canvas.rectangle(from, to, Color::WHITE, 0.98);
    canvas.frame(from, to, Pen::solid(Color::GRAY, 1.0));
}

/// The places of a tree's rays, the least weight first.
fn least_first<R: Real>(tree: &Tree<R>) -> Vec<usize> {
    let mut places: Vec<usize> = (0..tree.nodes.len()).collect();
    places.sort_by(|&a, &b| tree.nodes[a].weight.total_cmp(&tree.nodes[b].weight).then(b.cmp(&a)));
    places
}

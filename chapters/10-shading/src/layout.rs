//! Where in the picture what is drawn, and what a pixel of it shows.

use crate::Start;
use crate::own::SCALES;

/// The size for which it is laid out.
pub(crate) const SIZE: (u32, u32) = (960, 866);

/// What a part of the picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// One of the terms of the scene.
    Term(Term),
    /// The small scene, by its row and its column in the table.
    Cell(usize, usize),
}

/// What of the shading is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Term {
    /// E
    All,
    /// r_a I_a C
    Ambient,
    /// Σ V r_d I C max(0, n⃗·s⃗)
    Diffuse,
    /// Σ V r_s I max(0, c⃗·m⃗)^α
    Specular,
    /// V of the lights.
    Shadows,
}

impl Term {
    /// As it is written on the picture.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Term::All => "E: all of it",
            Term::Ambient => "ambient: r_a I_a C",
            Term::Diffuse => "diffuse: V r_d I C (n·s)",
            Term::Specular => "specular: V r_s I (c·m)^α",
            Term::Shadows => "shadows: V I",
        }
    }
}

/// A rectangle of pixels that shows something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) what: What,
    /// Its top left pixel.
    pub(crate) at: (u32, u32),
    /// Its columns and rows.
    pub(crate) size: (u32, u32),
}

impl Part {
    /// Whether a pixel of the picture is in it, and then which of its own.
    pub(crate) fn own(&self, (col, row): (u32, u32)) -> Option<(u32, u32)> {
        let (col, row) = (col.checked_sub(self.at.0)?, row.checked_sub(self.at.1)?);
        (col < self.size.0 && row < self.size.1).then_some((col, row))
    }

    /// Its own pixel that is nearest to one of the picture, and how far that is, squared.
    fn nearest(&self, pixel: (u32, u32)) -> ((u32, u32), u64) {
        let along = |place: u32, start: u32, length: u32| {
            let own = place.clamp(start, start + length - 1);
            (own - start, u64::from(place.abs_diff(own)).pow(2))
        };
        let (col, across) = along(pixel.0, self.at.0, self.size.0);
        let (row, down) = along(pixel.1, self.at.1, self.size.1);
        ((col, row), across + down)
    }
}

/// The parts of a picture of `size`: where there is no room for more than one, it is the scene.
pub(crate) fn parts((width, height): (u32, u32)) -> Vec<Part> {
    let scale = (f64::from(width) / f64::from(SIZE.0)).min(f64::from(height) / f64::from(SIZE.1));
    if scale < 0.5 {
        return vec![Part { what: What::Term(Term::All), at: (0, 0), size: (width, height) }];
    }
    let (left, top) = (
        (f64::from(width) - scale * f64::from(SIZE.0)) / 2.0,
        (f64::from(height) - scale * f64::from(SIZE.1)) / 2.0,
    );
    let part = |what, (x, y): (f64, f64), (w, h): (f64, f64)| {
        let start = |from: f64, at: f64| (from + scale * at).round() as u32;
        let (at, end) = ((start(left, x), start(top, y)), (start(left, x + w), start(top, y + h)));
        Part { what, at, size: (end.0 - at.0, end.1 - at.1) }
    };
    let mut parts = vec![part(What::Term(Term::All), (8.0, 8.0), (468.0, 351.0))];
    let terms = [Term::Ambient, Term::Diffuse, Term::Specular, Term::Shadows];
    for (place, term) in terms.into_iter().enumerate() {
        let (column, row) = ((place % 2) as f64, (place / 2) as f64);
        parts.push(part(What::Term(term), (484.0 + 238.0 * column, 8.0 + 179.5 * row), (230.0, 171.5)));
    }
    for row in 0..SCALES.len() {
        for column in 0..Start::ALL.len() {
            let at = (CELLS.0 + CELL.0 * column as f64, CELLS.1 + CELL.1 * row as f64);
            parts.push(part(What::Cell(row, column), at, (CELL.0 - 6.0, CELL.1 - 6.0)));
        }
    }
    parts
}

/// The top left corner of the table, in units of [`SIZE`].
pub(crate) const CELLS: (f64, f64) = (72.0, 416.0);
/// From one cell to the next.
pub(crate) const CELL: (f64, f64) = (177.2, 90.0);
/// The methods in the order of the columns: from the simplest to the surest.
pub(crate) const COLUMNS: [Start; 5] =
    [Start::None, Start::Fixed, Start::Scaled, Start::Exclude, Start::Bound];

/// The part that a pixel shows, or the one nearest to it, and which of its own pixels.
pub(crate) fn shown(parts: &[Part], pixel: (u32, u32)) -> Option<(Part, (u32, u32))> {
    let nearest = parts.iter().min_by_key(|part| part.nearest(pixel).1)?;
    Some((*nearest, nearest.nearest(pixel).0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_do_not_overlap_and_lie_in_the_picture() {
        for size in [SIZE, (480, 433), (1920, 1732), (700, 2000), (37, 91), (1, 1)] {
            let parts = parts(size);
            for part in &parts {
                assert!(part.size.0 > 0 && part.size.1 > 0);
                assert!(part.at.0 + part.size.0 <= size.0 && part.at.1 + part.size.1 <= size.1, "{part:?}");
                let corners = [(0, 0), (part.size.0 - 1, part.size.1 - 1)];
                for own in corners {
                    let pixel = (part.at.0 + own.0, part.at.1 + own.1);
                    assert_eq!(shown(&parts, pixel), Some((*part, own)));
                    assert_eq!(parts.iter().filter(|other| other.own(pixel).is_some()).count(), 1);
                }
            }
            assert!(parts.len() == 1 || parts.len() == 30);
            assert!(shown(&parts, (size.0 - 1, size.1 - 1)).is_some(), "a pixel between the parts, too");
        }
    }
}

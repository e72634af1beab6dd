//! The inspector: a page on which every pixel's ray can be looked at, step by step.
//!
//! All that the page shows is computed here: it holds the steps and the drawing of each pixel, packed, and
//! its script unpacks those of the pixel under the pointer.

mod packed;
mod page;

use crate::{Ask, Color, Error, Section};

pub use packed::Packed;
pub(crate) use page::write_page;

/// The most pixels of a page when no size is asked for: each takes some hundred bytes of it.
pub(crate) const MOST_INSPECTED: u64 = 1 << 15;

/// A picture whose rays can be looked at one by one.
pub trait Inspect {
    /// The picture's columns and rows.
    fn size(&self) -> (u32, u32);

    /// The pixel that the page begins with: column and row.
    fn first(&self) -> (u32, u32);

    /// What lies below every drawing: the elements of a [`Sketch`](crate::Sketch), or nothing.
    fn ground(&self) -> String {
        String::new()
    }

    /// What the drawings show, in one or two sentences.
    fn caption(&self) -> &'static str;

    /// The ray of a pixel of the picture.
    ///
    /// [`Error::Failed`] where what it takes cannot be had, such as a thread.
    fn look(&self, pixel: (u32, u32)) -> Result<Look, Error>;
}

/// One pixel, and what its ray met.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// The pixel's color.
    pub color: Color,
    /// The steps of its ray: those that `show --pixel` prints of it.
    pub sections: Vec<Section>,
    /// What happened, seen in a plane: the elements of a [`Sketch`](crate::Sketch).
    pub drawing: String,
}

/// What a stage writes an [`Inspect`] with, see [`Chapter::inspect`](crate::Chapter::inspect).
pub type Inspector<'a> = &'a mut dyn FnMut(&dyn Inspect) -> Result<(), Error>;

/// Columns and rows.
type Size = (u32, u32);
/// Column and row.
type Pixel = (u32, u32);

impl Ask {
    /// The size of the picture to inspect and the pixel to begin with: as asked; else those of the same view
    /// with a k-th of the columns and rows of `own`, with the smallest k that leaves at most 32768 pixels.
    /// Its pixels are k times as wide: the ray of one is near those of the k × k that it stands for, and need
    /// be none of theirs. `worked` is the pixel that is explained when none is asked for, by the picture's
    /// size.
    ///
    /// [`Error::Request`] where the pixel that is asked for lies outside the picture.
    pub fn to_inspect(&self, own: Size, worked: impl Fn(Size) -> Pixel) -> Result<(Size, Pixel), Error> {
        let shown = self.size_or(own)?;
        let step = if self.size.is_some() { 1 } else { step(own) };
        let (col, row) = self.pixel.unwrap_or_else(|| worked(shown));
        Ok(((shown.0.div_ceil(step), shown.1.div_ceil(step)), (col / step, row / step)))
    }
}

/// The smallest k of which every k-th column and row are few enough.
fn step((width, height): (u32, u32)) -> u32 {
    let few = |&k: &u32| u64::from(width.div_ceil(k)) * u64::from(height.div_ceil(k)) <= MOST_INSPECTED;
    (1..=width.max(height)).find(few).unwrap_or(1)
}

#[cfg(test)]
mod tests;

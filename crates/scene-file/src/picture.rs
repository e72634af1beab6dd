//! Pictures for textures.

use std::io::Cursor;
use std::sync::Arc;

use image::codecs::png::PngDecoder;
use image::{ColorType, DynamicImage, ImageDecoder, Limits};

use crate::limits::PICTURE_MEMORY;

/// A picture in memory.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    /// Columns and rows.
    pub(crate) size: (u32, u32),
    /// Red, green and blue, row by row from the top.
    pub(crate) pixels: Arc<[[u8; 3]]>,
}

impl Picture {
    /// The pixels of a PNG of at most `limit` pixels and 8 bits a channel, without alpha.
    ///
    /// Where the bytes are none: what is wrong, and what would help.
    pub(crate) fn decode(bytes: &[u8], limit: u64) -> Result<Picture, (String, String)> {
        let broken =
            |_| ("it is no PNG picture, or a broken one".to_string(), "save it as a PNG".to_string());
        let mut limits = Limits::no_limits();
        limits.max_alloc = Some(PICTURE_MEMORY);
        let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits).map_err(broken)?;
        let (width, height) = decoder.dimensions();
        if u64::from(width) * u64::from(height) > limit {
            let problem =
                format!("{width} × {height} pixels are too many: a scene's pictures have 2^26 in all");
            return Err((problem, "save it smaller".to_string()));
        }
        if !matches!(
            decoder.color_type(),
            ColorType::L8 | ColorType::La8 | ColorType::Rgb8 | ColorType::Rgba8
        ) {
            let problem = "it has 16 bits a channel".to_string();
            return Err((problem, "save it with 8 bits a channel".to_string()));
        }
        let image = DynamicImage::from_decoder(decoder).map_err(broken)?.into_rgb8();
        Ok(Picture { size: (width, height), pixels: image.pixels().map(|pixel| pixel.0).collect() })
    }
}

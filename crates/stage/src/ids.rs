//! A picture whose pixels are numbers: the ids of the objects that are seen.

use std::io;
use std::path::Path;

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};

use crate::{Error, write_whole};

/// The id of the object that each pixel sees, row by row from the top; 0 where none is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ids {
    /// Columns and rows.
    pub size: (u32, u32),
    /// One a pixel.
    pub ids: Vec<u16>,
    /// How many pixels see an object that has no id, and so have no number.
    pub nameless: u64,
}

impl Ids {
    /// What the pixels see, row by row from the top, one for each: nothing, or an object, which may have an
    /// id.
    pub fn new(size: (u32, u32), seen: impl Iterator<Item = Option<Option<u16>>>) -> Ids {
        let mut nameless = 0;
        let ids = seen.map(|object| {
            nameless += u64::from(object == Some(None));
            object.flatten().unwrap_or(0)
        });
        let ids = ids.collect();
        Ids { size, ids, nameless }
    }

    /// Writes a PNG of 16-bit grays, each pixel the id. Panics where there are not as many ids as pixels.
    ///
    /// [`Error::Failed`] where the file cannot be written; then it is what it was before.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let (width, height) = self.size;
        // image takes the bytes of a sample in the machine's order
        let bytes: Vec<u8> = self.ids.iter().flat_map(|id| id.to_ne_bytes()).collect();
        write_whole(path, |file| {
            PngEncoder::new(file).write_image(&bytes, width, height, ExtendedColorType::L16).map_err(
                |error| match error {
                    ImageError::IoError(error) => error,
                    other => io::Error::other(other),
                },
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_its_id() {
        let folder = std::env::temp_dir().join(format!("stage-ids-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("ids.png");
        let seen = [0, 1, 258, 65535, 7, 0].map(|id| (id > 0).then_some(Some(id)));
        Ids::new((3, 2), seen.into_iter()).write(&path).unwrap();
        let read = image::open(&path).unwrap();
        assert_eq!(read.color(), image::ColorType::L16);
        let read = read.into_luma16();
        assert_eq!((read.get_pixel(2, 0).0, read.get_pixel(0, 1).0), ([258], [65535]));
        assert_eq!(read.into_raw(), [0, 1, 258, 65535, 7, 0]);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn an_object_without_an_id_is_told_from_nothing() {
        assert_eq!(Ids::new((3, 1), [None, Some(None), Some(Some(2))].into_iter()).nameless, 1);
    }
}

//! The picture: each object in a color of its own.

use std::collections::BTreeMap;

use math::Real;
use stage::{Anchor, Canvas, Color, Error, Ids, Pen, each_pixel};

use crate::false_color::{NOTHING, color_of};
use crate::{Method, Scene};

/// sig[i, j]: for each pixel the place of the object that it sees, from 0, row by row from the top.
pub(crate) struct Seen {
    /// Columns and rows.
    pub(crate) size: (u32, u32),
    /// One a pixel; `None` where nothing is hit.
    pub(crate) objects: Vec<Option<u32>>,
}

impl Seen {
    /// The page's outer loops.
    ///
    /// [`Error::Failed`] where the memory for a picture cannot be had.
    pub(crate) fn of<R: Real>(scene: &Scene<R>, method: Method) -> Result<Seen, Error> {
        let objects =
            each_pixel(scene.size, |col, row| scene.seen(method, (col, row)).map(|object| object as u32))?;
        Ok(Seen { size: scene.size, objects })
    }

    /// How many pixels see each object, by its place; objects that none sees are left out.
    pub(crate) fn counts(&self) -> BTreeMap<usize, u64> {
        let mut counts = BTreeMap::new();
        for object in self.objects.iter().flatten() {
            *counts.entry(*object as usize).or_default() += 1;
        }
        counts
    }

    /// The ids of a scene's objects in their pixels.
    pub(crate) fn ids<R: Real>(&self, scene: &Scene<R>) -> Ids {
        let id = |object: &Option<u32>| object.map(|object| scene.objects[object as usize].id);
        Ids::new(self.size, self.objects.iter().map(id))
    }

    /// The false colors.
    pub(crate) fn canvas(&self) -> Result<Canvas, Error> {
        let mut canvas = Canvas::new(self.size, NOTHING)?;
        let (width, objects) = (self.size.0 as usize, &self.objects);
        canvas.shade(|col, row| {
            objects[row as usize * width + col as usize].map_or(NOTHING, |object| color_of(object as usize))
        });
        Ok(canvas)
    }
}

/// The false colors, an id on every object that is large enough for it, and a ring around the pixel that is
/// explained.
pub(crate) fn draw<R: Real>(seen: &Seen, scene: &Scene<R>, pixel: (u32, u32)) -> Result<Canvas, Error> {
    let mut canvas = seen.canvas()?;
    canvas.fit(seen.size.0 as f32, seen.size.1 as f32);
    for (object, place) in label_places(seen) {
        if let Some(id) = scene.objects[object].id {
            let size = (0.03 * seen.size.1 as f32).clamp(9.0, 18.0);
            canvas.plate(
                (place.0, place.1 + size / 3.0),
                Anchor::Middle,
                size,
                Color::BLACK,
                &id.to_string(),
            );
        }
    }
    let at = (pixel.0 as f32 + 0.5, pixel.1 as f32 + 0.5);
    canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 4.0));
    canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 1.5));
    Ok(canvas)
}

/// For each object of which at least a two-hundredth of the picture is seen, the place of its id: the mean of its
/// pixels, or the one of them that is nearest to it.
fn label_places(seen: &Seen) -> Vec<(usize, (f32, f32))> {
    let least = (seen.objects.len() / 200).max(400) as u64;
    let width = seen.size.0 as usize;
    let place = |at: usize| ((at % width) as f32, (at / width) as f32);
    let mut places = Vec::new();
    for (object, count) in seen.counts().into_iter().filter(|(_, count)| *count >= least) {
        let its = || (0..seen.objects.len()).filter(|&at| seen.objects[at] == Some(object as u32)).map(place);
        let sum = its().fold((0.0, 0.0), |sum, (x, y)| (sum.0 + f64::from(x), sum.1 + f64::from(y)));
        let mean = ((sum.0 / count as f64) as f32, (sum.1 / count as f64) as f32);
        let apart = |(x, y): (f32, f32)| (x - mean.0).powi(2) + (y - mean.1).powi(2);
        if let Some(nearest) = its().min_by(|&a, &b| apart(a).total_cmp(&apart(b))) {
            places.push((object, nearest));
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::built_in;

    /// The page's loops, with an array that begins with what was there before.
    #[test]
    fn as_printed_a_pixel_that_sees_nothing_is_never_set() {
        let scene = crate::from_file::scene::<f64>(&built_in("spheres").unwrap(), Some((9, 9))).unwrap();
        let (width, mut sig) = (9, vec![77; 81]);
        for (row, col) in (0..9).flat_map(|row| (0..9).map(move |col| (row, col))) {
            if let Some(object) = scene.seen(Method::Robust, (col, row)) {
                sig[(row * width + col) as usize] = scene.objects[object].id.unwrap();
            }
        }
        // in the corner there is no sphere
        assert_eq!(sig[0], 77);
        let ids = Seen::of(&scene, Method::Robust).unwrap().ids(&scene).ids;
        assert_eq!(ids[0], 0);
        assert!(sig.iter().zip(&ids).all(|(sig, id)| sig == id || (*sig, *id) == (77, 0)));
    }
}

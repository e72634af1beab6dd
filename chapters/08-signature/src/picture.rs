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

/// The radius of the ring around the pixel that is explained.
const RING: f32 = 6.0;

/// The false colors, an id on every object that is large enough for it, and a ring around the pixel that is
/// explained.
pub(crate) fn draw<R: Real>(seen: &Seen, scene: &Scene<R>, pixel: (u32, u32)) -> Result<Canvas, Error> {
    let mut canvas = seen.canvas()?;
    canvas.fit(seen.size.0 as f32, seen.size.1 as f32);
    let size = (0.03 * seen.size.1 as f32).clamp(9.0, 18.0);
    for (object, place, room) in label_places(seen, pixel) {
        let id = scene.objects[object].id.map(|id| id.to_string());
        // a plate is some 0.65 of its letters' size wide for each of them, and as much beside them
        if let Some(id) = id.filter(|id| 0.33 * size * (id.len() + 1) as f32 <= room) {
            canvas.plate((place.0, place.1 + size / 3.0), Anchor::Middle, size, Color::BLACK, &id);
        }
    }
    let at = (pixel.0 as f32 + 0.5, pixel.1 as f32 + 0.5);
    canvas.circle(at, RING, Pen::solid(Color::BLACK, 4.0));
    canvas.circle(at, RING, Pen::solid(Color::WHITE, 1.5));
    Ok(canvas)
}

/// For each object that is seen, the middle of the largest square of pixels that see it, and half the square's side: its
/// id stands there, and covers no other object. The ring around the pixel that is explained is not covered either.
fn label_places(seen: &Seen, ring: (u32, u32)) -> Vec<(usize, (f32, f32), f32)> {
    let width = seen.size.0 as usize;
    let mut largest: BTreeMap<u32, (u32, usize)> = BTreeMap::new();
    // The side of the largest square whose lower right corner a pixel is: by those of its three neighbors above and left
    // of it. Two rows of them are kept.
    let (mut above, mut row) = (vec![0; width], vec![0; width]);
    for (at, object) in seen.objects.iter().enumerate() {
        let (col, line) = (at % width, at / width);
        let in_ring = col.abs_diff(ring.0 as usize).max(line.abs_diff(ring.1 as usize)) <= RING as usize + 2;
        let same = |other: usize| seen.objects[other] == *object;
        row[col] = match object {
            Some(_) if in_ring => 0,
            Some(_) if col == 0 || line == 0 => 1,
            Some(_) if same(at - 1) && same(at - width) && same(at - width - 1) => {
                1 + row[col - 1].min(above[col]).min(above[col - 1])
            }
            Some(_) => 1,
            None => 0,
        };
        if let Some(object) = object {
            let best = largest.entry(*object).or_insert((0, at));
            if row[col] > best.0 {
                *best = (row[col], at);
            }
        }
        if col + 1 == width {
            std::mem::swap(&mut above, &mut row);
        }
    }
    let half = |(side, at): (u32, usize)| {
        let half = side as f32 / 2.0;
        (((at % width + 1) as f32 - half, (at / width + 1) as f32 - half), half)
    };
    largest.into_iter().map(|(object, square)| (object as usize, half(square).0, half(square).1)).collect()
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

//! A corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`.

use super::line::Line;
use crate::Error;
use crate::toml::shown;

/// A corner, by places from 0 among what the file lists.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) normal: Option<u32>,
}

/// What a corner refers to, part by part, and the statement that lists it.
const LISTS: [(&str, &str); 3] = [("vertex", "v"), ("texture coordinate", "vt"), ("normal", "vn")];

/// How many vertices, texture coordinates and normals there are.
#[derive(Default)]
pub(super) struct Counts([u32; 3]);

impl Counts {
    /// Counts a statement, if it lists something.
    pub(super) fn count(&mut self, keyword: &str) {
        if let Some(which) = LISTS.iter().position(|(_, list)| *list == keyword) {
            self.0[which] = self.0[which].saturating_add(1);
        }
    }
}

impl Corner {
    /// The next corner of a face; `None` at the end of the line. Indices count from 1, negative ones back from the
    /// last that was listed before the face.
    pub(super) fn next(line: &mut Line, all: &Counts, so_far: &Counts) -> Result<Option<Corner>, Error> {
        let Some(word) = line.next() else {
            return Ok(None);
        };
        let mut parts = word.text.split('/');
        let mut places = [None; 3];
        for (which, place) in places.iter_mut().enumerate() {
            let Some(part) = parts.next().filter(|part| which == 0 || !part.is_empty()) else {
                continue;
            };
            let Ok(index) = part.parse::<i64>() else {
                let problem = format!("{} is no corner of a face", shown(word.text));
                return Err(line.fault(
                    word.spot,
                    &problem,
                    "write `v`, `v/vt`, `v//vn` or `v/vt/vn` in whole numbers",
                ));
            };
            let from_0 = if index > 0 { index - 1 } else { i64::from(so_far.0[which]).saturating_add(index) };
            *place = u32::try_from(from_0).ok().filter(|place| index != 0 && *place < all.0[which]);
            if place.is_none() {
                let (what, keyword) = LISTS[which];
                let count = all.0[which];
                let remedy = match count {
                    0 => format!("list it first, in a line that begins with `{keyword}`"),
                    _ => format!("write 1 to {count}, or -1 for the last one before this line"),
                };
                let problem = format!("there is no {what} {index}: the file lists {count}");
                return Err(line.fault(word.spot, &problem, &remedy));
            }
        }
        if parts.next().is_some() {
            let problem = format!("{} has more than three parts", shown(word.text));
            return Err(line.fault(word.spot, &problem, "write `v`, `v/vt`, `v//vn` or `v/vt/vn`"));
        }
        let [vertex, _, normal] = places;
        Ok(vertex.map(|vertex| Corner { vertex, normal }))
    }
}

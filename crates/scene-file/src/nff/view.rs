//! `v`: the camera.

use super::statement::{Statement, VIEW};
use crate::limits::PIXELS;
use crate::{At, Camera, Error, Extent, Grid, Handedness, Place, View};

/// The parts of a view as they come. `hither` is read and not used.
#[derive(Default)]
struct Parts {
    from: Option<At<[f64; 3]>>,
    at: Option<At<[f64; 3]>>,
    up: Option<At<[f64; 3]>>,
    angle: Option<At<f64>>,
    hither: Option<At<f64>>,
    resolution: Option<At<(u32, u32)>>,
}

/// Reads `from`, `at`, `up`, `angle`, `hither` and `resolution`, each once, in any order; only `hither` may be
/// missing.
pub(super) fn view(statement: Statement) -> Result<Camera, Error> {
    let place = statement.place();
    let words = statement.words;
    let mut parts = Parts::default();
    while let Some(mut part) = Statement::begin(words, VIEW) {
        parts.read(&mut part)?;
    }
    let spot = words.source.spot(place);
    let missing = |what: &str, sample: &str| {
        spot.fault(&format!("this view has no `{what}`"), &format!("write `{sample}`"))
    };
    let eye = parts.from.ok_or_else(|| missing("from", "from 0 1 -6"))?;
    let at = parts.at.ok_or_else(|| missing("at", "at 0 0 0"))?;
    let up = parts.up.ok_or_else(|| missing("up", "up 0 1 0"))?;
    let angle = parts.angle.ok_or_else(|| missing("angle", "angle 45"))?;
    let size = parts.resolution.ok_or_else(|| missing("resolution", "resolution 512 512"))?;
    Ok(Camera {
        place,
        eye,
        view: At { value: View::At(at.value), place: at.place },
        up,
        handedness: Handedness::Right,
        distance: At { value: 1.0, place },
        extent: At { value: Extent::Angle(angle.value), place: angle.place },
        size,
        grid: At { value: Grid::Centers, place },
    })
}

impl Parts {
    fn read(&mut self, part: &mut Statement) -> Result<(), Error> {
        let twice = match part.name() {
            "from" => self.from.replace(part.point()?).is_some(),
            "at" => self.at.replace(part.point()?).is_some(),
            "up" => {
                let up = part.point()?;
                if up.value == [0.0; 3] {
                    return Err(part.refused(up.place, "`up` must not be zero"));
                }
                self.up.replace(up).is_some()
            }
            "angle" => {
                let angle = part.number()?;
                if angle.value <= 0.0 || angle.value >= 180.0 {
                    return Err(part.impossible(angle.place, "must be above 0 and below 180"));
                }
                self.angle.replace(angle).is_some()
            }
            "hither" => self.hither.replace(part.number()?).is_some(),
            _ => self.resolution.replace(resolution(part)?).is_some(),
        };
        match twice {
            false => Ok(()),
            true => Err(part
                .words
                .source
                .spot(part.place())
                .fault(&format!("this view has `{}` twice", part.name()), "keep one of the two")),
        }
    }
}

fn resolution(part: &mut Statement) -> Result<At<(u32, u32)>, Error> {
    let (columns, rows) = (part.count()?, part.count()?);
    let place = Place { start: columns.place.start, end: rows.place.end };
    let pixels = columns.value.checked_mul(rows.value).filter(|pixels| (1..=PIXELS).contains(pixels));
    match (pixels, u32::try_from(columns.value), u32::try_from(rows.value)) {
        (Some(_), Ok(columns), Ok(rows)) => Ok(At { value: (columns, rows), place }),
        _ => Err(part.refused(place, "the resolution must be 1 to 2^28 pixels in all")),
    }
}

//! Pictures compared by their decoded pixels: the bytes of a PNG change with its encoder.

use std::fs;
use std::path::Path;

use image::{Rgb, RgbImage};

/// The gap between the parts of a difference picture, in pixels, and its color.
const GAP: u32 = 8;
const GRAY: Rgb<u8> = Rgb([128, 128, 128]);

/// Compares a picture with the committed `NAME.png` of a folder.
///
/// Where they differ, `NAME.actual.png` (what came) and `NAME.difference.png` (what was wanted, what
/// came and their difference, side by side) are left beside it, and the error names both, how many
/// pixels differ, and the first of them. Where they agree, files left by an earlier failure go.
pub fn compare(folder: &Path, name: &str, got: &RgbImage) -> Result<(), String> {
    let wanted = folder.join(format!("{name}.png"));
    let actual = folder.join(format!("{name}.actual.png"));
    let difference = folder.join(format!("{name}.difference.png"));
    let save = |picture: &RgbImage, path: &Path| {
        picture.save(path).map_err(|error| format!("cannot write {}: {error}", path.display()))
    };

    if !wanted.exists() {
        save(got, &actual)?;
        return Err(format!("{name}: there is no {}\n  actual: {}", wanted.display(), actual.display()));
    }
    let want = image::open(&wanted)
        .map_err(|error| format!("{name}: cannot read {}: {error}", wanted.display()))?
        .to_rgb8();
    let differing = differing(&want, got);
    let Some(&(col, row)) = differing.first() else {
        // Mostly there are none to remove.
        let _ = fs::remove_file(actual);
        let _ = fs::remove_file(difference);
        return Ok(());
    };

    save(got, &actual)?;
    save(&side_by_side(&want, got), &difference)?;
    let [of_want, of_got] = [&want, got].map(|picture| {
        let pixel = picture.get_pixel_checked(col, row);
        pixel.map_or("nothing".to_string(), |Rgb(color)| format!("{color:?}"))
    });
    let [(want_width, want_height), (width, height)] = [want.dimensions(), got.dimensions()];
    Err(format!(
        "{name}: {} pixels differ, the first at column {col}, row {row}: want {of_want}, got {of_got}\n  \
         size: want {want_width}x{want_height}, got {width}x{height}\n  \
         actual: {}\n  \
         want, got, difference: {}",
        differing.len(),
        actual.display(),
        difference.display()
    ))
}

/// The pixels that are not the same in both, row by row; a pixel that only one has is one of them.
fn differing(want: &RgbImage, got: &RgbImage) -> Vec<(u32, u32)> {
    let (width, height) = larger(want, got);
    let places = (0..height).flat_map(|row| (0..width).map(move |col| (col, row)));
    places.filter(|&(col, row)| want.get_pixel_checked(col, row) != got.get_pixel_checked(col, row)).collect()
}

/// Three pictures in a row: want, got, difference.
fn side_by_side(want: &RgbImage, got: &RgbImage) -> RgbImage {
    let (width, height) = larger(want, got);
    let mut sheet = RgbImage::from_pixel(3 * width + 2 * GAP, height, GRAY);
    for row in 0..height {
        for col in 0..width {
            let [want, got] = [want, got].map(|picture| picture.get_pixel_checked(col, row));
            let parts = [want.copied(), got.copied(), Some(amplified(want, got))];
            for (part, place) in parts.into_iter().zip([0, width + GAP, 2 * (width + GAP)]) {
                if let Some(pixel) = part {
                    sheet.put_pixel(place + col, row, pixel);
                }
            }
        }
    }
    sheet
}

/// Black where the pixels agree; where they do not, a channel that differs at all is at least half
/// bright, so that a difference of 1 is seen.
fn amplified(want: Option<&Rgb<u8>>, got: Option<&Rgb<u8>>) -> Rgb<u8> {
    let (Some(want), Some(got)) = (want, got) else { return Rgb([255, 255, 255]) };
    let channel = |i: usize| match want.0[i].abs_diff(got.0[i]) {
        0 => 0,
        difference => 128 + difference / 2,
    };
    Rgb([channel(0), channel(1), channel(2)])
}

/// The size of a picture that holds both.
fn larger(a: &RgbImage, b: &RgbImage) -> (u32, u32) {
    (a.width().max(b.width()), a.height().max(b.height()))
}

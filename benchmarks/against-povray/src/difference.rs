//! Whether two pictures show the same.

use std::path::Path;

use image::RgbImage;

/// How far two pictures of one size are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The mean of all channels' absolute differences, in steps of 1/255.
    pub mean: f64,
    /// The share of the pixels of which a channel differs by more than [`Difference::VISIBLE`], 0 to 1.
    pub visible: f64,
}

impl Difference {
    /// A difference of a channel that can be seen where the pictures are put side by side, in steps of 1/255.
    pub const VISIBLE: u8 = 8;

    /// Of two PNG files. What is wrong, and with which file, where one is no picture or they differ in size.
    pub fn of_files(one: &Path, other: &Path) -> Result<Difference, String> {
        let [a, b] = [read(one)?, read(other)?];
        Difference::of(&a, &b).ok_or_else(|| {
            format!(
                "{} has {:?} pixels, {} {:?}",
                one.display(),
                a.dimensions(),
                other.display(),
                b.dimensions()
            )
        })
    }

    /// Of two pictures; `None` where they differ in size or have no pixel.
    pub fn of(one: &RgbImage, other: &RgbImage) -> Option<Difference> {
        let pixels = u64::from(one.width()) * u64::from(one.height());
        if one.dimensions() != other.dimensions() || pixels == 0 {
            return None;
        }
        let (mut sum, mut visible) = (0_u64, 0_u64);
        for (a, b) in one.pixels().zip(other.pixels()) {
            let apart = [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]));
            sum += apart.map(u64::from).iter().sum::<u64>();
            visible += u64::from(apart.iter().any(|&apart| apart > Difference::VISIBLE));
        }
        Some(Difference { mean: sum as f64 / (3 * pixels) as f64, visible: visible as f64 / pixels as f64 })
    }
}

fn read(path: &Path) -> Result<RgbImage, String> {
    let picture = image::open(path).map_err(|why| format!("{}: {why}", path.display()))?;
    Ok(picture.into_rgb8())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(of: [u8; 4]) -> RgbImage {
        RgbImage::from_fn(2, 2, |x, y| image::Rgb([of[(2 * y + x) as usize]; 3]))
    }

    #[test]
    fn eight_is_not_seen_and_nine_is() {
        // 8 + 9 + 0 + 3 in four pixels; one of the four is off by more than 8
        let difference = Difference::of(&gray([10, 10, 10, 10]), &gray([18, 1, 10, 7])).unwrap();
        assert_eq!(difference, Difference { mean: 5.0, visible: 0.25 });
    }

    #[test]
    fn one_channel_is_enough() {
        let (one, mut other) = (gray([0; 4]), gray([0; 4]));
        other.put_pixel(1, 1, image::Rgb([0, 0, 12]));
        // 12 in one of twelve channels
        assert_eq!(Difference::of(&one, &other), Some(Difference { mean: 1.0, visible: 0.25 }));
    }

    #[test]
    fn pictures_of_different_sizes_have_none() {
        assert_eq!(Difference::of(&gray([0; 4]), &RgbImage::new(4, 1)), None);
        assert_eq!(Difference::of(&RgbImage::new(0, 0), &RgbImage::new(0, 0)), None);
        let why = Difference::of_files(Path::new("nowhere.png"), Path::new("nowhere.png")).unwrap_err();
        assert!(why.starts_with("nowhere.png: "), "{why}");
    }
}

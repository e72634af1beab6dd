//! A color for every id, so that one object is told from another.

use stage::Color;

/// Where no object is hit.
pub(crate) const NOTHING: Color = Color([22, 22, 26]);

/// The color of an object by its place, from 0: "each object gets one unique color". The next object's is on the other
/// side of the circle of hues and of another brightness.
///
/// A golden ratio of the circle from one to the next, so that however many there are, no hue comes near again soon; in
/// whole numbers, that of 2^16 parts.
pub(crate) fn color_of(object: usize) -> Color {
    const GOLDEN: u32 = 40_503;
    let hue = ((object as u32).wrapping_mul(GOLDEN) & 0xffff) * 6;
    let (sector, within) = (hue >> 16, (hue & 0xffff) >> 8);
    let (most, least) = [(255, 60), (200, 20), (255, 130), (150, 0)][object % 4];
    let up = least + (most - least) * within / 255;
    let down = most - (most - least) * within / 255;
    let [r, g, b] = match sector {
        0 => [most, up, least],
        1 => [down, most, least],
        2 => [least, most, up],
        3 => [least, down, most],
        4 => [up, least, most],
        _ => [most, least, down],
    };
    Color([r as u8, g as u8, b as u8])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No two of any nine in a row are nearer than a fifth of the way from black to full in all channels together.
    #[test]
    fn neighbors_are_clearly_different() {
        let apart = |Color(a): Color, Color(b): Color| -> u32 {
            a.into_iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(b))).sum()
        };
        for object in 0..65_535_usize {
            for next in 1..4 {
                let (one, other) = (color_of(object), color_of(object + next));
                assert!(apart(one, other) > 90, "{object} {next}: {one:?} {other:?}");
            }
            assert!(apart(color_of(object), NOTHING) > 90, "{object}");
        }
    }
}

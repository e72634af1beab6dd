//! A color for every id, so that one object is told from another.

use stage::Color;

/// Where no object is hit.
pub(crate) const NOTHING: Color = Color([22, 22, 26]);

/// The color of an object by its place, from 0. The next object's is on the other side of the circle of hues and of
/// another brightness.
///
/// "Each object gets one unique color": the first 932 do. There are fewer colors here than ids, and the eye tells fewer
/// still; the ids themselves are unique.
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

    #[test]
    fn the_first_932_are_unique() {
        let colors: std::collections::HashSet<[u8; 3]> = (0..932).map(|object| color_of(object).0).collect();
        assert_eq!(colors.len(), 932);
        assert_eq!(color_of(932), color_of(0));
    }

    /// No two of any eight in a row are nearer than a sixth of the way from black to full in all channels together.
    #[test]
    fn neighbors_are_clearly_different() {
        let apart = |Color(a): Color, Color(b): Color| -> u32 {
            a.into_iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(b))).sum()
        };
        for object in 0..65_535_usize {
            for next in 1..8 {
                let (one, other) = (color_of(object), color_of(object + next));
                assert!(6 * apart(one, other) > 3 * 255, "{object} {next}: {one:?} {other:?}");
            }
            assert!(apart(color_of(object), NOTHING) > 90, "{object}");
        }
    }
}

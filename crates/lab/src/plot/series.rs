//! The lines of a line plot: their spread, their points, their names.

use super::axis::LinearAxis;
use super::extent::Extent;
use super::letters::cut;
use super::lines::{LABEL, Series, WIDTH};
use super::palette;
use super::pen::{Letters, Stroke};
use super::svg::{Point, Svg};

/// Draws the spread of a line.
pub(super) fn band(svg: &mut Svg, series: &Series, place: usize, x: &LinearAxis, y: &LinearAxis) {
    let highs = series.points.iter().map(|point| (x.at(point.0), y.at(point.3)));
    let lows = series.points.iter().rev().map(|point| (x.at(point.0), y.at(point.2)));
    let outline: Vec<Point> = highs.chain(lows).collect();
    svg.area(&outline, palette::of_method(place), 0.16);
}

/// Draws a line with its points.
pub(super) fn line(svg: &mut Svg, series: &Series, place: usize, x: &LinearAxis, y: &LinearAxis) {
    let color = palette::of_method(place);
    let points: Vec<Point> = series.points.iter().map(|point| (x.at(point.0), y.at(point.1))).collect();
    svg.polyline(&points, Stroke::solid(color, 3.0));
    for (at, point) in points.iter().zip(&series.points) {
        svg.open_group(&format!(
            "{}: {} at {}, from {} to {}",
            series.name, point.1, point.0, point.2, point.3
        ));
        let rim = Stroke::solid(stage::Color::WHITE, 1.2);
        match sign(place, *at) {
            Some(corners) => svg.shape(&corners, Some(color), rim),
            None => svg.circle(*at, 6.0, Some(color), rim),
        }
        svg.close_group();
    }
}

/// The shape of a line's points, so that it can be told from the others without colors; `None` is a
/// circle.
fn sign(place: usize, (x, y): Point) -> Option<Vec<Point>> {
    let corners: &[Point] = match place % 6 {
        1 => &[(-5.3, -5.3), (5.3, -5.3), (5.3, 5.3), (-5.3, 5.3)],
        2 => &[(0.0, -7.5), (6.8, 5.0), (-6.8, 5.0)],
        3 => &[(0.0, -7.5), (7.5, 0.0), (0.0, 7.5), (-7.5, 0.0)],
        4 => &[(0.0, 7.5), (6.8, -5.0), (-6.8, -5.0)],
        5 => &[(-9.0, -3.0), (9.0, -3.0), (9.0, 3.0), (-9.0, 3.0)],
        _ => return None,
    };
    Some(corners.iter().map(|(dx, dy)| (x + dx, y + dy)).collect())
}

/// Names the lines at their right ends, pushed apart where the ends are close.
pub(super) fn names_at_the_end(
    svg: &mut Svg,
    series: &[Series],
    frame: Extent,
    x: &LinearAxis,
    y: &LinearAxis,
) {
    let mut ends: Vec<(usize, Point)> = Vec::new();
    for (i, series) in series.iter().enumerate() {
        if let Some(last) = series.points.last() {
            ends.push((i, (x.at(last.0), y.at(last.1))));
        }
    }
    ends.sort_by(|a, b| a.1.1.total_cmp(&b.1.1));
    let heights = apart(&ends.iter().map(|end| end.1.1).collect::<Vec<f64>>(), LABEL + 5.0);
    for ((i, end), height) in ends.into_iter().zip(heights) {
        let color = palette::as_text(palette::of_method(i));
        svg.line((end.0 + 10.0, end.1), (frame.right + 24.0, height), Stroke::solid(color, 1.0));
        let name = cut(&series[i].name, LABEL, WIDTH / 3.0);
        svg.text((frame.right + 29.0, height + 6.0), Letters::new(LABEL, color).bold(true), &name);
    }
}

/// Ascending heights, moved as little as keeps them `gap` apart: those that are too close form a block
/// around their own middle.
fn apart(heights: &[f64], gap: f64) -> Vec<f64> {
    // blocks of (sum of the heights wanted for its first member, how many)
    let mut blocks: Vec<(f64, usize)> = Vec::new();
    for &height in heights {
        blocks.push((height, 1));
        while let [.., (above, many), (below, more)] = blocks[..]
            && above / many as f64 + gap * many as f64 > below / more as f64
        {
            blocks.truncate(blocks.len() - 2);
            blocks.push((above + below - gap * (many * more) as f64, many + more));
        }
    }
    let members = |&(sum, many): &(f64, usize)| (0..many).map(move |i| sum / many as f64 + gap * i as f64);
    blocks.iter().flat_map(members).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_pushed_apart_as_little_as_can_be() {
        assert_eq!(apart(&[0.0, 100.0], 20.0), [0.0, 100.0]);
        assert_eq!(apart(&[50.0, 50.0], 20.0), [40.0, 60.0]);
        assert_eq!(apart(&[50.0, 50.0, 62.0], 20.0), [34.0, 54.0, 74.0]);
        assert!(apart(&[], 20.0).is_empty());
        let many = apart(&[1.0, 2.0, 3.0, 40.0, 41.0, 90.0], 12.0);
        assert!(many.windows(2).all(|pair| pair[1] - pair[0] >= 12.0 - 1e-9), "{many:?}");
    }
}

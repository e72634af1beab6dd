//! Where labels go when marks crowd.
//!
//! Every label has a few hundred places around its mark, each with a cost: the further off the dearer, and
//! what lies under it or under its leader costs, too. [`arrange`] picks one for each.

use super::arrange::arrange;
use super::extent::{Extent, distance, do_cross, length};
use super::svg::Point;

/// A mark that wants a label.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tag {
    /// The center of the mark.
    pub(super) at: Point,
    /// How far the mark reaches.
    pub(super) radius: f64,
    /// Width and height of the label.
    pub(super) size: (f64, f64),
    /// Where the lowest label above ends, for a mark that stands in a row of its own: the labels of a
    /// whole row are stacked from there.
    pub(super) stack: Option<f64>,
}

/// A label in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Label {
    pub(super) extent: Extent,
    /// From the mark to the label; `None` where it is beside its mark.
    pub(super) leader: Option<(Point, Point)>,
    /// What the place costs whatever the other labels do.
    pub(super) cost: f64,
}

/// A line that labels had better not lie on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) ends: (Point, Point),
    /// How many pixels further away a label would go to get off it.
    pub(super) cost: f64,
}

/// A label for every tag within the frame.
pub(super) fn place_labels(tags: &[Tag], frame: Extent, lines: &[Line]) -> Vec<Label> {
    let choices = (0..tags.len()).map(|i| {
        let mut choices = candidates(&tags[i], frame);
        choices.iter_mut().for_each(|label| label.cost += fixed_cost(i, label, tags, lines));
        choices
    });
    let mut labels = arrange(choices.collect());
    for (i, label) in labels.iter_mut().enumerate() {
        label.leader = label.leader.map(|(from, end)| (start(i, from, end, tags), end));
    }
    labels
}

/// Where a leader that would start at `from` begins: where the rim of its mark is to be seen, and not
/// behind one of the later marks, which lie on top.
fn start(own: usize, from: Point, end: Point, tags: &[Tag]) -> Point {
    let is_hidden = |point: Point| tags[own + 1..].iter().any(|tag| length(point, tag.at) < tag.radius + 0.5);
    let is_in_the_way = |point: Point| {
        let others = tags.iter().enumerate().filter(|&(i, _)| i != own);
        others.into_iter().any(|(_, tag)| distance(tag.at, (point, end)) < tag.radius)
    };
    let Tag { at: (x, y), radius, .. } = tags[own];
    let cost = |&point: &Point| {
        let (hidden, in_the_way) = (is_hidden(point), is_in_the_way(point));
        length(point, end)
            + if hidden { 100.0 } else { 0.0 }
            + if in_the_way { 3.0 * radius } else { 0.0 }
            // straight toward its center, if all else is the same
            + 0.5 * length(point, from)
    };
    // the rim, seen through points around a square
    let square = (-3..3).flat_map(|step| {
        let along = f64::from(step) / 3.0;
        [(1.0, along), (-along, 1.0), (-1.0, -along), (along, -1.0)]
    });
    let rim = square.map(|(dx, dy)| {
        let share = radius / length((0.0, 0.0), (dx, dy));
        (x + share * dx, y + share * dy)
    });
    rim.chain([from]).min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap_or(from)
}

/// The places around a mark: beside it, then further off in all directions.
fn candidates(tag: &Tag, frame: Extent) -> Vec<Label> {
    let (x, y) = tag.at;
    let (width, height) = tag.size;
    let beside = tag.radius + 3.0;
    let at = |left: f64, middle: f64| Extent {
        left,
        top: middle - height / 2.0,
        right: left + width,
        bottom: middle + height / 2.0,
    };
    let mut extents = vec![
        at(x - width / 2.0, y - tag.radius - 1.0 - height / 2.0),
        at(x - width / 2.0, y + tag.radius + 1.0 + height / 2.0),
    ];
    let middles: Vec<f64> = match tag.stack {
        Some(bottom) => {
            (0..9).map(|row| bottom - height / 2.0 - (height + 1.0) * f64::from(row)).chain([y]).collect()
        }
        None => (-16..=16).map(|step| y + 7.0 * f64::from(step)).collect(),
    };
    for dx in [0.0, 5.0, 12.0, 20.0, 30.0, 45.0, 65.0, 90.0, 120.0] {
        for &middle in &middles {
            extents.push(at(x + beside + dx, middle));
            extents.push(at(x - beside - dx - width, middle));
        }
    }
    extents.retain(|extent| frame.holds(extent));
    if extents.is_empty() {
        let left = (x + beside).min(frame.right - width).max(frame.left);
        extents.push(at(left, y.clamp(frame.top + height / 2.0, frame.bottom - height / 2.0)));
    }
    extents.into_iter().map(|extent| label(tag, extent)).collect()
}

/// A label with its leader, which ends in the middle of the label's nearer side.
fn label(tag: &Tag, extent: Extent) -> Label {
    let (x, y) = tag.at;
    let near = (x.clamp(extent.left, extent.right), y.clamp(extent.top, extent.bottom));
    let distance = length(tag.at, near) - tag.radius;
    let middle = (extent.top + extent.bottom) / 2.0;
    let end = if extent.left > x { (extent.left, middle) } else { (extent.right, middle) };
    let reach = length(tag.at, end);
    let is_beside = distance < 5.5 || reach <= tag.radius;
    // a slanted label is a little worse than a level one, the left a little worse than the right
    let slant = 0.15 * (middle - y).abs() + if extent.left > x { 0.0 } else { 1.0 };
    if is_beside {
        return Label { extent, leader: None, cost: distance.max(0.0) + slant };
    }
    let share = tag.radius / reach;
    let from = (x + share * (end.0 - x), y + share * (end.1 - y));
    const LEADER: f64 = 8.0;
    Label { extent, leader: Some((from, end)), cost: LEADER + distance + slant }
}

/// How far the rim of a mark is from a label.
fn gap(extent: &Extent, tag: &Tag) -> f64 {
    let (x, y) = tag.at;
    let near = (x.clamp(extent.left, extent.right), y.clamp(extent.top, extent.bottom));
    length(tag.at, near) - tag.radius
}

/// What a label costs by what lies still: marks and lines.
fn fixed_cost(own: usize, label: &Label, tags: &[Tag], lines: &[Line]) -> f64 {
    let mut cost = 0.0;
    for (i, tag) in tags.iter().enumerate() {
        let reach = tag.radius + 1.0;
        let (x, y) = tag.at;
        let mark = Extent { left: x - reach, top: y - reach, right: x + reach, bottom: y + reach };
        if label.extent.overlap(&mark) > 0.0 {
            cost += if i == own { 10.0 } else { 150.0 } + label.extent.overlap(&mark);
        }
        if i != own && label.leader.is_some_and(|leader| distance(tag.at, leader) < tag.radius + 1.0) {
            cost += 75.0;
        }
        // without a leader, and as near to another mark, it could be taken for that one's label
        if i != own
            && label.leader.is_none()
            && gap(&label.extent, tag) < gap(&label.extent, &tags[own]) + 6.0
        {
            cost += 60.0;
        }
    }
    for line in lines {
        if label.extent.inset(-1.0).is_crossed(line.ends) {
            cost += line.cost;
        }
        if label.leader.is_some_and(|leader| do_cross(leader, line.ends)) {
            cost += 0.1 * line.cost;
        }
    }
    cost
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Extent = Extent { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    fn tag(x: f64, y: f64) -> Tag {
        Tag { at: (x, y), radius: 5.0, size: (90.0, 14.0), stack: None }
    }

    fn assert_apart(labels: &[Label]) {
        for (i, label) in labels.iter().enumerate() {
            assert!(FRAME.holds(&label.extent), "{label:?} sticks out");
            for other in &labels[..i] {
                assert_eq!(label.extent.overlap(&other.extent), 0.0, "{label:?} lies on {other:?}");
            }
        }
    }

    #[test]
    fn a_lone_mark_has_its_label_beside_it() {
        let labels = place_labels(&[tag(200.0, 150.0)], FRAME, &[]);
        assert_eq!(labels.len(), 1);
        assert_eq!(labels[0].leader, None);
        assert!(
            distance((200.0, 150.0), ((labels[0].extent.left, 150.0), (labels[0].extent.right, 150.0)))
                < 30.0
        );
    }

    #[test]
    fn twelve_labels_of_a_crowd_lie_apart() {
        let crowd: Vec<Tag> =
            (0..12).map(|i| tag(180.0 + 9.0 * f64::from(i % 6), 150.0 + f64::from(i / 6))).collect();
        assert_apart(&place_labels(&crowd, FRAME, &[]));
        let same_place = [tag(200.0, 150.0); 12];
        assert_apart(&place_labels(&same_place, FRAME, &[]));
    }

    #[test]
    fn a_crowd_in_a_corner_stays_within_the_frame() {
        for corner in [(12.0, 12.0), (388.0, 12.0), (12.0, 288.0), (388.0, 288.0)] {
            assert_apart(&place_labels(&[tag(corner.0, corner.1); 6], FRAME, &[]));
        }
    }

    #[test]
    fn a_label_keeps_off_a_line() {
        let line = Line { ends: ((0.0, 150.0), (400.0, 150.0)), cost: 25.0 };
        let labels = place_labels(&[tag(200.0, 150.0)], FRAME, &[line]);
        assert!(!labels[0].extent.is_crossed(line.ends), "{:?}", labels[0]);
    }

    #[test]
    fn a_leader_starts_where_its_mark_is_to_be_seen() {
        // the later marks cover the earlier ones but for a sliver
        let crowd: Vec<Tag> = (0..9).map(|i| tag(180.0 + 2.0 * f64::from(i), 150.0)).collect();
        let labels = place_labels(&crowd, FRAME, &[]);
        assert!(labels.iter().filter(|label| label.leader.is_some()).count() > 3);
        for (i, label) in labels.iter().enumerate() {
            let Some((from, _)) = label.leader else { continue };
            assert!((length(from, crowd[i].at) - 5.0).abs() < 1e-9, "{label:?} is off its mark");
            for other in &crowd[i + 1..] {
                assert!(length(from, other.at) >= 5.0, "{label:?} starts on {other:?}");
            }
        }
    }

    #[test]
    fn a_label_that_could_be_another_mark_s_has_a_leader() {
        for apart in 3..20 {
            let pair = [tag(200.0, 150.0), tag(200.0 + f64::from(apart), 150.0)];
            for (i, label) in place_labels(&pair, FRAME, &[]).iter().enumerate() {
                let is_nearest = gap(&label.extent, &pair[i]) + 5.0 < gap(&label.extent, &pair[1 - i]);
                assert!(label.leader.is_some() || is_nearest, "{apart} apart: {label:?}");
            }
        }
    }

    #[test]
    fn the_labels_of_a_row_are_stacked_above_it() {
        let row: Vec<Tag> =
            (0..9).map(|i| Tag { stack: Some(260.0), ..tag(150.0 + 12.0 * f64::from(i), 280.0) }).collect();
        let labels = place_labels(&row, FRAME, &[]);
        assert_apart(&labels);
        for label in &labels {
            let rows = (260.0 - label.extent.bottom) / 15.0;
            let is_at_the_row = label.extent.bottom > 260.0;
            assert!(is_at_the_row || (rows == rows.round() && rows < 6.0), "{label:?}");
        }
    }

    #[test]
    fn a_label_that_fits_nowhere_is_still_there() {
        let wide = Tag { at: (20.0, 20.0), radius: 5.0, size: (900.0, 14.0), stack: None };
        assert_eq!(place_labels(&[wide], FRAME, &[]).len(), 1);
    }
}

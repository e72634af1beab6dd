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
    arrange(choices.collect())
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
    for dx in [0.0, 5.0, 12.0, 20.0, 30.0, 45.0, 65.0, 90.0, 120.0] {
        for step in -16..=16 {
            let middle = y + 7.0 * f64::from(step);
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
            cost += 60.0;
        }
        // beside another mark's center it could be taken for that one's label
        if i != own && label.leader.is_none() && label.extent.inset(-5.0).overlap(&mark) > 0.0 {
            cost += 12.0;
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
        Tag { at: (x, y), radius: 5.0, size: (90.0, 14.0) }
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
    fn a_label_that_fits_nowhere_is_still_there() {
        let wide = Tag { at: (20.0, 20.0), radius: 5.0, size: (900.0, 14.0) };
        assert_eq!(place_labels(&[wide], FRAME, &[]).len(), 1);
    }
}

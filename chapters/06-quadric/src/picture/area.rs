//! Where in a panel something is drawn, and what of a line lies there.

use super::panels::{HEIGHT, WIDTH};

/// What a caption at the top of a panel takes.
const CAPTION: f32 = 40.0;
/// What the legend at the bottom of a solid takes.
const LEGEND: f32 = 22.0;
/// What the list at the bottom of a section takes.
pub(crate) const LIST: f32 = 66.0;

/// A part of the canvas, in drawing units: from its top left to its bottom right corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Area {
    pub(crate) from: (f32, f32),
    pub(crate) to: (f32, f32),
}

impl Area {
    /// Where a solid is seen: between the caption and the legend.
    pub(crate) fn of_seen((left, top): (f32, f32)) -> Area {
        Area { from: (left, top + CAPTION), to: (left + WIDTH, top + HEIGHT - LEGEND) }
    }

    /// Where a section is drawn: between its caption and its list.
    pub(crate) fn of_section((left, top): (f32, f32)) -> Area {
        Area { from: (left + 2.0, top + CAPTION), to: (left + WIDTH - 2.0, top + HEIGHT - LIST) }
    }

    /// Whether a place lies in it.
    pub(crate) fn holds(&self, (x, y): (f32, f32)) -> bool {
        self.from.0 <= x && x <= self.to.0 && self.from.1 <= y && y <= self.to.1
    }

    /// The part of the line from `a` to `b` that lies within it (Liang and Barsky 1984); `None` where none does.
    pub(crate) fn clip(&self, a: (f32, f32), b: (f32, f32)) -> Option<((f32, f32), (f32, f32))> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut enters, mut leaves) = (0.0_f32, 1.0_f32);
        // How far `a` is within each edge, and how fast the line runs toward it.
        for (within, toward) in
            [(a.0 - self.from.0, -dx), (self.to.0 - a.0, dx), (a.1 - self.from.1, -dy), (self.to.1 - a.1, dy)]
        {
            match () {
                _ if toward > 0.0 => leaves = leaves.min(within / toward),
                _ if toward < 0.0 => enters = enters.max(within / toward),
                _ if within < 0.0 => return None,
                _ => {}
            }
        }
        let at = |s: f32| (a.0 + s * dx, a.1 + s * dy);
        (enters < leaves).then(|| (at(enters), at(leaves)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_clipped_to_an_area() {
        let area = Area { from: (0.0, 0.0), to: (10.0, 10.0) };
        assert_eq!(area.clip((-5.0, 5.0), (15.0, 5.0)), Some(((0.0, 5.0), (10.0, 5.0))));
        assert_eq!(area.clip((2.0, 3.0), (4.0, 5.0)), Some(((2.0, 3.0), (4.0, 5.0))), "within");
        assert_eq!(area.clip((-5.0, 0.0), (0.0, -5.0)), None, "past a corner");
        assert_eq!(area.clip((11.0, 0.0), (11.0, 10.0)), None, "beside it");
    }
}

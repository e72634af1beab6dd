//! How lines are drawn and text is set in an SVG.

use stage::{Anchor, Color};

use super::xml::{hex, number};

/// How a line is drawn.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    pub(super) color: Color,
    pub(super) width: f64,
    pub(super) opacity: f64,
    /// As `stroke-dasharray` takes it; empty for a solid line.
    pub(super) dash: &'static str,
}

/// How a line of text is set.
#[derive(Clone, Copy)]
pub(super) struct Letters {
    pub(super) size: f64,
    pub(super) color: Color,
    /// Which end of the text is at its place.
    pub(super) anchor: Anchor,
    pub(super) bold: bool,
}

impl Stroke {
    pub(super) fn solid(color: Color, width: f64) -> Stroke {
        Stroke { color, width, opacity: 1.0, dash: "" }
    }

    /// As the attributes of an element.
    pub(super) fn attributes(self) -> String {
        let mut text = format!(r#"stroke="{}" stroke-width="{}""#, hex(self.color), number(self.width));
        if self.opacity < 1.0 {
            text += &format!(r#" stroke-opacity="{}""#, number(self.opacity));
        }
        if !self.dash.is_empty() {
            text += &format!(r#" stroke-dasharray="{}""#, self.dash);
        }
        text
    }
}

impl Letters {
    pub(super) fn new(size: f64, color: Color) -> Letters {
        Letters { size, color, anchor: Anchor::Left, bold: false }
    }

    pub(super) fn at(self, anchor: Anchor) -> Letters {
        Letters { anchor, ..self }
    }

    pub(super) fn bold(self, bold: bool) -> Letters {
        Letters { bold, ..self }
    }
}

//! The lab's results as pictures for a slide: pure functions from plain data to a document.
//!
//! Nothing is measured here and nothing is chosen at random: the same data give the same bytes.
//! [`trade_svg`] shows speed against accuracy, a panel a regime; [`lines_svg`] how the time of a ray
//! depends on one quantity; [`failure_map`] where in a plane of two quantities a method loses its digits.
//!
//! The SVGs stand by themselves: no script, no style sheet, no font but the viewer's own sans-serif. They
//! are written by hand because plotting crates were found to clamp or to leave labels out below 1e-10, and
//! what is shown here goes down to 1e-17.

mod arrange;
mod axis;
mod extent;
mod front;
mod grid;
mod heat;
mod labels;
mod legend;
mod letters;
mod lines;
mod map;
mod map_axes;
mod mark;
mod palette;
mod panel;
mod pen;
mod series;
mod shared;
mod svg;
mod trade;
mod xml;

pub use lines::{LinePlot, Series, lines_svg};
pub use map::{Cell, MapAxis, MapPanel, MapPlot, failure_map};
pub use trade::{Mark, Panel, TradePlot, Words, trade_svg};

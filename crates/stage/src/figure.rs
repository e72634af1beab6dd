//! An interactive figure: what a reader can change by hand, and what is said of it.

use math::{Degenerate, Hit, Real, Vector};

use crate::{Section, Sketch, Transcript, Value};

/// A place of the plane that is drawn, y upward.
pub type Place = (f64, f64);

/// What can be dragged.
#[derive(Clone, Debug, PartialEq)]
pub struct Handle {
    /// What it is, as the page calls it.
    pub name: &'static str,
    /// Where it stands.
    pub place: Place,
}

/// What can be turned: a number between two others.
#[derive(Clone, Debug, PartialEq)]
pub struct Dial {
    /// What it is, as the page calls it.
    pub name: &'static str,
    /// The number it shows.
    pub value: f64,
    /// The least number there may be.
    pub least: f64,
    /// The largest.
    pub most: f64,
}

/// A chapter's question with everything that can be changed about it. What a new one shows is where a reader
/// starts.
///
/// A figure has no formula of its own: it asks the chapter's methods, and shows their steps as `show` does.
pub trait Figure: Default {
    /// What is drawn, in a sentence: which plane it is, and what to move.
    const CAPTION: &'static str;
    /// The lower left and the upper right corner of the part of the plane that is seen.
    const FRAME: (Place, Place);

    /// The chapter's methods by name.
    fn methods() -> Vec<&'static str>;

    /// What can be dragged.
    fn handles(&self) -> Vec<Handle>;

    /// Drags a handle, by its place in [`handles`](Figure::handles); one that there is not is let go.
    fn drag(&mut self, handle: usize, to: Place);

    /// What can be turned.
    fn dials(&self) -> Vec<Dial> {
        Vec::new()
    }

    /// Turns a dial, by its place in [`dials`](Figure::dials).
    fn turn(&mut self, _dial: usize, _to: f64) {}

    /// Draws what is there, but for the handles.
    fn draw(&self, sketch: &mut Sketch);

    /// The steps of a method, by its place in [`methods`](Figure::methods), in R.
    ///
    /// [`Degenerate`] for a question without an answer.
    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate>;

    /// The answer of a method, by its place in [`methods`](Figure::methods), in R, in a few words.
    fn answer<R: Real>(&self, method: usize) -> String;
}

/// The steps that a chapter's `explain` writes: those of the first section, none where it opens none.
pub fn first_steps<R: Real>(explain: impl FnOnce(&mut Transcript)) -> Section {
    let mut transcript =
        Transcript { stage: "figure", method: "figure", precision: R::NAME, sections: Vec::new() };
    explain(&mut transcript);
    transcript.sections.into_iter().next().unwrap_or_else(|| Section::new("", ""))
}

/// A hit in words: t and the point, or why there is none. `why` is the reason for a miss; it may be empty.
pub fn hit_in_words<R: Real, V: Vector<R>>(hit: Result<Option<Hit<R, V>>, Degenerate>, why: &str) -> String {
    match hit {
        Ok(Some(hit)) => format!("t = {} at {}", number(hit.t), Value::vector(hit.point).to_text()),
        Ok(None) if why.is_empty() => "no hit".to_string(),
        Ok(None) => format!("no hit: {why}"),
        Err(degenerate) => format!("no answer: {degenerate}"),
    }
}

fn number<R: Real>(x: R) -> String {
    Value::number(x).to_text()
}

/// A number of a pointer, which is never exact, as one that a reader can write down: to hundredths.
pub fn hundredths(x: f64) -> f64 {
    // adding 0 makes minus zero zero
    (x * 100.0).round() / 100.0 + 0.0
}

/// A point of the drawn plane where that is z = 0.
pub fn at_z_0<R: Real>((x, y): Place) -> R::Vec3 {
    R::vec3(R::round_from(x), R::round_from(y), R::from(0.0))
}

/// An arrow from one place to another, moved so that it begins elsewhere. Along an axis on which it is not moved its tip
/// stays as it is.
pub fn moved((from, tip): (Place, Place), to: Place) -> (Place, Place) {
    let along = |from: f64, tip: f64, to: f64| if to == from { tip } else { hundredths(to + tip - from) };
    (to, (along(from.0, tip.0, to.0), along(from.1, tip.1, to.1)))
}

/// Where a handle at `was` is dragged to: to hundredths, but for a coordinate that stays what it was.
pub fn to_hundredths(was: Place, to: Place) -> Place {
    let along = |was: f64, to: f64| if to == was { was } else { hundredths(to) };
    (along(was.0, to.0), along(was.1, to.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_moved_keeps_its_digits() {
        assert_eq!(to_hundredths((-0.125, 0.125), (-0.125, 0.2251)), (-0.125, 0.23));
        let arrow = ((1.0, 2.0), (1.125, 2.125));
        assert_eq!(moved(arrow, (1.0, 3.0)), ((1.0, 3.0), (1.125, 3.13)));
        assert_eq!(moved(arrow, (1.0, 2.0)), arrow);
    }
}

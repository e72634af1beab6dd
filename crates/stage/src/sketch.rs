//! A section of what happened, as a small drawing: SVG whose colors the page that shows it chooses.

use std::fmt::Write;

use crate::View;
use crate::figure::hundredths;

/// The frame of every sketch, in drawing units: width and height. A place in it is counted from its top left,
/// y downward.
pub const SKETCH: (u32, u32) = (480, 320);
/// The border that stays free around the plane, in drawing units.
const BORDER: f32 = 12.0;
/// The length of an arrow's head, in drawing units.
const HEAD: f64 = 9.0;

/// A place of the plane, y upward.
type Place = (f64, f64);

/// What a line stands for; how that looks is up to the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// The ray that is followed.
    Ray,
    /// The outline of an object.
    Object,
    /// The object's surface where it is met.
    Surface,
    /// A normal.
    Normal,
    /// A length that is measured.
    Length,
    /// What helps to read the drawing: axes, a view plane.
    Quiet,
    /// A ray in a mirror direction.
    Mirror,
    /// A ray that went through a surface.
    Refracted,
    /// A ray to a light.
    Shadow,
}

impl Ink {
    /// The class of the SVG element.
    fn class(self) -> &'static str {
        match self {
            Ink::Ray => "ray",
            Ink::Object => "object",
            Ink::Surface => "surface",
            Ink::Normal => "normal",
            Ink::Length => "length",
            Ink::Quiet => "quiet",
            Ink::Mirror => "mirror",
            Ink::Refracted => "refracted",
            Ink::Shadow => "shadow",
        }
    }
}

/// A drawing of a part of a plane, in the making; what is drawn later lies on top.
///
/// It is a fragment: the elements that stand within an `<svg viewBox="0 0 480 320">`, see [`SKETCH`]. Lines
/// are cut off at the frame, and what has no place there, for it is too far away or no number, is left out.
#[derive(Clone, Debug)]
pub struct Sketch {
    view: View,
    text: String,
    /// Where labels stand that others keep away from.
    taken: Vec<Place>,
}

impl Sketch {
    /// The part of the plane from the lower left corner `low` to the upper right `high`, which is above it
    /// and to its right, as large as the frame allows.
    pub fn new(low: Place, high: Place) -> Sketch {
        let (right, bottom) = (SKETCH.0 as f32 - BORDER, SKETCH.1 as f32 - BORDER);
        Sketch {
            view: View::new(low, high, (BORDER, BORDER), (right, bottom)),
            text: String::new(),
            taken: Vec::new(),
        }
    }

    /// A line.
    pub fn line(&mut self, from: Place, to: Place, ink: Ink) -> &mut Sketch {
        self.stroke(from, to, ink, false, 1.0)
    }

    /// A line with a head at its end: at `to`, or where the frame cuts it off. One shorter than a head has
    /// none. The smaller `weight` is, from 1 down to 0, the thinner the line; at 1 it is like any other.
    pub fn arrow(&mut self, from: Place, to: Place, ink: Ink, weight: f64) -> &mut Sketch {
        self.stroke(from, to, ink, true, weight)
    }

    fn stroke(&mut self, from: Place, to: Place, ink: Ink, has_head: bool, weight: f64) -> &mut Sketch {
        let Some(((x, y), (to_x, to_y))) = within_frame(self.at(from), self.at(to)) else { return self };
        let class = ink.class();
        // a ray that brings little is thin, and still a line
        let width = match weight {
            weight if weight < 1.0 => {
                format!(" style=\"stroke-width:{}\"", tenths(0.8 + 1.6 * weight.max(0.0).sqrt()))
            }
            _ => String::new(),
        };
        let [x1, y1, x2, y2] = [x, y, to_x, to_y].map(tenths);
        self.add(format_args!("<path class=\"{class}\"{width} d=\"M{x1} {y1}L{x2} {y2}\"/>"));
        let (dx, dy) = (to_x - x, to_y - y);
        let length = (dx * dx + dy * dy).sqrt();
        if has_head && length > HEAD {
            let (dx, dy) = (HEAD * dx / length, HEAD * dy / length);
            let (back, aside) = ((to_x - dx, to_y - dy), (0.4 * -dy, 0.4 * dx));
            let wings = [back.0 + aside.0, back.1 + aside.1, back.0 - aside.0, back.1 - aside.1].map(tenths);
            let [ax, ay, bx, by] = wings;
            self.add(format_args!("<path class=\"{class} head\" d=\"M{x2} {y2}L{ax} {ay}L{bx} {by}z\"/>"));
        }
        self
    }

    /// A circle by its center and radius, both in the plane.
    pub fn circle(&mut self, center: Place, radius: f64, ink: Ink) -> &mut Sketch {
        let ((x, y), radius) = (self.at(center), f64::from(self.view.length(radius)));
        if [x, y, radius].iter().all(|it| it.is_finite()) {
            let ([x, y, radius], class) = ([x, y, radius].map(tenths), ink.class());
            self.add(format_args!("<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>"));
        }
        self
    }

    /// A closed outline through its corners.
    pub fn outline(&mut self, corners: &[Place], ink: Ink) -> &mut Sketch {
        let places: Vec<Place> = corners.iter().map(|&corner| self.at(corner)).collect();
        if places.iter().all(|(x, y)| x.is_finite() && y.is_finite()) {
            let places: Vec<String> =
                places.iter().map(|&(x, y)| format!("{} {}", tenths(x), tenths(y))).collect();
            let class = ink.class();
            self.add(format_args!("<path class=\"{class}\" d=\"M{}z\"/>", places.join("L")));
        }
        self
    }

    /// A dot.
    pub fn dot(&mut self, place: Place, ink: Ink) -> &mut Sketch {
        let (x, y) = self.at(place);
        if is_inside((x, y)) {
            let ([x, y], class) = ([x, y].map(tenths), ink.class());
            self.add(format_args!("<circle class=\"{class} dot\" cx=\"{x}\" cy=\"{y}\" r=\"3.2\"/>"));
        }
        self
    }

    /// A text whose middle stands `aside` of a place, in drawing units to the right and downward. What follows `_` is
    /// an index: `p_r`.
    pub fn label(&mut self, place: Place, aside: (f64, f64), ink: Ink, text: &str) -> &mut Sketch {
        let (x, y) = self.at(place);
        let (x, y) = (x + aside.0, y + aside.1 + 4.0);
        if is_inside((x, y)) {
            let ([x, y], class, text) = ([x, y].map(tenths), ink.class(), with_indices(text));
            self.add(format_args!("<text class=\"{class}\" x=\"{x}\" y=\"{y}\">{text}</text>"));
        }
        self
    }

    /// The same where no other of these labels is near; else nothing. Returns whether there is room.
    pub fn label_where_free(&mut self, place: Place, aside: (f64, f64), ink: Ink, text: &str) -> bool {
        let (x, y) = self.at(place);
        let (x, y) = (x + aside.0, y + aside.1);
        let half = |text: &str| 3.7 * text.chars().count() as f64;
        let near = |other: &Place| (y - other.1).abs() < 13.0 && (x - other.0).abs() < 8.0 + half(text);
        let is_free = !self.taken.iter().any(near);
        if is_free {
            self.taken.push((x, y));
            self.label(place, aside, ink, text);
        }
        is_free
    }

    /// A text that begins at a place of the frame, in drawing units.
    pub fn caption(&mut self, (x, y): (f64, f64), ink: Ink, text: &str) -> &mut Sketch {
        let ([x, y], class, text) = ([x, y].map(tenths), ink.class(), escaped(text));
        self.add(format_args!("<text class=\"{class} caption\" x=\"{x}\" y=\"{y}\">{text}</text>"));
        self
    }

    /// What a reader can drag, by its number: a dot with room around it for a finger. One that stands
    /// outside of the frame waits at its border.
    pub fn handle(&mut self, place: Place, number: usize, name: &str) -> &mut Sketch {
        let (x, y) = self.at(place);
        let within = |x: f64, most: u32| tenths(x.max(0.0).min(f64::from(most)));
        let (x, y, name) = (within(x, SKETCH.0), within(y, SKETCH.1), escaped(name));
        let [now, other] = [place.0, place.1].map(hundredths);
        let [(least, _), (most, _)] = [(0.0, 0.0), (f64::from(SKETCH.0), 0.0)].map(|end| self.plane(end));
        self.add(format_args!(
            "<g class=\"handle\" data-handle=\"{number}\" tabindex=\"0\" role=\"slider\" \
             aria-label=\"{name}\" \
             aria-valuemin=\"{least}\" aria-valuemax=\"{most}\" aria-valuenow=\"{now}\" aria-valuetext=\"({now}, {other})\" transform=\"translate({x} {y})\">\
             <circle class=\"reach\" r=\"16\"/><circle class=\"grip\" r=\"6\"/></g>"
        ));
        self
    }

    /// The point of the plane at a place of the frame, in drawing units.
    pub fn plane(&self, place: (f64, f64)) -> Place {
        self.view.plane(place)
    }

    /// The elements.
    pub fn into_svg(self) -> String {
        self.text
    }

    fn at(&self, place: Place) -> Place {
        let (x, y) = self.view.at(place);
        (f64::from(x), f64::from(y))
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // a String takes whatever is written
        let _ = self.text.write_fmt(element);
    }
}

/// A text as HTML or SVG, between tags or inside a quoted attribute.
pub fn escaped(text: &str) -> String {
    let mut marked_up = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '&' => marked_up.push_str("&amp;"),
            '<' => marked_up.push_str("&lt;"),
            '>' => marked_up.push_str("&gt;"),
            '"' => marked_up.push_str("&quot;"),
            '\'' => marked_up.push_str("&#39;"),
            other => marked_up.push(other),
        }
    }
    marked_up
}

/// A length to a tenth of a drawing unit, which nobody sees.
fn tenths(x: f64) -> f64 {
    // adding 0 makes minus zero zero
    (10.0 * x).round() / 10.0 + 0.0
}

fn is_inside((x, y): Place) -> bool {
    (0.0..=f64::from(SKETCH.0)).contains(&x) && (0.0..=f64::from(SKETCH.1)).contains(&y)
}

/// What of a line is within the frame; `None` where nothing is.
fn within_frame((x, y): Place, (to_x, to_y): Place) -> Option<(Place, Place)> {
    let (dx, dy) = (to_x - x, to_y - y);
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (p, d, high) in [(x, dx, f64::from(SKETCH.0)), (y, dy, f64::from(SKETCH.1))] {
        if d == 0.0 {
            if !(0.0..=high).contains(&p) {
                return None;
            }
            continue;
        }
        let (a, b) = (-p / d, (high - p) / d);
        (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
    }
    let is_there = enters < leaves && [x, y, dx, dy].iter().all(|it| it.is_finite());
    is_there.then_some(((x + enters * dx, y + enters * dy), (x + leaves * dx, y + leaves * dy)))
}

/// A text as markup, its indices lower and smaller.
fn with_indices(text: &str) -> String {
    let mut parts = text.split('_');
    let mut markup = escaped(parts.next().unwrap_or_default());
    for part in parts {
        let end = part.find(|sign: char| !sign.is_alphanumeric()).unwrap_or(part.len());
        let (index, rest) = part.split_at(end);
        markup += &format!("<tspan dy=\"3\" font-size=\"0.8em\">{}</tspan>", escaped(index));
        if !rest.is_empty() {
            markup += &format!("<tspan dy=\"-3\">{}</tspan>", escaped(rest));
        }
    }
    markup
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_ends_at_the_frame_and_what_has_no_place_is_left_out() {
        // one unit of the plane is 29.6 drawing units, and (0, 0) the middle
        let mut sketch = Sketch::new((-5.0, -5.0), (5.0, 5.0));
        sketch.line((0.0, 0.0), (100.0, 0.0), Ink::Ray);
        sketch.line((0.0, 100.0), (1.0, 100.0), Ink::Ray).dot((100.0, 0.0), Ink::Ray);
        sketch.line((f64::NAN, 0.0), (1.0, f64::INFINITY), Ink::Ray).circle((0.0, f64::NAN), 1.0, Ink::Ray);
        assert_eq!(sketch.into_svg(), "<path class=\"ray\" d=\"M240 160L480 160\"/>");
    }

    #[test]
    fn labels_keep_away_from_each_other() {
        let mut sketch = Sketch::new((-5.0, -5.0), (5.0, 5.0));
        let mut free = |aside| sketch.label_where_free((0.0, 0.0), aside, Ink::Quiet, "1");
        assert_eq!(
            [(0.0, 0.0), (5.0, 5.0), (0.0, 14.0), (14.0, 0.0)].map(&mut free),
            [true, false, true, true]
        );
    }

    #[test]
    fn text_stays_text() {
        let mut sketch = Sketch::new((-5.0, -5.0), (5.0, 5.0));
        sketch.label((0.0, 0.0), (0.0, -4.0), Ink::Quiet, "d < r & 'a'");
        let want = "<text class=\"quiet\" x=\"240\" y=\"160\">d &lt; r &amp; &#39;a&#39;</text>";
        assert_eq!(sketch.into_svg(), want);
    }

    #[test]
    fn an_index_stands_lower() {
        let index = |text: &str| format!("<tspan dy=\"3\" font-size=\"0.8em\">{text}</tspan>");
        let back = "<tspan dy=\"-3\"> + u</tspan>";
        assert_eq!(with_indices("p_r + u_r"), ["p", &index("r"), back, &index("r")].concat());
        assert_eq!(with_indices("x_close"), ["x", &index("close")].concat());
        assert_eq!(with_indices("_<"), format!("{}<tspan dy=\"-3\">&lt;</tspan>", index("")));
    }
}

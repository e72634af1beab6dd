//! An SVG document, written by hand: the few elements that a plot needs.

use stage::{Anchor, Color};

use super::pen::{Letters, Stroke};
use super::xml::{escaped, hex, number};

/// A place in the document, x to the right, y downward.
pub(super) type Point = (f64, f64);

/// A document in the making; what is drawn later lies on top.
pub(super) struct Svg {
    text: String,
}

impl Svg {
    /// A white page with a title that a viewer may show or read aloud.
    pub(super) fn new((width, height): (f64, f64), title: &str) -> Svg {
        Svg::scaled((width, height), 1.0, title)
    }

    /// A page like [`new`](Svg::new) that is shown this many times as large.
    pub(super) fn scaled((width, height): (f64, f64), scale: f64, title: &str) -> Svg {
        let shown = (number(width * scale), number(height * scale));
        let (width, height, title) = (number(width), number(height), escaped(title));
        Svg {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" \
                 viewBox=\"0 0 {width} {height}\" \
                 font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n<title>{title}</title>\n\
                 <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n",
                shown.0, shown.1
            ),
        }
    }

    /// Opens a group whose tooltip is `title`; [`close_group`](Svg::close_group) ends it.
    pub(super) fn open_group(&mut self, title: &str) {
        self.text += &format!("<g><title>{}</title>\n", escaped(title));
    }

    pub(super) fn close_group(&mut self) {
        self.text += "</g>\n";
    }

    pub(super) fn line(&mut self, from: Point, to: Point, stroke: Stroke) {
        let [x1, y1, x2, y2] = [from.0, from.1, to.0, to.1].map(number);
        let stroke = stroke.attributes();
        self.text += &format!("<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {stroke}/>\n");
    }

    pub(super) fn polyline(&mut self, points: &[Point], stroke: Stroke) {
        let (points, stroke) = (places(points), stroke.attributes());
        self.text +=
            &format!("<polyline points=\"{points}\" fill=\"none\" stroke-linejoin=\"round\" {stroke}/>\n");
    }

    pub(super) fn area(&mut self, points: &[Point], fill: Color, opacity: f64) {
        let (points, fill, opacity) = (places(points), hex(fill), number(opacity));
        self.text += &format!("<polygon points=\"{points}\" fill=\"{fill}\" fill-opacity=\"{opacity}\"/>\n");
    }

    /// A rectangle from its top left to its bottom right.
    pub(super) fn rectangle(&mut self, from: Point, to: Point, fill: Color, opacity: f64) {
        let [x, y, width, height] = [from.0, from.1, to.0 - from.0, to.1 - from.1].map(number);
        let (fill, opacity) = (hex(fill), number(opacity));
        self.text += &format!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\" \
             fill-opacity=\"{opacity}\"/>\n"
        );
    }

    /// A closed outline, filled or hollow. A hollow one lets what lies below show through, but is seen
    /// by the pointer all over, so that its tooltip is easy to reach.
    pub(super) fn shape(&mut self, points: &[Point], fill: Option<Color>, stroke: Stroke) {
        let (points, fill, stroke) = (places(points), fill_or_none(fill), stroke.attributes());
        self.text += &format!("<polygon points=\"{points}\" {fill} {stroke}/>\n");
    }

    /// A circle, filled or hollow like a [`shape`](Svg::shape).
    pub(super) fn circle(&mut self, center: Point, radius: f64, fill: Option<Color>, stroke: Stroke) {
        let [x, y, radius] = [center.0, center.1, radius].map(number);
        let (fill, stroke) = (fill_or_none(fill), stroke.attributes());
        self.text += &format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {fill} {stroke}/>\n");
    }

    /// A line of text.
    pub(super) fn text(&mut self, place: Point, letters: Letters, text: &str) {
        self.marked_up(place, letters, "", &escaped(text));
    }

    /// A line of text with a white rim, which can be read where lines run under it.
    pub(super) fn text_over_lines(&mut self, place: Point, letters: Letters, text: &str) {
        let rim = format!(
            " stroke=\"{}\" stroke-width=\"5\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
            hex(Color::WHITE)
        );
        self.marked_up(place, letters, &rim, &escaped(text));
    }

    /// A line of text that reads upward.
    pub(super) fn upward_text(&mut self, place: Point, letters: Letters, text: &str) {
        let rotation = format!(" transform=\"rotate(-90 {} {})\"", number(place.0), number(place.1));
        self.marked_up(place, letters, &rotation, &escaped(text));
    }

    /// 10 to a power, with the exponent raised. Raised digits of the font are not relied on: many fonts
    /// lack some of them.
    pub(super) fn power_of_ten(&mut self, place: Point, letters: Letters, exponent: i32) {
        let (rise, size) = (number(0.38 * letters.size), number(0.86 * letters.size));
        let sign = if exponent < 0 { "−" } else { "" };
        let digits = exponent.unsigned_abs();
        let markup = format!("10<tspan dy=\"-{rise}\" font-size=\"{size}\">{sign}{digits}</tspan>");
        self.marked_up(place, letters, "", &markup);
    }

    fn marked_up(&mut self, place: Point, letters: Letters, attributes: &str, markup: &str) {
        let [x, y, size] = [place.0, place.1, letters.size].map(number);
        let fill = hex(letters.color);
        let weight = if letters.bold { " font-weight=\"bold\"" } else { "" };
        let anchor = match letters.anchor {
            Anchor::Left => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::Right => " text-anchor=\"end\"",
        };
        self.text += &format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{fill}\"{weight}{anchor}{attributes}>\
             {markup}</text>\n"
        );
    }

    /// The finished document.
    pub(super) fn finish(self) -> String {
        self.text + "</svg>\n"
    }
}

fn places(points: &[Point]) -> String {
    let places: Vec<String> =
        points.iter().map(|point| format!("{},{}", number(point.0), number(point.1))).collect();
    places.join(" ")
}

fn fill_or_none(fill: Option<Color>) -> String {
    match fill {
        Some(color) => format!("fill=\"{}\"", hex(color)),
        None => "fill=\"none\" pointer-events=\"all\"".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::xml::tests::assert_well_formed;
    use super::*;

    #[test]
    fn text_is_escaped_and_the_document_well_formed() {
        let mut svg = Svg::new((100.0, 50.0), "a < b & \"c\" > 'd'\u{1}");
        svg.open_group("]]> & <g>");
        svg.text((1.0, 2.0), Letters::new(10.0, Color::BLACK), "‖x‖ < r & t ≥ 0");
        svg.power_of_ten((1.0, 2.0), Letters::new(10.0, Color::BLACK).at(Anchor::Right), -16);
        svg.circle((f64::NAN, f64::INFINITY), -f64::INFINITY, None, Stroke::solid(Color::BLUE, 1.0));
        svg.close_group();
        let document = svg.finish();
        assert_well_formed(&document);
        assert!(document.contains("‖x‖ &lt; r &amp; t ≥ 0"));
        assert!(document.contains("a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos;\u{fffd}"));
    }
}

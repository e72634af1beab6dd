//! Numbers, colors and text as XML takes them.

use stage::Color;

/// A color as an attribute takes it.
pub(super) fn hex(Color([r, g, b]): Color) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A hundredth of a pixel is enough. Callers pass finite numbers; were one not, a mark at 0 would be
/// better than a file that no viewer opens.
pub(super) fn number(x: f64) -> String {
    if !x.is_finite() {
        return "0".to_owned();
    }
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The text with XML's own signs written as entities, and what XML does not allow at all replaced.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for sign in text.chars() {
        match sign {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&apos;",
            '\t' | '\n' | '\r' => escaped.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ => escaped.push(sign),
        }
    }
    escaped
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Panics unless every element is closed in its order, every attribute quoted and every `&` the
    /// start of an entity. Enough of XML to catch what an SVG writer gets wrong.
    pub(in crate::plot) fn assert_well_formed(document: &str) {
        let mut open = Vec::new();
        let mut rest = document;
        while let Some((text, after)) = rest.split_once('<') {
            assert_entities(text);
            let (tag, after) = after.split_once('>').expect("a tag ends");
            assert!(!tag.contains('<'), "a tag within a tag: {tag}");
            assert_entities(tag);
            if let Some(name) = tag.strip_prefix('/') {
                assert_eq!(open.pop(), Some(name), "an element is closed that is not the last one opened");
            } else {
                let (tag, is_empty) = tag.strip_suffix('/').map_or((tag, false), |tag| (tag, true));
                let name = tag.split(' ').next().unwrap_or_default();
                assert_eq!(tag.matches('"').count() % 2, 0, "a quote is open: {tag}");
                assert_eq!(tag.matches("=\"").count() * 2, tag.matches('"').count(), "no attribute: {tag}");
                if !is_empty {
                    open.push(name);
                }
            }
            rest = after;
        }
        assert_eq!(
            (open.len(), rest.trim()),
            (0, ""),
            "an element is not closed, or there is text after all"
        );
        for word in ["NaN", "inf"] {
            assert!(!document.contains(&format!("\"{word}")), "a number that is none: {word}");
        }
    }

    fn assert_entities(text: &str) {
        for after in text.split('&').skip(1) {
            let name = after.split(';').next().unwrap_or_default();
            assert!(["amp", "lt", "gt", "quot", "apos"].contains(&name), "not an entity: &{name}");
        }
    }

    #[test]
    #[should_panic(expected = "not the last one opened")]
    fn a_wrong_nesting_is_seen() {
        assert_well_formed("<svg><g></svg></g>");
    }

    #[test]
    fn numbers_are_short() {
        let short = [0.0, -0.001, 1.0, 1.25, -10.126, 100.0].map(number);
        assert_eq!(short, ["0", "0", "1", "1.25", "-10.13", "100"]);
    }
}

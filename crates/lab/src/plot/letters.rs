//! How much room a text takes, and where it breaks.

/// About how wide a text will be, in units of its size times one: the viewer's font is not known, so
/// this is Helvetica's and Arial's widths, by kinds of letters, a little generous.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let letter = |sign| match sign {
        'i' | 'j' | 'l' | '\'' | '|' | ',' | '.' | ':' | ';' | '!' => 0.26,
        ' ' | 'f' | 't' | 'r' | 'I' | '-' | '(' | ')' | '/' | '[' | ']' => 0.34,
        'm' | 'M' | 'w' | 'W' | '%' | '@' | '—' | '…' => 0.88,
        'A'..='Z' => 0.7,
        _ => 0.57,
    };
    text.chars().map(letter).sum::<f64>() * size
}

/// The text in at most `count` lines of at most `limit`, broken at spaces; what is too long ends in an
/// ellipsis.
pub(super) fn wrapped(text: &str, size: f64, limit: f64, count: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= limit => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    let is_cut = lines.len() > count;
    lines.truncate(count);
    if let (Some(line), true) = (lines.last_mut(), is_cut) {
        line.push('…');
    }
    lines.iter().map(|line| cut(line, size, limit)).collect()
}

/// The text as far as it fits; an ellipsis says that it went on.
pub(super) fn cut(text: &str, size: f64, limit: f64) -> String {
    if width(text, size) <= limit {
        return text.to_owned();
    }
    let mut kept = text.trim_end_matches('…').to_owned();
    while !kept.is_empty() && width(&kept, size) + width("…", size) > limit {
        kept.pop();
    }
    kept.trim_end().to_owned() + "…"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_breaks_at_spaces_and_ends_in_an_ellipsis() {
        assert_eq!(wrapped("far away, from 1e2 to 1e8", 10.0, 1000.0, 2), ["far away, from 1e2 to 1e8"]);
        assert_eq!(wrapped("one two three", 10.0, 45.0, 3), ["one two", "three"]);
        assert_eq!(wrapped("one two three four", 10.0, 50.0, 1), ["one two…"]);
        assert_eq!(wrapped("", 10.0, 45.0, 2), Vec::<String>::new());
    }

    #[test]
    fn no_line_is_wider_than_its_limit() {
        for limit in [12.0, 50.0, 90.0, 300.0] {
            for line in
                wrapped("an unbreakableunbreakableword, and what else there is to say", 10.0, limit, 2)
            {
                assert!(width(&line, 10.0) <= limit, "{line}");
            }
        }
    }
}

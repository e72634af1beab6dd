//! The keys that a table may have, and what to write after them.

use super::value::shown;

/// The key of a value, and a value that would do.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    pub(super) name: &'static str,
    pub(super) example: &'static str,
}

/// A key by its name, with a value that would do.
pub(super) const fn key(name: &'static str, example: &'static str) -> Key {
    Key { name, example }
}

impl Key {
    /// `radius = 1.0`; for what has a header, its header: `[camera]`.
    pub(super) fn sample(self) -> String {
        let Key { name, example } = self;
        if self.has_header() { format!("`{example}`") } else { format!("`{name} = {example}`") }
    }

    /// Whether it is written as a header, `[camera]` or `[[object]]`.
    pub(super) fn has_header(self) -> bool {
        self.example.trim_start_matches('[').starts_with(self.name)
    }
}

/// No key is longer, and comparing takes as long as one word times the other.
const LONGEST: usize = 64;

/// The name that somebody may have meant: the most similar one, if it is similar at all.
pub(super) fn meant<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let likeness = |name: &str| strsim::jaro(word, name);
    let comparable = |name: &&str| word.len() <= LONGEST && name.len() <= LONGEST;
    let close = names.into_iter().filter(comparable).filter(|name| likeness(name) > 0.7);
    close.max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
}

/// Names as a sentence has them: `a`, `b` and `c`.
pub(super) fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names: Vec<String> = names.into_iter().map(shown).collect();
    match names.pop() {
        Some(last) if names.is_empty() => last,
        Some(last) => format!("{} and {last}", names.join(", ")),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_near_miss_is_told_from_another_word() {
        let names = ["look_at", "forward", "up", "distance", "color"];
        assert_eq!(meant("lookat", names), Some("look_at"));
        assert_eq!(meant("colour", names), Some("color"));
        assert_eq!(meant("zoom", names), None);
        assert_eq!(meant("", names), None);
        let long = "a".repeat(1 << 20);
        assert_eq!(meant(&long, [&*long]), None);
    }

    #[test]
    fn names_are_listed() {
        assert_eq!(listed(["a", "b", "c"]), "`a`, `b` and `c`");
        assert_eq!((listed(["a"]), listed([])), ("`a`".to_string(), String::new()));
    }
}

//! A value of the file, and what it is wanted as.

use ::toml::Spanned;
use ::toml::de::{DeTable, DeValue};

use super::key::Key;
use super::table::Table;
use crate::source::Spot;
use crate::{At, Error, Place};

/// A value, its key, and where both stand.
#[derive(Clone, Copy)]
pub(super) struct Value<'t> {
    pub(super) spot: Spot<'t>,
    pub(super) key: Key,
    /// Where the key stands; of an item of a list, that of the list.
    pub(super) key_spot: Spot<'t>,
    value: &'t DeValue<'t>,
}

impl<'t> Value<'t> {
    pub(super) fn new(key: Key, key_spot: Spot<'t>, value: &'t Spanned<DeValue<'t>>) -> Value<'t> {
        Value { spot: key_spot.source.spot(value.span()), key, key_spot, value: value.get_ref() }
    }

    /// A finite number; a whole one is as good.
    pub(super) fn number(self) -> Result<f64, Error> {
        let read = match self.value {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(whole) if whole.radix() == 10 => whole.as_str().parse().ok(),
            DeValue::Integer(_) => self.whole().ok().map(|whole| whole as f64),
            _ => return Err(self.not("a number")),
        };
        read.filter(|number: &f64| number.is_finite()).ok_or_else(|| self.impossible("must be finite"))
    }

    /// A whole number.
    pub(super) fn whole(self) -> Result<i64, Error> {
        let DeValue::Integer(whole) = self.value else {
            return Err(self.not("a whole number"));
        };
        let read = i64::from_str_radix(whole.as_str(), whole.radix());
        read.map_err(|_| self.impossible("is too large"))
    }

    /// A string.
    pub(super) fn word(self) -> Result<&'t str, Error> {
        self.value.as_str().ok_or_else(|| self.not("a string"))
    }

    /// One of the words given, as what it stands for.
    pub(super) fn one_of<T: Copy>(self, words: &[(&str, T)]) -> Result<T, Error> {
        let word = self.word()?;
        words.iter().find(|(name, _)| *name == word).map(|(_, meaning)| *meaning).ok_or_else(|| {
            let names: Vec<_> = words.iter().map(|(name, _)| format!("\"{name}\"")).collect();
            let problem = format!("{} is no `{}`", shown(word), self.key.name);
            self.spot.fault(&problem, &format!("write {}", names.join(" or ")))
        })
    }

    /// `true` or `false`.
    pub(super) fn yes(self) -> Result<bool, Error> {
        self.value.as_bool().ok_or_else(|| self.not("`true` or `false`"))
    }

    /// The items of a list.
    pub(super) fn items(self) -> Result<impl ExactSizeIterator<Item = Value<'t>>, Error> {
        let items = self.value.as_array().ok_or_else(|| self.not("a list"))?;
        Ok(items.iter().map(move |item| Value::new(self.key, self.key_spot, item)))
    }

    /// A list of so many items.
    pub(super) fn exactly<const N: usize>(self) -> Result<[Value<'t>; N], Error> {
        let items: Vec<_> = self.items()?.collect();
        let found = items.len();
        items.try_into().map_err(|_| self.impossible(&format!("must have {N} items, and has {found}")))
    }

    /// A table that has none but the keys given.
    pub(super) fn table(self, kind: &'static str, keys: &'static [Key]) -> Result<Table<'t>, Error> {
        Table::new(self.spot, kind, keys, self.entries()?)
    }

    /// A table whose keys are the author's.
    pub(super) fn entries(self) -> Result<&'t DeTable<'t>, Error> {
        self.value.as_table().ok_or_else(|| self.not("a table"))
    }

    /// An entry of a table whose keys are the author's.
    pub(super) fn entry(self, name: &Spanned<impl Sized>, value: &'t Spanned<DeValue<'t>>) -> Value<'t> {
        Value::new(self.key, self.spot.source.spot(name.span()), value)
    }

    /// Something made of this value, with its place.
    pub(super) fn at<T>(self, value: T) -> At<T> {
        At { value, place: self.spot.place }
    }

    /// The place of the key and the value, if one follows the other.
    pub(super) fn whole_place(self) -> Place {
        let (Place { start, end }, value) = (self.key_spot.place, self.spot.place);
        Place { start, end: if value.start >= end { value.end } else { end } }
    }

    /// An error for a value of another type.
    fn not(self, wanted: &str) -> Error {
        let found = match self.value {
            DeValue::String(_) => "a string",
            DeValue::Integer(_) => "a whole number",
            DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "`true` or `false`",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        let problem = format!("{found} stands where `{}` wants {wanted}", self.key.name);
        self.spot.fault(&problem, &format!("write {wanted}, as in {}", self.key.sample()))
    }

    /// An error for a value of the right type that cannot be.
    pub(super) fn impossible(self, why: &str) -> Error {
        let Key { name, .. } = self.key;
        let found = shown(self.spot.text());
        self.spot
            .fault(&format!("`{name}` {why}: {found}"), &format!("write for example {}", self.key.sample()))
    }
}

/// A text for an error: short, in one line, and printable whatever it holds.
pub(crate) fn shown(text: &str) -> String {
    let more = if text.chars().nth(40).is_some() { "…" } else { "" };
    let start: String = text.chars().take(40).collect();
    format!("`{}{more}`", one_line(&start))
}

/// A text in one line: what cannot be printed is escaped.
pub(crate) fn one_line(text: &str) -> String {
    let seen =
        |char: char| if char.is_control() { char.escape_debug().to_string() } else { char.to_string() };
    text.chars().map(seen).collect()
}

//! A table of the file: keys and their values.

use ::toml::de::DeTable;

use super::key::{Key, listed, meant};
use super::value::{Value, shown};
use crate::source::Spot;
use crate::{At, Error};

/// A table whose keys are all known.
#[derive(Clone, Copy)]
pub(super) struct Table<'t> {
    /// Where it stands, or where its header does.
    pub(super) spot: Spot<'t>,
    /// What it describes, for errors: `sphere`, `object`.
    pub(super) kind: &'static str,
    keys: &'static [Key],
    entries: &'t DeTable<'t>,
}

impl<'t> Table<'t> {
    /// A table that has none but the keys given.
    ///
    /// An error at the first key that is not among them, with the one that may have been meant.
    pub(super) fn new(
        spot: Spot<'t>,
        kind: &'static str,
        keys: &'static [Key],
        entries: &'t DeTable<'t>,
    ) -> Result<Table<'t>, Error> {
        let names = || keys.iter().map(|key| key.name);
        let unknown = |name: &str| names().all(|known| known != name);
        let spans = entries.keys().filter(|name| unknown(name.get_ref()));
        let Some(name) = spans.min_by_key(|name| name.span().start) else {
            return Ok(Table { spot, kind, keys, entries });
        };
        let all = match keys {
            [] => format!("there are no keys in this {kind}"),
            _ => format!("the keys of this {kind} are {}", listed(names())),
        };
        let remedy = match meant(name.get_ref(), names()) {
            Some(meant) => match keys.iter().find(|key| key.name == meant) {
                Some(key) if key.has_header() => format!("write {}; {all}", key.sample()),
                _ => format!("write `{meant}`; {all}"),
            },
            None => format!("leave it out; {all}"),
        };
        let problem = format!("unknown key {} in this {kind}", shown(name.get_ref()));
        Err(spot.source.spot(name.span()).fault(&problem, &remedy))
    }

    /// The value of a key, where the table has it.
    pub(super) fn find(&self, name: &str) -> Option<Value<'t>> {
        let key = *self.keys.iter().find(|key| key.name == name)?;
        let (name, value) = self.entries.get_key_value(name)?;
        Some(Value::new(key, self.spot.source.spot(name.span()), value))
    }

    /// The value of a key that must be there.
    pub(super) fn get(&self, name: &str) -> Result<Value<'t>, Error> {
        self.find(name).ok_or_else(|| {
            let sample = self.keys.iter().find(|key| key.name == name).map(|key| key.sample());
            let problem = format!("this {} has no `{name}`", self.kind);
            self.spot.fault(&problem, &format!("write {}", sample.unwrap_or_default()))
        })
    }

    /// What a key says, or a default where it is left out.
    pub(super) fn or<T>(
        &self,
        name: &str,
        default: T,
        read: impl FnOnce(Value<'t>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        self.find(name).map_or(Ok(default), read)
    }

    /// What a key says and where, or a default, whose place is the table's.
    pub(super) fn at_or<T>(
        &self,
        name: &str,
        default: T,
        read: impl FnOnce(Value<'t>) -> Result<T, Error>,
    ) -> Result<At<T>, Error> {
        match self.find(name) {
            Some(value) => Ok(value.at(read(value)?)),
            None => Ok(At { value: default, place: self.spot.place }),
        }
    }
}

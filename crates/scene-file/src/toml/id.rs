//! The ids of the objects.

use std::collections::HashMap;

use super::table::Table;
use super::value::Value;
use crate::Error;
use crate::source::Spot;

/// The ids that are taken, and where.
#[derive(Default)]
pub(super) struct Ids<'t> {
    taken: HashMap<u16, Spot<'t>>,
    /// How many objects there were.
    objects: usize,
}

impl<'t> Ids<'t> {
    /// The id of the next object: what it says, else its place in the file, from 1.
    pub(super) fn next(&mut self, object: &Table<'t>) -> Result<u16, Error> {
        self.objects += 1;
        let said = object.find("id");
        let id = said.map_or(Ok(self.objects as i64), Value::whole)?;
        let Some(id) = u16::try_from(id).ok().filter(|id| *id > 0) else {
            return Err(match said {
                Some(value) => value.impossible("must be 1 to 65535"),
                None => object.spot.fault(
                    "this is the 65536th object, and there are 65535 ids",
                    "write fewer objects; many triangles make a `mesh`, and NFF takes more",
                ),
            });
        };
        let spot = said.map_or(object.spot, |value| value.spot);
        let Some(before) = self.taken.insert(id, spot) else {
            return Ok(id);
        };
        let free = (1..=u16::MAX).find(|id| !self.taken.contains_key(id));
        let remedy = format!("write an id that no other object has, such as `id = {}`", free.unwrap_or(id));
        let problem = match said {
            Some(_) => format!("the id {id} is taken since line {}", before.line()),
            None => {
                format!("the id {id}, this object's place in the file, is taken since line {}", before.line())
            }
        };
        Err(spot.clash(&problem, &remedy, before, "by this object"))
    }
}

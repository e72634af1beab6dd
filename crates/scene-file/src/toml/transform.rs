//! `transform = [ … ]`

use super::key::{Key, key};
use super::table::Table;
use super::value::Value;
use crate::{At, Error, Transform};

const STEP: &[Key] = &[
    key("scale", "[2.0, 1.0, 1.0]"),
    key("rotate", "{ axis = [0, 1, 0], degrees = 30 }"),
    key("translate", "[0.0, 0.0, 5.0]"),
    key("matrix", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
];

const ROTATE: &[Key] = &[key("axis", "[0.0, 1.0, 0.0]"), key("degrees", "30.0")];

/// The steps, in the order written. Whether all of them together can be undone is for whoever composes them.
pub(super) fn transform(value: Value) -> Result<Vec<At<Transform>>, Error> {
    value.items()?.map(|step| Ok(step.at(one_of_four(step.table("step", STEP)?)?))).collect()
}

fn one_of_four(step: Table) -> Result<Transform, Error> {
    let mut there = STEP.iter().filter_map(|key| step.find(key.name));
    let (first, second) = (there.next(), there.next());
    if let Some(second) = second {
        let remedy =
            "write a list of steps of one key each: `[{ scale = [2, 1, 1] }, { translate = [0, 0, 5] }]`";
        return Err(second.key_spot.fault("this step has more than one key, and so no order", remedy));
    }
    let Some(value) = first else {
        return Err(step
            .spot
            .fault("this step does nothing", "write for example `{ translate = [0, 0, 5] }`"));
    };
    match value.key.name {
        "scale" => scale(value),
        "rotate" => {
            let rotate = value.table("rotation", ROTATE)?;
            let axis = rotate.get("axis")?.direction()?;
            Ok(Transform::Rotate { axis, degrees: rotate.get("degrees")?.number()? })
        }
        "translate" => Ok(Transform::Translate(value.numbers()?)),
        _ => {
            let [a, b, c] = value.exactly()?;
            Ok(Transform::Matrix([a.numbers()?, b.numbers()?, c.numbers()?]))
        }
    }
}

fn scale(value: Value) -> Result<Transform, Error> {
    let factors: [f64; 3] = value.numbers()?;
    match factors.contains(&0.0) {
        true => Err(value.impossible("must not have a zero factor, which cannot be undone")),
        false => Ok(Transform::Scale(factors)),
    }
}

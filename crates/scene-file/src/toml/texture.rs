//! `texture = { checker = …, scale = … }` or `texture = { image = …, scale = … }`

use super::key::{Key, key};
use super::value::Value;
use crate::assets::Assets;
use crate::{Error, Texture};

const KEYS: &[Key] =
    &[key("checker", "[[1, 1, 1], [0, 0, 0]]"), key("image", "\"wood.png\""), key("scale", "1.0")];

pub(super) fn texture(value: Value, assets: &mut Assets) -> Result<Texture, Error> {
    let table = value.table("texture", KEYS)?;
    let scale = table.or("scale", 1.0, Value::positive)?;
    match (table.find("checker"), table.find("image")) {
        (Some(value), None) => {
            let [one, other] = value.exactly()?;
            Ok(Texture::Checker { colors: [one.color()?, other.color()?], scale })
        }
        (None, Some(value)) => {
            let picture = assets.picture(value.word()?, value.spot)?;
            Ok(Texture::Image { size: picture.size, pixels: picture.pixels, scale })
        }
        (Some(_), Some(image)) => {
            let remedy = "keep one of the two: `checker` is two colors in turns, `image` is a PNG file";
            Err(image.key_spot.fault("this texture has both `checker` and `image`", remedy))
        }
        (None, None) => {
            let problem = "this texture has neither `checker` nor `image`";
            Err(table
                .spot
                .fault(problem, "write `checker = [[1, 1, 1], [0, 0, 0]]` or `image = \"wood.png\"`"))
        }
    }
}

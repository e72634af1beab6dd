//! The pictures of the stages, as the stages draw them.

use std::collections::BTreeSet;
use std::path::Path;

use stage::{Ask, escaped, write_picture};

use crate::shown;

/// The line that shows a stage's picture: the stage says what it shows.
pub(crate) fn markdown(name: &str) -> Result<String, String> {
    let about = shown::named(name)?.about();
    let said = about.picture.replace(['[', ']'], "");
    let (width, height) = about.size;
    Ok(format!(
        "<figure class=\"picture\">\n<img src=\"pictures/{name}.png\" width=\"{width}\" height=\"{height}\" \
         alt=\"{}\">\n<figcaption>{} Drawn by <code>cargo run -p {name}</code>.</figcaption>\n</figure>\n",
        escaped(&said),
        escaped(&said)
    ))
}

/// Draws the pictures of these stages into a folder, which is made.
pub(crate) fn draw(names: &BTreeSet<String>, folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for name in names {
        let shown = shown::named(name)?.show(&Ask::default()).map_err(|error| error.to_string())?;
        let place = folder.join(name).with_extension("png");
        write_picture(&shown.picture, &place).map_err(|error| error.to_string())?;
    }
    Ok(())
}

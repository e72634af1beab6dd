//! Rows of case files, whatever columns the stage has.

use stage::{About, Stage};

/// The header row with the columns that a stage reads.
pub fn header(stage: &dyn Stage) -> String {
    stage.about().inputs.join(",")
}

/// A row that every stage takes: a ray from the origin, and a thing of ordinary size before it.
pub fn plain_row(stage: &dyn Stage) -> String {
    row_with(stage, "", "")
}

/// The plain row with another text in one of its columns.
pub fn row_with(stage: &dyn Stage, column: &str, text: &str) -> String {
    let about = stage.about();
    let fields = about.inputs.iter().map(|name| if *name == column { text } else { plain(&about, name) });
    fields.collect::<Vec<_>>().join(",")
}

/// An ordinary value for a column, by its name in the contract.
fn plain(about: &About, column: &str) -> &'static str {
    if let Some((_, words)) = about.words.iter().find(|(name, _)| *name == column) {
        return words[0];
    }
    match column {
        "ox" | "oy" | "oz" => "0",
        "width" => "5",
        "height" => "3",
        "left" | "bottom" => "-1",
        "front" => "4",
        "back" => "4.5",
        "cx" | "cy" | "cz" | "px" | "py" | "pz" => "2",
        "ay" | "az" | "bx" | "bz" => "0",
        "a11" | "a22" | "a33" => "2",
        _ => "1",
    }
}

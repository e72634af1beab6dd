//! Case files made for a test, whatever columns the stage has.

use stage::{About, Stage};
use tests::Folder;

use crate::process::run_with_input;

/// The header row with the columns that a stage reads.
pub(crate) fn header(stage: &dyn Stage) -> String {
    stage.about().inputs.join(",")
}

/// A row that every stage takes: a ray from the origin, and a thing of ordinary size before it.
pub(crate) fn plain_row(stage: &dyn Stage) -> String {
    row_with(stage, "", "")
}

/// The plain row with another text in one of its columns.
pub(crate) fn row_with(stage: &dyn Stage, column: &str, text: &str) -> String {
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

/// The result rows of a case file that is in order, without the header row.
pub(crate) fn answers(stage: &dyn Stage, cases: &str) -> Vec<String> {
    let (folder, name) = (Folder::new(), stage.about().name);
    let eval = run_with_input(folder.path(), name, &["eval"], cases.as_bytes());
    assert_eq!((eval.status, eval.errors.as_str()), (0, ""), "{name}:\n{cases}");
    let mut lines = eval.output.lines().map(str::to_string);
    assert_eq!(lines.next(), Some(stage.about().results.join(",")));
    lines.collect()
}

/// The field of a result row by the name of its column; `None` where the stage has no such column.
pub(crate) fn field<'a>(stage: &dyn Stage, row: &'a str, column: &str) -> Option<&'a str> {
    let place = stage.about().results.iter().position(|name| *name == column)?;
    row.split(',').nth(place)
}

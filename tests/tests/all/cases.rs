//! Case files made for a test, whatever columns the stage has.

use stage::Stage;
use tests::Folder;
pub(crate) use tests::{header, plain_row, row_with};

use crate::process::run_with_input;

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

//! `eval`: one result row a case.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;

use crate::case::CaseReader;
use crate::{Ask, Error, Stage};

/// Answers every case of a file, or of standard input, on standard output.
pub(crate) fn eval(
    stage: &dyn Stage,
    ask: &Ask,
    cases: Option<&Path>,
    output: &mut dyn Write,
) -> Result<(), Error> {
    match cases.filter(|path| *path != Path::new("-")) {
        None => answer_cases(stage, ask, io::stdin().lock(), "standard input", output),
        Some(path) => {
            let name = path.display().to_string();
            if path.is_dir() {
                return Err(Error::Request(format!("cannot read {name}: it is a folder; name a CSV file")));
            }
            let file = File::open(path).map_err(|error| {
                let cause = match error.kind() {
                    io::ErrorKind::NotFound => "there is no such file".to_string(),
                    _ => error.to_string(),
                };
                Error::Request(format!("cannot read {name}: {cause}; name a CSV file"))
            })?;
            answer_cases(stage, ask, BufReader::new(file), &name, output)
        }
    }
}

/// Answers every case of a text: a header row, then one row a case, each written as soon as its case is
/// read.
///
/// `name` is what errors call the text. [`Error::Request`] with the place of the fault where the text is no
/// case file of the stage; the rows before it are written then. [`Error::Failed`] where the text cannot be
/// read on, or the output not be written; [`Error::PipeClosed`] where nobody reads the output any more.
pub fn answer_cases(
    stage: &dyn Stage,
    ask: &Ask,
    input: impl BufRead,
    name: &str,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let about = stage.about();
    let mut reader = CaseReader::new(input, name, about.inputs, about.words)?;
    writeln!(output, "{}", about.results.join(",")).map_err(Error::from_output)?;
    while let Some(case) = reader.next()? {
        let row = stage.eval(ask, &case)?;
        writeln!(output, "{}", row.line(about.results)).map_err(Error::from_output)?;
    }
    Ok(())
}

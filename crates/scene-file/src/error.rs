//! What is wrong with a scene, where, and what would be right.

use std::fmt;

use crate::excerpt::render;
use crate::source::Spot;

/// Why a scene could not be read, or not be used.
#[derive(Debug)]
pub struct Error(Box<Report>);

#[derive(Debug)]
struct Report {
    status: u8,
    file: String,
    at: Option<At>,
    problem: String,
    remedy: String,
    rendered: String,
}

/// A place in numbers that a person can use, and what stands there.
#[derive(Debug)]
struct At {
    line: usize,
    column: usize,
    text: String,
}

impl Error {
    /// A file that says what it should not: exit status 2. `also` is another place that has to do with it.
    pub(crate) fn at(spot: Spot, problem: &str, remedy: &str, also: Option<(Spot, &str)>) -> Error {
        let (file, line, column) = (&spot.source.name, spot.line(), spot.source.column(spot.place.start));
        let rendered = render(&format!("{file}:{line}:{column}: {problem}"), spot, remedy, also);
        let at = Some(At { line, column, text: spot.text().to_string() });
        let (file, problem, remedy) = (file.clone(), problem.to_string(), remedy.to_string());
        Error(Box::new(Report { status: 2, file, at, problem, remedy, rendered }))
    }

    /// A file that is none, or none to be read as a scene: exit status 2.
    pub(crate) fn unreadable(file: &str, problem: &str, remedy: &str) -> Error {
        Error::whole(2, file, problem, remedy)
    }

    /// A file that ought to be readable and is not: exit status 1.
    pub(crate) fn failed(file: &str, problem: &str, remedy: &str) -> Error {
        Error::whole(1, file, problem, remedy)
    }

    fn whole(status: u8, file: &str, problem: &str, remedy: &str) -> Error {
        let rendered = format!("cannot read {file}: {problem}; {remedy}");
        let (file, problem, remedy) = (file.to_string(), problem.to_string(), remedy.to_string());
        Error(Box::new(Report { status, file, at: None, problem, remedy, rendered }))
    }

    /// The exit status of the contract: 2 where the request was wrong, 1 where it could not be done.
    pub fn status(&self) -> u8 {
        self.0.status
    }

    /// The name of the file that is to be mended: the scene's, or that of a mesh.
    pub fn file(&self) -> &str {
        &self.0.file
    }

    /// The line, from 1; `None` where no line of the file is to blame.
    pub fn line(&self) -> Option<usize> {
        self.0.at.as_ref().map(|at| at.line)
    }

    /// The column, in characters from 1; `None` where no line of the file is to blame.
    pub fn column(&self) -> Option<usize> {
        self.0.at.as_ref().map(|at| at.column)
    }

    /// What stands there, as far as it stands on one line; empty where no line of the file is to blame.
    pub fn text(&self) -> &str {
        self.0.at.as_ref().map_or("", |at| &at.text)
    }

    /// What is wrong, in one line.
    pub fn problem(&self) -> &str {
        &self.0.problem
    }

    /// What would be right.
    pub fn remedy(&self) -> &str {
        &self.0.remedy
    }
}

/// `FILE:LINE:COLUMN: PROBLEM`, the line with the place marked, and the remedy; where no line is to blame,
/// `cannot read FILE: PROBLEM; REMEDY`. Neither ends with a new line.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.rendered)
    }
}

impl std::error::Error for Error {}

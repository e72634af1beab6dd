//! A transcript for the terminal: columns that line up.

use std::fmt::{self, Display, Formatter};

use crate::{Section, Step, Table, Transcript};

/// Where the page of the notes stands, at the end of a heading.
const WIDTH: usize = 100;

/// The longest cell of a step that the others line up with: a formula fits, a vector of long numbers
/// does not, so that notes stay near their values.
const WIDEST_ALIGNED: usize = 42;

impl Display for Transcript {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (i, section) in self.sections.iter().filter(|section| section.in_text).enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{section}")?;
        }
        Ok(())
    }
}

impl Display for Section {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let gap = WIDTH.saturating_sub(length(&self.title) + length(&self.source)).max(2);
        writeln!(f, "{}", format!("{}{}{}", self.title, " ".repeat(gap), self.source).trim_end())?;
        let cells =
            |step: &Step| [&step.symbol, &step.formula, &step.value.to_text(), &step.note].map(String::clone);
        columns(f, self.steps.iter().map(|step| cells(step).to_vec()).collect(), WIDEST_ALIGNED)?;
        if let Some(table) = &self.table {
            write!(f, "{table}")?;
        }
        for remark in &self.remarks {
            writeln!(f, "  {remark}")?;
        }
        Ok(())
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let rows =
            self.rows.iter().take(self.in_text).map(|row| row.iter().map(|value| value.to_text()).collect());
        columns(f, std::iter::once(self.columns.clone()).chain(rows).collect(), usize::MAX)
    }
}

/// Writes lines of cells, each column as wide as its widest cell of at most `widest_aligned` signs. A
/// wider one pushes the rest of its own line only.
fn columns(f: &mut Formatter<'_>, lines: Vec<Vec<String>>, widest_aligned: usize) -> fmt::Result {
    let count = lines.iter().map(Vec::len).max().unwrap_or(0);
    let widest = |column: usize| {
        let cells = lines.iter().filter_map(|line| line.get(column));
        cells.map(|cell| length(cell)).filter(|&length| length <= widest_aligned).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..count).map(widest).collect();
    for line in &lines {
        let mut text = String::new();
        for (cell, width) in line.iter().zip(&widths) {
            text.push_str("  ");
            text.push_str(cell);
            text.push_str(
                &" ".repeat(width.saturating_sub(length(cell)) + usize::from(!cell.is_empty() || *width > 0)),
            );
        }
        writeln!(f, "{}", text.trim_end())?;
    }
    Ok(())
}

/// How many columns of a terminal a text takes: every sign the notes use takes one, and the marks
/// above a letter (p̄, d⃗) none.
fn length(text: &str) -> usize {
    let is_mark = |sign: &char| matches!(sign, '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}');
    text.chars().filter(|sign| !is_mark(sign)).count()
}

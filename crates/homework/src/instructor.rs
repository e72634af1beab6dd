//! What a lecturer wants to know of each exercise, as a page of the book.

use exercise::Case;

use crate::{Catalog, Exercise};

/// The page: a table of all exercises, and a section each.
pub(crate) fn page(catalog: &Catalog) -> String {
    let mut text = HEAD.to_string();
    for exercise in &catalog.exercises {
        let it = &exercise.manifest;
        let anchor = it.name.replace('/', "");
        let (points, mistakes) = (exercise.points(), exercise.mistakes.len());
        text += &format!(
            "| [{}](#{anchor}) | {} | {} | {points} | {mistakes} | {} |\n",
            it.name,
            cell(&it.page),
            it.minutes,
            cell(&it.title)
        );
    }
    let minutes: u32 = catalog.exercises.iter().map(|it| it.manifest.minutes).sum();
    text += &format!(
        "\nExercises: {}; hours, together: about {}.\n",
        catalog.exercises.len(),
        minutes.div_ceil(60)
    );
    text + &catalog.exercises.iter().map(section).collect::<String>()
}

const HEAD: &str = "\
# For the lecturer: every exercise

This page holds answers: it is not for students. It is written by

```sh
cargo run -- exercise list --format instructor > book/src/instructor.md
```

How to set, collect and grade them is in [Exercises in a course](exercises.md).

| exercise | the notes | minutes | points | known mistakes | what is to be done |
| --- | --- | --- | --- | --- | --- |
";

fn section(exercise: &Exercise) -> String {
    let it = &exercise.manifest;
    let (question, answer) = &it.predict;
    let mut text = format!(
        "\n## {}\n\n*{}* · {} · about {} minutes\n\n**Teaches.** {}\n\n**Predict, then run.** {question}\n\n\
         **Answer.** {answer}\n\n**Expected misconceptions.** `check` and `grade` name them by what they \
         do.\n\n",
        it.name,
        it.title,
        it.page,
        it.minutes,
        one(&it.teaches)
    );
    for known in &exercise.mistakes {
        text += &format!("- `{}`: {}\n", known.name, one(&known.says));
    }
    text += "\n**Graded by** these cases, of which a student is shown the first of each property.\n\n\
             | property | points | shown | hidden |\n| --- | --- | --- | --- |\n";
    for property in &it.properties {
        let case = |numbers: &Vec<f64>| cell(&Case::new(&it.columns, numbers).to_string());
        let mut cases = property.cases.iter().map(case);
        let shown = cases.next().unwrap_or_default();
        let hidden = cases.collect::<Vec<_>>().join("<br>");
        text += &format!("| {} | {} | {shown} | {hidden} |\n", cell(&property.name), property.points);
    }
    if let Some(method) = &it.method {
        text += &format!(
            "\nIt is a method of `{}`: once it is right, `check DIR --trade` measures the student's \
             `{method}` beside the others.\n",
            it.chapter
        );
    }
    text
}

/// A text in a line.
fn one(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text in a cell of a table.
fn cell(text: &str) -> String {
    one(text).replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every case is there, written as the program writes it, and the ones that are not shown apart.
    #[test]
    fn the_page_has_every_case() {
        let catalog = Catalog::read().unwrap();
        for exercise in &catalog.exercises {
            let (it, text) = (&exercise.manifest, section(exercise));
            for asked in &it.properties {
                let row = format!("| {} | {} | ", cell(&asked.name), asked.points);
                let row = text.lines().find_map(|line| line.strip_prefix(&row)).unwrap();
                let (shown, hidden) = row.trim_end_matches(" |").split_once(" | ").unwrap();
                let cases: Vec<String> =
                    asked.cases.iter().map(|numbers| Case::new(&it.columns, numbers).to_string()).collect();
                assert_eq!(shown, cases[0], "{}", it.name);
                assert_eq!(hidden.split("<br>").collect::<Vec<_>>(), cases[1..], "{}", it.name);
            }
        }
    }
}

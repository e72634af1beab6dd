//! The values of a figure in two tables: the answers of all methods, and the steps of one.

use math::{Degenerate, Real};
use stage::figure::Figure;
use stage::{Section, escaped};

/// What each method answers, and the steps of one, `f64` beside `f32`: HTML. The answers come first: they are what one
/// looks at while something is dragged.
pub fn values<F: Figure>(figure: &F, method: usize) -> String {
    let name = F::methods().get(method).copied().unwrap_or_default();
    let mut text =
        format!("<h4>What each method answers</h4>{}<h4>The steps of {name}</h4>", answers(figure));
    match (figure.steps::<f64>(method), figure.steps::<f32>(method)) {
        (Ok(in_f64), Ok(in_f32)) => text += &steps(&in_f64, &in_f32),
        (Err(why), Err(_)) => text += &no_answer("", why),
        // what is decided exactly is decided of the numbers as they are, and those of f32 are others
        (Ok(in_f64), Err(why)) => {
            text += &(steps(&in_f64, &Section::new("", "")) + &no_answer(" in f32", why))
        }
        (Err(why), Ok(in_f32)) => {
            text += &(no_answer(" in f64", why) + &steps(&Section::new("", ""), &in_f32))
        }
    }
    text
}

fn no_answer(precision: &str, why: Degenerate) -> String {
    format!("<p>There is no answer{precision}: {}.</p>", escaped(&why.to_string()))
}

/// The rows of both precisions side by side. Where they part, each says its own: a digit more can be another
/// verdict, and other steps follow.
fn steps(in_f64: &Section, in_f32: &Section) -> String {
    let mut rows = String::new();
    let most = in_f64.steps.len().max(in_f32.steps.len());
    let mut parted = false;
    for place in 0..most {
        let (wide, narrow) = (in_f64.steps.get(place), in_f32.steps.get(place));
        let is_same =
            matches!((wide, narrow), (Some(a), Some(b)) if a.symbol == b.symbol && a.formula == b.formula);
        parted |= !is_same;
        if is_same {
            if let (Some(wide), Some(narrow)) = (wide, narrow) {
                let note = if wide.note == narrow.note {
                    wide.note.clone()
                } else {
                    format!("f64: {}; f32: {}", wide.note, narrow.note)
                };
                let values = [wide.value.to_text(), narrow.value.to_text()];
                rows += &row([&wide.symbol, &wide.formula], [&values[0], &values[1]], &note);
            }
            continue;
        }
        if let Some(step) = wide {
            rows += &row([&step.symbol, &step.formula], [&step.value.to_text(), ""], &step.note);
        }
        if let Some(step) = narrow {
            rows += &row([&step.symbol, &step.formula], ["", &step.value.to_text()], &step.note);
        }
    }
    let both = !in_f64.steps.is_empty() && !in_f32.steps.is_empty();
    let remark = if parted && both {
        "<p>The two precisions decide otherwise, and go on by other steps.</p>"
    } else {
        ""
    };
    table("steps", ["symbol", "formula", "f64", "f32", "what it says"], &rows) + remark
}

fn row([symbol, formula]: [&str; 2], [wide, narrow]: [&str; 2], note: &str) -> String {
    let [symbol, formula, wide, narrow, note] = [symbol, formula, wide, narrow, note].map(escaped);
    let values = format!("<td>{wide}</td><td>{narrow}</td>");
    format!("<tr><th scope=\"row\">{symbol}</th><td>{formula}</td>{values}<td>{note}</td></tr>")
}

fn answers<F: Figure>(figure: &F) -> String {
    let mut rows = String::new();
    for (method, name) in F::methods().into_iter().enumerate() {
        let [wide, narrow] = [answer::<F, f64>(figure, method), answer::<F, f32>(figure, method)];
        rows += &format!("<tr><th scope=\"row\">{name}</th><td>{wide}</td><td>{narrow}</td></tr>");
    }
    table("answers", ["method", "f64", "f32"], &rows)
}

/// A table that scrolls by itself where it is wide.
fn table<const N: usize>(name: &str, columns: [&str; N], rows: &str) -> String {
    let head: String = columns.iter().map(|column| format!("<th>{column}</th>")).collect();
    format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{name}\">\
         <table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>"
    )
}

fn answer<F: Figure, R: Real>(figure: &F, method: usize) -> String {
    escaped(&figure.answer::<R>(method))
}

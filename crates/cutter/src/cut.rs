//! Regions of a file, and what is put in their place.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::spanned::Spanned;

/// What takes the place of a region.
#[derive(Clone, Debug, PartialEq)]
pub enum Filling {
    /// `todo!` with the region's question.
    Question,
    /// `todo!` that asks nothing: the region is another exercise's.
    Hidden,
    /// Other lines.
    Lines(String),
}

/// A region: its name, its question, and its lines, from the one after `// exercise` to that before
/// `// end`.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// `t_close`
    pub name: String,
    /// "How far along the ray …?"
    pub question: String,
    /// The lines.
    pub lines: String,
}

/// The regions of a text, in order. `Err` says which mark has no other, or comes twice.
pub fn regions(text: &str) -> Result<Vec<Region>, String> {
    let mut regions: Vec<Region> = Vec::new();
    let mut open = false;
    for line in text.lines() {
        match mark(line) {
            Some(Mark::Begin(name, question)) => {
                if open || regions.iter().any(|region| region.name == name) {
                    return Err(format!("`// exercise {name}` comes twice, or within another"));
                }
                let (name, question) = (name.to_string(), question.to_string());
                regions.push(Region { name, question, lines: String::new() });
                open = true;
            }
            Some(Mark::End(name)) => {
                if !open || regions.last().is_none_or(|region| region.name != name) {
                    return Err(format!("`// end {name}` ends nothing"));
                }
                open = false;
            }
            None if open => {
                if let Some(region) = regions.last_mut() {
                    region.lines += line;
                    region.lines += "\n";
                }
            }
            None => {}
        }
    }
    match regions.last().filter(|_| open) {
        Some(region) => Err(format!("`// exercise {}` has no end", region.name)),
        None => Ok(regions),
    }
}

enum Mark<'a> {
    Begin(&'a str, &'a str),
    End(&'a str),
}

fn mark(line: &str) -> Option<Mark<'_>> {
    let comment = line.trim_start();
    if let Some(rest) = comment.strip_prefix("// exercise ") {
        let (name, question) = rest.split_once(": ")?;
        return Some(Mark::Begin(name, question.trim()));
    }
    let name = comment.strip_prefix("// end ")?;
    (!name.contains(' ')).then_some(Mark::End(name))
}

/// The text with the named regions filled, and without the marks of any. A region that is not named stays as
/// it is. `Err` where a name is that of no region, where marks are wrong as [`regions`] says, and where a
/// region that is to ask has something else in it than `let`s and expressions.
pub fn cut(text: &str, fillings: &BTreeMap<String, Filling>) -> Result<String, String> {
    let regions = regions(text)?;
    if let Some(name) = fillings.keys().find(|&name| regions.iter().all(|region| region.name != *name)) {
        return Err(format!("there is no `// exercise {name}`"));
    }
    let mut regions = regions.into_iter();
    let (mut result, mut filled) = (String::new(), false);
    for line in text.lines() {
        match mark(line) {
            Some(Mark::Begin(..)) => {
                let Some(region) = regions.next() else { continue };
                if let Some(filling) = fillings.get(&region.name) {
                    let indent = &line[..line.len() - line.trim_start().len()];
                    let lines = match filling {
                        Filling::Question => holes(&region, &region.question)?,
                        Filling::Hidden => holes(&region, HIDDEN)?,
                        Filling::Lines(lines) => lines.clone(),
                    };
                    result += &indented(&lines, indent);
                    filled = true;
                }
            }
            Some(Mark::End(_)) => filled = false,
            None if filled => {}
            None => {
                result += line;
                result += "\n";
            }
        }
    }
    Ok(result)
}

/// Lines moved to an indent, whatever theirs is.
fn indented(lines: &str, indent: &str) -> String {
    let blank = |line: &&str| !line.trim().is_empty();
    let least = lines.lines().filter(blank).map(|line| line.len() - line.trim_start().len()).min();
    let moved = |line: &str| match line.trim().is_empty() {
        true => "\n".to_string(),
        false => format!("{indent}{}\n", &line[least.unwrap_or(0)..]),
    };
    lines.lines().map(moved).collect()
}

/// What stands in place of another exercise's region.
const HIDDEN: &str = "nothing is to be done here: this belongs to another exercise";

/// The region with a question in place of each value: what it binds is bound still, so that the rest
/// compiles. Where several values share the question they are numbered, "(1 of 3)".
fn holes(region: &Region, question: &str) -> Result<String, String> {
    let (text, block) = block(region)?;
    let mut lines = String::new();
    let asks = |it: &&syn::Stmt| matches!(it, syn::Stmt::Local(local) if local.init.is_some());
    let (of, mut asked) = (block.stmts.iter().filter(asks).count(), 0);
    // {:?} would take letters apart from their accents
    let question = question.replace('\\', "\\\\").replace('"', "\\\"");
    let whole = format!("todo!(\"{question}\")");
    let indent = |start: usize| &text[text[..start].rfind('\n').map_or(0, |at| at + 1)..start];
    // after a last expression nothing needs what is bound before it
    let value = block.stmts.last().is_some_and(is_value);
    for (place, statement) in block.stmts.iter().enumerate() {
        match statement {
            syn::Stmt::Local(_) if value => {}
            syn::Stmt::Local(local) => {
                let Some(init) = &local.init else { continue };
                let (whole, value) = (range(local.span()), range(init.expr.span()));
                // without its comments: they may give the answer away
                lines += indent(whole.start);
                asked += 1;
                lines += &text[whole.start..value.start];
                lines += &match of {
                    1 => format!("todo!(\"{question}\")"),
                    _ => format!("todo!(\"{question} ({asked} of {of})\")"),
                };
                lines += &text[value.end..whole.end];
                lines += "\n";
            }
            syn::Stmt::Expr(_, None) if value && place + 1 == block.stmts.len() => {
                lines += &format!("{}{whole}\n", indent(range(statement.span()).start));
                asked += 1;
            }
            syn::Stmt::Expr(..) => {}
            _ => return Err(format!("region {}: only `let`s and expressions can be asked for", region.name)),
        }
    }
    if asked == 0 {
        lines = format!("{whole};\n");
    }
    Ok(lines)
}

/// Whether a statement is an expression with a value, and not an `if` without an `else` or a loop.
fn is_value(statement: &syn::Stmt) -> bool {
    match statement {
        syn::Stmt::Expr(syn::Expr::If(it), None) => it.else_branch.is_some(),
        syn::Stmt::Expr(it, None) => !matches!(it, syn::Expr::ForLoop(_) | syn::Expr::While(_)),
        _ => false,
    }
}

/// The statements of a region, of a `let` the value alone, each without white space and comments: what no
/// hand-out may contain. `Err` where the lines are no Rust.
pub fn statements(region: &Region) -> Result<Vec<String>, String> {
    let (text, block) = block(region)?;
    let parts = block.stmts.iter().map(|statement| match statement {
        syn::Stmt::Local(syn::Local { init: Some(init), .. }) => init.expr.span(),
        other => other.span(),
    });
    Ok(parts.map(|span| squeezed(&text[range(span)])).collect())
}

/// A text without `//` comments and white space, to be compared with others. What follows `//` within a
/// string is taken for a comment too.
pub fn squeezed(text: &str) -> String {
    let code = text.lines().map(|line| line.split_once("//").map_or(line, |(code, _)| code));
    code.flat_map(str::chars).filter(|sign| !sign.is_whitespace()).collect()
}

fn block(region: &Region) -> Result<(String, syn::Block), String> {
    let text = format!("{{\n{}}}", region.lines);
    let block = syn::parse_str(&text).map_err(|error| format!("region {}: {error}", region.name))?;
    Ok((text, block))
}

fn range(span: Span) -> std::ops::Range<usize> {
    span.byte_range()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "fn d(x: f64) -> f64 {\n    // exercise twice: What is twice x?\n    // that is 2 x\n    \
                        let y: f64 = x + x; // twice\n    let Some(z) = Some(y)\n        else { return 0.0 };\n    \
                        // end twice\n    // exercise less: And one less?\n    z - 1.0\n    // end less\n}\n";

    fn filled(pairs: &[(&str, Filling)]) -> Result<String, String> {
        cut(TEXT, &pairs.iter().map(|(name, filling)| (name.to_string(), filling.clone())).collect())
    }

    #[test]
    fn what_is_bound_is_bound_still_and_comments_are_gone() {
        let text = filled(&[("twice", Filling::Question)]).unwrap();
        let expected = "fn d(x: f64) -> f64 {\n    let y: f64 = todo!(\"What is twice x? (1 of 2)\");\n    \
                        let Some(z) = todo!(\"What is twice x? (2 of 2)\")\n        else { return 0.0 };\n    z - 1.0\n}\n";
        assert_eq!(text, expected);
        let text = filled(&[("less", Filling::Question)]).unwrap();
        assert!(text.contains("    todo!(\"And one less?\")\n}"), "{text}");
        assert!(text.contains("    // that is 2 x\n    let y: f64 = x + x; // twice\n"), "{text}");
        let text = filled(&[("less", Filling::Hidden)]).unwrap();
        assert!(
            text.contains("todo!(\"nothing is to be done here") && !text.contains("And one less?"),
            "{text}"
        );
    }

    #[test]
    fn where_a_region_is_a_value_one_question_is_enough() {
        let hole = |lines: &str| {
            holes(&Region { name: "a".into(), question: String::new(), lines: lines.into() }, "b?").unwrap()
        };
        assert_eq!(hole("    let a = 1;\n    a + 1\n"), "    todo!(\"b?\")\n");
        let region = Region { name: "a".into(), question: String::new(), lines: "a\n".into() };
        assert_eq!(holes(&region, "p̄ \"b\"?").unwrap(), "todo!(\"p̄ \\\"b\\\"?\")\n");
    }

    /// What is asked for is the body's value, or that the body ends; nothing of the way there is given.
    #[test]
    fn a_whole_body_is_one_question() {
        let hole = |body: &str| {
            let text = format!("fn f() {{\n    // exercise a: b?\n    {body}\n    // end a\n}}\n");
            cut(&text, &[("a".to_string(), Filling::Question)].into_iter().collect()).unwrap()
        };
        assert_eq!(hole("let y = 2.0 * x;\n    y + 1.0"), "fn f() {\n    todo!(\"b?\")\n}\n");
        assert_eq!(hole("if x { return None; }"), "fn f() {\n    todo!(\"b?\");\n}\n");
        assert_eq!(hole("if x { 1 } else { 2 }"), "fn f() {\n    todo!(\"b?\")\n}\n");
        let bound = "let y = 2.0 * x;\n    if y > 1.0 { return None; }";
        assert_eq!(hole(bound), "fn f() {\n    let y = todo!(\"b?\");\n}\n");
    }

    #[test]
    fn other_lines_take_the_place_at_its_indent() {
        let lines = Filling::Lines("  let y = 2.0 * x;\n  {\n    z\n  }".into());
        let text = filled(&[("less", lines)]).unwrap();
        assert!(text.contains("    let y = 2.0 * x;\n    {\n      z\n    }\n}"), "{text}");
        assert!(!text.contains("exercise"), "{text}");
    }

    #[test]
    fn marks_that_do_not_fit_are_refused() {
        for (text, cause) in [
            ("// exercise a: b\n// exercise c: d\n", "within another"),
            ("// exercise a: b\n", "has no end"),
            ("// end a\n", "ends nothing"),
            ("// exercise a: b\n// end c\n", "ends nothing"),
            ("// exercise a: b\n// end a\n// exercise a: b\n// end a\n", "comes twice"),
        ] {
            assert!(regions(text).unwrap_err().contains(cause), "{text}");
        }
        assert!(filled(&[("thrice", Filling::Question)]).unwrap_err().contains("no `// exercise thrice`"));
        assert_eq!(regions("// end of it all\n"), Ok(Vec::new()), "a sentence is no mark");
    }

    #[test]
    fn a_solution_is_known_however_it_is_spaced() {
        let regions = regions(TEXT).unwrap();
        assert_eq!(statements(&regions[0]).unwrap(), ["x+x", "Some(y)"]);
        assert_eq!(statements(&regions[1]).unwrap(), [squeezed("z -\n 1.0 // one less")]);
    }
}

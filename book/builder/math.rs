//! Mathematics between dollar signs, made into elements that KaTeX draws.

/// A line of a page in which `$…$` is an element of class `math`, and `$$…$$` one that stands by itself.
///
/// What stands in backquotes stays as it is. A dollar sign alone on its line is a dollar sign.
pub(crate) fn line(text: &str) -> String {
    let (mut result, mut rest) = (String::new(), text);
    while let Some(at) = rest.find(['`', '$']) {
        result += &rest[..at];
        rest = &rest[at..];
        let fence = run(rest);
        let (start, inside) = rest.split_at(fence.len());
        let Some(end) = inside.find(fence) else {
            result += start;
            rest = inside;
            continue;
        };
        let (inside, after) = (&inside[..end], &inside[end + fence.len()..]);
        match fence {
            "$" => result += &format!("<span class=\"math\">{}</span>", entities(inside)),
            "$$" => result += &format!("<span class=\"math display\">{}</span>", entities(inside)),
            _ => result += &[fence, inside, fence].concat(),
        }
        rest = after;
    }
    result + rest
}

/// The run of one sign that a text starts with.
fn run(text: &str) -> &str {
    let first = text.chars().next();
    let end = text.find(|sign| Some(sign) != first).unwrap_or(text.len());
    &text[..end]
}

/// A text in which Markdown finds nothing to read: every sign of its own is an entity.
fn entities(text: &str) -> String {
    let one = |sign: char| match sign {
        sign if sign.is_ascii_punctuation() => format!("&#{};", sign as u32),
        sign => sign.to_string(),
    };
    text.trim().chars().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_is_an_element() {
        assert_eq!(line("that $t_1 < r$ is"), "that <span class=\"math\">t&#95;1 &#60; r</span> is");
        assert_eq!(line("$$a^2$$"), "<span class=\"math display\">a&#94;2</span>");
        assert_eq!(line("| $|x|$ | b |"), "| <span class=\"math\">&#124;x&#124;</span> | b |");
    }

    #[test]
    fn code_and_lone_dollars_stay() {
        for text in ["`a $b$ c` d", "``a ` $b$``", "it costs 5 $", "no math", "an open ` and all"] {
            assert_eq!(line(text), text);
        }
        assert_eq!(line("`$` $x$"), "`$` <span class=\"math\">x</span>");
    }
}

//! Formulas in comments, to be found again however they are written.

/// The comments of a file, each a line: `//`, `///` and `//!`, those that go on in the next line together.
pub fn comments(text: &str) -> String {
    let (mut all, mut before) = (String::new(), false);
    for line in text.lines() {
        let said = line.split_once("//").map(|(_, said)| said.trim_start_matches(['/', '!']).trim());
        // a comment goes on where nothing else is in its line
        let goes_on = before && line.trim_start().starts_with("//") && said != Some("");
        if let Some(said) = said {
            all += if goes_on { " " } else { "\n" };
            all += said;
        }
        before = said.is_some_and(|said| !said.is_empty());
    }
    all
}

/// A formula in one way of writing: without white space, accents, parentheses, signs of multiplication
/// between numbers, and what Rust adds to the page (`self.`, `R::from`). Both `a.dot(b)` and "a⃗ · b⃗" are
/// "a·b".
pub fn plain(text: &str) -> String {
    let mut text =
        text.replace(".dot(", "·").replace("R::cross(", "").replace("R::from(", "").replace("self.", "");
    for (sign, plain) in [("−", "-"), ("λ", "lambda"), ("α", "alpha"), ("β", "beta"), ("½", "0.5")] {
        text = text.replace(sign, plain);
    }
    let accent =
        |sign: char| ('\u{300}'..='\u{36f}').contains(&sign) || ('\u{20d0}'..='\u{20ff}').contains(&sign);
    let dropped = |sign: char| sign.is_whitespace() || accent(sign) || "()*`\"".contains(sign);
    text.chars().filter(|&sign| !dropped(sign)).flat_map(char::to_lowercase).collect()
}

/// What is shorter, in its plain form, says nothing.
const SHORT: usize = 5;

/// The parts of a text that are formulas, in their plain form: what stands between the signs that end a
/// clause and has something in it that is worked out.
pub fn formulas(text: &str) -> Vec<String> {
    let ends = |sign: char| matches!(sign, ',' | ';' | ':' | '=' | '\n' | '"' | '`') || sign == '→';
    let clauses = text.split(ends).flat_map(|clause| clause.split(". "));
    let clauses = clauses.map(|clause| clause.trim().trim_end_matches('.'));
    clauses.filter(|clause| is_formula(clause)).map(plain).filter(|it| it.chars().count() >= SHORT).collect()
}

/// Whether a clause works something out, and has no words in it.
fn is_formula(clause: &str) -> bool {
    let works = clause.chars().any(|sign| "+−·×/²√‖≤≥".contains(sign)) || clause.contains("adj");
    let is_word = |word: &str| word.len() > 3 && word.chars().all(|sign| sign.is_ascii_alphabetic());
    works && !clause.split_whitespace().any(is_word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_found_in_words() {
        let text = "A = d_x² + d_y², for the cone − ¼ d_z²";
        assert_eq!(formulas(text), ["d_x²+d_y²"]);
        assert_eq!(formulas("m⃗_s = −2 (d⃗·n⃗) n⃗ + d⃗, as long as d⃗."), ["-2d·nn+d"]);
        assert_eq!(formulas("t in [t_min, t_max]; nothing/else matters here"), [""; 0]);
    }

    #[test]
    fn code_and_page_are_alike() {
        assert_eq!(plain("P · e1"), plain("p.dot(e1)"));
        assert_eq!(plain("−d⃗·n⃗"), plain("-d.dot(n)"));
        assert_eq!(plain("α ≥ 0"), "alpha≥0");
    }

    #[test]
    fn a_comment_goes_on_in_the_next_line() {
        let text = "/// a +\n/// b\nx; // c\n\n//! d\n//!\n//! e\n";
        assert_eq!(comments(text), "\na + b\nc\nd\n\ne");
    }
}

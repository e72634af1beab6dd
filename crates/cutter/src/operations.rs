//! What a hand-out says of the operations there are: Rust's own for `R` are few, and nobody is to guess
//! names.

use crate::Manifest;

/// Where a file has the first, the second is said.
const LINES: [(&str, &str); 6] = [
    (
        "R: Real",
        "- Numbers are of a type `R`, which is `f64` here and might be `f32`: `x + y`, `x - y`, `x * y`, \
         `x / y`, `-x`, `x < y`, `x == y`, `x.sqrt()`, `x.is_finite()`. A constant is `R::from(0.5)`, or \
         `R::round_from(0.1)` where an `f32` would not hold all its digits. There is no `abs`, `min` or `max`: compare.",
    ),
    (
        "R: Real",
        "- Points and vectors: `a + b`, `a - b`, `-a`, `a * x` and `a / x` (the number comes second), \
         `a.dot(b)`, `a.length()`, `a.normalized()` (length 1), `a.is_zero()`.",
    ),
    ("Vec3", "- In space: `R::vec3(x, y, z)`, `R::cross(a, b)`, `let [x, y, z] = R::xyz(a);`."),
    ("Ray2", "- In the plane: `R::vec2(x, y)`, `a.x()`, `a.y()`."),
    ("Ray", "- A ray: `ray.origin`, `ray.direction`, `ray.at(t)`."),
    ("Span", "- A span of t: `span.contains(t)` (the ends belong to it), `span.min`, `span.max`."),
];

/// The section about them for a file with holes, and what its exercise has of its own; empty where there is
/// nothing to say.
pub(crate) fn of(manifest: &Manifest, file: &str) -> String {
    section(if manifest.generic { file } else { "" }, &manifest.tools)
}

fn section(file: &str, tools: &[String]) -> String {
    let common = LINES.iter().filter(|(sign, _)| file.contains(sign)).map(|(_, line)| line.to_string());
    let lines: Vec<String> = common.chain(tools.iter().map(|tool| format!("- {tool}."))).collect();
    match lines.is_empty() {
        true => String::new(),
        false => format!("## What there is to work with\n\n{}\n\n", lines.join("\n")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function that is named is one of `math`.
    #[test]
    fn what_is_named_is_there() {
        let math: String = ["real", "ray", "span"]
            .map(|file| {
                let path = format!("{}/../math/src/{file}.rs", env!("CARGO_MANIFEST_DIR"));
                std::fs::read_to_string(path).unwrap()
            })
            .concat();
        let mut count = 0;
        for (_, line) in LINES {
            let code = line.split('`').skip(1).step_by(2);
            for call in code.flat_map(|code| code.split_inclusive('(').filter(|it| it.ends_with('('))) {
                let name = call
                    .trim_end_matches('(')
                    .rsplit(|sign: char| !sign.is_alphanumeric() && sign != '_')
                    .next();
                let name = name.unwrap();
                count += 1;
                assert!(name == "from" || math.contains(&format!("fn {name}")), "{name} of {line}");
            }
        }
        assert!(count >= 12, "{count}");
    }

    #[test]
    fn only_what_is_of_use_is_said() {
        assert_eq!(section("fn f(x: f64) {}", &[]), "");
        let text = section("fn f<R: Real>(ray: Ray2<R>)", &["`f(x)`: more".to_string()]);
        assert!(text.contains("R::vec2") && !text.contains("R::vec3"), "{text}");
        assert!(text.ends_with("- `f(x)`: more.\n\n"), "{text}");
    }
}

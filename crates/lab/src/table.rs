//! Tables as `trade` prints them.

/// Lines of cells, as many in each, the heads first, in columns as wide as the widest: the first two are
/// names and stand to the left, numbers to the right. `starred` says of each line after the heads whether it
/// gets a ★; a line that it says nothing of is left out.
pub fn aligned(lines: &[Vec<String>], starred: &[bool]) -> String {
    let columns = lines.first().map_or(0, Vec::len);
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let stars = std::iter::once(&false).chain(starred);
    let mut text = String::new();
    for (line, &star) in lines.iter().zip(stars) {
        text += if star { "★ " } else { "  " };
        let padded = line.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| match column {
            0 | 1 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        text += padded.collect::<Vec<_>>().join("  ").trim_end();
        text += "\n";
    }
    text
}

/// The same of heads and lines, each line with whether it is starred.
pub fn under(heads: &[&str], lines: impl Iterator<Item = (Vec<String>, bool)>) -> String {
    let (lines, starred): (Vec<Vec<String>>, Vec<bool>) = lines.unzip();
    let heads = heads.iter().map(|head| head.to_string()).collect();
    let lines: Vec<Vec<String>> = std::iter::once(heads).chain(lines).collect();
    aligned(&lines, &starred)
}

/// Three digits of a number that is not negative: 4.71, 47.1, 471. Below 1 it is two decimals (0.05), from
/// 1000 on all digits before the point (4712). – for what is not finite.
pub fn three_digits(x: f64) -> String {
    match x {
        _ if !x.is_finite() => "–".to_string(),
        ..9.995 => format!("{x:.2}"),
        ..99.95 => format!("{x:.1}"),
        _ => format!("{x:.0}"),
    }
}

/// A count: as it is up to a million, above that as a power of ten.
pub fn short(count: f64) -> String {
    if count < 1e6 { format!("{count:.0}") } else { small(count) }
}

/// A number of any size to two digits, zero as 0, infinity as ∞, NaN as NaN.
pub fn small(x: f64) -> String {
    match x {
        0.0 => "0".to_string(),
        _ if !x.is_finite() => x.to_string().replace("inf", "∞"),
        _ => format!("{x:.1e}"),
    }
}

/// The line of a report that says how little so many cases show: of n, what befalls one in n / 3 is missed once in
/// twenty times, (1 − 3 / n)^n ≈ e^−3.
pub fn may_not_show(cases: u64, what: &str) -> String {
    format!("{cases} {what}: what happens to less than one in {} may not show.\n", (cases / 3).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_cases_show_little() {
        let said = may_not_show(1200, "rays a scene");
        assert_eq!(said, "1200 rays a scene: what happens to less than one in 400 may not show.\n");
        assert!(may_not_show(2, "rays").ends_with("less than one in 1 may not show.\n"));
    }

    #[test]
    fn names_stand_to_the_left_and_numbers_to_the_right() {
        let lines = [["method", "", "ns"], ["notes", "f32", "9.5"], ["robust", "f64", "100"]];
        let lines = lines.map(|line| line.map(str::to_string).to_vec());
        assert_eq!(
            aligned(&lines, &[true, false]),
            "  method        ns\n★ notes   f32  9.5\n  robust  f64  100\n"
        );
        let [heads, first, second] = lines.clone();
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let same = under(&heads, [(first, true), (second, false)].into_iter());
        assert_eq!(same, aligned(&lines, &[true, false]));
    }

    #[test]
    fn numbers_are_as_long_as_they_are_good() {
        assert_eq!([9.994, 9.996, 99.96, f64::NAN].map(three_digits), ["9.99", "10.0", "100", "–"]);
        assert_eq!([7.0, 999_999.0, 1.25e6].map(short), ["7", "999999", "1.2e6"]);
        assert_eq!([0.0, 0.5, f64::INFINITY].map(small), ["0", "5.0e-1", "∞"]);
    }
}

//! What `trade` measured, as a table: some rows and columns of the data that lie beside the pages.

use std::path::Path;

/// The rows of `book/src/trade/STAGE.csv` that belong to a regime, `best` of them only those of the Pareto front, and of
/// these the columns that are asked for.
///
/// An error where there is no such file, regime or column; it says which there are.
pub(crate) fn markdown(
    root: &Path,
    stage: &str,
    regime: &str,
    columns: &[&str],
    best: bool,
) -> Result<String, String> {
    let file = format!("book/src/trade/{stage}.csv");
    let text = std::fs::read_to_string(root.join(&file)).map_err(|error| format!("{file}: {error}"))?;
    // the tables of `trade` hold names and numbers, neither quotes nor commas within a field
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap_or_default();
    let place = |name: &str| {
        let found = header.iter().position(|column| *column == name);
        found.ok_or_else(|| format!("{file} has no column {name}; it has {}", header.join(", ")))
    };
    let (of_regime, of_front, rows) = (place("regime")?, place("pareto")?, lines.collect::<Vec<_>>());
    let places = columns.iter().map(|name| place(name)).collect::<Result<Vec<_>, _>>()?;
    let of_it = |row: &&Vec<&str>| {
        row.get(of_regime) == Some(&regime) && (!best || row.get(of_front) == Some(&"true"))
    };
    let mut wanted: Vec<&Vec<&str>> = rows.iter().filter(of_it).collect();
    if best && let Some(time) = header.iter().position(|column| *column == "ns_per_ray") {
        // a front is walked from the fastest on
        let time_of =
            |row: &&Vec<&str>| row.get(time).and_then(|field| field.parse().ok()).unwrap_or(f64::NAN);
        wanted.sort_by(|a, b| time_of(a).total_cmp(&time_of(b)));
    }
    if wanted.is_empty() {
        let mut there: Vec<&str> = rows.iter().filter_map(|row| row.get(of_regime).copied()).collect();
        there.dedup();
        return Err(format!("{file} has no regime {regime}; it has {}", there.join(", ")));
    }
    // the same number of cases in every row, as a rule: what a count is out of
    let mut cases: Vec<&str> =
        wanted.iter().filter_map(|row| row.get(place("cases").ok()?).copied()).collect();
    cases.dedup();
    let each = if let [cases] = cases[..] { format!(", {cases} cases each") } else { String::new() };
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut table = line(columns.iter().map(|name| name.replace('_', " ")).collect());
    table += &line(columns.iter().map(|_| "---".to_string()).collect());
    for row in wanted {
        table += &line(places.iter().map(|&at| rounded(row.get(at).copied().unwrap_or_default())).collect());
    }
    let link = format!("<a href=\"trade/{stage}.csv\">{stage}.csv</a>");
    Ok(format!("<p class=\"from\"><code>trade</code>, {regime}{each}: from {link}</p>\n\n{table}\n"))
}

/// A number with four digits that count: a table is read, the file beside it has them all.
fn rounded(field: &str) -> String {
    match field.parse::<f64>() {
        Ok(number) if number.is_finite() && number.fract() != 0.0 => {
            let digits = if number.abs() >= 1e-3 && number.abs() < 1e6 {
                let whole = number.abs().log10().floor() as i32;
                format!("{number:.*}", (3 - whole).clamp(0, 7) as usize)
            } else {
                format!("{number:.3e}")
            };
            digits.replace('-', "−")
        }
        // so many digits push a table out of its page
        Ok(number) if number.is_finite() && number.abs() >= 1e9 => format!("{number:.3e}"),
        _ => field.replace("true", "yes").replace("false", ""),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    #[test]
    fn rows_of_a_regime_and_columns_as_asked() {
        let table = markdown(root(), "ray-wall", "ordinary", &["method", "wrong_decisions"], false).unwrap();
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[2..4], ["| method | wrong decisions |", "| --- | --- |"]);
        assert!(lines[4].starts_with("| notes | ") || lines[4].starts_with("| robust | "), "{table}");
        let title = "<code>trade</code>, ordinary, 1000000 cases each: from <a href=\"trade/ray-wall.csv\">";
        assert!(lines[0].contains(title), "{table}");
    }

    #[test]
    fn a_front_is_walked_from_the_fastest_on() {
        let table = markdown(root(), "ray-sphere", "grazing", &["ns_per_ray"], true).unwrap();
        let times: Vec<f64> =
            table.lines().skip(4).filter_map(|line| line.trim_matches(['|', ' ']).parse().ok()).collect();
        assert!(times.len() > 3 && times.is_sorted(), "{table}");
    }

    #[test]
    fn what_is_not_there_is_told_with_what_is() {
        let error = |regime, column| markdown(root(), "ray-wall", regime, &[column], false).unwrap_err();
        assert!(error("odd", "method").contains("has no regime odd; it has ordinary"));
        assert!(error("ordinary", "color").contains("has no column color; it has method"));
        assert!(markdown(root(), "ray-ball", "ordinary", &[], false).unwrap_err().contains("ray-ball.csv"));
    }

    #[test]
    fn numbers_have_four_digits() {
        let all = [
            "12.3456",
            "1234567.25",
            "0.00001234",
            "7",
            "4600000000000000000",
            "inf",
            "",
            "robust",
            "true",
            "-0.51234",
        ]
        .map(rounded);
        assert_eq!(
            all,
            ["12.35", "1.235e6", "1.234e−5", "7", "4.600e18", "inf", "", "robust", "yes", "−0.5123"]
        );
    }
}

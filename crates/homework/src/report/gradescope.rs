//! `results.json` as Gradescope reads it: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.

use serde_json::{Value, json};

use super::{Part, Report};

/// One submission; each property is a test.
pub(crate) fn gradescope(report: &Report) -> String {
    let test = |it: &Part| {
        let status = if it.score == it.points { "passed" } else { "failed" };
        json!({
            "name": it.name, "score": it.score, "max_score": it.points, "status": status,
            "output": it.output, "output_format": "text", "visibility": "visible",
        })
    };
    let tests: Vec<Value> = report.properties.iter().map(test).collect();
    let results = json!({
        "score": report.score, "output": report.output, "output_format": "text", "visibility": "visible",
        "tests": tests,
    });
    format!("{results:#}\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::three;

    #[test]
    fn a_property_is_a_test() {
        let results: Value = serde_json::from_str(&gradescope(&three()[1])).unwrap();
        assert_eq!((&results["score"], results["tests"].as_array().unwrap().len()), (&json!(1), 2));
        let test = &results["tests"][1];
        assert_eq!((&test["name"], &test["score"]), (&json!("from inside"), &json!(0)));
        assert_eq!((&test["max_score"], &test["output"]), (&json!(2), &json!("  symbol    t_close")));
    }
}

//! For other programs.

use serde_json::{Value, json};

use super::{Part, Report};

/// A list, an object a submission.
pub(crate) fn json(reports: &[Report]) -> String {
    let all: Vec<Value> = reports.iter().map(value).collect();
    format!("{:#}\n", Value::Array(all))
}

/// One submission.
pub(crate) fn json_of(report: &Report) -> String {
    format!("{:#}\n", value(report))
}

fn value(it: &Report) -> Value {
    let part =
        |it: &Part| json!({ "name": it.name, "score": it.score, "points": it.points, "output": it.output });
    let wrong = it.wrong.as_ref().map(|it| {
        json!({
            "property": it.property, "given": it.given, "symbol": it.symbol, "formula": it.formula,
            "expected": it.expected, "got": it.got, "ulps": it.ulps, "page": it.page,
        })
    });
    let mistake = it.mistake.as_ref().map(|(name, says)| json!({ "name": name, "says": says }));
    json!({
        "student": it.student, "folder": it.folder, "exercise": it.exercise, "status": it.status.name(),
        "score": it.score, "points": it.points,
        "properties": it.properties.iter().map(part).collect::<Vec<_>>(),
        "first_wrong": wrong, "mistake": mistake, "output": it.output,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::three;

    #[test]
    fn it_reads_back() {
        let all: Value = serde_json::from_str(&json(&three())).unwrap();
        assert_eq!(all.as_array().unwrap().len(), 3);
        assert_eq!((&all[0]["score"], &all[0]["first_wrong"]), (&json!(3), &Value::Null));
        assert_eq!(all[1]["first_wrong"]["expected"], "1");
        assert_eq!(all[1]["first_wrong"]["page"], "House 4.4");
        assert_eq!(all[1]["mistake"]["name"], "direction-not-unit");
        assert_eq!(all[1]["properties"][1]["points"], 2);
        assert_eq!(all[2]["status"], "refused");
    }
}

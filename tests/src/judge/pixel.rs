//! The points of the view plane, which have no verdict.

use stage::Precision;

use crate::Record;

/// A pixel has a point or a reason, and a reason only where there can be no point.
pub(super) fn wrong_reason(got: &Record, method: &str, case: &[f64], precision: Precision) -> Option<String> {
    let [width, height, col, row, left, right, bottom, top, distance] = case.try_into().unwrap();
    let is_count = |count: f64| count.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&count);
    let is_within = |place: f64, count: f64| place.fract() == 0.0 && (0.0..count).contains(&place);
    let possible = case.iter().all(|number| number.is_finite())
        && is_count(width)
        && is_count(height)
        && is_within(col, width)
        && is_within(row, height)
        && left < right
        && bottom < top
        && distance > 0.0
        && (method != "edges" || width > 1.0 && height > 1.0);
    // Where the window's edges times the number of pixels are no number, a method may give up.
    let largest = if precision == Precision::F32 { f32::MAX.into() } else { f64::MAX };
    let extent = |low: f64, high: f64, count: f64| (low.abs() + high.abs()) * count;
    let too_large = extent(left, right, width) > largest || extent(bottom, top, height) > largest;

    let point = ["x", "y", "z"].map(|column| got.text(column));
    let is_empty = point.iter().all(|text| text.is_empty());
    let is_finite = point.iter().all(|text| text.parse().is_ok_and(f64::is_finite));
    match got.text("reason") {
        "" if !possible => Some("there is no such pixel, and no reason is given".to_string()),
        "" if !is_finite => Some(format!("the pixel has a point, and it is not {point:?}")),
        reason if !reason.is_empty() && possible && !too_large => {
            Some(format!("`{reason}`, yet the pixel has a point"))
        }
        reason if !reason.is_empty() && !is_empty => Some(format!("`{reason}`, and a point too: {point:?}")),
        _ => None,
    }
}

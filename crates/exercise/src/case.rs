//! The numbers that a probe starts from.

use std::fmt;

use crate::Value;

/// A row of numbers under the names of its columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Case<'a> {
    columns: &'a [String],
    numbers: &'a [f64],
}

impl<'a> Case<'a> {
    /// A case of so many numbers as there are columns; a number that is missing is NaN.
    pub fn new(columns: &'a [String], numbers: &'a [f64]) -> Case<'a> {
        Case { columns, numbers }
    }

    /// The number in a column.
    ///
    /// NaN where there is no such column: a probe asks for those of its own exercise, and the tests see to
    /// it.
    pub fn number(&self, column: &str) -> f64 {
        let place = self.columns.iter().position(|name| name == column);
        place.and_then(|place| self.numbers.get(place)).copied().unwrap_or(f64::NAN)
    }

    /// Three columns: `point("o")` is (ox, oy, oz).
    pub fn point(&self, name: &str) -> [f64; 3] {
        ["x", "y", "z"].map(|axis| self.number(&format!("{name}{axis}")))
    }

    /// Two columns: `point2("o")` is (ox, oy).
    pub fn point2(&self, name: &str) -> [f64; 2] {
        ["x", "y"].map(|axis| self.number(&format!("{name}{axis}")))
    }

    /// The names of the columns and their numbers, in order, as far as there are numbers.
    pub fn all(&self) -> impl Iterator<Item = (&'a str, f64)> {
        self.columns.iter().map(String::as_str).zip(self.numbers.iter().copied())
    }
}

/// "o = (0, 1, 0), r = 2": columns that end in x, y and z, or x and y, are a point.
impl fmt::Display for Case<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut all: Vec<(&str, f64)> = self.all().collect();
        let mut parts = Vec::new();
        while !all.is_empty() {
            let base = all[0].0.strip_suffix('x').unwrap_or_default();
            let is = |place: usize, axis: &str| {
                all.get(place).is_some_and(|(name, _)| name.strip_suffix(axis) == Some(base))
            };
            let axes = [is(0, "x"), is(1, "y"), is(2, "z")].iter().take_while(|&&it| it).count();
            let part: Vec<(&str, f64)> = all.drain(..if axes > 1 { axes } else { 1 }).collect();
            let name = if axes > 1 { base } else { part[0].0 };
            let numbers: Vec<f64> = part.into_iter().map(|(_, x)| x).collect();
            let value = if axes > 1 { Value::Vector(numbers) } else { Value::Number(numbers[0]) };
            parts.push(format!("{name} = {value}"));
        }
        f.write_str(&parts.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_by_name() {
        let columns = ["dx", "ox", "oy", "oz"].map(String::from);
        let case = Case::new(&columns, &[4.0, 1.0, 2.0, 3.0]);
        assert_eq!(case.point("o"), [1.0, 2.0, 3.0]);
        assert_eq!(case.point2("o"), [1.0, 2.0]);
        assert_eq!(case.number("dx"), 4.0);
        assert!(case.number("dy").is_nan());
    }

    #[test]
    fn points_are_written_as_points() {
        let columns = ["ox", "oy", "oz", "px", "py", "dx", "r", "y"].map(String::from);
        let case = Case::new(&columns, &[4.0, -1.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0]);
        assert_eq!(case.to_string(), "o = (4, −1, 2), p = (3, 5), dx = 6, r = 7, y = 8");
    }
}

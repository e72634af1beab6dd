//! A value of a step, and how far it is from another.

use std::fmt;

/// What a step found.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A vector, a point or a color.
    Vector(Vec<f64>),
    /// A verdict or a name.
    Text(String),
}

impl Value {
    /// The numbers in it, in order; none in a text.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Value::Number(x) => std::slice::from_ref(x),
            Value::Vector(v) => v,
            Value::Text(_) => &[],
        }
    }

    /// Whether `got` is this value where each number may be off by its `tolerance`. A number that is missing
    /// in `tolerance`, an infinity and a NaN are to be met as they are.
    pub fn is_met_by(&self, got: &Value, tolerance: &[f64]) -> bool {
        match (self, got) {
            (Value::Text(expected), Value::Text(got)) => expected == got,
            (Value::Number(_), Value::Number(_)) | (Value::Vector(_), Value::Vector(_)) => {
                let (expected, got) = (self.numbers(), got.numbers());
                let within = |place: usize| {
                    let (expected, got) = (expected[place], got[place]);
                    let same = expected == got || expected.is_nan() && got.is_nan();
                    same || (expected - got).abs() <= tolerance.get(place).copied().unwrap_or(0.0)
                };
                expected.len() == got.len() && (0..expected.len()).all(within)
            }
            _ => false,
        }
    }

    /// The kind and the value as a sheet has them, with a tab between them.
    pub(crate) fn to_fields(&self) -> String {
        match self {
            Value::Number(x) => format!("number\t{x:?}"),
            Value::Vector(v) => {
                let numbers: Vec<String> = v.iter().map(|x| format!("{x:?}")).collect();
                format!("vector\t{}", numbers.join(" "))
            }
            Value::Text(text) => format!("text\t{}", one_line(text)),
        }
    }

    /// Reads what [`Value::to_fields`] wrote; `None` where it is something else.
    pub(crate) fn from_fields(kind: &str, text: &str) -> Option<Value> {
        match kind {
            "number" => text.parse().ok().map(Value::Number),
            "vector" => text.split(' ').map(|x| x.parse().ok()).collect::<Option<_>>().map(Value::Vector),
            "text" => Some(Value::Text(text.to_string())),
            _ => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // −0 is 0
        let number = |x: &f64| format!("{}", x + 0.0).replace('-', "−");
        match self {
            Value::Number(x) => f.write_str(&number(x)),
            Value::Vector(v) => write!(f, "({})", v.iter().map(number).collect::<Vec<_>>().join(", ")),
            Value::Text(text) => f.write_str(text),
        }
    }
}

/// A text without the signs that end a field or a line of a sheet.
pub(crate) fn one_line(text: &str) -> String {
    text.replace(|sign: char| sign.is_control(), " ")
}

/// How far `got` is from `expected`, in units of the last digit of `expected`: 0 where they are equal, else
/// infinite where either is not finite.
pub fn ulps(expected: f64, got: f64) -> f64 {
    if expected == got {
        return 0.0;
    }
    let size = expected.abs();
    let ulp = if size.is_finite() { size.next_up() - size } else { f64::NAN };
    let apart = (got - expected).abs() / ulp;
    if apart.is_finite() { apart } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_number_has_its_own_tolerance() {
        let expected = Value::Vector(vec![1.0, 2.0]);
        let got = Value::Vector(vec![1.0, 2.25]);
        assert!(!expected.is_met_by(&got, &[0.25, 0.0]));
        assert!(expected.is_met_by(&got, &[0.0, 0.25]));
        assert!(!expected.is_met_by(&got, &[0.25]), "what has no tolerance is to be met");
        assert!(!expected.is_met_by(&Value::Vector(vec![1.0]), &[9.0, 9.0]));
        assert!(!Value::Number(1.0).is_met_by(&Value::Vector(vec![1.0]), &[9.0]));
    }

    #[test]
    fn what_is_no_number_is_met_by_nothing_else() {
        let nan = Value::Number(f64::NAN);
        assert!(nan.is_met_by(&Value::Number(-f64::NAN), &[0.0]));
        assert!(!nan.is_met_by(&Value::Number(1.0), &[f64::INFINITY]));
        assert!(!Value::Number(1.0).is_met_by(&nan, &[1.0]));
        assert!(!Value::Number(f64::INFINITY).is_met_by(&Value::Number(f64::MAX), &[1.0]));
    }

    #[test]
    fn a_value_reads_back_as_it_was() {
        for value in [
            Value::Number(-0.1 + 0.3),
            Value::Number(f64::NEG_INFINITY),
            Value::Vector(vec![1e-310, f64::MAX, -0.0]),
            Value::Text("a hit".into()),
        ] {
            let fields = value.to_fields();
            let (kind, text) = fields.split_once('\t').unwrap();
            assert_eq!(Value::from_fields(kind, text), Some(value));
        }
        assert_eq!(Value::from_fields("vector", "1 x"), None);
        assert_eq!(Value::Text("two\nlines\there".into()).to_fields(), "text\ttwo lines here");
    }

    #[test]
    fn ulps_are_counted_in_the_last_digit_of_what_is_expected() {
        assert_eq!(ulps(1.0, 1.0 + 3.0 * f64::EPSILON), 3.0);
        assert_eq!(ulps(4.0, 4.0), 0.0);
        assert_eq!(ulps(f64::INFINITY, 1.0), f64::INFINITY);
        assert_eq!(ulps(1.0, f64::NAN), f64::INFINITY);
    }
}

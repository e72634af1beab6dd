//! A value as a transcript carries it.

use math::{Real, Vector};

/// What stands at the end of a step: a number, an array or a text.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number of binary32.
    F32(f32),
    /// A number of binary64.
    F64(f64),
    /// A vector, or a list.
    Array(Vec<Value>),
    /// A word, or a sentence.
    Text(String),
}

impl Value {
    /// A number in the precision it was computed in.
    pub fn number<R: Real>(x: R) -> Value {
        let wide: f64 = x.into();
        if R::NAME == f32::NAME { Value::F32(wide as f32) } else { Value::F64(wide) }
    }

    /// A vector, component by component.
    pub fn vector<R: Real>(v: impl Vector<R>) -> Value {
        Value::Array(v.components().iter().map(|&x| Value::number(x)).collect())
    }

    /// A number where there is one; the text "none" where there is not.
    pub fn maybe<R: Real>(x: Option<R>) -> Value {
        x.map_or(Value::text("none"), Value::number)
    }

    /// A text.
    pub fn text(text: impl Into<String>) -> Value {
        Value::Text(text.into())
    }

    /// As the terminal shows it: `0.5`, `−1e−20`, `(0, −1, 3)`, `∞`. Numbers are as short as reading
    /// them back allows.
    pub fn to_text(&self) -> String {
        match self {
            Value::F32(x) => typeset(&digits(*x)),
            Value::F64(x) => typeset(&digits(*x)),
            Value::Array(values) => {
                let values: Vec<String> = values.iter().map(Value::to_text).collect();
                format!("({})", values.join(", "))
            }
            Value::Text(text) => text.clone(),
        }
    }
}

/// The shortest decimal that reads back to `x`, as a result row has it: `0.5`, `-1e-20`, `inf`, `nan`.
pub(crate) fn digits<R: Real>(x: R) -> String {
    if !x.is_finite() {
        let wide: f64 = x.into();
        return if wide.is_nan() { "nan".into() } else { wide.to_string() };
    }
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_string)
}

/// A number for a reader: a true minus sign, ∞.
fn typeset(digits: &str) -> String {
    digits.replace('-', "−").replace("inf", "∞").replace("nan", "NaN")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_to_the_same_value() {
        for x in [0.0, 0.1, -2.5, 1e300, 5e-324, 123456789012345680.0, f64::MAX] {
            assert_eq!(digits(x).parse::<f64>().unwrap(), x);
        }
        assert_eq!(digits(0.1_f32), "0.1", "the shortest for its own precision");
        assert_eq!(digits(f64::NEG_INFINITY), "-inf");
        assert_eq!(digits(f32::NAN), "nan");
    }

    #[test]
    fn text_is_typeset() {
        let vector = Value::vector(glam::DVec3::new(0.0, -1.0, 3e-20));
        assert_eq!(vector.to_text(), "(0, −1, 3e−20)");
        assert_eq!(Value::number(f32::INFINITY).to_text(), "∞");
    }
}

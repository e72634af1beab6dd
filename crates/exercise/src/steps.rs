//! What a probe writes down.

use crate::Value;

/// One line: a symbol, its formula as the page writes it, and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The page's symbol: `t_close`.
    pub symbol: String,
    /// The page's formula: `u_r · (c − p_r)`. Where the exercise asks for it, a word for it.
    pub formula: String,
    /// What the code makes of it.
    pub value: Value,
    /// How far off each number may be, as a difference; empty where that is not known, as in a student's own
    /// steps.
    pub tolerance: Vec<f64>,
}

/// What the code makes of one case, in the order of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps(pub Vec<Step>);

impl Steps {
    /// A step whose value is a number.
    pub fn number(&mut self, symbol: &str, formula: &str, x: impl Into<f64>) -> &mut Steps {
        self.value(symbol, formula, Value::Number(x.into()))
    }

    /// A step whose value is a vector, a point or a color.
    pub fn vector(&mut self, symbol: &str, formula: &str, v: impl Into<[f64; 3]>) -> &mut Steps {
        self.value(symbol, formula, Value::Vector(v.into().to_vec()))
    }

    /// A step whose value is any number of numbers.
    pub fn numbers(&mut self, symbol: &str, formula: &str, numbers: &[f64]) -> &mut Steps {
        self.value(symbol, formula, Value::Vector(numbers.to_vec()))
    }

    /// A step whose value is a verdict or a name.
    pub fn text(&mut self, symbol: &str, formula: &str, text: impl ToString) -> &mut Steps {
        self.value(symbol, formula, Value::Text(text.to_string()))
    }

    /// A number, or `otherwise` where there is none.
    pub fn maybe<X: Into<f64>>(
        &mut self,
        symbol: &str,
        formula: &str,
        x: Option<X>,
        otherwise: &str,
    ) -> &mut Steps {
        match x {
            Some(x) => self.number(symbol, formula, x),
            None => self.text(symbol, formula, otherwise),
        }
    }

    /// A step.
    pub fn value(&mut self, symbol: &str, formula: &str, value: Value) -> &mut Steps {
        let (symbol, formula) = (symbol.to_string(), formula.to_string());
        self.0.push(Step { symbol, formula, value, tolerance: Vec::new() });
        self
    }
}

//! Numbers, vectors and colors, each within its bounds.

use super::value::Value;
use crate::Error;

impl Value<'_> {
    /// A number above 0.
    pub(super) fn positive(self) -> Result<f64, Error> {
        self.number_that(|x| x > 0.0, "must be above 0")
    }

    /// A number from 0 up.
    pub(super) fn not_negative(self) -> Result<f64, Error> {
        self.number_that(|x| x >= 0.0, "must not be below 0")
    }

    /// A coefficient, 0 to 1.
    pub(super) fn fraction(self) -> Result<f64, Error> {
        self.number_that(|x| (0.0..=1.0).contains(&x), "must be 0 to 1")
    }

    fn number_that(self, holds: impl Fn(f64) -> bool, why: &str) -> Result<f64, Error> {
        let number = self.number()?;
        if holds(number) { Ok(number) } else { Err(self.impossible(why)) }
    }

    /// Numbers, so many.
    pub(super) fn numbers<const N: usize>(self) -> Result<[f64; N], Error> {
        self.each(Value::number)
    }

    /// Linear RGB, 0 to 1.
    pub(super) fn color(self) -> Result<[f64; 3], Error> {
        self.each(Value::fraction)
    }

    /// Linear RGB, from 0 up.
    pub(super) fn radiance(self) -> Result<[f64; 3], Error> {
        self.each(Value::not_negative)
    }

    /// A vector of any length but 0.
    pub(super) fn direction(self) -> Result<[f64; 3], Error> {
        let direction = self.numbers()?;
        if direction == [0.0; 3] { Err(self.impossible("must not be zero")) } else { Ok(direction) }
    }

    /// Vectors in a list of any length.
    pub(super) fn points(self) -> Result<Vec<[f64; 3]>, Error> {
        self.items()?.map(Value::numbers).collect()
    }

    fn each<const N: usize>(self, read: impl Fn(Self) -> Result<f64, Error>) -> Result<[f64; N], Error> {
        let items = self.exactly::<N>()?;
        let mut numbers = [0.0; N];
        for (number, item) in numbers.iter_mut().zip(items) {
            *number = read(item)?;
        }
        Ok(numbers)
    }
}

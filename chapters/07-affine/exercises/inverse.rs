//! What is looked at, in the order of the formulas.

use exercise::{Case, Steps};

use crate::Matrix3;

/// The inverse of the matrix with the rows `A1`, `A2`, `A3`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let a = Matrix3::<f64>::from_rows(["A1", "A2", "A3"].map(|row| case.point(row)));
    steps.number("det A", "the volume of the box", a.determinant());
    let named = |steps: &mut Steps, name: &str, formula: &str, rows: [[f64; 3]; 3]| {
        for (place, row) in rows.iter().enumerate() {
            steps.vector(name, &format!("{formula}, row {}", place + 1), *row);
        }
    };
    named(steps, "adj A", "the adjugate", a.adjugate().rows());
    named(steps, "A⁻¹", "the inverse", a.inverse().rows());
}

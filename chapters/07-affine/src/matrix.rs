//! A, its inverse, and ȳ = A x̄ + t.

use math::{Real, Vector};

/// A 3×3 matrix by its columns: where the matrix sends the three axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix3<R: Real> {
    /// A e_x, A e_y, A e_z.
    pub columns: [R::Vec3; 3],
}

impl<R: Real> Matrix3<R> {
    /// The matrix with these rows, as a page or a case file writes it.
    pub fn from_rows([x, y, z]: [[R; 3]; 3]) -> Matrix3<R> {
        Matrix3 { columns: [0, 1, 2].map(|column| R::vec3(x[column], y[column], z[column])) }
    }

    /// The rows.
    pub fn rows(&self) -> [[R; 3]; 3] {
        let [a, b, c] = self.columns.map(R::xyz);
        [0, 1, 2].map(|row| [a[row], b[row], c[row]])
    }

    /// The matrix that leaves everything as it is.
    pub fn identity() -> Matrix3<R> {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        Matrix3::from_rows([[one, zero, zero], [zero, one, zero], [zero, zero, one]])
    }

    /// A v
    #[inline]
    pub fn times(&self, v: R::Vec3) -> R::Vec3 {
        let [a, b, c] = self.columns;
        let [x, y, z] = R::xyz(v);
        a * x + b * y + c * z
    }

    /// Aᵀ v
    #[inline]
    pub fn transposed_times(&self, v: R::Vec3) -> R::Vec3 {
        let [a, b, c] = self.columns;
        R::vec3(a.dot(v), b.dot(v), c.dot(v))
    }

    /// det A, the volume of the box that the columns span: negative where A mirrors.
    #[inline]
    pub fn determinant(&self) -> R {
        let [a, b, c] = self.columns;
        // exercise determinant: What is the volume of the box that the columns a, b, c span, with its sign?
        a.dot(R::cross(b, c))
        // end determinant
    }

    /// adj A, the matrix with A adj A = det A · 1: its rows are b × c, c × a, a × b of the columns a, b, c.
    pub fn adjugate(&self) -> Matrix3<R> {
        let [a, b, c] = self.columns;
        // exercise adjugate: What is at right angles to two columns at a time: a row or a column of adj A?
        Matrix3::from_rows([R::cross(b, c), R::cross(c, a), R::cross(a, b)].map(R::xyz))
        // end adjugate
    }

    /// A⁻¹ = adj A / det A. Infinite or NaN where det A is zero, or vanishes when it is rounded.
    pub fn inverse(&self) -> Matrix3<R> {
        // exercise inverse: A adj A = det A · 1: what is A⁻¹ then?
        let det = self.determinant();
        Matrix3 { columns: self.adjugate().columns.map(|column| column / det) }
        // end inverse
    }

    /// No number is infinite or NaN.
    pub fn is_finite(&self) -> bool {
        self.columns.iter().all(|column| column.is_finite())
    }
}

/// The affine deformation ȳ = A x̄ + t (CSC418 11.3.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine<R: Real> {
    /// A, any matrix that has an inverse.
    pub a: Matrix3<R>,
    /// t, where the object's own origin goes.
    pub t: R::Vec3,
}

impl<R: Real> Affine<R> {
    /// ȳ = A x̄ + t
    #[inline]
    pub fn apply(&self, x: R::Vec3) -> R::Vec3 {
        self.a.times(x) + self.t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::Degenerate;

    /// By hand: det = 2 (1·1 − 0·4) − 1 (0·1 − 0·3) + 0 = 2, the adjugate from the nine minors.
    #[test]
    fn an_inverse_by_hand() {
        let a = Matrix3::<f64>::from_rows([[2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [3.0, 4.0, 1.0]]);
        assert_eq!(a.determinant(), 2.0);
        assert_eq!(a.adjugate().rows(), [[1.0, -1.0, 0.0], [0.0, 2.0, 0.0], [-3.0, -5.0, 2.0]]);
        assert_eq!(a.inverse().rows(), [[0.5, -0.5, 0.0], [0.0, 1.0, 0.0], [-1.5, -2.5, 1.0]]);
        let v = DVec3::new(4.0, -2.0, 8.0);
        assert_eq!(a.times(v), DVec3::new(6.0, -2.0, 12.0));
        assert_eq!(a.inverse().times(a.times(v)), v);
        assert_eq!(a.transposed_times(v), DVec3::new(32.0, 34.0, 8.0));
    }

    #[test]
    fn rows_are_rows() {
        let rows = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]];
        let a = Matrix3::<f64>::from_rows(rows);
        assert_eq!(a.rows(), rows);
        assert_eq!(a.columns[1], DVec3::new(2.0, 5.0, 8.0));
        assert_eq!(a.times(DVec3::Y), a.columns[1]);
        assert_eq!(Matrix3::<f64>::identity().times(DVec3::ONE), DVec3::ONE);
    }

    #[test]
    fn a_matrix_without_an_inverse_is_refused() {
        let flat = Matrix3::<f64>::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
        assert_eq!(Affine { a: flat, t: DVec3::ZERO }.check(), Err(Degenerate::Singular));
        assert_eq!(Affine { a: flat, t: DVec3::NAN }.check(), Err(Degenerate::NotFinite));
        // a determinant of 1e−600 vanishes in floating point, and is not zero
        let tiny: Matrix3<f64> =
            Matrix3 { columns: Matrix3::<f64>::identity().columns.map(|column| column * 1e-200) };
        assert_eq!(tiny.determinant(), 0.0);
        assert_eq!(Affine { a: tiny, t: DVec3::ZERO }.check(), Ok(()));
    }
}

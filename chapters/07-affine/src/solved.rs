//! A⁻¹ not stored: A a′ = a − t and A d′ = d solved for every ray.
//!
//! "Never invert a matrix to solve a system" is good advice where A is nearly singular: Gaussian elimination with
//! partial pivoting finds an x for which A x is the right-hand side but for the last digits (Wilkinson 1961; Higham,
//! *Accuracy and Stability*, ch. 9 and 14), and A⁻¹ b does not. Whether that saves λ* is another question. `trade`
//! answers: for a plane of condition 1e6 λ* keeps the digits that the inverse loses. For a sphere nothing is gained: a′
//! and d′ may be as good as they can be, but both are large, and B² − A C of nearly equal squares is lost all the
//! same. And it takes more than twice the time.

use math::{Degenerate, Ray3, Real, Span};

use crate::{Deformed, Found, Hit3, Matrix3, Undeformed, undeformed};

/// Every number of the method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved<'a, R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The deformed object.
    pub deformed: &'a Deformed<R>,
    /// a − t
    pub a_minus_t: R::Vec3,
    /// A brought to triangular form, with the right-hand sides a − t and d.
    pub eliminated: Eliminated<R, 2>,
    /// The ray r′(λ) = a′ + λ d′ in the object's own space.
    pub ray_prime: Ray3<R>,
    /// The object's own method for that ray.
    pub undeformed: Undeformed<R>,
}

/// A system of three equations with N right-hand sides, in triangular form: U x = b′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eliminated<R, const N: usize> {
    /// The rows of U: zeros below the diagonal, pivots on it.
    pub u: [[R; 3]; 3],
    /// Which equation each row of U was at first.
    pub order: [usize; 3],
    /// The right-hand sides, each with what was subtracted from it.
    pub b: [[R; 3]; N],
}

/// Works out the method, for a direction of any length but zero.
///
/// A degenerate ray gives values that mean nothing; [`Solved::hit`] refuses it.
#[inline]
pub fn solved<'a, R: Real>(ray: &Ray3<R>, deformed: &'a Deformed<R>) -> Solved<'a, R> {
    let (a, t) = (&deformed.affine.a, deformed.affine.t);

    // A a′ = a − t and A d′ = d
    let a_minus_t = ray.origin - t;
    let eliminated = eliminate(a.rows(), [a_minus_t, ray.direction].map(R::xyz));
    let [a_prime, d_prime] = eliminated.solutions().map(|[x, y, z]| R::vec3(x, y, z));
    let ray_prime = Ray3::new(a_prime, d_prime);

    let undeformed = undeformed(deformed.object, &ray_prime);
    Solved { ray: *ray, deformed, a_minus_t, eliminated, ray_prime, undeformed }
}

/// Gaussian elimination: in each column the equation with the largest coefficient is taken to clear the
/// others below. `u` are the coefficients, an equation a row, and each of `b` is a right-hand side.
#[inline]
pub fn eliminate<R: Real, const N: usize>(mut u: [[R; 3]; 3], mut b: [[R; 3]; N]) -> Eliminated<R, N> {
    let magnitude = |x: R| if x < R::from(0.0) { -x } else { x };
    let mut order = [0, 1, 2];
    for column in 0..2 {
        let mut pivot = column;
        for row in column + 1..3 {
            if magnitude(u[row][column]) > magnitude(u[pivot][column]) {
                pivot = row;
            }
        }
        u.swap(column, pivot);
        order.swap(column, pivot);
        b.iter_mut().for_each(|b| b.swap(column, pivot));

        for row in column + 1..3 {
            let (above, below) = (u[column], u[row]);
            let factor = below[column] / above[column];
            // below the diagonal zeros, by construction
            u[row] = [0, 1, 2].map(|at| match at > column {
                true => below[at] - factor * above[at],
                false => R::from(0.0),
            });
            b.iter_mut().for_each(|b| b[row] = b[row] - factor * b[column]);
        }
    }
    Eliminated { u, order, b }
}

impl<R: Real, const N: usize> Eliminated<R, N> {
    /// The solutions, by putting back from the last equation up. Infinite or NaN where a pivot is zero, which it may
    /// be, rounded, though A is not singular.
    #[inline]
    pub fn solutions(&self) -> [[R; 3]; N] {
        let u = &self.u;
        self.b.map(|b| {
            let z = b[2] / u[2][2];
            let y = (b[1] - u[1][2] * z) / u[1][1];
            let x = (b[0] - u[0][1] * y - u[0][2] * z) / u[0][0];
            [x, y, z]
        })
    }
}

/// A⁻ᵀ n, from Aᵀ m = n solved the same way.
#[inline]
fn inverse_transposed_times<R: Real>(a: &Matrix3<R>, n: R::Vec3) -> R::Vec3 {
    // the rows of Aᵀ are the columns of A
    let [[x, y, z]] = eliminate(a.columns.map(R::xyz), [R::xyz(n)]).solutions();
    R::vec3(x, y, z)
}

impl<R: Real> Solved<'_, R> {
    /// The λ* of the nearest hit in `span`, in both spaces. `None` for a miss, and where a pivot vanishes;
    /// [`Degenerate`] as [`Ray3::check`] says.
    #[inline]
    pub fn found(&self, span: Span<R>) -> Result<Option<Found<R>>, Degenerate> {
        self.ray.check()?;
        if self.deformed.parallel(&self.ray).is_some() {
            return Ok(None);
        }
        let Some(hit) = self.undeformed.hit(span) else { return Ok(None) };
        let a_inverse_transposed_n = inverse_transposed_times(&self.deformed.affine.a, hit.normal);
        Ok(Found::brought_back(&self.ray, hit, a_inverse_transposed_n))
    }

    /// The nearest hit in `span`; `None` and [`Degenerate`] as [`Solved::found`] says.
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        Ok(self.found(span)?.map(|found| found.hit()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: the second equation has the largest coefficient of x, and the third is left with 2 z = 6.
    #[test]
    fn a_system_by_hand() {
        let done = eliminate([[1.0, 2.0, 1.0], [2.0, 0.0, 2.0], [1.0, 2.0, 3.0]], [[8.0, 8.0, 14.0]]);
        assert_eq!(done.order, [1, 0, 2]);
        assert_eq!(done.u, [[2.0, 0.0, 2.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]);
        assert_eq!(done.solutions(), [[1.0, 2.0, 3.0]]);
    }

    /// A pivot of zero is stepped over.
    #[test]
    fn a_zero_on_the_diagonal_is_no_obstacle() {
        let turned = eliminate([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], [[2.0, 3.0, 1.0]]);
        assert_eq!(turned.solutions(), [[1.0, 2.0, 3.0]]);
    }

    /// By hand: 49 times the number next to 1/49 is not 1, and below the diagonal all is zero nevertheless.
    #[test]
    fn below_the_diagonal_are_zeros() {
        assert_ne!(1.0 - (1.0 / 49.0) * 49.0, 0.0);
        let done = eliminate([[49.0, 1.0, 2.0], [1.0, 49.0, 3.0], [-1.0, 1.0, 5.0]], [[0.0; 3]]);
        assert_eq!([done.u[1][0], done.u[2][0], done.u[2][1]], [0.0; 3]);
    }

    /// By hand: a sphere of radius 2 at the origin, and a ray along x from −9.
    #[test]
    fn a_sphere_by_hand() {
        use glam::DVec3;
        let twice = Matrix3::from_rows([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]);
        let affine = crate::Affine { a: twice, t: DVec3::ZERO };
        let sphere = Deformed::<f64>::new(crate::Object::Sphere, affine).unwrap();
        let hit = solved(&Ray3::new(DVec3::X * -9.0, DVec3::X), &sphere).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (7.0, DVec3::X * -2.0, -DVec3::X));
    }
}

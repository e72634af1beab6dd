//! Affine objects: {A p + t : p in the unit object}, by the adjugate of A.

use math::Degenerate;
use stage::Precision;

use super::unit::ScaledRay;
use super::vector::{cross, difference, dot, is_zero, vectors};
use super::{Dyadic, UnitObject, Verdict};
use crate::Truth;

/// What is true of a ray and {A p + t : p in the unit object}, from the columns
/// `ox,oy,oz,dx,dy,dz,a11,a12,a13,a21,a22,a23,a31,a32,a33,tx,ty,tz`.
///
/// The root is that of [`quadric`](super::quadric()) for the ray that A⁻¹ takes back, and so is the reason of
/// a miss. Invalid, whichever comes first: a number that is not finite, a zero direction, a singular matrix
/// (det A = 0).
pub fn affine(shape: UnitObject, case: [f64; 18], precision: Precision) -> Truth {
    exact_affine(shape, case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_affine(shape: UnitObject, case: [f64; 18]) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let [p_r, d, row_1, row_2, row_3, t] = vectors(&case);
    if is_zero(&d) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    // A⁻¹ = adj A / det A, and the columns of the adjugate are cross products of the rows of A.
    let columns = [cross(&row_2, &row_3), cross(&row_3, &row_1), cross(&row_1, &row_2)];
    let det = dot(&row_1, &columns[0]);
    if det.is_zero() {
        return Verdict::Invalid(Degenerate::Singular.reason());
    }
    // Instead of a division by det A the unit objects are |det A| times as large.
    let mirrored = det.sign().is_lt();
    let back = |v: &[Dyadic; 3]| -> [Dyadic; 3] {
        std::array::from_fn(|i| {
            let row = columns.each_ref().map(|column| column[i].clone());
            if mirrored { -&dot(&row, v) } else { dot(&row, v) }
        })
    };
    let (origin, direction) = (back(&difference(&p_r, &t)), back(&d));
    shape.verdict(&ScaledRay { origin, direction, scale: if mirrored { -&det } else { det } })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Draw;
    use crate::oracle::testing::{floats, for_drawn};
    use crate::oracle::{quadric, sphere, triangle};

    /// t of a ray from (x, 0, z) along (d_x, 0, d_z) and an object moved by (1, 0, 3); empty for a miss.
    fn t(shape: UnitObject, matrix: [f64; 9], [x, z, d_x, d_z]: [f64; 4]) -> Vec<f64> {
        let case = [&[x, 0.0, z, d_x, 0.0, d_z][..], &matrix, &[1.0, 0.0, 3.0]].concat();
        floats(&affine(shape, std::array::from_fn(|i| case[i]), Precision::F64))
    }

    #[test]
    fn closed_forms() {
        use UnitObject::{Cone, Cylinder, Plane, Sphere, Triangle};
        let longer = [2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 4.0];
        // by hand: half axes 2, 1, 4 around (1, 0, 3)
        assert_eq!(t(Sphere, longer, [-9.0, 3.0, 1.0, 0.0]), [8.0]);
        assert_eq!(t(Sphere, longer, [1.0, 3.0, 1.0, 0.0]), [2.0], "from inside");
        assert_eq!(t(Sphere, longer, [-1.0, 0.0, 0.0, 1.0]), [3.0], "a tangent");
        assert_eq!(t(Cylinder, longer, [1.0, 10.0, 0.0, -2.0]), [1.5], "its cap is at z = 7");
        assert_eq!(t(Cylinder, longer, [3.0, 10.0, 0.0, -2.0]), [1.5], "along its wall");
        assert_eq!(t(Cone, longer, [1.0, 10.0, 0.0, -2.0]), [1.5], "its apex");
        assert_eq!(t(Cone, longer, [-9.0, 5.0, 1.0, 0.0]), [9.5], "half of its height, half of its radius 1");
        assert_eq!(t(Plane, longer, [-9.0, 5.0, 1.0, -1.0]), [2.0]);
        assert_eq!(t(Triangle, longer, [3.0, 5.0, 0.0, -1.0]), [2.0], "its corner (1, 0, 0)");
        assert_eq!(t(Triangle, longer, [3.0_f64.next_up(), 5.0, 0.0, -1.0]), [0.0; 0]);
        // by hand: x and z change places, so z is the cone's way across, and its base is at x = 1; det = −1
        let mirrored = [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0];
        assert_eq!(t(Cone, mirrored, [-1.0, 3.0, 1.0, 0.0]), [2.0], "the base");
        assert_eq!(t(Cone, mirrored, [4.0, 3.0, -1.0, 0.0]), [2.0], "the apex at x = 2");
        assert_eq!(t(Cone, mirrored, [1.5, 3.0, 0.0, 1.0]), [0.25], "from inside, by the wall");
        assert_eq!(t(Plane, mirrored, [-1.0, 5.0, 1.0, 9.0]), [2.0]);
        // by hand: x' = x + z, and the axis leans
        let sheared = [1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        assert_eq!(t(Cylinder, sheared, [3.0, 3.0, 1.0, 1.0]), [0.0; 0], "outside along the wall");
        assert_eq!(t(Cylinder, sheared, [-1.0, 1.0, 1.0, 1.0]), [1.0], "along the axis");
        assert_eq!(t(Cylinder, sheared, [2.0, 3.0, 1.0, 1.0]), [0.0], "within the wall");
    }

    #[test]
    fn parallel_and_singular_are_exact() {
        // by hand: the plane is spanned by (1, 0, 1e200) and y, and det A = a_33 − 1e200
        let case = |a_33, d_z| {
            [0.0, 9.0, 0.0, 1.0, 0.0, d_z, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1e200, 0.0, a_33, 0.0, 0.0, 0.0]
        };
        let truth = |a_33, d_z| affine(UnitObject::Plane, case(a_33, d_z), Precision::F64);
        assert_eq!(truth(0.0, 1e200), Truth::Miss("in-plane"));
        assert_eq!(floats(&truth(0.0, 1e200_f64.next_up())), [0.0]);
        for shape in UnitObject::ALL {
            assert_eq!(affine(shape, case(1e200, 1.0), Precision::F64), Truth::Invalid("singular"));
        }
        assert_eq!(floats(&truth(1e200_f64.next_up(), 1.0)), [0.0], "not singular");
        assert_eq!(truth(1e200_f64.next_down(), 1e200), Truth::Miss("in-plane"));
    }

    #[test]
    fn the_first_reason_counts() {
        for shape in UnitObject::ALL {
            let reason = |t_z, d| {
                let mut case = [0.0; 18];
                (case[3], case[17]) = (d, t_z);
                affine(shape, case, Precision::F64)
            };
            assert_eq!(reason(f64::NAN, 0.0), Truth::Invalid("not-finite"));
            assert_eq!(reason(0.0, -0.0), Truth::Invalid("zero-direction"));
            assert_eq!(reason(0.0, 5e-324), Truth::Invalid("singular"));
        }
    }

    /// The same verdict and the same t, though the digits behind it may be another interval's.
    fn assert_same(got: Truth, want: Truth, case: &[f64]) {
        match (got, want) {
            (Truth::Hit { t, out: None }, Truth::Hit { t: want, .. }) => {
                assert_eq!(t.nearest.to_bits(), want.nearest.to_bits(), "{case:?}");
            }
            _ => assert_eq!(got, want, "{case:?}"),
        }
    }

    #[test]
    fn carried_along_with_the_object_a_ray_hits_at_the_same_t() {
        let mut draw = Draw::new(1, "affine", Precision::F64);
        let mut whole = |size: u64| (draw.below(2 * size + 1) as f64 - size as f64) / 4.0;
        let (mut hits, mut misses, mut singular) = (0, 0, 0);
        for round in 0..40_000 {
            let shape = UnitObject::ALL[round % 5];
            let ray: [f64; 6] = std::array::from_fn(|_| whole(8));
            let [a, t]: [[f64; 9]; 2] = [8, 64].map(|size| std::array::from_fn(|_| whole(size)));
            // A v, which a float holds exactly
            let carried = |v: &[f64]| [0, 3, 6].map(|row| (0..3).map(|i| a[row + i] * v[i]).sum::<f64>());
            let (p, d) = (carried(&ray[..3]), carried(&ray[3..]));
            let case = [&[p[0] + t[0], p[1] + t[1], p[2] + t[2]][..], &d, &a, &t[..3]].concat();
            let got = affine(shape, std::array::from_fn(|i| case[i]), Precision::F64);
            match got {
                // A zero d comes first, also where a singular matrix makes it zero.
                Truth::Invalid(_) => singular += 1,
                Truth::Miss(_) => misses += 1,
                Truth::Hit { .. } => hits += 1,
            }
            if !matches!(got, Truth::Invalid("singular" | "zero-direction")) {
                assert_same(got, quadric(shape, ray, Precision::F64), &case);
            }
        }
        assert!(hits > 5000 && misses > 5000 && singular > 10, "{hits} hits, {misses} misses, {singular}");
    }

    #[test]
    fn a_unit_sphere_scaled_and_moved_is_a_sphere() {
        for_drawn("scaled", |mut case: [f64; 10], precision| {
            case[9] = case[9].abs();
            let r = case[9];
            let matrix = [r, 0.0, 0.0, 0.0, -r, 0.0, 0.0, 0.0, r];
            let columns = [&case[..6], &matrix, &case[6..9]].concat();
            let got = affine(UnitObject::Sphere, std::array::from_fn(|i| columns[i]), precision);
            match (got, sphere(case, precision)) {
                (Truth::Invalid("singular"), Truth::Invalid("radius-not-positive")) => {}
                (got, want) => assert_same(got, want, &case),
            }
        });
    }

    #[test]
    fn a_unit_triangle_between_two_edges_is_a_triangle() {
        for_drawn("edges", |case: [f64; 15], precision| {
            let [edge_1, edge_2, third] = [0, 1, 2].map(|i| &case[6 + 3 * i..9 + 3 * i]);
            let matrix: Vec<f64> = (0..3).flat_map(|row| [edge_1[row], edge_2[row], third[row]]).collect();
            let columns = [&case[..6], &matrix, &[0.0; 3]].concat();
            let corners = [&case[..6], &[0.0; 3], edge_1, edge_2].concat();
            let got = affine(UnitObject::Triangle, std::array::from_fn(|i| columns[i]), precision);
            let want = triangle(std::array::from_fn(|i| corners[i]), precision);
            // Whatever the third column is: without it the matrix has no inverse.
            if got != Truth::Invalid("singular") {
                assert_same(got, want, &case);
            }
        });
    }
}

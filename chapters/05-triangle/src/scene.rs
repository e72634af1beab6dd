//! The worked example: a triangle that leans back behind a view plane, and a ray with round numbers.

use math::{Ray3, Real};

use crate::Triangle;

/// p̄1 = (−2, −1, −3), p̄2 = (2, −1, −3) and p̄3 = (0, 2, −5): its upper corner is farther away. n = (0, 8, 12).
pub fn triangle<R: Real>() -> Triangle<R> {
    let v = |x, y, z| R::vec3(R::from(x), R::from(y), R::from(z));
    Triangle { p1: v(-2.0, -1.0, -3.0), p2: v(2.0, -1.0, -3.0), p3: v(0.0, 2.0, -5.0) }
}

/// Where the worked example's ray starts: x and y of p̄_ij. It hits at λ = 3, with α = 1/8 and β = 1/2.
pub const WORKED: (f64, f64) = (-0.125, 0.125);

/// CSC418's ray of a pixel (11.2): the eye ē is the origin, the view plane is z = −1, and the ray starts there, at
/// p̄_ij = (x, y, −1), in the direction d⃗ = p̄_ij − ē. What is hit at λ is λ + 1 times as far from the eye as p̄_ij.
pub fn view_ray<R: Real>((x, y): (f64, f64)) -> Ray3<R> {
    let p = R::vec3(R::round_from(x), R::round_from(y), R::from(-1.0));
    Ray3::new(p, p)
}

/// Where a point in front of the eye (z < 0) is seen on the view plane: its x and y there.
pub fn seen_at<R: Real>(point: R::Vec3) -> (f64, f64) {
    let [x, y, z]: [f64; 3] = R::xyz(point).map(Into::into);
    (x / -z, y / -z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Method;
    use glam::{DVec3, Vec3};
    use math::Span;

    /// By hand: p̄1 + ⅛ (4, 0, 0) + ½ (2, 3, −2) = (−½, ½, −4), four times (−⅛, ⅛, −1).
    #[test]
    fn the_worked_example_has_round_numbers_by_every_method() {
        assert_eq!(triangle::<f64>().normal(), DVec3::new(0.0, 8.0, 12.0));
        for method in Method::ALL {
            let work = method.work(&view_ray::<f64>(WORKED), &triangle());
            let hit = work.hit(Span::ahead()).unwrap().unwrap();
            assert_eq!((hit.t, hit.point), (3.0, DVec3::new(-0.5, 0.5, -4.0)), "{}", method.name());
            assert_eq!(work.alpha_beta(), Some((0.125, 0.5)), "{}", method.name());
            assert_eq!(seen_at::<f64>(hit.point), WORKED);
            let in_f32 =
                method.work(&view_ray::<f32>(WORKED), &triangle()).hit(Span::ahead()).unwrap().unwrap();
            assert_eq!((in_f32.t, in_f32.point), (3.0, Vec3::new(-0.5, 0.5, -4.0)), "{}", method.name());
        }
    }
}

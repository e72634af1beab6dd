//! Where the two solids are seen from, and one ray of each that comes out in short numbers.

use math::{Camera, Degenerate, Handedness, Ray3, Real, Vector, Window};

use crate::Shape;

/// Where the eye of a solid stands: beside it, at negative x, and above its middle, in the plane y = 0.
pub fn eye<R: Real>(shape: Shape) -> R::Vec3 {
    match shape {
        Shape::Cylinder => point::<R>([-3.0, 0.0, 3.5]),
        Shape::Cone => point::<R>([-2.0, 0.0, 1.0]),
    }
}

/// The worked example: a ray in the plane y = 0 whose candidates have fates of every kind.
///
/// The cylinder's meets the wall above the top, then the top, then the wall from inside, then the plane of the
/// bottom beyond the rim. The cone's meets the wall, then the base, then the wall's continuation below it.
pub fn worked<R: Real>(shape: Shape) -> Ray3<R> {
    let direction = match shape {
        Shape::Cylinder => point::<R>([1.0, 0.0, -1.0]),
        Shape::Cone => point::<R>([2.0, 0.0, -1.0]),
    };
    Ray3::new(eye::<R>(shape), direction)
}

/// The camera at [`eye`] that looks at the middle of the solid, with z up. The view plane stands through that
/// middle, so its window is in the units of the solid.
///
/// `half` is half the window's side there, above zero; [`Degenerate::NotFinite`] where it is infinite or NaN.
pub fn camera<R: Real>(shape: Shape, half: f64) -> Result<Camera<R>, Degenerate> {
    let middle = match shape {
        Shape::Cylinder => point::<R>([0.0, 0.0, 0.0]),
        Shape::Cone => point::<R>([0.0, 0.0, 0.5]),
    };
    let eye = eye::<R>(shape);
    let forward = middle - eye;
    let up = point::<R>([0.0, 0.0, 1.0]);
    let half = R::round_from(half);
    let window = Window { left: -half, right: half, bottom: -half, top: half };
    Camera::looking(eye, forward, up, Handedness::Right, forward.length(), window)
}

/// The point (x, y, z) in R.
fn point<R: Real>([x, y, z]: [f32; 3]) -> R::Vec3 {
    R::vec3(R::from(x), R::from(y), R::from(z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notes::{Fate, Test, notes};
    use math::Span;

    /// Each candidate's λ and fate, in the order of the page.
    fn fates(shape: Shape) -> Vec<(f64, Fate)> {
        let work = notes(&worked::<f64>(shape), shape);
        let lambdas = work.candidates().iter().filter_map(|candidate| candidate.lambda);
        lambdas.enumerate().map(|(place, lambda)| (lambda, work.fate(place, Span::ahead()))).collect()
    }

    #[test]
    fn the_worked_examples_drop_their_candidates_for_every_reason() {
        // by hand, (−3 + λ, 0, 3.5 − λ): x = 1 at λ = 4 and −1 at 2, where z = 1.5; z = 1 at 2.5 and −1 at 4.5, where x = 1.5
        let cylinder = [
            (4.0, Fate::Farther),
            (2.0, Fate::Dropped(Test::ZOutside)),
            (2.5, Fate::Nearest),
            (4.5, Fate::Dropped(Test::BeyondRim)),
        ];
        assert_eq!(fates(Shape::Cylinder), cylinder);
        // by hand, (−2 + 2λ, 0, 1 − λ): x = ±½λ at λ = 4/3 and 4/5; z = 0 at λ = 1, where x = 0
        let cone = [(4.0 / 3.0, Fate::Dropped(Test::ZOutside)), (0.8, Fate::Nearest), (1.0, Fate::Farther)];
        assert_eq!(fates(Shape::Cone), cone);
    }
}

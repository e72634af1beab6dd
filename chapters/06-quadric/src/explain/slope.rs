//! A ray along the cone's own slope, A = 0, and a published value that is wrong there.

use math::{Ray3, Real, Span};
use stage::Transcript;

use crate::{Shape, notes};

/// The published ray, moved to this cone.
///
/// The ray of the published case starts at (0, 0, −1) along (0, 1, 1)/√2, and its cone is x² + z² = y². With
/// (½z, ½x, 1 − |y|) for its (x, y, z) it is this cone: the same λ, and a residual a quarter as large.
pub(crate) fn published<R: Real>() -> Ray3<R> {
    let (zero, one, half) = (R::from(0.0), R::from(1.0), R::from(0.5));
    let step = one / R::from(2.0).sqrt();
    Ray3::new(R::vec3(-half, zero, one), R::vec3(half * step, zero, -step))
}

/// The linear root, the published one, and the residual of either.
pub(crate) fn along_the_slope<R: Real>(transcript: &mut Transcript) {
    let ray = published::<R>();
    let work = notes(&ray, Shape::Cone);
    let [right, ..] = work.candidates() else { return };
    let (Some(lambda), Ok(Some(hit))) = (right.lambda, work.hit(Span::ahead())) else { return };
    // With b = 2 B: not −c/b but −c/2b.
    let b = work.b + work.b;
    let wrong = -work.c / (b + b);
    let wall = |point: R::Vec3| Shape::Cone.wall::<R>(point);
    transcript
        .section("Along the cone's own slope: A = 0", "CSC418 11.3.5")
        .vector("ā", "where the ray starts", ray.origin)
        .vector("d⃗", "parallel to a line of the wall", ray.direction)
        .number("A", "d_x² + d_y² − ¼d_z²", work.a)
        .note("−B/A ± √D/A would divide by zero")
        .number("B", "a_x d_x + a_y d_y + ¼(1 − a_z) d_z", work.b)
        .number("C", "a_x² + a_y² − ¼(1 − a_z)²", work.c)
        .number("λ", "−C / 2B", lambda)
        .note("2 B λ + C = 0: linear, one root")
        .vector("p̄", "ā + λ d⃗", hit.point)
        .number("residual", "x² + y² − ¼(1 − z)²", wall(hit.point))
        .number("λ_published", "−c / 2b, b = 2B", wrong)
        .note("a root for −c / b")
        .vector("p̄", "ā + λ d⃗", ray.at(wrong))
        .number("residual", "x² + y² − ¼(1 − z)²", wall(ray.at(wrong)))
        .note("not on the cone")
        .remark("A published test case expects this root, in a cone twice as wide: x² + z² = y², from (0, 0, −1) along (0, 1, 1)/√2.")
        .remark("There the residual is four times as large, 0.5.");
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn as_published_the_root_along_the_slope_is_not_on_the_cone() {
        // by hand, on x² + z² = y² from (0, 0, −1) along (0, 1, 1)/√2: a = ½ − ½ = 0, b = −√2, c = 1.
        // −c/b = 1/√2 gives (0, ½, −½): ¼ − ¼ = 0. −c/2b = 1/√8 gives (0, ¼, −¾): 9/16 − 1/16 = ½.
        let ray = published::<f64>();
        let work = notes(&ray, Shape::Cone);
        assert_eq!((work.a, work.c), (0.0, 0.25));
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert!((hit.t - 0.5_f64.sqrt()).abs() < 1e-15);
        assert!((hit.point - DVec3::new(-0.25, 0.0, 0.5)).length() < 1e-15);
        let published = ray.at(hit.t / 2.0);
        // a quarter of ½: this cone is half as wide
        assert!((Shape::Cone.wall::<f64>(published) - 0.125).abs() < 1e-15);
    }
}

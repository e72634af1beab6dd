//! The chapter's scene: each of the five unit objects once, squashed, sheared, leaning or mirrored, and a set of
//! squashed spheres of every condition.
//!
//! Every number of the deformations is a few binary digits, so that `f32` and `f64` have the same scene.

use math::grid::centers;
use math::{Camera, Degenerate, Handedness, Ray3, Real, Span, Window};

use crate::{Affine, Deformed, Found, Matrix3, Method, Object};

/// An object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<R: Real> {
    /// What the picture calls it.
    pub name: &'static str,
    /// What was done to it.
    pub what: &'static str,
    /// Which unit object it is and where it goes, ready for rays.
    pub deformed: Deformed<R>,
    /// A point of the unit object that the eye sees: a ray of the set is aimed there.
    pub seen: [f64; 3],
    /// A point of the ground, in the world, under which the picture writes its name.
    pub foot: [f64; 3],
    /// Its color, red, green and blue from 0 to 255.
    pub color: [u8; 3],
}

/// The squashed sphere: half as high as wide, and its upper part pushed to the right.
///
/// By hand: A⁻¹ has the rows (1, −1, 0), (0, 2, 0), (0, 0, 1), and no two of A, A⁻¹ and A⁻ᵀ are the same, so that
/// a normal by the wrong one is seen to be wrong.
pub fn squashed<R: Real>() -> Affine<R> {
    affine([[1.0, 0.5, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 1.0]], [-2.5, 0.5, 0.0])
}

/// The five, the squashed sphere first and the ground last.
pub fn five<R: Real>() -> Result<[Placed<R>; 5], Degenerate> {
    Ok([
        Placed {
            name: "sphere",
            what: "squashed and sheared",
            deformed: Deformed::new(Object::Sphere, squashed())?,
            seen: [0.0, 0.6, 0.8],
            foot: [-2.5, 0.0, 0.75],
            color: [230, 159, 0],
        },
        Placed {
            name: "cylinder",
            what: "oval and leaning",
            deformed: Deformed::new(
                Object::Cylinder,
                affine([[0.625, 0.0, 0.25], [0.0, 0.0, 0.5], [0.0, -0.5, 0.0]], [-0.5, 0.5, 0.0]),
            )?,
            seen: [0.6, -0.8, 0.0],
            foot: [-0.75, 0.0, 0.5],
            color: [86, 180, 233],
        },
        Placed {
            name: "cone",
            what: "mirrored: det A < 0",
            deformed: Deformed::new(
                Object::Cone,
                affine([[1.25, 0.0, -0.375], [0.0, 0.0, 1.625], [0.0, 1.25, 0.0]], [1.125, 0.0, 0.0]),
            )?,
            seen: [0.0, 0.25, 0.5],
            foot: [1.125, 0.0, 0.625],
            color: [213, 94, 0],
        },
        Placed {
            name: "triangle",
            what: "its two sides and z, moved to a corner",
            deformed: Deformed::new(
                Object::Triangle,
                triangle([[2.0, 0.0, -0.5], [2.75, 0.25, 0.75], [3.0, 1.625, -0.25]]),
            )?,
            seen: [0.375, 0.375, 0.0],
            foot: [2.5, 0.0, 0.625],
            color: [0, 158, 115],
        },
        Placed {
            name: "plane",
            what: "laid down, its tiles sheared",
            deformed: Deformed::new(
                Object::Plane,
                affine([[1.0, 0.5, 0.5], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]], [0.0, 0.0, 0.0]),
            )?,
            seen: [1.0, -3.0, 0.0],
            foot: [11.0, 0.0, -25.0],
            color: [150, 150, 150],
        },
    ])
}

/// The object that a ray meets first at λ ≥ 0, and where. On a tie the earlier one. `None` where it meets
/// none; a ray that [`Ray3::check`] refuses meets none.
pub fn first<'a, R: Real>(
    method: Method,
    ray: &Ray3<R>,
    objects: impl IntoIterator<Item = &'a Placed<R>>,
) -> Option<(&'a Placed<R>, Found<R>)> {
    let mut first: Option<(&Placed<R>, Found<R>)> = None;
    for placed in objects {
        let Ok(Some(found)) = method.work(ray, &placed.deformed).found(Span::ahead()) else { continue };
        if first.is_none_or(|(_, nearest)| found.lambda < nearest.lambda) {
            first = Some((placed, found));
        }
    }
    first
}

/// The unit triangle deformed to any other: e1 = b − a, e2 = c − a and any third direction that is not in
/// their plane, here up the z axis. Chapter 05's matrix, by another name.
fn triangle<R: Real>(corners: [[f32; 3]; 3]) -> Affine<R> {
    let [a, b, c] = corners.map(|[x, y, z]| R::vec3(R::from(x), R::from(y), R::from(z)));
    let (e1, e2) = (b - a, c - a);
    let third = R::vec3(R::from(0.0), R::from(0.0), R::from(1.0));
    Affine { a: Matrix3 { columns: [e1, e2, third] }, t: a }
}

fn affine<R: Real>(rows: [[f32; 3]; 3], [x, y, z]: [f32; 3]) -> Affine<R> {
    let a = Matrix3::from_rows(rows.map(|row| row.map(R::from)));
    Affine { a, t: R::vec3(R::from(x), R::from(y), R::from(z)) }
}

/// The unit sphere squashed along q = (2, −1, 2)/3 until it is `condition` ≥ 1 times as wide as thick:
/// A = 1 − (1 − 1/condition) q qᵀ, rounded.
pub fn squashed_by<R: Real>(condition: f64) -> Affine<R> {
    let q = [2.0, -1.0, 2.0];
    let by = (1.0 - 1.0 / condition) / 9.0;
    let rows = [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| R::round_from(if i == j { 1.0 - by * q[i] * q[j] } else { -by * q[i] * q[j] }))
    });
    let zero = R::from(0.0);
    Affine { a: Matrix3::from_rows(rows), t: R::vec3(zero, zero, zero) }
}

/// A ray into that sphere along its flat side, made to be checked by hand: from (−2, −2, 1) + (0.8/condition) q along
/// (2, 2, −1), both at right angles to q but for that step.
///
/// In the sphere's own space it runs at the height 0.8 over the middle, where the unit sphere has the radius 0.6, and
/// it starts 3 away and goes 3 for each λ: −3 + 3 λ* = −0.6, so λ* = 0.8 at every condition, on paper.
pub fn into_the_squashed<R: Real>(condition: f64) -> Ray3<R> {
    let step = 0.8 / condition / 3.0;
    let [x, y, z] = [-2.0 + 2.0 * step, -2.0 - step, 1.0 + 2.0 * step].map(R::round_from);
    Ray3::new(R::vec3(x, y, z), R::vec3(R::from(2.0), R::from(2.0), R::from(-1.0)))
}

/// The eye, in the world: level, 2 above the ground, looking along −z at what stands around z = 0.
pub const EYE: [f64; 3] = [0.0, 2.0, 10.8];
/// How far the view plane is from the eye, in units of the world.
pub const F: f64 = 2.0;

/// The camera at [`EYE`] with a window on the view plane, y upward. [`Degenerate::NotFinite`] where a number
/// of the window is infinite or NaN.
pub fn camera<R: Real>(window: Window<R>) -> Result<Camera<R>, Degenerate> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let [x, y, z] = EYE.map(R::round_from);
    let (forward, up) = (R::vec3(zero, zero, -one), R::vec3(zero, one, zero));
    Camera::looking(R::vec3(x, y, z), forward, up, Handedness::Right, R::round_from(F), window)
}

/// Where the eye sees a point of the world before it, on the view plane: (x, y) in the units of the window. A
/// point level with the eye gives numbers that are not finite.
pub fn seen_at([x, y, z]: [f64; 3]) -> (f64, f64) {
    let depth = EYE[2] - z;
    ((x - EYE[0]) * F / depth, (y - EYE[1]) * F / depth)
}

/// The worked example, made to be checked by hand: the ray (−0.44, −0.24, −2) from the eye meets the squashed
/// sphere at λ = 5, where the unit sphere has n = (0, 0.6, 0.8).
pub fn worked<R: Real>(camera: &Camera<R>) -> Ray3<R> {
    camera.ray((R::round_from(-0.44), R::round_from(-0.24)))
}

/// The ray of a pixel, through its center (House 4.1), from the eye. `size` is (columns, rows), `pixel`
/// (column, row) from the top left; λ is 1 at the view plane.
pub fn pixel_ray<R: Real>(camera: &Camera<R>, size: (u32, u32), pixel: (u32, u32)) -> Ray3<R> {
    camera.ray(centers(&camera.window, size, pixel))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const WINDOW: Window<f64> = Window { left: -0.75, right: 0.75, bottom: -0.5, top: 0.5 };

    /// By hand: ā − t⃗ = (2.5, 1.5, 10.8), ā′ = (1, 3, 10.8), d⃗′ = (−0.2, −0.48, −2), so that
    /// r̄′(5) = (0, 0.6, 0.8), which is on the unit sphere, and A⁻ᵀ n⃗ = (0, 1.2, 0.8).
    #[test]
    fn the_worked_example_by_hand() {
        let ray = worked(&camera(WINDOW).unwrap());
        for method in Method::ALL {
            let objects = five().unwrap();
            let (placed, found) = first(method, &ray, &objects).unwrap();
            assert_eq!(placed.name, "sphere", "{}", method.name());
            assert!((found.lambda - 5.0).abs() < 1e-14, "{}: {}", method.name(), found.lambda);
            let n = DVec3::new(0.0, 1.2, 0.8).normalize();
            assert!((found.normal() - n).length() < 1e-14, "{}", method.name());
        }
    }

    /// By hand: λ* = 1 for a ray that is as long as the way, and from the eye nothing stands before these points.
    #[test]
    fn each_object_is_seen_where_it_says() {
        for method in Method::ALL {
            let objects = five::<f64>().unwrap();
            for placed in &objects {
                let deformed = &placed.deformed;
                let eye = DVec3::from(EYE);
                let ray = Ray3::<f64>::new(eye, deformed.affine.apply(placed.seen.into()) - eye);
                let (seen, found) = first(method, &ray, &objects).unwrap();
                assert_eq!(seen.name, placed.name, "{}", method.name());
                assert!((found.lambda - 1.0).abs() < 1e-14, "{} {}", placed.name, method.name());
                // what is seen of a solid is its outside
                let toward = found.normal().dot(ray.direction);
                assert!(deformed.object.is_flat() || toward < 0.0, "{} {}", placed.name, method.name());
            }
        }
    }

    /// By hand, see [`into_the_squashed`]. ā is off by a few roundings, which A⁻¹ multiplies by the condition.
    #[test]
    fn the_squashed_spheres_are_met_at_0_8() {
        for condition in [1.0, 1e3, 1e6] {
            let (ray, affine) = (into_the_squashed::<f64>(condition), squashed_by::<f64>(condition));
            let sphere = Deformed::new(Object::Sphere, affine).unwrap();
            for method in Method::ALL {
                let found = method.work(&ray, &sphere).found(Span::ahead()).unwrap().unwrap();
                let off = (found.lambda - 0.8).abs() / condition;
                assert!(off < 8.0 * f64::EPSILON, "{condition} {}: {off}", method.name());
            }
        }
    }

    #[test]
    fn the_eye_sees_a_point_where_its_ray_goes() {
        let ray = camera::<f64>(WINDOW).unwrap().ray(seen_at([1.5, 0.5, -3.0]));
        assert!((ray.at(13.8 / 2.0) - DVec3::new(1.5, 0.5, -3.0)).length() < 1e-14);
    }
}

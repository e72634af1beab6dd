//! Gambetta's three spheres and his `TraceRay` (Listing 2-4, Figures 2-10 and 2-11).

use math::grid::lattice;
use math::{Camera, Degenerate, Handedness, Ray3, Real, Span, Window};

use crate::{Method, Sphere};

/// A sphere with the color it is painted in, red, green and blue from 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Painted<R: Real> {
    /// What the page calls it.
    pub name: &'static str,
    /// Where it is.
    pub sphere: Sphere<R>,
    /// Its color.
    pub color: [u8; 3],
}

/// The centers of the three spheres, which all have radius 1: whole numbers, as the page has them.
pub const CENTERS: [[i32; 3]; 3] = [[0, -1, 3], [2, 0, 4], [-2, 0, 4]];

/// The background: white.
pub const BACKGROUND: [u8; 3] = [255, 255, 255];

/// The scene of Figure 2-10.
pub fn three_spheres<R: Real>() -> [Painted<R>; 3] {
    let painted = |name, [x, y, z]: [i32; 3], color| {
        let [x, y, z] = [x, y, z].map(|coordinate| R::from(coordinate as f32));
        Painted { name, sphere: Sphere { center: R::vec3(x, y, z), radius: R::from(1.0) }, color }
    };
    [
        painted("red", CENTERS[0], [255, 0, 0]),
        painted("blue", CENTERS[1], [0, 0, 255]),
        painted("green", CENTERS[2], [0, 255, 0]),
    ]
}

/// Gambetta's camera: at the origin, looking along +z with y up and x right, the view plane at
/// d = 1, its viewport 1 high and as wide as the picture's shape asks (1 for a square one). `size` is the
/// picture's, in pixels.
///
/// [`Degenerate::NotFinite`] for a picture without rows.
pub fn camera<R: Real>(size: (u32, u32)) -> Result<Camera<R>, Degenerate> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let [origin, forward, up] =
        [R::vec3(zero, zero, zero), R::vec3(zero, zero, one), R::vec3(zero, one, zero)];
    Camera::looking(origin, forward, up, Handedness::Left, one, Window::around_axis(one, size))
}

/// `TraceRay(O, D, t_min, t_max)` (Listing 2-4): which sphere the ray meets first within the span, by its
/// place in `spheres`, and at which t, in lengths of D.
///
/// `None`: none of them, and the pixel takes the background. On a tie the earlier sphere wins
/// (the listing's strict `<`). Neither the ray nor a sphere may be degenerate.
pub fn trace_ray<R: Real>(
    method: Method,
    ray: &Ray3<R>,
    spheres: &[Painted<R>],
    span: Span<R>,
) -> Option<(usize, R)> {
    let mut closest: Option<(usize, R)> = None;
    for (index, painted) in spheres.iter().enumerate() {
        let roots = method.work(ray, &painted.sphere).roots();
        let Some(t) = roots.and_then(|roots| roots.first_within(span)) else { continue };
        if closest.is_none_or(|(_, closest_t)| t < closest_t) {
            closest = Some((index, t));
        }
    }
    closest
}

/// A pixel whose ray touches a sphere without entering it, on paper: D = B² − A C is exactly 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tangent {
    /// Column and row.
    pub pixel: (u32, u32),
    /// Which sphere: its place in [`CENTERS`].
    pub sphere: usize,
}

/// The exactly tangent pixels of the lattice of a picture of `size` pixels, row by row.
///
/// In whole numbers: the ray of a pixel is (X, Y, Z) = (2 col − width, height − 2 row, 2 height), up
/// to its length, and a sphere of radius 1 around (a, b, c) has K = a² + b² + c² − 1 for CSC418's C.
/// D = (a X + b Y + c Z)² − K (X² + Y² + Z²) = 0 is for each row a quadratic in X, whose solutions
/// are pixels if its root is whole and the division leaves nothing.
pub fn tangents(size: (u32, u32)) -> Vec<Tangent> {
    let (width, height) = (i128::from(size.0), i128::from(size.1));
    let mut found = Vec::new();
    for row in 0..size.1 {
        let (y, z) = (height - 2 * i128::from(row), 2 * height);
        for (sphere, center) in CENTERS.iter().enumerate() {
            let [a, b, c] = center.map(i128::from);
            let k = a * a + b * b + c * c - 1;
            // (a² − K) X² + 2 a m X + (m² − K (Y² + Z²)) = 0 with m = b Y + c Z
            let m = b * y + c * z;
            let (first, half_second, third) = (a * a - k, a * m, m * m - k * (y * y + z * z));
            let discriminant = half_second * half_second - first * third;
            let Some(root) = whole_root(discriminant) else { continue };
            let mut columns: Vec<u32> = [-half_second - root, -half_second + root]
                .into_iter()
                .filter(|numerator| numerator % first == 0)
                .map(|numerator| numerator / first + width)
                .filter(|twice_col| twice_col % 2 == 0 && (0..2 * width).contains(twice_col))
                .map(|twice_col| (twice_col / 2) as u32)
                .collect();
            columns.sort_unstable();
            columns.dedup();
            found.extend(columns.into_iter().map(|col| Tangent { pixel: (col, row), sphere }));
        }
    }
    found
}

/// The square root of a square; `None` for any other number.
fn whole_root(square: i128) -> Option<i128> {
    square.checked_isqrt().filter(|root| root * root == square)
}

/// The ray of a pixel (column, row), row 0 on top, on Gambetta's lattice (Listings 2-2 and 2-3). Its
/// direction is not normalized: t = 1 on the viewport.
pub fn pixel_ray<R: Real>(camera: &Camera<R>, size: (u32, u32), pixel: (u32, u32)) -> Ray3<R> {
    camera.ray(lattice(&camera.window, size, pixel))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn seven_pixels_of_540_are_tangent() {
        let size = (540, 540);
        let pixels: Vec<_> = tangents(size).into_iter().map(|tangent| tangent.pixel).collect();
        // The tangent rays (X, Y, 1) of the red sphere satisfy 9X² + 8Y² + 6Y = 0, solved by
        // (0, 0), (±5/27, −1/18), (±2/9, −1/12), (±1/3, −1/4): X = (col − 270)/540, Y = (270 − row)/540.
        let expected = [(270, 270), (170, 300), (370, 300), (150, 315), (390, 315), (90, 405), (450, 405)];
        assert_eq!(pixels, expected);
        for (col, row) in expected {
            let (x, y) = (i64::from(col) - 270, 270 - i64::from(row));
            assert_eq!(9 * x * x + 8 * y * y + 6 * 540 * y, 0);
        }
    }

    #[test]
    fn no_tangent_pixel_is_left_out() {
        let size = (136, 108);
        let found: Vec<_> = tangents(size).into_iter().map(|tangent| tangent.pixel).collect();
        let (width, height) = (i64::from(size.0), i64::from(size.1));
        let mut searched = Vec::new();
        for (row, col) in (0..size.1).flat_map(|row| (0..size.0).map(move |col| (row, col))) {
            let direction = [2 * i64::from(col) - width, height - 2 * i64::from(row), 2 * height];
            let dot = |v: [i64; 3], w: [i64; 3]| v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
            let touches = |center: &[i32; 3]| {
                let center = center.map(i64::from);
                let (b, c) = (dot(direction, center), dot(center, center) - 1);
                b * b == dot(direction, direction) * c
            };
            searched.extend(CENTERS.iter().filter(|center| touches(center)).map(|_| (col, row)));
        }
        assert_eq!(found, searched);
        assert!(found.len() > 1);
    }

    #[test]
    fn all_methods_draw_the_same_picture_but_for_the_tangents() {
        let size = (540, 540);
        let camera = camera::<f64>(size).unwrap();
        let spheres = three_spheres::<f64>();
        let tangents: Vec<_> = tangents(size).into_iter().map(|tangent| tangent.pixel).collect();
        let mut differ = Vec::new();
        for row in 0..size.1 {
            for col in 0..size.0 {
                let ray = pixel_ray(&camera, size, (col, row));
                let seen = Method::ALL.map(|method| {
                    trace_ray(method, &ray, &spheres, Span::from_view_plane()).map(|(sphere, _)| sphere)
                });
                if seen.iter().any(|&sphere| sphere != seen[0]) {
                    differ.push((col, row));
                }
            }
        }
        assert!(differ.iter().all(|pixel| tangents.contains(pixel)), "{differ:?}");
        assert!(!differ.is_empty(), "some tangents are decided differently: that is what they are for");
    }

    #[test]
    fn the_nearest_sphere_is_seen_and_the_earlier_one_on_a_tie() {
        let at = |name, z| {
            let sphere = Sphere { center: DVec3::new(0.0, 0.0, z), radius: 1.0 };
            Painted { name, sphere, color: [0, 0, 0] }
        };
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let spheres = [at("far", 9.0), at("near", 5.0), at("near again", 5.0), at("too near", 1.5)];
        for method in Method::ALL {
            let seen = trace_ray(method, &ray, &spheres, Span::new(3.0, f64::INFINITY));
            // by hand: "too near" ends at z = 2.5, "near" begins at z = 4
            assert_eq!(seen, Some((1, 4.0)), "{}", method.name());
        }
    }
}

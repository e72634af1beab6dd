use super::*;

const COLORS: [Rgb; 2] = [Rgb::WHITE, Rgb::BLACK];

fn checker(mapping: Mapping) -> Textured {
    Textured { mapping, texture: Texture::Checker { colors: COLORS, scale: 1.0 } }
}

/// By hand: of n = y, x is the first of the two axes at right angles to it; v = y × x = −z.
#[test]
fn the_ground_has_x_and_minus_z() {
    let ground = Mapping::plane([0.0; 3], [0.0, 2.0, 0.0], None);
    assert_eq!(ground.uv([3.0, 0.0, 5.0], None), (3.0, -5.0));
    let checker = checker(ground);
    let at = |x, z| checker.at([x, 0.0, z], None);
    assert_eq!(at(0.5, -0.5), Rgb::WHITE);
    assert_eq!(at(1.5, -0.5), Rgb::BLACK);
    assert_eq!(at(-0.5, -0.5), Rgb::BLACK);
    assert_eq!(at(-0.5, 0.5), Rgb::WHITE);
}

/// By hand: of n = x, y is the first axis at right angles to it, and v = x × y = z; both count from the plane's point.
#[test]
fn a_plane_counts_from_its_point() {
    let wall = Mapping::plane([1.0, 2.0, 3.0], [3.0, 0.0, 0.0], None);
    assert_eq!(wall.uv([1.0, 7.0, 5.0], None), (5.0, 2.0));
    let ground = Mapping::plane([1.0, 2.0, 3.0], [0.0, 1.0, 0.0], None);
    assert_eq!(ground.uv([4.0, 2.0, 5.0], None), (3.0, -2.0));
}

/// By hand: atan2(z, x) of (0, 0, 1) is a quarter turn; the pole y = 1 is v = 0.
#[test]
fn a_sphere_has_longitude_and_latitude() {
    let sphere = Mapping::Sphere { back: None, center: [1.0, 0.0, 0.0], radius: 2.0 };
    let close = |(u, v): (f64, f64), (want_u, want_v): (f64, f64)| {
        assert!((u - want_u).abs() < 1e-15 && (v - want_v).abs() < 1e-15, "{u} {v}");
    };
    close(sphere.uv([3.0, 0.0, 0.0], None), (0.5, 0.5));
    close(sphere.uv([1.0, 0.0, 2.0], None), (0.75, 0.5));
    close(sphere.uv([1.0, 2.0, 0.0], None), (0.5, 0.0));
    // a little beyond the pole by rounding
    close(sphere.uv([1.0, -2.000000001, 0.0], None), (0.5, 1.0));
}

/// By hand: the matrix doubles x, so what is at 3 was at 1.5, in the second square.
#[test]
fn a_transform_carries_the_texture() {
    let a = Matrix3::from_rows([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let by = Affine { a, t: f64::vec3(0.0, 7.0, 0.0) };
    let ground = Mapping::plane([0.0; 3], [0.0, 1.0, 0.0], Some(Back::of(&by)));
    assert_eq!(ground.uv([3.0, 7.0, 0.0], None).0, 1.5);
}

/// By hand: a picture of 2 × 1, a red and a green pixel, covers two units.
#[test]
fn a_picture_repeats_from_its_top_left() {
    let pixels = vec![[255, 0, 0], [0, 51, 0]].into();
    let it =
        Textured { mapping: Mapping::Triangle, texture: Texture::Image { size: (2, 1), pixels, scale: 2.0 } };
    let (red, green) = (Rgb([1.0, 0.0, 0.0]), Rgb([0.0, 0.2, 0.0]));
    for (u, want) in [(0.0, red), (0.9, red), (1.0, green), (2.0, red), (-0.5, green), (-1e-300, green)] {
        assert_eq!(it.color(u, 0.25), want, "{u}");
    }
    assert_eq!(it.color(f64::NAN, f64::INFINITY), red, "at the horizon");
}

#[test]
fn far_away_there_are_still_squares() {
    let ground = checker(Mapping::plane([0.0; 3], [0.0, 1.0, 0.0], None));
    // every number from 2^53 on is even
    assert_eq!(ground.at([1e300, 0.0, -0.5], None), Rgb::WHITE);
    assert_eq!(ground.at([f64::INFINITY, 0.0, f64::INFINITY], None), Rgb::WHITE);
}

/// By hand, of the normal (1, 2, 2): x is the least of its axes, and x − n⃗/3 is along (4, −1, −1); n⃗ × that is along
/// (0, 1, −1). The first is √18 long and the second √2.
///
/// A component of n⃗, u⃗ or v⃗ is off by less than a dozen roundings, 6 ε, and so is their sum of products with a way
/// whose components are 6 together at most: 36 ε, and the roundings of that sum, 3 · 6 ε / 2.
#[test]
fn the_axes_of_a_slanted_plane_lie_in_it() {
    let slanted = Mapping::plane([1.0, 2.0, 3.0], [1.0, 2.0, 2.0], None);
    for (way, want) in [
        ([4.0, -1.0, -1.0], (18.0_f64.sqrt(), 0.0)),
        ([0.0, 1.0, -1.0], (0.0, 2.0_f64.sqrt())),
        ([1.0, 2.0, 2.0], (0.0, 0.0)),
    ] {
        let (u, v) = slanted.uv([1.0 + way[0], 2.0 + way[1], 3.0 + way[2]], None);
        let off = (u - want.0).abs().max((v - want.1).abs());
        assert!(off <= 45.0 * f64::EPSILON, "{way:?}: {u} {v}");
    }
}

/// By hand: 2⁵³ − 1 squares along u and 2 back along v are 2⁵³ − 3 together, which is odd. 2⁵³ + 1 would be
/// rounded to an even number.
#[test]
fn squares_are_told_apart_as_far_as_there_are_odd_numbers() {
    let largest_odd = (2.0_f64).powi(53) - 1.0;
    assert_eq!(checker(Mapping::Triangle).color(largest_odd, -2.0), Rgb::BLACK);
    assert_eq!(checker(Mapping::Triangle).color(largest_odd, -1.0), Rgb::WHITE);
}

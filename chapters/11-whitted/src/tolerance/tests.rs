use super::*;
use crate::lit_scenes::{all, picture};
use crate::render::Rendered;
use scene_file::Scene as File;
use signature::Method;

/// What a picture with the tolerance `e` is off `full` in a channel at most, and the rays it took. Both may be infinite, and
/// then they are the same.
fn off<R: Real>(full: &Rendered, file: &File, depth: u32, e: f64) -> (f64, u64) {
    let less = drawn::<R>(file, depth, Some(e));
    let pairs = full.radiance.iter().zip(&less.radiance).flat_map(|(a, b)| a.0.into_iter().zip(b.0));
    let off = pairs.map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() }).fold(0.0, f64::max);
    (off, less.counts.rays())
}

fn drawn<R: Real>(file: &File, depth: u32, e: Option<f64>) -> Rendered {
    picture::<R>(file, Method::Robust, depth, |required| required, e)
}

const TOLERANCES: [f64; 8] = [0.0, 1e-300, 1e-16, 1e-11, 1e-4, 0.03, 1.0, f64::MAX];

/// Whether any tolerance leaves rays out, when none leaves out too much.
fn stays_within<R: Real>(name: &str, file: &File, depth: u32) -> bool {
    let full = drawn::<R>(file, depth, None);
    let mut last = full.counts.rays();
    for e in TOLERANCES {
        let (off, rays) = off::<R>(&full, file, depth, e);
        assert!(off <= e, "{name} {} E = {e}: {off}", R::NAME);
        assert!(rays <= last, "{name} E = {e}: {rays} rays, {last} with a smaller E");
        last = rays;
    }
    last < full.counts.rays()
}

#[test]
fn the_picture_differs_by_no_more_than_e() {
    let mut fewer = 0;
    for (name, file) in all() {
        fewer += u32::from(stays_within::<f64>(&name, &file, 4));
        stays_within::<f32>(&name, &file, 3);
    }
    assert!(fewer > 20, "{fewer} scenes");
}

/// A mirror ball over a mirror floor, by its coefficients, its background and its light.
fn mirrors(mirror: f64, transmit: f64, background: f64, intensity: f64) -> File {
    let text = format!(
        "background = [{background:e}, 0.0, 0.0]\n[camera]\neye = [0, 1, 4]\nlook_at = [0, 0.5, 0]\n\
         [[light]]\nposition = [3, 5, 2]\nintensity = [{intensity:e}, {intensity:e}, 0.0]\n\
         [material.m]\nmirror = {mirror}\ntransmit = {transmit}\nspecular = 1.0\nshininess = 1e7\n\
         [[object]]\nmaterial = \"m\"\nplane = {{ point = [0, -0.5, 0], normal = [0, 1, 0] }}\n\
         [[object]]\nmaterial = \"m\"\nplane = {{ point = [0, 2.5, 0], normal = [0, 1, 0] }}\n\
         [[object]]\nmaterial = \"m\"\nsphere = {{ center = [0, 0.5, 0], radius = 1 }}\n"
    );
    File::from_toml("mirrors.toml", &text, std::path::Path::new("")).unwrap()
}

#[test]
fn a_background_brighter_than_the_lights_counts() {
    assert!(stays_within::<f64>("bright", &mirrors(0.5, 0.0, 1e6, 1.0), 8));
    assert!(stays_within::<f64>("dark", &mirrors(0.5, 0.0, 0.0, 1.0), 8));
}

#[test]
fn coefficients_may_sum_up_to_more_than_one() {
    for depth in [3, 9] {
        stays_within::<f64>("1 + 0.9", &mirrors(1.0, 0.9, 0.5, 1.0), depth);
        stays_within::<f32>("1 + 0.9", &mirrors(1.0, 0.9, 0.5, 1.0), depth);
    }
    // B(1) = 2^50 and more
    assert!(stays_within::<f64>("1, deep", &mirrors(1.0, 0.0, 0.5, 1.0), 50));
}

/// By hand: with L = r_a I_a C + I (r_d C + r_s) = 0.1 + (0.9 + 1) = 2 and r_g = 0.5, a background of 0.5:
/// B(3) = 2, B(2) = 2 + 1 = 3, B(1) = 2 + 1.5 = 3.5; with a background of 10: 10, 10 and 10.
#[test]
fn the_bound_by_hand() {
    for (background, expected) in [(0.5, [3.5, 3.0, 2.0]), (10.0, [10.0; 3])] {
        let scene =
            crate::from_file::scene::<f64>(&mirrors(0.5, 0.0, background, 1.0), None, Some(3)).unwrap();
        let tolerance = Tolerance::new(&scene, 0.1);
        for (depth, expected) in (1..).zip(expected) {
            let bound = tolerance.bound(depth).unwrap();
            assert!(bound >= expected && bound < expected * (1.0 + 1e-13), "{depth}: {bound}");
        }
        assert_eq!(tolerance.bound(4), None);
        assert!(tolerance.of_a_pixel() < 0.1 && tolerance.of_a_pixel() > 0.1 - 1e-10);
    }
}

/// An eye between two mirrors, of 0.1 each by themselves.
fn between_mirrors(mirror: f64) -> File {
    let text = format!(
        "[camera]\neye = [0, 0, 0]\nlook_at = [0, 0, 1]\nwindow = [-1e-3, 1e-3, -1e-3, 1e-3]\n\
         [material.m]\ndiffuse = 0\nmirror = {mirror}\n\
         [[object]]\nmaterial = \"m\"\nplane = {{ point = [0, 0, 1], normal = [0, 0, 1] }}\n\
         [[object]]\nmaterial = \"m\"\nplane = {{ point = [0, 0, -1], normal = [0, 0, 1] }}\n"
    );
    File::from_toml("mirrors.toml", &text, std::path::Path::new("")).unwrap()
}

/// By hand: between two mirrors of r_g = 1 and r_a I_a C = 0.1 each ray brings 0.1, and the bounds are what
/// comes: 0.5 at depth 1 of 5. Within 0.25 the rays of depth 4 and 5 can be left out, 0.2 together, and not
/// that of depth 3 too.
#[test]
fn between_two_mirrors_the_bound_is_what_comes() {
    let file = between_mirrors(1.0);
    let pixels = 16 * 12;
    let full = drawn::<f64>(&file, 5, None);
    assert_eq!(full.counts.rays(), 5 * pixels);
    for (e, by, rays) in [(0.0999, 0.0, 5), (0.1001, 0.1, 4), (0.25, 0.2, 3), (0.35, 0.3, 2), (0.45, 0.4, 1)]
    {
        let (off, less) = off::<f64>(&full, &file, 5, e);
        assert!((off - by).abs() < 1e-15, "E = {e}: {off}");
        assert_eq!(less, rays * pixels, "E = {e}");
    }
}

/// Where the bound overflows nothing is known about what is left out.
#[test]
fn a_bound_that_overflows_leaves_nothing_out() {
    let file = mirrors(1.0, 0.0, 1e308, 1e308);
    let full = drawn::<f64>(&file, 6, None);
    assert_eq!(off::<f64>(&full, &file, 6, f64::MAX), (0.0, full.counts.rays()));
    let scene = crate::from_file::scene::<f64>(&file, None, Some(6)).unwrap();
    assert_eq!(Tolerance::new(&scene, 1.0).bound(1), Some(f64::INFINITY));
}

/// A ray whose weight underflows may still meet a light of 1e308.
#[test]
fn a_weight_without_digits_counts_as_one_with_all_of_them() {
    let scene = crate::from_file::scene::<f64>(&mirrors(0.5, 0.0, 1e300, 0.0), None, Some(3)).unwrap();
    let tolerance = Tolerance::new(&scene, 0.0);
    assert!(tolerance.at_most(0.0, 2) >= f64::MIN_POSITIVE * 1e300);
}

/// By hand: between two mirrors of r_g = ½, B = 0.1, 0.15, 0.175 and 0.1875 from depth 5 up to 2, and the rays of those depths
/// count with 1/16, 1/8, 1/4 and 1/2: they bring 0.00625, 0.01875, 0.04375 and 0.09375 at most.
#[test]
fn a_ray_counts_with_the_coefficients_on_its_way() {
    let file = between_mirrors(0.5);
    for (e, rays) in
        [(0.006, 5), (0.007, 4), (0.018, 4), (0.019, 3), (0.043, 3), (0.044, 2), (0.093, 2), (0.094, 1)]
    {
        assert_eq!(drawn::<f64>(&file, 5, Some(e)).counts.rays(), rays * 16 * 12, "E = {e}");
    }
}

/// By hand: a plane that fills the picture sends two rays on, each of which sees the background and counts with ½. What one
/// may bring is gone when it has been left out; and where all is black both may be.
#[test]
fn what_one_ray_may_bring_is_not_there_for_the_next() {
    let of = |background: f64| {
        let text = format!(
            "background = [{background}, 0, 0]\n[camera]\neye = [0, 0, 0]\nlook_at = [0, 0, 1]\n\
             [material.m]\nambient = 0\ndiffuse = 0\nmirror = 0.5\ntransmit = 0.5\n\
             [[object]]\nmaterial = \"m\"\nplane = {{ point = [0, 0, 1], normal = [0, 0, 1] }}\n"
        );
        File::from_toml("two-ways.toml", &text, std::path::Path::new("")).unwrap()
    };
    for (background, e, rays) in [(1.0, 0.4, 3), (1.0, 0.6, 2), (1.0, 0.9, 2), (1.0, 1.1, 1), (0.0, 0.0, 1)] {
        let counts = drawn::<f64>(&of(background), 2, Some(e)).counts;
        assert_eq!(counts.rays(), rays * 16 * 12, "{background}, E = {e}");
        assert_eq!(counts.left_out, (3 - rays) * 16 * 12, "{background}, E = {e}");
    }
}

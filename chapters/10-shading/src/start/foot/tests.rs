//! The bounds against numbers that are never rounded: whole numbers as long as it takes.

mod curved;

use lab::Draw;
use math::{Exact, Ray3, Span};
use ray_plane::Plane;
use ray_sphere::Sphere;
use stage::Precision;
use triangle::Triangle;

use super::*;

type V = [Exact; 3];

fn exact(v: [f64; 3]) -> V {
    v.map(Exact::new)
}

fn minus(a: &V, b: &V) -> V {
    std::array::from_fn(|axis| a[axis].clone() - b[axis].clone())
}

fn cross(a: &V, b: &V) -> V {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone())
}

fn at_least_zero(x: Exact) -> bool {
    !x.is_negative()
}

/// Whether a point is no farther than `error` from a plane: (w⃗·n⃗)² ≤ e² n⃗·n⃗.
fn is_near_plane(w: &V, n: &V, error: f64) -> bool {
    let (along, e) = (Exact::dot(w, n), Exact::new(error));
    at_least_zero(e.clone() * e * Exact::dot(n, n) - along.clone() * along)
}

/// Whether a point at w⃗ from the center is no farther than `error` from a sphere: (r − e)² ≤ w⃗·w⃗ ≤ (r + e)².
fn is_near_sphere(w: &V, r: f64, error: f64) -> bool {
    let (r, e, squared) = (Exact::new(r), Exact::new(error), Exact::dot(w, w));
    let [low, high] = [r.clone() - e.clone(), r + e];
    at_least_zero(squared.clone() - low.clone() * low) && at_least_zero(high.clone() * high - squared)
}

/// Where a ray from somewhere outside lands on a shape, by the robust method.
fn landing<R: Real>(shape: &Shape<R>, draw: &mut Draw, target: [f64; 3], size: f64) -> Option<Landing<R>> {
    let away = draw.direction() * (size * draw.log_uniform(0.1, 1e3));
    let eye: [f64; 3] = std::array::from_fn(|axis| target[axis] + f64::xyz(away)[axis]);
    let [o, to] = [eye, target].map(|v| v.map(R::round_from)).map(|[x, y, z]| R::vec3(x, y, z));
    let ray = Ray3::new(o, to - o);
    ray.check().ok()?;
    let hit = shape.hit(Method::Robust, &ray, Span::ahead())?;
    let (point, face_normal) = (hit.point, hit.normal);
    let flat = Landing {
        object: 0,
        part: 0,
        lambda: hit.t,
        point,
        face_normal,
        normal: face_normal,
        alpha_beta: None,
    };
    Some(flat)
}

/// A place and a size, each of any of many powers of ten.
fn place(draw: &mut Draw) -> ([f64; 3], f64) {
    let size = draw.log_uniform(1e-6, 1e6);
    let far = size * draw.huge_or_tiny(1.0, 1e5);
    (f64::xyz(draw.direction()).map(|x| x * far), size)
}

fn vector<R: Real>(v: [f64; 3]) -> R::Vec3 {
    let [x, y, z] = v.map(R::round_from);
    R::vec3(x, y, z)
}

const CASES: usize = 2000;

fn spheres<R: Real>(precision: Precision) {
    let mut draw = Draw::new(1, "foot on spheres", precision);
    let mut landed = 0;
    for _ in 0..CASES {
        let (center, size) = place(&mut draw);
        let sphere = Sphere::<R> { center: vector::<R>(center), radius: R::round_from(size) };
        let Some(landing) = landing(&Shape::Sphere(sphere), &mut draw, center, size) else { continue };
        let foot = of(Method::Robust, &Shape::Sphere(sphere), None, &landing);
        let (c, r) = (exact(sphere.center.in_f64()), sphere.radius.into());
        assert!(is_near_sphere(&minus(&exact(foot.point), &c), r, foot.error), "{sphere:?} {foot:?}");
        // the rays start outside, or inside
        let [out, within] = foot.origins().map(|origin| minus(&exact(origin.in_f64()), &c));
        let squared = Exact::new(r) * Exact::new(r);
        assert!((squared.clone() - Exact::dot(&out, &out)).is_negative(), "{sphere:?} {foot:?}");
        // where it is far away for its size, there may be no number of R within
        if foot.offset() < 1e-3 * r {
            assert!((Exact::dot(&within, &within) - squared).is_negative(), "{sphere:?} {foot:?}");
        }
        landed += 1;
    }
    assert!(landed > CASES / 4, "{landed}");
}

fn planes<R: Real>(precision: Precision) {
    let mut draw = Draw::new(1, "foot on planes", precision);
    for _ in 0..CASES {
        let (point, size) = place(&mut draw);
        let length = draw.huge_or_tiny(1.0, 1e10);
        let plane = Plane::<R> {
            point: vector::<R>(point),
            normal: vector::<R>(f64::xyz(draw.direction() * length)),
        };
        let Some(landing) = landing(&Shape::Plane(plane), &mut draw, point, size) else { continue };
        let foot = of(Method::Robust, &Shape::Plane(plane), None, &landing);
        let (p, n) = (exact(plane.point.in_f64()), exact(plane.normal.in_f64()));
        on_flat(&foot, &p, &n, &format!("{plane:?}"));
    }
}

fn triangles<R: Real>(precision: Precision) {
    let mut draw = Draw::new(1, "foot on triangles", precision);
    let mut landed = 0;
    for _ in 0..CASES {
        let (center, size) = place(&mut draw);
        let mut corner = || {
            let from_center = f64::xyz(draw.direction());
            vector::<R>(std::array::from_fn(|axis| center[axis] + size * from_center[axis]))
        };
        let triangle = Triangle::<R> { p1: corner(), p2: corner(), p3: corner() };
        let corners = triangle.corners().map(Vector::in_f64::<3>);
        let middle =
            std::array::from_fn(|axis| (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3.0);
        let Some(landing) = landing(&Shape::Triangle(triangle), &mut draw, middle, size) else { continue };
        let foot = of(Method::Robust, &Shape::Triangle(triangle), None, &landing);
        let [p_1, p_2, p_3] = corners.map(exact);
        let n = cross(&minus(&p_2, &p_1), &minus(&p_3, &p_1));
        on_flat(&foot, &p_1, &n, &format!("{triangle:?}"));
        landed += 1;
    }
    assert!(landed > CASES / 4, "{landed}");
}

/// The foot is near the plane, and the rays start on its two sides.
fn on_flat<R: Real>(foot: &Foot<R>, p: &V, n: &V, what: &str) {
    assert!(is_near_plane(&minus(&exact(foot.point), p), n, foot.error), "{what} {foot:?}");
    let side = Exact::dot(&exact(foot.normal), n);
    assert!(!side.is_zero());
    let [out, within] = foot.origins().map(|origin| {
        let height = Exact::dot(&minus(&exact(origin.in_f64()), p), n);
        assert!(!height.is_zero(), "{what} {foot:?}");
        height.is_negative()
    });
    assert!(out != within && out == side.is_negative(), "{what} {foot:?}");
}

#[test]
fn no_sphere_is_farther_from_its_foot_than_is_said() {
    spheres::<f32>(Precision::F32);
    spheres::<f64>(Precision::F64);
}

/// Far from the origin of the world an origin is rounded along the surface too, and a sphere bends away from there.
#[test]
fn a_ray_into_a_far_sphere_starts_within() {
    let mut draw = Draw::new(1, "into a far sphere", Precision::F32);
    for _ in 0..50_000 {
        // just above a power of two half a unit of the last digit is as much of the number as it ever is
        let center = vector::<f32>([8193.0, 0.0, 0.0]);
        let sphere = Shape::Sphere(Sphere { center, radius: 1.0 });
        let normal = vector::<f32>(f64::xyz(draw.direction()));
        let landing = Landing {
            object: 0,
            part: 0,
            lambda: 1.0,
            point: center + normal,
            face_normal: normal,
            normal,
            alpha_beta: None,
        };
        let foot: Foot<f32> = of(Method::Robust, &sphere, None, &landing);
        let [_, within] = foot.origins();
        let from_center = minus(&exact(within.in_f64()), &exact(center.in_f64()));
        let beyond = Exact::dot(&from_center, &from_center) - Exact::new(1.0);
        assert!(beyond.is_negative(), "{center:?} {normal:?} {within:?}");
    }
}

#[test]
fn no_plane_is_farther_from_its_foot_than_is_said() {
    planes::<f32>(Precision::F32);
    planes::<f64>(Precision::F64);
}

#[test]
fn no_triangle_is_farther_from_its_foot_than_is_said() {
    triangles::<f32>(Precision::F32);
    triangles::<f64>(Precision::F64);
}

/// By hand: a landing a whole unit above the plane y = 0 is put on it, and a ray starts a very little above.
#[test]
fn a_foot_on_the_ground() {
    let ground =
        Shape::Plane(Plane::<f64> { point: vector::<f64>([0.0; 3]), normal: vector::<f64>([0.0, 3.0, 0.0]) });
    let up = vector::<f64>([0.0, 1.0, 0.0]);
    let point = vector::<f64>([7.0, 1.0, -2.0]);
    let landing =
        Landing { object: 0, part: 0, lambda: 1.0, point, face_normal: up, normal: up, alpha_beta: None };
    let foot = of(Method::Robust, &ground, None, &landing);
    assert_eq!((foot.point, foot.normal), ([7.0, 0.0, -2.0], [0.0, 1.0, 0.0]));
    // what the product (p̄ − p̄1)·n⃗ = 1 may be off, 8u + 16u, and 2⁻²¹² of 7 + 2
    assert_eq!((foot.error, foot.rounding), (24.0 * unit(53), 9.0 * 2.0_f64.powi(-212)));
    // from a landing that knows nothing better there is still an origin
    let far = Landing { point: vector::<f64>([0.0, 1e300, 0.0]), ..landing };
    let lost = of(Method::Robust, &Shape::Sphere(Sphere { center: far.point, radius: 1e308 }), None, &far);
    assert!(lost.origins().iter().all(|origin| origin.is_finite()), "{lost:?}");
}

/// By hand: a quarter above a triangle at right angles to each axis in turn. With a = (2, 2) and b = (1, 4) their product
/// is 8 − 2 = 6, and the sum of its parts 8 + 2 = 10.
#[test]
fn a_foot_on_a_triangle() {
    let (p_1, above, u) = ([1.0, 2.0, 3.0], 0.25, unit(53));
    for turns in 0..3 {
        let turned = |mut v: [f64; 3]| {
            v.rotate_right(turns);
            std::array::from_fn(|axis| p_1[axis] + v[axis])
        };
        let [p1, p2, p3] =
            [[0.0; 3], [2.0, 2.0, 0.0], [1.0, 4.0, 0.0]].map(|corner| vector::<f64>(turned(corner)));
        let triangle = Shape::Triangle(Triangle::<f64> { p1, p2, p3 });
        let put = Put::on(u, turned([0.5, 1.0, above]), [0.0; 3], &triangle, None);
        let mut normal = [0.0, 0.0, 1.0];
        normal.rotate_right(turns);
        assert_eq!((put.point, put.normal), (turned([0.5, 1.0, 0.0]), normal));
        assert_eq!(put.error, 24.0 * u * above + 8.0 * u * (10.0 * above) / 6.0);
    }
}

/// A foot that were not put back: p̄ itself is farther from its sphere than the foot's error says.
#[test]
fn the_point_of_the_hit_is_farther_off() {
    let mut draw = Draw::new(1, "not put back", Precision::F32);
    let sphere = Sphere::<f32> { center: vector::<f32>([0.0; 3]), radius: 1.0 };
    let far = (0..100).filter_map(|_| {
        let landing = landing(&Shape::Sphere(sphere), &mut draw, [0.0; 3], 1.0)?;
        let foot = of(Method::Robust, &Shape::Sphere(sphere), None, &landing);
        Some(!is_near_sphere(&exact(landing.point.in_f64()), 1.0, foot.error))
    });
    assert!(far.filter(|is_far| *is_far).count() > 20);
}

/// 1 + 2⁻²⁴ is half way to the next number of f32, and 1 + 2⁻⁵³ of f64.
#[test]
fn u_is_half_a_unit_of_the_last_digit() {
    assert_eq!((unit(24), unit(53)), ((2.0_f64).powi(-24), (2.0_f64).powi(-53)));
    assert_eq!(AWAY_FROM_ZERO, (2.0_f64).powi(-212));
}

/// By hand: |1| + |−2| + |4| = 7, so that w = 7 · 2⁻²⁴; of r = 2 that is w²/2 lower. And where w = 1 is more than r = ½
/// no more than w.
#[test]
fn how_much_lower_a_sphere_is_by_then() {
    assert_eq!(bend::<f32>([1.0, -2.0, 4.0], 2.0), 49.0 * (2.0_f64).powi(-49));
    assert_eq!(bend::<f32>([0.0, (2.0_f64).powi(24), 0.0], 0.5), 1.0);
}

/// By hand: the corners of a triangle in z = 0 go round so that its own normal is z. It is turned to the side of the
/// landing's, and left alone where that is of neither side.
#[test]
fn a_foot_has_its_normal_on_the_side_of_the_landing() {
    let [p1, p2, p3] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(vector::<f64>);
    let triangle = Shape::Triangle(Triangle { p1, p2, p3 });
    for (normal, want) in [([0.0, 0.0, 1.0], 1.0), ([0.0, 0.0, -1.0], -1.0), ([1.0, 0.0, 0.0], 1.0)] {
        let (point, normal) = (vector::<f64>([1.0, 2.0, 0.0]), vector::<f64>(normal));
        let landing =
            Landing { object: 0, part: 0, lambda: 1.0, point, face_normal: normal, normal, alpha_beta: None };
        let foot = of(Method::Robust, &triangle, None, &landing);
        assert_eq!((foot.point, foot.normal), ([1.0, 2.0, 0.0], [0.0, 0.0, want]));
    }
}

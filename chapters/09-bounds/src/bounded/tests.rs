//! Every bound against a scene by hand.

use super::*;
use crate::{Counts, Uncounted};
use affine::Deformed;
use glam::DVec3;
use math::{Camera, Grid, Handedness, Window};
use ray_plane::Plane;
use signature::Object;
use triangle::mesh::Mesh;

/// By hand: from the middle of a sphere of radius 2 the ray leaves it at λ = 2; a light at λ = 1 is
/// before that.
#[test]
fn as_printed_a_ray_within_the_volume_is_not_tested() {
    let volume = Sphere { center: DVec3::ZERO, radius: 2.0 };
    let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::X);
    let to_the_light = Span::new(0.0, 1.0);
    assert_eq!(robust(&ray, &volume).roots().unwrap().first_within(to_the_light), None, "as printed");
    assert!(!passes(&ray, &volume, Reach::of(to_the_light)));
    // what touches it from without does not pass: the ray is in it from 7 to 11
    let through = Ray3::<f64>::new(DVec3::X * -9.0, DVec3::X);
    for (reach, want) in
        [([0.0, 7.0], false), ([11.0, 20.0], false), ([0.0, 6.5], true), ([11.5, 20.0], true)]
    {
        assert_eq!(passes(&through, &volume, Reach { min: reach[0], max: reach[1] }), want, "{reach:?}");
    }
    // a ray ahead of the sphere, behind it and beside it does pass
    for (origin, span) in [(-9.0, Span::new(0.0, 6.9)), (-9.0, Span::new(11.1, 20.0)), (3.0, Span::ahead())] {
        assert!(passes(&Ray3::<f64>::new(DVec3::X * origin, DVec3::X), &volume, Reach::of(span)));
    }
    assert!(passes(&Ray3::<f64>::new(DVec3::Y * 2.1, DVec3::X), &volume, Reach::of(Span::<f64>::ahead())));
}

/// By hand, before an eye at the origin that looks along z through five columns and rows of 0.6: a unit
/// sphere from z = 4 to 6, the plane z = 9, a square of two faces at z = 7, one more unit sphere on the
/// right, and on the left an ellipsoid from z = 3 to 7. The parts are those objects, the third of them
/// two.
fn scene() -> Scene<f64> {
    let at = |x: f64| DVec3::new(x, 0.0, 5.0);
    let sphere = |x: f64| Shape::Sphere(Sphere { center: at(x), radius: 1.0 });
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 7.0));
    let square = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let longer = Matrix3::from_rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]]);
    let ellipsoid = Deformed::new(affine::Object::Sphere, Affine { a: longer, t: at(-3.0) }).unwrap();
    let shapes = [
        sphere(0.0),
        Shape::Plane(Plane { point: DVec3::Z * 9.0, normal: -DVec3::Z }),
        Shape::Mesh(square),
        sphere(3.0),
        Shape::Deformed(Box::new(ellipsoid)),
    ];
    let window = Window { left: -1.5, right: 1.5, bottom: -1.5, top: 1.5 };
    let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
    let objects = shapes.map(|shape| Object { id: None, shape }).to_vec();
    Scene { camera, grid: Grid::Centers, size: (5, 5), objects }
}

/// Every bound, by either formulas, each ray as it is and carried.
fn for_all(mut assert: impl FnMut(&Bounded<'_, f64>, &str)) {
    let scene = scene();
    for (formulas, method) in Formulas::ALL.into_iter().flat_map(|it| Method::ALL.map(|method| (it, method)))
    {
        let bounded = Bounded::by(formulas, &scene, method);
        let says = format!("{} by {}", method.name(), formulas.name());
        assert_eq!((bounded.parts(), bounded.formulas()), (6, formulas), "{says}");
        assert(&bounded, &says);
        assert(&bounded.carrying(), &format!("{says}, carried"));
    }
}

fn along_z(x: f64, y: f64) -> Ray3<f64> {
    Ray3::new(DVec3::new(x, y, 0.0), DVec3::Z)
}

#[test]
fn every_bound_has_the_first_hit_by_hand() {
    for_all(|bounded, says| {
        for (x, y, [min, max], want) in [
            (0.0, 0.0, [0.0, f64::INFINITY], Some((0, 0, 4.0))),
            (0.0, 0.0, [4.5, f64::INFINITY], Some((0, 0, 6.0))),
            (0.0, 0.0, [4.5, 5.5], None),
            (0.5, 0.25, [6.5, f64::INFINITY], Some((2, 2, 7.0))),
            (0.25, 0.5, [6.5, f64::INFINITY], Some((2, 3, 7.0))),
            (0.0, 0.0, [7.5, 9.0], Some((1, 1, 9.0))),
            (0.0, 0.0, [7.5, 8.5], None),
            (3.0, 0.0, [0.0, f64::INFINITY], Some((3, 4, 4.0))),
            (-3.0, 0.0, [0.0, f64::INFINITY], Some((4, 5, 3.0))),
            (8.0, 8.0, [0.0, f64::INFINITY], Some((1, 1, 9.0))),
        ] {
            let (ray, span) = (along_z(x, y), Span::new(min, max));
            let query = Query::new(ray, span);
            let first = bounded.first_hit(&ray, span, &mut Uncounted);
            assert_eq!(
                first.map(|it| (it.object, it.lambda)),
                want.map(|it| (it.0, it.2)),
                "{says} {x} {min}"
            );
            let found = bounded.find(&query, &mut Uncounted);
            assert_eq!(found.map(|it| it.part), want.map(|it| it.1), "{says} {x} {min}");
            let hit = found.and_then(|found| bounded.hit_of(&query, found));
            assert_eq!(hit.map(|hit| (hit.t, hit.point)), want.map(|it| (it.2, ray.at(it.2))), "{says} {x}");
            let any = bounded.any_part(&query, &mut Uncounted);
            assert_eq!(any.is_some(), want.is_some(), "{says} {x} {min}");
            assert!(any.is_none_or(|part| bounded.hits(part, &query, &mut Uncounted)), "{says} {x}");
            let hit_parts = (0..6).filter(|&part| bounded.hits(part, &query, &mut Uncounted));
            assert_eq!(hit_parts.clone().next().is_some(), want.is_some(), "{says} {x} {min}");
            assert!(hit_parts.clone().any(|part| want.is_some_and(|want| part == want.1)) || want.is_none());
        }
    });
}

/// The middle row: plane, ellipsoid, sphere, the other sphere, plane; and above it the plane alone.
#[test]
fn every_bound_sees_each_object_in_its_pixel() {
    for_all(|bounded, says| {
        for (pixel, object) in
            [((0, 2), 1), ((1, 2), 4), ((2, 2), 0), ((3, 2), 3), ((4, 2), 1), ((2, 0), 1), ((2, 4), 1)]
        {
            let seen = bounded.seen(pixel, &mut Uncounted).map(|first| first.object);
            assert_eq!(seen, Some(object), "{says} {pixel:?}");
        }
    });
}

/// From (0, 0, 4) on, on the first sphere: past it the square is 3 away, and within it its far side 2.
#[test]
fn what_a_ray_leaves_is_not_met_again_or_is_only_left() {
    let scene = scene();
    let ray = Ray3::<f64>::new(DVec3::Z * 4.0, DVec3::Z);
    for method in Method::ALL {
        let bounded = Bounded::new(&scene, method);
        for (leaves, want) in [
            (Leaves::Unknown, (0, 0.0)),
            (Leaves::Passes(0), (2, 3.0)),
            (Leaves::Passes(0).tried_idly(), (2, 3.0)),
            (Leaves::Within(0), (0, 2.0)),
            (Leaves::Within(0).tried_idly(), (0, 2.0)),
        ] {
            let query = Query { leaves, ..Query::new(ray, Span::ahead()) };
            let found = bounded.find(&query, &mut Uncounted).unwrap();
            let hit = bounded.hit_of(&query, found).unwrap();
            assert_eq!((found.part, hit.t), want, "{} {leaves:?}", method.name());
        }
    }
    assert_eq!(Leaves::Passes(0).tried_idly(), Leaves::PassesIdly(0));
}

/// By hand, along z: where there are bounds the plane, which has none, is tried first, and then the
/// sphere is nearer. All four bounds are asked; that of the square is passed too, where the nearest hit
/// so far does not count. Without bounds the sphere comes first, and nothing is nearer.
#[test]
fn as_much_is_tested_as_the_bounds_leave_over() {
    let scene = scene();
    for (method, counts) in [
        (Method::None, Counts { boxes: 0, tests: 6, hits: 1 }),
        (Method::Sphere, Counts { boxes: 4, tests: 4, hits: 2 }),
        (Method::Box, Counts { boxes: 4, tests: 2, hits: 2 }),
        (Method::Extents, Counts { boxes: 0, tests: 6, hits: 1 }),
    ] {
        let (bounded, mut counted) = (Bounded::new(&scene, method), Counts::default());
        let ray = along_z(0.25, 0.125);
        bounded.first_hit(&ray, Span::ahead(), &mut counted);
        assert_eq!(counted, counts, "{}", method.name());
    }
}

/// What every bound asks and what it saves, in scenes of chapter 08, by both formulas: how many of 400 rays of the eye hit
/// something, the bounds and the parts that were tested, and the sum of all λ to its last digit.
#[cfg(feature = "stage")]
#[test]
fn what_each_bound_takes() {
    fn lines<R: Real>(name: &str) -> String {
        let file = signature::stage::built_in(name).unwrap();
        let scene = signature::from_file::scene::<R>(&file, Some((64, 48))).unwrap();
        let pixels = lab::scenes::pixels(name, 5, scene.size, 400);
        let line = |formulas: Formulas, method: Method| {
            let (mut counts, bounded) = (Counts::default(), Bounded::by(formulas, &scene, method));
            let seen: Vec<First<R>> =
                pixels.iter().filter_map(|&pixel| bounded.seen(pixel, &mut counts)).collect();
            let lambdas: f64 = seen.iter().map(|first| first.lambda.into()).sum();
            let Counts { boxes, tests, hits } = counts;
            format!(
                "{name} {} {} {}: {} seen, {boxes} boxes, {tests} tests, {hits} hits, λ {lambdas:?}\n",
                R::NAME,
                formulas.name(),
                method.name(),
                seen.len()
            )
        };
        let of = |formulas| Method::ALL[1..].iter().map(move |&method| (formulas, method));
        let both = of(Formulas::Robust).chain(of(Formulas::Notes));
        both.map(|(formulas, method)| line(formulas, method)).collect()
    }
    let names = ["signature", "spheres", "teapot", "balls2", "rings2", "mount4"];
    insta::assert_snapshot!(names.map(|name| lines::<f64>(name) + &lines::<f32>(name)).concat());
}

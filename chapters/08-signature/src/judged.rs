//! The reference of `trade`, the robust methods at f64, against the exact oracle.

use lab::{Truth, oracle};
use math::{Ray3, Vector, Wide};

use crate::measure::SCENES;
use crate::{Method, Scene, Shape, from_file};

/// λ* of a shape, exactly: `None` for a miss. Not for polygons, whose test is judged in chapter 05.
fn true_lambda(shape: &Shape<f64>, ray: &Ray3<f64>) -> Option<Wide> {
    let precision = stage::Precision::F64;
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let with = |rest: &[f64]| -> Vec<f64> { o.iter().chain(&d).chain(rest).copied().collect() };
    let triangle = |it: &triangle::Triangle<f64>| {
        let corners = it.corners().map(Vector::in_f64::<3>);
        oracle::triangle(with(&corners.concat()).try_into().unwrap(), precision)
    };
    let truth = match shape {
        Shape::Plane(plane) => {
            let [p, n] = [plane.point, plane.normal].map(Vector::in_f64::<3>);
            oracle::plane(with(&[p, n].concat()).try_into().unwrap(), precision)
        }
        Shape::Sphere(sphere) => {
            let mut rest = sphere.center.in_f64::<3>().to_vec();
            rest.push(sphere.radius);
            oracle::sphere(with(&rest).try_into().unwrap(), precision)
        }
        Shape::Triangle(it) => triangle(it),
        Shape::Mesh(mesh) => {
            let faces = (0..mesh.faces().len()).map(|face| Shape::Triangle(mesh.triangle(face)));
            return faces.filter_map(|face| true_lambda(&face, ray)).reduce(smaller);
        }
        Shape::Solid(_) | Shape::Polygon(_) => unreachable!("not in the scenes that are judged"),
        Shape::OpenCone(cone) => {
            let [b, a] = [cone.base, cone.apex].map(Vector::in_f64::<3>);
            let ends = [&b[..], &[cone.base_radius], &a, &[cone.apex_radius]].concat();
            oracle::open_cone(with(&ends).try_into().unwrap(), 0.0, precision)
        }
        Shape::Deformed(deformed) => {
            let object = match deformed.object {
                affine::Object::Cylinder => oracle::UnitObject::Cylinder,
                affine::Object::Cone => oracle::UnitObject::Cone,
                _ => oracle::UnitObject::Sphere,
            };
            let rest = [deformed.affine.a.rows().concat(), deformed.affine.t.in_f64::<3>().to_vec()].concat();
            oracle::affine(object, with(&rest).try_into().unwrap(), precision)
        }
    };
    match truth {
        Truth::Hit { t, .. } => Some(t.fine),
        Truth::Miss(_) => None,
        Truth::Invalid(reason) => panic!("{reason}"),
    }
}

fn smaller(a: Wide, b: Wide) -> Wide {
    if (b - a).is_negative() { b } else { a }
}

/// The object with the smallest true λ*, and of several the earliest.
fn truly_seen(scene: &Scene<f64>, ray: &Ray3<f64>) -> Option<usize> {
    let mut first: Option<(usize, Wide)> = None;
    for (object, it) in scene.objects.iter().enumerate() {
        let Some(lambda) = true_lambda(&it.shape, ray) else { continue };
        if first.is_none_or(|(_, best)| (lambda - best).is_negative()) {
            first = Some((object, lambda));
        }
    }
    first.map(|(object, _)| object)
}

/// Every pixel of small pictures, without their polygons: those of more than three corners.
#[test]
fn the_reference_sees_what_is_true() {
    for scene in SCENES.iter().filter(|scene| scene.name != "gears1" && scene.name != "teapot") {
        let file = scene.file().unwrap();
        let mut scene_64 = from_file::scene::<f64>(&file, Some((16, 12))).unwrap();
        scene_64.objects.retain(|object| !matches!(object.shape, Shape::Polygon(_)));
        let mut seen = 0;
        for (row, col) in (0..12).flat_map(|row| (0..16).map(move |col| (row, col))) {
            let (robust, truth) =
                (scene_64.seen(Method::Robust, (col, row)), truly_seen(&scene_64, &scene_64.ray((col, row))));
            assert_eq!(robust, truth, "{} {col},{row}", scene.name);
            seen += usize::from(truth.is_some());
        }
        assert!(seen > 8, "{}: {seen}", scene.name);
    }
}

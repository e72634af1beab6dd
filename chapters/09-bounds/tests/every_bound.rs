//! Scenes with every shape, by every kind of bound, against the loop of the signature.

use affine::{Affine, Deformed, Matrix3, Object as Unit};
use math::{Camera, Grid, Handedness, Ray3, Real, Span, Window};
use quadric::open::OpenCone;
use ray_plane::Plane;
use ray_sphere::Sphere;
use signature::{Method as Formulas, Object, Scene, Shape, first_hit};
use triangle::Triangle;
use triangle::mesh::ball::bumpy_ball;
use triangle::polygon::Polygon;

use bounds::{Bounded, Method, Uncounted};

/// Numbers that are the same on every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound
    }

    /// From 0 to 1.
    fn unit(&mut self) -> f64 {
        self.below(1 << 31) as f64 / (1u64 << 31) as f64
    }

    /// From −1 to 1.
    fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A vector with components from −size to size; now and then some of them zero, or whole.
    fn vector<R: Real>(&mut self, size: f64) -> R::Vec3 {
        let kind = self.below(6);
        let mut component = || match kind {
            0 if self.below(2) == 0 => 0.0,
            1 => (self.signed() * 3.0).round() * size,
            _ => self.signed() * size,
        };
        let [x, y, z] = [component(), component(), component()].map(R::round_from);
        R::vec3(x, y, z)
    }
}

fn number<R: Real>(numbers: &mut Numbers, size: f64) -> R {
    R::round_from(size * numbers.signed())
}

/// A unit object by a random matrix, now and then one that squashes a million times.
fn deformed<R: Real>(numbers: &mut Numbers) -> Option<Shape<R>> {
    let object = [Unit::Sphere, Unit::Cylinder, Unit::Cone][numbers.below(3) as usize];
    let squash = if numbers.below(4) == 0 { 1e-6 } else { 1.0 };
    let mut rows = [[R::from(0.0); 3]; 3];
    for (row, size) in rows.iter_mut().zip([1.0, 1.0, squash]) {
        *row = [0, 1, 2].map(|_| number(numbers, size));
    }
    let by = Affine { a: Matrix3::from_rows(rows), t: numbers.vector::<R>(4.0) };
    Some(Shape::Deformed(Box::new(Deformed::new(object, by).ok()?)))
}

/// A star in a plane across an axis or askew.
fn polygon<R: Real>(numbers: &mut Numbers) -> Option<Shape<R>> {
    const STAR: [[f32; 2]; 5] = [[0.0, 1.0], [-0.59, -0.81], [0.95, 0.31], [-0.95, 0.31], [0.59, -0.81]];
    let middle = numbers.vector::<R>(4.0);
    let [u, v] = [(); 2].map(|()| numbers.vector::<R>(1.0));
    let corners = STAR.map(|[x, y]| middle + u * R::from(x) + v * R::from(y));
    Polygon::new(corners.to_vec()).ok().map(Shape::Polygon)
}

/// A ray with nothing wrong about it.
fn any_ray<R: Real>() -> Ray3<R> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    Ray3::new(R::vec3(zero, zero, zero), R::vec3(zero, zero, one))
}

fn open_cone<R: Real>(numbers: &mut Numbers) -> Option<Shape<R>> {
    let radii = if numbers.below(2) == 0 { [0.4, 0.4] } else { [0.7, 0.0] }.map(R::round_from);
    let base = numbers.vector::<R>(4.0);
    let cone = OpenCone::new(base, radii[0], base + numbers.vector::<R>(1.5), radii[1]);
    cone.check(&any_ray()).ok().map(|()| Shape::OpenCone(cone))
}

/// One of each shape in turn; what happens to be no shape is left out, and the first is there several times.
fn objects<R: Real>(numbers: &mut Numbers, count: usize) -> Vec<Object<R>> {
    let mut shapes: Vec<Shape<R>> = Vec::new();
    for kind in (0..count).map(|at| at % 10) {
        let shape = match kind {
            0 => polygon(numbers),
            1 => open_cone(numbers),
            2 | 3 => deformed(numbers),
            4 => Some(Shape::Sphere(Sphere {
                center: numbers.vector::<R>(4.0),
                radius: R::round_from(0.1 + numbers.unit()),
            })),
            5 => {
                let p1 = numbers.vector::<R>(4.0);
                let triangle =
                    Triangle { p1, p2: p1 + numbers.vector::<R>(1.0), p3: p1 + numbers.vector::<R>(1.0) };
                triangle.check(&any_ray()).ok().map(|()| Shape::Triangle(triangle))
            }
            6 if shapes.len() < 10 => Some(Shape::Mesh(bumpy_ball::<R>(1, [1.0, -2.0, 0.5]))),
            7 => Some(Shape::Solid(
                [quadric::Shape::Cylinder, quadric::Shape::Cone][numbers.below(2) as usize],
            )),
            8 if shapes.len() < 20 => {
                let normal = R::vec3(number(numbers, 0.1), R::from(1.0), number(numbers, 0.1));
                Some(Shape::Plane(Plane {
                    point: R::vec3(R::from(0.0), number(numbers, 5.0), R::from(0.0)),
                    normal,
                }))
            }
            _ => shapes.first().cloned(),
        };
        shapes.extend(shape);
    }
    shapes.into_iter().map(|shape| Object { id: None, shape }).collect()
}

fn random_scene<R: Real>(numbers: &mut Numbers, count: usize, wide: f64) -> Option<Scene<R>> {
    let grid = Grid::ALL[numbers.below(3) as usize];
    let size = [(2, 2), (9, 5), (61, 47), (160, 3)][numbers.below(4) as usize];
    let f = R::from(1.0);
    let (x, y) = (wide * numbers.signed(), wide * numbers.signed());
    let half = wide * (0.05 + numbers.unit());
    let window = Window {
        left: R::round_from(x - half),
        right: R::round_from(x + half),
        bottom: R::round_from(y - half),
        top: R::round_from(y + half),
    };
    let away = [1.0, 9.0][numbers.below(2) as usize];
    let eye = numbers.vector::<R>(away);
    let hand = [Handedness::Right, Handedness::Left][numbers.below(2) as usize];
    let camera =
        Camera::looking(eye, numbers.vector::<R>(1.0), numbers.vector::<R>(1.0), hand, f, window).ok()?;
    Some(Scene { camera, grid, size, objects: objects(numbers, count) })
}

/// What is seen by each method in each pixel, and by rays anywhere in spans of any kind.
fn assert_all_agree<R: Real>(numbers: &mut Numbers, scene: &Scene<R>) -> usize {
    let methods = Method::ALL.map(|method| (method, Bounded::new(scene, method)));
    let mut hits = 0;
    for (row, col) in (0..scene.size.1).flat_map(|row| (0..scene.size.0).map(move |col| (row, col))) {
        let ray = scene.ray((col, row));
        let expected = first_hit(Formulas::Robust, &ray, &scene.objects, Span::ahead());
        for (method, bounded) in &methods {
            let seen = bounded.seen((col, row), &mut Uncounted);
            let Scene { camera, grid, size, .. } = scene;
            let what = || expected.map(|first| scene.objects[first.object].shape.name());
            assert_eq!(
                seen,
                expected,
                "{} {col},{row} {size:?} {grid:?} {camera:?} {:?}",
                method.name(),
                what()
            );
        }
        hits += usize::from(expected.is_some());
    }
    for _ in 0..200 {
        let ray = Ray3::new(numbers.vector::<R>(4.0), numbers.vector::<R>(1.0));
        if ray.check().is_err() {
            continue;
        }
        let (min, length) = (4.0 * numbers.unit(), 2.0 * numbers.unit());
        let all = Span::ahead();
        let of = |min: f64, max: f64| Span::new(R::round_from(min), R::round_from(max));
        // and to the very hit, from the very hit
        let first =
            first_hit(Formulas::Robust, &ray, &scene.objects, all).map_or(R::from(1.0), |first| first.lambda);
        let mut spans = vec![all, of(0.0, length), of(min, min + length), of(min, f64::INFINITY)];
        spans.extend([Span::new(all.min, first), Span::new(first, all.max), Span::new(first, first)]);
        for span in spans {
            let expected = first_hit(Formulas::Robust, &ray, &scene.objects, span);
            for (method, bounded) in &methods {
                let found = bounded.first_hit(&ray, span, &mut Uncounted);
                let what = || expected.map(|first| scene.objects[first.object].shape.name());
                assert_eq!(found, expected, "{} {span:?} {ray:?} {:?}", method.name(), what());
            }
        }
    }
    hits
}

fn scenes<R: Real>(seed: u64, wide: f64, count: usize) {
    let mut numbers = Numbers(seed);
    let mut hits = 0;
    for _ in 0..count {
        let objects = [3, 10, 40][numbers.below(3) as usize];
        let Some(scene) = random_scene::<R>(&mut numbers, objects, wide) else { continue };
        hits += assert_all_agree(&mut numbers, &scene);
    }
    assert!(hits > 50 * count, "{hits}");
}

#[test]
fn every_bound_sees_what_the_signature_sees() {
    scenes::<f64>(1, 1.0, 12);
    scenes::<f32>(2, 1.0, 12);
}

/// Nearly along the plane of the eye, where what is rounded of a direction is many pixels, or more than its
/// way into the scene.
#[test]
fn windows_that_are_very_wide() {
    for (at, wide) in [1e2, 1e4, 1e7, 1e9].into_iter().enumerate() {
        scenes::<f32>(at as u64, wide, 6);
    }
    for (at, wide) in [1e4, 1e8, 1e15, 1e17].into_iter().enumerate() {
        scenes::<f64>(at as u64, wide, 6);
    }
}

/// A sphere so far away that the notes' discriminant has no digit left, and rays that pass at any part of its
/// box. What the notes see they see by every bound.
#[test]
fn by_the_notes_every_bound_sees_the_same() {
    let mut numbers = Numbers(3);
    let radius = 1e-8;
    let tiny = Shape::Sphere(Sphere { center: glam::DVec3::ZERO, radius });
    let mut scene = random_scene::<f64>(&mut numbers, 1, 1.0).unwrap();
    scene.objects = vec![Object { id: None, shape: tiny.clone() }];
    let methods = Method::ALL.map(|method| (method, Bounded::by(Formulas::Notes, &scene, method)));
    let mut wrong = 0;
    for _ in 0..2000 {
        let [x, y, z] = [(); 3].map(|()| 1.5 * radius * numbers.signed());
        let origin = glam::DVec3::new(9.0 * numbers.signed(), 7.0, 5.0);
        let ray = Ray3::<f64>::new(origin, (glam::DVec3::new(x, y, z) - origin).normalize());
        let expected = methods[1].1.first_hit(&ray, Span::ahead(), &mut Uncounted);
        for (method, bounded) in &methods {
            let found = bounded.first_hit(&ray, Span::ahead(), &mut Uncounted);
            assert_eq!(found, expected, "{} {ray:?}", method.name());
        }
        let is_met = tiny.hit(Formulas::Robust, &ray, Span::ahead()).is_some();
        wrong += u32::from(expected.is_some() && !is_met);
    }
    assert!(methods[1].0 == Method::None && wrong > 100, "{wrong}");
}

//! How a case of each regime is drawn: a triangle, a point of its plane, and a ray aimed at it.

use lab::{Draw, Vec3};
use math::{Ray3, Real};

use crate::Triangle;

/// A ray and a triangle.
pub(super) struct Scene {
    ray: Ray3<f64>,
    triangle: Triangle<f64>,
}

impl Scene {
    /// The columns of a case file.
    pub(super) fn numbers(&self) -> [f64; 15] {
        let Scene { ray: Ray3 { origin: o, direction: d }, triangle: Triangle { p1, p2, p3 } } = self;
        let vectors = [o, d, p1, p2, p3].map(|v| v.to_array());
        std::array::from_fn(|i| vectors[i / 3][i % 3])
    }

    /// Everything elsewhere.
    fn moved(mut self, by: Vec3) -> Scene {
        let Triangle { p1, p2, p3 } = &mut self.triangle;
        [&mut self.ray.origin, p1, p2, p3].into_iter().for_each(|point| *point += by);
        self
    }

    /// Every length times a factor, the direction as it is.
    fn scaled(mut self, factor: f64) -> Scene {
        let Triangle { p1, p2, p3 } = &mut self.triangle;
        [&mut self.ray.origin, p1, p2, p3].into_iter().for_each(|point| *point *= factor);
        self
    }

    /// The direction times a factor.
    fn with_direction_times(mut self, factor: f64) -> Scene {
        self.ray.direction *= factor;
        self
    }
}

/// How far the triangle is from the world's origin on every axis, if nothing else is said.
const SPREAD: f64 = 10.0;

/// A triangle of about this size, no sliver, around a point within `spread`, in numbers of the precision.
fn triangle(draw: &mut Draw, spread: f64, size: f64) -> Triangle<f64> {
    let center = draw.in_cube(spread);
    loop {
        let [p1, p2, p3] = std::array::from_fn(|_| {
            let corner = center + draw.direction() * size;
            draw.rounded_vector(corner)
        });
        let triangle = Triangle::<f64> { p1, p2, p3 };
        // twice the area of one with equal sides would be 2.6 size²
        if triangle.normal().length() > 0.25 * size * size {
            return triangle;
        }
    }
}

/// p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1)
fn point(triangle: &Triangle<f64>, alpha: f64, beta: f64) -> Vec3 {
    let Triangle { p1, p2, p3 } = *triangle;
    p1 + (p2 - p1) * alpha + (p3 - p1) * beta
}

/// A point of the plane that is in the triangle half of the time, and never far from it.
fn point_about(draw: &mut Draw, triangle: &Triangle<f64>) -> Vec3 {
    let (alpha, beta) = (draw.uniform(-0.1, 0.9), draw.uniform(-0.1, 0.9));
    point(triangle, alpha, beta)
}

/// A point of an edge, anywhere on it.
fn point_of_edge(draw: &mut Draw, triangle: &Triangle<f64>) -> Vec3 {
    let [a, b, c] = triangle.corners();
    let (from, to) = [(a, b), (b, c), (c, a)][draw.below(3) as usize];
    from + (to - from) * draw.uniform(0.0, 1.0)
}

/// A ray of a unit direction from so far away toward a point. The origin is rounded first, so that the aim holds at
/// either precision.
fn aimed(draw: &mut Draw, triangle: Triangle<f64>, target: Vec3, distance: f64) -> Scene {
    let origin = target - draw.direction() * distance;
    let origin = draw.rounded_vector(origin);
    Scene { ray: Ray3::<f64>::new(origin, (target - origin).normalize()), triangle }
}

/// Size 0.1 to 5.
fn size(draw: &mut Draw) -> f64 {
    draw.uniform(0.1, 5.0)
}

/// Numbers as pictures have them.
pub(super) fn ordinary(draw: &mut Draw) -> Scene {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let (target, distance) = (point_about(draw, &triangle), draw.uniform(5.0, 40.0));
    aimed(draw, triangle, target, distance)
}

/// A direction of another length than 1.
pub(super) fn unnormalized(draw: &mut Draw) -> [f64; 15] {
    let length = draw.log_uniform(1e-6, 1e6);
    ordinary(draw).with_direction_times(length).numbers()
}

/// Away from the triangle.
pub(super) fn behind(draw: &mut Draw) -> [f64; 15] {
    ordinary(draw).with_direction_times(-1.0).numbers()
}

/// Toward an edge. Only the direction is rounded, and the point: which side it passes on is chance.
pub(super) fn edge(draw: &mut Draw) -> [f64; 15] {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let (target, distance) = (point_of_edge(draw, &triangle), draw.uniform(5.0, 40.0));
    aimed(draw, triangle, target, distance).numbers()
}

/// Toward a corner, where two edges are to be decided.
pub(super) fn vertex(draw: &mut Draw) -> [f64; 15] {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let (corner, distance) = (triangle.corners()[draw.below(3) as usize], draw.uniform(5.0, 40.0));
    aimed(draw, triangle, corner, distance).numbers()
}

/// A vector of whole numbers, none above `most`.
fn whole(draw: &mut Draw, most: i32) -> Vec3 {
    let [x, y, z] = std::array::from_fn(|_| draw.whole(-most, most));
    f64::vec3(x, y, z)
}

/// An edge of some equal steps of whole numbers, and a ray of some equal steps to the end of one of them: no rounding
/// disturbs either, and the ray meets the edge or the corner exactly.
pub(super) fn edge_exact(draw: &mut Draw) -> [f64; 15] {
    loop {
        let [a, step, c] = [50, 9, 50].map(|most| whole(draw, most));
        let steps = draw.below(8);
        let b = a + step * (steps + 1) as f64;
        let target = a + step * draw.below(steps + 2) as f64;
        let direction = whole(draw, 9);
        let origin = target - direction * draw.whole(0, 8);
        let corners = [[a, b, c], [c, a, b], [b, c, a]][draw.below(3) as usize];
        let triangle = Triangle::<f64> { p1: corners[0], p2: corners[1], p3: corners[2] };
        if triangle.normal().dot(direction) != 0.0 {
            return Scene { ray: Ray3::<f64>::new(origin, direction), triangle }.numbers();
        }
    }
}

/// A triangle so many times as long as high.
pub(super) fn sliver(draw: &mut Draw, aspect: f64, aspect_at_f32: f64) -> [f64; 15] {
    let (along, length) = (draw.direction(), draw.uniform(1.0, 5.0));
    let height = draw.perpendicular(along) * (length / draw.by_precision(aspect, aspect_at_f32));
    let a = draw.in_cube(SPREAD);
    let (b, c) = (a + along * length, a + along * (length * draw.uniform(0.0, 1.0)) + height);
    let corners = [[a, b, c], [c, a, b], [b, c, a]][draw.below(3) as usize];
    let [p1, p2, p3] = corners.map(|corner| draw.rounded_vector(corner));
    let triangle = Triangle::<f64> { p1, p2, p3 };
    let (target, distance) = (point_about(draw, &triangle), draw.uniform(5.0, 40.0));
    aimed(draw, triangle, target, distance).numbers()
}

/// All but along the plane.
pub(super) fn grazing(draw: &mut Draw) -> [f64; 15] {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let n = triangle.normal().normalize();
    let least = draw.by_precision(1e-12, 1e-6);
    let fall = n * (draw.sign() * draw.log_uniform(least, 1e-2));
    let direction = draw.perpendicular(n) + fall;
    let (target, distance) = (point_about(draw, &triangle), draw.uniform(5.0, 40.0));
    Scene { ray: Ray3::<f64>::new(target - direction * distance, direction), triangle }.numbers()
}

/// Along the plane in whole numbers, beside it or within it, which no rounding disturbs; and most of the time one
/// number beside that. Only an exact d · n tells them apart.
pub(super) fn parallel(draw: &mut Draw) -> [f64; 15] {
    loop {
        let [a, e1, e2] = [50, 20, 20].map(|most| whole(draw, most));
        let [i, j, k, l] = std::array::from_fn(|_| draw.whole(-5, 5));
        let direction = e1 * i + e2 * j;
        let beside = if draw.coin() { whole(draw, 9) } else { Vec3::ZERO };
        let triangle = Triangle::<f64> { p1: a, p2: a + e1, p3: a + e2 };
        if direction != Vec3::ZERO && triangle.normal() != Vec3::ZERO {
            let ray = Ray3::<f64>::new(a + e1 * k + e2 * l + beside, direction);
            return draw.nudged(Scene { ray, triangle }.numbers());
        }
    }
}

/// So many sizes away.
pub(super) fn far(draw: &mut Draw) -> [f64; 15] {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let farthest = draw.by_precision(1e8, 1e4);
    let (target, sizes) = (point_about(draw, &triangle), draw.log_uniform(1e2, farthest));
    aimed(draw, triangle, target, sizes * size).numbers()
}

/// A triangle smaller than anything around it. At f32 it is near the world's origin: elsewhere there are no numbers
/// for its corners.
pub(super) fn tiny(draw: &mut Draw) -> [f64; 15] {
    let (size, spread) = (draw.log_uniform(1e-9, 1e-3), draw.by_precision(SPREAD, 0.0));
    let triangle = triangle(draw, spread, size);
    let (target, distance) = (point_about(draw, &triangle), draw.uniform(5.0, 40.0));
    aimed(draw, triangle, target, distance).numbers()
}

/// Next to a triangle so large that its edges are far away.
pub(super) fn huge(draw: &mut Draw) -> [f64; 15] {
    let size = draw.log_uniform(1e3, 1e9);
    let triangle = triangle(draw, SPREAD, size);
    let (target, distance) = (point_about(draw, &triangle), draw.uniform(5.0, 40.0));
    aimed(draw, triangle, target, distance).numbers()
}

/// Far from the world's origin, where numbers are coarse.
pub(super) fn shifted(draw: &mut Draw) -> [f64; 15] {
    let (nearest, farthest) = draw.by_precision((1e5, 1e12), (1e3, 1e5));
    let way = draw.direction() * draw.log_uniform(nearest, farthest);
    ordinary(draw).moved(way).numbers()
}

/// A ray from the point where another one hit.
pub(super) fn on_plane(draw: &mut Draw) -> [f64; 15] {
    let size = size(draw);
    let triangle = triangle(draw, SPREAD, size);
    let (origin, direction) = (point_about(draw, &triangle), draw.direction());
    Scene { ray: Ray3::<f64>::new(origin, direction), triangle }.numbers()
}

/// A direction whose products overflow or vanish.
pub(super) fn direction_extreme(draw: &mut Draw) -> [f64; 15] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let length = draw.huge_or_tiny(low, high);
    ordinary(draw).with_direction_times(length).numbers()
}

/// A scene in which products overflow or vanish.
pub(super) fn scale_extreme(draw: &mut Draw) -> [f64; 15] {
    let (low, high) = draw.by_precision((1e87, 1e290), (1e12, 1e30));
    let factor = draw.huge_or_tiny(low, high);
    ordinary(draw).scaled(factor).numbers()
}

/// A scene at the smallest scale there is.
pub(super) fn subnormal(draw: &mut Draw) -> [f64; 15] {
    let scale = draw.subnormal_scale();
    let scene = ordinary(draw).scaled(scale);
    if draw.coin() { scene.numbers() } else { scene.with_direction_times(scale).numbers() }
}

/// Numbers at the ends of what there is.
pub(super) fn special(draw: &mut Draw) -> [f64; 15] {
    let case = ordinary(draw).numbers();
    draw.with_special_numbers(case)
}

/// Any numbers.
pub(super) fn bits(draw: &mut Draw) -> [f64; 15] {
    draw.any_numbers()
}

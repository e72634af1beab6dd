//! How a case of each regime is drawn: a ray aimed at a point of a solid, or past it.

use lab::{Draw, Vec3};
use math::Real;

use crate::Shape;

/// The columns of a case file.
fn case(origin: Vec3, direction: Vec3, shape: Shape) -> [f64; 7] {
    let place = Shape::ALL.iter().position(|&other| other == shape).unwrap_or(0);
    [origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, place as f64]
}

/// One of the two shapes.
fn either(draw: &mut Draw) -> Shape {
    if draw.coin() { Shape::Cylinder } else { Shape::Cone }
}

/// A point in and around the solid: a line through it hits two times of three.
fn about(draw: &mut Draw, shape: Shape) -> Vec3 {
    match shape {
        Shape::Cylinder => draw.in_cube(1.4),
        Shape::Cone => draw.in_cube(0.6) + f64::vec3(0.0, 0.0, 0.4),
    }
}

/// A point inside the solid, a tenth of its size from the surface.
fn within(draw: &mut Draw, shape: Shape) -> Vec3 {
    let around = draw.direction_in_plane();
    let (z, radius) = match shape {
        Shape::Cylinder => (draw.uniform(-0.9, 0.9), 0.9),
        Shape::Cone => {
            let z = draw.uniform(0.1, 0.7);
            (z, 0.5 * (1.0 - z) - 0.1)
        }
    };
    let rho = radius * draw.uniform(0.0, 1.0);
    f64::vec3(rho * around.x, rho * around.y, z)
}

/// The radius of the wall at a height.
fn radius(shape: Shape, z: f64) -> f64 {
    match shape {
        Shape::Cylinder => 1.0,
        Shape::Cone => 0.5 * (1.0 - z),
    }
}

/// A point of the wall, rounded.
fn on_wall(draw: &mut Draw, shape: Shape) -> Vec3 {
    let (lowest, highest) = shape.heights::<f64>();
    let z = draw.uniform(lowest, highest);
    let (around, radius) = (draw.direction_in_plane(), radius(shape, z));
    f64::vec3(radius * around.x, radius * around.y, z)
}

/// A point of a cap, rounded across, but with the z of the plane.
fn on_cap(draw: &mut Draw, shape: Shape) -> Vec3 {
    let z = cap_height(draw, shape);
    let around = draw.direction_in_plane();
    let rho = radius(shape, z) * draw.uniform(0.0, 1.0).sqrt();
    f64::vec3(rho * around.x, rho * around.y, z)
}

/// The z of one of its caps.
fn cap_height(draw: &mut Draw, shape: Shape) -> f64 {
    match shape {
        Shape::Cylinder => draw.sign(),
        Shape::Cone => 0.0,
    }
}

/// A ray from 3 to 20 before a point, aimed at it.
fn aimed(draw: &mut Draw, target: Vec3, direction: Vec3) -> Vec3 {
    target - direction * draw.uniform(3.0, 20.0)
}

/// Numbers as pictures have them.
pub(super) fn ordinary(draw: &mut Draw) -> [f64; 7] {
    let shape = either(draw);
    ordinary_of(draw, shape, 1.0)
}

/// The same with a direction of another length.
fn ordinary_of(draw: &mut Draw, shape: Shape, length: f64) -> [f64; 7] {
    let (target, direction) = (about(draw, shape), draw.direction());
    let origin = aimed(draw, target, direction);
    case(origin, direction * length, shape)
}

/// t in lengths of a direction that is not 1.
pub(super) fn unnormalized(draw: &mut Draw) -> [f64; 7] {
    let (shape, length) = (either(draw), draw.log_uniform(1e-6, 1e6));
    ordinary_of(draw, shape, length)
}

/// Away from the solid, from a unit farther: from what is aimed at no point of the solid is as far as 4, for
/// 1.4 √3 + √2 = 3.84.
pub(super) fn behind(draw: &mut Draw) -> [f64; 7] {
    let shape = either(draw);
    let (target, direction) = (about(draw, shape), draw.direction());
    case(aimed(draw, target, direction) - direction, -direction, shape)
}

/// From within, but not from next to the surface.
pub(super) fn inside(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    case(within(draw, shape), draw.direction(), shape)
}

/// Aimed at a point of the rim, rounded; one case in four in whole numbers and halves, at a point that is on
/// it.
pub(super) fn rim(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let z = cap_height(draw, shape);
    let radius = radius(shape, z);
    if draw.below(4) == 0 {
        let (side, steps) = (draw.sign() * radius, draw.whole(1, 4));
        let at = if draw.coin() { f64::vec3(side, 0.0, z) } else { f64::vec3(0.0, side, z) };
        let direction = whole_vector(draw, 8);
        return case(at - direction * steps, direction, shape);
    }
    let around = draw.direction_in_plane();
    let at = f64::vec3(radius * around.x, radius * around.y, z);
    let direction = draw.direction();
    case(aimed(draw, at, direction), direction, shape)
}

/// A vector of whole numbers, not zero.
fn whole_vector(draw: &mut Draw, largest: i32) -> Vec3 {
    loop {
        let [x, y, z] = std::array::from_fn(|_| draw.whole(-largest, largest));
        let v = f64::vec3(x, y, z);
        if v != f64::vec3(0.0, 0.0, 0.0) {
            return v;
        }
    }
}

/// All but parallel to the straight lines of the wall: the axis of the cylinder, the slope of the cone.
pub(super) fn near_generator(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let nearest = draw.by_precision(1e-15, 1e-7);
    let (off, around) = (draw.log_uniform(nearest, 1e-3), draw.direction_in_plane());
    let slope = match shape {
        Shape::Cylinder => f64::vec3(0.0, 0.0, 1.0),
        Shape::Cone => f64::vec3(0.5 * around.x, 0.5 * around.y, -1.0),
    };
    let direction = (slope + draw.direction() * off) * draw.sign();
    let target = about(draw, shape);
    let steps = draw.uniform(-1.0, 8.0);
    case(target - direction * steps, direction, shape)
}

/// Along the axis, in whole numbers and eighths: no root of the cylinder's wall, for A = 0 = B.
pub(super) fn axial(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let [x, y] = std::array::from_fn(|_| draw.whole(-8, 8) / 8.0);
    let z = draw.whole(-24, 24) / 8.0;
    let size = radius(shape, 0.0);
    let direction = f64::vec3(0.0, 0.0, draw.sign() * draw.whole(1, 8));
    case(f64::vec3(x * size, y * size, z), direction, shape)
}

/// Along the cone's own slope, in whole numbers: A = d_x² + d_y² − ¼ d_z² = 0 exactly.
pub(super) fn slope_exact(draw: &mut Draw) -> [f64; 7] {
    const TRIPLES: [[f64; 3]; 6] = [
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [3.0, 4.0, 5.0],
        [4.0, 3.0, 5.0],
        [5.0, 12.0, 13.0],
        [8.0, 15.0, 17.0],
    ];
    let [x, y, length] = TRIPLES[draw.below(6) as usize];
    let direction = f64::vec3(draw.sign() * x, draw.sign() * y, draw.sign() * 2.0 * length);
    let [x, y, z] = std::array::from_fn(|_| draw.whole(-6, 6) / 8.0);
    let target = f64::vec3(x, y, 0.5 + 0.5 * z);
    let steps = draw.whole(-4, 16) / 16.0;
    case(target - direction * steps, direction, Shape::Cone)
}

/// Aimed at the apex: half of them in whole numbers, through it exactly; the others rounded, just past it.
pub(super) fn apex(draw: &mut Draw) -> [f64; 7] {
    let apex = f64::vec3(0.0, 0.0, 1.0);
    if draw.coin() {
        let (direction, steps) = (whole_vector(draw, 8), draw.whole(1, 8));
        return case(apex - direction * steps, direction, Shape::Cone);
    }
    let direction = draw.direction();
    case(aimed(draw, apex, direction), direction, Shape::Cone)
}

/// Touching the wall, but for 1e-3 to 1e-15 of its radius on either side.
pub(super) fn grazing(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let nearest = draw.by_precision(1e-15, 1e-7);
    let off = 1.0 + draw.sign() * draw.log_uniform(nearest, 1e-3);
    let (lowest, highest) = shape.heights::<f64>();
    let margin = 0.1 * (highest - lowest);
    let z = draw.uniform(lowest + margin, highest - margin);
    let (out, radius) = (draw.direction_in_plane(), radius(shape, z));
    let at = f64::vec3(off * radius * out.x, off * radius * out.y, z);
    // The tangent plane of the wall: around it, and along its straight line.
    let along = match shape {
        Shape::Cylinder => f64::vec3(0.0, 0.0, 1.0),
        Shape::Cone => f64::vec3(0.5 * out.x, 0.5 * out.y, -1.0),
    };
    let direction = f64::vec3(-out.y, out.x, 0.0) + along * draw.uniform(-1.5, 1.5);
    case(aimed(draw, at, direction), direction, shape)
}

/// From afar.
pub(super) fn far(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let farthest = draw.by_precision(1e10, 1e6);
    let distance = draw.log_uniform(1e3, farthest);
    let (target, direction) = (about(draw, shape), draw.direction());
    case(target - direction * distance, direction, shape)
}

/// A ray from the point where another one hit: in or out by a rounding, or on a cap.
pub(super) fn on_surface(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let origin = if draw.below(4) == 0 { on_cap(draw, shape) } else { on_wall(draw, shape) };
    case(origin, draw.direction(), shape)
}

/// From a point of the surface, any direction: t = 0.
pub(super) fn on_surface_exact(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    if draw.coin() {
        // Within a cap, where only z matters.
        return case(on_cap(draw, shape) * f64::vec3(0.9, 0.9, 1.0), draw.direction(), shape);
    }
    // No other points of the circle than its four ends have coordinates that are floats; the cone has some
    // more.
    let ([x, y, radius], z) = match shape {
        Shape::Cylinder => ([1.0, 0.0, 1.0], draw.uniform(-1.0, 1.0)),
        Shape::Cone => {
            let tenth = draw.whole(0, 204) / 2048.0;
            ([3.0, 4.0, 5.0], 1.0 - 10.0 * tenth)
        }
    };
    let unit = self::radius(shape, z) / radius;
    let (x, y) = if draw.coin() { (x, y) } else { (y, x) };
    let origin = f64::vec3(draw.sign() * x * unit, draw.sign() * y * unit, z);
    case(origin, draw.direction(), shape)
}

/// Exactly within the plane of a cap, toward it or from inside it.
pub(super) fn cap_plane(draw: &mut Draw, shape: Shape) -> [f64; 7] {
    let z = cap_height(draw, shape);
    let (around, across) = (draw.direction_in_plane(), draw.direction_in_plane());
    let past = radius(shape, z) * draw.uniform(0.0, 1.3);
    let steps = if draw.coin() { 0.0 } else { draw.uniform(2.0, 20.0) };
    let origin = f64::vec3(past * around.x - steps * across.x, past * around.y - steps * across.y, z);
    case(origin, f64::vec3(across.x, across.y, 0.0), shape)
}

/// A direction whose square overflows or vanishes.
pub(super) fn direction_extreme(draw: &mut Draw) -> [f64; 7] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let (shape, length) = (either(draw), draw.huge_or_tiny(low, high));
    ordinary_of(draw, shape, length)
}

/// A direction at the smallest scale there is.
pub(super) fn subnormal(draw: &mut Draw) -> [f64; 7] {
    let (shape, scale) = (either(draw), draw.subnormal_scale());
    ordinary_of(draw, shape, scale)
}

/// Numbers at the ends of what there is; the shape stays.
pub(super) fn special(draw: &mut Draw) -> [f64; 7] {
    let [ox, oy, oz, dx, dy, dz, shape] = ordinary(draw);
    let [ox, oy, oz, dx, dy, dz] = draw.with_special_numbers([ox, oy, oz, dx, dy, dz]);
    [ox, oy, oz, dx, dy, dz, shape]
}

/// Six numbers of any bits.
pub(super) fn bits(draw: &mut Draw) -> [f64; 7] {
    let [ox, oy, oz, dx, dy, dz] = draw.any_numbers();
    [ox, oy, oz, dx, dy, dz, draw.whole(0, 1)]
}

//! How a case of each regime is drawn.

use std::cmp::Ordering;

use lab::Draw;
use math::{Ray3, Real};

use super::scene::{
    Scene, aimed, aimed_along, on_surface as surface_point, ordinary_matrix, place, rounded, solid,
    squashed_matrix, turned, within,
};
use crate::exact_sign::of_determinant;
use crate::{Affine, Matrix3, Object};

/// Numbers as pictures have them.
pub(super) fn ordinary(draw: &mut Draw) -> Scene {
    let (object, a) = (solid(draw), ordinary_matrix(draw));
    aimed(draw, object, a)
}

/// The same of one object.
pub(super) fn ordinary_of(draw: &mut Draw, object: Object) -> [f64; 19] {
    let a = ordinary_matrix(draw);
    aimed(draw, object, a).numbers()
}

/// t in lengths of a direction that is not 1.
pub(super) fn unnormalized(draw: &mut Draw) -> [f64; 19] {
    let length = draw.log_uniform(1e-6, 1e6);
    ordinary(draw).with_direction_times(length).numbers()
}

/// Away from the object, from 8 farther: from what is aimed at no point of an object is as far as 13, for
/// 3 (1.5 √3 + √2) = 12.1.
pub(super) fn behind(draw: &mut Draw) -> [f64; 19] {
    let mut scene = ordinary(draw).with_direction_times(-1.0);
    scene.ray.origin += scene.ray.direction * 8.0;
    scene.numbers()
}

/// From within, but not from next to the surface.
pub(super) fn inside(draw: &mut Draw) -> [f64; 19] {
    let (object, a, direction) = (solid(draw), ordinary_matrix(draw), draw.direction());
    let target = within(draw, object);
    aimed_along(draw, object, a, target, direction, 0.0).numbers()
}

/// A matrix that mirrors.
pub(super) fn mirrored(draw: &mut Draw) -> [f64; 19] {
    let (object, a) = (solid(draw), ordinary_matrix(draw));
    let [x, y, z] = a.columns;
    aimed(draw, object, Matrix3 { columns: [x, y, -z] }).numbers()
}

/// One object, squashed so many times.
pub(super) fn squashed(draw: &mut Draw, object: Object, condition: f64) -> [f64; 19] {
    let a = squashed_matrix(draw, condition);
    aimed(draw, object, a).numbers()
}

/// A sphere stretched and squashed along the axes alone.
pub(super) fn axis_scale(draw: &mut Draw) -> [f64; 19] {
    let [x, y, z] = [0, 1, 2].map(|_| draw.log_uniform(1e-3, 1e3));
    let a = Matrix3::from_rows([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]);
    let a = rounded(draw, a);
    aimed(draw, Object::Sphere, a).numbers()
}

/// Far from the world's origin, where numbers are coarse.
pub(super) fn shifted(draw: &mut Draw) -> [f64; 19] {
    let (nearest, farthest) = draw.by_precision((1e5, 1e9), (1e3, 1e5));
    let way = draw.direction() * draw.log_uniform(nearest, farthest);
    ordinary(draw).moved(way).numbers()
}

/// So far away that the squares of its own size are below their last digit.
pub(super) fn far(draw: &mut Draw) -> [f64; 19] {
    let (object, a) = (solid(draw), ordinary_matrix(draw));
    let (nearest, farthest) = draw.by_precision((1e4, 1e10), (1e2, 1e5));
    let (target, direction) = (super::scene::target(draw, object), draw.direction());
    let distance = draw.log_uniform(nearest, farthest);
    aimed_along(draw, object, a, target, direction, distance).numbers()
}

/// Past a sphere by next to nothing, or through it by as little: in its own space, where that is seen.
pub(super) fn grazing(draw: &mut Draw) -> [f64; 19] {
    let a = ordinary_matrix(draw);
    let direction = draw.direction();
    let direction = draw.rounded_vector(direction);
    let d_prime = a.inverse().times(direction);
    let side = draw.perpendicular(d_prime / d_prime.length());
    let smallest = draw.by_precision(1e-15, 1e-7);
    let off = draw.log_uniform(smallest, 1e-3) * draw.sign();
    let distance = draw.uniform(5.0, 40.0);
    aimed_along(draw, Object::Sphere, a, side * (1.0 + off), direction, distance).numbers()
}

/// A tangent of the unit sphere, carried along by a matrix of whole numbers: nothing is rounded. In three of
/// four cases one number is then moved to a neighbor.
pub(super) fn tangent(draw: &mut Draw) -> [f64; 19] {
    let a = whole_matrix(draw);
    let (y, z) = loop {
        let step = (draw.whole(-4, 4), draw.whole(-4, 4));
        if step != (0.0, 0.0) {
            break step;
        }
    };
    // touches at ±e_x, where it is at right angles to x
    let (touches, d_prime) = (f64::vec3(draw.sign(), 0.0, 0.0), f64::vec3(0.0, y, z));
    let o_prime = touches - d_prime * draw.whole(0, 6);
    let t = f64::vec3(draw.whole(-9, 9), draw.whole(-9, 9), draw.whole(-9, 9));
    let ray = Ray3::<f64>::new(a.times(o_prime) + t, a.times(d_prime));
    let case = Scene { ray, object: Object::Sphere, affine: Affine { a, t } }.numbers();
    with_object(draw.nudged(case), Object::Sphere)
}

/// A matrix of whole numbers up to 5 that is not singular, and not nearly.
fn whole_matrix(draw: &mut Draw) -> Matrix3<f64> {
    loop {
        let rows = [0, 1, 2].map(|_| [0, 1, 2].map(|_| draw.whole(-5, 5)));
        let a = Matrix3::from_rows(rows);
        if a.determinant() != 0.0 {
            return a;
        }
    }
}

/// From a rounded point of the surface: a secondary ray.
pub(super) fn on_surface(draw: &mut Draw) -> [f64; 19] {
    let (object, a, direction) = (solid(draw), ordinary_matrix(draw), draw.direction());
    let from = surface_point(draw, object);
    aimed_along(draw, object, a, from, direction, 0.0).numbers()
}

/// Along a plane or a triangle of whole numbers, apart from it or within it.
pub(super) fn parallel(draw: &mut Draw) -> [f64; 19] {
    let (object, a) = (flat(draw), whole_matrix(draw));
    let t = f64::vec3(draw.whole(-9, 9), draw.whole(-9, 9), draw.whole(-9, 9));
    let height = if draw.coin() { 0.0 } else { draw.whole(1, 3) };
    let [o_prime, d_prime] = [
        f64::vec3(draw.whole(-4, 4), draw.whole(-4, 4), height),
        f64::vec3(draw.whole(-4, 4), draw.whole(1, 4), 0.0),
    ];
    let ray = Ray3::<f64>::new(a.times(o_prime) + t, a.times(d_prime));
    Scene { ray, object, affine: Affine { a, t } }.numbers()
}

/// All but along a plane or a triangle, down to it by so little; one ray of three rises instead.
pub(super) fn near_parallel(draw: &mut Draw) -> [f64; 19] {
    let (object, a) = (flat(draw), ordinary_matrix(draw));
    let target = super::scene::target(draw, object);
    let along = draw.direction_in_plane();
    let smallest = draw.by_precision(1e-15, 1e-7);
    let falls = draw.log_uniform(smallest, 1e-2);
    let direction = a.times(f64::vec3(along.x, along.y, -falls));
    let turns_away = object == Object::Plane && draw.below(3) == 0;
    let distance = draw.uniform(5.0, 40.0) * if turns_away { -1.0 } else { 1.0 };
    aimed_along(draw, object, a, target, direction, distance).numbers()
}

/// The plane or the triangle.
fn flat(draw: &mut Draw) -> Object {
    if draw.coin() { Object::Plane } else { Object::Triangle }
}

/// Through an edge or a corner of a triangle of whole numbers: its boundary belongs to it. In three of four
/// cases one number is then moved to a neighbor.
pub(super) fn triangle_edge(draw: &mut Draw) -> [f64; 19] {
    let a = whole_matrix(draw);
    let t = f64::vec3(draw.whole(-9, 9), draw.whole(-9, 9), draw.whole(-9, 9));
    let (eighths, side) = (draw.whole(0, 8) / 8.0, draw.below(3));
    let on_edge = match side {
        0 => f64::vec3(eighths, 0.0, 0.0),
        1 => f64::vec3(0.0, eighths, 0.0),
        _ => f64::vec3(eighths, 1.0 - eighths, 0.0),
    };
    let d_prime = f64::vec3(draw.whole(-4, 4), draw.whole(-4, 4), draw.whole(1, 4));
    let o_prime = on_edge - d_prime * draw.whole(1, 4);
    let ray = Ray3::<f64>::new(a.times(o_prime) + t, a.times(d_prime));
    let case = Scene { ray, object: Object::Triangle, affine: Affine { a, t } }.numbers();
    with_object(draw.nudged(case), Object::Triangle)
}

/// A direction whose square overflows or vanishes.
pub(super) fn direction_extreme(draw: &mut Draw) -> [f64; 19] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let length = draw.huge_or_tiny(low, high);
    ordinary(draw).with_direction_times(length).numbers()
}

/// A scene in which det A, or its square, overflows or vanishes.
pub(super) fn scale_extreme(draw: &mut Draw) -> [f64; 19] {
    let (low, high) = draw.by_precision((1e60, 1e290), (1e10, 1e30));
    let factor = draw.huge_or_tiny(low, high);
    ordinary(draw).scaled(factor).numbers()
}

/// A scene at the smallest scale there is. With two digits left a matrix may be singular: such a one is drawn
/// again.
pub(super) fn subnormal(draw: &mut Draw) -> [f64; 19] {
    let scale = draw.subnormal_scale();
    let scene = loop {
        let scene = ordinary(draw).scaled(scale);
        if of_determinant(&rounded(draw, scene.affine.a)) != Ordering::Equal {
            break scene;
        }
    };
    if draw.coin() { scene.numbers() } else { scene.with_direction_times(scale).numbers() }
}

/// Numbers at the ends of what there is.
pub(super) fn special(draw: &mut Draw) -> [f64; 19] {
    let object = any_object(draw);
    let a = turned(draw, [1.0, 2.0, 3.0]);
    let case = aimed(draw, object, a).numbers();
    with_object(draw.with_special_numbers(case), object)
}

/// Any numbers.
pub(super) fn bits(draw: &mut Draw) -> [f64; 19] {
    let object = any_object(draw);
    with_object(draw.any_numbers(), object)
}

fn any_object(draw: &mut Draw) -> Object {
    Object::ALL[draw.below(Object::ALL.len() as u64) as usize]
}

/// The same with this object's word, whatever happened to it.
fn with_object(mut case: [f64; 19], object: Object) -> [f64; 19] {
    case[6] = place(object);
    case
}

//! How a case of each regime is drawn: a ray aimed at a sphere, and what is then done to both.

use lab::{Draw, Vec3};
use math::{Ray3, Real};

use crate::Sphere;

/// A ray and a sphere.
pub(super) struct Scene {
    ray: Ray3<f64>,
    sphere: Sphere<f64>,
}

impl Scene {
    /// The columns of a case file.
    pub(super) fn numbers(&self) -> [f64; 10] {
        let Scene { ray: Ray3 { origin: o, direction: d }, sphere: Sphere { center: c, radius } } = self;
        [o.x, o.y, o.z, d.x, d.y, d.z, c.x, c.y, c.z, *radius]
    }

    /// Everything elsewhere.
    fn moved(mut self, by: Vec3) -> Scene {
        self.ray.origin += by;
        self.sphere.center += by;
        self
    }

    /// Every length times a factor, the direction as it is.
    fn scaled(mut self, factor: f64) -> Scene {
        self.ray.origin *= factor;
        self.sphere.center *= factor;
        self.sphere.radius *= factor;
        self
    }

    /// The direction times a factor.
    fn with_direction_times(mut self, factor: f64) -> Scene {
        self.ray.direction *= factor;
        self
    }
}

/// A ray that starts `distance` before the point where it passes the center, at `impact` radii. The
/// center is within `spread` of the world's origin on every axis.
///
/// Origin and direction are rounded first and the center follows from them, so that the aim holds at
/// either precision.
fn aimed(draw: &mut Draw, spread: f64, radius: f64, distance: f64, impact: f64) -> Scene {
    let direction = draw.direction();
    let direction = draw.rounded_vector(direction);
    let side = draw.perpendicular(direction);
    let about = draw.in_cube(spread);
    let origin = draw.rounded_vector(about - direction * distance);
    let center = origin + direction * distance + side * (impact * radius);
    Scene { ray: Ray3::<f64>::new(origin, direction), sphere: Sphere { center, radius } }
}

/// How far the center is from the world's origin, if nothing else is said.
const SPREAD: f64 = 10.0;

/// A radius as pictures have it.
fn radius(draw: &mut Draw) -> f64 {
    draw.uniform(0.1, 5.0)
}

/// Where a ray passes the center, in radii: within the sphere two times of three.
fn impact(draw: &mut Draw) -> f64 {
    draw.uniform(0.0, 1.5)
}

/// Numbers as pictures have them.
pub(super) fn ordinary(draw: &mut Draw) -> Scene {
    let impact = impact(draw);
    ordinary_at(draw, impact)
}

/// The same, passing the center at so many radii.
fn ordinary_at(draw: &mut Draw, impact: f64) -> Scene {
    let radius = radius(draw);
    let distance = radius + draw.uniform(5.0, 40.0);
    aimed(draw, SPREAD, radius, distance, impact)
}

/// An ordinary case that hits, or one that misses.
pub(crate) fn ordinary_that(draw: &mut Draw, hits: bool) -> [f64; 10] {
    let impact = if hits { draw.uniform(0.0, 1.0) } else { draw.uniform(1.0, 1.5) };
    ordinary_at(draw, impact).numbers()
}

/// A ray that passes the center at so many radii, from so many radii away.
pub(crate) fn passing(draw: &mut Draw, radii: f64, impact: f64) -> [f64; 10] {
    let radius = radius(draw);
    aimed(draw, SPREAD, radius, radii * radius, impact).numbers()
}

/// t in lengths of a direction that is not 1.
pub(super) fn unnormalized(draw: &mut Draw) -> [f64; 10] {
    let length = draw.log_uniform(1e-6, 1e6);
    ordinary(draw).with_direction_times(length).numbers()
}

/// Away from the sphere.
pub(super) fn behind(draw: &mut Draw) -> [f64; 10] {
    ordinary(draw).with_direction_times(-1.0).numbers()
}

/// From within, but not from next to the surface.
pub(super) fn inside(draw: &mut Draw) -> [f64; 10] {
    let (center, radius, direction) = (draw.in_cube(SPREAD), draw.uniform(1.0, 5.0), draw.direction());
    let origin = center + draw.direction() * (radius * draw.uniform(0.0, 0.9));
    Scene { ray: Ray3::<f64>::new(origin, direction), sphere: Sphere { center, radius } }.numbers()
}

/// So many radii away.
pub(super) fn far(draw: &mut Draw, radii: f64) -> [f64; 10] {
    let (radius, impact) = (radius(draw), impact(draw));
    aimed(draw, SPREAD, radius, radii * radius, impact).numbers()
}

/// So far away that all of r² is below the last digit of distance².
pub(super) fn far_beyond(draw: &mut Draw) -> [f64; 10] {
    let radii = draw.log_uniform(1e8, 1e15);
    far(draw, radii)
}

/// A sphere smaller than anything around it. At f32 its center is near the world's origin: elsewhere
/// no three numbers come as close to it as its radius.
pub(super) fn tiny(draw: &mut Draw, radius: f64) -> [f64; 10] {
    let spread = draw.by_precision(SPREAD, 0.0);
    let (distance, impact) = (draw.uniform(5.0, 40.0), impact(draw));
    aimed(draw, spread, radius, distance, impact).numbers()
}

/// Every size below those of pictures.
pub(super) fn tiny_of_any_size(draw: &mut Draw) -> [f64; 10] {
    let radius = draw.log_uniform(1e-12, 1e-3);
    tiny(draw, radius)
}

/// Above a sphere so large that it looks flat. Half of the rays look down.
pub(super) fn huge(draw: &mut Draw) -> [f64; 10] {
    let (radius, origin, direction) = (1e8, draw.in_cube(SPREAD), draw.direction());
    let center = origin + draw.direction() * (radius + draw.uniform(5.0, 40.0));
    Scene { ray: Ray3::<f64>::new(origin, direction), sphere: Sphere { center, radius } }.numbers()
}

/// The ground of many a picture: a sphere under the scene, seen by a camera that stands on it. Half of
/// the rays look up.
pub(super) fn ground(draw: &mut Draw) -> [f64; 10] {
    let sphere = Sphere { center: f64::vec3(0.0, -1e6, 0.0), radius: 1e6 };
    let origin = f64::vec3(draw.uniform(-1.0, 1.0), 1.0, draw.uniform(-1.0, 1.0));
    let direction = f64::vec3(draw.uniform(-0.75, 0.75), draw.uniform(-0.75, 0.75), -1.0);
    Scene { ray: Ray3::<f64>::new(origin, direction), sphere }.numbers()
}

/// How near the rim a grazing ray passes, in radii: just within the sphere, or just outside.
fn rim(draw: &mut Draw) -> f64 {
    let nearest = draw.by_precision(1e-15, 1e-7);
    1.0 + draw.sign() * draw.log_uniform(nearest, 1e-3)
}

/// Past the rim.
pub(super) fn grazing(draw: &mut Draw) -> [f64; 10] {
    let radius = radius(draw);
    let (distance, impact) = (radius + draw.uniform(5.0, 40.0), rim(draw));
    aimed(draw, SPREAD, radius, distance, impact).numbers()
}

/// Past the rim, from afar.
pub(super) fn grazing_far(draw: &mut Draw) -> [f64; 10] {
    let (radius, impact) = (radius(draw), rim(draw));
    let (nearest, farthest) = draw.by_precision((1e2, 1e6), (1e1, 1e3));
    let distance = radius * draw.log_uniform(nearest, farthest);
    aimed(draw, SPREAD, radius, distance, impact).numbers()
}

/// A touching ray in whole numbers, which no rounding disturbs; and most of the time one number beside
/// that. Only an exact discriminant tells them apart.
pub(super) fn tangent(draw: &mut Draw) -> [f64; 10] {
    let ([direction, side, _], length) = draw.whole_frame();
    let (about, steps, radii) = (whole_point(draw), draw.whole(1, 8), draw.whole(1, 8));
    let sphere = Sphere { center: about + direction * steps + side * radii, radius: radii * length };
    let touching = Scene { ray: Ray3::<f64>::new(about, direction), sphere }.numbers();
    draw.nudged(touching)
}

/// A point of whole numbers.
fn whole_point(draw: &mut Draw) -> Vec3 {
    let [x, y, z] = std::array::from_fn(|_| draw.whole(-50, 50));
    f64::vec3(x, y, z)
}

/// A ray from the point where another one hit: in or out, and the sphere itself no longer to be hit at
/// t = 0 if the point was rounded outward.
pub(super) fn on_surface(draw: &mut Draw) -> [f64; 10] {
    let (center, radius, direction) = (draw.in_cube(SPREAD), radius(draw), draw.direction());
    let origin = center + draw.direction() * radius;
    Scene { ray: Ray3::<f64>::new(origin, direction), sphere: Sphere { center, radius } }.numbers()
}

/// A ray from a point of the sphere: t = 0 touches and is the hit, whatever the direction.
pub(super) fn on_surface_exact(draw: &mut Draw) -> [f64; 10] {
    let ([out, ..], length) = draw.whole_frame();
    let (center, radii, direction) = (whole_point(draw), draw.whole(1, 8), draw.direction());
    let sphere = Sphere { center, radius: radii * length };
    Scene { ray: Ray3::<f64>::new(center + out * radii, direction), sphere }.numbers()
}

/// Far from the world's origin, where numbers are coarse.
pub(super) fn moved(draw: &mut Draw, by: f64) -> [f64; 10] {
    let way = draw.direction() * by;
    ordinary(draw).moved(way).numbers()
}

/// Far from the world's origin, as far as a sphere keeps some digits.
pub(super) fn moved_anywhere(draw: &mut Draw) -> [f64; 10] {
    let (nearest, farthest) = draw.by_precision((1e5, 1e12), (1e4, 1e7));
    let by = draw.log_uniform(nearest, farthest);
    moved(draw, by)
}

/// A direction whose square overflows or vanishes.
pub(super) fn direction_extreme(draw: &mut Draw) -> [f64; 10] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let length = draw.huge_or_tiny(low, high);
    ordinary(draw).with_direction_times(length).numbers()
}

/// A scene in which squares, or their products, overflow or vanish.
pub(super) fn scale_extreme(draw: &mut Draw) -> [f64; 10] {
    let (low, high) = draw.by_precision((1e87, 1e290), (1e12, 1e30));
    let factor = draw.huge_or_tiny(low, high);
    ordinary(draw).scaled(factor).numbers()
}

/// A scene at the smallest scale there is.
pub(super) fn subnormal(draw: &mut Draw) -> [f64; 10] {
    let scale = draw.subnormal_scale();
    let scene = ordinary(draw).scaled(scale);
    if draw.coin() { scene.numbers() } else { scene.with_direction_times(scale).numbers() }
}

/// Numbers at the ends of what there is.
pub(super) fn special(draw: &mut Draw) -> [f64; 10] {
    let case = ordinary(draw).numbers();
    with_a_radius(draw.with_special_numbers(case))
}

/// Any numbers.
pub(super) fn bits(draw: &mut Draw) -> [f64; 10] {
    with_a_radius(draw.any_numbers())
}

/// The same with a radius that is not negative.
fn with_a_radius(mut case: [f64; 10]) -> [f64; 10] {
    case[9] = case[9].abs();
    case
}

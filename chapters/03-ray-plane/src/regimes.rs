//! The kinds of ray and plane, and what the notes' method loses in each.
//!
//! Two dot products decide, n · (p_r − p_0) and n · u_r, and the regimes are what can become of them:
//! their terms cancel, or overflow, or are so small that they vanish. What varies over a scale is drawn
//! log-uniformly. If nothing else is said, the plane is behind every other ray.

use lab::Notes::{Hold, LoseDigits, Misjudge};
use lab::{Draw, Regime, Vec3};
use math::{Ray3, Real};
use stage::Precision::{F32, F64};

use crate::Plane;

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, and the plane's point and normal.
pub fn regimes() -> Vec<Regime<12>> {
    vec![
        Regime {
            name: "ordinary",
            what: "origin and plane within 10, unit direction and normal",
            draw: |draw| ordinary(draw).numbers(),
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "unnormalized",
            what: "ordinary, with direction and normal of lengths 1e-6 to 1e6",
            draw: unnormalized,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "far",
            what: "ordinary, the origin 1e2 to 1e15 away",
            draw: far,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "horizon",
            what: "an upright normal and the eye one unit above the plane, 1e-3 to 1e-15 off the horizon",
            draw: horizon,
            notes: Hold("n has one component: nothing is added, so nothing cancels"),
        },
        Regime {
            name: "near-parallel",
            what: "ordinary, at a slope of 1e-3 to 1e-15",
            draw: near_parallel,
            notes: Misjudge("notes", F32),
        },
        Regime {
            name: "parallel",
            what: "n · u_r = 0 exactly, every other ray within the plane",
            draw: parallel,
            notes: Hold("n · u_r = 0 is decided on the numbers as given"),
        },
        Regime {
            name: "on-plane",
            what: "the origin a rounded point of the plane",
            draw: on_plane,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "on-plane-exact",
            what: "the origin a point of the plane in whole numbers, any direction",
            draw: on_plane_exact,
            notes: Hold("n · (p_r − p_0) is a sum of whole numbers, exactly 0"),
        },
        Regime {
            name: "shifted-1e6",
            what: "ordinary, everything moved 1e6 away from the world's origin",
            draw: |draw| moved(draw, 1e6),
            notes: LoseDigits("notes", F32),
        },
        Regime {
            name: "shifted",
            what: "ordinary, everything moved 1e5 to 1e12 (f32: 1e4 to 1e7)",
            draw: moved_anywhere,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "vectors-any-length",
            what: "ordinary, with direction and normal of lengths 1e-140 to 1e140 (f32: 1e±17)",
            draw: vectors_any_length,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "vectors-extreme",
            what: "ordinary, with direction and normal of lengths 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: vectors_extreme,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "scale-extreme",
            what: "ordinary, all lengths times 1e±87 to 1e±290 (f32: 1e±12 to 1e±30)",
            draw: scale_extreme,
            notes: LoseDigits("notes", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, scaled until every length is subnormal; every other direction too",
            draw: subnormal,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "special",
            what: "ordinary, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "bits",
            what: "twelve numbers of any bits",
            draw: |draw| draw.any_numbers(),
            notes: Misjudge("notes", F64),
        },
    ]
}

/// A ray and a plane.
struct Scene {
    ray: Ray3<f64>,
    plane: Plane<f64>,
}

impl Scene {
    /// The columns of a case file.
    fn numbers(&self) -> [f64; 12] {
        let Scene { ray: Ray3 { origin: o, direction: d }, plane: Plane { point: p, normal: n } } = self;
        [o.x, o.y, o.z, d.x, d.y, d.z, p.x, p.y, p.z, n.x, n.y, n.z]
    }

    /// The origin of the ray and the point of the plane times a factor.
    fn scaled(mut self, factor: f64) -> Scene {
        self.ray.origin *= factor;
        self.plane.point *= factor;
        self
    }

    /// The direction and the normal times a factor each.
    fn with_vectors_times(mut self, direction: f64, normal: f64) -> Scene {
        self.ray.direction *= direction;
        self.plane.normal *= normal;
        self
    }
}

/// A ray and the plane through a point.
fn scene(origin: Vec3, direction: Vec3, point: Vec3, normal: Vec3) -> Scene {
    Scene { ray: Ray3::<f64>::new(origin, direction), plane: Plane { point, normal } }
}

/// How far the origin and the plane's point are from the world's origin, if nothing else is said.
const SPREAD: f64 = 10.0;

/// Numbers as pictures have them.
fn ordinary(draw: &mut Draw) -> Scene {
    let (origin, direction) = (draw.in_cube(SPREAD), draw.direction());
    scene(origin, direction, draw.in_cube(SPREAD), draw.direction())
}

/// t in lengths of a direction that is not 1, and a normal that is no unit vector.
fn unnormalized(draw: &mut Draw) -> [f64; 12] {
    let [direction, normal] = std::array::from_fn(|_| draw.log_uniform(1e-6, 1e6));
    ordinary(draw).with_vectors_times(direction, normal).numbers()
}

/// A plane seen from afar.
fn far(draw: &mut Draw) -> [f64; 12] {
    let mut far = ordinary(draw);
    far.ray.origin += draw.direction() * draw.log_uniform(1e2, 1e15);
    far.numbers()
}

/// A camera on a floor. Every other ray looks above the horizon, and misses.
fn horizon(draw: &mut Draw) -> [f64; 12] {
    let fall = draw.sign() * draw.log_uniform(1e-15, 1e-3);
    let origin = f64::vec3(draw.uniform(-1.0, 1.0), 1.0, draw.uniform(-1.0, 1.0));
    let direction = f64::vec3(draw.uniform(-0.75, 0.75), fall, -1.0);
    scene(origin, direction, f64::vec3(0.0, 0.0, 0.0), f64::vec3(0.0, 1.0, 0.0)).numbers()
}

/// The same slopes where no axis is the plane's: what is left of n · u_r, when its terms have canceled.
fn near_parallel(draw: &mut Draw) -> [f64; 12] {
    let slope = draw.sign() * draw.log_uniform(1e-15, 1e-3);
    let direction = draw.direction();
    let normal = draw.perpendicular(direction) + direction * slope;
    scene(draw.in_cube(SPREAD), direction, draw.in_cube(SPREAD), normal).numbers()
}

/// A parallel that no rounding disturbs: whole numbers at right angles, or (a, b, 0) and (b, −a, 0) with
/// any a and b.
fn parallel(draw: &mut Draw) -> [f64; 12] {
    let [normal, along, across] = if draw.coin() { draw.whole_frame().0 } else { upright_frame(draw) };
    let point = whole_point(draw);
    let within = point + across * draw.whole(-8, 8);
    let origin = if draw.coin() { within } else { within + whole_point(draw) };
    scene(origin, along, point, normal).numbers()
}
/// Three vectors at right angles, the first two any of the xy plane.
fn upright_frame(draw: &mut Draw) -> [Vec3; 3] {
    let [a, b] = std::array::from_fn(|_| draw.uniform(-1.0, 1.0));
    [f64::vec3(a, b, 0.0), f64::vec3(b, -a, 0.0), f64::vec3(0.0, 0.0, 1.0)]
}

/// A point of whole numbers.
fn whole_point(draw: &mut Draw) -> Vec3 {
    let [x, y, z] = std::array::from_fn(|_| draw.whole(-50, 50));
    f64::vec3(x, y, z)
}

/// A ray from a point where another one hit: in front of the plane or behind it by a rounding.
fn on_plane(draw: &mut Draw) -> [f64; 12] {
    let normal = draw.direction();
    let side = draw.perpendicular(normal);
    let point = draw.in_cube(SPREAD);
    let origin = point + side * draw.uniform(-SPREAD, SPREAD);
    scene(origin, draw.direction(), point, normal).numbers()
}

/// A ray from a point of the plane: t = 0 touches and is the hit.
fn on_plane_exact(draw: &mut Draw) -> [f64; 12] {
    let ([normal, along, across], _) = draw.whole_frame();
    let point = whole_point(draw);
    let origin = point + along * draw.whole(-8, 8) + across * draw.whole(-8, 8);
    scene(origin, draw.direction(), point, normal).numbers()
}

/// Far from the world's origin, where numbers are coarse.
fn moved(draw: &mut Draw, by: f64) -> [f64; 12] {
    let way = draw.direction() * by;
    let mut moved = ordinary(draw);
    moved.ray.origin += way;
    moved.plane.point += way;
    moved.numbers()
}

/// Far from the world's origin, as far as some digits of a distance remain.
fn moved_anywhere(draw: &mut Draw) -> [f64; 12] {
    let (nearest, farthest) = draw.by_precision((1e5, 1e12), (1e4, 1e7));
    let by = draw.log_uniform(nearest, farthest);
    moved(draw, by)
}

/// A direction and a normal of very different lengths, whose products still exist.
fn vectors_any_length(draw: &mut Draw) -> [f64; 12] {
    let (low, high) = draw.by_precision((1e-140, 1e140), (1e-17, 1e17));
    let [direction, normal] = std::array::from_fn(|_| draw.log_uniform(low, high));
    ordinary(draw).with_vectors_times(direction, normal).numbers()
}

/// A direction and a normal whose products overflow or vanish.
fn vectors_extreme(draw: &mut Draw) -> [f64; 12] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let [direction, normal] = std::array::from_fn(|_| draw.huge_or_tiny(low, high));
    ordinary(draw).with_vectors_times(direction, normal).numbers()
}

/// A scene of very large or very small lengths.
fn scale_extreme(draw: &mut Draw) -> [f64; 12] {
    let (low, high) = draw.by_precision((1e87, 1e290), (1e12, 1e30));
    let factor = draw.huge_or_tiny(low, high);
    ordinary(draw).scaled(factor).numbers()
}

/// A scene at the smallest scale there is.
fn subnormal(draw: &mut Draw) -> [f64; 12] {
    let scale = draw.subnormal_scale();
    let scene = ordinary(draw).scaled(scale);
    if draw.coin() { scene.numbers() } else { scene.with_vectors_times(scale, 1.0).numbers() }
}

/// Numbers at the ends of what there is.
fn special(draw: &mut Draw) -> [f64; 12] {
    let case = ordinary(draw).numbers();
    draw.with_special_numbers(case)
}

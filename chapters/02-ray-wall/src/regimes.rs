//! The kinds of ray and wall, and what the notes' method loses in each: hardly anything.
//!
//! There is one subtraction and one division, each rounded once, and no sum whose terms could cancel.
//! What varies over a scale is drawn log-uniformly. If nothing else is said, the ray starts outside the
//! wall and points anywhere, so that it misses half of the time.

use lab::Notes::{Hold, Misjudge};
use lab::{Draw, Regime, Vec2};
use math::{Ray2, Real};
use stage::Precision::F64;

use crate::Wall;

/// Every regime of the chapter, the ordinary one first. Each draws the numbers of a row of a case file: the
/// ray's origin and direction, and the wall's front and back.
pub fn regimes() -> Vec<Regime<6>> {
    vec![
        Regime {
            name: "ordinary",
            what: "a wall 0.1 to 5 thick within 10, the origin 0.1 to 40 before or behind it, unit direction",
            draw: |draw| ordinary(draw).numbers(),
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "unnormalized",
            what: "ordinary, with a direction of length 1e-6 to 1e6",
            draw: unnormalized,
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "inside",
            what: "ordinary, with the origin between the faces",
            draw: inside,
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "on-face",
            what: "ordinary, with the origin on a face",
            draw: on_face,
            notes: Hold("front − p_x is exactly 0"),
        },
        Regime {
            name: "far",
            what: "ordinary, the origin 1e2 to 1e15 away",
            draw: far,
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "thin",
            what: "a wall 1e-3 to 1e-15 thick, or of no thickness",
            draw: thin,
            notes: Hold("each face is asked by itself: both t may be the same"),
        },
        Regime {
            name: "near-parallel",
            what: "ordinary, with u_x of 1e-3 to 1e-15",
            draw: near_parallel,
            notes: Hold("u_x is a number as given: dividing by a small one loses nothing"),
        },
        Regime {
            name: "parallel",
            what: "u_x = 0: outside, inside and within a face",
            draw: parallel,
            notes: Hold("u_x = 0 and p_x = front are decided on the numbers as given"),
        },
        Regime {
            name: "shifted-1e6",
            what: "ordinary, everything moved 1e6 away from the world's origin",
            draw: |draw| moved(draw, 1e6),
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "shifted",
            what: "ordinary, everything moved 1e5 to 1e12 (f32: 1e4 to 1e7)",
            draw: moved_anywhere,
            notes: Hold(TWO_ROUNDINGS),
        },
        Regime {
            name: "direction-extreme",
            what: "ordinary, with a direction of length 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: direction_extreme,
            notes: Hold("nothing is squared"),
        },
        Regime {
            name: "scale-extreme",
            what: "ordinary, all lengths times 1e±87 to 1e±290 (f32: 1e±12 to 1e±30)",
            draw: scale_extreme,
            notes: Hold("nothing is squared"),
        },
        Regime {
            name: "both-extreme",
            what: "ordinary, lengths and direction times 1e±150 to 1e±300 (f32: 1e±18 to 1e±36)",
            draw: both_extreme,
            notes: Misjudge("notes", F64),
        },
        Regime {
            name: "subnormal",
            what: "ordinary, scaled until every length is subnormal; every other direction too",
            draw: subnormal,
            notes: Hold("a difference of subnormal numbers is exact"),
        },
        Regime {
            name: "special",
            what: "ordinary, one or two numbers replaced by 0, smallest, largest, their roots, ∞ or NaN",
            draw: special,
            notes: Hold("no product: what overflows or vanishes does so in t itself, with its sign"),
        },
        Regime {
            name: "bits",
            what: "six numbers of any bits, the faces in order",
            draw: bits,
            notes: Misjudge("notes", F64),
        },
    ]
}

/// Why there is nothing to lose.
const TWO_ROUNDINGS: &str = "one subtraction and one division: two roundings, and nothing to cancel";

/// A ray and a wall.
struct Scene {
    ray: Ray2<f64>,
    wall: Wall<f64>,
}

impl Scene {
    /// The columns of a case file.
    fn numbers(&self) -> [f64; 6] {
        let Scene { ray: Ray2 { origin: o, direction: d }, wall: Wall { front, back } } = self;
        [o.x, o.y, d.x, d.y, *front, *back]
    }

    /// Every length times a factor, the direction as it is.
    fn scaled(mut self, factor: f64) -> Scene {
        self.ray.origin *= factor;
        self.wall = Wall { front: self.wall.front * factor, back: self.wall.back * factor };
        self
    }

    /// The direction times a factor.
    fn with_direction_times(mut self, factor: f64) -> Scene {
        self.ray.direction *= factor;
        self
    }
}

/// How far the wall and the height of the origin are from the world's origin, if nothing else is said.
const SPREAD: f64 = 10.0;

/// A wall as thick as walls are.
fn wall(draw: &mut Draw) -> Wall<f64> {
    let front = draw.uniform(-SPREAD, SPREAD);
    Wall { front, back: front + draw.uniform(0.1, 5.0) }
}

/// An origin that far before the wall, or behind it.
fn outside(draw: &mut Draw, wall: Wall<f64>, distance: f64) -> Vec2 {
    let x = if draw.coin() { wall.front - distance } else { wall.back + distance };
    f64::vec2(x, draw.uniform(-SPREAD, SPREAD))
}

/// A ray that starts that far from the wall, in any direction.
fn at_distance(draw: &mut Draw, wall: Wall<f64>, distance: f64) -> Scene {
    let origin = outside(draw, wall, distance);
    Scene { ray: Ray2::<f64>::new(origin, draw.direction_in_plane()), wall }
}

/// Numbers as pictures have them.
fn ordinary(draw: &mut Draw) -> Scene {
    let (wall, distance) = (wall(draw), draw.uniform(0.1, 40.0));
    at_distance(draw, wall, distance)
}

/// t in lengths of a direction that is not 1.
fn unnormalized(draw: &mut Draw) -> [f64; 6] {
    let length = draw.log_uniform(1e-6, 1e6);
    ordinary(draw).with_direction_times(length).numbers()
}

/// From within the wall: every ray hits, where it leaves.
fn inside(draw: &mut Draw) -> [f64; 6] {
    let mut inside = ordinary(draw);
    inside.ray.origin.x = draw.uniform(inside.wall.front, inside.wall.back);
    inside.numbers()
}

/// From a face: t = 0 touches and is the hit, whatever the direction.
fn on_face(draw: &mut Draw) -> [f64; 6] {
    let mut on_face = ordinary(draw);
    on_face.ray.origin.x = if draw.coin() { on_face.wall.front } else { on_face.wall.back };
    on_face.numbers()
}

/// A wall seen from afar.
fn far(draw: &mut Draw) -> [f64; 6] {
    let (wall, distance) = (wall(draw), draw.log_uniform(1e2, 1e15));
    at_distance(draw, wall, distance).numbers()
}

/// A wall like paper. What is thinner than the last digit of `front` has no thickness.
fn thin(draw: &mut Draw) -> [f64; 6] {
    let (front, distance) = (draw.uniform(-SPREAD, SPREAD), draw.uniform(0.1, 40.0));
    let wall = Wall { front, back: front + draw.log_uniform(1e-15, 1e-3) };
    at_distance(draw, wall, distance).numbers()
}

/// All but along the faces.
fn near_parallel(draw: &mut Draw) -> [f64; 6] {
    let mut nearly = ordinary(draw);
    nearly.ray.direction = f64::vec2(draw.sign() * draw.log_uniform(1e-15, 1e-3), draw.sign());
    nearly.numbers()
}

/// Along the faces: no ray hits.
fn parallel(draw: &mut Draw) -> [f64; 6] {
    let mut along = ordinary(draw);
    along.ray.direction = f64::vec2(0.0, draw.uniform(-1.0, 1.0));
    match draw.below(3) {
        0 => {}
        1 => along.ray.origin.x = draw.uniform(along.wall.front, along.wall.back),
        _ => along.ray.origin.x = along.wall.front,
    }
    along.numbers()
}

/// Far from the world's origin, where numbers are coarse.
fn moved(draw: &mut Draw, by: f64) -> [f64; 6] {
    let (way, mut moved) = (draw.sign() * by, ordinary(draw));
    moved.ray.origin.x += way;
    moved.wall = Wall { front: moved.wall.front + way, back: moved.wall.back + way };
    moved.numbers()
}

/// Far from the world's origin, as far as some digits of a distance remain.
fn moved_anywhere(draw: &mut Draw) -> [f64; 6] {
    let (nearest, farthest) = draw.by_precision((1e5, 1e12), (1e4, 1e7));
    let by = draw.log_uniform(nearest, farthest);
    moved(draw, by)
}

/// A direction whose square would overflow or vanish.
fn direction_extreme(draw: &mut Draw) -> [f64; 6] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let length = draw.huge_or_tiny(low, high);
    ordinary(draw).with_direction_times(length).numbers()
}

/// A scene of very large or very small lengths.
fn scale_extreme(draw: &mut Draw) -> [f64; 6] {
    let (low, high) = draw.by_precision((1e87, 1e290), (1e12, 1e30));
    let factor = draw.huge_or_tiny(low, high);
    ordinary(draw).scaled(factor).numbers()
}

/// A wall behind the origin whose t is so small that it vanishes: −0 is not below 0.
fn both_extreme(draw: &mut Draw) -> [f64; 6] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let [lengths, direction] = std::array::from_fn(|_| draw.huge_or_tiny(low, high));
    ordinary(draw).scaled(lengths).with_direction_times(direction).numbers()
}

/// A scene at the smallest scale there is.
fn subnormal(draw: &mut Draw) -> [f64; 6] {
    let scale = draw.subnormal_scale();
    let scene = ordinary(draw).scaled(scale);
    if draw.coin() { scene.numbers() } else { scene.with_direction_times(scale).numbers() }
}

/// Numbers at the ends of what there is.
fn special(draw: &mut Draw) -> [f64; 6] {
    let case = ordinary(draw).numbers();
    draw.with_special_numbers(case)
}

/// Any numbers.
fn bits(draw: &mut Draw) -> [f64; 6] {
    let [ox, oy, dx, dy, front, back] = draw.any_numbers();
    let (front, back) = if front > back { (back, front) } else { (front, back) };
    [ox, oy, dx, dy, front, back]
}

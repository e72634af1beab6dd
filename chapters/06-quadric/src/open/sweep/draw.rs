//! How a case of each regime is drawn: a cone anywhere, and a ray aimed at a point of its wall, or past it.

use lab::{Draw, Vec3};
use math::Real;

/// What draws a case.
pub(super) type Regime = fn(&mut Draw) -> [f64; 14];

/// Every kind of ray.
pub(super) const REGIMES: [(&str, Regime); 19] = [
    ("ordinary", ordinary),
    ("unnormalized", unnormalized),
    ("behind", behind),
    ("equal-radii", equal_radii),
    ("far", far),
    ("far-scene", far_scene),
    ("inside", inside),
    ("grazing", grazing),
    ("edge", edge),
    ("edge-exact", edge_exact),
    ("near-generator", near_generator),
    ("generator-exact", generator_exact),
    ("tip", tip),
    ("on-wall", on_wall),
    ("end-plane-exact", end_plane_exact),
    ("direction-extreme", direction_extreme),
    ("subnormal", subnormal),
    ("special", special),
    ("bits", bits),
];

/// A cone as it is drawn, its numbers already rounded to the precision, with a frame of its own.
#[derive(Clone, Copy)]
struct Drawn {
    base: Vec3,
    v: Vec3,
    radii: [f64; 2],
    /// Two directions across the axis.
    across: [Vec3; 2],
}

impl Drawn {
    /// One of radii that are drawn as `kind` says: 0 any, 1 equal, 2 and 3 with a tip.
    fn of_kind(draw: &mut Draw, kind: u64) -> Drawn {
        let base = draw.in_cube(2.0);
        let v = draw.direction() * draw.log_uniform(0.2, 5.0);
        let [r, other] = [0, 1].map(|_| draw.log_uniform(0.1, 2.0));
        let radii = match kind {
            0 => [r, other],
            1 => [r, r],
            2 => [r, 0.0],
            _ => [0.0, r],
        };
        Drawn::of(draw, base, base + v, radii)
    }

    fn any(draw: &mut Draw) -> Drawn {
        let kind = draw.below(4);
        Drawn::of_kind(draw, kind)
    }

    fn of(draw: &mut Draw, base: Vec3, apex: Vec3, radii: [f64; 2]) -> Drawn {
        let [base, apex] = [base, apex].map(|end| draw.rounded_vector(end));
        let v = apex - base;
        let first = draw.perpendicular(v / v.length());
        let across = [first, first.cross(v / v.length())];
        Drawn { base, v, radii: radii.map(|r| draw.rounded(r)), across }
    }

    fn radius(&self, s: f64) -> f64 {
        self.radii[0] + s * (self.radii[1] - self.radii[0])
    }

    /// A point at the height s, so many radii from the axis.
    fn point(&self, draw: &mut Draw, s: f64, radii: f64) -> Vec3 {
        let out = self.out(draw);
        self.base + self.v * s + out * (radii * self.radius(s))
    }

    /// A direction across the axis.
    fn out(&self, draw: &mut Draw) -> Vec3 {
        let around = draw.direction_in_plane();
        self.across[0] * around.x + self.across[1] * around.y
    }

    /// A point in and around it.
    fn about(&self, draw: &mut Draw) -> Vec3 {
        let (s, radii) = (draw.uniform(-0.3, 1.3), draw.uniform(0.0, 1.2));
        self.point(draw, s, radii)
    }

    /// The columns of the oracle.
    fn case(&self, o: Vec3, d: Vec3) -> [f64; 14] {
        let (b, a, [r_b, r_a]) = (self.base, self.base + self.v, self.radii);
        [o.x, o.y, o.z, d.x, d.y, d.z, b.x, b.y, b.z, r_b, a.x, a.y, a.z, r_a]
    }

    /// A ray from so far before a point.
    fn aimed(&self, at: Vec3, direction: Vec3, distance: f64) -> [f64; 14] {
        self.case(at - direction * distance, direction)
    }
}

/// Some way off.
fn away(draw: &mut Draw) -> f64 {
    draw.uniform(3.0, 20.0)
}

fn ordinary(draw: &mut Draw) -> [f64; 14] {
    let cone = Drawn::any(draw);
    of_length(draw, cone, 1.0)
}

fn of_length(draw: &mut Draw, cone: Drawn, length: f64) -> [f64; 14] {
    let (at, direction, distance) = (cone.about(draw), draw.direction(), away(draw));
    cone.case(at - direction * distance, direction * length)
}

fn unnormalized(draw: &mut Draw) -> [f64; 14] {
    let (cone, length) = (Drawn::any(draw), draw.log_uniform(1e-6, 1e6));
    of_length(draw, cone, length)
}

fn behind(draw: &mut Draw) -> [f64; 14] {
    let cone = Drawn::any(draw);
    of_length(draw, cone, -1.0)
}

fn equal_radii(draw: &mut Draw) -> [f64; 14] {
    let cone = Drawn::of_kind(draw, 1);
    of_length(draw, cone, 1.0)
}

fn far(draw: &mut Draw) -> [f64; 14] {
    let farthest = draw.by_precision(1e10, 1e6);
    let (cone, distance) = (Drawn::any(draw), draw.log_uniform(1e3, farthest));
    let (at, direction) = (cone.about(draw), draw.direction());
    cone.aimed(at, direction, distance)
}

/// Cone and ray far from the origin of the coordinates.
fn far_scene(draw: &mut Draw) -> [f64; 14] {
    let (cone, farthest) = (Drawn::any(draw), draw.by_precision(1e10, 1e4));
    let offset = draw.direction() * draw.log_uniform(1e2, farthest);
    let cone = Drawn::of(draw, cone.base + offset, cone.base + offset + cone.v, cone.radii);
    of_length(draw, cone, 1.0)
}

fn inside(draw: &mut Draw) -> [f64; 14] {
    let cone = Drawn::any(draw);
    let (s, radii) = (draw.uniform(0.02, 0.98), draw.uniform(0.0, 0.95));
    cone.case(cone.point(draw, s, radii), draw.direction())
}

/// Touching the wall, but for 1e-3 to 1e-15 of its radius on either side.
fn grazing(draw: &mut Draw) -> [f64; 14] {
    let (cone, nearest) = (Drawn::any(draw), draw.by_precision(1e-15, 1e-7));
    let off = 1.0 + draw.sign() * draw.log_uniform(nearest, 1e-3);
    let (s, out) = (draw.uniform(0.05, 0.95), cone.out(draw));
    let at = cone.base + cone.v * s + out * (off * cone.radius(s));
    // The tangent plane of the wall: around it, and along its straight line.
    let along = cone.v + out * (cone.radii[1] - cone.radii[0]);
    let direction = cone.v.cross(out) / cone.v.length() + along * draw.uniform(-1.5, 1.5);
    let distance = away(draw);
    cone.aimed(at, direction, distance)
}

/// Aimed at a point of an edge, rounded.
fn edge(draw: &mut Draw) -> [f64; 14] {
    let cone = Drawn::any(draw);
    let (s, direction, distance) = (draw.whole(0, 1), draw.direction(), away(draw));
    cone.aimed(cone.point(draw, s, 1.0), direction, distance)
}

/// A cone of whole numbers in a whole frame, and the corner x of each edge: where the wall has a straight line.
fn whole(draw: &mut Draw) -> (Drawn, [Vec3; 2], Vec3) {
    let ([x, y, z], length) = draw.whole_frame();
    let base = whole_vector(draw, 9);
    let height = draw.whole(1, 3);
    let radii = loop {
        let radii = [draw.whole(0, 3), draw.whole(0, 3)];
        if radii != [0.0; 2] {
            break radii;
        }
    };
    let cone =
        Drawn { base, v: z * height, radii: radii.map(|r| r * length), across: [x / length, y / length] };
    (cone, [base + x * radii[0], base + z * height + x * radii[1]], y)
}

/// A vector of whole numbers, not zero.
fn whole_vector(draw: &mut Draw, largest: i32) -> Vec3 {
    loop {
        let [x, y, z] = std::array::from_fn(|_| draw.whole(-largest, largest));
        if [x, y, z] != [0.0; 3] {
            return f64::vec3(x, y, z);
        }
    }
}

/// Exactly through a point of an edge, or a digit past it.
fn edge_exact(draw: &mut Draw) -> [f64; 14] {
    let (cone, corners, _) = whole(draw);
    let (at, direction) = (corners[draw.below(2) as usize], whole_vector(draw, 30));
    let steps = draw.whole(-1, 6);
    nudged(draw, cone.aimed(at, direction, steps))
}

/// The ray of a case, one number of it moved by a digit or two, one time of two.
fn nudged(draw: &mut Draw, mut case: [f64; 14]) -> [f64; 14] {
    let ray: [f64; 6] = std::array::from_fn(|i| draw.rounded(case[i]));
    if draw.coin() {
        case[..6].copy_from_slice(&draw.nudged(ray));
    }
    case
}

/// All but parallel to a straight line of the wall, and near it.
fn near_generator(draw: &mut Draw) -> [f64; 14] {
    let (cone, nearest) = (Drawn::any(draw), draw.by_precision(1e-15, 1e-7));
    let (out, off) = (cone.out(draw), draw.log_uniform(nearest, 1e-3));
    let along = (cone.v + out * (cone.radii[1] - cone.radii[0])) * draw.sign();
    let s = draw.uniform(0.0, 1.0);
    let at = if draw.coin() { cone.about(draw) } else { cone.base + cone.v * s + out * cone.radius(s) };
    let distance = draw.uniform(-1.0, 8.0);
    cone.aimed(at, along + draw.direction() * (off * along.length()), distance)
}

/// Parallel to a straight line of the wall in whole numbers: A = 0; half of them in the wall, or a digit beside it.
fn generator_exact(draw: &mut Draw) -> [f64; 14] {
    let (cone, corners, _) = whole(draw);
    let direction = (corners[1] - corners[0]) * draw.sign() * draw.whole(1, 3);
    let side = if draw.coin() { f64::vec3(0.0, 0.0, 0.0) } else { whole_vector(draw, 9) };
    let steps = draw.whole(-4, 8) / 4.0;
    nudged(draw, cone.aimed(corners[0] + side, direction, steps))
}

/// At the tip: half of them in whole numbers, through it exactly; the others rounded, just past it.
fn tip(draw: &mut Draw) -> [f64; 14] {
    let at_base = draw.coin();
    if draw.coin() {
        let (mut cone, _, _) = whole(draw);
        let r = cone.radii[0].max(cone.radii[1]);
        cone.radii = if at_base { [0.0, r] } else { [r, 0.0] };
        let at = if at_base { cone.base } else { cone.base + cone.v };
        let (direction, steps) = (whole_vector(draw, 20), draw.whole(-1, 8));
        return nudged(draw, cone.aimed(at, direction, steps));
    }
    let cone = Drawn::of_kind(draw, if at_base { 3 } else { 2 });
    let at = if at_base { cone.base } else { cone.base + cone.v };
    let (direction, distance) = (draw.direction(), away(draw));
    cone.aimed(at, direction, distance)
}

/// The origin a rounded point of the wall: a secondary ray.
fn on_wall(draw: &mut Draw) -> [f64; 14] {
    let (cone, s) = (Drawn::any(draw), draw.uniform(0.0, 1.0));
    cone.case(cone.point(draw, s, 1.0), draw.direction())
}

/// Exactly in the plane of an end, in whole numbers; many of them touch the edge or go through its corner.
fn end_plane_exact(draw: &mut Draw) -> [f64; 14] {
    let (cone, corners, y) = whole(draw);
    let end = draw.below(2) as usize;
    let middle = cone.base + cone.v * end as f64;
    let x = cone.across[0] * y.length();
    let direction = match draw.below(3) {
        0 => y,
        1 => x,
        _ => x * draw.whole(-3, 3) + y * draw.whole(1, 3),
    };
    let at = if draw.coin() { corners[end] } else { middle };
    let steps = draw.whole(-1, 6);
    nudged(draw, cone.aimed(at.map(f64::round), direction.map(f64::round), steps))
}

fn direction_extreme(draw: &mut Draw) -> [f64; 14] {
    let (low, high) = draw.by_precision((1e150, 1e300), (1e18, 1e36));
    let (cone, length) = (Drawn::any(draw), draw.huge_or_tiny(low, high));
    of_length(draw, cone, length)
}

fn subnormal(draw: &mut Draw) -> [f64; 14] {
    let (cone, scale) = (Drawn::any(draw), draw.subnormal_scale());
    of_length(draw, cone, scale)
}

fn special(draw: &mut Draw) -> [f64; 14] {
    let case = ordinary(draw);
    draw.with_special_numbers(case)
}

/// Any bits; the radii without their signs.
fn bits(draw: &mut Draw) -> [f64; 14] {
    let mut case: [f64; 14] = draw.any_numbers();
    (case[9], case[13]) = (case[9].abs(), case[13].abs());
    case
}

//! CSC418 11.3.5: every point where the line meets the wall or a plane, tested, and the smallest λ.

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use crate::{Hit3, Part, Shape};

/// Every number of the page's method. The ray is a + λ d; the page's B is half of the linear coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notes<R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The solid.
    pub shape: Shape,
    /// A = d_x² + d_y², for the cone − ¼ d_z²
    pub a: R,
    /// B = a_x d_x + a_y d_y, for the cone + ¼(1 − a_z) d_z
    pub b: R,
    /// C = f(a): a_x² + a_y² − 1, for the cone a_x² + a_y² − ¼(1 − a_z)²
    pub c: R,
    /// D = B² − A C, below zero where the line misses the endless wall
    pub d: R,
    all: [Candidate<R>; 4],
    count: usize,
}

/// A point where the line meets the wall or the plane of a cap, if it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<R: Real> {
    /// Which part of the surface this would be.
    pub part: Part,
    /// λ, in lengths of d; `None` where the line does not meet the wall or the plane.
    pub lambda: Option<R>,
    /// p(λ) = a + λ d; for a cap its z is that of the plane, exactly. The origin of the ray where there is
    /// no λ.
    pub point: R::Vec3,
    /// What the page's test says of it.
    pub test: Test,
}

/// What the test of a candidate says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// There is no such point: D < 0, or A = 0 and no other root, or the ray is parallel to the plane.
    NoPoint,
    /// A point of the wall above or below the solid, or beyond the largest number.
    ZOutside,
    /// A point of the plane beyond the rim.
    BeyondRim,
    /// A point of the solid's surface.
    OnSurface,
}

/// What becomes of a candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is no point of the solid: [`Test`] says why.
    Dropped(Test),
    /// λ < 0, or whatever else lies outside the span.
    OutsideSpan,
    /// Another one is nearer, or as near and comes before it: the wall comes before the caps.
    Farther,
    /// The hit.
    Nearest,
}

impl Fate {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Fate::Dropped(Test::NoPoint) => "dropped: no such point",
            Fate::Dropped(Test::ZOutside) => "dropped: z is outside",
            Fate::Dropped(Test::BeyondRim) => "dropped: beyond the rim",
            // (A point of the surface is not dropped.)
            Fate::OutsideSpan | Fate::Dropped(Test::OnSurface) => "dropped: behind",
            Fate::Farther => "dropped: farther",
            Fate::Nearest => "kept: the nearest",
        }
    }
}

/// Works out the page's method (CSC418 11.3.5), for a direction of any length but zero.
///
/// A degenerate ray gives values that mean nothing; [`Notes::hit`] refuses it.
#[inline]
pub fn notes<R: Real>(ray: &Ray3<R>, shape: Shape) -> Notes<R> {
    // The quadratic wall: f(a + λ d) = A λ² + 2 B λ + C = 0
    let (a, b, c) = wall(ray, shape);
    // exercise discriminant: Which number tells, before any root is taken, whether A λ² + 2 B λ + C = 0 has a solution?
    let d = b * b - a * c;
    // end discriminant
    let lambdas = wall_roots(a, b, c, d);

    // Then test the z component of p(λ*) against the constraint on z.
    let nowhere = Candidate { part: Part::Wall, lambda: None, point: ray.origin, test: Test::NoPoint };
    let mut all = [nowhere; 4];
    for (candidate, lambda) in all.iter_mut().zip(lambdas) {
        *candidate = on_wall(ray, shape, lambda);
    }

    // Intersect the ray with the planes containing the base or cap, and test x and y.
    let caps = shape.caps();
    for (candidate, &part) in all[2..].iter_mut().zip(caps) {
        *candidate = on_plane(ray, shape, part);
    }
    Notes { ray: *ray, shape, a, b, c, d, all, count: 2 + caps.len() }
}

/// A, B and C of the wall.
#[inline]
fn wall<R: Real>(ray: &Ray3<R>, shape: Shape) -> (R, R, R) {
    match shape {
        Shape::Cylinder => cylinder(ray),
        Shape::Cone => cone(ray),
    }
}

/// A, B and C of x² + y² − 1 = 0.
#[inline]
fn cylinder<R: Real>(ray: &Ray3<R>) -> (R, R, R) {
    let ([a_x, a_y, _], [d_x, d_y, _], one) = (R::xyz(ray.origin), R::xyz(ray.direction), R::from(1.0));
    // exercise cylinder: Put a + λ d into x² + y² − 1 = 0: what are A, B and C of A λ² + 2 B λ + C = 0?
    (d_x * d_x + d_y * d_y, a_x * d_x + a_y * d_y, a_x * a_x + a_y * a_y - one)
    // end cylinder
}

/// A, B and C of x² + y² − ¼(1 − z)² = 0.
#[inline]
fn cone<R: Real>(ray: &Ray3<R>) -> (R, R, R) {
    let ([a_x, a_y, a_z], [d_x, d_y, d_z]) = (R::xyz(ray.origin), R::xyz(ray.direction));
    // exercise cone: Put a + λ d into x² + y² − ¼(1 − z)² = 0: what are A, B and C of A λ² + 2 B λ + C = 0?
    let (below_apex, quarter) = (R::from(1.0) - a_z, R::from(0.25));
    let a = d_x * d_x + d_y * d_y - quarter * d_z * d_z;
    let b = a_x * d_x + a_y * d_y + quarter * below_apex * d_z;
    let c = a_x * a_x + a_y * a_y - quarter * below_apex * below_apex;
    (a, b, c)
    // end cone
}

/// λ1 and λ2 of A λ² + 2 B λ + C = 0, as in 11.3.3.
///
/// With A = 0, where a ray runs along the slope of the cone or the axis of the cylinder, the equation is linear: one
/// root −C / 2B, or none.
#[inline]
fn wall_roots<R: Real>(a: R, b: R, c: R, d: R) -> [Option<R>; 2] {
    let zero = R::from(0.0);
    if a == zero {
        let root = if b == zero { None } else { Some(-c / (b + b)) };
        return [root, None];
    }
    if d < zero {
        return [None, None];
    }
    // exercise roots: What are the two solutions of A λ² + 2 B λ + C = 0?
    let root = d.sqrt();
    [Some(-b / a + root / a), Some(-b / a - root / a)]
    // end roots
}

/// A point of the wall, kept where 0 ≤ z ≤ 1, or |z| ≤ 1 for the cylinder. (The page's "z ≤ 1 or z < 1" lacks the
/// lower bound, and with < for wall and cap alike a ray slips through the rim.)
#[inline]
fn on_wall<R: Real>(ray: &Ray3<R>, shape: Shape, lambda: Option<R>) -> Candidate<R> {
    let Some(at) = lambda else {
        return Candidate { part: Part::Wall, lambda, point: ray.origin, test: Test::NoPoint };
    };
    let point = ray.at(at);
    let (lowest, highest) = shape.heights::<R>();
    let z = R::xyz(point)[2];
    // exercise between: Which points of the endless wall belong to the solid, its rims included?
    let is_between: bool = lowest <= z && z <= highest;
    // end between
    // A root that overflowed has no point to show.
    let test = if is_between && point.is_finite() { Test::OnSurface } else { Test::ZOutside };
    Candidate { part: Part::Wall, lambda, point, test }
}

/// A point of a cap's plane, kept where x² + y² ≤ 1, or ≤ ¼ for the base of the cone.
#[inline]
fn on_plane<R: Real>(ray: &Ray3<R>, shape: Shape, part: Part) -> Candidate<R> {
    let (height, d_z) = (R::from(part.height().unwrap_or(0.0)), R::xyz(ray.direction)[2]);
    if d_z == R::from(0.0) {
        return Candidate { part, lambda: None, point: ray.origin, test: Test::NoPoint };
    }
    // exercise plane: At which λ is z of a + λ d the height of the plane?
    let lambda = (height - R::xyz(ray.origin)[2]) / d_z;
    // end plane
    let [x, y, _] = R::xyz(ray.at(lambda));
    let point = R::vec3(x, y, height);
    // exercise rim: Which points of the plane belong to the cap, the rim included?
    let is_within: bool = shape.wall::<R>(point) <= R::from(0.0);
    // end rim
    let test = if is_within { Test::OnSurface } else { Test::BeyondRim };
    Candidate { part, lambda: Some(lambda), point, test }
}

impl<R: Real> Notes<R> {
    /// λ1 = −B/A + √D/A and λ2 = −B/A − √D/A of the wall, then the caps from the top down.
    pub fn candidates(&self) -> &[Candidate<R>] {
        &self.all[..self.count]
    }

    /// The place among the candidates of the one with the smallest λ in `span`; on a tie the first. `None`
    /// where none of them is a point of the surface in the span.
    #[inline]
    pub fn nearest(&self, span: Span<R>) -> Option<usize> {
        // exercise nearest: Which candidates count, and which of them does the ray meet first?
        let mut nearest = None;
        let mut smallest = R::INFINITY;
        for (place, candidate) in self.all.iter().enumerate() {
            let Some(lambda) = candidate.lambda else { continue };
            let counts = candidate.test == Test::OnSurface && span.contains(lambda);
            if counts && (nearest.is_none() || lambda < smallest) {
                nearest = Some(place);
                smallest = lambda;
            }
        }
        nearest
        // end nearest
    }

    /// What becomes of a candidate, by its place among [`Notes::candidates`], which it must have.
    pub fn fate(&self, place: usize, span: Span<R>) -> Fate {
        let candidate = &self.all[place];
        match (candidate.test, candidate.lambda) {
            (Test::OnSurface, Some(lambda)) if !span.contains(lambda) => Fate::OutsideSpan,
            (Test::OnSurface, _) if self.nearest(span) == Some(place) => Fate::Nearest,
            (Test::OnSurface, _) => Fate::Farther,
            (test, _) => Fate::Dropped(test),
        }
    }

    /// The nearest hit in `span`: "the intersection with the smallest positive λ", λ = 0 included. The
    /// normal is that of [`Shape::normal`].
    ///
    /// `None` for a miss, [`Degenerate`] for a ray that asks nothing, see [`Ray3::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.ray.check()?;
        let Some(place) = self.nearest(span) else { return Ok(None) };
        let Candidate { part, lambda, point, .. } = self.all[place];
        let normal = self.shape.normal::<R>(part, point);
        Ok(lambda.map(|lambda| Hit { t: lambda + R::from(0.0), point, normal })) // minus zero is zero
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn hit(shape: Shape, origin: [f64; 3], direction: [f64; 3]) -> Option<Hit3<f64>> {
        let ray = Ray3::new(origin.into(), direction.into());
        notes(&ray, shape).hit(Span::ahead()).unwrap()
    }

    /// By hand, for ā = (2, 3, 5) and d⃗ = (4, 5, 2): of the cylinder 16 + 25, 8 + 15, 4 + 9 − 1; of the cone, where 1 − z is
    /// −4 − 2 λ, those without the 1, less a quarter of 4, of 8, and of 16.
    #[test]
    fn a_b_and_c_of_a_ray_askew() {
        let ray = Ray3::<f64>::new(DVec3::new(2.0, 3.0, 5.0), DVec3::new(4.0, 5.0, 2.0));
        assert_eq!(wall(&ray, Shape::Cylinder), (41.0, 23.0, 12.0));
        assert_eq!(wall(&ray, Shape::Cone), (40.0, 21.0, 9.0));
    }

    /// From on the top down, λ is 0 / −1.
    #[test]
    fn minus_zero_is_zero() {
        let hit = hit(Shape::Cylinder, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(hit.t.to_bits(), 0);
    }

    #[test]
    fn across_the_cylinder() {
        // by hand: along x at z = 0 the wall is at x = −1 and x = 1, and the caps are never met
        let ray = Ray3::<f64>::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::new(2.0, 0.0, 0.0));
        let work = notes(&ray, Shape::Cylinder);
        assert_eq!((work.a, work.b, work.c, work.d), (4.0, -6.0, 8.0, 4.0));
        let lambdas: Vec<_> = work.candidates().iter().map(|candidate| candidate.lambda).collect();
        assert_eq!(lambdas, [Some(2.0), Some(1.0), None, None]);
        let fates: Vec<_> = (0..4).map(|place| work.fate(place, Span::ahead())).collect();
        let parallel = Fate::Dropped(Test::NoPoint);
        assert_eq!(fates, [Fate::Farther, Fate::Nearest, parallel, parallel]);
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (1.0, -DVec3::X, -DVec3::X));
    }

    #[test]
    fn down_the_axis_there_is_no_wall() {
        for (shape, t) in [(Shape::Cylinder, 2.0), (Shape::Cone, 2.0)] {
            // by hand: from z = 3 the top of the cylinder and the apex of the cone, both at z = 1
            let hit = hit(shape, [0.0, 0.0, 3.0], [0.0, 0.0, -1.0]).unwrap();
            assert_eq!((hit.t, hit.normal), (t, DVec3::Z), "{shape:?}");
        }
        let within = hit(Shape::Cylinder, [0.5, 0.0, 0.0], [0.0, 0.0, -4.0]).unwrap();
        assert_eq!((within.t, within.normal), (0.25, -DVec3::Z));
    }

    /// ∇f / ‖∇f‖ is 0/0 at the apex.
    #[test]
    fn at_the_apex_there_is_no_gradient() {
        let apex = DVec3::Z;
        let gradient = Shape::Cone.half_gradient::<f64>(apex);
        assert!(gradient == DVec3::ZERO && (gradient / gradient.length()).is_nan(), "as printed");
        for part in [Part::Apex, Part::Wall] {
            assert_eq!(Shape::Cone.normal::<f64>(part, apex), DVec3::Z);
        }
    }

    /// "z ≤ 1 or z < 1" is no lower bound, and "z = 1 for the cylinder" is one cap of two (slip 24).
    #[test]
    fn as_printed_the_wall_has_no_lower_end_and_the_cylinder_one_cap() {
        // by hand: across the axis at z = −2 the walls are at x = −1, and at x = −½ · 3 of the cone; z ≤ 1 keeps both
        for (shape, t) in [(Shape::Cylinder, 2.0), (Shape::Cone, 1.5)] {
            let below = notes(&Ray3::<f64>::new(DVec3::new(-3.0, 0.0, -2.0), DVec3::X), shape);
            let [_, wall, ..] = below.candidates() else { panic!("{shape:?}") };
            assert_eq!(wall.lambda, Some(t), "{shape:?}");
            assert!(wall.point.z <= 1.0, "as printed");
            assert_eq!(below.hit(Span::ahead()), Ok(None), "{shape:?}");
        }
        // by hand: up from z = −3 along the axis the caps are at λ = 2 and 4, and z = 1 alone is the farther one
        let upward = notes(&Ray3::<f64>::new(DVec3::new(0.0, 0.0, -3.0), DVec3::Z), Shape::Cylinder);
        let lambdas: Vec<_> = upward.candidates().iter().map(|candidate| candidate.lambda).collect();
        assert_eq!(lambdas, [None, None, Some(4.0), Some(2.0)]);
        assert_eq!(upward.hit(Span::ahead()).unwrap().map(|hit| hit.t), Some(2.0));
    }

    /// A = 0: the equation is linear, and its root is −C / 2B (−c / b where b is the whole coefficient).
    #[test]
    fn along_the_slope_of_the_cone() {
        // by hand: A = 1 − ¼·4 = 0, B = −1 + ¼·2 = −½, C = 1 − ¼ = ¾, λ = −C / 2B = ¾; but z = 1.5 there
        let ray = Ray3::<f64>::new(DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 2.0));
        let work = notes(&ray, Shape::Cone);
        assert_eq!((work.a, work.b, work.c), (0.0, -0.5, 0.75));
        assert_eq!(work.candidates()[0].lambda, Some(0.75));
        let as_printed = [1.0, -1.0].map(|sign| -work.b / work.a + sign * work.d.sqrt() / work.a);
        assert!(as_printed[0].is_infinite() && as_printed[1].is_nan(), "{as_printed:?}");
    }

    /// By hand: (3 − λ, 0, 2 − ½λ) is at x = 1 and at z = 1 at λ = 2. The wall comes before the caps, and has it.
    #[test]
    fn a_tie_at_the_rim_is_the_walls() {
        let ray = Ray3::<f64>::new(DVec3::new(3.0, 0.0, 2.0), DVec3::new(-1.0, 0.0, -0.5));
        let work = notes(&ray, Shape::Cylinder);
        let lambdas: Vec<_> = work.candidates().iter().map(|candidate| candidate.lambda).collect();
        assert_eq!(lambdas, [Some(4.0), Some(2.0), Some(2.0), Some(6.0)]);
        let fates = [1, 2].map(|place| work.fate(place, Span::ahead()));
        assert_eq!(fates, [Fate::Nearest, Fate::Farther]);
        assert_eq!(work.hit(Span::ahead()).unwrap().map(|hit| hit.normal), Some(DVec3::X));
    }

    /// By hand: from the axis along x the walls are at λ = 1 and λ = −1.
    #[test]
    fn what_is_behind_is_outside_the_span() {
        let work = notes(&Ray3::<f64>::new(DVec3::ZERO, DVec3::X), Shape::Cylinder);
        let fates = [0, 1].map(|place| (work.candidates()[place].lambda, work.fate(place, Span::ahead())));
        assert_eq!(fates, [(Some(1.0), Fate::Nearest), (Some(-1.0), Fate::OutsideSpan)]);
    }
}

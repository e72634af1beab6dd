//! CSC418 11.3.2: general planar polygons.
//!
//! The page's way: "solve for the intersection with the plane. Then form a ray s(t) in the plane, starting at
//! the intersection p̄(λ*). Measure the number of intersections with the polygon sides for t > 0." Its rule for
//! that number is upside down (slip 20: an odd number means inside), and counting has a trap that the page does
//! not name: where s(t) runs through a corner or along a side. [`mod@crossing`] says how not to fall into it,
//! [`mod@even_odd`] is the page's rule put right, and [`mod@winding`] its rival, which differs where a polygon
//! overlaps itself.

mod at_once;
mod bounds;
mod check;
pub mod crossing;
pub mod even_odd;
mod newell;
mod on_plane;
mod passage;
pub mod star;
mod strips;
pub mod winding;

use math::{Degenerate, Glance, Parallel, Ray3, Real, Span, Vector};
use ray_plane::{Meeting, Plane};

use crate::Hit3;
use at_once::AtOnce;
pub use check::NotAPolygon;
pub use even_odd::{EvenOdd, even_odd};
use strips::Strips;
pub use winding::{Winding, winding};

/// A planar polygon of three corners or more: convex or not, and it may touch or overlap itself.
///
/// Its plane is Newell's: through the first corner, with the normal Σ p̄_i × p̄_{i+1}, which sees the corners turn
/// counterclockwise. Its boundary belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon<R: Real> {
    corners: Vec<R::Vec3>,
    plane: Plane<R>,
    axes: [usize; 2],
    outline: Vec<[R; 2]>,
    /// Two corners of a rectangle around the outline.
    rectangle: [[f64; 2]; 2],
    /// Which sides to ask, for an outline of many.
    strips: Option<Box<Strips>>,
}

/// The two ways to tell inside from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// CSC418's: s(t) crosses an odd number of sides.
    EvenOdd,
    /// The polygon winds around the point.
    Winding,
}

impl Rule {
    /// Both.
    pub const ALL: [Rule; 2] = [Rule::EvenOdd, Rule::Winding];

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Rule::EvenOdd => "even-odd",
            Rule::Winding => "winding",
        }
    }
}

impl<R: Real> Polygon<R> {
    /// The polygon with these corners, in order around it; its last side leads from the last corner to the
    /// first.
    ///
    /// [`NotAPolygon`] says which corner is wrong and what to do about it.
    pub fn new(corners: Vec<R::Vec3>) -> Result<Polygon<R>, NotAPolygon> {
        check::corners::<R>(&corners)?;
        let normal = newell::normal::<R>(&corners).ok_or(NotAPolygon::NoArea)?;
        let plane = Plane { point: corners[0], normal };
        check::planar(&corners, &plane)?;
        let axes = axes_of::<R>(normal);
        let outline: Vec<[R; 2]> = corners.iter().map(|&corner| flat::<R>(corner, axes)).collect();
        let along = |axis: usize| outline.iter().map(move |corner| corner[axis].into());
        let rectangle = [
            [0, 1].map(|axis| along(axis).fold(f64::INFINITY, f64::min)),
            [0, 1].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max)),
        ];
        let strips = Strips::of(&along(1).collect::<Vec<f64>>());
        Ok(Polygon { corners, plane, axes, outline, rectangle, strips })
    }

    /// Its corners, in order.
    pub fn corners(&self) -> &[R::Vec3] {
        &self.corners
    }

    /// Its plane: the first corner, and Newell's normal, not normalized. It is as long as twice the area,
    /// or scaled where that is no good number.
    pub fn plane(&self) -> Plane<R> {
        self.plane
    }

    /// The two axes of space, 0 to 2, that are left when the one along which n is longest is dropped, of several the
    /// first: seen along that one the polygon is widest. Their order is such that its corners still turn
    /// counterclockwise.
    pub fn axes(&self) -> [usize; 2] {
        self.axes
    }

    /// The corners on those axes: nothing is rounded, two coordinates are kept as they are.
    pub fn outline(&self) -> &[[R; 2]] {
        &self.outline
    }

    /// A point on those axes: its two coordinates there, as they are.
    pub fn flat(&self, point: R::Vec3) -> [R; 2] {
        flat::<R>(point, self.axes)
    }

    /// Whether a point of the plane belongs to the polygon, its boundary included: decided exactly, for the
    /// point as it is rounded. A point beside the plane is judged by its two coordinates on
    /// [`Polygon::axes`]; one that is not finite there does not belong to it.
    pub fn holds(&self, rule: Rule, point: R::Vec3) -> bool {
        let point = self.flat(point);
        if !point.iter().all(|x| x.is_finite()) {
            return false;
        }
        match rule {
            Rule::EvenOdd => even_odd(&self.outline, point).is_inside(),
            Rule::Winding => winding(&self.outline, point).is_inside(),
        }
    }

    /// How the ray runs along the plane; `None` where d⃗ · n⃗ ≠ 0. Decided exactly; the ray must be finite,
    /// and its direction not zero.
    pub fn parallel(&self, ray: &Ray3<R>) -> Option<Parallel> {
        match ray_plane::robust(ray, &self.plane).meeting() {
            Meeting::Never(how) => Some(how),
            Meeting::At(_) => None,
        }
    }

    /// The hit in `span` by the page's rule, the plane met by chapter 03's `robust`, and whether that is inside decided
    /// exactly: two polygons that share a side let no ray through between them. The normal is n / ‖n‖, not
    /// turned toward the ray.
    ///
    /// `None` for a miss, which a parallel ray is too; [`Degenerate`] for a ray that is none.
    ///
    /// What is behind the origin, or far beside the outline in plain `f64`, needs no more; and that most are.
    #[inline]
    pub fn hit(&self, ray: &Ray3<R>, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        if span.min >= R::from(0.0) && self.is_level_behind(ray) {
            return ray.check().map(|()| None);
        }
        let point = AtOnce::of(self, ray);
        if let Some(point) = &point
            && (point.is_before_or_after(span)
                || point.is_outside(self.rectangle)
                || !on_plane::holds(self, Rule::EvenOdd, ray, Some(point)))
        {
            return Ok(None);
        }
        let hit = ray_plane::robust(ray, &self.plane).hit(span)?;
        Ok(hit.filter(|_| point.is_some() || on_plane::holds(self, Rule::EvenOdd, ray, None)))
    }

    /// Whether the line of the ray passes through the polygon, decided exactly by the even-odd rule, and
    /// roughly where, for who does not need the last digits of λ. What is all behind the origin is missed,
    /// whether it does or not.
    ///
    /// [`Glance::Unsure`] for a ray that is parallel or nearly so, for numbers that are out of range, and
    /// for a ray that is none.
    #[inline]
    pub fn glance(&self, ray: &Ray3<R>) -> Glance {
        match AtOnce::of(self, ray) {
            None => Glance::Unsure,
            Some(point) if point.is_behind() || point.is_outside(self.rectangle) => Glance::Misses,
            Some(point) => match on_plane::holds(self, Rule::EvenOdd, ray, Some(&point)) {
                true => Glance::Once(point.around()),
                false => Glance::Misses,
            },
        }
    }

    /// Whether the plane is at right angles to an axis and the ray leads away from it: two comparisons tell, exactly.
    /// A ray that leaves the polygon itself is the hardest for everything else.
    #[inline(always)]
    fn is_level_behind(&self, ray: &Ray3<R>) -> bool {
        let [u, v] = self.axes;
        let (w, zero) = (3 - u - v, R::from(0.0));
        let [n, p, a, d] = [self.plane.normal, self.plane.point, ray.origin, ray.direction].map(R::xyz);
        n[u] == zero && n[v] == zero && (a[w] > p[w] && d[w] > zero || a[w] < p[w] && d[w] < zero)
    }

    /// The hit in `span` by another method for the plane, or another rule for the inside, which is asked of
    /// the point r̄(λ*) as it is rounded. `None` and [`Degenerate`] as with [`Polygon::hit`].
    pub fn hit_by(
        &self,
        plane_by: ray_plane::Method,
        rule: Rule,
        ray: &Ray3<R>,
        span: Span<R>,
    ) -> Result<Option<Hit3<R>>, Degenerate> {
        let on_plane = plane_by.work(ray, &self.plane).hit(span)?;
        Ok(on_plane.filter(|hit| self.holds(rule, hit.point)))
    }
}

/// See [`Polygon::axes`].
fn axes_of<R: Real>(normal: R::Vec3) -> [usize; 2] {
    let n: [f64; 3] = normal.in_f64();
    let longer = |a: usize, b: usize| if n[b].abs() > n[a].abs() { b } else { a };
    let dropped = longer(longer(0, 1), 2);
    let (next, last) = ((dropped + 1) % 3, (dropped + 2) % 3);
    // against the dropped axis the others turn the other way
    if n[dropped] < 0.0 { [last, next] } else { [next, last] }
}

fn flat<R: Real>(point: R::Vec3, [u, v]: [usize; 2]) -> [R; 2] {
    let point = R::xyz(point);
    [point[u], point[v]]
}

#[cfg(test)]
mod sweep;
#[cfg(test)]
mod tests;

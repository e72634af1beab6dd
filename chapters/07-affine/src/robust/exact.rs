//! The last resort: the line in integers as long as it takes, and the point of the unit object in numbers that neither
//! overflow nor vanish.
//!
//! The point is that of [`super::place`], with every difference that may cancel worked out exactly first: next to the
//! apex along the slope, or all but along the axis, nothing else would be left of it in `f64`.

use math::{Exact, Ray3, Real, Sure, Wide};
use quadric::Part;
use quadric::robust::{Place, Verdict};

use super::line::Line;
use super::solve::place_of;
use super::{Crossing, place, stored};
use crate::{Deformed, Object};

/// The line in integers as long as it takes.
pub(super) struct ExactLine {
    pub(super) line: Line<Exact>,
    /// adj A sgn det A
    adjugate: [[Exact; 3]; 3],
}

impl ExactLine {
    pub(super) fn of<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> ExactLine {
        let scaled = stored::exactly(&deformed.affine);
        ExactLine { adjugate: scaled.adjugate.clone(), line: Line::of(ray, deformed, scaled) }
    }

    /// The crossing that a verdict names; `None` for a miss.
    pub(super) fn crossing<R: Real>(&self, deformed: &Deformed<R>, verdict: Verdict) -> Option<Crossing<R>> {
        let (object, line) = (deformed.object, &self.line);
        let (place, enters) = place_of(verdict)?;
        let (lambda, p) = if let Verdict::Starts(_) = verdict {
            let s = line.s.to_wide();
            (R::from(0.0), wide(&line.o).map(|x| x / s))
        } else {
            (line.lambda(object, place, enters)?, line.point(object, place, enters))
        };
        let p = p.map(Wide::to_f64);
        let n = place::normal(object, place.part, p);
        // A⁻ᵀ n is adjᵀ A n but for its length. Nothing may be rounded before the sum, of which little may be left.
        let outward = place::outward(object, place.part, p).map(Exact::new);
        let m = [0, 1, 2].map(|axis| {
            Exact::dot(&self.adjugate.each_ref().map(|row| row[axis].clone()), &outward).to_wide()
        });
        let longest = largest(m);
        let a_inverse_transposed_n = m.map(|x| (x / longest).to_f64());
        Some(Crossing { lambda: lambda + R::from(0.0), p, n, a_inverse_transposed_n, enters })
    }
}

impl Line<Exact> {
    /// The point p with p × d = w where the line enters the surface at this place, or leaves it.
    fn point(&self, object: Object, place: Place, enters: bool) -> [Wide; 3] {
        if let Some(height) = place.plane.and_then(Part::height) {
            return self.on_plane(height.into());
        }
        let root = self.chord(object).to_wide().sqrt();
        let root = if enters { -root } else { root };
        match object {
            Object::Cylinder => self.on_cylinder(root),
            Object::Cone => self.on_cone(root),
            Object::Sphere | Object::Plane | Object::Triangle => self.on_sphere(root),
        }
    }

    fn on_plane(&self, height: f64) -> [Wide; 3] {
        let ([d_x, d_y, d_z], [w_x, w_y, _]) = (self.d.clone(), self.w.clone());
        let z = Exact::new(height);
        let across = [z.clone() * d_x - w_y, w_x + z * d_y];
        let [x, y] = across.map(|x| x.to_wide() / d_z.to_wide());
        [x, y, Wide::from(height)]
    }

    fn on_sphere(&self, root: Wide) -> [Wide; 3] {
        let a = Exact::dot(&self.d, &self.d).to_wide();
        let (closest, d) = (wide(&cross(&self.d, &self.w)), wide(&self.d));
        [0, 1, 2].map(|axis| (closest[axis] + root * d[axis]) / a)
    }

    /// z = (m + √D d_z) / A with m = w_y d_x − w_x d_y. Where the two differ in sign, m² less the square of the other is
    /// A (w_x² + w_y² − d_z²), by Lagrange's identity, and nothing cancels.
    fn on_cylinder(&self, root: Wide) -> [Wide; 3] {
        let ([d_x, d_y, d_z], [w_x, w_y, w_z]) = (&self.d, &self.w);
        let product = |x: &Exact, y: &Exact| x.clone() * y.clone();
        let a = (product(d_x, d_x) + product(d_y, d_y)).to_wide();
        let x = (product(d_y, w_z).to_wide() + root * d_x.to_wide()) / a;
        let y = (root * d_y.to_wide() - product(d_x, w_z).to_wide()) / a;
        let m = (product(w_y, d_x) - product(w_x, d_y)).to_wide();
        let along = root * d_z.to_wide();
        let z = if m.is_negative() == along.is_negative() {
            (m + along) / a
        } else {
            (product(w_x, w_x) + product(w_y, w_y) - product(d_z, d_z)).to_wide() / (m - along)
        };
        [x, y, z]
    }

    /// From the point q nearest to the apex, by the wall's quadratic along q + μ d.
    fn on_cone(&self, root: Wide) -> [Wide; 3] {
        let ([d_x, d_y, _], [w_x, w_y, w_z]) = (self.d.clone(), self.w.clone());
        // the moment about the apex; and q times the square of the length of d
        let v = [w_x + d_y, w_y - d_x, w_z];
        let q = cross(&self.d, &v);
        let length = Exact::dot(&self.d, &self.d).to_wide();
        let a = form(&self.d, &self.d).to_wide();
        let b = -form(&q, &self.d).to_wide() / length;
        let c = form(&q, &q).to_wide() / (length * length);
        let (numerator, denominator) =
            if b.is_negative() == root.is_negative() { (b + root, a) } else { (c, b - root) };
        // All is zero for a line through the apex along the slope.
        let mu = if numerator.is_zero() { Wide::ZERO } else { numerator / denominator };
        let (q, d) = (wide(&q).map(|x| x / length), wide(&self.d));
        let [x, y, below] = [0, 1, 2].map(|axis| q[axis] + mu * d[axis]);
        [x, y, below + Wide::from(1.0)]
    }
}

/// The wall's form: x² + y² − ¼ z²
fn form([u_x, u_y, u_z]: &[Exact; 3], [v_x, v_y, v_z]: &[Exact; 3]) -> Exact {
    let product = |x: &Exact, y: &Exact| x.clone() * y.clone();
    product(u_x, v_x) + product(u_y, v_y) - Exact::new(0.25) * product(u_z, v_z)
}

fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    Sure::cross(a, b)
}

fn wide(v: &[Exact; 3]) -> [Wide; 3] {
    [v[0].to_wide(), v[1].to_wide(), v[2].to_wide()]
}

/// The size of the largest component of a vector that is not zero.
fn largest(v: [Wide; 3]) -> Wide {
    let size = |x: Wide| if x.is_negative() { -x } else { x };
    v.into_iter().map(size).fold(Wide::ZERO, |most, x| if (most - x).is_negative() { x } else { most })
}

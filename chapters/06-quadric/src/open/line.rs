//! The numbers of a line beside an open cone, each written once for every kind of number.
//!
//! With p = o − b, the moment q = p × d of the line about the base, and k = r_a − r_b. Nothing is divided by v·v.

use std::cmp::Ordering;

use math::{Quadratic, Real, Sure};

use super::{End, OpenCone};

/// The line o + λ d beside a cone.
#[derive(Clone, Debug)]
pub(super) struct Line<N> {
    /// Its direction, not zero.
    pub(super) d: [N; 3],
    /// o − b and o − (b + v): from the middles of the two ends to the origin.
    from: [[N; 3]; 2],
    /// r_b and r_a
    pub(super) radii: [N; 2],
    /// k = r_a − r_b
    pub(super) k: N,
    /// v
    pub(super) v: [N; 3],
    /// v·v
    pub(super) vv: N,
    /// p·v: s v·v at the origin.
    pub(super) height: N,
    /// −(p − v)·v: (1 − s) v·v at the origin.
    pub(super) depth: N,
    /// d·v: how fast s v·v rises.
    pub(super) rise: N,
}

impl<N: Sure> Line<N> {
    /// The line o + λ d. The numbers must be finite.
    #[inline(always)]
    pub(super) fn new(cone: &OpenCone<f64>, o: [f64; 3], d: [f64; 3]) -> Line<N> {
        let [base, apex] = [cone.base, cone.apex].map(f64::xyz);
        let minus = |a: [f64; 3], b: [f64; 3]| -> [N; 3] {
            std::array::from_fn(|axis| N::difference(a[axis], b[axis]))
        };
        let radii = [cone.base_radius, cone.apex_radius];
        Line::with(
            [minus(o, base), minus(o, apex)],
            d.map(N::of),
            minus(apex, base),
            radii.map(N::of),
            N::difference(radii[1], radii[0]),
        )
    }

    #[inline(always)]
    fn with(from: [[N; 3]; 2], d: [N; 3], v: [N; 3], radii: [N; 2], k: N) -> Line<N> {
        let (vv, rise) = (N::dot(&v, &v), N::dot(&d, &v));
        let (height, depth) = (N::dot(&from[0], &v), -N::dot(&from[1], &v));
        Line { d, from, radii, k, v, vv, height, depth, rise }
    }

    /// The same line with its origin at λ.
    pub(super) fn starting_at(self, lambda: f64) -> Line<N> {
        let way = self.d.clone().map(|d| N::of(lambda) * d);
        let from = self.from.map(|from| {
            let [[x, y, z], [x_way, y_way, z_way]] = [from, way.clone()];
            [x + x_way, y + y_way, z + z_way]
        });
        Line::with(from, self.d, self.v, self.radii, self.k)
    }

    /// How s compares with an end at the origin: how far it is above the base, or below the apex.
    #[inline(always)]
    pub(super) fn within(&self, end: End) -> Option<Ordering> {
        match end {
            End::Base => self.height.sign(),
            End::Apex => self.depth.sign(),
        }
    }

    /// Whether s rises along the line.
    #[inline(always)]
    pub(super) fn rises(&self) -> Option<Ordering> {
        self.rise.sign()
    }

    /// The moment of the line about the middle of an end: (o − middle) × d.
    #[inline(always)]
    pub(super) fn moment(&self, end: End) -> [N; 3] {
        N::cross(&self.from[end as usize], &self.d)
    }

    /// p × v and d × v: from the axis to the line, turned about it, times ‖v‖.
    #[inline(always)]
    fn turned(&self) -> [[N; 3]; 2] {
        [&self.from[0], &self.d].map(|a| N::cross(a, &self.v))
    }

    /// v·v r(s) at the origin, r_b (1 − s) v·v + r_a s v·v, and how fast it grows: k d·v.
    #[inline(always)]
    fn radius(&self) -> [N; 2] {
        let [base, apex] = self.radii.clone();
        let radius = base * self.depth.clone() + apex * self.height.clone();
        [radius, self.k.clone() * self.rise.clone()]
    }

    /// C = v·v ‖p × v‖² − (v·v r)²: f at the origin.
    #[inline(always)]
    pub(super) fn c(&self) -> N {
        let [turned, _] = self.turned();
        let [radius, _] = self.radius();
        self.vv.clone() * N::dot(&turned, &turned) - radius.clone() * radius
    }

    /// B = −(v·v (p × v)·(d × v) − (v·v r) k d·v): half of −f′ at the origin.
    #[inline(always)]
    pub(super) fn b(&self) -> N {
        let [turned, turns] = self.turned();
        let [radius, grows] = self.radius();
        radius * grows - self.vv.clone() * N::dot(&turned, &turns)
    }

    /// A = v·v ‖d × v‖² − (k d·v)²
    #[inline(always)]
    fn a(&self) -> N {
        let [_, turns] = self.turned();
        let [_, grows] = self.radius();
        self.vv.clone() * N::dot(&turns, &turns) - grows.clone() * grows
    }

    /// (B² − A C) / (v·v)² without the cancellation of far origins.
    ///
    /// By Lagrange's identity it is ‖v × j‖² − v·v (q·v)², with j = r_b d × v − k q: of the origin nothing is left but
    /// the moment q, which is the same wherever on the line the origin is.
    #[inline(always)]
    pub(super) fn discriminant(&self) -> N {
        let q = self.moment(End::Base);
        let [_, turns] = self.turned();
        let base = self.radii[0].clone();
        let j = std::array::from_fn(|i| base.clone() * turns[i].clone() - self.k.clone() * q[i].clone());
        let (across, along) = (N::cross(&self.v, &j), N::dot(&q, &self.v));
        N::dot(&across, &across) - self.vv.clone() * (along.clone() * along)
    }

    /// A, B, C and D of the wall: f(o + λ d) = A λ² − 2 B λ + C.
    #[inline(always)]
    pub(super) fn quadratic(&self) -> Quadratic<N> {
        let vv = self.vv.clone();
        let d = vv.clone() * vv * self.discriminant();
        Quadratic { a: self.a(), b: self.b(), c: self.c(), d }
    }
}

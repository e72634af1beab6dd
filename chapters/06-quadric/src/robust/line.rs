//! The numbers of a line beside a solid, each written once for every kind of number.

use std::cmp::Ordering;

use math::{Quadratic, Sure};

use crate::{Part, Shape};

/// The line o + λ d beside a solid s times the unit one, s > 0.
///
/// With h = ½(s − z) the wall of the cone is f = x² + y² − h², which is as smooth to work with as the cylinder's
/// f = x² + y² − s²: along the line h is linear in λ, as x and y are.
#[derive(Clone, Debug)]
pub struct Line<N> {
    /// Which solid.
    pub shape: Shape,
    /// The origin of the ray.
    pub o: [N; 3],
    /// Its direction, not zero.
    pub d: [N; 3],
    /// How many times the unit solid, s > 0.
    pub s: N,
    /// ½(s − o_z) and ½ d_z: h, and how fast it falls along the line.
    half: [N; 2],
}

/// Where the line crosses the plane of a cap, everything times d_z, so that nothing is divided.
pub(super) struct Crossing<N> {
    /// The sign of f at the crossing: below zero within the wall.
    pub(super) wall: Ordering,
    /// x d_z and y d_z
    across: [N; 2],
    /// The radius of the wall there, times d_z.
    radius: N,
}

/// How far the plane of a part of a solid s times the unit one is above the height z: s − z, −s − z or −z. The wall has no
/// plane: that of z = 0 is taken.
#[inline(always)]
pub fn rise_to<N: Sure>(part: Part, s: N, z: N) -> N {
    match part {
        Part::Top | Part::Apex => s - z,
        Part::Bottom => -(s + z),
        Part::Base | Part::Wall => -z,
    }
}

impl<N: Sure> Line<N> {
    /// The line o + λ d beside the solid of that shape, s times the unit one. s must be greater than zero, d not zero.
    #[inline(always)]
    pub fn new(shape: Shape, o: [N; 3], d: [N; 3], s: N) -> Line<N> {
        let half = N::of(0.5);
        let half = [half.clone() * (s.clone() - o[2].clone()), half * d[2].clone()];
        Line { shape, o, d, s, half }
    }

    /// The line o + λ d beside the unit solid. The numbers must be finite, and d not zero.
    #[inline(always)]
    pub fn beside_unit(shape: Shape, o: [f64; 3], d: [f64; 3]) -> Line<N> {
        Line::new(shape, o.map(N::of), d.map(N::of), N::of(1.0))
    }

    /// A, B, C and D of the wall: f(o + λ d) = A λ² − 2 B λ + C (B with the other sign than the page's), D = B² − A C.
    #[inline(always)]
    pub fn quadratic(&self) -> Quadratic<N> {
        Quadratic { a: self.a(), b: self.b(), c: self.c(), d: self.discriminant() }
    }

    /// A = d_x² + d_y², for the cone − ¼ d_z²
    #[inline(always)]
    pub fn a(&self) -> N {
        let [d_x, d_y, _] = self.d.clone();
        let across = d_x.clone() * d_x + d_y.clone() * d_y;
        let [_, k] = self.half.clone();
        match self.shape {
            Shape::Cylinder => across,
            Shape::Cone => across - k.clone() * k,
        }
    }

    /// B = −(o_x d_x + o_y d_y), for the cone − ¼(s − o_z) d_z: half of −f′ at the origin.
    #[inline(always)]
    pub fn b(&self) -> N {
        let ([x, y, _], [d_x, d_y, _]) = (self.o.clone(), self.d.clone());
        let across = x * d_x + y * d_y;
        let [h, k] = self.half.clone();
        match self.shape {
            Shape::Cylinder => -across,
            Shape::Cone => -(across + h * k),
        }
    }

    /// C = o_x² + o_y² − s², or o_x² + o_y² − ¼(s − o_z)²: f at the origin.
    #[inline(always)]
    pub fn c(&self) -> N {
        let [x, y, _] = self.o.clone();
        let across = x.clone() * x + y.clone() * y;
        let [h, _] = self.half.clone();
        match self.shape {
            Shape::Cylinder => across - self.s.clone() * self.s.clone(),
            Shape::Cone => across - h.clone() * h,
        }
    }

    /// D = B² − A C without the cancellation of far origins.
    ///
    /// With the moment m = o_x d_y − o_y d_x about the axis, Lagrange's identity makes it A s² − m² for the cylinder. The
    /// cone's f is a square with a minus sign in it, and the identity has one too: D = (o_x k + h d_x)² + (o_y k + h d_y)²
    /// − m², with k = ½ d_z. The brackets are half the moments about the apex: all is zero for a line through it.
    #[inline(always)]
    pub fn discriminant(&self) -> N {
        let ([x, y, _], [d_x, d_y, _]) = (self.o.clone(), self.d.clone());
        let m = x.clone() * d_y.clone() - y.clone() * d_x.clone();
        let [h, k] = self.half.clone();
        match self.shape {
            Shape::Cylinder => {
                let s = self.s.clone();
                self.a() * (s.clone() * s) - m.clone() * m
            }
            Shape::Cone => {
                let u = x * k.clone() + h.clone() * d_x;
                let v = y * k + h * d_y;
                u.clone() * u + v.clone() * v - m.clone() * m
            }
        }
    }

    /// How far the plane of a part is above the origin, see [`rise_to`].
    #[inline(always)]
    pub fn rise_to(&self, part: Part) -> N {
        rise_to(part, self.s.clone(), self.o[2].clone())
    }

    /// The crossing with the plane of a part, where d_z is not zero; `None` in doubt.
    #[inline(always)]
    pub(super) fn crossing(&self, part: Part) -> Option<Crossing<N>> {
        let ([x, y, _], [d_x, d_y, d_z]) = (self.o.clone(), self.d.clone());
        let rise = self.rise_to(part);
        let x = x * d_z.clone() + rise.clone() * d_x;
        let y = y * d_z.clone() + rise * d_y;
        let radius = match part {
            Part::Apex => N::of(0.0),
            Part::Base => self.s.clone() * self.half[1].clone(),
            Part::Top | Part::Bottom | Part::Wall => self.s.clone() * d_z,
        };
        let across = [x.clone(), y.clone()];
        let wall = x.clone() * x + y.clone() * y - radius.clone() * radius.clone();
        Some(Crossing { wall: wall.sign()?, across, radius })
    }

    /// Whether f falls or rises along the ray where it crosses a plane; `None` in doubt.
    #[inline(always)]
    pub(super) fn slope(&self, at: &Crossing<N>) -> Option<Ordering> {
        let ([x, y], [d_x, d_y, d_z]) = (at.across.clone(), self.d.clone());
        let across = x * d_x + y * d_y;
        let slope = match self.shape {
            Shape::Cylinder => across,
            Shape::Cone => across + at.radius.clone() * self.half[1].clone(),
        };
        let times_d_z = slope.sign()?;
        Some(if d_z.sign()? == Ordering::Less { times_d_z.reverse() } else { times_d_z })
    }
}

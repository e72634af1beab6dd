//! Who is told what a tracer does.

use bounds::{Tally, Uncounted};
use math::{Ray3, Real};
use shading::lighting::Point;
use shading::{Fate, Rgb};

use crate::{Media, Refraction};

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From the eye.
    Eye,
    /// In the mirror direction.
    Mirror,
    /// Through a surface.
    Refracted,
}

impl Kind {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Eye => "eye",
            Kind::Mirror => "mirror",
            Kind::Refracted => "refracted",
        }
    }
}

/// A ray that is sent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent<R: Real> {
    /// Why.
    pub kind: Kind,
    /// The page's depth, from 1.
    pub depth: u32,
    /// The ray: an eye ray reaches the view plane at λ = 1, the others have directions of unit length.
    pub ray: Ray3<R>,
    /// What its radiance is multiplied by: r_g, or the coefficient of what goes through; 1 for an eye ray.
    pub coefficient: f64,
}

/// Is told what happens, ray by ray, in the order in which it happens. Every method has a default that does nothing.
pub trait Witness<R: Real>: Tally {
    /// Whether it wants to know of every ray where it landed, though it may not matter, and what became of each light there.
    const WANTS_LANDINGS: bool = false;

    /// A ray is sent. What follows is about it, and about the rays that are sent from where it lands, until
    /// [`Witness::ends`].
    fn sent(&mut self, _sent: &Sent<R>) {}
    /// So many rays were sent to lights.
    fn shadow_rays(&mut self, _more: u64) {}
    /// It landed on this object of the scene, at this λ. `None`: too far away to be a number.
    fn landed(&mut self, _object: usize, _lambda: R, _point: Option<&Point<R>>) {}
    /// What one light did there.
    fn light(&mut self, _light: usize, _fate: &Fate<R>) {}
    /// The local term.
    fn local(&mut self, _e: Rgb) {}
    /// The media on one side of a surface that lets light through, and then those on the other.
    fn media(&mut self, _media: &Media) {}
    /// It comes to a surface that lets light through. `Some(true)`: it enters a solid, `Some(false)`: it
    /// leaves it; `None`: it is no solid.
    fn refraction(&mut self, _refraction: &Refraction<R>, _solid: Option<bool>) {}
    /// A ray was not sent, as with all that it could bring, its weight included, it stays within the
    /// tolerance.
    fn left_out(&mut self, _kind: Kind, _at_most: f64) {}
    /// What the ray sees, before it is multiplied by its coefficient.
    fn ends(&mut self, _e: Rgb) {}
}

/// Nobody.
impl<R: Real> Witness<R> for Uncounted {}

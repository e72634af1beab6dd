//! Refraction (CSC418 11.7.3).
//!
//! Snell's law is sin θ1 / sin θ2 = c1 / c2, the speeds of light on the two sides. An index of refraction n is how many
//! times slower than in air light is in a medium, so that c1 / c2 = n2 / n1 and sin θ2 = (n1 / n2) sin θ1.
//!
//! "The outgoing direction is in the plane of the incoming direction and n⃗." So split d⃗ into what goes along the surface
//! and what goes along n⃗: the first has the length sin θ1 and becomes n1/n2 times as long, and the second is whatever
//! makes the whole a unit vector again.

use math::{Real, Vector, portable};

/// Refraction, with what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction<R: Real> {
    /// The index of refraction on the side from where the ray comes.
    pub n1: f64,
    /// And on the side to where it goes.
    pub n2: f64,
    /// cos θ1 = −d⃗·n⃗
    pub cos_theta1: R,
    /// d⃗ + cos θ1 n⃗: what of d⃗ goes along the surface.
    pub tangent: R::Vec3,
    /// sin² θ2 = (n1/n2)² sin² θ1: above 1 there is no θ2.
    pub sin2_theta2: R,
    /// t⃗, a unit vector; `None` for total internal reflection.
    pub t: Option<R::Vec3>,
}

/// The refracted direction of the unit vector `d` at a surface whose unit normal `n` is turned toward where the ray comes
/// from, from the index `n1` to the index `n2`, both above 0.
///
/// Where the indices are the same nothing is bent, to the last bit.
#[inline(always)]
pub fn refract<R: Real>(d: R::Vec3, n: R::Vec3, n1: f64, n2: f64) -> Refraction<R> {
    // exercise theta1: d⃗ comes down on the surface and n⃗ points up: what is the cosine of the angle between them?
    let cos_theta1: R = -d.dot(n);
    // end theta1
    // exercise tangent: What is left of d⃗ without its part along n⃗?
    let tangent: R::Vec3 = d + n * cos_theta1;
    // end tangent
    // exercise snell: By what factor does a sine change from one side to the other, and what is sin² θ2 then?
    let eta: R = R::round_from(n1 / n2);
    let sin2_theta2: R = eta * eta * tangent.dot(tangent);
    // end snell
    let one = R::from(1.0);
    // exercise t: Which unit vector is t⃗ made of, along the surface and along n⃗, and when is there none?
    // straight on, or with nothing to bend it
    let t: Option<R::Vec3> = if n1 == n2 || tangent.is_zero() {
        Some(d)
    } else if sin2_theta2 <= one {
        let cos_theta2 = (one - sin2_theta2).sqrt();
        Some((tangent * eta - n * cos_theta2).unit())
    } else {
        None
    };
    // end t
    Refraction { n1, n2, cos_theta1, tangent, sin2_theta2, t }
}

impl<R: Real> Refraction<R> {
    /// θ1 in degrees, from its sine and cosine, which is good at both ends.
    pub fn theta1(&self) -> f64 {
        degrees(self.tangent.length().into(), self.cos_theta1.into())
    }

    /// θ2 in degrees; `None` for total internal reflection.
    pub fn theta2(&self) -> Option<f64> {
        // of a ray that grazes and is not bent it may come out a little above 1
        let sin2 = Into::<f64>::into(self.sin2_theta2).min(1.0);
        self.t.map(|_| degrees(sin2.sqrt(), (1.0 - sin2).sqrt()))
    }
}

fn degrees(sin: f64, cos: f64) -> f64 {
    portable::atan2(sin, cos).to_degrees()
}

/// The critical angle θ_c in degrees, at which θ2 is 90°: sin θ_c = n2 / n1, both above 0. Beyond it nothing
/// enters the other medium. `None` where n2 ≥ n1: into the slower medium light always finds a way.
pub fn critical_angle(n1: f64, n2: f64) -> Option<f64> {
    let sin = n2 / n1;
    // tan θ_c = sin / cos, with cos² = (1 − sin)(1 + sin)
    (n2 < n1).then(|| degrees(sin, ((1.0 - sin) * (1.0 + sin)).sqrt()))
}

#[cfg(test)]
mod tests;

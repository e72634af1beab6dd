//! The deformed plane z″ = 0, and the triangle in it: (0, 0), (s, 0), (0, s).

use std::cmp::Ordering::{Equal, Less};

use math::Sure;
use quadric::Part;
use quadric::robust::{Place, Verdict};

use super::line::Line;
use crate::Object;

/// The plane z = 0 is that of the cone's base.
const FLAT: Place = Place { part: Part::Base, plane: Some(Part::Base) };

/// What the ray meets, by signs alone; `None` in doubt. Along the plane, even within it, it misses.
///
/// z″ = 0 is met at λ = −o″_z / d″_z. There p × d″ = w says that α = p_x = −w_y / d″_z and β = p_y = w_x / d″_z: two of
/// chapter 05's edge volumes over their sum.
#[inline(always)]
pub(super) fn verdict<N: Sure>(line: &Line<N>, object: Object) -> Option<Verdict> {
    let ([_, _, height], [_, _, slope]) = (&line.o, &line.d);
    let (above, rises) = (height.sign()?, slope.sign()?);
    if rises == Equal || above == rises {
        return Some(Verdict::Misses);
    }
    if object == Object::Triangle {
        // α, β and 1 − α − β, times |d″_z|
        let turned = |x: &N| if rises == Less { -x.clone() } else { x.clone() };
        let (alpha, beta) = (-turned(&line.w[1]), turned(&line.w[0]));
        let rest = turned(slope) - (alpha.clone() + beta.clone());
        for weight in [alpha, beta, rest] {
            if weight.sign()? == Less {
                return Some(Verdict::Misses);
            }
        }
    }
    Some(if above == Equal { Verdict::Starts(Part::Base) } else { Verdict::Enters(FLAT) })
}

//! The deformed plane z″ = 0, and the triangle in it: (0, 0), (s, 0), (0, s).

use std::cmp::Ordering;

use math::{Ray3, Real, Sure, Wide};

use super::stored::{self, Line, Scaled};
use super::{Certainty, Crossing, Steps};
use crate::{Deformed, Object};

/// The first crossing at λ ≥ 0. The ray must not be degenerate.
#[inline(always)]
pub(super) fn first<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> (Steps, Option<Crossing<R>>) {
    if let Some(answer) = certain(ray, deformed, &deformed.stored.near, Certainty::AtOnce) {
        return answer;
    }
    slowly(ray, deformed)
}

#[cold]
#[inline(never)]
fn slowly<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> (Steps, Option<Crossing<R>>) {
    certain(ray, deformed, &deformed.stored.fine, Certainty::TwoPart)
        .or_else(|| certain(ray, deformed, &stored::exactly(&deformed.affine), Certainty::Exact))
        .unwrap_or((Steps::NONE, None))
}

/// z″ = 0 is met at λ = −o″_z / d″_z. There x″ d″_z = o″_x d″_z − o″_z d″_x = −det A w_y, and y″ d″_z = det A w_x:
/// so α = −w_y / d_z and β = w_x / d_z, where d = adj A d.
#[inline(always)]
fn certain<N: Sure, R: Real>(
    ray: &Ray3<R>,
    deformed: &Deformed<R>,
    scaled: &Scaled<N>,
    certainty: Certainty,
) -> Option<(Steps, Option<Crossing<R>>)> {
    let line = Line::of(ray, deformed, &scaled.adjugate);
    let about = |v: &[N; 3]| [v[0].about(), v[1].about(), v[2].about()];
    let steps = Steps {
        certainty,
        o: about(&line.o),
        d: about(&line.d),
        s: scaled.s.about(),
        w: about(&line.w),
        quadratic: None,
    };
    let (height, slope) = (&line.o[2], &line.d[2]);
    let (height_sign, slope_sign) = (height.sign()?, slope.sign()?);
    if slope_sign == Ordering::Equal || height_sign == slope_sign {
        return Some((steps, None));
    }

    // α and β times |d_z|, with the sign of d″_z and that of det A
    let turns = (slope_sign == Ordering::Less) != deformed.stored.mirrors;
    let turned = |x: &N| if turns { -x.clone() } else { x.clone() };
    let (alpha, beta) = (-turned(&line.w[1]), turned(&line.w[0]));
    if deformed.object == Object::Triangle {
        let size = if slope_sign == Ordering::Less { -slope.clone() } else { slope.clone() };
        let rest = size - (alpha.clone() + beta.clone());
        for weight in [&alpha, &beta, &rest] {
            if weight.sign()? == Ordering::Less {
                return Some((steps, None));
            }
        }
    }
    let lambda: R = N::quotient(&-height.clone(), slope)?;
    let lambda = lambda + R::from(0.0); // minus zero is zero
    let slope_size = slope.about().abs();
    let p = [alpha.about() / slope_size, beta.about() / slope_size, 0.0];
    let a_inverse_transposed_n = if certainty == Certainty::Exact {
        let columns = deformed.affine.a.columns.map(Wide::vector::<R, 3>);
        let cross = [(1, 2), (2, 0), (0, 1)]
            .map(|(i, j)| columns[0][i] * columns[1][j] - columns[0][j] * columns[1][i]);
        super::sphere::within_range(if deformed.stored.mirrors { cross.map(|x| -x) } else { cross })
    } else {
        deformed.stored.near.adjugate[2].map(|x| x.value)
    };
    let crossing = Crossing { lambda, p, n: [0.0, 0.0, 1.0], a_inverse_transposed_n, enters: false };
    Some((steps, Some(crossing)))
}

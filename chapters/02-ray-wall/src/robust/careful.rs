//! The slow way of [`robust`](super): for numbers near the ends of their range, and for a ray with no t.

use math::{Degenerate, Hit, Ray2, Real, Roots, Span, Vector, Wide};

use crate::{Hit2, Wall};

/// t_front and t_back before they are rounded; `None` for a degenerate ray or wall, and where u_x = 0.
#[cold]
#[inline(never)]
pub(super) fn faces<R: Real>(ray: &Ray2<R>, wall: &Wall<R>) -> Option<[Wide; 2]> {
    if wall.check(ray).is_err() || ray.direction.x() == R::from(0.0) {
        return None;
    }
    let (p_x, u_x) = (Wide::of(ray.origin.x()), Wide::of(ray.direction.x()));
    Some([wall.front, wall.back].map(|face| (Wide::of(face) - p_x) / u_x))
}

/// The nearest hit in `span`: t and y = p_y + t u_y with twice the digits, rounded at the end.
#[cold]
#[inline(never)]
pub(super) fn hit<R: Real>(
    ray: &Ray2<R>,
    wall: &Wall<R>,
    span: Span<R>,
) -> Result<Option<Hit2<R>>, Degenerate> {
    wall.check(ray)?;
    let Some([front, back]) = faces(ray, wall) else { return Ok(None) };
    let roots = Roots::sorted(front.rounded(), back.rounded());
    let Some(t) = roots.first_within(span) else { return Ok(None) };
    let leaves = !span.contains(roots.near);
    let by_the_front = (ray.direction.x() > R::from(0.0)) != leaves;
    let (face, wide_t) = if by_the_front { (wall.front, front) } else { (wall.back, back) };
    let y = Wide::of(ray.origin.y()) + wide_t * Wide::of(ray.direction.y());
    let point = R::vec2(face, R::round_from(y.to_f64()));
    Ok(Some(Hit { t, point, normal: wall.normal(ray, leaves) }))
}

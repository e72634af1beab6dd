//! By hand, in whole numbers.

use math::wide::scaled;
use math::{Degenerate, Ray3, Span};

use super::{End, OpenCone, Verdict, notes, robust};
use crate::Hit3;

type V = <f64 as math::Real>::Vec3;

const TOP: V = V::Z;

/// A wall around a line parallel to z, from (1, 2, 1) up.
fn cone(base_radius: f64, height: f64, apex_radius: f64) -> OpenCone<f64> {
    OpenCone::new(V::new(1.0, 2.0, 1.0), base_radius, V::new(1.0, 2.0, 1.0 + height), apex_radius)
}

/// A ray of the plane y = 2, in which the axis of [`cone`] is, x counted from the axis.
fn ray(x: f64, z: f64, d_x: f64, d_z: f64) -> Ray3<f64> {
    Ray3::new(V::new(1.0 + x, 2.0, z), V::new(d_x, 0.0, d_z))
}

/// What both methods say, which must be the same.
fn hit(cone: &OpenCone<f64>, ray: &Ray3<f64>, span: Span<f64>) -> Option<Hit3<f64>> {
    let hits = [notes(ray, cone).hit(span), robust(ray, cone).hit(span)].map(Result::unwrap);
    assert_eq!(hits[0], hits[1], "{ray:?} {cone:?}");
    hits[1]
}

/// t and normal of both, ahead.
fn ahead(cone: &OpenCone<f64>, ray: Ray3<f64>) -> Option<(f64, V)> {
    hit(cone, &ray, Span::ahead()).map(|hit| (hit.t, hit.normal))
}

/// t and normal of robust alone, where the notes' method has another answer or none.
fn robustly(cone: &OpenCone<f64>, ray: Ray3<f64>) -> Option<(f64, V)> {
    robust(&ray, cone).hit(Span::ahead()).unwrap().map(|hit| (hit.t, hit.normal))
}

#[test]
fn through_the_wall_and_seen_from_both_sides() {
    // by hand: radius 2 from z = 1 to z = 5
    let pipe = cone(2.0, 4.0, 2.0);
    assert_eq!(ahead(&pipe, ray(-6.0, 3.0, 2.0, 0.0)), Some((2.0, -V::X)), "the near wall, from outside");
    assert_eq!(ahead(&pipe, ray(0.0, 3.0, 2.0, 0.0)), Some((1.0, V::X)), "the far wall, from within");
    assert_eq!(ahead(&pipe, ray(-1.0, 0.0, 1.0, 1.0)), Some((3.0, V::X)), "in by the open end");
    assert_eq!(ahead(&pipe, ray(-1.0, 0.0, 0.25, 1.0)), None, "in by one end and out by the other");
    assert_eq!(ahead(&pipe, ray(0.0, 0.0, 0.0, 1.0)), None, "along the axis");
    assert_eq!(ahead(&pipe, ray(-6.0, 6.0, 2.0, 0.0)), None, "above it");
    assert_eq!(ahead(&pipe, ray(6.0, 3.0, 2.0, 0.0)), None, "behind");
    assert_eq!(ahead(&pipe, ray(2.0, 3.0, -1.0, 0.0)), Some((0.0, V::X)), "from the wall inward");
    assert_eq!(ahead(&pipe, ray(2.0, 3.0, 1.0, 0.0)), Some((0.0, V::X)), "and outward");
}

#[test]
fn a_tip_a_funnel_and_a_lampshade() {
    // by hand: radius 3 at z = 1, nothing at z = 5: 3 − ¾ (z − 1), and the normal is (4, 3) / 5
    let (tip, funnel) = (cone(3.0, 4.0, 0.0), cone(0.0, 4.0, 3.0));
    let across = ahead(&tip, ray(-8.0, 3.0, 0.5, 0.0)).unwrap();
    assert_eq!(across.0, 13.0);
    assert!((across.1 - V::new(-0.8, 0.0, 0.6)).length() < 1e-15, "{across:?}");
    let across = ahead(&funnel, ray(-8.0, 3.0, 0.5, 0.0)).unwrap();
    assert!((across.1 - V::new(-0.8, 0.0, -0.6)).length() < 1e-15, "{across:?}");
    assert_eq!(ahead(&tip, ray(-8.0, 6.0, 0.5, 0.0)), None, "the other nappe");
    assert_eq!(ahead(&tip, ray(0.0, 0.0, 0.0, 1.0)), Some((5.0, TOP)), "the tip, along the axis");
    assert_eq!(ahead(&funnel, ray(0.0, 0.0, 0.0, 1.0)), Some((1.0, -TOP)), "the tip, from without");
    assert_eq!(ahead(&tip, ray(-3.0, 5.0, 1.0, 0.0)), Some((3.0, TOP)), "the tip, flat");
    // by hand: radius 3 at z = 1, 1 at z = 5; at z = 3 it is 2
    let shade = cone(3.0, 4.0, 1.0);
    assert_eq!(ahead(&shade, ray(-4.0, 3.0, 1.0, 0.0)).map(|(t, _)| t), Some(2.0));
    assert_eq!(ahead(&shade, ray(0.0, 0.0, 0.0, 1.0)), None, "along the axis");
    assert_eq!(
        ahead(&shade, ray(2.0, 0.0, 0.0, 1.0)).map(|(t, _)| t),
        Some(3.0),
        "from below, the inner side"
    );
    assert_eq!(
        ahead(&shade, ray(2.0, 9.0, 0.0, -1.0)).map(|(t, _)| t),
        Some(6.0),
        "from above, the outer side"
    );
}

#[test]
fn along_a_straight_line_of_the_wall() {
    // by hand: x = 3 − ½ (z − 1) from z = 1 to z = 5
    for (cone, d_x) in [(cone(2.0, 4.0, 2.0), 0.0), (cone(3.0, 4.0, 1.0), -1.0), (cone(2.0, 4.0, 0.0), -1.0)]
    {
        let x = cone.base_radius;
        let t = |z: f64, way: f64| {
            let ray = ray(x + d_x * (z - 1.0) / 2.0, z, way * d_x, way * 2.0);
            assert_eq!(notes(&ray, &cone).hit(Span::ahead()), Ok(None), "A = B = 0");
            robustly(&cone, ray).map(|(t, _)| t)
        };
        assert_eq!(t(-5.0, 1.0), Some(3.0), "from below, at the base");
        assert_eq!(t(9.0, -1.0), Some(2.0), "from above, at the apex");
        for z in [1.0, 3.0, 5.0] {
            assert_eq!([t(z, 1.0), t(z, -1.0)], [Some(0.0); 2], "within, or at an end");
        }
        assert_eq!([t(-5.0, -1.0), t(9.0, 1.0)], [None; 2], "behind");
    }
}

#[test]
fn the_edges_belong_to_the_wall() {
    let pipe = cone(2.0, 4.0, 2.0);
    // by hand: the edge of the base is at x = 2, z = 1, that of the apex at z = 5
    for (z, way, end) in [(1.0, 1.0, End::Base), (5.0, -1.0, End::Apex)] {
        assert_eq!(
            ahead(&pipe, ray(4.0, z - 2.0 * way, -1.0, way)),
            Some((2.0, V::X)),
            "{end:?}, from outside"
        );
        assert_eq!(
            ahead(&pipe, ray(0.0, z + 2.0 * way, 1.0, -way)),
            Some((2.0, V::X)),
            "{end:?}, from inside"
        );
        assert_eq!(ahead(&pipe, ray(0.0, z, 1.0, 0.0)), Some((2.0, V::X)), "{end:?}, in its plane");
        let starts = |x: f64, z: f64| robust(&ray(x, z, -1.0, way), &pipe).verdict;
        assert_eq!(starts(2.0, z), Verdict::Starts(Some(end)));
        assert_eq!(starts(2.0, 3.0), Verdict::Starts(None), "between the edges");
        let off = |x: f64, z_off: f64| robust(&ray(x, z - 2.0 * way, -1.0, way * z_off), &pipe).verdict;
        assert_eq!(off(4.0, 1.0), Verdict::Edge(end));
        assert_eq!(off(4.0 + 4.0 * f64::EPSILON, 1.0), Verdict::Outer, "a digit farther in");
        // A digit nearer it comes in through the open end, and goes on to the other side.
        assert_eq!(off(4.0 - 4.0 * f64::EPSILON, 1.0), Verdict::Inner);
        let past = z - way * f64::EPSILON * 4.0;
        assert_eq!(ahead(&pipe, ray(-4.0, past, 1.0, 0.0)), None, "{end:?}, a digit beyond it");
    }
}

#[test]
fn grazing_counts() {
    let pipe = cone(2.0, 4.0, 2.0);
    let along_y = |x: f64, z: f64| Ray3::new(V::new(x, -3.0, z), V::Y);
    assert_eq!(ahead(&pipe, along_y(3.0, 3.0)), Some((5.0, V::X)), "a tangent");
    assert_eq!(ahead(&pipe, along_y(3.0, 1.0)), Some((5.0, V::X)), "a tangent of an edge");
    assert_eq!(robustly(&pipe, along_y(3.0_f64.next_up(), 3.0)), None);
    assert!(robustly(&pipe, along_y(3.0_f64.next_down(), 3.0)).is_some_and(|(t, _)| t < 5.0));
}

/// The axis is a difference of numbers as given: rounded it would be (1, 0, 1) here, and end 2^−60 sooner.
#[test]
fn the_axis_is_not_rounded() {
    let leaning = OpenCone::new(V::new(-(2.0_f64.powi(-60)), 0.0, -1.0), 1.0, V::X, 1.0);
    assert_eq!(leaning.apex - leaning.base, V::new(1.0, 0.0, 1.0));
    // by hand: the plane y = 1 touches the wall in a line that ends at (1, 1, 0), above the middle of the apex
    let up = |x: f64| robust(&Ray3::new(V::new(x, 1.0, -3.0), V::Z), &leaning);
    assert_eq!((up(1.0).verdict, up(1.0).t), (Verdict::Edge(End::Apex), Some(3.0)));
    assert_eq!(up(1.0_f64.next_up()).verdict, Verdict::Misses);
    assert_eq!(up(1.0_f64.next_down()).verdict, Verdict::Outer);
}

#[test]
fn a_span_is_entered_exactly() {
    // by hand: the wall is met at t = 2 and t = 4
    let (pipe, through) = (cone(2.0, 4.0, 2.0), ray(-6.0, 3.0, 2.0, 0.0));
    let from = |min: f64| hit(&pipe, &through, Span::new(min, f64::INFINITY)).map(|hit| hit.t);
    for (min, t) in [(1.0, 2.0), (2.0, 2.0), (2.0_f64.next_up(), 4.0), (3.0, 4.0), (4.0, 4.0)] {
        assert_eq!(from(min), Some(t), "from {min}");
    }
    assert_eq!([from(4.0_f64.next_up()), from(f64::INFINITY), from(f64::NAN)], [None; 3]);
    assert_eq!(hit(&pipe, &through, Span::new(0.0, 2.0_f64.next_down())), None);
    assert_eq!(hit(&pipe, &through, Span::new(0.0, 2.0)).map(|hit| hit.t), Some(2.0));
    // in the wall from t = 2 to t = 4
    let along = robust(&ray(2.0, -3.0, 0.0, 2.0), &pipe);
    let from = |min: f64| along.hit(Span::new(min, f64::INFINITY)).unwrap().map(|hit| hit.t);
    assert_eq!([from(2.5), from(4.0), from(4.0_f64.next_up())], [Some(2.5), Some(4.0), None]);
}

#[test]
fn the_first_reason_counts() {
    let reason = |x: f64, d: f64, radii: [f64; 2], height: f64| {
        let (ray, cone) = (ray(x, 0.0, d, -0.0), cone(radii[0], height, radii[1]));
        let reasons = [notes(&ray, &cone).hit(Span::ahead()), robust(&ray, &cone).hit(Span::ahead())];
        assert_eq!(reasons[0], reasons[1]);
        reasons[0].unwrap_err()
    };
    assert_eq!(reason(0.0, 0.0, [1.0, f64::NAN], 1.0), Degenerate::NotFinite);
    assert_eq!(reason(f64::INFINITY, 0.0, [1.0, 1.0], 1.0), Degenerate::NotFinite);
    assert_eq!(reason(0.0, 0.0, [-1.0, 1.0], 0.0), Degenerate::ZeroDirection);
    for radii in [[-1.0, 1.0], [1.0, -5e-324], [0.0, -0.0]] {
        assert_eq!(reason(0.0, 1.0, radii, 0.0), Degenerate::RadiusNotPositive);
    }
    assert_eq!(reason(0.0, 1.0, [0.0, 1.0], 0.0), Degenerate::NoHeight);
}

#[test]
fn far_beyond_the_largest_number() {
    // by hand: x = −2 is 4 away, 4 · 2^1070 directions
    let pipe = OpenCone::new(V::ZERO, 2.0, V::Z, 2.0);
    let far = Ray3::new(V::new(-6.0, 0.0, 0.5), V::X * scaled(1.0, -1070));
    let hit = robust(&far, &pipe).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (f64::INFINITY, V::new(-2.0, 0.0, 0.5), -V::X));
    // by hand: measures whose squares are no numbers, huge and tiny; the slope is 1
    for size in [1000, -1000, 1021, -1070].map(|power| scaled(1.0, power)) {
        let cone = OpenCone::new(V::Z * -size, 2.0 * size, V::Z * size, 0.0);
        let across = Ray3::new(V::X * -3.0 * size, V::X * size);
        let hit = robust(&across, &cone).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point), (2.0, -V::X * size));
        assert!((hit.normal - V::new(-1.0, 0.0, 1.0) / 2.0_f64.sqrt()).length() < 1e-15, "{hit:?}");
        assert!(hit.normal.is_finite());
    }
}

/// By hand: 49 · (1/49) as rounded is 1 − 2⁻⁵³, which leads not quite to the tip.
#[test]
fn a_tip_is_met_though_t_leads_beside_it() {
    let tip = OpenCone::new(V::ZERO, 1.0, V::Z, 0.0);
    let aslant = Ray3::new(V::new(-1.0, 0.0, 2.0), V::new(49.0, 0.0, -49.0));
    let work = robust(&aslant, &tip);
    let hit = work.hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((work.verdict, hit.t), (Verdict::Edge(End::Apex), 1.0 / 49.0));
    assert_eq!((hit.point, hit.normal), (V::new(-f64::EPSILON / 2.0, 0.0, 1.0), V::Z));
}

#[test]
fn the_end_of_a_verdict() {
    let ends = [Verdict::Starts(Some(End::Apex)), Verdict::Edge(End::Base), Verdict::Starts(None)];
    assert_eq!(ends.map(Verdict::end), [Some(End::Apex), Some(End::Base), None]);
    assert_eq!([Verdict::Misses, Verdict::Outer, Verdict::Inner].map(Verdict::end), [None; 3]);
}

/// By hand: from x = −1 to 3/2, in units of 2^1023, are two directions of 5/4. That sum is a number, twice 5/4 is none.
#[test]
fn where_t_is_a_number_and_t_d_is_none() {
    let unit = scaled(1.0, 1023);
    let pipe = OpenCone::new(V::ZERO, 1.5 * unit, V::Z, 1.5 * unit);
    let ray = Ray3::<f64>::new(V::new(-unit, 0.0, 0.5), V::X * (1.25 * unit));
    assert_eq!(ray.at(2.0).x, f64::INFINITY);
    let hit = robust(&ray, &pipe).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (2.0, V::new(1.5 * unit, 0.0, 0.5), V::X));
}

//! What the rules say of points whose place is known from elsewhere.

use glam::{DVec3, Vec3};

use super::crossing::{Way, relation};
use super::even_odd::{count_naively, is_inside_as_printed};
use super::star::{CONCAVE, PENTAGRAM, in_space};
use super::*;

fn polygon(corners: &[[f32; 2]]) -> Polygon<f64> {
    Polygon::new(in_space::<f64>(corners)).unwrap()
}

fn at(x: f64, y: f64) -> DVec3 {
    DVec3::new(x, y, 0.0)
}

/// Slip 20. By hand: (1, 1) is in the square, (3, 1) beside it, and s(t) from there crosses one side, none.
#[test]
fn as_printed_the_rule_is_upside_down() {
    let square = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    for (u, crossed, is_inside) in [(1.0, 1, true), (3.0, 0, false), (-1.0, 2, false)] {
        let work = even_odd(square.outline(), [u, 1.0]);
        assert_eq!((work.crossings.len(), work.is_inside()), (crossed, is_inside));
        assert_ne!(is_inside_as_printed(&work), is_inside, "as printed: even is inside");
    }
}

/// The test rays of the transcript through corners and along sides.
#[test]
fn a_corner_is_counted_once() {
    let star = polygon(&CONCAVE);
    for (point, crossed, naively, is_inside) in [
        ([0.0, 0.0], 1, 1, true),
        ([0.0, -1.0], 1, 2, true), // through the notch (4, −1): both its sides end there
        ([0.0, 3.0], 1, 2, true),  // through the notch (2, 3), along a side, out at the point (10, 3)
        ([-12.0, 10.0], 0, 2, false), // past the tip (0, 10)
        ([-12.0, -8.0], 4, 4, false), // through both feet
        ([-12.0, -4.0], 2, 4, false), // through the crotch (0, −4), an upper end
        ([-12.0, 3.0], 2, 4, false), // along both level sides
    ] {
        let work = even_odd(star.outline(), point);
        assert_eq!((work.crossings.len(), work.is_inside(), work.on_side), (crossed, is_inside, None));
        assert_eq!(count_naively(star.outline(), point), naively);
        let around = winding(star.outline(), point).number;
        assert_eq!(around, i64::from(is_inside), "counterclockwise");
    }
}

#[test]
fn the_boundary_belongs_to_it() {
    let star = polygon(&CONCAVE);
    let (corners, sides) = (star.corners().to_vec(), star.corners().len());
    for side in 0..sides {
        let (p, q) = (corners[side], corners[(side + 1) % sides]);
        // the corners are whole numbers: halves and quarters between them are exact
        for point in [p, (p + q) / 2.0, (3.0 * p + q) / 4.0] {
            assert!(Rule::ALL.iter().all(|&rule| star.holds(rule, point)), "{point}");
            let hit =
                star.hit(&Ray3::<f64>::new(point + DVec3::Z, -DVec3::Z), Span::ahead()).unwrap().unwrap();
            assert_eq!((hit.t, hit.point, hit.normal), (1.0, point, DVec3::Z));
        }
        assert_eq!(even_odd(star.outline(), star.flat((p + q) / 2.0)).on_side, Some(side));
    }
}

/// Once around each tip, twice around the middle: even-odd calls the middle outside, winding inside.
#[test]
fn the_rules_differ_in_the_middle_of_a_pentagram() {
    let star = polygon(&PENTAGRAM);
    for (point, number, even_odd) in [
        (at(0.0, 0.0), 2, false),
        (at(0.0, 8.0), 1, true),
        (at(-8.0, 2.5), 1, true),
        (at(0.0, -7.0), 0, false),
    ] {
        assert_eq!(winding(star.outline(), star.flat(point)).number, number);
        assert_eq!(star.holds(Rule::Winding, point), number != 0);
        assert_eq!(star.holds(Rule::EvenOdd, point), even_odd);
    }
    let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.0, 5.0), DVec3::new(0.0, 0.0, -2.0));
    assert_eq!(star.hit(&ray, Span::ahead()), Ok(None), "through the middle");
    let by_winding = star.hit_by(ray_plane::Method::Notes, Rule::Winding, &ray, Span::ahead());
    assert_eq!(by_winding.unwrap().unwrap().t, 2.5);
}

/// Two squares that touch at a corner, as one polygon through that corner twice.
#[test]
fn a_polygon_may_touch_itself() {
    let corners =
        [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0], [2.0, 2.0], [0.0, 2.0]];
    let touching = polygon(&corners);
    for rule in Rule::ALL {
        for (x, y, inside) in
            [(1.0, 1.0, true), (3.0, 3.0, true), (2.0, 2.0, true), (1.0, 3.0, false), (3.0, 1.0, false)]
        {
            assert_eq!(touching.holds(rule, at(x, y)), inside, "{x} {y}");
        }
    }
}

/// The turns around a point, by angles: for points not on the boundary.
fn turns_by_angles(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> i64 {
    let count = outline.len();
    let angle = |i: usize| {
        let ([px, py], [qx, qy]) = (outline[i], outline[(i + 1) % count]);
        let ([px, py], [qx, qy]) = ([px - x, py - y], [qx - x, qy - y]);
        (px * qy - py * qx).atan2(px * qx + py * qy)
    };
    let total: f64 = (0..count).map(angle).sum();
    (total / std::f64::consts::TAU).round() as i64
}

/// In whole numbers: whether a point is on a side.
fn is_on_boundary(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let count = outline.len();
    (0..count).any(|i| {
        let ([px, py], [qx, qy]) = (outline[i], outline[(i + 1) % count]);
        let on_line = (qx - px) * (y - py) == (qy - py) * (x - px);
        on_line && (px.min(qx)..=px.max(qx)).contains(&x) && (py.min(qy)..=py.max(qy)).contains(&y)
    })
}

/// Polygons of whole corners from a small grid, most of them overlapping themselves, every point of the grid and
/// around it against the angles: corners and sides are on the test ray all the time.
#[test]
fn on_a_grid_every_verdict_is_that_of_the_angles() {
    let mut state = 5_u64;
    let mut below = |bound: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) % bound) as f32
    };
    let (mut polygons, mut on_boundary, mut naive_wrong) = (0, 0, 0);
    while polygons < 400 {
        let count = 3 + below(6) as usize;
        let corners: Vec<[f32; 2]> = (0..count).map(|_| [below(6), below(6)]).collect();
        let Ok(polygon) = Polygon::new(in_space::<f64>(&corners)) else { continue };
        polygons += 1;
        for (u, v) in (-1..=6).flat_map(|u| (-1..=6).map(move |v| (f64::from(u), f64::from(v)))) {
            let outline = polygon.outline();
            let (parity, around) = (even_odd(outline, [u, v]), winding(outline, [u, v]));
            assert_eq!(parity.on_side, around.on_side);
            assert_eq!(parity.on_side.is_some(), is_on_boundary(outline, [u, v]), "{outline:?} {u} {v}");
            if parity.on_side.is_some() {
                on_boundary += 1;
                continue;
            }
            let turns = turns_by_angles(outline, [u, v]);
            assert_eq!(around.number, turns, "{outline:?} {u} {v}");
            assert_eq!(parity.is_inside(), turns % 2 != 0, "{outline:?} {u} {v}");
            naive_wrong += u32::from((count_naively(outline, [u, v]) % 2 == 1) != (turns % 2 != 0));
        }
    }
    assert!(on_boundary > 1000, "{on_boundary}");
    assert!(naive_wrong > 1000, "counting corners twice is wrong on a tenth of them: {naive_wrong}");
}

/// The verdict does not depend on which side starts the polygon, nor on the way around.
#[test]
fn turned_over_it_is_the_same_polygon() {
    let ray = Ray3::<f64>::new(DVec3::new(0.0, -1.0, 5.0), DVec3::new(0.0, 0.0, -1.0));
    let mut corners = CONCAVE.to_vec();
    for _ in 0..corners.len() {
        corners.rotate_left(1);
        let there = polygon(&corners).hit(&ray, Span::ahead()).unwrap().unwrap();
        let reversed: Vec<[f32; 2]> = corners.iter().rev().copied().collect();
        let back = polygon(&reversed).hit(&ray, Span::ahead()).unwrap().unwrap();
        assert_eq!((there.t, there.normal), (5.0, DVec3::Z));
        assert_eq!((back.t, back.normal), (5.0, -DVec3::Z), "Newell's normal turns with the corners");
    }
}

#[test]
fn the_widest_view_is_taken() {
    // the square seen along x, y and z; its corners turn counterclockwise on the axes that are left
    for axis in 0..3 {
        for flipped in [false, true] {
            let mut square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
            if flipped {
                square.reverse();
            }
            let corner = |[u, v]: [f64; 2]| {
                let mut corner = [7.0; 3];
                (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (u, v);
                DVec3::from(corner)
            };
            let polygon = Polygon::<f64>::new(square.map(corner).to_vec()).unwrap();
            assert!(!polygon.axes().contains(&axis));
            assert_eq!(winding(polygon.outline(), [1.0, 1.0]).number, 1);
            let [p, q] = [polygon.outline()[0], polygon.outline()[1]];
            assert!(matches!(
                relation(p, q, [1.0, 1.0]),
                super::crossing::Relation::Apart | super::crossing::Relation::Crosses(Way::Up)
            ));
        }
    }
}

#[test]
fn parallel_rays_and_rays_that_are_none() {
    let star = polygon(&CONCAVE);
    let ray = |origin, direction| Ray3::<f64>::new(origin, direction);
    let (within, apart) = (ray(DVec3::ZERO, DVec3::X), ray(DVec3::Z, DVec3::X));
    assert_eq!(star.parallel(&within), Some(Parallel::Within));
    assert_eq!(star.parallel(&apart), Some(Parallel::Apart));
    for parallel in [within, apart] {
        assert_eq!(star.hit(&parallel, Span::ahead()), Ok(None));
    }
    let behind = ray(DVec3::Z, DVec3::Z);
    assert_eq!((star.parallel(&behind), star.hit(&behind, Span::ahead())), (None, Ok(None)));
    assert_eq!(star.hit(&ray(DVec3::Z, DVec3::ZERO), Span::ahead()), Err(Degenerate::ZeroDirection));
    assert_eq!(star.hit(&ray(DVec3::NAN, DVec3::Z), Span::ahead()), Err(Degenerate::NotFinite));
    // t = 1e300 / 1e−300 is a hit at infinity, and no point of the star
    let beyond = ray(DVec3::new(0.0, 0.0, 1e300), DVec3::new(1.0, 0.0, -1e-300));
    assert_eq!(star.hit(&beyond, Span::ahead()), Ok(None));
}

#[test]
fn what_is_no_polygon_is_refused_by_its_corner() {
    let new =
        |corners: &[[f64; 3]]| Polygon::<f64>::new(corners.iter().map(|&corner| corner.into()).collect());
    let [o, x, y, xy] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    for (corners, error, says) in [
        (&[o, x][..], NotAPolygon::TooFewCorners { count: 2 }, "not 2"),
        (&[], NotAPolygon::TooFewCorners { count: 0 }, "three corners or more"),
        (&[o, x, [0.0, f64::NAN, 0.0]], NotAPolygon::NotFinite { corner: 3 }, "corner 3"),
        (&[o, [f64::INFINITY, 0.0, 0.0], y], NotAPolygon::NotFinite { corner: 2 }, "corner 2"),
        (&[o, x, x, y], NotAPolygon::Repeated { corner: 3 }, "the same as corner 2"),
        (&[o, x, y, o], NotAPolygon::Repeated { corner: 1 }, "closes by itself"),
        (&[o, x, [-0.0, 0.0, 0.0]], NotAPolygon::Repeated { corner: 1 }, "−0 is 0"),
        (&[o, x, [3.0, 0.0, 0.0], [2.0, 0.0, 0.0]], NotAPolygon::NoArea, "on a line"),
        (&[o, xy, x, y], NotAPolygon::NoArea, "loops cancel"),
    ] {
        assert_eq!(new(corners), Err(error), "{says}");
        if !says.contains('−') {
            assert!(error.to_string().contains(says), "{error}");
        }
    }
    assert!(new(&[o, x, xy, y]).is_ok());
}

#[test]
fn a_ten_thousandth_of_the_extent_is_planar() {
    // by hand: with one corner of the unit square lifted by h, Newell's normal is (0, −h, 1) + (−h, 0, 1). The lifted
    // corner (1, 1, h) is in the plane then, and (1, 0, 0) and (0, 1, 0) are h / √(4 + 2h²) off, half of h.
    for scale in [1.0, 1e-200, 1e150] {
        let lifted = |h: f64| {
            let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, h], [0.0, 1.0, 0.0]];
            Polygon::<f64>::new(corners.map(|corner| scale * DVec3::from(corner)).to_vec())
        };
        assert!(lifted(1.9e-4).is_ok(), "h / 2 = 0.95e−4 off");
        let Err(NotAPolygon::NotPlanar { corner, distance, allowed }) = lifted(2.1e-4) else {
            panic!("{:?}", lifted(2.1e-4))
        };
        assert_eq!(corner, 2);
        assert!((distance / scale - 1.05e-4).abs() < 1e-11 && (allowed / scale - 1e-4).abs() < 1e-18);
    }
    let error = NotAPolygon::NotPlanar { corner: 2, distance: 0.5, allowed: 1e-4 };
    let says = "corner 2 is 5.000e-1 off the plane of the polygon, and 1.000e-4 is allowed: move it there, or split \
                the polygon into triangles";
    assert_eq!(error.to_string(), says);
}

/// By hand: a square at height 1 along each axis; and one that leans, which a ray meets though it leads away
/// from the first corner.
#[test]
fn only_a_level_polygon_is_left_behind_at_once() {
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    for axis in 0..3 {
        let place = |along: f64, [u, v]: [f64; 2]| {
            let mut place = [along; 3];
            (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (u, v);
            DVec3::from(place)
        };
        let level = Polygon::<f64>::new(square.map(|corner| place(1.0, corner)).to_vec()).unwrap();
        let behind = |from: f64, up: f64| {
            level.is_level_behind(&Ray3::<f64>::new(place(from, [1.0, 1.0]), place(up, [0.25, 0.5])))
        };
        let (above, below) = (1.0_f64.next_up(), 1.0_f64.next_down());
        assert_eq!([behind(above, 1.0), behind(below, -1.0)], [true; 2]);
        for (from, up) in [(above, -1.0), (below, 1.0), (1.0, 1.0), (1.0, -1.0), (above, 0.0), (below, 0.0)] {
            assert!(!behind(from, up), "{from} {up}");
        }
        for lean in [[0.25, 0.0], [0.0, 0.25]] {
            let corner = |[u, v]: [f64; 2]| place(1.0 + lean[0] * u + lean[1] * v, [u, v]);
            let leaning = Polygon::<f64>::new(square.map(corner).to_vec()).unwrap();
            let away = Ray3::<f64>::new(place(1.125, [1.0, 1.0]), place(0.25, [0.0, 0.0]));
            assert_eq!(leaning.hit(&away, Span::ahead()).unwrap().map(|hit| hit.t), Some(0.5), "{lean:?}");
        }
    }
}

/// In f32 as in f64; and whatever the numbers are, nothing panics and nothing is NaN.
#[test]
fn any_bits_are_refused_or_answered() {
    let mut state = 9_u64;
    let mut bits = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 32) as u32
    };
    let (mut number, mut polygons) = (move || f32::from_bits(bits() & !(1 << 30)), 0);
    for _ in 0..2000 {
        let mut vector = || Vec3::new(number(), number(), number());
        let [a, b, c, origin, direction] = [vector(), vector(), vector(), vector(), vector()];
        let Ok(polygon) = Polygon::<f32>::new(vec![a, b, c]) else { continue };
        polygons += 1;
        let hit = polygon.hit(&Ray3::<f32>::new(origin, direction), Span::ahead());
        if let Ok(Some(hit)) = hit {
            assert!(hit.t >= 0.0 && hit.point.is_finite() && hit.normal.is_finite());
        }
    }
    assert!(polygons > 1000, "{polygons}");
}

#[test]
fn the_names_of_the_rules() {
    assert_eq!(Rule::ALL.map(Rule::name), ["even-odd", "winding"]);
}

/// By hand: n = (1, 1, 1) is as long along each axis, and (0, 2, 2) along the last two.
#[test]
fn of_axes_as_wide_the_first_is_dropped() {
    let axes =
        |corners: [[f64; 3]; 3]| Polygon::<f64>::new(corners.map(DVec3::from).to_vec()).unwrap().axes();
    assert_eq!(axes([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), [1, 2]);
    assert_eq!(axes([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, -1.0]]), [2, 0]);
}

/// By hand: the square is 1 behind the origin of a ray through its middle, and 1 ahead of the other.
#[test]
fn what_is_behind_is_missed_at_a_glance() {
    let square = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    let at_a_glance =
        |u: f64, up: f64| square.glance(&Ray3::<f64>::new(DVec3::new(u, 1.0, 1.0), DVec3::Z * up));
    assert_eq!([at_a_glance(1.0, 1.0), at_a_glance(3.0, -1.0)], [Glance::Misses; 2]);
    assert!(matches!(at_a_glance(1.0, -1.0), Glance::Once(around) if around.t == 1.0));
}

/// By hand: from a point of the left side the other one is 2 ahead, and its own is not ahead.
#[test]
fn the_side_of_the_point_is_not_counted_naively() {
    let square = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    assert_eq!([-1.0, 0.0, 2.0].map(|u| count_naively(square.outline(), [u, 1.0])), [2, 1, 0]);
}

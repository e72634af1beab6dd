use std::cmp::Ordering;

use super::*;
use crate::Draw;
use crate::oracle::testing::{exactly, floats, for_drawn};
use crate::oracle::vector::cross;
use crate::oracle::{UnitObject, affine};

/// t in the plane y = 0 and a wall around the z axis from (0, 0, 1); empty for a miss.
fn t([x, z, d_x, d_z]: [f64; 4], radii: [f64; 2], height: f64) -> Vec<f64> {
    let case = [x, 0.0, z, d_x, 0.0, d_z, 0.0, 0.0, 1.0, radii[0], 0.0, 0.0, 1.0 + height, radii[1]];
    floats(&open_cone(case, 0.0, Precision::F64))
}

#[test]
fn closed_forms() {
    // by hand: a pipe of radius 2 from z = 1 to z = 5
    let pipe = |ray| t(ray, [2.0, 2.0], 4.0);
    assert_eq!(pipe([-6.0, 3.0, 2.0, 0.0]), [2.0], "through the wall");
    assert_eq!(pipe([0.0, 3.0, 2.0, 0.0]), [1.0], "from within");
    assert_eq!(pipe([-1.0, 0.0, 1.0, 1.0]), [3.0], "in by the open end, and the far wall from within");
    assert_eq!(pipe([-1.0, 0.0, 0.25, 1.0]), [0.0; 0], "in by one end and out by the other");
    assert_eq!(pipe([0.0, 0.0, 0.0, 1.0]), [0.0; 0], "along the axis");
    assert_eq!(pipe([2.0, -3.0, 0.0, 2.0]), [2.0], "along the wall");
    assert_eq!(pipe([2.0, 3.0, 0.0, 2.0]), [0.0], "within the wall");
    assert_eq!(pipe([2.0, 6.0, 0.0, 2.0]), [0.0; 0], "beyond it");
    assert_eq!(pipe([4.0, -1.0, -1.0, 1.0]), [2.0], "the edge of the base, from outside");
    assert_eq!(pipe([4.0_f64.next_up(), -1.0, -1.0, 1.0]), [4.0_f64.next_up() - 2.0], "a digit above it");
    assert_eq!(pipe([0.0, -1.0, 1.0, 1.0]), [2.0], "the edge of the base, from within");
    assert_eq!(pipe([0.0, 3.0, 1.0, 1.0]), [2.0], "the other edge");
    assert_eq!(pipe([0.0, 3.0_f64.next_up(), 1.0, 1.0]), [0.0; 0], "a digit beyond it");
    // by hand: 3 at z = 1, nothing at z = 4
    let tip = |ray| t(ray, [3.0, 0.0], 3.0);
    assert_eq!(tip([-8.0, 2.0, 2.0, 0.0]), [3.0], "the radius is 2");
    assert_eq!(tip([0.0, 0.0, 0.0, 2.0]), [2.0], "the tip, from within");
    assert_eq!(tip([-1.0, 4.0, 1.0, 0.0]), [1.0], "the tip, flat");
    assert_eq!(tip([-1.0, 5.0, 1.0, 0.0]), [0.0; 0], "the other nappe does not count");
    assert_eq!(tip([1.0, 2.0, 1.0, -1.0]), [0.0; 0], "parallel to the wall, out by the base");
    assert_eq!(tip([-1.0, 2.0, 1.0, 1.0]), [1.5], "through the wall from within");
    assert_eq!(tip([-1.0, 5.0, 2.0, -2.0]), [0.5], "along the wall, from the tip down");
    assert_eq!(tip([0.0, 2.0, 1.0, 1.0]), [1.0], "and across the other one");
    assert_eq!(tip([-3.0, 1.0, 1.0, 1.0]), [0.0], "along the wall, from the edge");
}

#[test]
fn from_another_t_on() {
    // by hand: the wall is met at t = 2 and t = 4, and a ray in it from t = 2 to t = 4
    let case = |x, d_x, z, d_z| [x, 0.0, z, d_x, 0.0, d_z, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 5.0, 2.0];
    let t = |case, from| floats(&open_cone(case, from, Precision::F64));
    let (through, along) = (case(-6.0, 2.0, 3.0, 0.0), case(2.0, 0.0, -3.0, 2.0));
    for (from, expected) in [(1.0, 2.0), (2.0, 2.0), (2.0_f64.next_up(), 4.0), (4.0, 4.0)] {
        assert_eq!(t(through, from), [expected]);
    }
    assert_eq!([t(along, 1.0), t(along, 3.0), t(along, 4.0)], [[2.0], [3.0], [4.0]]);
    assert_eq!([t(through, 4.0_f64.next_up()), t(along, 4.0_f64.next_up())], [[], [0.0; 0]]);
}

#[test]
fn the_first_reason_counts() {
    let reason = |x, d, radii: [f64; 2], height| {
        let case = [x, 0.0, 0.0, d, -0.0, 0.0, 0.0, 0.0, 1.0, radii[0], 0.0, 0.0, height, radii[1]];
        open_cone(case, 0.0, Precision::F64)
    };
    assert_eq!(reason(1.0, 0.0, [f64::NAN, 1.0], 2.0), Truth::Invalid("not-finite"));
    assert_eq!(reason(1.0, 0.0, [-1.0, 1.0], 1.0), Truth::Invalid("zero-direction"));
    for radii in [[-1.0, 1.0], [1.0, -5e-324], [0.0, -0.0]] {
        assert_eq!(reason(1.0, 1.0, radii, 1.0), Truth::Invalid("radius-not-positive"));
    }
    assert_eq!(reason(1.0, 1.0, [0.0, 1.0], 1.0), Truth::Invalid("no-height"));
}

/// A line beside a wall, by the geometry alone: ‖w × v‖² V = (r_b V + (r_a − r_b) w·v)² with w = o + t d − b.
struct Geometry {
    o: [Dyadic; 3],
    d: [Dyadic; 3],
    base: [Dyadic; 3],
    v: [Dyadic; 3],
    r_b: Dyadic,
    k: Dyadic,
}

impl Geometry {
    fn new(case: &[f64; 14]) -> Geometry {
        let [o, d, base] = vectors(case);
        let apex: [Dyadic; 3] = std::array::from_fn(|axis| Dyadic::of(case[10 + axis]));
        let [r_b, r_a] = [case[9], case[13]].map(Dyadic::of);
        Geometry { v: difference(&apex, &base), o, d, base, k: &r_a - &r_b, r_b }
    }

    /// f, and where t is: below the base, between the ends, or above the apex.
    fn at(&self, t: &Dyadic) -> (Dyadic, Ordering) {
        let w: [Dyadic; 3] =
            std::array::from_fn(|axis| &(&self.o[axis] + &(t * &self.d[axis])) - &self.base[axis]);
        let (turned, height, vv) = (cross(&w, &self.v), dot(&w, &self.v), dot(&self.v, &self.v));
        let radius = &(&self.r_b * &vv) + &(&self.k * &height);
        let f = &(&dot(&turned, &turned) * &vv) - &radius.square();
        let place = match height.sign() {
            Ordering::Less => Ordering::Less,
            _ if (&vv - &height).sign().is_lt() => Ordering::Greater,
            _ => Ordering::Equal,
        };
        (f, place)
    }

    /// The sign of f: below zero within the wall, above it without; `None` beyond an end.
    fn side(&self, t: &Dyadic) -> Option<Ordering> {
        let (f, place) = self.at(t);
        place.is_eq().then(|| f.sign())
    }

    /// The sign of f′, as f has no third power of t.
    fn slope(&self, t: &Dyadic) -> Ordering {
        let one = Dyadic::of(1.0);
        (&self.at(&(t + &one)).0 - &self.at(&(t - &one)).0).sign()
    }
}

#[test]
fn put_back_into_the_ray_every_root_is_on_the_wall() {
    let (mut round, mut hits, mut misses) = (0, 0, 0);
    for_drawn("open-cone", |mut case: [f64; 14], precision| {
        // One of seven: the numbers are long.
        round += 1;
        if round % 7 != 0 {
            return;
        }
        (case[9], case[13]) = (case[9].abs(), case[13].abs());
        if case[0] < 0.0 {
            // Half of them aim at the middle of the base.
            (3..6).for_each(|i| case[i] = case[i + 3] - case[i - 3]);
        }
        let truth = match case.iter().all(|x| x.is_finite()) {
            true => open_cone(case, 0.0, precision),
            false => return,
        };
        let line = Geometry::new(&case);
        let before = match truth {
            Truth::Hit { t, out: None } => {
                hits += 1;
                let t = exactly(t.fine);
                let slack = &t * &Dyadic::scaled(1, -100);
                let [low, high] = [&t - &slack, &t + &slack];
                let changes = line.at(&low).0.sign() != line.at(&high).0.sign();
                let touches = line.slope(&low) != line.slope(&high);
                assert!(line.at(&t).0.is_zero() || changes || touches, "{case:?}");
                // Between the ends, unless it is beyond the same one on both sides.
                let places = [&low, &high].map(|t| line.at(t).1);
                assert!(places[0] != places[1] || places[0].is_eq(), "{case:?}");
                low
            }
            Truth::Miss("") => {
                misses += 1;
                Dyadic::scaled(1, 3000)
            }
            _ => return,
        };
        // On the way there the ray does not change sides between the ends.
        let sides = (0..12).map(|down| &before * &Dyadic::scaled(1, -down * down));
        let sides: Vec<_> = sides.chain([Dyadic::of(0.0)]).filter_map(|t| line.side(&t)).collect();
        let starts_on_it = before.is_zero();
        assert!(starts_on_it || sides.iter().all(|side| *side == sides[0] && side.is_ne()), "{case:?}");
    });
    assert!(hits > 300 && misses > 300, "{hits} hits, {misses} misses");
}

/// Whatever goes through the wall of a closed solid from outside, and not through its caps, does so at the same t.
#[test]
fn a_closed_solid_has_the_same_wall() {
    let mut draw = Draw::new(1, "closed", Precision::F64);
    let (mut walls, mut misses) = (0, 0);
    for round in 0..20_000 {
        let ([x, y, z], length) = draw.whole_frame();
        let whole = |draw: &mut Draw, size: i32| std::array::from_fn(|_| draw.whole(-size, size));
        let (base, o): ([f64; 3], [f64; 3]) = (whole(&mut draw, 9), whole(&mut draw, 99));
        let d: [f64; 3] =
            std::array::from_fn(|axis| base[axis] + z.to_array()[axis] - o[axis] + draw.whole(-40, 40));
        // The unit solid's columns times 2 and the frame: a cone of height 2 ‖z‖, a cylinder of half that height.
        let (object, radius, from) = match round % 2 {
            0 => (UnitObject::Cylinder, [1.0, 1.0], -1.0),
            _ => (UnitObject::Cone, [0.5, 0.0], 0.0),
        };
        let end = |height: f64| (0..3).map(move |axis| base[axis] + 2.0 * height * z.to_array()[axis]);
        let radius = radius.map(|r| 2.0 * r * length);
        let [low, high] = [end(from), end(1.0)].map(|end| end.collect::<Vec<f64>>());
        let open = [&o[..], &d, &low, &[radius[0]], &high, &[radius[1]]].concat();
        let rows = (0..3).flat_map(|axis| [x, y, z].map(|column| 2.0 * column.to_array()[axis]));
        let closed: Vec<f64> = [&o[..], &d].concat().into_iter().chain(rows).chain(base).collect();
        let case = std::array::from_fn(|i| closed[i]);
        if case[3..6] == [0.0; 3] {
            continue;
        }
        let open = std::array::from_fn(|i| open[i]);
        match (affine(object, case, Precision::F64), open_cone(open, 0.0, Precision::F64)) {
            (Truth::Miss(_), got) => {
                misses += 1;
                assert_eq!(got, Truth::Miss(""), "{open:?}");
            }
            (Truth::Hit { t: solid, .. }, got) => {
                let line = Geometry::new(&open);
                let here = line.side(&Dyadic::of(0.0)) != Some(Ordering::Less);
                let [before, after] = [1.0 - 1e-9, 1.0 + 1e-9].map(|part| Dyadic::of(solid.nearest * part));
                // Between the ends on both sides of the root: that was no cap.
                if here && line.at(&before).1.is_eq() && line.at(&after).1.is_eq() {
                    walls += 1;
                    assert_eq!(floats(&got), [solid.nearest], "{open:?}");
                }
            }
            (truth, _) => panic!("{truth:?}"),
        }
    }
    assert!(walls > 1000 && misses > 1000, "{walls} walls, {misses} misses");
}

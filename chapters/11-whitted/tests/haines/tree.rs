//! `tree`: each branch carries two, thinner and shorter, turned this way and that (Aono and Kunii 1984).

use crate::nff::{Nff, Point, View};
use crate::turn::{about_x, about_z, plus, times};

/// 2^(level + 1) − 1 branches, each a cone with a ball at its end: 4095 at level 11, which is Haines's own.
pub(crate) fn tree(level: u32) -> String {
    let lights = [
        [-5.0, 5.0, 50.0],
        [30.0, -30.0, 30.0],
        [-40.0, -30.0, 20.0],
        [10.0, 30.0, 40.0],
        [-30.0, 40.0, 10.0],
        [50.0, 25.0, 20.0],
        [-10.0, -60.0, 30.0],
    ];
    let (from, at) = ([4.5, 0.4, 2.0], [0.0, 0.0, 1.5]);
    let mut nff = Nff::new(&View { from, at, up: [0.0, 0.0, 1.0], hither: 1.0, lights: &lights });
    nff.material([0.2, 0.7, 0.2], [1.0, 0.0, 100_000.0, 0.0, 0.0]);
    nff.polygon(&[[50.0, 50.0, 0.0], [-50.0, 50.0, 0.0], [-50.0, -50.0, 0.0], [50.0, -50.0, 0.0]]);
    nff.material([0.55, 0.4, 0.2], [1.0, 0.0, 100_000.0, 0.0, 0.0]);
    grow(&mut nff, level, &mut Vec::new(), 0.15);
    nff.text()
}

/// The two ways in which a branch leaves another: by which angle it leans, how much shorter it is, and toward
/// where.
const WAYS: [(f64, f64, f64); 2] = [(40.0, 0.65, 90.0), (25.0, 0.70, 230.0)];
/// How thick the end of a branch is against its base.
const THINNER: f64 = 0.67;

/// `ways` lead from the trunk to the branch.
fn grow(nff: &mut Nff, level: u32, ways: &mut Vec<(f64, f64, f64)>, radius: f64) {
    let [base, apex] = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|own| in_the_world(ways, own));
    nff.cone((base, radius), (apex, radius * THINNER));
    nff.sphere(apex, radius * THINNER);
    if level > 0 {
        for way in WAYS {
            ways.push(way);
            grow(nff, level - 1, ways, radius * THINNER);
            ways.pop();
        }
    }
}

/// From the space of a branch, where it is a unit long and points up, to its parent's, and so on to the
/// trunk's.
fn in_the_world(ways: &[(f64, f64, f64)], own: Point) -> Point {
    ways.iter().rev().fold(own, |p, (leans, shorter, toward)| {
        let turned = about_z(toward.to_radians(), about_x(leans.to_radians(), p));
        plus(times(turned, *shorter), [0.0, 0.0, 1.0])
    })
}

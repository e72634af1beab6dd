//! `mount`: a square that is split again and again, its midpoints moved up or down by chance, under four
//! balls of glass.

use std::f64::consts::PI;

use crate::nff::{Nff, Point, View};
use crate::turn::{about, about_z, plus};

/// √2 with as many digits as he gives it: more would be another mountain.
const ROOT_2: f64 = 14_142_136.0 / 1e7;

/// 2 · 4^level triangles: 8192 at level 6, which is Haines's own.
pub(crate) fn mount(level: u32) -> String {
    let lights = [[-100.0, -100.0, 100.0]];
    let view =
        View { from: [-1.6, 1.6, 1.7], at: [0.0; 3], up: [0.0, 0.0, 1.0], hither: 0.01, lights: &lights };
    let mut nff = Nff::new(&view);
    nff.material([1.0, 1.0, 1.0], [0.1, 0.1, 101.148, 0.9, 1.5]);
    glass(&mut nff);
    nff.material([0.5, 0.45, 0.35], [1.0, 0.0, 100_000.0, 0.0, 0.0]);
    // how high the midpoints rise follows from the fractal dimension, 2.2
    let ratio = 2.0 / (2.0_f64.ln() / 1.2).exp();
    let mountain = Mountain { level, roughness: (ratio * ratio - 1.0).sqrt() };
    mountain.grow(&mut nff, 1 << level, (0, 0), [0.0; 4]);
    nff.text()
}

/// Four balls that touch each other.
fn glass(nff: &mut Nff) {
    let (center, radius) = ([-0.8, 0.8, 1.0], 0.17);
    let top = [0.0, 0.0, radius * 1.5_f64.sqrt()];
    let low = about([1.0, 1.0, 0.0], (-1.0_f64 / 3.0).acos(), top);
    nff.sphere(plus(center, top), radius);
    (0..3).for_each(|third| {
        nff.sphere(plus(center, about_z(f64::from(third) * 2.0 * PI / 3.0, low)), radius);
    });
}

struct Mountain {
    level: u32,
    roughness: f64,
}

impl Mountain {
    /// A square with its lower left corner at (x, y) of 2^level places, and the heights of its corners, from
    /// the lower left one around.
    fn grow(&self, nff: &mut Nff, width: u64, (x, y): (u64, u64), [ll, lr, ur, ul]: [f64; 4]) {
        let places = f64::from(1_u32 << self.level);
        if width == 1 {
            let at = |place: u64| -1.0 + place as f64 * 2.0 / places;
            let corner = |x: u64, y: u64, height: f64| -> Point { [at(x), at(y), height] };
            let corners =
                [corner(x, y, ll), corner(x + 1, y, lr), corner(x + 1, y + 1, ur), corner(x, y + 1, ul)];
            for first in [0, 2] {
                nff.polygon(&[0, 1, 2].map(|next| corners[(first + next) % 4]));
            }
            return;
        }
        let half = width / 2;
        let rise = half as f64 * 2.0 / places * self.roughness;
        let by_chance = |x: u64, y: u64| rise * self.chance(x, y);
        let lower = (ll + lr) / 2.0 + by_chance(x + half, y);
        let right = (lr + ur) / 2.0 + by_chance(x + width, y + half);
        let upper = (ur + ul) / 2.0 + by_chance(x + half, y + width);
        let left = (ul + ll) / 2.0 + by_chance(x, y + half);
        let middle = (ll + lr + ur + ul) / 4.0 + ROOT_2 * by_chance(x + half, y + half);
        self.grow(nff, half, (x, y), [ll, lower, middle, left]);
        self.grow(nff, half, (x + half, y), [lower, lr, right, middle]);
        self.grow(nff, half, (x + half, y + half), [middle, right, ur, upper]);
        self.grow(nff, half, (x, y + half), [left, middle, upper, ul]);
    }

    /// A number with a normal distribution, always the same at the same place: Haines's hash of 1987 (said to
    /// repeat itself, and kept, as the counts are those of its mountain) as the seed of Numerical Recipes'
    /// RAN1 and GASDEV.
    fn chance(&self, x: u64, y: u64) -> f64 {
        let shifted = |by: u32| by - self.level;
        let hash = ((x << shifted(23)) + (y << shifted(15)) + (x << shifted(7))) & 0xffff;
        let next = |seed: u64| (28_411 + seed * 8121) % 134_456;
        let signed = |seed: u64| seed as f64 * 2.0 / 134_456.0 - 1.0;
        let mut seed = 21 + hash;
        loop {
            let (one, two) = (next(seed), next(next(seed)));
            let (v_1, v_2) = (signed(one), signed(two));
            let r = v_1 * v_1 + v_2 * v_2;
            if r < 1.0 {
                return v_1 * (-2.0 * r.ln() / r).sqrt();
            }
            seed = two;
        }
    }
}

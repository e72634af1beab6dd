//! Numbers drawn at random, the same for the same seed.

use math::Real;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use stage::Precision;

/// A vector of the plane, as a generator computes with it.
pub type Vec2 = <f64 as Real>::Vec2;
/// A vector of space.
pub type Vec3 = <f64 as Real>::Vec3;

/// A source of the numbers of a regime.
///
/// What comes out is `f64`; a case is rounded to the precision when it is complete.
#[derive(Clone, Debug)]
pub struct Draw {
    generator: Pcg64,
    precision: Precision,
}

impl Draw {
    /// A source for one regime of a stage at one precision. Regimes have sources of their own, so that
    /// one of them alone draws the cases that it draws among the others.
    pub fn new(seed: u64, regime: &str, precision: Precision) -> Draw {
        // FNV-1a over the names: the same on every machine.
        let names = regime.bytes().chain(precision.name().bytes());
        let stream = names.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
        Draw { generator: Pcg64::new(u128::from(seed), u128::from(stream)), precision }
    }

    /// The precision that the case is for.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// x rounded to the precision.
    pub fn rounded(&self, x: f64) -> f64 {
        match self.precision {
            Precision::F32 => f64::from(x as f32),
            Precision::F64 => x,
        }
    }

    /// A vector rounded to the precision: for a number that another one of the case follows from.
    pub fn rounded_vector(&self, v: Vec3) -> Vec3 {
        v.map(|x| self.rounded(x))
    }

    /// The one or the other, by the precision.
    pub fn by_precision<T>(&self, at_f64: T, at_f32: T) -> T {
        match self.precision {
            Precision::F32 => at_f32,
            Precision::F64 => at_f64,
        }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.generator.next_u64()
    }

    /// A whole number below `bound`, which is not 0.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    /// From `low` up to `high`, which only a rounding reaches; every number is as likely as the next.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// From `low` to `high`, both above zero, every decade as likely as the next.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        // libm's, not the system's: the same bits on every machine
        math::portable::exp(self.uniform(math::portable::ln(low), math::portable::ln(high)))
    }

    /// From `low` to `high`, both above 1, every decade as likely as the next; or one over that.
    pub fn huge_or_tiny(&mut self, low: f64, high: f64) -> f64 {
        let huge = self.log_uniform(low, high);
        if self.coin() { huge } else { 1.0 / huge }
    }

    /// True half of the time.
    pub fn coin(&mut self) -> bool {
        self.bits() & 1 == 0
    }

    /// 1 or −1.
    pub fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    /// A point from a cube around the origin that reaches from −half to half on every axis.
    pub fn in_cube(&mut self, half: f64) -> Vec3 {
        let [x, y, z] = std::array::from_fn(|_| self.uniform(-half, half));
        f64::vec3(x, y, z)
    }

    /// A direction of length 1 to a rounding, none likelier than another.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.in_cube(1.0);
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v / v.length();
            }
        }
    }

    /// A direction in the plane, like [`Draw::direction`].
    pub fn direction_in_plane(&mut self) -> Vec2 {
        loop {
            let [x, y] = std::array::from_fn(|_| self.uniform(-1.0, 1.0));
            let v = f64::vec2(x, y);
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v / v.length();
            }
        }
    }

    /// A direction of length 1 at right angles to another of length 1, none likelier than the next.
    pub fn perpendicular(&mut self, direction: Vec3) -> Vec3 {
        loop {
            let v = self.direction();
            let side = v - direction * v.dot(direction);
            if side.length_squared() > 0.01 {
                return side / side.length();
            }
        }
    }

    /// Three vectors of whole numbers at right angles to each other, all of the same whole length, which
    /// comes with them: nothing about them needs rounding. No number is above 100.
    ///
    /// They are the columns of Euler's and Rodrigues' rotation matrix of (a, b, c, d), each times the
    /// length a² + b² + c² + d².
    pub fn whole_frame(&mut self) -> ([Vec3; 3], f64) {
        let [a, b, c, d] = loop {
            let whole: [f64; 4] = std::array::from_fn(|_| self.whole(-5, 5));
            if whole.iter().any(|&number| number != 0.0) {
                break whole;
            }
        };
        let columns = [
            f64::vec3(a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)),
            f64::vec3(2.0 * (b * c - a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d + a * b)),
            f64::vec3(2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a - b * b - c * c + d * d),
        ];
        (columns, a * a + b * b + c * c + d * d)
    }

    /// A whole number from `low` to `high`, both included; `high` is not below `low`, and less than
    /// 2^31 above it.
    pub fn whole(&mut self, low: i32, high: i32) -> f64 {
        f64::from(low) + self.below((high - low) as u64 + 1) as f64
    }

    /// Any bit pattern of the precision: subnormal, infinite and NaN ones among them.
    pub fn any_number(&mut self) -> f64 {
        match self.precision {
            Precision::F32 => f64::from(f32::from_bits(self.bits() as u32)),
            Precision::F64 => f64::from_bits(self.bits()),
        }
    }

    /// A case of [`Draw::any_number`]s, which have nothing to do with each other.
    pub fn any_numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.any_number())
    }

    /// The smallest number of the precision above zero, a subnormal one.
    pub fn smallest(&self) -> f64 {
        self.by_precision(f64::from_bits(1), f64::from(f32::from_bits(1)))
    }

    /// A scale at which ordinary numbers are subnormal, with two digits left.
    pub fn subnormal_scale(&self) -> f64 {
        64.0 * self.smallest()
    }

    /// A number at an end of what there is: zero, the smallest and the largest, those whose squares are,
    /// infinity; of either sign. Or NaN.
    pub fn special_number(&mut self) -> f64 {
        let (smallest_normal, largest) = self
            .by_precision((f64::MIN_POSITIVE, f64::MAX), (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)));
        let numbers = [
            0.0,
            self.smallest(),
            smallest_normal,
            smallest_normal.sqrt(),
            largest.sqrt(),
            largest,
            f64::INFINITY,
            f64::NAN,
        ];
        self.sign() * numbers[self.below(numbers.len() as u64) as usize]
    }

    /// A case with one of its numbers, or two, replaced by a [`Draw::special_number`].
    pub fn with_special_numbers<const N: usize>(&mut self, mut case: [f64; N]) -> [f64; N] {
        for _ in 0..2 {
            case[self.below(N as u64) as usize] = self.special_number();
        }
        case
    }

    /// A case with one of its numbers moved to a neighbor of the precision, up to three times; one case
    /// in four stays as it is. All of its numbers must be finite.
    pub fn nudged<const N: usize>(&mut self, mut case: [f64; N]) -> [f64; N] {
        let (place, up) = (self.below(N as u64) as usize, self.coin());
        for _ in 0..self.below(4) {
            case[place] = match (self.precision, up) {
                (Precision::F64, true) => case[place].next_up(),
                (Precision::F64, false) => case[place].next_down(),
                (Precision::F32, true) => f64::from((case[place] as f32).next_up()),
                (Precision::F32, false) => f64::from((case[place] as f32).next_down()),
            };
        }
        case
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draws(precision: Precision) -> Draw {
        Draw::new(1, "test", precision)
    }

    #[test]
    fn a_whole_frame_is_at_right_angles_exactly() {
        let mut draw = draws(Precision::F64);
        for _ in 0..1000 {
            let ([x, y, z], length) = draw.whole_frame();
            assert_eq!([x.dot(y), y.dot(z), z.dot(x)], [0.0; 3]);
            assert_eq!([x, y, z].map(|v| v.length_squared()), [length * length; 3]);
            assert!((1.0..=100.0).contains(&length));
        }
    }

    #[test]
    fn perpendiculars_are_to_a_rounding() {
        let mut draw = draws(Precision::F64);
        for _ in 0..1000 {
            let direction = draw.direction();
            let side = draw.perpendicular(direction);
            assert!(side.dot(direction).abs() < 1e-14 && (side.length() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn a_nudge_is_a_few_neighbors_of_one_number() {
        let mut draw = draws(Precision::F32);
        let mut seen = [0; 4];
        for _ in 0..1000 {
            let nudged = draw.nudged([1.5, 1.5, 1.5]);
            let steps = nudged.map(|number| ((number - 1.5) / f64::from(f32::EPSILON)).abs());
            assert!(steps.iter().filter(|&&step| step != 0.0).count() <= 1, "{steps:?}");
            seen[steps.iter().sum::<f64>() as usize] += 1;
        }
        assert!(seen.iter().all(|&count| count > 200), "{seen:?}");
    }

    #[test]
    fn a_whole_number_has_both_of_its_ends() {
        let mut draw = draws(Precision::F64);
        let numbers: Vec<f64> = (0..1000).map(|_| draw.whole(-2, 1)).collect();
        for end in [-2.0, -1.0, 0.0, 1.0] {
            assert!(numbers.contains(&end));
        }
        assert!(numbers.iter().all(|number| (-2.0..=1.0).contains(number)));
    }
}

//! Numbers drawn at random, the same for the same seed.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use stage::Precision;

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

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.generator.next_u64()
    }

    /// A whole number below `bound`, which is not 0.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    /// From `low` up to `high`, every number as likely as the next.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// From `low` to `high`, both above zero, every decade as likely as the next.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        // libm's, not the system's: the same bits on every machine
        math::portable::exp(self.uniform(math::portable::ln(low), math::portable::ln(high)))
    }

    /// 1 or −1.
    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    /// A point from a cube around the origin that reaches from −half to half on every axis.
    pub fn in_cube(&mut self, half: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.uniform(-half, half))
    }

    /// A direction of length 1 to a rounding, none likelier than another.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = self.in_cube(1.0);
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if (0.01..=1.0).contains(&square) {
                return v.map(|x| x / square.sqrt());
            }
        }
    }

    /// Any bit pattern of the precision: subnormal, infinite and NaN ones among them.
    pub fn any_number(&mut self) -> f64 {
        match self.precision {
            Precision::F32 => f64::from(f32::from_bits(self.bits() as u32)),
            Precision::F64 => f64::from_bits(self.bits()),
        }
    }
}

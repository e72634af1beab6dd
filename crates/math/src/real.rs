//! The scalar and its vectors: one formula, two precisions.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point number, `f32` or `f64`, with glam's vectors over it.
///
/// Everything a formula of the notes needs and nothing more. `From<f32>` makes constants exact:
/// `R::from(0.5)`.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + From<f32>
    + Into<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// Vectors of the plane: [`glam::Vec2`] or [`glam::DVec2`].
    type Vec2: Vector<Self>;
    /// Vectors of space: [`glam::Vec3`] or [`glam::DVec3`].
    type Vec3: Vector<Self>;
    /// The name that `--precision` takes.
    const NAME: &'static str;
    /// How many binary digits a significand has: 24 or 53.
    const DIGITS: u32;
    /// Positive infinity: "no upper bound on t".
    const INFINITY: Self;
    /// The smallest number above zero (a subnormal one).
    const SMALLEST: Self;
    /// The least and the largest square of a length that is 1 up to two units of the last digit.
    const ONE_FOR_SURE: (Self, Self);
    /// A sum of squares from here on has lost none of its digits to squares that vanish.
    const SAFE_SQUARE: Self;

    /// The vector (x, y).
    fn vec2(x: Self, y: Self) -> Self::Vec2;
    /// The vector (x, y, z).
    fn vec3(x: Self, y: Self, z: Self) -> Self::Vec3;
    /// The components of a vector: x, y, z.
    fn xyz(v: Self::Vec3) -> [Self; 3];
    /// a × b.
    fn cross(a: Self::Vec3, b: Self::Vec3) -> Self::Vec3;
    /// The square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The nearest number of this precision; beyond the largest one, an infinity.
    fn round_from(x: f64) -> Self;
    /// A root t rounded to this precision, except that no negative one becomes zero: what lies behind
    /// the origin of a ray stays behind it.
    #[inline(always)]
    fn root_from(t: f64) -> Self {
        let nearest = Self::round_from(t);
        if t < 0.0 && nearest == Self::from(0.0) { -Self::SMALLEST } else { nearest }
    }
    /// The decimal number nearest to `text`, read straight into this precision (so rounded once).
    /// `nan`, `inf` and overflowing numbers are numbers; what is not a number, or has white space around it,
    /// is `None`.
    fn parse(text: &str) -> Option<Self>;
}

/// What the formulas ask of a vector, in two dimensions or three.
pub trait Vector<R>:
    Copy
    + Debug
    + PartialEq
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<R, Output = Self>
    + Div<R, Output = Self>
    + Send
    + Sync
    + 'static
{
    /// a · b.
    fn dot(self, other: Self) -> R;
    /// ‖a‖, the square root of a · a (squares may overflow or vanish: that is a lesson of chapter 04).
    fn length(self) -> R;
    /// The components in order: x, y and in space z.
    fn components(&self) -> &[R];
    /// The vector whose components are f(a_i, b_i).
    fn zip(self, other: Self, f: impl Fn(R, R) -> R) -> Self;

    /// The components as `f64`, exactly: every `f32` is one. N is the number of components.
    fn in_f64<const N: usize>(self) -> [f64; N]
    where
        R: Real,
    {
        std::array::from_fn(|axis| self.components()[axis].into())
    }

    /// a / ‖a‖. Divided by its largest component first, so that no square overflows or vanishes; NaN
    /// throughout for the zero vector and for one that is not finite.
    fn normalized(self) -> Self
    where
        R: Real,
    {
        let magnitude = |x: R| if x < R::from(0.0) { -x } else { x };
        let larger = |a: R, b: R| if b > a { b } else { a };
        let largest = self.components().iter().fold(R::from(0.0), |most, &x| larger(most, magnitude(x)));
        let scaled = self / largest;
        scaled / scaled.length()
    }

    /// a / ‖a‖, like [`Vector::normalized`], without its detour where no square overflows or vanishes. What
    /// is a unit vector already, up to two units of the last digit, stays as it is.
    #[inline(always)]
    fn unit(self) -> Self
    where
        R: Real,
    {
        let squared = self.dot(self);
        if R::ONE_FOR_SURE.0 <= squared && squared <= R::ONE_FOR_SURE.1 {
            return self;
        }
        if R::SAFE_SQUARE <= squared && squared < R::INFINITY {
            self / squared.sqrt()
        } else {
            self.normalized()
        }
    }

    /// No component is infinite or NaN.
    fn is_finite(self) -> bool
    where
        R: Real,
    {
        self.components().iter().all(|component| component.is_finite())
    }

    /// Every component is zero (of either sign).
    fn is_zero(self) -> bool
    where
        R: Real,
    {
        self.components().iter().all(|&component| component == R::from(0.0))
    }

    /// The first component.
    fn x(&self) -> R
    where
        R: Copy,
    {
        self.components()[0]
    }

    /// The second component.
    fn y(&self) -> R
    where
        R: Copy,
    {
        self.components()[1]
    }
}

macro_rules! real {
    ($scalar:ident, $vec2:ty, $vec3:ty) => {
        impl Real for $scalar {
            type Vec2 = $vec2;
            type Vec3 = $vec3;
            const NAME: &'static str = stringify!($scalar);
            const DIGITS: u32 = $scalar::MANTISSA_DIGITS;
            const INFINITY: Self = $scalar::INFINITY;
            const SMALLEST: Self = $scalar::from_bits(1);
            const ONE_FOR_SURE: (Self, Self) = (1.0 - 4.0 * $scalar::EPSILON, 1.0 + 4.0 * $scalar::EPSILON);
            const SAFE_SQUARE: Self = $scalar::MIN_POSITIVE / $scalar::EPSILON;

            fn vec2(x: Self, y: Self) -> $vec2 {
                <$vec2>::new(x, y)
            }
            fn vec3(x: Self, y: Self, z: Self) -> $vec3 {
                <$vec3>::new(x, y, z)
            }
            fn xyz(v: $vec3) -> [Self; 3] {
                v.to_array()
            }
            fn cross(a: $vec3, b: $vec3) -> $vec3 {
                a.cross(b)
            }
            fn sqrt(self) -> Self {
                $scalar::sqrt(self)
            }
            fn is_finite(self) -> bool {
                $scalar::is_finite(self)
            }
            fn round_from(x: f64) -> Self {
                x as $scalar
            }
            fn parse(text: &str) -> Option<Self> {
                text.parse().ok()
            }
        }
        vector!($scalar, $vec2, x y);
        vector!($scalar, $vec3, x y z);
    };
}

macro_rules! vector {
    ($scalar:ident, $vector:ty, $($axis:ident)*) => {
        impl Vector<$scalar> for $vector {
            fn dot(self, other: Self) -> $scalar {
                self.dot(other)
            }
            fn length(self) -> $scalar {
                self.length()
            }
            fn components(&self) -> &[$scalar] {
                self.as_ref()
            }
            fn zip(self, other: Self, f: impl Fn($scalar, $scalar) -> $scalar) -> Self {
                Self { $($axis: f(self.$axis, other.$axis)),* }
            }
        }
    };
}

real!(f32, glam::Vec2, glam::Vec3);
real!(f64, glam::DVec2, glam::DVec3);

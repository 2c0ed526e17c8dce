//! `--precision`, and how numbers of each precision are written.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use serde::{Serialize, Serializer};

use crate::geometry::dd::Dd;
use crate::geometry::number::Real;
use crate::trace::Numbers;
use crate::trace::precision::Precision;

impl ValueEnum for Numbers {
    fn value_variants<'a>() -> &'a [Numbers] {
        &[Numbers::F32, Numbers::F64, Numbers::Dd]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Numbers::F32 => "Single precision, as it is",
            Numbers::F64 => "Double precision; what it cannot decide is decided in dd",
            Numbers::Dd => "Double-double, about 32 digits",
        };
        Some(PossibleValue::new(self.name()).help(help))
    }
}

/// A number in an answer. Zero has no sign.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Written {
    Single(f32),
    Double(f64),
    /// Decimal digits.
    Digits(String),
}

impl Serialize for Written {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Written::Single(x) => serializer.serialize_f32(*x),
            Written::Double(x) => serializer.serialize_f64(*x),
            Written::Digits(text) => serializer.serialize_str(text),
        }
    }
}

/// A precision whose numbers can be written: the shortest decimals that read back as the same
/// number, or for double-double a string of 32 significant digits.
pub(super) trait Writable: Precision {
    fn written(self) -> Written;
}

impl Writable for f32 {
    fn written(self) -> Written {
        Written::Single(self + 0.0)
    }
}

impl Writable for f64 {
    fn written(self) -> Written {
        Written::Double(self + 0.0)
    }
}

impl Writable for Dd {
    fn written(self) -> Written {
        Written::Digits(digits(self))
    }
}

/// The number of significant digits of a double-double number: its precision of 2⁻¹⁰² is 2·10⁻³¹.
const DIGITS: usize = 32;

/// A finite number with [`DIGITS`] significant digits, correctly rounded: 0.00…, 1234.5… or, where
/// that would need more zeros than digits, 1.2345…e67.
fn digits(x: Dd) -> String {
    let (high, low) = x.parts();
    // A precision of 0 means no limit, so that the sum of the parts is exact.
    let exact = |part: f64| {
        let part = FBig::<HalfEven, 2>::try_from(part).unwrap_or_default();
        part.with_precision(0).value()
    };
    let sum = exact(high) + exact(low);
    let decimal = sum.with_base_and_precision::<10>(DIGITS).value();
    let text = format!("{decimal:.precision$e}", precision = DIGITS - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", mantissa),
    };
    let mantissa = mantissa.replace('.', "");
    match exponent.parse::<i32>() {
        Ok(e @ 0..=15) => {
            let (whole, rest) = mantissa.split_at(mantissa.len().min(e as usize + 1));
            format!("{sign}{whole}.{rest}")
        }
        Ok(e @ -5..=-1) => format!("{sign}0.{}{mantissa}", "0".repeat(-e as usize - 1)),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_of_known_numbers() {
        // By the definition of each, to 32 digits: 1/3, 2/300, √2, 2¹⁰⁰ = 1267650600228229401496703205376.
        let third = Dd::ONE / Dd::of(3.0);
        assert_eq!(&digits(third)[..32], "0.333333333333333333333333333333");
        assert_eq!(digits(third).len(), 2 + DIGITS);
        let small = Dd::of(2.0) / Dd::of(300.0);
        assert_eq!(&digits(small)[..33], "0.0066666666666666666666666666666");
        let root = -Dd::of(2.0).sqrt();
        assert_eq!(&digits(root)[..32], "-1.41421356237309504880168872420");
        let power = Dd::of((1u128 << 100) as f64);
        assert_eq!(digits(power), "1.2676506002282294014967032053760e30");
        assert_eq!(
            digits(Dd::of(-1234.5)),
            format!("-1234.5{}", "0".repeat(27))
        );
        assert_eq!(digits(Dd::ZERO), format!("0.{}", "0".repeat(31)));
        assert_eq!(digits(-Dd::ZERO), digits(Dd::ZERO));
        // An exact part far below the last place of a double.
        let sum = Dd::sum(1.0, (0.5f64).powi(100));
        assert_eq!(digits(sum), "1.0000000000000000000000000000008");
    }
}

//! The spelling of a number: the shortest that reads back as the same value, without an exponent
//! where that makes it no longer.

use crate::syntax::with_point;
use std::borrow::Cow;
use std::fmt::{self, Write};

/// A decimal number of at most this many digits is the shortest spelling of its value as a double.
const CERTAIN_DIGITS: usize = 15;

/// The spelling of a number in the place of a real; `value` is the value of `text`. A number that is not finite stays
/// as it is, and so does one that may have lost its point, as `08`.
pub(super) fn real(text: &str, value: f64) -> Cow<'_, str> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if value != 0.0 && with_point(digits).is_some() {
        return text.into();
    }
    match plain(text) {
        Some(spelled) => spelled,
        None if value.is_finite() => shortest(text, value),
        None => text.into(),
    }
}

/// A quick test of a number whose spelling need not change: returns the length of the part before its point. `None`
/// says nothing about the number.
#[inline]
pub(super) fn canonical(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        rest.iter().take_while(|b| b.is_ascii_digit()).count()
    };
    let sign = usize::from(bytes.first() == Some(&b'-'));
    let whole = digits(sign);
    let point = sign + whole;
    let zero = bytes.get(sign) == Some(&b'0');
    if whole == 0 || whole > CERTAIN_DIGITS || zero && whole > 1 {
        return None;
    }
    let right = match bytes.get(point..)? {
        [] => true,
        [b'.', fraction @ .., last] => {
            let length = fraction.len() + 1;
            // A number below one with four zeros or more behind the point is shorter with an exponent.
            let near = !zero || bytes[point + 1..].iter().take(4).any(|&b| b != b'0');
            near && *last != b'0' && whole + length <= CERTAIN_DIGITS && digits(point + 1) == length
        }
        _ => false,
    };
    right.then_some(point)
}

/// The spelling of a number in the place of an integer. A text that is no integer stays as it is, and so do `-0` and
/// `-00`: read as reals they are −0, and `0` is not.
pub(super) fn integer(text: &str) -> Cow<'_, str> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    if digits.starts_with(|c: char| c.is_ascii_digit() && c != '0') || digits == "0" {
        return text.into();
    }
    match text.parse::<i64>() {
        Ok(0) if digits.len() < text.len() => text.into(),
        Ok(value) => value.to_string().into(),
        Err(_) => text.into(),
    }
}

/// The shortest spelling of a number without an exponent, found by leaving out a plus sign and needless zeros. `None`
/// if the number has too many digits for that, or is shorter with an exponent.
fn plain(text: &str) -> Option<Cow<'_, str>> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let negative = text.starts_with('-');
    let mut point = None;
    for (i, byte) in unsigned.bytes().enumerate() {
        match byte {
            b'0'..=b'9' => {}
            b'.' if point.is_none() => point = Some(i),
            _ => return None,
        }
    }
    let (whole, fraction) = match point {
        Some(at) => (&unsigned[..at], &unsigned[at + 1..]),
        None => (unsigned, ""),
    };
    if whole.len() + fraction.len() == 0 {
        return None;
    }
    let whole = whole.trim_start_matches('0');
    let fraction = fraction.trim_end_matches('0');
    if whole.is_empty() && fraction.is_empty() {
        return Some(if negative { "-0" } else { "0" }.into());
    }
    if whole.len() + fraction.len() > CERTAIN_DIGITS
        || (whole.is_empty() && fraction.starts_with("0000"))
    {
        return None;
    }
    let length = whole.len() + fraction.len() + usize::from(!fraction.is_empty());
    let first = usize::from(text.starts_with('+'));
    let digits_at = text.len() - unsigned.len();
    let is_bare = unsigned.starts_with(whole) && !whole.is_empty()
        || unsigned.starts_with("0.") && whole.is_empty();
    if is_bare {
        let zero = usize::from(whole.is_empty());
        return Some(text[first..digits_at + zero + length].into());
    }
    let sign = if negative { "-" } else { "" };
    let whole = if whole.is_empty() { "0" } else { whole };
    let point = if fraction.is_empty() { "" } else { "." };
    Some(format!("{sign}{whole}{point}{fraction}").into())
}

fn shortest(text: &str, value: f64) -> Cow<'_, str> {
    debug_assert_eq!(text.parse().map(f64::to_bits), Ok(value.to_bits()));
    let small_or_large = !(1e-4..1e16).contains(&value.abs()) && value != 0.0;
    // Most numbers that programs write are spelled like this already.
    if !small_or_large && is_written(value, text) {
        return text.into();
    }
    // `{}` and `{:e}` both print the fewest digits; the first never has an exponent, and the second always has one.
    let plain = format!("{value}");
    let kept = text.contains(['e', 'E']) && plain.len() > text.len();
    if kept || small_or_large {
        let exponent = format!("{value:e}");
        if kept || exponent.len() < plain.len() {
            return exponent.into();
        }
    }
    plain.into()
}

/// Whether `Display` writes `value` as this text.
fn is_written(value: f64, text: &str) -> bool {
    struct Rest<'t>(&'t str);
    impl fmt::Write for Rest<'_> {
        fn write_str(&mut self, part: &str) -> fmt::Result {
            self.0 = self.0.strip_prefix(part).ok_or(fmt::Error)?;
            Ok(())
        }
    }
    let mut rest = Rest(text);
    write!(rest, "{value}").is_ok() && rest.0.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(text: &str) -> Cow<'_, str> {
        super::real(text, text.parse().unwrap_or(f64::NAN))
    }

    #[test]
    fn shortest_spellings() {
        for (from, to) in [
            ("1.50", "1.5"),
            ("+3", "3"),
            ("1E+3", "1000"),
            ("3.0", "3"),
            (".5", "0.5"),
            ("5.", "5"),
            ("-0.0", "-0"),
            ("-0", "-0"),
            ("-.0", "-0"),
            ("-0e5", "-0"),
            ("-0.000e-99", "-0"),
            ("-1e-999", "-0"),
            ("0.00", "0"),
            ("1e-5", "1e-5"),
            ("0.00001", "1e-5"),
            ("0.0001", "0.0001"),
            ("123456789012345678901234567890", "1.2345678901234568e29"),
            ("1e3", "1e3"),
            ("1.0e3", "1000"),
            ("+1E-03", "0.001"),
            ("1e15", "1e15"),
            ("10E14", "1e15"),
            ("1000000000000000", "1000000000000000"),
            ("-00.50", "-0.5"),
            ("-.5", "-0.5"),
            ("+0.5", "0.5"),
            ("007.0", "7"),
            ("-10.25", "-10.25"),
            ("0.000010", "1e-5"),
            ("0.00000000000001e-1", "1e-15"),
            ("0.1000000000000000055511151231257827", "0.1"),
            ("1e999", "1e999"),
            ("large", "large"),
        ] {
            let point = to.find(['.', 'e']).unwrap_or(to.len());
            assert!(canonical(to).is_none_or(|p| p == point), "{to}");
            assert!(canonical(from).is_none_or(|_| from == to), "{from}");
            assert_eq!(real(from), to);
            assert_eq!(real(to), to);
        }
        for (from, to) in [
            ("+007", "7"),
            ("-0", "-0"),
            ("00", "0"),
            ("-40", "-40"),
            ("9.0", "9.0"),
            ("x", "x"),
        ] {
            assert_eq!(integer(from), to);
        }
    }

    proptest::proptest! {
        /// A number that is taken as it is would not be spelled otherwise.
        #[test]
        fn canonical_numbers_stay_as_they_are(text in "-?[0-9]{1,8}(\\.[0-9]{1,9})?") {
            if canonical(&text).is_some() {
                proptest::prop_assert_eq!(&real(&text), &text);
            }
        }

        #[test]
        fn values_stay_to_the_bit(bits: u64) {
            let value = f64::from_bits(bits);
            if value.is_finite() {
                let more = [format!("+{value}e0"), format!("{value}00")];
                let texts = [format!("{value}"), format!("{value:?}"), format!("{value:e}")];
                // Zeros behind what has a point say nothing; else they make another number.
                for text in texts.into_iter().chain(more.into_iter().filter(|t| t.contains('.'))) {
                    let spelled = real(&text);
                    let same = text.parse::<f64>().map(f64::to_bits);
                    proptest::prop_assert_eq!(spelled.parse::<f64>().map(f64::to_bits), same);
                    proptest::prop_assert_eq!(&real(&spelled), &spelled);
                    if canonical(&text).is_some() {
                        proptest::prop_assert_eq!(&real(&text), &text);
                    }
                }
            }
        }
    }
}

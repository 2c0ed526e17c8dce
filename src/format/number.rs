//! The one spelling of a number: the shortest that reads back as the same value.

use std::borrow::Cow;

/// A number where any will do. What is no finite number is left as it is.
pub fn real(text: &str) -> Cow<'_, str> {
    match text.parse::<f64>() {
        // A bare `-0` could be taken for an integer, which has no negative zero.
        Ok(value) if value == 0.0 && value.is_sign_negative() => "-0.0".into(),
        Ok(value) if value.is_finite() => shortest(value).into(),
        _ => text.into(),
    }
}

/// A number where an integer is needed. What is no integer is left as it is.
pub fn integer(text: &str) -> Cow<'_, str> {
    match text.parse::<i64>() {
        Ok(value) => value.to_string().into(),
        Err(_) => text.into(),
    }
}

/// Without an exponent where that is readable, and never with a needless `.0`.
fn shortest(value: f64) -> String {
    // `Debug` has the shortest digits, and an exponent below 1e-5 and from 1e16.
    let text = format!("{value:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shortest_spellings() {
        for (from, to) in [
            ("1.50", "1.5"),
            ("+3", "3"),
            ("1E+3", "1000"),
            ("3.0", "3"),
            (".5", "0.5"),
            ("5.", "5"),
            ("-0.0", "-0.0"),
            ("-0", "-0.0"),
            ("0.00", "0"),
            ("1e-5", "1e-5"),
            ("0.00001", "1e-5"),
            ("0.0001", "0.0001"),
            ("123456789012345678901234567890", "1.2345678901234568e29"),
            ("0.1000000000000000055511151231257827", "0.1"),
            ("1e999", "1e999"),
            ("large", "large"),
        ] {
            assert_eq!(real(from), to);
            assert_eq!(real(to), to);
        }
        for (from, to) in [("+007", "7"), ("-0", "0"), ("9.0", "9.0"), ("x", "x")] {
            assert_eq!(integer(from), to);
        }
    }

    proptest::proptest! {
        #[test]
        fn values_stay_to_the_bit(bits: u64) {
            let value = f64::from_bits(bits);
            if value.is_finite() {
                for text in [format!("{value}"), format!("{value:?}"), format!("{value:e}")] {
                    let spelled = real(&text);
                    proptest::prop_assert_eq!(spelled.parse::<f64>().unwrap().to_bits(), bits);
                    proptest::prop_assert_eq!(&real(&spelled), &spelled);
                }
            }
        }
    }
}

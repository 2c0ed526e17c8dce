//! Calculations that a person has left in the text: `3*0.3`, `2^3`, `√2`, `½`; and numbers with another sign for their
//! point, or none.

/// The value of a calculation, or of a number with another sign in the place of its decimal point. `None` for other
/// texts.
pub fn calculated(text: &str) -> Option<String> {
    let (sign, rest) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    if let Some(point) = pointed(rest) {
        return Some(format!("{}{point}", &text[..text.len() - rest.len()]));
    }
    let value = match rest {
        "½" => 0.5,
        "¼" => 0.25,
        "¾" => 0.75,
        _ => match rest.strip_prefix('√') {
            Some(of) => number(of)?.sqrt(),
            None => operation(rest)?,
        },
    };
    // Twelve digits suffice for a result of short decimal numbers; further ones are rounding, as in 0.1 + 0.2.
    let rounded = format!("{:.11e}", sign * value).parse().unwrap_or(value);
    let close = (rounded - sign * value).abs() <= 4.0 * f64::EPSILON * value.abs();
    let shown = if close { rounded } else { sign * value };
    value.is_finite().then(|| shown.to_string())
}

/// A number below 1 whose decimal point is lost or stands at its end: `08` and `08.` are 0.8, `085` is 0.85.
pub fn with_point(text: &str) -> Option<String> {
    let rest = text.strip_prefix('0')?;
    let rest = rest.strip_suffix('.').unwrap_or(rest);
    let is_one = !rest.is_empty() && rest.bytes().all(|c| c.is_ascii_digit());
    is_one.then(|| format!("0.{rest}"))
}

/// A whole number with a point before its last digit: `30` is `3.0`, `6` is `0.6`. `None` for other texts.
pub fn tenth(text: &str) -> Option<String> {
    let digits = text.trim_start_matches(['-', '+']);
    let is_whole = !digits.is_empty() && digits.bytes().all(|c| c.is_ascii_digit());
    let (most, last) = text.split_at(text.len().checked_sub(1).filter(|_| is_whole)?);
    let zero = if digits.len() == 1 { "0" } else { "" };
    Some(format!("{most}{zero}.{last}"))
}

/// A number with the other sign.
pub fn opposite(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{}", text.trim_start_matches('+')),
    }
}

/// The value of two numbers with `^`, `**`, `*` or `+` between them.
fn operation(text: &str) -> Option<f64> {
    let parts = |sign: &str| {
        let (a, b) = text.split_once(sign)?;
        Some((number(a)?, number(b)?))
    };
    let power = parts("^").or_else(|| parts("**"));
    let power = power.map(|(a, b)| a.powf(b));
    let product = || parts("*").map(|(a, b)| a * b);
    let sum = || parts("+").map(|(a, b)| a + b);
    power.or_else(product).or_else(sum)
}

/// A number with another sign in the place of its decimal point, as `0'8` or `0:8`. Before another sign than an
/// apostrophe only a 0 may stand, since `2:3` may be something else.
fn pointed(text: &str) -> Option<String> {
    let at = text.find(['\'', '’', '·', ':'])?;
    let sign = text[at..].chars().next()?;
    let (whole, part) = (&text[..at], &text[at + sign.len_utf8()..]);
    let is_digits = |t: &str| !t.is_empty() && t.bytes().all(|c| c.is_ascii_digit());
    let is_point = whole == "0" || matches!(sign, '\'' | '’');
    (is_point && is_digits(whole) && is_digits(part)).then(|| format!("{whole}.{part}"))
}

fn number(text: &str) -> Option<f64> {
    let is_number = text.contains(|c: char| c.is_ascii_digit());
    let value = text.parse::<f64>().ok().filter(|_| is_number)?;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::{calculated, opposite, tenth, with_point};

    #[test]
    fn arithmetic_and_points() {
        for (text, meant) in [
            ("2^3", "8"),
            ("2**3", "8"),
            ("√2", "1.4142135623730951"),
            ("-√4", "-2"),
            ("3*0.3", "0.9"),
            ("0.7+0.2", "0.9"),
            ("½", "0.5"),
            ("-½", "-0.5"),
            ("0'8", "0.8"),
            ("1’5", "1.5"),
            ("0·8", "0.8"),
            ("-0:8", "-0.8"),
        ] {
            assert_eq!(calculated(text).as_deref(), Some(meant), "{text}");
        }
        for text in ["2:5", "2·5", "3-4", "√", "2^", "0:8:1", "12", "a*b"] {
            assert_eq!(calculated(text), None, "{text}");
        }
    }
    #[test]
    fn points_and_signs() {
        for (text, meant) in [
            ("30", "3.0"),
            ("6", "0.6"),
            ("-6", "-0.6"),
            ("-125", "-12.5"),
        ] {
            assert_eq!(tenth(text).as_deref(), Some(meant), "{text}");
        }
        for text in ["", "-", "0.5", "1e3"] {
            assert_eq!(tenth(text), None, "{text}");
        }
        for (text, meant) in [("2", "-2"), ("+2", "-2"), ("-0.5", "0.5")] {
            assert_eq!(opposite(text), meant);
        }
        assert_eq!(with_point("08.").as_deref(), Some("0.8"));
    }
}

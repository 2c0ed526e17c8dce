//! Numbers in other characters than those of the language: letters that look like digits, typographic
//! minus signs, per cent and degree signs, fractions.

use crate::syntax::calculated;

/// Characters that may stand for a minus sign.
const DASHES: [char; 8] = ['−', '–', '—', '‐', '‑', '‒', '﹣', '－'];

/// Units behind numbers, the longer of two first.
const UNITS: [&str; 12] = [
    "°", "º", "˚", "degrees", "deg", "stupňů", "mm", "cm", "dm", "km", "px", "m",
];

/// The number that was meant by a word that is no number. A per cent sign divides by 100; units are dropped.
pub(super) fn number(text: &str) -> Option<String> {
    // On a Czech keyboard `=` stands where others have the minus.
    if let Some(number) = text.strip_prefix('=')
        && number.starts_with(|c: char| c.is_ascii_digit() || c == '.')
    {
        return Some(format!("-{}", plain(number)?));
    }
    // Angles are in degrees, and lengths have no unit.
    let without_unit = UNITS.iter().find_map(|unit| text.strip_suffix(unit));
    let text = without_unit
        .filter(|number| plain(number).is_some())
        .unwrap_or(text);
    // A decimal point may have been typed twice.
    let text = match text.matches('.').count() {
        2 if text.contains("..") => text.replace("..", "."),
        _ => text.to_owned(),
    };
    let text = text.as_str();
    // A second point, or the minus, may stand behind all digits.
    let without_end = text.strip_suffix('.').filter(|rest| rest.contains('.'));
    let sign_behind = text
        .strip_suffix('-')
        .filter(|rest| !rest.starts_with(['-', '+']));
    if let Some(number) = without_end.and_then(plain) {
        return Some(number);
    }
    // A point before all digits.
    let without_start = text.strip_prefix('.').filter(|rest| rest.contains('.'));
    if let Some(number) = without_start.and_then(plain) {
        return Some(number);
    }
    if let Some(number) = sign_behind.and_then(plain) {
        return Some(format!("-{number}"));
    }
    if let Some(share) = text.strip_suffix('%') {
        return hundredth(&plain(share)?);
    }
    if let Some((above, below)) = text.split_once('/') {
        let value = plain(above)?.parse::<f64>().ok()? / plain(below)?.parse::<f64>().ok()?;
        return value.is_finite().then(|| value.to_string());
    }
    // Programs write numbers of single precision with an `f` behind them.
    let single = || text.strip_suffix('f').filter(|t| t.contains('.'));
    plain(text)
        .or_else(|| calculated(text))
        .or_else(|| plain(single()?))
        .or_else(|| plain(&without_shift(text)?))
}

/// The signs on the keys of the digits of a Czech keyboard, from 0 to 9.
const KEYS: &str = "é+ěščřžýáí";

/// The first letter of a word that a Czech keyboard has on the key of a digit, and that digit. `None` if the word is
/// not read that way.
pub(super) fn czech_key(text: &str) -> Option<(char, usize)> {
    let is_read_so = without_shift(text).is_some() && number(text) == without_shift(text);
    let place = |c: char| KEYS.chars().position(|key| key == c);
    let mut keys = text.chars().filter_map(|c| Some((c, place(c)?)));
    keys.next().filter(|_| is_read_so)
}

/// The digits that were meant by the letters that a Czech keyboard has in their place without the shift key.
fn without_shift(text: &str) -> Option<String> {
    let digits = text.strip_prefix(['-', '=']).unwrap_or(text);
    // Some digits may be those of a number pad.
    let is_mixed = digits.contains(|c: char| c.is_ascii_digit());
    let has_letter = digits.contains(|c| KEYS.contains(c) && c != '+');
    if is_mixed && !(has_letter && digits.contains(['.', ','])) {
        return None;
    }
    let digit = |c: char| match KEYS.chars().position(|key| key == c) {
        Some(i) => char::from_digit(i as u32, 10),
        None => matches!(c, '.' | ',' | '0'..='9').then_some(c),
    };
    let new: Option<String> = digits.chars().map(digit).collect();
    let sign = if digits == text { "" } else { "-" };
    new.map(|new| format!("{sign}{new}"))
}

/// Converts an angle in parts of π, as `pi/2`, `2*PI/3` or `-π`, to degrees.
pub(super) fn degrees(text: &str) -> Option<String> {
    let text = text.to_lowercase().replace('π', "pi");
    let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
    let factor = above.strip_suffix("pi")?.trim_end_matches(['*', '·']);
    let factor = match factor {
        "" | "+" => "1".to_owned(),
        "-" | "−" => "-1".to_owned(),
        factor => plain(factor)?,
    };
    let value = 180.0 * factor.parse::<f64>().ok()? / plain(below)?.parse::<f64>().ok()?;
    value.is_finite().then(|| value.to_string())
}

/// Whether a word is a sign that belongs to the number before it.
pub(super) fn is_unit(text: &str) -> bool {
    matches!(text, "%" | "°" | "º" | "˚" | "deg" | "degrees" | "stupňů")
}

/// Whether there is a typographic dash in a word.
pub(super) fn has_dash(text: &str) -> bool {
    text.contains(DASHES)
}

/// Whether a word is a minus sign that belongs to the number behind it.
pub(super) fn is_dash(text: &str) -> bool {
    text == "-" || text.chars().all(|c| DASHES.contains(&c)) && text.chars().count() == 1
}

/// Reads a decimal number in which letters and signs stand for the characters that they look like.
fn plain(text: &str) -> Option<String> {
    let digit = |c: char| match c {
        'O' | 'o' => '0',
        'l' | 'I' | 'i' | '|' => '1',
        ',' => '.',
        c if DASHES.contains(&c) => '-',
        c => c,
    };
    let mut out: String = text.chars().map(digit).collect();
    // A letter `O` for a leading zero is dropped.
    if text.starts_with(['O', 'o']) && out[1..].starts_with(|c: char| c.is_ascii_digit()) {
        out.remove(0);
    }
    // A word of letters alone is a digit only if it is a single letter.
    let has_digit = text.contains(|c: char| c.is_ascii_digit())
        || text
            .trim_start_matches(['-', '+'])
            .trim_start_matches(DASHES)
            .chars()
            .count()
            == 1;
    let is_number = has_digit
        && out.len() < 40
        && out.contains(|c: char| c.is_ascii_digit())
        && out.parse::<f64>().is_ok_and(f64::is_finite);
    is_number.then_some(out)
}

/// A number divided by 100, digit by digit.
fn hundredth(text: &str) -> Option<String> {
    if text.contains(['e', 'E']) {
        return Some((text.parse::<f64>().ok()? / 100.0).to_string());
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let all = format!("{whole:0>3}{part}");
    let point = all.len() - part.len() - 2;
    let whole = all[..point].trim_start_matches('0');
    let part = all[point..].trim_end_matches('0');
    let whole = if whole.is_empty() { "0" } else { whole };
    Some(match part {
        "" => format!("{sign}{whole}"),
        part => format!("{sign}{whole}.{part}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_other_characters() {
        for (text, meant) in [
            ("−402", "-402"),
            ("–1.5", "-1.5"),
            ("1O", "10"),
            ("-4O2", "-402"),
            ("l1", "11"),
            ("O.5", "0.5"),
            ("60%", "0.6"),
            ("5%", "0.05"),
            ("100%", "1"),
            ("250%", "2.5"),
            ("12.5%", "0.125"),
            ("-0,5%", "-0.005"),
            ("0%", "0"),
            ("30°", "30"),
            ("1/4", "0.25"),
            ("O", "0"),
            ("O5", "5"),
            ("l", "1"),
            ("0.15m", "0.15"),
            ("40deg", "40"),
            ("110cm", "110"),
            ("-2..5", "-2.5"),
            ("é", "0"),
            ("č+", "41"),
            ("++", "11"),
            ("-ýé+", "-701"),
            ("é,č", "0.4"),
            ("é.2", "0.2"),
            ("=+", "-1"),
            ("=1", "-1"),
            ("=.5", "-.5"),
            ("0.7f", "0.7"),
            ("2^3", "8"),
            ("0:8", "0.8"),
            ("0.7.", "0.7"),
            (".0.3", "0.3"),
            ("4-", "-4"),
        ] {
            assert_eq!(number(text).as_deref(), Some(meant), "{text}");
        }
        for text in ["red", "1/0", "x", "", "%", "--", "oil"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}

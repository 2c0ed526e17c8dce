//! The spelling of numbers in findings and fixes.

use crate::scene::record::Params;
use crate::syntax;
use crate::trace::bitmap::linear;
use crate::trace::film::srgb8;

/// Writes a number as it stands in a scene.
pub fn spelled(x: f64) -> String {
    let text = format!("{:?}", x + 0.0);
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// The shortest decimal number for a part of a colour that pictures show as the sRGB byte `wanted`.
pub fn linear_part(wanted: u8) -> String {
    let exact = linear(f64::from(wanted) / 255.0);
    let rounded = (0..=9).map(|digits| format!("{exact:.digits$}").parse().unwrap_or(exact));
    let found = rounded
        .into_iter()
        .find(|x: &f64| srgb8(*x as f32) == wanted);
    spelled(found.unwrap_or(exact))
}

/// Writes the result of a calculation with decimal numbers, without the rounding of its last digits.
pub fn decimal(x: f64) -> String {
    spelled(format!("{x:.11e}").parse().unwrap_or(x))
}

/// The text of a parameter with the other sign; zero stays as it is.
pub fn opposite(p: &Params, i: usize) -> String {
    match p.text_of(i) {
        text if p.number(i) == 0.0 => text.to_owned(),
        text => syntax::opposite(text),
    }
}

/// Writes a number for people, with four significant digits.
pub fn rough(x: f64) -> String {
    let exact = spelled(x);
    let digits = exact.bytes().filter(u8::is_ascii_digit).count();
    match format!("{x:.3e}").parse() {
        Ok(rounded) if digits > 4 => spelled(rounded),
        _ => exact,
    }
}

/// Writes a coordinate of a place on an object of a given size, to a thousandth of the size: the place as written is
/// still on the object.
pub fn near(x: f64, size: f64) -> String {
    let digits = if size.is_finite() && size > 0.0 {
        3 - size.log10().floor() as i32
    } else {
        3
    };
    if !(0..=12).contains(&digits) {
        let rounded = format!("{x:.9e}").parse().unwrap_or(x);
        return format!("{rounded}");
    }
    let text = format!("{x:.precision$}", precision = digits as usize);
    let text = match text.split_once('.') {
        Some(_) => text.trim_end_matches('0').trim_end_matches('.'),
        None => &text,
    };
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

/// Three parts divided by their sum, with as many digits as show each to a thousandth of the whole. The written numbers
/// add up to 1 at most.
pub fn shares(k: &[f64], sum: f64) -> Vec<String> {
    const MAX_SHARE_ERROR: f64 = 5e-4;
    const FINEST: i32 = 9;
    let parts = |digits: i32| {
        let one = 10f64.powi(digits);
        let rounded = k.iter().map(move |x| (x / sum * one).round());
        (one, rounded.collect::<Vec<_>>())
    };
    let is_right = |(one, parts): &(f64, Vec<f64>)| {
        let off = |(part, x): (&f64, &f64)| (part / one - x / sum).abs();
        let near = parts.iter().zip(k).all(|each| off(each) < MAX_SHARE_ERROR);
        near && parts.iter().sum::<f64>() <= *one
    };
    let (one, mut parts) = (1..FINEST)
        .map(parts)
        .find(is_right)
        .unwrap_or_else(|| parts(FINEST));
    // If rounding makes the sum exceed 1, the excess is taken off the largest part.
    let excess = (parts.iter().sum::<f64>() - one).max(0.0);
    if let Some(largest) = parts.iter_mut().max_by(|a, b| a.total_cmp(b)) {
        *largest -= excess;
    }
    parts.iter().map(|part| spelled(part / one)).collect()
}

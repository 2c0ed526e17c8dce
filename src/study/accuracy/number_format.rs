//! Numbers and names as people read them.

use super::configurations::Kind;
use crate::diagnostics::{Complaint, Language, Value};

/// The values for the placeholders of a message.
pub type Filled<'a> = &'a [(&'static str, Value)];

pub fn say(language: Language, message: &'static str, values: Filled) -> String {
    language.say(message, values)
}

/// A number as it is written in the language.
pub fn local(language: Language, text: String) -> String {
    language.decimal(text)
}

/// An error in steps: as many digits as matter.
pub fn error(language: Language, steps: f64) -> String {
    local(
        language,
        match steps {
            0.0 => "0".into(),
            s if !s.is_finite() => "–".into(),
            s if s < 0.000_1 => format!("{s:.0e}"),
            s if s < 0.01 => format!("{s:.4}"),
            s if s < 0.1 => format!("{s:.3}"),
            s if s < 9.95 => format!("{s:.2}"),
            s => format!("{s:.1}"),
        },
    )
}

/// A factor, as `28` or `1.3`.
pub fn times(language: Language, times: f64) -> String {
    local(
        language,
        match times {
            t if t < 0.095 => format!("{t:.3}"),
            t if t < 9.95 => format!("{t:.2}"),
            t => format!("{t:.0}"),
        },
    )
}

/// A share in percent, without the sign: 0.12 as `12`.
pub fn percent(language: Language, share: f64) -> String {
    let hundredths = 100.0 * share;
    let text = match hundredths.abs() {
        p if p < 0.95 && p > 0.0 => format!("{hundredths:.1}"),
        _ => format!("{hundredths:.0}"),
    };
    local(language, text)
}

pub fn seconds(language: Language, seconds: f64) -> String {
    local(
        language,
        match seconds {
            s if s < 0.001 => format!("{:.0} µs", s * 1e6),
            s if s < 0.01 => format!("{:.1} ms", s * 1e3),
            s if s < 1.0 => format!("{:.0} ms", s * 1e3),
            s if s < 100.0 => format!("{s:.2} s"),
            s => format!("{s:.0} s"),
        },
    )
}

/// The wording of each complaint.
pub fn each(language: Language, all: &[Complaint]) -> Vec<String> {
    all.iter().map(|one| one.wording(language)).collect()
}

pub fn count(n: usize) -> Value {
    Value::Count(n as u64)
}

/// The name of a kind in the language, as "edges".
pub fn kind(language: Language, kind: Kind) -> String {
    say(
        language,
        match kind {
            Kind::Edges => "accuracy-kind-edges",
            Kind::Light => "accuracy-kind-light",
            Kind::Numbers => "accuracy-kind-numbers",
            Kind::Facets => "accuracy-kind-facets",
        },
        &[],
    )
}

/// The name of an effect in the language.
pub fn effect(language: Language, name: &str) -> String {
    let message = match name {
        "shadows" => "accuracy-effect-shadows",
        "transparent-shadows" => "accuracy-effect-transparent-shadows",
        "reflection" => "accuracy-effect-reflection",
        "refraction" => "accuracy-effect-refraction",
        "dispersion" => "accuracy-effect-dispersion",
        "textures" => "accuracy-effect-textures",
        _ => "accuracy-effect-smooth-normals",
    };
    say(language, message, &[])
}

//! Materials by name, in place of the numbers of their records: `2 -201 glass`, `2 -203 sklo`.

use crate::syntax::table::RecordKind;
use crate::syntax::words::plain;

/// A material: its names without accents, the shares of light that it scatters, mirrors and lets through, and its
/// refractive index where it lets light through.
struct Material {
    names: &'static [&'static str],
    shares: &'static str,
    index: Option<&'static str>,
}

const CLEAR: &str = "0 0.1 0.9";

/// The materials. Refractive indices are for yellow light (sodium D), rounded as in tables of physics.
const MATERIALS: &[Material] = &[
    clear(
        &[
            "glass", "sklo", "sklenena", "skleneny", "sklenene", "crystal",
        ],
        "1.5",
    ),
    clear(&["water", "voda"], "1.33"),
    clear(&["ice", "led"], "1.31"),
    clear(&["diamond", "diamant"], "2.42"),
    clear(&["plexiglass", "acrylic", "plexisklo"], "1.49"),
    clear(&["air", "vacuum", "vzduch", "vakuum"], "1"),
    opaque(&["mirror", "zrcadlo"], "0 1 0"),
    opaque(&["metal", "kov"], "0.3 0.7 0"),
    opaque(
        &["matte", "matt", "mat", "matny", "matna", "matne"],
        "1 0 0",
    ),
];

const fn clear(names: &'static [&'static str], index: &'static str) -> Material {
    Material {
        names,
        shares: CLEAR,
        index: Some(index),
    }
}

const fn opaque(names: &'static [&'static str], shares: &'static str) -> Material {
    Material {
        names,
        shares,
        index: None,
    }
}

/// The numbers of a record of some kind for the material with a name. `None` if the word names no material, or if the
/// material has no such numbers.
pub(super) fn numbers(kind: RecordKind, word: &str) -> Option<String> {
    let word = plain(word);
    let material = MATERIALS
        .iter()
        .find(|m| m.names.contains(&word.as_str()))?;
    match kind {
        RecordKind::Optics => Some(material.shares.to_owned()),
        RecordKind::OpticsRgb => Some([material.shares; 3].join(" ")),
        RecordKind::RefractiveIndex => Some([material.index?; 3].join(" ")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_in_both_languages() {
        let of = |kind, word| numbers(kind, word);
        for word in ["glass", "sklo", "Skleněná"] {
            assert_eq!(
                of(RecordKind::RefractiveIndex, word).as_deref(),
                Some("1.5 1.5 1.5")
            );
            assert_eq!(of(RecordKind::Optics, word).as_deref(), Some("0 0.1 0.9"));
        }
        assert_eq!(
            of(RecordKind::OpticsRgb, "zrcadlo").as_deref(),
            Some("0 1 0 0 1 0 0 1 0")
        );
        // A mirror lets no light through, and a colour is no material.
        assert_eq!(of(RecordKind::RefractiveIndex, "mirror"), None);
        assert_eq!(of(RecordKind::Colour, "glass"), None);
        assert_eq!(of(RecordKind::Optics, "koule"), None);
    }

    /// No material gives more light than it gets, and each name is one material's.
    #[test]
    fn materials_are_possible() {
        let mut seen = Vec::new();
        for material in MATERIALS {
            let sum: f64 = material
                .shares
                .split(' ')
                .map(|x| x.parse::<f64>().unwrap())
                .sum();
            assert!((sum - 1.0).abs() < 1e-12);
            for name in material.names {
                assert!(plain(name) == *name && !seen.contains(name), "{name}");
                seen.push(*name);
            }
        }
    }
}

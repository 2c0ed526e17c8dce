//! Colours by name: the 17 basic names of CSS, and the Czech ones.

use crate::syntax::words::plain;

/// The names that CSS 2.1 has, in sRGB, with other English names, and the Czech names without accents and endings.
const NAMES: &[([u8; 3], &[&str], &[&str])] = &[
    ([0, 255, 255], &["aqua", "cyan"], &["azurov"]),
    ([0, 0, 0], &["black"], &["cern"]),
    ([0, 0, 255], &["blue"], &["modr"]),
    ([255, 0, 255], &["fuchsia", "magenta"], &["purpurov"]),
    ([128, 128, 128], &["gray", "grey"], &["sed"]),
    ([0, 128, 0], &["green"], &["zelen"]),
    ([0, 255, 0], &["lime"], &["limetkov"]),
    ([128, 0, 0], &["maroon"], &["kastanov", "vinov"]),
    ([0, 0, 128], &["navy"], &["tmavomodr", "tmavemodr"]),
    ([128, 128, 0], &["olive"], &["olivov"]),
    ([255, 165, 0], &["orange"], &["oranzov"]),
    ([128, 0, 128], &["purple"], &["fialov"]),
    ([255, 0, 0], &["red"], &["cerven"]),
    ([192, 192, 192], &["silver"], &["stribrn"]),
    ([0, 128, 128], &["teal"], &["tyrkysov"]),
    ([255, 255, 255], &["white"], &["bil"]),
    ([255, 255, 0], &["yellow"], &["zlut"]),
];

/// How Czech adjectives end in the nominative, without accents.
const ENDINGS: [&str; 3] = ["a", "y", "e"];

/// Red, green and blue of a name in sRGB, from 0 to 255.
pub fn colour(word: &str) -> Option<[u8; 3]> {
    let word = plain(word);
    let is_czech = |stem: &&str| {
        let ending = word.strip_prefix(stem);
        ending.is_some_and(|ending| ENDINGS.contains(&ending))
    };
    let is_named =
        |n: &&([u8; 3], &[&str], &[&str])| n.1.contains(&word.as_str()) || n.2.iter().any(is_czech);
    NAMES.iter().find(is_named).map(|n| n.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::hex;

    /// <https://www.w3.org/TR/CSS21/syndata.html#value-def-color>
    #[test]
    fn names_of_css_and_czech_ones() {
        for (names, shown) in [
            ("maroon kaštanová vínový", "#800000"),
            ("red červená Červený červené RED", "#ff0000"),
            ("orange oranžová", "#ffa500"),
            ("yellow žlutá", "#ffff00"),
            ("olive olivová", "#808000"),
            ("purple fialová", "#800080"),
            ("fuchsia magenta purpurová", "#ff00ff"),
            ("white bílá bila", "#ffffff"),
            ("lime limetková", "#00ff00"),
            ("green zelená", "#008000"),
            ("navy tmavomodrá", "#000080"),
            ("blue modrá", "#0000ff"),
            ("aqua cyan azurová", "#00ffff"),
            ("teal tyrkysová", "#008080"),
            ("black černá", "#000000"),
            ("silver stříbrná", "#c0c0c0"),
            ("gray grey šedá", "#808080"),
        ] {
            for name in names.split(' ') {
                assert_eq!(colour(name), hex::colour(shown), "{name}");
            }
        }
        for word in ["", "reddish", "koule", "cern", "ball"] {
            assert_eq!(colour(word), None, "{word}");
        }
    }
}

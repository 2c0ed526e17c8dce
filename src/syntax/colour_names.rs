//! Colours by their names in CSS and in Czech.

use color::Srgb;

use crate::syntax::words::plain;

/// Czech names of colours, without accents and endings, each with the name of the same colour in CSS.
const CZECH: &[(&str, &str)] = &[
    ("azurov", "cyan"),
    ("bezov", "beige"),
    ("bil", "white"),
    ("blankytn", "skyblue"),
    ("cern", "black"),
    ("cerven", "red"),
    ("cokoladov", "chocolate"),
    ("fialov", "purple"),
    ("fuchsiov", "magenta"),
    ("hned", "brown"),
    ("indigov", "indigo"),
    ("karminov", "crimson"),
    ("kastanov", "maroon"),
    ("koralov", "coral"),
    ("levandulov", "lavender"),
    ("limetkov", "lime"),
    ("lososov", "salmon"),
    ("modr", "blue"),
    ("modrozelen", "teal"),
    ("olivov", "olive"),
    ("oranzov", "orange"),
    ("purpurov", "magenta"),
    ("ruzov", "pink"),
    ("sed", "gray"),
    ("slonovinov", "ivory"),
    ("stribrn", "silver"),
    ("svetlehned", "tan"),
    ("svetlemodr", "lightblue"),
    ("svetlesed", "lightgray"),
    ("svetlezelen", "lightgreen"),
    ("tmavecerven", "darkred"),
    ("tmavehned", "saddlebrown"),
    ("tmavemodr", "navy"),
    // CSS has a `darkgray` that is lighter than its `gray`.
    ("tmavesed", "dimgray"),
    ("tmavezelen", "darkgreen"),
    ("tyrkysov", "turquoise"),
    ("vinov", "maroon"),
    ("zelen", "green"),
    ("zlat", "gold"),
    ("zlut", "yellow"),
];

/// The endings of Czech adjectives in the nominative, without accents.
const ENDINGS: [&str; 3] = ["a", "y", "e"];

/// Red, green and blue, in sRGB from 0 to 255, of the colour that a word names. `None` if the word names no colour.
pub fn colour(written: &str) -> Option<[u8; 3]> {
    if !written.starts_with(char::is_alphabetic) {
        return None;
    }
    // `světlomodrá` is `světle modrá`.
    let word = plain(written)
        .replacen("svetlo", "svetle", 1)
        .replacen("tmavo", "tmave", 1);
    of_function(&written.to_lowercase())
        .or_else(|| named(&word))
        .or_else(|| named(&meant(&word)?))
}

/// The red, green and blue of a colour's name. Unlike in [`colour`], no letter may be wrong.
pub fn exact(word: &str) -> Option<[u8; 3]> {
    named(&plain(word))
}

/// A colour as CSS writes it with numbers, `rgb(255, 128, 0)`.
fn of_function(word: &str) -> Option<[u8; 3]> {
    word.starts_with("rgb").then(|| parsed(word))?
}

/// The fewest letters of a word that may be a misspelt name.
const MISSPELLED_LEAST: usize = 5;

/// The name of a colour that differs from a word by one letter, if only one colour has such a name.
fn meant(word: &str) -> Option<String> {
    if word.chars().count() < MISSPELLED_LEAST {
        return None;
    }
    // Letters are counted first: that is quicker, and most names have another number of them.
    let may_be = |length: usize| length >= MISSPELLED_LEAST && length.abs_diff(word.len()) <= 1;
    let czech = |stem: &&str| {
        let all = ENDINGS.map(|ending| format!("{stem}{ending}"));
        may_be(stem.len() + 1).then_some(all).into_iter().flatten()
    };
    let names = CZECH.iter().flat_map(|(stem, name)| {
        let css = may_be(name.len()).then(|| (*name).to_owned());
        let near = |n: &String| strsim::osa_distance(n, word) == 1;
        let all = czech(stem).chain(css);
        all.filter(near).map(|name| (name, *stem))
    });
    let found: Vec<(String, &str)> = names.collect();
    let (name, stem) = found.first()?;
    found.iter().all(|f| f.1 == *stem).then(|| name.clone())
}

/// The colour with a name, which is written without accents.
fn named(word: &str) -> Option<[u8; 3]> {
    let stem = ENDINGS.iter().find_map(|ending| word.strip_suffix(ending));
    let czech = CZECH.iter().find(|names| Some(names.0) == stem);
    let name = czech.map_or(word, |names| names.1);
    // The library knows only the spelling `gray`.
    let name = &name.replace("grey", "gray");
    (name.bytes().all(|b| b.is_ascii_lowercase())).then(|| parsed(name))?
}

fn parsed(css: &str) -> Option<[u8; 3]> {
    let colour = color::parse_color(css)
        .ok()?
        .to_alpha_color::<Srgb>()
        .to_rgba8();
    // `transparent` is no colour here.
    (colour.a == u8::MAX).then_some([colour.r, colour.g, colour.b])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::hex;

    /// <https://www.w3.org/TR/css-color-4/#named-colors>
    #[test]
    fn names_of_css_and_czech_ones() {
        for (names, shown) in [
            ("maroon kaštanová vínový", "#800000"),
            ("red červená Červený červené RED", "#ff0000"),
            ("orange oranžová", "#ffa500"),
            ("yellow žlutá", "#ffff00"),
            ("olive olivová", "#808000"),
            ("purple fialová", "#800080"),
            ("fuchsia magenta purpurová fuchsiová", "#ff00ff"),
            ("white bílá bila", "#ffffff"),
            ("lime limetková", "#00ff00"),
            ("green zelená", "#008000"),
            ("navy tmavomodrá tmavě-modrá", "#000080"),
            ("blue modrá", "#0000ff"),
            ("aqua cyan azurová", "#00ffff"),
            ("teal modrozelená", "#008080"),
            ("black černá", "#000000"),
            ("silver stříbrná", "#c0c0c0"),
            ("gray grey šedá šedý sede", "#808080"),
            ("turquoise tyrkysová", "#40e0d0"),
            ("brown hnědá hnedy", "#a52a2a"),
            ("gold zlatá zlate", "#ffd700"),
            ("pink růžová", "#ffc0cb"),
            ("lightblue Light-Blue světlemodrá světlomodrá", "#add8e6"),
            ("rebeccapurple", "#663399"),
            ("lightgoldenrodyellow", "#fafad2"),
            ("papayawhip", "#ffefd5"),
            ("dimgrey tmavošedá", "#696969"),
        ] {
            for name in names.split(' ') {
                assert_eq!(colour(name), hex::colour(shown), "{name}");
            }
        }
        for word in [
            "",
            "reddish",
            "koule",
            "cern",
            "ball",
            "transparent",
            "none",
            "rgb(1,2)",
            "rgba(1,2,3,0.5)",
            // `lime` and `line`, `tan` and `tin`: no short word is a misspelt one.
            "line",
        ] {
            assert_eq!(colour(word), None, "{word}");
        }
    }

    #[test]
    fn two_words_numbers_and_a_letter_too_few() {
        for (name, shown) in [
            ("tmavě modrá", "#000080"),
            ("světle zelená", "#90ee90"),
            ("dark blue", "#00008b"),
            ("Light Green", "#90ee90"),
            ("rgb(255, 128,0)", "#ff8000"),
            ("rgb(100%, 0%, 0%)", "#ff0000"),
            ("čevená", "#ff0000"),
            ("zelenna", "#008000"),
            ("purlpe", "#800080"),
            ("tmavě čevená", "#8b0000"),
        ] {
            assert_eq!(colour(name), hex::colour(shown), "{name}");
        }
        assert_eq!(exact("Červená"), Some([255, 0, 0]));
        assert_eq!(["block", "while"].map(exact), [None; 2]);
    }

    #[test]
    fn czech_names_are_those_of_css() {
        assert!(CZECH.is_sorted());
        for (stem, name) in CZECH {
            assert!(
                colour(name).is_some() && colour(&format!("{stem}a")) == colour(name),
                "{stem}"
            );
        }
    }
}

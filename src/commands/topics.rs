//! Pages of `zpg explain` about things that people want to make and that are no record type. Each has a scene that does
//! it.

mod tables;

use self::tables::{CODES, COMMANDS, WORDS};
use crate::diagnostics::{Code, Language};
use crate::syntax::table::{RECORD_TYPES, RecordType};
use crate::syntax::words::{self, plain};

/// A page of `zpg explain` about a thing to make, such as glass.
pub(super) struct Topic {
    /// The title in English and in Czech.
    titles: [&'static str; 2],
    /// Other words that lead here, without accents and in lower case.
    words: &'static [&'static str],
    /// Text and a scene, in English and in Czech.
    texts: [&'static str; 2],
}

/// The English and the Czech text of a topic, from the files of this name.
macro_rules! texts {
    ($name:literal) => {
        [
            include_str!(concat!("topics/", $name, ".md")),
            include_str!(concat!("topics/", $name, ".cs.md")),
        ]
    };
}

pub(super) const TOPICS: [Topic; 17] = [
    Topic {
        titles: ["glass", "sklo"],
        words: &[
            "transparent",
            "transparency",
            "pruhledny",
            "pruhlednost",
            "prusvitny",
            "prusvitnost",
            "translucent",
            "alpha",
            "alfa",
            "kryti",
        ],
        texts: texts!("glass"),
    },
    Topic {
        titles: ["mirror", "zrcadlo"],
        words: &[
            "reflection",
            "zrcadleni",
            "metal",
            "metallic",
            "chrome",
            "kov",
            "chrom",
        ],
        texts: texts!("mirror"),
    },
    Topic {
        titles: ["prism", "hranol"],
        words: &[],
        texts: texts!("prism"),
    },
    Topic {
        titles: ["shadow", "stín"],
        words: &["shadows", "stiny", "transparentshadow", "pruhlednystin"],
        texts: texts!("shadow"),
    },
    Topic {
        titles: ["checkerboard", "šachovnice"],
        words: &["checker", "chessboard"],
        texts: texts!("checkerboard"),
    },
    Topic {
        titles: ["pyramid", "jehlan"],
        words: &["pyramida"],
        texts: texts!("pyramid"),
    },
    Topic {
        titles: ["hemisphere", "polokoule"],
        words: &["halfsphere", "bowl", "miska"],
        texts: texts!("hemisphere"),
    },
    Topic {
        titles: ["disk", "kruh"],
        words: &["disc", "circle", "kotouc"],
        texts: texts!("disk"),
    },
    Topic {
        titles: ["highlight", "odlesk"],
        words: &[
            "highlights",
            "odlesky",
            "phong",
            "specular",
            "gloss",
            "roughness",
            "rough",
            "shininess",
            "shiny",
            "drsnost",
            "drsny",
            "leskly",
            "lesk",
        ],
        texts: texts!("highlight"),
    },
    Topic {
        titles: ["fog", "mlha"],
        words: &["mist", "haze", "opar"],
        texts: texts!("fog"),
    },
    Topic {
        titles: ["comment", "komentář"],
        words: &[
            "comments",
            "komentare",
            "poznamka",
            "noqa",
            "suppress",
            "ignore",
            "disable",
            "potlacit",
            "ignorovat",
            "vypnout",
        ],
        texts: texts!("comment"),
    },
    Topic {
        titles: ["gamma", "gama"],
        words: &["srgb", "brightness", "jas", "exposure", "expozice"],
        texts: texts!("gamma"),
    },
    Topic {
        titles: ["units", "jednotky"],
        words: &[
            "unit",
            "jednotka",
            "size",
            "sizes",
            "velikost",
            "rozmery",
            "degree",
            "degrees",
            "stupen",
            "stupne",
            "radian",
            "radians",
            "radiany",
            "coordinatesystem",
            "coordinates",
            "handedness",
            "lefthanded",
            "righthanded",
            "soustavasouradnic",
            "souradnice",
            "levotociva",
            "pravotociva",
            "yup",
            "zup",
            "ynahoru",
            "znahoru",
        ],
        texts: texts!("units"),
    },
    Topic {
        titles: ["order", "pořadí"],
        words: &[
            "id",
            "ids",
            "identifier",
            "identifikator",
            "record",
            "zaznam",
            "type",
            "typ",
            "parameter",
            "parametr",
            "object",
            "objekt",
            "scenefile",
            "souborsescenou",
        ],
        texts: texts!("order"),
    },
    Topic {
        titles: ["other lights", "jiná světla"],
        words: &[
            "spotlight",
            "spotlights",
            "spot",
            "reflektor",
            "bodovyreflektor",
            "arealight",
            "arealights",
            "plosnesvetlo",
            "directionallight",
            "smerovesvetlo",
            "parallellight",
            "sun",
            "sunlight",
            "slunce",
            "softshadow",
            "softshadows",
            "mekkystin",
            "mekkestiny",
        ],
        texts: texts!("other-lights"),
    },
    Topic {
        titles: ["decimal point", "desetinná tečka"],
        words: &[
            "decimal",
            "decimalcomma",
            "comma",
            "desetinnacarka",
            "carka",
        ],
        texts: texts!("decimal-point"),
    },
    Topic {
        titles: ["variables", "proměnné"],
        words: &[
            "variable",
            "promenna",
            "constant",
            "konstanta",
            "include",
            "import",
            "declare",
            "define",
            "macro",
            "macros",
            "makro",
            "makra",
            "loop",
            "cyklus",
            "while",
            "function",
            "funkce",
        ],
        texts: texts!("variables"),
    },
];

/// The sentence that says which `--help` explains a word of the command line; `None` if no help does.
pub(super) fn help(word: &str, language: Language) -> Option<String> {
    let word = plain(word);
    let (command, _) = COMMANDS
        .iter()
        .find(|(_, words)| words.contains(&word.as_str()))?;
    let (command, option) = command.split_once(' ').unwrap_or((command, ""));
    let words = ["zpg", command, "--help"].into_iter();
    let text = Vec::from_iter(words.filter(|w| !w.is_empty())).join(" ");
    let message = match option {
        "" => "explain-help",
        _ => "explain-help-option",
    };
    let values = [("text", text.into()), ("option", option.into())];
    Some(language.say(message, &values))
}

/// The finding that a word asks for. A code may lack its zeros: `e3` is `E003`.
pub(super) fn code(word: &str) -> Option<Code> {
    let word = plain(word);
    let coded = CODES
        .iter()
        .find(|(_, words)| words.contains(&word.as_str()));
    let number = || word.get(1..)?.parse::<u16>().ok();
    let padded = || Code::parse(&format!("{}{:03}", word.get(..1)?, number()?));
    coded.map(|(code, _)| *code).or_else(padded)
}

/// The record types that a word may stand for, the likeliest first.
pub(super) fn types(word: &str) -> Vec<&'static RecordType> {
    let named = words::named(word);
    if !named.is_empty() {
        return named;
    }
    let word = plain(word);
    if let Some((_, codes)) = WORDS.iter().find(|(name, _)| *name == word) {
        let types = codes.iter();
        return types
            .filter_map(|&code| RecordType::by_code(code.into()))
            .collect();
    }
    // Any other word may be the meaning of a parameter.
    let is_its = |doc: &str| {
        let doc = plain(doc);
        doc == word || doc.strip_prefix("the") == Some(&word)
    };
    let has = |ty: &&RecordType| {
        let params = ty.params.iter().chain(ty.optional);
        params
            .flat_map(|p| [p.doc.to_owned(), Language::Czech.name(p.doc)])
            .any(|doc| is_its(&doc))
    };
    RECORD_TYPES.iter().filter(has).collect()
}

/// All words that lead to record types and are no titles, without accents.
pub(super) fn all() -> impl Iterator<Item = &'static str> {
    let own = WORDS.iter().map(|n| n.0);
    words::all().map(|n| n.0).chain(own)
}

impl Topic {
    /// The topic that a word leads to: its title, or another word for it.
    pub(super) fn of(word: &str) -> Option<&'static Topic> {
        let word = plain(word);
        let is_its = |topic: &&Topic| {
            let mut titles = topic.titles.iter().map(|title| plain(title));
            titles.any(|title| title == word) || topic.words.contains(&word.as_str())
        };
        TOPICS.iter().find(is_its)
    }

    /// The title of the topic.
    pub(super) fn title(&self, language: Language) -> &'static str {
        self.titles[usize::from(language == Language::Czech)]
    }

    /// The text of the topic, as Markdown.
    pub(super) fn text(&self, language: Language) -> &'static str {
        self.texts[usize::from(language == Language::Czech)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Analysis;
    use crate::diagnostics::Code;
    use crate::solids::bounds::node_bounds;
    use crate::solids::inside::Inside;
    use crate::trace::plan::{Effect, Plan};

    /// Every page has one scene, which is right and needs what the page is about.
    #[test]
    fn scenes_do_what_they_are_for() {
        for (topic, effect) in TOPICS.iter().zip([
            Some(Effect::Refraction),
            Some(Effect::Reflection),
            None,
            Some(Effect::Shadows),
            Some(Effect::Checkerboard),
            None,
            None,
            None,
            Some(Effect::Reflection),
            None,
            None,
            None,
            None,
            None,
            Some(Effect::Shadows),
            None,
            None,
        ]) {
            let mut scenes = Vec::new();
            for language in [Language::English, Language::Czech] {
                let text = topic.text(language);
                let title = topic.title(language);
                let (_, rest) = text.split_once("```zpg\n").expect(title);
                let (scene, rest) = rest.split_once("```\n").expect(title);
                assert!(!rest.contains("```"), "{title}");
                let analysis = Analysis::new("a.zpg", scene.into());
                // It is seen with a camera and by a light of our own.
                let is_right = |code| matches!(code, Code::N602 | Code::N603);
                let found = analysis.findings().iter().map(|d| d.code);
                let wrong: Vec<Code> = found.filter(|code| !is_right(*code)).collect();
                assert_eq!(wrong, [], "{title}");
                let plan = Plan::of_picture(&analysis.scene).expect(title);
                assert!(effect.is_none_or(|effect| plan.on(effect)), "{title}");
                // The same records in both languages.
                let numbers = |line: &str| line.split('#').next().unwrap_or("").trim().to_owned();
                scenes.push(scene.lines().map(numbers).collect::<Vec<_>>());
            }
            assert_eq!(scenes[0], scenes[1]);
        }
    }

    /// Words that newcomers ask for lead somewhere.
    #[test]
    fn questions_of_newcomers_have_pages() {
        for (word, title) in [
            ("size", "units"),
            ("stupně", "units"),
            ("desetinná čárka", "decimal point"),
            ("decimal comma", "decimal point"),
            ("include", "variables"),
            ("declare", "variables"),
            ("macro", "variables"),
            ("proměnná", "variables"),
            ("rozměry", "units"),
            ("ID", "order"),
            ("pořadí", "order"),
            ("area_light", "other lights"),
            ("spotlight", "other lights"),
            ("Reflektor", "other lights"),
            ("měkký stín", "other lights"),
            ("alpha", "glass"),
            ("krytí", "glass"),
            ("coordinate system", "units"),
            ("left-handed", "units"),
            ("souřadnice", "units"),
            ("noqa", "comment"),
            ("potlačit", "comment"),
        ] {
            let topic = Topic::of(word).expect(word);
            assert_eq!(topic.title(Language::English), title, "{word}");
        }
        for (word, code) in [
            ("kt", -201),
            ("elipsa", 10),
            ("ellipse", 10),
            ("angle", -2),
            ("úhel", -2),
            ("image_map", -301),
            ("interior", -203),
            ("mesh", 6),
            ("sor", 1),
            ("up", -501),
            ("inverse", -104),
            ("inverze", -104),
            ("tube", 1),
            ("prstenec", 14),
            ("wall", 12),
            ("zeď", 12),
            ("gradient", 2),
            ("clipped_by", -102),
        ] {
            assert_eq!(types(word)[0].code, code, "{word}");
        }
        let codes = |word| Vec::from_iter(types(word).iter().map(|ty| ty.code));
        for word in ["matrix", "matice"] {
            assert_eq!(codes(word), [-4, 15], "{word}");
        }
        for word in ["depth", "hloubka"] {
            let said = help(word, Language::Czech).expect(word);
            assert_eq!(said, "Více řekne `zpg render --help` u `--depth`.");
        }
        for word in ["resolution", "rozlišení"] {
            let said = help(word, Language::Czech).expect(word);
            assert_eq!(said, "Více řekne `zpg render --help` u `--size`.");
        }
        for word in ["antialiasing", "vyhlazování hran"] {
            let said = help(word, Language::Czech).expect(word);
            assert_eq!(said, "Více řekne `zpg render --help` u `--samples`.");
        }
    }

    /// The points of the shapes that pages build of half-spaces, and points beside them.
    #[test]
    fn pages_build_the_shapes_that_they_are_about() {
        for (word, within, without) in [
            (
                "pyramid",
                &[
                    [0.0, 0.01, 0.0],
                    [0.9, 0.05, -0.9],
                    [0.0, 1.98, 0.0],
                    [-0.45, 1.0, 0.45],
                ][..],
                &[
                    [0.0, -0.01, 0.0],
                    [0.6, 1.0, 0.0],
                    [0.0, 1.0, -0.6],
                    [0.0, 2.1, 0.0],
                ][..],
            ),
            (
                "polokoule",
                &[[0.0, 0.01, 0.0], [0.0, 0.99, 0.0], [0.7, 0.1, 0.7]],
                &[[0.0, -0.01, 0.0], [0.0, 1.01, 0.0], [0.8, 0.1, 0.8]],
            ),
            (
                "disk",
                &[[0.99, 0.51, 0.0], [0.0, 0.01, 1.25]],
                &[
                    [1.01, 0.51, 0.0],
                    [0.0, 0.49, 0.0],
                    [0.0, 0.01, 0.9],
                    [1.6, 0.01, 0.0],
                ],
            ),
        ] {
            let text = Topic::of(word).expect(word).text(Language::English);
            let scene = text
                .split("```zpg\n")
                .nth(1)
                .and_then(|rest| rest.split("```").next());
            let analysis = Analysis::new("a.zpg", scene.expect(word).into());
            let scene = &analysis.scene;
            let bounds = node_bounds(scene);
            let mut inside = Inside::new(scene, &bounds);
            let root = scene.render.expect(word).root;
            for (points, is_within) in [(within, true), (without, false)] {
                for &point in points {
                    assert_eq!(
                        inside.node(root, point),
                        Some(is_within),
                        "{word} {point:?}"
                    );
                }
            }
        }
    }

    /// Words lead somewhere, and to one place.
    #[test]
    fn words_are_written_as_they_are_compared() {
        for (i, (name, codes)) in WORDS.iter().enumerate() {
            assert_eq!(plain(name), *name);
            assert_eq!(types(name).len(), codes.len(), "{name}");
            assert!(words::named(name).is_empty(), "{name} twice");
            assert!(WORDS[..i].iter().all(|n| n.0 != *name), "{name} twice");
        }
    }
}

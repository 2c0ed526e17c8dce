//! Names of types, English and Czech, that people write in the place of the number.

use std::sync::LazyLock;

use rustc_hash::FxHashSet;

use super::table::{Family, RECORD_TYPES, RecordType};
use crate::diagnostics::Language;

/// Names besides keywords and titles, without accents and in lower case, each with the types that it may stand for, the
/// likeliest first.
const NAMES: &[(&str, &[i32])] = &[
    ("sphere", &[11, 9, 13]),
    ("ball", &[11, 9]),
    ("koule", &[11, 9, 13]),
    ("kugel", &[11, 9]),
    ("box", &[12]),
    ("cube", &[12]),
    ("cuboid", &[12]),
    ("block", &[12]),
    ("krychle", &[12]),
    ("kostka", &[12]),
    ("kvadr", &[12]),
    ("rect", &[5]),
    ("rectangle", &[5]),
    ("square", &[5]),
    ("obdelnik", &[5]),
    ("ctverec", &[5]),
    ("triangle", &[6, 7, 8]),
    ("trojuhelnik", &[6, 7, 8]),
    ("plane", &[3, 4]),
    ("rovina", &[3, 4]),
    ("halfspace", &[4]),
    ("poloprostor", &[4]),
    ("ellipsoid", &[10]),
    ("elipsoid", &[10]),
    ("torus", &[14]),
    ("donut", &[14]),
    ("anuloid", &[14]),
    ("ring", &[14]),
    ("prsten", &[14]),
    ("cone", &[16, 17]),
    ("kuzel", &[16, 17]),
    ("quadric", &[15]),
    ("kvadrika", &[15]),
    ("lathe", &[1, 2]),
    ("revolution", &[1, 2]),
    ("cylinder", &[1]),
    ("valec", &[1]),
    ("move", &[-1]),
    ("translate", &[-1]),
    ("translation", &[-1]),
    ("shift", &[-1]),
    ("posun", &[-1]),
    ("posuv", &[-1]),
    ("posunuti", &[-1]),
    ("rotate", &[-2, -4]),
    ("rotation", &[-2, -4]),
    ("turn", &[-2]),
    ("rotace", &[-2, -4]),
    ("otoceni", &[-2, -4]),
    ("quaternion", &[-2]),
    ("kvaternion", &[-2]),
    ("scale", &[-3]),
    ("scaling", &[-3]),
    ("meritko", &[-3]),
    ("zmena", &[-3]),
    ("projection", &[-99]),
    ("projekce", &[-99]),
    ("union", &[-101]),
    ("or", &[-101]),
    ("merge", &[-101]),
    ("sjednoceni", &[-101]),
    ("intersection", &[-102]),
    ("intersect", &[-102]),
    ("and", &[-102]),
    ("prunik", &[-102]),
    ("difference", &[-103]),
    ("subtract", &[-103]),
    ("minus", &[-103]),
    ("rozdil", &[-103]),
    ("complement", &[-104]),
    ("not", &[-104]),
    ("doplnek", &[-104]),
    ("copy", &[-105]),
    ("kopie", &[-105]),
    ("optics", &[-201, -202]),
    ("material", &[-201, -202, -299]),
    ("optika", &[-201, -202]),
    ("vlastnost", &[-201, -202, -299]),
    ("vlastnosti", &[-299, -201, -202]),
    ("ior", &[-203]),
    ("index", &[-203]),
    ("lom", &[-203]),
    ("assign", &[-299]),
    ("apply", &[-299]),
    ("prirazeni", &[-299]),
    ("image", &[-301]),
    ("texture", &[-301, -302, -399]),
    ("textura", &[-301, -302, -399]),
    ("obrazek", &[-301]),
    ("checker", &[-399]),
    ("checkerboard", &[-399]),
    ("chessboard", &[-399]),
    ("sachovnice", &[-399]),
    ("ambient", &[-401]),
    ("ambientni", &[-401]),
    ("okolni", &[-401]),
    ("okolnisvetlo", &[-401]),
    ("light", &[-402, -401]),
    ("lamp", &[-402, -401]),
    ("lightsource", &[-402]),
    ("pointlight", &[-402]),
    ("svetlo", &[-402, -401]),
    ("lampa", &[-402]),
    ("bodove", &[-402]),
    ("camera", &[-501, -502]),
    ("kamera", &[-501, -502]),
    ("color", &[-701]),
    ("colour", &[-701]),
    ("rgb", &[-701]),
    ("pigment", &[-701]),
    ("barva", &[-701]),
    ("render", &[9999]),
    ("scene", &[9999]),
    ("vykresleni", &[9999]),
    ("scena", &[9999]),
];

/// Words that are no names of types but lead to some: what the types are used for, and the terms of the course's
/// handout.
const TOPICS: &[(&str, &[i32])] = &[
    ("glass", &[-201, -203]),
    ("sklo", &[-201, -203]),
    ("mirror", &[-201]),
    ("zrcadlo", &[-201]),
    ("transparent", &[-201]),
    ("transparency", &[-201]),
    ("pruhledny", &[-201]),
    ("pruhlednost", &[-201]),
    ("prusvitny", &[-201]),
    ("prusvitnost", &[-201]),
    ("translucent", &[-201]),
    ("opacity", &[-201]),
    ("boolean", &[-101, -102, -103]),
    ("csg", &[-101, -102, -103]),
    ("smooth", &[8, 7]),
    ("refraction", &[-203]),
    ("lookat", &[-501]),
    ("glulookat", &[-501]),
    ("shading", &[-201, -202]),
    ("stinovani", &[-201, -202]),
    ("emission", &[-402, -401]),
    ("emise", &[-402, -401]),
    ("uv", &[-301]),
    ("location", &[-501]),
    ("lighting", &[-402, -401]),
    ("osvetleni", &[-402, -401]),
    ("finish", &[-201]),
    ("normal", &[7, 8]),
    ("floor", &[4]),
    ("sky", &[9999]),
    ("shadow", &[-402]),
    ("stin", &[-402]),
    ("lens", &[-102, -203]),
    ("cocka", &[-102, -203]),
    ("reflection", &[-201]),
    ("odraz", &[-201]),
    ("odrazy", &[-201]),
    ("dispersion", &[-203]),
    ("disperze", &[-203]),
    ("fov", &[-501]),
    ("fovy", &[-501]),
    ("zornepole", &[-501]),
    ("stereo", &[-503]),
    ("eye", &[-501, -503]),
    ("oko", &[-501, -503]),
    ("lefteye", &[-503]),
    ("leveoko", &[-503]),
    ("righteye", &[-503]),
    ("praveoko", &[-503]),
    ("subtraction", &[-103]),
    ("odecteni", &[-103]),
    ("skalovani", &[-3]),
    ("zvetseni", &[-3]),
    ("zmenseni", &[-3]),
    ("otaceni", &[-2, -4]),
    ("transformace", &[-1, -2, -3, -4]),
    ("transform", &[-1, -2, -3, -4]),
    ("transformation", &[-1, -2, -3, -4]),
    ("profile", &[1, 2]),
    ("profil", &[1, 2]),
    ("normals", &[7, 8]),
    ("normaly", &[7, 8]),
    ("normala", &[7, 8]),
    ("radius", &[11, 9]),
    ("polomer", &[11, 9]),
    ("disc", &[1]),
    ("disk", &[1]),
    ("kruh", &[1]),
    ("group", &[-101]),
    ("skupina", &[-101]),
    ("obalovatelesa", &[-601, -602]),
    ("obalka", &[-601, -602]),
    ("svetla", &[-402, -401]),
    ("prism", &[-102, 4, 12]),
    ("hranol", &[-102, 4, 12]),
    ("cut", &[-103, 4]),
    ("rez", &[-103, 4]),
    ("clip", &[-102, -103, 4]),
    ("clipping", &[-102, -103, 4]),
    ("orez", &[-102, -103, 4]),
    ("orezani", &[-102, -103, 4]),
    ("background", &[9999]),
    ("pozadi", &[9999]),
    ("void", &[0]),
    ("voidobjekt", &[0]),
    ("rotacnitelesodaneprofilem", &[1, 2]),
    ("neorientovanarovina", &[3]),
    ("neorientovanyobdelnik", &[5]),
    ("trojuhelnikajehonormala", &[7]),
    ("elipsoidsestredemvpocatku", &[10]),
    ("koulevobecnepoloze", &[11]),
    ("kvadraabb", &[12, -601]),
    ("kouleisometrickygenerovana", &[13]),
    ("obecnakvadrika", &[15]),
    ("valcovaplocha", &[18, 19]),
    ("valcovaplochaparabolicka", &[18]),
    ("valcovaplochahyperbolicka", &[19]),
    ("parabolickyhyperboloid", &[21]),
    ("paraboloid", &[15, 21]),
    ("rotaceokoloosy", &[-2]),
    ("obecnarotace", &[-4]),
    ("optickevlastnosti", &[-201, -202]),
    ("optickevlastnostimaterialu", &[-201, -202]),
    ("optickevlastnostimaterialumono", &[-201]),
    ("optickevlastnostimaterialurgb", &[-202]),
    ("indexlomudanehoprostredi", &[-203]),
    ("prirazenivlastnostiobjektu", &[-299]),
    ("texturasachovnice", &[-399]),
    ("kameramono", &[-502]),
    ("kamerastereo", &[-503]),
    ("boundingvolume", &[-601, -602]),
    ("boundingvolumes", &[-601, -602]),
    ("barvargb", &[-701]),
    ("renderovanascena", &[9999]),
];

/// The fewest letters of a word that may be a misspelled name.
const MISSPELLED_LEAST: usize = 5;

/// The types that a word may stand for, the likeliest first; one letter of it may be wrong.
pub fn types(word: &str) -> Vec<&'static RecordType> {
    let named = named(word);
    let word = plain(word);
    if !named.is_empty() || word.len() < MISSPELLED_LEAST {
        return named;
    }
    let near = |n: &&(&str, &[i32])| {
        n.0.len() >= MISSPELLED_LEAST && strsim::osa_distance(n.0, &word) == 1
    };
    NAMES.iter().find(near).map_or(Vec::new(), |n| of(n.1))
}

/// The shapes that a word names. The word may be a plural, or another form of a Czech name.
pub fn shapes(word: &str) -> Vec<&'static RecordType> {
    let word = plain(word);
    let named = |name: &str| {
        let codes = NAMES.iter().find(|n| n.0 == name).map_or(&[][..], |n| n.1);
        let mut types = of(codes);
        types.retain(|ty| ty.family == Family::Shape);
        types
    };
    let stems = FORMS.iter().filter_map(|form| word.strip_suffix(form));
    stems
        .flat_map(|stem| {
            // Some forms lose a vowel, as `válce` from `válec`.
            let vowel = stem.strip_suffix('c').map(|stem| format!("{stem}ec"));
            let whole = NOMINATIVES.map(|end| format!("{stem}{end}"));
            whole.into_iter().chain(vowel)
        })
        .map(|name| named(&name))
        .find(|types| !types.is_empty())
        .unwrap_or_default()
}

/// Endings of nouns, without accents.
const FORMS: [&str; 13] = [
    "", "s", "es", "a", "e", "i", "u", "y", "ou", "em", "emi", "ami", "ech",
];
/// Endings of nominatives, without accents.
const NOMINATIVES: [&str; 4] = ["", "a", "e", "us"];

/// A word as `zpg explain` takes it, if it stands for a type; `none` if not.
pub fn explained(word: &str) -> String {
    let is_one = !named(word).is_empty();
    if is_one { word } else { "none" }.to_owned()
}

/// Whether a word is the name of a type, or the first word of one, without a mistake.
pub fn is_name(word: &str) -> bool {
    static ALL: LazyLock<FxHashSet<String>> = LazyLock::new(|| {
        let names = NAMES.iter().map(|n| n.0.to_owned());
        let titles = RECORD_TYPES.iter().flat_map(|ty| {
            let czech = Language::Czech.name(ty.title);
            [ty.keyword, ty.title, &czech]
                .map(|title| plain(title.split(' ').next().unwrap_or(title)))
        });
        names.chain(titles).collect()
    });
    ALL.contains(&plain(word))
}

/// Whether a word means a cylinder. No type has that name: a cylinder is a surface of revolution.
pub fn is_cylinder(word: &str) -> bool {
    matches!(plain(word).as_str(), "cylinder" | "valec")
}

/// Whether a word means a cone.
pub fn is_cone(word: &str) -> bool {
    matches!(plain(word).as_str(), "cone" | "kuzel")
}

fn of(codes: &[i32]) -> Vec<&'static RecordType> {
    let types = codes.iter().filter_map(|&c| RecordType::by_code(c.into()));
    types.collect()
}

/// The types that go by a name, the likeliest first.
pub fn named(name: &str) -> Vec<&'static RecordType> {
    let (word, parts) = (plain(name), in_order(name));
    if let Some((_, codes)) = NAMES.iter().chain(TOPICS).find(|n| n.0 == word) {
        return of(codes);
    }
    let titled = |ty: &&RecordType| {
        let czech = Language::Czech.name(ty.title);
        let titles = [ty.keyword, ty.title, &czech];
        titles
            .iter()
            .any(|t| plain(t) == word || in_order(t) == parts)
    };
    RECORD_TYPES.iter().filter(titled).collect()
}

/// The words of a name without accents, in alphabetical order: `textura obrazová` is `obrazová textura`.
fn in_order(name: &str) -> Vec<String> {
    let mut words: Vec<String> = name.split([' ', '-', '_']).map(plain).collect();
    words.retain(|word| !word.is_empty());
    words.sort();
    words
}

/// All names that are no titles, without accents, with the types they lead to.
pub fn all() -> impl Iterator<Item = (&'static str, &'static [i32])> {
    NAMES.iter().chain(TOPICS).copied()
}

/// The names of a type in both languages, without accents and in lower case.
pub fn names(ty: &RecordType) -> Vec<String> {
    let others = NAMES.iter().filter(|n| n.1.contains(&ty.code));
    let czech = Language::Czech.name(ty.title);
    let titles = [ty.title, &czech].map(|title| title.split(' ').map(plain).collect::<Vec<_>>());
    let mut all: Vec<String> = others.map(|n| n.0.to_owned()).collect();
    all.extend(titles.concat());
    let mut seen = FxHashSet::default();
    all.retain(|name| seen.insert(name.clone()));
    all
}

/// Endings of the forms of nouns, without accents.
const NOUN_ENDINGS: [&str; 22] = [
    "", "s", "es", "a", "e", "i", "o", "u", "y", "ou", "em", "im", "um", "am", "mi", "emi", "ami",
    "ech", "ich", "ach", "ovi", "ovy",
];
/// The fewest letters that the forms of a noun have in common.
const STEM_LEAST: usize = 3;
/// Vowels without accents.
const VOWELS: [char; 6] = ['a', 'e', 'i', 'o', 'u', 'y'];
/// Short words that name nothing, without accents.
const PARTICLES: [&str; 34] = [
    "the", "and", "for", "not", "its", "our", "one", "two", "has", "was", "are", "off", "out",
    "bez", "pro", "pod", "nad", "pred", "pri", "ten", "tato", "toto", "tento", "jen", "tam", "ani",
    "ale", "pak", "dva", "dve", "tri", "jeho", "mezi", "with",
];

/// Whether two words without accents are forms of one noun: `okno` and `okna`, `dum` and `domu`, `zed` and `zdi`.
pub fn are_forms(a: &str, b: &str) -> bool {
    let is_named = |word: &str| word.chars().count() >= STEM_LEAST && !PARTICLES.contains(&word);
    a.chars().next() == b.chars().next()
        && is_named(a)
        && is_named(b)
        && (have_one_stem(a, b) || changes_stem(a, b) || changes_stem(b, a))
}

fn have_one_stem(a: &str, b: &str) -> bool {
    let stems = |word| {
        let stripped = move |ending: &&str| str::strip_suffix(word, ending);
        NOUN_ENDINGS.iter().filter_map(stripped)
    };
    stems(a)
        .filter(|stem| stem.chars().count() >= STEM_LEAST)
        .any(|stem| stems(b).any(|other| other == stem))
}

/// Whether the last vowel of a noun without an ending changes in the other form: `ů` is `o` there, and `e` is left out.
fn changes_stem(bare: &str, other: &str) -> bool {
    let mut letters = bare.char_indices().rev();
    let (Some((end, last)), Some((at, vowel))) = (letters.next(), letters.next()) else {
        return false;
    };
    let changed = match vowel {
        _ if VOWELS.contains(&last) => return false,
        'u' => "o",
        'e' => "",
        _ => return false,
    };
    let behind = other.strip_prefix(&bare[..at]);
    let ending = behind
        .and_then(|rest| rest.strip_prefix(changed))
        .and_then(|rest| rest.strip_prefix(&bare[end..]));
    ending.is_some_and(|ending| !ending.is_empty() && NOUN_ENDINGS.contains(&ending))
}

/// The endings of Czech adjectives.
const ENDINGS: [char; 4] = ['ý', 'á', 'é', 'í'];

/// A Czech adjective with each of the four endings, its own included; empty for any other word.
pub fn other_endings(word: &str) -> impl Iterator<Item = String> {
    let stem = word.strip_suffix(ENDINGS);
    let forms = stem.map(|stem| ENDINGS.map(|ending| format!("{stem}{ending}")));
    forms.into_iter().flatten()
}

/// Beginnings of words for a hole, without accents.
pub const HOLE: [&str; 14] = [
    "hole", "cavity", "cavities", "dira", "diry", "dire", "dirou", "dirami", "dera", "dery",
    "deru", "derou", "dutin", "otvor",
];

/// Beginnings of words for a floor, without accents.
pub const FLOOR: [&str; 4] = ["floor", "ground", "podlah", "zem"];

/// The words of a text in lower case and without accents. Digits and signs separate words.
pub fn of_text(text: &str) -> impl Iterator<Item = String> {
    let words = text.split(|c: char| !c.is_alphabetic());
    words.filter(|word| !word.is_empty()).map(plain)
}

/// Whether a word of the text begins with one of `beginnings`, accents left out.
pub fn has(text: &str, beginnings: &[&str]) -> bool {
    of_text(text).any(|word| beginnings.iter().any(|b| word.starts_with(b)))
}

/// Words of a comment that says what something is not, or is at another time, without accents.
const DENIALS: [&str; 54] = [
    "no", "not", "never", "none", "non", "neither", "nor", "isn", "isnt", "wasn", "wasnt", "won",
    "wont", "instead", "later", "then", "soon", "yet", "will", "todo", "fixme", "future", "was",
    "were", "ne", "neni", "nejsou", "nebyl", "nebyla", "nebylo", "nebude", "nikoli", "nikoliv",
    "nikdy", "ani", "misto", "zadny", "zadna", "zadne", "zadneho", "zatim", "jeste", "bude",
    "budou", "pozdeji", "pak", "potom", "casem", "priste", "brzy", "driv", "byl", "byla", "bylo",
];

/// Whether a text has a word of denial or of another time.
pub fn denies(text: &str) -> bool {
    of_text(text).any(|word| DENIALS.contains(&word.as_str()))
}

/// A word in lower case, without accents, and without spaces, hyphens, points, colons and quotation marks.
pub fn plain(word: &str) -> String {
    let letters = word.chars().flat_map(char::to_lowercase);
    letters
        .filter(|c| !matches!(c, '-' | '_' | ' ' | ':' | '.' | '„' | '“' | '"'))
        .map(|c| match c {
            'á' => 'a',
            'č' => 'c',
            'ď' => 'd',
            'é' | 'ě' => 'e',
            'í' => 'i',
            'ň' => 'n',
            'ó' => 'o',
            'ř' => 'r',
            'š' => 's',
            'ť' => 't',
            'ú' | 'ů' => 'u',
            'ý' => 'y',
            'ž' => 'z',
            c => c,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_in_both_languages() {
        let codes = |word: &str| types(word).iter().map(|t| t.code).collect::<Vec<_>>();
        assert_eq!(codes("Sphere"), [11, 9, 13]);
        assert_eq!(codes("kužel"), [16, 17]);
        assert_eq!(codes("point-light"), [-402]);
        assert_eq!(codes("sjednocení"), [-101]);
        assert_eq!(codes("shpere"), [11, 9, 13]);
        assert_eq!(codes("okolní světlo"), [-401]);
        assert_eq!(codes("dům"), [] as [i32; 0]);
    }

    #[test]
    fn shapes_in_other_forms() {
        let code = |word: &str| shapes(word).first().map(|ty| ty.code);
        let forms = [
            "kostky", "krychlí", "koule", "koulemi", "válce", "toru", "boxes", "spheres",
        ];
        let codes = [12, 12, 11, 11, 1, 14, 12, 11];
        assert_eq!(forms.map(code), codes.map(Some));
        assert_eq!(["union", "barva", "kos"].map(code), [None; 3]);
    }

    #[test]
    fn forms_of_one_noun() {
        let forms = |a: &str, b: &str| are_forms(&plain(a), &plain(b));
        for (a, b) in [
            ("dům", "dům"),
            ("dům", "domu"),
            ("domem", "dům"),
            ("domě", "domu"),
            ("stůl", "stolu"),
            ("nůž", "nože"),
            ("kůň", "koně"),
            ("zeď", "zdi"),
            ("okno", "okna"),
            ("oken", "okno"),
            ("dveře", "dveří"),
            ("dveřmi", "dveře"),
            ("domek", "domku"),
            ("lid", "lids"),
        ] {
            assert!(forms(a, b), "{a} {b}");
        }
        for (a, b) in [
            ("díl", "důl"),
            ("důl", "dílu"),
            ("dům", "dno"),
            ("dům", "důl"),
            ("koš", "kůň"),
            ("the", "the"),
            ("a", "a"),
            ("zeď", "zub"),
        ] {
            assert!(!forms(a, b), "{a} {b}");
        }
    }

    #[test]
    fn names_are_written_as_they_are_compared() {
        let all: Vec<_> = all().collect();
        for (i, (name, codes)) in all.iter().enumerate() {
            assert_eq!(plain(name), *name);
            assert!(
                codes
                    .iter()
                    .all(|&c| RecordType::by_code(c.into()).is_some())
            );
            assert!(all[..i].iter().all(|n| n.0 != *name), "{name} twice");
        }
    }
}

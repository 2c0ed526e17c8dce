//! What is generated from the record table: the tables of the language reference and the EBNF.
//! The tests beside it keep the files in `grammar/` up to date.

use std::fmt::Write as _;

use zpg::internals::diagnostics::{Code, Language};
use zpg::internals::syntax::table::{Family, Kind, Param, ParamKind, RECORD_TYPES, RecordType};

/// Starts a generated part, with a name and ` -->`.
const START: &str = "<!-- table:";
/// Ends one.
const END: &str = "<!-- end -->";

/// A text with everything between its markers (`<!-- table:shapes -->` to `<!-- end -->`) written
/// anew. The error says which marker is wrong.
pub fn fill(text: &str, language: Language) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(START) {
        let (name, _) = rest[at + START.len()..]
            .split_once(" -->")
            .ok_or("a marker does not end")?;
        let marker = &rest[at..at + START.len() + name.len() + " -->".len()];
        let table = table(name, language).ok_or_else(|| format!("there is no table `{name}`"))?;
        let end = rest[at..]
            .find(END)
            .ok_or_else(|| format!("table `{name}` does not end"))?;
        out.push_str(&rest[..at]);
        let _ = write!(out, "{marker}\n{table}{END}");
        rest = &rest[at + end + END.len()..];
    }
    out.push_str(rest);
    Ok(out)
}

/// The table of a family, by the slug of its title, or that of the diagnostics.
fn table(name: &str, language: Language) -> Option<String> {
    if name == "diagnostics" {
        return Some(diagnostics(language));
    }
    let slug = |f: &&Family| f.title().to_lowercase().replace(' ', "-") == name;
    Family::ALL.iter().find(slug).map(|&f| family(f, language))
}

fn family(family: Family, language: Language) -> String {
    let mut out = match language {
        Language::English => "| type | keyword | parameters | meaning | values |".to_owned(),
        Language::Czech => "| typ | jméno | parametry | význam | hodnoty |".to_owned(),
    };
    out += "\n|---:|---|---|---|---|\n";
    for ty in RECORD_TYPES.iter().filter(|t| t.family == family) {
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} {} | {} |",
            ty.code,
            names(ty, language),
            code(&ty.signature()),
            ty.summary(language),
            ty.effect_text(language),
            values(ty, language)
        );
    }
    out
}

/// The keyword, and in other languages the name before it.
fn names(ty: &RecordType, language: Language) -> String {
    match language {
        Language::English => format!("`{}`", ty.keyword),
        Language::Czech => format!("{}, `{}`", language.name(ty.title), ty.keyword),
    }
}

fn code(text: &str) -> String {
    match text {
        "" => String::new(),
        _ => format!("`{text}`"),
    }
}

/// What the parameters may be; neighbours with the same rule share it.
fn values(ty: &RecordType, language: Language) -> String {
    let mut groups: Vec<(Vec<&str>, String)> = Vec::new();
    for (_, p) in ty.described() {
        let rule = p.rule_text(language);
        match groups.last_mut() {
            Some((names, last)) if *last == rule => names.push(p.name),
            _ => groups.push((vec![p.name], rule)),
        }
    }
    let text: Vec<_> = groups
        .into_iter()
        .map(|(names, rule)| match names.as_slice() {
            [first, .., last] if names.len() > 3 => format!("`{first}` … `{last}`: {rule}"),
            names => format!("`{}`: {rule}", names.join(" ")),
        })
        .collect();
    text.join("; ")
}

fn diagnostics(language: Language) -> String {
    let mut out = match language {
        Language::English => "| code | name | what it does |".to_owned(),
        Language::Czech => "| kód | název | co hlásí |".to_owned(),
    };
    out += "\n|---|---|---|\n";
    for code in Code::ALL {
        let what = code
            .explanation(language)
            .split("\n\n")
            .nth(1)
            .unwrap_or("")
            .replace('\n', " ");
        let _ = writeln!(out, "| {} | {} | {what} |", code.as_str(), code.name());
    }
    out
}

/// What does not come from the table.
const LEXICAL: &str = r##"(* The ZPG scene language, version 1, in ISO 14977 EBNF. Generated from the record table.

   Between any two terminals of a record there may be white space, comments and line breaks, and
   between two numbers there must be something. A group marked with "× count" stands as often as
   the count says. Parameters in brackets are there when what follows can only be read so; where it
   can be read in both ways, they are there exactly when just as many are left on the line, which ends
   at a line break outside of a comment. EBNF can express neither. *)

scene = { record | void | comment } ;

(* The VOID record: an ID of 0 is a whole record. It introduces a comment. *)
void = "0" ;

comment = "#", { ? any character but "#" ? }, "#" ;

digit = "0" | "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" ;
sign = "+" | "-" ;
digits = digit, { digit } ;
integer = [ sign ], digits ;
real = [ sign ], ( digits, [ ".", { digit } ] | ".", digits ), [ ( "e" | "E" ), [ sign ], digits ] ;
count = integer ;
id = integer ; (* 1 to 2147483647 *)
none = "0" ;
file_name = ? a word without white space ? | '"', { ? any character but '"' and a line break ? }, '"' ;

(* IDs that records refer to, by what the ID must stand for. *)
"##;

/// The grammar in EBNF, a production for each record type.
pub fn ebnf() -> String {
    let mut out = String::from(LEXICAL);
    for kind in REFERENCED {
        let _ = writeln!(out, "{} = id ;", kind_name(kind));
    }
    let names: Vec<_> = RECORD_TYPES.iter().map(production_name).collect();
    let _ = write!(out, "\nrecord\n  = {}\n  ;\n", names.join("\n  | "));
    for family in Family::ALL {
        let _ = write!(out, "\n(* {} *)\n", family.title());
        for ty in RECORD_TYPES.iter().filter(|t| t.family == family) {
            let _ = writeln!(out, "{} = {} ;", production_name(ty), production(ty));
        }
    }
    out
}

/// The kinds that records refer to.
const REFERENCED: [Kind; 7] = [
    Kind::Object,
    Kind::Optics,
    Kind::Texture,
    Kind::Colour,
    Kind::AmbientLight,
    Kind::PointLight,
    Kind::Camera,
];

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Undefined => "undefined_id",
        Kind::Object => "object_id",
        Kind::Optics => "optics_id",
        Kind::Texture => "texture_id",
        Kind::Colour => "colour_id",
        Kind::AmbientLight => "ambient_light_id",
        Kind::PointLight => "point_light_id",
        Kind::Camera => "camera_id",
        Kind::Selection => "selection_id",
        Kind::Render => "render_id",
    }
}

fn production_name(ty: &RecordType) -> String {
    format!("{}_record", ty.keyword.replace('-', "_"))
}

fn production(ty: &RecordType) -> String {
    let id = if ty.family == Family::Render {
        "\"1\""
    } else {
        "id"
    };
    let mut parts = vec![id.to_owned(), format!("\"{}\"", ty.code)];
    parts.extend(sequence(ty.params));
    for group in ty.repeats {
        parts.push(format!(
            "{{ {} }} (* × count *)",
            sequence(group).join(", ")
        ));
    }
    if !ty.optional.is_empty() {
        parts.push(format!("[ {} ]", sequence(ty.optional).join(", ")));
    }
    parts.join(", ")
}

/// Parameters one after another, runs of the same as `3 * real`.
fn sequence(params: &[Param]) -> Vec<String> {
    let mut runs: Vec<(usize, String)> = Vec::new();
    for param in params {
        let value = value(param);
        match runs.last_mut() {
            Some((n, last)) if *last == value => *n += 1,
            _ => runs.push((1, value)),
        }
    }
    runs.into_iter()
        .map(|(n, value)| match n {
            1 => value,
            n => format!("{n} * {value}"),
        })
        .collect()
}

fn value(param: &Param) -> String {
    match param.kind {
        ParamKind::Real => "real".to_owned(),
        ParamKind::Integer => "integer".to_owned(),
        ParamKind::Count => "count".to_owned(),
        ParamKind::FileName => "file_name".to_owned(),
        ParamKind::Reference { kinds, or_none } => {
            let mut names: Vec<_> = kinds.iter().map(|&k| kind_name(k)).collect();
            names.extend(or_none.then_some("none"));
            match names.as_slice() {
                [one] => (*one).to_owned(),
                many => format!("( {} )", many.join(" | ")),
            }
        }
    }
}

#[test]
fn productions() {
    let of = |keyword| production(RecordType::by_keyword(keyword).unwrap());
    assert_eq!(of("sphere"), "id, \"11\", 4 * real");
    assert_eq!(
        of("checkerboard"),
        "id, \"-399\", 2 * integer, 2 * colour_id"
    );
    assert_eq!(of("hyperboloid"), "id, \"20\", [ 3 * real, integer ]");
    assert_eq!(
        of("assign"),
        "id, \"-299\", ( texture_id | colour_id | none ), ( optics_id | none )"
    );
}

#[test]
fn wrong_markers_are_named() {
    assert_eq!(
        fill("<!-- table:nonsense --><!-- end -->", Language::English).unwrap_err(),
        "there is no table `nonsense`"
    );
    assert_eq!(
        fill("<!-- table:lights -->", Language::English).unwrap_err(),
        "table `lights` does not end"
    );
    let filled = fill("a <!-- table:lights -->x<!-- end --> b", Language::English).unwrap();
    assert!(filled.starts_with("a <!-- table:lights -->\n| type |"));
    assert!(filled.ends_with("<!-- end --> b"));
    assert_eq!(fill(&filled, Language::English).unwrap(), filled);
}

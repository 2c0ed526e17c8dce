//! `zpg explain`: the page of a finding or of a record type.

use std::fmt::Write as _;
use std::io::{self, IsTerminal as _};

use super::page::{PageStyle, laid_out};
use super::topics::{self, Topic};
use super::{LookChoice, Status, complain, terminal};
use crate::diagnostics::layout::hanging;
use crate::diagnostics::{Code, Complaint, Language};
use crate::features::pages::{code_page, type_page};
use crate::lint::levels::Selector;
use crate::syntax::quote;
use crate::syntax::table::{RECORD_TYPES, RecordKind, RecordType};
use crate::syntax::words::{other_endings, plain};

/// Explain a finding or a record type
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Without an argument, all codes and record types are listed.

Examples:
  zpg explain E101            a finding by its code
  zpg explain undefined-id    … or by its name
  zpg explain W310 W305       several
  zpg explain W3              all codes that begin like this, in a list
  zpg explain -399            a record type by its number
  zpg explain checkerboard    … or by its keyword
  zpg explain glass           how to make glass, a mirror, a prism, a shadow")]
pub struct Args {
    /// A code or name of a finding, or a number, keyword or other name of a record type, of one word or several
    #[arg(value_name = "CODE|TYPE", allow_negative_numbers = true)]
    topic: Vec<String>,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    if args.topic.is_empty() {
        return terminal::print(look, Status::Clean, |out| {
            let index = index(look.language());
            let mut lines = index.lines().map(|line| hanging(line, terminal::width()));
            lines.try_for_each(|line| writeln!(out, "{line}"))
        });
    }
    let language = look.language();
    let (answers, unknown) = answers(&args.topic, language);
    let status = match unknown.is_empty() {
        true => Status::Clean,
        false => Status::Failure,
    };
    if answers.is_empty() {
        complain(look, &no_topic(&unknown, language));
        return status;
    }
    let stdout = io::stdout();
    let colour = look.colour(&stdout);
    let form = match colour || stdout.is_terminal() {
        true => PageStyle::Text { colour },
        false => PageStyle::Markdown,
    };
    let texts: Vec<String> = (answers.iter())
        .map(|answer| answer.text(form, language))
        .collect();
    let printed = terminal::print(look, status, |out| {
        out.write_all(texts.join("\n").as_bytes())
    });
    if !unknown.is_empty() {
        complain(look, &no_topic(&unknown, language));
    }
    printed
}

/// The answer about a topic.
enum Answer {
    Page(String),
    /// A list of codes.
    Codes(Selector),
}

impl Answer {
    fn of(topic: &str, language: Language) -> Option<Answer> {
        group(topic)
            .map(Answer::Codes)
            .or_else(|| page(topic, language).map(Answer::Page))
    }

    fn text(&self, form: PageStyle, language: Language) -> String {
        match self {
            Answer::Page(page) => laid_out(page, form, terminal::width()),
            Answer::Codes(group) => {
                let lines = group.codes().iter().map(|&c| line(c, language));
                let lines = lines.map(|line| hanging(&line, terminal::width()) + "\n");
                lines.collect()
            }
        }
    }
}

/// The answers to a topic of all the words, or to each of them, and what has none.
fn answers(words: &[String], language: Language) -> (Vec<Answer>, Vec<String>) {
    let whole = words.join(" ");
    if let Some(answer) = Answer::of(&whole, language) {
        return (vec![answer], Vec::new());
    }
    let mut answers = Vec::new();
    let mut unknown = Vec::new();
    for word in words {
        match Answer::of(word, language) {
            Some(answer) => answers.push(answer),
            None => unknown.push(word.clone()),
        }
    }
    // A name of several words may be misspelt.
    let is_code = |word: &String| Code::parse(word).is_some() || group(word).is_some();
    let are_apart = unknown.is_empty() || words.iter().any(is_code);
    if !are_apart && !near_names(&normalise(&whole), language).is_empty() {
        return (Vec::new(), vec![whole]);
    }
    match answers.is_empty() {
        true => (answers, vec![whole]),
        false => (answers, unknown),
    }
}

/// The complaint of topics that have no answer.
fn no_topic(unknown: &[String], language: Language) -> Complaint {
    let near = match unknown {
        [topic] => suggestions(topic, language),
        _ => Vec::new(),
    };
    let quoted: Vec<String> = unknown.iter().map(|topic| quote(topic)).collect();
    let complaint = Complaint::new(match near.is_empty() {
        true => "no-topic-list",
        false => "no-topic",
    });
    complaint.with("text", quoted.join(", ")).or_meant(near)
}

/// All topics, a line each.
fn index(language: Language) -> String {
    let mut index = String::new();
    for &code in Code::ALL {
        index += &line(code, language);
        index.push('\n');
    }
    index.push('\n');
    for ty in RECORD_TYPES {
        let name = match language {
            Language::English => ty.keyword.to_owned(),
            Language::Czech => language.name(ty.title),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(index, "{:>5}  {name}", ty.code);
    }
    index
}

/// A code in the list of all.
fn line(code: Code, language: Language) -> String {
    let title = match language {
        Language::English => String::new(),
        Language::Czech => first_sentence(code, language),
    };
    let line = format!("{:>5}  {:<24}  {title}", code.as_str(), code.name());
    line.trim_end().to_owned()
}

/// The codes that begin with a topic, such as `W3`.
fn group(topic: &str) -> Option<Selector> {
    let has_page = page(topic, Language::English).is_some();
    topic.trim().parse().ok().filter(|_| !has_page)
}

/// The first sentence of a page, in one line.
fn first_sentence(code: Code, language: Language) -> String {
    let page = code.explanation(language);
    let text = page.split("\n\n").nth(1).unwrap_or_default();
    let text = text.replace('\n', " ");
    let is_code = |at: usize| text[..at].matches('`').count() % 2 == 1;
    let ends = [". ", ": "]
        .into_iter()
        .flat_map(|end| text.match_indices(end));
    let ends = ends.map(|(at, _)| at).filter(|&at| !is_code(at));
    let end = ends.min().unwrap_or(text.len());
    text[..end].trim_end_matches('.').to_owned()
}

/// The page on a topic. An adjective may have any of its endings.
fn page(topic: &str, language: Language) -> Option<String> {
    let topic = normalise(topic);
    let others = || other_endings(&topic).find_map(|form| exact_page(form, language));
    exact_page(topic.clone(), language).or_else(others)
}

fn exact_page(topic: String, language: Language) -> Option<String> {
    if let Some(code) = Code::parse(&topic) {
        return Some(code_page(code, language));
    }
    if let Ok(number) = topic.parse::<i64>() {
        return Some(type_page(RecordType::by_code(number)?, language));
    }
    let is_named = |t: &&RecordType| names(t).any(|name| normalise(&name) == topic);
    let about = Topic::of(&topic);
    if let Some(ty) = RECORD_TYPES.iter().find(is_named) {
        let mut page = type_page(ty, language);
        if let Some(about) = about {
            let heading = language.say("explain-in-a-scene", &[]);
            page += &format!("\n## {heading}\n\n{}", about.text(language));
        }
        return Some(page);
    }
    // What people call it. A word may stand for several types.
    let types = topics::types(&topic);
    let list = |types: &[&RecordType]| {
        let one =
            |ty: &&RecordType| format!("{} (`zpg explain {}`)", language.name(ty.title), ty.code);
        let list: Vec<String> = types.iter().map(one).collect();
        language.say("explain-also", &[("list", list.join(", ").into())])
    };
    let word = topic.replace('-', " ");
    if let Some(about) = about {
        let (title, text) = (about.title(language), about.text(language).trim_end());
        let heading = match plain(title) == plain(&word) {
            true => title.to_owned(),
            false => format!("{word}: {title}"),
        };
        let also = match types.is_empty() {
            true => String::new(),
            false => format!("\n{}\n", list(&types)),
        };
        return Some(format!("# {heading}\n\n{text}\n{also}"));
    }
    let Some((ty, others)) = types.split_first() else {
        let help = topics::help(&topic, language)?;
        return Some(format!("# {word}\n\n{help}\n"));
    };
    let page = type_page(ty, language);
    // The page begins with the word that was looked for.
    let page = page.replacen("# ", &format!("# {word}: "), 1);
    Some(match others.is_empty() {
        true => page,
        false => format!("{}\n\n{}\n", page.trim_end(), list(others)),
    })
}

/// The names of a record type, in any language.
fn names(ty: &RecordType) -> impl Iterator<Item = String> {
    let titles = [Language::English, Language::Czech].map(|l| l.name(ty.title));
    [ty.keyword.to_owned()].into_iter().chain(titles)
}

/// Names are spelled in lower case with hyphens.
fn normalise(topic: &str) -> String {
    topic.trim().to_lowercase().replace([' ', '_'], "-")
}

/// The numbers that the handout prints for a type by mistake, each with that type.
const MISPRINTS: [(i64, RecordKind); 1] = [(-204, RecordKind::Assignment)];

/// How many names are suggested at most.
const MAX_SUGGESTIONS: usize = 3;

/// The names nearest to what was typed, nearest first.
fn suggestions(topic: &str, language: Language) -> Vec<String> {
    let topic = normalise(topic);
    if let Ok(number) = topic.parse::<i64>() {
        let misprint = MISPRINTS.iter().find(|m| m.0 == number || m.0 == -number);
        let misprinted = misprint.map(|m| RecordType::of(m.1));
        // Of a number without its minus nothing else is meant.
        if let Some(ty) = misprinted.or_else(|| RecordType::by_code(-number)) {
            return vec![ty.code.to_string()];
        }
    }
    let mut near = near_names(&topic, language);
    if near.is_empty() {
        // One word of several.
        let has_page = |word: &&str| page(word, language).is_some();
        let words = topic.split('-').filter(has_page);
        near.extend(words.map(str::to_owned));
    }
    near.truncate(MAX_SUGGESTIONS);
    near.into_iter()
        .map(|name| match Code::parse(&name) {
            Some(code) if code.name() != name => code.as_str().to_owned(),
            _ => name,
        })
        .collect()
}

/// The names that a topic may be a misspelling of, nearest first.
fn near_names(topic: &str, language: Language) -> Vec<String> {
    let allowed = (topic.chars().count() / 3).clamp(1, 3);
    let codes = Code::ALL
        .iter()
        .flat_map(|c| [c.as_str().to_lowercase(), c.name().to_owned()]);
    let types = RECORD_TYPES
        .iter()
        .flat_map(|t| [t.keyword.to_owned(), t.code.to_string()]);
    let czech = (RECORD_TYPES.iter()).filter_map(|t| match language {
        Language::English => None,
        Language::Czech => Some(normalise(&language.name(t.title))),
    });
    let other = topics::all().map(str::to_owned);
    let mut near: Vec<(usize, String)> = codes
        .chain(types)
        .chain(other)
        .chain(czech)
        .filter_map(|name| {
            let distance = strsim::damerau_levenshtein(&plain(topic), &plain(&name));
            // `light` is part of `point-light`.
            let part = topic.len() > 2 && name.split('-').any(|word| word == topic);
            // An ending of a word, as `lom` of `zlom`, is another word.
            if distance > 0 && !topic.contains('-') && plain(topic).ends_with(&plain(&name)) {
                return None;
            }
            // No number is a misspelt code.
            if topic.starts_with(char::is_alphabetic) && !name.contains(char::is_alphabetic) {
                return None;
            }
            (distance <= allowed || part).then_some((if part { 1 } else { distance }, name))
        })
        .collect();
    // Of names that are the same without accents, one is enough: the one that has them.
    near.sort_by_cached_key(|(distance, name)| {
        (*distance, plain(name), name.is_ascii(), name.clone())
    });
    near.dedup_by(|a, b| plain(&a.1) == plain(&b.1));
    let nearest = near.first().map_or(0, |n| n.0);
    near.retain(|n| n.0 <= nearest + 1);
    near.into_iter().map(|(_, name)| name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn topics_have_several_names() {
        for topic in ["E101", "e101", "undefined-id", "Undefined ID"] {
            assert!(
                page(topic, Language::English)
                    .unwrap()
                    .starts_with("# undefined-id (E101)")
            );
        }
        for topic in ["-402", "point-light", "point light", "bodové světlo"] {
            let page = page(topic, Language::English);
            assert!(page.unwrap().starts_with("# point light (-402)"));
        }
        let page_of_a_ball = page("Koule", Language::Czech).unwrap();
        assert!(page_of_a_ball.starts_with("# koule (11)"));
        assert!(page("-400", Language::English).is_none());
    }

    /// Words for things, those of the handout first.
    #[test]
    fn words_have_pages() {
        for (word, codes) in [
            ("posuv", &["-1"][..]),
            ("anuloid", &["14"]),
            ("krychle", &["12"]),
            ("Kamera stereo", &["-503"]),
            ("textura obrazová", &["-301"]),
            ("Válcová plocha parabolická", &["18"]),
            ("koule v obecne poloze", &["11"]),
            ("cylinder", &["1"]),
            ("válec", &["1"]),
            ("look at", &["-501"]),
            ("light", &["-402", "-401"]),
            ("kostka", &["12"]),
            ("krabice", &["12"]),
            ("díra", &["-103"]),
            ("otvor", &["-103"]),
            ("úhel", &["-2", "-501"]),
            ("view", &["-501", "-502"]),
            ("paraboloid", &["15", "21"]),
            ("ořez", &["-102", "-103", "4"]),
            ("ořezání", &["-102", "-103", "4"]),
            ("levé oko", &["-503"]),
            ("bodová", &["-402"]),
        ] {
            let page = page(word, Language::English).expect(word);
            assert!(
                page.lines()
                    .next()
                    .unwrap()
                    .ends_with(&format!("({})", codes[0])),
                "{word}"
            );
            for code in &codes[1..] {
                assert!(
                    page.contains("See also: ") && page.contains(&format!("zpg explain {code}")),
                    "{word}"
                );
            }
        }
    }

    /// Each term of the glossary leads somewhere, in both languages; so do the meanings of parameters.
    #[test]
    fn terms_of_the_glossary_have_pages() {
        let rows = include_str!("../../docs/glossary.cs.md").lines();
        let mut count = 0;
        for row in rows.filter(|row| row.starts_with("| ")) {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            if cells[1] == "anglicky" {
                continue;
            }
            for term in cells[1..3].iter().flat_map(|cell| cell.split(", ")) {
                let is_found = page(term, Language::Czech).is_some();
                assert!(is_found || group(term).is_some(), "{term}");
                count += 1;
            }
        }
        assert!(count > 200);
        for (word, code) in [
            ("zorný úhel", "-501"),
            ("směr pohledu", "-501"),
            ("vektor nahoru", "-501"),
            ("otočit", "-2"),
            ("posunout", "-1"),
            ("the tube's radius", "14"),
            ("intensity", "-402"),
            ("stínování", "-201"),
            ("gluLookAt", "-501"),
        ] {
            let page = page(word, Language::Czech).expect(word);
            let heading = page.lines().next().unwrap_or_default();
            let is_also = page.contains(&format!("zpg explain {code}`"));
            assert!(heading.ends_with(&format!("({code})")) || is_also, "{page}");
        }
        let ray = page("paprsek", Language::Czech).expect("a page");
        assert!(ray.contains("`zpg probe --help`"), "{ray}");
    }

    /// Topics have pages of their own, which begin with the word and show a scene that does it.
    #[test]
    fn topics_have_scenes() {
        let (english, czech) = (Language::English, Language::Czech);
        for (word, language, heading, codes) in [
            ("glass", english, "# glass", &["-201", "-203"][..]),
            ("sklo", czech, "# sklo", &["-201", "-203"]),
            ("sklo", english, "# sklo: glass", &["-203"]),
            ("průhledné", czech, "# průhledný: sklo", &["-201"]),
            ("průsvitná", czech, "# průsvitný: sklo", &["-201"]),
            ("mirror", english, "# mirror", &["-201"]),
            ("prism", english, "# prism", &["-102"]),
            ("hranol", czech, "# hranol", &["-102"]),
            ("shadow", english, "# shadow", &["-402"]),
            ("stin", czech, "# stín", &["-402"]),
            ("jehlan", czech, "# jehlan", &["-102", "4"]),
            ("phong", english, "# phong: highlight", &["-201"]),
            ("circle", english, "# circle: disk", &["1"]),
            ("mlha", czech, "# mlha", &["-201"]),
            ("komentář", czech, "# komentář", &[]),
        ] {
            let page = page(word, language).expect(word);
            assert_eq!(page.lines().next(), Some(heading));
            assert!(page.contains("```zpg\n"), "{page}");
            for code in codes {
                assert!(page.contains(&format!("zpg explain {code}`")), "{page}");
            }
        }
        let glass = page("glass", english).unwrap().replace('\n', " ");
        assert!(glass.contains("water 1.33"), "{glass}");
        // A type with such a page has both.
        for word in ["checkerboard", "šachovnice"] {
            let page = page(word, czech).unwrap();
            assert!(page.starts_with("# šachovnice (-399)") && page.contains("```zpg\n"));
        }
        let lathe = page("lathe", english).unwrap();
        assert!(lathe.starts_with("# lathe: surface of revolution (1)"));
    }

    #[test]
    fn several_topics_and_groups() {
        let english = Language::English;
        let told = |topics: &[&str]| {
            let topics: Vec<String> = topics.iter().map(|t| (*t).to_owned()).collect();
            let (answers, unknown) = answers(&topics, english);
            let headings: Vec<String> = (answers.iter())
                .map(|a| a.text(PageStyle::Markdown, english))
                .map(|text| text.lines().next().unwrap_or_default().to_owned())
                .collect();
            (headings, unknown.join("|"))
        };
        let first = " W301  colour-out-of-range";
        for (topics, headings, unknown) in [
            (
                &["W310", "torus", "-399"][..],
                &[
                    "# unused-definition (W310)",
                    "# torus (14)",
                    "# checkerboard (-399)",
                ][..],
                "",
            ),
            (&["W3", "W305"], &[first, "# degenerate-shape (W305)"], ""),
            (
                &["W310", "nothing"],
                &["# unused-definition (W310)"],
                "nothing",
            ),
            (&["foo", "torus", "bar"], &["# torus (14)"], "foo|bar"),
            // A misspelt name, and words of none.
            (&["point", "ligth"], &[], "point ligth"),
            (&["foo", "bar"], &[], "foo bar"),
        ] {
            let expected = headings.iter().map(|h| (*h).to_owned()).collect();
            assert_eq!(told(topics), (expected, unknown.to_owned()));
        }
        let codes = group("n60").unwrap();
        assert!(codes.codes().contains(&Code::N601) && !codes.holds(Code::S501));
        for topic in ["W310", "torus", "light", "nothing", ""] {
            assert!(group(topic).is_none(), "{topic}");
        }
    }

    #[test]
    fn what_was_meant() {
        for (number, code) in [("203", "-203"), ("402", "-402"), ("501", "-501")] {
            assert_eq!(suggestions(number, Language::English), [code]);
        }
        // As `docs/handout.md` says of `4 -204 0 35`.
        for number in ["-204", "204"] {
            assert_eq!(suggestions(number, Language::Czech), ["-299"]);
        }
        assert_eq!(
            suggestions("chekerboard", Language::English),
            ["checkerboard"]
        );
        assert_eq!(suggestions("lights", Language::English), ["light"]);
        assert_eq!(suggestions("area light", Language::English), ["light"]);
        assert_eq!(suggestions("soft shadow", Language::English), ["shadow"]);
        assert_eq!(suggestions("e0001", Language::English), ["E001"]);
        assert!(suggestions("zlom", Language::Czech).is_empty());
        assert_eq!(suggestions("sachovnice", Language::Czech), ["šachovnice"]);
        assert!(suggestions("quite something else", Language::English).is_empty());
        assert!(!suggestions("W999", Language::English).contains(&"9999".to_owned()));
    }

    #[test]
    fn a_page_of_a_record_type() {
        insta::assert_snapshot!(page("torus", Language::English).unwrap(), @r#"
        # torus (14)

        Shapes; keyword `torus`. Defines an object.

            ID 14 R r

        Solid: a torus around the y axis. A tube wider than R is allowed; the inside follows the even-odd rule.

        ## Parameters

            R  the distance from the centre to the tube's centre  number, scene units, > 0
            r  the tube's radius                                  number, scene units, > 0

        ## Example

            2 14 1 0.25
        "#);
        insta::assert_snapshot!(page("2", Language::English).unwrap(), @r#"
        # coloured surface of revolution (2)

        Shapes; keyword `coloured-surface-of-revolution`. Defines an object.

            ID 2 N (x y)×N (r g b)×N

        As type 1, with a colour for each profile point; between points the colour is linear.

        ## Parameters

            N  the number of profile points              integer, a count, ≥ 2
          then N times:
            x  a profile point's distance from the axis  number, scene units, ≥ 0
            y  a profile point's height                  number, scene units
          then N times again:
            r  the red part                              number
            g  the green part                            number
            b  the blue part                             number

        ## Example

            2 2 2  0 1  1 0  1 0 0  0 0 1
        "#);
    }

    #[test]
    fn every_topic_has_a_page() {
        for code in Code::ALL {
            for language in [Language::English, Language::Czech] {
                let page = code_page(*code, language);
                assert!(page.lines().count() > 10, "{}", code.as_str());
            }
        }
        for ty in RECORD_TYPES {
            assert!(type_page(ty, Language::English).contains(ty.example));
            let czech = type_page(ty, Language::Czech);
            assert!(czech.contains(ty.example) && !czech.contains(ty.summary));
        }
    }
}

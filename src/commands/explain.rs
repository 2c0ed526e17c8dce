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
use crate::lint::spelling::linear_part;
use crate::syntax::table::{RECORD_TYPES, RecordKind, RecordType};
use crate::syntax::words::{other_endings, plain};
use crate::syntax::{colour_names, quote};

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
            .or_else(|| {
                let code = topics::code(topic)?;
                Some(Answer::Page(code_page(code, language)))
            })
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

/// The answer to all words as one topic, or else the answers to each of them. The second list has the words without an
/// answer.
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

/// The complaint about topics that have no answer.
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

/// The line about a code in a list of codes. In Czech it has the first sentence of the code's page.
fn line(code: Code, language: Language) -> String {
    let title = match language {
        Language::English => String::new(),
        Language::Czech => first_sentence(code, language),
    };
    let line = format!("{:>5}  {:<24}  {title}", code.as_str(), code.name());
    line.trim_end().to_owned()
}

/// The codes that begin with a topic such as `W3`. `None` if there are none, or if the topic has a page of its own.
fn group(topic: &str) -> Option<Selector> {
    let has_page = page(topic, Language::English).is_some();
    topic.trim().parse().ok().filter(|_| !has_page)
}

/// The first sentence of a code's page, in one line.
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

/// The page on a topic. A Czech adjective may have any of its endings.
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
    let is_named = |t: &&RecordType| names(t).any(|name| plain(&name) == plain(&topic));
    let about = Topic::of(&topic);
    if let Some(ty) = RECORD_TYPES.iter().find(is_named) {
        let mut page = type_page(ty, language);
        if let Some(about) = about {
            let heading = language.say("explain-in-a-scene", &[]);
            page += &format!("\n## {heading}\n\n{}", about.text(language));
        }
        return Some(page);
    }
    // The word may be another name that people use, and such a word may stand for several types.
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
        let help = topics::help(&topic, language).or_else(|| colour(&topic, language))?;
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

/// The numbers of a colour with that name, and the record that has them.
fn colour(name: &str, language: Language) -> Option<String> {
    let numbers = colour_names::exact(name)?.map(linear_part).join(" ");
    let ty = RecordType::of(RecordKind::Colour);
    let record = quote(&format!("ID {} {numbers}", ty.code));
    let values = [
        ("number", quote(&numbers).into()),
        ("text", record.into()),
        ("code", ty.code.to_string().into()),
    ];
    Some(language.say("explain-colour", &values))
}

/// The names of a record type, in any language.
fn names(ty: &RecordType) -> impl Iterator<Item = String> {
    let titles = [Language::English, Language::Czech].map(|l| l.name(ty.title));
    [ty.keyword.to_owned()].into_iter().chain(titles)
}

/// The topic as names are spelled: in lower case, with hyphens.
fn normalise(topic: &str) -> String {
    topic.trim().to_lowercase().replace([' ', '_'], "-")
}

/// The numbers that the handout prints for a type by mistake, each with the type that is meant.
const MISPRINTS: [(i64, RecordKind); 1] = [(-204, RecordKind::Assignment)];

/// How many names are suggested at most.
const MAX_SUGGESTIONS: usize = 3;

/// The names nearest to what was typed, nearest first.
fn suggestions(topic: &str, language: Language) -> Vec<String> {
    let topic = normalise(topic);
    if let Ok(number) = topic.parse::<i64>() {
        let misprint = MISPRINTS.iter().find(|m| m.0 == number || m.0 == -number);
        let misprinted = misprint.map(|m| RecordType::of(m.1));
        // A number without its minus leaves no doubt: nothing else is suggested.
        if let Some(ty) = misprinted.or_else(|| RecordType::by_code(-number)) {
            return vec![ty.code.to_string()];
        }
    }
    let mut near = near_names(&topic, language);
    if near.is_empty() {
        // One word of several may have a page.
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
            // A name that is the end of the topic, as `lom` is of `zlom`, is another word.
            if distance > 0 && !topic.contains('-') && plain(topic).ends_with(&plain(&name)) {
                return None;
            }
            // A topic that begins with a letter is no misspelt number.
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
mod tests;

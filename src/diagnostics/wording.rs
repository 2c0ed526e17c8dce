//! The texts of findings.
//!
//! The words stand in catalogues, a file a language, in the form of [Project Fluent](https://projectfluent.org):
//! `messages/en.ftl` and `messages/cs.ftl`, and files of these names in the folders of lint rules. The name of a
//! finding's message is its code and, if the code has several messages, the case. The attributes of the message are the
//! label at the primary place, a note, help, and others that a rule names. A *phrase* is the name of an attribute of
//! the finding's own message, or of a message that several findings share.
//!
//! A [`Value`] fills a placeholder of a message. Names of things of the scene language (types of records, parameters,
//! kinds) are *terms*: a catalogue translates them as `term-…` and may give other forms as attributes. A term in the
//! placeholder `$shape` also fills `$shape-FORM` for each of these forms, in English `$shape-a`, the name with its
//! article.

use std::borrow::Cow;
use std::path::Path;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};

use fluent_syntax::ast::Pattern;

use super::code::Code;
use super::complaint::Complaint;
use super::diagnostic::Diagnostic;
use super::language::Language;

/// A value for a placeholder of a message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Value {
    /// A text that stays unchanged: the user's own, or numbers as they are spelled.
    Text(Cow<'static, str>),
    /// A number that was measured or computed, with a decimal point, which each language writes in its own way. Numbers
    /// of the scene and of commands are text.
    Decimal(String),
    /// A number of things; the words around it agree with it.
    Count(u64),
    /// A name of the scene language, in English.
    Term(&'static str),
    /// Alternative names: "an object or a camera".
    OneOf(Vec<&'static str>),
    /// Phrases one after the other: "it mirrors, and its columns are not at right angles".
    Phrases(Vec<&'static str>),
    /// Another message, with its own values.
    Said(Box<Complaint>),
}

impl From<String> for Value {
    fn from(text: String) -> Value {
        Value::Text(Cow::Owned(text))
    }
}

impl From<&'static str> for Value {
    fn from(text: &'static str) -> Value {
        Value::Text(Cow::Borrowed(text))
    }
}

impl From<&Path> for Value {
    fn from(path: &Path) -> Value {
        // Control characters in a file's name could move the cursor of a terminal.
        path.to_string_lossy()
            .replace(char::is_control, "\u{fffd}")
            .into()
    }
}

/// The name of the note that explains a finding by a number with a leading zero.
pub const EXPLAINED: &str = "leading-zero";

/// The texts of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wording {
    pub message: String,
    /// The text at the primary place; "here" when the message says it all.
    pub label: String,
    /// The texts of the labels, in their order.
    pub labels: Vec<String>,
    pub notes: Vec<String>,
    pub help: Option<String>,
    /// The title of each fix.
    pub fixes: Vec<String>,
}

impl Diagnostic {
    /// The finding in words.
    pub fn wording(&self, language: Language) -> Wording {
        let own = match self.case {
            "" => Cow::Borrowed(self.code.as_str()),
            case => Cow::Owned(format!("{}-{case}", self.code.as_str())),
        };
        let speaker = Speaker::new(language, own).filled(language, &self.values);
        let own = |name: &str| speaker.attribute(name);
        let message = speaker.message(&speaker.own);
        Wording {
            message: match &self.at {
                Some(at) => format!("{at}: {message}"),
                None => message,
            },
            label: own("label").unwrap_or_else(|| speaker.message("here")),
            labels: (self.labels.iter())
                .map(|l| speaker.phrase(l.phrase))
                .collect(),
            notes: (own("note").into_iter())
                .chain(self.notes.iter().map(|n| speaker.phrase(n)))
                .collect(),
            // A finding that such a number explains needs no other help.
            help: own("help").filter(|_| !self.notes.contains(&EXPLAINED)),
            fixes: (self.fixes.iter())
                .map(|f| match f.values.is_empty() {
                    true => speaker.phrase(f.title),
                    false => Speaker::new(language, speaker.own.clone())
                        .filled(language, &self.values)
                        .filled(language, &f.values)
                        .phrase(f.title),
                })
                .collect(),
        }
    }
}

impl Language {
    /// A number with a decimal point, written with the decimal sign of the language.
    pub fn decimal(self, number: String) -> String {
        match self {
            Language::English => number,
            Language::Czech => number.replace('.', ","),
        }
    }

    /// The text of a message that belongs to no finding.
    pub fn say(self, message: &'static str, values: &[(&'static str, Value)]) -> String {
        let speaker = Speaker::new(self, Cow::Borrowed(message)).filled(self, values);
        speaker.message(message)
    }

    /// A name of the scene language in this language.
    pub fn name(self, name: &'static str) -> String {
        term(self, name)
    }

    /// A name of the scene language in a form that this language's catalogue has; in English always with its article.
    pub fn form(self, name: &'static str, form: &str) -> String {
        match self {
            Language::English => with_article(name),
            Language::Czech => {
                let own = self.own(&term_id(name), Some(form));
                own.unwrap_or_else(|| term(self, name))
            }
        }
    }

    /// The text of a message that only some languages have, or of an attribute of it; `None` if this language does not
    /// have it. English has these texts elsewhere: in the table of records, with the commands.
    pub fn own(self, message: &str, attribute: Option<&str>) -> Option<String> {
        let message = self.catalogue().get_message(message)?;
        let pattern = match attribute {
            Some(name) => message.get_attribute(name)?.value(),
            None => message.value()?,
        };
        Some(plain(self, pattern))
    }

    fn catalogue(self) -> &'static Catalogue {
        static ALL: [OnceLock<Catalogue>; 2] = [const { OnceLock::new() }; 2];
        ALL[self as usize].get_or_init(|| {
            let texts = self.sources();
            let mut bundle = FluentBundle::new_concurrent(self.tag().parse().into_iter().collect());
            // Values get no marks of direction around them: everything is read from left to right.
            bundle.set_use_isolating(false);
            let rules = Code::ALL.iter().filter_map(|code| code.messages());
            let rules = rules.map(|messages| messages[self as usize]);
            for text in texts.iter().copied().chain(rules) {
                // Faulty entries of a catalogue are left out; tests look for them.
                let resource = FluentResource::try_new(text.to_owned()).unwrap_or_else(|e| e.0);
                let _ = bundle.add_resource(resource);
            }
            bundle
        })
    }

    /// The message files of the language.
    fn sources(self) -> &'static [&'static str] {
        match self {
            Language::English => &[
                include_str!("messages/en.ftl"),
                include_str!("messages/complaints.en.ftl"),
                include_str!("messages/answers.en.ftl"),
                include_str!("../study/accuracy/en.ftl"),
                include_str!("../translate/en.ftl"),
            ],
            Language::Czech => &[
                include_str!("messages/cs.ftl"),
                include_str!("messages/complaints.cs.ftl"),
                include_str!("messages/answers.cs.ftl"),
                include_str!("../study/accuracy/cs.ftl"),
                include_str!("../translate/cs.ftl"),
                include_str!("messages/terms.cs.ftl"),
                include_str!("messages/phrases.cs.ftl"),
                include_str!("messages/summaries.cs.ftl"),
                include_str!("../commands/help.cs.ftl"),
            ],
        }
    }
}

type Catalogue = FluentBundle<FluentResource>;

/// A message in the catalogue of a language, with the values of its placeholders.
struct Speaker<'a> {
    catalogue: &'static Catalogue,
    own: Cow<'static, str>,
    arguments: FluentArgs<'a>,
}

impl<'a> Speaker<'a> {
    fn new(language: Language, own: Cow<'static, str>) -> Self {
        Speaker {
            catalogue: language.catalogue(),
            own,
            arguments: FluentArgs::new(),
        }
    }

    fn filled(mut self, language: Language, values: &'a [(&'static str, Value)]) -> Self {
        for (place, value) in values {
            let value = match value {
                Value::Text(text) => FluentValue::from(text.as_ref()),
                Value::Count(n) => FluentValue::from(*n),
                Value::Term(name) => {
                    for (form, text) in forms(language, name) {
                        self.arguments.set(format!("{place}-{form}"), text);
                    }
                    term(language, name).into()
                }
                Value::OneOf(names) => one_of(language, names).into(),
                Value::Said(inner) => inner.wording(language).into(),
                Value::Decimal(number) => language.decimal(number.clone()).into(),
                // Phrases may have placeholders themselves, which are filled once all values are known.
                Value::Phrases(_) => continue,
            };
            self.arguments.set(*place, value);
        }
        for (place, value) in values {
            if let Value::Phrases(names) = value {
                let phrases: Vec<String> = names.iter().map(|n| self.phrase(n)).collect();
                let all = phrases.into_iter().reduce(|first, last| {
                    language.say(
                        "list-clauses",
                        &[("first", first.into()), ("last", last.into())],
                    )
                });
                self.arguments.set(*place, all.unwrap_or_default());
            }
        }
        self
    }

    /// The text of a phrase: an attribute of the finding's own message, or a message that several findings share.
    fn phrase(&self, name: &str) -> String {
        self.attribute(name).unwrap_or_else(|| self.message(name))
    }

    fn attribute(&self, name: &str) -> Option<String> {
        let message = self.catalogue.get_message(&self.own)?;
        let pattern = message.get_attribute(name)?.value();
        Some(self.format(pattern))
    }

    /// The text of a message. A missing message is replaced by its name; tests see to it that none is missing.
    fn message(&self, id: &str) -> String {
        let pattern = self.catalogue.get_message(id).and_then(|m| m.value());
        debug_assert!(pattern.is_some(), "there is no message {id}");
        pattern.map_or_else(|| id.to_owned(), |p| self.format(p))
    }

    fn format(&self, pattern: &Pattern<&str>) -> String {
        let mut errors = Vec::new();
        let text = self
            .catalogue
            .format_pattern(pattern, Some(&self.arguments), &mut errors);
        debug_assert!(errors.is_empty(), "{}: {errors:?}", self.own);
        ids_behind_nouns(text.into_owned())
    }
}

/// A name of the scene language in a language of messages.
fn term(language: Language, name: &'static str) -> String {
    if name.is_empty() {
        return String::new();
    }
    let message = match language {
        Language::English => None,
        Language::Czech => language.catalogue().get_message(&term_id(name)),
    };
    match message.and_then(|m| m.value()) {
        Some(pattern) => plain(language, pattern),
        None => {
            debug_assert!(language == Language::English, "{name} is not translated");
            name.to_owned()
        }
    }
}

/// Further forms of a name, each with its name: with a capital for the beginning of a sentence, and those of the
/// catalogue.
fn forms(language: Language, name: &'static str) -> Vec<(&'static str, String)> {
    let mut forms = vec![("capital", capitalised(&term(language, name)))];
    match language {
        Language::English => forms.push(("a", with_article(name))),
        Language::Czech => {
            if let Some(message) = language.catalogue().get_message(&term_id(name)) {
                let own = message.attributes();
                forms.extend(own.map(|a| (a.id(), plain(language, a.value()))));
            }
        }
    }
    forms
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().into_iter().flat_map(char::to_uppercase);
    first.chain(chars.as_str().chars()).collect()
}

/// The ends of Czech names of shapes that go on behind their noun. An ID behind the whole name would read as a part of
/// what follows the noun.
const LONG_NAMES: [&str; 3] = [
    "oule se středem v počátku ",
    "rojúhelník s normálou ",
    "rojúhelník s normálami ve vrcholech ",
];

/// Moves the IDs of these shapes right behind their nouns: `koule 2 se středem v počátku`.
fn ids_behind_nouns(mut text: String) -> String {
    for name in LONG_NAMES {
        let mut from = 0;
        while let Some(at) = text[from..].find(name).map(|at| from + at) {
            let end = at + name.len();
            let digits = text[end..].bytes().take_while(u8::is_ascii_digit).count();
            if let (Some((noun, rest)), 1..) = (name.split_once(' '), digits) {
                let id = text[end..end + digits].to_owned();
                text.replace_range(
                    at..end + digits,
                    &format!("{noun} {id} {}", rest.trim_end()),
                );
            }
            from = end + digits.min(1);
        }
    }
    text
}

fn plain(language: Language, pattern: &Pattern<&str>) -> String {
    let text = language
        .catalogue()
        .format_pattern(pattern, None, &mut Vec::new());
    text.into_owned()
}

fn one_of(language: Language, names: &[&'static str]) -> String {
    let name = |n: &&'static str| match language {
        Language::English => with_article(n),
        Language::Czech => term(language, n),
    };
    match names.split_last() {
        Some((last, rest @ [_, ..])) => {
            let rest: Vec<String> = rest.iter().map(name).collect();
            let values = [
                ("first", rest.join(", ").into()),
                ("last", name(last).into()),
            ];
            language.say("list-or", &values)
        }
        Some((last, [])) => name(last),
        None => String::new(),
    }
}

/// The name of the message that translates a name: `term-` and the name's letters and digits.
fn term_id(name: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric());
    words
        .filter(|w| !w.is_empty())
        .fold("term".to_owned(), |id, word| {
            id + "-" + &word.to_lowercase()
        })
}

/// An English name with its article: "a sphere", "an ellipsoid", "the render record", "an EXR".
pub fn with_article(name: &str) -> String {
    let word = name.split(' ').next().unwrap_or_default();
    let vowel = if word
        .chars()
        .take(2)
        .all(|c| c.is_ascii_uppercase() || c.is_ascii_digit())
    {
        // Capitals are spelled out: PNG, SQLite.
        name.starts_with(|c| "AEFHILMNORSX8".contains(c))
    } else {
        // "a union", but "an undefined object".
        name.starts_with(['a', 'e', 'i', 'o', 'A', 'E', 'I', 'O'])
            || name.starts_with("un") && !name.starts_with("uni")
    };
    match () {
        _ if name.starts_with("the ") => name.to_owned(),
        _ if vowel => format!("an {name}"),
        _ => format!("a {name}"),
    }
}

//! Numbers of a scene, which are found by name and given other values.
//!
//! The name of a number is the ID of its record and the name of its parameter, as hints show it: `9.fovy`. A number of
//! a list has its index behind it, from 1 on: `5.x[3]`. Where several records with an ID have a parameter of that name,
//! the line of the record is given: `5@7.x`.

use std::fmt;
use std::str::FromStr;

use super::Analysis;
use crate::diagnostics::{Complaint, Edit, SourceFile, Span, fixes};
use crate::lint::spelling::spelled;
use crate::syntax::table::{Param, ParamKind};
use crate::syntax::{Item, Record};

/// The name of a number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    id: u32,
    /// The line that the record begins on, from 1.
    line: Option<u32>,
    parameter: String,
    /// The index in a list, from 1.
    place: Option<usize>,
}

impl FromStr for Name {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Name, Complaint> {
        let wrong = || Complaint::new("expected-parameter").with("text", text.to_owned());
        let (record, rest) = text.split_once('.').ok_or_else(wrong)?;
        let (id, line) = match record.split_once('@') {
            Some((id, line)) => (id, Some(line)),
            None => (record, None),
        };
        let (parameter, place) = match rest.split_once('[') {
            Some((parameter, place)) => {
                (parameter, Some(place.strip_suffix(']').ok_or_else(wrong)?))
            }
            None => (rest, None),
        };
        let place = place.map(str::parse).transpose();
        let line = line.map(str::parse).transpose();
        match (id.parse(), line, place) {
            (Ok(id), Ok(line), Ok(place)) if id > 0 && is_word(parameter) => Ok(Name {
                id,
                line,
                parameter: parameter.to_owned(),
                place,
            }),
            _ => Err(wrong()),
        }
    }
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_alphanumeric())
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.id)?;
        if let Some(line) = self.line {
            write!(f, "@{line}")?;
        }
        write!(f, ".{}", self.parameter)?;
        match self.place {
            Some(place) => write!(f, "[{place}]"),
            None => Ok(()),
        }
    }
}

/// A number in the text of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number {
    /// The name of the parameter in messages.
    pub name: String,
    pub span: Span,
    /// Index of the value in [`Document::values`](crate::syntax::Document::values).
    at: usize,
}

impl Number {
    /// Finds the number with a name.
    ///
    /// # Errors
    ///
    /// No number has this name, several have it, or the parameter must be a whole number, which cannot vary.
    pub fn named(analysis: &Analysis, name: &Name) -> Result<Number, Complaint> {
        let say = |message| Complaint::new(message).with("name", name.to_string());
        let line = |record: &Record| {
            let start = analysis.document.id_token(record).start;
            analysis.source.position(start).line
        };
        let all = records_of(analysis, name.id);
        let id = name.id.to_string();
        if all.is_empty() {
            return Err(Complaint::new("no-record-of-id").with("id", id));
        }
        let is_meant = |r: &&Record| name.line.is_none_or(|meant| meant == line(r));
        let meant: Vec<&Record> = all.iter().copied().filter(is_meant).collect();
        if meant.is_empty() {
            let lines = listed(all.iter().map(|r| line(r).to_string()));
            return Err(say("no-record-on-line").with("lines", lines));
        }
        let mut having = meant.clone();
        having.retain(|r| !places(r, &name.parameter).is_empty());
        // An index says that a list is meant.
        if name.place.is_some() && having.iter().any(|r| is_list(r, &name.parameter)) {
            having.retain(|r| is_list(r, &name.parameter));
        }
        let record = match having[..] {
            [record] => record,
            [] => {
                let of = |params: fn(&Record) -> Vec<&'static Param>| {
                    let params = meant.iter().flat_map(move |r| params(r));
                    params.filter(|p| p.kind == ParamKind::Real).map(|p| p.name)
                };
                if of(|r| r.ty().optional.iter().collect()).any(|p| p == name.parameter) {
                    return Err(say("parameter-left-out"));
                }
                let mut known: Vec<String> = Vec::new();
                for param in of(|r| written(r).map(|(_, param)| param).collect()) {
                    if known.iter().all(|k| k != param) {
                        known.push(param.to_owned());
                    }
                }
                return Err(match known.is_empty() {
                    true => Complaint::new("no-parameters").with("id", id),
                    false => (say("no-such-parameter").with("id", id)).with("known", listed(known)),
                });
            }
            ref several => {
                let one = |r: &&Record| {
                    let line = Some(line(r));
                    Name {
                        line,
                        ..name.clone()
                    }
                    .to_string()
                };
                let names = listed(several.iter().map(one));
                return Err(say("several-parameters").with("names", names));
            }
        };
        let places = places(record, &name.parameter);
        let is_list = is_list(record, &name.parameter);
        let at = match (name.place, is_list) {
            (Some(_), false) => return Err(say("parameter-no-list")),
            (Some(place), true) => place.checked_sub(1).and_then(|at| places.get(at)),
            (None, false) => places.first(),
            (None, true) => None,
        };
        let Some(&at) = at else {
            let one = |place| {
                Name {
                    place: Some(place),
                    ..name.clone()
                }
                .to_string()
            };
            let range = say("parameter-is-list").with("first", one(1));
            return Err(range.with("last", one(places.len())));
        };
        let param = record.ty().param(at, record.count());
        if param.is_none_or(|p| p.kind != ParamKind::Real) {
            return Err(say("parameter-is-whole"));
        }
        let number = Number::of(analysis, record, at).ok_or_else(|| say("no-such-parameter"))?;
        let name = name.to_string();
        Ok(Number { name, ..number })
    }

    /// The parameter of a record at an index, from 0.
    pub fn of(analysis: &Analysis, record: &Record, at: usize) -> Option<Number> {
        let param = record.ty().param(at, record.count())?;
        let token = analysis.document.params(record).nth(at)?;
        Some(Number {
            name: format!("{}.{}", record.id, param.name),
            span: token.span(),
            at: record.value as usize + at,
        })
    }
}

/// The records with an ID.
pub fn records_of(analysis: &Analysis, id: u32) -> Vec<&Record> {
    let records = analysis.document.items.iter().filter_map(Item::record);
    records.filter(|record| record.id == id).collect()
}

/// The parameters that are written in a record, each with its index.
fn written(record: &Record) -> impl Iterator<Item = (usize, &'static Param)> {
    let (ty, count) = (record.ty(), record.count());
    (0..record.params as usize).filter_map(move |i| Some((i, ty.param(i, count)?)))
}

/// The indices of a record's parameters with a name.
fn places(record: &Record, name: &str) -> Vec<usize> {
    let all = written(record).filter(|(_, param)| param.name == name);
    all.map(|(i, _)| i).collect()
}

/// Whether the parameters of a record with a name are a list.
fn is_list(record: &Record, name: &str) -> bool {
    let mut repeated = record.ty().repeats.iter().flat_map(|group| group.iter());
    repeated.any(|param| param.name == name)
}

/// The most parameters that a message names.
const NAMED: usize = 20;

fn listed(all: impl IntoIterator<Item = String>) -> String {
    let mut all: Vec<String> = all.into_iter().collect();
    if all.len() > NAMED {
        all.truncate(NAMED);
        all.push("…".to_owned());
    }
    all.join(", ")
}

/// Writes other values for some numbers of a scene and reads it again. The rest of the text stays as it is.
pub fn with_values(source: &SourceFile, values: &[(&Number, f64)]) -> Analysis {
    let edit = |&(number, value): &(&Number, f64)| Edit {
        span: number.span,
        text: spelled(value),
    };
    let mut edits: Vec<Edit> = values.iter().map(edit).collect();
    edits.sort_by_key(|edit| edit.span);
    Analysis::of(source.with_text(fixes::edited(&source.text, &edits)))
}

/// Whether `scene` is `of` with these values and otherwise the same. It may differ if a value is out of its range: then
/// optional numbers may be read as a record of their own.
pub fn has_values(scene: &Analysis, of: &Analysis, values: &[(&Number, f64)]) -> bool {
    let mut expected = of.document.values.clone();
    for (number, value) in values {
        expected[number.at] = *value;
    }
    let (found, items) = (&scene.document.values, scene.document.items.len());
    let is_same = |(a, b): (&f64, &f64)| a == b || a.is_nan() && b.is_nan();
    items == of.document.items.len()
        && found.len() == expected.len()
        && found.iter().zip(&expected).all(is_same)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::table::RECORD_TYPES;

    const SCENE: &str =
        "# a ring # 5 1 3  1 0  2 0\n 1.5 -1\n5 -1 0 2 0\n5 -1 1 1 1\n6 11 0 0 0 1\n";

    fn scene() -> Analysis {
        Analysis::new("a.zpg", SCENE.into())
    }

    fn number(name: &str) -> Result<Number, Complaint> {
        Number::named(&scene(), &name.parse()?)
    }

    #[test]
    fn names_find_numbers() {
        let text = |name: &str| number(name).map(|n| scene().source.slice(n.span).to_owned());
        for (name, expected) in [
            // Three records of 5 have an x, and one of them a list.
            ("5.x[2]", "2"),
            ("5@1.x[3]", "1.5"),
            ("5@1.y[3]", "-1"),
            ("5@3.y", "2"),
            ("6.r", "1"),
        ] {
            assert_eq!(text(name).as_deref(), Ok(expected), "{name}");
        }
    }

    #[test]
    fn what_names_no_number_is_told() {
        for (name, says) in [
            ("5", "9.fovy"),
            ("5.", "9.fovy"),
            ("5.x[", "9.fovy"),
            ("0.x", "9.fovy"),
            ("-1.x", "9.fovy"),
            ("7.x", "no record with ID 7"),
            ("5.x", "`5@1.x`, `5@3.x`, `5@4.x`"),
            ("5@2.x", "1, 3, 4"),
            ("5@1.x", "5@1.x[1]"),
            ("5@1.x[0]", "5@1.x[3]"),
            ("5@1.x[4]", "5@1.x[3]"),
            ("5.N", "whole number"),
            ("6.r[1]", "one number"),
            ("6.radius", "x, y, z, r"),
        ] {
            let said = number(name).expect_err(name).to_string();
            let says = says.replace('`', "");
            assert!(said.replace('`', "").contains(&says), "{name}: {said}");
        }
    }

    #[test]
    fn a_name_is_that_of_one_parameter_of_a_type() {
        for ty in RECORD_TYPES {
            let repeated = ty.repeats.iter().flat_map(|g| g.iter());
            let all = ty.params.iter().chain(repeated).chain(ty.optional);
            let mut names: Vec<&str> = all.map(|p| p.name).collect();
            names.sort_unstable();
            let before = names.len();
            names.dedup();
            assert_eq!(names.len(), before, "{}", ty.keyword);
            assert!(names.iter().all(|name| is_word(name)), "{}", ty.keyword);
        }
    }

    #[test]
    fn only_the_numbers_are_written() {
        let scene = scene();
        let numbers = ["6.r", "5@1.y[1]"].map(|name| number(name).unwrap());
        let values = [(&numbers[0], 0.1), (&numbers[1], -1e-300)];
        let other = with_values(&scene.source, &values);
        let expected = SCENE.replacen("1 0  2", "1 -1e-300  2", 1);
        let expected = expected.replace("6 11 0 0 0 1", "6 11 0 0 0 0.1");
        assert_eq!(other.source.text, expected);
        assert!(has_values(&other, &scene, &values));
        assert!(!has_values(&other, &scene, &values[..1]));
    }
}

//! The record table in words: what `zpg explain` and the language reference say about a record
//! type and its parameters.

use std::borrow::Cow;

use super::table::{Constraint, Effect, Kind, Param, ParamKind, RecordType, Unit};
use crate::diagnostics::Language;

/// The group of a record's parameters that a parameter belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Always there, once.
    Fixed,
    /// The n-th of the groups that are repeated as often as the count says.
    Repeated(usize),
    /// Present together with all other optional parameters, or absent together with them.
    Optional,
}

impl RecordType {
    /// Every parameter in the order of the record, each once.
    pub fn described(&self) -> impl Iterator<Item = (Group, &'static Param)> {
        let fixed = self.params.iter().map(|p| (Group::Fixed, p));
        let repeated = self
            .repeats
            .iter()
            .enumerate()
            .flat_map(|(i, group)| group.iter().map(move |p| (Group::Repeated(i), p)));
        let optional = self.optional.iter().map(|p| (Group::Optional, p));
        fixed.chain(repeated).chain(optional)
    }

    /// The meaning of the record, in a sentence or two.
    pub fn summary(&self, language: Language) -> Cow<'static, str> {
        let own = language.own(&format!("summary-{}", self.keyword), None);
        own.map_or(Cow::Borrowed(self.summary), Cow::Owned)
    }

    /// The effect of a record of this type on its ID: "Defines an object."
    pub fn effect_text(&self, language: Language) -> String {
        let all = |place, kinds: &[Kind], form| (place, any_of(kinds, form, language).into());
        match self.effect {
            Effect::Defines(kind) => language.say("record-defines", &[all("kind", &[kind], "acc")]),
            Effect::Changes(kinds) => language.say("record-changes", &[all("kinds", kinds, "acc")]),
            Effect::DefinesOrChanges(new, kinds) => {
                let values = [all("kind", &[new], "acc"), all("kinds", kinds, "gen")];
                language.say("record-defines-or-changes", &values)
            }
        }
    }
}

impl Param {
    /// The kind of value that the parameter takes, in words: "number", "ID of a colour, or 0".
    pub fn value_text(&self, language: Language) -> String {
        match self.kind {
            ParamKind::Real => language.say("record-number", &[]),
            ParamKind::Integer => language.say("record-integer", &[]),
            ParamKind::Count => language.say("record-count", &[]),
            ParamKind::Reference { kinds, or_none } => {
                let message = match or_none {
                    true => "record-id-or-none",
                    false => "record-id",
                };
                let kinds = any_of(kinds, "gen", language);
                language.say(message, &[("kinds", kinds.into())])
            }
            ParamKind::FileName => language.say("record-file-name", &[]),
        }
    }

    /// The unit, where there is one.
    pub fn unit_text(&self, language: Language) -> String {
        match self.unit {
            Unit::None => String::new(),
            Unit::Length => language.say("record-scene-units", &[]),
            Unit::Degrees => language.say("record-degrees", &[]),
            Unit::Share => language.say("record-share", &[]),
        }
    }

    /// The constraint on the value, where there is one.
    pub fn constraint_text(&self, language: Language) -> String {
        let between = |message, low: f64, high: f64| {
            let values = [
                ("low", low.to_string().into()),
                ("high", high.to_string().into()),
            ];
            language.say(message, &values)
        };
        match self.constraint {
            Constraint::Any => String::new(),
            Constraint::Positive => "> 0".to_owned(),
            Constraint::ProfileRadius => "≥ 0".to_owned(),
            Constraint::NonZeroScale => language.say("record-not-zero", &[]),
            Constraint::Between(low, high) => between("record-between", low, high),
            Constraint::Within(low, high) => between("record-within", low, high),
            Constraint::AtLeast(low) => format!("≥ {low}"),
            Constraint::Axis => language.say("record-axis", &[]),
        }
    }

    /// Value, unit, constraint and default in one line: "number, scene units, > 0, default 1".
    pub fn rule_text(&self, language: Language) -> String {
        let default = self.default.map(|number| {
            let number = match number {
                "black" => language.say("default-black", &[]),
                "white" => language.say("default-white", &[]),
                number => number.to_owned(),
            };
            let values = [("number", number.into())];
            language.say("record-default", &values)
        });
        let parts = [
            self.value_text(language),
            self.unit_text(language),
            self.constraint_text(language),
            default.unwrap_or_default(),
        ];
        let parts: Vec<String> = parts.into_iter().filter(|p| !p.is_empty()).collect();
        parts.join(", ")
    }
}

/// The names of some kinds in a list: "an object, a point light or a camera". `form` is the grammatical case of the
/// names, in languages that have cases.
fn any_of(kinds: &[Kind], form: &str, language: Language) -> String {
    let name = |kind: &Kind| language.form(kind.name(), form);
    let names: Vec<String> = kinds.iter().map(name).collect();
    match names.as_slice() {
        [rest @ .., last] if !rest.is_empty() => {
            let values = [
                ("first", rest.join(", ").into()),
                ("last", last.clone().into()),
            ];
            language.say("list-or", &values)
        }
        names => names.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_in_words() {
        let of = |keyword: &str| RecordType::by_keyword(keyword).unwrap();
        let rules = |keyword, language| -> Vec<String> {
            let all = of(keyword).described();
            all.map(|(_, p)| p.rule_text(language)).collect()
        };
        use Language::{Czech, English};
        assert_eq!(
            rules("parabolic-cylinder", English),
            ["number, scene units, > 0, default 1"]
        );
        assert_eq!(
            rules("parabolic-cylinder", Czech),
            ["číslo, jednotky scény, > 0, výchozí 1"]
        );
        assert_eq!(
            rules("assign", English)[0],
            "ID of a texture or a colour, or 0 for none"
        );
        assert_eq!(
            rules("assign", Czech)[0],
            "ID textury nebo barvy, nebo 0 pro žádnou"
        );
        assert_eq!(rules("optics", English)[0], "number, a share, 0 to 1");
        assert_eq!(rules("optics", Czech)[0], "číslo, podíl, 0 až 1");
        let effect = |language| of("translate").effect_text(language);
        assert_eq!(
            effect(English),
            "Changes an object, a point light or a camera."
        );
        assert_eq!(effect(Czech), "Mění objekt, bodové světlo nebo kameru.");
    }
}

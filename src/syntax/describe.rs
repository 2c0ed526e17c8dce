//! The record table in words: what `zpg explain` and the language reference say about a record
//! type and its parameters.

use crate::diagnostics::wording::with_article;

use super::table::{Constraint, Effect, Kind, Param, ParamKind, RecordType, Unit};

/// A parameter with the group it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Always there, once.
    Fixed,
    /// The n-th of the groups that are repeated as often as the count says.
    Repeated(usize),
    /// There with all other optional ones, or not at all.
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

    /// What a record of this type does with its ID: "Defines an object."
    pub fn effect_text(&self) -> String {
        match self.effect {
            Effect::Defines(kind) => format!("Defines {}.", with_article(kind.name())),
            Effect::Changes(kinds) => format!("Changes {}.", any_of(kinds)),
            Effect::DefinesOrChanges(new, kinds) => format!(
                "On a new ID it defines {}; on the ID of {} it changes that.",
                with_article(new.name()),
                any_of(kinds)
            ),
        }
    }
}

impl Param {
    /// What stands in its place: "number", "ID of a colour, or 0".
    pub fn value_text(&self) -> String {
        match self.kind {
            ParamKind::Real => "number".to_owned(),
            ParamKind::Integer => "integer".to_owned(),
            ParamKind::Count => "integer, a count".to_owned(),
            ParamKind::Reference { kinds, or_none } => {
                let or_none = if or_none { ", or 0 for none" } else { "" };
                format!("ID of {}{or_none}", any_of(kinds))
            }
            ParamKind::FileName => "file name".to_owned(),
        }
    }

    /// Its unit, where it has one.
    pub fn unit_text(&self) -> &'static str {
        match self.unit {
            Unit::None => "",
            Unit::Length => "scene units",
            Unit::Degrees => "degrees",
            Unit::Share => "a share",
        }
    }

    /// What its value must satisfy, where there is something.
    pub fn constraint_text(&self) -> String {
        match self.constraint {
            Constraint::Any => String::new(),
            Constraint::Positive => "> 0".to_owned(),
            Constraint::ProfileRadius => "≥ 0".to_owned(),
            Constraint::NonZeroScale => "not 0".to_owned(),
            Constraint::Between(low, high) => format!("> {low} and < {high}"),
            Constraint::Within(low, high) => format!("{low} to {high}"),
            Constraint::AtLeast(low) => format!("≥ {low}"),
            Constraint::Axis => "1, 2 or 3".to_owned(),
        }
    }

    /// Value, unit, constraint and default in one line: "number, scene units, > 0, default 1".
    pub fn rule_text(&self) -> String {
        let mut parts = vec![self.value_text()];
        parts.extend(Some(self.unit_text().to_owned()).filter(|s| !s.is_empty()));
        parts.extend(Some(self.constraint_text()).filter(|s| !s.is_empty()));
        parts.extend(self.default.map(|d| format!("default {d}")));
        parts.join(", ")
    }
}

/// "an object, a point light or a camera".
fn any_of(kinds: &[Kind]) -> String {
    let names: Vec<_> = kinds.iter().map(|k| with_article(k.name())).collect();
    match names.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_in_words() {
        let of = |keyword: &str| RecordType::by_keyword(keyword).unwrap();
        let rules = |keyword| -> Vec<String> {
            of(keyword)
                .described()
                .map(|(_, p)| p.rule_text())
                .collect()
        };
        assert_eq!(
            rules("parabolic-cylinder"),
            ["number, scene units, > 0, default 1"]
        );
        assert_eq!(
            rules("assign")[0],
            "ID of a texture or a colour, or 0 for none"
        );
        assert_eq!(rules("optics")[0], "number, a share, 0 to 1");
        assert_eq!(
            of("translate").effect_text(),
            "Changes an object, a point light or a camera."
        );
    }
}

//! A definition with a slip of its ID: the records right below have another ID, which is used and defined nowhere.

use rustc_hash::{FxHashMap, FxHashSet};

use super::switched_off;
use super::whole::{Matter, records};
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Span};
use crate::scene::names;
use crate::syntax::table::{Effect, Kind};
use crate::syntax::{Record, quote};

/// Most definitions that are tried in one file.
const MAX_TRIED: usize = 4;

/// The title of the fix that writes another ID in a definition.
const TITLE: &str = "fix-defined";

/// Whether a finding proposes another ID for a definition above.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    d.fixes.first().is_some_and(|f| f.title == TITLE)
}

/// The definitions of objects that no record names or changes, each with the ID of the records right below it, where
/// several findings speak of that ID. The findings are told as one.
pub(super) fn slips(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Matter> {
    let is_wrong = |d: &&Diagnostic| {
        let is_open = matches!(d.case, "" | "changed") && !switched_off::is_told(d);
        matches!(d.code, Code::E101 | Code::E103) && is_open
    };
    let mut wrong: FxHashMap<u32, Vec<&Diagnostic>> = FxHashMap::default();
    for d in findings.iter().filter(is_wrong) {
        if let Some(id) = super::named(d) {
            wrong.entry(id).or_default().push(d);
        }
    }
    wrong.retain(|_, all| all.len() > 1);
    if wrong.is_empty() {
        return Vec::new();
    }
    let document = &analysis.document;
    let all: Vec<&Record> = records(analysis).collect();
    let mut of_id: FxHashMap<u32, usize> = FxHashMap::default();
    let mut named: FxHashSet<u32> = FxHashSet::default();
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    for record in &all {
        *of_id.entry(record.id).or_default() += 1;
        named.extend(names::references(document, record));
        if matches!(record.ty().effect, Effect::Defines(_)) {
            defined.insert(record.id);
        }
    }
    let slip = |two: &[&Record]| {
        let [definition, below] = two else {
            return None;
        };
        let is_object = matches!(definition.ty().effect, Effect::Defines(Kind::Object));
        let is_alone = of_id[&definition.id] == 1 && !named.contains(&definition.id);
        let is_meant = !defined.contains(&below.id) && named.contains(&below.id);
        let findings = wrong.get(&below.id)?;
        if !is_object || !is_alone || !is_meant {
            return None;
        }
        let span = document.id_token(definition).span();
        let text = below.id.to_string();
        let number = quote(&text);
        let fix = Fix::guess(TITLE, vec![Edit { span, text }]).with("number", number);
        let first = (*findings.first()?).clone();
        let finding = Diagnostic {
            fixes: vec![fix],
            ..first
        };
        let spans: Vec<Span> = findings.iter().map(|d| d.span).collect();
        Some(Matter { finding, spans })
    };
    all.windows(2).filter_map(slip).take(MAX_TRIED).collect()
}

//! A definition with a slip of its ID: the records right below have another ID, which is used and defined nowhere; or a
//! property is defined twice.

use rustc_hash::{FxHashMap, FxHashSet};

use super::whole::{Matter, records};
use super::{Engine, switched_off};
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
    d.case == COPIED || d.fixes.first().is_some_and(|f| f.title == TITLE)
}

/// Finds definitions of objects that no record names or changes, right above a record whose ID has several findings and
/// no definition. The fix gives the definition that ID, and one finding stands for the several.
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

impl Engine<'_> {
    /// Finds a property that was copied with its ID, and replaces the errors that come from it by one finding.
    pub(super) fn copied(&mut self) {
        if let Some(matter) = copied(self.analysis, &self.findings) {
            self.settle(matter);
        }
    }
}

/// The title of the fix that writes another ID in the second definition of a property.
const COPIED_TITLE: &str = "fix-write";
/// The case of a finding about an undefined ID whose property has the ID of another one.
const COPIED: &str = "copied";

/// Finds a property that is defined twice before anything uses it, where just one ID is undefined: the second line was
/// copied with its ID. The fix gives that line the undefined ID.
fn copied(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Matter> {
    let is_open = |d: &&Diagnostic| d.code == Code::E101 && d.case.is_empty();
    let wrong: Vec<&Diagnostic> = findings
        .iter()
        .filter(is_open)
        .filter(|d| !switched_off::is_told(d))
        .collect();
    let id = super::named(wrong.first()?)?;
    if wrong.iter().any(|d| super::named(d) != Some(id)) {
        return None;
    }
    let document = &analysis.document;
    let all: Vec<&Record> = records(analysis).collect();
    // For each property that nothing has used yet, the index of the record that defines it.
    let mut unused: FxHashMap<u32, usize> = FxHashMap::default();
    let mut seen: FxHashSet<u32> = FxHashSet::default();
    let mut twice: Vec<usize> = Vec::new();
    for (at, record) in all.iter().enumerate() {
        for named in names::references(document, record) {
            unused.remove(&named);
        }
        let is_first = seen.insert(record.id);
        let is_property = matches!(
            record.ty().effect,
            Effect::DefinesOrChanges(Kind::Colour | Kind::Texture | Kind::Optics, _)
        );
        match unused.get(&record.id) {
            Some(&first) if all[first].kind == record.kind => twice.push(at),
            None if is_first && is_property => {
                unused.insert(record.id, at);
            }
            _ => {}
        }
    }
    let [second] = *twice else {
        return None;
    };
    let own = all[second].id;
    // Records right behind the second definition that change it get the new ID, too.
    let behind = all[second..].iter().take_while(|r| r.id == own);
    let text = id.to_string();
    let number = quote(&text);
    let edit = |r: &&Record| Edit {
        span: document.id_token(r).span(),
        text: text.clone(),
    };
    let fix = Fix::guess(COPIED_TITLE, behind.map(edit).collect()).with("number", number);
    let first = (**wrong.first()?).clone();
    let finding = Diagnostic {
        fixes: vec![fix],
        ..first
    };
    let finding = finding.case(COPIED).with("other-id", own.to_string());
    let spans: Vec<Span> = wrong.iter().map(|d| d.span).collect();
    Some(Matter { finding, spans })
}

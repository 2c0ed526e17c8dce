//! The linter: rules about the syntax tree and the scene, a folder for each in [`rules`]. A rule never reports a record
//! that is broken: the parser or the resolver has done so.

mod allow;
mod glance;
pub mod levels;
mod operations;
mod parts;
mod places;
mod properties;
mod rays;
mod records;
pub(crate) mod rules;
pub mod signs;
pub mod spelling;

use std::path::Path;
use std::sync::OnceLock;

use operations::Proven;

use crate::diagnostics::{Code, Diagnostic, Span};
use crate::parallel;
use crate::scene::names::Names;
use crate::scene::record::Params;
use crate::scene::{Node, NodeId, Scene};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::syntax::{Document, Item};

/// Bounds that are thinner than this share of their reach are flat: a few roundings leave that much.
const FLAT_REL_EXTENT: f64 = 1e-9;

/// The file, the scene and what is computed from both, for all rules.
pub struct Context<'a> {
    pub text: &'a str,
    pub document: &'a Document,
    pub scene: &'a Scene,
    /// The folder of the scene's file; `None` if the scene does not come from a file.
    folder: Option<&'a Path>,
    bounds: &'a OnceLock<Vec<NodeBounds>>,
    names: OnceLock<Option<Names>>,
    proven: OnceLock<Vec<Proven>>,
}

impl<'a> Context<'a> {
    /// Makes a context. `bounds` are those of the scene's nodes, and are computed when a rule first asks for them.
    pub fn new(
        text: &'a str,
        document: &'a Document,
        scene: &'a Scene,
        bounds: &'a OnceLock<Vec<NodeBounds>>,
    ) -> Context<'a> {
        Context {
            text,
            document,
            scene,
            folder: None,
            bounds,
            names: OnceLock::new(),
            proven: OnceLock::new(),
        }
    }

    /// Sets the folder of the scene's file.
    #[must_use]
    pub fn within(self, folder: Option<&'a Path>) -> Context<'a> {
        Context { folder, ..self }
    }

    /// The bounds of each node, for the rules about geometry.
    fn bounds(&self) -> &[NodeBounds] {
        self.bounds.get_or_init(|| node_bounds(self.scene))
    }

    /// The operations that are certainly empty, or certainly take nothing away.
    fn proven(&self) -> &[Proven] {
        self.proven.get_or_init(|| operations::proven(self))
    }

    /// The names by which records refer to each other; `None` if a record names an ID that does not exist.
    fn names(&self) -> Option<&Names> {
        let names = || Names::new(self.document, self.scene);
        self.names.get_or_init(names).as_ref()
    }

    /// The parameters of the record that starts where the span does; `None` if none starts there.
    fn params(&self, span: Span) -> Option<Params<'_>> {
        let items = &self.document.items;
        let start = |item: &Item| self.document.tokens[item.ends().0 as usize].start;
        let at = items.partition_point(|item| start(item) < span.start);
        match items.get(at) {
            Some(Item::Record(r)) if start(&items[at]) == span.start => {
                Some(Params::new(self.document, self.text, r))
            }
            _ => None,
        }
    }

    /// Whether the bounds of a node are flat along an axis, so that the node is no more than a face.
    fn is_flat(&self, node: NodeId) -> bool {
        let all = &self.bounds()[node as usize].all;
        let least = all.extent().into_iter().fold(f64::INFINITY, f64::min);
        all.is_finite() && least <= FLAT_REL_EXTENT * all.reach()
    }

    /// Whether the last numbers of the record that starts where the span does may belong to another record.
    fn is_doubted(&self, span: Span) -> bool {
        let item = self.document.item_at(span.start);
        item.is_some_and(|i| self.document.is_doubted(self.document.items[i].ends().0))
    }
}

/// For each node whether, at the end of the file, an ID stands for the node or for an object made of it. The states of
/// an object between two records that change it do not count, but all operations do.
fn live_nodes(scene: &Scene) -> Vec<bool> {
    let mut live = vec![false; scene.nodes.len()];
    for node in scene.entities.iter().filter_map(|e| e.node()) {
        live[node as usize] = true;
    }
    // Children stand before their parents.
    for (i, node) in scene.nodes.iter().enumerate().rev() {
        // An operation is a record of its own and counts, even if nothing uses its result.
        let operation = matches!(
            node,
            Node::Union(..) | Node::Intersection(..) | Node::Difference(..) | Node::Complement(_)
        );
        live[i] |= operation;
        if live[i] {
            for child in node.children() {
                live[child as usize] = true;
            }
        }
    }
    live
}

/// The nodes of the objects that are drawn; without a render record all live ones that are part of no other.
pub fn roots(scene: &Scene, live: &[bool]) -> Vec<NodeId> {
    if let Some(render) = &scene.render {
        return vec![render.root];
    }
    let mut part = vec![false; scene.nodes.len()];
    for (node, _) in scene.nodes.iter().zip(live).filter(|n| *n.1) {
        for child in node.children() {
            part[child as usize] = true;
        }
    }
    let tops = (0..scene.nodes.len()).filter(|&i| live[i] && !part[i]);
    tops.map(|i| i as NodeId).collect()
}

/// Runs the rules that are asked for, side by side. Adds their findings to those of the parser and the resolver, and
/// takes out the findings that comments allow. A rule does not run if the scene lacks the records that the rule asks
/// for.
pub fn run(context: &Context, asked: impl Fn(Code) -> bool + Sync, out: &mut Vec<Diagnostic>) {
    let contents = &context.document.contents;
    // With comments that allow findings, all rules run: an entry that allows nothing is a finding itself.
    let allowing = allow::comments(context);
    let all = !allowing.is_empty();
    let is_wrong = out.iter().any(Diagnostic::is_error);
    let has = |rule: &&rules::Rule| {
        (all || asked(rule.code))
            && rule.asks_for.iter().all(|kinds| contents.has(kinds))
            && !(is_wrong && rules::OF_PICTURES.contains(&rule.code))
    };
    let rules: Vec<&rules::Rule> = rules::RULES.iter().filter(has).collect();
    let found = |i: usize| {
        let mut found = Vec::new();
        (rules[i].check)(context, &mut found);
        found
    };
    let found = match context.document.items.len() < MIN_RECORDS_FOR_THREADS {
        // To share the rules out would take longer.
        true => (0..rules.len()).map(found).collect(),
        false => parallel::map(rules.len(), found),
    };
    let first = out.len();
    out.extend(found.into_iter().flatten());
    if is_wrong {
        let found = out[first..].iter_mut();
        let fixes = found
            // W311 holds a bound against the changed object, and the change may be what cannot be read.
            .filter(|d| takes_records_out(d.code) || d.code == Code::W311)
            .map(|d| &mut d.fixes);
        fixes.for_each(Vec::clear);
    }
    allow::apply(context, &allowing, out);
}

/// The ID of the first record that W301 or W302 reports as giving out more light than it gets. Findings that comments
/// allow do not count. `None` if there is none.
pub fn glaring(context: &Context, is_on: impl Fn(Code) -> bool) -> Option<u32> {
    let mut found = Vec::new();
    if is_on(Code::W301) {
        rules::colour_out_of_range::check(context, &mut found);
    }
    if is_on(Code::W302) {
        rules::energy_gain::check(context, &mut found);
    }
    if found.is_empty() {
        return None;
    }
    allow::apply(context, &allow::comments(context), &mut found);
    let (items, tokens) = (&context.document.items, &context.document.tokens);
    let glares = |d: &Diagnostic| {
        let starts_before = |item: &Item| tokens[item.ends().0 as usize].start <= d.span.start;
        let at = items.partition_point(starts_before).checked_sub(1)?;
        let Item::Record(record) = &items[at] else {
            return None;
        };
        // W301 also reports negative parts of colours.
        let p = context.record_params(record);
        let is_above = (0..p.len()).any(|i| d.span.touches(p.span_of(i, 1)) && p.number(i) > 1.0);
        let is_bright = match d.code {
            Code::W301 => is_above,
            code => code == Code::W302,
        };
        is_bright.then_some(record.id)
    };
    found.sort_by_key(|d| d.span.start);
    found.iter().find_map(glares)
}

/// The number of objects that W310 reports as not drawn. Findings that comments allow do not count.
pub fn undrawn(context: &Context) -> usize {
    let mut found = Vec::new();
    rules::unused_definition::check(context, &mut found);
    allow::apply(context, &allow::comments(context), &mut found);
    let objects = found
        .iter()
        .filter(|d| rules::unused_definition::is_of_object(d));
    objects.count()
}

/// Whether a rule is about the picture as a whole.
pub fn is_of_pictures(code: Code) -> bool {
    rules::OF_PICTURES.contains(&code)
}

/// Whether the fixes of a rule remove records.
pub fn takes_records_out(code: Code) -> bool {
    rules::TAKING_OUT.contains(&code)
}

/// Number of records below which all rules run in one thread.
const MIN_RECORDS_FOR_THREADS: usize = 64;

#[cfg(test)]
pub(crate) mod testing;

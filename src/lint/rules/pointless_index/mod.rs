//! W318: a refractive index without effect, because no light goes through the object; and an index below 1, or so large
//! that it has rather lost its decimal point.

mod apart;
mod covers;
mod instead;

use rustc_hash::FxHashMap;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::spelling::decimal;
use crate::lint::{Context, live_nodes, roots};
use crate::scene::record::Params;
use crate::scene::{DEFAULT_INDEX, Node, NodeId, Paint, Scene, fold_up};
use crate::syntax::quote;
use crate::syntax::table::{Kind, RecordKind};
use apart::Apart;
use covers::{Covers, optics_of};

/// The refractive index of a vacuum: nothing is thinner.
const VACUUM: f64 = 1.0;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut any = false;
    for record in context
        .records()
        .filter(|r| r.kind == RecordKind::RefractiveIndex)
    {
        any = true;
        let p = context.record_params(record);
        out.extend(below_one(&p));
        out.extend(too_large(&p));
    }
    if any {
        opaque(context, out);
    }
}

fn below_one(p: &Params) -> Option<Diagnostic> {
    let below: Vec<usize> = (0..p.len())
        .filter(|&i| (0.0..VACUUM).contains(&p.number(i)) && p.number(i) > 0.0)
        .collect();
    let (&first, &last) = (below.first()?, below.last()?);
    let parts: Vec<String> = below
        .iter()
        .map(|&i| {
            let name = p.param(i).map_or("", |q| q.name);
            format!("{name} = {}", p.text_of(i))
        })
        .collect();
    let d = Diagnostic::new(Code::W318, p.span_of(first, last - first + 1));
    Some(d.case("below-one").with("parts", parts.join(", ")))
}

/// The largest index that people write for a material: diamond has 2.4, germanium 4.
const LARGEST: f64 = 5.0;

/// The finding about indices above [`LARGEST`], which have rather lost their decimal points: `15` for `1.5`.
fn too_large(p: &Params) -> Option<Diagnostic> {
    let large: Vec<usize> = (0..p.len()).filter(|&i| p.number(i) > LARGEST).collect();
    let (&first, &last) = (large.first()?, large.last()?);
    let pointed = |x: f64| decimal(x / 10_f64.powf(x.log10().floor()));
    let edits = large.iter().map(|&i| Edit {
        span: p.span_of(i, 1),
        text: pointed(p.number(i)),
    });
    let numbers: Vec<String> = large.iter().map(|&i| pointed(p.number(i))).collect();
    let mut fix = Fix::guess("fix-point-lost", edits.collect());
    fix.applicability = Applicability::Choice;
    let d = Diagnostic::new(Code::W318, p.span_of(first, last - first + 1)).case("too-large");
    let d = d.with("text", quote(p.text_of(first)));
    Some(d.fix(fix.with("number", quote(&numbers.join(" ")))))
}

/// Reports indices that have no effect on any object with them: no light goes through these objects, and no transparent
/// object comes near them.
fn opaque(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let sources = sources(context);
    let transmits = transmits(scene);
    let reach = reach(scene);
    // For each record that gives an index: whether light goes through any object with that index, and the ID of an
    // object that no light goes through.
    let mut of_record: FxHashMap<Span, (bool, Option<u32>)> = FxHashMap::default();
    for (i, node) in scene.nodes.iter().enumerate() {
        let (Node::Paint { child, .. }, Some(source)) = (node, sources[i]) else {
            continue;
        };
        if reach[i] == IndexCompany::default() {
            continue;
        }
        let own = paint_of(scene, *node).and_then(|p| p.optics);
        let clear = match own {
            Some(optics) => lets_through(optics.kt),
            None => transmits[*child as usize],
        };
        let through = reach[i].transmits || reach[i].bare && clear;
        let known = of_record.entry(source).or_insert((false, None));
        known.0 |= through;
        if known.1.is_none() && !through {
            known.1 = Some(scene.origins[i].id);
        }
    }
    let mut silent: Vec<(Span, u32)> = (of_record.into_iter())
        .filter_map(|(span, (through, object))| Some((span, object.filter(|_| !through)?)))
        .collect();
    if silent.is_empty() {
        return;
    }
    silent.sort_by_key(|s| s.0);
    let roots = roots(scene, &live_nodes(scene));
    let Some(mut apart) = Apart::new(scene, context.bounds(), &sources, &roots) else {
        return;
    };
    silent.retain(|s| apart.is_without_effect(s.0));
    let titles = context.titles();
    let is_one = silent.len() == 1;
    let mut covers: Option<Covers> = None;
    let twice = super::overridden_property::with_two_optics(context);
    let told = super::overridden_property::with_lost_parts(context);
    // W342 and W310 say what these lack.
    let mut lacking = super::optics_by_comment::without_optics(context);
    lacking.extend(super::unused_definition::assigned_optics(context).map(|a| a.id));
    for (span, object) in silent {
        let Some(p) = context.params(span) else {
            continue;
        };
        // An index below 1 has been reported already, and W334 reports optics that were written under another ID by a
        // slip.
        if below_one(&p).is_some() || told == Some(p.id) || lacking.contains(&p.id) {
            continue;
        }
        let title = |id: u32| Value::Term(titles.get(&id).copied().unwrap_or("object"));
        let d = Diagnostic::new(Code::W318, p.span_of(0, 3))
            .with("object", title(object))
            .with("object-id", object.to_string());
        if let Some(cover) = covers
            .get_or_insert_with(|| Covers::new(scene))
            .of(&sources, span)
            && let Some(record) = optics_of(context, cover)
        {
            let written = context.document.span(record.first, record.last);
            let head = context.record_params(record);
            out.push(
                d.case("covered")
                    .with("cover", title(record.id))
                    .with("cover-id", record.id.to_string())
                    .with("number", quote(&format!("{} {}", head.id, head.ty.code)))
                    .label(written, "cover"),
            );
            continue;
        }
        let of_optics = is_one.then(|| instead::of_clear_optics(context, &p));
        if let Some((meant, fix)) = of_optics.flatten() {
            let d = d.case("other").with("other-id", meant.to_string());
            out.push(d.fix(fix));
            continue;
        }
        let fix = (is_one.then(|| instead::of_glass(context, &p, &twice))).flatten();
        out.push(match fix {
            Some(fix) => d.fix(fix),
            None => d,
        });
    }
}

fn lets_through(kt: [f64; 3]) -> bool {
    kt.iter().any(|&k| k > 0.0)
}

fn paint_of(scene: &Scene, node: Node) -> Option<&Paint> {
    match node {
        Node::Paint { paint, .. } => Some(&scene.paints[paint as usize]),
        _ => None,
    }
}

/// For each node that sets an index other than the default: the span of the record that gives the index.
fn sources(context: &Context) -> Vec<Option<Span>> {
    let scene = context.scene;
    let mut sources = vec![None; scene.nodes.len()];
    // For each object and each property the record that last gave it an index.
    let mut last: FxHashMap<u32, Option<Span>> = FxHashMap::default();
    let mut next = 0;
    for record in context.records() {
        let span = context.document.span(record.first, record.last);
        let made = scene.origins.get(next).is_some_and(|o| o.span == span);
        match record.kind {
            RecordKind::RefractiveIndex => {
                last.insert(record.id, Some(span));
            }
            RecordKind::Assignment => {
                let optics = context.record_params(record).integer(1);
                let optics = u32::try_from(optics).ok();
                let source = optics.and_then(|id| last.get(&id).copied().flatten());
                last.insert(record.id, source);
            }
            _ => {}
        }
        if made {
            let index = paint_of(scene, scene.nodes[next]).and_then(|p| p.index);
            if index.is_some_and(|i| i != DEFAULT_INDEX) {
                sources[next] = last.get(&record.id).copied().flatten();
            }
            next += 1;
        }
    }
    sources
}

/// For each node whether light goes through any part of it, by the paints of the node itself and not by those above.
fn transmits(scene: &Scene) -> Vec<bool> {
    fold_up(&scene.nodes, |_, node, transmits: &[bool]| {
        let of = |n: NodeId| transmits[n as usize];
        let optics = paint_of(scene, node).and_then(|p| p.optics);
        match (node, optics) {
            (_, Some(optics)) => lets_through(optics.kt),
            (Node::Difference(a, _), _) => of(a),
            _ => node.children().any(of),
        }
    })
}

/// The optics with which the index of a node is seen, on all ways down from what is drawn on which no paint above
/// overrides the index. All three are `false` if there is no such way.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct IndexCompany {
    /// On some way no paint above has optics, so the node's own count.
    bare: bool,
    /// On some way the optics of a paint above count, and they let light through.
    transmits: bool,
    /// On some way the optics of a paint above count, and they let no light through.
    opaque: bool,
}

fn reach(scene: &Scene) -> Vec<IndexCompany> {
    let bare = IndexCompany {
        bare: true,
        ..IndexCompany::default()
    };
    let mut reach = vec![IndexCompany::default(); scene.nodes.len()];
    match scene.render {
        Some(render) => reach[render.root as usize] = bare,
        None => {
            let objects = (scene.entities.iter()).filter(|e| e.kind == Some(Kind::Object));
            for node in objects.filter_map(|e| e.node()) {
                reach[node as usize] = bare;
            }
        }
    }
    for (i, &node) in scene.nodes.iter().enumerate().rev() {
        let mut down = reach[i];
        if let Some(paint) = paint_of(scene, node) {
            if paint.index.is_some() {
                continue;
            }
            if let (Some(optics), true) = (paint.optics, down.bare) {
                let through = lets_through(optics.kt);
                down.bare = false;
                down.transmits |= through;
                down.opaque |= !through;
            }
        }
        // Nothing is seen of the tool of a difference.
        let seen = match node {
            Node::Difference(..) => 1,
            _ => 2,
        };
        for child in node.children().take(seen) {
            let child = &mut reach[child as usize];
            child.bare |= down.bare;
            child.transmits |= down.transmits;
            child.opaque |= down.opaque;
        }
    }
    reach
}

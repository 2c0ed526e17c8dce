//! W310: something that is defined and not needed for the picture.

mod assign;
mod background;
mod part;
mod slip;
mod whole;

use std::cell::LazyCell;

use rustc_hash::FxHashMap;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Label, Value};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::names::Names;
use crate::syntax::table::{Effect, Kind, RecordKind};
use crate::syntax::{Record, quote};

/// Flags of an ID. A large scene has millions of IDs, so each has one byte.
type IdFlags = u8;
/// The ID is no object, or its object could be made. If its object could not be made, another finding says so.
const SOUND: IdFlags = 1;
/// A record other than a placeholder defines the ID.
const DEFINED: IdFlags = 2;
const USED: IdFlags = 4;
/// An unused definition names the ID.
const HELD: IdFlags = 8;
/// Set once it is decided whether the ID is reported.
const DECIDED: IdFlags = 16;

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render.filter(|_| !context.has_broken()) else {
        return;
    };
    let root = render.root_id.to_string();
    let mut all = definitions(context);
    // Where a record names an ID that does not exist, an ID that seems to be unused may be meant.
    let Some(names) = context.names() else {
        return;
    };
    spare_duplicates(context, &mut all);
    follow(names, &mut all);
    // A definition that only unused ones name is not reported: it goes with them.
    for i in 0..all.len() {
        for &name in names.of(i) {
            if all[i] & USED == 0 && name as usize != i {
                all[name as usize] |= HELD;
            }
        }
    }
    let holders = LazyCell::new(|| whole::holders(context, names));
    let (mut properties, mut objects, mut wholes) = (Vec::new(), Vec::new(), Vec::new());
    let mut backgrounds = Vec::new();
    // A placeholder and its later definition share an ID. The finding points at the later one.
    for entity in context.scene.entities.iter().rev() {
        let Some(number) = context.scene.ids.get(entity.id) else {
            continue;
        };
        let known = all[number as usize];
        all[number as usize] |= DECIDED;
        if known & (SOUND | USED | HELD | DECIDED) == SOUND
            && let Some(mut finding) = finding(context, entity)
        {
            let at = out.len();
            if finding.case == "object" && holders.contains(&number) {
                finding = finding.case("whole").with("part", root.clone());
                wholes.push((at, entity));
            }
            objects.extend((finding.case == "object").then_some((at, entity)));
            if finding.case.is_empty() {
                properties.push((at, entity));
                backgrounds.extend((entity.kind == Some(Kind::Colour)).then_some((at, entity.id)));
            }
            out.push(finding);
        }
    }
    let start = |record: &Record| context.document.tokens[record.first as usize].start;
    let lamps = context.lamps_with_places().into_iter();
    let lamps: FxHashMap<u32, _> = lamps.map(|pair| (start(pair.1), pair)).collect();
    for finding in out.iter_mut().filter(|d| is_of_object(d)) {
        if let Some((lamp, place)) = lamps.get(&finding.span.start) {
            let fix = slip::of_a_lamp(context, lamp, place);
            finding.fixes.push(fix);
        }
    }
    if let [(at, property)] = properties[..] {
        let fixes = &mut out[at].fixes;
        fixes.extend(slip::of_a_transparent_one(context, property));
        // A mere index has no effect on an object that lets no light through.
        if !slip::is_mere_index(context, property) {
            let is_drawn = |id: u32| {
                let number = context.scene.ids.get(id);
                number.is_some_and(|number| all[number as usize] & USED != 0)
            };
            let above = slip::of_the_object_above(context, property, is_drawn);
            let is_slip = |fix: &Fix| fix.applicability == Applicability::Unsafe;
            let fix = match above {
                Some(fix) if is_slip(&fix) => Some(fix),
                above => assign::to_the_only_one(context, property).or(above),
            };
            fixes.extend(fix);
        }
    }
    background::add(context, &backgrounds, out);
    name_checkerboard(context, &backgrounds, out);
    if let [(at, object)] = objects[..]
        && let Some(fix) = part::in_its_place(context, object)
    {
        out[at].case = "operand";
        out[at].values.extend(fix.values.iter().cloned());
        out[at].fixes.push(fix);
    }
    if let [(at, object)] = objects[..]
        && out[at].fixes.is_empty()
    {
        out[at]
            .fixes
            .extend(part::for_one_named_twice(context, object));
    }
    if let [(at, object)] = wholes[..] {
        out[at].fixes.extend(whole::drawn(context, object));
    }
}

/// Labels a checkerboard that names one colour twice, if a single colour is unused: the checkerboard may mean it. All
/// fixes of the finding go.
fn name_checkerboard(context: &Context, colours: &[(usize, u32)], out: &mut [Diagnostic]) {
    let [(at, _)] = colours[..] else { return };
    let mut boards = super::duplicate_operand::of_one_colour(context);
    if let Some(board) = boards.find(|board| board.span().start > out[at].span.start) {
        out[at].fixes.clear();
        out[at].labels.push(Label {
            span: board.span(),
            phrase: "board",
        });
    }
}

/// The object that unused optics are to be assigned to, and the record that does it with its fix.
pub(super) struct Assigned {
    pub id: u32,
    pub line: String,
    pub fix: Fix,
}

/// The assignment of unused optics that a finding proposes. `None` if none does.
pub(super) fn assigned_optics(context: &Context) -> Option<Assigned> {
    let mut found = Vec::new();
    check(context, &mut found);
    let mut fixes = found.into_iter().flat_map(|d| d.fixes);
    let fix = fixes.find(|fix| fix.title == assign::TITLE)?;
    let line = fix.edits.first()?.text.trim().to_owned();
    let mut numbers = line.split(' ');
    let (id, texture) = (numbers.next()?.parse().ok()?, numbers.nth(1)?);
    (texture == "0").then_some(Assigned { id, line, fix })
}

/// Whether a finding is about an object.
pub(crate) fn is_of_object(finding: &Diagnostic) -> bool {
    finding.code == Code::W310 && ["object", "whole", "operand"].contains(&finding.case)
}

fn finding(context: &Context, entity: &Entity) -> Option<Diagnostic> {
    let case = match entity.kind? {
        Kind::Object => "object",
        Kind::Undefined => "placeholder",
        Kind::Optics | Kind::Texture | Kind::Colour => "",
        _ => return None,
    };
    let title = context.params(entity.span).map_or("object", |p| p.ty.title);
    let assignment = match entity.kind? {
        Kind::Optics => format!("ID -299 0 {}", entity.id),
        _ => format!("ID -299 {} 0", entity.id),
    };
    Some(
        Diagnostic::new(Code::W310, entity.span)
            .case(case)
            .with("type", Value::Term(title))
            .with("id", entity.id.to_string())
            .with("assignment", quote(&assignment)),
    )
}

/// The flags of each ID, by its number.
fn definitions(context: &Context) -> Vec<IdFlags> {
    let scene = context.scene;
    // There are at most as many IDs as entities.
    let mut all = vec![0; scene.entities.len()];
    for e in &scene.entities {
        if let Some(number) = scene.ids.get(e.id) {
            let known = &mut all[number as usize];
            if e.kind != Some(Kind::Object) || e.node().is_some() {
                *known |= SOUND;
            }
            // The last record of an ID says what it is.
            *known &= !USED;
            if is_asked_for_by_nobody(e) {
                *known |= USED;
            }
        }
    }
    all
}

/// Marks IDs that are defined twice as used: which of the two definitions was meant is not known.
fn spare_duplicates(context: &Context, all: &mut [IdFlags]) {
    let entities = context.scene.entities.iter();
    let mut entities = entities.map(|e| e.span.start).peekable();
    for record in context.records() {
        // Entities are in the order of the records that define them. A record that was refused defines none.
        let start = context.document.tokens[record.first as usize].start;
        let is_entity = entities.next_if_eq(&start).is_some();
        let defines = matches!(record.ty().effect, Effect::Defines(_))
            && record.kind != RecordKind::Undefined;
        if defines && let Some(number) = context.scene.ids.get(record.id) {
            let known = &mut all[number as usize];
            *known |= match is_entity && *known & DEFINED == 0 {
                true => DEFINED,
                false => USED,
            };
        }
    }
}

/// Whether an entity counts as used even if no record names it: a light, a camera, a selection or the render record.
fn is_asked_for_by_nobody(entity: &Entity) -> bool {
    matches!(
        entity.kind,
        None | Some(
            Kind::AmbientLight | Kind::PointLight | Kind::Camera | Kind::Selection | Kind::Render
        )
    )
}

/// Marks as used all IDs that used IDs name, at any depth.
fn follow(names: &Names, all: &mut [IdFlags]) {
    let mut open: Vec<usize> = (0..all.len()).filter(|&i| all[i] & USED != 0).collect();
    while let Some(i) = open.pop() {
        for &name in names.of(i) {
            let name = name as usize;
            if all[name] & USED == 0 {
                all[name] |= USED;
                open.push(name);
            }
        }
    }
}

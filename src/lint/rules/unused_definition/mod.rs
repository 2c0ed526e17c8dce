//! W310: something that is defined and not needed for the picture.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::names::Names;
use crate::syntax::table::{Effect, Kind, RecordKind};

/// What is known of an ID besides the entity: whether an object could be made of it (otherwise something
/// else has been said about it), whether it is used, and whether something else that is not used names it.
#[derive(Clone, Copy, Default)]
struct Definition {
    /// Index into the scene's entities, the last one where there are several.
    entity: u32,
    sound: bool,
    used: bool,
    held: bool,
}

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.scene.render.is_none() || context.has_broken() {
        return;
    }
    let mut all = definitions(context);
    // What seems to be unused may be what was meant where a record names what is not there.
    let Some(names) = context.names() else {
        return;
    };
    spare_duplicates(context, &mut all);
    follow(names, &mut all);
    // What only an unused thing needs goes with it.
    for i in 0..all.len() {
        for &name in names.of(i) {
            if !all[i].used && name as usize != i {
                all[name as usize].held = true;
            }
        }
    }
    let entity = |d: &Definition| context.scene.entities[d.entity as usize];
    let reported = all.iter().filter(|d| d.sound && !d.used && !d.held);
    out.extend(reported.filter_map(|d| {
        let entity = entity(d);
        let case = match entity.kind? {
            Kind::Object => "object",
            Kind::Undefined => "placeholder",
            Kind::Optics | Kind::Texture | Kind::Colour => "",
            _ => return None,
        };
        let title = context.params(entity.span).map_or("object", |p| p.ty.title);
        Some(
            Diagnostic::new(Code::W310, entity.span)
                .case(case)
                .with("type", Value::Term(title))
                .with("id", entity.id.to_string()),
        )
    }));
}

/// A definition for each number of an ID.
fn definitions(context: &Context) -> Vec<Definition> {
    let scene = context.scene;
    let mut all: Vec<Definition> = Vec::with_capacity(scene.entities.len());
    for (i, e) in scene.entities.iter().enumerate() {
        let Some(number) = scene.ids.get(e.id) else {
            continue;
        };
        let new = Definition {
            entity: i as u32,
            sound: e.kind != Some(Kind::Object) || e.node().is_some(),
            used: is_asked_for_by_nobody(e),
            held: false,
        };
        match all.get_mut(number as usize) {
            // A placeholder and what has become of it.
            Some(old) => {
                let sound = old.sound || new.sound;
                *old = Definition { sound, ..new };
            }
            None => all.push(new),
        }
    }
    all
}

/// Marks what is defined twice as used: which of the two was meant is not known.
fn spare_duplicates(context: &Context, all: &mut [Definition]) {
    let scene = context.scene;
    for record in context.records() {
        let defines = matches!(record.ty().effect, Effect::Defines(_))
            && record.kind != RecordKind::Undefined;
        if defines && let Some(number) = scene.ids.get(record.id) {
            let definition = &mut all[number as usize];
            let entity = scene.entities[definition.entity as usize];
            let start = context.document.tokens[record.first as usize].start;
            definition.used |= start != entity.span.start;
        }
    }
}

/// Lights and cameras are; the render record is the beginning.
fn is_asked_for_by_nobody(entity: &Entity) -> bool {
    matches!(
        entity.kind,
        None | Some(
            Kind::AmbientLight | Kind::PointLight | Kind::Camera | Kind::Selection | Kind::Render
        )
    )
}

/// Marks as used what the used ones name.
fn follow(names: &Names, all: &mut [Definition]) {
    let mut open: Vec<usize> = (0..all.len()).filter(|&i| all[i].used).collect();
    while let Some(i) = open.pop() {
        for &name in names.of(i) {
            let name = name as usize;
            if !std::mem::replace(&mut all[name].used, true) {
                open.push(name);
            }
        }
    }
}

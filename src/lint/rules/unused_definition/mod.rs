//! W310: something that is defined and not needed for the picture.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::names::Names;
use crate::syntax::table::{Effect, Kind, RecordKind};

/// What is known of an ID. A large scene has millions of them, so that they are bits.
type Known = u8;
/// An object could be made of it, or it is no object; otherwise something else has been said about it.
const SOUND: Known = 1;
/// A record defines it that is no placeholder.
const DEFINED: Known = 2;
const USED: Known = 4;
/// Something else that is not used names it.
const HELD: Known = 8;
/// It has been looked at.
const SEEN: Known = 16;

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
            if all[i] & USED == 0 && name as usize != i {
                all[name as usize] |= HELD;
            }
        }
    }
    // Of a placeholder and what has become of it the last one is shown.
    let entities = context.scene.entities.iter().rev();
    let reported = entities.filter(|e| {
        let Some(number) = context.scene.ids.get(e.id) else {
            return false;
        };
        let known = std::mem::replace(&mut all[number as usize], SEEN);
        known & (SOUND | USED | HELD | SEEN) == SOUND
    });
    out.extend(reported.filter_map(|entity| {
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

/// What is known of each ID, by its number.
fn definitions(context: &Context) -> Vec<Known> {
    let scene = context.scene;
    // No ID has a greater number.
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

/// Marks what is defined twice as used: which of the two was meant is not known.
fn spare_duplicates(context: &Context, all: &mut [Known]) {
    for record in context.records() {
        let defines = matches!(record.ty().effect, Effect::Defines(_))
            && record.kind != RecordKind::Undefined;
        if defines && let Some(number) = context.scene.ids.get(record.id) {
            let known = &mut all[number as usize];
            *known |= match *known & DEFINED {
                0 => DEFINED,
                _ => USED,
            };
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
fn follow(names: &Names, all: &mut [Known]) {
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

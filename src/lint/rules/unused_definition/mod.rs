//! W310: something that is defined and not needed for the picture.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::syntax::table::{Effect, Kind, RecordKind};

/// What an ID stands for and which others its records name, whether they define or change it.
struct Definition {
    id: u32,
    kind: Option<Kind>,
    /// Whether an object could be made of it; otherwise something else has been said about it.
    sound: bool,
    span: Span,
    title: &'static str,
    names: Vec<u32>,
    used: bool,
    /// Named by something else that is not used.
    held: bool,
}

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.scene.render.is_none() || context.has_broken() {
        return;
    }
    let Some(mut all) = definitions(context) else {
        return;
    };
    follow(&mut all);
    // What only an unused thing needs goes with it.
    for i in 0..all.len() {
        for name in std::mem::take(&mut all[i].names) {
            if !all[i].used && name as usize != i {
                all[name as usize].held = true;
            }
        }
    }
    let reported = all.iter().filter(|d| d.sound && !d.used && !d.held);
    out.extend(reported.filter_map(|d| {
        let case = match d.kind? {
            Kind::Object => "object",
            Kind::Undefined => "placeholder",
            Kind::Optics | Kind::Texture | Kind::Colour => "",
            _ => return None,
        };
        Some(
            Diagnostic::new(Code::W310, d.span)
                .case(case)
                .with("type", Value::Term(d.title))
                .with("id", d.id.to_string()),
        )
    }));
}

/// Every definition, its names as indices; `None` if a record names what is not there: what seems
/// to be unused may be what was meant.
fn definitions(context: &Context) -> Option<Vec<Definition>> {
    let mut at: FxHashMap<u32, usize> = FxHashMap::default();
    let mut all: Vec<Definition> = Vec::new();
    for e in &context.scene.entities {
        let new = Definition {
            id: e.id,
            kind: e.kind,
            sound: e.kind != Some(Kind::Object) || e.node.is_some(),
            span: e.span,
            title: "object",
            names: Vec::new(),
            // Lights and cameras are asked for by nobody; the render record is the beginning.
            used: matches!(
                e.kind,
                None | Some(
                    Kind::AmbientLight
                        | Kind::PointLight
                        | Kind::Camera
                        | Kind::Selection
                        | Kind::Render
                )
            ),
            held: false,
        };
        match at.get(&e.id) {
            // A placeholder and what has become of it.
            Some(&i) => {
                let sound = all[i].sound || new.sound;
                all[i] = Definition { sound, ..new };
            }
            None => {
                at.insert(e.id, all.len());
                all.push(new);
            }
        }
    }
    for record in context.records() {
        let &own = at.get(&record.id)?;
        if context.document.id_token(record).span() == all[own].span {
            all[own].title = record.ty.title;
        } else if record.ty.kind != RecordKind::Undefined
            && matches!(record.ty.effect, Effect::Defines(_))
        {
            // Defined twice: which of the two was meant is not known.
            all[own].used = true;
        }
        for name in context.references(record) {
            let &named = at.get(&name)?;
            all[own].names.push(named as u32);
        }
    }
    Some(all)
}

/// Marks as used what the used ones name.
fn follow(all: &mut [Definition]) {
    let mut open: Vec<usize> = (0..all.len()).filter(|&i| all[i].used).collect();
    while let Some(i) = open.pop() {
        for k in 0..all[i].names.len() {
            let name = all[i].names[k] as usize;
            if !std::mem::replace(&mut all[name].used, true) {
                open.push(name);
            }
        }
    }
}

//! Objects that contain what is drawn, and are not drawn themselves: the render record names an earlier step of the
//! scene.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::names::Names;
use crate::syntax::quote;

/// The numbers of the IDs that contain what is drawn, at any depth.
pub(super) fn holders(context: &Context, names: &Names) -> FxHashSet<u32> {
    let mut holders = FxHashSet::default();
    let ids = &context.scene.ids;
    let Some(root) = context.scene.render.and_then(|r| ids.get(r.root_id)) else {
        return holders;
    };
    // Pairs of the number of an ID and that of an ID that names it.
    let all = 0..context.scene.entities.len() as u32;
    let named = all.flat_map(|i| names.of(i as usize).iter().map(move |&name| (name, i)));
    let mut named: Vec<(u32, u32)> = named.collect();
    named.sort_unstable();
    let mut open = vec![root];
    while let Some(part) = open.pop() {
        let first = named.partition_point(|&(name, _)| name < part);
        let by = named[first..].iter().take_while(|&&(name, _)| name == part);
        open.extend(by.map(|&(_, i)| i).filter(|&i| holders.insert(i)));
    }
    holders
}

/// The fix that makes the render record draw the object in place of the present one.
pub(super) fn drawn(context: &Context, object: &Entity) -> Option<Fix> {
    let p = context.params(context.scene.render?.span)?;
    let place = p.span_of(ROOT, 1);
    let record = format!(
        "{} {} {} {}",
        p.id,
        p.ty.code,
        object.id,
        p.text_of(ROOT + 1)
    );
    let fix = Fix::replace("fix", Applicability::Unsafe, place, object.id.to_string());
    Some(fix.with("text", quote(&record)))
}

/// The index of the drawn object among the parameters of the render record.
const ROOT: usize = 0;

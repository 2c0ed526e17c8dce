//! Two equal lamps in one place.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::scene::PointLight;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    // Adding 0 turns −0 into 0, so lamps with equal numbers have equal bits.
    let bits = |x: &f64| (x + 0.0).to_bits();
    let key = |lamp: &PointLight| {
        let numbers = lamp.position.iter().chain(&lamp.colour);
        let numbers: Vec<u64> = numbers.chain([&lamp.intensity]).map(bits).collect();
        numbers
    };
    let lamps = &context.scene.point_lights;
    let mut seen: FxHashMap<Vec<u64>, u32> = FxHashMap::default();
    let mut equal: FxHashMap<u32, u32> = FxHashMap::default();
    for lamp in lamps {
        let first = *seen.entry(key(lamp)).or_insert(lamp.id);
        if first != lamp.id {
            equal.insert(lamp.id, first);
        }
    }
    if equal.is_empty() {
        return;
    }
    let entities = context.scene.entities.iter();
    let spans: FxHashMap<u32, _> = entities.map(|e| (e.id, e.span)).collect();
    for lamp in lamps {
        if let Some(first) = equal.get(&lamp.id)
            && let (Some(&one), Some(&two)) = (spans.get(first), spans.get(&lamp.id))
        {
            let record = |span| context.params(span).map_or(span, |p| p.span());
            out.push(
                Diagnostic::new(Code::W333, record(two))
                    .case("lamps")
                    .with("one-id", first.to_string())
                    .with("two-id", lamp.id.to_string())
                    .label(record(one), "one"),
            );
        }
    }
}

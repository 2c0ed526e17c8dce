//! W309: a change that comes too late for the operation it was meant for.
//!
//! An operation takes its operands as they are at that point. A change that comes later is plainly
//! of no use if nothing takes the operand after it: neither another operation nor the render record. If
//! something does, then the one ID stands for several states of one thing, each used where it was
//! ready; that is a way to model, and nothing is said. Nor is anything said of an original that changes after it
//! was copied: that is what copies are for. What holds for operands holds for properties, too, which an
//! assignment takes as they are, and for the colours of a texture.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::syntax::Record;
use crate::syntax::table::{Effect, Family, RecordKind};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.has_broken() {
        return;
    }
    let late = late(context);
    if late.is_empty() {
        return;
    }
    let titles = context.titles();
    for Late {
        change,
        taker,
        more,
    } in late
    {
        let title = |id| Value::Term(titles.get(&id).copied().unwrap_or("object"));
        let document = context.document;
        let case = match taker.ty.family {
            Family::Operation => "",
            _ => "property",
        };
        out.push(
            Diagnostic::new(Code::W309, document.span(change.first, change.last))
                .case(case)
                .with("change", Value::Term(change.ty.title))
                .with("id", change.id.to_string())
                .with("type", title(change.id))
                .with("taker", title(taker.id))
                .with("taker-id", taker.id.to_string())
                .with("more", Value::Count(more))
                .label(document.span(taker.first, taker.last), "taken"),
        );
    }
}

/// A change that reaches nothing.
struct Late<'a> {
    change: &'a Record,
    /// The last record that took what is changed.
    taker: &'a Record,
    /// Further changes of the same thing.
    more: u64,
}

#[derive(Default)]
struct Entry<'a> {
    taker: Option<&'a Record>,
    change: Option<&'a Record>,
    more: u64,
}

fn late<'a>(context: &Context<'a>) -> Vec<Late<'a>> {
    let mut entries: FxHashMap<u32, Entry> = FxHashMap::default();
    // What is not there yet is not taken, and the record that defines it changes nothing.
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    // What these name is taken at the end of the file.
    let mut at_the_end: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        let kind = record.ty.kind;
        if matches!(
            kind,
            RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
        ) {
            at_the_end.extend(context.references(record));
            continue;
        }
        for id in context.references(record).filter(|id| defined.contains(id)) {
            entries.insert(
                id,
                Entry {
                    taker: Some(record).filter(|_| kind != RecordKind::Copy),
                    ..Entry::default()
                },
            );
        }
        // A promise changes nothing.
        let changes =
            !matches!(record.ty.effect, Effect::Defines(_)) && record.ty.family != Family::Bound;
        if changes
            && let Some(entry) = entries.get_mut(&record.id)
            && entry.taker.is_some()
        {
            match entry.change {
                None => entry.change = Some(record),
                Some(_) => entry.more += 1,
            }
        }
        if kind != RecordKind::Undefined {
            defined.insert(record.id);
        }
    }
    let mut late: Vec<Late> = (entries.into_iter())
        .filter(|(id, _)| !at_the_end.contains(id))
        .filter_map(|(_, e)| {
            Some(Late {
                change: e.change?,
                taker: e.taker?,
                more: e.more,
            })
        })
        .collect();
    late.sort_by_key(|l| l.change.first);
    late
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{found, messages};

    const BALLS: &str = "2 9 1\n3 9 0.5\n7 -701 1 0 0\n8 -201 0 1 0\n";

    #[track_caller]
    fn silent(records: &str) {
        let all = found(&(BALLS.to_owned() + records));
        assert!(
            !all.iter().any(|f| f.starts_with("W309")),
            "{records}: {all:?}"
        );
    }

    #[test]
    fn a_change_that_reaches_nothing() {
        for change in [
            "3 -1 0 1 0",
            "3 -2 30 1",
            "3 -701 1 0 0",
            "3 -299 7 8",
            "3 -203 2 2 2",
        ] {
            let scene = format!("{BALLS}4 -101 2 3\n{change}\n1 9999 4 0");
            let all = found(&scene);
            assert!(all.contains(&"W309 6:1".to_owned()), "{change}: {all:?}");
        }
        let scene = format!("{BALLS}4 -103 2 3\n3 -1 0 1 0\n3 -2 10 1\n3 -701 0 0 1");
        assert_eq!(found(&scene), ["W309 6:1"]);
        assert_eq!(
            messages(&scene),
            ["this translation of 3 comes too late for the difference 4, and so do 2 more changes"]
        );
        // Of two operations the last one is shown.
        let scene = format!("{BALLS}4 -103 2 3\n5 -101 4 3\n3 -1 0 1 0");
        assert!(messages(&scene)[0].contains("the union 5"));
    }

    #[test]
    fn properties() {
        let scene = format!("{BALLS}2 -299 7 8\n8 -203 1.5 1.5 1.5\n7 -701 0 1 0");
        assert_eq!(found(&scene), ["W309 6:1", "W309 7:1"]);
        let scene = format!("{BALLS}9 -399 2 2 7 7\n7 -701 0 1 0");
        assert_eq!(found(&scene), ["W309 6:1"]);
    }

    #[test]
    fn states_that_are_used() {
        silent("3 -1 0 1 0\n4 -101 2 3");
        // One ball in two places.
        silent("4 -101 2 3\n3 -1 0 1 0\n5 -101 4 3");
        silent("4 -103 2 3\n3 -1 0 1 0\n1 9999 3 0");
        silent("4 -103 2 3\n3 -1 0 1 0\n5 -105 3");
        silent("2 -299 7 0\n7 -701 0 1 0\n3 -299 7 0");
        silent("2 -299 7 0\n7 -701 0 1 0\n1 9999 2 7");
        // The result may change.
        silent("4 -101 2 3\n4 -1 0 1 0");
    }

    #[test]
    fn copies_and_promises() {
        silent("4 -105 3\n3 -1 0 1 0");
        silent("4 -103 2 3\n3 -601 -1 -1 -1 1 1 1");
    }

    #[test]
    fn a_definition_is_no_change() {
        let late = "14 -399 4 4 10 11\n10 -701 1 0 0\n11 -701 0 1 0\n";
        silent(late);
        silent(&format!("{late}10 -701 0 0 1\n"));
        silent("10 0\n14 -399 4 4 10 10\n10 -701 1 0 0\n");
        let taken = "10 0\n10 -701 1 0 0\n14 -399 4 4 10 10\n10 -701 0 0 1\n";
        assert!(found(&(BALLS.to_owned() + taken)).contains(&"W309 8:1".to_owned()));
    }

    #[test]
    fn a_broken_record_may_use_it() {
        silent("4 -101 2 3\n3 -1 0 1 0\n5 -101 4 3 3");
    }
}

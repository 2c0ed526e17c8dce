//! `zpg plan`: which effects a scene calls for.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

use serde::Serialize;

use super::terminal::{unprintable, width};
use super::{LookChoice, Status, complain, load_valid, refuse};
use crate::diagnostics::layout::hanging;
use crate::diagnostics::{Complaint, Error, Language, SourceFile, Value};
use crate::trace::plan::unseen::{Unseen, Why};
use crate::trace::plan::{Decision, Plan};

/// Tell which effects a scene calls for, and why
#[derive(Debug, clap::Args)]
#[command(after_help = "\
An effect counts where it can be seen: properties painted over, the tools of differences, objects that
the render record does not reach and parts that no ray can see turn nothing on. Code for an effect that
is off does not run. A part is not seen if it lies outside of the box of the render record, or strictly
inside an opaque solid that nothing opens.

Examples:
  zpg plan scene.zpg
  zpg plan scene.zpg --json")]
pub struct Args {
    /// The scene, as records or as JSON; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer<'a> {
    effects: Vec<Effect>,
    unreached: &'a [u32],
    unseen: Vec<UnseenPart>,
    shapes: &'a BTreeMap<&'static str, u32>,
    operations: &'a BTreeMap<&'static str, u32>,
    medium_depth: u32,
}

/// A part that no ray can see.
#[derive(Serialize)]
struct UnseenPart {
    id: u32,
    line: u32,
    why: String,
}

#[derive(Serialize)]
struct Effect {
    name: &'static str,
    on: bool,
    because: Vec<Because>,
    note: &'static str,
}

#[derive(Serialize)]
struct Because {
    id: u32,
    line: u32,
    text: &'static str,
}

impl UnseenPart {
    fn new(part: &Unseen, source: &SourceFile, language: Language) -> UnseenPart {
        let why = match part.why {
            Why::Outside => Complaint::new("unseen-outside"),
            Why::Inside(solid) => Complaint::new("unseen-inside")
                .with("type", Value::Term(solid.title))
                .with("id", solid.id.to_string()),
        };
        UnseenPart {
            id: part.id,
            line: source.position(part.span.start).line,
            why: why.wording(language),
        }
    }
}

impl Effect {
    fn new(decision: &Decision, source: &SourceFile) -> Effect {
        let because = decision.because.iter().map(|b| Because {
            id: b.id,
            line: source.position(b.span.start).line,
            text: b.text,
        });
        Effect {
            name: decision.effect.name(),
            on: decision.on,
            because: because.collect(),
            note: decision.note,
        }
    }
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let loaded = match load_valid(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    let Some(plan) = Plan::of_picture(&loaded.scene) else {
        return refuse(&loaded, Error::nothing_to_draw(), look);
    };
    let decisions = plan.effects.iter();
    let parts = plan.unseen.iter();
    let language = match args.json {
        true => Language::English,
        false => look.language(),
    };
    let part = |p| UnseenPart::new(p, &loaded.source, language);
    let answer = Answer {
        effects: decisions.map(|d| Effect::new(d, &loaded.source)).collect(),
        unreached: &plan.unreached,
        unseen: parts.map(part).collect(),
        shapes: &plan.shapes,
        operations: &plan.operations,
        medium_depth: plan.medium_depth,
    };
    let mut out = io::stdout().lock();
    let written = match args.json {
        true => serde_json::to_writer_pretty(&mut out, &answer)
            .map_err(io::Error::from)
            .and_then(|()| writeln!(out)),
        false => {
            let mut text = Vec::new();
            print(&mut text, &answer, language).and_then(|()| {
                let text = String::from_utf8_lossy(&text);
                let mut lines = text.lines().map(|line| hanging(line, width()));
                lines.try_for_each(|line| writeln!(out, "{line}"))
            })
        }
    };
    match written {
        // A reader that closes the pipe early is no failure.
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => Status::Clean,
        Err(e) => {
            complain(look, &unprintable(&e));
            Status::Failure
        }
        Ok(()) => Status::Clean,
    }
}

/// The most IDs, and the most unseen parts, that are printed for people; JSON has all.
const SHOWN: usize = 20;

/// The width of the first column in characters.
const WIDTH: usize = 20;

/// Writes the answer for people: the effects that are on with their reasons, those that are off, the counts of shapes
/// and operations, and the objects that are not drawn or not seen.
fn print(out: &mut dyn Write, answer: &Answer, language: Language) -> io::Result<()> {
    let say = |message, values: &[(&'static str, Value)]| language.say(message, values);
    let [on, off] = ["plan-on", "plan-off"].map(|message| say(message, &[]));
    let states = on.chars().count().max(off.chars().count());
    for effect in &answer.effects {
        let state = if effect.on { &on } else { &off };
        let (name, note) = (language.name(effect.name), language.name(effect.note));
        writeln!(out, "{name:<WIDTH$} {state:<states$}  {note}")?;
        for b in &effect.because {
            let values = [
                ("line", Value::from(b.line.to_string())),
                ("id", b.id.to_string().into()),
                ("text", Value::Term(b.text)),
            ];
            let because = say("plan-because", &values);
            writeln!(out, "{:<WIDTH$} {:<states$}  {because}", "", "")?;
        }
    }
    writeln!(out)?;
    let row = |out: &mut dyn Write, what: &'static str, text: &str| {
        writeln!(out, "{:<WIDTH$} {text}", say(what, &[]))
    };
    for (what, counts) in [
        ("plan-shapes", answer.shapes),
        ("plan-operations", answer.operations),
    ] {
        let count = |(name, n): (&&'static str, &u32)| {
            let values = [
                ("count", Value::from(n.to_string())),
                ("name", Value::Term(name)),
            ];
            say("plan-count", &values)
        };
        let each: Vec<String> = counts.iter().map(count).collect();
        let list = match each.is_empty() {
            true => say("plan-none", &[]),
            false => each.join(", "),
        };
        row(out, what, &list)?;
    }
    row(out, "plan-media", &answer.medium_depth.to_string())?;
    let ids = answer.unreached.iter().take(SHOWN).map(u32::to_string);
    let ids = ids.collect::<Vec<_>>().join(", ");
    let more = |n: usize| ("more", Value::from(n.to_string()));
    let list = match answer.unreached.len() {
        0 => say("plan-nothing", &[]),
        n if n > SHOWN => say("plan-ids-more", &[("ids", ids.into()), more(n - SHOWN)]),
        _ => ids,
    };
    row(out, "plan-not-drawn", &list)?;
    for part in answer.unseen.iter().take(SHOWN) {
        let values = [
            ("line", Value::from(part.line.to_string())),
            ("id", part.id.to_string().into()),
            ("why", part.why.clone().into()),
        ];
        row(out, "plan-not-seen", &say("plan-part", &values))?;
    }
    if let Some(left @ 1..) = answer.unseen.len().checked_sub(SHOWN) {
        row(out, "plan-not-seen", &say("plan-more", &[more(left)]))?;
    }
    Ok(())
}

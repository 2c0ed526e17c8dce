//! W340: by what comments say, a difference has its operands exchanged, or another operation is meant.

mod phrases;

use rustc_hash::{FxHashMap, FxHashSet};

use phrases::{
    SIGN, has_hole, is_cut, is_hole, is_reverse, is_taken_from, is_without, keeps_first, operation,
};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::scene::record::Params;
use crate::scene::{Node, NodeId};
use crate::solids::named_core;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};
use crate::syntax::words::{self, plain};

/// The cases of a union and of an intersection that comments describe as a difference.
const UNION: &str = "union";
const INTERSECTION: &str = "intersection";
/// The case of an operation that its comment calls another one.
const CALLED: &str = "called";
/// Words that show, before a word for a hole or for taking away, that this word is about another object.
const OF_ANOTHER: [&str; 16] = [
    "with", "having", "s", "in", "into", "v", "ve", "do", "for", "pro", "from", "od", "z", "ze",
    "of", "not",
];
/// Words that show, behind a word for a hole, that the hole is in the object of the comment.
const IN: [&str; 7] = ["in", "into", "through", "v", "ve", "do", "skrz"];
/// Most words of a comment that are read.
const MAX_COMMENT_WORDS: usize = 64;
/// Most comments on the records of one object that are read.
const MAX_COMMENTS: usize = 8;
/// Least number of equal letters at the beginning of two words that may be one word with two endings.
const STEM: usize = 4;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let said = said(context);
    out.extend(said.iter().map(|(p, _, meant)| finding(p, meant)));
}

/// The operations that W340 reports.
pub(super) fn contradicted(context: &Context) -> FxHashSet<NodeId> {
    said(context).into_iter().map(|(_, node, _)| node).collect()
}

/// The operations of a kind that W340 reports, since comments describe a difference, or one of the other operands.
pub(super) fn reported(context: &Context, own: RecordKind) -> FxHashSet<NodeId> {
    let said = said(context).into_iter();
    said.filter(|(p, _, meant)| p.ty.kind == own && meant.ty.kind == RecordKind::Difference)
        .map(|(_, node, _)| node)
        .collect()
}

/// Whether the comment on the difference at a place says that its first operand is the one that remains.
pub(crate) fn is_in_order(context: &Context, span: Span) -> bool {
    let scene = context.scene;
    // Nodes are in the order of the file.
    let at = scene
        .origins
        .binary_search_by_key(&span.start, |o| o.span.start);
    let Some((&Node::Difference(a, b), p)) = at
        .ok()
        .and_then(|at| Some((&scene.nodes[at], context.params(scene.origins[at].span)?)))
    else {
        return false;
    };
    let ids = [p.integer(0), p.integer(1)];
    let mut comments: FxHashMap<u32, Vec<Vec<String>>> = FxHashMap::default();
    for record in context.records() {
        if ids.contains(&i64::from(record.id)) {
            let own = context.record_params(record);
            let all = comments.entry(record.id).or_default();
            all.extend(own.own_comments().map(split));
            all.truncate(MAX_COMMENTS);
        }
    }
    let [one, two] = [(ids[0], a), (ids[1], b)].map(|(id, n)| operand(context, &comments, id, n));
    p.comments()
        .any(|said| keeps_first(&split_all(said, ids), &one, &two))
}

/// What comments say of an operation: the case of the finding, and the type of the operation that is meant.
struct Meant {
    case: &'static str,
    ty: &'static RecordType,
}

/// The operations that comments contradict, each with its record, its node and what the comments say.
fn said<'c>(context: &'c Context) -> Vec<(Params<'c>, NodeId, Meant)> {
    let mut out = Vec::new();
    if !context.document.contents.comments {
        return out;
    }
    let mut comments: FxHashMap<u32, Vec<Vec<String>>> = FxHashMap::default();
    let mut tools: FxHashSet<i64> = FxHashSet::default();
    for record in context.records() {
        let p = context.record_params(record);
        let own: Vec<Vec<String>> = p.own_comments().map(split).collect();
        if !own.is_empty() {
            let all = comments.entry(record.id).or_default();
            all.extend(own);
            all.truncate(MAX_COMMENTS);
        }
        if record.kind == RecordKind::Difference {
            tools.insert(p.integer(1));
        }
    }
    if comments.is_empty() {
        return out;
    }
    // Another rule reports operations of which nothing is left.
    let is_empty = |proven: &&Proven| matches!(proven.what, Proof::Empty(..));
    let empty = context.proven().iter().filter(is_empty);
    let empty: FxHashSet<NodeId> = empty.map(|proven| proven.node).collect();
    let scene = context.scene;
    for (node, made) in scene.nodes.iter().enumerate() {
        let node = node as NodeId;
        let (a, b, otherwise) = match *made {
            Node::Difference(a, b) => (a, b, None),
            Node::Union(a, b) => (a, b, Some(UNION)),
            Node::Intersection(a, b) => (a, b, Some(INTERSECTION)),
            _ => continue,
        };
        let origin = scene.origins[node as usize];
        let Some(p) = context
            .params(origin.span)
            .filter(|_| !empty.contains(&node))
        else {
            continue;
        };
        let operands = [(0, a), (1, b)].map(|(i, n)| operand(context, &comments, p.integer(i), n));
        let [one, two] = &operands;
        let difference = RecordType::of(RecordKind::Difference);
        if let Some(case) = otherwise {
            let of = |comment: &'c str| comment.split([',', ';', '.', ':', '(', ')']);
            let is_own = |said: &str| {
                let said = split_all(said, [one.id, two.id]);
                is_without(&said, one, two) || is_taken_from(&said, one, two)
            };
            // `disc with a hole`, where a comment calls the second operand a hole.
            let is_joined_hole = case == UNION
                && two.is_taken()
                && !one.is_taken()
                && p.comments().any(|said| has_hole(&split(said)));
            let is_said = is_joined_hole || p.comments().flat_map(of).any(is_own);
            // With a complement as an operand, the operation is a difference already: A ∩ −B is A − B.
            if is_said && !operands.iter().any(|o| o.is_complement) {
                let ty = difference;
                out.push((p, node, Meant { case, ty }));
                continue;
            }
        }
        let called = p.comments().find_map(|said| operation(&split(said)));
        if let Some(ty) = called.filter(|ty| ty.code != p.ty.code)
            && !operands.iter().any(|o| o.is_complement)
        {
            let case = CALLED;
            out.push((p, node, Meant { case, ty }));
            continue;
        }
        if otherwise.is_some() {
            continue;
        }
        let is_tool = tools.contains(&i64::from(p.id));
        let own = p
            .comments()
            .any(|said| is_reverse(&split_all(said, [one.id, two.id]), one, two));
        let case = match one.is_taken() && !two.is_taken() && !is_tool {
            _ if own => "",
            true => "taken",
            false => continue,
        };
        let ty = difference;
        out.push((p, node, Meant { case, ty }));
    }
    out
}

fn finding(p: &Params, meant: &Meant) -> Diagnostic {
    let [one, two] = [0, 1].map(|i| p.text_of(i).to_owned());
    let is_same = p.ty.code == meant.ty.code;
    let (span, number, edits) = match is_same {
        true => {
            let edits = [(0, &two), (1, &one)].map(|(i, text)| Edit {
                span: p.span_of(i, 1),
                text: text.clone(),
            });
            (p.span_of(0, 2), format!("{two} {one}"), edits.into())
        }
        false => {
            let text = meant.ty.code.to_string();
            let span = p.type_span();
            (span, text.clone(), vec![Edit { span, text }])
        }
    };
    let fix = Fix {
        title: "fix",
        values: vec![("number", quote(&number).into())],
        applicability: Applicability::Unsafe,
        edits,
    };
    Diagnostic::new(Code::W340, span)
        .case(meant.case)
        .with("id", p.id.to_string())
        .with("type", Value::Term(p.ty.title))
        .with("said", Value::Term(meant.ty.title))
        .with("one", one)
        .with("two", two)
        .fix(fix)
}

/// The words of a comment, without accents.
fn split(comment: &str) -> Vec<String> {
    words::of_text(comment).take(MAX_COMMENT_WORDS).collect()
}

/// The words of a comment without accents, with its signs of subtraction, and with the IDs of the operands if the
/// comment has both.
fn split_all(comment: &str, ids: [i64; 2]) -> Vec<String> {
    let is_open = |c: Option<char>| c.is_none_or(|c| c.is_whitespace() || c.is_ascii_digit());
    let mut before = None;
    let mut chars = comment.chars().peekable();
    let mut text = String::with_capacity(comment.len());
    while let Some(c) = chars.next() {
        match c {
            '-' | '–' | '−' if is_open(before) && is_open(chars.peek().copied()) => {
                text.extend([" ", SIGN, " "]);
            }
            c if c.is_alphanumeric() => text.push(c),
            _ => text.push(' '),
        }
        before = Some(c);
    }
    let words = text.split_whitespace().map(|w| match w {
        SIGN => w.to_owned(),
        w => plain(w),
    });
    let mut words: Vec<String> = words.take(MAX_COMMENT_WORDS).collect();
    let has_both = ids.iter().all(|id| words.contains(&id.to_string()));
    words.retain(|w| has_both || !w.starts_with(|c: char| c.is_ascii_digit()));
    words
}

/// An operand of a difference, a union or an intersection.
struct Operand<'a> {
    id: i64,
    /// The type of the shape that the operand is, or is cut out of; `None` for other objects.
    ty: Option<&'static RecordType>,
    is_complement: bool,
    comments: Vec<&'a [String]>,
}

fn operand<'a>(
    context: &Context,
    comments: &'a FxHashMap<u32, Vec<Vec<String>>>,
    id: i64,
    mut node: NodeId,
) -> Operand<'a> {
    let scene = context.scene;
    let core = named_core(scene, node).map(|(_, core)| core);
    let is_complement = matches!(core, Some(Node::Complement(_)));
    let ty = loop {
        match named_core(scene, node).map(|(_, core)| core) {
            Some(Node::Shape(s)) => break Some(scene.shapes[s as usize].ty()),
            Some(Node::Difference(first, _)) => node = first,
            _ => break None,
        }
    };
    let own = u32::try_from(id).ok().and_then(|id| comments.get(&id));
    Operand {
        id,
        ty,
        is_complement,
        comments: own.into_iter().flatten().map(Vec::as_slice).collect(),
    }
}

impl Operand<'_> {
    /// Whether a word names the operand: its shape or, if the word is no shape, what a comment calls it.
    fn is_called(&self, word: &str) -> bool {
        if let Ok(id) = word.parse::<i64>() {
            return id == self.id;
        }
        let shapes = words::shapes(word);
        match shapes.is_empty() {
            false => self
                .ty
                .is_some_and(|ty| shapes.iter().any(|s| s.code == ty.code)),
            true => self
                .comments
                .iter()
                .any(|c| c.iter().any(|w| is_one_word(w, word))),
        }
    }

    /// Whether a comment says that the operand is a hole or is taken away.
    fn is_taken(&self) -> bool {
        self.comments.iter().any(|said| {
            let is_taken = |&at: &usize| is_hole(&said[at]) || is_cut(said, at);
            let Some(at) = (0..said.len()).find(is_taken) else {
                return false;
            };
            let has =
                |words: &[String], any: &[&str]| words.iter().any(|w| any.contains(&w.as_str()));
            let is_other = |w: &String| !words::shapes(w).is_empty() && !self.is_called(w);
            let is_in = is_hole(&said[at]) && has(&said[at..], &IN);
            let is_another = has(&said[..at], &OF_ANOTHER) || is_in;
            !is_another && !said.iter().any(is_other)
        })
    }
}

fn begins(word: &str, beginnings: &[&str]) -> bool {
    beginnings.iter().any(|b| word.starts_with(b))
}

/// Whether two words are equal but for their endings of two letters at most, or are forms of one noun.
fn is_one_word(a: &str, b: &str) -> bool {
    let same = a.chars().zip(b.chars()).take_while(|(x, y)| x == y).count();
    let longer = a.chars().count().max(b.chars().count());
    same >= STEM && same + 2 >= longer || words::are_forms(a, b)
}

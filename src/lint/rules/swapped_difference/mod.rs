//! W340: a difference whose operands are in each other's place, or another operation that is a difference, by what
//! comments say.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::operations::{Proof, Proven};
use crate::scene::record::Params;
use crate::scene::{Node, NodeId};
use crate::solids::named_core;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType};
use crate::syntax::words::{self, plain};

/// The cases of operations that are a difference by their comments.
const UNION: &str = "union";
const INTERSECTION: &str = "intersection";
/// Between `cube` and what it is without: words as these.
const WITHOUT: [&str; 4] = ["without", "minus", "less", "bez"];
/// Between things of which only the first one is without something; the first word may be an article, too.
const AND: [&str; 4] = ["a", "and", "i", "plus"];
/// Before a hole: what has it.
const WITH: [&str; 5] = ["with", "having", "s", "se", "ma"];
/// Beginnings of words for a hole, without accents.
const HOLE: [&str; 7] = ["hole", "dira", "diry", "dire", "dirou", "dirami", "otvor"];
/// Words for what is taken away, without accents.
const TAKEN: [&str; 6] = [
    "subtracted",
    "odecte",
    "odecita",
    "odectena",
    "odecteny",
    "odectene",
];
/// Before a hole or what is taken away: that it is something else.
const OF_ANOTHER: [&str; 12] = [
    "with", "having", "s", "in", "v", "ve", "for", "pro", "from", "od", "of", "not",
];
/// Behind a hole: that it is in this.
const IN: [&str; 7] = ["in", "into", "through", "v", "ve", "do", "skrz"];
/// So many words are between a name and what is said of it at most.
const MAX_WORDS_BETWEEN: usize = 3;
/// Words of a comment that are looked at.
const MAX_COMMENT_WORDS: usize = 64;
/// Comments on the records of one object that are looked at.
const MAX_COMMENTS: usize = 8;
/// Words of which so many letters are the same may be one word with two endings.
const STEM: usize = 4;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let said = said(context);
    out.extend(said.iter().map(|(p, _, case)| finding(p, case)));
}

/// The intersections of which W340 says that a difference is meant.
pub(super) fn intersections(context: &Context) -> FxHashSet<NodeId> {
    let said = said(context).into_iter();
    said.filter(|(_, _, case)| *case == INTERSECTION)
        .map(|(_, node, _)| node)
        .collect()
}

/// The operations that comments say otherwise, with the case of each.
fn said<'c>(context: &'c Context) -> Vec<(Params<'c>, NodeId, &'static str)> {
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
    // That nothing is left has a rule of its own.
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
        if let Some(case) = otherwise {
            let of = |comment: &'c str| comment.split([',', ';', '.', ':', '(', ')']);
            let is_own = |said: &str| is_without(&split(said), one, two);
            let is_said = p.comments().flat_map(of).any(is_own);
            // A ∩ −B is A − B.
            if is_said && !operands.iter().any(|o| o.is_complement) {
                out.push((p, node, case));
            }
            continue;
        }
        let is_tool = tools.contains(&i64::from(p.id));
        let own = p
            .comments()
            .map(split)
            .any(|said| is_reverse(&said, one, two));
        let case = match one.is_taken() && !two.is_taken() && !is_tool {
            _ if own => "",
            true => "taken",
            false => continue,
        };
        out.push((p, node, case));
    }
    out
}

fn finding(p: &Params, case: &'static str) -> Diagnostic {
    let [one, two] = [0, 1].map(|i| p.text_of(i).to_owned());
    let is_difference = p.ty.kind == RecordKind::Difference;
    let (span, number, edits) = match is_difference {
        true => {
            let edits = [(0, &two), (1, &one)].map(|(i, text)| Edit {
                span: p.span_of(i, 1),
                text: text.clone(),
            });
            (p.span_of(0, 2), format!("{two} {one}"), edits.into())
        }
        false => {
            let text = RecordType::of(RecordKind::Difference).code.to_string();
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
        .case(case)
        .with("id", p.id.to_string())
        .with("one", one)
        .with("two", two)
        .fix(fix)
}

/// The words of a comment, without accents.
fn split(comment: &str) -> Vec<String> {
    let words = comment.split(|c: char| !c.is_alphabetic());
    let words = words.filter(|w| !w.is_empty()).map(plain);
    words.take(MAX_COMMENT_WORDS).collect()
}

/// An operand of a difference.
struct Operand<'a> {
    /// The type of the shape that it is, or is cut out of.
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
        ty,
        is_complement,
        comments: own.into_iter().flatten().map(Vec::as_slice).collect(),
    }
}

impl Operand<'_> {
    /// Whether a word names the operand: its shape or, if the word is no shape, what a comment calls it.
    fn is_called(&self, word: &str) -> bool {
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

    /// Whether a comment says that it is a hole or is taken away.
    fn is_taken(&self) -> bool {
        self.comments.iter().any(|said| {
            let is_hole = |w: &String| begins(w, &HOLE);
            let is_taken = |w: &String| is_hole(w) || TAKEN.contains(&w.as_str());
            let Some(at) = said.iter().position(is_taken) else {
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

/// Whether a comment on a difference says that its first operand is taken from the second one.
fn is_reverse(said: &[String], one: &Operand, two: &Operand) -> bool {
    let is_hole = |w: &String| begins(w, &HOLE);
    // A shape that is cut out of something else than one shape may be of any kind.
    let is_with_hole = |at: usize| {
        let mut behind = said[at + 1..].iter().take(MAX_WORDS_BETWEEN + 1);
        one.ty.is_some()
            && WITH.contains(&said[at].as_str())
            && behind.any(is_hole)
            && named_before(said, at, two, one).is_some()
    };
    is_without(said, two, one) || (1..said.len()).any(is_with_hole)
}

/// Whether a comment says that one operand is there without another one.
fn is_without(said: &[String], whole: &Operand, taken: &Operand) -> bool {
    (1..said.len())
        .filter(|&at| WITHOUT.contains(&said[at].as_str()))
        .any(|at| {
            let mut behind = said[at + 1..].iter().take(MAX_WORDS_BETWEEN + 1);
            let first = behind.next().into_iter();
            let behind = behind.take_while(|w| !AND.contains(&w.as_str()));
            let named = first.chain(behind).find(|w| is_name(w, whole, taken));
            named.is_some_and(|w| taken.is_called(w) && !whole.is_called(w))
                && named_before(said, at, whole, taken).is_some_and(|what| what.len() > 1)
        })
}

/// The nearest name before a place in a comment, if it is that of the first operand alone.
fn named_before<'s>(
    said: &'s [String],
    at: usize,
    first: &Operand,
    second: &Operand,
) -> Option<&'s String> {
    let mut before = said[..at].iter().rev().take(MAX_WORDS_BETWEEN + 1);
    let name = before.find(|w| is_name(w, first, second))?;
    (first.is_called(name) && !second.is_called(name)).then_some(name)
}

/// Whether a word is a name of a shape, or of one of two operands.
fn is_name(word: &str, one: &Operand, two: &Operand) -> bool {
    !words::shapes(word).is_empty() || one.is_called(word) || two.is_called(word)
}

fn begins(word: &str, beginnings: &[&str]) -> bool {
    beginnings.iter().any(|b| word.starts_with(b))
}

/// Whether two words are one but for their endings, two letters or less.
fn is_one_word(a: &str, b: &str) -> bool {
    let same = a.chars().zip(b.chars()).take_while(|(x, y)| x == y).count();
    let longer = a.chars().count().max(b.chars().count());
    same >= STEM && same + 2 >= longer
}

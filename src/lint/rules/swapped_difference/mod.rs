//! W340: a difference whose operands are in each other's place, by what comments say.

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

/// Between `cube` and what it is without: words as these.
const WITHOUT: [&str; 4] = ["without", "minus", "less", "bez"];
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
    if !context.document.contents.comments {
        return;
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
        return;
    }
    // That nothing is left has a rule of its own.
    let is_empty = |proven: &&Proven| matches!(proven.what, Proof::Empty(..));
    let empty = context.proven().iter().filter(is_empty);
    let empty: FxHashSet<NodeId> = empty.map(|proven| proven.node).collect();
    let scene = context.scene;
    for (node, made) in scene.nodes.iter().enumerate() {
        let node = node as NodeId;
        let Node::Difference(a, b) = made else {
            continue;
        };
        let origin = scene.origins[node as usize];
        let Some(p) = context
            .params(origin.span)
            .filter(|_| !empty.contains(&node))
        else {
            continue;
        };
        let operands =
            [(0, *a), (1, *b)].map(|(i, n)| operand(context, &comments, p.integer(i), n));
        let [one, two] = &operands;
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
        out.push(finding(&p, case));
    }
}

fn finding(p: &Params, case: &'static str) -> Diagnostic {
    let [one, two] = [0, 1].map(|i| p.text_of(i).to_owned());
    let edits = [(0, &two), (1, &one)].map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text: text.clone(),
    });
    let fix = Fix {
        title: "fix",
        values: vec![("number", quote(&format!("{two} {one}")).into())],
        applicability: Applicability::Unsafe,
        edits: edits.into(),
    };
    Diagnostic::new(Code::W340, p.span_of(0, 2))
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
    comments: Vec<&'a [String]>,
}

fn operand<'a>(
    context: &Context,
    comments: &'a FxHashMap<u32, Vec<Vec<String>>>,
    id: i64,
    mut node: NodeId,
) -> Operand<'a> {
    let scene = context.scene;
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
    let is_name =
        |w: &&String| !words::shapes(w).is_empty() || one.is_called(w) || two.is_called(w);
    let between = MAX_WORDS_BETWEEN + 1;
    (1..said.len()).any(|at| {
        let word = said[at].as_str();
        if !WITHOUT.contains(&word) && !WITH.contains(&word) {
            return false;
        }
        let what = said[..at].iter().rev().take(between).find(is_name);
        let Some(what) = what.filter(|w| two.is_called(w) && !one.is_called(w)) else {
            return false;
        };
        let mut behind = said[at + 1..].iter().take(between);
        if WITHOUT.contains(&word) {
            let is_right = |w: &String| one.is_called(w) && !two.is_called(w);
            return what.len() > 1 && behind.find(is_name).is_some_and(is_right);
        }
        // A shape that is cut out of something else than one shape may be of any kind.
        one.ty.is_some() && behind.any(|w| begins(w, &HOLE))
    })
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

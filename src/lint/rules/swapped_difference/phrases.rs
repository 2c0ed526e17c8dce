//! How comments say which of two operands is taken from the other one.

use super::{Operand, begins};
use crate::syntax::table::{RecordKind, RecordType};
use crate::syntax::words::{self, HOLE};

/// The word that stands for the sign of a subtraction among the words of a comment.
pub(super) const SIGN: &str = "-";
/// Words between an object and the one that it is without, as in `cube without ball`.
const WITHOUT: [&str; 5] = ["without", "minus", "less", "bez", SIGN];
/// Words that end the search for a name behind one of [`WITHOUT`]: `cube without ball and cone`. Right behind that
/// word, `a` is an article.
const AND: [&str; 4] = ["a", "and", "i", "plus"];
/// Words between an object and the hole that it has.
const WITH: [&str; 5] = ["with", "having", "s", "se", "ma"];
/// Words for a hole, without accents, which may have an ending. A participle that begins with one of them is longer.
const NOTCH: [&str; 5] = ["notch", "recess", "dent", "vyrez", "zarez"];
/// The longest ending of one of the words [`NOTCH`].
const MAX_ENDING: usize = 2;
/// Beginnings of words that mean a hole behind one of [`WITH`].
const HOLLOW: [&str; 6] = ["hollow", "groove", "slot", "prohlub", "vyhloub", "drazk"];
/// Beginnings of words for a bore, without accents.
const BORE: [&str; 2] = ["bore", "vrt"];
/// Words, without accents, that say by themselves that the object is taken away.
const TAKEN: [&str; 11] = [
    "subtracted",
    "removed",
    "odecte",
    "odecita",
    "odectena",
    "odecteny",
    "odectene",
    "odectou",
    "odecitana",
    "odecitany",
    "odecitane",
];
/// Words that show, before a verb of taking away, that the object is what is taken: `what is cut away`.
const DONE: [&str; 9] = [
    "what", "that", "which", "to", "se", "bude", "bylo", "byla", "je",
];
/// Words that show, behind a verb of taking away, that the object is what is taken, not what remains.
const AWAY: [&str; 4] = ["away", "out", "off", "from"];
/// Beginnings of words for a difference, without accents. The first object that is named behind them is the one that
/// remains.
const DIFFERENCE: [&str; 2] = ["difference", "rozdil"];
/// Words before the name of an operation.
const ARTICLES: [&str; 4] = ["the", "a", "an", "csg"];
/// Most words between a name and what is said of it.
const MAX_WORDS_BETWEEN: usize = 3;

/// Words of one language for taking away, without accents.
struct Taking {
    /// Beginnings of the verbs.
    verbs: &'static [&'static str],
    /// Words before the object that remains.
    from: &'static [&'static str],
    /// Words behind a participle and before the object that is taken.
    by: &'static [&'static str],
    /// Words between the object that remains and the one that is taken.
    with: &'static [&'static str],
}

const TAKING: [Taking; 2] = [
    Taking {
        verbs: &[
            "subtract", "remov", "cut", "carv", "drill", "scoop", "take", "taking", "took",
        ],
        from: &["from", "of"],
        by: &["by", "with"],
        with: &["with", "having"],
    },
    Taking {
        verbs: &[
            "odect", "odecit", "odecet", "odecis", "ubra", "uber", "ubir", "odebr", "odeber",
            "odebir", "odstran", "vyriz", "vyrez", "vydlab", "vyvrt", "vyhloub", "vykroj", "odriz",
            "odrez",
        ],
        from: &["od", "z", "ze"],
        by: &[],
        with: &["s", "se"],
    },
];
/// Endings of Czech participles, without accents.
const PARTICIPLE: [&str; 6] = ["ny", "na", "ne", "ty", "ta", "te"];
/// Endings of Czech nouns in the instrumental case, without accents.
const INSTRUMENTAL: [&str; 4] = ["i", "ou", "em", "y"];

/// Whether a word means a hole.
pub(super) fn is_hole(word: &str) -> bool {
    let mut endings = NOTCH.iter().filter_map(|notch| word.strip_prefix(notch));
    begins(word, &HOLE) || endings.any(|ending| ending.len() <= MAX_ENDING)
}

/// Whether the word `at` of a comment on an operand says that the operand is taken away.
pub(super) fn is_cut(said: &[String], at: usize) -> bool {
    let word = said[at].as_str();
    if TAKEN.contains(&word) {
        return true;
    }
    let before = &said[at.saturating_sub(MAX_WORDS_BETWEEN)..at];
    let is_done = before.iter().any(|w| DONE.contains(&w.as_str()));
    let [english, czech] = &TAKING;
    let behind = said.get(at + 1).map(String::as_str);
    let is_away = behind.is_some_and(|w| AWAY.contains(&w));
    match word {
        // In `the cut`, the object is taken away; in `cut ball`, it remains.
        "cut" if at + 1 == said.len() && at < MAX_WORDS_BETWEEN => {
            is_done || before.iter().all(|w| words::shapes(w).is_empty())
        }
        "cutter" | "cutout" => true,
        // In `cuts off the top`, the object is what cuts.
        "cuts" if at + 1 < MAX_WORDS_BETWEEN => true,
        _ if at == 0 && begins(word, czech.verbs) && is_active(word) => true,
        _ if begins(word, czech.verbs) => is_done && !word.ends_with("ni"),
        _ => is_done && is_away && begins(word, english.verbs),
    }
}

/// Whether a Czech verb is in the third person, as `odřezává` and `vyřízne`.
fn is_active(word: &str) -> bool {
    ["ava", "ira", "izne"].iter().any(|end| word.ends_with(end))
}

/// Whether a comment on a union has a word for a hole: `disc with a bore`.
pub(super) fn has_hole(said: &[String]) -> bool {
    said.iter()
        .any(|w| is_hole(w) || begins(w, &HOLLOW) || begins(w, &BORE))
}

/// Whether a comment on a difference says that its first operand is taken from the second one.
pub(super) fn is_reverse(said: &[String], one: &Operand, two: &Operand) -> bool {
    let is_hole = |w: &String| is_hole(w) || begins(w, &HOLLOW);
    // The type of the first operand must be known: an operand that is not made of one shape may have any name.
    let is_with_hole = |at: usize| {
        let mut behind = said[at + 1..].iter().take(MAX_WORDS_BETWEEN + 1);
        one.ty.is_some()
            && WITH.contains(&said[at].as_str())
            && behind.any(is_hole)
            && named_before(said, at, two, one).is_some()
    };
    is_without(said, two, one)
        || (1..said.len()).any(is_with_hole)
        || is_taken_from(said, two, one) && !is_taken_from(said, one, two)
}

/// Whether a comment on a difference says that its first operand is the one that remains: `cube without pips`, `cube with
/// a hole`. The second one need not be named.
pub(super) fn keeps_first(said: &[String], one: &Operand, two: &Operand) -> bool {
    let is_hole = |w: &String| is_hole(w) || begins(w, &HOLLOW) || begins(w, &BORE);
    let is_first = |w: &String| one.is_called(w) && !two.is_called(w);
    let says = |at: usize| {
        let word = said[at].as_str();
        let (is_without, is_with) = (WITHOUT.contains(&word), WITH.contains(&word));
        if !is_without && !is_with {
            return false;
        }
        let behind = &said[at + 1..said.len().min(at + 2 + MAX_WORDS_BETWEEN)];
        named_before(said, at, one, two).is_some()
            && (is_without && !behind.iter().any(is_first) || is_with && behind.iter().any(is_hole))
    };
    (1..said.len()).any(says) || is_taken_from(said, one, two)
}

/// Whether a comment says that the operand `whole` is without the operand `taken`.
pub(super) fn is_without(said: &[String], whole: &Operand, taken: &Operand) -> bool {
    (1..said.len())
        .filter(|&at| WITHOUT.contains(&said[at].as_str()))
        .any(|at| {
            // A dash is a minus only right between two names; between other words it joins sentences.
            let between = match said[at] == SIGN {
                true => 0,
                false => MAX_WORDS_BETWEEN,
            };
            let mut behind = said[at + 1..].iter().take(between + 1);
            let first = behind.next().into_iter();
            let behind = behind.take_while(|w| !AND.contains(&w.as_str()));
            let named = first.chain(behind).find(|w| is_name(w, whole, taken));
            let before = &said[at.saturating_sub(between + 1)..at];
            named.is_some_and(|w| taken.is_called(w) && !whole.is_called(w))
                && named_before(before, before.len(), whole, taken)
                    .is_some_and(|what| what.len() > 1 || is_number(what))
        })
}

/// The operation that a comment begins with, as in `difference` or `the union of the legs`. `None` if the comment names
/// another operation, too.
pub(super) fn operation(said: &[String]) -> Option<&'static RecordType> {
    let named = |w: &String| {
        let kind = match w.as_str() {
            "union" | "sjednoceni" => RecordKind::Union,
            "intersection" | "prunik" => RecordKind::Intersection,
            "difference" | "rozdil" => RecordKind::Difference,
            _ => return None,
        };
        Some(RecordType::of(kind))
    };
    let is_article = |w: &&String| ARTICLES.contains(&w.as_str());
    let behind = said.iter().take_while(is_article).count();
    let first = named(said.get(behind)?)?;
    let mut others = said[behind + 1..].iter().filter_map(named);
    others.next().is_none().then_some(first)
}

/// Whether a comment says that the operand `taken` is taken from the operand `whole`, or calls the two a difference in
/// this order. `false` if the comment names anything else.
pub(super) fn is_taken_from(said: &[String], whole: &Operand, taken: &Operand) -> bool {
    let is = |o: &Operand, other: &Operand, w: &str| o.is_called(w) && !other.is_called(w);
    let is_whole = |w: &String| is(whole, taken, w);
    let is_taken = |w: &String| is(taken, whole, w);
    let names: Vec<usize> = (0..said.len())
        .filter(|&i| is_name(&said[i], whole, taken))
        .collect();
    let &[first, last] = &names[..] else {
        return false;
    };
    let order = [is_whole(&said[first]), is_taken(&said[last])];
    let (is_in_order, is_against) = (
        order == [true; 2],
        is_taken(&said[first]) && is_whole(&said[last]),
    );
    if !is_in_order && !is_against {
        return false;
    }
    let is_difference = |w: &String| begins(w, &DIFFERENCE);
    if is_in_order && said[..first].iter().any(is_difference) {
        return true;
    }
    let remains = if is_in_order { first } else { last };
    TAKING.iter().any(|taking| {
        let is_verb = |w: &String| begins(w, taking.verbs);
        let Some(verb) = said.iter().position(is_verb) else {
            return false;
        };
        let reach = remains.saturating_sub(MAX_WORDS_BETWEEN + 1)..remains;
        // In `koule, od které se odečte kostka`, the cube is taken, since `od` stands before the verb.
        let from = said[reach].iter().rev().take_while(|w| !is_verb(w));
        if from.into_iter().any(|w| taking.from.contains(&w.as_str())) {
            return true;
        }
        let between = first < verb && verb < last;
        let is_by = |w: &String| taking.by.contains(&w.as_str());
        let is_participle = PARTICIPLE.iter().any(|end| said[verb].ends_with(end));
        let is_instrumental = |i: usize| INSTRUMENTAL.iter().any(|end| said[i].ends_with(end));
        let has_from = said.iter().any(|w| taking.from.contains(&w.as_str()));
        match is_in_order {
            // Examples: `block with a ball taken away`, `block cut by a ball`, `kvádr s odečtenou koulí`.
            true => {
                let behind = &said[first + 1..last];
                let is_with = |w: &String| taking.with.contains(&w.as_str());
                !has_from
                    && (behind.iter().any(is_with) && verb > first
                        || between && said[verb..last].iter().any(is_by)
                        || between && is_participle && is_instrumental(last))
            }
            // Example: `koulí vydlabaný kvádr`.
            false => {
                !has_from && between && is_participle && first + 1 == verb && is_instrumental(first)
            }
        }
    })
}

/// The nearest name before the word `at` of a comment, if it is a name of the first operand alone.
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

fn is_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit())
}

//! Scenes for the formatter: records that are right, laid out in any way, some of them then spoiled.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use zpg::internals::syntax::table::{Effect, Kind, Param, ParamKind, RECORD_TYPES, RecordType};

/// What stands between two tokens.
const GAPS: &[&str] = &[
    " ",
    "  ",
    "\t",
    "\n",
    "\n\n",
    "\n \n\n   ",
    "\n    ",
    " # c # ",
    "# střed koule #",
    " # 半径 # # žluťoučký kůň #\n",
    "\n# own line #\n",
    "\n  # leads # ",
    " # two\n   lines # ",
    "\n# 7 9 1\n 8 9 2 #\n",
    " , ",
    " # zpg: allow(W302) # ",
];

/// What stands behind a record that is laid out as people do it.
const ENDS: &[&str] = &[
    "\n",
    "\n",
    "\n",
    "\n\n",
    "\n\n\n\n",
    " # comment #\n",
    "   # delší komentář k záznamu #\n",
    "   # a comment that takes more room than the others, and goes on for about ninety characters #\n",
    " 0 # behind #\n",
    "\n0 # heading #\n",
    "\n\n0 # heading #\n",
    "\n# bare #\n",
    "\n0 # zpg: allow(W302, W307) #\n",
    " # zpg: allow(W302) #\n",
    "  ",
];

const REALS: &[&str] = &[
    "0",
    "1",
    "2",
    "-1",
    "3",
    "9",
    "0.5",
    "1.50",
    "+7",
    "-0.25",
    ".5",
    "5.",
    "-0.0",
    "1E+3",
    "1e-5",
    "0.1234567890123456",
    "1e300",
    "12345.678",
    "-13.5",
    "100",
    "0.00001",
    "-101",
];

/// What may go wrong in a record.
#[derive(Debug, Clone)]
pub enum Fault {
    None,
    /// A token too many, or instead of another.
    Put(Index, &'static str),
    Replace(Index, &'static str),
    Drop(Index),
}

/// One record to be.
#[derive(Debug, Clone)]
pub struct Plan {
    ty: Index,
    values: Vec<Index>,
    count: usize,
    optional: bool,
    /// Gaps inside: `None` is a space.
    gaps: Vec<Option<&'static str>>,
    end: &'static str,
    fault: Fault,
}

fn fault() -> impl Strategy<Value = Fault> {
    let odd = select(
        &[
            "7", "-101", "0", "0,5", "x", "1e999", "@", "# open", "\"", "1.5",
        ][..],
    );
    prop_oneof![
        40 => Just(Fault::None),
        1 => (any::<Index>(), odd.clone()).prop_map(|(i, t)| Fault::Put(i, t)),
        1 => (any::<Index>(), odd).prop_map(|(i, t)| Fault::Replace(i, t)),
        1 => any::<Index>().prop_map(Fault::Drop),
    ]
}

/// `free` says how often, in thousandths, something else than a space stands in a record.
fn plan(free: u32, faults: bool) -> impl Strategy<Value = Plan> {
    let gap = prop_oneof![
        1000 - free => Just(None),
        free => select(GAPS).prop_map(Some),
    ];
    let count = prop_oneof![8 => 2usize..8, 2 => 8usize..40];
    (
        any::<Index>(),
        vec(any::<Index>(), 4..30),
        count,
        any::<bool>(),
        vec(gap, 1..24),
        select(ENDS),
        if faults {
            fault().boxed()
        } else {
            Just(Fault::None).boxed()
        },
    )
        .prop_map(|(ty, values, count, optional, gaps, end, fault)| Plan {
            ty,
            values,
            count,
            optional,
            gaps,
            end,
            fault,
        })
}

/// A text: most are laid out in lines, some are not; half of them are without faults.
pub fn scene() -> impl Strategy<Value = String> {
    let plans = (select(&[0, 5, 100, 400, 1000][..]), any::<bool>())
        .prop_flat_map(|(free, faults)| vec(plan(free, faults), 0..14));
    // Runs of one type are what alignment is about.
    let repeat = vec(1usize..4, 14);
    let breaks = select(&["\n", "\n", "\r\n"][..]);
    let mark = prop_oneof![9 => Just(""), 1 => Just("\u{feff}")];
    (plans, repeat, breaks, mark).prop_map(|(plans, repeat, breaks, mark)| {
        let mut builder = Builder::default();
        for (plan, repeat) in plans.iter().zip(repeat) {
            for shift in 0..repeat {
                builder.add(plan, shift);
            }
        }
        mark.to_owned() + &builder.text.replace('\n', breaks)
    })
}

/// The text so far and what its IDs stand for.
#[derive(Default)]
struct Builder {
    text: String,
    known: Vec<(u32, Kind)>,
    next: u32,
}

impl Builder {
    fn any(&self, kinds: &[Kind], index: &Index) -> Option<u32> {
        let of_kind = |k: &&(u32, Kind)| kinds.contains(&k.1);
        let found: Vec<u32> = self.known.iter().filter(of_kind).map(|k| k.0).collect();
        (!found.is_empty()).then(|| *index.get(&found))
    }

    /// Adds a record, unless there is nothing that it could refer to.
    fn add(&mut self, plan: &Plan, shift: usize) {
        let ty = plan.ty.get(RECORD_TYPES);
        let mut values = plan.values.iter().cycle().skip(shift);
        let mut next = || values.next().expect("it goes round");
        let fresh = self.next + 2;
        let (id, defines) = match ty.effect {
            Effect::Defines(Kind::Render) => (1, Some(Kind::Render)),
            Effect::Defines(kind) => (fresh, Some(kind)),
            Effect::DefinesOrChanges(kind, _) if shift.is_multiple_of(2) => (fresh, Some(kind)),
            Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds) => {
                match self.any(kinds, next()) {
                    Some(id) => (id, None),
                    None => return,
                }
            }
        };
        let mut tokens = vec![id.to_string(), ty.code.to_string()];
        for param in params(ty, plan) {
            let token = match param.kind {
                ParamKind::Real => (*next().get(REALS)).to_owned(),
                ParamKind::Count => plan.count.to_string(),
                ParamKind::Integer => (1 + next().index(3)).to_string(),
                ParamKind::FileName => "a.png".to_owned(),
                ParamKind::Reference { kinds, or_none } => match self.any(kinds, next()) {
                    Some(id) => id.to_string(),
                    None if or_none => "0".to_owned(),
                    None => return,
                },
            };
            tokens.push(token);
        }
        if let Some(kind) = defines {
            self.next += 1;
            self.known.push((id, kind));
        }
        spoil(&mut tokens, &plan.fault);
        self.write(&tokens, plan);
    }

    fn write(&mut self, tokens: &[String], plan: &Plan) {
        for (i, token) in tokens.iter().enumerate() {
            self.text.push_str(token);
            let gap = plan.gaps[i % plan.gaps.len()];
            match gap {
                _ if i + 1 == tokens.len() => self.text.push_str(plan.end),
                None => self.text.push(' '),
                Some(gap) => self.text.push_str(gap),
            }
        }
    }
}

fn params(ty: &'static RecordType, plan: &Plan) -> Vec<&'static Param> {
    let repeated = (ty.repeats.iter())
        .flat_map(|group| std::iter::repeat_n(group.iter(), plan.count).flatten());
    let optional = ty.optional.iter().filter(|_| plan.optional);
    ty.params.iter().chain(repeated).chain(optional).collect()
}

fn spoil(tokens: &mut Vec<String>, fault: &Fault) {
    match fault {
        Fault::None => {}
        Fault::Put(at, token) => tokens.insert(at.index(tokens.len() + 1), (*token).to_owned()),
        Fault::Replace(at, token) => {
            let at = at.index(tokens.len());
            tokens[at] = (*token).to_owned();
        }
        Fault::Drop(at) => {
            tokens.remove(at.index(tokens.len()));
        }
    }
}

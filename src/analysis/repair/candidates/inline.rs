//! Colours in the place of their IDs: `1 9999 2 0.2 0.3 0.4`.

use super::{Candidate, Habit, LineContext};
use crate::analysis::colours;
use crate::diagnostics::{Applicability, Edit, Fix, Span, Value};
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{Kind, Param, ParamKind, RecordKind, RecordType};
use crate::syntax::{Captions, Item};

/// How many numbers a colour has.
const PARTS: usize = 3;
/// The most parameters of a record that may be colours, with the optional ones.
const PLACES: u32 = 2;
/// The most operands of one operation that are split into several operations.
pub(super) const MAX_OPERANDS: usize = 16;
pub(super) const MAX_ID: u32 = i32::MAX as u32;

/// A colour where an ID belongs: its place in the text, and its numbers.
struct Inline {
    span: Span,
    numbers: String,
    /// Whether its name stands there.
    is_name: bool,
}

/// Parts of a colour that are the same but for rounding are not further apart.
const PART_GAP: f64 = 0.02;

const TITLE: &str = "fix-inline";

/// The title of fixes that write the IDs of colours which have records.
const ID_TITLE: &str = "fix-colour-id";

/// The title of fixes that give an ID to a part of an operation.
pub(super) const PARTS_TITLE: &str = "fix-parts";

/// The titles of fixes that give a record another ID: in the record alone, and also in the assignments of the ID.
pub(super) const FREE_TITLE: &str = "fix-free-id";
pub(super) const OWN_TITLE: &str = "fix-own-id";
/// The title of fixes that give each of several operations on one object an ID.
pub(super) const CHAIN_TITLE: &str = "fix-chain";
/// The title of fixes that give an ID to a record that has none.
pub(super) const NAMED_TITLE: &str = "fix-named-id";

/// The titles of fixes that write records for a block of another program. The new text begins with the ID of the
/// record.
pub(super) const CLAUSES_TITLE: &str = "fix-clauses";
pub(super) const BLOCK_TITLE: &str = "fix-block";
pub(super) const ANGLE_TITLE: &str = "fix-block-angle";
pub(super) const PLANE_TITLE: &str = "fix-block-plane";
/// The title of fixes that make two triangles of four corners. The new text begins with the ID of the first triangle.
pub(super) const QUAD_TITLE: &str = "fix-quad";

/// The new IDs that a fix gives to records.
pub(crate) fn new_ids(fix: &Fix) -> impl Iterator<Item = u32> {
    let is = move |titles: &[&str]| titles.contains(&fix.title);
    let is_one = is(&[
        TITLE,
        PARTS_TITLE,
        FREE_TITLE,
        OWN_TITLE,
        NAMED_TITLE,
        CHAIN_TITLE,
    ]);
    let ids = fix.edits.iter().filter(move |_| is_one);
    let ids = ids.filter_map(|edit| edit.text.trim_end().parse().ok());
    let is_block = is(&[
        CLAUSES_TITLE,
        BLOCK_TITLE,
        ANGLE_TITLE,
        PLANE_TITLE,
        QUAD_TITLE,
    ]);
    let mut heads = fix.edits.iter().filter(move |_| is_block);
    let head = heads.find_map(|edit| edit.text.split_once(' ')?.0.parse().ok());
    ids.chain(head)
}

/// Whether a fix puts IDs in the place of colours.
pub(super) fn is_inline(fix: &Fix) -> bool {
    [TITLE, ID_TITLE].contains(&fix.title)
}

impl LineContext<'_> {
    /// Guesses that colours stand in the places of their IDs, and makes them records of their own above this one. Their
    /// new IDs are none of `used`.
    pub(super) fn inline(&self, used: &[u32], out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| !ty.is_counted()) else {
            return;
        };
        for chosen in 1..1 << PLACES {
            let least = ty.params.len();
            let all = [least, least + ty.optional.len()];
            let lists = all.iter().filter_map(|&n| self.inlined(ty, n, chosen));
            out.extend(
                lists
                    .filter_map(|list| self.with_records(&list, used))
                    .take(1),
            );
        }
        out.extend(self.colours_alone(ty, used));
    }

    /// A guess at a checkerboard for which two colours stand, and no numbers of fields: one field of each colour.
    fn colours_alone(&self, ty: &RecordType, used: &[u32]) -> Option<Candidate> {
        let params = self.params();
        if ty.kind != RecordKind::Checkerboard || params.len() != 2 * PARTS {
            return None;
        }
        let (one, two) = params.split_at(PARTS);
        let list = [self.colour(one)?.1, self.colour(two)?.1];
        let mut candidate = self.with_records(&list, used)?;
        let mut edits = candidate.fix.edits.iter_mut();
        let first = edits.find(|e| e.span == list[0].span)?;
        first.text = format!("1 1 {}", first.text);
        Some(candidate)
    }

    /// The colours in the places that are bits of `chosen`, if the record then has exactly its first `count`
    /// parameters.
    fn inlined(&self, ty: &RecordType, count: usize, chosen: u32) -> Option<Vec<Inline>> {
        let mut rest = self.params();
        let mut found = Vec::new();
        let mut places = 0;
        let params: Vec<&Param> = ty.params.iter().chain(ty.optional).take(count).collect();
        for param in params {
            let is_colour = matches!(param.kind,
                ParamKind::Reference { kinds, .. } if kinds.contains(&Kind::Colour));
            let is_chosen = is_colour && chosen & (1 << places) != 0;
            places += u32::from(is_colour);
            let taken = match is_chosen {
                true => {
                    let (taken, inline) = self.colour(rest)?;
                    found.push(inline);
                    taken
                }
                false => {
                    rest.first()?.number(self.text)?;
                    1
                }
            };
            rest = &rest[taken..];
        }
        (rest.is_empty() && found.len() == chosen.count_ones() as usize).then_some(found)
    }

    /// The colour that some tokens begin with, and how many tokens it takes.
    fn colour(&self, tokens: &[Token]) -> Option<(usize, Inline)> {
        let first = tokens.first()?;
        if first.kind() == TokenKind::Word {
            let (of, numbers) = self.named_colour(tokens)?;
            let span = first.span().to(tokens[of - 1].span());
            let inline = Inline {
                span,
                numbers,
                is_name: true,
            };
            return Some((of, inline));
        }
        let parts = tokens.get(..PARTS)?;
        let is_part = |t: &Token| {
            t.number(self.text)
                .is_some_and(|x| (0.0..=1.0).contains(&x))
        };
        let span = first.span().to(parts[PARTS - 1].span());
        let inline = Inline {
            span,
            numbers: self.spaced(parts)?,
            is_name: false,
        };
        parts.iter().all(is_part).then_some((PARTS, inline))
    }

    /// The candidate that writes IDs in the place of colours. A colour without a record gets one above this record,
    /// with a free ID.
    fn with_records(&self, list: &[Inline], used: &[u32]) -> Option<Candidate> {
        let code = RecordType::of(RecordKind::Colour).code;
        let mut free = self.free_id(used)?..=MAX_ID;
        let mut above = String::new();
        let (mut edits, mut new, mut known) = (Vec::new(), Vec::new(), Vec::new());
        for inline in list {
            let id = match self.colour_id(inline) {
                Some(id) => {
                    known.push(id.to_string());
                    id
                }
                None => {
                    let id = free.next()?;
                    above += &format!("{id} {code} {}\n", inline.numbers);
                    new.push(quote(&inline.numbers));
                    id
                }
            };
            edits.push(Edit {
                span: inline.span,
                text: id.to_string(),
            });
        }
        let (title, shown) = match new.is_empty() {
            true => (ID_TITLE, known),
            false => {
                let head = self.tokens.first()?.start;
                let span = Span::new(head, head);
                edits.insert(0, Edit { span, text: above });
                (TITLE, new)
            }
        };
        let fix = Fix {
            title,
            values: vec![
                ("count", Value::Count(shown.len() as u64)),
                ("text", shown.join(", ").into()),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(Habit::Apart, fix))
    }

    /// The ID of the record that defines a colour: its comment has the name that is written, or it has the colour's
    /// numbers. An ID with other records is left out. A black background is 0.
    fn colour_id(&self, inline: &Inline) -> Option<u32> {
        let numbers = inline.numbers.as_str();
        let document = &self.analysis.document;
        let captions = Captions::of(document, self.text);
        let values = numbers.split_whitespace().map(str::parse);
        let values: Vec<f64> = values.collect::<Result<_, _>>().ok()?;
        let records = || document.items.iter().filter_map(Item::record);
        let is_alone = |id: u32| records().filter(|r| r.id == id).count() == 1;
        let defined = self.entities(&[Kind::Colour]).map(|e| e.id);
        let defined: Vec<u32> = defined.filter(|&id| is_alone(id)).collect();
        let is_named = |id: u32| {
            let name = captions.own(id).and_then(colours::numbers);
            name.as_deref() == Some(numbers)
        };
        let is_background = self.ty().is_some_and(|ty| ty.kind == RecordKind::Render);
        let black = (is_background && values.iter().all(|&x| x == 0.0)).then_some(0);
        if !inline.is_name && black.is_some() {
            return black;
        }
        let gap = |id: u32| {
            let written = records().find(|r| r.id == id && r.kind == RecordKind::Colour)?;
            let written = document.params(written).map(|t| t.number(self.text));
            let mut gaps = written.zip(&values).map(|(a, &b)| Some((a? - b).abs()));
            gaps.try_fold(0.0, |most: f64, gap| Some(most.max(gap?)))
        };
        let mut all = defined.iter().copied();
        let named = all.find(|&id| inline.is_name && is_named(id));
        let near = || {
            let near = defined.iter().filter_map(|&id| Some((gap(id)?, id)));
            let near = near.filter(|&(gap, _)| gap <= PART_GAP);
            let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some(nearest.1)
        };
        named.or_else(near).or(black)
    }

    /// The smallest ID that is larger than all IDs of the file and all that are `used`.
    pub(super) fn free_id(&self, used: &[u32]) -> Option<u32> {
        let items = self.analysis.document.items.iter();
        let ids = items.filter_map(|item| match item {
            Item::Record(r) => Some(r.id),
            Item::Broken(b) => b.id,
            Item::Void { .. } => None,
        });
        ids.chain(used.iter().copied()).max()?.checked_add(1)
    }

    /// Guesses that an operation with more than two operands is several operations: `5 -103 2 3 4` is 2 minus 3, minus
    /// 4.
    pub(super) fn operands(&self, used: &[u32]) -> Option<Candidate> {
        let is_operation = |k: RecordKind| {
            matches!(
                k,
                RecordKind::Union | RecordKind::Intersection | RecordKind::Difference
            )
        };
        let ty = self.ty().filter(|ty| is_operation(ty.kind))?;
        let params = self.params();
        let last = params
            .last()
            .filter(|_| (3..=MAX_OPERANDS).contains(&params.len()))?;
        let ids: Option<Vec<i64>> = params
            .iter()
            .map(|t| t.integer(self.text).filter(|&id| id > 1))
            .collect();
        // An operand that is written twice is a slip of another kind.
        let ids = ids.filter(|ids| (1..ids.len()).all(|i| !ids[..i].contains(&ids[i])))?;
        let (mut above, mut part) = (String::new(), ids[0].to_string());
        let first = self.free_id(used)?;
        for (id, operand) in (first..MAX_ID).zip(&ids[1..ids.len() - 1]) {
            above += &format!("{id} {} {part} {operand}\n", ty.code);
            part = id.to_string();
        }
        let edit = |span: Span, text: String| Edit { span, text };
        let head = self.tokens.first()?.start;
        let behind = params[params.len() - 2].end();
        let fix = Fix {
            title: PARTS_TITLE,
            values: vec![("type", Value::Term(ty.title))],
            applicability: Applicability::Unsafe,
            edits: vec![
                edit(Span::new(head, head), above),
                edit(Span::new(params[0].start, behind), part),
            ],
        };
        self.is_gap(Span::new(behind, last.start))
            .then_some(Candidate::new(Habit::Doubled, fix))
    }
}

//! Records that stand above a definition that they need (E107), or above the definition of their own object (E102): the
//! definition moves up, or the record moves down.
//!
//! A block moves as a whole: a record, the records right behind it that change it, and the comment above it, on lines
//! that nothing else has a part in.

use std::ops::Range;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, SourceFile, Span, Value};
use crate::scene::names;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Effect, Family, RecordKind};
use crate::syntax::{Document, Item, Record};

/// The most items that are gone through for one file, to see whether an item on the way needs the moved block. That
/// takes some milliseconds.
const STEPS: usize = 1_000_000;

/// Gives the findings about a use before the definition (E107) their fixes.
pub(super) fn propose(source: &SourceFile, document: &Document, findings: &mut [Diagnostic]) {
    if !findings.iter().any(|d| d.code == Code::E107) {
        return;
    }
    let mut mover = Mover::new(source, document, findings);
    let is_use = |d: &&mut Diagnostic| d.code == Code::E107 && d.case.is_empty();
    for d in findings.iter_mut().filter(is_use) {
        d.fixes.extend(mover.moved(d));
    }
    early_changes(&mover, findings);
}

/// Proposes to move records that change something behind its definition. For each ID only the last such record gets the
/// proposal, so that the records stay in order.
fn early_changes(mover: &Mover, findings: &mut [Diagnostic]) {
    let mut seen = FxHashSet::default();
    let is_one = |d: &&mut Diagnostic| d.code == Code::E107 && d.case == "changed";
    let mut all: Vec<&mut Diagnostic> = findings.iter_mut().filter(is_one).collect();
    all.sort_by_key(|d| std::cmp::Reverse(d.span.start));
    for d in all {
        let Some(definition) = d.labels.first().map(|label| label.span) else {
            continue;
        };
        if !seen.insert(definition.start) {
            continue;
        }
        let [from, to] = [d.span, definition].map(|span| {
            let at = mover.item(span.start)?;
            mover.own_lines(at..at + 1)
        });
        if let (Some(from), Some(to)) = (from, to) {
            d.fixes = vec![mover.fix("fix", Applicability::Unsafe, from, to.end)];
        }
    }
}

/// The fix that brings a definition above the records of its ID, and the spans of those records. `None` if that cannot
/// be done.
type Behind = Option<(Fix, Vec<Span>)>;

/// For each finding about a definition, makes the fix that moves the records of its ID from above the definition to
/// behind it. `None` if a record between them names the object.
pub(super) fn behind(
    source: &SourceFile,
    document: &Document,
    findings: &[&Diagnostic],
) -> Vec<Behind> {
    let mut mover = Mover::new(source, document, &[]);
    findings.iter().map(|d| mover.behind(d)).collect()
}

/// For each finding about a definition, makes the fix that moves the definition above the properties with its ID, and
/// returns the spans of these properties.
pub(super) fn above(
    source: &SourceFile,
    document: &Document,
    findings: &[&Diagnostic],
) -> Vec<Behind> {
    let mut mover = Mover::new(source, document, &[]);
    findings.iter().map(|d| mover.above(d)).collect()
}

struct Mover<'a> {
    source: &'a SourceFile,
    document: &'a Document,
    /// For each definition, by the offset at which it begins: the index of the first item that uses it too early.
    first_use: FxHashMap<u32, usize>,
    /// How often each ID is used too early, and how often it is referred to at all.
    uses: FxHashMap<u32, Uses>,
    /// For each ID, the indices of the first and the last item with it.
    records: FxHashMap<u32, (usize, usize)>,
    left: usize,
}

#[derive(Default)]
struct Uses {
    early: usize,
    all: usize,
}

/// The records that move, as indices of items and as numbers of lines.
struct Block {
    items: Range<usize>,
    lines: Range<usize>,
}

impl<'a> Mover<'a> {
    fn new(source: &'a SourceFile, document: &'a Document, findings: &[Diagnostic]) -> Self {
        let mut mover = Mover {
            source,
            document,
            first_use: FxHashMap::default(),
            uses: FxHashMap::default(),
            records: FxHashMap::default(),
            left: STEPS,
        };
        for d in findings.iter().filter(|d| d.code == Code::E107) {
            let used = mover.item(d.span.start);
            let (Some(used), Some(label)) = (used, d.labels.first()) else {
                continue;
            };
            let first = mover.first_use.entry(label.span.start).or_insert(used);
            *first = used.min(*first);
            if let (true, Ok(id)) = (d.case.is_empty(), source.slice(d.span).parse()) {
                mover.uses.entry(id).or_default().early += 1;
            }
        }
        for (i, item) in document.items.iter().enumerate() {
            let Some(record) = item.record() else {
                continue;
            };
            mover.records.entry(record.id).or_insert((i, i)).1 = i;
            for id in names::references(document, record) {
                if let Some(uses) = mover.uses.get_mut(&id) {
                    uses.all += 1;
                }
            }
        }
        mover
    }

    /// The fix for an operand that is defined below its record: moves the definition up, or else the record down.
    fn moved(&mut self, finding: &Diagnostic) -> Option<Fix> {
        let definition = finding.labels.first()?.span.start;
        let (user, defined) = (self.item(finding.span.start)?, self.item(definition)?);
        let first = *self.first_use.get(&definition)?;
        self.left = self.left.checked_sub(defined.saturating_sub(first))?;
        let id = self.record(defined)?.id;
        let block = self.block(defined)?;
        let needs = self.needs(&block, id)?;
        // If the definition itself needs something below it, that is another finding.
        if !self.are_above(&needs, defined) {
            return None;
        }
        if self.are_above(&needs, first) {
            let to = self.with_comment(&self.block(first)?, &block.lines).start;
            let lines = self.with_comment(&block, &(0..0));
            let applicability = match self.is_safe(id, &needs, &block, first) {
                true => Applicability::Safe,
                false => Applicability::Unsafe,
            };
            return Some(self.fix("fix", applicability, lines, to));
        }
        let own = self.block(user).filter(|own| own.items.end <= defined)?;
        let id = self.record(user)?.id;
        let is_free = (own.items.end..block.items.end).all(|i| !self.mentions(i, id));
        let lines = self.with_comment(&own, &(0..0));
        is_free.then(|| self.fix("fix-down", Applicability::Unsafe, lines, block.lines.end))
    }

    /// The IDs that the records of a block refer to, without the ID of the block. `None` if an item is no record.
    fn needs(&self, block: &Block, id: u32) -> Option<FxHashSet<u32>> {
        let mut needs = FxHashSet::default();
        for i in block.items.clone() {
            needs.extend(names::references(self.document, self.record(i)?));
        }
        needs.remove(&id);
        Some(needs)
    }

    /// The fix that moves a definition, with the changes right behind it, above the first record with its ID, and the
    /// spans of the records with that ID in between. `None` if something that the definition needs is not above them.
    fn above(&mut self, finding: &Diagnostic) -> Behind {
        let defined = self.item(finding.span.start)?;
        let id = self.record(defined)?.id;
        let first = self.records.get(&id)?.0;
        self.left = self.left.checked_sub(defined.checked_sub(first)?)?;
        let block = self.block(defined)?;
        let needs = self.needs(&block, id)?;
        if first == defined || !self.are_above(&needs, first) {
            return None;
        }
        let mut spans = Vec::new();
        for i in first..defined {
            let Some(record) = self.record(i).filter(|r| r.id == id) else {
                continue;
            };
            if matches!(record.ty().effect, Effect::Defines(_)) {
                return None;
            }
            spans.push(self.document.span(record.first, record.last));
        }
        let to = self.own_lines(first..first + 1)?.start;
        let lines = self.with_comment(&block, &(0..0));
        Some((self.fix("fix", Applicability::Unsafe, lines, to), spans))
    }

    /// The fix that moves the records above a definition that have its ID to the lines behind it, in their order, and
    /// their spans.
    fn behind(&mut self, finding: &Diagnostic) -> Behind {
        let defined = self.item(finding.span.start)?;
        let id = self.record(defined)?.id;
        let first = self.records.get(&id)?.0;
        self.left = self.left.checked_sub(defined.checked_sub(first)?)?;
        let to = self.own_lines(defined..defined + 1)?.end;
        let (mut edits, mut text, mut spans) = (Vec::new(), String::new(), Vec::new());
        for i in first..defined {
            let own = self.record(i).filter(|r| r.id == id);
            let Some(record) = own else {
                match self.mentions(i, id) {
                    true => return None,
                    false => continue,
                }
            };
            if matches!(record.ty().effect, Effect::Defines(_)) {
                return None;
            }
            let lines = self.own_lines(i..i + 1)?;
            spans.push(self.span(&lines));
            let [gone, put] = self
                .fix("fix", Applicability::Unsafe, lines, to)
                .edits
                .try_into()
                .ok()?;
            edits.push(gone);
            text += &put.text;
        }
        let at = self.source.line_span(to - 1).end;
        edits.push(Edit {
            span: Span::new(at, at),
            text,
        });
        let fix = Fix {
            title: "fix",
            values: vec![("count", Value::Count(spans.len() as u64))],
            applicability: Applicability::Unsafe,
            edits,
        };
        (!spans.is_empty()).then_some((fix, spans))
    }

    /// The span of some lines in the text.
    fn span(&self, lines: &Range<usize>) -> Span {
        let [first, last] = [lines.start, lines.end - 1].map(|line| self.source.line_span(line));
        first.to(last)
    }

    /// Whether each of some IDs has its first record above an item.
    fn are_above(&self, ids: &FxHashSet<u32>, at: usize) -> bool {
        let first = |id| self.records.get(id).map(|&(first, _)| first);
        ids.iter().filter_map(first).all(|first| first < at)
    }

    /// Whether a definition can move up to before the item `to` without a change to the scene.
    fn is_safe(&self, id: u32, needs: &FxHashSet<u32>, block: &Block, to: usize) -> bool {
        let items = &self.document.items;
        // A change of the definition or of its parts on the way, or a later change of it, would have another effect for
        // the records that use it.
        let is_changed = |r: &Record| r.id == id || needs.contains(&r.id);
        let mut between = items[to..block.items.start].iter().filter_map(Item::record);
        let is_last = (self.records.get(&id)).is_none_or(|&(_, last)| last < block.items.end);
        // If other references name the ID in time, they may mean another definition.
        let all_early = (self.uses.get(&id)).is_none_or(|uses| uses.all == uses.early);
        all_early && is_last && !between.any(is_changed)
    }

    fn record(&self, i: usize) -> Option<&'a Record> {
        self.document.items.get(i)?.record()
    }

    /// Whether an item changes or refers to an ID; an item that cannot be read might. The render record and selections
    /// of cameras do not count, since they refer to the state at the end of the file.
    fn mentions(&self, i: usize, id: u32) -> bool {
        match &self.document.items[i] {
            Item::Void { .. } => false,
            Item::Broken(_) => true,
            Item::Record(r) => {
                let late = matches!(
                    r.kind,
                    RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
                );
                r.id == id || !late && names::references(self.document, r).any(|used| used == id)
            }
        }
    }

    /// The index of the item that contains a place, or of the first item behind the place.
    fn item(&self, at: u32) -> Option<usize> {
        let items = &self.document.items;
        let i = items.partition_point(|item| self.document.item_span(item).end <= at);
        (i < items.len()).then_some(i)
    }

    /// The block of a record: that record, and the records right behind it that change its entity. `None` if the record
    /// shares its lines with others.
    fn block(&self, first: usize) -> Option<Block> {
        let id = self.record(first)?.id;
        let mut lines = self.own_lines(first..first + 1)?;
        let mut end = first + 1;
        while let Some(next) = self.record(end).filter(|r| r.id == id) {
            let changes = !matches!(next.ty().effect, Effect::Defines(_));
            let Some(own) = self.own_lines(end..end + 1).filter(|_| changes) else {
                break;
            };
            lines.end = own.end;
            end += 1;
        }
        Some(Block {
            items: first..end,
            lines,
        })
    }

    /// The lines of items. `None` if another item has a part in them, or if a comment goes on beyond them.
    fn own_lines(&self, items: Range<usize>) -> Option<Range<usize>> {
        let (source, document) = (self.source, self.document);
        let span = |item: &Item| document.item_span(item);
        let (before, rest) = document.items.split_at(items.start);
        let own = span(rest.first()?).to(span(&document.items[items.end - 1]));
        let [first, last] = [own.start, own.end - 1].map(|at| source.line_index(at));
        let is_above = |item: &Item| source.line_index(span(item).end - 1) < first;
        let is_below = |item: &Item| source.line_index(span(item).start) > last;
        let is_alone = before.last().is_none_or(is_above)
            && document.items.get(items.end).is_none_or(is_below);
        let lines = source.line_span(first).to(source.line_span(last));
        let goes_on = |t: &Token| {
            t.kind() == TokenKind::Comment && (t.start < lines.start || t.end() > lines.end)
        };
        let tokens = &document.tokens;
        let begin = tokens.partition_point(|t| t.end() <= lines.start);
        let end = tokens.partition_point(|t| t.start < lines.end);
        let on_lines = &tokens[begin..end];
        let mut ends = [on_lines.first(), on_lines.last()].into_iter().flatten();
        (is_alone && !ends.any(goes_on)).then_some(first..last + 1)
    }

    /// The lines of a block, with those of the comment right above it, unless that is the heading of more records. It
    /// is no such heading if behind the block, or behind the lines `gone` that follow the block, there is an empty
    /// line, another comment, nothing, or a light, a camera or the render record.
    fn with_comment(&self, block: &Block, gone: &Range<usize>) -> Range<usize> {
        let next = match gone.start == block.lines.end {
            true => gone.end,
            false => block.lines.end,
        };
        let goes_on = |line: usize| {
            let at = self.source.line_span(line).start;
            let item = self.item(at).map(|i| &self.document.items[i]);
            let on_line =
                |item: &&Item| self.source.line_index(self.document.item_span(item).start) == line;
            item.filter(on_line).is_some_and(|item| match item {
                Item::Void { .. } => false,
                Item::Broken(_) => true,
                Item::Record(r) => !matches!(
                    r.ty().family,
                    Family::Light | Family::Camera | Family::Render
                ),
            })
        };
        if next < self.source.line_count() && goes_on(next) {
            return block.lines.clone();
        }
        self.comment_above(block.lines.start)..block.lines.end
    }

    /// The first of the lines with comments of their own right above a line; the line itself if there are none.
    fn comment_above(&self, line: usize) -> usize {
        let (source, tokens) = (self.source, &self.document.tokens);
        let start = source.line_span(line).start;
        let mut i = tokens.partition_point(|t| t.start < start);
        let mut begin = line;
        // The tokens are read backwards: the end of a line, a comment, and perhaps a `0` before it.
        while let [.., comment, end] = &tokens[..i]
            && (comment.kind(), end.kind()) == (TokenKind::Comment, TokenKind::Newline)
        {
            let mut first = i - 2;
            let is_void = |t: &Token| t.text(&source.text) == "0";
            if first > 0 && is_void(&tokens[first - 1]) {
                first -= 1;
            }
            let is_first = first == 0 || tokens[first - 1].kind() == TokenKind::Newline;
            if !is_first {
                break;
            }
            begin = source.line_index(tokens[first].start);
            i = first;
        }
        begin
    }

    /// The fix that moves lines to the place before the line `to`.
    fn fix(
        &self,
        title: &'static str,
        applicability: Applicability,
        lines: Range<usize>,
        to: usize,
    ) -> Fix {
        let source = self.source;
        let start = |line: usize| match line < source.line_count() {
            true => source.line_span(line).start,
            false => source.text.len() as u32,
        };
        let end = |line: usize| source.line_span(line - 1).end;
        let span = Span::new(start(lines.start), end(lines.end));
        // Edits have `\n` for all line breaks.
        let text = (source.slice(span).replace("\r\n", "\n")).replace('\r', "\n");
        let edit = |span: Span, text: String| Edit { span, text };
        let mut edits = match to <= lines.start {
            true => {
                let gap = match lines.end < source.line_count() {
                    true => Span::new(span.start, start(lines.end)),
                    false => Span::new(end(lines.start), span.end),
                };
                let at = start(to);
                vec![
                    edit(Span::new(at, at), text + "\n"),
                    edit(gap, String::new()),
                ]
            }
            false => {
                let at = end(to);
                let gap = Span::new(span.start, start(lines.end));
                vec![
                    edit(gap, String::new()),
                    edit(Span::new(at, at), format!("\n{text}")),
                ]
            }
        };
        edits.sort_by_key(|e| e.span.start);
        Fix {
            title,
            values: Vec::new(),
            applicability,
            edits,
        }
    }
}

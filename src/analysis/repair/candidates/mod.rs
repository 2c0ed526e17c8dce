//! Guesses at what is meant by a line that something is wrong with.

mod apart;
mod assigned;
mod axes;
pub(super) mod cameras;
mod clauses;
mod comments;
mod complements;
mod cylinders;
mod drawn;
mod flat;
mod groups;
mod habit;
mod heads;
mod indices;
mod inline;
mod lost_spaces;
mod lost_types;
mod matrices;
mod notation;
mod numbers;
mod own_id;
mod parts;
mod profiles;
mod properties;
mod references;
mod rotations;
mod settings;
mod sizes;
pub(super) mod smaller;
mod solids;
mod types;

use rustc_hash::FxHashSet;

pub(super) use habit::Habit;

use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::{SEPARATORS, Token, TokenKind};
use crate::syntax::table::{Family, Param, RecordType, Unit};
use crate::syntax::words;
use crate::syntax::{allows, quote};
pub(crate) use inline::new_ids;

/// A guess at what was meant: a fix, and the kind of slip that it repairs.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    pub habit: Habit,
    pub fix: Fix,
    /// The type that the fix writes, if it writes one.
    pub ty: Option<&'static RecordType>,
}

impl Candidate {
    /// A fix that writes no type.
    pub(super) fn new(habit: Habit, fix: Fix) -> Candidate {
        Candidate {
            habit,
            fix,
            ty: None,
        }
    }

    /// A candidate that writes `text` in the place of `span`; the title of its fix shows the text.
    pub(super) fn writing(habit: Habit, span: Span, text: String) -> Candidate {
        let shown = quote(&text);
        let fix = Fix::replace("fix-write", Applicability::Unsafe, span, text);
        Candidate::new(habit, fix.with("number", shown))
    }

    /// Whether the candidate writes decimal commas as points and has all edits of a fix.
    pub(super) fn includes(&self, fix: &Fix) -> bool {
        let is_here = |e: &Edit| self.fix.edits.contains(e);
        self.fix.title == numbers::COMMA_TITLE && fix.edits.iter().all(is_here)
    }

    /// Whether the candidate gives an ID of its own to the record that a finding calls a second definition.
    pub(super) fn renames(&self, finding: &Diagnostic) -> bool {
        let is_head = |e: &Edit| e.span == finding.span;
        let is_twice = finding.code == Code::E102 && self.fix.title == inline::CHAIN_TITLE;
        is_twice && self.fix.edits.iter().any(is_head)
    }
}

/// The most candidates for one finding.
const MAX_CANDIDATES: usize = 16;

/// How a record of a type is written, in words: the ID, the number of the type and the names of its parameters.
fn header(ty: &RecordType) -> String {
    format!("`ID {} {}`", ty.code, ty.signature())
}

/// A line of the text, or all of a record that begins on it.
pub(super) struct LineContext<'a> {
    analysis: &'a Analysis,
    text: &'a str,
    /// The span from the first token of the line to its end, without the white space around.
    line: Span,
    /// The tokens of the line, trivia too.
    all: &'a [Token],
    /// The significant tokens of the record that begins the line, else of the line.
    tokens: Vec<Token>,
    /// The type that a word names in the place of the type's number.
    named: Option<&'static RecordType>,
}

impl<'a> LineContext<'a> {
    /// The contexts of a place: its line, and then the record that begins the line, if that goes on behind the line's
    /// end.
    pub(super) fn both(analysis: &'a Analysis, at: u32) -> Vec<LineContext<'a>> {
        let Some(line) = LineContext::of(analysis, at, false) else {
            return Vec::new();
        };
        let record = LineContext::of(analysis, at, true);
        let longer = record.filter(|r| r.tokens.len() > line.tokens.len());
        std::iter::once(line).chain(longer).collect()
    }

    fn of(analysis: &'a Analysis, at: u32, goes_on: bool) -> Option<LineContext<'a>> {
        let source = &analysis.source;
        let line = source.line_span(source.line_index(source.floor(at)));
        let document = &analysis.document;
        let first = document.tokens.partition_point(|t| t.start < line.start);
        let last = document.tokens.partition_point(|t| t.start < line.end);
        let all = &document.tokens[first..last];
        let all = match all {
            [rest @ .., last] if last.kind() == TokenKind::Newline => rest,
            all => all,
        };
        let head = all.iter().position(|t| !t.kind().is_trivia())?;
        let begin = (first + head) as u32;
        let item = document.items.partition_point(|item| item.ends().0 < begin);
        let item = document
            .items
            .get(item)
            .filter(|item| item.ends().0 == begin);
        let on_line = || all.iter().filter(|t| !t.kind().is_trivia()).copied();
        let tokens: Vec<Token> = match item.map(|item| item.ends().1) {
            Some(end) if goes_on && end as usize >= last => {
                document.significant(begin, end).copied().collect()
            }
            _ => on_line().collect(),
        };
        let text = &source.text;
        let end = line.start + text[line.range()].trim_end().len() as u32;
        Some(LineContext {
            analysis,
            text,
            line: Span::new(all[head].start, end),
            all,
            tokens,
            named: None,
        })
    }

    pub(super) fn line(&self) -> Span {
        self.line
    }

    fn int(&self, i: usize) -> Option<i64> {
        self.tokens.get(i)?.integer(self.text)
    }

    fn params(&self) -> &[Token] {
        self.tokens.get(2..).unwrap_or(&[])
    }

    pub(super) fn id(&self) -> Option<u32> {
        u32::try_from(self.int(0)?).ok().filter(|&id| id > 0)
    }

    pub(in crate::analysis::repair) fn ty(&self) -> Option<&'static RecordType> {
        self.named.or_else(|| RecordType::by_code(self.int(1)?))
    }

    /// Whether the record is an operation, which makes an object of others.
    pub(super) fn is_operation(&self) -> bool {
        self.ty().is_some_and(|ty| ty.family == Family::Operation)
    }

    /// Whether a record of this type has as many parameters as stand here.
    fn fits(&self, ty: &RecordType) -> bool {
        self.fit(ty, self.params())
    }

    fn fit(&self, ty: &RecordType, params: &[Token]) -> bool {
        let n = params.len() as u64;
        let count = match ty.is_counted() {
            true => (params.first())
                .and_then(|t| t.integer(self.text))
                .and_then(|n| u64::try_from(n).ok())
                // A profile has two points at least.
                .filter(|&n| n >= 2),
            false => Some(0),
        };
        count.is_some_and(|count| {
            let base = ty.arity(count);
            n == base || !ty.optional.is_empty() && n == base + ty.optional.len() as u64
        })
    }

    /// The note, with its values, about a record with too few numbers that ends with a vector of its type. The note
    /// `lack` names the missing number, if only the last one can be missing; `lack-any` lists all parameters.
    pub(super) fn lacking(&self) -> Option<(&'static str, Vec<(&'static str, Value)>)> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let (params, wanted) = (self.params(), ty.params);
        let mut ends = ty.vectors.iter().scan(0, |sum, n| {
            *sum += n;
            Some(*sum)
        });
        let n = params.len();
        let (between, last) = (ends.any(|end| end == n), wanted.last()?);
        if !between || n >= wanted.len() {
            return None;
        }
        let names = |some: &[Param]| some.iter().map(|p| p.name).collect::<Vec<_>>().join(" ");
        let end = params.last()?.number(self.text)?;
        // An angle of one degree is rather a part of a vector.
        let may_be_last = allows(last, end) && (last.unit != Unit::Degrees || end > 1.0);
        if n + 1 == wanted.len() && !may_be_last {
            let (have, missing) = wanted.split_at(n);
            let values = vec![
                ("have", names(have).into()),
                ("missing", names(missing).into()),
                ("parameter", Value::Term(last.doc)),
            ];
            return Some(("lack", values));
        }
        Some(("lack-any", vec![("missing", names(wanted).into())]))
    }

    /// Lists the guesses at what was meant, for a finding at this place. `undefined` are the IDs that are used but
    /// defined nowhere, `taken` those that other proposals define.
    pub(super) fn candidates(
        &self,
        finding: &Diagnostic,
        undefined: &[u32],
        taken: &[u32],
    ) -> Vec<Candidate> {
        let mut out = Vec::new();
        let lost = self.without_type();
        if let Some(infix) = self.infix().filter(|_| finding.is_error()) {
            out.push(infix);
        } else if finding.is_error() && !lost.is_empty() {
            out = lost;
        } else if finding.is_error() {
            self.characters(&mut out);
            // A negative ID may be a type that changed places with its ID.
            let is_negative = self.int(0).is_some_and(|id| id < 0) && finding.code == Code::E005;
            out.extend(
                self.exchange()
                    .filter(|_| is_negative)
                    .map(|(_, candidate)| candidate),
            );
            out.extend(self.torn_type());
            out.extend(self.type_behind());
            out.extend(self.glued(&[undefined, taken].concat()));
            self.lost_spaces(&mut out);
            out.extend(self.own_name());
            out.extend(self.labelled());
            out.extend(self.equation());
            self.product(&mut out);
            out.extend(self.named_values());
            out.extend(self.axis_equation());
            self.keyword(&[undefined, taken].concat(), &mut out);
            let clauses = self.clauses(&[undefined, taken].concat());
            let is_block = clauses.as_ref().is_some_and(|c| self.is_in_brackets(c));
            let is_either = clauses
                .as_ref()
                .is_some_and(|c| c.fix.title == inline::PLANE_TITLE);
            if let Some(clauses) = clauses {
                // The numbers of the other notation mean something else than those of a record.
                out.retain(|c| c.habit != Habit::Unnamed);
                out.push(clauses);
            }
            out.extend(self.square_roots());
            out.extend(self.setting(&[undefined, taken].concat()));
            out.extend(self.vectors());
            out.extend(self.named_picture());
            out.extend(self.image_type());
            self.spaced_name(&mut out);
            if !is_block {
                self.words(&mut out);
            }
            if is_either {
                let fixes = out.iter_mut().map(|c| &mut c.fix);
                fixes.for_each(|f| f.applicability = Applicability::Choice);
            }
            self.profile(&mut out);
            self.axis(&mut out);
            out.extend(self.called_axis(finding));
            self.comments(&mut out);
            self.with_slashes(finding, undefined, taken, &mut out);
            self.signs(&mut out);
            self.count(&mut out);
            self.doubled(&mut out);
            self.spaced_commas(&mut out);
            out.extend(self.spaced_points());
            self.surplus(finding, &mut out);
            self.three_numbers(&mut out);
            self.about_vector(&mut out);
            self.turns_of_quaternion(&mut out);
            self.smaller_matrix(&mut out);
            out.extend(self.without_alpha(finding));
            out.extend(self.per_cent(finding));
            out.extend(self.index(finding));
            out.extend(self.index_behind(finding));
            out.extend(self.operands(&[undefined, taken].concat()));
            out.extend(self.drawn(finding, &[undefined, taken].concat()));
            match self.assignment() {
                Some(assignment) => out.push(assignment),
                None => self.siblings(&mut out),
            }
            self.keep_named_shape(&mut out);
            self.by_points(finding, &[undefined, taken].concat(), &mut out);
            self.flat(finding, &mut out);
            self.by_sizes(finding, &mut out);
            self.by_centre(finding, &mut out);
            out.extend(self.lost_line_end(finding, undefined));
            out.extend(self.moved_copy(finding));
            let behind = self.records_behind().or_else(|| self.changes_behind());
            // Text that is a record was not meant as a comment.
            if behind.is_some() {
                out.retain(|c| c.habit != Habit::Comment);
            }
            out.extend(behind);
            self.apart(finding, &mut out);
            self.inline(&[undefined, taken].concat(), &mut out);
            self.camera(finding, &mut out);
            self.without_up(finding, &mut out);
            out.extend(self.only_cameras());
            self.lost_number(finding, &mut out);
            self.angle_before(finding, &mut out);
            match self.assigned(finding) {
                Some(assigned) => out.push(assigned),
                None => match self.lost_id(finding) {
                    Some(lost) => out.push(lost),
                    None => out.extend(self.assigned_to(finding)),
                },
            }
            out.extend(self.as_one_property(finding));
            out.extend(self.negative_id(finding, undefined));
            self.types(finding, &mut out);
            self.arranged(&mut out);
            self.references(finding, &mut out);
            self.ids(finding, undefined, &mut out);
            self.own_id(finding, &[undefined, taken].concat(), &mut out);
            if out.is_empty() {
                self.lost_type(&mut out);
            }
            self.lost_shape_type(&mut out);
            out.extend(self.type_before_zero(finding));
            self.called_shape(finding, &mut out);
            self.one_too_few(finding, &mut out);
        } else if finding.code == Code::W319 {
            out.extend(self.smaller_cut(finding));
            if !self.is_in_order() {
                self.swapped(&mut out);
            }
        }
        let is_keyword = |c: &Candidate| matches!(c.habit, Habit::Keyword | Habit::Unnamed);
        if out
            .iter()
            .any(|c| inline::is_inline(&c.fix) || is_keyword(c))
        {
            // Colours are no comment, nor is the name of a type before numbers.
            out.retain(|c| c.habit != Habit::Comment);
        }
        out.iter_mut().for_each(|c| self.drop_separators(c));
        let mut seen: FxHashSet<Vec<(Span, String)>> = FxHashSet::default();
        let edits = |c: &Candidate| -> Vec<(Span, String)> {
            (c.fix.edits.iter())
                .map(|e| (e.span, e.text.clone()))
                .collect()
        };
        out.retain(|c| seen.insert(edits(c)));
        out.truncate(MAX_CANDIDATES);
        out
    }

    /// The finding that speaks of the fault which a candidate repairs; `None` if its habit has no finding of its own.
    /// Together with [`Habit::is_said_by`] it makes a finding and its first proposal speak of one fault.
    pub(super) fn matter(&self, candidate: &Candidate) -> Option<Diagnostic> {
        let edits = || candidate.fix.edits.iter();
        let on_line = edits().find(|e| self.line.touches(e.span));
        let edit = on_line.or_else(|| edits().next())?;
        let written = quote(&self.text[edit.span.range()]);
        let with_type = |d: Diagnostic| {
            let ty = candidate.ty?;
            let d = d.with("number", ty.code.to_string());
            Some(d.with("type", Value::Term(ty.title)))
        };
        match candidate.habit {
            Habit::Sign => with_type(Diagnostic::new(Code::E007, edit.span).case("sign")),
            Habit::Unnamed => {
                let ty = candidate.ty?;
                // An edit that writes a comment is not part of the record.
                let own = |e: &&Edit| !e.text.starts_with('#');
                let end = edits().rfind(own)?.span.end;
                let d = Diagnostic::new(Code::E005, Span::new(edit.span.start, end)).case("name");
                with_type(d).map(|d| d.with("header", header(ty)))
            }
            Habit::NoType => with_type(Diagnostic::new(Code::E006, edit.span).case("lost")),
            Habit::Characters => Some(Diagnostic::new(Code::E003, edit.span).with("text", written)),
            Habit::Glued | Habit::GluedAsBeside => self.several_numbers(candidate),
            Habit::Exchanged => Some(self.exchange()?.0),
            Habit::Word | Habit::Keyword => {
                let name = words::explained(&self.text[edit.span.range()]);
                let d = Diagnostic::new(Code::E006, edit.span).case("word");
                Some(d.with("text", written).with("name", name))
            }
            Habit::Comment => {
                let words = self.text[edit.span.range()]
                    .trim_start_matches('#')
                    .trim_start();
                let word = words.split_whitespace().next()?;
                let start = edit.span.end - words.len() as u32;
                let span = Span::new(start, start + word.len() as u32);
                Some(Diagnostic::new(Code::E012, span).with("text", quote(word)))
            }
            Habit::Doubled | Habit::Sibling | Habit::Apart => self.wrong_count(),
            Habit::Count => self.points(),
            Habit::Axis => {
                // Two edits: the axis stands before the angle, and both are written anew.
                let case = match candidate.fix.edits.len() {
                    1 => "axis",
                    _ => "axis-first",
                };
                let d = Diagnostic::new(Code::E012, edit.span).case(case);
                Some(d.with("text", written))
            }
            Habit::Swapped => {
                let d = Diagnostic::new(Code::E101, edit.span).case("no-id");
                Some(d.with("number", written))
            }
            Habit::Infix
            | Habit::Digit
            | Habit::Shifted
            | Habit::Reference
            | Habit::Id
            | Habit::Between
            | Habit::Type
            | Habit::Proposed => None,
            Habit::Direction | Habit::Point | Habit::Up => None,
            Habit::Split | Habit::Lost | Habit::Eye => None,
        }
    }

    /// Drops all separators of the line where a candidate arranges numbers anew, so that no half of a bracket is left.
    fn drop_separators(&self, candidate: &mut Candidate) {
        use Habit::*;
        let arranges = matches!(
            candidate.habit,
            Apart
                | Doubled
                | Sibling
                | Word
                | Keyword
                | Unnamed
                | Sign
                | Axis
                | Direction
                | Point
                | Count
        );
        // A candidate that takes out the word before a vector in brackets takes out the brackets, too.
        let is_bracket =
            |t: &Token| t.kind() == TokenKind::Separator && "<>[](){}".contains(t.text(self.text));
        let is_vector = candidate.habit == Characters && self.all.iter().any(is_bracket);
        let writes_type = candidate.ty.is_some() && candidate.habit != Unnamed;
        if writes_type || !(arranges || is_vector) {
            return;
        }
        let edits = &mut candidate.fix.edits;
        let is_space = |i: usize| {
            self.text
                .as_bytes()
                .get(i)
                .is_none_or(u8::is_ascii_whitespace)
        };
        let separators = self.all.iter().filter(|t| t.kind() == TokenKind::Separator);
        let left = separators.map(|t| t.span()).filter(|s| {
            let is_in = |e: &Edit| e.span.start <= s.start && s.end <= e.span.end;
            !edits.iter().any(is_in)
        });
        let left: Vec<Edit> = left
            .map(|span| {
                let apart = span.start == 0
                    || is_space(span.start as usize - 1)
                    || is_space(span.end as usize);
                let text = if apart { "" } else { " " }.to_owned();
                Edit { span, text }
            })
            .collect();
        edits.extend(left);
        edits.sort_by_key(|e| (e.span.start, e.span.end));
    }

    /// Whether a part of the text has nothing but white space and separators.
    fn is_gap(&self, between: Span) -> bool {
        let is_nothing = |c: char| c.is_whitespace() || SEPARATORS.contains(&c);
        self.text[between.range()].chars().all(is_nothing)
    }

    /// The texts of some tokens, joined by spaces. `None` if there is anything but spaces and separators between them.
    fn spaced(&self, tokens: &[Token]) -> Option<String> {
        let gap = |two: &[Token]| self.is_gap(Span::new(two[0].end(), two[1].start));
        let texts: Vec<&str> = tokens.iter().map(|t| t.text(self.text)).collect();
        tokens.windows(2).all(gap).then(|| texts.join(" "))
    }

    fn write_type(&self, habit: Habit, ty: &'static RecordType) -> Candidate {
        let fix = Fix::replace(
            "fix-type",
            Applicability::Unsafe,
            self.tokens[1].span(),
            ty.code.to_string(),
        );
        Candidate {
            habit,
            fix: (fix.with("number", ty.code.to_string())).with("type", Value::Term(ty.title)),
            ty: Some(ty),
        }
    }

    /// A candidate that writes several tokens anew, given in any order. `None` if that changes nothing.
    fn write(&self, habit: Habit, new: &[(Token, String)]) -> Option<Candidate> {
        let mut edits: Vec<Edit> = (new.iter())
            .filter(|(t, text)| t.text(self.text) != text)
            .map(|(t, text)| Edit {
                span: t.span(),
                text: text.clone(),
            })
            .collect();
        edits.sort_by_key(|edit| edit.span.start);
        let (first, last) = (edits.first()?.span, edits.last()?.span);
        // The title shows the new text from the first edit to the last.
        let mut shown = String::new();
        let mut at = first.start;
        for edit in &edits {
            shown += &self.text[at as usize..edit.span.start as usize];
            shown += &edit.text;
            at = edit.span.end;
        }
        debug_assert!(at == last.end);
        let fix = Fix {
            title: "fix-write",
            values: vec![("number", quote(shown.trim()).into())],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(habit, fix))
    }
}

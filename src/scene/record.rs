//! Parameters of a record: their tokens, their values, and the table's facts about each.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::commented_out::is_commented_out;
use crate::syntax::directive::is_directive;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Constraint, Param, RecordKind, RecordType, ShapeKind};
use crate::syntax::{Document, Record, words};

/// Common angles of view of cameras, in degrees.
const USUAL_ANGLES: [f64; 13] = [
    10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0, 75.0, 90.0,
];

/// A record with the values of its parameters, which are borrowed from the document.
pub struct Params<'a> {
    pub text: &'a str,
    document: &'a Document,
    record: Record,
    values: &'a [f64],
    pub ty: &'static RecordType,
    pub id: u32,
    pub count: usize,
}

/// 2⁵³: every integer below it is exact in a double.
const INTEGERS: f64 = 9_007_199_254_740_992.0;

impl<'a> Params<'a> {
    #[inline]
    pub fn new(document: &'a Document, text: &'a str, record: &Record) -> Params<'a> {
        Params {
            text,
            document,
            record: *record,
            values: document.values(record),
            ty: record.ty(),
            id: record.id,
            count: record.count(),
        }
    }

    pub fn id_span(&self) -> Span {
        self.document.id_token(&self.record).span()
    }

    /// The place of the type's number in the text.
    pub fn type_span(&self) -> Span {
        let mut tokens = (self.document).significant(self.record.first, self.record.last);
        tokens.nth(1).map_or(self.span(), |t| t.span())
    }

    /// The place in the text from the ID to the last parameter.
    pub fn span(&self) -> Span {
        self.document.span(self.record.first, self.record.last)
    }

    /// The comments on the line before the record, inside it and behind it, without directives to zpg and without
    /// records that are commented out.
    pub fn comments(&self) -> impl Iterator<Item = &'a str> {
        let before = self.document.comments_before(&self.record);
        before
            .filter_map(|t| self.said(t))
            .chain(self.own_comments())
    }

    /// The comments inside the record and behind it, chosen as in [`comments`](Self::comments).
    pub fn own_comments(&self) -> impl Iterator<Item = &'a str> {
        let own = self.document.comments_at(&self.record);
        own.filter_map(|t| self.said(t))
    }

    fn said(&self, comment: &Token) -> Option<&'a str> {
        let text = comment.text(self.text);
        (!is_directive(comment, self.text) && !is_commented_out(text)).then_some(text)
    }

    /// Whether a comment about the record has a word with one of these beginnings. Accents are ignored.
    pub fn is_called(&self, beginnings: &[&str]) -> bool {
        self.comments().any(|text| words::has(text, beginnings))
    }

    pub fn len(&self) -> usize {
        self.values.len()
    }

    #[inline]
    pub fn number(&self, i: usize) -> f64 {
        self.values
            .get(i)
            .copied()
            .filter(|x| !x.is_nan())
            .unwrap_or(0.0)
    }

    pub fn numbers<const N: usize>(&self, first: usize) -> [f64; N] {
        std::array::from_fn(|i| self.number(first + i))
    }

    /// The value of an integer parameter, cut off at the limits of `i64`.
    pub fn integer(&self, i: usize) -> i64 {
        match self.values.get(i) {
            Some(x) if x.abs() < INTEGERS => *x as i64,
            _ => (self.token(i))
                .and_then(|t| t.integer(self.text))
                .unwrap_or(0),
        }
    }

    fn token(&self, i: usize) -> Option<&'a Token> {
        // In a record without comments or line breaks inside, the place of each token is known.
        let dense = self.record.last - self.record.first == self.record.params + 1;
        match dense {
            true if i < self.len() => {
                Some(&self.document.tokens[self.record.first as usize + 2 + i])
            }
            true => None,
            false => self.document.params(&self.record).nth(i),
        }
    }

    pub fn text_of(&self, i: usize) -> &'a str {
        self.token(i).map_or("", |t| t.text(self.text))
    }

    /// The span of parameters `first..first + n`, or of the whole record if there are no such parameters.
    pub fn span_of(&self, first: usize, n: usize) -> Span {
        match (
            self.token(first),
            n.checked_sub(1).and_then(|n| self.token(first + n)),
        ) {
            (Some(a), Some(b)) => a.span().to(b.span()),
            _ => self.span(),
        }
    }

    pub fn param(&self, i: usize) -> Option<&'static Param> {
        self.ty.param(i, self.count)
    }

    /// Checks each value against its constraint in the table, and reports violations. Returns `true` if all constraints
    /// hold.
    pub fn check_constraints(&self, out: &mut Vec<Diagnostic>) -> bool {
        let before = out.len();
        let constrained = |group: &[Param]| group.iter().any(|p| p.constraint != Constraint::Any);
        let fixed = self.ty.params.len();
        for (i, p) in self.ty.params.iter().enumerate() {
            if p.constraint != Constraint::Any {
                out.extend(self.violation(i, p));
            }
        }
        let rest = self.ty.repeats.iter().any(|g| constrained(g)) || constrained(self.ty.optional);
        for i in fixed..if rest { self.len() } else { fixed } {
            out.extend(self.param(i).and_then(|p| self.violation(i, p)));
        }
        // Once for the record: the fix is as long as the profile.
        let heights = || (2..=2 * self.count).step_by(2).map(|y| self.number(y));
        if let Some(d) = out[before..].iter_mut().find(|d| d.code == Code::E208)
            && heights().all(|y| y >= 0.0)
        {
            d.fixes.insert(0, self.points_exchanged());
        }
        out.len() == before
    }

    /// The fix that swaps two parameters, marked as a guess.
    fn swapped(&self, i: usize, j: usize) -> Fix {
        let edit = |at: usize, from: usize| Edit {
            span: self.span_of(at, 1),
            text: self.text_of(from).to_owned(),
        };
        Fix::guess("fix", vec![edit(i, j), edit(j, i)])
    }

    /// The fix for a camera's angle of view that has a minus, or has lost its decimal point: `350` for `35.0`. 180 and
    /// multiples of 360 degrees may be meant, so they get no fix.
    fn angle_of_view(&self, i: usize) -> Option<Fix> {
        let x = self.number(i);
        let is_one = self.ty.kind == RecordKind::Camera && i + 1 == self.len();
        let (number, applicability) = match self.text_of(i).strip_prefix('-') {
            _ if !is_one => return None,
            Some(number) if (1.0..180.0).contains(&-x) => {
                (number.to_owned(), Applicability::Unsafe)
            }
            None if x > 180.0 && x < 10_000.0 && x % 10.0 == 0.0 && x % 360.0 != 0.0 => {
                let mut shifts = [x / 10.0, x / 100.0].into_iter();
                let usual = shifts.find(|x| USUAL_ANGLES.contains(x))?;
                (usual.to_string(), Applicability::Choice)
            }
            _ => return None,
        };
        let fix = Fix::replace("fix", applicability, self.span_of(i, 1), number.clone());
        Some(fix.with("number", crate::syntax::quote(&number)))
    }

    /// The fix for a sphere whose radius is written before its centre. `i` is the last parameter, which is no valid
    /// radius. The fix is a guess if parameter `i` is zero or a wider gap sets the first number apart, else a choice.
    fn radius_first(&self, i: usize) -> Option<Fix> {
        let is_one = self.ty.kind == RecordKind::Shape(ShapeKind::Sphere)
            && i + 1 == self.len()
            && self.number(0) > 0.0;
        let order = [1, 2, 3, 0].map(|from| self.text_of(from.min(i)));
        let edits = order.iter().enumerate().map(|(at, text)| Edit {
            span: self.span_of(at, 1),
            text: (*text).to_owned(),
        });
        let mut fix = Fix::guess("fix", edits.collect());
        if self.number(i) != 0.0 && !self.is_widest_gap(0) {
            fix.applicability = Applicability::Choice;
        }
        is_one.then(|| fix.with("number", crate::syntax::quote(&order.join(" "))))
    }

    /// Whether the gap in the text behind a parameter is wider than the gap behind any other parameter.
    fn is_widest_gap(&self, at: usize) -> bool {
        let gap = |i: usize| self.span_of(i + 1, 1).start - self.span_of(i, 1).end;
        (0..self.len() - 1).all(|i| i == at || gap(i) < gap(at))
    }

    /// The fix that exchanges x and y of every point of a profile, to be chosen.
    pub fn points_exchanged(&self) -> Fix {
        let edit = |at: usize, from: usize| Edit {
            span: self.span_of(at, 1),
            text: self.text_of(from).to_owned(),
        };
        let points = (1..2 * self.count).step_by(2);
        Fix {
            title: "fix-turned",
            values: Vec::new(),
            applicability: Applicability::Choice,
            edits: points
                .flat_map(|x| [edit(x, x + 1), edit(x + 1, x)])
                .collect(),
        }
    }

    fn violation(&self, i: usize, p: &Param) -> Option<Diagnostic> {
        let x = self.number(i);
        let (holds, code, case, [low, high]) = match p.constraint {
            Constraint::Any => return None,
            Constraint::Positive => (x > 0.0, Code::E201, "", [0.0; 2]),
            Constraint::ProfileRadius => (x >= 0.0, Code::E208, "", [0.0; 2]),
            Constraint::NonZeroScale => (x != 0.0, Code::E204, "scale", [0.0; 2]),
            Constraint::Between(a, b) => (a < x && x < b, Code::E206, "between", [a, b]),
            Constraint::Within(a, b) => (a <= x && x <= b, Code::E206, "", [a, b]),
            Constraint::AtLeast(a) => (x >= a, Code::E206, "least", [a; 2]),
            Constraint::Axis => ((1.0..=3.0).contains(&x), Code::E205, "", [0.0; 2]),
        };
        let turned = code == Code::E205 && i > 0 && [1.0, 2.0, 3.0].contains(&self.number(i - 1));
        (!holds).then(|| {
            let d = Diagnostic::new(code, self.span_of(i, 1));
            let d = match turned {
                true => d.case("turned").fix(self.swapped(i - 1, i)),
                false => d.case(case),
            };
            let d = match self.text_of(i).strip_prefix('-') {
                Some(number) if code == Code::E201 && x < 0.0 => {
                    let (span, number) = (self.span_of(i, 1), number.to_owned());
                    let fix = Fix::replace("fix", Applicability::Choice, span, number.clone());
                    let d = d.fix(fix.with("number", crate::syntax::quote(&number)));
                    // A cone's height may be negative, so height and radius may stand in each other's place.
                    let is_cone = self.ty.kind == RecordKind::Shape(ShapeKind::Cone);
                    match is_cone && i > 0 && self.number(i - 1) > 0.0 {
                        true => d.fix(Fix {
                            title: "fix-swap",
                            applicability: Applicability::Choice,
                            ..self.swapped(i - 1, i)
                        }),
                        false => d,
                    }
                }
                Some(number) if code == Code::E208 => {
                    let (span, number) = (self.span_of(i, 1), number.to_owned());
                    let fix = Fix::replace("fix", Applicability::Choice, span, number.clone());
                    d.fix(fix.with("number", crate::syntax::quote(&number)))
                }
                _ => d,
            };
            let mut d = self.angle_of_view(i).into_iter().fold(d, Diagnostic::fix);
            if let Some(fix) = self.radius_first(i) {
                // A wide gap before the last number says that the last number is the radius.
                let is_last = i > 0 && self.is_widest_gap(i - 1);
                d.fixes.insert(if is_last { d.fixes.len() } else { 0 }, fix);
            }
            d.with("parameter", Value::Term(p.doc))
                .with("type", Value::Term(self.ty.title))
                .with("name", p.name)
                .with("text", crate::syntax::quote(self.text_of(i)))
                .with("low", low.to_string())
                .with("high", high.to_string())
        })
    }
}

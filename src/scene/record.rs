//! One record's parameters: their tokens, their values, and what the table says about each.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::Token;
use crate::syntax::table::{Constraint, Param, ParamKind, RecordType};
use crate::syntax::{Document, Record};

/// A record with its parameter tokens at hand.
pub struct Params<'a> {
    pub text: &'a str,
    pub ty: &'static RecordType,
    pub id: u32,
    pub id_span: Span,
    /// From the ID to the last parameter.
    pub span: Span,
    pub tokens: Vec<Token>,
    pub count: usize,
}

impl<'a> Params<'a> {
    pub fn new(document: &Document, text: &'a str, record: &Record) -> Params<'a> {
        let mut tokens: Vec<Token> = Vec::with_capacity(record.params as usize);
        // Behind the ID and the type.
        tokens.extend(document.significant(record.first, record.last).skip(2));
        Params {
            text,
            ty: record.ty,
            id: record.id,
            id_span: document.id_token(record).span(),
            span: document.span(record.first, record.last),
            tokens,
            count: record.count as usize,
        }
    }

    pub fn len(&self) -> usize {
        self.tokens.len()
    }

    pub fn number(&self, i: usize) -> f64 {
        self.tokens
            .get(i)
            .and_then(|t| t.number(self.text))
            .unwrap_or(0.0)
    }

    pub fn numbers<const N: usize>(&self, first: usize) -> [f64; N] {
        std::array::from_fn(|i| self.number(first + i))
    }

    pub fn integer(&self, i: usize) -> i64 {
        self.tokens
            .get(i)
            .and_then(|t| t.integer(self.text))
            .unwrap_or(0)
    }

    pub fn text_of(&self, i: usize) -> &'a str {
        self.tokens.get(i).map_or("", |t| t.text(self.text))
    }

    /// The span of parameters `first..first + n`; that of the record where there are none.
    pub fn span_of(&self, first: usize, n: usize) -> Span {
        match self.tokens.get(first..first + n) {
            Some([a, .., b]) => a.span().to(b.span()),
            Some([a]) => a.span(),
            _ => self.span,
        }
    }

    pub fn param(&self, i: usize) -> Option<&'static Param> {
        self.ty.param(i, self.count)
    }

    /// Checks each value against the table; `true` if all are right.
    pub fn check_constraints(&self, out: &mut Vec<Diagnostic>) -> bool {
        let before = out.len();
        for i in 0..self.len() {
            if let Some(p) = self.param(i)
                && !matches!(p.kind, ParamKind::FileName | ParamKind::Reference { .. })
                && let Some(d) = self.violation(i, p)
            {
                out.push(d);
            }
        }
        out.len() == before
    }

    /// Two parameters exchanged; a guess.
    fn swapped(&self, i: usize, j: usize) -> Fix {
        let edit = |at: usize, from: usize| Edit {
            span: self.span_of(at, 1),
            text: self.text_of(from).to_owned(),
        };
        Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits: vec![edit(i, j), edit(j, i)],
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
            d.with("parameter", Value::Term(p.doc))
                .with("type", Value::Term(self.ty.title))
                .with("name", p.name)
                .with("text", crate::syntax::quote(self.text_of(i)))
                .with("low", low.to_string())
                .with("high", high.to_string())
        })
    }
}

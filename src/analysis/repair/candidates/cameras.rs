//! Where a camera looks, and which way is up.

use super::{Candidate, Habit, Place};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span};
use crate::geometry::array::{length, sub};
use crate::lint::spelling::decimal;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::RecordKind;

/// A direction of length 1 is written with so many digits at least.
const ROUNDED: f64 = 1e-3;
/// Words before the point that a camera of other programs looks at.
const LOOK_AT: [&str; 4] = ["look_at", "lookat", "target", "at"];
/// The angle of a camera that lacks it.
const ANGLE: &str = "45";

impl Place<'_> {
    /// The direction is the point that the camera looks at, or the up vector is along the direction.
    pub(super) fn camera(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_camera = self.ty().is_some_and(|ty| ty.kind == RecordKind::Camera);
        let is_one = matches!(finding.code, Code::E203 | Code::E207) && is_camera;
        let numbers = self.params().iter().map(|t| t.number(self.text));
        let numbers: Option<Vec<f64>> = numbers.collect();
        let (Some(&[x, y, z, dx, dy, dz, ux, uy, uz, _]), true) = (numbers.as_deref(), is_one)
        else {
            return;
        };
        let way = sub([dx, dy, dz], [x, y, z]).map(decimal);
        out.push(self.vector(Habit::Point, "fix-point", 3, &way));
        if finding.code == Code::E207 && [ux, uy, uz] != [0.0; 3] {
            let upright = upright([dx, dy, dz]).map(str::to_owned);
            out.push(self.vector(Habit::Up, "fix-up", 6, &upright));
        }
    }

    /// A camera without its up vector: its direction, or the point that it looks at, is followed by its angle.
    pub(super) fn without_up(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_camera = self.ty().is_some_and(|ty| ty.kind == RecordKind::Camera);
        let numbers = self.params().iter().map(|t| t.number(self.text));
        let numbers: Option<Vec<f64>> = numbers.collect();
        let (Some(&[x, y, z, dx, dy, dz, _]), true) =
            (numbers.as_deref(), is_camera && finding.code == Code::E008)
        else {
            return;
        };
        let tokens = &self.params()[3..6];
        let Some(text) = self.spaced(tokens) else {
            return;
        };
        let way = sub([dx, dy, dz], [x, y, z]);
        let candidate = |title, habit, way: String, up: [&str; 3]| Candidate {
            habit,
            fix: Fix {
                title,
                values: vec![
                    ("text", quote(&text).into()),
                    ("number", quote(&up.join(" ")).into()),
                    ("way", quote(&way).into()),
                ],
                applicability: Applicability::Unsafe,
                edits: vec![Edit {
                    span: tokens[0].span().to(tokens[2].span()),
                    text: format!("{way} {}", up.join(" ")),
                }],
            },
            ty: None,
        };
        let to_point = candidate(
            "fix-look-at",
            Habit::Point,
            way.map(decimal).join(" "),
            upright(way),
        );
        out.push(to_point);
        let up = upright([dx, dy, dz]);
        let is_unit = (length([dx, dy, dz]) - 1.0).abs() < ROUNDED;
        let habit = if is_unit { Habit::Direction } else { Habit::Up };
        out.push(candidate("fix-up", habit, text.clone(), up));
    }

    /// Words between the numbers of a record, as in `look_at 0 0 0`: they go, and the point that a camera looks at becomes
    /// a direction.
    pub(super) fn labelled(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        // `rgb(255,0,0)` and `2*pi` are something else.
        let is_word = |t: &Token| {
            let behind = self.text[t.end() as usize..].chars().next();
            t.kind() == TokenKind::Word && behind.is_none_or(char::is_whitespace)
        };
        let is_number = |t: &Token| t.kind().is_number();
        let params = self.params();
        let (words, numbers): (Vec<Token>, Vec<Token>) = params.iter().partition(|t| is_word(t));
        let is_whole = !words.is_empty()
            && numbers.iter().all(is_number)
            && self.fit(ty, &numbers)
            // Behind all numbers they are rather a comment.
            && params.last().is_some_and(is_number);
        let (first, last) = (words.first()?, words.last()?);
        if !is_whole {
            return None;
        }
        let mut edits: Vec<Edit> = (params.windows(2))
            .filter(|two| is_word(&two[0]))
            .map(|two| Edit {
                span: Span::new(two[0].start, two[1].start),
                text: String::new(),
            })
            .collect();
        let written = quote(&self.text[first.span().to(last.span()).range()]);
        let point = params.windows(2).find(|two| {
            let word = two[0].text(self.text).to_lowercase();
            LOOK_AT.contains(&&*word) && Some(two[1].start) == numbers.get(3).map(|t| t.start)
        });
        let is_camera = ty.kind == RecordKind::Camera && point.is_some();
        let number = |i: usize| numbers[i].number(self.text);
        let title = match is_camera {
            true => {
                for (i, of) in (3..6).zip(0..) {
                    edits.push(Edit {
                        span: numbers[i].span(),
                        text: decimal(number(i)? - number(of)?),
                    });
                }
                "fix-labelled-point"
            }
            false => "fix-labelled",
        };
        edits.sort_by_key(|e| e.span.start);
        Some(Candidate {
            habit: Habit::Characters,
            fix: Fix {
                title,
                values: vec![("text", written.into())],
                applicability: Applicability::Unsafe,
                edits,
            },
            ty: None,
        })
    }

    /// A camera without its angle, which is the last number: 45 degrees are what most have.
    pub(super) fn without_angle(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| ty.kind == RecordKind::Camera)?;
        let is_one = finding.code == Code::E008 && self.params().len() + 1 == ty.params.len();
        let last = self.params().last().filter(|_| is_one)?;
        let at = Span::new(last.end(), last.end());
        Some(Candidate {
            habit: Habit::Up,
            fix: Fix::replace("fix-angle", Applicability::Unsafe, at, format!(" {ANGLE}"))
                .with("number", quote(ANGLE)),
            ty: None,
        })
    }

    /// Three parameters written anew.
    fn vector(&self, habit: Habit, title: &'static str, at: usize, new: &[String; 3]) -> Candidate {
        let tokens = &self.params()[at..at + new.len()];
        let written: Vec<&str> = tokens.iter().map(|t| t.text(self.text)).collect();
        let changed = tokens.iter().zip(new);
        let changed = changed.filter(|(t, new)| t.text(self.text) != new.as_str());
        let fix = Fix {
            title,
            values: vec![
                ("number", quote(&new.join(" ")).into()),
                ("text", quote(&written.join(" ")).into()),
            ],
            applicability: Applicability::Unsafe,
            edits: changed
                .map(|(t, new)| Edit {
                    span: t.span(),
                    text: new.clone(),
                })
                .collect(),
        };
        Candidate {
            habit,
            fix,
            ty: None,
        }
    }
}

/// An up vector for a direction: straight down, what is far is at the top.
fn upright(direction: [f64; 3]) -> [&'static str; 3] {
    match direction {
        [0.0, y, 0.0] if y < 0.0 => ["0", "0", "-1"],
        [0.0, _, 0.0] => ["0", "0", "1"],
        _ => ["0", "1", "0"],
    }
}

//! Guesses at where a camera looks, and which way is up.

use super::solids::has_unit_length;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span};
use crate::geometry::array::{cross, sub};
use crate::lint::spelling::decimal;
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Kind, RecordKind};

/// The angle in degrees for a camera that lacks its angle.
pub(super) const ANGLE: f64 = 45.0;

/// The title of the fix that reads a camera's direction as the point that it looks at.
pub(in crate::analysis::repair) const POINT_TITLE: &str = "fix-look-at";
/// The title of the fix that keeps a camera's direction and adds an up vector.
pub(in crate::analysis::repair) const DIRECTION_TITLE: &str = "fix-up";

impl LineContext<'_> {
    /// Guesses at the missing IDs in a choice of one camera or two, if just as many other cameras are left.
    pub(super) fn only_cameras(&self) -> Option<Candidate> {
        let ty = self.ty()?;
        let is_one = matches!(ty.kind, RecordKind::MonoCamera | RecordKind::StereoCamera);
        let lost = ty.params.len().checked_sub(self.params().len());
        let lost = lost.filter(|&lost| is_one && lost > 0)?;
        let written = self.params().iter().map(|t| t.integer(self.text));
        let written: Vec<i64> = written.collect::<Option<_>>()?;
        let known = self.entities(&[Kind::Camera]).filter(|e| e.kind.is_some());
        let (named, left): (Vec<i64>, Vec<i64>) =
            (known.map(|e| i64::from(e.id))).partition(|id| written.contains(id));
        if named.len() != written.len() || left.len() != lost {
            return None;
        }
        let last = *self.params().last().unwrap_or(&self.tokens[1]);
        let ids = left.iter().map(|id| format!(" {id}"));
        let text = format!("{}{}", last.text(self.text), ids.collect::<String>());
        let habit = match named.is_empty() {
            true => Habit::Lost,
            false => Habit::Eye,
        };
        self.write(habit, &[(last, text)])
    }

    /// Guesses that the direction is the point that the camera looks at, or that the up vector is parallel to the
    /// direction or zero.
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
        if finding.code == Code::E207 || [ux, uy, uz] == [0.0; 3] {
            let upright = upright([dx, dy, dz]).map(str::to_owned);
            out.push(self.vector(Habit::Up, "fix-up", 6, &upright));
        }
    }

    /// Guesses at a camera without its up vector: its direction, or the point that it looks at, is followed by its
    /// angle.
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
        let candidate = |title, habit, way: String, up: [&str; 3]| {
            Candidate::new(
                habit,
                Fix {
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
            )
        };
        let to_point = candidate(
            POINT_TITLE,
            Habit::Point,
            way.map(decimal).join(" "),
            upright(way),
        );
        out.push(to_point);
        let up = upright([dx, dy, dz]);
        let habit = match is_unit([dx, dy, dz]) {
            true => Habit::Direction,
            false => Habit::Up,
        };
        out.push(candidate(DIRECTION_TITLE, habit, text.clone(), up));
    }

    /// Guesses at a camera with one number too few: it lacks its angle, which is 45 degrees in most scenes, or a 0 or 1
    /// of its vectors, wherever the other numbers make a camera with it.
    pub(super) fn lost_number(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| ty.kind == RecordKind::Camera) else {
            return;
        };
        let params = self.params();
        let is_one = finding.code == Code::E008 && params.len() + 1 == ty.params.len();
        let numbers = params.iter().map(|t| t.number(self.text));
        let (Some(numbers), true) = (numbers.collect::<Option<Vec<f64>>>(), is_one) else {
            return;
        };
        let (last, angle) = (params.len() - 1, numbers[params.len() - 1]);
        if !is_angle(angle) {
            let at = Span::new(params[last].end(), params[last].end());
            out.push(Candidate::new(
                Habit::Up,
                Fix::replace("fix-angle", Applicability::Unsafe, at, format!(" {ANGLE}"))
                    .with("number", quote(&ANGLE.to_string())),
            ));
            return;
        }
        let mut found: Vec<(Vec<f64>, Candidate)> = Vec::new();
        for (at, before) in params.iter().enumerate() {
            let lost = if at < 6 { &[0.0][..] } else { &[0.0, 1.0] };
            for &number in lost {
                let mut row = numbers.clone();
                row.insert(at, number);
                let (way, up) = ([row[3], row[4], row[5]], [row[6], row[7], row[8]]);
                let is_camera = is_axis(up) && cross(way, up) != [0.0; 3];
                if !is_camera || found.iter().any(|(known, _)| *known == row) {
                    continue;
                }
                let before = Span::new(before.start, before.start);
                let fix = Fix::replace(
                    "fix-lost-number",
                    Applicability::Unsafe,
                    before,
                    format!("{number} "),
                );
                let candidate = Candidate::new(
                    Habit::Lost,
                    fix.with("name", ty.params[at].name)
                        .with("number", quote(&number.to_string())),
                );
                found.push((row, candidate));
            }
        }
        // In most scenes y is up.
        let is_y_up = |(row, _): &(Vec<f64>, Candidate)| row[7] != 0.0;
        if found.iter().any(is_y_up) {
            found.retain(is_y_up);
        }
        out.extend(found.into_iter().map(|(_, candidate)| candidate));
    }

    /// Guesses that the angle of a camera stands before its up vector or before another vector: the number in the place
    /// of the angle is none.
    pub(super) fn angle_before(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let is_camera = self.ty().is_some_and(|ty| ty.kind == RecordKind::Camera);
        let params = self.params();
        let is_one = is_camera && params.len() == 10 && finding.code == Code::E206;
        for at in [6, 3, 0].into_iter().filter(|_| is_one) {
            if !params[at].number(self.text).is_some_and(is_angle) {
                continue;
            }
            let behind = params[at + 1..].iter().chain([&params[at]]);
            let up = |tokens: &[&Token]| -> Option<Vec<f64>> {
                tokens.iter().map(|t| t.number(self.text)).collect()
            };
            let own = up(&params[6..9].iter().collect::<Vec<_>>());
            let moved: Vec<&Token> = params[..at].iter().chain(behind.clone()).collect();
            // A camera whose written up vector may be one stays as it is.
            if !is_up_rather(up(&moved[6..9]), own) {
                continue;
            }
            let texts = behind.map(|t| t.text(self.text).to_owned());
            let new: Vec<(Token, String)> = params[at..].iter().copied().zip(texts).collect();
            out.extend(self.write(Habit::Up, &new).map(|mut candidate| {
                candidate.fix.title = "fix-angle-last";
                candidate
            }));
        }
    }

    /// The candidate that writes three parameters from `at` on anew.
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
        Candidate::new(habit, fix)
    }
}

/// Whether the length of a vector, or its largest component, is 1.
pub(in crate::analysis::repair) fn is_unit(v: [f64; 3]) -> bool {
    let largest = v.map(f64::abs).into_iter().fold(0.0, f64::max);
    largest == 1.0 || has_unit_length(v)
}

/// Whether a number may be an angle of view in degrees.
fn is_angle(x: f64) -> bool {
    x > 1.0 && x < 180.0
}

/// Whether three numbers are the up vector of a camera rather than three others.
fn is_up_rather(new: Option<Vec<f64>>, old: Option<Vec<f64>>) -> bool {
    let vector = |v: Option<Vec<f64>>| <[f64; 3]>::try_from(v?).ok();
    let (Some(new), Some(old)) = (vector(new), vector(old)) else {
        return false;
    };
    let is_small = |v: [f64; 3]| v.iter().all(|x| x.abs() <= 1.0);
    match is_axis(new) {
        true => !is_axis(old) || new[1] == 1.0 && old[1] != 1.0,
        false => is_small(new) && !is_small(old),
    }
}

/// Whether a vector is one of length 1 along an axis, in its positive direction.
fn is_axis(v: [f64; 3]) -> bool {
    let count = |x: f64| v.iter().filter(|&&part| part == x).count();
    count(0.0) == 2 && count(1.0) == 1
}

/// An up vector for a direction: +y, unless the direction is vertical. If it is straight down, -z is up, so that far
/// things are at the top of the picture.
fn upright(direction: [f64; 3]) -> [&'static str; 3] {
    match direction {
        [0.0, y, 0.0] if y < 0.0 => ["0", "0", "-1"],
        [0.0, _, 0.0] => ["0", "0", "1"],
        _ => ["0", "1", "0"],
    }
}

//! Profiles: their number of points, points in space, and one colour for all points.

use super::numbers::COMMA_TITLE;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType, ShapeKind};

/// The coordinates of a point in space.
const AXES: usize = 3;
/// The parts of a colour.
const PARTS: usize = 3;
/// The fewest points whose third coordinates show by zeros alone that they are points in space. Two such points have as
/// many numbers as three of a profile, so there only spaces or brackets tell.
const TOLD_BY_ZEROS_MIN: usize = 3;

/// Brackets around a point.
const OPENING: [char; 4] = ['(', '[', '<', '{'];
const CLOSING: [char; 4] = [')', ']', '>', '}'];

/// The points of a text, each as its numbers: they have brackets around them, or spaces between them.
fn points(text: &str) -> Option<Vec<Vec<&str>>> {
    if !text.starts_with(OPENING) {
        return Some(text.split_whitespace().map(coordinates).collect());
    }
    let mut all = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let (point, behind) = rest.strip_prefix(OPENING)?.split_once(CLOSING)?;
        all.push(coordinates(point));
        rest = behind.trim_start_matches([',', ';', ' ', '\t', '\r', '\n']);
    }
    Some(all)
}

/// The numbers of a point. Its commas are decimal where something else is between the numbers: a semicolon, a comma
/// with a space, or a space.
fn coordinates(point: &str) -> Vec<&str> {
    let parts: Vec<&str> = if point.contains(';') {
        point.split(';').collect()
    } else if point.contains(", ") {
        point.split(", ").collect()
    } else if point.trim().contains(' ') {
        point.split_whitespace().collect()
    } else {
        point.split(',').collect()
    };
    parts.into_iter().map(str::trim).collect()
}

impl LineContext<'_> {
    /// How many points follow the count at the beginning of a profile. `None` if the numbers there are not whole
    /// points.
    fn whole_points(&self) -> Option<usize> {
        let ty = self.ty().filter(|ty| ty.is_counted())?;
        let each: usize = ty.repeats.iter().map(|group| group.len()).sum();
        let (n, points) = self.params().split_first()?;
        let is_number = |t: &Token| t.number(self.text).is_some();
        let is_one = n.integer(self.text).is_some() && points.iter().all(is_number);
        let count = points.len() / each;
        (is_one && points.len() % each == 0 && count > 1).then_some(count)
    }

    /// Guesses that a profile lacks its number of points, and writes it in front. `None` if the first number is just
    /// that: then a coordinate is missing.
    fn lost_count(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| ty.is_counted() && !self.fits(ty))?;
        let (base, point) = (ty.arity(0), ty.arity(1) - ty.arity(0));
        let numbers = self.params().len() as u64;
        let points = (numbers + 1).checked_sub(base)? / point;
        let is_whole = points >= 2 && ty.arity(points) == numbers + 1;
        let first = self.params().first().filter(|_| is_whole)?;
        if first.integer(self.text).and_then(|n| u64::try_from(n).ok()) == Some(points) {
            return None;
        }
        let text = format!("{points} {}", first.text(self.text));
        self.write(Habit::Count, &[(*first, text)])
    }

    /// Guesses at the points of a profile that are written as pairs with decimal commas, `(0,5;0) (0,5;1,2)`, with or
    /// without brackets.
    pub(super) fn points_with_commas(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| ty.is_counted())?;
        let each: usize = ty.repeats.iter().map(|group| group.len()).sum();
        let (n, behind) = self.params().split_first()?;
        let count = usize::try_from(n.integer(self.text)?).ok()?;
        let end = behind.last()?.end() as usize;
        let closed = self.text[end..].trim_start_matches(CLOSING);
        let all = &self.text[n.end() as usize..self.text.len() - closed.len()];
        let start = n.end() + (all.len() - all.trim_start().len()) as u32;
        let points = points(all.trim())?;
        let is_decimal = points.iter().flatten().any(|x| x.contains(','));
        let is_one = points.len() == count && points.iter().all(|p| p.len() == each);
        let numbers = points.concat().into_iter().map(|x| x.replace(',', "."));
        let numbers: Vec<String> = numbers.collect();
        let is_number = |x: &String| x.parse().is_ok_and(f64::is_finite);
        if !is_decimal || !is_one || !numbers.iter().all(is_number) {
            return None;
        }
        let span = Span::new(start, start + all.trim().len() as u32);
        let mut candidate = Candidate::writing(Habit::Doubled, span, numbers.join(" "));
        candidate.fix.title = COMMA_TITLE;
        candidate.fix = candidate.fix.with("text", quote(&self.text[span.range()]));
        Some(candidate)
    }

    /// Guesses at a profile with a wrong number of points: its points have three coordinates, or one colour for all, or
    /// the number is wrong or missing.
    pub(super) fn count(&self, out: &mut Vec<Candidate>) {
        if let Some(points) = self.points_with_commas() {
            out.push(points);
            return;
        }
        if self.in_space().is_some() {
            out.extend(self.without_third());
            return;
        }
        let coloured = self.one_colour();
        if !coloured.is_empty() {
            out.extend(coloured);
            return;
        }
        let count = self.whole_points().map(|count| count.to_string());
        out.extend(count.and_then(|count| self.write(Habit::Count, &[(self.params()[0], count)])));
        out.extend(self.lost_count());
    }

    /// The finding that a profile says another number of points than it has.
    pub(super) fn points(&self) -> Option<Diagnostic> {
        let points = self.whole_points()?;
        let n = self.params()[0];
        let d = self.wrong_count()?;
        let d = Diagnostic {
            span: n.span(),
            ..d
        }
        .case("points");
        let d = d.with("says", n.text(self.text).to_owned());
        Some(
            d.with("points", Value::Count(points as u64))
                .with("number", quote(&points.to_string())),
        )
    }

    /// The type of a profile, the number of points that it says, and the tokens behind that number.
    fn said_points(&self) -> Option<(&'static RecordType, usize, &[Token])> {
        let ty = self.ty().filter(|ty| ty.is_counted())?;
        let (n, behind) = self.params().split_first()?;
        let n = usize::try_from(n.integer(self.text)?).ok()?;
        let is_right = (2..=behind.len()).contains(&n);
        is_right.then_some((ty, n, behind))
    }

    /// The points of a profile that have three coordinates each: as spaces and brackets show it, or because all third
    /// ones are zero.
    fn in_space(&self) -> Option<&[Token]> {
        let (ty, n, behind) = self.said_points()?;
        let wanted = usize::try_from(ty.arity(n as u64)).ok()? - 1;
        if behind.len() != wanted + n {
            return None;
        }
        let points = &behind[..AXES * n];
        let (flat, groups) = (self.is_flat_profile(points), self.group_sizes(points));
        let told = match groups.len() {
            1 => flat && n >= TOLD_BY_ZEROS_MIN,
            _ => groups.iter().all(|&size| size == AXES),
        };
        let is_number = |t: &Token| t.number(self.text).is_some();
        (told && behind.iter().all(is_number)).then_some(points)
    }

    fn is_flat_profile(&self, points: &[Token]) -> bool {
        let mut points = points.chunks(AXES);
        points.all(|p| p[AXES - 1].number(self.text) == Some(0.0))
    }

    /// The points of a profile without their third coordinates, which are zero.
    fn without_third(&self) -> Option<Candidate> {
        let points = self.in_space().filter(|p| self.is_flat_profile(p))?;
        let edits = points.chunks(AXES).map(|p| Edit {
            span: Span::new(p[AXES - 2].end(), p[AXES - 1].end()),
            text: String::new(),
        });
        let fix = Fix::guess("fix-flat-profile", edits.collect());
        Some(Candidate::new(Habit::Count, fix))
    }

    /// The finding that the points of a profile have three coordinates.
    pub(in crate::analysis::repair) fn points_in_space(&self) -> Option<Diagnostic> {
        let points = self.in_space()?;
        let span = points[0].span().to(points[points.len() - 1].span());
        let d = self.wrong_count()?;
        Some(Diagnostic { span, ..d }.case("space"))
    }

    /// Guesses at one colour behind all points of a coloured profile: it is repeated for each of them, or becomes a
    /// record of its own behind a profile without colours.
    fn one_colour(&self) -> Vec<Candidate> {
        let surface = |kind: ShapeKind| RecordType::of(RecordKind::Shape(kind));
        let coloured = surface(ShapeKind::ColouredSurfaceOfRevolution);
        let said = self.said_points().filter(|s| s.0.kind == coloured.kind);
        let (Some((_, n, behind)), Some(id)) = (said, self.id()) else {
            return Vec::new();
        };
        let is_part = |t: &Token| {
            t.number(self.text)
                .is_some_and(|x| (0.0..=1.0).contains(&x))
        };
        let Some((points, colour)) = behind.split_at_checked(2 * n) else {
            return Vec::new();
        };
        if colour.len() != PARTS || !colour.iter().all(is_part) {
            return Vec::new();
        }
        let Some(text) = self.spaced(colour) else {
            return Vec::new();
        };
        let of_all = Fix::replace(
            "fix-colour-each",
            Applicability::Unsafe,
            colour[0].span().to(colour[PARTS - 1].span()),
            vec![text.as_str(); n].join("  "),
        );
        let plain = surface(ShapeKind::SurfaceOfRevolution);
        let gap = Span::new(points[points.len() - 1].end(), colour[0].start);
        let code = RecordType::of(RecordKind::Colour).code;
        let apart = Fix::guess(
            "fix-colour-apart",
            vec![
                Edit {
                    span: self.tokens[1].span(),
                    text: plain.code.to_string(),
                },
                Edit {
                    span: gap,
                    text: format!("\n{id} {code} "),
                },
            ],
        );
        let values = |fix: Fix| {
            fix.with("text", quote(&text))
                .with("number", plain.code.to_string())
                .with("type", Value::Term(plain.title))
                .with("count", Value::Count(n as u64))
        };
        vec![
            Candidate::new(Habit::Sibling, values(of_all)),
            Candidate::new(Habit::Apart, values(apart)),
        ]
    }
}

//! A shape with its properties in one line, as POV-Ray has them: `sphere { <0,1,0>, 1 pigment { color Red } }`; and a
//! camera, a plane, a cylinder or a light.

use super::cameras::ANGLE;
use super::inline::{ANGLE_TITLE, BLOCK_TITLE, CLAUSES_TITLE, PLANE_TITLE};
use super::properties::OWN;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::geometry::array::{length, sub};
use crate::lint::spelling::decimal;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;
use crate::syntax::table::{Family, RecordKind, RecordType, ShapeKind};
use crate::syntax::words;

/// The height of a picture as a share of its width, for 640 by 480 pixels.
const HEIGHT_TO_WIDTH: f64 = 0.75;

/// A record: its type and its numbers.
pub(super) type Line = (&'static RecordType, String);

/// A type, records with their numbers, the first of that type, and the tokens that follow.
type Block<'t> = (&'static RecordType, Vec<Line>, &'t [Token]);

impl LineContext<'_> {
    /// Guesses at the records of a shape and of each of its properties and moves. A shape without an ID gets the only
    /// undefined ID, or a free one.
    pub(super) fn clauses(&self, used: &[u32]) -> Option<Candidate> {
        let written = self.id().filter(|_| self.tokens[0].kind().is_number());
        let at = usize::from(written.is_some());
        let word = *self.tokens.get(at).filter(|t| is_word(t))?;
        let behind = &self.tokens[at + 1..];
        let (own, rest) = behind.split_at(numbers(behind));
        let named = words::types(word.text(self.text)).into_iter();
        let mut shapes = named.filter(|ty| ty.family == Family::Shape && self.fit(ty, own));
        let shape = shapes.next().filter(|_| !own.is_empty());
        let block = self.block(&word.text(self.text).to_lowercase(), behind);
        let is_block = block.is_some();
        let (shape, lines, rest) = match (block, shape) {
            (Some(block), _) => block,
            (None, Some(shape)) => (shape, vec![(shape, self.texts(own))], rest),
            (None, None) => return self.only_properties(written?),
        };
        let more = self.properties(rest)?;
        let leaves_out = more.leaves_out();
        let (id, is_known) = match (written, &self.missing()[..]) {
            (Some(id), _) => (id, true),
            (None, &[id]) if shape.family == Family::Shape => (id, true),
            // Nothing refers to a camera or a lamp.
            (None, _) => (self.free_id(used)?, shape.family != Family::Shape),
        };
        let mut text = format!(" {}", lines[0].1);
        for (ty, numbers) in lines[1..].iter().chain(&more.lines) {
            text += &format!("\n{id} {} {numbers}", ty.code);
        }
        text += &more.comment();
        let last = self.last_part()?;
        let span = Span::new(word.end(), last.max(word.end()));
        // A comment between the numbers would be lost.
        let is_gone = self.text[span.range()].contains('#');
        let code = match written {
            Some(_) => shape.code.to_string(),
            None => format!("{id} {}", shape.code),
        };
        let edit = |span: Span, text: String| Edit { span, text };
        // Without brackets the numbers may be those of a record of zpg, where d has the other sign.
        let is_bare = |s: &str| !s.trim_start().starts_with(['{', '<']);
        let is_offset = |t: &Token| t.number(self.text).is_some_and(|d| d != 0.0);
        let is_bare_plane = word.text(self.text).eq_ignore_ascii_case("plane")
            && own.len() > OWN
            && own.last().is_some_and(is_offset)
            && is_bare(&self.text[word.end() as usize..]);
        // The word `angle` counts only within the block, and the angle is the last number of a camera.
        let has_angle = shape.kind == RecordKind::Camera
            && behind[..behind.len() - rest.len()]
                .iter()
                .any(|t| is_angle(t.text(self.text)));
        let angle = lines[0].1.rsplit(' ').next().unwrap_or_default();
        let values = match has_angle {
            true => vec![("number", quote(angle).into())],
            false => Vec::new(),
        };
        let fix = Fix {
            title: match (leaves_out, is_block) {
                (true, _) => "fix-clauses-some",
                (false, true) if is_bare_plane => PLANE_TITLE,
                (false, true) if has_angle => ANGLE_TITLE,
                (false, true) => BLOCK_TITLE,
                (false, false) => CLAUSES_TITLE,
            },
            values,
            applicability: match is_known && !is_bare_plane {
                true => Applicability::Unsafe,
                false => Applicability::Choice,
            },
            edits: vec![edit(word.span(), code), edit(span, text)],
        };
        ((is_block || !rest.is_empty()) && !is_gone).then_some(Candidate::new(Habit::Keyword, fix))
    }

    /// Whether a candidate is for a block in the notation of POV-Ray, whose numbers are not those of a record:
    /// `plane { <0,1,0>, -1 }`, `plane <0,1,0>, -1`.
    pub(super) fn is_in_brackets(&self, candidate: &Candidate) -> bool {
        let word = candidate.fix.edits[0].span;
        [BLOCK_TITLE, ANGLE_TITLE].contains(&candidate.fix.title)
            && self.text[word.end as usize..]
                .trim_start()
                .starts_with(['{', '<'])
    }

    /// Reads what POV-Ray writes in another way than as the numbers of a record. Returns the type, the records with
    /// their numbers, and the tokens that follow.
    fn block<'t>(&self, word: &str, behind: &'t [Token]) -> Option<Block<'t>> {
        let count = numbers(behind);
        let (own, rest) = behind.split_at(count);
        let values: Option<Vec<f64>> = own.iter().map(|t| t.number(self.text)).collect();
        let values = values?;
        let half_space = RecordType::of(RecordKind::Shape(ShapeKind::HalfSpace));
        match (word, values.as_slice()) {
            ("camera", []) => self.camera_block(behind),
            ("plane", &[a, b, c, d]) => Some((half_space, vec![plane([a, b, c], d)], rest)),
            // The normal is an axis: `plane { y, -1 }`.
            ("plane", []) => {
                let normal = match behind.first()?.text(self.text) {
                    "x" => [1.0, 0.0, 0.0],
                    "y" => [0.0, 1.0, 0.0],
                    "z" => [0.0, 0.0, 1.0],
                    _ => return None,
                };
                let d = behind.get(1)?.number(self.text)?;
                Some((half_space, vec![plane(normal, d)], &behind[2..]))
            }
            ("cylinder", &[x0, y0, z0, x1, y1, z1, r]) => {
                let lines = cylinder([x0, y0, z0], [x1, y1, z1], r)?;
                Some((lines[0].0, lines, rest))
            }
            ("light_source", &[_, _, _]) => {
                let (intensity, colour, rest) = self.brightness(rest);
                let mut lines = lamp(intensity, self.texts(own));
                lines.extend(colour);
                Some((lines[0].0, lines, rest))
            }
            ("light_source", &[_, _, _, _]) => {
                let intensity = own[OWN].text(self.text).to_owned();
                let lines = lamp(intensity, self.texts(&own[..OWN]));
                Some((lines[0].0, lines, rest))
            }
            _ => None,
        }
    }

    /// Reads how bright a lamp is, as `rgb 0.8` or `color rgb<1,1,1>*0.8`. Returns its intensity, the record of its
    /// colour unless that is white, and the tokens that follow. A colour without a factor is a property.
    fn brightness<'t>(&self, behind: &'t [Token]) -> (String, Option<Line>, &'t [Token]) {
        let is_colour = |t: &&Token| {
            let named = words::types(t.text(self.text));
            is_word(t) && named.iter().any(|ty| ty.kind == RecordKind::Colour)
        };
        let count = behind.iter().take_while(is_colour).count();
        let (own, rest) = behind[count..].split_at(numbers(&behind[count..]));
        let factor = rest.first().and_then(|t| {
            let factor = t.text(self.text).strip_prefix('*')?;
            factor.parse().is_ok_and(f64::is_finite).then_some(factor)
        });
        match (own, factor) {
            ([one], None) if count > 0 => (one.text(self.text).to_owned(), None, rest),
            ([_, _, _], Some(factor)) if count > 0 => {
                let is_white = own.iter().all(|t| t.number(self.text) == Some(1.0));
                let colour = (RecordType::of(RecordKind::Colour), self.texts(own));
                (factor.to_owned(), (!is_white).then_some(colour), &rest[1..])
            }
            _ => ("1".to_owned(), None, behind),
        }
    }

    /// A camera of POV-Ray: `camera { location <0,1,8> look_at <0,0,0> angle 45 }`. Its angle is that of the width.
    fn camera_block<'t>(&self, behind: &'t [Token]) -> Option<Block<'t>> {
        let mut rest = behind;
        let (mut location, mut target) = (None, None);
        let (mut direction, mut up, mut angle) = (None, [0.0, 1.0, 0.0], ANGLE);
        while let Some((word, after)) = rest.split_first() {
            let (own, behind) = after.split_at(numbers(after));
            let values: Option<Vec<f64>> = own.iter().map(|t| t.number(self.text)).collect();
            match (&*word.text(self.text).to_lowercase(), &*values?) {
                ("perspective", []) | ("right", [_, _, _]) => {}
                ("location", &[x, y, z]) => location = Some([x, y, z]),
                ("look_at", &[x, y, z]) => target = Some([x, y, z]),
                ("direction", &[x, y, z]) => direction = Some([x, y, z]),
                ("up" | "sky", &[x, y, z]) => up = [x, y, z],
                (word, &[degrees]) if is_angle(word) => angle = of_height(degrees),
                _ => return None,
            }
            rest = behind;
        }
        let location = location?;
        let direction = target.map_or(direction, |target| Some(sub(target, location)))?;
        let all = [location, direction, up].concat();
        let all = all.into_iter().chain([angle]).map(decimal);
        let camera = RecordType::of(RecordKind::Camera);
        let text = all.collect::<Vec<_>>().join(" ");
        Some((camera, vec![(camera, text)], rest))
    }
}

fn is_angle(word: &str) -> bool {
    word.eq_ignore_ascii_case("angle")
}

/// Converts the angle of view of a picture's width to that of its height, to a tenth of a degree.
fn of_height(of_width: f64) -> f64 {
    match of_width > 0.0 && of_width < 180.0 {
        true => {
            let half = libm::atan(HEIGHT_TO_WIDTH * libm::tan(of_width.to_radians() / 2.0));
            (20.0 * half.to_degrees()).round() / 10.0
        }
        false => of_width,
    }
}

/// The records of a lamp: its light, and its translation to its place.
fn lamp(intensity: String, place: String) -> Vec<Line> {
    let [light, translation] =
        [RecordKind::PointLight, RecordKind::Translation].map(RecordType::of);
    vec![(light, intensity), (translation, place)]
}

/// The half-space below a plane, by its normal and the distance of the plane from the origin along the normal.
fn plane(normal: [f64; 3], along: f64) -> (&'static RecordType, String) {
    let ty = RecordType::of(RecordKind::Shape(ShapeKind::HalfSpace));
    let [a, b, c] = normal.map(decimal);
    (
        ty,
        format!("{a} {b} {c} {}", decimal(-along * length(normal))),
    )
}

/// The records of a cylinder along one of the axes, by the centres of its ends: a surface of revolution about the y
/// axis, turned and moved. `None` if it is along none of the axes.
fn cylinder(
    from: [f64; 3],
    to: [f64; 3],
    radius: f64,
) -> Option<Vec<(&'static RecordType, String)>> {
    let of = |kind| RecordType::of(kind);
    let along = sub(to, from);
    let axis = along.iter().position(|&x| x != 0.0)?;
    if along.iter().filter(|&&x| x != 0.0).count() > 1 {
        return None;
    }
    let (low, high) = (along[axis].min(0.0), along[axis].max(0.0));
    let [r, low, high] = [radius, low, high].map(decimal);
    let profile = of(RecordKind::Shape(ShapeKind::SurfaceOfRevolution));
    let mut lines = vec![(profile, format!("2 {r} {low} {r} {high}"))];
    // A turn about z takes the y axis to x, and a turn about x takes it to z.
    let turn = ["-90 3", "", "90 1"][axis];
    if !turn.is_empty() {
        lines.push((of(RecordKind::Rotation), turn.to_owned()));
    }
    if from != [0.0; 3] {
        let place = from.map(decimal).join(" ");
        lines.push((of(RecordKind::Translation), place));
    }
    Some(lines)
}

pub(super) fn is_word(t: &Token) -> bool {
    t.kind() == TokenKind::Word
}

/// How many numbers some tokens begin with.
pub(super) fn numbers(tokens: &[Token]) -> usize {
    tokens.iter().take_while(|t| t.kind().is_number()).count()
}

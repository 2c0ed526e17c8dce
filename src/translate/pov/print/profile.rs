//! Profiles of surfaces of revolution: as lathes, and as patterns along the profile.
//!
//! A lathe itself tells where on its profile a point lies: with `uv_mapping`, y is (i + t)/n at the fraction t of
//! segment i of n.

use super::shape::{Primitive, size_unit};
use super::text::vector;
use crate::solids::shapes::profile::twice_area;
use crate::translate::number;

/// The most entries that one of POV-Ray's maps may have.
const MAP: usize = 256;
/// Points on a line of the file.
const PER_LINE: usize = 6;

/// The closed profile of a lathe.
pub(super) struct Profile {
    /// Points from the axis to the axis, or of a ring; no point twice in a row. Counter-clockwise, which tells POV-Ray
    /// the outer side of the lathe from the inner one.
    points: Vec<[f64; 2]>,
    /// For each point of the scene's profile its index in `points`.
    places: Vec<usize>,
    /// For each point of the scene's profile, the fraction of the profile's length up to it.
    arc: Vec<f64>,
}

impl Profile {
    pub(super) fn of(profile: &[[f64; 2]]) -> Profile {
        let ring = profile.first() == profile.last();
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(profile.len() + 2);
        let mut places = Vec::with_capacity(profile.len());
        let push = |points: &mut Vec<[f64; 2]>, p: [f64; 2]| {
            if points.last() != Some(&p) {
                points.push(p);
            }
        };
        if let (false, Some(first)) = (ring, profile.first()) {
            push(&mut points, [0.0, first[1]]);
        }
        for p in profile {
            push(&mut points, *p);
            places.push(points.len() - 1);
        }
        if let (false, Some(last)) = (ring, profile.last()) {
            push(&mut points, [0.0, last[1]]);
        }
        let mut arc = vec![0.0; profile.len()];
        for i in 1..profile.len() {
            let [a, b] = [profile[i - 1], profile[i]];
            arc[i] = arc[i - 1] + (b[0] - a[0]).hypot(b[1] - a[1]);
        }
        if twice_area(&points) < 0.0 {
            points.reverse();
            for place in &mut places {
                *place = points.len() - 1 - *place;
            }
        }
        let whole = arc.last().copied().unwrap_or(0.0);
        if whole > 0.0 {
            arc.iter_mut().for_each(|a| *a /= whole);
        }
        Profile {
            points,
            places,
            arc,
        }
    }

    pub(super) fn lathe(&self) -> Primitive {
        let size = self
            .points
            .iter()
            .flatten()
            .fold(0.0f64, |m, x| m.max(x.abs()));
        let unit = size_unit(size);
        let points = self.points.iter().map(|p| vector(&p.map(|x| x / unit)));
        let points: Vec<String> = points.collect();
        let mut lines = vec![format!("linear_spline {},", points.len())];
        let rows = points.len().div_ceil(PER_LINE);
        for (i, row) in points.chunks(PER_LINE).enumerate() {
            let comma = if i + 1 < rows { "," } else { "" };
            lines.push(format!("{}{comma}", row.join(", ")));
        }
        Primitive {
            keyword: "lathe",
            lines,
        }
        .scaled(unit)
    }

    /// A pattern along the profile, to be written after `uv_mapping`. It has the given value at each point of the
    /// scene's profile and is linear between them; the discs at the ends have the value of their point.
    pub(super) fn pattern(&self, values: impl Iterator<Item = String>) -> String {
        let segments = (self.points.len() - 1).max(1) as f64;
        let places = self.places.iter().map(|place| *place as f64 / segments);
        let mut entries: Vec<_> = places.zip(values).collect();
        // The positions in POV-Ray's maps have to ascend.
        if self.places.first() > self.places.last() {
            entries.reverse();
        }
        pattern(&entries)
    }

    /// The arc length along the profile, from 0 to 1, as a [`pattern`](Self::pattern) in grey.
    pub(super) fn arc_pattern(&self) -> String {
        self.pattern(self.arc.iter().map(|a| format!("rgb {}", number(*a))))
    }
}

/// The text `function { … } color_map { … }` of a pattern over y, or a map of such maps for many entries. The function
/// is 1/4 + y/2, which stays below 1, where patterns begin again.
fn pattern(entries: &[(f64, String)]) -> String {
    const FUNCTION: &str = "function { 0.25 + 0.5*y }";
    let at = |y: f64| number(0.25 + 0.5 * y);
    let colour_map = |entries: &[(f64, String)]| {
        let list: Vec<String> = entries
            .iter()
            .map(|(y, value)| format!("[{} {value}]", at(*y)))
            .collect();
        format!("color_map {{ {} }}", list.join(" "))
    };
    if entries.len() <= MAP {
        return format!("{FUNCTION} {}", colour_map(entries));
    }
    // Neighbouring maps share an entry; each map holds from its first entry to its last.
    let mut out = format!("{FUNCTION} pigment_map {{");
    let mut from = 0;
    while from + 1 < entries.len() {
        let to = (from + MAP - 1).min(entries.len() - 1);
        let part = &entries[from..=to];
        let inner = format!("{FUNCTION} {}", colour_map(part));
        out.push_str(&format!(
            "\n      [{} {inner}]\n      [{} {inner}]",
            at(part[0].0),
            at(part[part.len() - 1].0)
        ));
        from = to;
    }
    out.push_str("\n    }");
    out
}

//! Surface coordinates as POV-Ray functions of a point in the shape's own coordinates.
//! POV-Ray's `uv_mapping` has other coordinates for most shapes.

use super::text::number;
use crate::scene::{Geometry, Vec3};

/// u and v of a point (x, y, z) on the shape; `None` for shapes that have no such formula here.
pub fn expressions(geometry: &Geometry) -> Option<[String; 2]> {
    match geometry {
        Geometry::Sphere { centre, radius } => {
            let [x, y, z] = from_centre(*centre);
            let height = format!("{y}/{}", number(*radius));
            Some([
                // The angle mod 1, so that it is never negative.
                format!("select(-{z}, 1, 0) + atan2(-{z}, {x})/(2*pi)"),
                format!("acos(max(-1, min(1, -{height})))/pi"),
            ])
        }
        Geometry::Box { min, max } => Some(box_faces(*min, *max)),
        Geometry::Rectangle { min, max } => {
            Some([along("x", min[0], max[0]), along("y", min[1], max[1])])
        }
        Geometry::Plane(p) | Geometry::HalfSpace(p) => plane(p),
        _ => None,
    }
}

/// `(x - c)`.
fn minus(axis: &str, c: f64) -> String {
    if c == 0.0 {
        axis.to_owned()
    } else if c < 0.0 {
        format!("({axis} + {})", number(-c))
    } else {
        format!("({axis} - {})", number(c))
    }
}

fn from_centre(c: Vec3) -> [String; 3] {
    [minus("x", c[0]), minus("y", c[1]), minus("z", c[2])]
}

/// From 0 at `min` to 1 at `max`.
fn along(axis: &str, min: f64, max: f64) -> String {
    let length = max - min;
    if length > 0.0 {
        format!("{}/{}", minus(axis, min), number(length))
    } else {
        "0".to_owned()
    }
}

/// The face is the one that the point is farthest out on, as a part of the box's half-width.
fn box_faces(min: Vec3, max: Vec3) -> [String; 2] {
    let axes = ["x", "y", "z"];
    let out: [String; 3] = std::array::from_fn(|i| {
        let half = (max[i] - min[i]) / 2.0;
        let centre = min[i] / 2.0 + max[i] / 2.0;
        if half > 0.0 {
            format!("{}/{}", minus(axes[i], centre), number(half))
        } else {
            // A box without thickness: every point is on these two faces.
            "2".to_owned()
        }
    });
    let [x, y, z]: [String; 3] = std::array::from_fn(|i| along(axes[i], min[i], max[i]));
    let [ox, oy, oz] = &out;
    let face = |on_x: String, on_y: String, on_z: String| {
        format!(
            "select(max(abs({oy}), abs({oz})) - abs({ox}), {on_x}, {on_x}, select(abs({oz}) - abs({oy}), {on_y}, {on_y}, {on_z}))"
        )
    };
    let mirrored =
        |side: &str, there: String, here: String| format!("select({side}, {there}, {here})");
    let u = face(
        mirrored(ox, z.clone(), format!("1 - {z}")),
        x.clone(),
        mirrored(oz, format!("1 - {x}"), x.clone()),
    );
    let v = face(
        y.clone(),
        mirrored(oy, z.clone(), format!("1 - {z}")),
        y.clone(),
    );
    [u, v]
}

/// Lengths along ŷ × n and n × that, from the point nearest the origin.
fn plane(p: &[f64; 4]) -> Option<[String; 2]> {
    let length = p[0].hypot(p[1]).hypot(p[2]);
    let n = [p[0] / length, p[1] / length, p[2] / length];
    let side = if n[1].abs() > 0.999 {
        // −ẑ × n
        [n[1], -n[0], 0.0]
    } else {
        // ŷ × n
        [n[2], 0.0, -n[0]]
    };
    let length = side[0].hypot(side[1]).hypot(side[2]);
    let u = side.map(|c| c / length);
    let v = [
        n[1] * u[2] - n[2] * u[1],
        n[2] * u[0] - n[0] * u[2],
        n[0] * u[1] - n[1] * u[0],
    ];
    let finite = u.iter().chain(&v).all(|c| c.is_finite());
    finite.then(|| [dot(u), dot(v)])
}

fn dot(c: Vec3) -> String {
    let terms: Vec<String> = ["x", "y", "z"]
        .iter()
        .zip(c)
        .filter(|(_, c)| *c != 0.0)
        .map(|(axis, c)| match c {
            1.0 => (*axis).to_owned(),
            -1.0 => format!("(-{axis})"),
            c => format!("({})*{axis}", number(c)),
        })
        .collect();
    if terms.is_empty() {
        "0".to_owned()
    } else {
        terms.join(" + ")
    }
}

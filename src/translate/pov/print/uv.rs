//! Surface coordinates as POV-Ray functions of a point in the shape's own coordinates.
//! POV-Ray's `uv_mapping` has other coordinates for most shapes.

use crate::geometry::array::{cross, dot, length};
use crate::scene::Vec3;
use crate::translate::number;

/// The surface coordinates u and v, as expressions in x, y and z: those of a point, and for a lathe, those that
/// `uv_mapping` makes of the point.
pub(super) struct Coordinates {
    pub u: String,
    pub v: Along,
}

/// The way in which v is written.
pub(super) enum Along {
    Expression(String),
    /// A pigment whose red is v.
    Pattern(String),
}

/// The distance from the y axis.
pub(super) const RHO: &str = "sqrt(x*x + z*z)";

/// The angle about the y axis as a fraction of a full turn, from 0 to 1 and never negative.
pub(super) fn turn(x: &str, z: &str) -> String {
    format!("select(-{z}, 1, 0) + atan2(-{z}, {x})/(2*pi)")
}

pub(super) fn around() -> String {
    turn("x", "z")
}

/// The polar angle, acos(−height)/π: 0 for the height −1, 1 for the height 1.
pub(super) fn polar(height: &str) -> String {
    format!("acos(max(-1, min(1, -{height})))/pi")
}

/// The angle round the tube, as a fraction of a full turn. With a tube wider than its ring, points of the lemon count
/// as points of the tube from beyond the axis.
pub(super) fn tube(major: f64, minor: f64) -> String {
    let ring = number(major);
    let across = if minor > major {
        let square = number(minor * minor);
        let off = |sign: char| format!("abs(pow({RHO} {sign} {ring}, 2) + y*y - {square})");
        format!(
            "(select({} - {}, 1, -1)*{RHO} - {ring})",
            off('-'),
            off('+')
        )
    } else {
        format!("({RHO} - {ring})")
    };
    format!("select(y, 1, 0) + atan2(y, {across})/(2*pi)")
}

/// The second coordinate of a double cone. On the sides ρ/r equals |y|/h, and on the discs it is less. The summand 1e-6
/// lets the sides win where the two are the same up to rounding; it takes the outermost millionth from a disc.
pub(super) fn double_cone(height: f64, radius: f64) -> String {
    let (h, r) = (number(height), number(radius));
    format!("select({RHO}/{r} - abs(y)/{h} + 1e-6, {RHO}/{r}, 0.5 + 0.5*y/{h})")
}

/// The barycentric weights of the second and third vertex.
pub(super) fn weights([a, b, c]: &[Vec3; 3]) -> [String; 2] {
    let size = [b, c]
        .iter()
        .flat_map(|p| (0..3).map(|i| (p[i] - a[i]).abs()))
        .fold(0.0f64, f64::max);
    let edge = |p: &Vec3| -> Vec3 { std::array::from_fn(|i| (p[i] - a[i]) / size) };
    let (ab, ac) = (edge(b), edge(c));
    let n = cross(ab, ac);
    let square = dot(n, n);
    let weight = |v: Vec3| {
        let g = v.map(|x| x / square / size);
        if !g.iter().all(|x| x.is_finite()) {
            return "1/3".to_owned();
        }
        let terms = ["x", "y", "z"]
            .iter()
            .zip(g.iter().zip(a))
            .filter(|(_, (g, _))| **g != 0.0)
            .map(|(axis, (g, a))| format!("({})*{}", number(*g), minus(axis, *a)));
        let sum = terms.collect::<Vec<_>>().join(" + ");
        format!("max(0, min(1, {sum}))")
    };
    [weight(cross(ac, n)), weight(cross(n, ab))]
}

/// The text of a difference, `(x - c)`; for c = 0, the axis alone.
fn minus(axis: &str, c: f64) -> String {
    if c == 0.0 {
        axis.to_owned()
    } else if c < 0.0 {
        format!("({axis} + {})", number(-c))
    } else {
        format!("({axis} - {})", number(c))
    }
}

pub(super) fn from_centre(c: Vec3) -> [String; 3] {
    [minus("x", c[0]), minus("y", c[1]), minus("z", c[2])]
}

/// The expression that goes from 0 at `min` to 1 at `max` along an axis.
pub(super) fn along(axis: &str, min: f64, max: f64) -> String {
    let length = max - min;
    if length > 0.0 {
        format!("{}/{}", minus(axis, min), number(length))
    } else {
        "0".to_owned()
    }
}

/// u and v on a box. The face of a point is the one towards which it is farthest from the centre, measured in
/// half-widths of the box.
pub(super) fn box_faces(min: Vec3, max: Vec3) -> [String; 2] {
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

/// u and v on a plane: lengths along ŷ × n and n × (ŷ × n), from the point nearest the origin.
pub(super) fn plane(p: &[f64; 4]) -> [String; 2] {
    let largest = p[..3].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let p = [p[0] / largest, p[1] / largest, p[2] / largest];
    let far = length(p);
    let n = p.map(|x| x / far);
    // The language's own bound for planes that lie flat.
    let side = if n[1].abs() > 0.999 {
        // −ẑ × n
        [n[1], -n[0], 0.0]
    } else {
        // ŷ × n
        [n[2], 0.0, -n[0]]
    };
    let long = length(side);
    let u = side.map(|x| x / long);
    [product(u), product(cross(n, u))]
}

/// The text of the scalar product c·(x, y, z).
fn product(c: Vec3) -> String {
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

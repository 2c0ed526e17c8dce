//! Materials: what of light is diffused, mirrored and let through, as a mixture of Mitsuba's BSDFs.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::exact::Exact;
use super::xml::{number, rgb};
use crate::scene::{DEFAULT_COLOUR, Optics, Rgb, Texture};
use crate::trace::graph::Graph;
use crate::translate::mesh::Skin;

/// How a mesh knows its colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Colours {
    /// They are one, the skin's.
    Plain,
    OfFaces,
    OfPoints,
}

/// The materials of a scene, each written once.
pub struct Bsdfs<'g> {
    graph: &'g Graph,
    pub text: String,
    numbers: HashMap<String, usize>,
}

impl<'g> Bsdfs<'g> {
    pub fn new(graph: &'g Graph) -> Bsdfs<'g> {
        Bsdfs {
            graph,
            text: String::new(),
            numbers: HashMap::new(),
        }
    }

    /// A reference to the material of an exact shape with an index around it.
    pub fn exact(&mut self, skin: &Skin, shape: &Exact, around: Option<u32>) -> String {
        let board = skin
            .texture
            .as_ref()
            .map(|t| &self.graph.textures[t.texture as usize]);
        let colour = match (skin.plain_colour(self.graph), board, shape.uv) {
            (None, Some(Texture::Checkerboard { n, m, colours }), Some([[su, sv], [tu, tv]])) => {
                // Its board has two cells each way.
                let [x, y] = [f64::from(*n) / 2.0, f64::from(*m) / 2.0];
                let [ax, ay, bx, by] = [su * x, sv * y, tu * x, tv * y].map(number);
                Reflectance::Board(
                    *colours,
                    format!(
                        "<transform name=\"to_uv\"><scale x=\"{ax}\" y=\"{ay}\"/><translate x=\"{bx}\" y=\"{by}\"/></transform>"
                    ),
                )
            }
            (plain, ..) => Reflectance::Plain(plain.unwrap_or(DEFAULT_COLOUR)),
        };
        self.reference(skin, &colour, around)
    }

    /// A reference to the material of a mesh with an index around it.
    pub fn mesh(&mut self, skin: &Skin, colours: Colours, around: Option<u32>) -> String {
        let colour = match colours {
            Colours::Plain => {
                Reflectance::Plain(skin.plain_colour(self.graph).unwrap_or(DEFAULT_COLOUR))
            }
            Colours::OfFaces => Reflectance::Attribute("face_color"),
            Colours::OfPoints => Reflectance::Attribute("vertex_color"),
        };
        self.reference(skin, &colour, around)
    }

    fn reference(&mut self, skin: &Skin, colour: &Reflectance, around: Option<u32>) -> String {
        let optics = &self.graph.optics[skin.optics.unwrap_or(0) as usize];
        let indices = [skin.index, around].map(|i| self.graph.indices[i.unwrap_or(0) as usize]);
        let body = mixture(optics, indices, colour);
        let next = self.numbers.len();
        let n = *self.numbers.entry(body.clone()).or_insert(next);
        if n == next {
            // Writing to a string does not fail.
            let (start, rest) = body.split_at("<bsdf".len());
            let _ = writeln!(self.text, "  {start} id=\"Material_{n}\"{rest}");
        }
        format!("<ref id=\"Material_{n}\"/>")
    }
}

enum Reflectance {
    Plain(Rgb),
    Attribute(&'static str),
    /// Two colours, and the transformation of surface coordinates.
    Board([Rgb; 2], String),
}

impl Reflectance {
    /// As the diffuse reflectance, dimmed per channel.
    fn xml(&self, k: Rgb) -> String {
        let by = |c: Rgb| [0, 1, 2].map(|i| c[i] * k[i]);
        match self {
            Reflectance::Plain(c) => rgb("reflectance", by(*c)),
            Reflectance::Attribute(name) => {
                let scale = number(mean(k));
                format!(
                    "<texture name=\"reflectance\" type=\"mesh_attribute\"><string name=\"name\" value=\"{name}\"/><float name=\"scale\" value=\"{scale}\"/></texture>"
                )
            }
            Reflectance::Board([a, b], to_uv) => format!(
                "<texture name=\"reflectance\" type=\"checkerboard\">{}{}{to_uv}</texture>",
                rgb("color0", by(*a)),
                rgb("color1", by(*b)),
            ),
        }
    }
}

fn mean(k: Rgb) -> f64 {
    k.iter().sum::<f64>() / 3.0
}

fn blend(weight: f64, first: &str, second: &str) -> String {
    format!(
        "<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"{}\"/>{first}{second}</bsdf>",
        number(weight)
    )
}

/// Each kind of light takes part as often as it is strong, and is as much stronger then. The indices
/// are those of the two sides: within and around.
fn mixture(o: &Optics, [within, around]: [Rgb; 2], colour: &Reflectance) -> String {
    // By the strongest channel: where no light is made, what is stronger then is no more than all.
    let strongest = |k: Rgb| k.iter().fold(0.0f64, |m, x| m.max(*x));
    let (kd, ks, kt) = (strongest(o.kd), strongest(o.ks), strongest(o.kt));
    let all = kd + ks + kt;
    // Mitsuba knows no surface that makes light.
    let scaled = |k: Rgb, share: f64| {
        k.map(|x| match share > 0.0 {
            true => (x / share).clamp(0.0, 1.0),
            false => 0.0,
        })
    };
    if all == 0.0 {
        return format!(
            "<bsdf type=\"twosided\"><bsdf type=\"diffuse\">{}</bsdf></bsdf>",
            rgb("reflectance", [0.0; 3])
        );
    }
    let (diffuse, mirrored, through) = (kd / all, ks / all, kt / all);
    let matt = format!(
        "<bsdf type=\"diffuse\">{}</bsdf>",
        colour.xml(scaled(o.kd, diffuse))
    );
    let mirror = format!(
        "<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/>{}</bsdf>",
        rgb("specular_reflectance", scaled(o.ks, mirrored))
    );
    let opaque = match (diffuse > 0.0, mirrored > 0.0) {
        (true, true) => blend(mirrored / (diffuse + mirrored), &matt, &mirror),
        (false, true) => mirror,
        _ => matt,
    };
    let opaque = format!("<bsdf type=\"twosided\">{opaque}</bsdf>");
    if through == 0.0 {
        return opaque;
    }
    // What does not bend light is a sheet, which knows no total reflection either.
    let kind = if within == around {
        "thindielectric"
    } else {
        "dielectric"
    };
    let indices =
        [mean(within), mean(around)].map(|n| number(if within == around { 1.0 } else { n }));
    let clear = format!(
        "<bsdf type=\"{kind}\"><float name=\"int_ior\" value=\"{}\"/><float name=\"ext_ior\" value=\"{}\"/>{}</bsdf>",
        indices[0],
        indices[1],
        rgb("specular_transmittance", scaled(o.kt, through))
    );
    if diffuse + mirrored == 0.0 {
        clear
    } else {
        blend(through, &opaque, &clear)
    }
}

//! Materials: the shares of light that a surface diffuses, mirrors and lets through, as a mixture of Mitsuba's BSDFs.

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;

use super::exact::Exact;
use super::xml::{escaped, rgb};
use crate::scene::{DEFAULT_COLOUR, Optics, Rgb, Texture};
use crate::trace::graph::Graph;
use crate::translate::mesh::SurfaceLabel;
use crate::translate::mesh::picture::file_name;
use crate::translate::number;

/// The way in which a mesh has its colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Colours {
    /// A single colour, the skin's.
    Plain,
    OfFaces,
    OfPoints,
    /// A picture, or a checkerboard, that is laid on by surface coordinates: the number of its texture.
    Pictured(u32),
}

/// The materials of a scene, each written once.
pub(super) struct Bsdfs<'g> {
    graph: &'g Graph,
    pub text: String,
    numbers: HashMap<String, usize>,
    /// The numbers of the textures whose pictures are used.
    pub images: BTreeSet<u32>,
    /// The numbers, in the graph, of the refractive indices that differ by channel: they are parameters of the
    /// document.
    dispersive: BTreeSet<u32>,
}

impl<'g> Bsdfs<'g> {
    pub(super) fn new(graph: &'g Graph) -> Bsdfs<'g> {
        Bsdfs {
            graph,
            text: String::new(),
            numbers: HashMap::new(),
            images: BTreeSet::new(),
            dispersive: BTreeSet::new(),
        }
    }

    /// The largest component of any colour in the scene's textures, pictures excepted.
    pub(super) fn brightest(&self) -> f64 {
        let colours = self
            .graph
            .textures
            .iter()
            .flat_map(|texture| match texture {
                Texture::Colour(c) => vec![*c],
                Texture::Checkerboard { colours, .. } | Texture::Solid { colours, .. } => {
                    colours.to_vec()
                }
                Texture::Image { .. } => Vec::new(),
            });
        colours.flatten().fold(0.0, f64::max)
    }

    /// A reference to the material of an exact shape. `around` is the number of the refractive index outside, `stem`
    /// the beginning of the names of files.
    pub(super) fn exact(
        &mut self,
        skin: &SurfaceLabel,
        shape: &Exact,
        around: Option<u32>,
        stem: &str,
    ) -> String {
        let plain = skin.plain_colour(self.graph);
        let colour = match (plain, &skin.texture, shape.uv) {
            (None, Some(t), Some(uv)) => self.picture(t.texture, uv, stem),
            (plain, ..) => Reflectance::Plain(plain.unwrap_or(DEFAULT_COLOUR)),
        };
        self.reference(skin, &colour, around)
    }

    /// A reference to the material of a mesh. `around` is the number of the refractive index outside, `stem` the
    /// beginning of the names of files.
    pub(super) fn mesh(
        &mut self,
        skin: &SurfaceLabel,
        colours: Colours,
        around: Option<u32>,
        stem: &str,
    ) -> String {
        let colour = match colours {
            Colours::Plain => {
                Reflectance::Plain(skin.plain_colour(self.graph).unwrap_or(DEFAULT_COLOUR))
            }
            Colours::OfFaces => Reflectance::Attribute("face_color"),
            Colours::OfPoints => Reflectance::Attribute("vertex_color"),
            Colours::Pictured(number) => self.picture(number, [[1.0; 2], [0.0; 2]], stem),
        };
        self.reference(skin, &colour, around)
    }

    /// A checkerboard or an image as a reflectance. `uv` has the factors and the summands that make the scene's surface
    /// coordinates of Mitsuba's.
    fn picture(&mut self, number: u32, uv: [[f64; 2]; 2], stem: &str) -> Reflectance {
        match &self.graph.textures[number as usize] {
            // Mitsuba's checkerboard has two cells in each direction.
            Texture::Checkerboard { n, m, colours } => {
                let cells = [n, m].map(|n| f64::from(*n) / 2.0);
                Reflectance::Board(*colours, to_uv(cells, uv))
            }
            _ => {
                self.images.insert(number);
                // Mitsuba's pictures hang down from v = 0.
                Reflectance::Image(file_name(stem, number), to_uv([1.0, -1.0], uv))
            }
        }
    }

    /// The part of a document about indices that differ by channel: a comment with the commands for a picture of each
    /// channel, and the parameters, whose defaults are the means of the channels. `None` if no index differs.
    pub(super) fn dispersion(&self) -> Option<String> {
        let channel = |k: usize| {
            let of = |i: &u32| {
                let value = number(self.graph.indices[*i as usize][k]);
                format!(" -D {}={value}", parameter(*i))
            };
            self.dispersive.iter().map(of).collect::<String>()
        };
        let defaults = self.dispersive.iter().map(|i| {
            let value = number(mean(self.graph.indices[*i as usize]));
            format!(
                "  <default name=\"{}\" value=\"{value}\"/>\n",
                parameter(*i)
            )
        });
        (!self.dispersive.is_empty()).then(|| {
            format!(
                "  <!-- Refractive indices differ by channel: make three pictures, and keep one channel of each:\n       \
                 red: mitsuba{}\n       green: mitsuba{}\n       blue: mitsuba{}\n       \
                 Without -D all channels have the mean. -->\n{}",
                channel(0),
                channel(1),
                channel(2),
                defaults.collect::<String>()
            )
        })
    }

    fn reference(
        &mut self,
        skin: &SurfaceLabel,
        colour: &Reflectance,
        around: Option<u32>,
    ) -> String {
        let optics = &self.graph.optics[skin.optics.unwrap_or(0) as usize];
        let sides = [skin.index, around].map(|i| i.unwrap_or(0));
        let indices = sides.map(|i| self.graph.indices[i as usize]);
        let bends = optics.kt != [0.0; 3] && indices[0] != indices[1];
        let named = [0, 1].map(|k| match is_plain(indices[k]) {
            true => number(indices[k][0]),
            false if bends => {
                self.dispersive.insert(sides[k]);
                format!("${}", parameter(sides[k]))
            }
            false => number(mean(indices[k])),
        });
        let body = mixture(optics, bends.then_some(&named), colour);
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

/// The transformation `to_uv` of a texture that repeats `x` times along u and `y` times along v of the scene's surface
/// coordinates. The second argument has the factors and the summands that make these of Mitsuba's.
fn to_uv([x, y]: [f64; 2], [[su, sv], [tu, tv]]: [[f64; 2]; 2]) -> String {
    let whole = |b: f64| b.rem_euclid(1.0);
    let [ax, ay, bx, by] = [su * x, sv * y, whole(tu * x), whole(tv * y)].map(number);
    format!(
        "<transform name=\"to_uv\"><scale x=\"{ax}\" y=\"{ay}\"/><translate x=\"{bx}\" y=\"{by}\"/></transform>"
    )
}

/// Whether an index is the same in all channels.
fn is_plain(index: Rgb) -> bool {
    index.iter().all(|x| *x == index[0])
}

fn parameter(index: u32) -> String {
    format!("index_{index}")
}

enum Reflectance {
    /// A file, and the transformation of surface coordinates.
    Image(String, String),
    Plain(Rgb),
    Attribute(&'static str),
    /// Two colours, and the transformation of surface coordinates.
    Board([Rgb; 2], String),
}

impl Reflectance {
    /// The BSDF of a surface that diffuses light, dimmed by `k` per channel.
    fn diffuse(&self, k: Rgb) -> String {
        let matt = |reflectance: &str| format!("<bsdf type=\"diffuse\">{reflectance}</bsdf>");
        match self {
            // Mitsuba's pictures have no factor, so the surface is partly black instead.
            Reflectance::Image(..) if k != [1.0; 3] => {
                let black = matt(&rgb("reflectance", [0.0; 3]));
                blend(mean(k), &black, &matt(&self.xml(k)))
            }
            _ => matt(&self.xml(k)),
        }
    }

    /// The XML of the reflectance of a diffuse surface. Colours are dimmed by `k` per channel, mesh attributes by its
    /// mean, and pictures not at all.
    fn xml(&self, k: Rgb) -> String {
        let by = |c: Rgb| [0, 1, 2].map(|i| (c[i] * k[i]).min(1.0));
        match self {
            Reflectance::Image(file, to_uv) => format!(
                "<texture name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" value=\"{}\"/>{to_uv}</texture>",
                escaped(file)
            ),
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

/// The BSDF of a surface as a mixture: light is diffused, mirrored or let through with a probability in proportion to
/// the strength of each, and divided by that probability. `indices` has the refractive indices within and around;
/// `None` where light is not bent.
fn mixture(o: &Optics, indices: Option<&[String; 2]>, colour: &Reflectance) -> String {
    // The strength is that of the strongest channel: unless the surface makes light, the divided values are then at
    // most 1.
    let strongest = |k: Rgb| k.iter().fold(0.0f64, |m, x| m.max(*x));
    let (kd, ks, kt) = (strongest(o.kd), strongest(o.ks), strongest(o.kt));
    let all = kd + ks + kt;
    // Mitsuba has no surface that makes light, so the values are limited to 1.
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
    let matt = colour.diffuse(scaled(o.kd, diffuse));
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
    // A surface that does not bend light is a thin sheet to Mitsuba, which has no total reflection either.
    let one = || number(1.0);
    let (kind, within, around) = match indices {
        Some([within, around]) => ("dielectric", within.clone(), around.clone()),
        None => ("thindielectric", one(), one()),
    };
    let clear = format!(
        "<bsdf type=\"{kind}\"><float name=\"int_ior\" value=\"{}\"/><float name=\"ext_ior\" value=\"{}\"/>{}</bsdf>",
        within,
        around,
        rgb("specular_transmittance", scaled(o.kt, through))
    );
    if diffuse + mirrored == 0.0 {
        clear
    } else {
        blend(through, &opaque, &clear)
    }
}

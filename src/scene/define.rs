//! What defining records make.

use super::entity::{OpticsParts, State, keep};
use super::model::*;
use super::record::Params;
use super::resolve::Resolver;
use super::{geometry, matrices};
use crate::syntax::table::RecordKind;

impl Resolver<'_> {
    /// The state that a defining record gives its ID; `None` where it is broken, with findings.
    pub(super) fn definition(&mut self, p: &Params) -> Option<State> {
        match p.ty.kind {
            RecordKind::Shape(kind) => {
                let geometry = geometry::shape(kind, p, &mut self.out)?;
                self.scene.shapes.push(Shape {
                    id: p.id,
                    kind,
                    geometry,
                });
                let shape = self.scene.shapes.len() as u32 - 1;
                Some(State::Object(self.node(Node::Shape(shape))))
            }
            RecordKind::Union | RecordKind::Intersection | RecordKind::Difference => {
                let (b, c) = (self.object(p, 0), self.object(p, 1));
                let (b, c) = (b?, c?);
                let node = match p.ty.kind {
                    RecordKind::Union => Node::Union(b, c),
                    RecordKind::Intersection => Node::Intersection(b, c),
                    _ => Node::Difference(b, c),
                };
                Some(State::Object(self.node(node)))
            }
            RecordKind::Complement => {
                let b = self.object(p, 0)?;
                Some(State::Object(self.node(Node::Complement(b))))
            }
            RecordKind::Copy => {
                let original = self.reference(p, 0, false)??;
                let state = self.state(original)?;
                Some(self.copy(state, p.id))
            }
            RecordKind::PointLight | RecordKind::AmbientLight => {
                let sound = p.check_constraints(&mut self.out);
                let (id, intensity, colour) = (p.id, p.number(0), DEFAULT_COLOUR);
                let ambient = AmbientLight {
                    id,
                    intensity,
                    colour,
                };
                let point = PointLight {
                    id,
                    position: [0.0; 3],
                    intensity,
                    colour,
                };
                let values = &mut self.values;
                sound.then(|| match p.ty.kind {
                    RecordKind::AmbientLight => {
                        State::AmbientLight(keep(&mut values.ambient_lights, ambient))
                    }
                    _ => State::PointLight(keep(&mut values.point_lights, point)),
                })
            }
            RecordKind::Camera => {
                let camera = super::camera::camera(p, &mut self.out)?;
                Some(State::Camera(keep(&mut self.values.cameras, camera)))
            }
            _ => None,
        }
    }

    /// The state of a copy with this ID.
    fn copy(&mut self, state: State, id: u32) -> State {
        let values = &mut self.values;
        match state {
            State::Object(child) => State::Object(self.node(Node::Copy { child, id })),
            State::Optics(at) => {
                let parts = values.optics[at as usize];
                State::Optics(keep(&mut values.optics, parts))
            }
            State::Texture(at) => {
                let texture = values.textures[at as usize].clone();
                State::Texture(keep(&mut values.textures, texture))
            }
            State::Colour(at) => {
                let rgb = values.colours[at as usize];
                State::Colour(keep(&mut values.colours, rgb))
            }
            State::AmbientLight(at) => {
                let light = values.ambient_lights[at as usize];
                State::AmbientLight(keep(
                    &mut values.ambient_lights,
                    AmbientLight { id, ..light },
                ))
            }
            State::PointLight(at) => {
                let light = values.point_lights[at as usize];
                State::PointLight(keep(&mut values.point_lights, PointLight { id, ..light }))
            }
            State::Camera(at) => {
                let camera = values.cameras[at as usize];
                State::Camera(keep(&mut values.cameras, Camera { id, ..camera }))
            }
            State::Undefined
            | State::Selection
            | State::Render
            | State::Broken(_)
            | State::Stored => state,
        }
    }

    /// The state of a new property, texture, colour or projection.
    pub(super) fn new_property(&mut self, p: &Params) -> Option<State> {
        match p.ty.kind {
            RecordKind::Optics | RecordKind::OpticsRgb | RecordKind::RefractiveIndex => {
                let mut parts = OpticsParts::default();
                self.optics(p, &mut parts)?;
                Some(State::Optics(keep(&mut self.values.optics, parts)))
            }
            RecordKind::ImageTexture | RecordKind::SolidTexture | RecordKind::Checkerboard => {
                let texture = self.texture(p)?;
                Some(State::Texture(keep(&mut self.values.textures, texture)))
            }
            RecordKind::Colour => {
                let rgb = p.numbers(0);
                Some(State::Colour(keep(&mut self.values.colours, rgb)))
            }
            RecordKind::ProjectionMatrix => {
                let m = matrices::projection(p, &mut self.out)?;
                let camera = super::camera::projecting(p.id, m);
                Some(State::Camera(keep(&mut self.values.cameras, camera)))
            }
            _ => None,
        }
    }

    pub(super) fn optics(&mut self, p: &Params, parts: &mut OpticsParts) -> Option<()> {
        if !p.check_constraints(&mut self.out) {
            return None;
        }
        match p.ty.kind {
            RecordKind::Optics => {
                let [kd, ks, kt] = p.numbers(0);
                parts.optics = Some(Optics {
                    kd: [kd; 3],
                    ks: [ks; 3],
                    kt: [kt; 3],
                });
            }
            RecordKind::OpticsRgb => {
                let of = |k: usize| [p.number(k), p.number(k + 3), p.number(k + 6)];
                parts.optics = Some(Optics {
                    kd: of(0),
                    ks: of(1),
                    kt: of(2),
                });
            }
            _ => parts.index = Some(p.numbers(0)),
        }
        Some(())
    }

    pub(super) fn texture(&mut self, p: &Params) -> Option<Texture> {
        match p.ty.kind {
            RecordKind::ImageTexture => {
                let file = p.text_of(0).trim_matches('"').to_owned();
                let span = p.span_of(0, 1);
                super::image_file::check(&file, span, self.folder, &mut self.out)
                    .then_some(Texture::Image { file, span })
            }
            RecordKind::SolidTexture => {
                let sound = p.check_constraints(&mut self.out);
                if p.len() == 0 {
                    return Some(Texture::Solid {
                        colours: [[0.0; 3], [1.0; 3]],
                        size: 1.0,
                    });
                }
                let colours = [self.colour(p, 0), self.colour(p, 1)];
                let size = p.number(2);
                sound.then_some(())?;
                Some(Texture::Solid {
                    colours: [colours[0]?, colours[1]?],
                    size,
                })
            }
            _ => {
                let sound = p.check_constraints(&mut self.out);
                let colours = [self.colour(p, 2), self.colour(p, 3)];
                sound.then_some(())?;
                Some(Texture::Checkerboard {
                    n: u32::try_from(p.integer(0)).ok()?,
                    m: u32::try_from(p.integer(1)).ok()?,
                    colours: [colours[0]?, colours[1]?],
                })
            }
        }
    }
}

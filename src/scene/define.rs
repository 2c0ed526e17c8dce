//! Defining records, and the nodes that they make.

use super::entity::{OpticsParts, State, again, keep};
use super::model::*;
use super::record::Params;
use super::resolve::Resolver;
use super::{geometry, matrices};
use crate::syntax::table::RecordKind;

impl Resolver<'_> {
    /// The state that a defining record gives its ID. `None` where the record is wrong, which is reported.
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

    /// Copies a state for the ID `id`.
    fn copy(&mut self, state: State, id: u32) -> State {
        let values = &mut self.values;
        match state {
            State::Object(child) => State::Object(self.node(Node::Copy { child, id })),
            State::Optics(at) => State::Optics(again(&mut values.optics, at)),
            State::Texture(at) => State::Texture(again(&mut values.textures, at)),
            State::Colour(at) => State::Colour(again(&mut values.colours, at)),
            State::AmbientLight(at) => {
                let copy = again(&mut values.ambient_lights, at);
                values.ambient_lights[copy as usize].id = id;
                State::AmbientLight(copy)
            }
            State::PointLight(at) => {
                let copy = again(&mut values.point_lights, at);
                values.point_lights[copy as usize].id = id;
                State::PointLight(copy)
            }
            State::Camera(at) => {
                let copy = again(&mut values.cameras, at);
                values.cameras[copy as usize].id = id;
                State::Camera(copy)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    #[test]
    fn a_copy_and_its_original_change_apart() {
        let scene = scene(
            "2 9 1\n20 9 1\n\
             3 -701 1 0 0\n4 -105 3\n4 -701 0 1 0\n\
             5 -201 0.5 0 0\n6 -105 5\n5 -201 0.25 0 0\n\
             7 -399 2 2 3 3\n8 -105 7\n8 -399 4 4 3 3\n\
             2 -299 3 5\n20 -299 4 6\n\
             30 9 1\n31 9 1\n30 -299 7 0\n31 -299 8 0\n\
             10 -402 1\n11 -105 10\n11 -1 1 2 3\n10 -701 0 0 1\n\
             12 -401 1\n13 -105 12\n13 -701 0 1 1\n\
             14 -501 0 0 9 0 0 -1 0 1 0 45\n15 -105 14\n14 -1 0 0 1\n\
             21 -101 2 20\n22 -101 30 31\n23 -101 21 22\n1 9999 23 0\n",
        );
        let looks = |id: u32| {
            let paint = scene.paints.iter().rfind(|p| p.owner == id).unwrap();
            (paint.texture.clone().unwrap(), paint.optics.unwrap().kd[0])
        };
        assert_eq!(looks(2), (Texture::Colour([1.0, 0.0, 0.0]), 0.25));
        assert_eq!(looks(20), (Texture::Colour([0.0, 1.0, 0.0]), 0.5));
        let cells = |id: u32| match looks(id).0 {
            Texture::Checkerboard { n, m, .. } => [n, m],
            other => panic!("{other:?}"),
        };
        assert_eq!([cells(30), cells(31)], [[2, 2], [4, 4]]);
        let points = scene.point_lights.iter();
        let points: Vec<_> = points.map(|l| (l.id, l.position, l.colour)).collect();
        assert_eq!(points[0], (10, [0.0; 3], [0.0, 0.0, 1.0]));
        assert_eq!(points[1], (11, [1.0, 2.0, 3.0], [1.0; 3]));
        let ambient = scene.ambient_lights.iter();
        let ambient: Vec<_> = ambient.map(|l| (l.id, l.colour)).collect();
        assert_eq!(ambient, [(12, [1.0; 3]), (13, [0.0, 1.0, 1.0])]);
        let cameras: Vec<_> = scene.cameras.iter().map(|c| (c.id, c.position)).collect();
        assert_eq!(cameras, [(14, [0.0, 0.0, 10.0]), (15, [0.0, 0.0, 9.0])]);
    }
}

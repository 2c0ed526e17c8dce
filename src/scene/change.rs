//! Changing records: transformations, properties, textures, colours, bounding volumes.

use super::entity::{OpticsParts, State};
use super::model::*;
use super::record::Params;
use super::resolve::Resolver;
use super::{checks, matrices};
use crate::diagnostics::{Code, Diagnostic, Value};
use crate::geometry::Matrix;
use crate::syntax::table::{Kind, RecordKind};

impl Resolver<'_> {
    /// Applies a changing record to an entity.
    pub(super) fn change(&mut self, p: &Params, kinds: &'static [Kind]) {
        let Some(state) = self.changed(p, kinds) else {
            return;
        };
        match p.ty.kind {
            RecordKind::Translation
            | RecordKind::Rotation
            | RecordKind::Scaling
            | RecordKind::RotationMatrix => {
                if let Some(m) = super::camera::transformation(p, &mut self.out) {
                    self.transform(p, state, &m);
                }
            }
            RecordKind::ProjectionMatrix => {
                let m = matrices::projection(p, &mut self.out);
                if let (Some(m), State::Camera(at)) = (m, state) {
                    self.values.cameras[at as usize].projection = Some(m);
                }
            }
            RecordKind::Optics | RecordKind::OpticsRgb | RecordKind::RefractiveIndex => {
                let mut parts = match state {
                    State::Optics(at) => self.values.optics[at as usize],
                    _ => OpticsParts::default(),
                };
                if self.optics(p, &mut parts).is_some() {
                    match state {
                        State::Optics(at) => self.values.optics[at as usize] = parts,
                        _ => self.paint(p.id, |paint| {
                            paint.optics = parts.optics.or(paint.optics);
                            paint.index = parts.index.or(paint.index);
                        }),
                    }
                }
            }
            RecordKind::Assignment => self.assign(p),
            RecordKind::ImageTexture | RecordKind::SolidTexture | RecordKind::Checkerboard => {
                if let Some(texture) = self.texture(p) {
                    match state {
                        State::Texture(at) => self.values.textures[at as usize] = texture,
                        _ => self.paint(p.id, |paint| paint.texture = Some(texture)),
                    }
                }
            }
            RecordKind::Colour => {
                let rgb = p.numbers(0);
                let values = &mut self.values;
                match state {
                    State::Colour(at) => values.colours[at as usize] = rgb,
                    State::AmbientLight(at) => values.ambient_lights[at as usize].colour = rgb,
                    State::PointLight(at) => values.point_lights[at as usize].colour = rgb,
                    _ => self.paint(p.id, |paint| paint.texture = Some(Texture::Colour(rgb))),
                }
            }
            _ => self.promise(p, state),
        }
    }

    /// Adds the bounding volume of a -601 or -602 record.
    fn promise(&mut self, p: &Params, state: State) {
        let volume = match p.ty.kind {
            RecordKind::BoundingBox => match checks::ordered(p, 0, 3, &mut self.out) {
                Some(()) => Volume::Box {
                    min: p.numbers(0),
                    max: p.numbers(3),
                },
                None => return,
            },
            _ if !p.check_constraints(&mut self.out) => return,
            _ => Volume::Sphere {
                centre: p.numbers(0),
                radius: p.number(3),
            },
        };
        if let State::Object(node) = state {
            self.taken[node as usize] = true;
            self.scene.promises.push(Promise {
                id: p.id,
                node,
                volume,
                span: p.span(),
            });
        }
    }

    /// Applies a -299 record, which gives an object a texture and optics.
    fn assign(&mut self, p: &Params) {
        let texture = self.reference(p, 0, false);
        let optics = self.reference(p, 1, false);
        let (Some(texture), Some(optics)) = (texture, optics) else {
            return;
        };
        let texture = match texture.and_then(|id| self.state(id)) {
            Some(State::Texture(at)) => self.values.textures[at as usize].clone(),
            Some(State::Colour(at)) => Texture::Colour(self.values.colours[at as usize]),
            _ => Texture::Colour(DEFAULT_COLOUR),
        };
        let parts = match optics.and_then(|id| self.state(id)) {
            Some(State::Optics(at)) => self.values.optics[at as usize],
            _ => OpticsParts::default(),
        };
        self.paint(p.id, |paint| {
            paint.texture = Some(texture);
            paint.optics = Some(parts.optics.unwrap_or_default());
            paint.index = Some(parts.index.unwrap_or(DEFAULT_INDEX));
        });
    }

    /// Puts properties on the object with this ID.
    fn paint(&mut self, id: u32, set: impl FnOnce(&mut Paint)) {
        let Some(State::Object(node)) = self.state(id) else {
            return;
        };
        // Properties given one after the other are merged into one paint.
        let (child, mut paint) = match self.scene.nodes[node as usize] {
            Node::Paint { child, paint } if self.scene.paints[paint as usize].owner == id => {
                (child, self.scene.paints[paint as usize].clone())
            }
            _ => (
                node,
                Paint {
                    owner: id,
                    ..Paint::default()
                },
            ),
        };
        set(&mut paint);
        self.scene.paints.push(paint);
        let paint = self.scene.paints.len() as u32 - 1;
        let painted = self.node(Node::Paint { child, paint });
        if child != node {
            let from = match self.taken[node as usize] {
                true => Some(node),
                false => self.scene.steps.get(&node).map(|s| s.from),
            };
            let matrix = None;
            let step = from.map(|from| (painted, Derivation { from, matrix }));
            self.scene.steps.extend(step);
        }
        self.set_state(id, State::Object(painted));
    }

    /// Adds a matrix to the scene and returns its index.
    fn matrix(&mut self, m: Matrix) -> u32 {
        self.scene.matrices.push(m);
        self.scene.matrices.len() as u32 - 1
    }

    fn transform(&mut self, p: &Params, state: State, m: &Matrix) {
        let moved = match state {
            State::Object(node) => {
                // Moves one after the other are merged into one matrix.
                let (child, matrix) = match self.scene.nodes[node as usize] {
                    Node::Transform { child, matrix } => {
                        (child, m.after(&self.scene.matrices[matrix as usize]))
                    }
                    _ => (node, *m),
                };
                let is_regular = matrix.is_plainly_invertible()
                    || !matrix.is_singular() && matrix.inverse().is_some();
                is_regular.then(|| {
                    let matrix = self.matrix(matrix);
                    let moved = self.node(Node::Transform { child, matrix });
                    let goes_on = self.taken[node as usize] || self.scene.steps.contains_key(&node);
                    if child != node && goes_on {
                        let matrix = Some(self.matrix(*m));
                        let step = Derivation { from: node, matrix };
                        self.scene.steps.insert(moved, step);
                    }
                    State::Object(moved)
                })
            }
            State::PointLight(at) => {
                let light = &mut self.values.point_lights[at as usize];
                let position = m.point(light.position);
                let finite = position.iter().all(|x| x.is_finite());
                finite.then(|| {
                    light.position = position;
                    state
                })
            }
            State::Camera(at) => {
                let camera = &mut self.values.cameras[at as usize];
                super::camera::moved(camera, m).map(|moved| {
                    *camera = moved;
                    state
                })
            }
            _ => None,
        };
        match moved {
            Some(state) => {
                self.set_state(p.id, state);
            }
            None if matches!(state, State::Broken(_)) => {}
            None => self.out.push(
                Diagnostic::new(Code::E204, p.span())
                    .case("product")
                    .with("type", Value::Term(p.ty.title))
                    .with("id", p.id.to_string()),
            ),
        }
    }
}

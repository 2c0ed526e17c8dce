//! Features of a scene: every type of record of the language's table, and the effects that no record stands for alone.
//! Every target has to say what becomes of each feature.

use std::collections::BTreeMap;

use crate::geometry::Matrix;
use crate::scene::{Node, Paint, Scene, Texture, View, Volume};
use crate::solids::staging::is_dark;
use crate::syntax::table::{RECORD_TYPES, RecordKind, RecordType};
use crate::trace::plan::{self, Plan};

/// A feature of scenes that a translation has to deal with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// A type of record.
    Record(RecordKind),
    Effect(Effect),
}

/// The effects that a scene has beyond its records.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    Diffuse,
    Shadows,
    TransparentShadows,
    Reflection,
    Refraction,
    Dispersion,
    TotalReflection,
    VertexColours,
    SmoothNormals,
    Background,
    RenderBox,
    AutomaticCamera,
    AutomaticLights,
    Depth,
    Cutoff,
}

impl Effect {
    pub const ALL: [Effect; 15] = [
        Effect::Diffuse,
        Effect::Shadows,
        Effect::TransparentShadows,
        Effect::Reflection,
        Effect::Refraction,
        Effect::Dispersion,
        Effect::TotalReflection,
        Effect::VertexColours,
        Effect::SmoothNormals,
        Effect::Background,
        Effect::RenderBox,
        Effect::AutomaticCamera,
        Effect::AutomaticLights,
        Effect::Depth,
        Effect::Cutoff,
    ];

    fn name(self) -> &'static str {
        match self {
            Effect::Diffuse => "diffuse light",
            Effect::Shadows => "shadows",
            Effect::TransparentShadows => "shadows of transparent objects",
            Effect::Reflection => "reflection",
            Effect::Refraction => "refraction",
            Effect::Dispersion => "refractive index by channel",
            Effect::TotalReflection => "total internal reflection",
            Effect::VertexColours => "colours along a profile",
            Effect::SmoothNormals => "shading normals",
            Effect::Background => "background",
            Effect::RenderBox => "render box",
            Effect::AutomaticCamera => "automatic camera",
            Effect::AutomaticLights => "automatic lights",
            Effect::Depth => "depth of rays",
            Effect::Cutoff => "cutoff of faint rays",
        }
    }
}

impl Feature {
    /// All features: those of the table in its order, then the effects.
    pub fn all() -> impl Iterator<Item = Feature> {
        let records = RECORD_TYPES.iter().map(|t| Feature::Record(t.kind));
        records.chain(Effect::ALL.into_iter().map(Feature::Effect))
    }

    /// The name of the feature in reports.
    pub fn name(self) -> &'static str {
        match self {
            Feature::Record(kind) => RecordType::of(kind).title,
            Feature::Effect(effect) => effect.name(),
        }
    }
}

/// The features that a scene uses in all that the render record reaches, and how often it uses each. The number of an
/// effect is 0.
pub fn used(scene: &Scene) -> BTreeMap<Feature, u64> {
    let mut out = BTreeMap::new();
    let (Some(render), Some(plan)) = (&scene.render, Plan::new(scene)) else {
        return out;
    };
    // An assignment also gives the index 1, which nobody wrote, and which matters only beside indices that bend light.
    let is_refracting = scene.paints.iter().any(is_bent);
    let mut count = |kind: RecordKind| *out.entry(Feature::Record(kind)).or_insert(0) += 1;
    for (_, node) in scene.below(render.root) {
        match node {
            Node::Shape(shape) => count(scene.shapes[shape as usize].ty().kind),
            Node::Union(..) => count(RecordKind::Union),
            Node::Intersection(..) => count(RecordKind::Intersection),
            Node::Difference(..) => count(RecordKind::Difference),
            Node::Complement(_) => count(RecordKind::Complement),
            Node::Copy { .. } => count(RecordKind::Copy),
            Node::Transform { matrix, .. } => {
                count(transformation(&scene.matrices[matrix as usize]));
            }
            Node::Paint { paint, .. } => {
                let paint = &scene.paints[paint as usize];
                if paint.texture.is_some() && paint.optics.is_some() {
                    count(RecordKind::Assignment);
                }
                paint
                    .texture
                    .as_ref()
                    .map(texture)
                    .into_iter()
                    .for_each(&mut count);
                if let Some(o) = &paint.optics {
                    let mono = [o.kd, o.ks, o.kt].iter().all(|[r, g, b]| r == g && g == b);
                    count(if mono {
                        RecordKind::Optics
                    } else {
                        RecordKind::OpticsRgb
                    });
                }
                if paint.index.is_some() && is_refracting {
                    count(RecordKind::RefractiveIndex);
                }
            }
        }
    }
    let uses = scene.uses(render.root);
    for promise in &scene.promises {
        let uses = uses.get(scene.defined(promise.node) as usize);
        if uses.is_some_and(|&n| n > 0) {
            count(match promise.volume {
                Volume::Box { .. } => RecordKind::BoundingBox,
                Volume::Sphere { .. } => RecordKind::BoundingSphere,
            });
        }
    }
    scene
        .ambient_lights
        .iter()
        .for_each(|_| count(RecordKind::AmbientLight));
    scene
        .point_lights
        .iter()
        .for_each(|_| count(RecordKind::PointLight));
    match scene.view {
        View::Automatic => {}
        // With a single camera there is nothing to choose.
        View::Mono(_) if scene.cameras.len() < 2 => {}
        View::Mono(_) => count(RecordKind::MonoCamera),
        View::Stereo { .. } => count(RecordKind::StereoCamera),
    }
    for camera in scene.chosen_cameras() {
        count(if camera.projection.is_some() {
            RecordKind::ProjectionMatrix
        } else {
            RecordKind::Camera
        });
    }
    count(RecordKind::Render);
    for effect in Effect::ALL {
        if shows(effect, scene, &plan) {
            out.insert(Feature::Effect(effect), 0);
        }
    }
    out
}

/// Whether a paint gives an index that bends light.
fn is_bent(paint: &Paint) -> bool {
    paint.index.is_some_and(|index| index != [1.0; 3])
}

fn texture(texture: &Texture) -> RecordKind {
    match texture {
        Texture::Colour(_) => RecordKind::Colour,
        Texture::Image { .. } => RecordKind::ImageTexture,
        Texture::Solid { .. } => RecordKind::SolidTexture,
        Texture::Checkerboard { .. } => RecordKind::Checkerboard,
    }
}

/// The type of record that says what a matrix does.
fn transformation(m: &Matrix) -> RecordKind {
    let r = &m.0;
    let moved = (0..3).any(|i| r[i][3] != 0.0);
    let diagonal = (0..3).all(|i| (0..3).all(|j| i == j || r[i][j] == 0.0));
    let kept = (0..3)
        .any(|k| (0..3).all(|i| r[i][k] == r[k][i] && r[i][k] == f64::from(u8::from(i == k))));
    match (diagonal, moved) {
        (true, true) if (0..3).all(|i| r[i][i] == 1.0) => RecordKind::Translation,
        (true, false) => RecordKind::Scaling,
        // A rotation's determinant is 1, within the rounding of sine and cosine and that of ten digits.
        (false, false) if kept && (m.determinant3() - 1.0).abs() < 1e-9 => RecordKind::Rotation,
        _ => RecordKind::RotationMatrix,
    }
}

fn shows(effect: Effect, scene: &Scene, plan: &Plan) -> bool {
    use plan::Effect as Planned;
    let refracts = plan.on(Planned::Refraction);
    match effect {
        Effect::Diffuse => plan.on(Planned::Diffuse),
        Effect::Shadows => plan.on(Planned::Shadows),
        Effect::TransparentShadows => plan.on(Planned::TransparentShadows),
        Effect::Reflection => plan.on(Planned::Reflection),
        Effect::Refraction => refracts,
        Effect::Dispersion => plan.on(Planned::Dispersion),
        Effect::TotalReflection => refracts && scene.paints.iter().any(is_bent),
        Effect::VertexColours => plan.on(Planned::VertexColour),
        Effect::SmoothNormals => plan.on(Planned::SmoothNormals),
        Effect::Background => true,
        Effect::RenderBox => plan.on(Planned::ClipBox),
        Effect::AutomaticCamera => scene.view == View::Automatic,
        Effect::AutomaticLights => is_dark(scene),
        Effect::Depth | Effect::Cutoff => refracts || plan.on(Planned::Reflection),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_are_told_apart() {
        assert_eq!(
            transformation(&Matrix::translation(1.0, 0.0, 0.0)),
            RecordKind::Translation
        );
        assert_eq!(
            transformation(&Matrix::rotation(30.0, 1)),
            RecordKind::Rotation
        );
        assert_eq!(
            transformation(&Matrix::scaling(2.0, -1.0, 1.0)),
            RecordKind::Scaling
        );
        let turned = Matrix::rotation(30.0, 1).after(&Matrix::rotation(30.0, 0));
        assert_eq!(transformation(&turned), RecordKind::RotationMatrix);
    }

    #[test]
    fn names_are_unique() {
        let names: std::collections::BTreeSet<_> = Feature::all().map(Feature::name).collect();
        assert_eq!(names.len(), Feature::all().count());
    }
}

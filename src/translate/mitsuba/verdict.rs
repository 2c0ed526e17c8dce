//! Support of each feature by Mitsuba.

use super::written::Written;
use crate::diagnostics::{Complaint, Value};
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::translate::{Effect, Feature, FeatureSupport, mesh};

pub(super) fn verdict(feature: Feature, tolerance: f64, written: &Written) -> FeatureSupport {
    match feature {
        Feature::Record(kind) => record(kind, tolerance, written.counts(kind)),
        Feature::Effect(effect) => of_effect(effect),
    }
}

/// The numbers of shapes with a type of record that were written as Mitsuba's own, and as meshes.
type Counts = [usize; 2];

fn record(kind: RecordKind, tolerance: f64, counts: Counts) -> FeatureSupport {
    let within = || mesh::within(tolerance);
    let facets = |note: &'static str| FeatureSupport::approximate(within(), note);
    let [exact, meshes] = counts;
    match kind {
        RecordKind::Undefined => FeatureSupport::exact("there is nothing to draw"),
        RecordKind::Shape(ShapeKind::SphereAtOrigin | ShapeKind::Sphere) if meshes == 0 => {
            FeatureSupport::exact(made("sphere", counts))
        }
        RecordKind::Shape(ShapeKind::SphereAtOrigin | ShapeKind::Sphere) => {
            FeatureSupport::approximate(within(), made("sphere", counts))
        }
        RecordKind::Shape(ShapeKind::Plane | ShapeKind::HalfSpace) if exact == 0 && meshes > 0 => {
            FeatureSupport::exact("a mesh")
        }
        RecordKind::Shape(ShapeKind::Plane | ShapeKind::HalfSpace) => {
            let end = "ends at a thousand times the scene's size";
            let own = if meshes == 0 { "rectangles" } else { "plane" };
            FeatureSupport::approximate(end, made(own, counts))
        }
        RecordKind::Shape(ShapeKind::Rectangle) => FeatureSupport::exact(made("rectangle", counts)),
        RecordKind::Shape(ShapeKind::Box) => FeatureSupport::exact(made("cube", counts)),
        // Every other kind of shape is written as a mesh.
        RecordKind::Shape(kind) if mesh::is_faceted(kind) => {
            FeatureSupport::exact("a mesh of the same facets")
        }
        RecordKind::Shape(_) => facets("a mesh"),
        RecordKind::Translation
        | RecordKind::Rotation
        | RecordKind::Scaling
        | RecordKind::RotationMatrix => FeatureSupport::exact(""),
        RecordKind::ProjectionMatrix => FeatureSupport::approximate(
            "exact where rays are parallel, or pixels square",
            "orthographic, perspective with principal_point_offset",
        ),
        RecordKind::Union => {
            FeatureSupport::exact("shapes side by side; those of one clear medium are joined")
        }
        RecordKind::Intersection | RecordKind::Difference | RecordKind::Complement => {
            facets("cut as meshes")
        }
        RecordKind::Copy => FeatureSupport::exact(""),
        RecordKind::Optics | RecordKind::OpticsRgb => FeatureSupport::approximate(
            "a mixture by the strongest channel, with Fresnel's law where light is bent",
            "diffuse, conductor, dielectric",
        ),
        RecordKind::RefractiveIndex => FeatureSupport::exact("int_ior, ext_ior"),
        RecordKind::Assignment | RecordKind::Colour => FeatureSupport::exact(""),
        RecordKind::ImageTexture if meshes == 0 => FeatureSupport::exact("bitmap"),
        RecordKind::ImageTexture => FeatureSupport::approximate(STRAIGHT, laid("bitmap", counts)),
        RecordKind::SolidTexture => {
            FeatureSupport::approximate("one colour a triangle", "mesh_attribute")
        }
        RecordKind::Checkerboard if meshes == 0 => FeatureSupport::exact("checkerboard"),
        RecordKind::Checkerboard => {
            FeatureSupport::approximate(STRAIGHT, laid("checkerboard", counts))
        }
        RecordKind::AmbientLight => {
            FeatureSupport::approximate("light that what is near keeps out", "a constant emitter")
        }
        RecordKind::PointLight => FeatureSupport::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point emitter",
        ),
        RecordKind::Camera | RecordKind::MonoCamera => FeatureSupport::exact("perspective"),
        RecordKind::StereoCamera => FeatureSupport::exact("one file for each eye"),
        RecordKind::BoundingBox | RecordKind::BoundingSphere => {
            FeatureSupport::exact("left out: it never changes the picture")
        }
        RecordKind::Render => FeatureSupport::exact(""),
    }
}

/// The fidelity of surface coordinates on a mesh.
const STRAIGHT: &str = "straight between the points of a mesh";

/// The note on what shapes became: `2 spheres, 1 mesh`.
fn made(own: &'static str, counts: Counts) -> Complaint {
    match counts {
        [_, 0] => Complaint::term(own),
        [0, _] => Complaint::term("a mesh"),
        counts => counted("fidelity-made", own, counts),
    }
}

/// The note on where textures were laid: `checkerboard, on 2 exact shapes and 1 mesh`.
fn laid(name: &'static str, counts: Counts) -> Complaint {
    match counts {
        [0, _] => Complaint::term(name),
        counts => counted("fidelity-laid", name, counts),
    }
}

fn counted(message: &'static str, name: &'static str, [exact, meshes]: Counts) -> Complaint {
    Complaint::new(message)
        .with("name", Value::Term(name))
        .with("exact", Value::Count(exact as u64))
        .with("meshes", Value::Count(meshes as u64))
}

fn of_effect(effect: Effect) -> FeatureSupport {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection => {
            FeatureSupport::approximate("light between surfaces comes in addition", "path")
        }
        Effect::TransparentShadows => FeatureSupport::approximate(
            "full behind what bends light",
            "point lights are no caustics",
        ),
        Effect::Refraction | Effect::TotalReflection => {
            FeatureSupport::approximate("with Fresnel's law", "dielectric")
        }
        Effect::Dispersion => FeatureSupport::approximate(
            "the mean of the channels; exact in three passes",
            "as the head of the file says",
        ),
        Effect::VertexColours => {
            FeatureSupport::approximate("at the points of a mesh", "mesh_attribute")
        }
        Effect::SmoothNormals => FeatureSupport::exact("normals of the mesh"),
        Effect::Background => FeatureSupport::approximate(
            "it lights the scene; beside ambient light that is seen instead",
            "a constant emitter",
        ),
        Effect::RenderBox => FeatureSupport::exact("what it cuts is a mesh, and open"),
        Effect::AutomaticCamera => FeatureSupport::exact("the camera is written out"),
        Effect::AutomaticLights => FeatureSupport::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point and a constant emitter",
        ),
        Effect::Depth => FeatureSupport::exact("max_depth"),
        Effect::Cutoff => FeatureSupport::exact("paths end at random, which is right on average"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_counted() {
        let made = |own, counts| made(own, counts).to_string();
        assert_eq!(made("sphere", [3, 0]), "sphere");
        assert_eq!(made("sphere", [0, 3]), "a mesh");
        assert_eq!(made("sphere", [1, 2]), "1 sphere, 2 meshes");
        assert_eq!(made("cube", [2, 1]), "2 cubes, 1 mesh");
        assert_eq!(
            laid("checkerboard", [2, 1]).to_string(),
            "checkerboard, on 2 exact shapes and 1 mesh"
        );
    }
}

//! What a mesh makes of each feature.

use super::shape;
use crate::diagnostics::Complaint;
use crate::syntax::table::RecordKind;
use crate::translate::{Effect, Feature, Verdict};

/// Off by no more than the tolerance.
pub fn within(tolerance: f64) -> Complaint {
    Complaint::new("fidelity-within").with("tolerance", format!("{tolerance:.3e}"))
}

pub fn verdict(target: &str, feature: Feature, tolerance: f64) -> Verdict {
    match feature {
        Feature::Record(kind) => record(target, kind, tolerance),
        Feature::Effect(effect) => of_effect(target, effect),
    }
}

fn record(target: &str, kind: RecordKind, tolerance: f64) -> Verdict {
    let within = || within(tolerance);
    match kind {
        RecordKind::Undefined => Verdict::exact("there is nothing to draw"),
        RecordKind::Shape(kind) if shape::is_faceted(kind) => Verdict::exact("triangles"),
        RecordKind::Shape(_) => Verdict::approximate(within(), "triangles"),
        RecordKind::Translation
        | RecordKind::Rotation
        | RecordKind::Scaling
        | RecordKind::RotationMatrix => Verdict::exact("applied to the points"),
        RecordKind::Union
        | RecordKind::Intersection
        | RecordKind::Difference
        | RecordKind::Complement => Verdict::approximate(within(), "cut and joined as meshes"),
        RecordKind::Copy => Verdict::exact(""),
        RecordKind::Optics | RecordKind::OpticsRgb | RecordKind::RefractiveIndex => match target {
            "ply" => Verdict::dropped("a PLY file has colours only"),
            "obj" => Verdict::approximate("a material of MTL", "Kd, Ks, Tf, Ni"),
            _ => Verdict::approximate(
                "a physically based material",
                "metallic, roughness, transmission, index",
            ),
        },
        RecordKind::Assignment | RecordKind::Colour => Verdict::exact(""),
        RecordKind::ImageTexture | RecordKind::Checkerboard if target != "ply" => {
            Verdict::approximate("straight between the points of the mesh", "a picture")
        }
        RecordKind::ImageTexture | RecordKind::SolidTexture | RecordKind::Checkerboard => {
            Verdict::approximate("one colour a triangle or point", "")
        }
        RecordKind::AmbientLight | RecordKind::PointLight => {
            Verdict::dropped("a mesh has no lights")
        }
        RecordKind::Camera
        | RecordKind::MonoCamera
        | RecordKind::StereoCamera
        | RecordKind::ProjectionMatrix => Verdict::dropped("a mesh has no camera"),
        RecordKind::BoundingBox | RecordKind::BoundingSphere => {
            Verdict::exact("left out: it never changes the picture")
        }
        RecordKind::Render => Verdict::exact(""),
    }
}

fn of_effect(target: &str, effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::TransparentShadows => {
            Verdict::exact("up to the program that shows the mesh")
        }
        Effect::Reflection | Effect::Refraction | Effect::Dispersion | Effect::TotalReflection => {
            match target {
                "ply" => Verdict::dropped("a PLY file has colours only"),
                _ => Verdict::approximate("a material", ""),
            }
        }
        Effect::VertexColours => Verdict::approximate("between the points of the mesh", ""),
        Effect::SmoothNormals => Verdict::exact("normals of the mesh"),
        Effect::Background => Verdict::dropped("a mesh has no background"),
        Effect::RenderBox => {
            Verdict::approximate("what it cuts is closed", "everything is cut to it")
        }
        Effect::AutomaticCamera | Effect::Headlight => Verdict::exact("left to the viewer"),
        Effect::Depth | Effect::Cutoff => Verdict::exact("left to the viewer"),
    }
}

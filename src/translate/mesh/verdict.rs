//! Support of each feature by meshes.

use super::glb_scenery::LIGHTS;
use super::shape;
use crate::diagnostics::{Complaint, Value};
use crate::syntax::table::RecordKind;
use crate::translate::{Effect, Feature, FeatureSupport, Fidelity, Report};

/// The message that something is off by no more than the tolerance.
pub fn within(tolerance: f64) -> Complaint {
    Complaint::new("fidelity-within").with("tolerance", Value::Decimal(format!("{tolerance:.3e}")))
}

/// The largest distances of triangles from the surfaces that they stand for.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// The distance of the triangles as they are made.
    pub tolerance: f64,
    /// The error that the numbers of the file add.
    pub off: f64,
}

impl Bounds {
    /// Whether the file's numbers add a larger error than the tolerance.
    fn is_coarse(self) -> bool {
        self.off > self.tolerance
    }

    /// Adds a note to the report if the file's numbers are coarse.
    pub(super) fn account(self, target: &str, report: &mut Report) {
        if !self.is_coarse() {
            return;
        }
        let note = match target {
            "obj" => "double precision is coarse so far from the origin",
            _ => "single precision is coarse so far from the origin; an OBJ has more digits",
        };
        let fidelity = Fidelity::Approximate(within(self.off));
        report.state("coordinates", fidelity, Complaint::term(note));
    }
}

/// The reason why colours, materials and the like are dropped.
const TRIANGLES_ONLY: &str = "an STL file has triangles only";

pub(super) fn verdict(target: &str, feature: Feature, bounds: Bounds) -> FeatureSupport {
    match feature {
        Feature::Record(kind) => record(target, kind, bounds),
        Feature::Effect(effect) => of_effect(target, effect),
    }
}

fn record(target: &str, kind: RecordKind, bounds: Bounds) -> FeatureSupport {
    let within = || within(bounds.tolerance + bounds.off);
    match kind {
        RecordKind::Undefined => FeatureSupport::exact("there is nothing to draw"),
        RecordKind::Shape(kind) if shape::is_faceted(kind) => match bounds.is_coarse() {
            true => FeatureSupport::approximate(self::within(bounds.off), "triangles"),
            false => FeatureSupport::exact("triangles"),
        },
        RecordKind::Shape(_) => FeatureSupport::approximate(within(), "triangles"),
        RecordKind::Translation
        | RecordKind::Rotation
        | RecordKind::Scaling
        | RecordKind::RotationMatrix => FeatureSupport::exact("applied to the points"),
        RecordKind::Union
        | RecordKind::Intersection
        | RecordKind::Difference
        | RecordKind::Complement => {
            FeatureSupport::approximate(within(), "cut and joined as meshes")
        }
        RecordKind::Copy => FeatureSupport::exact(""),
        RecordKind::Optics | RecordKind::OpticsRgb | RecordKind::RefractiveIndex => match target {
            "ply" => FeatureSupport::dropped("a PLY file has colours only"),
            "stl" => FeatureSupport::dropped(TRIANGLES_ONLY),
            "obj" => FeatureSupport::approximate("a material of MTL", "Kd, Ks, Tf, Ni"),
            _ => FeatureSupport::approximate(
                "a physically based material",
                "metallic, roughness, transmission, index",
            ),
        },
        RecordKind::Colour
        | RecordKind::ImageTexture
        | RecordKind::SolidTexture
        | RecordKind::Checkerboard
            if target == "stl" =>
        {
            FeatureSupport::dropped(TRIANGLES_ONLY)
        }
        RecordKind::Assignment | RecordKind::Colour => FeatureSupport::exact(""),
        RecordKind::ImageTexture | RecordKind::Checkerboard if target != "ply" => {
            FeatureSupport::approximate("straight between the points of the mesh", "a picture")
        }
        RecordKind::ImageTexture | RecordKind::SolidTexture | RecordKind::Checkerboard => {
            FeatureSupport::approximate("one colour a triangle or point", "")
        }
        RecordKind::PointLight if target == "glb" => FeatureSupport::approximate(
            "as bright in the middle of the scene, fading with distance",
            LIGHTS,
        ),
        RecordKind::AmbientLight if target == "glb" => {
            FeatureSupport::dropped("glTF has no ambient light")
        }
        RecordKind::AmbientLight | RecordKind::PointLight => {
            FeatureSupport::dropped("a mesh has no lights")
        }
        RecordKind::Camera | RecordKind::ProjectionMatrix if target == "glb" => {
            FeatureSupport::exact("a camera")
        }
        RecordKind::MonoCamera if target == "glb" => {
            FeatureSupport::exact("the first camera of the file")
        }
        RecordKind::StereoCamera if target == "glb" => {
            FeatureSupport::approximate("two cameras, each by itself", "the first ones of the file")
        }
        RecordKind::Camera
        | RecordKind::MonoCamera
        | RecordKind::StereoCamera
        | RecordKind::ProjectionMatrix => FeatureSupport::dropped("a mesh has no camera"),
        RecordKind::BoundingBox | RecordKind::BoundingSphere => {
            FeatureSupport::exact("left out: it never changes the picture")
        }
        RecordKind::Render => FeatureSupport::exact(""),
    }
}

fn of_effect(target: &str, effect: Effect) -> FeatureSupport {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::TransparentShadows => {
            FeatureSupport::exact("up to the program that shows the mesh")
        }
        Effect::Reflection | Effect::Refraction | Effect::Dispersion | Effect::TotalReflection => {
            match target {
                "ply" => FeatureSupport::dropped("a PLY file has colours only"),
                "stl" => FeatureSupport::dropped(TRIANGLES_ONLY),
                _ => FeatureSupport::approximate("a material", ""),
            }
        }
        Effect::VertexColours | Effect::SmoothNormals if target == "stl" => {
            FeatureSupport::dropped(TRIANGLES_ONLY)
        }
        Effect::VertexColours => FeatureSupport::approximate("between the points of the mesh", ""),
        Effect::SmoothNormals => FeatureSupport::exact("normals of the mesh"),
        Effect::Background => FeatureSupport::dropped("a mesh has no background"),
        Effect::RenderBox => {
            FeatureSupport::approximate("what it cuts is closed", "everything is cut to it")
        }
        Effect::AutomaticCamera | Effect::AutomaticLights => {
            FeatureSupport::exact("left to the viewer")
        }
        Effect::Depth | Effect::Cutoff => FeatureSupport::exact("left to the viewer"),
    }
}

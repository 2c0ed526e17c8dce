//! Support of each feature by POV-Ray.

use super::pictures::Pictures;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::translate::{Effect, Feature, FeatureSupport};

const IMAGE_MAP: &str = "image_map through the surface coordinates";

pub(super) fn verdict(feature: Feature, pictures: &Pictures) -> FeatureSupport {
    match feature {
        Feature::Record(RecordKind::ImageTexture) if matches!(pictures, Pictures::InPlace(_)) => {
            FeatureSupport::approximate(
                "POV-Ray decodes the picture itself; with -o it is copied as PNG",
                IMAGE_MAP,
            )
        }
        Feature::Record(kind) => record(kind),
        Feature::Effect(effect) => of_effect(effect),
    }
}

fn record(kind: RecordKind) -> FeatureSupport {
    match kind {
        RecordKind::Undefined => FeatureSupport::exact("there is nothing to draw"),
        RecordKind::Shape(kind) => shape(kind),
        RecordKind::Translation
        | RecordKind::Rotation
        | RecordKind::Scaling
        | RecordKind::RotationMatrix => FeatureSupport::exact("matrix"),
        RecordKind::ProjectionMatrix => FeatureSupport::exact("location, direction, right and up"),
        RecordKind::Union => FeatureSupport::exact("union, of transparent parts merge"),
        RecordKind::Intersection => FeatureSupport::exact("intersection"),
        RecordKind::Difference => FeatureSupport::exact("difference"),
        RecordKind::Complement => FeatureSupport::exact("inverse"),
        RecordKind::Copy => FeatureSupport::exact("the same object, declared once"),
        RecordKind::Optics | RecordKind::OpticsRgb => {
            FeatureSupport::exact("finish, kt as a filter")
        }
        RecordKind::RefractiveIndex => FeatureSupport::exact("interior { ior }"),
        RecordKind::Assignment | RecordKind::Colour => FeatureSupport::exact(""),
        RecordKind::ImageTexture => FeatureSupport::exact(IMAGE_MAP),
        RecordKind::SolidTexture => FeatureSupport::exact("checker"),
        RecordKind::Checkerboard => FeatureSupport::exact("checker, or a function pigment"),
        RecordKind::AmbientLight => FeatureSupport::exact("ambient_light"),
        RecordKind::PointLight => FeatureSupport::exact("light_source without fading"),
        RecordKind::Camera | RecordKind::MonoCamera => FeatureSupport::exact("camera"),
        RecordKind::StereoCamera => FeatureSupport::exact("one file for each eye"),
        RecordKind::BoundingBox | RecordKind::BoundingSphere => {
            FeatureSupport::exact("bounded_by, where it is proved to hold the object")
        }
        RecordKind::Render => FeatureSupport::exact(""),
    }
}

/// The inaccuracy of triangles with shading normals, for the report.
const BEHIND: &str = "a light behind the triangle, but before its shading normal, is seen";

/// How exactly POV-Ray draws a kind of shape.
fn shape(kind: ShapeKind) -> FeatureSupport {
    match kind {
        ShapeKind::SurfaceOfRevolution => FeatureSupport::exact("lathe { linear_spline }"),
        ShapeKind::ColouredSurfaceOfRevolution => {
            FeatureSupport::exact("lathe { linear_spline }, the colours as a pigment")
        }
        ShapeKind::Plane | ShapeKind::HalfSpace => FeatureSupport::exact("plane"),
        ShapeKind::Rectangle => FeatureSupport::exact("polygon"),
        ShapeKind::Triangle => FeatureSupport::exact("triangle"),
        ShapeKind::TriangleWithNormal | ShapeKind::TriangleWithVertexNormals => {
            FeatureSupport::approximate(BEHIND, "smooth_triangle")
        }
        ShapeKind::SphereAtOrigin | ShapeKind::Ellipsoid | ShapeKind::Sphere => {
            FeatureSupport::exact("sphere")
        }
        ShapeKind::Box => FeatureSupport::exact("box"),
        ShapeKind::GeodesicSphere => FeatureSupport::exact("a mesh of the same facets"),
        ShapeKind::Torus => FeatureSupport::exact("torus"),
        ShapeKind::Quadric
        | ShapeKind::ParabolicCylinder
        | ShapeKind::HyperbolicCylinder
        | ShapeKind::Hyperboloid
        | ShapeKind::HyperbolicParaboloid => FeatureSupport::exact("poly { 2 }"),
        ShapeKind::Cone | ShapeKind::DoubleCone => FeatureSupport::exact("cone"),
    }
}

fn of_effect(effect: Effect) -> FeatureSupport {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection | Effect::Refraction => {
            FeatureSupport::exact("")
        }
        Effect::TransparentShadows => FeatureSupport::exact("kt of each surface on the way"),
        Effect::Dispersion => FeatureSupport::exact("three passes, Channel 0, 1 and 2"),
        Effect::TotalReflection => FeatureSupport::approximate(
            "the mirrored ray counts with weight 1 instead of ks + kt",
            "",
        ),
        Effect::VertexColours => FeatureSupport::exact("a pigment over the profile"),
        Effect::SmoothNormals => FeatureSupport::approximate(BEHIND, "smooth_triangle"),
        Effect::Background => FeatureSupport::exact("background"),
        Effect::RenderBox => FeatureSupport::exact("clipped_by"),
        Effect::AutomaticCamera => FeatureSupport::exact("the camera is written out"),
        Effect::AutomaticLights => FeatureSupport::exact("ambient_light and a light_source"),
        Effect::Depth => FeatureSupport::exact("max_trace_level"),
        Effect::Cutoff => FeatureSupport::exact("adc_bailout 0: all rays are followed"),
    }
}

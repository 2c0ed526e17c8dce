//! What POV-Ray makes of each feature.

use super::pictures::Pictures;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::translate::{Effect, Feature, Verdict};

const IMAGE_MAP: &str = "image_map through the surface coordinates";

pub fn verdict(feature: Feature, pictures: &Pictures) -> Verdict {
    match feature {
        Feature::Record(RecordKind::ImageTexture) if matches!(pictures, Pictures::InPlace(_)) => {
            Verdict::approximate(
                "POV-Ray decodes the picture itself; with -o it is copied as PNG",
                IMAGE_MAP,
            )
        }
        Feature::Record(kind) => record(kind),
        Feature::Effect(effect) => of_effect(effect),
    }
}

fn record(kind: RecordKind) -> Verdict {
    match kind {
        RecordKind::Undefined => Verdict::exact("there is nothing to draw"),
        RecordKind::Shape(kind) => shape(kind),
        RecordKind::Translation
        | RecordKind::Rotation
        | RecordKind::Scaling
        | RecordKind::RotationMatrix => Verdict::exact("matrix"),
        RecordKind::ProjectionMatrix => Verdict::exact("location, direction, right and up"),
        RecordKind::Union => Verdict::exact("union, of transparent parts merge"),
        RecordKind::Intersection => Verdict::exact("intersection"),
        RecordKind::Difference => Verdict::exact("difference"),
        RecordKind::Complement => Verdict::exact("inverse"),
        RecordKind::Copy => Verdict::exact("the same object, declared once"),
        RecordKind::Optics | RecordKind::OpticsRgb => Verdict::exact("finish, kt as a filter"),
        RecordKind::RefractiveIndex => Verdict::exact("interior { ior }"),
        RecordKind::Assignment | RecordKind::Colour => Verdict::exact(""),
        RecordKind::ImageTexture => Verdict::exact(IMAGE_MAP),
        RecordKind::SolidTexture | RecordKind::Checkerboard => Verdict::exact("a function pigment"),
        RecordKind::AmbientLight => Verdict::exact("ambient_light"),
        RecordKind::PointLight => Verdict::exact("light_source without fading"),
        RecordKind::Camera | RecordKind::MonoCamera => Verdict::exact("camera"),
        RecordKind::StereoCamera => Verdict::exact("one file for each eye"),
        RecordKind::BoundingBox | RecordKind::BoundingSphere => {
            Verdict::exact("bounded_by, where it is proved to hold the object")
        }
        RecordKind::Render => Verdict::exact(""),
    }
}

/// What shading normals cost.
const BEHIND: &str = "a light behind the triangle, but before its shading normal, is seen";

/// How exact a shape is.
fn shape(kind: ShapeKind) -> Verdict {
    match kind {
        ShapeKind::SurfaceOfRevolution => Verdict::exact("lathe { linear_spline }"),
        ShapeKind::ColouredSurfaceOfRevolution => {
            Verdict::exact("lathe { linear_spline }, the colours as a pigment")
        }
        ShapeKind::Plane | ShapeKind::HalfSpace => Verdict::exact("plane"),
        ShapeKind::Rectangle => Verdict::exact("polygon"),
        ShapeKind::Triangle => Verdict::exact("triangle"),
        ShapeKind::TriangleWithNormal | ShapeKind::TriangleWithVertexNormals => {
            Verdict::approximate(BEHIND, "smooth_triangle")
        }
        ShapeKind::SphereAtOrigin | ShapeKind::Ellipsoid | ShapeKind::Sphere => {
            Verdict::exact("sphere")
        }
        ShapeKind::Box => Verdict::exact("box"),
        ShapeKind::GeodesicSphere => Verdict::exact("a mesh of the same facets"),
        ShapeKind::Torus => Verdict::exact("torus"),
        ShapeKind::Quadric
        | ShapeKind::ParabolicCylinder
        | ShapeKind::HyperbolicCylinder
        | ShapeKind::Hyperboloid
        | ShapeKind::HyperbolicParaboloid => Verdict::exact("poly { 2 }"),
        ShapeKind::Cone | ShapeKind::DoubleCone => Verdict::exact("cone"),
    }
}

fn of_effect(effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection | Effect::Refraction => {
            Verdict::exact("")
        }
        Effect::TransparentShadows => Verdict::exact("kt of each surface on the way"),
        Effect::Dispersion => Verdict::exact("three passes, Channel 0, 1 and 2"),
        Effect::TotalReflection => Verdict::approximate(
            "the mirrored ray counts with weight 1 instead of ks + kt",
            "",
        ),
        Effect::VertexColours => Verdict::exact("a pigment over the profile"),
        Effect::SmoothNormals => Verdict::approximate(BEHIND, "smooth_triangle"),
        Effect::Background => Verdict::exact("background"),
        Effect::RenderBox => Verdict::exact("clipped_by"),
        Effect::AutomaticCamera => Verdict::exact("the camera is written out"),
        Effect::AutomaticLights => Verdict::exact("ambient_light and a light_source"),
        Effect::Depth => Verdict::exact("max_trace_level"),
        Effect::Cutoff => Verdict::exact("adc_bailout 0: all rays are followed"),
    }
}

//! The rules of the linter, each in a folder of its own.
//!
//! A folder has the name of the rule's code, with underscores, and holds
//!
//! - `mod.rs`: `check`, which looks at a scene and adds its findings;
//! - `explain.md`: the page of `zpg explain`, with a scene that is wrong and one that is right, both of which
//!   a test checks; `explain.cs.md`: the page in Czech, with the same scenes;
//! - `en.ftl` and `cs.ftl`: its messages;
//! - `tests/*.zpg`: scenes, and beside each a snapshot of all that is printed about it and of what fixes make
//!   of it (`tests/lint_rules.rs` runs them).
//!
//! Three lines name the folder: the line of its code in `diagnostics/code.rs`, and here its `mod` and its entry in
//! `RULES`.

mod among_others;
mod angle_in_radians;
mod asymmetric_quadric;
mod bare_comment;
mod beside_picture;
mod bound_too_small;
mod bounds_by_size;
mod buried_shape;
mod camera_in_solid;
mod coincident_faces;
pub(super) mod colour_out_of_range;
mod comment_contradicts;
mod comment_hides_records;
mod degenerate_shape;
mod duplicate_operand;
mod empty_result;
pub(super) mod energy_gain;
mod idle_difference;
mod ill_scaled;
mod lamp_in_solid;
mod leading_zero;
mod mixed_intersection;
mod no_camera;
mod no_light;
mod no_real_points;
mod normals_in_plane;
mod not_a_rotation;
mod notation_separator;
mod nothing_in_view;
mod nothing_lit;
mod optics_by_comment;
mod overlapping_union;
mod overridden_property;
mod pointless_index;
mod pointless_transformation;
mod repeated_transformation;
mod rotation_in_radians;
mod scene_box_cuts;
mod self_intersecting;
mod several_cameras;
mod several_records_per_line;
mod smaller_than_a_pixel;
mod stale_operand;
mod standing_floor;
mod stereo_pair;
mod surface_operand;
pub(crate) mod swapped_difference;
mod too_bright;
mod turned_about_origin;
mod unseen_glass;
mod unseen_texture;
pub(super) mod unused_definition;
mod up_along_view;

use super::Context;
use crate::diagnostics::{Code, Diagnostic};
use crate::syntax::table::{RecordKind, ShapeKind};

/// A rule of the linter.
pub(super) struct Rule {
    pub code: Code,
    /// Looks at a scene and adds its findings.
    pub check: fn(&Context, &mut Vec<Diagnostic>),
    /// Groups of record types. The rule runs only on a scene that has a record of each group.
    pub asks_for: &'static [&'static [RecordKind]],
}

use RecordKind as R;
use ShapeKind as S;

/// Largest gap between two places that are equal but for rounding, as a share of their distance from the origin.
const PLACE_REL_GAP: f64 = 1e-9;

const CUTS: &[RecordKind] = &[R::Intersection, R::Difference];
const OPERATIONS: &[RecordKind] = &[R::Union, R::Intersection, R::Difference];
const UNIONS: &[RecordKind] = &[R::Union];
/// Records that [`duplicate_operand`] looks at.
const DOUBLED: &[RecordKind] = &[R::Union, R::Intersection, R::Checkerboard, R::PointLight];
const DIFFERENCES: &[RecordKind] = &[R::Difference];
const ROTATIONS: &[RecordKind] = &[R::Rotation];
const TRANSLATIONS: &[RecordKind] = &[R::Translation];
const INTERSECTIONS: &[RecordKind] = &[R::Intersection];
const SOLID_OPERATIONS: &[RecordKind] = &[R::Intersection, R::Difference, R::Complement];
const BOUNDS: &[RecordKind] = &[R::BoundingBox, R::BoundingSphere];
/// Shapes that are given by their bounds, a radius or a height.
const SIZED: &[RecordKind] = &[
    R::Shape(S::Box),
    R::Shape(S::Rectangle),
    R::Shape(S::Sphere),
    R::Shape(S::SphereAtOrigin),
    R::Shape(S::Cone),
];
/// Records that [`comment_contradicts`] looks at.
const SAID: &[RecordKind] = &[
    R::Shape(S::Plane),
    R::Shape(S::HalfSpace),
    R::Shape(S::Cone),
    R::Rotation,
    R::PointLight,
    R::Colour,
    R::Camera,
];
const RECTANGLES: &[RecordKind] = &[R::Shape(S::Rectangle)];
const RENDER: &[RecordKind] = &[R::Render];
const OPTICS: &[RecordKind] = &[R::Optics, R::OpticsRgb];
const INDICES: &[RecordKind] = &[R::RefractiveIndex];
const ROTATION_MATRICES: &[RecordKind] = &[R::RotationMatrix];
const QUADRICS: &[RecordKind] = &[R::Shape(S::Quadric)];
const CAMERAS: &[RecordKind] = &[R::Camera];
/// The records that define cameras.
const CAMERA_RECORDS: &[RecordKind] = &[R::Camera, R::ProjectionMatrix];
const STEREO: &[RecordKind] = &[R::StereoCamera];
const LAMPS: &[RecordKind] = &[R::PointLight];
const TRANSFORMATIONS: &[RecordKind] =
    &[R::Translation, R::Rotation, R::Scaling, R::RotationMatrix];
const TEXTURES: &[RecordKind] = &[R::ImageTexture, R::SolidTexture, R::Checkerboard];
const TEXTURES_AND_COLOURS: &[RecordKind] =
    &[R::ImageTexture, R::SolidTexture, R::Checkerboard, R::Colour];
const COLOURS: &[RecordKind] = &[R::Colour, R::Shape(S::ColouredSurfaceOfRevolution)];
const SURFACES: &[RecordKind] = &[
    R::Shape(S::Plane),
    R::Shape(S::Rectangle),
    R::Shape(S::Triangle),
    R::Shape(S::TriangleWithNormal),
    R::Shape(S::TriangleWithVertexNormals),
];
const TRIANGLES_WITH_NORMALS: &[RecordKind] = &[
    R::Shape(S::TriangleWithNormal),
    R::Shape(S::TriangleWithVertexNormals),
];
const RINGS: &[RecordKind] = &[
    R::Shape(S::Torus),
    R::Shape(S::SurfaceOfRevolution),
    R::Shape(S::ColouredSurfaceOfRevolution),
];
const THIN_SHAPES: &[RecordKind] = &[
    R::Shape(S::Box),
    R::Shape(S::Rectangle),
    R::Shape(S::Triangle),
    R::Shape(S::TriangleWithNormal),
    R::Shape(S::TriangleWithVertexNormals),
    R::Shape(S::Cone),
    R::Shape(S::Quadric),
    R::Shape(S::SurfaceOfRevolution),
    R::Shape(S::ColouredSurfaceOfRevolution),
];

/// All rules, in the order in which they are begun. The rules that may take longest come first.
pub(super) const RULES: &[Rule] = &[
    Rule {
        code: Code::W321,
        check: coincident_faces::check,
        asks_for: &[CUTS],
    },
    Rule {
        code: Code::W307,
        check: overlapping_union::check,
        asks_for: &[UNIONS],
    },
    Rule {
        code: Code::W311,
        check: bound_too_small::check,
        asks_for: &[BOUNDS],
    },
    Rule {
        code: Code::W312,
        check: scene_box_cuts::check,
        asks_for: &[RENDER],
    },
    Rule {
        code: Code::W319,
        check: empty_result::check,
        asks_for: &[CUTS],
    },
    Rule {
        code: Code::W308,
        check: mixed_intersection::check,
        asks_for: &[INTERSECTIONS],
    },
    Rule {
        code: Code::W310,
        check: unused_definition::check,
        asks_for: &[RENDER],
    },
    Rule {
        code: Code::W309,
        check: stale_operand::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W301,
        check: colour_out_of_range::check,
        asks_for: &[COLOURS],
    },
    Rule {
        code: Code::W302,
        check: energy_gain::check,
        asks_for: &[OPTICS],
    },
    Rule {
        code: Code::W303,
        check: not_a_rotation::check,
        asks_for: &[ROTATION_MATRICES],
    },
    Rule {
        code: Code::W304,
        check: asymmetric_quadric::check,
        asks_for: &[QUADRICS],
    },
    Rule {
        code: Code::W305,
        check: degenerate_shape::check,
        asks_for: &[THIN_SHAPES],
    },
    Rule {
        code: Code::W306,
        check: no_real_points::check,
        asks_for: &[QUADRICS],
    },
    Rule {
        code: Code::W313,
        check: surface_operand::check,
        asks_for: &[SOLID_OPERATIONS, SURFACES],
    },
    Rule {
        code: Code::W315,
        check: comment_hides_records::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W316,
        check: several_cameras::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W318,
        check: pointless_index::check,
        asks_for: &[INDICES],
    },
    Rule {
        code: Code::W320,
        check: self_intersecting::check,
        asks_for: &[RINGS],
    },
    Rule {
        code: Code::W322,
        check: ill_scaled::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W323,
        check: angle_in_radians::check,
        asks_for: &[CAMERAS],
    },
    Rule {
        code: Code::W324,
        check: nothing_in_view::check,
        asks_for: &[CAMERA_RECORDS, RENDER],
    },
    Rule {
        code: Code::W325,
        check: camera_in_solid::check,
        asks_for: &[CAMERA_RECORDS, RENDER],
    },
    Rule {
        code: Code::W326,
        check: lamp_in_solid::check,
        asks_for: &[LAMPS, RENDER],
    },
    Rule {
        code: Code::W327,
        check: pointless_transformation::check,
        asks_for: &[TRANSFORMATIONS],
    },
    Rule {
        code: Code::W328,
        check: up_along_view::check,
        asks_for: &[CAMERAS],
    },
    Rule {
        code: Code::W329,
        check: smaller_than_a_pixel::check,
        asks_for: &[CAMERA_RECORDS, RENDER],
    },
    Rule {
        code: Code::W330,
        check: nothing_lit::check,
        asks_for: &[CAMERA_RECORDS, RENDER, LAMPS],
    },
    Rule {
        code: Code::W331,
        check: unseen_texture::check,
        asks_for: &[TEXTURES_AND_COLOURS, RENDER],
    },
    Rule {
        code: Code::W332,
        check: idle_difference::check,
        asks_for: &[DIFFERENCES],
    },
    Rule {
        code: Code::N602,
        check: no_camera::check,
        asks_for: &[],
    },
    Rule {
        code: Code::N603,
        check: no_light::check,
        asks_for: &[],
    },
    Rule {
        code: Code::N606,
        check: too_bright::check,
        asks_for: &[RENDER],
    },
    Rule {
        code: Code::N607,
        check: rotation_in_radians::check,
        asks_for: &[ROTATIONS],
    },
    Rule {
        code: Code::N608,
        check: beside_picture::check,
        asks_for: &[CAMERA_RECORDS, RENDER, UNIONS],
    },
    Rule {
        code: Code::N609,
        check: turned_about_origin::check,
        asks_for: &[TRANSLATIONS, ROTATIONS],
    },
    Rule {
        code: Code::N610,
        check: among_others::check,
        asks_for: &[],
    },
    Rule {
        code: Code::S501,
        check: notation_separator::check,
        asks_for: &[],
    },
    Rule {
        code: Code::S502,
        check: bare_comment::check,
        asks_for: &[],
    },
    Rule {
        code: Code::S503,
        check: several_records_per_line::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W333,
        check: duplicate_operand::check,
        asks_for: &[DOUBLED],
    },
    Rule {
        code: Code::W334,
        check: overridden_property::check,
        asks_for: &[],
    },
    Rule {
        code: Code::W335,
        check: buried_shape::check,
        asks_for: &[RENDER, UNIONS],
    },
    Rule {
        code: Code::W336,
        check: repeated_transformation::check,
        asks_for: &[TRANSFORMATIONS],
    },
    Rule {
        code: Code::W337,
        check: unseen_glass::check,
        asks_for: &[RENDER, OPTICS],
    },
    Rule {
        code: Code::W338,
        check: stereo_pair::check,
        asks_for: &[STEREO],
    },
    Rule {
        code: Code::W341,
        check: bounds_by_size::check,
        asks_for: &[SIZED],
    },
    Rule {
        code: Code::W339,
        check: normals_in_plane::check,
        asks_for: &[TRIANGLES_WITH_NORMALS],
    },
    Rule {
        code: Code::W340,
        check: swapped_difference::check,
        asks_for: &[OPERATIONS],
    },
    Rule {
        code: Code::W342,
        check: optics_by_comment::check,
        asks_for: &[RENDER],
    },
    Rule {
        code: Code::W343,
        check: standing_floor::check,
        asks_for: &[RECTANGLES],
    },
    Rule {
        code: Code::W344,
        check: comment_contradicts::check,
        asks_for: &[SAID],
    },
    Rule {
        code: Code::S505,
        check: leading_zero::check,
        asks_for: &[],
    },
];

/// Rules about the picture as a whole, or about an object that several records make. They do not run on a scene with an
/// error: the error may leave out an object that would be seen, or a property.
pub(super) const OF_PICTURES: &[Code] = &[
    Code::W307,
    Code::W318,
    Code::W321,
    Code::W324,
    Code::W325,
    Code::W326,
    Code::W329,
    Code::W330,
    Code::W331,
    Code::W333,
    Code::W334,
    Code::W335,
    Code::W337,
    Code::W338,
    Code::W342,
    Code::W343,
    Code::N606,
    Code::N608,
];

/// Rules whose fixes remove records. They offer no fix in a scene with an error: the record may be the one to repair.
pub(super) const TAKING_OUT: &[Code] = &[Code::W327, Code::W336];

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    use crate::diagnostics::Language;

    /// Every folder is listed, as a rule and with its code, and has its files.
    #[test]
    fn folders_are_complete() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lint/rules");
        let mut count = 0;
        for entry in fs::read_dir(root).unwrap().map(Result::unwrap) {
            let path = entry.path();
            if !path.is_dir() {
                continue;
            }
            for file in ["mod.rs", "explain.md", "explain.cs.md", "en.ftl", "cs.ftl"] {
                assert!(path.join(file).exists(), "{} lacks {file}", path.display());
            }
            let name = entry.file_name().into_string().unwrap().replace('_', "-");
            let code = Code::ALL.iter().find(|c| c.name() == name);
            let page = fs::read_to_string(path.join("explain.md")).unwrap();
            assert!(
                code.is_some_and(|c| c.explanation(Language::English) == page),
                "{name}"
            );
            assert!(RULES.iter().any(|r| Some(&r.code) == code), "{name}");
            count += 1;
        }
        assert_eq!(count, RULES.len());
    }
}

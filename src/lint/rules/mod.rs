//! One file a rule.

pub mod asymmetric_quadric;
pub mod bare_comment;
pub mod bound_too_small;
pub mod coincident_faces;
pub mod degenerate_shape;
pub mod empty_result;
pub mod energy_gain;
pub mod ill_scaled;
pub mod no_camera;
pub mod no_light;
pub mod no_real_points;
pub mod not_a_rotation;
pub mod notation_separator;
pub mod overlapping_union;
pub mod scene_box_cuts;
pub mod self_intersecting;
pub mod several_records_per_line;

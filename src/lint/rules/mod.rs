//! One file a rule.

pub mod asymmetric_quadric;
pub mod bare_comment;
pub mod bound_too_small;
pub mod coincident_faces;
pub mod colour_out_of_range;
pub mod comment_hides_records;
pub mod degenerate_shape;
pub mod empty_result;
pub mod energy_gain;
pub mod ill_scaled;
pub mod mixed_intersection;
pub mod no_camera;
pub mod no_light;
pub mod no_real_points;
pub mod not_a_rotation;
pub mod notation_separator;
pub mod overlapping_union;
pub mod pointless_index;
pub mod scene_box_cuts;
pub mod self_intersecting;
pub mod several_cameras;
pub mod several_records_per_line;
pub mod stale_operand;
pub mod surface_operand;
pub mod unused_definition;

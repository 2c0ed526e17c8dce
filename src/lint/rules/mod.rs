//! One file a rule.

pub mod bare_comment;
pub mod energy_gain;
pub mod no_camera;
pub mod no_light;
pub mod notation_separator;
pub mod several_records_per_line;

//! What a ray meets.
//!
//! [`walk`] goes down the graph along one ray. Outside of every solid, [`nearest`] looks for the first
//! crossing. Inside, [`spans`] finds where along the ray each operand is, and [`merge`] joins the spans of the operands.
//! [`root_order`] says which of two crossings comes first, [`surface_identity`] whether two of them are on one surface.
//! [`hit`] says what is at a crossing. [`escalate`] asks again in double-double what rounding may have decided.

pub mod context;
pub mod escalate;
pub mod events;
pub mod hit;
mod merge;
mod nearest;
pub mod query;
pub mod root_order;
mod spans;
mod surface_identity;
pub mod walk;

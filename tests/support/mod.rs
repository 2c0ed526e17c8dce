//! What the tests of translations share: making scenes, an independent evaluator, the real POV-Ray.

pub mod compare;
pub mod make;
pub mod mitsuba;
pub mod naive;
pub mod naive_shapes;
pub mod povray;
pub mod program;

//! What the tests of translations share: making scenes, an independent evaluator, the real POV-Ray.
#![allow(dead_code, reason = "each test binary uses its own part of it")]

pub mod compare;
pub mod make;
pub mod naive;
pub mod naive_shapes;
pub mod povray;

//! What the tests of translations share: making scenes, an independent evaluator, the real POV-Ray.

pub mod compare;
pub mod make;
pub mod mitsuba;
pub mod naive;
pub mod naive_shapes;
pub mod povray;
pub mod program;

/// The seeds of random scenes: those that a variable of the environment chooses, as in `0..1000`, or these.
pub fn seeds(variable: &str, usual: std::ops::Range<u64>) -> std::ops::Range<u64> {
    let Ok(text) = std::env::var(variable) else {
        return usual;
    };
    let number = |n: &str| {
        n.parse()
            .unwrap_or_else(|e| panic!("{variable}={text}: {e}"))
    };
    let (from, to) = text
        .split_once("..")
        .unwrap_or_else(|| panic!("{variable}={text}"));
    number(from)..number(to)
}

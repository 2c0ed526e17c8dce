//! What the tests of translations share: making scenes, the real POV-Ray.

pub mod compare;
pub mod endless;
pub mod mitsuba;
pub mod picture_file;
pub mod povray;
pub mod program;

/// Whether all cases run: `TESTS=all`. Otherwise long tables and random tests take a sample of theirs.
pub fn all_cases() -> bool {
    std::env::var("TESTS").is_ok_and(|v| v == "all")
}

/// How many cases run: `all` of them, or the `sample`.
pub fn cases<T>(sample: T, all: T) -> T {
    if all_cases() { all } else { sample }
}

/// Whether a case of a table takes part: one of `every`, chosen by a hash of its name (FNV-1a), or all of them.
pub fn takes_part(name: &str, every: u64) -> bool {
    let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    all_cases() || (hash >> 32) % every == 0
}

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

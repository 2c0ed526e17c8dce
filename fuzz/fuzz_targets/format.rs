//! Any text: formatting twice is formatting once, and what was said is still said.
#![no_main]

use libfuzzer_sys::fuzz_target;
use zpg::format::{format, same_content};
use zpg::syntax::parse;

fuzz_target!(|text: &str| {
    let (document, findings) = parse(text);
    let once = format(text, &document);
    let (again, _) = parse(&once);
    if findings.iter().all(|d| !d.is_error()) {
        assert!(same_content((text, &document), (&once, &again)), "{once}");
        assert_eq!(format(&once, &again), once);
    }
});

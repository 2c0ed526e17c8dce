//! Any text, with mistakes or without: formatting twice is formatting once, what was said is still said,
//! and any range of lines can be formatted alone.
#![no_main]

use libfuzzer_sys::fuzz_target;
use zpg::internals::format::{Options, format, format_range, same_content};
use zpg::internals::syntax::{Item, parse};

fuzz_target!(|input: (u8, u8, &str)| {
    let (first, more, text) = input;
    let options = Options::default();
    let (document, findings) = parse(text);
    let is_broken = |i: &Item| matches!(i, Item::Broken(_));
    let errors = findings.iter().filter(|d| d.is_error()).count();
    assert!(
        errors > 0 || !document.items.iter().any(is_broken),
        "nothing is said of what is broken"
    );
    let once = format(text, &document, &options);
    let (again, _) = parse(&once);
    assert!(same_content((text, &document), (&once, &again)), "{once}");
    assert_eq!(format(&once, &again, &options), once);
    let (first, more) = (1 + usize::from(first), usize::from(more));
    if let Some(edit) = format_range(text, &document, &options, first..=first + more) {
        let mut part = text.to_owned();
        part.replace_range(edit.span.range(), &edit.text);
        assert!(
            same_content((text, &document), (&part, &parse(&part).0)),
            "{part}"
        );
    }
});

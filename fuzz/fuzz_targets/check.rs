//! Any bytes: checking them and printing the findings in every format ends well.
#![no_main]

use libfuzzer_sys::fuzz_target;
use zpg::commands::Loaded;

fuzz_target!(|bytes: &[u8]| {
    let loaded = Loaded::new("fuzz.zpg", bytes.to_vec());
    assert_eq!(
        loaded.document.print(&loaded.source.text),
        loaded.source.text
    );
    for d in &loaded.diagnostics {
        assert!(loaded.source.text.get(d.span.range()).is_some(), "{d:?}");
    }
});

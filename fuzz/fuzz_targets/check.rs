//! Any bytes: checking them and printing the findings in every format ends well.
#![no_main]

use libfuzzer_sys::fuzz_target;
use zpg::internals::analysis::Analysis;

fuzz_target!(|bytes: &[u8]| {
    let loaded = Analysis::new("fuzz.zpg", bytes.to_vec());
    assert_eq!(
        loaded.document.print(&loaded.source.text),
        loaded.source.text
    );
    for d in loaded.findings() {
        assert!(loaded.source.text.get(d.span.range()).is_some(), "{d:?}");
    }
});

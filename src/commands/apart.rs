//! Files that are worked on side by side, so that a mistake of zpg in one of them leaves the others alone.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use crate::diagnostics::Complaint;

/// Works on one file. Where zpg panics, which the panic's own message has told, that is a complaint about the file.
pub(super) fn apart<T>(
    path: &Path,
    work: impl FnOnce() -> Result<T, Complaint>,
) -> Result<T, Complaint> {
    catch_unwind(AssertUnwindSafe(work))
        .unwrap_or_else(|_| Err(Complaint::new("own-mistake").with("path", path)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Language;

    #[test]
    fn a_panic_is_a_complaint_about_its_file() {
        let done = |i: usize| apart(Path::new("a.zpg"), || Ok([1, 2][i]));
        assert_eq!(done(1).ok(), Some(2));
        let complaint = done(2).expect_err("there is no third number");
        let said = [Language::English, Language::Czech].map(|l| complaint.wording(l));
        assert!(said.iter().all(|text| text.contains("a.zpg")), "{said:?}");
        assert!(
            said[0].contains("mistake") && said[1].contains("chyb"),
            "{said:?}"
        );
    }
}

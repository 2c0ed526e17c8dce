//! Isolation of the work on one file: a panic of zpg over one file leaves the work on the others alone.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use crate::diagnostics::Complaint;

/// Runs `work` on the file `path`. A panic becomes a complaint about the file; the panic's own message has been
/// printed.
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

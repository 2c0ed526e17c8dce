//! Output with a finding a line: `scene.zpg:4:3: E101 error: message`. For editors, `grep` and `sort`.

use std::io::{self, Write};

use super::visible;
use crate::diagnostics::source::{Locator, SourceFile};
use crate::diagnostics::{Diagnostic, Language};

/// Writes a file's findings, in the order they are given.
pub fn write(
    out: &mut dyn Write,
    file: &SourceFile,
    diagnostics: &[Diagnostic],
    language: Language,
) -> io::Result<()> {
    let path = visible(&file.path);
    let mut locator = Locator::new(file);
    for d in diagnostics {
        let place = locator.position(d.span.start);
        writeln!(
            out,
            "{path}:{}:{}: {} {}: {}",
            place.line,
            place.column,
            d.code.as_str(),
            language.say(d.severity.as_str(), &[]),
            visible(&d.wording(language).message),
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Span};

    #[test]
    fn a_line_for_each() {
        let file = SourceFile::new("a.zpg", "2 9 1\n1 9999 7 0\n".into());
        let d = Diagnostic::new(Code::E101, Span::new(13, 14)).with("id", "7\n7");
        let mut out = Vec::new();
        write(&mut out, &file, &[d], Language::English).unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "a.zpg:2:8: E101 error: 7 7 is not defined\n"
        );
    }
}

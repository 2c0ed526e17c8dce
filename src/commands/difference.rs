//! Showing how a file would change, as a unified diff.

use std::fmt;

use clap::builder::styling::AnsiColor;
use imara_diff::{InternedInput, Interner, Token, UnifiedDiffConfig, UnifiedDiffPrinter};

use crate::format::difference;

/// Lines of a unified diff as `patch` and git read them.
struct Lines<'a>(&'a Interner<&'a str>);

impl Lines<'_> {
    fn write(&self, mut f: impl fmt::Write, mark: char, token: Token) -> fmt::Result {
        let line = self.0[token];
        let end = match line.ends_with('\n') {
            true => "",
            false => "\n\\ No newline at end of file\n",
        };
        write!(f, "{mark}{line}{end}")
    }
}

impl UnifiedDiffPrinter for Lines<'_> {
    fn display_header(
        &self,
        mut f: impl fmt::Write,
        old_start: u32,
        new_start: u32,
        old_len: u32,
        new_len: u32,
    ) -> fmt::Result {
        // The line before a range without lines is named.
        let range = |start: u32, len: u32| match len {
            0 => format!("{start},0"),
            1 => format!("{}", start + 1),
            _ => format!("{},{len}", start + 1),
        };
        let (old, new) = (range(old_start, old_len), range(new_start, new_len));
        writeln!(f, "@@ -{old} +{new} @@")
    }

    fn display_context_token(&self, f: impl fmt::Write, token: Token) -> fmt::Result {
        self.write(f, ' ', token)
    }

    fn display_hunk(&self, mut f: impl fmt::Write, old: &[Token], new: &[Token]) -> fmt::Result {
        old.iter().try_for_each(|&t| self.write(&mut f, '-', t))?;
        new.iter().try_for_each(|&t| self.write(&mut f, '+', t))
    }
}

/// Writes a unified diff.
pub fn diff(out: &mut Vec<u8>, path: &str, old: &str, new: &str, colour: bool) {
    let input = InternedInput::new(old, new);
    let diff = difference::of(&input);
    let lines = Lines(&input.interner);
    let hunks = diff.unified_diff(&lines, UnifiedDiffConfig::default(), &input);
    // A name with spaces ends with a tab for `patch`, as git writes it.
    let end = match path.contains(char::is_whitespace) {
        true => "\t",
        false => "",
    };
    let unified = format!("--- {path}{end}\n+++ {path}{end}\n{hunks}");
    for line in unified.split_inclusive('\n') {
        let style = match line.as_bytes().first() {
            _ if !colour => None,
            Some(b'+') => Some(AnsiColor::Green),
            Some(b'-') => Some(AnsiColor::Red),
            Some(b'@') => Some(AnsiColor::Cyan),
            _ => None,
        };
        match style.map(AnsiColor::on_default) {
            Some(style) => {
                let text = line.trim_end_matches('\n');
                out.extend(format!("{style}{text}{style:#}\n").into_bytes());
            }
            None => out.extend(line.as_bytes()),
        }
    }
}

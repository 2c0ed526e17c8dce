//! Findings as results of tests: JUnit XML, which most services for continuous integration read.
//!
//! A file is a suite. Each finding in it is a test that has failed; a file without findings has one test that has
//! passed. The type of a failure is the finding's severity.

use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::{is_disruptive, one_text, plain_path, visible};
use crate::diagnostics::source::Locator;
use crate::diagnostics::{Diagnostic, Language, SourceFile};

/// The findings of a file.
pub struct File {
    path: String,
    findings: Vec<Finding>,
}

struct Finding {
    code: &'static str,
    name: &'static str,
    severity: &'static str,
    message: String,
    text: String,
    line: u32,
    column: u32,
}

impl File {
    pub fn new(file: &SourceFile, diagnostics: &[Diagnostic], language: Language) -> File {
        let path = writable(&plain_path(&file.path, cfg!(windows)));
        let mut locator = Locator::new(file);
        let mut finding = |d: &Diagnostic| {
            let words = d.wording(language);
            let place = locator.position(d.span.start);
            Finding {
                code: d.code.as_str(),
                name: d.code.name(),
                severity: d.severity.as_str(),
                message: writable(&visible(&words.message)),
                text: format!(
                    "{path}:{}:{}: {}",
                    place.line,
                    place.column,
                    writable(&one_text(&words, language))
                ),
                line: place.line,
                column: place.column,
            }
        };
        let findings = diagnostics.iter().map(&mut finding).collect();
        File { path, findings }
    }
}

/// Writes the report of a run. Names of tests are the same in all languages.
pub fn write(out: &mut dyn Write, files: &[File]) -> io::Result<()> {
    let failures: usize = files.iter().map(|file| file.findings.len()).sum();
    let tests: usize = files.iter().map(|file| file.findings.len().max(1)).sum();
    let mut xml = Writer::new_with_indent(&mut *out, b' ', 4);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.create_element("testsuites")
        .with_attribute(("name", "zpg"))
        .with_attribute(("tests", tests.to_string().as_str()))
        .with_attribute(("failures", failures.to_string().as_str()))
        .with_attribute(("errors", "0"))
        .write_inner_content(|xml| files.iter().try_for_each(|file| suite(xml, file)))?;
    writeln!(xml.into_inner())
}

fn suite(xml: &mut Writer<&mut dyn Write>, file: &File) -> io::Result<()> {
    let failures = file.findings.len();
    xml.create_element("testsuite")
        .with_attribute(("name", file.path.as_str()))
        .with_attribute(("tests", failures.max(1).to_string().as_str()))
        .with_attribute(("failures", failures.to_string().as_str()))
        .with_attribute(("errors", "0"))
        .write_inner_content(|xml| {
            if failures == 0 {
                let test = xml.create_element("testcase");
                let test = test.with_attribute(("name", "no findings"));
                let test = test.with_attribute(("classname", file.path.as_str()));
                return test.write_empty().map(|_| ());
            }
            file.findings.iter().try_for_each(|f| case(xml, file, f))
        })?;
    Ok(())
}

fn case(xml: &mut Writer<&mut dyn Write>, file: &File, f: &Finding) -> io::Result<()> {
    xml.create_element("testcase")
        .with_attribute(("name", format!("{} {}", f.code, f.name).as_str()))
        .with_attribute(("classname", file.path.as_str()))
        .with_attribute(("file", file.path.as_str()))
        .with_attribute(("line", f.line.to_string().as_str()))
        .with_attribute(("column", f.column.to_string().as_str()))
        .write_inner_content(|xml| {
            xml.create_element("failure")
                .with_attribute(("type", f.severity))
                .with_attribute(("message", f.message.as_str()))
                .write_text_content(BytesText::new(&f.text))?;
            Ok(())
        })?;
    Ok(())
}

/// Text that XML can hold and a terminal can show: other characters are replaced. Lines stay lines.
fn writable(text: &str) -> String {
    let is_none = |c| c != '\n' && is_disruptive(c) || matches!(c, '\u{fffe}' | '\u{ffff}');
    text.replace(is_none, "\u{fffd}")
}

//! Findings for code scanning: SARIF 2.1.0, the OASIS standard for results of static analysis.
//!
//! The log has one run with the rules of the findings, the files that were checked, and a result for each finding.
//! Lines and columns count as everywhere in zpg; byte offsets are those of the file on disk.

use std::collections::BTreeSet;
use std::io::{self, Write};

use serde::Serialize;

use super::{one_text, plain_path};
use crate::diagnostics::source::{Locator, SourceFile};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Language, Severity, Span};

/// The language of the log, which is the same for all users: programs read the log.
const LANGUAGE: Language = Language::English;

const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";
const VERSION: &str = "2.1.0";

/// The findings of a file.
#[derive(Debug)]
pub struct File {
    artifact: Artifact,
    findings: Vec<(Code, Finding)>,
}

#[derive(Serialize)]
struct Log<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run<'a> {
    tool: Tool,
    invocations: [Invocation; 1],
    language: &'static str,
    column_kind: &'static str,
    newline_sequences: [&'static str; 3],
    artifacts: Vec<&'a Artifact>,
    results: Vec<SarifResult<'a>>,
}

#[derive(Serialize)]
struct Tool {
    driver: Driver,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Driver {
    name: &'static str,
    version: &'static str,
    /// The home page that the package names.
    #[serde(skip_serializing_if = "str::is_empty")]
    information_uri: &'static str,
    rules: Vec<Rule>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Invocation {
    execution_successful: bool,
}

#[derive(Debug, Serialize)]
struct Artifact {
    location: ArtifactLocation,
    encoding: &'static str,
}

#[derive(Debug, Clone, Serialize)]
struct ArtifactLocation {
    uri: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Rule {
    id: &'static str,
    name: &'static str,
    short_description: Message,
    full_description: Message,
    help: Help,
    default_configuration: Configuration,
    properties: RuleProperties,
}

/// The page of a rule: Markdown, which is also readable as it stands.
#[derive(Serialize)]
struct Help {
    text: &'static str,
    markdown: &'static str,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
struct RuleProperties {
    tags: [&'static str; 1],
    /// The severity that GitHub sorts by.
    #[serde(rename = "problem.severity")]
    problem_severity: &'static str,
}

#[derive(Debug, Serialize)]
struct Message {
    text: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct SarifResult<'a> {
    rule_id: &'static str,
    rule_index: usize,
    #[serde(flatten)]
    finding: &'a Finding,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Finding {
    level: &'static str,
    message: Message,
    locations: [Location; 1],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related_locations: Vec<Location>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<Proposal>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    physical_location: PhysicalLocation,
    message: Message,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation {
    artifact_location: ArtifactLocation,
    region: Region,
}

/// A stretch of text, as lines and columns and as bytes; both mean the same.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: u32,
    start_column: u32,
    end_line: u32,
    end_column: u32,
    byte_offset: u32,
    byte_length: u32,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Proposal {
    description: Message,
    artifact_changes: [ArtifactChange; 1],
    properties: FixProperties,
}

#[derive(Debug, Serialize)]
struct FixProperties {
    applicability: Applicability,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactChange {
    artifact_location: ArtifactLocation,
    replacements: Vec<Replacement>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Replacement {
    deleted_region: Region,
    inserted_content: Content,
}

/// Text of a file; unlike a [`Message`] it has no placeholders.
#[derive(Debug, Serialize)]
struct Content {
    text: String,
}

impl File {
    /// A file's findings, which are sorted by their offset.
    pub fn new(file: &SourceFile, diagnostics: Vec<Diagnostic>) -> File {
        let location = ArtifactLocation {
            uri: uri(&file.path, cfg!(windows)),
        };
        let encoding = file.encoding.name();
        let mut places = Places {
            location: &location,
            locator: Locator::new(file),
        };
        let findings = diagnostics
            .into_iter()
            .map(|d| (d.code, places.finding(d)))
            .collect();
        File {
            artifact: Artifact { location, encoding },
            findings,
        }
    }
}

/// The places of findings in a file.
struct Places<'a> {
    location: &'a ArtifactLocation,
    locator: Locator<'a>,
}

impl Places<'_> {
    fn finding(&mut self, d: Diagnostic) -> Finding {
        let words = d.wording(LANGUAGE);
        let text = one_text(&words, Language::English);
        let labels = d.labels.iter().zip(words.labels);
        let fixes = d.fixes.into_iter().zip(words.fixes);
        Finding {
            level: level(d.severity),
            message: message(text),
            locations: [self.location(d.span, words.label)],
            related_locations: labels
                .map(|(label, text)| self.location(label.span, text))
                .collect(),
            fixes: fixes
                .map(|(fix, title)| self.proposal(fix, title))
                .collect(),
        }
    }

    fn location(&mut self, span: Span, text: String) -> Location {
        Location {
            physical_location: PhysicalLocation {
                artifact_location: self.location.clone(),
                region: self.region(span),
            },
            message: message(text),
        }
    }

    fn region(&mut self, span: Span) -> Region {
        let start = self.locator.position(span.start);
        let end = self.locator.position(span.end.max(span.start));
        Region {
            start_line: start.line,
            start_column: start.column,
            end_line: end.line,
            end_column: end.column,
            byte_offset: start.offset,
            byte_length: end.offset - start.offset,
        }
    }

    fn proposal(&mut self, fix: Fix, title: String) -> Proposal {
        let replacements = fix
            .edits
            .into_iter()
            .map(|edit| Replacement {
                deleted_region: self.region(edit.span),
                inserted_content: Content { text: edit.text },
            })
            .collect();
        Proposal {
            description: message(title),
            artifact_changes: [ArtifactChange {
                artifact_location: self.location.clone(),
                replacements,
            }],
            properties: FixProperties {
                applicability: fix.applicability,
            },
        }
    }
}

impl Rule {
    fn new(code: Code) -> Rule {
        let page = code.explanation(LANGUAGE);
        let what = section(page, "What it does");
        let first = what.find(". ").map_or(what.as_str(), |end| &what[..=end]);
        Rule {
            id: code.as_str(),
            name: code.name(),
            short_description: message(first.to_owned()),
            full_description: message(format!("{what} {}", section(page, "Why is this bad"))),
            help: Help {
                text: page,
                markdown: page,
            },
            default_configuration: Configuration {
                level: level(code.severity()),
            },
            properties: RuleProperties {
                tags: [tag(code)],
                problem_severity: match code.severity() {
                    Severity::Error => "error",
                    Severity::Warning => "warning",
                    Severity::Note | Severity::Style => "recommendation",
                },
            },
        }
    }
}

/// A section of a page of `zpg explain`, its lines joined.
fn section(page: &str, heading: &str) -> String {
    page.lines()
        .skip_while(|line| line.strip_prefix("## ") != Some(heading))
        .skip(1)
        .take_while(|line| !line.starts_with("## "))
        .flat_map(str::split_whitespace)
        .collect::<Vec<_>>()
        .join(" ")
}

/// The subject that a code's letter and first digit stand for.
fn tag(code: Code) -> &'static str {
    match &code.as_str()[..2] {
        "E0" => "syntax",
        "E1" => "references",
        "E2" => "values",
        "W3" => "suspicious",
        "S5" => "style",
        _ => "notes",
    }
}

/// The level of a severity. SARIF has no level for matters of style: they share that of notes.
fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note | Severity::Style => "note",
    }
}

/// A message of a text. Its braces are doubled, or they would be placeholders for arguments (section 3.11.5 of the
/// standard).
fn message(text: String) -> Message {
    let text = if text.contains(['{', '}']) {
        text.replace('{', "{{").replace('}', "}}")
    } else {
        text
    };
    Message { text }
}

/// A path as a URI reference. A relative path stays relative, so that programs that read the findings can find the
/// files wherever they are.
fn uri(path: &str, windows: bool) -> String {
    let path = plain_path(path, windows);
    let (drive, rest) = match path.split_at_checked(2) {
        Some((drive, rest)) if windows && drive.ends_with(':') => (drive, rest),
        _ => ("", path.as_str()),
    };
    let mut encoded = String::with_capacity(rest.len());
    for byte in rest.bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'~' => encoded.push(byte.into()),
            _ if byte.is_ascii_alphanumeric() => encoded.push(byte.into()),
            _ => encoded += &format!("%{byte:02X}"),
        }
    }
    match (drive, encoded.starts_with('/')) {
        ("", false) => encoded,
        ("", true) => format!("file://{encoded}"),
        _ => format!("file:///{drive}{encoded}"),
    }
}

/// Writes the log of a run. `complete` says whether all files could be read.
pub fn write(out: &mut dyn Write, files: &[File], complete: bool) -> io::Result<()> {
    let findings = || files.iter().flat_map(|file| &file.findings);
    let spoke: BTreeSet<Code> = findings().map(|&(code, _)| code).collect();
    let spoke = Vec::from_iter(spoke);
    let log = Log {
        schema: SCHEMA,
        version: VERSION,
        runs: [Run {
            tool: Tool {
                driver: Driver {
                    name: env!("CARGO_PKG_NAME"),
                    version: env!("CARGO_PKG_VERSION"),
                    information_uri: env!("CARGO_PKG_HOMEPAGE"),
                    rules: spoke.iter().map(|&code| Rule::new(code)).collect(),
                },
            },
            invocations: [Invocation {
                execution_successful: complete,
            }],
            language: LANGUAGE.tag(),
            column_kind: "unicodeCodePoints",
            newline_sequences: ["\r\n", "\n", "\r"],
            artifacts: files.iter().map(|file| &file.artifact).collect(),
            results: findings()
                .map(|(code, finding)| SarifResult {
                    rule_id: code.as_str(),
                    rule_index: spoke.partition_point(|c| c < code),
                    finding,
                })
                .collect(),
        }],
    };
    serde_json::to_writer_pretty(&mut *out, &log)?;
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_references() {
        let unix = |path| uri(path, false);
        assert_eq!(unix("./scenes/./a b.zpg"), "scenes/a%20b.zpg");
        assert_eq!(unix("../ž:#?%\\.zpg"), "../%C5%BE%3A%23%3F%25%5C.zpg");
        assert_eq!(unix("/tmp/a.zpg"), "file:///tmp/a.zpg");
        assert_eq!(unix("C:/a.zpg"), "C%3A/a.zpg");
        let windows = |path| uri(path, true);
        assert_eq!(windows(".\\scenes\\a b.zpg"), "scenes/a%20b.zpg");
        assert_eq!(windows("C:\\a.zpg"), "file:///C:/a.zpg");
    }

    #[test]
    fn braces_are_no_places() {
        assert_eq!(message("`{0}`".to_owned()).text, "`{{0}}`");
    }

    #[test]
    fn every_rule_is_described() {
        for &code in Code::ALL {
            let rule = Rule::new(code);
            let (short, full) = (&rule.short_description.text, &rule.full_description.text);
            assert!(short.starts_with(char::is_uppercase), "{}", rule.id);
            assert!(short.ends_with('.'), "{}: {short}", rule.id);
            assert!(full.starts_with(short.as_str()), "{}", rule.id);
            assert!(!full.contains("##"), "{}: {full}", rule.id);
        }
    }
}

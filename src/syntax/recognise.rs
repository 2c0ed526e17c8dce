//! Whether a file is a scene. Other files are neither read as scenes nor written to.
//!
//! It is decided over the bytes; the first row that applies counts.
//!
//! | a file | is |
//! |---|---|
//! | in UTF-16, by its mark or because every other byte is NUL | looked at as the text that it is |
//! | that begins as files of a known format do | such a file |
//! | with a NUL before its end | binary data |
//! | with other control characters in more than 1 % of it, but for tab, LF, VT, FF and CR | binary data |
//! | that is one value in brackets or braces of JSON, or begins with `{ "` | JSON, or a scene in JSON |
//! | with a comment or word of 256 MiB or more | some other text |
//! | of which fewer than half of the lines begin with a number: a third is enough with [records of a scene](Lines::are_of_scene) among them | some other text |
//! | of which fewer than half of the numbers are in records, or nearly so: [`by_records`] says where a fifth is enough | some other text |
//! | that is something else | a scene, with mistakes perhaps |
//!
//! Two things behind the text do not belong to it: the mark with which texts of DOS end, 0x1A, and NULs that fill a
//! block of a disk.
//!
//! Three kinds of lines do not count: blank ones, comments, and lines that begin with `//`, `;`, `--` or `/*`, as
//! comments in other languages do. So an empty file is a scene, and so is a file of comments, closed or not. Because a
//! comment that has lost its `#` turns all later ones inside out, the lines are counted twice: with comments that end
//! with the next `#`, and with comments that end with their lines at the latest. It is enough if one of the two counts
//! makes a scene.

use file_format::{FileFormat, Kind};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::ast::Document;
use super::in_records::by_records;
use super::lexer::{self, SEPARATORS, TokenKind, Tokens};
use super::scene_lines::SceneLines;
use crate::diagnostics::wording::with_article;
use crate::diagnostics::{Code, Diagnostic, SourceFile, Span, Value};

/// A file that is no scene, and the finding that says what it is.
#[derive(Debug)]
pub struct NotAScene {
    /// The file. Its text is empty if the bytes are no text.
    pub source: SourceFile,
    pub finding: Diagnostic,
}

/// Decodes the bytes of a file, if it is a scene.
pub fn read(path: impl Into<String>, bytes: Vec<u8>) -> Result<SourceFile, Box<NotAScene>> {
    let format = FileFormat::from_bytes(&bytes);
    let size = bytes.len();
    let source = SourceFile::new(path, bytes);
    let utf16 = source.encoding.is_utf16();
    let characters = if utf16 { size / 2 } else { size };
    let is_known = !matches!(
        format,
        FileFormat::Empty | FileFormat::PlainText | FileFormat::ArbitraryBinaryData
    );
    let finding = Diagnostic::new(Code::E014, Span::default());
    let finding = if is_known && !utf16 {
        let name = format.short_name().unwrap_or(format.name()).to_owned();
        finding
            .case("known")
            .with("name-a", with_article(&name))
            .with("name", name)
            .with("kind", kind(format))
    } else if source.is_blank_disk() || is_binary(&source.text, characters) {
        finding.case("binary")
    } else {
        return match text(&source.text, finding) {
            None => Ok(source),
            Some(finding) => Err(Box::new(NotAScene { source, finding })),
        };
    };
    let source = source.with_text(String::new());
    Err(Box::new(NotAScene { source, finding }))
}

/// Like [`read`], but also parses the text, and refuses it if too few of its numbers are in records.
pub fn parse(
    path: impl Into<String>,
    bytes: Vec<u8>,
) -> Result<(SourceFile, Document), Box<NotAScene>> {
    let source = read(path, bytes)?;
    let (document, _) = super::parse(&source.text);
    match by_records(&source.text, &document) {
        None => Ok((source, document)),
        Some(finding) => Err(Box::new(NotAScene { source, finding })),
    }
}

/// Whether the lines of a text are those of a scene; see the table above for what else it may be.
pub fn is_scene(written: &str) -> bool {
    let finding = Diagnostic::new(Code::E014, Span::default());
    !is_binary(written, written.len()) && text(written, finding).is_none()
}

/// The word by which the message catalogues know a kind of file formats.
fn kind(format: FileFormat) -> &'static str {
    match format.kind() {
        Kind::Image => "picture",
        Kind::Audio => "recording",
        Kind::Video => "film",
        Kind::Archive | Kind::Compressed | Kind::Disk | Kind::Package => "archive",
        Kind::Document | Kind::Ebook | Kind::Presentation | Kind::Spreadsheet => "document",
        Kind::Executable | Kind::Rom => "program",
        Kind::Font => "font",
        Kind::Model => "model",
        Kind::Database => "database",
        _ => "file",
    }
}

/// Whether a text has a NUL, or has more than 1 % other control characters. `characters` is its length in the file.
fn is_binary(text: &str, characters: usize) -> bool {
    let is_control = |b: &u8| b.is_ascii_control() && !(b'\t'..=b'\r').contains(b);
    // Without a branch for each byte.
    let has = |bytes: &[u8]| bytes.iter().fold(false, |any, b| any | is_control(b));
    let bytes = text.as_bytes();
    if !bytes.chunks(1 << 12).any(has) {
        return false;
    }
    let controls = bytes.iter().filter(|b| is_control(b)).count();
    text.contains('\0') || controls * 100 > characters
}

/// Completes the finding about a text that is no scene; `None` for a scene.
fn text(text: &str, finding: Diagnostic) -> Option<Diagnostic> {
    if let Some(case) = json(text) {
        return Some(finding.case(case));
    }
    if let Some(token) = lexer::too_long(text, &[]) {
        let span = Span::new(token.start, token.start);
        return Some(Diagnostic { span, ..finding }.case("long"));
    }
    let mut lines = Lines::default();
    let mut start = 0;
    for end in memchr::memchr2_iter(b'\n', b'\r', text.as_bytes()).chain([text.len()]) {
        match begins_with_digits(&text.as_bytes()[start..end]) {
            true => lines.count(Opening::Number),
            false => lines.count(opening(&text[start..end], false)),
        }
        start = end + 1;
    }
    // Most scenes are known by now.
    if lines.are_records() || Lines::across(text).are_records() || are_comments(text) {
        return None;
    }
    let are_of_scene = lines.are_of_scene(text);
    if are_of_scene && 3 * lines.numbers >= lines.all {
        return None;
    }
    if let Some(span) = first_line(text, is_pov_ray) {
        return Some(Diagnostic { span, ..finding }.case("pov-ray"));
    }
    let span = first_line(text, |line| opening(line, false) == Opening::Other);
    let span = span.unwrap_or_default();
    let finding = Diagnostic { span, ..finding }
        .with("numbers", lines.numbers.to_string())
        .with("lines", Value::Count(lines.all as u64));
    Some(match are_of_scene {
        true => finding.note("comments"),
        false => finding,
    })
}

/// Whether all lines are comments, each of which only lacks its closing sign.
fn are_comments(text: &str) -> bool {
    let is_comment = |line: &str| {
        let line = line.trim_matches(is_blank);
        let words = line.strip_prefix('#').unwrap_or(line);
        !words.contains('#')
            && (line.is_empty() || words.contains(char::is_alphanumeric))
            && words.len() < line.len().max(1)
    };
    text.split(BREAKS).all(is_comment)
}

/// The span of the first line for which `is_so` is true.
fn first_line(text: &str, is_so: impl Fn(&str) -> bool) -> Option<Span> {
    let mut end = 0;
    text.split_inclusive(BREAKS).find_map(|line| {
        let start = end;
        end += line.len();
        let line = line.trim_end_matches(BREAKS);
        is_so(line).then(|| Span::new(start as u32, (start + line.len()) as u32))
    })
}

const BREAKS: [char; 2] = ['\n', '\r'];

/// How many lines count, and how many of those begin with a number.
#[derive(Default)]
struct Lines {
    all: usize,
    numbers: usize,
}

impl Lines {
    fn count(&mut self, opening: Opening) {
        self.all += usize::from(matches!(opening, Opening::Number | Opening::Other));
        self.numbers += usize::from(opening == Opening::Number);
    }

    fn are_records(&self) -> bool {
        2 * self.numbers >= self.all
    }

    /// Whether there are records of a scene among the lines: the render record, or at least two lines that begin as
    /// only those of scenes do, and these are a third of the lines with a number. A page about scenes may show a scene
    /// between fences, and does not count.
    fn are_of_scene(&self, text: &str) -> bool {
        let is_fence = |line: &str| line.trim_start().starts_with("```");
        if self.numbers < 2 || text.split(BREAKS).any(is_fence) {
            return false;
        }
        let lines = SceneLines::of(text, &lexer::lex(text, &[]));
        let of_scenes = lines.typed + lines.worded;
        lines.is_drawn || of_scenes > 1 && 3 * of_scenes >= self.numbers
    }

    /// Counts with comments that may go on over lines.
    fn across(text: &str) -> Lines {
        let mut lines = Lines::default();
        let mut hashes = text.matches('#').count();
        let mut is_comment = false;
        for line in text.split(BREAKS) {
            let here = line.matches('#').count();
            hashes -= here;
            let rest = match (is_comment, line.split_once('#')) {
                (true, None) => continue,
                (true, Some((_, rest))) => rest,
                (false, _) => line,
            };
            lines.count(opening(rest, hashes > 0));
            // A `#` opens no comment if no later one is left to close it.
            is_comment = (is_comment ^ (here % 2 == 1)) && hashes > 0;
        }
        lines
    }
}

/// How a line begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Opening {
    Number,
    Other,
    /// The line is empty but for blanks and comments.
    Nothing,
}

/// Whether a line begins with digits and a space, as nearly all records do.
fn begins_with_digits(line: &[u8]) -> bool {
    let digits = line.iter().take_while(|b| b.is_ascii_digit()).count();
    (1..20).contains(&digits) && line.get(digits) == Some(&b' ')
}

/// How a line begins, comments left out. A comment that is not closed on the line is the rest of the line if `goes_on`
/// is true, and else no comment.
fn opening(line: &str, goes_on: bool) -> Opening {
    let mut rest = line.trim_start_matches(is_blank);
    while let Some(comment) = rest.strip_prefix('#') {
        rest = match comment.split_once('#') {
            Some((_, rest)) => rest.trim_start_matches(is_blank),
            None if goes_on => return Opening::Nothing,
            None => return Opening::Other,
        };
    }
    match rest {
        "" => Opening::Nothing,
        _ if ["//", ";", "--", "/*"].iter().any(|c| rest.starts_with(c)) => Opening::Nothing,
        _ if is_number(rest) => Opening::Number,
        _ => Opening::Other,
    }
}

/// White space, or the mark at the beginning of a file.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || c == '\u{feff}'
}

/// Whether a text begins with a number. A dash may stand for the minus sign.
fn is_number(text: &str) -> bool {
    let number = text.strip_prefix(['−', '–']).unwrap_or(text);
    if !number.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
        return false;
    }
    let ends = |c: char| c.is_whitespace() || "#\"".contains(c) || SEPARATORS.contains(&c);
    let word = number.split(ends).next().unwrap_or_default();
    matches!(
        Tokens::new(word, &[]).next().map(|t| t.kind()),
        Some(TokenKind::Integer | TokenKind::Real | TokenKind::HugeNumber)
    )
}

/// Whether a line is one that scenes of POV-Ray have.
fn is_pov_ray(line: &str) -> bool {
    const BEGINNINGS: [&str; 7] = [
        "#version ",
        "#declare ",
        "#local ",
        "global_settings",
        "light_source",
        "camera {",
        "camera{",
    ];
    BEGINNINGS.iter().any(|b| line.trim_start().starts_with(b))
}

/// The kind of JSON that a text is, as the case of the finding: `scene-json` or `json`. `None` for any other text.
fn json(text: &str) -> Option<&'static str> {
    /// The members that every scene in JSON has.
    #[derive(Deserialize)]
    struct Scene {
        #[serde(rename = "version")]
        _version: u64,
        #[serde(rename = "nodes")]
        _nodes: IgnoredAny,
    }
    let text = text.trim_matches(is_blank);
    if !text.starts_with(['{', '[']) {
        return None;
    }
    if serde_json::from_str::<Scene>(text).is_ok() && text.starts_with('{') {
        return Some("scene-json");
    }
    let is_object = text[1..].trim_start().starts_with('"') && text.starts_with('{');
    let is_json = is_object || serde_json::from_str::<IgnoredAny>(text).is_ok();
    is_json.then_some("json")
}

#[cfg(test)]
mod tests {
    use super::super::lexer::Token;
    use super::*;

    /// The case of the finding; `None` for a scene.
    fn stranger(bytes: &[u8]) -> Option<&'static str> {
        read("a.zpg", bytes.to_vec()).err().map(|s| s.finding.case)
    }

    #[track_caller]
    fn scenes(texts: &[&str]) {
        for text in texts {
            assert_eq!(stranger(text.as_bytes()), None, "{text:?}");
        }
    }

    #[track_caller]
    fn other_texts(texts: &[&str]) {
        for text in texts {
            assert_eq!(stranger(text.as_bytes()), Some(""), "{text:?}");
        }
    }

    #[test]
    fn half_of_the_lines_begin_with_a_number() {
        scenes(&[
            "2 9 1",
            "2 9 1\nword",
            "word\r\n\r\n2 9 1\r\n",
            "word\r2 9 1\r",
            // Words for types, signs that were lost, everything on one line or in lines of one token.
            "1 sphere 0 0 0 1\n2 box 0 0 0 1 1 1\n1 render 2 0\n",
            "2 11 0 0 0 1 2 1 0 0 0 1 9999 2 0 word word word",
            "2\n9\n1\n3\n301\n\"a b.png\"\n",
            "-1\n.5\n+3\n5.\n1e-3\n0,5\n−1\n\"a.png\"\n",
            "7 (1 2 3)\n< 1, 2 >\n",
            "1e999 9 1",
        ]);
        other_texts(&[
            "word",
            "2 9 1\nword\nword",
            "< 1, 2 >\n",
            "(1 2 3)\n",
            // Words that merely begin like numbers.
            "127.0.0.1 localhost\n192.168.1.2 printer\n",
            "2024-01-31 begun\n2024-02-01 done\n",
            "12:00:01 begun\n",
            "3D\n1st\n0x1F\n",
            "nan\ninf\n",
            "-\n+\n.\n",
            "- 1\n- 2\n",
            "\"a.png\"\n",
        ]);
    }

    #[test]
    fn a_third_of_the_lines_is_enough_where_they_are_those_of_a_scene() {
        let scene = "My scene\nThe ball\n2 11 0 1 0 1\nThe lamp\n5 -402 1\nand all\n1 9999 2 0\n";
        scenes(&[
            scene,
            &scene.replace("-402", "light"),
            &format!("{scene}The end\nof it"),
        ]);
        other_texts(&[
            &format!("{scene}The end\nof it\nall"),
            &scene.replace("My scene", "```zpg"),
            // Other numbers than those of scenes.
            "My list\n1 2 3\nmore\n2 3 4\nand\n3 4 5\nmore",
        ]);
    }

    #[test]
    fn some_lines_do_not_count() {
        scenes(&[
            "",
            "\u{feff}",
            " \t\n\u{b}\u{c}\r\n",
            "# a comment #",
            "# a comment\nin prose,\nover three lines #\n",
            "# a # # b #\n\n# c #",
            "# a # 2 9 1\n# over\nlines # 3 9 1\nword\nword",
            "0 # prose #\nword",
            "2 9 1 # prose\nand prose\nand prose #\n",
            "// prose\n; prose\n-- prose\n/* prose\n",
            "// prose\n  -- prose\n2 9 1\nword\n",
            "2 9 1\n\u{1a}",
        ]);
        other_texts(&["// prose\nprose", "* prose\n*/", "- prose", "# a # word"]);
    }

    #[test]
    fn a_lost_sign_turns_no_scene_into_another_text() {
        let scene =
            "# a scene #\n2 9 1 # ball #\n0 # over\ntwo lines #\n3 9 2 # ball #\n1 9999 2 0\n";
        scenes(&[scene]);
        for (at, _) in scene.match_indices('#') {
            let mut text = scene.to_owned();
            text.remove(at);
            scenes(&[&text]);
        }
        scenes(&[
            "2 9 1 # ball\n3 9 1 # ball\n",
            "# ball\n2 9 1\n# ball\n3 9 1\n",
        ]);
        // Nothing but comments that lack it.
        scenes(&["# only a comment", "# one\n# two\n\n  # three\n"]);
        // Comments of other languages.
        other_texts(&[
            "# Title\n\nprose\n",
            "## one\n",
            "#\n# a\n",
            "# one\nx = 1\n",
        ]);
    }

    #[test]
    fn what_no_text_has() {
        let with = |more: &[u8]| [b"2 9 1 # ball #\n".repeat(20), more.to_vec()].concat();
        assert_eq!(stranger(&with(b"\x01\x7f\x1b")), None);
        assert_eq!(stranger(&with(b"\x01\x7f\x1b\x08")), Some("binary"));
        assert_eq!(stranger(&with(b"\x01\x7f\x1b\x1a")), None);
        assert_eq!(stranger(&with(b"\t\x0b\x0c\t\x0b\x0c\t\x0b\x0c")), None);
        assert_eq!(stranger(&with(b"\0")), None);
        assert_eq!(stranger(&with(b"\x002 9 1")), Some("binary"));
        assert_eq!(stranger(b"\0\0\0\0"), Some("binary"));
        assert_eq!(stranger(b"\x01"), Some("binary"));
        assert_eq!(stranger(b"\x1a"), None);
    }

    #[test]
    fn utf_16_is_looked_at_as_text() {
        let utf16 =
            |text: &str| -> Vec<u8> { text.encode_utf16().flat_map(u16::to_le_bytes).collect() };
        for mark in ["", "\u{feff}"] {
            assert_eq!(stranger(&utf16(&format!("{mark}2 9 1\n# žlutá #\n"))), None);
            assert_eq!(stranger(&utf16(&format!("{mark}some words\n"))), Some(""));
            assert_eq!(
                stranger(&utf16(&format!("{mark}2 9 1\n\x003 9 1"))),
                Some("binary")
            );
            assert_eq!(stranger(&utf16(&format!("{mark}[1, 2]"))), Some("json"));
        }
        // UTF-32.
        assert_eq!(stranger(b"\xff\xfe\0\x002\0\0\0"), Some("binary"));
    }

    #[test]
    fn other_formats_are_named() {
        let name = |bytes: &[u8]| {
            let stranger = read("a.zpg", bytes.to_vec()).err()?;
            Some(stranger.finding.wording(Default::default()).message)
        };
        for (bytes, expected) in [
            (
                &b"\x89PNG\r\n\x1a\n"[..],
                "this is a PNG picture, not a scene",
            ),
            (b"\xff\xd8\xff\xe0", "this is a JPEG picture, not a scene"),
            (b"v/1\x01\x02", "this is an EXR picture, not a scene"),
            (b"PF\n2 2\n", "this is a PFM picture, not a scene"),
            (b"%PDF-1.7\n2 9 1\n", "this is a PDF document, not a scene"),
            (b"PK\x03\x04", "this is a ZIP archive, not a scene"),
            (b"\x7fELF", "this is an ELF program, not a scene"),
            (b"glTF\x02\0\0\0", "this is a GLB 3D model, not a scene"),
            (
                b"ply\nformat ascii 1.0\n1 2 3\n1 2 3\n1 2 3\n",
                "this is a PLY 3D model, not a scene",
            ),
            (b"#!/bin/sh\n", "this is a Shell Script file, not a scene"),
            (
                b"SQLite format 3\0",
                "this is an SQLite 3 database, not a scene",
            ),
        ] {
            assert_eq!(name(bytes).as_deref(), Some(expected));
        }
    }

    #[test]
    fn a_comment_may_not_be_too_long() {
        let comment = |length: usize| format!("2 9 1\n#{}#\n", " ".repeat(length - 2));
        let text = comment(Token::LENGTH_MAX);
        assert_eq!(stranger(text.as_bytes()), Some("long"));
        drop(text);
        scenes(&[&comment(Token::LENGTH_MAX - 1)]);
    }

    #[test]
    fn json_is_no_scene_however_many_numbers_it_has() {
        for (text, case) in [
            ("[\n1,\n2,\n3\n]\n", Some("json")),
            ("{}", Some("json")),
            ("{ \"cut\": [\n1,\n2,\n3,\n4,\n5,\n", Some("json")),
            (
                "\u{feff}{\"version\": 1, \"nodes\": [\n1,\n2\n]}\n",
                Some("scene-json"),
            ),
            ("{\"version\": 1}\n", Some("json")),
            ("12", None),
            ("\"a.png\"\n2 9 1\n", None),
        ] {
            assert_eq!(stranger(text.as_bytes()), case, "{text}");
        }
    }
}

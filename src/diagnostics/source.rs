//! A scene file in memory: the text the tools read, and the way back to the bytes on disk.

#![warn(missing_docs)]

use std::borrow::Cow;
use std::path::Path;
use std::sync::OnceLock;

use super::Span;

/// The longest file that is read, in bytes: spans are 32-bit.
pub const MAX_FILE_BYTES: usize = i32::MAX as usize;

/// The encoding of a file on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8.
    Utf8,
    /// A text that is not valid UTF-8, and so is taken as the usual Czech encoding. One byte is one character.
    Windows1250,
    /// UTF-16 with the low byte first, as Windows' Notepad writes it. It is recognised by a byte order mark, or by NUL
    /// in nearly every other byte.
    Utf16Le,
    /// UTF-16 with the high byte first.
    Utf16Be,
}

impl Encoding {
    /// Tells UTF-16 from other encodings by a file's bytes. UTF-8 is not validated here: [`SourceFile::new`] takes
    /// invalid UTF-8 for Windows-1250.
    fn of(bytes: &[u8]) -> Encoding {
        match bytes {
            [0xff, 0xfe, ..] => Encoding::Utf16Le,
            [0xfe, 0xff, ..] => Encoding::Utf16Be,
            _ if memchr::memchr(0, bytes).is_none() => Encoding::Utf8,
            _ if is_half_nul(bytes, 1) => Encoding::Utf16Le,
            _ if is_half_nul(bytes, 0) => Encoding::Utf16Be,
            _ => Encoding::Utf8,
        }
    }

    /// The name of the encoding in the registry of character sets.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 => "UTF-8",
            Encoding::Windows1250 => "windows-1250",
            Encoding::Utf16Le => "UTF-16LE",
            Encoding::Utf16Be => "UTF-16BE",
        }
    }

    /// Whether the encoding is UTF-16, in either order of bytes.
    pub fn is_utf16(self) -> bool {
        matches!(self, Encoding::Utf16Le | Encoding::Utf16Be)
    }

    /// The number of bytes that a text takes on disk.
    fn width(self, text: &str) -> u32 {
        match self {
            Encoding::Utf8 => text.len() as u32,
            Encoding::Windows1250 => text.chars().count() as u32,
            Encoding::Utf16Le | Encoding::Utf16Be => 2 * text.encode_utf16().count() as u32,
        }
    }

    /// Decodes bytes. Returns the text, and whether it stands for all of the bytes.
    fn decode(self, bytes: Vec<u8>) -> (String, bool) {
        let unit: fn([u8; 2]) -> u16 = match self {
            Encoding::Utf8 => {
                let text = String::from_utf8(bytes);
                return text.map_or_else(
                    |e| (String::from_utf8_lossy(e.as_bytes()).into_owned(), false),
                    |text| (text, true),
                );
            }
            Encoding::Windows1250 => {
                let (text, _) = encoding_rs::WINDOWS_1250.decode_without_bom_handling(&bytes);
                return (text.into_owned(), true);
            }
            Encoding::Utf16Le => u16::from_le_bytes,
            Encoding::Utf16Be => u16::from_be_bytes,
        };
        let (pairs, rest) = bytes.as_chunks::<2>();
        let mut whole = rest.is_empty();
        let characters = char::decode_utf16(pairs.iter().map(|&pair| unit(pair)));
        let text = characters.map(|c| {
            whole &= c.is_ok();
            c.unwrap_or(char::REPLACEMENT_CHARACTER)
        });
        (text.collect(), whole)
    }

    fn encode(self, text: &str) -> Cow<'_, [u8]> {
        let bytes: fn(u16) -> [u8; 2] = match self {
            Encoding::Utf8 => return text.as_bytes().into(),
            Encoding::Windows1250 => return encoding_rs::WINDOWS_1250.encode(text).0,
            Encoding::Utf16Le => u16::to_le_bytes,
            Encoding::Utf16Be => u16::to_be_bytes,
        };
        text.encode_utf16()
            .flat_map(bytes)
            .collect::<Vec<u8>>()
            .into()
    }
}

/// Whether the bytes are pairs in which one byte, the first (0) or the second (1) as `nul` says, is nearly always NUL,
/// and the other one hardly ever: letters beyond Latin 1 occur in comments.
fn is_half_nul(bytes: &[u8], nul: usize) -> bool {
    let (mut pairs, _) = bytes.as_chunks::<2>();
    // NULs at the end fill a block of a disk, and say nothing about the encoding.
    while let [before @ .., [0, 0]] = pairs {
        pairs = before;
    }
    let nuls = |i: usize| pairs.iter().filter(|pair| pair[i] == 0).count();
    !pairs.is_empty() && 4 * nuls(nul) >= 3 * pairs.len() && 16 * nuls(1 - nul) <= pairs.len()
}

/// The end of the text proper. Behind it may be end marks of DOS (0x1A) and NULs, perhaps with blanks between them.
fn end_of_text(text: &str) -> usize {
    let is_fill = |c: char| matches!(c, '\0' | '\u{1a}');
    let kept = text.trim_end_matches(|c: char| is_fill(c) || matches!(c, ' ' | '\t' | '\r' | '\n'));
    let fill = text[kept.len()..].find(is_fill);
    fill.map_or(text.len(), |at| kept.len() + at)
}

/// The line break of a text. In a text with several kinds it is the last one: a text that is printed anew ends with
/// this line break, so that it is found again.
pub fn line_break(text: &str) -> &'static str {
    match text.rfind(['\n', '\r']) {
        Some(at) if text[..=at].ends_with("\r\n") => "\r\n",
        Some(at) if text[at..].starts_with('\r') => "\r",
        _ => "\n",
    }
}

/// A place as people count: line and column from 1, the column in characters; and the byte on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Position {
    /// The byte on disk.
    pub offset: u32,
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

/// A scene file: its name for messages, its text, and how to get back to its bytes.
#[derive(Debug)]
pub struct SourceFile {
    /// The path as the user gave it.
    pub path: String,
    /// The decoded text; a byte order mark stays in it, so that offsets agree with the file.
    pub text: String,
    /// The encoding of the file.
    pub encoding: Encoding,
    /// Whether the text stands for all bytes of the file. Half a character of UTF-16 cannot be kept.
    pub is_whole: bool,
    /// The characters behind the text: the end mark of DOS, and those that fill the file's last block on a disk.
    tail: String,
    lines: OnceLock<Lines>,
}

#[derive(Debug)]
struct Lines {
    /// Byte offset in the text of each line's start.
    starts: Vec<u32>,
    /// Byte offset on disk of each line's start; empty for UTF-8, where the two offsets agree.
    starts_on_disk: Vec<u32>,
}

impl Lines {
    fn new(text: &str, encoding: Encoding) -> Lines {
        let bytes = text.as_bytes();
        let is_end = |&i: &usize| bytes[i] == b'\n' || bytes.get(i + 1) != Some(&b'\n');
        let ends = memchr::memchr2_iter(b'\n', b'\r', bytes).filter(is_end);
        let starts: Vec<u32> = std::iter::once(0)
            .chain(ends.map(|i| i as u32 + 1))
            .collect();
        let mut starts_on_disk = Vec::new();
        if encoding != Encoding::Utf8 {
            let mut on_disk = 0;
            for (i, &start) in starts.iter().enumerate() {
                starts_on_disk.push(on_disk);
                let end = starts.get(i + 1).map_or(text.len(), |&e| e as usize);
                on_disk += encoding.width(&text[start as usize..end]);
            }
        }
        Lines {
            starts,
            starts_on_disk,
        }
    }
}

impl SourceFile {
    /// Decodes a file: as UTF-16 where that is plain, as UTF-8 where it is valid, otherwise as Windows-1250, which
    /// never fails.
    pub fn new(path: impl Into<String>, bytes: Vec<u8>) -> SourceFile {
        let encoding = Encoding::of(&bytes);
        let (encoding, (text, is_whole)) = match encoding {
            Encoding::Utf8 => match String::from_utf8(bytes) {
                Ok(text) => (encoding, (text, true)),
                Err(e) => (
                    Encoding::Windows1250,
                    Encoding::Windows1250.decode(e.into_bytes()),
                ),
            },
            _ => (encoding, encoding.decode(bytes)),
        };
        SourceFile {
            encoding,
            is_whole,
            ..SourceFile::of_text(path, text)
        }
    }

    /// A file in UTF-8 with a text that is decoded already.
    pub fn of_text(path: impl Into<String>, mut text: String) -> SourceFile {
        let tail = text.split_off(end_of_text(&text));
        SourceFile {
            path: path.into(),
            text,
            encoding: Encoding::Utf8,
            is_whole: true,
            tail,
            lines: OnceLock::new(),
        }
    }

    /// The same file with another text.
    pub fn with_text(&self, text: String) -> SourceFile {
        SourceFile {
            path: self.path.clone(),
            text,
            encoding: self.encoding,
            is_whole: self.is_whole,
            tail: self.tail.clone(),
            lines: OnceLock::new(),
        }
    }

    /// Whether the file is nothing but NULs, and so no text at all.
    pub fn is_blank_disk(&self) -> bool {
        self.text.is_empty() && self.tail.contains('\0')
    }

    /// The starts of lines. They are found when they are first asked for, which most scenes, having no findings, never
    /// need.
    fn lines(&self) -> &Lines {
        self.lines
            .get_or_init(|| Lines::new(&self.text, self.encoding))
    }

    /// The folder the file lies in, the current one for standard input; `None` for texts that are no files.
    pub fn folder(&self) -> Option<&Path> {
        let path = Path::new(&self.path);
        if self.path == "-" {
            return Some(Path::new("."));
        }
        let parent = path.parent().filter(|_| path.is_file())?;
        Some(if parent.as_os_str().is_empty() {
            Path::new(".")
        } else {
            parent
        })
    }

    /// The text of a span.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or("")
    }

    /// The start of the character that an offset lies in, which may be the offset itself; at most the text's end.
    pub fn floor(&self, offset: u32) -> u32 {
        let mut at = (offset as usize).min(self.text.len());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        at as u32
    }

    /// The number of the line a text offset lies on, from 0.
    pub fn line_index(&self, offset: u32) -> usize {
        self.lines().starts.partition_point(|&s| s <= offset) - 1
    }

    /// The span of a line (from 0) without its line break.
    pub fn line_span(&self, line: usize) -> Span {
        let lines = self.lines();
        let start = lines
            .starts
            .get(line)
            .copied()
            .unwrap_or(self.text.len() as u32);
        let end = lines
            .starts
            .get(line + 1)
            .map_or(self.text.len(), |&e| e as usize);
        let text = self.text[start as usize..end].trim_end_matches(['\r', '\n']);
        Span::new(start, start + text.len() as u32)
    }

    /// Number of lines.
    pub fn line_count(&self) -> usize {
        self.lines().starts.len()
    }

    /// Line, column and byte on disk of a text offset.
    pub fn position(&self, offset: u32) -> Position {
        let line = self.line_index(offset);
        let start = self.lines().starts[line];
        let before = &self.text[start as usize..(offset as usize).min(self.text.len())];
        // A byte order mark is no character of the first line.
        let column = before.trim_start_matches('\u{feff}').chars().count() as u32;
        Position {
            offset: self.byte_on_disk(offset),
            line: line as u32 + 1,
            column: column + 1,
        }
    }

    /// The byte of the file on disk that a text offset stands for.
    pub fn byte_on_disk(&self, offset: u32) -> u32 {
        let line = self.line_index(offset);
        match self.lines().starts_on_disk.get(line) {
            None => offset,
            Some(start) => {
                let inside =
                    self.lines().starts[line] as usize..(offset as usize).min(self.text.len());
                start + self.encoding.width(&self.text[inside])
            }
        }
    }

    /// The bytes of another text in the file's encoding. `None` if they would be read as a different text, or if the
    /// file has bytes that its text does not stand for.
    pub fn encode<'t>(&self, text: &'t str) -> Option<Cow<'t, [u8]>> {
        let mut bytes = self.encoding.encode(text);
        if !self.tail.is_empty() {
            bytes.to_mut().extend(&*self.encoding.encode(&self.tail));
        }
        let is_same = self.is_whole
            && (self.encoding == Encoding::Utf8
                || SourceFile::new("", bytes.to_vec()).text == text);
        is_same.then_some(bytes)
    }
}

/// Finds positions one after another, counting from the last one found: findings that stand close
/// together on a very long line cost no more than on a short one.
pub struct Locator<'a> {
    file: &'a SourceFile,
    /// The line of the last position, from 0.
    line: usize,
    /// The text offset of the last position.
    offset: u32,
    /// The length of the text between the line's start and the last position.
    before: Extent,
}

/// The length of a stretch of text, in characters and in bytes on disk.
#[derive(Clone, Copy, Default)]
struct Extent {
    chars: u32,
    on_disk: u32,
}

impl<'a> Locator<'a> {
    /// A locator for a file.
    pub fn new(file: &'a SourceFile) -> Locator<'a> {
        Locator {
            file,
            line: 0,
            offset: 0,
            before: Extent::default(),
        }
    }

    /// The same position as [`SourceFile::position`] gives. An offset inside a character or past the end is moved back
    /// to where a character starts.
    pub fn position(&mut self, offset: u32) -> Position {
        let file = self.file;
        let offset = file.floor(offset);
        let line = file.line_index(offset);
        let start = file.lines().starts[line];
        let extent = |from: u32, to: u32| {
            let text = &file.text[from as usize..to as usize];
            Extent {
                chars: text.chars().count() as u32,
                on_disk: file.encoding.width(text),
            }
        };
        let known = line == self.line && self.offset >= start;
        self.before = if known && offset >= self.offset {
            let more = extent(self.offset, offset);
            Extent {
                chars: self.before.chars + more.chars,
                on_disk: self.before.on_disk + more.on_disk,
            }
        } else if known && self.offset - offset < offset - start {
            let less = extent(offset, self.offset);
            Extent {
                chars: self.before.chars - less.chars,
                on_disk: self.before.on_disk - less.on_disk,
            }
        } else {
            extent(start, offset)
        };
        self.line = line;
        self.offset = offset;
        // A byte order mark is no character of the first line.
        let mark = u32::from(line == 0 && offset > 0 && file.text.starts_with('\u{feff}'));
        let start_on_disk = file
            .lines()
            .starts_on_disk
            .get(line)
            .copied()
            .unwrap_or(start);
        Position {
            offset: start_on_disk + self.before.on_disk,
            line: line as u32 + 1,
            column: self.before.chars - mark + 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn the_locator_agrees_with_position() {
        let utf16 = utf16("\u{feff}é 1\r\n# 😀ž # 2\n", u16::to_be_bytes);
        for bytes in [
            "\u{feff}é 1\r\n# ž # 2\n".as_bytes().to_vec(),
            b"# p\xf8\xedklad #\n2 9 x\xf8".to_vec(),
            utf16,
        ] {
            let file = SourceFile::new("a", bytes);
            let places: Vec<u32> = (0..=file.text.len() as u32)
                .filter(|&i| file.text.is_char_boundary(i as usize))
                .collect();
            let mut locator = Locator::new(&file);
            for &place in places.iter().chain(places.iter().rev()) {
                assert_eq!(locator.position(place), file.position(place));
            }
            assert_eq!(locator.position(u32::MAX).line as usize, file.line_count());
        }
    }

    #[test]
    fn positions_count_characters() {
        let f = SourceFile::new("a", "é 1\r\n# ž # 2\n".into());
        let p = f.position(f.text.find('2').unwrap() as u32);
        assert_eq!((p.line, p.column), (2, 7));
        assert_eq!(f.line_span(0), Span::new(0, 4));
        assert_eq!(f.line_count(), 3);
    }

    #[test]
    fn windows_1250_points_at_the_bytes_on_disk() {
        let bytes = b"# p\xf8\xedklad # 2 9 x".to_vec();
        let f = SourceFile::new("a", bytes.clone());
        assert_eq!(f.encoding, Encoding::Windows1250);
        assert!(f.text.contains("příklad"));
        let p = f.position(f.text.find('x').unwrap() as u32);
        assert_eq!(bytes[p.offset as usize], b'x');
        assert_eq!(f.encode(&f.text), Some(bytes.into()));
        // Every byte is a character that is written as this byte again.
        let all: Vec<u8> = (1..=255).collect();
        let f = SourceFile::new("a", all.clone());
        assert_eq!(f.encode(&f.text), Some(all.into()));
        // What the encoding cannot say is not written as something else.
        assert_eq!(f.encode("2 9 1 # ∞ #"), None);
    }

    #[test]
    fn utf_16_points_at_the_bytes_on_disk() {
        type Bytes = fn(u16) -> [u8; 2];
        let kinds: [(Encoding, Bytes); 2] = [
            (Encoding::Utf16Le, u16::to_le_bytes),
            (Encoding::Utf16Be, u16::to_be_bytes),
        ];
        for (encoding, order) in kinds {
            for mark in ["\u{feff}", ""] {
                let text = format!("{mark}# příklad 😀 # 2 9 1\r\n3 9 x\r\n");
                let bytes = utf16(&text, order);
                let f = SourceFile::new("a", bytes.clone());
                assert_eq!((f.encoding, &f.text, f.is_whole), (encoding, &text, true));
                let p = f.position(text.find('x').unwrap() as u32);
                let at = p.offset as usize;
                assert_eq!(bytes[at..at + 2], order(u16::from(b'x')));
                assert_eq!((p.line, p.column), (2, 5));
                assert_eq!(f.encode(&f.text), Some((&bytes).into()));
                // Nothing is lost that is no character.
                let f = SourceFile::new("a", [&bytes[..], b"\n"].concat());
                assert_eq!((&f.text, f.encode(&f.text)), (&text, None));
                let lone = [&bytes[..], &order(0xd812), &order(u16::from(b'1'))].concat();
                let f = SourceFile::new("a", lone);
                assert_eq!(f.text, format!("{text}\u{fffd}1"));
                assert_eq!(f.encode(&f.text), None);
            }
        }
        // What a block of a disk is filled with.
        let f = SourceFile::new("a", b"2 9 1\n\x1a\0\0\0\0\0\0\0\0\0\0\0".to_vec());
        assert_eq!((f.encoding, &f.text[..]), (Encoding::Utf8, "2 9 1\n"));
        let f = SourceFile::new("a", b"2\09\0\x1a\0\0\0".to_vec());
        assert_eq!((f.encoding, &f.text[..]), (Encoding::Utf16Le, "29"));
        // Text of some other kind with a NUL in it.
        let f = SourceFile::new("a", b"2 9 1\0\n".to_vec());
        assert_eq!(f.encoding, Encoding::Utf8);
    }

    #[test]
    fn the_line_break_is_the_last_one() {
        for (text, expected) in [
            ("", "\n"),
            ("2 9 1", "\n"),
            ("a\r\nb\n", "\n"),
            ("a\nb\r\nc", "\r\n"),
            ("a\rb", "\r"),
            ("a\nb\r", "\r"),
            ("a\rb\n", "\n"),
            ("a\r\n\r", "\r"),
        ] {
            assert_eq!(line_break(text), expected, "{text:?}");
        }
    }

    #[test]
    fn what_is_behind_the_text_stays() {
        for (text, tail) in [
            ("2 9 1\n", "\u{1a}"),
            ("2 9 1", "\u{1a}\u{1a}"),
            ("2 9 1\r\n", "\u{1a}\r\n"),
            ("2 9 1\n\n", "\0\0\0"),
            ("2 9\u{1a}1 \n", ""),
            ("", "\u{1a}"),
        ] {
            let all = format!("{text}{tail}");
            let file = SourceFile::new("a", all.clone().into());
            assert_eq!(file.text, text);
            assert_eq!(file.encode(text).as_deref(), Some(all.as_bytes()));
            let other = file.with_text("3 9 1\n".to_owned());
            let expected = format!("3 9 1\n{tail}");
            assert_eq!(
                other.encode(&other.text).as_deref(),
                Some(expected.as_bytes())
            );
            assert_eq!(SourceFile::of_text("a", all).text, text);
        }
    }

    #[test]
    fn a_byte_order_mark_is_no_column() {
        let f = SourceFile::new("a", "\u{feff}2 9 1".into());
        let p = f.position(3);
        assert_eq!((p.offset, p.line, p.column), (3, 1, 1));
    }
}

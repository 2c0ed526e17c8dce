//! A scene file in memory: the text the tools read, and the way back to the bytes on disk.

use std::path::Path;

use super::Span;

/// The longest file that is read, in bytes: spans are 32-bit.
pub const MAX_FILE_BYTES: usize = i32::MAX as usize;

/// How the file lies on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    Utf8,
    /// Not valid UTF-8, so taken as the usual Czech encoding. One byte is one character.
    Windows1250,
}

/// A place as people count: line and column from 1, the column in characters; and the byte on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Position {
    pub offset: u32,
    pub line: u32,
    pub column: u32,
}

/// A scene file: its name for messages, its text, and how to get back to its bytes.
#[derive(Debug)]
pub struct SourceFile {
    /// The path as the user gave it.
    pub path: String,
    /// The decoded text; a byte order mark stays in it, so that offsets agree with the file.
    pub text: String,
    pub encoding: Encoding,
    /// Byte offset in `text` of each line's start.
    line_starts: Vec<u32>,
    /// For Windows-1250 only: at each line's start, how many characters came before.
    chars_before_line: Vec<u32>,
}

impl SourceFile {
    /// Decodes a file: UTF-8 where it is valid, else Windows-1250, which never fails.
    pub fn new(path: impl Into<String>, bytes: Vec<u8>) -> SourceFile {
        let (text, encoding) = match String::from_utf8(bytes) {
            Ok(text) => (text, Encoding::Utf8),
            Err(e) => {
                let (text, _) = encoding_rs::WINDOWS_1250.decode_without_bom_handling(e.as_bytes());
                (text.into_owned(), Encoding::Windows1250)
            }
        };
        let mut line_starts = vec![0u32];
        let bytes = text.as_bytes();
        for (i, &b) in bytes.iter().enumerate() {
            if b == b'\n' || (b == b'\r' && bytes.get(i + 1) != Some(&b'\n')) {
                line_starts.push(i as u32 + 1);
            }
        }
        let mut chars_before_line = Vec::new();
        if encoding == Encoding::Windows1250 {
            let mut chars = 0;
            for (i, &start) in line_starts.iter().enumerate() {
                chars_before_line.push(chars);
                let end = line_starts.get(i + 1).map_or(text.len(), |&e| e as usize);
                chars += text[start as usize..end].chars().count() as u32;
            }
        }
        SourceFile {
            path: path.into(),
            text,
            encoding,
            line_starts,
            chars_before_line,
        }
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

    /// The offset itself, or where the character starts that it lies in; at most the text's end.
    pub fn floor(&self, offset: u32) -> u32 {
        let mut at = (offset as usize).min(self.text.len());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        at as u32
    }

    /// The number of the line a text offset lies on, from 0.
    pub fn line_index(&self, offset: u32) -> usize {
        self.line_starts.partition_point(|&s| s <= offset) - 1
    }

    /// The span of a line (from 0) without its line break.
    pub fn line_span(&self, line: usize) -> Span {
        let start = self
            .line_starts
            .get(line)
            .copied()
            .unwrap_or(self.text.len() as u32);
        let end = self
            .line_starts
            .get(line + 1)
            .map_or(self.text.len(), |&e| e as usize);
        let text = self.text[start as usize..end].trim_end_matches(['\r', '\n']);
        Span::new(start, start + text.len() as u32)
    }

    pub fn line_count(&self) -> usize {
        self.line_starts.len()
    }

    /// Line, column and byte on disk of a text offset.
    pub fn position(&self, offset: u32) -> Position {
        let line = self.line_index(offset);
        let start = self.line_starts[line];
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
        match self.encoding {
            Encoding::Utf8 => offset,
            Encoding::Windows1250 => {
                let line = self.line_index(offset);
                let start = self.line_starts[line] as usize;
                let inside = self.text[start..(offset as usize).min(self.text.len())]
                    .chars()
                    .count() as u32;
                self.chars_before_line[line] + inside
            }
        }
    }

    /// A text as bytes in this file's encoding.
    pub fn encode(&self, text: &str) -> Vec<u8> {
        match self.encoding {
            Encoding::Utf8 => text.as_bytes().to_vec(),
            Encoding::Windows1250 => encoding_rs::WINDOWS_1250.encode(text).0.into_owned(),
        }
    }
}

/// Finds positions one after another, counting characters from the last one found: findings that
/// stand close together on a very long line cost no more than on a short one.
pub struct Locator<'a> {
    file: &'a SourceFile,
    /// The line of the last position, its text offset, and the characters before it on the line.
    line: usize,
    offset: u32,
    chars: u32,
}

impl<'a> Locator<'a> {
    pub fn new(file: &'a SourceFile) -> Locator<'a> {
        Locator {
            file,
            line: 0,
            offset: 0,
            chars: 0,
        }
    }

    /// As [`SourceFile::position`]. An offset inside a character or past the end is moved back to
    /// where a character starts.
    pub fn position(&mut self, offset: u32) -> Position {
        let file = self.file;
        let offset = file.floor(offset);
        let line = file.line_index(offset);
        let start = file.line_starts[line];
        let count =
            |from: u32, to: u32| file.text[from as usize..to as usize].chars().count() as u32;
        let known = line == self.line && self.offset >= start;
        self.chars = if known && offset >= self.offset {
            self.chars + count(self.offset, offset)
        } else if known && self.offset - offset < offset - start {
            self.chars - count(offset, self.offset)
        } else {
            count(start, offset)
        };
        self.line = line;
        self.offset = offset;
        // A byte order mark is no character of the first line.
        let mark = u32::from(line == 0 && offset > 0 && file.text.starts_with('\u{feff}'));
        Position {
            offset: match file.encoding {
                Encoding::Utf8 => offset,
                Encoding::Windows1250 => file.chars_before_line[line] + self.chars,
            },
            line: line as u32 + 1,
            column: self.chars - mark + 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_locator_agrees_with_position() {
        for bytes in [
            "\u{feff}é 1\r\n# ž # 2\n".as_bytes().to_vec(),
            b"# p\xf8\xedklad #\n2 9 x\xf8".to_vec(),
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
        assert_eq!(f.encode(&f.text), bytes);
    }

    #[test]
    fn a_byte_order_mark_is_no_column() {
        let f = SourceFile::new("a", "\u{feff}2 9 1".into());
        let p = f.position(3);
        assert_eq!((p.offset, p.line, p.column), (3, 1, 1));
    }
}

//! What must come of a file. The rules are written out here a second time, and tokens are cut in a
//! simpler way: words between white space.

use zpg::internals::analysis::Analysis;
use zpg::internals::analysis::fixing::to_fixed_point;
use zpg::internals::diagnostics::SourceFile;
use zpg::internals::format::{Options, format};
use zpg::internals::syntax::lexer::SEPARATORS;
use zpg::internals::syntax::{in_records, parse, preserved, recognise};

/// What the tools make of a file, and what is wrong with that.
pub struct Verdict {
    pub is_scene: bool,
    /// Whether nothing stands in the way of writing it.
    pub is_written: bool,
    pub formatted: Vec<u8>,
    pub fixed: Vec<u8>,
    pub wrong: Vec<String>,
}

pub const FORMATTED: fn(&Verdict) -> &Vec<u8> = |v| &v.formatted;
pub const FIXED: fn(&Verdict) -> &Vec<u8> = |v| &v.fixed;

/// `is_scene` is whether the file was made as a scene, where that is known.
pub fn foresee(bytes: &[u8], is_scene: Option<bool>) -> Verdict {
    let mut verdict = Verdict {
        is_scene: true,
        is_written: true,
        formatted: bytes.to_vec(),
        fixed: bytes.to_vec(),
        wrong: Vec::new(),
    };
    let read = recognise::parse("a.zpg", bytes.to_vec());
    // Mutations may leave fewer than a third of the lines of a scene with a number at their beginning.
    let expected = match known(bytes) {
        Some(false) => Some(false),
        _ => is_scene,
    };
    if expected.is_some_and(|expected| expected != read.is_ok()) {
        let what = match &read {
            Ok(_) => "taken for a scene".to_owned(),
            Err(stranger) => format!("taken for no scene: {:?}", stranger.finding),
        };
        verdict.wrong.push(what);
    }
    let Ok((source, document)) = read else {
        verdict.is_scene = false;
        return verdict;
    };
    let text = format(&source.text, &document, &Options::default());
    if text != source.text {
        if !preserved::by_layout((&source.text, &document), &text) {
            verdict.wrong.push("formatting would be refused".to_owned());
        }
        let difference = difference(&words(&source.text), &words(&text));
        verdict
            .wrong
            .extend(difference.map(|d| format!("fmt: {d}")));
        match written(&source, &text) {
            Some(bytes) => verdict.formatted = bytes,
            None => verdict.is_written = false,
        }
    }

    let old = source.text.clone();
    let mended = to_fixed_point(Analysis::of(source), false, Analysis::of);
    let source = &mended.analysis.source;
    let mut text = old;
    for edits in &mended.rounds {
        let edits: Vec<_> = (edits.iter())
            .map(|e| (e.span.range(), e.text.as_str()))
            .collect();
        let new = apply(&text, &edits);
        if let Some(word) = lost(&text, &edits, &new) {
            verdict.wrong.push(format!("check --fix changes {word:?}"));
        }
        text = new;
    }
    if text != source.text {
        let what = "check --fix changes more than it lists";
        verdict.wrong.push(what.to_owned());
    }
    if mended.count > 0 {
        match written(source, &text) {
            Some(bytes) => verdict.fixed = bytes,
            None => verdict.is_written = false,
        }
    }
    verdict
}

/// The bytes of a scene with another text, if it is a scene still.
fn written(scene: &SourceFile, text: &str) -> Option<Vec<u8>> {
    let bytes = scene.encode(text)?;
    let is_scene =
        recognise::is_scene(text) && in_records::by_records(text, &parse(text).0).is_none();
    is_scene.then(|| bytes.into_owned())
}

/// Whether a file is a scene, where that does not depend on which `#` closes which or on a format.
fn known(bytes: &[u8]) -> Option<bool> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return None;
    }
    // What fills a block of a disk is no part of the text.
    let text = bytes
        .iter()
        .rposition(|&b| b != 0)
        .map_or(0, |last| last + 1);
    let bytes = &bytes[..text];
    if bytes.contains(&0) {
        let every_other = (0..2).any(|i| {
            bytes.iter().skip(i).step_by(2).filter(|b| **b == 0).count() * 4 > bytes.len()
        });
        return (!every_other).then_some(false);
    }
    let control = |b: u8| b < 32 && !matches!(b, 9..=13) || b == 127;
    let controls = bytes.iter().filter(|&&b| control(b)).count();
    if controls > usize::from(bytes.ends_with(&[0x1a])) + bytes.len() / 100 {
        return Some(false);
    }
    // Every byte a character: only ASCII matters here.
    let text: String = bytes.iter().map(|&b| char::from(b)).collect();
    if text.contains([
        '#', '\u{1a}', '\u{80}', '\u{85}', '\u{a0}', '\u{e2}', '\u{ef}',
    ]) || text.trim_start().starts_with(['{', '['])
    {
        return None;
    }
    let (mut all, mut numbers) = (0, 0);
    for line in text.split(['\n', '\r']) {
        let line = line.trim();
        let comment = ["//", ";", "--", "/*"].iter().any(|c| line.starts_with(c));
        if !line.is_empty() && !comment {
            all += 1;
            let word =
                line.split(|c: char| c.is_whitespace() || c == '"' || SEPARATORS.contains(&c));
            let word = word.into_iter().next().unwrap_or_default();
            // Such a number may be malformed.
            if !word.is_ascii() {
                return None;
            }
            let digits = word.trim_start_matches(['+', '-']);
            let begins = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
            numbers += usize::from(begins && word.parse::<f64>().is_ok());
        }
    }
    if 3 * numbers < all {
        return Some(false);
    }
    // A known format may be behind it all the same.
    None
}

/// The words of a text. A `#` is one by itself, notation marks are none, and what a `"` opens need not stand apart.
fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let blank = |c: char| c.is_whitespace() || c == '\u{feff}' || SEPARATORS.contains(&c);
    for piece in text.split(blank) {
        for (i, part) in piece.split('#').enumerate() {
            words.extend((i > 0).then_some("#"));
            let (before, quoted) = part.split_at(part.find('"').unwrap_or(part.len()));
            words.extend([before, quoted].into_iter().filter(|w| !w.is_empty()));
        }
    }
    words
}

/// The first word that is not there any more, or new: a number of the same value is the same, and a
/// `0` before a comment may go.
fn difference(old: &[&str], new: &[&str]) -> Option<String> {
    let bits = |word: &str| {
        let number = word.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        number
            .then(|| word.parse::<f64>().ok().map(f64::to_bits))
            .flatten()
    };
    let mut new = new.iter().peekable();
    for (i, word) in old.iter().enumerate() {
        let same =
            |other: &&&str| *other == word || bits(word).is_some() && bits(word) == bits(other);
        // Not `-0`, whose bits are others.
        let may_go = bits(word) == Some(0) && old.get(i + 1) == Some(&"#");
        if new.next_if(same).is_none() && !may_go {
            return Some(format!("{word:?} becomes {:?}", new.peek()));
        }
    }
    new.next().map(|word| format!("{word:?} is new"))
}

fn apply(text: &str, edits: &[(std::ops::Range<usize>, &str)]) -> String {
    let mut new = String::new();
    let mut at = 0;
    for (place, with) in edits {
        assert!(at <= place.start, "edits are in order");
        new += &text[at..place.start];
        new += with;
        at = place.end;
    }
    new + &text[at..]
}

/// A word that no edit touches and that is not there any more, where it should be.
fn lost(old: &str, edits: &[(std::ops::Range<usize>, &str)], new: &str) -> Option<String> {
    let mut moved = 0i64;
    let mut edits = edits.iter().peekable();
    let mut at = 0;
    for word in old.split_inclusive(char::is_whitespace) {
        let start = at;
        at += word.len();
        let word = word.trim_end_matches(char::is_whitespace);
        let end = start + word.len();
        let mut touched = false;
        while let Some((place, with)) = edits.peek() {
            if place.start > end {
                break;
            }
            touched |= place.end >= start;
            if place.end > end {
                // It may touch the next word too.
                break;
            }
            moved += with.len() as i64 - place.len() as i64;
            edits.next();
        }
        if touched || word.is_empty() {
            continue;
        }
        let start = (start as i64 + moved) as usize;
        let there = new.get(start..start + word.len()) == Some(word);
        let apart = |c: Option<char>| c.is_none_or(char::is_whitespace);
        if !there
            || !apart(new[..start].chars().next_back())
            || !apart(new[start + word.len()..].chars().next())
        {
            return Some(word.to_owned());
        }
    }
    None
}

//! Showing how a file would change, as a unified diff, or has changed, line by line.

use std::fmt::Write;
use std::ops::Range;

use clap::builder::styling::AnsiColor;
use imara_diff::{Diff, Hunk, InternedInput, Token};
use rustc_hash::FxHashMap;

use crate::format::difference;

/// The number of unchanged lines around each change.
const AROUND: u32 = 3;

/// The hunks of a unified diff, as `patch` and git read them.
fn hunks(input: &InternedInput<&str>, diff: &Diff) -> String {
    let mut all: Vec<Vec<Hunk>> = Vec::new();
    for hunk in diff.hunks() {
        match all
            .last_mut()
            .and_then(|group| Some((group.last()?.before.end, group)))
        {
            // The unchanged lines around the two hunks would overlap, so that the hunks become one.
            Some((end, group)) if hunk.before.start - end <= 2 * AROUND => group.push(hunk),
            _ => all.push(vec![hunk]),
        }
    }
    let mut out = String::new();
    let write = |out: &mut String, mark: char, tokens: &[Token]| {
        for &token in tokens {
            let line = input.interner[token];
            let end = match line.ends_with('\n') {
                true => "",
                false => "\n\\ No newline at end of file\n",
            };
            out.extend([mark.encode_utf8(&mut [0; 4]), line, end]);
        }
    };
    let kept = |range: Range<u32>| &input.before[range.start as usize..range.end as usize];
    for group in &all {
        let [Some(first), Some(last)] = [group.first(), group.last()] else {
            continue;
        };
        let above = first.before.start.min(AROUND);
        let below = (input.before.len() as u32 - last.before.end).min(AROUND);
        let around = |of: fn(&Hunk) -> &Range<u32>| of(first).start - above..of(last).end + below;
        let (old, new) = (around(|h| &h.before), around(|h| &h.after));
        // Writing to a string cannot fail.
        let _ = writeln!(out, "@@ -{} +{} @@", place(&old), place(&new));
        let mut at = old.start;
        for hunk in group {
            write(&mut out, ' ', kept(at..hunk.before.start));
            write(&mut out, '-', kept(hunk.before.clone()));
            write(
                &mut out,
                '+',
                &input.after[hunk.after.start as usize..hunk.after.end as usize],
            );
            at = hunk.before.end;
        }
        write(&mut out, ' ', kept(at..old.end));
    }
    out
}

/// The lines of a range as the head of a hunk names them: the first line, from 1, and the number of lines. A range
/// without lines is named by the line before it.
fn place(lines: &Range<u32>) -> String {
    match lines.len() {
        0 => format!("{},0", lines.start),
        1 => format!("{}", lines.start + 1),
        n => format!("{},{n}", lines.start + 1),
    }
}

/// Writes a unified diff.
pub(super) fn diff(out: &mut Vec<u8>, path: &str, old: &str, new: &str, colour: bool) {
    let input = InternedInput::new(old, new);
    let hunks = hunks(&input, &difference::of(&input));
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

/// A change in a line.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Change<'t> {
    /// The number of the line in the new text, from 1. For a line that is gone, the number of the line that stands
    /// there now.
    pub line: usize,
    /// The old text of the line, without the words that `old` and `new` both begin or end with. Empty if the line is
    /// new; `new` is empty if the line is gone.
    pub old: &'t str,
    pub new: &'t str,
}

/// The changed lines of a text, in the order of the new lines.
pub(super) fn changes<'t>(old: &'t str, new: &'t str) -> Vec<Change<'t>> {
    let input = InternedInput::new(old, new);
    let diff = difference::of(&input);
    let (before, after): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let mut all = Vec::new();
    for hunk in diff.hunks() {
        let [old, new] = [hunk.before, hunk.after].map(|r| r.start as usize..r.end as usize);
        let first = 1 + new.start;
        for (at, old, new) in pairs(&before[old], &after[new]) {
            let (old, new) = without_common(old, new);
            if (old, new) != ("", "") {
                let line = first + at;
                all.push(Change { line, old, new });
            }
        }
    }
    all
}

/// Pairs old lines with new ones: lines that begin with the same word, as records do with their ID, and the lines that
/// are left between them, in order. Each pair comes with the number of new lines before it. An empty text stands for a
/// missing line.
fn pairs<'t>(old: &[&'t str], new: &[&'t str]) -> Vec<(usize, &'t str, &'t str)> {
    let id = |line: &'t str| line.split_whitespace().next().unwrap_or_default();
    // The number of lines that begin with each word.
    let count = |lines: &[&'t str]| {
        let mut all: FxHashMap<&str, usize> = FxHashMap::default();
        lines
            .iter()
            .for_each(|l| *all.entry(id(l)).or_default() += 1);
        all
    };
    let (mut left, mut to_come) = (count(old), count(new));
    let has = |words: &FxHashMap<&str, usize>, word: &str| words.get(word).is_some_and(|&n| n > 0);
    let take = |words: &mut FxHashMap<&'t str, usize>, line: &'t str| {
        words
            .entry(id(line))
            .and_modify(|n| *n = n.saturating_sub(1));
    };
    let (mut i, mut j) = (0, 0);
    let mut all = Vec::new();
    while i < old.len() || j < new.len() {
        let (was, now) = (old.get(i).copied(), new.get(j).copied());
        let are_one = match (was, now) {
            (Some(was), Some(now)) => id(was) == id(now),
            _ => false,
        };
        let stays = was.is_some_and(|was| has(&to_come, id(was)));
        let is_old = now.is_some_and(|now| has(&left, id(now)));
        let (was, now) = match (was, now) {
            _ if are_one => (was, now),
            (_, Some(_)) if stays => (None, now),
            (Some(_), _) if is_old => (was, None),
            _ => (was, now),
        };
        all.push((j, was.unwrap_or_default(), now.unwrap_or_default()));
        if let Some(was) = was {
            take(&mut left, was);
            i += 1;
        }
        if let Some(now) = now {
            take(&mut to_come, now);
            j += 1;
        }
    }
    all
}

/// Two texts without the words that both begin with and end with.
fn without_common<'t>(old: &'t str, new: &'t str) -> (&'t str, &'t str) {
    let (mut old, mut new) = (old.trim(), new.trim());
    let first = |text: &'t str| text.split_once(char::is_whitespace).unwrap_or((text, ""));
    while !old.is_empty() && first(old).0 == first(new).0 {
        (old, new) = (first(old).1.trim_start(), first(new).1.trim_start());
    }
    let last = |text: &'t str| match text.rsplit_once(char::is_whitespace) {
        Some((rest, word)) => (rest, word),
        None => ("", text),
    };
    while !old.is_empty() && last(old).1 == last(new).1 {
        (old, new) = (last(old).0.trim_end(), last(new).0.trim_end());
    }
    (old, new)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(old: &str, new: &str) -> Vec<String> {
        let tell = |c: &Change| format!("{}: {} → {}", c.line, c.old, c.new);
        changes(old, new).iter().map(tell).collect()
    }

    #[test]
    fn heads_of_hunks_are_where_their_lines_are() {
        let lines = |changed: &[usize]| {
            let line = |i| match changed.contains(&i) {
                true => format!("{i} new\n"),
                false => format!("{i}\n"),
            };
            (1..=20).map(line).collect::<String>()
        };
        for changed in (1..=20).flat_map(|i| (i..=20).map(move |j| [i, j])) {
            let (old, new) = (lines(&[]), lines(&changed));
            let mut out = Vec::new();
            diff(&mut out, "a.zpg", &old, &new, false);
            let text = String::from_utf8(out).unwrap();
            for hunk in text.split("@@ -").skip(1) {
                let (head, body) = hunk.split_once('\n').unwrap();
                let [start, count] = head.split([',', ' ']).collect::<Vec<_>>()[..2] else {
                    panic!("{head}");
                };
                let kept: Vec<&str> = (body.lines())
                    .filter_map(|l| l.strip_prefix([' ', '-']))
                    .collect();
                let at: usize = start.parse().unwrap();
                assert_eq!(kept.len().to_string(), count, "{text}");
                let all: Vec<&str> = old.lines().collect();
                assert_eq!(&all[at - 1..at - 1 + kept.len()], kept, "{text}");
            }
        }
    }

    #[test]
    fn lines_are_those_of_the_file_as_it_is_now() {
        let old = "2 9 0,5  # a #\n50 -402 1 4 6 5\n3 9 1\ngone\n4 9 1 # x #\n";
        let new = "2 9 0.5  # a #\n50 -402 1\n50 -1 4 6 5\n3 9 1\n4 9 1.5 # x #\n";
        assert_eq!(
            told(old, new),
            [
                "1: 0,5 → 0.5",
                "2: 4 6 5 → ",
                "3:  → 50 -1 4 6 5",
                "5: gone → ",
                "5: 1 → 1.5"
            ]
        );
        // The record that one has become two of moves those below it.
        let old = "50 -402 1 4 6 5\n2 9 0,5\n3 14 1 3\n";
        let new = "50 -402 1\n50 -1 4 6 5\n2 9 0.5\n3 14 3 1\n";
        assert_eq!(
            told(old, new),
            [
                "1: 4 6 5 → ",
                "2:  → 50 -1 4 6 5",
                "3: 0,5 → 0.5",
                "4: 1 3 → 3 1"
            ]
        );
        assert_eq!(told("2 9 1\n", "20 9 1\n"), ["1: 2 → 20"]);
        assert_eq!(told("a\nb\nc\n", "a\nc\n"), ["2: b → "]);
        assert_eq!(told("a\n", "a\nb\n"), ["2:  → b"]);
        assert_eq!(told("a b\r\n", "a b\n"), Vec::<String>::new());
        assert_eq!(told("a\n", "a\n"), Vec::<String>::new());
    }
}

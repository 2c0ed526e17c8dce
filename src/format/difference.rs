//! The lines of a text that are still there when it is printed anew.
//!
//! Where many lines are equal, the usual algorithms take time in proportion to the square of the number of changed
//! lines. In scenes many lines are equal: a hundred thousand lines took half a minute. So a long text is compared in
//! blocks of a few hundred lines. Blocks with as many words before them belong together, since printing a text anew
//! moves words to other lines, but keeps their number and order.

use std::ops::Range;

use imara_diff::{Algorithm, Diff, InternedInput, Token};

/// The number of old lines in a block.
const BLOCK_LINES: usize = 250;
/// The most changed lines of texts that are compared as a whole.
const MAX_LINES_COMPARED_AT_ONCE: usize = 2000;
/// The next block is looked for within this many lines of the line where it is guessed to begin.
const MAX_GUESS_ERROR: usize = 50;
/// How many lines must be alike where two blocks begin.
const AGREEING_LINES: usize = 2;

/// Compares two texts, line by line.
pub fn of(input: &InternedInput<&str>) -> Diff {
    let (before, after) = (&input.before[..], &input.after[..]);
    let start = common(before.iter().zip(after));
    let most = before.len().min(after.len()) - start;
    let end = common(before.iter().rev().zip(after.iter().rev())).min(most);
    let changed = [before, after].map(|lines| start..lines.len() - end);
    let mut diff = match changed
        .iter()
        .all(|lines| lines.len() <= MAX_LINES_COMPARED_AT_ONCE)
    {
        true => Diff::compute(Algorithm::Histogram, input),
        false => in_blocks(input, changed),
    };
    diff.postprocess_lines(input);
    diff
}

/// The number of equal pairs before the first unequal one.
fn common<'t>(pairs: impl Iterator<Item = (&'t Token, &'t Token)>) -> usize {
    pairs.take_while(|(a, b)| a == b).count()
}

/// Compares the lines in the ranges of the old and the new text block by block. The lines outside of them are equal.
fn in_blocks(input: &InternedInput<&str>, changed: [Range<usize>; 2]) -> Diff {
    let [old, new] = changed;
    // Every line gets a label. A line that stays has the same label in both texts, and all other labels differ, so the
    // final comparison finds just the lines that stay.
    let mut next = 0;
    let mut fresh = || {
        next += 1;
        Token(next - 1)
    };
    let mut labels = [&input.before, &input.after].map(|lines| vec![Token(u32::MAX); lines.len()]);
    let [before, after] = &mut labels;
    let ends = (old.end..before.len()).zip(new.end..after.len());
    for (i, j) in (0..old.start).zip(0..new.start).chain(ends) {
        let label = fresh();
        (before[i], after[j]) = (label, label);
    }
    for [old, new] in blocks(input, old, new) {
        let mut block = Diff::default();
        let (a, b) = (&input.before[old.clone()], &input.after[new.clone()]);
        block.compute_with(Algorithm::Histogram, a, b, input.interner.num_tokens());
        let kept = (old.clone()).filter(|i| !block.is_removed((i - old.start) as u32));
        let there = (new.clone()).filter(|j| !block.is_added((j - new.start) as u32));
        for (i, j) in kept.zip(there) {
            let label = fresh();
            (before[i], after[j]) = (label, label);
        }
    }
    for label in before.iter_mut().chain(after.iter_mut()) {
        if label.0 == u32::MAX {
            *label = fresh();
        }
    }
    let mut diff = Diff::default();
    diff.compute_with(Algorithm::Myers, before, after, next);
    diff
}

/// Cuts the lines in the ranges of the old and the new text into pairs of blocks.
fn blocks(
    input: &InternedInput<&str>,
    old: Range<usize>,
    new: Range<usize>,
) -> Vec<[Range<usize>; 2]> {
    let text = |line: &Token| input.interner[*line];
    let before: Vec<&str> = input.before[old.clone()].iter().map(text).collect();
    let after: Vec<&str> = input.after[new.clone()].iter().map(text).collect();
    let (words_before, words_after) = (words(&before), words(&after));
    let mut out = Vec::new();
    let (mut i, mut j) = (0, 0);
    // How many more words stand before the block in the new text than in the old one.
    let mut drift = 0;
    while before.len() - i > BLOCK_LINES && j < after.len() {
        let next = i + BLOCK_LINES;
        let wanted = words_before[next].saturating_add_signed(drift);
        let guess = words_after.partition_point(|&words| words < wanted);
        let nearest =
            (0..MAX_GUESS_ERROR).flat_map(|k| [guess.checked_add(k), guess.checked_sub(k + 1)]);
        let says_the_same = |&line: &usize| {
            line >= j
                && (0..AGREEING_LINES).all(|k| is_alike(before.get(next + k), after.get(line + k)))
        };
        let found = nearest.flatten().find(says_the_same);
        if let Some(line) = found.filter(|&line| line < after.len()) {
            drift = words_after[line] as isize - words_before[next] as isize;
        }
        let line = found.unwrap_or(guess).clamp(j, after.len());
        out.push([
            old.start + i..old.start + next,
            new.start + j..new.start + line,
        ]);
        (i, j) = (next, line);
    }
    out.push([old.start + i..old.end, new.start + j..new.end]);
    out
}

/// The number of words before each line. No `0` is counted, since the formatter may drop one before a comment.
fn words(lines: &[&str]) -> Vec<usize> {
    let mut sum = 0;
    let count = |line: &str| line.split_whitespace().filter(|word| *word != "0").count();
    let before = |line: &&str| {
        sum += count(line);
        sum - count(line)
    };
    lines.iter().map(before).collect()
}

/// Whether two lines have the same letters and digits, apart from zeros.
fn is_alike(a: Option<&&str>, b: Option<&&str>) -> bool {
    let signs = |line: &str| -> Vec<u8> {
        let counts = |b: &u8| b.is_ascii_alphanumeric() && *b != b'0';
        line.bytes().filter(counts).collect()
    };
    a.map(|line| signs(line)) == b.map(|line| signs(line))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from 0 to `below`, the same ones each time.
    fn random(seed: &mut u64, below: u64) -> u64 {
        *seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (*seed >> 33) % below
    }

    /// Texts of many equal lines, and what might become of them. Of `kinds` different lines, one in `changed` changes.
    fn texts(lines: usize, kinds: u64, changed: u64) -> (String, String) {
        let (mut old, mut new) = (String::new(), String::new());
        let mut seed = kinds + changed;
        for _ in 0..lines {
            let id = random(&mut seed, kinds);
            let blank = ["\n", "\n\n\n", "\n"][random(&mut seed, 3) as usize];
            match random(&mut seed, changed) {
                0 => {
                    old += &format!("{id}   -1 0 0 1.50{blank}");
                    new += &format!("{id} -1  0 0 1.5\n");
                }
                _ => {
                    let line = format!("{id} -1  0 0 1\n");
                    old += &line;
                    new += &line;
                }
            }
        }
        (old, new)
    }

    /// The second text, made of the first one and the difference; and how many lines are said to go or to come.
    fn applied(old: &str, new: &str) -> (String, usize) {
        let input = InternedInput::new(old, new);
        let diff = of(&input);
        let mut out = String::new();
        let (mut at, mut changed) = (0, 0);
        for hunk in diff.hunks() {
            for line in at..hunk.before.start as usize {
                out += input.interner[input.before[line]];
            }
            for line in hunk.after.clone() {
                out += input.interner[input.after[line as usize]];
            }
            at = hunk.before.end as usize;
            changed += hunk.before.len() + hunk.after.len();
        }
        for line in &input.before[at..] {
            out += input.interner[*line];
        }
        (out, changed)
    }

    #[test]
    fn the_difference_makes_one_text_of_the_other() {
        for (lines, kinds, changed) in [
            (10, 3, 2),
            (5000, 1, 1),
            (5000, 5, 1),
            (5000, 5, 2),
            (5000, 1000, 3),
            (20_000, 5, 1000),
        ] {
            let (old, new) = texts(lines, kinds, changed);
            for (old, new) in [(&old, &new), (&new, &old)] {
                assert!(applied(old, new).0 == *new, "{lines} {kinds} {changed}");
            }
        }
        let long = "a\n".repeat(5000);
        for other in [
            "",
            "b\n",
            "a\n",
            &"b\n".repeat(5000),
            &("b\n".to_owned() + &long),
        ] {
            assert!(applied(&long, other).0 == other);
            assert!(applied(other, &long).0 == long);
        }
    }

    /// Cut into blocks it says hardly more than without.
    #[test]
    fn lines_that_stay_are_found() {
        for (kinds, changed) in [(5, 2), (5, 30), (1000, 3)] {
            let (old, new) = texts(4000, kinds, changed);
            let input = InternedInput::new(&old[..], &new[..]);
            let whole = Diff::compute(Algorithm::Myers, &input);
            let least = (whole.count_additions() + whole.count_removals()) as usize;
            let said = applied(&old, &new).1;
            assert!(
                10 * said <= 11 * least,
                "{kinds} {changed}: {said} for {least}"
            );
        }
    }
}

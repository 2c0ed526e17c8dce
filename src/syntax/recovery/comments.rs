//! Pairs of `#` that open and close comments.
//!
//! Comments do not nest, so one forgotten `#` pairs with the next comment's opening one and turns
//! every later comment inside out. Where the plain reading is in trouble, this finds the pairing
//! with the least damage: a walk over the lines with the states "in code" and "in a comment", where
//! text that cannot be code, records that would be hidden, and comments that are given up at their
//! line's end all have a price.

use super::super::hex;
use super::super::table::{RecordKind, RecordType};
use super::super::words;
use super::prices::{GARBAGE_LINE, HIDDEN, INSIDE_OUT, UNCLOSED};

/// The most hidden records of one comment that have a price.
const HIDDEN_MAX: usize = 2;

/// States: 0 is code, 1 + h a comment that has hidden h records so far.
const STATES: usize = 2 + HIDDEN_MAX;
const NEVER: u32 = u32::MAX / 2;

/// How a line was read, to walk back along the cheapest way.
#[derive(Clone, Copy, Default)]
struct BackPointer {
    from: u8,
    /// The `#` that is given up on this line, as its offset in the text + 1; 0 is none.
    unclosed: u32,
}

/// Finds each `#` that is given up: its comment is taken to end with its line. Returns the offsets, ascending.
pub(crate) fn unclosed(text: &str) -> Vec<u32> {
    let mut cost = [NEVER; STATES];
    cost[0] = 0;
    let mut steps: Vec<[BackPointer; STATES]> = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive(['\n', '\r']) {
        let mut next = [NEVER; STATES];
        let mut step = [BackPointer::default(); STATES];
        let mut offer = |to: usize, price: u32, from: usize, unclosed: Option<usize>| {
            if price < next[to] {
                next[to] = price;
                step[to] = BackPointer {
                    from: from as u8,
                    unclosed: unclosed.map_or(0, |o| (start + o) as u32 + 1),
                };
            }
        };
        let hashes = line.matches('#').count();
        for state in (0..STATES).filter(|&s| cost[s] < NEVER) {
            let reading = Reading::of(line, state);
            let price = cost[state].saturating_add(reading.price);
            if let Some(sign) = colour(line).filter(|_| state == 0 && reading.end_state != 0) {
                offer(0, cost[0], 0, Some(sign));
            }
            offer(reading.end_state, price, state, None);
            // Either of two comments may be given up: the one that is open at the line's end, or the first one on the
            // line.
            if reading.end_state != 0 && (state == 0 || hashes > 0) {
                offer(0, price.saturating_add(UNCLOSED), state, line.rfind('#'));
            }
            if state == 0 && hashes > 1 {
                let first = line.find('#').unwrap_or(0);
                let price = cost[0].saturating_add(garbage(&line[..first]));
                offer(0, price.saturating_add(UNCLOSED + 1), 0, Some(first));
            }
        }
        cost = next;
        steps.push(step);
        start += line.len();
    }
    // At the end of the text every comment must be closed or given up.
    let mut out = Vec::new();
    let mut state = 0;
    for step in steps.iter().rev() {
        let s = step[state];
        if s.unclosed > 0 {
            out.push(s.unclosed - 1);
        }
        state = s.from as usize;
    }
    out.reverse();
    out
}

/// Whether some `#` may begin a colour and no comment.
pub(crate) fn has_colour(text: &str) -> bool {
    memchr::memchr_iter(b'#', text.as_bytes()).any(|at| {
        let line = text[..at].rfind(['\n', '\r']).map_or(0, |end| end + 1);
        hex::at_start(&text[at..]).is_some() && begins_colour(&text[line..at])
    })
}

/// The `#` of a colour, `7 -701 #ff8000`, if it is the first one of a line: giving it up costs nothing.
fn colour(line: &str) -> Option<usize> {
    let at = line.find('#')?;
    hex::at_start(&line[at..])?;
    begins_colour(&line[..at]).then_some(at)
}

/// Whether a text is the ID and the type of a colour.
fn begins_colour(text: &str) -> bool {
    let mut words = text.split_whitespace();
    let (Some(id), Some(code), None) = (words.next(), words.next(), words.next()) else {
        return false;
    };
    let ty = code.parse().ok().and_then(RecordType::by_code);
    id.parse::<u32>().is_ok() && ty.is_some_and(|ty| ty.kind == RecordKind::Colour)
}

/// The reading of a line from one state on, in which each `#` in turn opens or closes a comment.
struct Reading {
    price: u32,
    end_state: usize,
}

impl Reading {
    fn of(line: &str, state: usize) -> Reading {
        let mut price = 0;
        let mut now = state;
        let before = line.split('#').next().unwrap_or(line);
        for (i, part) in line.split('#').enumerate() {
            let at_hash = now;
            if i > 0 {
                now = if now == 0 { 1 } else { 0 };
            }
            if now == 0 {
                let inside_out = i == 1 && (at_hash > 1 || at_hash == 1 && is_void(before));
                price = price.max(match garbage(part) {
                    0 => 0,
                    _ if inside_out => INSIDE_OUT,
                    garbage => garbage,
                });
            } else if i == 0 && now <= HIDDEN_MAX && looks_like_a_record(part) {
                price += HIDDEN;
                now += 1;
            }
        }
        Reading {
            price,
            end_state: now,
        }
    }
}

/// The price of a part of a line as code: 0 if it begins a record or if all of its words begin like numbers, else
/// [`GARBAGE_LINE`].
fn garbage(part: &str) -> u32 {
    // Words that begin like numbers may be code.
    let is_code = |w: &str| {
        let unsigned = w.trim_start_matches(['+', '-', '.']);
        unsigned.starts_with(|c: char| c.is_ascii_digit())
    };
    // A word among the numbers of a record is an error whichever `#` closes which.
    if begins_a_record(part) || part.split_whitespace().all(is_code) {
        0
    } else {
        GARBAGE_LINE
    }
}

/// Whether a stretch of text is nothing, or the `0` in front of a comment.
fn is_void(part: &str) -> bool {
    matches!(part.trim(), "" | "0")
}

/// Whether a stretch of text begins with an ID, a type or its name, and something else.
fn begins_a_record(part: &str) -> bool {
    let mut words = part.split_whitespace();
    let (Some(id), Some(ty), Some(_)) = (words.next(), words.next(), words.next()) else {
        return false;
    };
    let dashed = ty.strip_prefix(['−', '–', '—', '‑', '‐']);
    let ty = dashed.map_or(ty.to_owned(), |digits| format!("-{digits}"));
    let is_type = match ty.parse() {
        Ok(code) => RecordType::by_code(code).is_some(),
        // A letter in the place of a digit.
        Err(_) => {
            ty.len() > 1 && ty.contains(|c: char| c == '-' || c.is_ascii_digit())
                || words::is_name(&ty)
        }
    };
    is_type && id.parse::<u32>().is_ok_and(|id| id > 0)
}

/// Whether a stretch of comment begins as a record, or is three numbers or more, the first two of them integers.
fn looks_like_a_record(part: &str) -> bool {
    if begins_a_record(part) {
        return true;
    }
    let mut words = part.split_whitespace();
    let id = words.next().is_some_and(|w| w.parse::<u32>().is_ok());
    let code = words.next().is_some_and(|w| w.parse::<i32>().is_ok());
    let mut rest = words.peekable();
    id && code && rest.peek().is_some() && rest.all(|w| w.parse::<f64>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines (from 1) whose comment is given up.
    fn lines(text: &str) -> Vec<usize> {
        unclosed(text)
            .iter()
            .map(|&o| text[..o as usize].matches('\n').count() + 1)
            .collect()
    }

    #[test]
    fn balanced_texts_are_left_alone() {
        assert!(lines("2 9 1 # a # \n# b\nc # 3 9 2\n").is_empty());
        assert!(lines("# 2 9 1\n3 9 1\n4 9 1\n5 9 1 #\n6 9 1 # x #\n").is_empty());
    }

    #[test]
    fn the_line_of_the_forgotten_sign() {
        assert_eq!(lines("2 9 1 # a\n3 9 2 # b #\n4 9 1 # c #\n"), [1]);
        assert_eq!(lines("2 9 1 # a #\n3 9 2 # b \n4 9 1 # c #\n"), [2]);
        assert_eq!(lines("2 9 1 # a #\n3 9 2 # b #\n4 9 1 # c \n"), [3]);
    }

    #[test]
    fn among_comments_over_several_lines() {
        let text = "# head\n more #\n2 9 1 # a\n3 9 2 # b #\n# tail\n end #\n4 9 1\n";
        assert_eq!(lines(text), [3]);
        let text = "# 2 9 1\n3 9 2\n4 9 3\n5 9 1 #\n6 9 1 # x\n7 9 1 # y #\n";
        assert_eq!(lines(text), [5]);
    }

    #[test]
    fn a_sign_for_the_rest_of_the_line() {
        for n in 2..12 {
            let text: String = (0..n)
                .map(|i| format!("{} 11 {i} 0 0 1 # ball\n", i + 2))
                .collect();
            let all: Vec<usize> = (1..=n).collect();
            assert_eq!(lines(&format!("{text}40 -101 2 3\n")), all);
            // With headings, and with comments that are closed.
            let text: String = (0..n)
                .map(|i| format!("# ball\n{} 11 {i} 0 0 1\n", i + 2))
                .collect();
            let all: Vec<usize> = (0..n).map(|i| 2 * i + 1).collect();
            assert_eq!(lines(&text), all);
            assert!(lines(&text.replace("ball", "ball #")).is_empty());
        }
    }

    #[test]
    fn a_record_with_a_mistake_is_one() {
        for record in [
            "2 -701 rgb 1 0 0",
            "2 -701 red",
            "2 sphere 0 0 0 1",
            "2 koule 0 0 0 x",
        ] {
            let all = "# floor\n3 9 1\n# red\n?\n# ball\n4 9 1\n# all\n5 -101 3 4\n";
            assert_eq!(lines(&all.replace('?', record)), [1, 3, 5, 7], "{record}");
            let all = "3 9 1 # floor\n? # red\n4 9 1 # ball\n5 -101 3 4 # all\n";
            assert_eq!(lines(&all.replace('?', record)), [1, 2, 3, 4], "{record}");
        }
    }

    #[test]
    fn signs_for_the_rest_of_neighbouring_lines() {
        assert_eq!(lines("2 9 1 # a\n# b\n4 9 1\n"), [1, 2]);
        assert_eq!(lines("0 # a\n0 # b\n4 9 1\n"), [1, 2]);
        assert_eq!(lines("# a\n\n# b\n# c\n4 9 1\n"), [1, 3, 4]);
        assert_eq!(lines("# a\n# b\n# c #\n4 9 1\n"), [1, 2]);
        let banner = "#-----\n# Title\n#-----\n";
        assert_eq!(lines(&format!("{banner}2 9 1\n")), [1, 2, 3]);
        assert_eq!(lines(&format!("{banner}2 9 1 # a #\n3 9 1\n")), [1, 2, 3]);
        let two = format!("{banner}2 9 1\n{}3 9 1\n", banner.replace("Title", "b"));
        assert_eq!(lines(&two), [1, 2, 3, 5, 6, 7]);
        // A comment over several lines, and one more word.
        assert!(lines("# a\n b\n # c\n2 9 1\n").is_empty());
    }

    #[test]
    fn a_stray_sign() {
        assert_eq!(lines("2 9 1 # a #\n3 # 9 2 # b #\n4 9 1 # c #\n"), [2]);
    }
}

//! Definitions below what uses them, and IDs of one record in each other's places.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic};

use super::rules::{SCENE, with};
use super::scenes::{Record, text};
use super::{WRITERS, read, values};
use crate::rng::Rng;
use crate::support::{cases, seeds};

fn errors(text: &str) -> Vec<Diagnostic> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).collect()
}

fn mended(text: &str, unsafe_too: bool) -> String {
    let mended = fixing::to_fixed_point(read(text), unsafe_too, Analysis::of);
    mended.analysis.source.text
}

/// The lines of a text, in no order.
fn sorted(text: &str) -> Vec<&str> {
    let mut lines: Vec<&str> = text.lines().filter(|l| !l.is_empty()).collect();
    lines.sort_unstable();
    lines
}

/// A record, and what changes it right behind it, is moved below the first record that uses it: the proposal is to move
/// one of the two, never to use something else, and mends the scene.
#[test]
fn a_definition_below_what_uses_it() {
    let (mut count, mut safe) = (0, 0);
    for seed in seeds("PEOPLE_ORDER", cases(0..24, 0..200)) {
        for scene in WRITERS {
            let mut rng = Rng::new(seed);
            let records = scene(&mut rng, 8 + (seed as usize * 7) % 43);
            let is_operation = |r: &Record| matches!(r.code, -103..=-101);
            let users: Vec<usize> = (0..records.len())
                .filter(|&i| is_operation(&records[i]))
                .collect();
            if users.is_empty() {
                continue;
            }
            let user = *rng.pick(&users);
            let used = records[user].params[rng.below(2)].clone();
            let Some(first) = records.iter().position(|r| r.id.to_string() == used) else {
                continue;
            };
            let own = |r: &&Record| r.id == records[first].id;
            let block = records[first..].iter().take_while(own).count();
            // Only what nobody uses or changes in between can go below.
            let between = &records[first + block..user];
            if between
                .iter()
                .any(|r| r.id.to_string() == used || r.params.contains(&used))
            {
                continue;
            }
            let mut moved = records.clone();
            let part: Vec<Record> = moved.drain(first..first + block).collect();
            let at = user + 1 - block;
            moved.splice(at..at, part);
            let text = text(&moved);
            let errors = errors(&text);
            let d = &errors[0];
            assert_eq!(
                (errors.len(), d.code, d.case),
                (1, Code::E107, ""),
                "seed {seed}\n{text}"
            );
            let titles: Vec<&str> = d.fixes.iter().map(|f| f.title).collect();
            assert!(
                matches!(titles[..], ["fix" | "fix-down"]),
                "seed {seed}: {titles:?}\n{text}"
            );
            let is_safe = d.fixes[0].applicability == Applicability::Safe;
            let fixed = mended(&text, !is_safe);
            assert!(read(&fixed).is_sound(), "seed {seed}\n{text}\n{fixed}");
            assert_eq!(sorted(&fixed), sorted(&text), "seed {seed}");
            count += 1;
            safe += usize::from(is_safe);
        }
    }
    assert!(count >= 20 && 2 * safe > count, "{safe} of {count}");
}

#[test]
fn what_moves_takes_its_comment_along() {
    let rest = "50 -402 1\n50 -1 3 5 5\n9 -501 0 0 9 0 0 -1 0 1 0 45\n1 9999 4 0\n";
    let cases = [
        (
            "2 9 1\n4 -101 2 3\n\n0 # the ball #\n3 11 2 1 0 1 # red #\n3 -701 1 0 0\n\n",
            "2 9 1\n0 # the ball #\n3 11 2 1 0 1 # red #\n3 -701 1 0 0\n4 -101 2 3\n\n\n",
        ),
        // A heading of more stays where it is.
        (
            "2 9 1\n4 -101 2 3\n0 # colours and balls #\n3 11 2 1 0 1\n5 -701 1 0 0\n4 -299 5 0\n",
            "2 9 1\n3 11 2 1 0 1\n4 -101 2 3\n0 # colours and balls #\n5 -701 1 0 0\n4 -299 5 0\n",
        ),
        // A light, the camera and the render record are of no one's heading.
        (
            "2 9 1\n4 -101 2 3\n0 # the ball #\n3 11 2 1 0 1\n",
            "2 9 1\n0 # the ball #\n3 11 2 1 0 1\n4 -101 2 3\n",
        ),
        // What uses it keeps its own.
        (
            "2 9 1\n\n0 # both #\n4 -101 2 3\n\n0 # the ball #\n3 11 2 1 0 1\n\n",
            "2 9 1\n\n0 # the ball #\n3 11 2 1 0 1\n0 # both #\n4 -101 2 3\n\n\n",
        ),
    ];
    for (written, meant) in cases {
        for line_break in ["\n", "\r\n"] {
            let with = |part: &str| (part.to_owned() + rest).replace('\n', line_break);
            assert_eq!(mended(&with(written), false), with(meant));
        }
    }
    // The last line of a file, without an end.
    let text = "1 9999 4 0\n2 9 1\n4 -101 2 3\n3 11 2 1 0 1";
    assert_eq!(
        mended(text, false),
        "1 9999 4 0\n2 9 1\n3 11 2 1 0 1\n4 -101 2 3"
    );
}

/// Properties, changes and a use above a definition, with its ID: one finding, which moves the definition up.
#[test]
fn a_definition_below_its_properties_and_a_use() {
    let rest = "50 -402 1\n50 -1 3 5 5\n9 -501 0 0 9 0 0 -1 0 1 0 45\n1 9999 4 0\n";
    for property in ["-701 1 0 0", "-201 0.1 0.5 0", "-203 1.5 1.5 1.5"] {
        for changes in ["", "3 -1 2 0 0\n", "3 -2 30 1\n3 -1 2 0 0\n"] {
            let (above, below) = (format!("3 {property}\n{changes}"), "4 -101 2 3\n");
            let text = format!("2 11 -1 0 0 1\n{above}{below}3 9 1\n{rest}");
            let [d] = &errors(&text)[..] else {
                panic!("{text}");
            };
            assert_eq!(
                (d.code, d.case, d.fixes.len()),
                (Code::E107, "", 1),
                "{text}"
            );
            let meant = format!("2 11 -1 0 0 1\n3 9 1\n{above}{below}{rest}");
            assert_eq!(mended(&text, false), text);
            assert_eq!(mended(&text, true), meant);
        }
    }
    // What it is made of is above, and a comment goes along.
    let parts = "12 11 -1 0 0 1\n13 11 0 0 0 1\n2 12 -3 -3 -3 3 -1 3\n";
    let above = "14 -701 1 0 0\n14 -2 30 2\n14 -1 0 1 0\n";
    let (below, own) = ("4 -101 14 2\n", "0 # cut #\n14 -103 12 13\n");
    assert_eq!(
        mended(&[parts, above, below, own, rest].concat(), true),
        [parts, own, above, below, rest].concat()
    );
    // Where a part is defined below the properties, nothing is moved.
    let text = ["14 -701 1 0 0\n", parts, below, own, rest].concat();
    assert!(errors(&text).iter().all(|d| d.code != Code::E107));
}

/// It is a guess where a change in between, or after, has a say, or where others use it in its place.
#[test]
fn where_moving_is_a_guess() {
    for between in [
        // Of what the definition is made of.
        "4 -101 2 3\n2 -1 0 1 0\n3 -105 2\n",
        "4 -101 2 3\n3 -105 2\n2 -1 0 1 0\n3 -1 0 0 1\n",
        "4 -101 2 3\n3 9 3\n5 -101 4 3\n",
    ] {
        let text = format!("2 9 1\n{between}1 9999 4 0\n");
        let all = errors(&text);
        assert_eq!((all.len(), all[0].code), (1, Code::E107), "{text}");
        assert_eq!(
            all[0].fixes[0].applicability,
            Applicability::Unsafe,
            "{text}"
        );
        assert_eq!(mended(&text, false), text);
        assert!(read(&mended(&text, true)).is_sound(), "{text}");
    }
    // What the definition needs is in between: the record goes down. Not where somebody needs it there.
    let down = "2 9 1\n4 -101 2 3\n5 9 2\n3 -103 5 2\n1 9999 4 0\n";
    let meant = "2 9 1\n5 9 2\n3 -103 5 2\n4 -101 2 3\n1 9999 4 0\n";
    assert_eq!(mended(down, true), meant);
    let needed = down.replace("5 9 2\n", "5 9 2\n6 -105 4\n");
    assert_eq!(errors(&needed)[0].fixes, []);
}

/// All arrangements of the object, the texture and the optics of an assignment (-299): with both, and with one of them.
#[test]
fn an_assignment_in_any_order() {
    const ORDERS: [[usize; 3]; 5] = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    for meant in [["4", "2", "3"], ["4", "0", "3"], ["4", "2", "0"]] {
        let line = |ids: [&str; 3]| format!("{} -299 {} {}", ids[0], ids[1], ids[2]);
        // An optical property that nothing has would be the likelier one.
        let with = |line: &str| match meant[2] {
            "0" => with(4, line).replace("3 -201 0.6 0.3 0\n", ""),
            _ => with(4, line),
        };
        let right = with(&line(meant));
        for order in ORDERS {
            let written = line(order.map(|i| meant[i]));
            let text = with(&written);
            let all = errors(&text);
            assert_eq!(
                all.len(),
                1,
                "{written}: {:?}",
                all.iter().map(super::said).collect::<Vec<_>>()
            );
            let (fixed, _) =
                zpg::internals::diagnostics::fixes::apply(&text, all[0].fixes.first().into_iter());
            assert_eq!(
                values(&fixed),
                values(&right),
                "{written}: {:?}",
                super::said(&all[0])
            );
        }
    }
    assert_eq!(with(4, "4 -299 2 3"), SCENE);
}

/// An ID that is defined below as something that the record cannot change is not called undefined.
#[test]
fn what_is_defined_below_is_not_called_undefined() {
    for (line, kind, below) in [
        ("51 -1 0 5 0", "ambient light", "51 -401 0.2"),
        ("51 -2 30 1", "ambient light", "51 -401 0.2"),
        ("51 -601 0 0 0 1 1 1", "point light", "51 -402 1"),
    ] {
        let text = format!("2 11 0 0 0 1\n{line}\n{below}\n1 9999 2 0\n");
        let all = errors(&text);
        let found: Vec<Code> = all.iter().map(|d| d.code).collect();
        assert_eq!(found, [Code::E103], "{text}");
        assert!(
            super::said(&all[0])[0].contains(kind),
            "{:?}",
            super::said(&all[0])
        );
    }
    // Of what is moved and coloured the definition is missing.
    let found = errors("2 11 0 0 0 1\n51 -3 1 2 1\n51 -701 1 0 0\n1 9999 2 0\n");
    assert_eq!((found.len(), found[0].case), (1, "missing-lamp"));
    // What can be changed only stands in the wrong place.
    let found = errors("2 11 0 0 0 1\n51 -1 0 5 0\n51 -402 1\n1 9999 2 0\n");
    assert_eq!(
        (found.len(), found[0].code, found[0].case),
        (1, Code::E107, "changed")
    );
}

/// While another error hides which object is left over, none of several guesses at an operand is taken, and all are
/// listed. When the other error is mended, the right one is.
#[test]
fn of_several_guesses_none_is_taken() {
    // 7 is what is left over, and the colour lacks a number that nobody can guess.
    for (line, written) in [
        (11, "8 -101 4 77"),
        (11, "8 -101 14 7"),
        (10, "7 -103 6 15"),
    ] {
        let scene = with(line, written);
        let text = scene.replace("2 -701 1 0.5 0.2", "2 -701 1 0.5");
        let finding = errors(&text).into_iter().find(|d| d.code == Code::E101);
        let finding = finding.unwrap_or_else(|| panic!("{written}"));
        let is_choice =
            |f: &zpg::internals::diagnostics::Fix| f.applicability == Applicability::Choice;
        assert!(
            finding.fixes.len() > 1 && finding.fixes.iter().all(is_choice),
            "{written}"
        );
        assert_eq!(finding.notes, ["choose"]);
        let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
        assert_eq!(mended.analysis.source.text, text);
        let left = mended.findings.iter().find(|d| d.code == Code::E101);
        let edits = |d: &Diagnostic| d.fixes.iter().map(|f| f.edits.clone()).collect::<Vec<_>>();
        assert_eq!(left.map(edits), Some(edits(&finding)));
        assert_eq!(self::mended(&scene, true), super::rules::SCENE, "{written}");
    }
}

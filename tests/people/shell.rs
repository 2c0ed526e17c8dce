//! Comments as shells have them: a `#` for the rest of the line, and another mistake in the scene.

use zpg::internals::analysis::{Analysis, fixing};
use zpg::internals::diagnostics::Code;
use zpg::internals::syntax::lexer;

use super::{WRITERS, read, scenes, slips};
use crate::rng::Rng;
use crate::support::{cases, seeds};

const WORDS: [&str; 6] = [
    "floor",
    "red",
    "the big ball",
    "podlaha",
    "světlo 2",
    "everything",
];

/// A scene with such comments above its records or behind them, and the lines of its records.
fn scene(rng: &mut Rng, records: &[scenes::Record], at: usize, line: &str) -> (String, Vec<usize>) {
    let (mut text, mut signs) = (String::new(), Vec::new());
    let above = rng.chance(0.5);
    for (i, record) in records.iter().enumerate() {
        let own = if i == at {
            line.to_owned()
        } else {
            record.line()
        };
        let comment = format!("# {}", rng.pick(&WORDS));
        let number = text.matches('\n').count() + 1;
        if above {
            signs.push(number);
            text += &format!("{comment}\n{own}\n");
        } else if i != at {
            signs.push(number);
            text += &format!("{own} {comment}\n");
        } else {
            text += &format!("{own}\n");
        }
    }
    (text, signs)
}

/// The numbers of a text that are in no comment.
fn numbers(text: &str) -> Vec<String> {
    let tokens = lexer::lex(text, &[]);
    let numbers = tokens.iter().filter(|t| t.kind().is_numeric());
    numbers.map(|t| t.text(text).to_owned()).collect()
}

#[test]
fn each_comment_ends_with_its_line_whatever_else_is_wrong() {
    let (mut all, mut wrong) = (0, Vec::new());
    for seed in seeds("PEOPLE_SHELL", cases(0..12, 0..100)) {
        for writer in WRITERS {
            let mut rng = Rng::new(seed);
            let records = writer(&mut rng, 12);
            for slip in slips::ALL
                .iter()
                .filter(|s| !s.name.contains('#') && !s.name.starts_with('`'))
            {
                let at = rng.below(records.len());
                let Some(written) = (slip.make)(&mut rng, &records, at) else {
                    continue;
                };
                if written.line.contains(['#', '"']) {
                    continue;
                }
                let (text, signs) = scene(&mut rng, &records, at, &written.line);
                let analysis = read(&text);
                let found = analysis.findings().iter().filter(|d| d.code == Code::E002);
                let lines: Vec<usize> = (found)
                    .map(|d| analysis.source.position(d.span.start).line as usize)
                    .collect();
                all += 1;
                if lines != signs {
                    wrong.push(format!("{}\n{text}\n{lines:?}", slip.name));
                }
            }
        }
    }
    assert!(all > 100, "{all}");
    assert!(
        100 * wrong.len() <= all,
        "{} of {all}: {}",
        wrong.len(),
        wrong[..wrong.len().min(5)].join("\n")
    );
}

/// No number of another record ends in a comment.
#[test]
fn no_fix_hides_a_record() {
    let scene = "# floor\n3 3 0 1 0 0\n# red\n2 -701 rgb 1 0 0\n# ball\n4 11 0 1 0 1\n# all\n5 -101 3 4\n1 9999 5 0\n";
    for unsafe_too in [false, true] {
        let mended = fixing::to_fixed_point(read(scene), unsafe_too, Analysis::of);
        let text = &mended.analysis.source.text;
        let left = numbers(text);
        let all = numbers(
            &scene
                .lines()
                .filter(|l| !l.starts_with('#'))
                .collect::<Vec<_>>()
                .join("\n"),
        );
        let without = left.iter().filter(|n| *n != "0").count();
        assert_eq!(without, all.iter().filter(|n| *n != "0").count(), "{text}");
    }
}

//! Comments that allow what is found: `zpg check --add-allow`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::analysis::{Analysis, allowing};
use zpg::internals::diagnostics::{Code, Language, SourceFile, Span, fixes};
use zpg::internals::features::actions::{self, What};

use crate::rng::Rng;
use crate::support::program::{folder, text, zpg, zpg_with};

/// All samples of the rules, and all scenes.
fn scenes() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    for folder in ["src/lint", "scenes", "tests/corpus", "tests/recovery"] {
        let files = ignore::Walk::new(root.join(folder)).map(|e| e.unwrap().into_path());
        all.extend(files.filter(|p| p.extension().is_some_and(|e| e == "zpg")));
    }
    all.sort();
    all
}

/// How often each code is found.
fn counts(analysis: &Analysis) -> BTreeMap<Code, usize> {
    let mut counts = BTreeMap::new();
    let codes = analysis.findings().iter().map(|d| d.code);
    codes.for_each(|code| *counts.entry(code).or_default() += 1);
    counts
}

/// What is left can be allowed by no comment, nothing is new, and nothing is left to do.
#[test]
fn what_can_be_allowed_is_allowed_once() {
    let (mut scenes_with_some, mut allowed, mut left) = (0, 0, Vec::new());
    for path in scenes() {
        let read = |bytes| Analysis::new(path.to_string_lossy(), bytes);
        let before = read(fs::read(&path).unwrap());
        if !before.is_scene() {
            continue;
        }
        let old = counts(&before);
        let made = allowing::all(before, Analysis::of);
        let source = &made.analysis.source;
        let bytes = source.encode(&source.text).unwrap();
        let after = read(bytes.into_owned());
        let new = counts(&after);
        assert_eq!(new, counts(&made.analysis), "{}", path.display());
        for (code, count) in &new {
            let name = path.display();
            assert!(
                old.get(code) >= Some(count),
                "{name}: more of {code:?}:\n{}",
                source.text
            );
            let can_be = !code.is_never_allowed() && *code != Code::S504;
            if can_be {
                left.push(format!("{name}: {code:?}\n{}", source.text));
            }
        }
        scenes_with_some += usize::from(made.count > 0);
        allowed += made.count;
        let text = after.source.text.clone();
        let again = allowing::all(after, Analysis::of);
        assert_eq!(
            (again.count, &again.analysis.source.text),
            (0, &text),
            "{}",
            path.display()
        );
    }
    assert!(left.is_empty(), "{}: {}", left.len(), left.join("\n"));
    assert!(
        scenes_with_some > 250 && allowed > 500,
        "{scenes_with_some} {allowed}"
    );
}

const REST: &str = "9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -401 1\n1 9999 2 0\n";

/// The scene that comes of one, from standard input to standard output.
fn made(scene: &str, args: &[&str]) -> String {
    let dir = tempfile::tempdir().unwrap();
    let args = [&["check", "--add-allow", "-"], args].concat();
    text(&zpg_with(dir.path(), &args, scene).stdout)
}

#[test]
fn where_the_comment_stands() {
    for (before, after) in [
        // Behind the record, with what there is already.
        (
            "2 11 0 0 0 1\n2 -701 2 0 0\n",
            "2 11 0 0 0 1\n2 -701 2 0 0  # zpg: allow(W301) #\n",
        ),
        (
            "2 11 0 0 0 1\n2 -701 2 0 0 # red #\n",
            "2 11 0 0 0 1\n2 -701 2 0 0 # red # # zpg: allow(W301) #\n",
        ),
        // Two codes on a line, in one comment.
        (
            "2 11 0 0 0 1 2 -701 2 0 0\n",
            "2 11 0 0 0 1 2 -701 2 0 0  # zpg: allow(W301, S503) #\n",
        ),
        // Into the comment that is there, before its reason.
        (
            "2 11 0 0 0 1 2 -701 2 0 0 # ZPG: Allow(S503) as it is meant #\n",
            "2 11 0 0 0 1 2 -701 2 0 0 # ZPG: Allow(S503, W301) as it is meant #\n",
        ),
        (
            "2 11 0 0 0 1\n# zpg: allow(S501) #\n2 ⟨-701⟩ 2 0 0\n",
            "2 11 0 0 0 1\n# zpg: allow(S501, W301) #\n2 ⟨-701⟩ 2 0 0\n",
        ),
        // The last line of a record, and no line where a long comment begins.
        (
            "2 11 0 0 0 1\n2 -701 2\n0 0\n",
            "2 11 0 0 0 1\n2 -701 2\n0 0  # zpg: allow(W301) #\n",
        ),
        (
            "2 11 0 0 0 1\n2 -701 2 0 0 # a\nlong one #\n",
            "2 11 0 0 0 1\n2 -701 2 0 0  # zpg: allow(W301) # # a\nlong one #\n",
        ),
        // What is in no record: at the head, for all of the file.
        (
            "2 11 0 0 0 1\n# bare #\n",
            "# zpg: allow(S502) #\n2 11 0 0 0 1\n# bare #\n",
        ),
    ] {
        let (before, after) = (format!("{before}{REST}"), format!("{after}{REST}"));
        assert_eq!(made(&before, &[]), after);
        assert_eq!(made(&after, &[]), after);
    }
    // Line breaks and a mark at the head stay.
    let scene = "\u{feff}# bare #\r\n2 11 0 0 0 1\r\n1 9999 2 0\r\n";
    let chosen = made(scene, &["--select", "S502"]);
    assert_eq!(
        chosen,
        scene.replace("# bare", "# zpg: allow(S502) #\r\n# bare")
    );
}

#[test]
fn files_are_changed_and_errors_stay() {
    let warned = format!("2 11 0 0 0 1\n2 -701 2 0 0\n3 11 0 0 0 -1\n4 -101 2 3\n{REST}");
    let good = format!("2 11 0 0 0 1\n{REST}");
    let dir = folder(&[("a.zpg", warned.as_bytes()), ("b.zpg", good.as_bytes())]);
    let read = |name: &str| fs::read_to_string(dir.path().join(name)).unwrap();
    let run = zpg(dir.path(), &["check", "--add-allow", "--ignore", "W310"]);
    assert_eq!(run.status.code(), Some(1));
    let out = text(&run.stdout);
    assert!(
        out.starts_with("error[E201]") && !out.contains("W301"),
        "{out}"
    );
    assert!(
        out.contains("Allowed 1 finding in 1 file.\nFound 1 error in 1 file."),
        "{out}"
    );
    let after = warned.replace("2 0 0\n3", "2 0 0  # zpg: allow(W301) #\n3");
    assert_eq!((read("a.zpg"), read("b.zpg")), (after.clone(), good));
    // Once more: nothing to do.
    let run = zpg(
        dir.path(),
        &["check", "--add-allow", "--ignore", "W310", "--lang", "cs"],
    );
    assert!(!text(&run.stdout).contains("Povoleno"));
    assert_eq!(read("a.zpg"), after);
    let run = zpg(
        dir.path(),
        &["check", "--format", "short", "--ignore", "W310"],
    );
    assert_eq!(
        text(&run.stdout).lines().count(),
        1,
        "{}",
        text(&run.stdout)
    );
    // What settings take for an error can be allowed.
    fs::write(
        dir.path().join("a.zpg"),
        format!("2 11 0 0 0 1\n2 -701 2 0 0\n{REST}"),
    )
    .unwrap();
    let run = zpg(
        dir.path(),
        &["check", "--add-allow", "--deny", "W301", "a.zpg"],
    );
    assert_eq!(run.status.code(), Some(0));
    let out = text(&run.stdout);
    assert_eq!(out, "Allowed 1 finding in 1 file.\nAll checks passed!\n");
    for other in ["--fix", "--diff", "--watch"] {
        let run = zpg(dir.path(), &["check", "--add-allow", other]);
        assert_eq!(run.status.code(), Some(2));
    }
    // What is no scene is left alone.
    fs::write(dir.path().join("c.zpg"), "no scene\n").unwrap();
    let run = zpg(dir.path(), &["check", "--add-allow", "c.zpg"]);
    assert_eq!(
        (run.status.code(), read("c.zpg")),
        (Some(2), "no scene\n".to_owned())
    );
}

/// A file may be a single line with tens of thousands of findings on it.
#[test]
fn one_line_takes_no_longer_than_many() {
    for separator in [' ', '\n'] {
        let record = |i: u32| format!("{i} 11 {} 0 0 1 {i} -701 2 0 0{separator}", 3 * i);
        let scene: String = (2..20_000).map(record).collect();
        let before = Analysis::new("a.zpg", (scene + "1 9999 2 0\n").into_bytes());
        let found = before.findings().len();
        let start = std::time::Instant::now();
        let made = allowing::all(before, Analysis::of);
        assert_eq!((made.count, made.analysis.findings().len()), (found, 0));
        assert!(start.elapsed().as_secs() < 10, "{:?}", start.elapsed());
    }
}

#[test]
fn the_encoding_stays() {
    let scene = b"2 11 0 0 0 1\r\n2 -701 2 0 0 # \xe8erven\xe1 #\r\n9 -501 0 0 5 0 0 -1 0 1 0 45\r\n50 -401 1\r\n1 9999 2 0\r\n";
    let dir = folder(&[("a.zpg", scene)]);
    let run = zpg(dir.path(), &["check", "--add-allow", "a.zpg"]);
    assert_eq!(run.status.code(), Some(0));
    let after = fs::read(dir.path().join("a.zpg")).unwrap();
    let comment = b" # zpg: allow(W301, N601) #";
    let at = 14 + b"2 -701 2 0 0 # \xe8erven\xe1 #".len();
    assert_eq!(after, [&scene[..at], &comment[..], &scene[at..]].concat());
}

/// Lines of scenes, right ones and torn ones.
const LINES: [&str; 24] = [
    "2 11 0 0 0 1",
    "2 -701 2 0 0",
    "3 9 1",
    "3 9 1 # a # b #",
    "3 9 1 # a #",
    "3 9",
    "4 9 1 # a",
    "4 9 1 # a # # b # c # d",
    "5 -101 2 3",
    "2 -701 2",
    "0 0",
    "# bare #",
    "# bare",
    "#",
    "##",
    "0 # note # # a # b #",
    "# zpg: allow(W310) #",
    "# zpg: allow(W310, W301, S501, S502) as it is meant #",
    "# zpg: allow(W3$0) #",
    "# zpg: allow(W311, , S502) #",
    "# zpg: allow(E101) #",
    "# zpg: deny(W311) #",
    "# zpg: allow(W311)",
    "3 9 1 # zpg: allow(W311)",
];

/// What editors offer silences the finding and does no harm, and is what `--add-allow` writes where there is one finding.
#[test]
fn what_is_offered_has_an_effect() {
    let mut rng = Rng::new(5);
    let (mut offered, mut the_same) = (0, 0);
    let mut texts = vec![
        "2 9 1\n3 9 1 # a # b #\n1 9999 2 0\n".to_owned(),
        "2 9 1\n3 9 1 # zpg: allow(W311)\n1 9999 2 0\n".to_owned(),
        "2 9 1 # zpg: allow(W3$0) #\n1 9999 2 0\n".to_owned(),
    ];
    texts.extend((0..2000).map(|_| {
        let count = 1 + rng.below(4);
        let end = if rng.chance(0.2) { " " } else { "\n" };
        let lines: String = (0..count)
            .map(|_| format!("{}{end}", rng.pick(&LINES)))
            .collect();
        let first = if rng.chance(0.7) {
            "2 11 0 0 0 1\n"
        } else {
            ""
        };
        format!("{first}{lines}{REST}")
    }));
    for text in texts {
        let read = |text: &str| Analysis::of(SourceFile::of_text("a.zpg", text.to_owned()));
        let before = read(&text);
        let old = counts(&before);
        let all = Span::new(0, text.len() as u32);
        let can_be = old.iter().filter(|(code, _)| !code.is_never_allowed());
        let is_one = can_be.map(|(_, n)| n).sum::<usize>() == 1;
        let all = actions::actions(&before, all, Language::English).into_iter();
        let all = all.filter_map(|action| match action.what {
            What::Allow { finding, edits } => Some((finding, edits)),
            _ => None,
        });
        let all: Vec<_> = all.collect();
        if is_one && all.is_empty() {
            assert_eq!(allowing::all(read(&text), Analysis::of).count, 0, "{text}");
        }
        for (finding, edits) in all {
            let code = before.findings()[finding].code;
            let after = read(&fixes::edited(&text, &edits));
            let new = counts(&after);
            let count = |all: &BTreeMap<Code, usize>| all.get(&code).copied().unwrap_or(0);
            assert!(
                count(&new) < count(&old),
                "{code:?}: {text}{}",
                after.source.text
            );
            assert!(
                new.iter().all(|(code, n)| old.get(code) >= Some(n)),
                "{code:?}: {text}"
            );
            offered += 1;
            if is_one {
                let made = allowing::all(read(&text), Analysis::of);
                assert_eq!(made.analysis.source.text, after.source.text, "{text}");
                the_same += 1;
            }
        }
    }
    assert!(offered > 1000 && the_same > 100, "{offered} {the_same}");
}

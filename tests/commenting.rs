//! Commenting out and in: what comes of real scenes, of generated ones and of torn ones, wherever a selection begins and
//! ends.

use std::path::Path;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use zpg::internals::analysis::{Analysis, Settings};
use zpg::internals::diagnostics::{Code, SourceFile, Span, fixes};
use zpg::internals::features::actions;
use zpg::internals::features::commenting::{Mode, edits};
use zpg::internals::format::Options;
use zpg::internals::syntax::{Item, commented_out, preserved};

use crate::formatting::generate;
use crate::rng::Rng;

fn read(text: &str) -> Analysis {
    Analysis::of(SourceFile::new("a.zpg", text.to_owned().into_bytes()))
}

fn commented(text: &str, selections: &[Span], mode: Mode) -> String {
    fixes::edited(text, &edits(&read(text), selections, mode))
}

/// The same lines of a text that has as many of them: a selection stays in its lines, wherever in them.
fn same_lines(before: &str, selection: Span, after: &str, rng: &mut Rng) -> Span {
    let (before, after) = (read(before).source, read(after).source);
    let mut last = before.line_index(selection.end);
    let first = before.line_index(selection.start);
    if first < last && before.line_span(last).start == selection.end {
        last -= 1;
    }
    let mut within = |line: usize| {
        let span = after.line_span(line);
        after.floor(span.start + rng.below(span.range().len() + 1) as u32)
    };
    let [start, end] = [first, last].map(&mut within);
    if first == last {
        return Span::new(start.min(end), start.max(end));
    }
    // Not at the start of the last line, which would leave it out.
    let most = after.line_span(last).end;
    Span::new(
        start,
        if end == after.line_span(last).start {
            most
        } else {
            end
        },
    )
}

#[test]
fn what_stands_alone_is_a_zero_with_a_comment() {
    let cases = [
        (
            "10 -701 0.8 0.1 0.1 # red #",
            "0 # ~ 10 -701 0.8 0.1 0.1 ~~ red ~~ #",
        ),
        (
            "\u{feff}  2 9 1\t\r\n\r\n3 9 2 # ~5 cm #\r\n",
            "\u{feff}0 # ~   2 9 1\t #\r\n\r\n0 # ~ 3 9 2 ~~ ~'5 cm ~~ #\r\n",
        ),
        (
            "2 15  1 0 0 0\n\n      0 1 0 0 # y #\n0 0 1 0\n0 0 0 -1 3 9 1\n",
            "0 # ~ 2 15  1 0 0 0 #\n0 # ~+  #\n0 # ~+       0 1 0 0 ~~ y ~~ #\n0 # ~+ 0 0 1 0 #\n\
             0 # ~+ 0 0 0 -1 3 9 1 #\n",
        ),
        (
            "0 # ~ 2 9 1 #\n3 9 1\n",
            "0 # ~ 0 ~~ ~' 2 9 1 ~~ #\n0 # ~ 3 9 1 #\n",
        ),
        // An unclosed comment ends with its line.
        ("2 9 1 # ball", "0 # ~ 2 9 1 ~~ ball #"),
        ("2 -301 \"a#1.png\"", "0 # ~ 2 -301 \"a~~1.png\" #"),
        ("", ""),
        (" \n\t\n", " \n\t\n"),
    ];
    for (text, out) in cases {
        let all = [Span::new(0, text.len() as u32)];
        assert_eq!(commented(text, &all, Mode::Toggle), out);
        let all = [Span::new(0, out.len() as u32)];
        assert_eq!(commented(out, &all, Mode::Toggle), text);
        assert_eq!(commented(out, &all, Mode::In), text);
    }
}

/// A place in a record means its lines, with those of all that shares a line; the others stay as they are.
#[test]
fn whole_records_go_out() {
    let text = "2 9 1\n3 11 0 0\n0 1 # a\nb # 4 9 1\n5 9 1\n";
    let out = "2 9 1\n0 # ~ 3 11 0 0 #\n0 # ~+ 0 1 ~~ a #\n0 # ~+ b ~~ 4 9 1 #\n5 9 1\n";
    for at in 6..text.find("\n5").unwrap() as u32 {
        let here = [Span::new(at, at)];
        assert_eq!(commented(text, &here, Mode::Toggle), out, "at {at}");
    }
    // Any of the lines brings back all of them.
    for (at, _) in out.match_indices("0 # ~") {
        let here = [Span::new(at as u32 + 3, at as u32 + 3)];
        assert_eq!(commented(out, &here, Mode::Toggle), text, "at {at}");
    }
    // Several cursors are one step.
    let two = [
        Span::new(text.len() as u32 - 1, text.len() as u32 - 1),
        Span::new(0, 3),
    ];
    let out = commented(text, &two, Mode::Toggle);
    assert!(
        out.starts_with("0 # ~ 2 9 1 #\n3 11") && out.ends_with("4 9 1\n0 # ~ 5 9 1 #\n"),
        "{out}"
    );
    // The start of the next line is not part of a selection of whole lines.
    let lines = [Span::new(0, 6)];
    assert!(commented(text, &lines, Mode::Toggle).starts_with("0 # ~ 2 9 1 #\n3 11"));
    // What is asked for by name is done in one direction only.
    assert_eq!(commented(text, &two, Mode::In), text);
    let twice = commented("0 # ~ 2 9 1 #", &[Span::new(0, 0)], Mode::Out);
    assert_eq!(twice, "0 # ~ 0 ~~ ~' 2 9 1 ~~ #");
}

/// Many lines come and go in one edit.
#[test]
fn long_selections() {
    let text = "2 9 1 # a ~ #\r\n".repeat(5000);
    let all = [Span::new(3, text.len() as u32)];
    assert_eq!(edits(&read(&text), &all, Mode::Toggle).len(), 1);
    let out = commented(&text, &all, Mode::Toggle);
    assert_eq!(out, "0 # ~ 2 9 1 ~~ a ~' ~~ #\r\n".repeat(5000));
    let all = [Span::new(3, out.len() as u32)];
    assert_eq!(commented(&out, &all, Mode::Toggle), text);
}

/// The scenes of the repository, and generated ones.
fn scenes() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders =
        ["gallery", "handout", "handout/printed", "hard"].map(|f| root.join("scenes").join(f));
    let files = folders.iter().flat_map(|f| std::fs::read_dir(f).unwrap());
    let mut files: Vec<_> = files.map(|e| e.unwrap().path()).collect();
    files.retain(|p| p.extension().is_some_and(|e| e == "zpg"));
    files.sort();
    let texts = files
        .iter()
        .map(|p| read_file(p))
        .filter(|t| t.len() < 20_000);
    let mut out: Vec<String> = texts.collect();
    assert!(out.len() > 20, "{} scenes", out.len());
    let mut runner = TestRunner::deterministic();
    let strategy = generate::scene();
    out.extend((0..60).map(|_| strategy.new_tree(&mut runner).unwrap().current()));
    out
}

fn read_file(path: &Path) -> String {
    SourceFile::new("", std::fs::read(path).unwrap()).text
}

/// Where the character starts that an offset lies in.
fn floor(text: &str, at: usize) -> usize {
    let is_start = |at: &usize| text.is_char_boundary(*at);
    (0..=at.min(text.len())).rev().find(is_start).unwrap_or(0)
}

/// What people and programs do to a text.
fn torn(text: &str, rng: &mut Rng) -> String {
    let mut text = match rng.below(8) {
        0 => text.replace('\n', "\r\n"),
        1 => text.replace('\n', "\r"),
        2 => text.replace(' ', "\t"),
        3 => format!("\u{feff}{text}"),
        _ => text.to_owned(),
    };
    let odd = [
        "#",
        "~",
        "~~",
        "~'",
        "'",
        " # ",
        "\"a #~ b.png\"",
        "ž😀",
        "\n",
        "\r",
        "0 # ~ ",
        "0 # ~+ 2 9 1 #\n",
        " \n",
    ];
    for _ in 0..rng.below(5) {
        let at = floor(&text, rng.below(text.len() + 1));
        match rng.below(4) {
            // A sign of a comment is lost.
            0 => drop(text[at..].find('#').map(|i| text.remove(at + i))),
            1 => text.truncate(at.max(floor(&text, text.len() / 2 + 4))),
            _ => {
                let new: &&str = rng.pick(&odd);
                text.insert_str(at, new);
            }
        }
    }
    text
}

fn any_selection(text: &str, rng: &mut Rng) -> Span {
    let mut at = || floor(text, rng.below(text.len() + 1));
    let [a, b] = [at(), at()];
    match rng.below(3) {
        0 => Span::new(a as u32, a as u32),
        1 => {
            let near = floor(text, a + rng.below(120));
            Span::new(a as u32, near as u32)
        }
        _ => Span::new(a.min(b) as u32, a.max(b) as u32),
    }
}

/// Lines outside of what went out, and how many lines there are, do not change.
fn only_whole_lines_change(before: &str, after: &str) {
    let (old, new) = (read(before).source, read(after).source);
    assert_eq!(old.line_count(), new.line_count());
    for line in 0..old.line_count() {
        let [a, b] =
            [&old, &new].map(|s| s.slice(s.line_span(line)).trim_start_matches('\u{feff}'));
        assert!(
            a == b || commented_out::read(b).is_some() || commented_out::read(a).is_some(),
            "{a}\n{b}"
        );
    }
}

/// Twice is the text as it was: 1500 selections in scenes as they are and in torn ones, some with lines that are
/// commented out already.
#[test]
fn twice_is_the_text_as_it_was() {
    let mut rng = Rng::new(61);
    let scenes = scenes();
    let (mut went_out, mut came_in, mut compared) = (0, 0, 0);
    for round in 0..1500 {
        let scene = &scenes[round % scenes.len()];
        let mut text = match round % 3 {
            0 => scene.clone(),
            _ => torn(scene, &mut rng),
        };
        if round % 5 == 0 {
            for _ in 0..1 + rng.below(3) {
                text = commented(&text, &[any_selection(&text, &mut rng)], Mode::Out);
            }
        }
        let selection = any_selection(&text, &mut rng);
        let once = commented(&text, &[selection], Mode::Toggle);
        only_whole_lines_change(&text, &once);
        if once == text {
            let selected = text[selection.range()].trim_start_matches('\u{feff}');
            let is_blank = selected.trim().is_empty();
            assert!(
                is_blank,
                "nothing happens to {:?}",
                &text[selection.range()]
            );
            continue;
        }
        let again = same_lines(&text, selection, &once, &mut rng);
        let signs = |text: &str| text.matches('#').count() + text.matches('~').count();
        match signs(&once) > signs(&text) {
            true => went_out += 1,
            false => came_in += 1,
        }
        // What comes in is cut into records anew, which is another matter where mistakes are around it or signs that
        // nobody wrote so; and what is out twice comes in as many steps.
        let is_torn = round % 3 != 0 || !read(&once).is_sound();
        let came_in_doubt = signs(&once) < signs(&text) && (is_out(&once, again) || is_torn);
        if came_in_doubt {
            continue;
        }
        compared += 1;
        let twice = commented(&once, &[again], Mode::Toggle);
        assert_eq!(
            twice, text,
            "round {round}, {selection:?}, then {again:?}:\n{once}"
        );
    }
    let all = format!("{went_out} out, {came_in} in, {compared} compared");
    assert!(went_out > 1000 && came_in > 50 && compared > 1000, "{all}");
    println!("{all}");
}

/// The same from the other side: parts of scenes that are commented out come in and go out.
#[test]
fn what_comes_in_goes_out_again() {
    let mut rng = Rng::new(63);
    let scenes = scenes();
    let mut compared = 0;
    for scene in scenes.iter().filter(|s| read(s).is_sound()) {
        let text = commented(scene, &[Span::new(0, scene.len() as u32)], Mode::Out);
        for _ in 0..8 {
            let selection = any_selection(&text, &mut rng);
            let once = commented(&text, &[selection], Mode::Toggle);
            let again = same_lines(&text, selection, &once, &mut rng);
            if is_out(&once, again) {
                // Blank lines, or what was out in the scene itself.
                continue;
            }
            // Where the lines of a record no longer bear each other out, it is cut in another way.
            let is_broken = |item: &Item| matches!(item, Item::Broken(_));
            if read(&once).document.items.iter().any(is_broken) {
                continue;
            }
            compared += usize::from(once != text);
            assert_eq!(commented(&once, &[again], Mode::Toggle), text, "{once}");
        }
    }
    assert!(compared > 200, "{compared}");
}

/// Whether all lines of a selection are commented out.
fn is_out(text: &str, selection: Span) -> bool {
    let source = read(text).source;
    let lines = source.line_index(selection.start)..=source.line_index(selection.end);
    let mut texts = lines.map(|line| {
        source
            .slice(source.line_span(line))
            .trim_start_matches('\u{feff}')
    });
    texts.all(|t| t.trim().is_empty() || commented_out::read(t).is_some())
}

/// All that is commented out comes in, however deep.
fn all_in(text: &str) -> String {
    let all = [Span::new(0, text.len() as u32)];
    commented(text, &all, Mode::In)
}

/// What is commented out gives no finding, and neither the formatter nor fixes touch it.
#[test]
fn what_is_out_stays_as_it_is() {
    let mut rng = Rng::new(62);
    let mut scenes = scenes();
    scenes.extend((0..40).map(crate::lint_generated::scenes::scene));
    let mut tried = 0;
    for scene in scenes.iter().filter(|s| s.len() < 5000) {
        let style = Options::default();
        let formatted =
            |text: &str| zpg::internals::format::format(text, &read(text).document, &style);
        for _ in 0..3 {
            let out = commented(scene, &[any_selection(scene, &mut rng)], Mode::Out);
            let analysis = read(&out);
            if !analysis.is_scene() || !analysis.is_sound() {
                continue;
            }
            tried += 1;
            let source = &analysis.source;
            // A render record that lacks is said of the last line, whatever that is.
            let findings = analysis.findings().iter().filter(|f| f.code != Code::E106);
            for finding in findings {
                let line = source.slice(source.line_span(source.line_index(finding.span.start)));
                assert!(
                    commented_out::read(line).is_none(),
                    "{:?}\n{out}",
                    finding.code
                );
            }
            // Laid out anew, and again.
            let anew = formatted(&out);
            assert!(preserved::by_layout((&out, &analysis.document), &anew));
            assert_eq!(formatted(&anew), anew);
            assert_eq!(lines_out(&anew), lines_out(&out), "{out}");
            let (old, new) = (all_in(&out), all_in(&anew));
            assert!(
                preserved::by_layout((&old, &read(&old).document), &new),
                "{old}\n{new}"
            );
            let fixed = fixes::edited(&out, &actions::fix_all(&analysis, &Settings::default()));
            assert_eq!(lines_out(&fixed), lines_out(&out));
        }
    }
    assert!(tried > 100, "{tried}");
}

/// The texts that are commented out.
fn lines_out(text: &str) -> Vec<&str> {
    let lines = text.split(['\n', '\r']);
    lines
        .filter_map(|line| Some(&line[commented_out::read(line)?.text]))
        .collect()
}

/// A scene that was formatted is the same again when all of it was out and the formatter ran.
#[test]
fn formatted_scenes_come_back_as_they_were() {
    for scene in scenes() {
        let style = Options::default();
        let formatted =
            |text: &str| zpg::internals::format::format(text, &read(text).document, &style);
        let text = formatted(&scene);
        // A text without records stays as it is, a last line without an end as well.
        if !text.ends_with('\n') {
            continue;
        }
        let out = commented(&text, &[Span::new(0, text.len() as u32)], Mode::Out);
        assert_eq!(formatted(&out), out);
        assert_eq!(all_in(&out), text);
    }
}

/// The command line's own way: several lines, inner comments, all that a scene can hold. W315 and all others are silent.
#[test]
fn the_program_says_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.zpg");
    let rest = "0 # what is drawn #\n2 11  0 0 0  1 # ball #\n3 -402 1\n3 -1  3 4 5\n4 -501  0 0 9  0 0 -1  0 1 0  30\n1 9999 2 0\n";
    let out = "7 15  1 0 0 0\n0 1 0 0 # a\n b # 0 0 1 0\n0 0 0 -1\n10 -701 0.8 0.1 7 # red #\n6 -101 99 98\nthis is nothing\n";
    let out = commented(out, &[Span::new(0, out.len() as u32)], Mode::Out);
    std::fs::write(&path, format!("{out}{rest}")).unwrap();
    let mut program = crate::support::program::command();
    let said = program
        .args(["check", "--format", "short"])
        .arg(&path)
        .output()
        .unwrap();
    assert_eq!(
        String::from_utf8_lossy(&said.stdout),
        "",
        "{}",
        String::from_utf8_lossy(&said.stderr)
    );
    assert!(said.status.success());
    // Nor of a block that an editor has made, which ends where it ends.
    std::fs::write(&path, format!("0 # ~ 7 9 1\n8 9 1 #\n{rest}")).unwrap();
    let mut program = crate::support::program::command();
    let said = program
        .args(["check", "--format", "short"])
        .arg(&path)
        .output()
        .unwrap();
    assert_eq!(String::from_utf8_lossy(&said.stdout), "");
}

/// No record takes in lines that are commented out, however many numbers it lacks.
#[test]
fn a_record_that_lacks_numbers_ends_before_what_is_out() {
    let whole = "2 11 0 0 0 1\n3 2 3 0 1 1 1 1 0 1 0 0 0 1 0 0 0 1\n4 15 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1\n";
    for record in whole.lines() {
        let words: Vec<&str> = record.split(' ').collect();
        for kept in 2..words.len() {
            for lines in 1..words.len() - kept + 3 {
                let head = words[..kept].join(" ");
                let out: String = (0..lines)
                    .map(|i| format!("0 # ~ {} 9 1 #\n", 20 + i))
                    .collect();
                let text = format!("{head}\n{out}1 9999 2 0\n");
                let analysis = read(&text);
                let in_first = |d: &zpg::internals::diagnostics::Diagnostic| {
                    analysis.source.line_index(d.span.start) == 0
                };
                let errors = analysis.findings();
                let errors = errors
                    .iter()
                    .filter(|d| d.is_error() && d.code != Code::E101);
                assert!(
                    errors.clone().count() == 1 && errors.clone().all(in_first),
                    "{text}"
                );
                let formatted =
                    zpg::internals::format::format(&text, &analysis.document, &Options::default());
                assert!(
                    formatted.ends_with(&format!("{out}1 9999 2 0\n")),
                    "{formatted}"
                );
            }
        }
    }
}

//! Every fix of every finding: applied alone it leaves a file that checks better, loses no comment,
//! and draws the same picture if it is called safe.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::rng::Rng;
use crate::trace_support;
use zpg::internals::analysis::{Analysis, fixing};
use zpg::internals::diagnostics::{
    Applicability, Code, Diagnostic, Language, Severity, Span, fixes,
};
use zpg::internals::features::actions::{self, Action, What};

/// What the examples leave out: other cases of a code, and comments between any two tokens.
const TRIGGERS: &[&str] = &[
    "2 9 1 # never closed\n3 9 2 # closed #\n4 -101 2 3\n1 9999 4 0\n",
    "2 # a # 9 # b # 0,5 # c #\n1 9999 2 0\n",
    "2 11 0 −1 0 1\n1 9999 2 0\n",
    "2 9 1\n9 1\n1 9999 2 0\n",
    "11 0 0 0 1\n3 9 1\n4 -101 2 3\n1 9999 4 0\n",
    "2 11 0 0-1 1\n3 11 1.2.3 0 1\n4-101 2 3\n1 9999 4 0\n",
    "2 11 1/2 0 0 1\n3 11 1/0 0 0 1\n4 -101 2 3\n1 9999 4 0\n",
    "2 9 1\n3 9 2\n4 -101 2 3\n9999 1 4 0\n",
    "2 9 1\n7 -301 my image.png\n1 9999 2 0\n",
    "2 1 3 0,0 1,1 0,2\n7 -301 my image.png\n1 9999 2 0\n",
    "2 11 0 0 0 1 # a\n3 11 1 0 0 1 # b\n4 -101 2 3\n1 9999 4 0\n",
    "2 9 1\n3 201 .8 .1 .1\n1 9999 2 0\n",
    "2.0 9 1\n3 9.0 1\n4 13 1 3.0\n4 -2 90 1.0\n1 9999 2 0\n",
    "10 12 1 1 1 0,5 0 0\n1 9999 10 0\n",
    "9 -501 0 0 9 0 0 0 0 0 0 4,5\n2 9 1\n1 9999 2 0\n",
    "14 -701 1 0 0\n35 -201 1 0 0\n4 9 1\n4 -204 # paint # 0 35\n1 9999 4 0\n",
    "2 9 1\n2 -2 1 45\n1 9999 2 0\n",
    "15 -701 1 0 0\n16 -399 10 15 14 55\n1 9999 4 0\n",
    "20 9 1\n3 9 1\n4 -101 2 3\n1 9999 44 0\n",
    "7 9999 2 0\n2 9 1\n",
    "2 12 1 0 0 # x # -1 1 1\n3 5 2 2 1 1\n4 -101 2 3\n1 9999 4 0\n",
    "2 9 1\n2 -601 1 1 1 -1 -1 -1\n1 9999 2 0  9 9 9  -9 -9 -9\n",
    "2 15 1 2 0 0  0 1 0 0  0 0 1 3  0 0 0 -1\n1 9999 2 0\n",
    "2 15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\n1 9999 2 0\n",
    "2 12 -1 -1 -1 1 1 1\n2 -4 0.707 0 0.707 0  0 1 0 0  -0.707 0 0.707 0  0 0 0 1\n1 9999 2 0\n",
    "2 14 1 3\n1 9999 2 0\n",
    "2 12 0 0 0 2 2 2\n3 12 .5 .5 .5 1.5 2 1.5\n4 -103 2 3\n1 9999 4 0\n",
    "# a heading #\n2 (9) {1}; # b # 3 9 2\n# c #\n4 -101 2 3 1 9999 4 0\n",
    "2 9 1 # zpg: allow(W302, W303) #\n# zpg: allow(W320) #\n\n# zpg: allow(W302) #\n1 9999 2 0\n",
];

/// Scenes that trigger something: the examples of all codes, and the files of the repository.
fn scenes() -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = (TRIGGERS.iter())
        .flat_map(|t| [t.to_string(), t.replace('\n', "\r\n")])
        .map(|t| (t.clone(), t))
        .collect();
    for code in Code::ALL {
        let fences = code
            .explanation(Language::English)
            .split("```zpg\n")
            .skip(1);
        for (i, fence) in fences.enumerate() {
            let scene = fence.split("```").next().unwrap();
            all.push((
                format!("example {i} of {}", code.as_str()),
                scene.to_owned(),
            ));
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders: Vec<PathBuf> = vec![root.join("scenes"), root.join("tests")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "zpg") {
                let bytes = fs::read(&path).unwrap();
                let text = Analysis::new("a", bytes).source.text;
                // The large ones take long and trigger nothing else.
                if text.len() < 20_000 {
                    all.push((path.display().to_string(), text));
                }
            }
        }
    }
    all
}

fn read(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.into())
}

/// How many malformed tokens, and render records that are missing, which hide what else is wrong; errors, warnings,
/// notes and remarks on style.
fn weight(found: &[Diagnostic]) -> [usize; 5] {
    let of = |s: Severity| found.iter().filter(|d| d.severity == s).count();
    let hiding = [
        Code::E001,
        Code::E002,
        Code::E003,
        Code::E004,
        Code::E010,
        Code::E106,
    ];
    [
        found.iter().filter(|d| hiding.contains(&d.code)).count(),
        of(Severity::Error),
        of(Severity::Warning),
        of(Severity::Note),
        of(Severity::Style),
    ]
}

fn comments(loaded: &Analysis) -> Vec<String> {
    let text = &loaded.source.text;
    let comments = loaded.document.comments();
    comments.map(|t| t.text(text).to_owned()).collect()
}

/// A small picture, bit by bit; `None` where the scene cannot be drawn.
fn picture(loaded: &Analysis) -> Option<Vec<u32>> {
    let drawable = loaded.is_sound() && loaded.scene.render.is_some();
    // Images lie beside the scene, which is no file here.
    if !drawable || loaded.source.text.contains("-301") {
        return None;
    }
    let settings = trace_support::small(24, 18);
    let picture = trace_support::picture(&loaded.scene, &settings);
    Some(
        picture
            .film
            .pixels
            .iter()
            .flatten()
            .map(|x| x.to_bits())
            .collect(),
    )
}

#[test]
fn every_fix_makes_it_better() {
    let mut tried = 0;
    let mut drawn = 0;
    let mut wrong = String::new();
    let mut with_fix = BTreeSet::new();
    for (name, text) in scenes() {
        let before = read(&text);
        for d in before.findings() {
            for fix in &d.fixes {
                tried += 1;
                with_fix.insert(d.code);
                let (fixed, count) = fixes::apply(&text, std::iter::once(fix));
                assert_eq!(count, 1, "{name}: {d:?}");
                let after = read(&fixed);
                let what = format!("{name}: {} {:?}", d.code.as_str(), fix);
                if weight(after.findings()) >= weight(before.findings()) {
                    let found: Vec<_> = after.findings().iter().map(|d| d.code).collect();
                    wrong += &format!("{what} checks no better: {found:?}\n{fixed}\n");
                }
                // Closing a comment adds its end, and a comment that allows nothing may go.
                let own = [Code::E002, Code::S504].contains(&d.code);
                if !own && comments(&before) != comments(&after) {
                    wrong += &format!("{what} changes a comment\n");
                }
                if fix.applicability == Applicability::Safe
                    && let Some(picture_before) = picture(&before)
                {
                    drawn += 1;
                    if Some(picture_before) != picture(&after) {
                        wrong += &format!("{what} is called safe, but draws another picture\n");
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    // Fewer would mean that the test looks past its matter.
    assert!(
        tried > 100 && drawn > 20,
        "{tried} fixes of {with_fix:?}, {drawn} pictures"
    );
}

/// The text of the first fix of the first error applied.
fn mended(text: &str) -> String {
    let loaded = read(text);
    let first = loaded.findings().iter().find(|d| d.is_error());
    let fix = first.and_then(|d| d.fixes.first());
    fixes::apply(text, fix.into_iter()).0
}

#[test]
fn fixes_write_what_was_meant() {
    for (line, meant) in [
        ("3 11 0 0-1 1", "3 11 0 0 -1 1"),
        ("3 11 1.2.3 0 1", "3 11 1.2 .3 0 1"),
        ("3-101 2 2", "3 -101 2 2"),
        ("3 11 1/2 0 0 1", "3 11 0.5 0 0 1"),
        ("3 11 1/0 0 0 1", "3 11 1/0 0 0 1"),
        ("3 201 .8 .1 .1", "3 -201 .8 .1 .1"),
        ("3 -301 my image.png", "3 -301 \"my image.png\""),
        ("9999 1 2 0", "1 9999 2 0"),
        ("2 -2 1 45", "2 -2 45 1"),
        ("2 -2 45.5 4", "2 -2 45.5 4"),
    ] {
        let text = |line: &str| format!("2 9 1\n40 9 1\n41 9 1\n{line}\n");
        assert_eq!(mended(&text(line)), text(meant));
    }
}

/// All decimal points of the scenes made commas, and made points again.
#[test]
fn decimal_commas_are_mended() {
    let mut commas = 0;
    for folder in ["handout", "gallery", "hard"] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|e| e != "zpg") {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let digit = |i: usize| text.as_bytes().get(i).is_some_and(u8::is_ascii_digit);
            let mut spoiled = text.clone();
            let (mut count, mut lines) = (0, BTreeSet::new());
            for t in &read(&text).document.tokens {
                let (from, to) = (t.start as usize, t.end() as usize);
                let point = text[from..to].find('.').filter(|_| t.kind().is_number());
                let point = point.map(|i| from + i);
                if let Some(p) = point.filter(|&p| digit(p.wrapping_sub(1)) && digit(p + 1)) {
                    spoiled.replace_range(p..p + 1, ",");
                    count += 1;
                    lines.insert(text[..p].matches('\n').count());
                }
            }
            let loaded = read(&spoiled);
            let errors: Vec<_> = loaded.findings().iter().filter(|d| d.is_error()).collect();
            let right = errors.iter().all(|d| d.code == Code::E003);
            let found: Vec<_> = errors.iter().map(|d| (d.code, d.span)).collect();
            assert!(
                right && errors.len() == lines.len(),
                "{lines:?} {} {found:?}",
                path.display()
            );
            let safe = errors.iter().flat_map(|d| &d.fixes);
            assert_eq!(fixes::apply(&spoiled, safe).0, text, "{}", path.display());
            commas += count;
        }
    }
    assert!(commas > 1000, "{commas}");
}

/// Editors prefer no fix that `zpg check --fix` refuses; the only one there is, they prefer where it is applied.
#[test]
fn what_is_refused_is_not_preferred() {
    let refused = [
        "2 9 1\n3 9 1 # a # b #\n1 9999 2 0\n",
        "2 4##😀#",
        "1e9 -1#1",
        "5-1 0 1 0\n7 -102 5 5",
    ];
    let (mut preferred, mut not) = (0, 0);
    let mut texts: Vec<String> = scenes().into_iter().map(|(_, text)| text).collect();
    texts.retain(|text| text.len() < 4000);
    texts.extend(refused.map(str::to_owned));
    let mut rng = Rng::new(3);
    for i in 0..600 {
        let text = &texts[i % texts.len()];
        if text.len() < 2000 {
            let at = text.floor_char_boundary(rng.below(text.len() + 1));
            let (before, after) = text.split_at(at);
            let odd = rng.pick(&["#", "-", ",5", ";", " ", "\n", "<", "0", "# a # b #"]);
            texts.push(format!("{before}{odd}{after}"));
        }
    }
    for text in texts {
        let read = |text: &str| Analysis::new("a.zpg", text.into());
        let before = read(&text);
        let all = Span::new(0, before.source.text.len() as u32);
        let offered = actions::actions(&before, all, Language::English);
        let of_fix = |action: &Action| match action.what {
            What::Fix { preferred, .. } => Some(preferred),
            _ => None,
        };
        let chosen: Vec<bool> = offered.iter().filter_map(of_fix).collect();
        let count = chosen.iter().filter(|&&p| p).count();
        let is_safe = |d: &&Diagnostic| d.applicable_fix(false).is_some();
        let safe = before.findings().iter().filter(is_safe).count();
        let mended = fixing::to_fixed_point(read(&text), false, Analysis::of);
        if mended.count == 0 {
            assert_eq!(count, 0, "{text}");
        }
        if safe == 1 && mended.count > 0 {
            assert!(count > 0, "{text}");
        }
        preferred += count;
        not += usize::from(safe > 0 && count == 0);
    }
    assert!(preferred > 200 && not > 10, "{preferred} {not}");
}

//! Editor features as data: a folder of scenes for each, with `$0` where the pointer is, and beside each scene the
//! answer. Where a scene has several `$0` each is asked about.

use std::fmt::Write as _;
use std::path::Path;

use zpg::internals::analysis::{Analysis, Settings};
use zpg::internals::diagnostics::{Edit, Language, SourceFile, Span, fixes};
use zpg::internals::features::actions::What;
use zpg::internals::features::*;
use zpg::internals::format::Options;

const CURSOR: &str = "$0";

/// A scene and the places that were marked in it.
struct Fixture {
    scene: Analysis,
    cursors: Vec<u32>,
}

impl Fixture {
    fn read(text: &str) -> Fixture {
        let mut cursors = Vec::new();
        let mut rest = text.to_owned();
        while let Some(at) = rest.find(CURSOR) {
            rest.replace_range(at..at + CURSOR.len(), "");
            cursors.push(at as u32);
        }
        let scene = Analysis::of(SourceFile::new("a.zpg", rest.into_bytes()));
        // Editors have them before anybody points at anything.
        scene.findings();
        Fixture { scene, cursors }
    }

    fn text(&self) -> &str {
        &self.scene.source.text
    }

    fn all(&self) -> Span {
        Span::new(0, self.text().len() as u32)
    }

    /// The answers at the cursors, one after the other.
    fn each(&self, answer: impl Fn(u32) -> String) -> String {
        let mut out = String::new();
        for &at in &self.cursors {
            let place = self.scene.source.position(at);
            let _ = writeln!(out, "== {}:{}", place.line, place.column);
            out.push_str(answer(at).trim_end());
            out.push('\n');
        }
        out
    }

    /// "2:3-2:5 `text`".
    fn place(&self, span: Span) -> String {
        let [a, b] = [span.start, span.end].map(|at| self.scene.source.position(at));
        let text = self.scene.source.slice(span).replace('\n', "⏎");
        format!("{}:{}-{}:{} `{text}`", a.line, a.column, b.line, b.column)
    }

    /// The text with something put into it.
    fn with(&self, mut notes: Vec<(u32, String)>) -> String {
        notes.sort_by_key(|n| n.0);
        let mut out = String::new();
        let mut at = 0;
        for (place, note) in notes {
            out.push_str(&self.text()[at..place as usize]);
            out.push_str(&note);
            at = place as usize;
        }
        out + &self.text()[at..]
    }

    fn after(&self, edits: &[Edit]) -> String {
        fixes::edited(self.text(), edits)
    }
}

fn hints_of(f: &Fixture) -> String {
    let all = hints::hints(
        &f.scene,
        f.all(),
        hints::Wanted::default(),
        Language::English,
    );
    f.with(all.map(|h| (h.at, format!("‹{}›", h.text))).collect())
}

fn hover_of(f: &Fixture) -> String {
    f.each(|at| match hover::hover(&f.scene, at, Language::English) {
        None => "nothing".to_owned(),
        Some(hover) => format!("{}\n{}", f.place(hover.span), hover.markdown),
    })
}

fn signature_of(f: &Fixture) -> String {
    f.each(
        |at| match signature::signature(&f.scene, at, Language::English) {
            None => "nothing".to_owned(),
            Some(s) => {
                let mut label = s.label.clone();
                let active = s.active.map(|i| &s.params[i]);
                if let Some(param) = active {
                    label.insert(param.at.1, '›');
                    label.insert(param.at.0, '‹');
                }
                format!("{label}\n{}", active.map_or("", |p| p.doc.as_str()))
            }
        },
    )
}

fn completion_of(f: &Fixture) -> String {
    f.each(|at| {
        let found = completion::completion(&f.scene, at, Language::English);
        let word = f.scene.source.slice(found.word);
        let mut out = format!("in the place of `{word}`:\n");
        for p in &found.proposals {
            let insert = p.insert.snippet().replace('\n', "⏎");
            let _ = writeln!(out, "{} | {} | {} | {insert}", p.label, p.detail, p.filter);
        }
        out
    })
}

fn definition_of(f: &Fixture) -> String {
    f.each(|at| match uses::definition(&f.scene, at) {
        None => "nothing".to_owned(),
        Some((id, record)) => format!("{} of {}", f.place(id), f.place(record)),
    })
}

fn references_of(f: &Fixture) -> String {
    f.each(|at| {
        let all = uses::references(&f.scene, at, true);
        let line = |o: &uses::Occurrence| format!("{} {:?}\n", f.place(o.span), o.kind);
        all.iter().map(line).collect()
    })
}

fn highlights_of(f: &Fixture) -> String {
    f.each(|at| {
        let all = uses::highlights(&f.scene, at);
        let line =
            |(span, kind): &(Span, Option<uses::Kind>)| format!("{} {kind:?}\n", f.place(*span));
        all.iter().map(line).collect()
    })
}

fn rename_of(f: &Fixture) -> String {
    let to = f.text().lines().next().unwrap();
    let new = to.trim_start_matches("0 # to ").trim_end_matches(" #");
    f.each(|at| match rename::rename(&f.scene, at, new) {
        Ok(edits) => f.after(&edits),
        Err(why) => why.to_string(),
    })
}

fn renumber_of(f: &Fixture) -> String {
    match rename::renumber(&f.scene) {
        Some(edits) => f.after(&edits),
        None => "not done".to_owned(),
    }
}

fn symbols_of(f: &Fixture) -> String {
    fn add(f: &Fixture, symbol: &symbols::Symbol, depth: usize, out: &mut String) {
        let lines = [symbol.span.start, symbol.span.end].map(|at| f.scene.source.position(at).line);
        let [first, last] = lines;
        let indent = "  ".repeat(depth);
        let sort = symbol.sort;
        let _ = writeln!(
            out,
            "{indent}{} ({}) {sort:?}, lines {first}-{last}",
            symbol.name, symbol.detail
        );
        symbol
            .children
            .iter()
            .for_each(|s| add(f, s, depth + 1, out));
    }
    let mut out = String::new();
    symbols::symbols(&f.scene, Language::English)
        .iter()
        .for_each(|s| add(f, s, 0, &mut out));
    out
}

fn calls_of(f: &Fixture) -> String {
    f.each(|at| {
        let Some(node) = calls::prepare(&f.scene, at, Language::English) else {
            return "nothing".to_owned();
        };
        let mut out = format!("{}\n", node.name);
        for (sign, all) in [
            (
                "made into",
                calls::incoming(&f.scene, node.id, Language::English),
            ),
            (
                "made of",
                calls::outgoing(&f.scene, node.id, Language::English),
            ),
        ] {
            for call in all {
                let at: Vec<String> = call.at.iter().map(|s| f.place(*s)).collect();
                let _ = writeln!(out, "{sign} {} at {}", call.node.name, at.join(", "));
            }
        }
        out
    })
}

fn folding_of(f: &Fixture) -> String {
    let line = |f: &folding::Fold| format!("{}-{} {:?}\n", f.first + 1, f.last + 1, f.kind);
    folding::folds(&f.scene).iter().map(line).collect()
}

fn selection_of(f: &Fixture) -> String {
    f.each(|at| {
        let all = selection::selection(&f.scene, at);
        all.iter().map(|s| f.place(*s) + "\n").collect()
    })
}

fn tokens_of(f: &Fixture) -> String {
    let all = tokens::tokens(&f.scene, f.all());
    // Any part is told as it is within the whole.
    for at in 0..=f.text().len() as u32 {
        let part = tokens::tokens(&f.scene, Span::new(at, at + 7));
        let within = all
            .iter()
            .filter(|t| t.span.start < at + 7 && t.span.end > at);
        assert_eq!(part, within.copied().collect::<Vec<_>>(), "at {at}");
    }
    let line = |t: &tokens::Meaning| {
        let defines = if t.defines { ", defined" } else { "" };
        format!("{} {:?}{defines}\n", f.place(t.span), t.role)
    };
    all.iter().map(line).collect()
}

fn colours_of(f: &Fixture) -> String {
    let line = |c: &colours::Colour| {
        let shown = c.shown.map(|x| (x * 255.0).round());
        format!("{} {shown:?}\n", f.place(c.span))
    };
    colours::colours(&f.scene).iter().map(line).collect()
}

fn lenses_of(f: &Fixture) -> String {
    let line = |l: &lenses::Lens| format!("{} {:?}\n", f.place(l.span), l.action);
    lenses::lenses(&f.scene).iter().map(line).collect()
}

fn on_type_of(f: &Fixture) -> String {
    f.each(|at| {
        f.after(&formatting::on_line_break(
            &f.scene,
            &Options::default(),
            at,
        ))
    })
}

fn actions_of(f: &Fixture) -> String {
    f.each(|at| {
        let mut out = String::new();
        for action in actions::actions(&f.scene, Span::new(at, at), Language::English) {
            let _ = writeln!(out, "-- {}", action.title);
            match action.what {
                What::Fix {
                    edits, preferred, ..
                } => {
                    let _ = writeln!(out, "preferred: {preferred}\n{}", f.after(&edits));
                }
                What::Allow { edits, .. } => {
                    let _ = writeln!(out, "{}", f.after(&edits));
                    // The comment does what it says.
                    let before = f.scene.findings().len();
                    let after = Analysis::of(SourceFile::new("a", f.after(&edits).into_bytes()));
                    assert!(after.findings().len() < before);
                }
                What::Explain(code) => {
                    let _ = writeln!(out, "{}", code.as_str());
                }
            }
        }
        out
    })
}

fn fix_all_of(f: &Fixture) -> String {
    assert!(actions::has_safe_fixes(&f.scene));
    f.after(&actions::fix_all(&f.scene, &Settings::default()))
}

/// The answer to a request, by the name of its folder.
fn answer(feature: &str, f: &Fixture) -> String {
    match feature {
        "hints" => hints_of(f),
        "hover" => hover_of(f),
        "signature" => signature_of(f),
        "completion" => completion_of(f),
        "definition" => definition_of(f),
        "references" => references_of(f),
        "highlights" => highlights_of(f),
        "rename" => rename_of(f),
        "renumber" => renumber_of(f),
        "symbols" => symbols_of(f),
        "calls" => calls_of(f),
        "folding" => folding_of(f),
        "selection" => selection_of(f),
        "tokens" => tokens_of(f),
        "colours" => colours_of(f),
        "lenses" => lenses_of(f),
        "on_type" => on_type_of(f),
        "actions" => actions_of(f),
        "fix_all" => fix_all_of(f),
        other => panic!("there is no feature {other}"),
    }
}

#[test]
fn scenes_of_features() {
    insta::glob!("features/*/*.zpg", |path: &Path| {
        let feature = path.parent().unwrap().file_name().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let said = answer(feature.to_str().unwrap(), &Fixture::read(&text));
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(path.parent().unwrap());
        settings.set_prepend_module_to_snapshot(false);
        settings.remove_snapshot_suffix();
        settings.set_omit_expression(true);
        settings.remove_input_file();
        let name = path.file_name().unwrap().to_str().unwrap();
        settings.bind(|| insta::assert_snapshot!(name, said));
    });
}

/// Every feature answers everywhere, in the scenes of the repository and in torn ones, and what it names is there.
#[test]
fn no_place_is_too_odd() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = vec![
        String::new(),
        "\u{feff}".to_owned(),
        "2".to_owned(),
        "#".to_owned(),
    ];
    for entry in std::fs::read_dir(root.join("scenes/handout")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "zpg") {
            let text = std::fs::read_to_string(path).unwrap();
            // Half of it, with lone carriage returns and characters of several bytes.
            let half = &text[..text.floor_char_boundary(text.len() / 2)];
            texts.push(half.replace("\n", "\r").replace('1', "ž😀"));
            texts.push(text.replace(' ', "\r\n"));
            // IDs that begin with a placeholder, and those that are defined twice.
            let id = |line: &str| line.split(' ').next().unwrap_or_default().to_owned();
            let with_placeholders = |line: &str| format!("{} 0\n{line}\n\n", id(line));
            texts.push(text.lines().map(with_placeholders).collect());
            texts.push(
                text.lines()
                    .map(|line| format!("{line}\n{line}\n\n"))
                    .collect(),
            );
            texts.push(text);
        }
    }
    for text in texts {
        let f = Fixture::read(&text);
        let all = f.all();
        for wanted in [all, Span::new(all.end / 3, all.end / 2)] {
            hints::hints(&f.scene, wanted, hints::Wanted::default(), Language::Czech)
                .for_each(drop);
            tokens::tokens(&f.scene, wanted);
        }
        for answer in [
            symbols_of, folding_of, colours_of, lenses_of, tokens_of, hints_of,
        ] {
            answer(&f);
        }
        for at in (0..=all.end).filter(|&at| text.is_char_boundary(at as usize)) {
            if let Some(hover) = hover::hover(&f.scene, at, Language::Czech) {
                assert!(text.get(hover.span.range()).is_some());
            }
            signature::signature(&f.scene, at, Language::Czech);
            let found = completion::completion(&f.scene, at, Language::Czech);
            let word = found.word;
            assert!(word.start <= at && text.get(word.range()).is_some());
            let mut labels: Vec<&str> = found.proposals.iter().map(|p| p.label.as_str()).collect();
            labels.sort_unstable();
            let twice = labels.windows(2).find(|pair| pair[0] == pair[1]);
            assert_eq!(twice, None, "at {at} of {text}");
            uses::definition(&f.scene, at);
            uses::highlights(&f.scene, at);
            calls::prepare(&f.scene, at, Language::Czech);
            let spans = selection::selection(&f.scene, at);
            let holds =
                |pair: &[Span]| pair[1].start <= pair[0].start && pair[0].end <= pair[1].end;
            assert!(spans.windows(2).all(holds));
            let _ = rename::rename(&f.scene, at, "77");
            formatting::on_line_break(&f.scene, &Options::default(), at);
        }
    }
}

/// What is picked is what is shown then, to 8 bits, and a number that need not change does not.
#[test]
fn repainting_changes_what_it_must() {
    let f = Fixture::read("2 -701   1 0.50  .25\n");
    let colour = colours::colours(&f.scene)[0];
    let same = colours::repaint(&f.scene, colour.span, colour.shown).unwrap();
    assert_eq!(same.text, "1 0.50  .25");
    for wanted in 0..=255u8 {
        let picked = [colour.shown[0], f64::from(wanted) / 255.0, colour.shown[2]];
        let edit = colours::repaint(&f.scene, colour.span, picked).unwrap();
        assert!(
            edit.text.starts_with("1 ") && edit.text.ends_with("  .25"),
            "{}",
            edit.text
        );
        let again = Fixture::read(&f.after(&[edit]));
        assert_eq!(colours::colours(&again.scene)[0].shown[1], picked[1]);
    }
    assert!(colours::repaint(&f.scene, Span::new(0, 3), colour.shown).is_none());
}

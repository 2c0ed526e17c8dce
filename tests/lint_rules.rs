//! Lint rules as data: scenes in the folders of the rules, and beside each what `zpg check` prints about it and
//! what its fixes make of it.
//!
//! A scene here may lack a render record, a camera or a light: nothing is said about that, but by the rules
//! that ask for a camera and a light.

use std::path::Path;

use zpg::internals::analysis::{Analysis, fixing};
use zpg::internals::diagnostics::render::human::{self, Look};
use zpg::internals::diagnostics::{Code, Language, SourceFile};

/// What is said of scenes that draw nothing or from nowhere.
const ASIDE: [Code; 3] = [Code::E106, Code::N602, Code::N603];

/// What `zpg check` prints.
fn printed(scene: &Analysis, aside: &[Code]) -> String {
    let all = scene.findings().iter().filter(|d| !aside.contains(&d.code));
    let all: Vec<_> = all.cloned().collect();
    // That no wording is missing is asserted where it is looked for.
    for finding in &all {
        finding.wording(Language::Czech);
    }
    let mut out = Vec::new();
    human::write(&mut out, &scene.source, &all, Look::default()).unwrap();
    match out.is_empty() {
        true => "Nothing is found.\n".to_owned(),
        false => String::from_utf8(out).unwrap(),
    }
}

/// The scene after fixes, if they change it.
fn fixed(name: &str, text: &str, unsafe_too: bool) -> Option<String> {
    let scene = Analysis::new(name, text.into());
    let mended = fixing::to_fixed_point(scene, unsafe_too, Analysis::of);
    let fixed = mended.analysis.source.text;
    (fixed != text).then_some(fixed)
}

/// All that is to be seen of a scene.
fn report(path: &Path) -> String {
    let name = path.file_name().unwrap().to_str().unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    let about_views = ["no_camera", "no_light"].map(|rule| format!("/{rule}/"));
    let about_views = about_views
        .iter()
        .any(|r| path.to_str().unwrap().contains(r));
    let aside: &[Code] = if about_views { &[] } else { &ASIDE };
    let scene = Analysis::of(SourceFile::new(name, text.clone().into()));
    let mut report = printed(&scene, aside);
    let safe = fixed(name, &text, false);
    let all = fixed(name, &text, true);
    for (title, fixed) in [
        ("after --fix", &safe),
        (
            "after --fix --unsafe-fixes",
            &all.filter(|all| Some(all) != safe.as_ref()),
        ),
    ] {
        if let Some(fixed) = fixed {
            report += &format!("\n== {title} ==\n{fixed}");
        }
    }
    report
}

/// Compares all that is to be seen of a scene with the snapshot beside it.
pub fn snapshot(path: &Path) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(path.parent().unwrap());
    settings.set_prepend_module_to_snapshot(false);
    settings.remove_snapshot_suffix();
    settings.set_omit_expression(true);
    settings.remove_input_file();
    let name = path.file_name().unwrap().to_str().unwrap();
    settings.bind(|| insta::assert_snapshot!(name, report(path)));
}

#[test]
fn scenes_of_rules() {
    insta::glob!("../src/lint", "**/tests/*.zpg", snapshot);
}

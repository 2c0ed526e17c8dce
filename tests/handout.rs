//! The handout's examples: as printed they give the findings that lie beside them, repaired they
//! give none.

use std::fmt::Write;
use std::path::PathBuf;

use zpg::internals::analysis::file::load;

fn scenes(folder: &str) -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        .collect();
    files.sort();
    assert_eq!(files.len(), 4, "{}", folder.display());
    files
}

#[test]
fn printed_examples() {
    for path in scenes("scenes/handout/printed") {
        let loaded = load(&path).unwrap();
        let mut found = String::new();
        for d in loaded.findings() {
            let at = loaded.source.position(d.span.start);
            write!(
                found,
                "{}:{} {} {}",
                at.line,
                at.column,
                d.severity.as_str(),
                d.code.as_str()
            )
            .unwrap();
            for edit in d.fixes.iter().flat_map(|f| &f.edits) {
                let old = loaded.source.slice(edit.span);
                write!(found, ", {old} -> {}", edit.text).unwrap();
            }
            found.push('\n');
        }
        let expected = std::fs::read_to_string(path.with_extension("expected")).unwrap();
        assert_eq!(found, expected, "{}", path.display());
    }
}

#[test]
fn repaired_examples() {
    for path in scenes("scenes/handout") {
        let loaded = load(&path).unwrap();
        assert!(
            loaded.findings().is_empty(),
            "{}: {:?}",
            path.display(),
            loaded.findings()
        );
        assert!(loaded.scene.render.is_some());
    }
}

/// The third example's ball has the colour that its record says: it is in the picture.
#[test]
fn the_ball_before_the_camera_is_orange() {
    let folder = tempfile::tempdir().unwrap();
    let scene = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes/handout/3-camera.zpg");
    let args = [
        "render",
        scene.to_str().unwrap(),
        "-o",
        "a.png",
        "--size",
        "40x30",
        "--samples",
        "1",
    ];
    assert!(
        crate::support::program::zpg(folder.path(), &args)
            .status
            .success()
    );
    let picture = image::open(folder.path().join("a.png")).unwrap().to_rgb8();
    let [r, g, b] = picture.get_pixel(20, 15).0;
    assert!(r > 100 && r > g && g > b.saturating_add(40), "{r} {g} {b}");
}

/// The pages of what the handout leaves open: the page, the reference whose last section says the same, and how
/// the heading of that begins.
const PAGES: [[&str; 3]; 2] = [
    ["docs/handout.md", "grammar/reference.md", "## 9. "],
    ["docs/handout.cs.md", "grammar/reference.cs.md", "## 9. "],
];

fn read(path: &str) -> String {
    std::fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn the_reference_says_what_the_pages_say() {
    for [page, reference, heading] in PAGES {
        let (page, reference) = (read(page), read(reference));
        let section = reference.split(&format!("\n{heading}")).nth(1).unwrap();
        let section = format!("# {}", section.replace("\n### ", "\n## "));
        assert_eq!(page, section);
    }
}

/// Each example is a part of the scene at the top: before its last line, or in place of it.
#[test]
fn what_the_pages_show_is_true() {
    for [page, ..] in PAGES {
        let text = read(page);
        let blocks = |fence: &str| -> Vec<String> {
            let opening = format!("```{fence}\n");
            let all = text.split(&opening).skip(1);
            all.map(|rest| rest.split("```").next().unwrap().to_owned())
                .collect()
        };
        let scenes = blocks("zpg");
        let [scene] = scenes.as_slice() else {
            panic!("{page}: {} scenes", scenes.len());
        };
        let (before, last) = scene.trim_end().rsplit_once('\n').unwrap();
        let parts = blocks("zpg part");
        assert!(parts.len() > 30, "{page}");
        for part in parts {
            let is_render = |line: &str| line.starts_with("1 9999");
            let whole = match part.lines().any(is_render) {
                true => format!("{before}\n{part}"),
                false => format!("{before}\n{part}{last}\n"),
            };
            let loaded =
                zpg::internals::analysis::Analysis::new("scene.zpg", whole.clone().into_bytes());
            assert!(
                loaded.is_sound(),
                "{page}: {:#?}\n{whole}",
                loaded.findings()
            );
            // What the head of the page says that some examples show.
            let shown = ["W310", "W331", "W309", "W313", "W312"];
            let others = loaded
                .findings()
                .iter()
                .filter(|d| !shown.contains(&d.code.as_str()));
            // The picture is not beside this page.
            let others: Vec<_> = others
                .filter(|d| !part.contains("-301") || d.code.as_str() != "E210")
                .collect();
            assert!(others.is_empty(), "{page}: {others:#?}\n{whole}");
        }
    }
}

#[test]
fn the_pages_have_the_same_examples() {
    let parts = |page: &str| -> Vec<String> {
        let text = read(page);
        let blocks = text.split("```").skip(1).step_by(2);
        // Comments are in the language of the page.
        let bare = |block: &str| block.split('#').step_by(2).collect::<String>();
        blocks
            .map(|b| bare(b).split_whitespace().collect::<Vec<_>>().join(" "))
            .collect()
    };
    assert_eq!(parts(PAGES[0][0]), parts(PAGES[1][0]));
}

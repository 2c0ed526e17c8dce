//! The template for a course: its scenes are right and draw, and what is set up around them runs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use saphyr::{LoadableYamlNode as _, Yaml};
use serde_json::Value;

use crate::support::program::{self, text, zpg};

fn template() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/course")
}

/// The template in a folder of its own.
fn copied() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let from = template();
    for entry in ignore::WalkBuilder::new(&from).hidden(false).build() {
        let path = entry.unwrap().into_path();
        let to = dir.path().join(path.strip_prefix(&from).unwrap());
        match path.is_dir() {
            true => fs::create_dir_all(to).unwrap(),
            false => drop(fs::copy(path, to).unwrap()),
        }
    }
    dir
}

fn yaml(name: &str) -> Yaml<'static> {
    let text = fs::read_to_string(template().join(name)).unwrap();
    let text: &'static str = text.leak();
    Yaml::load_from_str(text).unwrap().remove(0)
}

fn string<'y>(yaml: &'y Yaml, key: &str) -> Option<&'y str> {
    yaml.as_mapping_get(key)?.as_str()
}

/// What the steps of the workflow run, by their names.
fn steps() -> BTreeMap<String, String> {
    let workflow = yaml(".github/workflows/scenes.yml");
    let job = workflow
        .as_mapping_get("jobs")
        .unwrap()
        .as_mapping_get("scenes")
        .unwrap();
    let steps = job.as_mapping_get("steps").unwrap().as_vec().unwrap();
    let named = steps.iter().filter_map(|step| {
        let command = string(step, "run")?.to_owned();
        Some((string(step, "name")?.to_owned(), command))
    });
    named.collect()
}

#[test]
fn scenes_are_right_and_draw() {
    let dir = copied();
    for check in [&["check", "--deny", "all"][..], &["fmt", "--check"]] {
        let run = zpg(dir.path(), check);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stdout));
    }
    let run = zpg(
        dir.path(),
        &["render", "scenes", "-o", "p", "--size", "64x48"],
    );
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let mut count = 0;
    for entry in fs::read_dir(dir.path().join("p")).unwrap() {
        let picture = image::open(entry.unwrap().path()).unwrap().into_rgb8();
        let clipped = picture.pixels().filter(|p| p.0 == [255; 3]).count();
        assert_eq!(clipped, 0);
        count += 1;
    }
    assert_eq!(count, 3);
    // The settings mean something: a scene without a camera is wrong.
    fs::write(
        dir.path().join("scenes/a.zpg"),
        "2 9 1\n50 -401 1\n1 9999 2 0\n",
    )
    .unwrap();
    let run = zpg(dir.path(), &["check", "--format", "short"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(
        text(&run.stdout).contains("N602 error"),
        "{}",
        text(&run.stdout)
    );
}

/// A Git repository of the template, and a way to run commands in it that find zpg.
struct Repository {
    dir: tempfile::TempDir,
    path: String,
}

impl Repository {
    fn new() -> Repository {
        let bin = Path::new(program::PATH).parent().unwrap();
        let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap());
        let repository = Repository {
            dir: copied(),
            path,
        };
        repository.git("git init --quiet && git add . && git commit --quiet -m Template");
        repository
    }

    /// Runs a step as GitHub does; the exit status and what is printed.
    fn run(&self, step: &str, base: &str) -> (Option<i32>, String) {
        let output = Command::new("bash")
            .args(["--noprofile", "--norc", "-e", "-o", "pipefail", "-c", step])
            .env("PATH", &self.path)
            .env("BASE", base)
            .env("LC_ALL", "C")
            .env("GIT_CONFIG_GLOBAL", "/dev/null")
            .envs(["AUTHOR", "COMMITTER"].map(|who| (format!("GIT_{who}_NAME"), "A")))
            .envs(["AUTHOR", "COMMITTER"].map(|who| (format!("GIT_{who}_EMAIL"), "a@example.org")))
            .current_dir(self.dir.path())
            .output()
            .unwrap();
        (
            output.status.code(),
            text(&output.stdout) + &text(&output.stderr),
        )
    }

    fn git(&self, command: &str) -> String {
        let (status, said) = self.run(command, "");
        assert_eq!(status, Some(0), "{said}");
        said.trim().to_owned()
    }

    fn pictures(&self) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.dir.path().join("pictures/scenes")) else {
            return Vec::new();
        };
        let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }
}

/// The workflow's own lines: at first all is drawn, then what has changed, and what is wrong stands at its line.
#[cfg(unix)]
#[test]
fn the_workflow_runs() {
    let repository = Repository::new();
    let steps = steps();
    // Smaller pictures are drawn sooner.
    let draw = steps["Draw what has changed"].replace("--quality good", "--size 16x12");
    assert_eq!(repository.run(&steps["Check"], "").0, Some(0));
    assert_eq!(repository.run(&steps["Look at the layout"], "").0, Some(0));
    let (status, said) = repository.run(&draw, &"0".repeat(40));
    assert_eq!(status, Some(0), "{said}");
    let all = ["1-snowman.png", "2-cup.png", "3-lamps.png"];
    assert_eq!(repository.pictures(), all);

    let base = repository.git("git rev-parse HEAD");
    fs::remove_dir_all(repository.dir.path().join("pictures")).unwrap();
    let scenes = repository.dir.path().join("scenes");
    let good = fs::read_to_string(scenes.join("3-lamps.zpg")).unwrap();
    fs::write(scenes.join("four letters.zpg"), &good).unwrap();
    fs::write(
        scenes.join("2-cup.zpg"),
        good.replace("10 14 0.8 0.22", "10 14 0.8"),
    )
    .unwrap();
    repository
        .git("git add . && git rm --quiet scenes/1-snowman.zpg && git commit --quiet -m More");
    let (status, said) = repository.run(&draw, &base);
    // One scene is wrong; the other is drawn all the same.
    assert_eq!(
        (status, repository.pictures()),
        (Some(1), vec!["four letters.png".to_owned()]),
        "{said}"
    );
    let (status, said) = repository.run(&steps["Check"], "");
    assert_eq!(status, Some(1));
    assert!(
        said.contains("::error ") && said.contains("file=scenes/2-cup.zpg,line="),
        "{said}"
    );
}

/// All that is named is there: options of the hooks and commands of the pages, the version, settings of the extension.
#[test]
fn names_are_those_of_zpg() {
    let version = format!("zpg-tools=={}", env!("CARGO_PKG_VERSION"));
    assert!(steps()["Install zpg"].ends_with(&version));
    let dir = copied();
    let hooks = yaml(".pre-commit-config.yaml");
    let repository = &hooks.as_mapping_get("repos").unwrap().as_vec().unwrap()[0];
    let hooks = repository
        .as_mapping_get("hooks")
        .unwrap()
        .as_vec()
        .unwrap();
    assert_eq!(hooks.len(), 2);
    for hook in hooks {
        assert_eq!(string(hook, "language"), Some("python"));
        let needs = hook.as_mapping_get("additional_dependencies").unwrap();
        assert_eq!(needs.as_vec().unwrap()[0].as_str(), Some(version.as_str()));
        let words: Vec<&str> = string(hook, "entry").unwrap().split(' ').skip(1).collect();
        let run = zpg(
            dir.path(),
            &[&words[..], &["scenes/1-snowman.zpg"]].concat(),
        );
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    }
    for page in ["README.md", "README.cs.md"] {
        let page = fs::read_to_string(template().join(page)).unwrap();
        let in_block = page.lines().filter(|line| line.starts_with("zpg "));
        for line in in_block.filter(|line| !line.contains("--watch")) {
            let words = line.split('#').next().unwrap().split_whitespace().skip(1);
            let run = zpg(dir.path(), &words.collect::<Vec<_>>());
            assert_eq!(run.status.code(), Some(0), "{line}: {}", text(&run.stderr));
        }
        fs::remove_file(dir.path().join("scenes/4-own.zpg")).unwrap();
    }
    let json =
        |path: PathBuf| -> Value { serde_json::from_slice(&fs::read(path).unwrap()).unwrap() };
    let extension = template().join("../../editors/vscode/package.json");
    let extension = json(extension);
    let id = format!("{}.{}", extension["publisher"], extension["name"]).replace('"', "");
    let settings = json(template().join(".vscode/settings.json"));
    assert_eq!(settings["[zpg]"]["editor.defaultFormatter"], id.as_str());
    assert_eq!(
        json(template().join(".vscode/extensions.json"))["recommendations"][0],
        id.as_str()
    );
    let known = extension["contributes"]["configuration"]["properties"]
        .as_object()
        .unwrap();
    let own = settings
        .as_object()
        .unwrap()
        .iter()
        .filter(|(name, _)| name.starts_with("zpg."));
    for (name, value) in own {
        assert_eq!(
            known[name]["type"] == "boolean",
            value.is_boolean(),
            "{name}"
        );
    }
}

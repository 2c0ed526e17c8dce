//! The hooks of `.pre-commit-hooks.yaml`, run by the real pre-commit on a repository with scenes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const GOOD: &str = "2 11  0 0 0  1\n9 -501  0 0 5  0 0 -1  0 1 0  45\n50 -402 1\n1 9999 2 0\n";
const BROKEN: &str = "2 11  0 0 0  1\n9 -501  0 0 5  0 0 -1  0 1 0  45\n50 -402 1\n1 9999 7 0\n";
const LOOSE: &str = "2 11 0 0 0 1.0\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50  -402 1\n1 9999 2 0";

const CHECK: &str = "zpg check................................................................";
const FMT: &str = "zpg fmt..................................................................";

/// A repository with scenes that uses the hooks, and one that has them.
struct Setup {
    folder: tempfile::TempDir,
}

impl Setup {
    /// `manifest` is what the repository with the hooks has in `.pre-commit-hooks.yaml`.
    fn new(manifest: &str) -> Setup {
        let setup = Setup::empty();
        let hooks = setup.path("hooks");
        fs::create_dir(&hooks).unwrap();
        fs::write(hooks.join(".pre-commit-hooks.yaml"), manifest).unwrap();
        setup.git("hooks", &["init", "--quiet"]);
        setup.git("hooks", &["add", "."]);
        setup.git("hooks", &["commit", "--quiet", "--message", "Hooks"]);
        setup.using(&hooks);
        setup
    }

    fn empty() -> Setup {
        Setup {
            folder: tempfile::tempdir().unwrap(),
        }
    }

    /// Makes the repository with scenes, which uses the hooks of another at its newest commit.
    fn using(&self, hooks: &Path) {
        let scenes = self.path("scenes");
        fs::create_dir(&scenes).unwrap();
        let rev = self.run(
            hooks,
            Command::new("git").args(["rev-parse", "HEAD"]),
            "git: install it from your system's packages",
        );
        let config = format!(
            "repos:\n  - repo: {}\n    rev: {}\n    hooks:\n      - id: zpg-fmt\n      - id: zpg-check\n",
            hooks.display(),
            text(&rev.stdout).trim()
        );
        fs::write(scenes.join(".pre-commit-config.yaml"), config).unwrap();
        self.git("scenes", &["init", "--quiet"]);
        let installed = self.pre_commit(&["install"]);
        assert!(installed.status.success(), "{installed:?}");
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, scene: &str) {
        fs::write(self.path("scenes").join(name), scene).unwrap();
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path("scenes").join(name)).unwrap()
    }

    /// Commits everything there is; what the hooks say, and whether there is a commit.
    fn commit(&self) -> (bool, String) {
        self.git("scenes", &["add", "."]);
        let mut command = Command::new("git");
        command.args(["commit", "--quiet", "--message", "Scenes"]);
        let run = self.run(&self.path("scenes"), &mut command, "git");
        (run.status.success(), text(&run.stdout) + &text(&run.stderr))
    }

    fn git(&self, folder: &str, args: &[&str]) {
        let mut command = Command::new("git");
        let run = self.run(&self.path(folder), command.args(args), "git");
        assert!(run.status.success(), "git {args:?}: {}", text(&run.stderr));
    }

    fn pre_commit(&self, args: &[&str]) -> Output {
        let mut command = Command::new("pre-commit");
        self.run(
            &self.path("scenes"),
            command.args(args),
            "pre-commit: tests/run installs it, or `pip install pre-commit`",
        )
    }

    /// Runs a command that sees the program under test, and nothing of the user's settings.
    fn run(&self, folder: &Path, command: &mut Command, what: &str) -> Output {
        let program = Path::new(crate::support::program::PATH).parent().unwrap();
        let path = std::env::var_os("PATH").unwrap_or_default();
        let places = [program.to_owned()]
            .into_iter()
            .chain(std::env::split_paths(&path));
        for name in ["GIT_DIR", "GIT_INDEX_FILE", "GIT_WORK_TREE", "SKIP"] {
            command.env_remove(name);
        }
        command
            .current_dir(folder)
            .env("PATH", std::env::join_paths(places).unwrap())
            .env("PRE_COMMIT_HOME", self.path("cache"))
            .env("PRE_COMMIT_COLOR", "never")
            .env("LC_ALL", "C")
            .env("GIT_CONFIG_GLOBAL", self.path("no-such-file"))
            .env("GIT_CONFIG_NOSYSTEM", "1")
            .env("GIT_AUTHOR_NAME", "A. Student")
            .env("GIT_AUTHOR_EMAIL", "student@example.org")
            .env("GIT_COMMITTER_NAME", "A. Student")
            .env("GIT_COMMITTER_EMAIL", "student@example.org")
            .output()
            .unwrap_or_else(|e| panic!("cannot run {what} ({e})"))
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The definitions as they are, except that the program is not compiled once more but taken from
/// the tests' own build.
fn manifest() -> String {
    let manifest = fs::read_to_string(root().join(".pre-commit-hooks.yaml")).unwrap();
    assert_eq!(manifest.matches("\n  language: rust\n").count(), 2);
    manifest.replace("language: rust", "language: system")
}

/// The course of events for a student, whose scenes are good, broken and loosely laid out.
fn assert_commits(setup: &Setup) {
    setup.write("good.zpg", GOOD);
    setup.write("notes.txt", "1 2 3");
    let (done, said) = setup.commit();
    assert!(done, "{said}");
    assert!(said.contains(&format!("{CHECK}Passed\n")), "{said}");
    assert!(said.contains(&format!("{FMT}Passed\n")), "{said}");

    setup.write("broken.zpg", BROKEN);
    let (done, said) = setup.commit();
    assert!(!done, "{said}");
    assert!(
        said.contains("- hook id: zpg-check\n- exit code: 1\n"),
        "{said}"
    );
    assert!(said.contains("error[E101]: 7 is not defined\n"), "{said}");
    assert!(said.contains("broken.zpg:4:8"), "{said}");
    assert!(!said.contains("good.zpg"), "{said}");
    assert_eq!(setup.read("broken.zpg"), BROKEN);
    setup.write("broken.zpg", GOOD);

    setup.write("loose.zpg", LOOSE);
    let (done, said) = setup.commit();
    assert!(!done, "{said}");
    assert!(
        said.contains("- hook id: zpg-fmt\n- files were modified by this hook\n"),
        "{said}"
    );
    assert!(
        said.contains("1 file reformatted, 1 file left unchanged\n"),
        "{said}"
    );
    assert_eq!(setup.read("loose.zpg"), GOOD);
    let (done, said) = setup.commit();
    assert!(done, "{said}");
    assert_eq!(setup.read("notes.txt"), "1 2 3");
}

#[test]
#[ignore = "needs pre-commit"]
fn the_definitions_are_valid() {
    let setup = Setup::empty();
    fs::create_dir(setup.path("scenes")).unwrap();
    let manifest = root().join(".pre-commit-hooks.yaml");
    let run = setup.pre_commit(&["validate-manifest", manifest.to_str().unwrap()]);
    assert!(run.status.success(), "{}", text(&run.stdout));
}

#[test]
#[ignore = "needs pre-commit"]
fn commits_are_checked_and_formatted() {
    assert_commits(&Setup::new(&manifest()));
}

#[test]
#[ignore = "needs pre-commit"]
fn folders_with_many_scenes_take_one_run() {
    let setup = Setup::new(&manifest());
    for i in 0..300 {
        setup.write(&format!("{i}.zpg"), LOOSE);
    }
    let (done, said) = setup.commit();
    assert!(!done, "{said}");
    assert!(said.contains("\n300 files reformatted\n"), "{said}");
}

/// As it is for users: pre-commit compiles the program of this repository's newest commit.
#[test]
#[ignore = "compiles everything with all optimisations, which takes minutes"]
fn commits_with_the_program_from_source() {
    let setup = Setup::empty();
    setup.using(root());
    assert_commits(&setup);
}

//! The server in real editors. `tests/run` installs them into `target/editors`.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

use crate::lsp::model::Model;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn installed(name: &str) -> PathBuf {
    root().join("target/editors").join(name)
}

/// Fails with all that was said, if it has failed.
#[track_caller]
fn has_passed(output: &Output) {
    let said = [&output.stdout, &output.stderr].map(|s| String::from_utf8_lossy(s));
    assert!(output.status.success(), "{}\n{}", said[0], said[1]);
}

fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy_folder(&entry.path(), &target),
            false => drop(std::fs::copy(entry.path(), target).unwrap()),
        }
    }
}

/// A home with a scene in it, and in the PATH a `zpg` that keeps what an editor and the server say to each other. A question
/// is kept before the server reads it, so that no answer stands without its question.
fn home() -> (tempfile::TempDir, PathBuf, String) {
    let home = tempfile::tempdir().unwrap();
    let scene = home.path().join("a.zpg");
    std::fs::copy(root().join("tests/editors/scene.zpg"), &scene).unwrap();
    let path = format!(
        "{}:{}",
        home.path().display(),
        std::env::var("PATH").unwrap()
    );
    let (program, folder) = (crate::support::program::PATH, home.path().display());
    let script = format!(
        "#!/bin/sh\n\
         export LC_ALL=C\n\
         [ \"$1\" = lsp ] || exec {program} \"$@\"\n\
         tee /dev/fd/3 3>&1 >>{folder}/asked.$$ | {program} lsp | tee -a {folder}/said.$$\n"
    );
    let own = home.path().join("zpg");
    std::fs::write(&own, script).unwrap();
    std::fs::set_permissions(&own, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    (home, scene, path)
}

/// The messages of a stream, the last one perhaps cut off.
fn messages(mut bytes: &[u8]) -> Vec<Value> {
    let mut out = Vec::new();
    while let Some(end) = bytes.windows(4).position(|w| w == b"\r\n\r\n") {
        let head = std::str::from_utf8(&bytes[..end]).unwrap();
        let length = head
            .lines()
            .find_map(|l| l.strip_prefix("Content-Length: "))
            .unwrap();
        let (start, length) = (end + 4, length.trim().parse::<usize>().unwrap());
        let Some(body) = bytes.get(start..start + length) else {
            break;
        };
        out.push(serde_json::from_slice(body).unwrap());
        bytes = &bytes[start + length..];
    }
    out
}

/// All that the servers have said in a folder keeps to the protocol.
fn all_kept_to_the_protocol(folder: &Path) {
    let model = Model::read();
    let mut count = 0;
    for entry in std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
    {
        let Some(number) = entry
            .to_str()
            .unwrap()
            .strip_prefix(folder.to_str().unwrap())
        else {
            continue;
        };
        let Some(number) = number.strip_prefix("/said.") else {
            continue;
        };
        let said = messages(&std::fs::read(&entry).unwrap());
        let asked = messages(&std::fs::read(folder.join(format!("asked.{number}"))).unwrap());
        for message in said {
            count += 1;
            let own = message["method"].as_str();
            let right = match (own, message.get("id")) {
                (Some("$/progress"), _) => Ok(()),
                (Some(method), id) => model.check_call(method, &message["params"], id.is_some()),
                (None, id) => {
                    let question = asked
                        .iter()
                        .find(|a| a.get("id") == id && !a["method"].is_null());
                    let method = question.unwrap()["method"].as_str().unwrap();
                    match message.get("result") {
                        Some(result) if !method.starts_with("zpg/") => {
                            model.check_result(method, result)
                        }
                        _ => Ok(()),
                    }
                }
            };
            right.unwrap_or_else(|e| panic!("{e}"));
        }
    }
    assert!(count > 10, "{count} messages");
}

/// As editors/neovim/README.md says.
#[test]
#[ignore = "needs Neovim"]
fn neovim() {
    let home = run_neovim(&["--headless", "-l"], "neovim.lua");
    let text = std::fs::read_to_string(home.path().join("a.zpg")).unwrap();
    assert!(text.starts_with("77 11  0 1 0  1  # ball #\n77 -701 0.9 0.2 0.1\n4 11  0.5 0 0  1\n"));
}

/// Runs a script of ours on a scene, in Neovim with our package; the home that it ran in.
fn run_neovim(arguments: &[&str], script: &str) -> tempfile::TempDir {
    let (home, scene, path) = home();
    let data = home.path().join("data");
    let package = data.join("nvim/site/pack/zpg/start/zpg");
    copy_folder(&root().join("editors/neovim"), &package);
    let output = Command::new(installed("venv/bin/nvim"))
        .args(arguments)
        .arg(root().join("tests/editors").join(script))
        .arg(&scene)
        .env("HOME", home.path())
        .env("XDG_DATA_HOME", &data)
        .env("XDG_STATE_HOME", home.path().join("state"))
        .env("XDG_CONFIG_HOME", home.path().join("config"))
        .env("PATH", path)
        .output()
        .unwrap();
    has_passed(&output);
    all_kept_to_the_protocol(home.path());
    home
}

/// Records that are typed come out as they are, with Neovim's own completion, on and off.
#[test]
#[ignore = "needs Neovim"]
fn neovim_typing() {
    run_neovim(&["--headless", "-u", "NONE", "-l"], "neovim-typing.lua");
}

/// The extension as it is packed: what people see in the window, and the interface within the host.
#[test]
#[ignore = "needs VS Code and Chromium"]
fn vscode() {
    let (home, _, _) = home();
    let output = Command::new("node")
        .arg(root().join("tests/editors/vscode.mjs"))
        .arg(installed(""))
        .arg(root().join("editors/vscode/zpg.vsix"))
        .arg(home.path().join("zpg"))
        .arg(installed("pictures"))
        .output()
        .unwrap();
    has_passed(&output);
    all_kept_to_the_protocol(home.path());
}

/// What the editors above do not ask for: pulled diagnostics, differences of tokens, files that change, cancelling.
#[test]
#[ignore = "needs pytest-lsp"]
fn flows() {
    let (home, _, _) = home();
    let output = Command::new(installed("pytest/bin/python"))
        .args([
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            "-o",
            "asyncio_mode=auto",
        ])
        .arg(root().join("tests/editors/flows"))
        .arg("--basetemp")
        .arg(home.path().join("scenes"))
        .env("HOME", home.path())
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("ZPG", home.path().join("zpg"))
        .output()
        .unwrap();
    has_passed(&output);
    all_kept_to_the_protocol(home.path());
}

/// What the grammar of the extension makes of lines whose scopes stand below them.
#[test]
#[ignore = "needs vscode-tmgrammar-test"]
fn textmate() {
    let output = Command::new(installed("browser/node_modules/.bin/vscode-tmgrammar-test"))
        .current_dir(root())
        .args(["-g", "editors/vscode/syntaxes/zpg.tmLanguage.json"])
        .arg("tests/editors/textmate.txt")
        .output()
        .unwrap();
    has_passed(&output);
}

/// The grammar as Neovim has it: the trees of the corpus, every scene of the repository, and the queries.
#[test]
#[ignore = "needs Neovim and a C compiler"]
fn tree_sitter() {
    let grammar = root().join("grammar/tree-sitter");
    let folder = tempfile::tempdir().unwrap();
    let parser = folder.path().join("zpg.so");
    let compiled = Command::new("cc")
        .args(["-shared", "-fPIC", "-O2", "-Wall", "-Werror", "-I"])
        .arg(grammar.join("src"))
        .args(["parser.c", "scanner.c"].map(|f| grammar.join("src").join(f)))
        .arg("-o")
        .arg(&parser)
        .output()
        .unwrap();
    has_passed(&compiled);
    let scenes = ignore::Walk::new(root().join("scenes")).map(|e| e.unwrap().into_path());
    let scenes = scenes.filter(|p| p.extension().is_some_and(|e| e == "zpg"));
    let output = Command::new(installed("venv/bin/nvim"))
        .args(["--headless", "-u", "NONE", "-l"])
        .arg(root().join("tests/editors/tree-sitter.lua"))
        .arg(parser)
        .arg(grammar.join("queries"))
        .arg(grammar.join("test/corpus/records.txt"))
        .args(scenes)
        .output()
        .unwrap();
    has_passed(&output);
}

/// As editors/emacs/README.md says.
#[test]
#[ignore = "needs Emacs"]
fn emacs() {
    let (home, scene, path) = home();
    let output = Command::new("emacs")
        .args(["-Q", "--batch", "-L"])
        .arg(root().join("editors/emacs"))
        .arg("-l")
        .arg(root().join("tests/editors/emacs.el"))
        .env("HOME", home.path())
        .env("PATH", path)
        .env("SCENE", &scene)
        .output()
        .unwrap();
    has_passed(&output);
    all_kept_to_the_protocol(home.path());
    assert!(
        std::fs::read_to_string(scene)
            .unwrap()
            .starts_with("77 11  0 1 0  1  # ball #\n")
    );
}

/// As editors/helix/README.md says.
#[test]
#[ignore = "needs Helix and tmux"]
fn helix() {
    let (home, scene, path) = home();
    let settings = home.path().join(".config/helix");
    std::fs::create_dir_all(&settings).unwrap();
    let languages = root().join("editors/helix/languages.toml");
    std::fs::copy(languages, settings.join("languages.toml")).unwrap();
    let hints = "[editor.lsp]\ndisplay-inlay-hints = true\n";
    std::fs::write(settings.join("config.toml"), hints).unwrap();
    let output = Command::new("bash")
        .arg(root().join("tests/editors/helix.sh"))
        .arg(installed("hx"))
        .arg(&scene)
        .env("HOME", home.path())
        .env("XDG_CONFIG_HOME", home.path().join(".config"))
        .env("XDG_CACHE_HOME", home.path().join("cache"))
        .env("PATH", path)
        .output()
        .unwrap();
    has_passed(&output);
    all_kept_to_the_protocol(home.path());
}

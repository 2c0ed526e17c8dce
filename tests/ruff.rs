//! What ruff calls otherwise.

use std::path::Path;

use crate::support::program::{self, folder, text};

const SCENE: &str = "1 9999 2 0\n2 11 0 0 0 -1\n";

fn said(folder: &Path, arguments: &[&str]) -> String {
    let run = program::zpg(folder, arguments);
    text(&run.stdout) + &text(&run.stderr)
}

#[test]
fn names_of_ruff_are_understood() {
    let dir = folder(&[("a.zpg", SCENE), ("old/b.zpg", SCENE)]);
    for (theirs, ours) in [
        (
            &["check", "--output-format", "short"][..],
            &["check", "--format", "short"][..],
        ),
        (&["rule", "E101"], &["explain", "E101"]),
        (&["format", "--diff"], &["fmt", "--diff"]),
    ] {
        let answer = said(dir.path(), theirs);
        assert!(answer.len() > 20, "{answer}");
        assert_eq!(answer, said(dir.path(), ours));
    }
    let help = said(dir.path(), &["check", "--help"]);
    assert!(help.contains("-w, --watch"), "{help}");
}

#[test]
fn patterns_leave_out_files() {
    let settings = "exclude = [\"a.zpg\"]\n";
    let dir = folder(&[
        ("a.zpg", SCENE),
        ("old/b.zpg", SCENE),
        ("c.zpg", SCENE),
        ("zpg.toml", settings),
    ]);
    let files = |arguments: &[&str]| {
        let run = program::zpg(
            dir.path(),
            &[&["check", "--show-files"], arguments].concat(),
        );
        let names = text(&run.stdout);
        let name = |line: &str| Path::new(line).file_name().unwrap().to_owned();
        names.lines().map(name).collect::<Vec<_>>()
    };
    assert_eq!(files(&[]), ["c.zpg", "b.zpg"]);
    // As in ruff, the option counts in place of the setting.
    assert_eq!(files(&["--exclude", "old"]), ["a.zpg", "c.zpg"]);
    assert_eq!(files(&["--exclude", "old,c.zpg"]), ["a.zpg"]);
    assert_eq!(files(&["--exclude", "old", "--exclude", "a*"]), ["c.zpg"]);
    let diff = said(dir.path(), &["fmt", "--check", "--exclude", "*.zpg"]);
    assert!(!diff.contains("b.zpg"), "{diff}");
    let wrong = said(dir.path(), &["check", "--exclude", "a["]);
    assert!(wrong.contains("`a[` is not a file pattern"), "{wrong}");
}

#[test]
fn more_codes_are_selected() {
    let off = "[lint]\nall = \"off\"\n";
    let scene = "1 9999 2 0\n2 11 0 0 0 1\n3 11 5 0 0 1\n";
    let dir = folder(&[("a.zpg", scene), ("zpg.toml", off)]);
    let short = |arguments: &[&str]| {
        said(
            dir.path(),
            &[&["check", "--format", "short"], arguments].concat(),
        )
    };
    assert_eq!(short(&[]), "");
    let camera = short(&["--extend-select", "N602"]);
    assert!(
        camera.contains(" N602 ") && camera.lines().count() == 1,
        "{camera}"
    );
    // What is on stays on.
    let both = short(&["--isolated", "--extend-select", "N602"]);
    assert!(both.lines().count() > 1, "{both}");
    assert_eq!(both, short(&["--isolated"]));
    assert_eq!(
        short(&["--select", "W3", "--extend-select", "N602"])
            .lines()
            .count(),
        camera.lines().count() + short(&["--select", "W3"]).lines().count()
    );
}

#[test]
fn other_words_of_ruff_have_an_answer() {
    let drawn = "2 11 0 1 0 1\n1 9999 2 0\n";
    let dir = folder(&[("a.zpg", SCENE), ("b.zpg", drawn)]);
    for (arguments, answer) in [
        (
            &["check", "--fix-only"][..],
            "`zpg check --fix` fixes what it can and then reports what is left",
        ),
        (
            &["check", "--show-fixes"],
            "`--diff` shows what `--fix` would change",
        ),
        (
            &["check", "--add-noqa"],
            "zpg calls it `zpg check --add-allow`",
        ),
        (
            &["check", "--extend-exclude=old"],
            "zpg calls it `--exclude`",
        ),
        (&["check", "--no-cache"], "zpg keeps no cache"),
        (&["check", "--verbose"], "zpg says all that it found"),
        (&["check", "-v"], "zpg says all that it found"),
        (
            &["format", "--line-length", "100"],
            "zpg calls it `--config format.width=100`",
        ),
        (
            &["config"],
            "`zpg check --show-settings` shows all settings",
        ),
        (&["server"], "zpg calls it `zpg lsp`"),
        (&["init"], "zpg calls it `zpg new`"),
        (&["compare", "a.zpg"], "zpg calls it `zpg crosscheck`"),
        (&["view", "a.zpg"], "zpg calls it `zpg render`"),
        (&["new", "a.zpg", "glass"], "zpg calls it `--from glass`"),
        (&["fmt", "a.zpg", "-o", "b.zpg"], "`zpg fmt - < scene.zpg`"),
        (&["check", "--no-fix"], "writes nothing without `--fix`"),
        (&["render", "--width", "320"], "`--size 640x480`"),
        (
            &["fmt", "--width", "80"],
            "zpg calls it `--config format.width=80`",
        ),
        (
            &["render", "--antialias", "0.3"],
            "zpg calls it `--samples`",
        ),
        (&["version"], "zpg calls it `zpg --version`"),
        (&["render", "-j", "4"], "zpg calls it `--threads`"),
        (
            &["render", "a.zpg", "-s", "160x120"],
            "zpg calls it `--size`",
        ),
        (&["render", "a.zpg", "--res", "160x120"], "`--size 640x480`"),
        (&["render", "a.zpg", "+W160", "+H120"], "`--size 160x120`"),
        (&["render", "a.zpg", "+Oout.png"], "`-o out.png`"),
        (&["render", "a.zpg", "+A0.3"], "zpg calls it `--samples`"),
        (&["render", "a.zpg", "+A"], "zpg calls it `--samples`"),
        (&["render", "a.zpg", "+KFF30"], "`--frames 0-29"),
        (&["render", "a.zpg", "+K0.5"], "named by `--set`"),
        (&["render", "a.zpg", "Clock=0.5"], "named by `--set`"),
        (&["render", "a.zpg", "--clock", "3"], "named by `--set`"),
        (
            &["render", "a.zpg", "Width=160", "Height=120"],
            "`--size 160x120`",
        ),
        (&["render", "a.zpg", "+WT2"], "`--threads 2`"),
        (&["render", "a.zpg", "+R3"], "zpg calls it `--samples`"),
        (
            &["render", "a.zpg", "Declare=x=1"],
            "zpg has no such option",
        ),
        (&["render", "a.zpg", "+P"], "zpg has no such option"),
        (&["render", "a.zpg", "+GA"], "zpg has no such option"),
        (&["render", "a.zpg", "+UA"], "zpg has no such option"),
        (&["fmt", "-l", "88", "a.zpg"], "`--config format.width=88`"),
        (&["render", "a.zpg", "+Q9"], "`--quality draft`"),
        (&["render", "a.zpg", "+FN"], "the ending of `-o`"),
        (&["render", "+Ia.zpg"], "`zpg render a.zpg`"),
        (&["render", "a.zpg", "out.png"], "`-o out.png`"),
        (&["convert", "a.zpg", "out.pov"], "`-o out.pov`"),
        (
            &["convert", "a.zpg", "--format", "pov"],
            "`zpg convert` calls it `--to`",
        ),
        (
            &["render", "a.zpg", "--fov", "40"],
            "the angle of view is the last number",
        ),
        (
            &["render", "a.zpg", "--background", "1,1,1"],
            "the second number of the render record",
        ),
        (&["fmt", "-w", "a.zpg"], "`zpg fmt` writes into the files"),
        // Decimal commas.
        (
            &["render", "a.zpg", "--exposure", "0,5"],
            "write `0.5`, with a decimal point",
        ),
        (&["convert", "a.zpg", "--tolerance", "0,01"], "write `0.01`"),
        // Words of other programs.
        (&["render", "--preview", "a.zpg"], "`--quality draft`"),
        (&["check", "--dry-run", "a.zpg"], "zpg calls it `--diff`"),
        (&["fmt", "--dry-run", "a.zpg"], "zpg calls it `--diff`"),
        (&["fmt", "--stdout", "a.zpg"], "`zpg fmt - < scene.zpg`"),
        (&["check", "--warnings-as-errors"], "`--deny warnings`"),
        (&["render", "--camera", "top", "a.zpg"], "`--view top`"),
        (&["probe", "--json", "a.zpg"], "always writes JSON"),
        (&["accuracy", "a.zpg", "--samples", "4"], "`--axes`"),
        (&["accuracy", "a.zpg", "--adaptive"], "`--axes`"),
        (&["accuracy", "a.zpg", "--depth=4"], "`--axes`"),
        (&["accuracy", "a.zpg", "--precision", "f32"], "`--axes`"),
        (&["accuracy", "a.zpg", "--quality", "draft"], "`--axes`"),
        (&["generate-shell-completion", "bash"], "`zpg completions`"),
        (
            &["--config", "format.width=100", "check", "a.zpg"],
            "`zpg check --config`",
        ),
        (&["--isolated", "check", "a.zpg"], "`zpg check --isolated`"),
        (&["check", "--json", "a.zpg"], "`--format json`"),
        (
            &["plan", "a.zpg", "--format", "json"],
            "zpg calls it `--json`",
        ),
        (
            &["plan", "--output-format=json", "a.zpg"],
            "zpg calls it `--json`",
        ),
        (
            &["crosscheck", "a.zpg", "--format", "json"],
            "zpg calls it `--json`",
        ),
        (
            &["accuracy", "a.zpg", "--format", "json"],
            "zpg calls it `--json`",
        ),
        (&["check", "fix", "a.zpg"], "`zpg check --fix`"),
        (&["napoveda"], "`zpg --help`"),
        (&["nápověda"], "`zpg --help`"),
        (&["kontrola", "a.zpg"], "`zpg check`"),
        (&["převeď", "a.zpg"], "`zpg convert`"),
        (&["render", "a.zpg", "--rozměr=64x48"], "`--size`"),
        (&["render", "a.zpg", "--kvalita", "good"], "`--quality`"),
        (&["check", "--jazyk", "cs", "a.zpg"], "`--lang`"),
        (&["--verze"], "`--version`"),
        (&["render", "a.zpg", "-v"], "`--cost` prints"),
        (
            &["farm", "a.zpg", "-o", "job"],
            "missing: --for <ENGINE> (openjd, slurm, shell)",
        ),
        (
            &["crosscheck", "a.zpg", "--lang", "cs"],
            "chybí: --with <PROGRAM> (povray, mitsuba)",
        ),
        (
            &["render", "a.zpg", "--format", "jpg", "--lang", "cs"],
            "`-o obrazek.png`",
        ),
        (
            &["check", "--add-ignore"],
            "zpg calls it `zpg check --add-allow`",
        ),
        (
            &["rule", "W310", "--output-format", "json"],
            "`zpg explain` writes Markdown",
        ),
        (&["rule", "--all"], "without an argument lists all"),
        (
            &["fmt", "--output-format", "json"],
            "`--diff` shows what would change",
        ),
        (&["render", "b.zpg", "--max-depth", "5"], "`--depth 5`"),
        (&["render", "b.zpg", "--max-bounces=5"], "`--depth 5`"),
        (&["render", "b.zpg", "-W160", "-H120"], "`--size 160x120`"),
        (
            &["render", "b.zpg", "--width", "320", "--height=200"],
            "`--size 320x200`",
        ),
        (&["convert", "b.zpg", "-t", "pov"], "`--to pov`"),
        (
            &["convert", "b.zpg", "-o", "x.png"],
            "x.png is a picture: `zpg render b.zpg -o x.png` draws it",
        ),
        (&["render", "-i", "b.zpg"], "on its own, without `-i`"),
        (
            &["render", "b.zpg", "-o", "x.gif"],
            "`-o x.png` makes a still picture",
        ),
        (
            &["check", "a.zpg", "--stdin-filename", "b.zpg"],
            "`--stdin-filename` names standard input, so a.zpg is not read",
        ),
        // A folder that is not there.
        (
            &["convert", "b.zpg", "--to", "pov", "-o", "c/b.pov"],
            "there is no folder c",
        ),
        (
            &["render", "b.zpg", "-o", "c/b.png"],
            "there is no folder c",
        ),
        (
            &["check", "--per-file-ignores", "*:W310"],
            "`--config 'lint.per-file-ignores={\"*\" = [\"W310\"]}'`",
        ),
    ] {
        let run = program::zpg(dir.path(), arguments);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}");
        let error = text(&run.stderr);
        assert!(error.contains(answer), "{arguments:?}: {error}");
        assert!(!error.contains("did you mean"), "{arguments:?}: {error}");
    }
    // Pictures alone have a number of threads.
    let run = program::zpg(dir.path(), &["check", "-j", "4"]);
    assert!(!text(&run.stderr).contains("--threads"));
    let run = program::zpg(dir.path(), &["help", "--help"]);
    assert!(run.status.success() && text(&run.stdout).contains("Usage: zpg"));
    // Nothing was drawn before the answer.
    assert!(!dir.path().join("a.png").exists());
    // What is proposed is right.
    for proposal in [
        &[
            "check",
            "--config",
            "lint.per-file-ignores={\"*\" = [\"W310\"]}",
        ][..],
        &["fmt", "--check", "--config", "format.width=100"],
        &["--version"],
    ] {
        let run = program::zpg(dir.path(), proposal);
        assert_ne!(run.status.code(), Some(2), "{proposal:?}");
    }
}

#[test]
fn a_name_for_standard_input_means_standard_input() {
    let dir = folder(&[("a.zpg", "2   9 0,5\n")]);
    for (arguments, printed) in [
        (&["fmt"][..], "2 9 0.5\n"),
        (&["check", "--fix"], "2   9 0.5\n"),
    ] {
        let arguments = [arguments, &["--stdin-filename", "a.zpg"]].concat();
        let scene = printed.replace("2 9", "2   9");
        let run = program::zpg_with(dir.path(), &arguments, &scene);
        assert_eq!(text(&run.stdout), printed, "{}", text(&run.stderr));
    }
    let check = ["check", "--stdin-filename", "b.zpg", "--format", "short"];
    let run = program::zpg_with(dir.path(), &check, "2 11 0 0 0 -1\n1 9999 2 0\n");
    assert!(text(&run.stdout).contains("b.zpg:1:12: E201"));
    let a = std::fs::read_to_string(dir.path().join("a.zpg")).unwrap();
    assert_eq!(a, "2   9 0,5\n");
}

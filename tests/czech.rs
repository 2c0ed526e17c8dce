//! Whoever reads only Czech gets along: what the program says in Czech has no English in it. What programs read,
//! and what is written into files, is the same in both languages.

use std::fs;
use std::path::Path;
use std::process::Output;

use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Language, Span};
use zpg::internals::features::{completion, hints, hover, signature};
use zpg::internals::syntax::table::RECORD_TYPES;

use crate::support::program::{self, folder, text};

/// Words that English can hardly do without and Czech does not have.
const ENGLISH: &str = "\
    the of is are not with and or for this that it its from at be has have no nothing file files line \
    error errors warning scene picture pixels use usage options option default print found cannot \
    expected unexpected missing number numbers wrote fixed invalid value values which there every \
    each one two more other what where shape shapes object record records";

/// A scene with a bit of everything, right.
const GOOD: &str = "\
2 11  0 1 0  1
2 -701 0.9 0.2 0.1
2 -202  0.5 0.3 0.1  0.5 0.3 0.1  0.5 0.3 0.1
2 -203 1.5 1.5 1.6
3 4  0 1 0  0
5 -701 0.1 0.1 0.1
6 -701 0.9 0.9 0.9
3 -399 1 1 5 6
7 14 1 0.25
7 -1 3 1 0
4 -101 2 3
8 -101 4 7
11 12 40 0 0 41 1 1
9 -501  0 3 8  0 -0.25 -1  0 1 0  45
50 -402 0.8
50 -1 3 5 5
51 -401 0.2
1 9999 8 0
";

/// A decimal comma, a lost number, an ID of nothing, and what rules warn of.
const BROKEN: &str = "\
2 9 0,5
3 12 0 0 0  1 1
4 -101 2 33
4 -701 2 0 0
9 -501  0 3 8  0 -0.25 -1  0 1 0  45
1 9999 4 0
";

/// Mistakes that are mended safely, and no others.
const MENDED: &str =
    "2 9 0,5 # koule\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

/// Runs zpg for somebody whose system is Czech.
fn in_czech(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = program::command();
    command.env("LC_ALL", "cs_CZ.UTF-8").args(arguments);
    command.current_dir(folder).output().expect("zpg runs")
}

/// The first English word of a text, apart from code.
fn english(text: &str) -> Option<String> {
    let fences = text.split("```").step_by(2).collect::<String>();
    let lines = fences.lines().map(|line| match line.split_once(" = ") {
        // A setting, and the parameters of a record.
        Some((_, meaning)) => meaning,
        None if line.starts_with("    ID ") => "",
        None => match line.strip_prefix("    ").map(|l| l.split_once(' ')) {
            Some(rest) => rest.map_or("", |(_, meaning)| meaning),
            None => line,
        },
    });
    let fences = lines.collect::<Vec<_>>().join("\n");
    let prose = fences.split('`').step_by(2).collect::<Vec<_>>().join(" ");
    let lower = prose.to_lowercase();
    let words = lower.split(|c: char| c.is_whitespace() || ".,:;()[]{}„“\"|".contains(c));
    let found = words
        .into_iter()
        .find(|w| ENGLISH.split(' ').any(|english| english == *w));
    found.map(|word| format!("`{word}` in:\n{text}"))
}

#[track_caller]
fn is_czech(dir: &Path, arguments: &[&str], status: i32) -> String {
    let run = in_czech(dir, arguments);
    let said = text(&run.stdout) + &text(&run.stderr);
    assert_eq!(run.status.code(), Some(status), "{arguments:?}: {said}");
    if let Some(found) = english(&said) {
        panic!("{arguments:?}: {found}");
    }
    said
}

const COMMANDS: [&str; 16] = [
    "check",
    "new",
    "fmt",
    "convert",
    "crosscheck",
    "render",
    "probe",
    "plan",
    "accuracy",
    "farm",
    "join",
    "sheet",
    "explain",
    "lsp",
    "completions",
    "man",
];

#[test]
fn from_help_to_a_picture() {
    let dir = folder(&[("scena.zpg", MENDED)]);
    let help = is_czech(dir.path(), &["--help"], 0);
    assert!(help.contains("zpg check scena.zpg") && help.contains("zpg render scena.zpg"));
    let said = is_czech(dir.path(), &["check", "scena.zpg"], 1);
    assert!(said.contains("`zpg check --fix` opraví"), "{said}");
    let code = said.split("chyba[").nth(1).unwrap().split(']').next();
    is_czech(dir.path(), &["explain", code.unwrap()], 0);
    is_czech(dir.path(), &["check", "--fix", "scena.zpg"], 0);
    is_czech(dir.path(), &["check", "scena.zpg"], 0);
    is_czech(dir.path(), &["fmt", "scena.zpg"], 0);
    let said = is_czech(dir.path(), &["render", "scena.zpg", "--size", "16x12"], 0);
    assert_eq!(said, "Zapsáno: scena.png, 16 × 12 pixelů\n");
    assert!(dir.path().join("scena.png").exists());
}

#[test]
fn help_of_all_commands() {
    let dir = folder::<&str>(&[]);
    for command in COMMANDS {
        let long = is_czech(dir.path(), &[command, "--help"], 0);
        assert!(long.contains("Použití: zpg "), "{long}");
        is_czech(dir.path(), &[command, "-h"], 0);
        assert_eq!(is_czech(dir.path(), &["help", command], 0), long);
    }
    let all = is_czech(dir.path(), &["-h"], 0);
    for command in COMMANDS {
        assert!(all.contains(&format!("\n  {command} ")), "{all}");
    }
    is_czech(dir.path(), &["help", "help"], 0);
    assert_eq!(
        is_czech(dir.path(), &["--version"], 0),
        format!("zpg {}\n", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn wrong_usage() {
    let dir = folder(&[("a.zpg", GOOD)]);
    for arguments in [
        &["chek"][..],
        &["help", "chek"],
        &["check", "--fixx"],
        &["check", "--fix=1"],
        &["check", "--fix", "--fix"],
        &["check", "--fix", "--watch"],
        &["check", "--format", "xml"],
        &["check", "--select", "W399"],
        &["check", "--memory", "x"],
        &["render"],
        &["plan", "a.zpg", "b.zpg"],
        &["render", "a.zpg", "--depth", "x"],
        &["render", "a.zpg", "--depth", "99999999999"],
        &["render", "a.zpg", "--threads", "-1"],
        &["render", "a.zpg", "--camera", "1.5"],
        &["render", "a.zpg", "--size", "9"],
        &["render", "a.zpg", "--size"],
        &["render", "a.zpg", "--samples", "0"],
        &["render", "a.zpg", "--adaptive", "2"],
        &["render", "a.zpg", "--cutoff", "2"],
        &["render", "a.zpg", "--crop", "1"],
        &["render", "a.zpg", "--precision", "f16"],
        &["render", "a.zpg", "--stereo", "x"],
        &["render", "a.zpg", "--adaptive", "0.1", "--samples", "2"],
        &["convert", "a.zpg"],
        &["convert", "a.zpg", "--to", "png"],
        &["convert", "a.zpg", "--to", "pov", "--tolerance", "x"],
        &["crosscheck", "a.zpg", "--with", "blender"],
        &["crosscheck", "a.zpg", "--with", "povray", "--max-diff", "0"],
        &["probe", "a.zpg"],
        &["probe", "a.zpg", "--ray", "1 2 3"],
        &["probe", "a.zpg", "--ray", "0 0 0 0 0 0"],
        &["probe", "a.zpg", "--point", "x"],
        &["probe", "a.zpg", "--pixel", "1"],
        &[
            "probe",
            "a.zpg",
            "--ray",
            "0 0 9 0 0 -1",
            "--point",
            "0 0 0",
        ],
        &["fmt", "--range", "x", "a.zpg"],
        &["sheet", "."],
        &["sheet", ".", "-o", "x.gif"],
        &["sheet", ".", "-o", "x.png", "--size", "1x1"],
        &["sheet", ".", "-o", "x.png", "--columns", "0"],
        &["accuracy"],
        &["accuracy", "a.zpg", "--axes", "x"],
        &["accuracy", "a.zpg", "--budget", "x"],
        &["accuracy", "a.zpg", "--goal", "0"],
        &["accuracy", "a.zpg", "--runs", "0"],
        &["explain", "W999"],
        &["explain", "kouule"],
        &["completions", "cmd"],
        &["man", "rendr"],
        &["lsp", "--tcp"],
        &["--color", "x"],
        &["--lang"],
        &["--lang", "de"],
    ] {
        let said = is_czech(dir.path(), arguments, 2);
        assert!(said.starts_with("chyba: "), "{arguments:?}: {said}");
    }
}

#[cfg(unix)]
#[test]
fn an_argument_that_is_no_text() {
    use std::os::unix::ffi::OsStrExt as _;
    let dir = folder::<&str>(&[]);
    let argument = std::ffi::OsStr::from_bytes(b"\xff");
    let mut command = program::command();
    command.env("LC_ALL", "cs").arg("explain").arg(argument);
    let run = command.current_dir(dir.path()).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
    let said = text(&run.stderr);
    assert!(said.starts_with("chyba: některý argument není text v UTF-8\n"));
    assert_eq!(english(&said), None);
}

#[test]
fn a_good_scene() {
    let dir = folder(&[("a.zpg", GOOD)]);
    let dir = dir.path();
    is_czech(dir, &["check", "a.zpg"], 0);
    is_czech(dir, &["check", "--statistics", "a.zpg"], 0);
    is_czech(dir, &["check", "--show-files"], 0);
    let plan = is_czech(dir, &["plan", "a.zpg"], 0);
    assert!(
        plan.contains("ambientní světlo     ano  jeden součet"),
        "{plan}"
    );
    assert!(plan.contains("nevykreslená ID      11\n"), "{plan}");
    let small = ["--size", "16x12", "a.zpg"];
    for arguments in [
        &["render", "--cost"][..],
        &["render", "--heatmap", "map.png", "--threads", "999"],
        &["render", "--adaptive", "0.1", "--stats", "stats.json"],
    ] {
        is_czech(dir, &[arguments, &small].concat(), 0);
    }
    for target in ["pov", "mitsuba", "ply", "obj", "glb", "json", "zpg"] {
        // Any format may go to a file of this name.
        let output = format!("out/{target}.new");
        fs::create_dir_all(dir.join("out")).unwrap();
        for verbose in [&["--verbose"][..], &[]] {
            let arguments = ["convert", "a.zpg", "--force", "--to", target, "-o", &output];
            is_czech(dir, &[&arguments, verbose].concat(), 0);
        }
    }
    is_czech(
        dir,
        &[
            "accuracy", "a.zpg", "--size", "8x6", "--budget", "1s", "--runs", "1",
        ],
        0,
    );
    is_czech(dir, &["fmt", "--diff", "a.zpg"], 1);
    is_czech(dir, &["fmt", "--check", "a.zpg"], 1);
    is_czech(dir, &["fmt", "a.zpg"], 0);
    is_czech(dir, &["fmt", "a.zpg"], 0);
}

#[test]
fn a_broken_scene() {
    let dir = folder(&[
        ("a.zpg", BROKEN),
        ("b.zpg", MENDED),
        ("c.zpg", "2 9 1\n"),
        ("d.zpg", "text\n"),
    ]);
    let dir = dir.path();
    for format in ["human", "short"] {
        is_czech(
            dir,
            &["check", "--format", format, "a.zpg", "b.zpg", "c.zpg"],
            1,
        );
    }
    is_czech(dir, &["check", "d.zpg"], 2);
    is_czech(dir, &["check", "--statistics", "a.zpg"], 1);
    is_czech(dir, &["check", "--diff", "b.zpg"], 1);
    for command in [
        &["render"][..],
        &["plan"],
        &["accuracy"],
        &["probe", "--ray", "0 0 9 0 0 -1"],
        &["crosscheck", "--with", "povray"],
        &["convert", "--to", "pov"],
    ] {
        is_czech(dir, &[command, &["a.zpg"]].concat(), 1);
        is_czech(dir, &[command, &["c.zpg"]].concat(), 1);
        is_czech(dir, &[command, &["d.zpg"]].concat(), 2);
    }
    is_czech(dir, &["fmt", "--check", "a.zpg", "d.zpg"], 2);
    is_czech(dir, &["check", "--add-allow", "a.zpg"], 1);
    is_czech(dir, &["check", "--fix", "--unsafe-fixes", "a.zpg"], 1);
}

/// What is said goes with the gender of what it is said of.
#[test]
fn genders_agree() {
    let said = |text: &str, code: Code| {
        let analysis = Analysis::new("scene.zpg", text.as_bytes().to_vec());
        let finding = analysis.findings().iter().find(|d| d.code == code);
        let words = finding.unwrap().wording(Language::Czech);
        format!("{}; {}", words.message, words.labels.join("; "))
    };
    let twice = said("2 9 1\n1 9999 2 0\n1 9999 2 0\n", Code::E102);
    assert!(twice.contains("první renderovací záznam je zde"), "{twice}");
    let kind = said("2 9 1\n3 -201 1 0 0\n2 -299 3 0\n1 9999 2 0\n", Code::E103);
    assert!(
        kind.starts_with("3 je optická vlastnost; má to být textura nebo barva"),
        "{kind}"
    );
    let outside = "2 9 1\n3 11 90 0 0 1\n4 -101 2 3\n1 9999 4 0 -5 -5 -5 5 5 5\n";
    let outside = said(outside, Code::W312);
    assert!(outside.contains("leží zcela mimo"), "{outside}");
}

#[test]
fn a_file_that_is_not_there() {
    let dir = folder(&[
        ("a.zpg", GOOD),
        ("t.toml", "x = ["),
        ("u.toml", "[lint]\nW30 = 1\n"),
        ("k.json", "{\"a\": }"),
    ]);
    fs::create_dir(dir.path().join("empty")).unwrap();
    let dir = dir.path();
    for arguments in [
        &["check", "x.zpg"][..],
        &["fmt", "x.zpg"],
        &["render", "x.zpg"],
        &["plan", "x.zpg"],
        &["accuracy", "x.zpg"],
        &["probe", "x.zpg", "--ray", "0 0 9 0 0 -1"],
        &["probe", "a.zpg", "--rays", "x.txt"],
        &["probe", "a.zpg", "--pixel", "999,999"],
        &["probe", "a.zpg", "--point", "0 0 0", "--object", "77"],
        &["probe", "a.zpg", "--point", "0 0 0", "--object", "50"],
        &["crosscheck", "x.zpg", "--with", "povray"],
        &["sheet", "empty", "-o", "x.png"],
        &["sheet", "x", "-o", "x.png"],
        &["sheet", "a.zpg", "-o", "x.png"],
        &[
            "crosscheck",
            "a.zpg",
            "--with",
            "povray",
            "--program",
            "./nothing",
            "--size",
            "8x6",
        ],
        &[
            "crosscheck",
            "a.zpg",
            "--with",
            "mitsuba",
            "--program",
            "./nothing",
            "--size",
            "8x6",
        ],
        &["convert", "x.zpg", "--to", "pov"],
        &["convert", "a.zpg", "--to", "mitsuba"],
        &["convert", "a.zpg", "--to", "json", "-o", "a.zpg"],
        &["render", "a.zpg", "-o", "x/y.png"],
        &["render", "a.zpg", "-o", "x.gif"],
        &["render", "a.zpg", "--camera", "7"],
        &["render", "a.zpg", "--stereo", "pair"],
        &["render", "a.zpg", "--crop", "600,0,100,100"],
        &["render", "a.zpg", "--size", "99999x99999"],
        &["render", "a.zpg", "--memory", "1K"],
        &["check", "a.zpg", "--config", "t.toml"],
        &["check", "a.zpg", "--config", "u.toml"],
        &["check", "a.zpg", "--config", "lint.W307=\"x\""],
        &["check", "a.zpg", "--config", "exclude=[\"[\"]"],
        &["check", "a.zpg", "--ignore", "E101"],
        &["check", "--fix", "k.json"],
        &["fmt", "k.json"],
        &["check", "--statistics", "--format", "short", "a.zpg"],
    ] {
        let said = is_czech(dir, arguments, 2);
        assert!(said.contains("chyba: "), "{arguments:?}: {said}");
    }
    is_czech(dir, &["check", "k.json"], 1);
    is_czech(dir, &["check", "empty"], 0);
}

#[test]
fn all_pages() {
    let dir = folder::<&str>(&[]);
    let index = is_czech(dir.path(), &["explain"], 0);
    let codes = Code::ALL.iter().map(|c| c.as_str().to_owned());
    for topic in codes.chain(RECORD_TYPES.iter().map(|t| t.code.to_string())) {
        assert!(index.contains(&topic));
        is_czech(dir.path(), &["explain", &topic], 0);
    }
}

/// Hover, hints, the parameters of a record and completion, everywhere in a scene.
#[test]
fn what_editors_show() {
    let scene = Analysis::new("a.zpg", GOOD.into());
    let _ = scene.findings();
    let language = Language::Czech;
    let shown = |text: &str| {
        if let Some(found) = english(text) {
            panic!("{found}");
        }
    };
    let all = Span::new(0, GOOD.len() as u32);
    for hint in hints::hints(&scene, all, hints::Wanted::default(), language) {
        shown(&hint.doc);
    }
    for at in 0..=GOOD.len() as u32 {
        if let Some(hover) = hover::hover(&scene, at, language) {
            shown(&hover.markdown);
        }
        if let Some(signature) = signature::signature(&scene, at, language) {
            shown(&signature.doc);
            signature.params.iter().for_each(|p| shown(&p.doc));
        }
        let found = completion::completion(&scene, at, language);
        found.proposals.iter().for_each(|p| shown(&p.doc));
    }
}

/// The variables, and `--lang` above them.
#[test]
fn the_language_is_chosen() {
    let dir = folder(&[("a.zpg", "2 9 -1\n1 9999 2 0\n")]);
    let speaks = |variables: &[(&str, &str)], arguments: &[&str]| {
        let mut command = program::command();
        for name in ["LC_ALL", "LC_MESSAGES", "LANG"] {
            command.env_remove(name);
        }
        command.envs(variables.iter().copied());
        command.args(["check", "a.zpg"]).args(arguments);
        let run = command.current_dir(dir.path()).output().unwrap();
        match text(&run.stdout).split('[').next() {
            Some("chyba") => "cs",
            Some("error") => "en",
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(speaks(&[], &[]), "en");
    assert_eq!(speaks(&[("LANG", "cs_CZ.UTF-8")], &[]), "cs");
    assert_eq!(
        speaks(&[("LANG", "en_GB"), ("LC_MESSAGES", "cs")], &[]),
        "cs"
    );
    assert_eq!(speaks(&[("LC_ALL", "C"), ("LC_MESSAGES", "cs")], &[]), "en");
    assert_eq!(speaks(&[("LC_ALL", ""), ("LANG", "czech")], &[]), "cs");
    assert_eq!(speaks(&[("LC_ALL", "cs_CZ")], &["--lang", "en"]), "en");
    assert_eq!(speaks(&[("LC_ALL", "C")], &["--lang", "cs"]), "cs");
}

/// What services show to people is in their language, and tells findings apart in the same way in all.
#[test]
fn services_show_messages_in_the_language() {
    let dir = folder(&[("b.zpg", "2 9 1\n1 9999 7 0\n")]);
    let out = |language: &str, format: &str| {
        let arguments = ["check", "--format", format, "b.zpg", "--lang", language];
        text(&program::zpg(dir.path(), &arguments).stdout)
    };
    for format in ["github", "gitlab", "junit"] {
        let (english, czech) = (out("en", format), out("cs", format));
        assert!(english.contains("7 is not defined"), "{english}");
        assert!(
            czech.contains("7 není definováno") && !czech.contains("not defined"),
            "{czech}"
        );
        // As many lines, with the same codes; a label that only points says nothing in either.
        assert_eq!(english.lines().count(), czech.lines().count());
        assert!(english.contains("E101") && czech.contains("E101"));
        assert!(
            !czech.contains("%0Azde") && !czech.contains("; zde"),
            "{czech}"
        );
    }
    let prints = |language: &str| {
        let issues: serde_json::Value = serde_json::from_str(&out(language, "gitlab")).unwrap();
        let all = issues.as_array().unwrap().iter();
        all.map(|issue| issue["fingerprint"].clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(prints("en"), prints("cs"));
}

/// Comments of translations are for people; all else in them is the same.
#[test]
fn comments_of_translations_are_czech() {
    let sphere = "2 9 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    let dir = folder(&[("a.zpg", sphere)]);
    let written = |language: &str, to: &str| {
        let arguments = ["convert", "a.zpg", "--to", to, "--lang", language];
        text(&program::zpg(dir.path(), &arguments).stdout)
    };
    let bare = |text: &str| {
        let lines = text
            .lines()
            .map(|line| line.split("//").next().unwrap_or(""));
        lines
            .map(|line| line.split('#').next().unwrap_or("").trim_end().to_owned())
            .collect::<Vec<_>>()
    };
    for (to, words) in [
        (
            "pov",
            ["// Scéna pro POV-Ray", "// Tolikrát se hotová scéna"],
        ),
        ("zpg", ["0 # světla #", "0 # co se zobrazí #"]),
    ] {
        let [english, czech] = ["en", "cs"].map(|language| written(language, to));
        assert_eq!(bare(&english), bare(&czech));
        for words in words {
            assert!(czech.contains(words), "{czech}");
        }
    }
    // What a solid texture is without its numbers, in words.
    let page = is_czech(dir.path(), &["explain", "-302"], 0);
    assert!(
        page.contains("výchozí černá") && page.contains("výchozí bílá"),
        "{page}"
    );
}

/// Numbers and what they count; an ID behind the noun of a long name.
#[test]
fn numbers_agree_with_nouns() {
    let scene = "2 9 2\n3 9 1\n4 -103 3 2\n9 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 4 0\n";
    let dir = folder(&[
        ("a.zpg", scene),
        ("b.zpg", "2 9 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 2 0\n"),
    ]);
    let said = is_czech(dir.path(), &["check", "a.zpg"], 0).replace("\n  ", " ");
    assert!(said.contains("koule 3 se středem v počátku"), "{said}");
    for (frames, words) in [("2", "první 2 kreslí"), ("5", "prvních 5 kreslí")] {
        let arguments = [
            "render", "b.zpg", "-o", "b.png", "--size", "8x6", "--frames", frames, "--orbit",
            "9,360",
        ];
        let said = is_czech(dir.path(), &arguments, 0).replace("\n  ", " ");
        assert!(said.contains(words), "{said}");
    }
}

/// What programs read does not depend on the language.
#[test]
fn machines_are_spoken_to_in_one_language() {
    let dir = folder(&[("a.zpg", GOOD), ("b.zpg", BROKEN)]);
    let out = |language: &str, arguments: &[&str]| {
        let run = program::zpg(dir.path(), &[arguments, &["--lang", language]].concat());
        text(&run.stdout)
    };
    for arguments in [
        &["check", "--format", "json", "b.zpg"][..],
        &["check", "--format", "sarif", "b.zpg"],
        &["check", "--statistics", "--format", "json", "b.zpg"],
        &["check", "--show-settings", "b.zpg"],
        &["plan", "--json", "a.zpg"],
        &["probe", "a.zpg", "--ray", "0 0 9 0 0 -1"],
        &["convert", "a.zpg", "--to", "json"],
        &["completions", "bash"],
    ] {
        let english = out("en", arguments);
        assert!(english.len() > 50, "{arguments:?}");
        assert_eq!(english, out("cs", arguments), "{arguments:?}");
    }
    let report = |language: &str| {
        let arguments = [
            "accuracy", "a.zpg", "--size", "8x6", "--budget", "1s", "--axes", "depth", "--json",
        ];
        let json: serde_json::Value = serde_json::from_str(&out(language, &arguments)).unwrap();
        let why = json["skipped"]
            .as_array()
            .unwrap()
            .iter()
            .map(|s| s["why"].clone());
        let advice = json["advice"].as_str().unwrap();
        assert!(
            !advice.contains(['ě', 'š', 'č', 'ř', 'ž', 'á', 'í']),
            "{advice}"
        );
        why.collect::<Vec<_>>()
    };
    assert_eq!(report("en"), report("cs"));
    let file = |language: &str, name: &str| {
        let arguments = [
            "convert", "a.zpg", "--to", "obj", "-o", "a.obj", "--report", "r.json",
        ];
        out(language, &arguments);
        fs::read_to_string(dir.path().join(name)).unwrap()
    };
    for name in ["a.obj", "a.mtl", "r.json"] {
        assert_eq!(file("en", name), file("cs", name), "{name}");
    }
}

/// Numbers of reports have a comma; those of the scene, of options and of file names are code, with a point.
#[test]
fn numbers_of_reports_have_a_comma() {
    let scene = MENDED.replace("0,5 # koule", "0.5");
    let dir = folder(&[("a.zpg", &scene)]);
    let mut commas = 0;
    for arguments in [
        &["convert", "a.zpg", "--to", "glb", "--verbose"][..],
        &[
            "convert",
            "a.zpg",
            "--to",
            "ply",
            "--tolerance",
            "0.0125",
            "--verbose",
        ],
        &[
            "convert",
            "a.zpg",
            "--to",
            "pov",
            "-o",
            "a.pov",
            "--verbose",
        ],
        &["render", "a.zpg", "--size", "16x12", "--cost"],
    ] {
        let run = program::zpg(dir.path(), &[arguments, &["--lang", "cs"]].concat());
        let said = [run.stdout, run.stderr].concat();
        let said = String::from_utf8(said).unwrap();
        assert!(run.status.success(), "{said}");
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        for word in said
            .split_whitespace()
            .filter(|w| !w.contains('=') && !w.starts_with('-'))
        {
            for (sign, counts) in [('.', true), (',', false)] {
                let parts: Vec<&str> = word.split(sign).collect();
                let between = parts
                    .windows(2)
                    .any(|p| digit(p[0].chars().last()) && digit(p[1].chars().next()));
                assert!(!(between && counts), "{word} in: {said}");
                commas += usize::from(between && !counts);
            }
        }
    }
    // Times may have none.
    assert!(commas >= 1, "{commas}");
}

/// Numbers in Czech sentences have a comma, and those of the scene stand between backquotes.
#[test]
fn numbers_of_findings_have_a_comma() {
    let rest = "9 -501 0 0 6 0 0 -1 0 1 0 0.785\n50 -402 1\n50 -1 3 5 5\n1 9999 4 0\n";
    let balls = "2 11 0.25 0 0 1\n3 11 0.75 0 0 1.25\n3 -203 1.5 1.5 1.5\n2 -201 0.5 0.25 0.85\n";
    for (scene, said) in [
        (format!("{balls}3 -2 0.785 2\n4 -103 2 3\n{rest}"), ""),
        (format!("{balls}4 -101 2 3\n{rest}"), "`kd + ks + kt = 1.6`"),
        (
            "2 11 0 0 0 1\n2 -701 1.5 0 0\n1 9999 2 0\n".to_owned(),
            "`r = 1.5`",
        ),
        ("2 11 0 0 0 1\n1 9999 2 0\n".to_owned(), "světlo 0,2"),
    ] {
        let dir = folder(&[("a.zpg", &scene)]);
        let run = program::zpg(
            dir.path(),
            &["check", "a.zpg", "--format", "short", "--lang", "cs"],
        );
        let all = text(&run.stdout);
        assert!(all.contains(said), "{all}");
        for (i, part) in all.split('`').enumerate().filter(|(i, _)| i % 2 == 0) {
            let bytes = part.as_bytes().windows(3);
            let digit = |b: u8| b.is_ascii_digit();
            let has_point = |w: &[u8]| digit(w[0]) && w[1] == b'.' && digit(w[2]);
            assert!(!bytes.into_iter().any(has_point), "{i}: {all}");
        }
    }
    // How bright the picture is, too.
    let bright = "2 11 0 0 0 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 3\n50 -1 3 5 5\n1 9999 2 0\n";
    let dir = folder(&[("a.zpg", bright)]);
    let arguments = [
        "convert",
        "a.zpg",
        "--verbose",
        "--to",
        "pov",
        "-o",
        "a.pov",
        "--lang",
        "cs",
    ];
    let all = text(&program::zpg(dir.path(), &arguments).stderr).replace('\n', " ");
    assert!(
        all.contains("=0.25") && all.contains("0,25násobek"),
        "{all}"
    );
}

/// A condition stands between commas behind the line that a guess is about.
#[test]
fn a_guess_with_a_condition_on_another_line() {
    let scene = "2 4 0 1 0 0\n3 11 0.7 0.3 0.7 2.2\n3 -201 0.05 0.1 0.85\n3 -203 1.5 1.5 1.5\n\
                 4 -101 2 3\n9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 3\n50 -1 3 5 5\n1 9999 4 0\n";
    let dir = folder(&[("a.zpg", scene)]);
    for (language, said) in [
        (
            "cs",
            "na řádku 2: je-li první poloměr, napsat `0.3 0.7 2.2 0.7`",
        ),
        (
            "en",
            "on line 2, if the radius is first, write `0.3 0.7 2.2 0.7`",
        ),
    ] {
        let run = program::zpg(dir.path(), &["check", "a.zpg", "--lang", language]);
        assert!(text(&run.stdout).contains(said), "{}", text(&run.stdout));
    }
    let run = program::zpg(dir.path(), &["check", "a.zpg", "--lang", "cz"]);
    let said = text(&run.stderr).replace("\n  ", " ");
    assert!(said.contains("did you mean `cs`?"), "{said}");
}

use super::*;
use crate::diagnostics::{Diagnostic, Language, Severity, Span};

fn of(text: &str) -> Result<Config, Complaint> {
    let root = Path::new("/scenes");
    let written = parse(text, root).map_err(|mistakes| {
        let path = NAME.into();
        ConfigError { path, mistakes }.complaint()
    })?;
    Ok(Config::new(None, root.to_owned(), &written, &[]))
}

fn severity(config: &Config, code: Code) -> Option<Severity> {
    let mut all = vec![Diagnostic::new(code, Span::default())];
    let levels = config.levels(Path::new("/scenes/a.zpg"));
    levels.apply(&Choice::default(), &mut all);
    all.pop().map(|d| d.severity)
}

#[test]
fn one_code_counts_more_than_many() {
    let config = of("[lint]\nW302 = \"note\"\nW = \"off\"\nall = \"error\"\n").unwrap();
    assert_eq!(severity(&config, Code::W302), Some(Severity::Note));
    assert_eq!(severity(&config, Code::W303), None);
    assert_eq!(severity(&config, Code::S502), Some(Severity::Error));
}

#[test]
fn mistakes_name_their_line() {
    let says = |text: &str| of(text).unwrap_err().wording(Language::English);
    assert_eq!(
        says("\n[lint]\nW399 = \"off\"\n"),
        "zpg.toml:3:1: there is no code `W399`; did you mean `W309`?"
    );
    assert_eq!(
        says("[lint]\nE101 = \"off\"\n"),
        "zpg.toml:2:1: E101 is always an error"
    );
    assert!(says("[lint]\nW302 = \"loud\"\n").contains("zpg.toml:2:"));
    for level in ["3", "\"loud\"", "true"] {
        let said = says(&format!("[lint]\nW302 = {level}\n"));
        let named = "expected one of `error`, `warning`, `note`, `off`";
        assert!(
            said.contains(named) && said.contains("zpg.toml:2:8: "),
            "{said}"
        );
    }
    assert_eq!(
        says("[lints]\n"),
        "zpg.toml:1:2: there is no setting `lints`, only `exclude`, `format`, `lint`, \
         `per-file-ignores`; did you mean `lint`?"
    );
    assert!(says("width = 80\n").ends_with("did you mean `format.width`?"));
    assert!(says("W310 = \"off\"\n").ends_with("did you mean `lint.W310`?"));
    assert!(says("[lint]\nwidth = 80\n").ends_with("did you mean `format.width`?"));
    assert!(says("[lint]\nper-file-ignore = 1\n").ends_with("`per-file-ignores`?"));
    assert!(says("[lint]\nW302 = \"warn\"\n").ends_with("did you mean `warning`?"));
    for (line, reason) in [
        (
            "exclude = \"old\"",
            "a list of file patterns, such as [\"old\", \"*/draft.zpg\"], found `\"old\"`",
        ),
        (
            "exclude = [1]",
            "a list of file patterns, such as [\"old\", \"*/draft.zpg\"], found `1`",
        ),
        ("exclude = [\"a[\"]", "`a[` is not a file pattern"),
        ("lint = 1", "`lint`: expected a table, found `1`"),
        ("lint.per-file-ignores = [1]", "expected a table"),
        (
            "lint.per-file-ignores = {\"*\" = \"W3\"}",
            "`lint.per-file-ignores.\"*\"`: expected a list of codes",
        ),
        (
            "lint.per-file-ignores = {\"*\" = [\"W399\"]}",
            "no code `W399`",
        ),
        (
            "lint.per-file-ignores = {\"*\" = [\"E101\"]}",
            "E101 is always an error",
        ),
    ] {
        let said = says(&format!("\n{line}\n"));
        assert!(
            said.starts_with("zpg.toml:2:") && said.contains(reason),
            "{said}"
        );
    }
    for (line, reason) in [
        (
            "widht = 80",
            "no setting `format.widht`, only `align`, `group`, `numbers`, `width`; did you mean `width`?",
        ),
        (
            "width = 5",
            "`format.width`: expected a whole number (a width is from 20 to 1000), found `5`",
        ),
        (
            "width = \"80\"",
            "expected a whole number (a width is from 20 to 1000)",
        ),
        (
            "width = -80",
            "expected a whole number (a width is from 20 to 1000)",
        ),
        (
            "align = 1",
            "`format.align`: expected true or false, found `1`",
        ),
        (
            "numbers = \"long\"",
            "`format.numbers`: expected \"shortest\" or \"keep\", found `\"long\"`",
        ),
    ] {
        let said = says(&format!("[lint]\n[format]\n{line}\n"));
        assert!(
            said.starts_with("zpg.toml:3:") && said.contains(reason),
            "{said}"
        );
    }
    assert!(says("[lint\n").starts_with("zpg.toml:1:"));
    let none = Config {
        root: "/scenes".into(),
        ..Config::default()
    };
    assert_eq!(of("").unwrap(), none);
}

#[test]
fn all_mistakes_are_said_at_once() {
    let text = "[lint]\nstyl = \"off\"\nW999 = \"off\"\nW302 = \"of\"\n\n[format]\n\
                widht = 100\nalign = 3\n[lint.per-file-ignores]\n\"a\" = [\"W302\", \"notse\", 3]\n";
    let said = of(text).unwrap_err().wording(Language::English);
    let said: Vec<&str> = said.lines().collect();
    let near = [
        ("zpg.toml:2:1: ", "did you mean `style`?"),
        (
            "zpg.toml:3:1: ",
            "there is no code `W999` (`zpg explain` lists all)",
        ),
        ("zpg.toml:4:8: ", "did you mean `off`?"),
        ("zpg.toml:10:16: ", "did you mean `notes`?"),
        ("zpg.toml:10:25: ", "found `3`"),
        ("zpg.toml:7:1: ", "did you mean `width`?"),
        ("zpg.toml:8:9: ", "expected true or false, found `3`"),
    ];
    assert_eq!(said.len(), near.len(), "{said:?}");
    for (place, end) in near {
        let is_it = |line: &&&str| line.starts_with(place) && line.ends_with(end);
        assert_eq!(said.iter().filter(is_it).count(), 1, "{place} {said:?}");
    }
    // Where it is no TOML, too.
    let said = of("a = \n\nb = = 1\n")
        .unwrap_err()
        .wording(Language::English);
    let lines = ["zpg.toml:1:", "zpg.toml:3:"];
    assert!(lines.iter().all(|line| said.contains(line)), "{said}");
}

#[test]
fn the_style_of_the_formatter() {
    let text = "[format]\nwidth = 80\nalign = false\ngroup = false\nnumbers = \"keep\"\n";
    let style = format::Options {
        width: 80,
        align: false,
        group: false,
        numbers: format::Numbers::Keep,
    };
    assert_eq!(of(text).unwrap().format, style);
    let part = of("[format]\nwidth = 80\n").unwrap().format;
    let rest = format::Options::default();
    assert_eq!(part, format::Options { width: 80, ..rest });
}

#[test]
fn the_nearest_file_counts() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    std::fs::create_dir_all(at("a/b")).unwrap();
    std::fs::write(at(NAME), "[lint]\nW302 = \"off\"\n").unwrap();
    std::fs::write(at("a/zpg.toml"), "[lint]\nW303 = \"off\"\n").unwrap();
    let configs = Configs::default();
    let off = |file: &str, code| {
        let config = configs.for_file(&at(file)).unwrap();
        severity(&config, code).is_none()
    };
    assert!(off("x.zpg", Code::W302) && !off("x.zpg", Code::W303));
    assert!(off("a/b/x.zpg", Code::W303) && !off("a/b/x.zpg", Code::W302));
    std::fs::write(at("a/b/zpg.toml"), "lint = 1\n").unwrap();
    let error = Configs::default().for_file(&at("a/b/x.zpg")).unwrap_err();
    assert_eq!(error.path, at("a/b/zpg.toml"));
}

#[test]
fn what_is_shown_is_read_as_the_same() {
    let text = "exclude = [\"a\\\\b\", \"c/*\"]\n[lint]\nW3 = \"note\"\nW302 = \"off\"\nS501 = \"error\"\n\
                [lint.per-file-ignores]\n\"!x*\" = [\"W303\", \"style\"]\n\
                [format]\nwidth = 80\nnumbers = \"keep\"\n";
    let config = of(text).unwrap();
    // The pattern is of all files but those that begin with x.
    let file = Path::new("/scenes/x.zpg");
    let shown = config.show(file, &Choice::default());
    let again = of(&shown).unwrap();
    assert_eq!(again.show(file, &Choice::default()), shown);
    let same = |c: &Config| (c.exclude.clone(), c.format, c.per_file_ignores.len());
    assert_eq!(same(&again), same(&config));
    for &code in Code::ALL {
        assert_eq!(severity(&again, code), severity(&config, code), "{code:?}");
    }
}

#[test]
fn files_have_codes_of_their_own_that_are_ignored() {
    let text = "[lint]\nW302 = \"error\"\n[lint.per-file-ignores]\n\"old/*\" = [\"W3\"]\n\"!a.zpg\" = [\"S\"]\n";
    let config = of(text).unwrap();
    let is_on = |file: &str, code| {
        let select = Choice {
            select: vec!["W".parse().unwrap(), "S".parse().unwrap()],
            deny: vec!["W302".parse().unwrap()],
            ..Choice::default()
        };
        let levels = config.levels(Path::new(file));
        assert_eq!(
            levels.is_on(&select, code),
            levels.is_on(&Choice::default(), code)
        );
        levels.is_on(&select, code)
    };
    assert!(is_on("/scenes/a.zpg", Code::W302) && is_on("/scenes/a.zpg", Code::S501));
    assert!(!is_on("/scenes/old/a.zpg", Code::W302) && is_on("/scenes/old/a.zpg", Code::S501));
    assert!(is_on("/scenes/b.zpg", Code::W302) && !is_on("/scenes/b.zpg", Code::S501));
}

#[test]
fn what_is_left_out() {
    let config = of("exclude = [\"old\", \"a/*.zpg\"]\n").unwrap();
    let out = |file: &str| config.excludes_file(Path::new(file));
    assert!(out("/scenes/b/old/c/x.zpg") && out("/scenes/a/x.zpg") && out("/scenes/old"));
    assert!(!out("/scenes/x.zpg") && !out("/old/x.zpg") && !out("/scenes/older/x.zpg"));
    assert!(config.excludes(Path::new("/scenes/b/old")));
    assert!(!config.excludes(Path::new("/scenes/b/old/x.zpg")));
}

#[test]
fn settings_of_the_command_line() {
    let says = |text: &str| {
        let found = Configs::chosen(&[text.to_owned()], &[], false);
        found.unwrap_err().wording(Language::English)
    };
    assert_eq!(
        says("none.toml"),
        "--config: there is no file none.toml; a setting is written as in lint.W310=off"
    );
    let of = |text: &str| {
        Configs::chosen(&[text.to_owned()], &[], false)
            .unwrap()
            .over
    };
    for (bare, quoted) in [
        ("lint.N602=off", "lint.N602=\"off\""),
        ("format.numbers = keep", "format.numbers=\"keep\""),
    ] {
        assert_eq!(of(bare), of(quoted));
    }
    assert_eq!(
        says("lint.W310=of"),
        "--config `lint.W310=of`: `lint.W310`: expected one of `error`, `warning`, `note`, `off`, \
         found `\"of\"`; did you mean `off`?"
    );
    assert!(says("format.align=yes").ends_with("write `true` or `false`"));
    assert!(says("lint.W310=\"of\"").ends_with("did you mean `off`?"));
    assert!(says("format.widht=80").ends_with("did you mean `width`?"));
    assert!(
        says("format.width=8").starts_with("--config `format.width=8`: `format.width`: expected")
    );
    let chosen = [
        "lint.W3=\"off\"",
        "lint.W302=\"error\"",
        "lint.W303=\"note\"",
    ]
    .map(String::from);
    let config = Configs::chosen(&chosen, &[], true).unwrap();
    let config = config.for_file(Path::new("a.zpg")).unwrap();
    assert_eq!(severity(&config, Code::W302), Some(Severity::Error));
    assert_eq!(severity(&config, Code::W303), Some(Severity::Note));
    assert_eq!(severity(&config, Code::W304), None);
}

//! Hints for people who know ruff or a renderer, or who write Czech: options, commands and values that zpg calls
//! otherwise, or does without.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::new::Template;
use crate::diagnostics::Complaint;
use crate::solids::staging::Side;
use crate::syntax::words::plain;
use crate::translate::registry::of_file;

/// Words of ruff and of renderers, each with the message that says what zpg has instead.
const HABITS: [(&str, &str); 87] = [
    ("--add-ignore", "habit-add-allow"),
    ("--max-depth", "habit-depth"),
    ("--max-bounces", "habit-depth"),
    ("--bounces", "habit-depth"),
    ("--max-trace-level", "habit-depth"),
    ("--recursion", "habit-depth"),
    ("-W", "habit-size"),
    ("-H", "habit-size"),
    ("--add-noqa", "habit-add-allow"),
    ("--cache-dir", "habit-cache"),
    ("--no-cache", "habit-cache"),
    ("clean", "habit-cache"),
    ("config", "habit-config"),
    ("--exit-non-zero-on-fix", "habit-exit-non-zero"),
    ("--exit-non-zero-on-format", "habit-exit-non-zero"),
    ("--extend-exclude", "habit-exclude"),
    ("--extend-ignore", "habit-ignore"),
    ("--extend-per-file-ignores", "habit-per-file-ignores"),
    ("--per-file-ignores", "habit-per-file-ignores"),
    ("--extension", "habit-extension"),
    ("--fix-only", "habit-fix-only"),
    ("--fixable", "habit-fixable"),
    ("--extend-fixable", "habit-fixable"),
    ("--unfixable", "habit-fixable"),
    ("--ignore-noqa", "habit-ignore-allow"),
    ("--line-length", "habit-line-length"),
    ("linter", "habit-linter"),
    ("--preview", "habit-preview"),
    ("--respect-gitignore", "habit-gitignore"),
    ("server", "habit-server"),
    ("--show-fixes", "habit-show-fixes"),
    ("--silent", "habit-silent"),
    ("--target-version", "habit-target-version"),
    ("analyze", "habit-analyze"),
    ("--verbose", "habit-verbose"),
    ("-v", "habit-verbose"),
    ("--log-level", "habit-verbose"),
    ("--all", "habit-linter"),
    ("--no-fix", "habit-no-fix"),
    ("--no-fix-only", "habit-no-option"),
    ("--no-force-exclude", "habit-default"),
    ("--no-preview", "habit-preview"),
    ("--no-show-fixes", "habit-no-option"),
    ("--no-unsafe-fixes", "habit-default"),
    ("--no-respect-gitignore", "habit-gitignore"),
    ("-n", "habit-cache"),
    ("-s", "habit-silent-or-size"),
    ("-e", "habit-exit-zero"),
    ("--show-source", "habit-show-source"),
    ("init", "habit-new"),
    ("create", "habit-new"),
    ("lint", "habit-check"),
    ("validate", "habit-check"),
    ("fix", "habit-fix"),
    ("draw", "habit-render"),
    ("trace", "habit-render"),
    ("view", "habit-render"),
    ("compare", "habit-crosscheck"),
    ("export", "habit-convert"),
    ("translate", "habit-convert"),
    ("--width", "habit-size"),
    ("--height", "habit-size"),
    ("--resolution", "habit-size"),
    ("--res", "habit-size"),
    ("--format", "habit-format"),
    ("-f", "habit-format"),
    ("--fov", "habit-angle"),
    ("--fovy", "habit-angle"),
    ("--angle", "habit-angle"),
    ("--background", "habit-background"),
    ("--background-color", "habit-background"),
    ("--bg", "habit-background"),
    ("-w", "habit-in-place"),
    ("--write", "habit-in-place"),
    ("-i", "habit-in-place"),
    ("--in-place", "habit-in-place"),
    ("--inplace", "habit-in-place"),
    ("--antialias", "habit-samples"),
    ("--antialiasing", "habit-samples"),
    ("--aa", "habit-samples"),
    ("--spp", "habit-samples"),
    ("--gamma", "habit-gamma"),
    ("version", "habit-version"),
    ("generate-shell-completion", "habit-completions"),
    ("--warnings-as-errors", "habit-deny"),
    ("--clock", "habit-clock"),
    ("-l", "habit-line-length"),
];

/// Czech words for commands and options, without accents, and what zpg calls them.
const CZECH: [(&str, &str); 89] = [
    ("kontrola", "zpg check"),
    ("kontroluj", "zpg check"),
    ("zkontroluj", "zpg check"),
    ("kontrolovat", "zpg check"),
    ("zkontrolovat", "zpg check"),
    ("oprav", "zpg check --fix"),
    ("opravit", "zpg check --fix"),
    ("vykresli", "zpg render"),
    ("vykreslit", "zpg render"),
    ("kresli", "zpg render"),
    ("kreslit", "zpg render"),
    ("nakresli", "zpg render"),
    ("nakreslit", "zpg render"),
    ("vykresleni", "zpg render"),
    ("formatuj", "zpg fmt"),
    ("formatovat", "zpg fmt"),
    ("zformatuj", "zpg fmt"),
    ("naformatuj", "zpg fmt"),
    ("formatovani", "zpg fmt"),
    ("preved", "zpg convert"),
    ("prevest", "zpg convert"),
    ("prevod", "zpg convert"),
    ("preloz", "zpg convert"),
    ("prelozit", "zpg convert"),
    ("vysvetli", "zpg explain"),
    ("vysvetlit", "zpg explain"),
    ("vysvetleni", "zpg explain"),
    ("novy", "zpg new"),
    ("nova", "zpg new"),
    ("nove", "zpg new"),
    ("novascena", "zpg new"),
    ("vytvor", "zpg new"),
    ("vytvorit", "zpg new"),
    ("porovnej", "zpg crosscheck"),
    ("porovnat", "zpg crosscheck"),
    ("presnost", "zpg accuracy"),
    ("spoj", "zpg join"),
    ("spojit", "zpg join"),
    ("sonda", "zpg probe"),
    ("dotaz", "zpg probe"),
    ("prehled", "zpg sheet"),
    ("farma", "zpg farm"),
    ("verze", "zpg --version"),
    ("napoveda", "zpg --help"),
    ("pomoc", "zpg --help"),
    ("--rozmer", "--size"),
    ("--rozmery", "--size"),
    ("--velikost", "--size"),
    ("--rozliseni", "--size"),
    ("--sirka", "--size"),
    ("--vyska", "--size"),
    ("--kvalita", "--quality"),
    ("--jazyk", "--lang"),
    ("--bod", "--point"),
    ("--paprsek", "--ray"),
    ("--verze", "--version"),
    ("--napoveda", "--help"),
    ("--pomoc", "--help"),
    ("--pohled", "--view"),
    ("--kamera", "--camera"),
    ("--vystup", "--output"),
    ("--oprav", "--fix"),
    ("--opravit", "--fix"),
    ("--tise", "--quiet"),
    ("--ticho", "--quiet"),
    ("--vzorky", "--samples"),
    ("--hloubka", "--depth"),
    ("--presnost", "--precision"),
    ("--vlakna", "--threads"),
    ("--pamet", "--memory"),
    ("--expozice", "--exposure"),
    ("--vyrez", "--crop"),
    ("--snimky", "--frames"),
    ("--sleduj", "--watch"),
    ("--sledovat", "--watch"),
    ("--pokracuj", "--resume"),
    ("--pokracovat", "--resume"),
    ("--barva", "--color"),
    ("--barvy", "--color"),
    ("--nastaveni", "--config"),
    ("--vyber", "--select"),
    ("--ignoruj", "--ignore"),
    ("--ignorovat", "--ignore"),
    ("--vynech", "--exclude"),
    ("--vynechat", "--exclude"),
    ("--prepis", "--force"),
    ("--prepsat", "--force"),
    ("--naklady", "--cost"),
    ("--cena", "--cost"),
];

/// The hint for a command or an option in Czech: what zpg calls it. `None` for other words.
pub(super) fn czech(word: &str) -> Option<Complaint> {
    let name = word.split('=').next()?;
    let dashes = if name.starts_with("--") { "--" } else { "" };
    let name = format!("{dashes}{}", plain(name));
    let (_, ours) = CZECH.iter().find(|(czech, _)| *czech == name)?;
    Some(Complaint::new("habit-called").with("text", (*ours).to_owned()))
}

/// The message about a word of another program that stands behind a command of zpg. `None` for other words.
pub(super) fn message(word: &str, command: &str) -> Option<&'static str> {
    let word = word.split('=').next().unwrap_or(word);
    match (word, command) {
        // Only a formatter has the width of a line.
        ("-l", of) if of != "fmt" => return None,
        ("--width", "fmt") => return Some("habit-line-length"),
        ("-j" | "--jobs", "render") => return Some("habit-threads"),
        ("-o" | "--out" | "--output", "fmt") => return Some("habit-fmt-output"),
        ("-v" | "--verbose", "render") => return Some("habit-verbose-render"),
        ("-s", "render" | "sheet" | "farm" | "crosscheck" | "accuracy") => {
            return Some("habit-size-or-silent");
        }
        ("-t", "convert") => return Some("habit-to"),
        ("-i", "render" | "convert" | "plan" | "probe") => return Some("habit-scene-named"),
        ("--all", "explain") => return Some("habit-all-codes"),
        ("--output-format" | "--format" | "-f", "explain") => {
            return Some("habit-output-format-explain");
        }
        ("--output-format" | "--format" | "-f", "fmt") => return Some("habit-output-format-fmt"),
        ("--format" | "-f", "render") => return Some("habit-picture-format"),
        ("--werror" | "--strict" | "--max-warnings", "check") => return Some("habit-deny"),
        // Compilers have `-Werror` and `-Wall`.
        ("-W", "check") if is_given("-Werror") => return Some("habit-deny"),
        ("-W", "check") => return Some("habit-verbose"),
        ("-W" | "-H", "fmt" | "plan" | "explain" | "probe") => return None,
        ("--seed", "render") => return Some("habit-seed"),
        ("--preview", "render") => return Some("habit-render-preview"),
        ("--dry-run", "check" | "fmt") => return Some("habit-dry-run"),
        ("--stdout", "fmt") => return Some("habit-fmt-output"),
        ("--json", "probe") => return Some("habit-probe-json"),
        ("--json", "check") => return Some("habit-check-json"),
        ("--format" | "--output-format", "plan" | "crosscheck" | "accuracy") => {
            return Some("habit-json");
        }
        ("--samples" | "--adaptive" | "--depth" | "--precision" | "--quality", "accuracy") => {
            return Some("habit-axes");
        }
        // An option before the command has the usage of all of zpg, which begins with `[OPTIONS]`.
        ("--config" | "--isolated", "[OPTIONS]") => return Some("habit-behind-command"),
        _ => {}
    }
    let habit = HABITS.iter().find(|(name, _)| *name == word);
    habit.map(|(_, message)| *message)
}

/// The hint for `--explain W310` behind another command: `zpg explain W310`.
pub(super) fn explain(word: &str) -> Option<Complaint> {
    let name = "--explain";
    if word.split('=').next() != Some(name) {
        return None;
    }
    let written = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    let mut behind = written.skip_while(|argument| !argument.starts_with(name));
    let value = match behind.next()?.split_once('=') {
        Some((_, value)) => value.to_owned(),
        None => behind.next().unwrap_or_default(),
    };
    let is_code = !value.is_empty() && value.bytes().all(|c| c.is_ascii_alphanumeric());
    let text = match is_code {
        true => format!("zpg explain {value}"),
        false => "zpg explain".to_owned(),
    };
    Some(Complaint::new("habit-called").with("text", text))
}

/// The hint for the name of a template on its own behind `zpg new`: `--from` is missing.
pub(super) fn template(word: &str, command: &str) -> Option<Complaint> {
    let is_one = command == "new" && Template::from_str(word, true).is_ok();
    is_one.then(|| Complaint::new("habit-from").with("text", word.to_owned()))
}

/// The endings of files that zpg writes and does not read as scenes.
const OUTPUTS: [&str; 13] = [
    "png", "apng", "jpg", "jpeg", "webp", "exr", "pfm", "pov", "xml", "ply", "obj", "glb", "stl",
];

/// The size of a picture, as `160x120`, from the arguments of this run, which may give it in the way of other programs:
/// `-W160 -H120` or `--width 160 --height 120`. `640x480` if they do not.
pub(super) fn size() -> String {
    let width = number(&["-W", "+W", "--width", "Width"]);
    let height = number(&["-H", "+H", "--height", "Height"]);
    let (width, height) = width.zip(height).unwrap_or((640, 480));
    format!("{width}x{height}")
}

/// The line length that this run's arguments ask for, also in the spelling of other programs. 100, zpg's own, if they
/// give none.
pub(super) fn line_length() -> String {
    let length = number(&["--line-length", "--width", "-l"]);
    length.unwrap_or(100).to_string()
}

/// The number of threads from the arguments of this run, which may give it in the way of other programs. 4 if they do
/// not.
pub(super) fn threads() -> String {
    let threads = number(&["--jobs", "-j", "+WT", "Work_Threads"]);
    threads.unwrap_or(4).to_string()
}

/// Whether a word is among the arguments of this run.
fn is_given(word: &str) -> bool {
    std::env::args_os().any(|argument| argument == word)
}

/// The first number, 1 or more, that the arguments of this run give to an option of one of these names.
fn number(names: &[&str]) -> Option<u32> {
    let written: Vec<String> = std::env::args_os()
        .map(|argument| argument.to_string_lossy().into_owned())
        .collect();
    let behind = |at: usize, name: &str| {
        let rest = written[at].strip_prefix(name)?;
        let value = match rest {
            "" => written.get(at + 1)?,
            _ => rest.strip_prefix('=').unwrap_or(rest),
        };
        value.parse().ok().filter(|number: &u32| *number > 0)
    };
    (0..written.len()).find_map(|at| names.iter().find_map(|name| behind(at, name)))
}

/// The endings of pictures that zpg draws.
const PICTURES: [&str; 7] = ["png", "apng", "jpg", "jpeg", "webp", "exr", "pfm"];

/// The hint for a line of POV-Ray's settings such as `Width=640`: what zpg has instead. `None` for other words.
fn of_povray_settings(word: &str) -> Option<Complaint> {
    let (name, value) = word.split_once('=')?;
    let name = name.to_ascii_lowercase();
    let message = match name.as_str() {
        "width" | "height" => "habit-size",
        "antialias" | "antialias_depth" | "antialias_threshold" | "quality" => "habit-samples",
        "work_threads" => "habit-threads",
        "initial_frame" | "final_frame" => "habit-frames",
        "clock" | "initial_clock" | "final_clock" => "habit-clock",
        "declare" => "habit-declare",
        "output_alpha" | "pause_when_done" | "display" => "habit-none",
        "output_file_name" => {
            return Some(Complaint::new("habit-output").with("path", Path::new(value)));
        }
        _ => return None,
    };
    Some(with_numbers(message))
}

/// The message with the size, the threads and the line length that the arguments of this run give.
pub(super) fn with_numbers(message: &'static str) -> Complaint {
    Complaint::new(message)
        .with("size", size())
        .with("threads", threads())
        .with("length", line_length())
}

/// The hint for an option of POV-Ray such as `+W640` or `+Opicture.png`: what zpg has instead. `None` for other words.
fn of_povray(word: &str) -> Option<Complaint> {
    let rest = word.strip_prefix('+')?;
    let of = |names: &[&str]| {
        let mut values = names.iter().filter_map(|name| rest.strip_prefix(name));
        values.any(|value| value.is_empty() || value.parse().is_ok_and(f64::is_finite))
    };
    // `+GA` and `+GFfile`: where messages go.
    let stream = rest.strip_prefix('G');
    let is_stream = stream.is_some_and(|to| to.starts_with(['A', 'D', 'F', 'R', 'S', 'W']));
    let message = [
        ("habit-threads", of(&["WT"])),
        ("habit-frames", of(&["KFF", "KFI"])),
        ("habit-clock", of(&["KI", "KF", "KC", "K"])),
        ("habit-samples", of(&["R", "AM", "J"])),
        ("habit-none", of(&["P", "D", "V", "UA"]) || is_stream),
    ];
    let message = message.into_iter().find(|(_, is_it)| *is_it);
    if let Some((message, _)) = message {
        return Some(with_numbers(message));
    }
    let letter = rest.chars().next()?;
    let value = &rest[letter.len_utf8()..];
    let is_whole = !value.is_empty() && value.bytes().all(|c| c.is_ascii_digit());
    let is_number = value.is_empty() || value.parse().is_ok_and(f64::is_finite);
    match letter {
        'W' | 'H' if is_whole => Some(with_numbers("habit-size")),
        'A' | 'Q' if is_number => Some(Complaint::new("habit-samples")),
        'F' if value.len() <= 2 => Some(Complaint::new("habit-picture-format")),
        'O' if !value.is_empty() => {
            Some(Complaint::new("habit-output").with("path", Path::new(value)))
        }
        'I' if !value.is_empty() => {
            Some(Complaint::new("habit-scene").with("path", Path::new(value)))
        }
        _ => None,
    }
}

/// The hint for a word that stands where a scene belongs and is none: the name of a picture, or an option of POV-Ray.
pub(super) fn output(word: &Path) -> Option<Complaint> {
    let text = word.to_string_lossy();
    if let Some(complaint) = of_povray(&text).or_else(|| of_povray_settings(&text)) {
        return Some(complaint);
    }
    let ending = word.extension()?;
    let is_output = OUTPUTS.iter().any(|e| ending.eq_ignore_ascii_case(e));
    let complaint = Complaint::new("habit-output").with("path", word);
    (is_output && !text.starts_with('-')).then_some(complaint)
}

/// The hint for the name of a picture as the output of a translation: which command draws it.
pub(super) fn picture(word: &Path, scene: &Path) -> Option<Complaint> {
    let ending = word.extension()?;
    let is_picture = PICTURES.iter().any(|e| ending.eq_ignore_ascii_case(e));
    let complaint = Complaint::new("picture-not-translated").with("path", word);
    is_picture.then(|| complaint.with("scene", scene))
}

/// The hint for the name of a translation, such as `scene.pov`, where `zpg render` takes a scene or a picture. It tells
/// how to translate the first of the scenes.
pub(super) fn translation(word: &Path, scenes: &[PathBuf]) -> Option<Complaint> {
    of_file(word).filter(|target| target.ending() != "zpg")?;
    let scene = scenes.iter().find(|path| *path != word)?;
    let complaint = Complaint::new("habit-translation").with("path", word);
    Some(complaint.with("scene", scene.as_path()))
}

/// Other words for values of `--view`, `--precision`, `--to` and `--lang`, each with the value that zpg has.
const VALUES: [(&str, &str); 26] = [
    ("cz", "cs"),
    ("czech", "cs"),
    ("double", "f64"),
    ("single", "f32"),
    ("float", "f32"),
    ("xml", "mitsuba"),
    ("above", "top"),
    ("up", "top"),
    ("shora", "top"),
    ("seshora", "top"),
    ("nahore", "top"),
    ("below", "bottom"),
    ("down", "bottom"),
    ("zdola", "bottom"),
    ("zespoda", "bottom"),
    ("dole", "bottom"),
    ("zepredu", "front"),
    ("predni", "front"),
    ("behind", "back"),
    ("rear", "back"),
    ("zezadu", "back"),
    ("zleva", "left"),
    ("zprava", "right"),
    ("isometric", "iso"),
    ("izometrie", "iso"),
    ("sikmo", "iso"),
];

/// The hint for a side as the value of `--camera`: `--view` takes sides.
pub(super) fn camera(argument: &str, value: &str) -> Option<Complaint> {
    let is_camera = argument.split(' ').next() == Some("--camera");
    let side = self::value(value).map_or_else(|| plain(value), str::to_owned);
    let is_side = is_camera && Side::from_str(&side, true).is_ok();
    is_side.then(|| Complaint::new("habit-view").with("text", side))
}

/// The hint for `fix` in the place of a file to check, unless there is a file of this name.
pub(super) fn of_check(word: &Path) -> Option<Complaint> {
    let is_one = word.as_os_str() == "fix" && !word.exists();
    is_one.then(|| Complaint::new("habit-fix"))
}

/// The value that another word for it means.
pub(super) fn value(word: &str) -> Option<&'static str> {
    let word = plain(word);
    let value = VALUES.iter().find(|(name, _)| *name == word);
    value.map(|(_, value)| *value)
}

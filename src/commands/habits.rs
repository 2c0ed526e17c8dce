//! What people write who know ruff: options and commands that zpg calls otherwise, or does without.

/// A word of ruff, and the message that says what there is instead.
const HABITS: [(&str, &str); 29] = [
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
    ("version", "habit-version"),
];

/// The message about a word, if it is one of ruff's.
pub fn message(word: &str) -> Option<&'static str> {
    let word = word.split('=').next().unwrap_or(word);
    let habit = HABITS.iter().find(|(name, _)| *name == word);
    habit.map(|(_, message)| *message)
}

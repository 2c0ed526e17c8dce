//! Patterns of files: `old`, `draft-*.zpg`, `exercises/**/solution.zpg`.
//!
//! A pattern with a slash matches paths below the folder of the settings; a pattern without a slash also matches names
//! of files and folders, wherever they are. `*` matches slashes, too, as in the settings of ruff.

use std::path::{Component, Path, PathBuf};

use globset::{Glob, GlobMatcher};

use crate::diagnostics::Complaint;
use crate::syntax::quote;

/// A pattern that is ready to be matched with paths.
#[derive(Debug, Clone)]
pub(super) struct Pattern {
    /// The pattern as the settings spell it.
    pub written: String,
    /// Whether the pattern stands for all files that do not match.
    negated: bool,
    root: PathBuf,
    path: GlobMatcher,
    name: Option<GlobMatcher>,
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Pattern) -> bool {
        (&self.written, &self.root) == (&other.written, &other.root)
    }
}

impl Eq for Pattern {}

impl Pattern {
    /// Builds a pattern of settings that are about the folder `root`.
    ///
    /// # Errors
    ///
    /// The text is no pattern.
    pub(super) fn new(written: &str, root: &Path) -> Result<Pattern, Complaint> {
        Pattern::build(written, false, written, root)
    }

    /// Like [`new`](Self::new); a `!` before the pattern makes it stand for all files that do not match.
    ///
    /// # Errors
    ///
    /// The text is no pattern.
    pub(super) fn new_or_not(written: &str, root: &Path) -> Result<Pattern, Complaint> {
        match written.strip_prefix('!') {
            Some(rest) => Pattern::build(written, true, rest, root),
            None => Pattern::new(written, root),
        }
    }

    fn build(written: &str, negated: bool, text: &str, root: &Path) -> Result<Pattern, Complaint> {
        let matcher = |glob: &str| {
            let glob = Glob::new(glob).map_err(|e| {
                Complaint::new("setting-glob")
                    .with("text", quote(text))
                    .with("reason", e.kind().to_string())
            });
            glob.map(|glob| glob.compile_matcher())
        };
        let name = match text.contains('/') {
            true => None,
            false => Some(matcher(text)?),
        };
        Ok(Pattern {
            written: written.to_owned(),
            negated,
            root: root.to_owned(),
            path: matcher(&below(root, text))?,
            name,
        })
    }

    /// Whether an absolute path matches.
    pub(super) fn matches(&self, path: &Path) -> bool {
        let name = path.file_name().zip(self.name.as_ref());
        let fits = self.path.is_match(path) || name.is_some_and(|(n, glob)| glob.is_match(n));
        fits != self.negated
    }
}

/// Turns a pattern of paths below `root` into a pattern of absolute paths. Special characters in the name of the folder
/// stand for themselves.
fn below(root: &Path, pattern: &str) -> String {
    let mut root = root;
    let mut rest = pattern.trim_end_matches('/');
    if Path::new(rest).is_absolute() {
        return rest.to_owned();
    }
    loop {
        if let Some(more) = rest.strip_prefix("./") {
            rest = more;
        } else if let Some(more) = rest.strip_prefix("../") {
            (rest, root) = (more, root.parent().unwrap_or(root));
        } else {
            break;
        }
    }
    let root = globset::escape(&root.to_string_lossy());
    format!("{}/{rest}", root.trim_end_matches('/'))
}

/// The absolute path of a file, which need not exist, without `.` and `..`. Symbolic links are left as they are.
pub fn whole(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let mut out = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                out.pop();
            }
            Component::CurDir => {}
            component => out.push(component),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_anywhere_and_paths_below_the_folder() {
        let fits = |pattern: &str, path: &str| {
            let pattern = Pattern::new_or_not(pattern, Path::new("/a [1]/b")).unwrap();
            pattern.matches(Path::new(path))
        };
        for (pattern, path, expected) in [
            ("old", "/a [1]/b/old", true),
            ("old", "/a [1]/b/c/old", true),
            ("old", "/a [1]/b/older", false),
            ("*.zpg", "/a [1]/b/c/x.zpg", true),
            ("c/x.zpg", "/a [1]/b/c/x.zpg", true),
            ("c/x.zpg", "/a [1]/b/d/c/x.zpg", false),
            ("./c/x.zpg", "/a [1]/b/c/x.zpg", true),
            ("../d/x.zpg", "/a [1]/d/x.zpg", true),
            ("c/", "/a [1]/b/c", true),
            ("c/", "/a [1]/b/d/c", false),
            ("c/*.zpg", "/a [1]/b/c/d/x.zpg", true),
            ("**/d/*", "/a [1]/b/c/d/x.zpg", true),
            ("/a*/b/x.zpg", "/a [1]/b/x.zpg", true),
            ("!c/*", "/a [1]/b/c/x.zpg", false),
            ("!c/*", "/a [1]/b/x.zpg", true),
            ("{x,y}.zpg", "/a [1]/b/y.zpg", true),
        ] {
            assert_eq!(fits(pattern, path), expected, "{pattern} {path}");
        }
        let why = Pattern::new("a[", Path::new("/")).unwrap_err().to_string();
        assert!(why.contains("`a[`"), "{why}");
    }

    #[test]
    fn whole_paths_have_no_dots() {
        assert_eq!(whole(Path::new("/a/./b/../c")), Path::new("/a/c"));
        assert_eq!(whole(Path::new("/../a")), Path::new("/a"));
        assert!(whole(Path::new("a.zpg")).is_absolute());
    }
}

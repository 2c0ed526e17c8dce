//! URIs and paths.

use std::path::{Path, PathBuf};

use gen_lsp_types::Uri;
use url::Url;

/// The path of a file; `None` if the URI is not of a file, as that of a text that was never saved.
pub(super) fn path_of(uri: &Uri) -> Option<PathBuf> {
    let url = Url::parse(uri.as_ref()).ok()?;
    (url.scheme() == "file").then(|| url.to_file_path().ok())?
}

/// The key that tells files apart: clients differ in the characters of a URI that they escape.
pub(super) fn key(uri: &Uri) -> PathBuf {
    path_of(uri).unwrap_or_else(|| uri.0.clone().into())
}

/// Whether a text is a URI at all.
pub(super) fn is_uri(uri: &Uri) -> bool {
    Url::parse(uri.as_ref()).is_ok()
}

/// The URI of a file; `None` if the path cannot be made absolute.
pub(super) fn uri_of(path: &Path) -> Option<Uri> {
    let path = std::path::absolute(path).ok()?;
    Some(Uri(Url::from_file_path(path).ok()?.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways() {
        let uri = Uri::from("file:///a%20b/%C5%99%23.zpg");
        let path = path_of(&uri).unwrap();
        assert_eq!(path, Path::new("/a b/ř#.zpg"));
        assert_eq!(uri_of(&path), Some(uri));
        for other in [
            "untitled:Untitled-1",
            "http://a/b.zpg",
            "file://Sé/b.zpg",
            "nonsense",
            "",
        ] {
            assert_eq!(path_of(&Uri::from(other)), None);
        }
    }
}

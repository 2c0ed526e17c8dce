//! Reading of scene files and of standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::Analysis;
use crate::diagnostics::Complaint;
use crate::diagnostics::source::MAX_FILE_BYTES;

/// The path that stands for standard input, or for standard output where something is written.
pub const STDIN: &str = "-";

/// Reads a scene file; `-` is standard input. Findings have the default severities of their codes.
///
/// # Errors
///
/// The file cannot be read.
pub fn load(path: &Path) -> Result<Analysis, Complaint> {
    Ok(Analysis::new(path.to_string_lossy(), read(path)?))
}

/// Reads a file's bytes; `-` is standard input.
pub fn read(path: &Path) -> Result<Vec<u8>, Complaint> {
    let error = |reason: Complaint| unreadable(path, reason);
    let too_large = || {
        let size = MAX_FILE_BYTES.div_ceil(1 << 30).to_string();
        error(Complaint::new("too-large").with("size", size))
    };
    let result = if path.as_os_str() == STDIN {
        read_limited(io::stdin().lock(), 0)
    } else {
        File::open(path).and_then(|file| {
            // A file that is known to be too large is not read at all.
            match file.metadata() {
                Ok(m) if m.is_file() && m.len() > MAX_FILE_BYTES as u64 => Ok(None),
                Ok(m) if m.is_file() => read_limited(file, m.len() as usize),
                _ => read_limited(file, 0),
            }
        })
    };
    match result {
        Ok(Some(bytes)) => Ok(bytes),
        Ok(None) => Err(too_large()),
        Err(e) if e.kind() == io::ErrorKind::NotFound => Err(error(not_found(path, &e))),
        Err(e) => Err(error((&e).into())),
    }
}

/// The message about a file that does not exist. If a scene has its name with `.zpg` behind it, the message names that
/// scene.
fn not_found(path: &Path, error: &io::Error) -> Complaint {
    let mut scene = path.as_os_str().to_owned();
    scene.push(".zpg");
    let scene = Path::new(&scene);
    match scene.is_file() {
        true => Complaint::new("not-found-but").with("path", scene),
        false => error.into(),
    }
}

/// The message that a file cannot be read.
pub fn unreadable(path: &Path, reason: Complaint) -> Complaint {
    Complaint::new("cannot-read")
        .with("path", path)
        .with("reason", reason)
}

/// Reads all bytes. `None` if there are more than [`MAX_FILE_BYTES`]. `size` is the expected number of bytes.
fn read_limited(input: impl Read, size: usize) -> io::Result<Option<Vec<u8>>> {
    // Room for more bytes than expected: the end is only found by reading further.
    let mut bytes = Vec::with_capacity(size + 32);
    input
        .take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)?;
    Ok((bytes.len() <= MAX_FILE_BYTES).then_some(bytes))
}

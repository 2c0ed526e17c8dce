//! Running `zpg` itself.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs it in a folder, with something on its standard input.
pub fn zpg(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_zpg"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("zpg starts");
    // It need not read all of it.
    let _ = child
        .stdin
        .take()
        .map(|mut i| i.write_all(input.as_bytes()));
    child.wait_with_output().expect("zpg ends")
}

//! Running `zpg` itself.

use std::io::{BufRead as _, BufReader, Read, Write as _};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// The program, which speaks English whatever the environment says, and in long lines.
pub fn command() -> Command {
    let mut command = Command::new(PATH);
    command.env("LC_ALL", "C").env("COLUMNS", "1000");
    command.env_remove("NO_COLOR");
    command
}

/// Where the program is, for those that are run by others.
pub const PATH: &str = env!("CARGO_BIN_EXE_zpg");

/// The lines that a run writes, as they come.
pub type Lines = std::io::Lines<BufReader<Box<dyn Read>>>;

/// Starts it in a folder, to be watched: the run, and the lines of its standard output and standard error.
pub fn started(folder: &Path, arguments: &[&str]) -> (Child, [Lines; 2]) {
    let mut child = command()
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("zpg starts");
    let pipes: [Box<dyn Read>; 2] = [
        Box::new(child.stdout.take().expect("a pipe")),
        Box::new(child.stderr.take().expect("a pipe")),
    ];
    (child, pipes.map(|pipe| BufReader::new(pipe).lines()))
}

/// Runs it in a folder.
pub fn zpg(folder: &Path, arguments: &[&str]) -> Output {
    zpg_with(folder, arguments, "")
}

/// Runs it in a folder, with something on its standard input.
pub fn zpg_with(folder: &Path, arguments: &[&str], input: impl AsRef<[u8]>) -> Output {
    let mut child = command()
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("zpg starts");
    let (mut stdin, input) = (child.stdin.take().expect("a pipe"), input.as_ref());
    std::thread::scope(|scope| {
        // It need not read all of it.
        scope.spawn(move || stdin.write_all(input));
        child.wait_with_output().expect("zpg ends")
    })
}

/// The words of a command line without quotes.
pub fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// What it has printed.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("it prints text")
}

/// A folder with these files, which may lie in folders of their own.
pub fn folder<T: AsRef<[u8]>>(files: &[(&str, T)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("there is room for temporary files");
    for (name, contents) in files {
        let path = dir.path().join(name);
        let parent = path.parent().expect("a file lies in a folder");
        std::fs::create_dir_all(parent).expect("the folder can be made");
        std::fs::write(path, contents).expect("the file can be written");
    }
    dir
}

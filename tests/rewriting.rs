//! What belongs to a file besides its text is still there when it is rewritten.
#![cfg(unix)]

use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const SCENE: &str = "2 11 0 0 0 0,50\n1 9999 2 0\n";

/// The user and the group that nobody is.
const NOBODY: u32 = 65534;

/// A folder for whoever runs the program, and the program where everybody may run it.
struct Place {
    folder: tempfile::TempDir,
    program: PathBuf,
}

impl Place {
    fn new() -> Place {
        let folder = tempfile::tempdir().unwrap();
        let program = folder.path().join("zpg");
        // By another process: a program that any process still has open to write cannot be started, and those that other
        // tests start have what this one has open.
        let copied = Command::new("cp")
            .arg(env!("CARGO_BIN_EXE_zpg"))
            .arg(&program)
            .status();
        assert!(copied.unwrap().success());
        fs::set_permissions(folder.path(), Permissions::from_mode(0o755)).unwrap();
        let place = Place { folder, program };
        fs::create_dir(place.at("home")).unwrap();
        fs::create_dir(place.at("tmp")).unwrap();
        fs::set_permissions(place.at("tmp"), Permissions::from_mode(0o777)).unwrap();
        place
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, mode: u32) -> PathBuf {
        let path = self.at("home/a.zpg");
        fs::write(&path, "2  9 1\n1 9999  2 0\n").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(mode)).unwrap();
        path
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command
            .args(args)
            .env("LC_ALL", "C")
            .env("TMPDIR", self.at("tmp"));
        command
    }

    fn left(&self, folder: &str) -> usize {
        fs::read_dir(self.at(folder)).unwrap().count()
    }
}

fn is_root() -> bool {
    let folder = tempfile::tempdir().unwrap();
    fs::metadata(folder.path()).unwrap().uid() == 0
}

fn said(run: &Output) -> String {
    String::from_utf8_lossy(&[&run.stdout[..], &run.stderr].concat()).into_owned()
}

#[track_caller]
fn formats(place: &Place, path: &Path, command: &mut Command) {
    let run = command.arg("fmt").arg(path).output().unwrap();
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    assert_eq!(fs::read_to_string(path).unwrap(), "2 9 1\n1 9999 2 0\n");
    assert_eq!((place.left("home"), place.left("tmp")), (1, 0));
}

#[test]
fn permissions_stay() {
    let place = Place::new();
    for mode in [0o600, 0o640, 0o666, 0o755] {
        let path = place.write(mode);
        formats(&place, &path, &mut place.command(&[]));
        assert_eq!(fs::metadata(&path).unwrap().mode() & 0o7777, mode);
    }
}

#[test]
fn attributes_stay() {
    let place = Place::new();
    let path = place.write(0o644);
    if let Err(e) = xattr::set(&path, "user.origin", b"handout") {
        assert_eq!(e.kind(), std::io::ErrorKind::Unsupported, "{e}");
        eprintln!("skipped: the file system has no attributes");
        return;
    }
    let before = fs::metadata(&path).unwrap().ino();
    formats(&place, &path, &mut place.command(&[]));
    assert_eq!(
        xattr::get(&path, "user.origin").unwrap().unwrap(),
        b"handout"
    );
    // In one step all the same.
    assert_ne!(fs::metadata(&path).unwrap().ino(), before);
}

#[test]
fn other_names_stay() {
    let place = Place::new();
    let path = place.write(0o644);
    let other = place.at("b.zpg");
    fs::hard_link(&path, &other).unwrap();
    formats(&place, &path, &mut place.command(&[]));
    assert_eq!(
        fs::metadata(&path).unwrap().ino(),
        fs::metadata(&other).unwrap().ino()
    );
    // A symbolic link leads to the file, and is still one.
    let path = place.write(0o644);
    let link = place.at("c.zpg");
    std::os::unix::fs::symlink(&path, &link).unwrap();
    let run = place.command(&["fmt"]).arg(&link).output().unwrap();
    assert_eq!(run.status.code(), Some(0));
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
}

#[test]
fn the_owner_stays() {
    if !is_root() {
        eprintln!("skipped: only root may give files away");
        return;
    }
    let place = Place::new();
    // Root's draft is given away, too.
    let path = place.write(0o640);
    chown(&path, Some(NOBODY), Some(NOBODY)).unwrap();
    formats(&place, &path, &mut place.command(&[]));
    let found = fs::metadata(&path).unwrap();
    assert_eq!(
        (found.uid(), found.gid(), found.mode() & 0o777),
        (NOBODY, NOBODY, 0o640)
    );
    // Somebody else's cannot be: the file is written in place, in a folder of one's own and in one for all.
    for mode in [0o777, 0o1777] {
        let path = place.write(0o666);
        chown(&path, Some(0), Some(0)).unwrap();
        fs::set_permissions(place.at("home"), Permissions::from_mode(mode)).unwrap();
        formats(&place, &path, place.command(&[]).uid(NOBODY).gid(NOBODY));
        let found = fs::metadata(&path).unwrap();
        assert_eq!(
            (found.uid(), found.gid(), found.mode() & 0o777),
            (0, 0, 0o666)
        );
    }
}

/// What cannot be read is named, not the folder that was asked for.
#[test]
fn a_folder_below_may_be_closed() {
    let place = Place::new();
    for name in ["a", "b/c"] {
        let closed = place.at("home").join(name);
        fs::create_dir_all(&closed).unwrap();
        fs::set_permissions(&closed, Permissions::from_mode(0o000)).unwrap();
    }
    let mut command = place.command(&["check"]);
    if is_root() {
        command.uid(NOBODY).gid(NOBODY);
    }
    let run = command.arg(place.at("home")).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
    for name in ["home/a", "home/b/c"] {
        let line = format!(
            "cannot read {}: Permission denied",
            place.at(name).display()
        );
        assert!(said(&run).contains(&line), "{}", said(&run));
    }
}

#[test]
fn a_folder_may_forbid_new_files() {
    let place = Place::new();
    let path = place.write(0o666);
    fs::set_permissions(place.at("home"), Permissions::from_mode(0o555)).unwrap();
    let mut command = place.command(&[]);
    // Root may do anything.
    if is_root() {
        command.uid(NOBODY).gid(NOBODY);
    }
    formats(&place, &path, &mut command);
    let path = place.at("home/a.zpg");
    fs::write(&path, SCENE).unwrap();
    let mut command = place.command(&["check", "--fix"]);
    if is_root() {
        command.uid(NOBODY).gid(NOBODY);
    }
    let run = command.arg(&path).output().unwrap();
    assert_ne!(run.status.code(), Some(2), "{}", said(&run));
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        SCENE.replace("0,50", "0.50")
    );
    assert_eq!((place.left("home"), place.left("tmp")), (1, 0));
    fs::set_permissions(place.at("home"), Permissions::from_mode(0o755)).unwrap();
}

/// What cannot be written to its end takes nothing from the file, also where that is written in place.
#[test]
fn a_file_stays_where_there_is_no_room() {
    let place = Place::new();
    let path = place.at("home/a.zpg");
    // Numbers under each other take more room: more than a file may have here.
    let long = "2 12 -10000000000.5 -10000000000.5 -10000000000.5 1.25 1.25 1.25\n";
    let old = long.to_owned()
        + &(3..40)
            .map(|id| format!("{id} 12 0 0 0 1 1 1\n"))
            .collect::<String>();
    assert!(old.len() < 1024);
    fs::write(&path, &old).unwrap();
    fs::hard_link(&path, place.at("b.zpg")).unwrap();
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" fmt \"$1\"";
    let run = Command::new("bash")
        .args(["-c", script])
        .args([&place.program, &path])
        .env("LC_ALL", "C")
        .env("TMPDIR", place.at("tmp"))
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(2), "{}", said(&run));
    assert!(said(&run).contains("cannot write"), "{}", said(&run));
    assert_eq!(fs::read_to_string(&path).unwrap(), old);
    assert_eq!((place.left("home"), place.left("tmp")), (1, 0));
}

#[test]
fn what_is_no_regular_file_is_refused() {
    let place = Place::new();
    let pipe = place.at("home/a.zpg");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    for args in [&["fmt"][..], &["check", "--fix"], &["check", "--add-allow"]] {
        // Nobody writes into the pipe: it is not even opened.
        let run = place.command(args).arg(&pipe).output().unwrap();
        assert_eq!(run.status.code(), Some(2));
        assert!(
            said(&run).contains("it is not a regular file"),
            "{}",
            said(&run)
        );
        let kind = fs::symlink_metadata(&pipe).unwrap().file_type();
        assert!(std::os::unix::fs::FileTypeExt::is_fifo(&kind));
    }
}

//! The build for every processor hands over to the one with AVX2 and FMA that lies beside it in a package.
//!
//! The tests themselves run in a build with these instructions, which never hands over. So the module that decides is
//! compiled by itself for every processor; the faster build is a script that says what it was given.
#![cfg(all(target_arch = "x86_64", unix))]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::support::program::text;

/// A package as it is installed.
struct Package {
    folder: tempfile::TempDir,
}

impl Package {
    fn new() -> Package {
        let package = Package {
            folder: tempfile::tempdir().unwrap(),
        };
        fs::create_dir_all(package.path("bin")).unwrap();
        fs::create_dir_all(package.path("lib/zpg")).unwrap();
        let module = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/machine.rs");
        let source = format!(
            "#[path = {module:?}] mod machine;\n\
             fn main() {{ machine::suffices().unwrap(); println!(\"every processor\"); std::process::exit(3) }}\n"
        );
        fs::write(package.path("main.rs"), source).unwrap();
        let built = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
            .args(["--edition", "2024", "-C", "target-cpu=x86-64", "-o"])
            .arg(package.plain())
            .arg(package.path("main.rs"))
            .output()
            .unwrap();
        assert!(built.status.success(), "{}", text(&built.stderr));
        package
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn plain(&self) -> PathBuf {
        self.path("bin/zpg")
    }

    fn faster(&self) -> PathBuf {
        self.path("lib/zpg/zpg-x86-64-v3")
    }

    /// Puts a program there that says what it was given and ends with 5.
    fn put(&self, mode: u32) {
        let _ = fs::remove_file(self.faster());
        fs::write(self.faster(), "#!/bin/sh\necho \"faster: $*\"\nexit 5\n").unwrap();
        fs::set_permissions(self.faster(), PermissionsExt::from_mode(mode)).unwrap();
    }

    fn run(&self, program: &Path) -> (Option<i32>, String) {
        let run = Command::new("timeout")
            .arg("20")
            .arg(program)
            .args(["a b", "-c"])
            .output();
        let Output { status, stdout, .. } = run.unwrap();
        (status.code(), text(&stdout).to_owned())
    }
}

fn has_fma() -> bool {
    // Both have what the two names stand for, and more, since the first processors of x86-64-v3.
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

#[test]
fn the_faster_build_runs_where_it_can() {
    let package = Package::new();
    let own = (Some(3), "every processor\n".to_owned());
    let faster = match has_fma() {
        true => (Some(5), "faster: a b -c\n".to_owned()),
        false => own.clone(),
    };
    // It is the only one.
    assert_eq!(package.run(&package.plain()), own);
    package.put(0o755);
    assert_eq!(package.run(&package.plain()), faster);
    // By a link from elsewhere, as package managers make them.
    symlink(package.plain(), package.path("zpg")).unwrap();
    assert_eq!(package.run(&package.path("zpg")), faster);
    // One that may not be run.
    package.put(0o644);
    assert_eq!(package.run(&package.plain()), own);
}

/// Whoever puts the wrong build there gets an answer all the same.
#[test]
fn it_does_not_hand_over_to_itself_for_ever() {
    let package = Package::new();
    let own = (Some(3), "every processor\n".to_owned());
    fs::copy(package.plain(), package.faster()).unwrap();
    assert_eq!(package.run(&package.plain()), own);
    fs::remove_file(package.faster()).unwrap();
    symlink(package.plain(), package.faster()).unwrap();
    assert_eq!(package.run(&package.plain()), own);
    fs::remove_file(package.faster()).unwrap();
    fs::hard_link(package.plain(), package.faster()).unwrap();
    assert_eq!(package.run(&package.plain()), own);
}

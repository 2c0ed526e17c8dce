//! How bright POV-Ray draws what was translated for it, as people run it.

use std::path::Path;
use std::process::Command;

use crate::support::program::zpg;

/// A ball on a floor, lit by lamps of an intensity that together could make it brighter than white.
fn scene(lamps: f64) -> String {
    format!(
        "2 11 0 1 0 1\n2 -701 0.9 0.2 0.1\n2 -201 0.7 0.3 0\n3 4 0 1 0 0\n3 -701 0.9 0.9 0.8\n4 -101 2 3\n\
         7 -402 {lamps}\n7 -1 4 6 5\n8 -402 {lamps}\n8 -1 -6 6 5\n9 -401 0.15\n\
         10 -501 1.5 2.2 5 -0.28 -0.26 -1 0 1 0 40\n1 9999 4 0\n"
    )
}

/// A scene's translation, and the report of that.
fn translated(folder: &Path, lamps: f64) -> (String, String) {
    std::fs::write(folder.join("a.zpg"), scene(lamps)).unwrap();
    let args = [
        "convert",
        "a.zpg",
        "--to",
        "pov",
        "-o",
        "a.pov",
        "--size",
        "80x60",
        "--verbose",
    ];
    let run = zpg(folder, &args);
    let report = String::from_utf8(run.stderr).unwrap();
    assert!(run.status.success(), "{report}");
    (
        std::fs::read_to_string(folder.join("a.pov")).unwrap(),
        report,
    )
}

#[test]
fn the_report_names_light_above_white() {
    let dir = tempfile::tempdir().unwrap();
    // Lamps of 0.45 and ambient light of 0.15 are more than white together, but no pixel is.
    let (text, report) = translated(dir.path(), 0.45);
    assert!(
        text.contains("\n#ifndef (Light_Scale) #declare Light_Scale = 1; #end\n"),
        "{text}"
    );
    assert!(
        report.contains("exact        light above white: nothing in a small picture is"),
        "{report}"
    );
    let (text, report) = translated(dir.path(), 1.5);
    // 0.25 and not 0.5: two lamps and the ambient light are 3.15.
    assert!(
        text.contains(" File_Gamma=1.0 Declare=Light_Scale=0.25\n"),
        "{text}"
    );
    let line = report
        .lines()
        .find(|l| l.contains("light above white"))
        .unwrap();
    assert!(line.starts_with("approximate"), "{line}");
    assert!(
        line.ends_with(
            "with Declare=Light_Scale=0.25 nothing is clipped, and all is 0.25 times as bright"
        ),
        "{line}"
    );
    // The share is that of our own picture.
    let args = [
        "render",
        "a.zpg",
        "-o",
        "a.pfm",
        "--size",
        "80x60",
        "--samples",
        "1",
    ];
    assert!(zpg(dir.path(), &args).status.success());
    let bytes = std::fs::read(dir.path().join("a.pfm")).unwrap();
    let values = &bytes[bytes.len() - 80 * 60 * 12..];
    let above = values.chunks_exact(12).filter(|p| {
        p.chunks_exact(4)
            .any(|c| f32::from_le_bytes([c[0], c[1], c[2], c[3]]) > 1.0)
    });
    let percent = 100.0 * above.count() as f64 / 4800.0;
    assert!(
        percent > 5.0 && line.contains(&format!("({percent:.0} % of the picture")),
        "{percent}: {line}"
    );
}

/// The file as it is, with POV-Ray's own settings: a picture as bright as ours, clipped where ours is.
#[test]
#[ignore = "needs POV-Ray"]
fn the_picture_is_as_bright_as_ours() {
    for lamps in [0.45, 1.5] {
        let dir = tempfile::tempdir().unwrap();
        translated(dir.path(), lamps);
        let run = Command::new("povray")
            .args(["+Ia.pov", "+Otheirs.png", "+W80", "+H60", "-D", "-A"])
            .current_dir(dir.path())
            .output()
            .unwrap();
        assert!(
            run.status.success(),
            "{}",
            String::from_utf8_lossy(&run.stderr)
        );
        let args = [
            "render",
            "a.zpg",
            "-o",
            "ours.png",
            "--size",
            "80x60",
            "--samples",
            "1",
        ];
        assert!(zpg(dir.path(), &args).status.success());
        let [ours, theirs] = ["ours.png", "theirs.png"]
            .map(|name| image::open(dir.path().join(name)).unwrap().to_rgb8());
        let alike = ours.pixels().zip(theirs.pixels());
        let alike = alike.filter(|(a, b)| (0..3).all(|k| a.0[k].abs_diff(b.0[k]) <= 2));
        // But for some on edges.
        assert!(alike.count() > 4800 - 60, "lamps of {lamps}");
    }
}

//! Scenes with round numbers in POV-Ray and in our tracer: things of glass and others that stand on one another,
//! overlap, fill each other and end in the same planes.

mod things;

use std::path::Path;

use crate::support::compare::{agrees, compare};
use crate::support::{cases, povray, seeds};
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::Language;
use zpg::internals::translate::pov;

/// Glass of three kinds, two opaque materials, one that light goes through straight on.
const LOOKS: &str = "11 -701 0.3 0.6 0.58\n12 -701 0.85 0.5 0.8\n13 -701 0.9 0.7 0.2\n14 -701 0.4 0.5 0.62\n\
                     20 -201 0.05 0.05 0.87\n20 -203 1.5 1.5 1.5\n21 -201 0.06 0 0.9\n21 -203 1.3 1.3 1.3\n\
                     22 -201 0.1 0.05 0.8\n22 -203 1.1 1.1 1.1\n23 -201 0.8 0.1 0\n24 -201 0.5 0 0.4\n25 -201 0.2 0.7 0\n";

/// The parts of a union, in order, seen from somewhere above.
fn parts(body: &str, order: &[u32], [x, y, z]: [f64; 3]) -> Analysis {
    let mut text = format!("{LOOKS}{body}");
    let mut root = order[0];
    for (i, part) in order[1..].iter().enumerate() {
        text += &format!("{} -101 {root} {part}\n", 200 + i);
        root = 200 + i as u32;
    }
    let down = 0.4 - y;
    text += &format!(
        "3 -402 0.8\n3 -1 -0.5 6.1 4.6\n4 -401 0.2\n5 -501 {x} {y} {z} {} {down} {} 0 1 0 40\n1 9999 {root} 14\n",
        -x, -z
    );
    let loaded = Analysis::new("contacts", text.into_bytes());
    assert!(loaded.is_sound(), "{:?}", loaded.findings());
    loaded
}

const EYE: [f64; 3] = [0.8, 1.8, 2.2];

/// Something opaque that fills a hole in glass: the face is the glass's, through which one sees into it, but
/// nothing of what else is in it, before it or after it in the order.
/// Boxes with their tops in one plane are moved apart only where the tops meet, and not where boxes around them do.
#[test]
fn only_faces_that_meet_are_moved_apart() {
    // Along the diagonal the boxes, turned by 45 degrees, are 2 long.
    for (apart, is_moved) in [(2.4, false), (2.001, false), (1.9, true), (0.5, true)] {
        let way = apart / 2.0f64.sqrt();
        let text = format!(
            "2 12 -1 -1 -1 1 1 1\n2 -701 1 0 0\n2 -2 45 2\n3 12 -1 -1 -1 1 1 1\n3 -2 45 2\n3 -1 {way} 0 {way}\n\
             4 -101 2 3\n1 9999 4 0\n"
        );
        let loaded = Analysis::new("boxes.zpg", text.into_bytes());
        let translation =
            pov::write(&loaded.scene, loaded.bounds(), &pov::Options::default()).unwrap();
        let text = &translation.files[0].text;
        assert_eq!(text.contains("made longer"), is_moved, "{apart}\n{text}");
    }
}

/// A union of very many parts and an operand that is moved very often: the report names both limits, in both languages.
#[test]
fn limits_that_are_exceeded_are_named() {
    let mut text =
        "2 12 -1 -1 -1 1 1 1\n3 9 1\n".to_owned() + &"2 -1 0.1 0 0\n2 -701 1 0 0\n".repeat(33);
    text += "4 -103 2 3\n";
    let mut root = 4;
    for (part, union) in (5..1030).zip(2000..) {
        text += &format!("{part} 11 {part} 0 0 0.25\n{union} -101 {root} {part}\n");
        root = union;
    }
    text += &format!("1 9999 {root} 0\n");
    let loaded = Analysis::new("parts.zpg", text.into_bytes());
    let report =
        (pov::write(&loaded.scene, loaded.bounds(), &pov::Options::default()).unwrap()).report;
    for (language, words) in [
        (
            Language::English,
            "limits of the translation (in unions of more than 1024 parts faces",
        ),
        (
            Language::English,
            "limits of the translation (operands that are modified more than 64 times",
        ),
        (
            Language::Czech,
            "meze převodu (ve sjednoceních o více než 1024 částech se stěny",
        ),
        (
            Language::Czech,
            "meze převodu (operandy změněné více než 64krát",
        ),
    ] {
        let text = report.text(language);
        assert!(text.contains(words), "{words}\n{text}");
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn what_is_in_opaque_fillings() {
    let floor = "101 4 0 1 0 0\n101 -299 11 24\n";
    let cube = "102 12 -0.5 -0.5 -0.5 0.5 0.5 0.5\n103 9 0.3\n104 -103 102 103\n104 -299 12 22\n\
                105 9 0.3\n105 -299 13 25\n";
    let place = "-1 -0.3 0.52 -0.3\n";
    let rod = format!("106 12 -0.2 -0.05 -0.05 0.2 0.05 0.05\n106 -299 11 25\n106 {place}");
    let cup = "107 1 5 0.4 0 0.5 1.2 0.45 1.2 0.35 0.1 0 0.1\n107 -299 12 22\n";
    let body = format!("{floor}{cube}104 {place}105 {place}{rod}{cup}");
    let orders: [&[u32]; 4] = [
        &[101, 104, 105, 107],
        &[104, 105, 107],
        &[101, 104, 106, 105],
        &[101, 104, 105, 106],
    ];
    for (i, order) in orders.into_iter().enumerate() {
        agrees(&format!("filled_{i}"), &parts(&body, order, EYE));
    }
}

/// Things side by side on a plate of glass: one ends where the other does, and both stand on a third.
#[test]
#[ignore = "needs POV-Ray"]
fn side_by_side_on_a_plate() {
    let body = |look: u32| {
        format!(
            "101 12 -0.8 -0.05 -0.6 0.6 0 0.6\n101 -299 11 22\n102 12 -0.3 0 -0.3 0.3 0.4 0.3\n102 -299 14 {look}\n\
             102 -1 -0.5 0 0\n103 1 5 0.4 0 0.5 1.2 0.45 1.2 0.35 0.1 0 0.1\n103 -299 12 22\n"
        )
    };
    for look in [21, 23, 24] {
        let name = format!("beside_{look}");
        agrees(&name, &parts(&body(look), &[101, 102, 103], EYE));
    }
    // A vessel that reaches beyond the edge of what it stands on.
    let vessel = "101 12 -1.75 -0.25 -1.25 1 0 0.5\n101 -299 11 24\n106 12 -0.375 0 -0.375 0.375 0.75 0.375\n\
                  107 12 -0.25 0.125 -0.25 0.25 0.75 0.25\n108 -103 106 107\n108 -299 14 21\n108 -1 0.25 0 0.25\n";
    agrees("edge", &parts(vessel, &[101, 108], [-1.27, 3.45, 4.62]));
}

/// Parts of one medium with others between them in the order.
#[test]
#[ignore = "needs POV-Ray"]
fn one_medium_in_turns() {
    let scenes: [(&str, &[u32]); 4] = [
        // A floor and a vessel on it that light goes through straight on; a plate and a cylinder on it.
        (
            "101 4 0 1 0 0\n101 -299 11 24\n102 9 0.5\n102 -1 0.75 0.5 -0.5\n102 -299 12 20\n\
             103 12 -0.625 0 -0.625 0.625 1.25 0.625\n104 12 -0.5 0.125 -0.5 0.5 1.25 0.5\n105 -103 103 104\n\
             105 -299 11 24\n105 -2 45 2\n105 -1 -0.5 0 0\n",
            &[101, 102, 105],
        ),
        (
            "101 1 2 1.75 -0.125 1 0\n101 -299 13 24\n102 1 5 0.5 0 0.5 0.75 0.45 0.75 0.45 0.05 0 0.05\n\
             102 -299 12 20\n102 -1 0.75 0 -0.25\n103 1 2 0.5 0 0.5 0.5\n103 -299 11 24\n103 -1 -0.25 0 0.25\n",
            &[101, 102, 103],
        ),
        // Boxes of something opaque that a ball of glass is between.
        (
            "103 12 -0.75 0 -0.625 0.75 0.75 0.625\n103 -299 12 23\n103 -1 0.5 0 -0.5\n105 9 0.5\n\
             105 -1 -0.5 0.5 0.5\n105 -299 14 22\n106 12 -0.75 0 -0.25 0.75 0.5 0.25\n106 -299 12 23\n106 -1 0.25 0 0\n",
            &[103, 105, 106],
        ),
        // A dome on a plate of its own glass, with ground and a cone of another one.
        (
            "101 4 0 1 0 0.25\n101 -299 11 21\n102 12 -1 -0.25 -1.5 2 0 1.25\n102 -299 12 20\n103 9 0.75\n\
             104 4 0 -1 0 0\n105 -102 103 104\n105 -299 12 20\n105 -1 0.25 0 -0.75\n110 1 2 0.75 0 0 0.75\n\
             110 -299 12 21\n110 -1 0.5 0 -0.75\n",
            &[101, 102, 105, 110],
        ),
    ];
    for (i, (body, order)) in scenes.into_iter().enumerate() {
        agrees(&format!("turns_{i}"), &parts(body, order, [1.4, 3.3, 5.3]));
    }
}

/// What fills a hole through a block, as high as that; what is in one place but turned about its axis; a filling,
/// and something on top, that are parts of one opaque object with other things.
#[test]
#[ignore = "needs POV-Ray"]
fn fillings_and_groups() {
    let block = |hole: u32, filling: u32| {
        format!(
            "105 12 -0.375 0 -0.75 0.375 1 0.75\n106 1 2 0.2 0 0.2 1\n107 -103 105 106\n108 1 2 0.2 0 0.2 1\n\
             107 -299 12 {hole}\n107 -2 90 2\n107 -1 0.5 0 0.25\n108 -299 14 {filling}\n108 -2 90 2\n108 -1 0.5 0 0.25\n"
        )
    };
    for (i, (hole, filling)) in [(23, 21), (22, 23), (22, 21)].into_iter().enumerate() {
        let name = format!("block_{i}");
        agrees(&name, &parts(&block(hole, filling), &[107, 108], EYE));
    }
    let turned = "104 1 5 0.25 0 0.25 1 0.2 1 0.2 0.05 0 0.05\n104 -299 12 23\n104 -1 0.75 0 0.5\n\
                  107 1 2 0.25 0 0.25 0.75\n107 -299 14 21\n107 -2 30 2\n107 -1 0.75 0 0.5\n";
    agrees("turned", &parts(turned, &[107, 104], [1.5, 2.0, 4.0]));
    let drink = "101 12 -1.25 -0.25 -1.25 1.25 0 1\n101 -299 11 23\n103 1 3 0 0.05 0.45 0.05 0.45 0.575\n103 -299 11 23\n\
                 103 -1 -0.25 0 -0.25\n102 1 5 0.5 0 0.5 0.75 0.45 0.75 0.45 0.05 0 0.05\n102 -299 13 20\n\
                 102 -1 -0.25 0 -0.25\n";
    agrees(
        "drink_of_table",
        &parts(drink, &[103, 101, 102], [1.4, 3.3, 5.3]),
    );
    let dome = "101 12 -1.25 -0.25 -1 1.5 0 1.25\n101 -299 14 23\n107 9 0.5\n108 4 0 -1 0 0\n109 -102 107 108\n\
                109 -299 12 20\n109 -1 0.5 0 -0.75\n110 1 2 0.5 0 0.5 0.75\n110 -299 14 23\n110 -1 0.25 0.5 -0.5\n";
    agrees(
        "dome_on_table",
        &parts(dome, &[110, 101, 109], [1.4, 3.3, 5.3]),
    );
    // The same table as one thing that was painted and moved as a whole.
    let table = dome.replace("101 -299 14 23\n", "")
        + "111 -101 110 101\n111 -299 14 23\n111 -1 0 0.25 0\n109 -1 0 0.25 0\n";
    let table = table.replace("110 -299 14 23\n", "");
    agrees("moved_table", &parts(&table, &[111, 109], [1.4, 3.3, 5.3]));
}

/// Where three overlap, and the second one bends no light.
#[test]
#[ignore = "needs POV-Ray"]
fn three_in_one_place() {
    let body = "102 1 2 0.25 0 0.25 1\n102 -299 11 20\n102 -1 0.25 0 0\n103 1 2 0.75 0 0.75 0.75\n103 -299 14 24\n\
                103 -1 0.5 0 -0.5\n105 1 2 0.75 0 0.75 0.75\n105 -299 12 21\n105 -1 0.5 0.25 -0.25\n";
    agrees("three", &parts(body, &[102, 103, 105], [-1.04, 1.37, 5.45]));
}

/// A dome on a plate that is thinner than it: made longer for the plate, it does not come out below.
#[test]
#[ignore = "needs POV-Ray"]
fn domes_on_thin_plates() {
    let plate = "101 12 -1 -0.12 -0.8 1 0 0.8\n101 -299 14 21\n";
    let dome = "103 9 0.5\n104 4 0 -1 0 0\n105 -102 103 104\n105 -299 12 22\n";
    for (name, place) in [
        ("straight", ""),
        ("turned", "105 -2 90 2\n105 -1 -0.2 0 0\n"),
        ("flat", "105 -3 1.2 0.5 1\n"),
        ("very_flat", "105 -3 1.2 0.08 1\n"),
    ] {
        let body = format!("{plate}{dome}{place}");
        agrees(&format!("dome_{name}"), &parts(&body, &[101, 105], EYE));
    }
}

/// Two opaque boxes of different looks that end in one plane, only the first of them beside glass.
#[test]
#[ignore = "needs POV-Ray"]
fn level_tops_beside_glass() {
    let body = "101 1 2 0.75 0 0.75 0.5\n101 -299 11 20\n101 -1 -0.5 0 -0.75\n\
                102 12 -0.375 0 -0.5 0.375 0.75 0.5\n102 -299 11 23\n102 -2 30 2\n102 -1 0.75 0 0\n\
                103 12 -0.375 0 -0.25 0.375 0.75 0.25\n103 -299 14 23\n103 -2 30 2\n103 -1 0.75 0 0.25\n";
    let eye = [-1.23, 2.07, 5.04];
    agrees("level", &parts(body, &[101, 102, 103], eye));
}

/// Things of all sorts on a grid keep to the bar. `CONTACT_SEEDS=0..200` chooses others; benches/README.md says
/// what came of these.
#[test]
#[ignore = "needs POV-Ray"]
fn things_on_a_grid() {
    let mut bad = Vec::new();
    for seed in seeds("CONTACT_SEEDS", 0..cases(2, 6)) {
        let text = things::scene(seed, LOOKS);
        let loaded = Analysis::new("things", text.clone().into_bytes());
        assert!(loaded.is_sound(), "{seed}: {:?}", loaded.findings());
        let name = format!("grid_{seed}");
        let path = povray::folder().join(format!("{name}.zpg"));
        std::fs::write(path, &text).unwrap();
        for outcome in compare(&name, &loaded.scene, Path::new("."), (96, 72)) {
            let share = 100.0 * outcome.differing.share_off_silhouettes;
            println!(
                "{name:>8}: {share:6.3} % wrong, {} total reflection",
                outcome.total_reflection
            );
            if share > 0.05 {
                bad.push(name.clone());
            }
        }
    }
    assert!(bad.is_empty(), "{bad:?}");
}

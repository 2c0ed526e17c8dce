//! What W307 says, and what not.

use crate::diagnostics::Applicability;
use crate::lint::testing::{self, fixed, fixes, messages};

/// What this rule finds.
fn found(scene: &str) -> Vec<String> {
    let all = testing::found(scene).into_iter();
    all.filter(|f| f.starts_with("W307")).collect()
}

/// Water in a glass; the two spheres overlap by 0.5.
fn two(first: &str, second: &str) -> String {
    format!(
        "2 11 0 0 0 1\n2 {first}\n3 11 1.5 0 0 1\n3 {second}\n4 -101 2 3 # both #\n1 9999 4 0\n"
    )
}

const GLASS: &str = "-201 0 0 1";
const MATT: &str = "-201 0.5 0 0";

#[test]
fn glass_with_something_else() {
    let scene = two(GLASS, MATT);
    assert_eq!(found(&scene), ["W307 5:8"]);
    assert_eq!(
        messages(&scene),
        [
            "in the union 4, the sphere 2 and the sphere 3 overlap, and they are of different media: (0.75, 0, 0) is in both"
        ]
    );
    assert_eq!(found(&two(MATT, GLASS)).len(), 1);
    assert_eq!(found(&two(GLASS, "-201 0 0.1 0.9")).len(), 1);
    // Opaque, of one medium, or apart.
    assert!(found(&two(MATT, "-201 0.9 0 0")).is_empty());
    assert!(found(&two(GLASS, "-201 0 0 1.0")).is_empty());
    assert!(found(&two(GLASS, "-1 0.5 0 0")).is_empty());
    assert!(found(&two(GLASS, "-1 0.49999999 0 0")).is_empty());
    assert_eq!(found(&two(GLASS, "-1 0.49 0 0")).len(), 1);
}

#[test]
fn the_fix_keeps_the_comment() {
    let scene = two(GLASS, MATT);
    let after = fixed(&scene);
    let pieces = "\n5 -102 2 3\n5 -201 0 0 1\n6 -103 2 3\n7 -103 3 2\n8 -101 6 7\n";
    assert!(
        after.contains(&format!("{pieces}4 -101 5 8 # both #\n")),
        "{after}"
    );
    assert_eq!(fixes(&scene)[0].1, Applicability::Unsafe);
    assert!(!found(&after).iter().any(|f| f.starts_with("W307")));
}

#[test]
fn the_fix_leaves_out_what_is_empty() {
    let within = two(GLASS, MATT).replace("3 11 1.5 0 0 1", "3 11 0.1 0 0 0.5");
    let after = fixed(&within);
    assert!(after.contains("\n5 -102 2 3\n5 -201 0 0 1\n6 -103 2 3\n4 -101 5 6 # both #\n"));
    assert_eq!(testing::found(&after), Vec::<String>::new());
    // What has never been given a property has none of its own to repeat.
    let plain = two(MATT, GLASS).replace("2 -201 0.5 0 0\n", "");
    assert!(fixed(&plain).contains("\n5 -102 2 3\n5 -299 0 0\n"));
}

#[test]
fn properties_of_the_whole_and_parts_of_parts() {
    // Painted over.
    let over = two(GLASS, MATT).replace("1 9999", "4 -201 0 0 1\n1 9999");
    assert!(found(&over).is_empty());
    // Parts of different unions, one of them moved.
    let nested = "2 9 1\n2 -201 0 0 1\n3 11 9 0 0 1\n4 -101 2 3\n5 9 1\n6 11 9 9 0 1\n7 -101 6 5\n\
        7 -1 0.5 0 0\n8 -101 4 7\n1 9999 8 0\n";
    assert_eq!(found(nested), ["W307 9:8"]);
    // Cut off.
    let cut = two(GLASS, MATT).replace("1 9999 4 0", "5 12 -2 -2 -2 0 2 2\n6 -102 4 5\n1 9999 6 0");
    assert!(found(&cut).is_empty());
    let left = two(GLASS, MATT).replace(
        "1 9999 4 0",
        "5 12 -2 -2 -2 2 0.5 2\n6 -102 4 5\n1 9999 6 0",
    );
    assert_eq!(found(&left), ["W307 5:8"]);
    // A tool's parts have no properties.
    let tool =
        two(GLASS, MATT).replace("1 9999 4 0", "5 12 -2 -2 -2 2 2 2\n6 -103 5 4\n1 9999 6 0");
    assert!(found(&tool).is_empty());
    // Not drawn.
    let boxed = two(GLASS, MATT).replace("9999 4 0", "9999 4 0 -9 -9 -9 0 9 9");
    assert!(found(&boxed).is_empty());
}

/// A red and a blue ball, and what is cut out of both.
#[test]
fn opaque_parts_cut_open() {
    let cut = |operation: &str, tool: &str| {
        format!(
            "2 11 -.5 0 0 1\n2 -701 1 0 0\n3 11 .5 0 0 1\n3 -701 0 0 1\n4 -101 2 3\n5 12 {tool}\n\
             6 {operation} 4 5\n1 9999 6 0\n"
        )
    };
    let corner = "-3 -3 0 3 3 3";
    let scene = cut("-103", corner);
    assert_eq!(found(&scene), ["W307 5:8"]);
    let says = messages(&scene).remove(0);
    assert!(
        says.starts_with("in the union 4, the sphere 2 and the sphere 3 overlap, look different, and are cut open: at (")
            && says.ends_with(", 0) the cut goes through both"),
        "{says}"
    );
    let after = fixed(&scene);
    assert!(after.contains("7 -102 2 3\n7 -701 1 0 0\n"), "{after}");
    assert!(found(&after).is_empty());
    // A cut beside what both hold, one that takes all of it, one that is not drawn.
    assert!(found(&cut("-103", "-3 -3 -3 -.6 3 3")).is_empty());
    assert!(found(&cut("-103", "-.6 -3 -3 .6 3 3")).is_empty());
    assert!(found(&scene.replace("9999 6 0", "9999 6 0 -9 -9 -9 9 9 -.1")).is_empty());
    // Faces that an intersection makes look like what cuts.
    assert!(found(&cut("-102", corner)).is_empty());
    // Alike, nowhere cut, or painted over.
    assert!(found(&scene.replace("3 -701 0 0 1", "3 -701 1 0 0")).is_empty());
    assert!(found(&scene.replace("6 -103 4 5", "6 -101 4 5")).is_empty());
    assert!(found(&scene.replace("1 9999", "6 -701 0 1 0\n1 9999")).is_empty());
    // One of them shines.
    let shines = scene.replace("3 -701 0 0 1", "3 -701 1 0 0\n3 -201 .5 .5 0");
    assert_eq!(found(&shines).len(), 1);
}

#[test]
fn a_stone_in_the_glass() {
    let stone = "2 9 2\n2 -201 0 0 1\n3 9 0.5\n4 -101 3 2\n1 9999 4 0\n";
    assert_eq!(found(stone), ["W307 4:8"]);
    // In a hollow made for it.
    let hollow = "2 9 2\n2 -201 0 0 1\n3 9 0.5\n5 -103 2 3\n4 -101 3 5\n1 9999 4 0\n";
    assert!(found(hollow).is_empty());
    // In water that has no end.
    let water = "2 4 0 1 0 0\n2 -201 0 0 1\n3 9 0.5\n4 -101 3 2\n1 9999 4 0\n";
    assert_eq!(found(water), ["W307 4:8"]);
}

/// Pairs of balls, all in one chain of unions: each pair is found at the union that joins it,
/// however deep that lies.
#[test]
fn chains_of_unions() {
    const PAIRS: usize = 5000;
    let mut scene = String::from("2 -201 0 0 1\n");
    let mut expected = Vec::new();
    let mut chain = 0;
    for i in 0..PAIRS {
        let (one, two) = (10 + 4 * i, 11 + 4 * i);
        scene += &format!("{one} 11 {} 0 0 1\n{one} -299 0 2\n", 4 * i);
        scene += &format!("{two} 11 {} 0 0 1\n", 4 * i + 1);
        for ball in [one, two] {
            if chain > 0 {
                scene += &format!("{} -101 {chain} {ball}\n", ball + 2);
                chain = ball + 2;
            } else {
                chain = ball;
            }
        }
        let line = scene.lines().count();
        expected.push(format!(
            "W307 {line}:{}",
            format!("{chain} -101 ").len() + 1
        ));
    }
    scene += &format!("1 9999 {chain} 0\n");
    assert_eq!(found(&scene), expected);
}

#[test]
fn what_nobody_sees_depends_on_no_order() {
    let inside = |radius: &str, more: &str| {
        format!(
            "2 11 0 0 0 {radius}\n2 {GLASS}\n3 11 0 0 0 1\n4 -101 2 3\n{more}\n1 9999 5 0 -9 -9 -9 9 9 9\n"
        )
    };
    let alone = "5 -101 4 4";
    assert!(found(&inside("0.5", "5 -105 4")).is_empty());
    // It touches the opaque ball from within, or reaches out of it.
    assert_eq!(found(&inside("1", "5 -105 4")).len(), 1);
    assert_eq!(found(&inside("1.5", "5 -105 4")).len(), 1);
    // Something opens the ball: a cut, other glass, or the ball is not opaque itself.
    assert_eq!(
        found(&inside("0.5", "6 12 0 0 0 2 2 2\n5 -103 4 6")).len(),
        1
    );
    let glass = "6 11 1 0 0 0.25\n6 -201 0 0 1\n5 -101 6 4";
    assert!(!found(&inside("0.5", glass)).is_empty());
    assert_eq!(found(&inside("0.5", "5 -105 4\n5 -201 0 0 1")).len(), 0);
    // What occurs twice is not looked into.
    assert!(!found(&inside("0.5", alone)).is_empty());
    // Without a picture nothing is known about who sees it.
    let unrendered = inside("0.5", "5 -105 4").replace("1 9999", "0 #");
    assert_eq!(found(&format!("{}#", unrendered.trim_end())).len(), 1);
}

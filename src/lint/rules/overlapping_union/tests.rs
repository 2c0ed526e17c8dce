//! Scenes with and without the finding W307.

use crate::lint::testing::{self};

/// The findings of this rule.
fn found(scene: &str) -> Vec<String> {
    let all = testing::found(scene).into_iter();
    all.filter(|f| f.starts_with("W307")).collect()
}

/// Pairs of balls, all in one chain of unions: each pair is found at the union that joins it,
/// however deep that lies.
#[test]
fn chains_of_unions() {
    const PAIRS: usize = 1500;
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

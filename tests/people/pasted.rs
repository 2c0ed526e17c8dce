//! Text of POV-Ray behind an ID or alone on a line: the records that it stands for, and nothing of it is lost.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Language};

use super::{fixed, guessed, read};

/// A ball with a line behind it, a camera, a lamp, and what is drawn.
fn scene(line: &str) -> String {
    let rest = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    format!("2 11 0.5 0.5 0 1\n{line}\n{rest}")
}

/// A text becomes another, for one error.
fn becomes(text: &str, meant: &str) {
    let all = repair::proposals(&read(text));
    let errors: Vec<&Diagnostic> = all.iter().filter(|d| d.is_error()).collect();
    assert_eq!(errors.len(), 1, "{text}{errors:#?}");
    assert_eq!(fixed(text), meant);
}

/// What a guess knows no record for, it keeps as a comment.
#[test]
fn surfaces_and_insides() {
    for (line, meant) in [
        (
            "2 pigment { color rgb <0.8, 0.2, 0.1> } finish { reflection 0.5 }",
            "2 -701 0.8 0.2 0.1\n2 -201 0.5 0.5 0",
        ),
        (
            "2 texture { pigment { rgb <1,0,0> } finish { ambient 0.1 diffuse 0.6 reflection 0.3 } }",
            "2 -701 1 0 0\n2 -201 0.6 0.3 0 # finish { ambient 0.1 } #",
        ),
        (
            "2 pigment { rgb <1,0,0> } interior { ior 1.5 }",
            "2 -701 1 0 0\n2 -203 1.5 1.5 1.5",
        ),
        ("2 finish { diffuse 0.7 }", "2 -201 0.7 0 0"),
        // What goes through is taken from the diffuse part; a filter lets through what the colour does.
        (
            "2 pigment { color rgbt <1,1,1,0.8> }",
            "2 -701 1 1 1\n2 -201 0.2 0 0.8",
        ),
        (
            "2 pigment { rgb <1,0,0> transmit 0.5 }",
            "2 -701 1 0 0\n2 -201 0.5 0 0.5",
        ),
        (
            "2 pigment { Red filter 0.8 } interior { ior 1.5 }",
            "2 -701 1 0 0\n2 -203 1.5 1.5 1.5\n2 -202 0.2 0 0.8 0.2 0 0 0.2 0 0",
        ),
        (
            "2 pigment { rgbt <1,1,1,0.8> } finish { reflection 0.1 }",
            "2 -701 1 1 1\n2 -201 0.18 0.1 0.72",
        ),
        (
            "2 pigment { Red } finish { reflection { 0.1, 0.9 } phong 1 } no_shadow",
            "2 -701 1 0 0 # finish { reflection { 0.1, 0.9 } phong 1 } no_shadow #",
        ),
    ] {
        becomes(&scene(line), &scene(meant));
    }
    // A block that goes on below, and what is no property.
    for line in [
        "2 pigment { rgb <1,0,0> } finish {",
        "2 pigment { rgb <1,0,0> transmit 1.5 }",
        "2 pigment { rgb <1,0,0> turbulence 0.5 }",
    ] {
        assert_eq!(fixed(&scene(line)), scene(line));
    }
    let text = scene("2 pigment { Red } normal { bumps 0.2 }");
    let (error, _) = guessed(&text, Code::E006);
    let said = [Language::English, Language::Czech].map(|l| error.wording(l).fixes[0].clone());
    let meant = [
        "write each property and each transformation as a record of its own; what no record can say becomes a comment",
        "napsat každou vlastnost a každou transformaci jako samostatný záznam; z toho, co žádný záznam neříká, se stane \
         komentář",
    ];
    assert_eq!(said, meant);
}

/// A background gets an ID, which the render record names; an ambient light gets one, too.
#[test]
fn settings_of_the_scene() {
    for (line, numbers) in [
        ("background { color rgb <0.2, 0.3, 0.5> }", "0.2 0.3 0.5"),
        ("background 0.2 0.3 0.5", "0.2 0.3 0.5"),
        ("background { rgb 0.2 }", "0.2 0.2 0.2"),
        ("pozadí 0.2 0.3 0.5", "0.2 0.3 0.5"),
    ] {
        let meant = scene(&format!("51 -701 {numbers}")).replace("9999 2 0", "9999 2 51");
        becomes(&scene(line), &meant);
    }
    // Behind the render record, too.
    let text = format!("{}background 0.2 0.3 0.5\n", scene("2 -701 1 0 0"));
    let error = repair::proposals(&read(&text));
    let error = error.iter().find(|d| d.is_error()).unwrap();
    assert_eq!(&text[error.span.range()], "background");
    // Another background may be the right one.
    let text = scene("30 -701 1 1 1\nbackground 0.2 0.3 0.5").replace("9999 2 0", "9999 2 30");
    let (error, made) = guessed(&text, Code::E006);
    assert_eq!(error.fixes[0].applicability, Applicability::Choice);
    let meant = text.replace("background", "51 -701");
    assert_eq!(made, [meant.replace("9999 2 30", "9999 2 51")]);
    for (line, meant) in [
        ("global_settings { ambient_light 0.2 }", "51 -401 0.2"),
        (
            "global_settings { assumed_gamma 1 ambient_light rgb <0.2, 0.2, 0.2> max_trace_level 5 }",
            "51 -401 0.2 # assumed_gamma 1 max_trace_level 5 #",
        ),
        (
            "global_settings { ambient_light rgb <1, 0.5, 0> }",
            "51 -401 1\n51 -701 1 0.5 0",
        ),
    ] {
        becomes(&scene(line), &scene(meant));
    }
}

/// Words before the name of a picture go.
#[test]
fn pictures() {
    for (line, name) in [
        ("png moon.png", "moon.png"),
        ("png \"moon.png\"", "moon.png"),
        ("image_map { png \"moon.png\" }", "moon.png"),
        ("image_map { jpeg \"full moon.jpg\" }", "\"full moon.jpg\""),
    ] {
        let text = scene(&format!("2 -301 {line}"));
        assert_eq!(fixed(&text), scene(&format!("2 -301 {name}")));
    }
    for line in [
        "texture { pigment { image_map { png \"moon.png\" } } }",
        "pigment { image_map { png \"moon.png\" } }",
    ] {
        becomes(&scene(&format!("2 {line}")), &scene("2 -301 moon.png"));
    }
    let ball = "3 sphere { <0,1,0>, 1 texture { pigment { image_map { png \"moon.png\" } } } }";
    let text = scene(ball).replace("9999 2", "9999 3");
    let meant = scene("3 11 0 1 0 1\n3 -301 moon.png").replace("9999 2", "9999 3");
    assert_eq!(fixed(&text), meant);
    let text = scene("2 -301 full moon.png");
    assert_eq!(fixed(&text), scene("2 -301 \"full moon.png\""));
}

/// Several transformations behind one ID.
#[test]
fn several_transformations() {
    for line in [
        "2 -1 0 1 0 rotate <0, 45, 0>",
        "2 -1 0 1 0 rotate 0 45 0",
        "2 -1 0 1 0 -2 45 2",
        "2 translate <0,1,0> rotate <0,45,0>",
        "2 translate y rotate 45*y",
        "2 translate <0,1,0> -2 45 2",
    ] {
        becomes(&scene(line), &scene("2 -1 0 1 0\n2 -2 45 2"));
    }
    let text = scene("3 11 0 1 0 0.5 translate <1,0,0>").replace("9999 2", "9999 3");
    let meant = scene("3 11 0 1 0 0.5\n3 -1 1 0 0").replace("9999 2", "9999 3");
    assert_eq!(fixed(&text), meant);
    // Words of people are a comment.
    let text = scene("2 -1 0 1 0 rotate later");
    assert_eq!(fixed(&text), scene("2 -1 0 1 0 # rotate later #"));
}

/// Vectors along an axis, and turns about one.
#[test]
fn vectors_along_an_axis() {
    for (line, meant) in [
        ("2 -2 80*x", "2 -2 80 1"),
        ("2 -2 x*80", "2 -2 80 1"),
        ("2 -1 2*z", "2 -1 0 0 2"),
        ("2 -1 -z", "2 -1 0 0 -1"),
        ("2 translate 2*z", "2 -1 0 0 2"),
        ("2 translate z*-2", "2 -1 0 0 -2"),
    ] {
        becomes(&scene(line), &scene(meant));
    }
    let part = |line: &str| {
        let line = format!("20 {line}\n21 -101 2 20");
        scene(&line).replace("9999 2", "9999 21")
    };
    for (line, meant) in [("4 y 0", "4 0 1 0 0"), ("11 2*y 0.5", "11 0 2 0 0.5")] {
        becomes(&part(line), &part(meant));
    }
    // The plane of POV-Ray is on the other side of the origin; a scaling would leave nothing.
    assert_eq!(fixed(&part("4 y 1")), part("4 y 1"));
    assert_eq!(fixed(&scene("2 -3 2*y")), scene("2 -3 2*y"));
}

/// A comment of C behind a block stays a comment, and hides nothing of the block.
#[test]
fn blocks_with_a_comment_of_c() {
    let part = |line: &str| {
        let line = format!("{line}\n21 -101 2 3");
        scene(&line).replace("9999 2", "9999 21")
    };
    for (line, meant) in [
        ("sphere { <-2.5,1,0>, 1 }", "3 11  -2.5 1 0  1 "),
        ("box { <-1,0,-1>, <1,2,1> }", "3 12  -1 0 -1  1 2 1 "),
        ("torus { 1, 0.3 }", "3 14  1 0.3 "),
        ("cylinder { <0,0,0>, <0,2,0>, 1 }", "3 1 2 1 0 1 2"),
        ("plane { y, -1 }", "3 4 0 1 0 1"),
        (
            "sphere { <-2.5,1,0>, 1 pigment { color Red } }",
            "3 11 -2.5 1 0 1\n3 -701 1 0 0",
        ),
    ] {
        for words in ["mirror ball", "zrcadlová koule"] {
            let text = part(&format!("{line} // {words}"));
            becomes(&text, &part(&format!("{meant} # {words} #")));
        }
    }
    for (line, meant) in [
        (
            "light_source { <4,6,5> rgb 0.8 }",
            "51 -402 0.8\n51 -1 4 6 5",
        ),
        (
            "light_source { <4,6,5> color rgb <1,0.9,0.8> }",
            "51 -402 1\n51 -1 4 6 5\n51 -701 1 0.9 0.8",
        ),
    ] {
        let text = scene(&format!("{line} // a warm lamp"));
        becomes(&text, &scene(&format!("{meant} # a warm lamp #")));
        let block = scene(&format!("{line} /* a warm lamp */"));
        becomes(&block, &scene(&format!("{meant} # a warm lamp #")));
    }
    // The comment is no part of what the error speaks of.
    let text = part("sphere { <-2.5,1,0>, 1 } // mirror ball");
    let (error, _) = guessed(&text, Code::E005);
    let said = &text[error.span.range()];
    assert_eq!(said, "sphere { <-2.5,1,0>, 1 }");
}

//! What pages say.

use super::*;

#[test]
fn topics_have_several_names() {
    for topic in ["E101", "e101", "undefined-id", "Undefined ID"] {
        assert!(
            page(topic, Language::English)
                .unwrap()
                .starts_with("# undefined-id (E101)")
        );
    }
    for topic in ["-402", "point-light", "point light", "bodové světlo"] {
        let page = page(topic, Language::English);
        assert!(page.unwrap().starts_with("# point light (-402)"));
    }
    let page_of_a_ball = page("Koule", Language::Czech).unwrap();
    assert!(page_of_a_ball.starts_with("# koule (11)"));
    assert!(page("-400", Language::English).is_none());
}

/// Words for things, those of the handout first.
#[test]
fn words_have_pages() {
    for (word, codes) in [
        ("posuv", &["-1"][..]),
        ("anuloid", &["14"]),
        ("krychle", &["12"]),
        ("Kamera stereo", &["-503"]),
        ("textura obrazová", &["-301"]),
        ("Válcová plocha parabolická", &["18"]),
        ("koule v obecne poloze", &["11"]),
        ("cylinder", &["1"]),
        ("válec", &["1"]),
        ("look at", &["-501"]),
        ("light", &["-402", "-401"]),
        ("kostka", &["12"]),
        ("krabice", &["12"]),
        ("díra", &["-103"]),
        ("otvor", &["-103"]),
        ("úhel", &["-2", "-501"]),
        ("view", &["-501", "-502"]),
        ("paraboloid", &["15", "21"]),
        ("ořez", &["-102", "-103", "4"]),
        ("ořezání", &["-102", "-103", "4"]),
        ("levé oko", &["-503"]),
        ("bodová", &["-402"]),
        ("síť", &["6", "7", "8"]),
        ("Euler", &["-2", "-4"]),
        ("barva pozadí", &["9999"]),
        ("background colour", &["9999"]),
    ] {
        let page = page(word, Language::English).expect(word);
        assert!(
            page.lines()
                .next()
                .unwrap()
                .ends_with(&format!("({})", codes[0])),
            "{word}"
        );
        for code in &codes[1..] {
            assert!(
                page.contains("See also: ") && page.contains(&format!("zpg explain {code}")),
                "{word}"
            );
        }
    }
}

/// Each term of the glossary leads somewhere, in both languages; so do the meanings of parameters.
#[test]
fn terms_of_the_glossary_have_pages() {
    let rows = include_str!("../../../docs/glossary.cs.md").lines();
    let mut count = 0;
    for row in rows.filter(|row| row.starts_with("| ")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if cells[1] == "anglicky" {
            continue;
        }
        for term in cells[1..3].iter().flat_map(|cell| cell.split(", ")) {
            let found = page(term, Language::Czech);
            assert!(found.is_some() || group(term).is_some(), "{term}");
            let words = term.split(' ').map(plain);
            let bare = page(&Vec::from_iter(words).join(" "), Language::Czech);
            // A heading may repeat the word as it was typed.
            let parts = |page: Option<String>| {
                page.map(|page| {
                    let (heading, rest) = page.split_once('\n').unwrap_or_default();
                    (plain(heading), rest.to_owned())
                })
            };
            assert_eq!(parts(bare), parts(found), "{term}");
            count += 1;
        }
    }
    assert!(count > 200);
    for (word, code) in [
        ("zorný úhel", "-501"),
        ("směr pohledu", "-501"),
        ("vektor nahoru", "-501"),
        ("otočit", "-2"),
        ("posunout", "-1"),
        ("the tube's radius", "14"),
        ("intensity", "-402"),
        ("stínování", "-201"),
        ("gluLookAt", "-501"),
    ] {
        let page = page(word, Language::Czech).expect(word);
        let heading = page.lines().next().unwrap_or_default();
        let is_also = page.contains(&format!("zpg explain {code}`"));
        assert!(heading.ends_with(&format!("({code})")) || is_also, "{page}");
    }
    let ray = page("paprsek", Language::Czech).expect("a page");
    assert!(ray.contains("`zpg probe --help`"), "{ray}");
}

/// The numbers of a colour, and the record that has them.
#[test]
fn names_of_colours_have_numbers() {
    for (word, numbers) in [
        ("červená", "1 0 0"),
        ("cervena", "1 0 0"),
        ("blue", "0 0 1"),
    ] {
        for language in [Language::English, Language::Czech] {
            let page = page(word, language).expect(word);
            assert!(page.contains(&format!("`ID -701 {numbers}`")), "{page}");
        }
    }
}

/// A code may lack its zeros. Words of other programs lead to what zpg says of it.
#[test]
fn codes_may_be_short() {
    for (topic, code) in [
        ("e3", Code::E003),
        ("E8", Code::E008),
        ("overlap", Code::W307),
    ] {
        let Some(Answer::Page(page)) = Answer::of(topic, Language::Czech) else {
            panic!("{topic}");
        };
        assert_eq!(page, code_page(code, Language::Czech));
    }
    assert!(matches!(
        Answer::of("e1", Language::Czech),
        Some(Answer::Codes(_))
    ));
}

/// Topics have pages of their own, which begin with the word and show a scene that does it.
#[test]
fn topics_have_scenes() {
    let (english, czech) = (Language::English, Language::Czech);
    for (word, language, heading, codes) in [
        ("glass", english, "# glass", &["-201", "-203"][..]),
        ("sklo", czech, "# sklo", &["-201", "-203"]),
        ("sklo", english, "# sklo: glass", &["-203"]),
        ("průhledné", czech, "# průhledný: sklo", &["-201"]),
        ("průsvitná", czech, "# průsvitný: sklo", &["-201"]),
        ("mirror", english, "# mirror", &["-201"]),
        ("prism", english, "# prism", &["-102"]),
        ("hranol", czech, "# hranol", &["-102"]),
        ("shadow", english, "# shadow", &["-402"]),
        ("stin", czech, "# stín", &["-402"]),
        ("jehlan", czech, "# jehlan", &["-102", "4"]),
        ("y up", english, "# y up: units", &[]),
        ("z nahoru", czech, "# z nahoru: jednotky", &[]),
        ("phong", english, "# phong: highlight", &["-201"]),
        ("roughness", english, "# roughness: highlight", &["-201"]),
        ("drsnost", czech, "# drsnost: odlesk", &["-201"]),
        ("circle", english, "# circle: disk", &["1"]),
        ("mlha", czech, "# mlha", &["-201"]),
        ("komentář", czech, "# komentář", &[]),
    ] {
        let page = page(word, language).expect(word);
        assert_eq!(page.lines().next(), Some(heading));
        assert!(page.contains("```zpg\n"), "{page}");
        for code in codes {
            assert!(page.contains(&format!("zpg explain {code}`")), "{page}");
        }
    }
    let glass = page("glass", english).unwrap().replace('\n', " ");
    assert!(glass.contains("water 1.33"), "{glass}");
    // A type with such a page has both.
    for word in ["checkerboard", "šachovnice"] {
        let page = page(word, czech).unwrap();
        assert!(page.starts_with("# šachovnice (-399)") && page.contains("```zpg\n"));
    }
    let lathe = page("lathe", english).unwrap();
    assert!(lathe.starts_with("# lathe: surface of revolution (1)"));
}

#[test]
fn several_topics_and_groups() {
    let english = Language::English;
    let told = |topics: &[&str]| {
        let topics: Vec<String> = topics.iter().map(|t| (*t).to_owned()).collect();
        let (answers, unknown) = answers(&topics, english);
        let headings: Vec<String> = (answers.iter())
            .map(|a| a.text(PageStyle::Markdown, english))
            .map(|text| text.lines().next().unwrap_or_default().to_owned())
            .collect();
        (headings, unknown.join("|"))
    };
    let first = " W301  colour-out-of-range";
    for (topics, headings, unknown) in [
        (
            &["W310", "torus", "-399"][..],
            &[
                "# unused-definition (W310)",
                "# torus (14)",
                "# checkerboard (-399)",
            ][..],
            "",
        ),
        (&["W3", "W305"], &[first, "# degenerate-shape (W305)"], ""),
        (
            &["W310", "nothing"],
            &["# unused-definition (W310)"],
            "nothing",
        ),
        (&["foo", "torus", "bar"], &["# torus (14)"], "foo|bar"),
        // A misspelt name, and words of none.
        (&["point", "ligth"], &[], "point ligth"),
        (&["foo", "bar"], &[], "foo bar"),
    ] {
        let expected = headings.iter().map(|h| (*h).to_owned()).collect();
        assert_eq!(told(topics), (expected, unknown.to_owned()));
    }
    let codes = group("n60").unwrap();
    assert!(codes.codes().contains(&Code::N601) && !codes.holds(Code::S501));
    for topic in ["W310", "torus", "light", "nothing", ""] {
        assert!(group(topic).is_none(), "{topic}");
    }
}

#[test]
fn what_was_meant() {
    for (number, code) in [("203", "-203"), ("402", "-402"), ("501", "-501")] {
        assert_eq!(suggestions(number, Language::English), [code]);
    }
    // As `docs/handout.md` says of `4 -204 0 35`.
    for number in ["-204", "204"] {
        assert_eq!(suggestions(number, Language::Czech), ["-299"]);
    }
    assert_eq!(
        suggestions("chekerboard", Language::English),
        ["checkerboard"]
    );
    assert_eq!(suggestions("lights", Language::English), ["light"]);
    assert_eq!(suggestions("area light", Language::English), ["light"]);
    assert_eq!(suggestions("soft shadow", Language::English), ["shadow"]);
    assert_eq!(suggestions("e0001", Language::English), ["E001"]);
    assert!(suggestions("zlom", Language::Czech).is_empty());
    assert_eq!(suggestions("sachovnice", Language::Czech), ["šachovnice"]);
    assert!(suggestions("quite something else", Language::English).is_empty());
    assert!(!suggestions("W999", Language::English).contains(&"9999".to_owned()));
}

#[test]
fn a_page_of_a_record_type() {
    insta::assert_snapshot!(page("torus", Language::English).unwrap(), @r#"
    # torus (14)

    Shapes; keyword `torus`. Defines an object.

        ID 14 R r

    Solid: a torus around the y axis. A tube wider than R is allowed; the inside follows the even-odd rule.

    ## Parameters

        R  the distance from the centre to the tube's centre  number, scene units, > 0
        r  the tube's radius                                  number, scene units, > 0

    ## Example

        2 14 1 0.25
    "#);
    insta::assert_snapshot!(page("2", Language::English).unwrap(), @r#"
    # coloured surface of revolution (2)

    Shapes; keyword `coloured-surface-of-revolution`. Defines an object.

        ID 2 N (x y)×N (r g b)×N

    As type 1, with a colour for each profile point; between points the colour is linear.

    ## Parameters

        N  the number of profile points              integer, a count, ≥ 2
      then N times:
        x  a profile point's distance from the axis  number, scene units, ≥ 0
        y  a profile point's height                  number, scene units
      then N times again:
        r  the red part                              number
        g  the green part                            number
        b  the blue part                             number

    ## Example

        2 2 2  0 1  1 0  1 0 0  0 0 1
    "#);
}

#[test]
fn every_topic_has_a_page() {
    for code in Code::ALL {
        for language in [Language::English, Language::Czech] {
            let page = code_page(*code, language);
            assert!(page.lines().count() > 10, "{}", code.as_str());
        }
    }
    for ty in RECORD_TYPES {
        assert!(type_page(ty, Language::English).contains(ty.example));
        let czech = type_page(ty, Language::Czech);
        assert!(czech.contains(ty.example) && !czech.contains(ty.summary));
    }
}

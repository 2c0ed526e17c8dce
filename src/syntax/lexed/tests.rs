use super::*;
use crate::testing;

/// A text of lines that are hard to cut into parts.
fn long_text(random: &mut impl FnMut(u64) -> u64) -> String {
    let lines = [
        "1 21 0 10 0 10\n",
        "# a comment #\n",
        "# a comment\nover lines # 12 1 2\n",
        "7 -701 0,5 0 \"a b.png\"\n",
        "\r\n",
        "3 2 1 2\r",
        "5 2 1 2 # ends here #\n",
        "9 1,2,3 word -\n",
        "2 21 1 2 3 4e999 # one # # two #\n",
    ];
    let mut text = String::new();
    while text.len() < 3000 {
        text += lines[random(lines.len() as u64) as usize];
    }
    text
}

#[test]
fn a_text_cut_in_parts_gives_the_same_tokens() {
    let mut random = testing::random();
    let mut cut = 0;
    for i in 0..200 {
        let mut text = long_text(&mut random);
        if i % 3 == 0 {
            // A comment that nobody closes, or a `#` in a name.
            text.insert_str(text.len() * i / 200, ["#", "\"#\""][i % 2]);
        }
        let whole = Lexed::part(&text, 0, &[], text.len());
        for parts in 2..6 {
            let ends = lines_near(&text, parts);
            let Some(joined) = Lexed::in_parts(&text, &ends) else {
                continue;
            };
            cut += usize::from(ends.len() > 1);
            assert_eq!(format!("{joined:?}"), format!("{whole:?}"));
        }
    }
    assert!(cut > 500, "{cut}");
}

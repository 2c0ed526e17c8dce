use super::*;

fn kinds(text: &str) -> Vec<TokenKind> {
    lex(text, &[]).iter().map(|t| t.kind()).collect()
}

#[test]
fn numbers_and_near_numbers() {
    use TokenKind::*;
    assert_eq!(
        kinds("1 +2 -3. .5 1.5e-3 2E5 1e 1.2.3 1.5abc 0x10 --1 nan -inf 5- @5"),
        [
            Integer,
            Integer,
            Real,
            Real,
            Real,
            Real,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
            MalformedNumber,
        ]
    );
    assert_eq!(
        kinds("1e999 @ $! wood.png \"a b.png\""),
        [HugeNumber, Invalid, Invalid, Word, Quoted]
    );
    assert_eq!(kinds(&"9".repeat(2_000_000)), [HugeNumber]);
    assert_eq!(kinds("01.png \u{feff}"), [MalformedNumber, Invalid]);
}

#[test]
fn commas() {
    use TokenKind::*;
    assert_eq!(kinds("0,5 -1,25e3"), [DecimalComma, DecimalComma]);
    assert_eq!(
        kinds("1,2,3"),
        [Integer, Separator, Integer, Separator, Integer]
    );
    assert_eq!(kinds("1, 2"), [Integer, Separator, Integer]);
    assert_eq!(kinds("1,5.25"), [Integer, Separator, Real]);
    assert_eq!(kinds("1.5,2.5"), [Real, Separator, Real]);
    assert_eq!(
        kinds("<0,5>"),
        [Separator, Integer, Separator, Integer, Separator]
    );
}

#[test]
fn comments() {
    use TokenKind::*;
    assert_eq!(kinds("0 # a\nb # 1"), [Integer, Comment, Integer]);
    assert_eq!(
        kinds("0 # a\n1"),
        [Integer, UnterminatedComment, Newline, Integer]
    );
    let text = "2 # a\n3 # b #";
    assert_eq!(
        lex(text, &[2]).iter().map(|t| t.kind()).collect::<Vec<_>>(),
        [Integer, UnterminatedComment, Newline, Integer, Comment]
    );
}

proptest::proptest! {
    /// The short way says what the automaton says, and what the standard library makes of numbers.
    #[test]
    fn plain_tokens_are_those_of_the_automaton(text in "[0-9+.,eE# \\n\\r\\t\\-\"x]{0,40}") {
        let mut tokens = Tokens::new(&text, &[]);
        let automaton: Vec<Token> =
            std::iter::from_fn(|| tokens.comma.take().or_else(|| tokens.other())).collect();
        proptest::prop_assert_eq!(lex(&text, &[]), automaton.clone());
        let lexed = Lexed::new(&text, &[]);
        proptest::prop_assert_eq!(&lexed.tokens, &automaton);
        for (sig, value) in lexed.sigs.iter().zip(&lexed.values) {
            let token = &automaton[sig.token() as usize];
            let number = token.number(&text).unwrap_or(f64::NAN);
            proptest::prop_assert_eq!(number.to_bits(), value.to_bits());
        }
    }
}

#[test]
fn byte_order_mark_and_odd_spaces() {
    use TokenKind::*;
    assert_eq!(
        kinds("\u{feff}2\u{a0}9 1"),
        [ByteOrderMark, Integer, Integer, Integer]
    );
}

#[test]
fn millions_of_comments_need_no_stack() {
    assert_eq!(lex(&"##".repeat(1_000_000), &[]).len(), 1_000_000);
}

/// A text of lines in which something may go wrong where it is cut.
fn long_text(seed: u64) -> String {
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
    let mut state = seed;
    let mut text = String::new();
    while text.len() < 3000 {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        text += lines[(state >> 33) as usize % lines.len()];
    }
    text
}

#[test]
fn a_text_cut_in_parts_gives_the_same_tokens() {
    let mut cut = 0;
    for seed in 0..200 {
        let mut text = long_text(seed);
        if seed % 3 == 0 {
            // A comment that nobody closes, or a `#` in a name.
            text.insert_str(
                text.len() * seed as usize / 200,
                ["#", "\"#\""][seed as usize % 2],
            );
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

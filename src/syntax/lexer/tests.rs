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

/// Among all characters, those that are listed are separators, and end numbers and words.
#[test]
fn separators() {
    use TokenKind::*;
    for c in '\0'..=char::MAX {
        let listed = SEPARATORS.contains(&c);
        assert_eq!(kinds(&c.to_string()) == [Separator], listed, "{c:?}");
        if listed {
            assert_eq!(
                kinds(&format!("-1.5{c}x{c}")),
                [Real, Separator, Word, Separator],
                "{c:?}"
            );
        }
    }
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
        let mut tokens = Tokens::new(&text, &[]);
        for token in automaton {
            let (valued, value) = tokens.next_valued().expect("there are as many");
            proptest::prop_assert_eq!(valued, token);
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
    // Files that were joined.
    assert_eq!(
        kinds("\u{feff}\u{feff}2 9 1\r\n\u{feff}3\u{feff}"),
        [
            ByteOrderMark,
            ByteOrderMark,
            Integer,
            Integer,
            Integer,
            Newline,
            ByteOrderMark,
            MalformedNumber
        ]
    );
}

#[test]
fn millions_of_comments_need_no_stack() {
    assert_eq!(lex(&"##".repeat(1_000_000), &[]).len(), 1_000_000);
}

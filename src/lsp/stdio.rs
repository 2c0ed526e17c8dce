//! Messages over standard input and output.
//!
//! Unlike the threads of `lsp-server`, the threads here live on when a message cannot be understood: they refuse it.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::thread::{self, JoinHandle};

use crossbeam_channel::{Receiver, Sender, unbounded};
use lsp_server::{ErrorCode, Message, Response};
use serde_json::Value;

use super::outgoing;
use super::refusal::{Refusal, refusal};

/// The longest message that is read, in bytes: larger than the largest scene.
const MAX_MESSAGE: u64 = 1 << 32;

/// The longest line of a header that is read at once, in bytes.
const MAX_LINE: u64 = 1 << 13;

/// Connects to standard input and output. Returns the incoming messages, the sender for outgoing ones, and the thread
/// that writes. The thread that reads ends with its input, or with the program.
pub(super) fn connect() -> (
    Receiver<Message>,
    Sender<String>,
    JoinHandle<io::Result<()>>,
) {
    let (to, incoming) = unbounded();
    let (sender, outgoing) = unbounded();
    let back = sender.clone();
    thread::spawn(move || read(BufReader::new(io::stdin()), &to, &back));
    let writer = thread::spawn(move || write(io::stdout(), &outgoing));
    (incoming, sender, writer)
}

/// Reads messages until the input ends or nobody listens. Anything that is no message is refused.
fn read(mut input: impl BufRead, to: &Sender<Message>, back: &Sender<String>) {
    while let Ok(Some(body)) = next(&mut input) {
        let message = serde_json::from_slice::<Message>(&body);
        match message.or_else(|_| understood(&without_halves(body))) {
            Ok(message) => {
                let is_exit = matches!(&message, Message::Notification(n) if n.method == "exit");
                if to.send(message).is_err() || is_exit {
                    return;
                }
            }
            Err((id, why)) => {
                // Editors show what a server writes to standard error.
                #[expect(clippy::print_stderr)]
                {
                    eprintln!("zpg lsp: a message is refused: {}", why.message);
                }
                let _ = back.send(outgoing::refused(id, &why));
            }
        }
    }
}

/// Reads a message. The error is the message's ID, null if it has none, and the reason why it is no message. Anything
/// that looks like an answer becomes an empty answer: two programs that refuse each other's answers would never end.
fn understood(body: &[u8]) -> Result<Message, (Value, Refusal)> {
    let value: Value = serde_json::from_slice(body).map_err(|e| {
        let why = format!("this is no JSON: {e}");
        (Value::Null, refusal(ErrorCode::ParseError, why))
    })?;
    let id = value
        .get("id")
        .filter(|id| id.is_string() || id.is_number());
    let id = id.cloned().unwrap_or_default();
    if value.get("method").is_none() && (value.get("result").or(value.get("error"))).is_some() {
        return Ok(Response::new_ok(0.into(), Value::Null).into());
    }
    serde_json::from_value(value).map_err(|_| {
        let why = "this is no message of JSON-RPC 2.0";
        (id, refusal(ErrorCode::InvalidRequest, why))
    })
}

/// The next message's body; `None` at the end of the input. Lines that are no headers are passed over.
fn next(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.by_ref().take(MAX_LINE).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim_end();
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("content-length")
        {
            length = value.trim().parse::<u64>().ok();
        }
        if let (true, Some(length)) = (line.is_empty(), length.filter(|&n| n <= MAX_MESSAGE)) {
            // The body is read piece by piece, so that a wrong length does not take memory for bytes that never come.
            let mut body = Vec::new();
            input.by_ref().take(length).read_to_end(&mut body)?;
            return Ok((body.len() as u64 == length).then_some(body));
        }
    }
}

/// Replaces halves of surrogate pairs in a message, which a string that was cut in UTF-16 may have, by U+FFFD. This is
/// as long in UTF-16.
fn without_halves(mut body: Vec<u8>) -> Vec<u8> {
    let unit = |body: &[u8], at: usize| {
        let digits = body.get(at..at + 6)?.strip_prefix(b"\\u")?;
        u16::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()
    };
    let mut at = 0;
    while let Some(next) = memchr::memchr(b'\\', &body[at..]) {
        at += next;
        let pair = [unit(&body, at), unit(&body, at + 6)];
        at += match pair {
            [Some(0xd800..0xdc00), Some(0xdc00..0xe000)] => 12,
            [Some(0xd800..0xe000), _] => {
                body[at + 2..at + 6].copy_from_slice(b"fffd");
                6
            }
            // The character after a backslash belongs to it.
            _ => 2.min(body.len() - at),
        };
    }
    body
}

/// Writes messages until all their senders are gone.
fn write(mut output: impl Write, from: &Receiver<String>) -> io::Result<()> {
    for message in from {
        write!(output, "Content-Length: {}\r\n\r\n{message}", message.len())?;
        output.flush()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_of_surrogate_pairs_are_replaced() {
        let mended = |text: &str| String::from_utf8(without_halves(text.into())).unwrap();
        for (text, meant) in [
            (r#""\ud83d""#, r#""\ufffd""#),
            (
                r#""\ude00 \ud83d\ud83d\ude00""#,
                r#""\ufffd \ufffd\ud83d\ude00""#,
            ),
            (r#""\\ud83d \n \u0041""#, r#""\\ud83d \n \u0041""#),
            (r#""\ud8"#, r#""\ud8"#),
            (r"\", r"\"),
        ] {
            assert_eq!(mended(text), meant);
        }
    }

    #[test]
    fn nonsense_is_refused_and_passed_over() {
        let good = r#"{"jsonrpc":"2.0","method":"a","params":{}}"#;
        let frame = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
        let nested = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
        let stream = [
            "\r\nhello\r\n\r\nContent-Length: x\r\n\r\n".to_owned(),
            frame("{"),
            frame("[1, 2]"),
            frame(&nested),
            frame("\u{1}"),
            // A method that is none, no method, and an answer to something.
            frame(r#"{"jsonrpc":"2.0","id":"a","method":7}"#),
            frame("{}"),
            frame(r#"{"jsonrpc":"2.0","id":null,"error":7}"#),
            format!(
                "Content-Type: x\r\ncontent-length:{}\r\n\r\n{good}",
                good.len()
            ),
            frame(good),
            // More than there is.
            "Content-Length: 4000000000\r\n\r\n{}".to_owned(),
        ]
        .concat();
        let (to, receiver) = unbounded();
        let (back, said) = unbounded();
        read(stream.as_bytes(), &to, &back);
        drop((to, back));
        assert_eq!(receiver.iter().count(), 3);
        // Broken JSON three times, then messages that are none.
        let refused: Vec<(i64, Value)> = (said.iter())
            .map(|text| serde_json::from_str::<Value>(&text).unwrap())
            .map(|m| (m["error"]["code"].as_i64().unwrap(), m["id"].clone()))
            .collect();
        let none = Value::Null;
        let expected = [
            (-32700, none.clone()),
            (-32600, none.clone()),
            (-32700, none.clone()),
            (-32700, none.clone()),
            (-32600, "a".into()),
            (-32600, none),
        ];
        assert_eq!(refused, expected);
    }
}

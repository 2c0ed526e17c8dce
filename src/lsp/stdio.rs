//! Messages over standard input and output.
//!
//! Unlike the threads of `lsp-server`, these live on when a message cannot be understood: it is left out.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::thread::{self, JoinHandle};

use crossbeam_channel::{Receiver, Sender, unbounded};
use lsp_server::{Connection, Message};

/// The longest message that is read, in bytes: larger than the largest scene.
const MAX_MESSAGE: u64 = 1 << 32;

/// The longest line of a header.
const MAX_LINE: u64 = 1 << 13;

/// A connection over standard input and output, and the thread that writes. The one that reads ends with its
/// input, or with the program.
pub fn connect() -> (Connection, JoinHandle<io::Result<()>>) {
    let (incoming, receiver) = unbounded();
    let (sender, outgoing) = unbounded();
    thread::spawn(move || read(BufReader::new(io::stdin()), &incoming));
    let writer = thread::spawn(move || write(io::stdout(), &outgoing));
    (Connection { sender, receiver }, writer)
}

/// Reads until the input ends or nobody listens.
fn read(mut input: impl BufRead, to: &Sender<Message>) {
    while let Ok(Some(body)) = next(&mut input) {
        let message = serde_json::from_slice::<Message>(&body);
        let message = message.or_else(|_| serde_json::from_slice(&without_halves(body)));
        match message {
            Ok(message) => {
                let is_exit = matches!(&message, Message::Notification(n) if n.method == "exit");
                if to.send(message).is_err() || is_exit {
                    return;
                }
            }
            Err(e) => eprintln!("zpg lsp: a message is left out: {e}"),
        }
    }
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
            // Read piece by piece: what is claimed need not be there.
            let mut body = Vec::new();
            input.by_ref().take(length).read_to_end(&mut body)?;
            return Ok((body.len() as u64 == length).then_some(body));
        }
    }
}

/// A message without halves of surrogate pairs, which a string of UTF-16 may be cut to: each becomes U+FFFD, which is as
/// long in UTF-16.
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
            // The sign after a backslash is taken with it.
            _ => 2.min(body.len() - at),
        };
    }
    body
}

/// Writes until nobody has anything to say.
fn write(mut output: impl Write, from: &Receiver<Message>) -> io::Result<()> {
    for message in from {
        message.write(&mut output)?;
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
    fn nonsense_is_passed_over() {
        let good = r#"{"jsonrpc":"2.0","method":"a","params":{}}"#;
        let frame = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
        let nested = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
        let stream = [
            "\r\nhello\r\n\r\nContent-Length: x\r\n\r\n".to_owned(),
            frame("{"),
            frame("[1, 2]"),
            frame(&nested),
            frame("\u{1}"),
            format!(
                "Content-Type: x\r\ncontent-length:{}\r\n\r\n{good}",
                good.len()
            ),
            frame(good),
            // More than there is.
            "Content-Length: 4000000000\r\n\r\n{}".to_owned(),
        ]
        .concat();
        let (sender, receiver) = unbounded();
        read(stream.as_bytes(), &sender);
        drop(sender);
        assert_eq!(receiver.iter().count(), 2);
    }
}

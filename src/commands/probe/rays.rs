//! Files of rays of any length: they are read, traced and answered in batches.

use std::io::{self, BufRead, BufReader, Read, Write};

use std::path::Path;

use super::answer::{self, RayAnswer};
use crate::commands::Status;
use crate::commands::numbers::Writable;
use crate::commands::terminal::{LookChoice, complain, unprintable};
use crate::diagnostics::{Complaint, Value};
use crate::geometry::vec::Vec3;
use crate::parallel;
use crate::syntax::quote;
use crate::trace::{Ray, Tracer};

/// Bytes that are read at once.
pub(super) const BUFFER: usize = 1 << 20;
/// Rays that are held at once.
const BATCH: usize = 1 << 14;
/// Rays that a thread takes at once.
const SHARE: usize = 64;
/// The most bytes of a line: a file without line breaks would be a line without end.
const LINE_MAX: u64 = 1 << 16;

/// A line that cannot be read, that holds no ray, or whose ray cannot be answered.
#[derive(Debug)]
pub(super) struct BadRay {
    line: u64,
    reason: Complaint,
}

impl BadRay {
    /// The complaint about the line; `path` is the file of rays.
    pub(super) fn complaint(self, path: &Path) -> Complaint {
        Complaint::new("at-line")
            .with("path", path)
            .with("line", self.line.to_string())
            .with("why", self.reason)
    }
}

/// Reads N numbers separated by white space, commas or both.
pub(super) fn numbers<const N: usize>(s: &str) -> Result<[f64; N], Complaint> {
    // The handout writes points as `[0,6; 1; 1,2]`.
    let s = s.trim();
    let s = (s.strip_prefix('[').and_then(|s| s.strip_suffix(']'))).unwrap_or(s);
    // Scenes of POV-Ray have `<0, 4, 11>`.
    let s = &s.replace([';', '<', '>'], " ");
    let mut out = [0.0; N];
    let mut count = 0;
    let words = s.split(|c: char| c.is_whitespace() || c == ',');
    for word in words.filter(|word| !word.is_empty()) {
        let number = match word.parse::<f64>() {
            Ok(x) if x.is_finite() => x,
            // "inf" and "NaN" count as words, not as numbers.
            Ok(_) if word.bytes().any(|b| b.is_ascii_digit()) => {
                return Err(Complaint::new("number-out-of-range").with("word", quote(word)));
            }
            _ => return Err(Complaint::new("not-a-number").with("word", quote(word))),
        };
        if let Some(slot) = out.get_mut(count) {
            *slot = number;
        }
        count += 1;
    }
    // There may be as many numbers as wanted if commas are decimal ones, as in `0,5 1 9 0 0 -1`.
    let pointed = || {
        let words = s.split_whitespace().map(|word| word.replacen(',', ".", 1));
        let numbers: Option<Vec<String>> = words
            .map(|word| word.parse::<f64>().is_ok().then_some(word))
            .collect();
        numbers.filter(|numbers| numbers.len() == N)
    };
    if count == N {
        Ok(out)
    } else if let Some(numbers) = pointed() {
        Err(Complaint::new("decimal-commas").with("number", quote(&numbers.join(" "))))
    } else {
        Err(Complaint::new("wrong-count")
            .with("expected", Value::Count(N as u64))
            .with("found", count.to_string()))
    }
}

/// Reads a ray: origin and direction.
pub(super) fn parse(s: &str) -> Result<Ray, Complaint> {
    let [ox, oy, oz, dx, dy, dz] = numbers(s)?;
    let direction = Vec3::new(dx, dy, dz);
    if !direction.any() {
        return Err(Complaint::new("zero-direction"));
    }
    Ok(Ray::new(Vec3::new(ox, oy, oz), direction))
}

/// Answers every ray of a file on standard output, in order. A line that holds no ray, or whose ray cannot be answered,
/// is handed to `bad` after the answers to all rays before it, and to some behind it. A line that cannot be read ends
/// the file.
pub(super) fn stream<R: Writable>(
    tracer: &Tracer,
    input: &mut Input,
    bad: impl Fn(BadRay),
    look: LookChoice,
) -> Status {
    let mut lines = Lines {
        input,
        number: 0,
        line: Vec::new(),
    };
    let mut out = io::stdout().lock();
    let mut status = Status::Clean;
    loop {
        let (batch, end) = lines.batch();
        let (text, unanswered) = trace::<R>(tracer, &batch);
        if tracer.graph.room.is_exhausted() {
            // Memory has run out for some of these answers, which are worth nothing; the caller says why.
            return Status::Negative;
        }
        let written = out.write_all(&text).and_then(|()| out.flush());
        match written {
            Err(e) if e.kind() == io::ErrorKind::BrokenPipe => return Status::Clean,
            Err(e) => {
                complain(look, &unprintable(&e));
                return Status::Failure;
            }
            Ok(()) => {}
        }
        for e in unanswered {
            bad(e);
            status = Status::Failure;
        }
        match end {
            End::Unreadable(e) => {
                bad(e);
                return Status::Failure;
            }
            End::File => return status,
            End::Batch => {}
        }
    }
}

/// A file of rays.
pub(super) type Input = BufReader<Box<dyn Read>>;

/// Why a batch ends.
enum End {
    /// The batch is full, or nothing more has arrived yet.
    Batch,
    File,
    Unreadable(BadRay),
}

/// The content of a line.
enum Content {
    Nothing,
    Ray(Box<Ray>),
    /// Something else, with the reason why it is no ray.
    NoRay(Complaint),
}

/// The number of a line, and the ray on it or why there is none.
type Asked = (u64, Result<Ray, Complaint>);

/// The lines of a file of rays.
struct Lines<'a> {
    input: &'a mut Input,
    /// The number of the last line that was read, from 1.
    number: u64,
    line: Vec<u8>,
}

impl Lines<'_> {
    /// The next batch of lines that are to hold rays, and why it ends. A batch ends before the input would have to be
    /// waited for: a program that waits for an answer before it writes the next ray gets the answer.
    fn batch(&mut self) -> (Vec<Asked>, End) {
        let mut asked = Vec::new();
        let mut ready = true;
        while asked.is_empty() || (ready && asked.len() < BATCH) {
            match self.next() {
                Ok(None) => return (asked, End::File),
                Ok(Some(Content::Nothing)) => {}
                Ok(Some(Content::Ray(ray))) => asked.push((self.number, Ok(*ray))),
                Ok(Some(Content::NoRay(reason))) => asked.push((self.number, Err(reason))),
                Err(reason) => {
                    let line = self.number;
                    return (asked, End::Unreadable(BadRay { line, reason }));
                }
            }
            ready = self.input.buffer().contains(&b'\n');
        }
        (asked, End::Batch)
    }

    /// The next line; `None` at the end of the file. `Err` says why the line cannot be read.
    fn next(&mut self) -> Result<Option<Content>, Complaint> {
        self.line.clear();
        self.number += 1;
        let mut limited = self.input.by_ref().take(LINE_MAX);
        let read = limited.read_until(b'\n', &mut self.line);
        let read = read
            .map_err(|e| Complaint::new("line-unreadable").with("reason", Complaint::from(&e)))?;
        if read == 0 {
            return Ok(None);
        }
        if read as u64 == LINE_MAX && self.line.last() != Some(&b'\n') {
            return Err(Complaint::new("line-too-long").with("max", LINE_MAX.to_string()));
        }
        // Comments may be in any encoding, numbers are ASCII.
        let text = String::from_utf8_lossy(&self.line);
        let mark = |text| str::strip_prefix(text, '\u{feff}').filter(|_| self.number == 1);
        let text = mark(&text).unwrap_or(&text);
        let content = text.split('#').next().unwrap_or("").trim();
        if content.is_empty() {
            return Ok(Some(Content::Nothing));
        }
        Ok(Some(parse(content).map_or_else(Content::NoRay, |ray| {
            Content::Ray(Box::new(ray))
        })))
    }
}

/// The answers to a batch as JSON, a line each, and the lines of the batch that have no answer.
fn trace<R: Writable>(tracer: &Tracer, batch: &[Asked]) -> (Vec<u8>, Vec<BadRay>) {
    let asked: Vec<&[Asked]> = batch.chunks(SHARE).collect();
    let shares = parallel::map_with(
        asked.len(),
        || tracer.walker::<R>(),
        |walkers, i| {
            let (mut text, mut bad) = (Vec::new(), Vec::new());
            for (line, ray) in asked[i] {
                let answer = ray
                    .as_ref()
                    .map_err(Complaint::clone)
                    .and_then(|ray| RayAnswer::new(tracer, walkers, ray));
                let answered = answer.and_then(|answer| {
                    answer::write(&mut text, &answer).map_err(Complaint::quoted)
                });
                if let Err(reason) = answered {
                    bad.push(BadRay {
                        line: *line,
                        reason,
                    });
                }
            }
            (text, bad)
        },
    );
    let (mut all, mut bad) = (Vec::new(), Vec::new());
    for (text, unanswered) in shares {
        all.extend(text);
        bad.extend(unanswered);
    }
    (all, bad)
}

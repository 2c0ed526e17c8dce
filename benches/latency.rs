//! How soon the language server answers: the program itself, over pipes, as editors talk to it. See
//! benches/README.md.
//!
//! `cargo bench --bench latency` prints a table; `-- memory` makes 100 000 edits and prints what the server holds.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

const URI: &str = "file:///nowhere/large.zpg";

/// A server and the text that it has.
struct Session {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    next: i64,
    version: i64,
    lines: Vec<String>,
}

impl Session {
    fn start(text: &str) -> Session {
        let mut child = Command::new(env!("CARGO_BIN_EXE_zpg"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let (input, output) = (child.stdin.take(), child.stdout.take());
        let mut session = Session {
            child,
            input: input.expect("a pipe"),
            output: BufReader::new(output.expect("a pipe")),
            next: 0,
            version: 1,
            lines: text.lines().map(str::to_owned).collect(),
        };
        session.ask(
            "initialize",
            json!({ "processId": null, "rootUri": null, "capabilities": {} }),
        );
        session.tell("initialized", json!({}));
        let file = json!({ "uri": URI, "languageId": "zpg", "version": 1, "text": text });
        session.tell("textDocument/didOpen", json!({ "textDocument": file }));
        session.diagnostics();
        session
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        let head = format!("Content-Length: {}\r\n\r\n", body.len());
        self.input
            .write_all(head.as_bytes())
            .expect("the server reads");
        self.input
            .write_all(body.as_bytes())
            .expect("the server reads");
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The next message, as it is.
    fn next_message(&mut self) -> String {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).expect("the server writes");
            assert!(!line.is_empty(), "the server is gone");
            if let Some(n) = line.strip_prefix("Content-Length: ") {
                length = n.trim().parse().expect("a length");
            }
            if line == "\r\n" {
                let mut body = vec![0; length];
                self.output
                    .read_exact(&mut body)
                    .expect("the server writes");
                return String::from_utf8(body).expect("UTF-8");
            }
        }
    }

    /// How long an answer takes.
    fn ask(&mut self, method: &str, params: Value) -> Duration {
        self.next += 1;
        let start = Instant::now();
        self.send(
            &json!({ "jsonrpc": "2.0", "id": self.next, "method": method, "params": params }),
        );
        let id = format!("\"id\":{},", self.next);
        loop {
            let message = self.next_message();
            if message.contains(&id) {
                assert!(message.contains("\"result\":"), "{method}: {message}");
                return start.elapsed();
            }
        }
    }

    /// Waits for the diagnostics of this version.
    fn diagnostics(&mut self) {
        let ends = [",", "}"].map(|end| format!("\"version\":{}{end}", self.version));
        let is_it = |message: &str| {
            message.contains("textDocument/publishDiagnostics")
                && ends.iter().any(|end| message.contains(end))
        };
        while !is_it(&self.next_message()) {}
    }

    /// Changes a digit of a line.
    fn edit(&mut self, line: usize, random: &mut Random) {
        let text = &mut self.lines[line];
        // Behind the ID and the type.
        let from = text.match_indices(' ').nth(1).map_or(0, |(at, _)| at);
        let digits: Vec<usize> = (from..text.len())
            .filter(|&i| text.as_bytes()[i].is_ascii_digit())
            .collect();
        let (at, new) = match digits.is_empty() {
            true => (text.len(), " ".to_owned()),
            false => (
                digits[random.below(digits.len())],
                (1 + random.below(9)).to_string(),
            ),
        };
        let end = (at + 1).min(text.len());
        text.replace_range(at..end, &new);
        self.version += 1;
        let place = |character: usize| json!({ "line": line, "character": character });
        let change = json!({ "range": { "start": place(at), "end": place(end) }, "text": new });
        let file = json!({ "uri": URI, "version": self.version });
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": file, "contentChanges": [change] }),
        );
    }

    fn memory_kib(&self) -> u64 {
        let path = format!("/proc/{}/status", self.child.id());
        let status = std::fs::read_to_string(path).unwrap_or_default();
        let line = status.lines().find_map(|l| l.strip_prefix("VmRSS:"));
        line.and_then(|l| l.split_whitespace().next()?.parse().ok())
            .unwrap_or(0)
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Numbers that look random, the same in each run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }
}

/// A scene of so many lines: balls in their places and colours, in unions of a thousand or so.
fn scene(lines: usize) -> String {
    let mut text = String::from("2 -201 0.7 0.3 0\n");
    let (mut id, mut line) = (3, 1);
    let mut groups = Vec::new();
    let mut group = 0;
    while line + 12 < lines {
        let ball = id;
        let x = line % 100;
        let z = line / 100;
        let _ = writeln!(text, "{ball} 11  {x}.25 1.5 {z}  0.25 # ball {ball} #");
        let _ = writeln!(text, "{ball} -1 0.5 0 0.125");
        let _ = writeln!(text, "{ball} -701 0.{} 0.5 0.25", 1 + x % 9);
        id += 1;
        line += 3;
        if group == 0 {
            group = ball;
        } else {
            let _ = writeln!(text, "{id} -101 {group} {ball}");
            group = id;
            id += 1;
            line += 1;
        }
        if line % 1000 < 4 {
            groups.push(group);
            group = 0;
        }
    }
    groups.extend(Some(group).filter(|&g| g > 0));
    let mut root = groups[0];
    for other in &groups[1..] {
        let _ = writeln!(text, "{id} -101 {root} {other}");
        root = id;
        id += 1;
    }
    let _ = writeln!(
        text,
        "{id} -501  50 20 99  0 0 -1  0 1 0  45\n{} -402 1\n1 9999 {root} 0",
        id + 1
    );
    text
}

fn median(mut all: Vec<Duration>) -> (f64, f64) {
    all.sort();
    let ms = |d: Duration| d.as_secs_f64() * 1e3;
    (ms(all[all.len() / 2]), ms(all[all.len() * 19 / 20]))
}

/// Median and 95th percentile in milliseconds, a line of the table.
fn row(name: &str, all: Vec<Duration>) {
    let (middle, high) = median(all);
    println!("| {name} | {middle:.1} | {high:.1} |");
}

fn latency(lines: usize) {
    let text = scene(lines);
    let mut random = Random(1);
    let mut s = Session::start(&text);
    let count = s.lines.len();
    println!(
        "\n{count} lines, {} bytes:\n\n| ms | median | 95 % |\n|---|---:|---:|",
        text.len()
    );
    let mut times = Vec::new();
    for _ in 0..200 {
        let line = random.below(count - 3);
        let start = Instant::now();
        s.edit(line, &mut random);
        s.diagnostics();
        times.push(start.elapsed());
    }
    row("diagnostics after an edit", times);
    let file = json!({ "textDocument": { "uri": URI } });
    let with = |name: &str, value: Value| {
        let mut params = file.clone();
        params[name] = value;
        params
    };
    let place = |line: usize| with("position", json!({ "line": line, "character": 0 }));
    let visible = |line: usize| {
        let (start, end) = (
            json!({ "line": line, "character": 0 }),
            json!({ "line": line + 60, "character": 0 }),
        );
        json!({ "start": start, "end": end })
    };
    for (name, method) in [
        ("hover", "textDocument/hover"),
        ("completion", "textDocument/completion"),
        ("signature help", "textDocument/signatureHelp"),
        ("definition", "textDocument/definition"),
        ("highlights", "textDocument/documentHighlight"),
        ("hints of 60 lines", "textDocument/inlayHint"),
        ("tokens of 60 lines", "textDocument/semanticTokens/range"),
        ("code actions of 60 lines", "textDocument/codeAction"),
    ] {
        let mut times = Vec::new();
        for _ in 0..50 {
            let line = random.below(count - 100);
            s.edit(line, &mut random);
            s.diagnostics();
            let params = match method {
                "textDocument/codeAction" => {
                    let mut params = with("range", visible(line));
                    params["context"] = json!({ "diagnostics": [] });
                    params
                }
                _ if method.contains("Hint") || method.contains("range") => {
                    with("range", visible(line))
                }
                _ => place(line),
            };
            times.push(s.ask(method, params));
        }
        row(name, times);
    }
    let style = json!({ "tabSize": 2, "insertSpaces": true });
    for (name, method, params) in [
        (
            "tokens of the file",
            "textDocument/semanticTokens/full",
            file.clone(),
        ),
        ("outline", "textDocument/documentSymbol", file.clone()),
        ("folding", "textDocument/foldingRange", file.clone()),
        ("colours", "textDocument/documentColor", file.clone()),
        ("lenses", "textDocument/codeLens", file.clone()),
        (
            "formatting",
            "textDocument/formatting",
            with("options", style),
        ),
    ] {
        let mut times = Vec::new();
        for _ in 0..7 {
            s.edit(random.below(count - 3), &mut random);
            s.diagnostics();
            times.push(s.ask(method, params.clone()));
        }
        row(name, times);
    }
    println!(
        "\nAfter all requests the server holds {} MB.",
        s.memory_kib() / 1024
    );
}

/// 100 000 edits of a small scene.
fn memory() {
    let mut random = Random(2);
    let mut s = Session::start(&scene(200));
    for round in 0..=10 {
        println!("{:>6} edits: {} KiB", round * 10_000, s.memory_kib());
        if round == 10 {
            break;
        }
        for i in 0..10_000 {
            let line = random.below(s.lines.len() - 3);
            s.edit(line, &mut random);
            if i % 10 == 9 {
                s.diagnostics();
            }
        }
    }
}

/// Every line is wrong: the time from opening to the findings.
fn all_wrong(lines: usize) {
    let text: String = (2..lines + 2)
        .map(|i| format!("{i} 11 0 0,5 0\n"))
        .collect();
    let start = Instant::now();
    let _s = Session::start(&text);
    println!(
        "\n{lines} lines, all wrong: {:.0} ms from the start of the program",
        start.elapsed().as_secs_f64() * 1e3
    );
}

fn main() {
    if std::env::args().any(|a| a == "memory") {
        return memory();
    }
    latency(20_000);
    latency(200_000);
    all_wrong(20_000);
}

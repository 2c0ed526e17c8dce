//! A job for Slurm, on a Slurm of one node: of 16 tasks one is taken away while it runs, one fails at first, and the
//! node is drained and resumed. Fails if the picture is not that of one machine, or tasks are drawn that need not be.

#[expect(dead_code, reason = "the tests use the rest")]
#[path = "../tests/farm/jobs.rs"]
mod jobs;
#[expect(dead_code, reason = "the tests use the rest")]
#[path = "../tests/support/program.rs"]
mod program;
#[path = "../tests/farm/slurm.rs"]
mod slurm;

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;
use std::time::{Duration, Instant};

use slurm::Slurm;

const TILES: &str = "16";
const SIZE: [&str; 2] = ["--size", "160x120"];
const LONGEST: Duration = Duration::from_secs(300);

/// In place of zpg: it writes down each band that it is asked for, takes its time, and fails when it is asked for the
/// third one first.
const WRAPPER: &str = "#!/bin/sh
[ \"$1\" = render ] || exec 'ZPG' \"$@\"
tile=$(echo \"$*\" | sed 's/.*--tile \\([0-9]*\\).*/\\1/')
echo \"$tile\" >>'CALLS'
sleep 2
[ \"$tile\" != 3 ] || [ \"$(grep -c '^3$' 'CALLS')\" -gt 1 ] || exit 1
exec 'ZPG' \"$@\"
";

fn main() {
    let dir = jobs::one(jobs::MONO);
    let dir = dir.path();
    fs::create_dir(dir.join("whole")).expect("the folder is new");
    let whole = ["render", "a.zpg", "--samples", "1", "-o", "whole/a.png"];
    jobs::says(dir, &[&whole[..], &SIZE].concat(), 0);
    let slurm = Slurm::start(4);
    long_array(&slurm, dir);
    let farm = [
        "farm", "a.zpg", "--for", "slurm", "--tiles", TILES, "-o", "job",
    ];
    jobs::says(dir, &[&farm[..], &SIZE].concat(), 0);
    let calls = dir.join("calls");
    let wrapper = dir.join("wrapper");
    let script = WRAPPER.replace("ZPG", program::PATH);
    let script = script.replace("CALLS", calls.to_str().expect("a plain path"));
    fs::write(&wrapper, script).expect("the folder is ours");
    fs::set_permissions(&wrapper, fs::Permissions::from_mode(0o755)).expect("it is ours");

    let start = Instant::now();
    let seconds = || format!("{:4.0} s", start.elapsed().as_secs_f64());
    let mut submit = slurm.command("sh");
    submit
        .arg("submit.sh")
        .env("ZPG", &wrapper)
        .current_dir(dir.join("job"));
    let said = String::from_utf8(submit.output().expect("sh is there").stdout).expect("a text");
    let job = (said.lines().next())
        .and_then(|line| line.strip_prefix("drawing: job ")?.split(',').next())
        .unwrap_or_else(|| panic!("{said}"));
    let running = || slurm.says("squeue", &["-h", "-r", "-t", "R", "-j", job, "-o", "%K"]);
    let is_running = |task: &str| running().lines().any(|line| line.trim() == task);

    slurm.wait_for(LONGEST, "task 5 that runs", || is_running("5"));
    slurm.says("scontrol", &["requeue", &format!("{job}_5")]);
    println!("{}: task 5 runs, and is taken away", seconds());

    let host = slurm.says("hostname", &["-s"]);
    let node = format!("nodename={}", host.trim());
    slurm.says(
        "scontrol",
        &["update", &node, "state=drain", "reason=repair"],
    );
    println!("{}: the node is drained", seconds());
    slurm.wait_for(LONGEST, "end of what runs", || running().trim().is_empty());
    let before = fs::read_to_string(&calls).expect("the wrapper has run");
    std::thread::sleep(Duration::from_secs(5));
    let after = fs::read_to_string(&calls).expect("the wrapper has run");
    assert_eq!(before, after, "nothing begins on a node that is drained");
    slurm.says("scontrol", &["update", &node, "state=resume"]);
    println!(
        "{}: it is resumed; {} bands have been begun",
        seconds(),
        after.lines().count()
    );

    slurm.wait_for_all(LONGEST);
    println!("{}: all is joined", seconds());
    let mut begun: BTreeMap<u32, u32> = BTreeMap::new();
    for line in fs::read_to_string(&calls)
        .expect("the wrapper has run")
        .lines()
    {
        *begun.entry(line.parse().expect("a number")).or_default() += 1;
    }
    let expected = (1..=16).map(|tile| (tile, 1 + u32::from(tile == 3 || tile == 6)));
    assert_eq!(begun, expected.collect(), "how often bands were begun");
    jobs::are_those_of(&dir.join("job/out"), &dir.join("whole"));
    println!(
        "Bands 3 and 6 were begun twice, the others once. The bytes are those of one machine."
    );
}

/// Slurm refuses an array of more than 1000 elements, and takes what `zpg farm` makes of so many bands.
fn long_array(slurm: &Slurm, dir: &Path) {
    let farm = [
        "farm", "a.zpg", "--for", "slurm", "--tiles", "2500", "-o", "long",
    ];
    jobs::says(dir, &[&farm[..], &["--size", "8x2500"]].concat(), 0);
    let takes = |arguments: &[&str]| {
        let mut command = slurm.command("sbatch");
        command.arg("--test-only").args(arguments).arg("draw.slurm");
        let run = command.current_dir(dir.join("long")).output();
        run.expect("sbatch is there").status.success()
    };
    assert!(!takes(&["--array=0-2499"]) && takes(&[]));
    println!("2500 bands are taken as one array, which 2500 elements are not.");
}

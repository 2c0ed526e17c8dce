//! The files of a job: scripts that draw and join, and what an engine reads.

use std::path::Path;

use crate::commands::atomic_file;
use crate::diagnostics::{Complaint, Language};

/// The program that runs the tasks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Engine {
    /// Open Job Description: job.yaml, for render farms and `openjd run`
    Openjd,
    /// Slurm: an array that draws, and a job that joins
    Slurm,
    /// make, on one machine
    Shell,
}

/// The work of a job in tasks. A task is a picture, or a band of rows of one.
pub(super) struct Work {
    /// The name of the job: letters, digits and dashes.
    pub name: String,
    /// The summary for people.
    pub summary: String,
    /// The options of `zpg render`, as a shell reads them.
    pub options: String,
    /// The name ending of the pictures: png or exr.
    pub ending: &'static str,
    pub tasks: u32,
    /// Bands of each picture.
    pub tiles: u32,
    /// Whether numbers vary from frame to frame, even if there is a single frame.
    pub is_framed: bool,
    /// Pictures of each scene.
    pub frames: u32,
    pub first_frame: u32,
    /// Digits of the number of a frame in the name of its file.
    pub digits: usize,
    /// The number of tasks that are drawn in one go.
    pub chunk: u32,
    pub cores: u32,
    pub megabytes: u64,
    /// Minutes that tasks in one go may take at most.
    pub minutes: u64,
    /// Minutes that joining all pictures may take at most.
    pub join_minutes: u64,
    /// Whether there are several scenes, so that a sheet of all pictures is made at the end.
    pub is_class: bool,
}

/// The most elements of one array that Slurm runs at a time.
const AT_A_TIME: u32 = 64;
/// The most elements that an array of Slurm has: its MaxArraySize is 1001 unless it is set.
const ARRAY: u32 = 1000;

/// The files that start the job on some engine.
const STARTED: [&str; 6] = [
    "job.yaml",
    "job-plain.yaml",
    "draw.slurm",
    "join.slurm",
    "submit.sh",
    "Makefile",
];

const DRAW: &str = include_str!("draw.sh");
const JOIN: &str = include_str!("join.sh");
const SHEET: &str = include_str!("sheet.sh");
const OPENJD: &str = include_str!("job.yaml");
const SLURM: &str = include_str!("draw.slurm");
const SLURM_JOIN: &str = include_str!("join.slurm");
const SLURM_SUBMIT: &str = include_str!("submit.sh");
const MAKE: &str = include_str!("Makefile");

/// The tasks of job.yaml: in chunks, by the extension TASK_CHUNKING.
const CHUNKS: &str = "        - name: Tasks
          type: CHUNK[INT]
          range: 1-@TASKS@
          chunks: {defaultTaskCount: @CHUNK@, rangeConstraint: CONTIGUOUS}";
/// The tasks of job-plain.yaml, for engines without that extension: the first task of each chunk.
const STEPS: &str = "        - name: Tasks
          type: INT
          range: 1-@TASKS@:@CHUNK@";

impl Engine {
    /// The least number of tasks in one go that an engine needs for this many tasks in all.
    pub(super) fn least_chunk(self, tasks: u32) -> u32 {
        match self {
            Engine::Slurm => tasks.div_ceil(ARRAY),
            Engine::Openjd | Engine::Shell => 1,
        }
    }

    /// The README, which says how the job is started.
    fn readme(self, language: Language) -> &'static str {
        match (self, language) {
            (Engine::Openjd, Language::English) => include_str!("README.openjd.md"),
            (Engine::Openjd, Language::Czech) => include_str!("README.openjd.cs.md"),
            (Engine::Slurm, Language::English) => include_str!("README.slurm.md"),
            (Engine::Slurm, Language::Czech) => include_str!("README.slurm.cs.md"),
            (Engine::Shell, Language::English) => include_str!("README.shell.md"),
            (Engine::Shell, Language::Czech) => include_str!("README.shell.cs.md"),
        }
    }

    /// The names of the files and what stands in them.
    fn files(self, work: &Work, language: Language) -> Vec<(&'static str, String)> {
        let filled = |text: &str| work.fill(text);
        let join = match work.is_class {
            true => [JOIN, SHEET].concat(),
            false => JOIN.to_owned(),
        };
        let mut files = vec![
            ("draw.sh", filled(DRAW)),
            ("join.sh", filled(&join)),
            ("README.md", filled(self.readme(language))),
        ];
        match self {
            Engine::Openjd => {
                let chunked = OPENJD
                    .replace("@EXTENSION@", "extensions: [TASK_CHUNKING]\n")
                    .replace("@SPACE@", CHUNKS)
                    .replace("@LAST_TASK@", "${tasks##*-}");
                let plain = OPENJD
                    .replace("@EXTENSION@", "")
                    .replace("@SPACE@", STEPS)
                    .replace("@LAST_TASK@", "$((first + @CHUNK@ - 1))");
                files.push(("job.yaml", filled(&chunked)));
                files.push(("job-plain.yaml", filled(&plain)));
            }
            Engine::Slurm => {
                files.push(("draw.slurm", filled(SLURM)));
                files.push(("join.slurm", filled(SLURM_JOIN)));
                files.push(("submit.sh", filled(SLURM_SUBMIT)));
            }
            Engine::Shell => files.push(("Makefile", filled(MAKE))),
        }
        files
    }

    /// Writes the files of a job into its folder.
    pub(super) fn write(
        self,
        work: &Work,
        language: Language,
        folder: &Path,
    ) -> Result<(), Complaint> {
        let files = self.files(work, language);
        // Files that an earlier job of another engine has left would draw other tasks.
        for name in STARTED {
            if !files.iter().any(|(written, _)| *written == name) {
                let _ = std::fs::remove_file(folder.join(name));
            }
        }
        for (name, text) in files {
            atomic_file::write(&folder.join(name), |out| out.write_all(text.as_bytes()))?;
        }
        Ok(())
    }
}

impl Work {
    /// Puts values where their names stand between `@`.
    fn fill(&self, text: &str) -> String {
        let runs = self.tasks.div_ceil(self.chunk);
        let number = |n: u64| n.to_string();
        let values = [
            ("NAME", self.name.clone()),
            ("SUMMARY", self.summary.clone()),
            ("VERSION", env!("CARGO_PKG_VERSION").to_owned()),
            ("ENDING", self.ending.to_owned()),
            ("TASKS", number(self.tasks.into())),
            ("TILES", number(self.tiles.into())),
            (
                "FRAMED",
                if self.is_framed { "yes" } else { "no" }.to_owned(),
            ),
            ("FRAMES", number(self.frames.into())),
            ("FIRST_FRAME", number(self.first_frame.into())),
            ("DIGITS", number(self.digits as u64)),
            ("CHUNK", number(self.chunk.into())),
            ("LAST", number(u64::from(runs) - 1)),
            ("AT_A_TIME", number(runs.min(AT_A_TIME).into())),
            ("CORES", number(self.cores.into())),
            ("MEGABYTES", number(self.megabytes)),
            ("MINUTES", number(self.minutes)),
            ("JOIN_MINUTES", number(self.join_minutes)),
            ("SECONDS", number(60 * self.minutes)),
            // The options are the last, so that nothing is put into what people have written.
            ("OPTIONS", self.options.clone()),
        ];
        let mut filled = text.to_owned();
        for (name, value) in values {
            filled = filled.replace(&format!("@{name}@"), &value);
        }
        filled
    }
}

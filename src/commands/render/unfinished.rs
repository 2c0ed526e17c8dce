//! Keeps the rows that an interrupted run has drawn, and lets the next run go on from them.

use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use crate::commands::LookChoice;
use crate::commands::atomic_file;
use crate::commands::terminal::note;
use crate::diagnostics::{Complaint, Error};
use crate::picture_files::{self, Format, Origin, Row, read};
use crate::trace::stats::Counts;
use crate::trace::{CostMap, Film, Picture, Samples};

/// The file beside the picture that keeps the drawn rows of one camera.
pub(super) struct Unfinished {
    pub path: PathBuf,
    /// The origin of the whole picture of this camera.
    pub origin: Origin,
}

/// A function that draws these rows of the whole picture.
type Draw<'d> = &'d mut dyn FnMut(Range<u32>) -> Result<Picture, Error>;

impl Unfinished {
    /// Whether the file has rows of this very picture. A note says so if it has rows of another one.
    fn is_there(&self, look: LookChoice) -> bool {
        if !self.path.exists() {
            return false;
        }
        let is_ours = |rows: &read::Rows| rows.origin.is_of_one_picture(&self.origin);
        let is_ours = read::open(&self.path).is_ok_and(|rows| is_ours(&rows));
        if !is_ours {
            note(
                look,
                &Complaint::new("note-other-part").with("path", self.path.as_path()),
            );
        }
        is_ours
    }

    /// The picture of the wanted rows: the file's rows are taken, and the others are drawn. Rows behind damage in the
    /// file are drawn, too.
    pub(super) fn go_on(
        &self,
        wanted: Range<u32>,
        look: LookChoice,
        draw: Draw,
    ) -> Result<Picture, Error> {
        if !self.is_there(look) {
            return draw(wanted);
        }
        let mut picture = blank(self.origin.size[0], wanted.clone());
        if let Err(damage) = self.fill(&mut picture, wanted.start) {
            note(look, &damage);
        }
        for missing in gaps(&picture.finished) {
            let at = |row: u32| wanted.start + row;
            let drawn = draw(at(missing.start)..at(missing.end))?;
            put(&mut picture, missing.start, drawn);
        }
        picture.samples.min = picture.samples.min.min(picture.samples.max);
        Ok(picture)
    }

    /// Copies the rows of the file into `picture`, whose first row is row `start` of the whole picture.
    fn fill(&self, picture: &mut Picture, start: u32) -> Result<(), Complaint> {
        let rows = read::open(&self.path)?;
        let drawn = rows.origin.rows.clone();
        let is_drawn = |y: u32| drawn.iter().any(|r| r[0] <= y && y - r[0] < r[1]);
        let width = picture.film.width as usize;
        for (y, row) in (rows.origin.span()[0]..).zip(rows.all(&self.path)) {
            let at = y.checked_sub(start).map(|row| row as usize);
            let at = at.filter(|&row| row < picture.finished.len() && is_drawn(y));
            if let (Some(at), Row::Linear(row)) = (at, row?) {
                picture.film.pixels[at * width..][..width].copy_from_slice(&row);
                picture.finished[at] = true;
            }
        }
        Ok(())
    }

    /// Writes the finished rows of `picture`, whose first row is row `start` of the whole picture, and returns their
    /// number. If there are none, nothing is written.
    pub(super) fn leave(&self, picture: &Picture, start: u32) -> Result<u32, Complaint> {
        let at = |row: u32| start + row;
        let missing = gaps(&picture.finished);
        let ends = missing.iter().map(|gap| gap.start);
        let ends = ends.chain([picture.finished.len() as u32]);
        let starts = [0].into_iter().chain(missing.iter().map(|gap| gap.end));
        let drawn = starts.zip(ends).filter(|(start, end)| start < end);
        let origin = Origin {
            rows: drawn.map(|(start, end)| [at(start), end - start]).collect(),
            ..self.origin.clone()
        };
        let [first, count] = origin.span();
        if count > 0 {
            let rows = picture.film.rows().map(|row| Ok(Row::Linear(row.to_vec())));
            let mut rows = rows.skip((first - start) as usize).take(count as usize);
            let write = |out: &mut dyn std::io::Write| {
                picture_files::write(Format::Exr, out, &origin, &mut rows)
            };
            atomic_file::write(&self.path, write)?;
        }
        Ok(origin.rows.iter().map(|rows| rows[1]).sum())
    }

    /// Removes the file if it has rows of this picture: the picture is complete.
    pub(super) fn remove(&self) {
        let is_ours = |rows: read::Rows| rows.origin.is_of_one_picture(&self.origin);
        if self.path.exists() && read::open(&self.path).is_ok_and(is_ours) {
            // A file that is left does no harm.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// A picture of these rows in which nothing is drawn yet.
fn blank(width: u32, rows: Range<u32>) -> Picture {
    let height = rows.end - rows.start;
    let count = width as usize * height as usize;
    Picture {
        film: Film {
            width,
            height,
            pixels: vec![[0.0; 3]; count],
        },
        samples: Samples::NONE,
        costs: CostMap {
            width,
            height,
            tests: vec![0; count],
        },
        total_reflection: vec![false; count],
        finished: vec![false; height as usize],
        counts: Counts::default(),
    }
}

/// Copies drawn rows into a picture, from its row `start` on.
fn put(picture: &mut Picture, start: u32, rows: Picture) {
    let at = start as usize * picture.film.width as usize;
    let end = at + rows.film.pixels.len();
    picture.film.pixels[at..end].copy_from_slice(&rows.film.pixels);
    picture.costs.tests[at..end].copy_from_slice(&rows.costs.tests);
    picture.total_reflection[at..end].copy_from_slice(&rows.total_reflection);
    picture.finished[start as usize..][..rows.finished.len()].copy_from_slice(&rows.finished);
    picture.samples.add(rows.samples);
    picture.counts += rows.counts;
}

/// The ranges of rows that are not finished.
fn gaps(finished: &[bool]) -> Vec<Range<u32>> {
    let mut gaps: Vec<Range<u32>> = Vec::new();
    for (row, _) in (0..)
        .zip(finished)
        .filter(|(_, is_finished)| !**is_finished)
    {
        match gaps.last_mut() {
            Some(gap) if gap.end == row => gap.end += 1,
            _ => gaps.push(row..row + 1),
        }
    }
    gaps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_where_rows_are_missing() {
        let of = |text: &str| gaps(&text.chars().map(|c| c == 'x').collect::<Vec<_>>());
        assert_eq!(of("xx"), []);
        assert_eq!(of("..x.x..."), [0..2, 3..4, 5..8]);
    }
}

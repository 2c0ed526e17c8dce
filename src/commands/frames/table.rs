//! Tables of numbers: a column for each number of the scene, a row for each frame.

use std::path::{Path, PathBuf};

use super::{MOST_FRAMES, too_many};
use crate::analysis::file;
use crate::analysis::parameters::Name;
use crate::diagnostics::{Complaint, SourceFile};

/// The most mistakes of a table that are named.
const MOST_NAMED: usize = 20;

/// The numbers of a table.
#[derive(Debug, Default)]
pub(super) struct Table {
    path: PathBuf,
    pub names: Vec<Name>,
    /// The rows of numbers, one for each frame. Each row has as many numbers as there are names.
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// Reads a table with commas or semicolons between its columns. With semicolons, numbers may have decimal commas.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or it has mistakes: the first of them are named with their rows and columns.
    pub(super) fn read(path: &Path) -> Result<Table, Complaint> {
        let source = SourceFile::new(path.to_string_lossy(), file::read(path)?);
        parsed(path, source.text.trim_start_matches('\u{feff}'))
    }

    /// The complaint about the name of a column, which is counted from 0.
    pub(super) fn misnamed(&self, column: usize, why: Complaint) -> Complaint {
        in_cell(&self.path, 1, (column + 1).to_string(), why)
    }
}

/// A cell as messages show it: cut to some letters, and without control characters. A file that is no table may have
/// long cells, and control characters that move the cursor of a terminal.
fn shown(cell: &str) -> String {
    const MAX_CELL_CHARS: usize = 40;
    let mut text: String = cell.chars().take(MAX_CELL_CHARS).collect();
    if text.len() < cell.len() {
        text.push('…');
    }
    text.replace(char::is_control, "\u{fffd}")
}

/// Counts the rows of a text up to ascending byte offsets.
struct Rows<'a> {
    text: &'a str,
    /// The end of a line: in old files a carriage return alone.
    end: char,
    /// The last byte offset, and the number of lines that end before it.
    before: (usize, u64),
}

impl<'a> Rows<'a> {
    fn of(text: &'a str) -> Rows<'a> {
        let end = if text.contains('\n') { '\n' } else { '\r' };
        let before = (0, 0);
        Rows { text, end, before }
    }

    /// The row, from 1, of the first text behind byte offset `place`, which must not go down from call to call. The
    /// line number of the CSV reader would not do: the reader skips empty rows, and names the first of them as the line
    /// of the record that follows.
    fn row(&mut self, place: u64) -> u64 {
        let place = usize::try_from(place).unwrap_or(usize::MAX);
        let rest = self.text.get(place..).unwrap_or("");
        let start = self.text.len() - rest.trim_start_matches(['\r', '\n']).len();
        let (up_to, count) = self.before;
        let between = self.text.get(up_to..start).unwrap_or("");
        let count = count + between.matches(self.end).count() as u64;
        self.before = (start, count);
        count + 1
    }
}

/// The complaint about a cell; rows count from 1, as in a spreadsheet.
fn in_cell(path: &Path, row: u64, column: String, why: Complaint) -> Complaint {
    Complaint::new("in-cell")
        .with("path", path)
        .with("row", row.to_string())
        .with("column", column)
        .with("why", why)
}

fn parsed(path: &Path, text: &str) -> Result<Table, Complaint> {
    let header = text.lines().find(|line| !line.trim().is_empty());
    let has_semicolons = header.is_some_and(|line| line.contains(';'));
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(if has_semicolons { b';' } else { b',' })
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut table = Table {
        path: path.to_owned(),
        ..Table::default()
    };
    let mut titles: Vec<String> = Vec::new();
    let mut wrong = Vec::new();
    let mut rows = Rows::of(text);
    for record in reader.records() {
        // No error is expected: the text is in memory, and is UTF-8.
        let record = record.map_err(|e| file::unreadable(path, Complaint::quoted(e)))?;
        let row = rows.row(record.position().map_or(0, csv::Position::byte));
        if titles.is_empty() {
            titles = record.iter().map(shown).collect();
            for (i, title) in titles.iter().enumerate() {
                match title.parse() {
                    Ok(name) => table.names.push(name),
                    Err(why) => wrong.push(in_cell(path, row, (i + 1).to_string(), why)),
                }
            }
            // Cells of columns without names cannot be checked.
            if !wrong.is_empty() {
                break;
            }
            continue;
        }
        if table.rows.len() == MOST_FRAMES as usize {
            return Err(too_many());
        }
        let mut numbers = Vec::with_capacity(titles.len());
        for (i, title) in titles.iter().enumerate() {
            match number(record.get(i).unwrap_or(""), has_semicolons) {
                Ok(x) => numbers.push(x),
                Err(why) => wrong.push(in_cell(path, row, title.clone(), why)),
            }
        }
        if let Some(text) = record.get(titles.len()) {
            let why = Complaint::new("cell-beyond").with("text", shown(text));
            wrong.push(in_cell(path, row, (titles.len() + 1).to_string(), why));
        }
        table.rows.push(numbers);
        if wrong.len() >= MOST_NAMED {
            break;
        }
    }
    wrong.truncate(MOST_NAMED);
    match Complaint::several(wrong) {
        Some(all) => Err(all),
        None if table.rows.is_empty() => Err(Complaint::new("empty-table").with("path", path)),
        None => Ok(table),
    }
}

fn number(cell: &str, has_commas: bool) -> Result<f64, Complaint> {
    if cell.is_empty() {
        return Err(Complaint::new("empty-cell"));
    }
    let text = match has_commas {
        true => cell.replacen(',', ".", 1),
        false => cell.to_owned(),
    };
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| Complaint::new("not-a-number").with("word", shown(cell)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), String> {
        let table = parsed(Path::new("t.csv"), text).map_err(|e| e.to_string())?;
        Ok((
            table.names.iter().map(Name::to_string).collect(),
            table.rows,
        ))
    }

    #[test]
    fn tables_of_both_kinds() {
        let expected = (
            vec!["9.fovy".to_owned(), "5.x[3]".to_owned()],
            vec![vec![30.5, 1.0], vec![-4e1, 0.25]],
        );
        for text in [
            "9.fovy,5.x[3]\n30.5,1\n-4e1,0.25\n",
            " 9.fovy , 5.x[3] \r\n\"30.5\",1\r\n\r\n-4e1,0.25",
            "9.fovy;5.x[3]\n30,5;1\n-4e1;0.25\n",
        ] {
            assert_eq!(read(text), Ok(expected.clone()), "{text}");
        }
    }

    #[test]
    fn mistakes_are_named_with_their_places() {
        for (text, says) in [
            ("", "no rows"),
            ("9.fovy\n", "no rows"),
            ("9.fovy,oops\n1,2\n", "row 1, column 2"),
            (
                "9.fovy,5.x\n1,2\n\n3,x\n",
                "row 4, column 5.x: x is not a number",
            ),
            (
                "\r\r9.fovy\r1\r\rx",
                "row 6, column 9.fovy: x is not a number",
            ),
            (
                "9.fovy,5.x\n1,2\n3\n",
                "row 3, column 5.x: the cell is empty",
            ),
            ("9.fovy,5.x\n1,2,7\n", "row 2, column 3"),
            (
                "9.fovy\n1e999\n",
                "row 2, column 9.fovy: 1e999 is not a number",
            ),
            (
                "9.fovy;5.x\n1;1,2,3\n",
                "row 2, column 5.x: 1,2,3 is not a number",
            ),
        ] {
            let said = read(text).expect_err(text);
            assert!(said.contains(says), "{text:?}: {said}");
        }
        let noise = read(&"\u{1b}[2J".repeat(1000)).expect_err("no table");
        assert!(!noise.contains('\u{1b}') && noise.len() < 300, "{noise}");
        let many = format!("9.fovy\n{}", "x\n".repeat(100));
        assert_eq!(
            read(&many).expect_err("no numbers").lines().count(),
            MOST_NAMED
        );
    }
}

//! A time on the command line: `90s`, `2m`, `1.5h`.

use std::str::FromStr;

use crate::diagnostics::Complaint;

/// From a second to a day; a number alone is seconds.
#[derive(Debug, Clone, Copy)]
pub struct Seconds(pub f64);

impl FromStr for Seconds {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Seconds, Complaint> {
        let wrong = || Complaint::new("expected-time");
        let text = text.trim();
        let (number, unit) = match text.chars().last() {
            Some('s') => (&text[..text.len() - 1], 1.0),
            Some('m') => (&text[..text.len() - 1], 60.0),
            Some('h') => (&text[..text.len() - 1], 3600.0),
            _ => (text, 1.0),
        };
        let number: f64 = number.trim().parse().map_err(|_| wrong())?;
        let seconds = number * unit;
        match (1.0..=86_400.0).contains(&seconds) {
            true => Ok(Seconds(seconds)),
            false => Err(wrong()),
        }
    }
}

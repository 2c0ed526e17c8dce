//! A time on the command line: `90s`, `2m`, `1.5h`; a number alone is seconds.

use std::str::FromStr;
use std::time::Duration;

use crate::diagnostics::Complaint;

/// A time in seconds, from one second to a day.
#[derive(Debug, Clone, Copy)]
pub struct Seconds(pub f64);

impl From<Seconds> for Duration {
    fn from(seconds: Seconds) -> Duration {
        Duration::from_secs_f64(seconds.0)
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times() {
        for (text, seconds) in [("90s", 90.0), ("2m", 120.0), ("1.5h", 5400.0), ("45", 45.0)] {
            assert_eq!(text.parse::<Seconds>().map(|s| s.0), Ok(seconds));
        }
        for wrong in ["", "m", "0", "2d", "25h", "-1m", "NaN", "inf", "1e999"] {
            assert!(wrong.parse::<Seconds>().is_err(), "{wrong}");
        }
    }
}

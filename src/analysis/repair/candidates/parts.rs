//! Parts of light (diffuse, mirrored and transmitted), one of which is above 1.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Code, Diagnostic};
use crate::lint::spelling::{decimal, shares};
use crate::syntax::lexer::Token;
use crate::syntax::table::RecordKind;
use crate::syntax::with_point;

/// A reading of parts of light, one of which is above 1.
enum Parts {
    /// All parts are too large by this factor.
    Divided(f64),
    /// The transmitted part is a refractive index. The value is the part that the others leave for transmitted light.
    Index(f64),
    /// The part at this index has its decimal point one place or two too far to the right: it is too large by this
    /// factor.
    Point(usize, f64),
}

/// The whole in per cent.
const PER_CENT: f64 = 100.0;
/// Parts are in per cent if one of them is as large as this, or if they are whole and add up to nearly 100.
const PER_CENT_MIN: f64 = 10.0;
/// The most by which the sum of rounded per cent differs from 100.
const PER_CENT_OFF_MAX: f64 = 2.0;
/// The refractive indices of glass and the like.
const INDICES: std::ops::RangeInclusive<f64> = 1.2..=2.5;
/// The least sum of parts after a decimal point was put right.
const PARTS_SUM_MIN: f64 = 0.9;
/// The largest sum of parts after a decimal point was put right, with room for rounding.
const PARTS_SUM_MAX: f64 = 1.0 + 1e-9;

/// Finds the reading of parts of light that are no shares of 1. `None` if none fits.
fn parts(written: &[f64]) -> Option<Parts> {
    let is_whole = |x: &f64| x.fract() == 0.0;
    let sum: f64 = written.iter().sum();
    let is_large = written.iter().any(|&x| x >= PER_CENT_MIN);
    let all_whole = written.iter().all(is_whole);
    if written.iter().any(|x| !(0.0..=PER_CENT).contains(x)) {
        return None;
    }
    let in_per_cent = |x: &f64| *x == 0.0 || *x >= 1.0;
    let is_per_cent = is_large || all_whole && (sum - PER_CENT).abs() <= PER_CENT_OFF_MAX;
    if is_per_cent && written.iter().all(in_per_cent) {
        return Some(Parts::Divided(PER_CENT));
    }
    let &[kd, ks, kt] = written else {
        return None;
    };
    if all_whole {
        return Some(Parts::Divided(sum));
    }
    let left = 1.0 - kd - ks;
    if INDICES.contains(&kt) && left > 0.0 {
        return Some(Parts::Index(left));
    }
    let mut large = written.iter().enumerate().filter(|(_, x)| **x > 1.0);
    let (Some((at, x)), None) = (large.next(), large.next()) else {
        return None;
    };
    let others: f64 = written.iter().filter(|x| **x <= 1.0).sum();
    let is_whole = |by: &f64| (PARTS_SUM_MIN..=PARTS_SUM_MAX).contains(&(others + x / by));
    let by = [10.0, PER_CENT].into_iter().find(is_whole)?;
    Some(Parts::Point(at, by))
}

impl LineContext<'_> {
    /// Guesses at parts of light that are in per cent, lack their decimal point, add up to another sum than 1, or have
    /// a refractive index among them.
    pub(super) fn per_cent(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| self.fits(ty))?;
        let is_parts = matches!(ty.kind, RecordKind::Optics | RecordKind::OpticsRgb);
        if finding.code != Code::E206 || !is_parts || self.is_index() {
            return None;
        }
        let pointed: Vec<(Token, String)> = (self.params().iter())
            .filter_map(|t| Some((*t, with_point(t.text(self.text))?)))
            .collect();
        if !pointed.is_empty() {
            return self.write(Habit::Proposed, &pointed);
        }
        let written = self.params().iter().map(|t| t.number(self.text));
        let written: Vec<f64> = written.collect::<Option<_>>()?;
        match parts(&written)? {
            Parts::Divided(by) => {
                let new: Vec<String> = match by {
                    PER_CENT => written.iter().map(|x| decimal(x / by)).collect(),
                    _ => shares(&written, by),
                };
                let tokens = self.params().iter().copied();
                self.write(Habit::Proposed, &Vec::from_iter(tokens.zip(new)))
            }
            Parts::Index(kt) => self.index_for_part(kt),
            Parts::Point(at, by) => {
                let new = decimal(written[at] / by);
                self.write(Habit::Proposed, &[(self.params()[at], new)])
            }
        }
    }
}

//! The account that every translation gives of itself: feature by feature, whether the target shows
//! what the scene says.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use super::feature::{Feature, used};
use crate::scene::Scene;

/// How well one feature of the scene came through.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fidelity {
    Exact,
    /// With a bound on the error, in words or numbers.
    Approximate(String),
    /// Not in the translation at all.
    Dropped,
}

/// What a target makes of a feature in general.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    pub fidelity: Fidelity,
    /// How the feature is expressed, where that is worth saying.
    pub note: Cow<'static, str>,
}

impl Verdict {
    pub fn exact(note: impl Into<Cow<'static, str>>) -> Verdict {
        Verdict {
            fidelity: Fidelity::Exact,
            note: note.into(),
        }
    }

    pub fn approximate(bound: &str, note: impl Into<Cow<'static, str>>) -> Verdict {
        Verdict {
            fidelity: Fidelity::Approximate(bound.to_owned()),
            note: note.into(),
        }
    }

    pub fn dropped(note: impl Into<Cow<'static, str>>) -> Verdict {
        Verdict {
            fidelity: Fidelity::Dropped,
            note: note.into(),
        }
    }
}

/// One line of the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    pub feature: String,
    pub fidelity: Fidelity,
    /// How the feature is expressed, where that is worth saying.
    pub note: String,
    /// How many times the scene uses it; 0 for properties of the scene as a whole.
    pub uses: u64,
}

/// What became of the features a scene uses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// The program translated for, as `--to` names it.
    pub target: &'static str,
    entries: BTreeMap<(Fidelity, String), Entry>,
}

impl Report {
    pub fn new(target: &'static str) -> Report {
        Report {
            target,
            entries: BTreeMap::new(),
        }
    }

    /// A line for each feature that the scene uses, by what the target makes of it.
    pub fn of(target: &'static str, scene: &Scene, verdict: impl Fn(Feature) -> Verdict) -> Report {
        let mut report = Report::new(target);
        for (feature, uses) in used(scene) {
            let verdict = verdict(feature);
            report
                .add(feature.name(), verdict.fidelity, &verdict.note)
                .uses = uses;
        }
        report
    }

    /// Counts one more use of a feature.
    pub fn count(&mut self, feature: &str, fidelity: Fidelity, note: &str) {
        self.add(feature, fidelity, note).uses += 1;
    }

    /// States something about the scene as a whole.
    pub fn state(&mut self, feature: &str, fidelity: Fidelity, note: &str) {
        self.add(feature, fidelity, note);
    }

    fn add(&mut self, feature: &str, fidelity: Fidelity, note: &str) -> &mut Entry {
        self.entries
            .entry((fidelity.clone(), feature.to_owned()))
            .or_insert_with(|| Entry {
                feature: feature.to_owned(),
                fidelity,
                note: note.to_owned(),
                uses: 0,
            })
    }

    /// Exact features first, then approximate, then dropped ones; each by name.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.entries.values()
    }

    /// The report without what is exact, and how many features are.
    pub fn brief(&self) -> (Report, usize) {
        let mut rest = self.clone();
        rest.entries
            .retain(|(fidelity, _), _| *fidelity != Fidelity::Exact);
        let exact = self.entries.len() - rest.entries.len();
        (rest, exact)
    }

    pub fn has_dropped(&self) -> bool {
        self.entries().any(|e| e.fidelity == Fidelity::Dropped)
    }

    /// The report as `--report` writes it.
    pub fn to_json(&self) -> serde_json::Value {
        let features: Vec<_> = self
            .entries()
            .map(|e| {
                let (fidelity, bound) = match &e.fidelity {
                    Fidelity::Exact => ("exact", None),
                    Fidelity::Approximate(bound) => ("approximate", Some(bound)),
                    Fidelity::Dropped => ("dropped", None),
                };
                serde_json::json!({
                    "feature": e.feature,
                    "fidelity": fidelity,
                    "bound": bound,
                    "note": (!e.note.is_empty()).then_some(&e.note),
                    "uses": e.uses,
                })
            })
            .collect();
        serde_json::json!({ "version": 1, "target": self.target, "features": features })
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for e in self.entries() {
            match &e.fidelity {
                Fidelity::Exact => write!(f, "exact        {}", e.feature)?,
                Fidelity::Approximate(bound) => write!(f, "approximate  {} ({bound})", e.feature)?,
                Fidelity::Dropped => write!(f, "dropped      {}", e.feature)?,
            }
            if e.uses > 1 {
                write!(f, " ×{}", e.uses)?;
            }
            if !e.note.is_empty() {
                write!(f, ": {}", e.note)?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_first_and_counted() {
        let mut r = Report::new("pov");
        r.state("image texture", Fidelity::Dropped, "");
        r.count("sphere", Fidelity::Exact, "");
        r.count("sphere", Fidelity::Exact, "");
        r.count("torus", Fidelity::Approximate("1e-3".into()), "a mesh");
        assert_eq!(
            r.to_string(),
            "exact        sphere ×2\napproximate  torus (1e-3): a mesh\ndropped      image texture\n"
        );
        let (brief, exact) = r.brief();
        assert_eq!(
            (brief.to_string().as_str(), exact),
            (
                "approximate  torus (1e-3): a mesh\ndropped      image texture\n",
                1
            )
        );
        assert!(r.has_dropped());
        assert_eq!(r.to_json()["features"][1]["bound"], "1e-3");
    }
}

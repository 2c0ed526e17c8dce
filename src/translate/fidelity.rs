//! The account that every translation gives of itself: feature by feature, whether the target shows
//! what the scene says.
//!
//! Its texts stand in the source in English, and the catalogues of other languages give a translation for each
//! ([`Complaint::term`]). Texts with places to fill are messages.

#![warn(missing_docs)]

use std::collections::BTreeMap;
use std::fmt;

use super::feature::{Feature, used};
use crate::diagnostics::{Complaint, Language};
use crate::scene::Scene;

/// How well one feature of the scene came through.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fidelity {
    /// A feature that is the same in the other program.
    Exact,
    /// A feature with a bound on the error, in words or numbers.
    Approximate(Complaint),
    /// A feature that the translation does not have.
    Dropped,
}

impl Fidelity {
    /// An approximate feature, with a bound in words.
    pub fn approximate(bound: &'static str) -> Fidelity {
        Fidelity::Approximate(Complaint::term(bound))
    }

    /// The name of the fidelity in JSON.
    fn name(&self) -> &'static str {
        match self {
            Fidelity::Exact => "exact",
            Fidelity::Approximate(_) => "approximate",
            Fidelity::Dropped => "dropped",
        }
    }
}

/// The support of a target for a feature in general.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FeatureSupport {
    /// How well the feature comes through.
    pub fidelity: Fidelity,
    /// How the feature is expressed, where that is worth saying.
    pub note: Complaint,
}

impl FeatureSupport {
    /// A feature that comes through exactly.
    pub fn exact(note: impl Into<Complaint>) -> FeatureSupport {
        FeatureSupport {
            fidelity: Fidelity::Exact,
            note: note.into(),
        }
    }

    /// A feature that comes through with an error, within a bound.
    pub fn approximate(bound: impl Into<Complaint>, note: impl Into<Complaint>) -> FeatureSupport {
        FeatureSupport {
            fidelity: Fidelity::Approximate(bound.into()),
            note: note.into(),
        }
    }

    /// A feature that is not in the translation.
    pub fn dropped(note: impl Into<Complaint>) -> FeatureSupport {
        FeatureSupport {
            fidelity: Fidelity::Dropped,
            note: note.into(),
        }
    }
}

/// A line of the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportLine {
    /// The name of the feature.
    pub feature: &'static str,
    /// How well the feature came through.
    pub fidelity: Fidelity,
    /// How the feature is expressed, where that is worth saying.
    pub note: Complaint,
    /// How many times the scene uses it; 0 for properties of the scene as a whole.
    pub uses: u64,
}

/// How well a feature came through, its bound in English, and its name: entries are sorted by these.
type Key = (u8, String, &'static str);

/// The fate of the features that a scene uses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// The name of the target, as `--to` has it.
    pub target: &'static str,
    entries: BTreeMap<Key, ReportLine>,
}

impl Report {
    /// An empty report of a target.
    pub fn new(target: &'static str) -> Report {
        Report {
            target,
            entries: BTreeMap::new(),
        }
    }

    /// A line for each feature that the scene uses, by what the target makes of it.
    pub fn of(
        target: &'static str,
        scene: &Scene,
        verdict: impl Fn(Feature) -> FeatureSupport,
    ) -> Report {
        let mut report = Report::new(target);
        for (feature, uses) in used(scene) {
            let verdict = verdict(feature);
            report
                .add(feature.name(), verdict.fidelity, verdict.note)
                .uses = uses;
        }
        report
    }

    /// Counts one more use of a feature.
    pub fn count(&mut self, feature: &'static str, fidelity: Fidelity, note: impl Into<Complaint>) {
        self.add(feature, fidelity, note.into()).uses += 1;
    }

    /// States something about the scene as a whole.
    pub fn state(&mut self, feature: &'static str, fidelity: Fidelity, note: impl Into<Complaint>) {
        self.add(feature, fidelity, note.into());
    }

    fn add(
        &mut self,
        feature: &'static str,
        fidelity: Fidelity,
        note: Complaint,
    ) -> &mut ReportLine {
        let (rank, bound) = match &fidelity {
            Fidelity::Exact => (0, String::new()),
            Fidelity::Approximate(bound) => (1, bound.to_string()),
            Fidelity::Dropped => (2, String::new()),
        };
        self.entries
            .entry((rank, bound, feature))
            .or_insert_with(|| ReportLine {
                feature,
                fidelity,
                note,
                uses: 0,
            })
    }

    /// The lines of the report: exact features first, then approximate, then dropped ones; approximate ones by bound
    /// and name, the others by name.
    pub fn entries(&self) -> impl Iterator<Item = &ReportLine> {
        self.entries.values()
    }

    /// The report without its exact features, and the number of these.
    pub fn brief(&self) -> (Report, usize) {
        let mut rest = self.clone();
        rest.entries
            .retain(|_, entry| entry.fidelity != Fidelity::Exact);
        let exact = self.entries.len() - rest.entries.len();
        (rest, exact)
    }

    /// Whether any feature of the scene is not in the translation.
    pub fn has_dropped(&self) -> bool {
        self.entries().any(|e| e.fidelity == Fidelity::Dropped)
    }

    /// The report as `--report` writes it, in English.
    pub fn to_json(&self) -> serde_json::Value {
        let features: Vec<_> = self
            .entries()
            .map(|e| {
                let bound = match &e.fidelity {
                    Fidelity::Approximate(bound) => Some(bound.to_string()),
                    Fidelity::Exact | Fidelity::Dropped => None,
                };
                let note = e.note.to_string();
                serde_json::json!({
                    "feature": e.feature,
                    "fidelity": e.fidelity.name(),
                    "bound": bound,
                    "note": (!note.is_empty()).then_some(note),
                    "uses": e.uses,
                })
            })
            .collect();
        serde_json::json!({ "version": 1, "target": self.target, "features": features })
    }

    /// The report for people, a line for each entry.
    pub fn text(&self, language: Language) -> String {
        let mut out = String::new();
        for e in self.entries() {
            let bound = match &e.fidelity {
                Fidelity::Approximate(bound) => format!(" ({})", bound.wording(language)),
                Fidelity::Exact | Fidelity::Dropped => String::new(),
            };
            let mut line = language.name(e.feature) + &bound;
            if e.uses > 1 {
                line += &format!(" ×{}", e.uses);
            }
            let note = e.note.wording(language);
            if !note.is_empty() {
                line += &format!(": {note}");
            }
            out += &row(&e.fidelity, &line, language);
        }
        out
    }
}

/// Writes the report in English, for those who do not ask for a language.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Language::English))
    }
}

/// The width of a report's first column, in characters.
const WIDTH: usize = 12;

/// A line of a report: a word for the fidelity in the first column, and the rest of the line.
pub fn row(fidelity: &Fidelity, line: &str, language: Language) -> String {
    let what = match fidelity {
        Fidelity::Exact => "fidelity-exact",
        Fidelity::Approximate(_) => "fidelity-approximate",
        Fidelity::Dropped => "fidelity-dropped",
    };
    format!("{:<WIDTH$} {line}\n", language.say(what, &[]))
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
        r.count("torus", Fidelity::approximate("a material"), "a mesh");
        assert_eq!(
            r.text(Language::English),
            "exact        sphere ×2\napproximate  torus (a material): a mesh\ndropped      image texture\n"
        );
        assert_eq!(
            r.text(Language::Czech),
            "přesně       koule ×2\npřibližně    torus (materiál): síť\nvynecháno    obrazová textura\n"
        );
        let (brief, exact) = r.brief();
        assert_eq!(
            (brief.text(Language::English).as_str(), exact),
            (
                "approximate  torus (a material): a mesh\ndropped      image texture\n",
                1
            )
        );
        assert!(r.has_dropped());
        assert_eq!(r.to_json()["features"][1]["bound"], "a material");
    }
}

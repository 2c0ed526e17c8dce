//! The configurations that a study tries: on each axis the values of one setting, from cheap to expensive.

use crate::trace::Numbers;
use crate::trace::switches::Without;

/// A kind of error; kinds are never mixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Errors at edges, from details smaller than a pixel: samples.
    Edges,
    /// Errors from light that is not followed further: depth and cutoff.
    Light,
    /// Errors of rounding: the kind of numbers, and the solver of roots.
    Numbers,
    /// Errors of flat pieces that stand for curved shapes.
    Facets,
}

impl Kind {
    pub const ALL: [Kind; 4] = [Kind::Edges, Kind::Light, Kind::Numbers, Kind::Facets];

    /// The name of the kind in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Edges => "edges",
            Kind::Light => "light",
            Kind::Numbers => "numbers",
            Kind::Facets => "facets",
        }
    }
}

/// A setting that is varied while the others are held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    Samples,
    Adaptive,
    Depth,
    Cutoff,
    Precision,
    Solver,
    Tessellation,
    Levels,
}

impl Axis {
    pub const ALL: [Axis; 8] = [
        Axis::Samples,
        Axis::Adaptive,
        Axis::Depth,
        Axis::Cutoff,
        Axis::Precision,
        Axis::Solver,
        Axis::Tessellation,
        Axis::Levels,
    ];

    /// The name of the axis on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Axis::Samples => "samples",
            Axis::Adaptive => "adaptive",
            Axis::Depth => "depth",
            Axis::Cutoff => "cutoff",
            Axis::Precision => "precision",
            Axis::Solver => "solver",
            Axis::Tessellation => "tessellation",
            Axis::Levels => "levels",
        }
    }

    pub fn kind(self) -> Kind {
        match self {
            Axis::Samples | Axis::Adaptive => Kind::Edges,
            Axis::Depth | Axis::Cutoff => Kind::Light,
            Axis::Precision | Axis::Solver => Kind::Numbers,
            Axis::Tessellation | Axis::Levels => Kind::Facets,
        }
    }
}

/// The program that finds the hits of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kernel {
    /// The tracer, in these numbers.
    Ours(Numbers),
    /// The plain kernel in single precision.
    PlainF32,
    /// The plain kernel in doubles.
    PlainF64,
}

impl Kernel {
    pub const ALL: [Kernel; 5] = [
        Kernel::PlainF32,
        Kernel::PlainF64,
        Kernel::Ours(Numbers::F32),
        Kernel::Ours(Numbers::F64),
        Kernel::Ours(Numbers::Dd),
    ];

    pub fn name(self) -> &'static str {
        match self {
            Kernel::Ours(numbers) => numbers.name(),
            Kernel::PlainF32 => "plain-f32",
            Kernel::PlainF64 => "plain-f64",
        }
    }
}

/// The solver that finds the roots of tori and solids of revolution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Roots {
    /// The closed formula, with coefficients from the ray's own origin.
    ClosedForm,
    /// The closed formula, after the origin was moved near to the shape.
    Recentred,
    /// The tracer's own solver.
    Ours,
    /// The tracer's roots, improved by Newton's method in double-double.
    Polished,
}

impl Roots {
    pub const ALL: [Roots; 4] = [
        Roots::ClosedForm,
        Roots::Recentred,
        Roots::Ours,
        Roots::Polished,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Roots::ClosedForm => "closed-form",
            Roots::Recentred => "recentred",
            Roots::Ours => "tracer",
            Roots::Polished => "polished-dd",
        }
    }
}

/// All settings that a picture depends on besides the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    pub samples: u32,
    pub tolerance: Option<f64>,
    pub depth: u32,
    pub cutoff: f64,
    pub kernel: Kernel,
    pub roots: Roots,
    pub without: Without,
    /// The number of the scene that is drawn: 0 for the given one, others for scenes made from it.
    pub variant: usize,
}

impl Default for Settings {
    /// The settings that plain `zpg render` takes.
    fn default() -> Settings {
        let default = crate::trace::Settings::default();
        Settings {
            samples: default.samples,
            tolerance: None,
            depth: default.depth,
            cutoff: default.cutoff,
            kernel: Kernel::Ours(default.numbers),
            roots: Roots::Ours,
            without: Without::default(),
            variant: 0,
        }
    }
}

/// A choice of all settings: that of the axis is varied, the others are the default's.
#[derive(Debug, Clone, PartialEq)]
pub struct Configuration {
    pub axis: Axis,
    pub label: String,
    pub settings: Settings,
    /// Whether the configuration may be dropped when time is short.
    pub inner: bool,
}

impl Configuration {
    fn new(axis: Axis, label: impl Into<String>, settings: Settings) -> Configuration {
        Configuration {
            axis,
            label: label.into(),
            settings,
            inner: false,
        }
    }

    fn inner(self, inner: bool) -> Configuration {
        Configuration { inner, ..self }
    }

    pub fn is_default(&self) -> bool {
        self.settings == Settings::default()
    }

    /// The configuration as an option of `zpg render`, as `--depth 16`; without dashes where there is no such option.
    pub fn option(&self) -> String {
        match self.axis {
            Axis::Solver | Axis::Tessellation | Axis::Levels => {
                format!("{} {}", self.axis.name(), self.label)
            }
            axis => format!("--{} {}", axis.name(), self.label),
        }
    }
}

/// The configurations of an axis, the cheapest first.
pub fn ladder(axis: Axis) -> Vec<Configuration> {
    let base = Settings::default();
    match axis {
        Axis::Samples => [1, 2, 4, 8, 16, 64, 256]
            .into_iter()
            .map(|samples| {
                let configuration =
                    Configuration::new(axis, samples.to_string(), Settings { samples, ..base });
                configuration.inner([2, 8].contains(&samples))
            })
            .collect(),
        Axis::Adaptive => [0.1, 0.05, 0.02, 0.01]
            .into_iter()
            .map(|tolerance| {
                let settings = Settings {
                    tolerance: Some(tolerance),
                    ..base
                };
                Configuration::new(axis, tolerance.to_string(), settings).inner(tolerance == 0.05)
            })
            .collect(),
        Axis::Depth => [0, 1, 2, 3, 4, 6, 8, 10, 16, 32]
            .into_iter()
            .map(|depth| {
                let configuration =
                    Configuration::new(axis, depth.to_string(), Settings { depth, ..base });
                configuration.inner([3, 6, 32].contains(&depth))
            })
            .collect(),
        Axis::Cutoff => [
            ("0.1", 0.1),
            ("0.03", 0.03),
            ("0.01", 0.01),
            ("1/256", 1.0 / 256.0),
            ("1/1024", 1.0 / 1024.0),
            ("1/4096", 1.0 / 4096.0),
            ("1e-6", 1e-6),
        ]
        .into_iter()
        .map(|(label, cutoff)| {
            let configuration = Configuration::new(axis, label, Settings { cutoff, ..base });
            configuration.inner(label == "0.03")
        })
        .collect(),
        Axis::Precision => (Kernel::ALL.into_iter())
            .map(|kernel| Configuration::new(axis, kernel.name(), Settings { kernel, ..base }))
            .collect(),
        Axis::Solver => (Roots::ALL.into_iter())
            .map(|roots| Configuration::new(axis, roots.name(), Settings { roots, ..base }))
            .collect(),
        // These configurations are made from the scene.
        Axis::Tessellation | Axis::Levels => Vec::new(),
    }
}

/// A configuration that draws another scene.
pub fn variant(axis: Axis, label: String, variant: usize) -> Configuration {
    let settings = Settings {
        variant,
        ..Settings::default()
    };
    Configuration::new(axis, label, settings)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ladder_has_the_default_once() {
        for axis in [
            Axis::Samples,
            Axis::Depth,
            Axis::Cutoff,
            Axis::Precision,
            Axis::Solver,
        ] {
            let configurations = ladder(axis);
            let defaults = configurations.iter().filter(|r| r.is_default());
            assert_eq!(defaults.count(), 1, "{axis:?}");
            // What may be dropped is neither an end nor the default.
            let ends = [configurations.first(), configurations.last()]
                .into_iter()
                .flatten();
            assert!(
                ends.chain(configurations.iter().filter(|r| r.is_default()))
                    .all(|r| !r.inner || r.label == "32")
            );
        }
    }
}

//! The axes that a scene calls for.

use super::configurations::Axis;
use super::runner::Runner;
use crate::scene::Geometry;
use crate::study::plain::{self, solver};
use crate::trace::plan::{Effect, Plan};
use crate::trace::switches::Without;

/// The reason why an axis is not run, as the name of a message; `None` if it is run.
pub fn skipped(axis: Axis, runner: &Runner) -> Option<&'static str> {
    let plan = &runner.tracer().plan;
    match axis {
        Axis::Samples | Axis::Adaptive | Axis::Precision => None,
        Axis::Depth | Axis::Cutoff => {
            let goes_on = plan.on(Effect::Reflection) || plan.on(Effect::Refraction);
            (!goes_on).then_some("accuracy-skip-light")
        }
        Axis::Solver => {
            let applies = solver::applies(runner.scene(), runner.tracer());
            (!applies).then_some("accuracy-skip-solver")
        }
        Axis::Tessellation => super::facets::unfit(runner),
        Axis::Levels => {
            let geometry = |r: &u32| &runner.scene().shapes[*r as usize].geometry;
            let mut all = runner.tracer().graph.records.iter().map(geometry);
            let any = all.any(|g| matches!(g, Geometry::GeodesicSphere { .. }));
            (!any).then_some("accuracy-skip-levels")
        }
    }
}

/// The reason why the plain kernel is not run, as the name of a message; `None` if it is run.
pub fn no_plain(runner: &Runner) -> Option<&'static str> {
    plain::fits(runner.tracer(), runner.scene()).err()
}

/// The effects that a scene calls for and that can be taken out, each with the switch that does so.
pub fn effects(plan: &Plan) -> Vec<(&'static str, Without)> {
    let none = Without::default;
    let textures = [
        Effect::ImageTexture,
        Effect::SolidTexture,
        Effect::Checkerboard,
        Effect::VertexColour,
    ];
    let all: [(&'static str, bool, Without); 7] = [
        (
            "shadows",
            plan.on(Effect::Shadows),
            Without {
                shadows: true,
                ..none()
            },
        ),
        (
            "transparent-shadows",
            plan.on(Effect::TransparentShadows),
            Without {
                transparent_shadows: true,
                ..none()
            },
        ),
        (
            "reflection",
            plan.on(Effect::Reflection),
            Without {
                reflection: true,
                ..none()
            },
        ),
        (
            "refraction",
            plan.on(Effect::Refraction),
            Without {
                refraction: true,
                ..none()
            },
        ),
        (
            "dispersion",
            plan.on(Effect::Dispersion),
            Without {
                dispersion: true,
                ..none()
            },
        ),
        (
            "textures",
            textures.into_iter().any(|e| plan.on(e)),
            Without {
                textures: true,
                ..none()
            },
        ),
        (
            "smooth-normals",
            plan.on(Effect::SmoothNormals),
            Without {
                smooth_normals: true,
                ..none()
            },
        ),
    ];
    let on = all.into_iter().filter(|e| e.1);
    on.map(|(name, _, without)| (name, without)).collect()
}

//! The cost of a picture, in words.

use std::path::Path;
use std::sync::Arc;

use super::stats::Seconds;
use crate::analysis::Analysis;
use crate::commands::{LookChoice, terminal};
use crate::diagnostics::layout::hanging;
use crate::diagnostics::{Error, Value};
use crate::scene::{Camera, Scene};
use crate::study::accuracy::{cost, number_format};
use crate::trace::stats::Counts;
use crate::trace::{Images, Settings};

/// Seconds that are taken to find out where the time of a picture goes.
const COST_SECONDS: f64 = 1.0;

/// The least width of the first column, in characters.
const LABEL_WIDTH: usize = 36;

/// The text that `--cost` asks for, in some ten lines: rays, tests and times of a picture, its dearest objects and its
/// dearest effect.
pub(super) fn spent(
    camera: &Camera,
    (loaded, scene): (&Analysis, &Scene),
    settings: &Settings,
    (seconds, counts): (&Seconds, &Counts),
    look: LookChoice,
) -> Result<String, Error> {
    let language = look.language();
    let images = Images::load(scene, loaded.source.folder().unwrap_or(Path::new(".")))?;
    let scene = Arc::new(scene.clone());
    let cost = cost::cost(scene, &images, *camera, settings, COST_SECONDS)?;
    let background = language.say("accuracy-background", &[]);
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let objects: Vec<String> = (cost.objects.iter().take(3))
        .map(|&(id, share)| match id {
            0 => format!("{background} {}", percent(share)),
            id => format!("#{id} {}", percent(share)),
        })
        .collect();
    let effects: Vec<String> = (cost.effects.iter().take(1))
        .map(|(name, share)| {
            format!(
                "{} {}",
                number_format::effect(language, name),
                percent(*share)
            )
        })
        .collect();
    let text = |x: f64| number_format::seconds(language, x);
    let phase = |name, x: f64| (name, Value::from(text(x)));
    let phases = [
        phase("load", seconds.load),
        phase("plan", seconds.plan),
        phase("build", seconds.build),
        phase("trace", seconds.trace),
        phase("encode", seconds.encode),
    ];
    let phases = language.say("cost-seconds", &phases);
    let rays = counts.rays;
    let all = [
        ("cost-camera", rays.camera.to_string()),
        ("cost-shadow", rays.shadow.to_string()),
        ("cost-reflection", rays.reflection.to_string()),
        ("cost-refraction", rays.refraction.to_string()),
        ("cost-boxes", counts.intersections.boxes.to_string()),
        ("cost-shapes", counts.intersections.shape.to_string()),
        ("cost-uncertain", counts.uncertain.to_string()),
        ("cost-phases", phases),
        ("cost-objects", objects.join(" · ")),
        ("cost-effect", effects.join(" · ")),
    ];
    let lines = all.into_iter().filter(|line| !line.1.is_empty());
    let lines = lines.map(|(name, text)| (language.say(name, &[]), text));
    let lines: Vec<(String, String)> = lines.collect();
    let widest = lines.iter().map(|line| line.0.chars().count() + 2).max();
    let width = widest.unwrap_or(0).max(LABEL_WIDTH);
    let lines = lines.iter();
    let lines = lines.map(|(name, text)| format!("{name:<width$}{text}"));
    let lines = lines.map(|line| hanging(&line, terminal::width()) + "\n");
    Ok(lines.collect())
}

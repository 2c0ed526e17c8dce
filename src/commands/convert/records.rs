//! The resolved scene: as JSON, and as records.

use super::{Args, Made};
use crate::analysis::Analysis;
use crate::diagnostics::Error;
use crate::format;
use crate::scene::Scene;
use crate::syntax;
use crate::translate::{Report, json};

/// The scene as JSON.
pub fn json(args: &Args, loaded: &Analysis) -> Result<Made, Error> {
    let mut text = serde_json::to_vec_pretty(&json::write(&loaded.scene)).unwrap_or_default();
    text.push(b'\n');
    Ok(made(args, "json", &loaded.scene, text))
}

/// The scene as records, in the layout of the formatter.
pub fn zpg(args: &Args, loaded: &Analysis) -> Result<Made, Error> {
    let records = json::spell(&json::write(&loaded.scene)).text;
    let (document, _) = syntax::parse(&records);
    let text = format::format(&records, &document, &format::Options::default());
    Ok(made(args, "zpg", &loaded.scene, text.into_bytes()))
}

fn made(args: &Args, target: &'static str, scene: &Scene, bytes: Vec<u8>) -> Made {
    Made {
        files: vec![(args.output.clone(), bytes)],
        report: Report::of(target, scene, json::verdict),
    }
}

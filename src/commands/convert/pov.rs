//! POV-Ray: a file, or one for each eye.

use std::path::Path;

use super::{Args, Made, suffixed};
use crate::analysis::Analysis;
use crate::diagnostics::Error;
use crate::syntax::Captions;
use crate::translate::pov::{self, Options, Stereo, Translation};

/// Translates the scene.
pub fn make(args: &Args, loaded: &Analysis) -> Result<Made, Error> {
    let span = loaded.scene.render.map(|r| r.span);
    let crowded = |why| Error::Scene { why, span };
    args.memory.confine_scene(&loaded.scene).map_err(crowded)?;
    let options = Options {
        size: (args.size.width, args.size.height),
        depth: args.depth,
        pictures: pictures(&args.file, args.output.as_deref()),
        stereo: match args.output {
            Some(_) => Stereo::TwoFiles,
            None => Stereo::OneFile,
        },
        captions: Captions::of(&loaded.document, &loaded.source.text),
    };
    let Translation { files, report, .. } = pov::write(&loaded.scene, &options)?;
    let path = |suffix| args.output.as_deref().map(|p| suffixed(p, suffix));
    Ok(Made {
        files: (files.into_iter())
            .map(|f| (path(f.suffix), f.text.into_bytes()))
            .collect(),
        report,
    })
}

/// What leads from the translation to the pictures beside the scene: nothing where it is written
/// beside them, too, else their folder with its whole path.
pub fn pictures(scene: &Path, output: Option<&Path>) -> String {
    let folder = |path: &Path| {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        folder.unwrap_or(Path::new(".")).canonicalize().ok()
    };
    match (folder(scene), output.map(folder)) {
        (Some(from), Some(Some(to))) if from == to => String::new(),
        (Some(from), _) => format!("{}/", from.display()),
        (None, _) => String::new(),
    }
}

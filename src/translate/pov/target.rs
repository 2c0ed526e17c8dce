//! POV-Ray: a file, or one for each eye.

use std::path::Path;

use super::{Options, Stereo, Translation, write};
use crate::diagnostics::Error;
use crate::translate::target::{self, Output, Prepared, Target};

/// POV-Ray 3.7.
#[derive(Debug)]
pub struct Pov;

impl Target for Pov {
    fn name(&self) -> &'static str {
        "pov"
    }

    fn help(&self) -> &'static str {
        "POV-Ray 3.7"
    }

    fn draws(&self) -> bool {
        true
    }

    fn write(&self, scene: &Prepared, options: &target::Options) -> Result<Output, Error> {
        let span = scene.scene().render.map(|r| r.span);
        let crowded = |why| Error::Scene { why, span };
        (options.confine)(scene.scene()).map_err(crowded)?;
        let own = Options {
            size: options.size,
            depth: options.depth,
            pictures: pictures(options.file, options.output),
            stereo: match options.output {
                Some(_) => Stereo::TwoFiles,
                None => Stereo::OneFile,
            },
            captions: scene.captions.clone(),
        };
        let Translation { files, report, .. } = write(scene.scene(), &own)?;
        Ok(Output {
            files: (files.into_iter())
                .map(|f| (options.suffixed(f.suffix), f.text.into_bytes()))
                .collect(),
            report,
        })
    }
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

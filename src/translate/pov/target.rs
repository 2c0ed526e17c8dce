//! POV-Ray: a file, or one for each eye.

use std::path::{Path, PathBuf};

use super::pictures::Pictures;
use super::{Options, Stereo, Translation, brightness, write};
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

    fn adds_what_is_lacking(&self) -> bool {
        true
    }

    fn draws(&self) -> bool {
        true
    }

    fn write(&self, scene: &Prepared, options: &target::Options) -> Result<Output, Error> {
        let span = scene.scene().render.map(|r| r.span);
        let crowded = |why| Error::Scene { why, span };
        (options.confine)(scene.scene()).map_err(crowded)?;
        let stem = (options.output).and_then(|path| Some(path.file_stem()?.to_string_lossy()));
        let stem = stem.unwrap_or("scene".into());
        let (pictures, copies) = match options.output {
            Some(_) => Pictures::beside(&scene.images()?, &stem),
            // Without an output path nobody knows where the translation will lie, so pictures have their whole paths.
            None => (Pictures::InPlace(whole(scene.folder())), Vec::new()),
        };
        let own = Options {
            size: options.size,
            viewpoint: options.viewpoint,
            depth: options.depth,
            pictures,
            stereo: match options.output {
                Some(_) => Stereo::TwoFiles,
                None => Stereo::OneFile,
            },
            captions: scene.captions.clone(),
            name: stem.into_owned(),
            language: options.language,
        };
        let Translation {
            files,
            mut report,
            light_scale,
            ..
        } = write(scene.scene(), scene.bounds(), &own)?;
        brightness::state(&mut report, scene, options, light_scale);
        // Pictures are written first, so that no translation names a file that is not there.
        let beside = |name: String| options.output.map(|path| path.with_file_name(name));
        let copies = copies.into_iter().map(|(name, png)| (beside(name), png));
        let files = files.into_iter();
        let files = files.map(|f| (options.suffixed(f.suffix), f.text.into_bytes()));
        Ok(Output {
            files: copies.chain(files).collect(),
            report,
        })
    }
}

/// The absolute path of a folder, or the folder as it is if it has none.
fn whole(folder: &Path) -> PathBuf {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    folder.canonicalize().unwrap_or_else(|_| folder.to_owned())
}

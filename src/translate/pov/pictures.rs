//! The picture files of a translation: what POV-Ray is to open, and which files that takes.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::PathBuf;

use crate::scene::image_file::JPEG;
use crate::trace::Images;
use crate::translate::plain::plain;

/// The way in which POV-Ray finds the pictures of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Pictures {
    /// Pictures in the scene's folder, as they are. POV-Ray decodes them, and opens no path that is not ASCII.
    InPlace(PathBuf),
    /// Pictures beside the translation: by the name that the scene has for each, the name of a PNG of its texels.
    Beside(BTreeMap<String, String>),
}

impl Default for Pictures {
    fn default() -> Pictures {
        Pictures::InPlace(PathBuf::new())
    }
}

impl Pictures {
    /// PNGs beside a translation of this name, without its extension: their names, and the files.
    pub fn beside(images: &Images, stem: &str) -> (Pictures, Vec<(String, Vec<u8>)>) {
        let stem = plain(stem);
        let mut names = BTreeMap::new();
        let mut files = Vec::new();
        for (i, (file, bitmap)) in images.iter().enumerate() {
            let name = format!("{stem}_image_{}.png", i + 1);
            names.insert(file.to_owned(), name.clone());
            files.push((name, bitmap.png()));
        }
        (Pictures::Beside(names), files)
    }

    /// A picture in POV-Ray's language: the kind of file, which its content tells and not its name, and
    /// its path.
    pub fn named(&self, file: &str) -> String {
        let path = self.path(file);
        let kind = match self {
            Pictures::InPlace(_) => kind(&path),
            Pictures::Beside(_) => "png",
        };
        let path = path.replace('\\', "\\\\").replace('"', "\\\"");
        format!("{kind} \"{path}\"")
    }

    /// The path of a picture as the translation has it.
    pub fn path(&self, file: &str) -> String {
        match self {
            Pictures::InPlace(folder) => folder.join(file).to_string_lossy().into_owned(),
            Pictures::Beside(names) => names.get(file).cloned().unwrap_or_default(),
        }
    }
}

/// POV-Ray's name for the kind of a picture file.
fn kind(path: &str) -> &'static str {
    let mut start = [0; 3];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut start));
    match read.is_ok() && start == JPEG {
        true => "jpeg",
        false => "png",
    }
}

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
    /// The scene's own picture files, in the folder with this path. POV-Ray decodes them, and opens no path that is not
    /// ASCII.
    InPlace(PathBuf),
    /// PNG copies beside the translation: from the scene's name of each picture to the name of its copy.
    Beside(BTreeMap<String, String>),
}

impl Default for Pictures {
    fn default() -> Pictures {
        Pictures::InPlace(PathBuf::new())
    }
}

impl Pictures {
    /// Makes a PNG copy of each image, to be put beside the translation. `stem` is the name of the translation without
    /// its extension. Returns the pictures, and the name and content of each copy.
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

    /// A picture in POV-Ray's language: the kind of file, which is read from its content and not from its name, and its
    /// path in quotes.
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

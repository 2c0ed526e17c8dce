//! The boxes of a sheet: pictures, each with the scene of its name, and scenes without a picture.

use std::collections::{HashMap, HashSet};
use std::path::{Component, Path, PathBuf};

use super::findings::Scene;

/// A box of the sheet.
pub(super) struct SheetBox<'f> {
    /// The path of the picture, or else of the scene, within its folder.
    pub name: String,
    pub picture: Option<PathBuf>,
    pub scene: Option<&'f Scene>,
}

/// The boxes for all pictures of a folder and for the scenes without a picture, in the order of names.
pub(super) fn entries<'f>(
    folder: &Path,
    pictures: Vec<PathBuf>,
    scenes: &'f [Scene],
) -> Vec<SheetBox<'f>> {
    let scenes = Scenes::new(scenes);
    let mut shown = HashSet::new();
    let mut entries = Vec::new();
    for picture in pictures {
        let within = picture.strip_prefix(folder).unwrap_or(&picture);
        let scene = scenes.of_picture(within);
        shown.extend(scene);
        entries.push(SheetBox {
            name: joined(&names(within)),
            scene: scene.map(|i| &scenes.all[i]),
            picture: Some(picture),
        });
    }
    for (i, scene) in scenes.all.iter().enumerate() {
        if !shown.contains(&i) {
            entries.push(SheetBox {
                name: joined(&scenes.names[i][scenes.common..]),
                picture: None,
                scene: Some(scene),
            });
        }
    }
    // Names are compared without endings first, so that "a.png" comes before "a-b.png".
    entries.sort_by_cached_key(|entry| {
        (
            Path::new(&entry.name).with_extension(""),
            entry.name.clone(),
        )
    });
    entries
}

/// The scenes that were checked.
struct Scenes<'f> {
    all: &'f [Scene],
    /// The names in the path of each scene: its folders, and last its own name.
    names: Vec<Vec<String>>,
    /// The number of outermost folders that all scenes share.
    common: usize,
    /// The numbers of the scenes, by their file names without an ending.
    by_stem: HashMap<String, Vec<usize>>,
}

impl<'f> Scenes<'f> {
    fn new(all: &'f [Scene]) -> Scenes<'f> {
        let names: Vec<Vec<String>> = all.iter().map(|scene| names(&scene.path)).collect();
        let folders = |i: usize| {
            names[i]
                .split_last()
                .map_or(&[][..], |(_, folders)| folders)
        };
        let mut common = names.first().map_or(0, |_| folders(0).len());
        for i in 0..names.len() {
            let alike = folders(i)
                .iter()
                .zip(folders(0))
                .take_while(|(a, b)| a == b);
            common = common.min(alike.count());
        }
        let mut by_stem: HashMap<String, Vec<usize>> = HashMap::new();
        for (i, scene) in all.iter().enumerate() {
            by_stem.entry(stem(&scene.path)).or_default().push(i);
        }
        Scenes {
            all,
            names,
            common,
            by_stem,
        }
    }

    /// The number of the scene that a picture shows: it has the picture's name, and is in the same folder or the only
    /// one that may be meant. `within` is the path of the picture within its folder.
    fn of_picture(&self, within: &Path) -> Option<usize> {
        let names = names(within);
        let (_, folders) = names.split_last()?;
        let named = meant(&stem(within))
            .into_iter()
            .find_map(|stem| self.by_stem.get(&stem))?;
        let inner = |i: usize| {
            let (_, outer) = self.names[i].split_last()?;
            Some((&outer[self.common.min(outer.len())..], outer))
        };
        let mut same = named
            .iter()
            .filter(|&&i| inner(i).is_some_and(|(inner, _)| inner == folders));
        let mut near = named
            .iter()
            .filter(|&&i| inner(i).is_some_and(|(_, all)| all.ends_with(folders)));
        match (same.next(), same.next(), near.next(), near.next()) {
            (Some(&only), None, ..) | (None, _, Some(&only), None) => Some(only),
            _ => None,
        }
    }
}

/// The names of a path, from the outermost folder on.
fn names(path: &Path) -> Vec<String> {
    let names = path.components().filter(|part| *part != Component::CurDir);
    names
        .map(|part| part.as_os_str().to_string_lossy().into_owned())
        .collect()
}

fn joined(names: &[String]) -> String {
    names.join("/")
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// The names without an ending that the scene of a picture may have: the picture's own name, and the name without what
/// `render` adds for an eye of a pair or for a frame.
fn meant(stem: &str) -> Vec<String> {
    let mut all = vec![stem.to_owned()];
    let mut rest = stem;
    for eye in ["_left", "_right"] {
        rest = rest.strip_suffix(eye).unwrap_or(rest);
    }
    all.push(rest.to_owned());
    if let Some((name, number)) = rest.rsplit_once('.')
        && number.bytes().all(|c| c.is_ascii_digit())
    {
        all.push(name.to_owned());
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names of the boxes, and of the scenes that belong to them.
    fn boxes(pictures: &[&str], scenes: &[&str]) -> Vec<String> {
        let scene = |path: &&str| Scene {
            path: path.into(),
            findings: Vec::new(),
        };
        let scenes: Vec<Scene> = scenes.iter().map(scene).collect();
        let pictures = pictures
            .iter()
            .map(|name| Path::new("out").join(name))
            .collect();
        let all = entries(Path::new("out"), pictures, &scenes);
        let shown = |entry: &SheetBox| {
            let scene = entry.scene.map_or("-".into(), |s| s.path.to_string_lossy());
            format!("{} {scene}", entry.name)
        };
        all.iter().map(shown).collect()
    }

    #[test]
    fn pictures_have_the_scenes_of_their_names() {
        let found = boxes(
            &["b.png", "a.png", "c.exr"],
            &["in/a.zpg", "in/b.zpg", "in/d.zpg"],
        );
        assert_eq!(
            found,
            [
                "a.png in/a.zpg",
                "b.png in/b.zpg",
                "c.exr -",
                "d.zpg in/d.zpg"
            ]
        );
        // One name in several folders.
        let found = boxes(
            &["x/scene.png", "y/scene.png", "scene.png"],
            &["./in/x/scene.zpg", "./in/y/scene.zpg"],
        );
        let expected = [
            "scene.png -",
            "x/scene.png ./in/x/scene.zpg",
            "y/scene.png ./in/y/scene.zpg",
        ];
        assert_eq!(found, expected);
        // A picture in a folder of its own has no scene from elsewhere.
        assert_eq!(
            boxes(&["z/a.png"], &["in/a.zpg"]),
            ["a.zpg in/a.zpg", "z/a.png -"]
        );
        assert_eq!(boxes(&["in/a.png"], &["in/a.zpg"]), ["in/a.png in/a.zpg"]);
    }

    #[test]
    fn eyes_and_frames_belong_to_their_scene() {
        let found = boxes(&["a_left.png", "a_right.png", "a.0001.png"], &["a.zpg"]);
        assert_eq!(
            found,
            ["a.0001.png a.zpg", "a_left.png a.zpg", "a_right.png a.zpg"]
        );
        // A scene of exactly this name comes first.
        assert_eq!(
            boxes(&["a_left.png"], &["a.zpg", "a_left.zpg"])[1],
            "a_left.png a_left.zpg"
        );
    }
}

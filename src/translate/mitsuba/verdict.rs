//! What Mitsuba makes of each feature.

use super::written::Written;
use crate::translate::{Effect, Feature, Verdict};

/// `None` for a feature that this translation was never told about.
pub fn verdict(feature: Feature, tolerance: f64, written: &Written) -> Option<Verdict> {
    Some(match feature {
        Feature::Record(code) => record(code, tolerance, written.counts(code))?,
        Feature::Effect(effect) => of_effect(effect),
    })
}

/// How many of a type of record were written as Mitsuba's own, and how many as meshes.
type Counts = [usize; 2];

fn record(code: i32, tolerance: f64, counts: Counts) -> Option<Verdict> {
    let within = format!("within {tolerance:.3e}");
    let facets = |note: &'static str| Verdict::approximate(&within, note);
    let [exact, meshes] = counts;
    Some(match code {
        0 => Verdict::exact("there is nothing to draw"),
        1 | 2 | 10 | 14..=21 => facets("a mesh"),
        9 | 11 if meshes == 0 => Verdict::exact(made("sphere", counts)),
        9 | 11 => Verdict::approximate(&within, made("sphere", counts)),
        3 | 4 if exact == 0 && meshes > 0 => Verdict::exact("a mesh"),
        3 | 4 => {
            let end = "ends at a thousand times the scene's size";
            let own = if meshes == 0 { "rectangles" } else { "plane" };
            Verdict::approximate(end, made(own, counts))
        }
        5 => Verdict::exact(made("rectangle", counts)),
        12 => Verdict::exact(made("cube", counts)),
        6..=8 | 13 => Verdict::exact("a mesh of the same facets"),
        -4..=-1 => Verdict::exact(""),
        -99 => Verdict::approximate(
            "exact where rays are parallel, or pixels square",
            "orthographic, perspective with principal_point_offset",
        ),
        -101 => Verdict::exact("shapes side by side; those of one clear medium are joined"),
        -104..=-102 => facets("cut as meshes"),
        -105 => Verdict::exact(""),
        -201 | -202 => Verdict::approximate(
            "a mixture by the strongest channel, with Fresnel's law where light is bent",
            "diffuse, conductor, dielectric",
        ),
        -203 => Verdict::exact("int_ior, ext_ior"),
        -299 | -701 => Verdict::exact(""),
        -301 if meshes == 0 => Verdict::exact("bitmap"),
        -301 => Verdict::approximate(STRAIGHT, laid("bitmap", counts)),
        -302 => Verdict::approximate("one colour a triangle", "mesh_attribute"),
        -399 if meshes == 0 => Verdict::exact("checkerboard"),
        -399 => Verdict::approximate(STRAIGHT, laid("checkerboard", counts)),
        -401 => Verdict::approximate("light that what is near keeps out", "a constant emitter"),
        -402 => Verdict::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point emitter",
        ),
        -501 | -502 => Verdict::exact("perspective"),
        -503 => Verdict::exact("one file for each eye"),
        -601 | -602 => Verdict::exact("left out: it never changes the picture"),
        9999 => Verdict::exact(""),
        _ => return None,
    })
}

/// What surface coordinates are on a mesh.
const STRAIGHT: &str = "straight between the points of a mesh";

/// What shapes became: `2 spheres, 1 mesh`.
fn made(own: &str, counts: Counts) -> String {
    match counts {
        [_, 0] => own.to_owned(),
        [0, _] => "a mesh".to_owned(),
        [exact, meshes] => {
            let many = if exact > 1 { "s" } else { "" };
            format!("{exact} {own}{many}, {}", of_meshes(meshes))
        }
    }
}

/// On what textures were laid: `checkerboard, on 2 exact shapes and 1 mesh`.
fn laid(name: &str, [exact, meshes]: Counts) -> String {
    if exact == 0 {
        return name.to_owned();
    }
    let shapes = if exact > 1 { "shapes" } else { "shape" };
    format!(
        "{name}, on {exact} exact {shapes} and {}",
        of_meshes(meshes)
    )
}

fn of_meshes(count: usize) -> String {
    match count {
        1 => "1 mesh".to_owned(),
        n => format!("{n} meshes"),
    }
}

fn of_effect(effect: Effect) -> Verdict {
    match effect {
        Effect::Diffuse | Effect::Shadows | Effect::Reflection => {
            Verdict::approximate("light between surfaces comes in addition", "path")
        }
        Effect::TransparentShadows => Verdict::approximate(
            "full behind what bends light",
            "point lights are no caustics",
        ),
        Effect::Refraction | Effect::TotalReflection => {
            Verdict::approximate("with Fresnel's law", "dielectric")
        }
        Effect::Dispersion => Verdict::approximate(
            "the mean of the channels; exact in three passes",
            "as the head of the file says",
        ),
        Effect::VertexColours => Verdict::approximate("at the points of a mesh", "mesh_attribute"),
        Effect::SmoothNormals => Verdict::exact("normals of the mesh"),
        Effect::Background => Verdict::approximate(
            "it lights the scene; beside ambient light that is seen instead",
            "a constant emitter",
        ),
        Effect::RenderBox => Verdict::exact("what it cuts is a mesh, and open"),
        Effect::AutomaticCamera => Verdict::exact("the camera is written out"),
        Effect::Headlight => Verdict::approximate(
            "as bright as ours at the scene's middle: it fades with distance",
            "a point emitter",
        ),
        Effect::Depth => Verdict::exact("max_depth"),
        Effect::Cutoff => Verdict::exact("paths end at random, which is right on average"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_feature_has_a_line() {
        for feature in Feature::all() {
            for counts in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let line = match feature {
                    Feature::Record(code) => record(code, 0.1, counts),
                    Feature::Effect(effect) => Some(of_effect(effect)),
                };
                assert!(line.is_some(), "{feature:?}");
            }
        }
    }

    #[test]
    fn shapes_are_counted() {
        assert_eq!(made("sphere", [3, 0]), "sphere");
        assert_eq!(made("sphere", [0, 3]), "a mesh");
        assert_eq!(made("sphere", [1, 2]), "1 sphere, 2 meshes");
        assert_eq!(made("cube", [2, 1]), "2 cubes, 1 mesh");
        assert_eq!(
            laid("checkerboard", [2, 1]),
            "checkerboard, on 2 exact shapes and 1 mesh"
        );
    }
}

//! Lights.

use crate::scene::{NodeId, PointLight, Rgb, Scene};
use crate::solids::bounds::NodeBounds;
use crate::syntax::Captions;
use crate::trace::plan::unseen::view::on_surfaces;
use crate::translate::pov::tree::Light;

/// The point lights.
pub(super) fn point_lights(scene: &Scene, captions: &Captions) -> Vec<Light> {
    let light = |light: &PointLight| Light {
        caption: captions.entity(light.id),
        position: light.position,
        colour: light.colour,
        intensity: light.intensity,
    };
    scene.point_lights.iter().map(light).collect()
}

/// Whether any lamp lies on a surface.
pub(super) fn is_any_on_surface(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> bool {
    let places: Vec<_> = scene.point_lights.iter().map(|l| l.position).collect();
    on_surfaces(scene, bounds, root, &places).contains(&true)
}

/// The sum of the ambient lights.
pub(super) fn ambient(scene: &Scene) -> Rgb {
    (scene.ambient_lights.iter()).fold([0.0; 3], |sum, light| {
        std::array::from_fn(|c| sum[c] + light.intensity * light.colour[c])
    })
}

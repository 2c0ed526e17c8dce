//! Distances of the things that the picture shows, found by following rays of a small picture.

use super::camera::Eye;
use crate::geometry::Aabb;
use crate::geometry::vec::Vec3;
use crate::scene::Scene;
use crate::trace::camera::View;
use crate::trace::{Ray, Tracer, Walkers};

/// The numbers of rays, across and down the picture, that are followed.
const GRID: (u32, u32) = (40, 30);
/// The most surfaces that a ray is followed to.
const SURFACES: usize = 8;

/// Distances in the scene's units.
#[derive(Debug, Clone, Copy)]
pub(super) struct SightRange {
    /// Distance from the eye to the nearer surfaces: for a tenth of the rays the first surface is nearer.
    pub near: f64,
    /// Distance from a surface that light goes through to the next one. For a hundredth of the rays it is less;
    /// infinite if fewer rays meet such surfaces.
    pub gap: f64,
    /// The largest distance from the eye to a surface that is seen, or from such a surface to one that throws a shadow
    /// on it.
    pub far: f64,
}

/// The range of distances that the eyes see. `None` if nothing is seen, or the tracer cannot tell.
pub(super) fn sight_range(scene: &Scene, eyes: &[Eye], whole: Aabb) -> Option<SightRange> {
    let tracer = Tracer::new(scene).ok()?;
    let mut sight = Sight {
        scene,
        walkers: tracer.walker(),
        tracer: &tracer,
        firsts: Vec::new(),
        gaps: Vec::new(),
        far: 0.0,
    };
    for eye in eyes {
        sight.look(eye);
    }
    if bends(scene) {
        // Mirrors and refracting surfaces may show things anywhere in the scene.
        for eye in eyes {
            let ends = [whole.min, whole.max];
            let away = ends
                .iter()
                .flat_map(|end| (0..3).map(|i| (end[i] - eye.camera.position[i]).abs()));
            // An endless scene has no farthest point in some directions; these do not count.
            sight.far = away.filter(|x| x.is_finite()).fold(sight.far, f64::max);
        }
    }
    let Sight {
        firsts, gaps, far, ..
    } = sight;
    // If a ray needed more memory than it may have, its answer is not reliable.
    if tracer.graph.room.is_exhausted() {
        return None;
    }
    Some(SightRange {
        near: quantile(firsts, 10)?,
        gap: quantile(gaps, 100)?,
        far,
    })
}

/// Whether any optics in the scene mirror or refract light.
fn bends(scene: &Scene) -> bool {
    let optics = || scene.paints.iter().filter_map(|p| p.optics.as_ref());
    let any = |share: [f64; 3]| share.iter().any(|k| *k > 0.0);
    optics().any(|o| any(o.ks))
        || optics().any(|o| any(o.kt))
            && scene
                .paints
                .iter()
                .any(|p| p.index.is_some_and(|i| i != [1.0; 3]))
}

/// The value that a fraction 1/`part` of the values does not exceed; `None` if there are no values.
fn quantile(mut values: Vec<f64>, part: usize) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / part).copied()
}

struct Sight<'a> {
    scene: &'a Scene,
    tracer: &'a Tracer,
    walkers: Walkers<'a>,
    /// For each ray that meets a surface, the distance to the first one.
    firsts: Vec<f64>,
    /// For each ray, the smallest distance from one surface to the next; infinite if the ray meets fewer than two.
    gaps: Vec<f64>,
    far: f64,
}

impl Sight<'_> {
    fn look(&mut self, eye: &Eye) {
        let Some(view) = View::new(&eye.camera, GRID.0, GRID.1) else {
            return;
        };
        for y in 0..GRID.1 {
            for x in 0..GRID.0 {
                if let Some(ray) = view.ray(f64::from(x) + 0.5, f64::from(y) + 0.5) {
                    self.follow(ray);
                }
            }
        }
    }

    fn follow(&mut self, mut ray: Ray) {
        let (mut way, mut gap) = (0.0, f64::INFINITY);
        for surface in 0..SURFACES {
            let Some(hit) = self.tracer.hit(&mut self.walkers, &ray) else {
                break;
            };
            let step = hit.t * ray.line.direction.length();
            way += step;
            match surface {
                0 => self.firsts.push(step),
                _ => gap = gap.min(step),
            }
            self.far = self.far.max(way);
            for light in &self.scene.point_lights {
                let to_light = Vec3::from(light.position) - hit.point;
                let shadow = hit.leave(to_light, false);
                if let Some(by) = self.tracer.hit(&mut self.walkers, &shadow)
                    && by.t < 1.0
                {
                    self.far = self.far.max(by.t * to_light.length());
                }
            }
            let optics = &self.tracer.graph.optics[hit.optics as usize];
            if !optics.kt.iter().any(|k| *k > 0.0) {
                break;
            }
            ray = hit.leave(ray.line.direction, true);
        }
        self.gaps.push(gap);
    }
}

//! How near and how far the things are that the picture shows, by looking at it.

use super::camera::Eye;
use crate::geometry::Aabb;
use crate::geometry::vec::Vec3;
use crate::scene::Scene;
use crate::trace::camera::View;
use crate::trace::{Ray, Tracer, Walkers};

/// The picture is looked at through so many pixels.
const GRID: (u32, u32) = (40, 30);
/// A ray is followed through so many surfaces.
const SURFACES: usize = 8;

/// Distances in the scene's units.
#[derive(Debug, Clone, Copy)]
pub(super) struct SightRange {
    /// Distance from the eye to the nearer surfaces: a tenth of what is seen is nearer.
    pub near: f64,
    /// Distance from a surface that light goes through to the next one; for a hundredth of the picture it is less,
    /// infinite where that is not so.
    pub gap: f64,
    /// The farthest that anything seen is from the eye, or that throws a shadow on it from there.
    pub far: f64,
}

/// Looks through the eyes; nothing where there is nothing to be seen.
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
        // What mirrors show may be anywhere.
        for eye in eyes {
            let ends = [whole.min, whole.max];
            let away = ends
                .iter()
                .flat_map(|end| (0..3).map(|i| (end[i] - eye.camera.position[i]).abs()));
            // Of what has no end there is no farthest point.
            sight.far = away.filter(|x| x.is_finite()).fold(sight.far, f64::max);
        }
    }
    let Sight {
        firsts, gaps, far, ..
    } = sight;
    // Where so much lies in one place nobody can tell.
    if tracer.graph.room.is_exhausted() {
        return None;
    }
    Some(SightRange {
        near: quantile(firsts, 10)?,
        gap: quantile(gaps, 100)?,
        far,
    })
}

/// Whether anything sends light another way.
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

/// The value that one `part`-th of the values does not exceed.
fn quantile(mut values: Vec<f64>, part: usize) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / part).copied()
}

struct Sight<'a> {
    scene: &'a Scene,
    tracer: &'a Tracer,
    walkers: Walkers<'a>,
    /// Distances along each ray that meets a surface.
    firsts: Vec<f64>,
    /// Distances between surfaces, for each ray.
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

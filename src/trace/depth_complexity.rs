//! How many objects of a scene lie over one another in one place. A shared part is stored once, however often it
//! occurs, but a ray takes memory for every object that it enters.

use super::graph::{Graph, Operation, Target};
use super::memory_limit::GROWTH_FACTOR;
use super::search::context::Context;
use crate::geometry::affine::Placement;
use crate::geometry::vec::Vec3;

/// The most points that are looked at to find out whether a scene is crowded.
const POINTS: usize = 16;
/// The most parts that are looked at for one of these points.
const STEPS: usize = 1 << 26;

impl Graph {
    /// The number of shapes in the scene, each counted as often as it occurs.
    pub fn occurrences(&self) -> f64 {
        self.totals(|_| 0.0, 1.0)
    }

    /// The sum over all occurrences of objects and shapes: `own` of the index for an object, `shape` for a shape.
    /// Operands are added up first.
    fn totals(&self, own: impl Fn(u32) -> f64, shape: f64) -> f64 {
        let mut totals = Vec::with_capacity(self.objects.len());
        for object in 0..self.objects.len() as u32 {
            let mut total = own(object);
            self.each_part(object, |part| {
                total += match self.parts[part as usize].target {
                    Target::Shape(_) => shape,
                    Target::Object(below) => totals[below as usize],
                };
            });
            totals.push(total);
        }
        totals[self.root as usize]
    }

    fn each_part(&self, object: u32, mut step: impl FnMut(u32)) {
        let group = match &self.objects[object as usize].operation {
            Operation::Union(group) => group,
            Operation::Intersection { first, cuts, .. } => {
                first.clone().for_each(&mut step);
                cuts
            }
        };
        group.parts().for_each(step);
    }

    /// Whether more objects lie over one another in some place than a ray has memory for. Only a few likely points are
    /// tried. A ray may still run out of memory elsewhere, and [`Graph::room`] notes that.
    pub fn is_crowded(&self) -> bool {
        let most = self.room.bytes / (GROWTH_FACTOR * size_of::<Context>());
        // A ray cannot enter more objects than there are.
        if self.totals(|_| 1.0, 0.0) < most as f64 {
            return false;
        }
        let points = self.likely_points();
        points.iter().any(|&point| self.lies_in(point, most))
    }

    /// The points that are tried: the centre of the scene, then the centre of its largest object, and so on down. The
    /// largest object has the most objects below it.
    fn likely_points(&self) -> Vec<Vec3> {
        let mut sizes = Vec::with_capacity(self.objects.len());
        for object in 0..self.objects.len() as u32 {
            let mut size = 1.0;
            self.each_part(object, |part| {
                if let Target::Object(below) = self.parts[part as usize].target {
                    let below: f64 = sizes[below as usize];
                    size += below;
                }
            });
            sizes.push(size);
        }
        let mut points = Vec::new();
        let mut object = self.root;
        // The placements on the way, the innermost last.
        let mut way = Vec::new();
        while points.len() < POINTS {
            let mut centre = Vec3(self.objects[object as usize].bounds.centre());
            for &placement in way.iter().rev() {
                let placement: &Placement = &self.placements[placement as usize];
                centre = placement.out.point(centre);
            }
            if centre.is_finite() {
                points.push(centre);
            }
            let mut largest: Option<(f64, u32, u32)> = None;
            self.each_part(object, |part| {
                let part = &self.parts[part as usize];
                if let Target::Object(below) = part.target {
                    let size = sizes[below as usize];
                    if largest.is_none_or(|(most, ..)| size > most) {
                        largest = Some((size, below, part.placement));
                    }
                }
            });
            let Some((_, below, placement)) = largest else {
                break;
            };
            object = below;
            way.push(placement);
        }
        points
    }

    /// Whether a point lies in the boxes of at least `most` occurrences of objects; `false` if that takes too many
    /// steps.
    fn lies_in(&self, point: Vec3, most: usize) -> bool {
        let (mut entered, mut steps) = (0, 0);
        let mut stack = vec![(self.root, point)];
        while let Some((object, point)) = stack.pop() {
            let bounds = &self.objects[object as usize].bounds;
            if (0..3).any(|i| point[i] < bounds.min[i] || bounds.max[i] < point[i]) {
                continue;
            }
            entered += 1;
            if entered >= most {
                return true;
            }
            if steps > STEPS {
                break;
            }
            self.each_part(object, |part| {
                let part = &self.parts[part as usize];
                steps += 1;
                if let Target::Object(below) = part.target {
                    let back = &self.placements[part.placement as usize].back;
                    stack.push((below, back.point(point)));
                }
            });
        }
        false
    }
}

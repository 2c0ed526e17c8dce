//! All surfaces of shapes on a ray, also where operations cut them away.

use super::graph::{Operation, Target};
use super::precision::Precision;
use super::ray::Ray;
use super::search::context::Leaf;
use super::search::escalate::Walkers;
use super::search::events::Task;
use super::search::walk::Walker;
use super::tracer::Tracer;

/// A crossing with the surface of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface<R = f64> {
    pub t: R,
    /// ID of the entity whose record made the shape.
    pub shape: u32,
    /// A number for the occurrence of the shape on this ray.
    pub leaf: u32,
}

impl Tracer {
    /// The surfaces of shapes that a ray crosses in [from, to], in no order, also where an operation or
    /// the region that is drawn cuts them away.
    pub fn surfaces<R: Precision>(
        &self,
        walkers: &mut Walkers<R>,
        ray: &Ray<R>,
        from: R,
        to: R,
    ) -> Vec<Surface<R>> {
        walkers.walker().surfaces(ray, from, to)
    }
}

impl<R: Precision> Walker<'_, R> {
    fn surfaces(&mut self, ray: &Ray<R>, from: R, to: R) -> Vec<Surface<R>> {
        let graph = self.graph;
        let mut out = Vec::new();
        let mut leaves = 0;
        self.begin(ray);
        self.spans.tasks.clear();
        self.spans.tasks.push(Task::Object { context: 0 });
        while let Some(task) = self.spans.tasks.pop() {
            match task {
                Task::Object { context } => {
                    let object = self.contexts[context as usize].object as usize;
                    match &graph.objects[object].operation {
                        Operation::Union(group) => self.gather(context, group, from, to),
                        Operation::Intersection { first, cuts, .. } => {
                            let operands = first.clone().map(|part| Task::Part { part, context });
                            self.spans.tasks.extend(operands);
                            self.gather(context, cuts, from, to);
                        }
                    }
                }
                Task::Part { part, context } => match self.part(part).target {
                    Target::Object(object) => {
                        let context = self.enter(context, part, object);
                        let task = context.map(|context| Task::Object { context });
                        self.spans.tasks.extend(task);
                    }
                    Target::Shape(primitive) => {
                        let leaf = Leaf { part, context };
                        self.cross(ray, leaf, primitive, from, None);
                        let roots = self.roots.list.iter().map(|root| root.t);
                        let crossed = roots.filter(|t| (from..=to).contains(t));
                        out.extend(crossed.map(|t| Surface {
                            t,
                            shape: self.shape_id(leaf),
                            leaf: leaves,
                        }));
                        leaves += 1;
                    }
                },
                // This walk puts no tasks of these kinds on the stack.
                Task::Operand { .. } | Task::JoinUnion { .. } | Task::JoinIntersection { .. } => {}
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    #[test]
    fn what_is_cut_away_counts() {
        // A box, a ball taken out of it, a rectangle in the box's upper face, a ball beside the ray.
        let text = "2 12 -1 -1 -1 1 1 1\n3 11 0 1 0 0.5\n4 -103 2 3\n5 5 -2 -2 2 2\n5 -2 90 1\n\
                    5 -1 0 1 0\n6 -101 4 5\n7 11 5 0 0 1\n8 -101 6 7\n1 9999 8 0\n";
        let scene = scene(text);
        let tracer = Tracer::new(&scene).unwrap();
        let mut walkers = tracer.walker::<f64>();
        let ray = Ray::new([0.25, 5.0, 0.0].into(), [0.0, -1.0, 0.0].into());
        let mut found = |from: f64, to: f64| {
            let mut all = tracer.surfaces(&mut walkers, &ray, from, to);
            all.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.shape.cmp(&b.shape)));
            all.iter().map(|s| (s.t, s.shape)).collect::<Vec<_>>()
        };
        let half = 0.1875f64.sqrt();
        let all = [
            (4.0 - half, 3),
            (4.0, 2),
            (4.0, 5),
            (4.0 + half, 3),
            (6.0, 2),
        ];
        let got = found(0.0, 10.0);
        assert_eq!(got.len(), all.len(), "{got:?}");
        for (got, meant) in got.iter().zip(all) {
            assert!(
                (got.0 - meant.0).abs() < 1e-12 && got.1 == meant.1,
                "{got:?}"
            );
        }
        assert_eq!(found(3.999, 4.001), [(4.0, 2), (4.0, 5)]);
    }
}

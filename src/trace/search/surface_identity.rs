//! Whether two faces lie in one surface, by the numbers of the scene. Unlike computed crossings, these numbers are not
//! blurred by rounding.

use super::context::Leaf;
use super::events::RayPoint;
use super::walk::Walker;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::trace::precision::Precision;
use crate::trace::shapes::Root;
use crate::trace::shapes::support::{Passage, Placed, Support};

impl<R: Precision> Walker<'_, R> {
    /// How a line passes the support of a face, which is the surface that the face is a part of. The line crosses the
    /// face at `point`; both are in the space of the leaf's shape. `None` if other shapes have no faces in that
    /// support.
    pub(in crate::trace) fn passage(
        &self,
        leaf: Leaf,
        line: &Line<R>,
        (face, point): (u32, Vec3<R>),
    ) -> Option<Passage> {
        let own = self.primitive(leaf).shape().support(face)?;
        let outwards = own.outwards(point);
        Some(Passage {
            placed: self.placed_support(leaf, own),
            outwards: outwards.map(|n| n.dot(line.direction) > R::ZERO),
        })
    }

    /// The support of a leaf's face, carried from the shape's space towards the scene's.
    fn placed_support(&self, leaf: Leaf, own: Support) -> Placed {
        let mut placed = Placed::new(own, self.chain(leaf));
        self.climb(leaf, |at, placement| {
            placed.carry(&self.graph.matrices[placement as usize], || self.chain(at));
        });
        placed
    }

    /// Like [`passage`](Self::passage), for the face and the point of a root.
    pub(in crate::trace) fn passage_at(
        &self,
        leaf: Leaf,
        line: &Line<R>,
        root: Root<R>,
    ) -> Option<Passage> {
        let point = self.primitive(leaf).intersect().locate(line, root).point;
        self.passage(leaf, line, (root.face, point))
    }

    /// Whether two crossings that are near each other are with faces in one surface.
    pub(in crate::trace) fn in_one_place(&self, a: &RayPoint<R>, b: &RayPoint<R>) -> bool {
        let passage = |place: &RayPoint<R>| {
            let line = self.line(place.leaf);
            self.passage_at(place.leaf, &line, place.root)
        };
        let both = passage(a).zip(passage(b));
        both.is_some_and(|(a, b)| a.is(&b))
    }

    /// Whether a crossing near the start of a ray is with the surface that the ray has left, at the start itself.
    /// `left` is how the ray passes that surface.
    pub(in crate::trace) fn goes_on(
        &self,
        leaf: Leaf,
        line: &Line<R>,
        root: Root<R>,
        left: Option<Passage>,
    ) -> bool {
        let both = left.zip(left.and_then(|_| self.passage_at(leaf, line, root)));
        both.is_some_and(|(left, here)| here.is(&left))
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::scene;
    use crate::trace::picture::{Numbers, Settings, selected_camera};
    use crate::trace::{Picture, Tracer};

    fn picture(text: &str, numbers: Numbers) -> Picture {
        let scene = scene(text);
        let tracer = Tracer::new(&scene).unwrap();
        let settings = Settings {
            width: 32,
            height: 24,
            depth: 6,
            numbers,
            ..Settings::default()
        };
        let camera = selected_camera(&scene, 4.0 / 3.0);
        tracer.render(&camera, &settings, || ()).unwrap()
    }

    const OPTICS: &str = "3 -201 0.05 0.08 0.87\n3 -203 1.5 1.5 1.5\n4 -201 0.02 0.03 0.95\n\
                          4 -203 1.33 1.33 1.33\n50 -402 0.8\n50 -1 3 6 5\n51 -401 0.2\n\
                          60 -501 1.5 2.6 6 -0.25 -0.32 -1 0 1 0 40\n";

    /// Vessels and what fills them: no ray has to be looked at twice, and all see what they see in
    /// double-double.
    #[test]
    fn what_fills_something_is_known_to() {
        let tank = "10 12 -2 0 -1 2 2 1\n11 12 -1.9 0.1 -0.9 1.9 2.1 0.9\n12 -103 10 11\n12 -299 0 3\n\
                    13 12 -1.9 0.1 -0.9 1.9 1.7 0.9\n13 -299 0 4\n";
        // Up to half of the wall's height, where its radius is 0.7.
        let glass = "10 1 9 1 0 1 0.08 0.1 0.15 0.1 1.2 0.7 1.6 0.8 2.6 0.75 2.6 0.65 1.62 0.08 1.3\n\
                     12 -105 10\n12 -299 0 3\n13 1 3 0.08 1.3 0.65 1.62 0.7 2.11\n13 -299 0 4\n";
        let cup = "10 1 2 1 0 1 2\n11 1 2 0.9 0.1 0.9 2.1\n12 -103 10 11\n12 -299 0 3\n\
                   13 1 2 0.9 0.1 0.9 1.4\n13 -299 0 4\n";
        let stone = "10 9 1\n11 9 0.7\n12 -103 10 11\n12 -299 0 3\n12 -1 0 1 0\n13 11 0 1 0 0.7\n13 -299 0 4\n";
        // 0.1 + 0.7 and 0.5 + 0.3 are 0.8, but not in doubles.
        let stack = "10 12 -1 0 -1 1 0.5 1\n10 -1 0 0.3 0\n12 -105 10\n12 -299 0 3\n\
                     13 12 -1 0.1 -1 1 0.5 1\n13 -1 0 0.7 0\n13 -299 0 4\n";
        let turned = "10 12 -2 0 -1 2 2 1\n11 12 -1.9 0.1 -0.9 1.9 2.1 0.9\n12 -103 10 11\n12 -299 0 3\n\
                      12 -2 30 2\n13 12 -1.9 0.1 -0.9 1.9 1.7 0.9\n13 -299 0 4\n13 -2 30 2\n";
        for solids in [tank, glass, cup, stone, stack, turned] {
            for order in ["12 13", "13 12"] {
                let floor = "40 4 0 1 0 0\n";
                let union = format!("30 -101 {order}\n31 -101 30 40\n1 9999 31 0\n");
                let text = [OPTICS, solids, floor, &union].concat();
                let [double, fine] = [Numbers::F64, Numbers::Dd].map(|n| picture(&text, n));
                assert!(
                    double.counts.uncertain * 100 < double.counts.rays.camera,
                    "{text}"
                );
                let apart =
                    |(a, b): (&[f32; 3], &[f32; 3])| (0..3).any(|c| (a[c] - b[c]).abs() > 1e-5);
                let mut pixels = double.film.pixels.iter().zip(&fine.film.pixels);
                assert!(!pixels.any(apart), "{text}");
            }
        }
    }

    /// A transparent sheet in a face of a solid looks as one that lies a little above the face: the face is seen
    /// through it, and is lit through it.
    #[test]
    fn a_face_is_seen_through_a_sheet_in_it() {
        const LOOKS: &str = "60 -201 0.2 0 0.7\n61 -201 0.1 0.1 0.8\n61 -203 1.5 1.5 1.5\n\
                             62 -201 0.3 0.5 0\n";
        let around = "9 -501 0.3 4 3 0 -1 -0.8 0 1 0 45\n50 -402 0.8\n50 -1 2 6 3\n51 -401 0.1\n\
                      5 -101 2 3\n6 -101 3 2\n40 12 -5 -3 -5 5 -2.5 5\n";
        let solids = ["2 4 0 1 0 0", "2 12 -2 -1 -2 2 0 2", "2 1 3 0 -1 2 -1 2 0"];
        let sheets = [
            "3 5 -1 -1 1 1\n3 -2 -90 1",
            "3 6 -1 0 1 1 0 1 0 0 -1.4",
            "3 3 0 1 0 0",
            "7 5 -1 -1 1 1\n7 -2 -90 1\n8 9 0.9\n3 -102 7 8",
        ];
        for (solid, look) in solids.iter().flat_map(|s| [(s, "0"), (s, "61"), (s, "62")]) {
            for (sheet, order) in sheets.iter().flat_map(|s| [(s, 5), (s, 6)]) {
                let text = |height: f64| {
                    let sheet = format!("{sheet}\n3 -1 0 {height} 0\n3 -299 0 60\n");
                    let solid = format!("{solid}\n2 -299 0 {look}\n");
                    let union = format!("7{order} -101 {order} 40\n1 9999 7{order} 0\n");
                    [LOOKS, &solid, &sheet, around, &union].concat()
                };
                let [flush, above] = [0.0, 1e-6].map(|height| picture(&text(height), Numbers::F64));
                let fine = picture(&text(0.0), Numbers::Dd);
                // What the face mirrors of the sheet's underside is left out, and from inside the sheet is before the
                // face.
                let most = if look == "0" { 1e-4 } else { 0.01 };
                let differ = |a: &Picture, b: &Picture, most: f32| {
                    let pixels = a.film.pixels.iter().zip(&b.film.pixels);
                    let far = |(a, b): &(&[f32; 3], &[f32; 3])| {
                        (0..3).any(|c| (a[c] - b[c]).abs() > most)
                    };
                    pixels.filter(far).count()
                };
                // The picture is of 768 pixels; some lie on edges, or see many reflections.
                assert!(differ(&flush, &above, most) < 8, "{}", text(0.0));
                assert_eq!(differ(&flush, &fine, 1e-5), 0, "{}", text(0.0));
            }
        }
    }
}

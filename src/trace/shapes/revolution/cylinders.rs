//! A cheap test that recognises most lines that miss the solid, and many that go right through it.

use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::trace::shapes::quick_reject::{Ball, POLYNOMIAL_MARGIN, Pass, is_above};

/// Layers of the same height that the solid is cut into.
const LAYERS: usize = 32;

/// The bounding cylinder of a solid of revolution, and cylinders inscribed in it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cylinders {
    /// The centre of the bounding cylinder and of the ball around that.
    centre: Vec3,
    /// Half of the cylinder's height.
    half: f64,
    /// The radius of the ball, which is the unit of `outer` and `inner`.
    size: f64,
    /// The square of the bounding cylinder's radius.
    outer: f64,
    /// For each layer, from the lowest, the square of the radius up to which all of the layer is in the solid. The
    /// number is 0 for the outermost layers, since the profile begins and ends on the axis there.
    inner: [f64; LAYERS],
}

impl Cylinders {
    /// The cylinders of a solid, from its bounds and its closed profile, whose points are `scale` times as large.
    pub(super) fn new(bounds: &Aabb, points: &[[f64; 2]], scale: f64) -> Cylinders {
        let (radius, half) = (bounds.max[0], 0.5 * (bounds.max[1] - bounds.min[1]));
        let size = (half * half + radius * radius).sqrt();
        let mut cylinders = Cylinders {
            centre: Vec3::ZERO,
            half: 0.0,
            size: 0.0,
            outer: 0.0,
            inner: [0.0; LAYERS],
        };
        // The test says nothing about a solid whose size is zero, overflows or underflows.
        if (size * size).is_normal() && size.is_finite() {
            cylinders.centre = Vec3(bounds.centre());
            (cylinders.half, cylinders.size) = (half, size);
            cylinders.outer = (radius / size).powi(2);
            cylinders.inner = cylinders.layers(points, scale);
        }
        cylinders
    }

    /// The layer that a height above the centre is in.
    fn layer(&self, height: f64) -> usize {
        let share = (height + self.half) / (2.0 * self.half);
        ((share * LAYERS as f64) as usize).min(LAYERS - 1)
    }

    /// For each layer the square of the radius up to which the layer is in the solid; 0 if its part at the axis is
    /// not. Nearer to the axis the profile has no point, so that part of the layer is in the solid if the axis is.
    fn layers(&self, points: &[[f64; 2]], scale: f64) -> [f64; LAYERS] {
        let mut least = [f64::INFINITY; LAYERS];
        let mut inside = [false; LAYERS];
        let thick = 2.0 * self.half / LAYERS as f64;
        let floor = |i: usize| i as f64 * thick - self.half;
        // Heights on a line are known to less than this.
        let margin = POLYNOMIAL_MARGIN * self.size;
        for ends in points.windows(2) {
            let [mut low, mut high] = each([ends[0], ends[1]], |[x, y]| {
                [x / scale, y / scale - self.centre[1]]
            });
            if low[1] > high[1] {
                std::mem::swap(&mut low, &mut high);
            }
            let (width, rise) = (high[0] - low[0], high[1] - low[1]);
            let share = |y: f64, of_flat: f64| match rise > 0.0 {
                true => ((y - low[1]) / rise).clamp(0.0, 1.0),
                false => of_flat,
            };
            for i in self.layer(low[1] - margin)..=self.layer(high[1] + margin) {
                let [from, to] = [floor(i) - margin, floor(i + 1) + margin];
                let ends = each([share(from, 0.0), share(to, 1.0)], |share| {
                    low[0] + share * width
                });
                let nearest = ends[0].min(ends[1]);
                least[i] = least[i].min(nearest);
                let middle = 0.5 * (from + to);
                inside[i] ^= low[1] <= middle && middle < high[1];
            }
        }
        std::array::from_fn(|i| match inside[i] && least[i].is_finite() {
            true => ((least[i] - margin).max(0.0) / self.size).powi(2),
            false => 0.0,
        })
    }

    /// The line is beside the solid if it is outside of the bounding cylinder wherever it is in the cylinder's slab.
    /// It goes through if its place nearest to the axis is inside of an inscribed cylinder.
    pub(super) fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        let approach = match Ball::meets(line, stretch, self.centre, self.size) {
            Ball::Misses => return Pass::Beside,
            Ball::Unknown => return Pass::Perhaps,
            Ball::Meets(approach) => approach,
        };
        let Some([from, to]) = approach.between(1, -self.half, self.half) else {
            return Pass::Beside;
        };
        let unit = self.size * self.size;
        let flat = |v: Vec3, w: Vec3| (v[0] * w[0] + v[2] * w[2]) / unit;
        let (p, d) = (approach.point, approach.direction);
        let [a, b, c] = [flat(d, d), flat(p, d), flat(p, p)];
        if is_above([a, b, c - self.outer], [from, to], POLYNOMIAL_MARGIN) {
            return Pass::Beside;
        }
        let nearest = (-b / a).max(from).min(to);
        approach.through(nearest, POLYNOMIAL_MARGIN, |t| {
            (a * t + 2.0 * b) * t + c - self.inner[self.layer(p[1] + t * d[1])]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::Revolution;
    use super::*;
    use crate::trace::shapes::facet::tests::Random;

    /// A place above or below the solid counts as one in an outermost layer.
    #[test]
    fn the_outermost_layers_hold_no_cylinder() {
        let mut random = Random(19);
        let mut held = 0;
        for case in 0..2000 {
            let profile: Vec<[f64; 2]> = (0..2 + case % 12)
                .map(|_| {
                    let p = random.point(3.0);
                    [p[0].abs(), p[1]]
                })
                .collect();
            let Cylinders { inner, .. } = Revolution::new(&profile, &[]).cylinders;
            assert!(inner[0] == 0.0 && inner[LAYERS - 1] == 0.0, "{profile:?}");
            held += inner.iter().filter(|&&x| x > 0.0).count();
        }
        assert!(held > 10_000, "{held}");
    }

    #[test]
    fn a_solid_without_numbers_says_nothing() {
        for profile in [
            vec![[1.0, 0.0], [1.0, 1.0], [1.0, 0.0]],
            vec![[1e-170, 0.0], [1e-170, 1e-170]],
        ] {
            let solid = Revolution::new(&profile, &[]);
            assert!(solid == solid.clone());
            let line = Line::new(Vec3::new(0.0, 0.5, -5.0), Vec3::new(0.0, 0.0, 1.0));
            let pass = solid.cylinders.pass(&line, [0.0, 10.0]);
            assert_eq!(pass, Pass::Perhaps);
        }
    }
}

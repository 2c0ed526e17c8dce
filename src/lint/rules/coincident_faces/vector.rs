//! The little vector algebra that faces need.

use crate::scene::Vec3;

pub fn add(a: Vec3, b: Vec3, times: f64) -> Vec3 {
    std::array::from_fn(|i| a[i] + b[i] * times)
}

pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    add(a, b, -1.0)
}

pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

pub fn length(a: Vec3) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// The direction of a vector, whatever its length; `None` where it has none.
pub fn unit(a: Vec3) -> Option<Vec3> {
    let l = length(a);
    (l > 0.0 && l.is_finite()).then(|| a.map(|x| x / l))
}

pub fn middle(points: &[Vec3]) -> Vec3 {
    let n = points.len().max(1) as f64;
    points.iter().fold([0.0; 3], |sum, p| add(sum, *p, 1.0 / n))
}

//! Quadric forms whose axes are those of their space, as plain numbers for code that computes with several forms at
//! once.

use super::QuadricForm;
use crate::trace::shapes::Primitive;

/// A polynomial Σ squareᵢ xᵢ² + linearᵢ xᵢ + constant, where xᵢ is a coordinate divided by unitᵢ.
#[derive(Debug, Clone, Copy)]
pub struct Axial {
    pub square: [f64; 3],
    pub linear: [f64; 3],
    pub constant: f64,
    pub unit: [f64; 3],
    /// 1 for axes along which the polynomial curves, 0 for the others.
    pub curves: [f64; 3],
    /// A bound on the sum of the slopes of w²·F(x/w) along the axes, for coordinates and w up to 1; F is the
    /// polynomial.
    pub weight: f64,
    /// The height at which a cone has its base; 0 for shapes that are no cones.
    pub height: f64,
}

impl Axial {
    /// The polynomial of a quadric, an ellipsoid or a single cone. `None` for other shapes, for polynomials with mixed
    /// terms or with terms that may cancel, and where a coordinate occurs in its first power alone.
    pub fn new(primitive: &Primitive) -> Option<Axial> {
        let (form, height) = match primitive {
            Primitive::Quadric(quadric) => (&quadric.form, 0.0),
            Primitive::Ellipsoid(ellipsoid) => (ellipsoid.form(), 0.0),
            Primitive::Cone(cone) => (cone.form(), cone.single_height()?),
            _ => return None,
        };
        let QuadricForm {
            square,
            mixed,
            linear,
            rest,
            constant,
            unit,
            degree,
            weight,
            cancels,
            ..
        } = *form;
        let is_plain = mixed == [0.0; 3] && rest == [[0.0; 3]; 2] && !cancels;
        (is_plain && !degree.contains(&1)).then(|| Axial {
            square,
            linear,
            constant,
            unit,
            curves: degree.map(|n| f64::from(u8::from(n > 0))),
            weight,
            height,
        })
    }
}

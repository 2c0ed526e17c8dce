//! What holds a shape, as a test of many lines at once takes it.

/// A polynomial of points that is negative in a solid or where more than the solid is.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// Negative everywhere.
    Constant,
    /// Of second degree: the coefficients of x², y², z², xy, xz, yz, x, y, z and 1.
    Quadric([f64; 10]),
    /// (|p|² + R² − r²)² − 4R²(x² + z²), with R and r.
    Torus([f64; 2]),
}

/// The points where a polynomial is negative, in the bounds of a shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    pub form: Form,
    /// Whether all these points are in the solid.
    pub is_exact: bool,
}

impl Outline {
    /// The bounds alone.
    pub const BOUNDS: Outline = Outline {
        form: Form::Constant,
        is_exact: false,
    };

    /// In a sphere around the origin.
    pub fn in_sphere(radius: f64) -> Outline {
        let form = Form::Quadric([
            1.0,
            1.0,
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            -radius * radius,
        ]);
        Outline {
            form,
            is_exact: false,
        }
    }
}

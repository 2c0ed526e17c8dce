//! What holds a shape, for tests of several lines at once.

use crate::geometry::vec::Vec3;

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

    /// That of a solid which is all that it holds.
    pub fn exact(form: Form) -> Outline {
        Outline {
            form,
            is_exact: true,
        }
    }

    /// That of a shape which may hold less.
    pub fn around(form: Form) -> Outline {
        Outline {
            form,
            is_exact: false,
        }
    }
}

impl Form {
    /// Negative in a sphere.
    pub fn sphere(centre: Vec3, radius: f64) -> Form {
        let [x, y, z] = (centre * -2.0).0;
        let constant = centre.dot(centre) - radius * radius;
        Form::Quadric([1.0, 1.0, 1.0, 0.0, 0.0, 0.0, x, y, z, constant])
    }
}

//! Simple regions that contain shapes, for tests of several lines at once.

use crate::geometry::vec::Vec3;

/// A polynomial of a point's coordinates that is negative inside a solid, and perhaps in a larger region around it.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// Negative everywhere.
    Constant,
    /// A form of second degree: the coefficients of x², y², z², xy, xz, yz, x, y, z and 1.
    Quadric([f64; 10]),
    /// The torus (|p|² + R² − r²)² − 4R²(x² + z²); the numbers are R and r.
    Torus([f64; 2]),
    /// The solid inside of a profile that is turned about the y axis. No polynomial.
    Profile(Vec<ProfilePoint>),
}

/// An end of a piece of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// The distance from the axis.
    pub radius: f64,
    pub height: f64,
    /// Whether a piece leads here from the point before it in the list.
    pub is_joined: bool,
}

/// A region that contains a shape: the points in the shape's bounds where a polynomial is negative.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    pub form: Form,
    /// Whether all points of the outline are in the solid.
    pub is_exact: bool,
}

impl Outline {
    /// The outline that fills the shape's bounds.
    pub const BOUNDS: Outline = Outline {
        form: Form::Constant,
        is_exact: false,
    };

    /// The outline of a solid that fills it.
    pub fn exact(form: Form) -> Outline {
        Outline {
            form,
            is_exact: true,
        }
    }

    /// An outline that contains the shape and may be larger than it.
    pub fn around(form: Form) -> Outline {
        Outline {
            form,
            is_exact: false,
        }
    }
}

impl Form {
    /// The form that is negative inside a sphere.
    pub fn sphere(centre: Vec3, radius: f64) -> Form {
        let [x, y, z] = (centre * -2.0).0;
        let constant = centre.dot(centre) - radius * radius;
        Form::Quadric([1.0, 1.0, 1.0, 0.0, 0.0, 0.0, x, y, z, constant])
    }
}

//! The solids that a ray starts in, as far as they are known: what it meets next says then by itself what is before
//! and behind it.

/// A solid of the scene's union: a shape, or an intersection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// A number for its surface; see [`Walker::surface`](super::search::walk::Walker::surface).
    pub surface: u64,
    /// The operand of the scene's union that it is, or that it is a part of.
    pub operand: u32,
    pub medium: Medium,
}

/// What light notices of a solid: the numbers of its optics and of its refractive index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    pub optics: u32,
    pub index: u32,
}

/// The solids around a place: none, or few, or nobody knows. Of two the earlier operand, which owns the place, is first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Within {
    Unknown,
    Outside,
    One(Solid),
    Two([Solid; 2]),
}

impl Within {
    fn solids(&self) -> &[Solid] {
        match self {
            Within::Unknown | Within::Outside => &[],
            Within::One(solid) => std::slice::from_ref(solid),
            Within::Two(solids) => solids,
        }
    }

    /// The medium of the solid that owns the place, if the place is in any.
    #[inline]
    pub fn medium(&self) -> Option<Medium> {
        self.solids().first().map(|solid| solid.medium)
    }

    /// Whether the place is in the solid with this surface.
    #[inline]
    pub fn is_in(&self, surface: u64) -> bool {
        self.solids().iter().any(|solid| solid.surface == surface)
    }

    /// Around a place in one solid more.
    #[inline]
    pub fn with(self, new: Solid) -> Within {
        match self {
            Within::Outside => Within::One(new),
            Within::One(old) if old.operand < new.operand => Within::Two([old, new]),
            Within::One(old) if old.operand > new.operand => Within::Two([new, old]),
            // Which of two within one operand owns the place is written in there.
            Within::One(_) | Within::Two(_) | Within::Unknown => Within::Unknown,
        }
    }

    /// Around a place out of the solid with this surface.
    #[inline]
    pub fn without(self, surface: u64) -> Within {
        match self {
            Within::One(solid) if solid.surface == surface => Within::Outside,
            Within::Two([a, b]) if a.surface == surface => Within::One(b),
            Within::Two([a, b]) if b.surface == surface => Within::One(a),
            as_before => as_before,
        }
    }
}

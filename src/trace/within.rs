//! The solids that a ray starts in, where they are known. With them, the next crossing alone says which media are before
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

/// The properties of a solid that light notices: the numbers of its optics and of its refractive index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    pub optics: u32,
    pub index: u32,
}

/// The solids around a place: none, one, two, or not known. Of two the earlier operand, which owns the place, is first.
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

    /// The medium of the solid that owns the place, if the place is known to be in any.
    #[inline]
    pub fn medium(&self) -> Option<Medium> {
        self.solids().first().map(|solid| solid.medium)
    }

    /// The operand of the solid that owns the place, if the place is known to be in any.
    #[inline]
    pub fn operand(&self) -> Option<u32> {
        self.solids().first().map(|solid| solid.operand)
    }

    /// The solid with this surface, if the place is known to be in it.
    #[inline]
    pub fn solid(&self, surface: u64) -> Option<&Solid> {
        self.solids().iter().find(|solid| solid.surface == surface)
    }

    /// The solids around a place that is also in `new`.
    #[inline]
    pub fn with(self, new: Solid) -> Within {
        match self {
            Within::Outside => Within::One(new),
            Within::One(old) if old.operand < new.operand => Within::Two([old, new]),
            Within::One(old) if old.operand > new.operand => Within::Two([new, old]),
            // Of two solids in one operand, their order in there decides, which is not looked up here.
            Within::One(_) | Within::Two(_) | Within::Unknown => Within::Unknown,
        }
    }

    /// The same without the solid with this surface, if it is among them.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_solids_are_known_and_no_third() {
        let solid = |operand: u32| Solid {
            surface: u64::from(operand) + 100,
            operand,
            medium: Medium {
                optics: operand,
                index: 7,
            },
        };
        let [a, b, c] = [1, 2, 3].map(solid);
        // The earlier operand owns the place, whichever comes first.
        for both in [Within::One(a).with(b), Within::One(b).with(a)] {
            assert_eq!(both, Within::Two([a, b]));
            assert_eq!(both.medium(), Some(a.medium));
            assert!(both.solid(b.surface) == Some(&b) && both.solid(c.surface).is_none());
            assert_eq!(both.without(a.surface), Within::One(b));
            assert_eq!(both.without(b.surface), Within::One(a));
            assert_eq!(both.without(c.surface), both);
            assert_eq!(both.with(c), Within::Unknown);
        }
        assert_eq!(Within::Outside.with(a), Within::One(a));
        assert_eq!(Within::One(a).without(a.surface), Within::Outside);
        assert_eq!(Within::Unknown.without(a.surface), Within::Unknown);
        // Two parts of one operand.
        let other = Solid { surface: 9, ..a };
        assert_eq!(Within::One(a).with(other), Within::Unknown);
    }
}

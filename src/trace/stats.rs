//! Counts of the work that rendering has taken.

use serde::Serialize;
use std::ops::AddAssign;

/// The number of rays that were traced, by their purpose. A ray that goes straight on through a surface counts as
/// refraction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Rays {
    pub camera: u64,
    pub shadow: u64,
    pub reflection: u64,
    pub refraction: u64,
    /// How often light was totally reflected; the rays are among `reflection`, too.
    #[serde(skip)]
    pub total: u64,
}

/// Intersection tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Intersections {
    /// Tests with boxes of trees, by single rays and by bundles of rays.
    #[serde(rename = "box")]
    pub boxes: u64,
    pub shape: u64,
}

/// How often the work of each effect was done; 0 for an effect that is off.
macro_rules! work {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
        pub struct Work {
            $($(#[$doc])* pub $name: u64,)*
        }

        impl AddAssign for Work {
            fn add_assign(&mut self, other: Work) {
                $(self.$name += other.$name;)*
            }
        }
    };
}

work! {
    /// Shadow rays.
    shadow,
    /// Shadow rays that have listed the surfaces on their way, since something transparent was near.
    transparent_shadow,
    /// Mirrored rays.
    reflection,
    /// Rays that go on through a surface.
    refraction,
    /// Rays that go on in some of the colour channels only, since dispersion parts the channels.
    channel_split,
    /// Surface coordinates for a texture.
    uv,
    /// Colours looked up in image files.
    image_texture,
    /// Colours from solid textures.
    solid_texture,
    /// Colours from checkerboards.
    checkerboard,
    /// Colours along a profile.
    vertex_colour,
    /// Shading normals that a shape has of its own.
    smooth_normal,
    /// Lists of crossings that an intersection or a difference has merged.
    csg_merge,
    /// Rays cut to the region that is drawn.
    clip,
    /// How often light met a transparent surface with different refractive indices before and behind it.
    medium_change,
}

/// All counters of one picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Counts {
    pub rays: Rays,
    pub intersections: Intersections,
    pub work: Work,
    /// Rays with a decision that was closer than its rounding errors. In doubles, these rays were traced again in
    /// double-double.
    pub uncertain: u64,
    /// Pixels that the quick kernel has drawn alone.
    pub quick: u64,
}

/// The cost of the samples of one pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Intersection tests.
    pub tests: u32,
    /// Whether the samples saw totally reflected light.
    pub total_reflection: bool,
    /// Samples that the quick kernel has not drawn alone.
    pub slow: u32,
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Cost) {
        self.tests = self.tests.saturating_add(other.tests);
        self.total_reflection |= other.total_reflection;
        self.slow += other.slow;
    }
}

impl AddAssign for Intersections {
    fn add_assign(&mut self, other: Intersections) {
        self.boxes += other.boxes;
        self.shape += other.shape;
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Counts) {
        self.rays.camera += other.rays.camera;
        self.rays.shadow += other.rays.shadow;
        self.rays.reflection += other.rays.reflection;
        self.rays.refraction += other.rays.refraction;
        self.rays.total += other.rays.total;
        self.intersections += other.intersections;
        self.work += other.work;
        self.uncertain += other.uncertain;
        self.quick += other.quick;
    }
}

/// The least and the most samples of a pixel, and the sum over all pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Samples {
    pub min: u32,
    pub max: u32,
    /// The samples of all pixels.
    pub total: u64,
}

impl Samples {
    /// The samples of no pixel.
    pub const NONE: Samples = Samples {
        min: u32::MAX,
        max: 0,
        total: 0,
    };

    /// The samples of one pixel.
    pub fn of(samples: u32) -> Samples {
        Samples {
            min: samples,
            max: samples,
            total: u64::from(samples),
        }
    }

    pub fn add(&mut self, others: Samples) {
        self.min = self.min.min(others.min);
        self.max = self.max.max(others.max);
        self.total += others.total;
    }
}

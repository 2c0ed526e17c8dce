//! The texts of plans about effects: names, costs, and reasons for being off.

use super::Effect;

impl Effect {
    pub fn name(self) -> &'static str {
        self.texts()[0]
    }

    /// The text about the cost of the effect, for a plan that has it on.
    pub fn cost(self) -> &'static str {
        self.texts()[1]
    }

    /// The text about the reason why the effect is off, for a plan that has it off.
    pub fn absence(self) -> &'static str {
        self.texts()[2]
    }

    fn texts(self) -> [&'static str; 3] {
        match self {
            Effect::Ambient => [
                "ambient",
                "one addition at each diffuse point",
                "no ambient light, or nothing diffuse to be lit",
            ],
            Effect::Diffuse => [
                "diffuse",
                "a cosine for each light at each diffuse point",
                "no point light that shines, or nothing diffuse to be lit",
            ],
            Effect::Shadows => [
                "shadows",
                "a ray to each light that a diffuse point faces",
                "no diffuse light, or a lone convex shape that nothing can be in the way of",
            ],
            Effect::TransparentShadows => [
                "transparent-shadows",
                "shadow rays that meet something transparent list all surfaces on their way",
                "no shadows, or nothing that lets light through",
            ],
            Effect::Reflection => [
                "reflection",
                "a ray at each mirroring or totally reflecting point",
                "nothing mirrors, and no medium can reflect light totally",
            ],
            Effect::Refraction => [
                "refraction",
                "a ray at each transparent point, and the media on both sides",
                "nothing lets light through: kt is 0 wherever it shows",
            ],
            Effect::Dispersion => [
                "dispersion",
                "up to three rays at points where the indices differ",
                "nothing transparent, or one index for all channels",
            ],
            Effect::ImageTexture => [
                "image-texture",
                "surface coordinates and a pixel at each diffuse point that has one",
                "no image texture shows",
            ],
            Effect::SolidTexture => [
                "solid-texture",
                "the point in the painted object's space at each diffuse point that has one",
                "no solid texture shows",
            ],
            Effect::Checkerboard => [
                "checkerboard",
                "surface coordinates at each diffuse point that has one",
                "no checkerboard shows",
            ],
            Effect::VertexColour => [
                "vertex-colour",
                "a colour from the shape itself at each diffuse point that has one",
                "no shape shows colours of its own",
            ],
            Effect::SmoothNormals => [
                "smooth-normals",
                "a second normal at each point that has one",
                "no shape that shows has normals of its own",
            ],
            Effect::Csg => [
                "csg",
                "lists of crossings for rays that come near",
                "unions only: the nearest crossing is enough",
            ],
            Effect::Unbounded => [
                "unbounded",
                "a test for every ray, since no box can spare it",
                "everything has bounds",
            ],
            Effect::ClipBox => [
                "clip-box",
                "every ray is cut to the region, and may start inside of solids",
                "no region to be drawn, or all of the scene lies in it",
            ],
            Effect::Stereo => ["stereo", "two pictures", "one picture"],
            Effect::ProjectionMatrix => [
                "projection-matrix",
                "two points through the inverse matrix for each camera ray",
                "the camera has a field of view",
            ],
        }
    }
}

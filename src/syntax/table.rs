//! **The** table of record types.
//!
//! One entry is one type of record: its number, its names, what it defines or changes, and its
//! parameters. The parser, the resolver's first checks, the formatter, `zpg explain`, the EBNF and
//! the tables of the language reference all read this table or are tested against it. Adding a
//! shape starts here.

use std::sync::OnceLock;

/// The kind of value that an ID stands for. The resolver gives one to every entity; a reference accepts some of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Declared with type 0 and not defined yet.
    Undefined,
    /// A shape or the result of an operation.
    Object,
    Optics,
    Texture,
    Colour,
    AmbientLight,
    PointLight,
    Camera,
    /// A mono or stereo camera selection.
    Selection,
    Render,
}

impl Kind {
    /// The name for people: "object", "colour"; there is but one render record.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Undefined => "undefined object",
            Kind::Object => "object",
            Kind::Optics => "optical property",
            Kind::Texture => "texture",
            Kind::Colour => "colour",
            Kind::AmbientLight => "ambient light",
            Kind::PointLight => "point light",
            Kind::Camera => "camera",
            Kind::Selection => "camera selection",
            Kind::Render => "the render record",
        }
    }
}

/// The families of the handout, in its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Family {
    Void,
    Shape,
    Transformation,
    Operation,
    Property,
    Texture,
    Light,
    Camera,
    Bound,
    Colour,
    Render,
}

impl Family {
    /// All families, in the order of the reference.
    pub const ALL: [Family; 11] = [
        Family::Void,
        Family::Shape,
        Family::Transformation,
        Family::Operation,
        Family::Property,
        Family::Texture,
        Family::Light,
        Family::Camera,
        Family::Bound,
        Family::Colour,
        Family::Render,
    ];

    pub fn title(self) -> &'static str {
        match self {
            Family::Void => "Void",
            Family::Shape => "Shapes",
            Family::Transformation => "Transformations",
            Family::Operation => "Operations",
            Family::Property => "Properties",
            Family::Texture => "Textures",
            Family::Light => "Lights",
            Family::Camera => "Cameras",
            Family::Bound => "Bounding volumes",
            Family::Colour => "Colour",
            Family::Render => "Rendering",
        }
    }
}

/// The effect of a record on its ID.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// Defines a new entity; an ID that exists already is E102.
    Defines(Kind),
    /// Changes an entity that must exist and be of one of these kinds.
    Changes(&'static [Kind]),
    /// Changes an entity of one of these kinds, or defines a new one of the first kind given.
    DefinesOrChanges(Kind, &'static [Kind]),
}

/// The kind of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParamKind {
    Real,
    Integer,
    /// An integer that says how often the repeated groups follow.
    Count,
    /// The ID of an entity of one of these kinds; with `or_none`, 0 means "none".
    Reference {
        kinds: &'static [Kind],
        or_none: bool,
    },
    /// A word without white space, or a quoted string.
    FileName,
}

/// The unit a number is read in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    None,
    /// A length in scene units.
    Length,
    Degrees,
    /// A share in [0, 1].
    Share,
}

/// The constraint on one value alone. The resolver checks the rules over several parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Constraint {
    Any,
    /// Greater than zero, else E201.
    Positive,
    /// A number of at least zero, else E208 (a profile's radius).
    ProfileRadius,
    /// A number other than zero, else E204 (a scale).
    NonZeroScale,
    /// Strictly between the two, else E206.
    Between(f64, f64),
    /// A number between the two, ends included, else E206.
    Within(f64, f64),
    /// A number of at least this value, else E206.
    AtLeast(f64),
    /// 1, 2 or 3, else E205.
    Axis,
}

/// A parameter of a record type.
#[derive(Debug, Clone, Copy)]
pub struct Param {
    /// Short name, as it stands in signatures: `x`, `radius`.
    pub name: &'static str,
    pub kind: ParamKind,
    pub unit: Unit,
    pub constraint: Constraint,
    /// The value of an absent optional parameter, spelled as in a scene.
    pub default: Option<&'static str>,
    /// The meaning of the parameter, for messages and help: "the tube's radius".
    pub doc: &'static str,
}

/// A type of record.
#[derive(Debug)]
pub struct RecordType {
    /// The kind of the record, as the rest of the toolchain calls it.
    pub kind: RecordKind,
    /// The number that stands in the scene.
    pub code: i32,
    /// Keyword of lower-case words with hyphens, unique: `surface-of-revolution`.
    pub keyword: &'static str,
    /// The title for people: "surface of revolution".
    pub title: &'static str,
    pub family: Family,
    pub effect: Effect,
    /// Parameters that are always there.
    pub params: &'static [Param],
    /// Groups that follow, each repeated as often as the [`ParamKind::Count`] parameter says.
    pub repeats: &'static [&'static [Param]],
    /// Parameters that are all there or all absent.
    pub optional: &'static [Param],
    /// The lengths of the vectors into which the parameters are grouped, in order, the optional ones last. Empty where
    /// all parameters are one vector, or where they are repeated.
    pub vectors: &'static [usize],
    /// The meaning of the record, in a sentence or two.
    pub summary: &'static str,
    /// The text of a correct record of this type.
    pub example: &'static str,
}

impl RecordType {
    const fn of_vectors(self, vectors: &'static [usize]) -> RecordType {
        RecordType { vectors, ..self }
    }

    const fn of_kind(self, kind: RecordKind) -> RecordType {
        RecordType { kind, ..self }
    }

    /// The entry of a kind.
    #[inline]
    pub fn of(kind: RecordKind) -> &'static RecordType {
        &RECORD_TYPES[kind.place()]
    }

    /// The entry for a type number, if there is one.
    #[inline]
    pub fn by_code(code: i64) -> Option<&'static RecordType> {
        // The least code, and the entries by code from that one on.
        static INDEX: OnceLock<(i64, Vec<Option<&'static RecordType>>)> = OnceLock::new();
        let (least, index) = INDEX.get_or_init(|| {
            let codes = || RECORD_TYPES.iter().map(|t| i64::from(t.code));
            let (least, most) = (codes().min().unwrap_or(0), codes().max().unwrap_or(0));
            let mut index = vec![None; (most - least) as usize + 1];
            for (code, ty) in codes().zip(RECORD_TYPES) {
                index[(code - least) as usize] = Some(ty);
            }
            (least, index)
        });
        *index.get(usize::try_from(code.checked_sub(*least)?).ok()?)?
    }

    /// The entry with this keyword.
    pub fn by_keyword(keyword: &str) -> Option<&'static RecordType> {
        RECORD_TYPES.iter().find(|t| t.keyword == keyword)
    }

    /// Whether the record gives optics: parts of light or a refractive index.
    pub fn gives_optics(&self) -> bool {
        matches!(self.effect, Effect::DefinesOrChanges(Kind::Optics, _))
    }

    /// The positions of the parameters that say how much light goes through: every third one of optics. Empty for other
    /// types.
    pub fn transmitted(&self) -> impl Iterator<Item = usize> {
        let count = match self.kind {
            RecordKind::Optics | RecordKind::OpticsRgb => self.params.len(),
            _ => 0,
        };
        (2..count).step_by(3)
    }

    /// Whether the record's length depends on a count.
    pub fn is_counted(&self) -> bool {
        !self.repeats.is_empty()
    }

    /// The number of parameters without the optional group; `count` is the value of the count
    /// parameter where there is one.
    pub fn arity(&self, count: u64) -> u64 {
        let per: u64 = self.repeats.iter().map(|g| g.len() as u64).sum();
        (self.params.len() as u64).saturating_add(per.saturating_mul(count))
    }

    /// The value of the count parameter of a record with `params` parameters; 0 for a type without a count.
    pub fn count(&self, params: usize) -> usize {
        let per: usize = self.repeats.iter().map(|g| g.len()).sum();
        params
            .saturating_sub(self.params.len())
            .checked_div(per)
            .unwrap_or(0)
    }

    /// The parameter that stands at position `i` of a record with the given count.
    pub fn param(&self, i: usize, count: usize) -> Option<&'static Param> {
        let mut i = i;
        if i < self.params.len() {
            return Some(&self.params[i]);
        }
        i -= self.params.len();
        for group in self.repeats {
            let n = group.len().saturating_mul(count);
            if i < n {
                return Some(&group[i % group.len()]);
            }
            i -= n;
        }
        self.optional.get(i)
    }

    /// The position of the first red part among the parameters of a record with the given count. All parameters from
    /// there on are colours. `None` for a type without colours.
    pub fn first_colour(&self, count: usize) -> Option<usize> {
        let is_red = |p: &Param| p.name == RGB[0].name && p.doc == RGB[0].doc;
        if let Some(i) = self.params.iter().position(is_red) {
            return Some(i);
        }
        let group = self
            .repeats
            .iter()
            .position(|g| g.first().is_some_and(is_red))?;
        let before = self.repeats[..group].iter().map(|g| g.len());
        Some(self.params.len() + count * before.sum::<usize>())
    }

    /// The parameters as a reader sees them: `x y z radius`, `N (x y)×N`, `[a b]`.
    pub fn signature(&self) -> String {
        let mut out = String::new();
        let mut push = |s: &str| {
            if !out.is_empty() {
                out.push(' ');
            }
            out.push_str(s);
        };
        for p in self.params {
            push(p.name);
        }
        for group in self.repeats {
            let names: Vec<_> = group.iter().map(|p| p.name).collect();
            push(&format!("({})×N", names.join(" ")));
        }
        if !self.optional.is_empty() {
            let names: Vec<_> = self.optional.iter().map(|p| p.name).collect();
            push(&format!("[{}]", names.join(" ")));
        }
        out
    }
}

const OBJECT: &[Kind] = &[Kind::Object];
const COLOUR: &[Kind] = &[Kind::Colour];
const CAMERA: &[Kind] = &[Kind::Camera];
const OPTICS: &[Kind] = &[Kind::Optics];
const SURFACE_LOOK: &[Kind] = &[Kind::Texture, Kind::Colour];
const ANYTHING: &[Kind] = &[
    Kind::Object,
    Kind::Optics,
    Kind::Texture,
    Kind::Colour,
    Kind::AmbientLight,
    Kind::PointLight,
    Kind::Camera,
];
const MOVABLE: &[Kind] = &[Kind::Object, Kind::PointLight, Kind::Camera];

const fn real(name: &'static str, doc: &'static str) -> Param {
    Param {
        name,
        kind: ParamKind::Real,
        unit: Unit::None,
        constraint: Constraint::Any,
        default: None,
        doc,
    }
}

const fn length(name: &'static str, doc: &'static str) -> Param {
    Param {
        unit: Unit::Length,
        ..real(name, doc)
    }
}

const fn positive(name: &'static str, doc: &'static str) -> Param {
    Param {
        constraint: Constraint::Positive,
        ..length(name, doc)
    }
}

const fn share(name: &'static str, doc: &'static str) -> Param {
    Param {
        unit: Unit::Share,
        constraint: Constraint::Within(0.0, 1.0),
        ..real(name, doc)
    }
}

const fn integer(name: &'static str, constraint: Constraint, doc: &'static str) -> Param {
    Param {
        kind: ParamKind::Integer,
        constraint,
        ..real(name, doc)
    }
}

const fn reference(name: &'static str, kinds: &'static [Kind], doc: &'static str) -> Param {
    Param {
        kind: ParamKind::Reference {
            kinds,
            or_none: false,
        },
        ..real(name, doc)
    }
}

const fn reference_or_none(name: &'static str, kinds: &'static [Kind], doc: &'static str) -> Param {
    Param {
        kind: ParamKind::Reference {
            kinds,
            or_none: true,
        },
        ..real(name, doc)
    }
}

const fn or_default(param: Param, default: &'static str) -> Param {
    Param {
        default: Some(default),
        ..param
    }
}

const COUNT: Param = Param {
    kind: ParamKind::Count,
    constraint: Constraint::AtLeast(2.0),
    ..real("N", "the number of profile points")
};
const PROFILE: &[Param] = &[
    Param {
        constraint: Constraint::ProfileRadius,
        ..length("x", "a profile point's distance from the axis")
    },
    length("y", "a profile point's height"),
];
const RGB: &[Param] = &[
    real("r", "the red part"),
    real("g", "the green part"),
    real("b", "the blue part"),
];
const PLANE: &[Param] = &[
    real("a", "the normal's x"),
    real("b", "the normal's y"),
    real("c", "the normal's z"),
    length("d", "the constant term"),
];

macro_rules! point {
    ($x:literal, $y:literal, $z:literal, $of:literal) => {
        [
            length($x, concat!($of, "'s x")),
            length($y, concat!($of, "'s y")),
            length($z, concat!($of, "'s z")),
        ]
    };
}

/// Joins `G` arrays of three parameters each into one array of `N`, for a constant.
const fn join<const G: usize, const N: usize>(groups: [[Param; 3]; G]) -> [Param; N] {
    assert!(G * 3 == N);
    let mut out = [groups[0][0]; N];
    let mut i = 0;
    while i < N {
        out[i] = groups[i / 3][i % 3];
        i += 1;
    }
    out
}

const V1: [Param; 3] = point!("x1", "y1", "z1", "the first vertex");
const V2: [Param; 3] = point!("x2", "y2", "z2", "the second vertex");
const V3: [Param; 3] = point!("x3", "y3", "z3", "the third vertex");
const N1: [Param; 3] = [
    real("nx1", "the first normal's x"),
    real("ny1", "the first normal's y"),
    real("nz1", "the first normal's z"),
];
const N2: [Param; 3] = [
    real("nx2", "the second normal's x"),
    real("ny2", "the second normal's y"),
    real("nz2", "the second normal's z"),
];
const N3: [Param; 3] = [
    real("nx3", "the third normal's x"),
    real("ny3", "the third normal's y"),
    real("nz3", "the third normal's z"),
];
const N: [Param; 3] = [
    real("nx", "the normal's x"),
    real("ny", "the normal's y"),
    real("nz", "the normal's z"),
];
const MIN: [Param; 3] = point!("xmin", "ymin", "zmin", "the lower corner");
const MAX: [Param; 3] = point!("xmax", "ymax", "zmax", "the upper corner");
const TRIANGLE: [Param; 9] = join([V1, V2, V3]);
const TRIANGLE_NORMAL: [Param; 12] = join([V1, V2, V3, N]);
const TRIANGLE_NORMALS: [Param; 18] = join([V1, V2, V3, N1, N2, N3]);
const CORNERS: [Param; 6] = join([MIN, MAX]);
const SPHERE: [Param; 4] = [
    length("x", "the centre's x"),
    length("y", "the centre's y"),
    length("z", "the centre's z"),
    positive("r", "the radius"),
];
const OPTICS_RGB: [Param; 9] = [
    share("kdR", "the diffuse part in red"),
    share("ksR", "the mirrored part in red"),
    share("ktR", "the transmitted part in red"),
    share("kdG", "the diffuse part in green"),
    share("ksG", "the mirrored part in green"),
    share("ktG", "the transmitted part in green"),
    share("kdB", "the diffuse part in blue"),
    share("ksB", "the mirrored part in blue"),
    share("ktB", "the transmitted part in blue"),
];
const MATRIX: [Param; 16] = [
    real("m11", "row 1, column 1"),
    real("m12", "row 1, column 2"),
    real("m13", "row 1, column 3"),
    real("m14", "row 1, column 4"),
    real("m21", "row 2, column 1"),
    real("m22", "row 2, column 2"),
    real("m23", "row 2, column 3"),
    real("m24", "row 2, column 4"),
    real("m31", "row 3, column 1"),
    real("m32", "row 3, column 2"),
    real("m33", "row 3, column 3"),
    real("m34", "row 3, column 4"),
    real("m41", "row 4, column 1"),
    real("m42", "row 4, column 2"),
    real("m43", "row 4, column 3"),
    real("m44", "row 4, column 4"),
];
const CAMERA_PARAMS: [Param; 10] = [
    length("x", "the camera's x"),
    length("y", "the camera's y"),
    length("z", "the camera's z"),
    real("dx", "the view direction's x"),
    real("dy", "the view direction's y"),
    real("dz", "the view direction's z"),
    real("ux", "the up vector's x"),
    real("uy", "the up vector's y"),
    real("uz", "the up vector's z"),
    Param {
        unit: Unit::Degrees,
        constraint: Constraint::Between(0.0, 180.0),
        ..real("fovy", "the vertical field of view")
    },
];
const CONE: &[Param] = &[
    length("h", "the height of the base disc, with its sign"),
    positive("r", "the base disc's radius"),
];
const DOUBLE_CONE: &[Param] = &[
    positive("h", "the height of the upper base disc"),
    positive("r", "the base discs' radius"),
];
const TWO_OBJECTS: &[Param] = &[
    reference("B", OBJECT, "the first operand"),
    reference("C", OBJECT, "the second operand"),
];

const fn shape(
    code: i32,
    keyword: &'static str,
    title: &'static str,
    params: &'static [Param],
    summary: &'static str,
    example: &'static str,
) -> RecordType {
    RecordType {
        // The macro `record_types` replaces this kind by the entry's own.
        kind: RecordKind::Undefined,
        code,
        keyword,
        title,
        family: Family::Shape,
        effect: Effect::Defines(Kind::Object),
        params,
        repeats: &[],
        optional: &[],
        vectors: &[],
        summary,
        example,
    }
}

const fn record(
    code: i32,
    [keyword, title]: [&'static str; 2],
    family: Family,
    effect: Effect,
    params: &'static [Param],
    summary: &'static str,
    example: &'static str,
) -> RecordType {
    RecordType {
        // The macro `record_types` replaces this kind by the entry's own.
        kind: RecordKind::Undefined,
        code,
        keyword,
        title,
        family,
        effect,
        params,
        repeats: &[],
        optional: &[],
        vectors: &[],
        summary,
        example,
    }
}

const PROPERTY: Effect = Effect::DefinesOrChanges(Kind::Optics, &[Kind::Optics, Kind::Object]);
const TEXTURE: Effect = Effect::DefinesOrChanges(Kind::Texture, &[Kind::Texture, Kind::Object]);

/// Makes from the table one kind of record for each entry, and the list of the entries with their kinds.
macro_rules! record_types {
    (
        void { $void:ident: $void_entry:expr, }
        shapes { $($shape:ident: $shape_entry:expr,)* }
        others { $($other:ident: $other_entry:expr,)* }
    ) => {
        /// The shapes of the language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum ShapeKind { $($shape),* }

        /// The types of records of the language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum RecordKind { $void, Shape(ShapeKind), $($other),* }

        impl RecordKind {
            /// Index of the entry in the table.
            pub(super) fn place(self) -> usize {
                enum Place { $void, $($shape,)* $($other),* }
                let place = match self {
                    RecordKind::$void => Place::$void,
                    $(RecordKind::Shape(ShapeKind::$shape) => Place::$shape,)*
                    $(RecordKind::$other => Place::$other,)*
                };
                place as usize
            }
        }

        /// Every record type of the language, in the order of the reference.
        pub static RECORD_TYPES: &[RecordType] = &[
            $void_entry.of_kind(RecordKind::$void),
            $($shape_entry.of_kind(RecordKind::Shape(ShapeKind::$shape)),)*
            $($other_entry.of_kind(RecordKind::$other),)*
        ];
    };
}

record_types! {
    void {
        Undefined: record(
            0,
            ["undefined", "undefined object"],
            Family::Void,
            Effect::Defines(Kind::Undefined),
            &[],
            "`ID 0` declares an object that may be defined once, later. A lone `0` in the place of an \
             ID is the VOID record, which introduces a stand-alone comment.",
            "7 0",
        ),
    }
    shapes {
        SurfaceOfRevolution: RecordType {
            repeats: &[PROFILE],
            ..shape(
                1,
                "surface-of-revolution",
                "surface of revolution",
                &[COUNT],
                "Solid: the polyline of N profile points turned about the y axis; x is the distance from \
                 the axis. Ends off the axis are closed by flat discs, unless the last point is the \
                 first (a ring). The inside follows the even-odd rule of the closed profile. A cylinder of \
                 radius r and height h is `ID 1 2 r 0 r h`.",
                "2 1 4  0 2  1 1  1 0  0 0",
            )
        },
        ColouredSurfaceOfRevolution: RecordType {
            repeats: &[PROFILE, RGB],
            ..shape(
                2,
                "coloured-surface-of-revolution",
                "coloured surface of revolution",
                &[COUNT],
                "As type 1, with a colour for each profile point; between points the colour is linear.",
                "2 2 2  0 1  1 0  1 0 0  0 0 1",
            )
        },
        Plane: shape(
            3,
            "plane",
            "plane",
            PLANE,
            "Surface: all points with ax + by + cz + d = 0. It has no inside and no orientation.",
            "2 3  0 1 0  0",
        )
        .of_vectors(&[3, 1]),
        HalfSpace: shape(
            4,
            "half-space",
            "half-space",
            PLANE,
            "Solid: all points with ax + by + cz + d ≤ 0.",
            "2 4  0 1 0  0",
        )
        .of_vectors(&[3, 1]),
        Rectangle: shape(
            5,
            "rectangle",
            "rectangle",
            &[
                length("xmin", "the left edge"),
                length("ymin", "the lower edge"),
                length("xmax", "the right edge"),
                length("ymax", "the upper edge"),
            ],
            "Surface: the axis-aligned rectangle in the plane z = 0.",
            "2 5  -1 -1  1 1",
        )
        .of_vectors(&[2, 2]),
        Triangle: shape(
            6,
            "triangle",
            "triangle",
            &TRIANGLE,
            "Surface: a flat triangle.",
            "2 6  0 0 0  1 0 0  0 1 0",
        )
        .of_vectors(&[3, 3, 3]),
        TriangleWithNormal: shape(
            7,
            "triangle-with-normal",
            "triangle with a normal",
            &TRIANGLE_NORMAL,
            "Surface: a triangle with one shading normal for all of it.",
            "2 7  0 0 0  1 0 0  0 1 0  0 0 1",
        )
        .of_vectors(&[3, 3, 3, 3]),
        TriangleWithVertexNormals: shape(
            8,
            "triangle-with-vertex-normals",
            "triangle with vertex normals",
            &TRIANGLE_NORMALS,
            "Surface: a triangle with a shading normal at each vertex, interpolated and renormalised.",
            "2 8  0 0 0  1 0 0  0 1 0  0 0 1  0 0 1  0 0 1",
        )
        .of_vectors(&[3, 3, 3, 3, 3, 3]),
        SphereAtOrigin: shape(
            9,
            "sphere-at-origin",
            "sphere at the origin",
            &[positive("r", "the radius")],
            "Solid: the ball of this radius around the origin.",
            "2 9 10",
        ),
        Ellipsoid: shape(
            10,
            "ellipsoid",
            "ellipsoid",
            &[
                positive("a", "the semi-axis along x"),
                positive("b", "the semi-axis along y"),
                positive("c", "the semi-axis along z"),
            ],
            "Solid: the axis-aligned ellipsoid around the origin.",
            "2 10 1 2 3",
        ),
        Sphere: shape(
            11,
            "sphere",
            "sphere",
            &SPHERE,
            "Solid: the ball with this centre and radius.",
            "2 11  0 10 0  10",
        )
        .of_vectors(&[3, 1]),
        Box: shape(
            12,
            "box",
            "box",
            &CORNERS,
            "Solid: the axis-aligned box between two corners.",
            "2 12  -1 -1 -1  1 1 1",
        )
        .of_vectors(&[3, 3]),
        GeodesicSphere: shape(
            13,
            "geodesic-sphere",
            "geodesic sphere",
            &[
                positive("r", "the radius"),
                integer(
                    "n",
                    Constraint::Within(0.0, 9.0),
                    "the number of splits of the facets",
                ),
            ],
            "Solid: an icosahedron with the vertices (0, ±1, ±φ) and their cyclic permutations, \
             every facet split into four n times, new vertices pushed out to the sphere: 20·4ⁿ flat facets.",
            "2 13 1 3",
        ),
        Torus: shape(
            14,
            "torus",
            "torus",
            &[
                positive("R", "the distance from the centre to the tube's centre"),
                positive("r", "the tube's radius"),
            ],
            "Solid: a torus around the y axis. A tube wider than R is allowed; the inside follows the even-odd rule.",
            "2 14 1 0.25",
        ),
        Quadric: shape(
            15,
            "quadric",
            "quadric",
            &MATRIX,
            "Solid: all points with xᵀQx ≤ 0, where x = (x, y, z, 1). Only the symmetric part of Q counts.",
            "2 15  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 -1",
        )
        .of_vectors(&[4, 4, 4, 4]),
        Cone: shape(
            16,
            "cone",
            "cone",
            CONE,
            "Solid: apex at the origin, axis y, base disc of radius r at y = h.",
            "2 16 2 1",
        ),
        DoubleCone: shape(
            17,
            "double-cone",
            "double cone",
            DOUBLE_CONE,
            "Solid: two cones that share the apex at the origin, base discs of radius r at y = ±h.",
            "2 17 2 1",
        ),
        ParabolicCylinder: RecordType {
            optional: &[or_default(positive("a", "the half width at y = 1"), "1")],
            ..shape(
                18,
                "parabolic-cylinder",
                "parabolic cylinder",
                &[],
                "Solid: (x/a)² − y ≤ 0, along z.",
                "2 18",
            )
        },
        HyperbolicCylinder: RecordType {
            optional: &[
                or_default(positive("a", "the semi-axis along x"), "1"),
                or_default(positive("b", "the semi-axis along y"), "1"),
            ],
            ..shape(
                19,
                "hyperbolic-cylinder",
                "hyperbolic cylinder",
                &[],
                "Solid: (x/a)² − (y/b)² − 1 ≤ 0, along z.",
                "2 19",
            )
        },
        Hyperboloid: RecordType {
            optional: &[
                or_default(positive("a", "the semi-axis along x"), "1"),
                or_default(positive("b", "the semi-axis along y"), "1"),
                or_default(positive("c", "the semi-axis along z"), "1"),
                or_default(
                    integer("sheets", Constraint::Within(1.0, 2.0), "the number of sheets"),
                    "1",
                ),
            ],
            ..shape(
                20,
                "hyperboloid",
                "hyperboloid",
                &[],
                "Solid around the y axis; one sheet: (x/a)² − (y/b)² + (z/c)² − 1 ≤ 0, two sheets: (x/a)² − (y/b)² + (z/c)² + 1 ≤ 0.",
                "2 20 1 1 1 1",
            )
        },
        HyperbolicParaboloid: RecordType {
            optional: &[
                or_default(positive("a", "the half width along x at y = 1"), "1"),
                or_default(positive("b", "the half width along z at y = −1"), "1"),
            ],
            ..shape(
                21,
                "hyperbolic-paraboloid",
                "hyperbolic paraboloid",
                &[],
                "Solid: (x/a)² − (z/b)² − y ≤ 0.",
                "2 21 1 1",
            )
        },
    }
    others {
        Translation: record(
            -1,
            ["translate", "translation"],
            Family::Transformation,
            Effect::Changes(MOVABLE),
            &[
                length("x", "the step along x"),
                length("y", "the step along y"),
                length("z", "the step along z"),
            ],
            "Moves the object, point light or camera with this ID.",
            "2 -1 0 5 0",
        ),
        Rotation: record(
            -2,
            ["rotate", "rotation"],
            Family::Transformation,
            Effect::Changes(MOVABLE),
            &[
                Param {
                    unit: Unit::Degrees,
                    ..real(
                        "angle",
                        "the angle, counter-clockwise seen from the tip of the axis",
                    )
                },
                integer("axis", Constraint::Axis, "the axis (1 = x, 2 = y, 3 = z)"),
            ],
            "Turns the object, point light or camera with this ID about a coordinate axis.",
            "2 -2 10 1",
        ),
        Scaling: record(
            -3,
            ["scale", "scaling"],
            Family::Transformation,
            Effect::Changes(MOVABLE),
            &[
                Param {
                    constraint: Constraint::NonZeroScale,
                    ..real("sx", "the factor along x")
                },
                Param {
                    constraint: Constraint::NonZeroScale,
                    ..real("sy", "the factor along y")
                },
                Param {
                    constraint: Constraint::NonZeroScale,
                    ..real("sz", "the factor along z")
                },
            ],
            "Scales the object, point light or camera with this ID from the origin; a negative factor mirrors.",
            "2 -3 1 2 1",
        ),
        RotationMatrix: record(
            -4,
            ["rotation-matrix", "rotation matrix"],
            Family::Transformation,
            Effect::Changes(MOVABLE),
            &MATRIX,
            "Turns the object, point light or camera with this ID by a 4×4 matrix, given row by row, that acts on column vectors.",
            "2 -4  0 -1 0 0  1 0 0 0  0 0 1 0  0 0 0 1",
        )
        .of_vectors(&[4, 4, 4, 4]),
        ProjectionMatrix: record(
            -99,
            ["projection-matrix", "projection matrix"],
            Family::Transformation,
            Effect::DefinesOrChanges(Kind::Camera, CAMERA),
            &MATRIX,
            "Gives the camera with this ID a projection of its own: clip = P · view · x with the clip cube of OpenGL, \
             in place of fovy. A new ID defines a camera at the origin that looks along −z.",
            "9 -99  1 0 0 0  0 1 0 0  0 0 -1.2 -2.2  0 0 -1 0",
        )
        .of_vectors(&[4, 4, 4, 4]),
        Union: record(
            -101,
            ["union", "union"],
            Family::Operation,
            Effect::Defines(Kind::Object),
            TWO_OBJECTS,
            "A := B ∪ C. Each part keeps its own properties; the first operand that holds a point owns it.",
            "4 -101 2 3",
        ),
        Intersection: record(
            -102,
            ["intersection", "intersection"],
            Family::Operation,
            Effect::Defines(Kind::Object),
            TWO_OBJECTS,
            "A := B ∩ C. Every piece of boundary keeps the properties of the shape it comes from.",
            "4 -102 2 3",
        ),
        Difference: record(
            -103,
            ["difference", "difference"],
            Family::Operation,
            Effect::Defines(Kind::Object),
            TWO_OBJECTS,
            "A := B − C: C is taken from B. The whole boundary, cut faces too, has the properties of B.",
            "4 -103 2 3",
        ),
        Complement: record(
            -104,
            ["complement", "complement"],
            Family::Operation,
            Effect::Defines(Kind::Object),
            &[reference("B", OBJECT, "the operand")],
            "A := −B, everything outside B.",
            "4 -104 2",
        ),
        Copy: record(
            -105,
            ["copy", "copy"],
            Family::Operation,
            Effect::Defines(Kind::Object),
            &[reference("B", ANYTHING, "what is copied")],
            "A := B as it is at this point; the copy and the original then change apart.",
            "4 -105 2",
        ),
        Optics: record(
            -201,
            ["optics", "optical property"],
            Family::Property,
            PROPERTY,
            &[
                share("kd", "the diffuse part"),
                share("ks", "the mirrored part"),
                share("kt", "the transmitted part"),
            ],
            "Diffuse, mirrored and transmitted parts of the light, the same in all channels.",
            "35 -201 0.3 0.5 0.1",
        ),
        OpticsRgb: record(
            -202,
            ["optics-rgb", "optical property per channel"],
            Family::Property,
            PROPERTY,
            &OPTICS_RGB,
            "Diffuse, mirrored and transmitted parts of the light, channel by channel.",
            "35 -202  0.5 0.5 0  0.5 0.5 0  0.5 0.5 0",
        )
        .of_vectors(&[3, 3, 3]),
        RefractiveIndex: record(
            -203,
            ["refractive-index", "refractive index"],
            Family::Property,
            PROPERTY,
            &[
                Param {
                    constraint: Constraint::Positive,
                    ..real("etaR", "the index for red")
                },
                Param {
                    constraint: Constraint::Positive,
                    ..real("etaG", "the index for green")
                },
                Param {
                    constraint: Constraint::Positive,
                    ..real("etaB", "the index for blue")
                },
            ],
            "The refractive index, one per channel; different values split the colours.",
            "35 -203 1.5 1.5 1.5",
        ),
        Assignment: record(
            -299,
            ["assign", "assignment of properties"],
            Family::Property,
            Effect::Changes(OBJECT),
            &[
                reference_or_none("T", SURFACE_LOOK, "the texture or colour, or 0"),
                reference_or_none("O", OPTICS, "the optical property, or 0"),
            ],
            "Gives the object with this ID a texture or colour and an optical property; 0 takes it back to the default.",
            "4 -299 0 35",
        ),
        ImageTexture: record(
            -301,
            ["image-texture", "image texture"],
            Family::Texture,
            TEXTURE,
            &[Param {
                kind: ParamKind::FileName,
                ..real("file", "a PNG or JPEG file beside the scene")
            }],
            "A picture laid over the surface coordinates (u, v), repeated, read as sRGB.",
            "16 -301 wood.png",
        ),
        SolidTexture: RecordType {
            optional: &[
                or_default(
                    reference("c1", COLOUR, "the colour of the cubes at even places"),
                    "black",
                ),
                or_default(
                    reference("c2", COLOUR, "the colour of the cubes at odd places"),
                    "white",
                ),
                or_default(positive("s", "the cubes' edge"), "1"),
            ],
            ..record(
                -302,
                ["solid-texture", "solid texture"],
                Family::Texture,
                TEXTURE,
                &[],
                "Cubes of two alternating colours in the object's coordinates at the time of the assignment.",
                "16 -302 14 15 2",
            )
        },
        Checkerboard: record(
            -399,
            ["checkerboard", "checkerboard"],
            Family::Texture,
            TEXTURE,
            &[
                integer("N", Constraint::AtLeast(1.0), "the number of cells along u"),
                integer("M", Constraint::AtLeast(1.0), "the number of cells along v"),
                reference("c1", COLOUR, "the colour of the cells at even places"),
                reference("c2", COLOUR, "the colour of the cells at odd places"),
            ],
            "N × M cells over the surface coordinates; c1 where ⌊uN⌋ + ⌊vM⌋ is even.",
            "16 -399  10 15  14 15",
        )
        .of_vectors(&[2, 2]),
        AmbientLight: record(
            -401,
            ["ambient-light", "ambient light"],
            Family::Light,
            Effect::Defines(Kind::AmbientLight),
            &[Param {
                constraint: Constraint::AtLeast(0.0),
                ..real("intensity", "the intensity")
            }],
            "Light that reaches every surface from everywhere; several add up.",
            "50 -401 0.2",
        ),
        PointLight: record(
            -402,
            ["point-light", "point light"],
            Family::Light,
            Effect::Defines(Kind::PointLight),
            &[Param {
                constraint: Constraint::AtLeast(0.0),
                ..real("intensity", "the intensity")
            }],
            "A light at the origin until a transformation moves it; it does not get weaker with distance.",
            "51 -402 0.8",
        ),
        Camera: record(
            -501,
            ["camera", "camera"],
            Family::Camera,
            Effect::Defines(Kind::Camera),
            &CAMERA_PARAMS,
            "Position, view direction, up vector (both of any length) and the vertical field of view. The direction \
             is no point: to look at a point, write the point minus the position.",
            "9 -501  0 0 0  0 0 -1  0 1 0  45",
        )
        .of_vectors(&[3, 3, 3, 1]),
        MonoCamera: record(
            -502,
            ["mono-camera", "mono camera"],
            Family::Camera,
            Effect::Defines(Kind::Selection),
            &[reference("camera", CAMERA, "the camera")],
            "Selects the camera the picture is taken with; the last selection counts.",
            "60 -502 9",
        ),
        StereoCamera: record(
            -503,
            ["stereo-camera", "stereo camera"],
            Family::Camera,
            Effect::Defines(Kind::Selection),
            &[
                reference("left", CAMERA, "the left eye's camera"),
                reference("right", CAMERA, "the right eye's camera"),
            ],
            "Selects a pair of cameras for a stereo picture; the last selection counts.",
            "60 -503 9 10",
        ),
        BoundingBox: record(
            -601,
            ["bounding-box", "bounding box"],
            Family::Bound,
            Effect::Changes(OBJECT),
            &CORNERS,
            "Promises that the object with this ID lies in this box. It never changes the picture.",
            "2 -601  -1 -1 -1  1 1 1",
        )
        .of_vectors(&[3, 3]),
        BoundingSphere: record(
            -602,
            ["bounding-sphere", "bounding sphere"],
            Family::Bound,
            Effect::Changes(OBJECT),
            &SPHERE,
            "Promises that the object with this ID lies in this ball. It never changes the picture.",
            "2 -602  0 0 0  1",
        )
        .of_vectors(&[3, 1]),
        Colour: record(
            -701,
            ["colour", "colour"],
            Family::Colour,
            Effect::DefinesOrChanges(
                Kind::Colour,
                &[
                    Kind::Colour,
                    Kind::Object,
                    Kind::AmbientLight,
                    Kind::PointLight,
                ],
            ),
            RGB,
            "Linear red, green and blue in [0, 1]. On an object or a light it is that one's colour.",
            "7 -701 1 1 1",
        ),
        Render: RecordType {
            optional: &CORNERS,
            vectors: &[2, 3, 3],
            ..record(
                9999,
                ["render", "render record"],
                Family::Render,
                Effect::Defines(Kind::Render),
                &[
                    reference("scene", OBJECT, "the object that is drawn"),
                    reference_or_none("background", COLOUR, "the background colour, 0 for black"),
                ],
                "What is drawn, always with ID 1: an object, the background, and a box outside of which nothing is visible.",
                "1 9999 6 7",
            )
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_keywords_are_unique() {
        for (i, a) in RECORD_TYPES.iter().enumerate() {
            for b in &RECORD_TYPES[i + 1..] {
                assert_ne!(a.code, b.code);
                assert_ne!(a.keyword, b.keyword);
            }
            assert!(std::ptr::eq(RecordType::by_code(a.code.into()).unwrap(), a));
            assert!(std::ptr::eq(RecordType::by_keyword(a.keyword).unwrap(), a));
            assert!(std::ptr::eq(RecordType::of(a.kind), a));
        }
    }

    #[test]
    fn vectors_are_made_of_all_parameters() {
        for ty in RECORD_TYPES.iter().filter(|t| !t.vectors.is_empty()) {
            let sum: usize = ty.vectors.iter().sum();
            assert_eq!(sum, ty.params.len() + ty.optional.len(), "{}", ty.keyword);
        }
    }

    #[test]
    fn counted_arity() {
        let lathe = RecordType::by_code(2).unwrap();
        assert_eq!(lathe.arity(3), 1 + 6 + 9);
        assert_eq!(lathe.param(0, 3).unwrap().name, "N");
        assert_eq!(lathe.param(1, 3).unwrap().name, "x");
        assert_eq!(lathe.param(6, 3).unwrap().name, "y");
        assert_eq!(lathe.param(7, 3).unwrap().name, "r");
        assert_eq!(lathe.param(15, 3).unwrap().name, "b");
        assert!(lathe.param(16, 3).is_none());
        assert_eq!(lathe.arity(u64::MAX), u64::MAX);
    }
}

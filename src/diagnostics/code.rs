//! The registry of codes. A code is stable: its number and name never change their meaning.

#![warn(missing_docs)]

use super::language::Language;

/// The weight of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// An error: the scene is not drawn.
    Error,
    /// A warning: probably a mistake.
    Warning,
    /// A note: worth knowing.
    Note,
    /// A remark on style.
    Style,
}

impl Severity {
    /// The name of the severity, as `error`.
    pub fn as_str(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
            Severity::Style => "style",
        }
    }
}

/// The registry's entry of a code.
struct CodeEntry {
    code: &'static str,
    name: &'static str,
    /// The pages in English and Czech: the files `explain/CODE.md` and `CODE.cs.md`, or for a rule `explain.md` and
    /// `explain.cs.md` in its folder.
    explanation: [&'static str; 2],
    /// The messages of a rule in English and Czech; `None` for other codes, whose messages stand in `messages/`.
    messages: Option<[&'static str; 2]>,
}

/// A file in the folder of a lint rule.
macro_rules! of_rule {
    ($rule:literal, $file:literal) => {
        include_str!(concat!("../lint/rules/", $rule, "/", $file))
    };
}

macro_rules! explanation {
    ($code:ident) => {
        [
            include_str!(concat!("explain/", stringify!($code), ".md")),
            include_str!(concat!("explain/", stringify!($code), ".cs.md")),
        ]
    };
    ($code:ident $rule:literal) => {
        [
            of_rule!($rule, "explain.md"),
            of_rule!($rule, "explain.cs.md"),
        ]
    };
}

macro_rules! messages {
    () => {
        None
    };
    ($rule:literal) => {
        Some([of_rule!($rule, "en.ftl"), of_rule!($rule, "cs.ftl")])
    };
}

macro_rules! codes {
    ($($code:ident $name:literal $(of rule $rule:literal)?;)*) => {
        /// The codes of all findings.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $(#[doc = $name] $code),* }

        impl Code {
            /// Every code, in the order of the reference.
            pub const ALL: &'static [Code] = &[$(Code::$code),*];

            fn entry(self) -> CodeEntry {
                match self {
                    $(Code::$code => CodeEntry {
                        code: stringify!($code),
                        name: $name,
                        explanation: explanation!($code $($rule)?),
                        messages: messages!($($rule)?),
                    }),*
                }
            }
        }
    };
}

codes! {
    E001 "invalid-character";
    E002 "unterminated-comment";
    E003 "malformed-number";
    E004 "number-out-of-range";
    E005 "expected-id";
    E006 "expected-type";
    E007 "unknown-type";
    E008 "too-few-parameters";
    E009 "too-many-parameters";
    E010 "expected-integer";
    E011 "expected-filename";
    E012 "unexpected-word";
    E013 "limit-exceeded";
    E014 "not-a-scene";
    E015 "malformed-json";
    E101 "undefined-id";
    E102 "duplicate-id";
    E103 "wrong-kind";
    E104 "self-reference";
    E105 "reserved-render-id";
    E106 "missing-render";
    E107 "used-before-definition";
    E108 "void-used";
    E201 "not-positive";
    E202 "inverted-range";
    E203 "zero-vector";
    E204 "singular-matrix";
    E205 "bad-axis";
    E206 "out-of-range";
    E207 "degenerate-camera";
    E208 "negative-profile-radius";
    E209 "unsafe-path";
    E210 "unreadable-file";
    W301 "colour-out-of-range" of rule "colour_out_of_range";
    W302 "energy-gain" of rule "energy_gain";
    W303 "not-a-rotation" of rule "not_a_rotation";
    W304 "asymmetric-quadric" of rule "asymmetric_quadric";
    W305 "degenerate-shape" of rule "degenerate_shape";
    W306 "no-real-points" of rule "no_real_points";
    W307 "overlapping-union" of rule "overlapping_union";
    W308 "mixed-intersection" of rule "mixed_intersection";
    W309 "stale-operand" of rule "stale_operand";
    W310 "unused-definition" of rule "unused_definition";
    W311 "bound-too-small" of rule "bound_too_small";
    W312 "scene-box-cuts" of rule "scene_box_cuts";
    W313 "surface-operand" of rule "surface_operand";
    W314 "suspicious-line-break";
    W315 "comment-hides-records" of rule "comment_hides_records";
    W316 "several-cameras" of rule "several_cameras";
    W318 "pointless-index" of rule "pointless_index";
    W319 "empty-result" of rule "empty_result";
    W320 "self-intersecting" of rule "self_intersecting";
    W321 "coincident-faces" of rule "coincident_faces";
    W322 "ill-scaled" of rule "ill_scaled";
    W323 "angle-in-radians" of rule "angle_in_radians";
    W324 "nothing-in-view" of rule "nothing_in_view";
    W325 "camera-in-solid" of rule "camera_in_solid";
    W326 "lamp-in-solid" of rule "lamp_in_solid";
    W327 "pointless-transformation" of rule "pointless_transformation";
    W328 "up-along-view" of rule "up_along_view";
    W329 "smaller-than-a-pixel" of rule "smaller_than_a_pixel";
    W330 "nothing-lit" of rule "nothing_lit";
    W331 "unseen-texture" of rule "unseen_texture";
    W332 "idle-difference" of rule "idle_difference";
    W333 "duplicate-operand" of rule "duplicate_operand";
    W334 "overridden-property" of rule "overridden_property";
    W335 "buried-shape" of rule "buried_shape";
    W336 "repeated-transformation" of rule "repeated_transformation";
    W337 "unseen-glass" of rule "unseen_glass";
    W338 "stereo-pair" of rule "stereo_pair";
    W339 "normals-in-plane" of rule "normals_in_plane";
    W340 "swapped-difference" of rule "swapped_difference";
    W341 "bounds-by-size" of rule "bounds_by_size";
    W342 "optics-by-comment" of rule "optics_by_comment";
    W343 "standing-floor" of rule "standing_floor";
    W344 "comment-contradicts" of rule "comment_contradicts";
    N601 "not-utf8";
    N602 "no-camera" of rule "no_camera";
    N603 "no-light" of rule "no_light";
    N604 "utf16";
    N605 "two-readings";
    N606 "too-bright" of rule "too_bright";
    N607 "rotation-in-radians" of rule "rotation_in_radians";
    N608 "beside-picture" of rule "beside_picture";
    N609 "turned-about-origin" of rule "turned_about_origin";
    N610 "among-others" of rule "among_others";
    S501 "notation-separator" of rule "notation_separator";
    S502 "bare-comment" of rule "bare_comment";
    S503 "several-records-per-line" of rule "several_records_per_line";
    S504 "unused-allow";
    S505 "leading-zero" of rule "leading_zero";
}

impl Code {
    /// Whether the code is about how records are written, and not about the scene that they make.
    pub fn is_about_notation(self) -> bool {
        use Code::{N601, N604, N605, W314, W315};
        self.severity() == Severity::Style || matches!(self, N601 | N604 | N605 | W314 | W315)
    }

    /// The code itself, as `E101`.
    pub fn as_str(self) -> &'static str {
        self.entry().code
    }

    /// The name of the code, as `undefined-id`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The page that `zpg explain` shows: what the check does, why it matters, an example, the fix.
    pub fn explanation(self, language: Language) -> &'static str {
        self.entry().explanation[language as usize]
    }

    /// The messages of a lint rule, in English and in Czech; `None` for other codes.
    pub(super) fn messages(self) -> Option<[&'static str; 2]> {
        self.entry().messages
    }

    /// The severity that the code's letter stands for.
    pub fn severity(self) -> Severity {
        match self.as_str().as_bytes()[0] {
            b'E' => Severity::Error,
            b'W' => Severity::Warning,
            b'N' => Severity::Note,
            _ => Severity::Style,
        }
    }

    /// Whether the code is always an error. A missing render record (E106) is only a warning while nothing is to be
    /// drawn.
    pub fn is_never_allowed(self) -> bool {
        self.severity() == Severity::Error && self != Code::E106
    }

    /// Finds a code by its number (in any case) or its name; `None` if there is no such code.
    pub fn parse(text: &str) -> Option<Code> {
        Code::ALL
            .iter()
            .copied()
            .find(|c| c.as_str().eq_ignore_ascii_case(text) || c.name() == text)
    }
}

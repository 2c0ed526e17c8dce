//! The registry of codes. A code is stable: its number and name never change their meaning.

/// How much a finding weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    Error,
    Warning,
    Note,
    Style,
}

impl Severity {
    pub fn as_str(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
            Severity::Style => "style",
        }
    }
}

/// What the registry keeps of a code. The explanation is the file `explain/CODE.md`.
struct Entry {
    code: &'static str,
    name: &'static str,
    explanation: &'static str,
}

macro_rules! codes {
    ($($code:ident $name:literal;)*) => {
        /// The codes of all findings.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $($code),* }

        impl Code {
            /// Every code, in the order of the reference.
            pub const ALL: &'static [Code] = &[$(Code::$code),*];

            fn entry(self) -> Entry {
                match self {
                    $(Code::$code => Entry {
                        code: stringify!($code),
                        name: $name,
                        explanation: include_str!(concat!("explain/", stringify!($code), ".md")),
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
    W301 "colour-out-of-range";
    W302 "energy-gain";
    W303 "not-a-rotation";
    W304 "asymmetric-quadric";
    W305 "degenerate-shape";
    W306 "no-real-points";
    W307 "overlapping-union";
    W308 "mixed-intersection";
    W309 "stale-operand";
    W310 "unused-definition";
    W311 "bound-too-small";
    W312 "scene-box-cuts";
    W313 "surface-operand";
    W314 "suspicious-line-break";
    W315 "comment-hides-records";
    W316 "several-cameras";
    W318 "pointless-index";
    W319 "empty-result";
    W320 "self-intersecting";
    W321 "coincident-faces";
    W322 "ill-scaled";
    N601 "not-utf8";
    N602 "no-camera";
    N603 "no-light";
    N604 "utf16";
    S501 "notation-separator";
    S502 "bare-comment";
    S503 "several-records-per-line";
    S504 "unused-allow";
}

impl Code {
    /// `E101`.
    pub fn as_str(self) -> &'static str {
        self.entry().code
    }

    /// `undefined-id`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The page that `zpg explain` shows: what it does, why it matters, an example, the fix.
    pub fn explanation(self) -> &'static str {
        self.entry().explanation
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

    /// Whether it is always an error. That there is no render record is a warning as long as nothing
    /// is to be drawn.
    pub fn is_never_allowed(self) -> bool {
        self.severity() == Severity::Error && self != Code::E106
    }

    /// Finds a code by its number (in any case) or its name.
    pub fn parse(text: &str) -> Option<Code> {
        Code::ALL
            .iter()
            .copied()
            .find(|c| c.as_str().eq_ignore_ascii_case(text) || c.name() == text)
    }
}

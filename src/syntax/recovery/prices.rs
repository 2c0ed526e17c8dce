//! Prices of all that recovery may take for a mistake: the way to read a text that costs least wins. The price of an
//! error is [`FAULT`], and all other prices are in relation to it. In each part the dearest comes first.

// Errors: pieces that are no records, and lines that are swallowed.

/// The price of taking a record for a fault if nothing is wrong with it: the record must be read as it stands.
pub(super) const NOTHING_WRONG: u32 = 1_000 * FAULT;
/// The price of a record that takes numbers from a line which would be a record but for a slip. More than two errors,
/// one in the record and one in the line.
pub(super) const TWO_SLIPS: u32 = 2 * FAULT + FAULT / 10;
/// The price of a line that looks like a record of its own and is swallowed by another. More than an error, since the
/// line by itself would be one error at most.
pub(super) const OWN_LINE: u32 = FAULT + FAULT / 2;
/// The price of a reading that is likelier a mistake than meant: more than one error, less than two.
pub(super) const IMPLAUSIBLE: u32 = 1200;
/// The price of a record with two numbers more or less than it takes.
pub(super) const FEW_OFF: u32 = FAULT + 2 * ONE_OFF;
/// The price of one error.
pub(super) const FAULT: u32 = 1000;
/// The price of a reading that only a second look would doubt: a little less than an error.
pub(super) const DOUBTFUL: u32 = 900;
/// The price of a record that was cut off by a comment which nobody closed: the comment is an error already.
pub(super) const CUT_OFF: u32 = FAULT / 10;
/// Additional price of taking the type of an operation, a light, a camera or a property for a coordinate. A record of
/// that type with two numbers too many or too few is cheaper.
pub(super) const TYPE_AS_COORDINATE: u32 = 3 * ONE_OFF;
/// The price of a line that is a record but for integers that are spelled as reals. A program may have written all
/// lines like that: it is less than what three numbers too many cost.
pub(super) const REALS: u32 = 50;
/// Price of the cheapest fault.
pub(super) const LEAST_PRICE: u32 = REALS;
/// Additional price of taking a number for a type if it follows the ID of the line before: it is rather the next ID.
pub(super) const IN_ORDER: u32 = 40;
/// The price of each number more or less.
pub(super) const ONE_OFF: u32 = 20;

// What speaks against a piece where it stands: its IDs and parameters.

/// Price of an ID that is defined a second time.
pub(super) const DEFINED_TWICE: u32 = 1000;
/// Price of an ID that is changed and defined nowhere.
pub(super) const CHANGES_NOTHING: u32 = 1000;
/// Price of using ID 1, which is the render record's, for anything else.
pub(super) const RENDER_ID: u32 = 1000;
/// Price of a parameter that leads nowhere.
pub(super) const REFERS_TO_NOTHING: u32 = 900;
/// Price of a parameter that no such record may have.
pub(super) const NOT_ALLOWED: u32 = 900;
/// Price of a parameter that is no number of its kind.
pub(super) const WRONG_KIND: u32 = 600;
/// The price of a parameter that looks like the type of an operation or a property, perhaps without its sign.
pub(super) const LIKE_A_TYPE: u32 = 200;
/// Price of an ID that is new and lower than another one: files have their IDs in order, mostly.
pub(super) const OUT_OF_ORDER: u32 = 150;
/// Price of an ID that is changed or referred to where a record before lost its ID, which may be that one.
pub(super) const MAY_BE_LOST: u32 = 150;
/// The price of a parameter that looks like the next ID.
pub(super) const LIKE_AN_ID: u32 = 50;

// Where line breaks say nothing: what each mistake costs more or less than another.

/// Highest price of doubts about a record that is not right in form.
pub(super) const DOUBTS_OF_FAULT_MAX: u32 = 3000;
/// Faults are not looked for at a token if a way to one of the next tokens is cheaper by this much.
pub(super) const HOPELESS: u64 = 1500;
/// Highest price of doubts about a record that is right in form: less than for garbage.
pub(super) const DOUBTS_MAX: u32 = 1250;
/// Additional price of taking tokens for no record at all.
pub(super) const NO_RECORD: u32 = 300;
/// The price of a `0` that introduces no comment.
pub(super) const LONE_VOID: u32 = 300;
/// The price of a wrong number of points if the numbers behind it are not whole points.
pub(super) const PARTS_OF_POINTS: u32 = 200;
/// Highest price of doubts about parameters that fit no type.
pub(super) const FITS_NO_TYPE: u32 = 200;
/// The additional price of a lost ID if a number at its place could be that ID.
pub(super) const COULD_BE_ID: u32 = 150;
/// The price of each token of a piece that is no record and does not end with its line. The tokens of a whole record
/// together cost about as much as an error.
pub(super) const GARBAGE: u32 = 150;
/// Additional price of a number too many before the type if it could be the type itself.
pub(super) const STRAY_TYPE: u32 = 100;
/// Additional price of a lost ID before a type that reads like any other number.
pub(super) const LIKE_A_NUMBER: u32 = 60;
/// The price of a wrong number of points if the numbers behind it are whole points.
pub(super) const WHOLE_POINTS: u32 = 60;
/// The price of reading an optional group, or of leaving it out, against the evidence of the following records.
pub(super) const OTHER_WAY: u32 = 60;
/// The price of a place within a piece at which a record could begin.
pub(super) const HEAD_WITHIN: u32 = 60;
/// Additional price of a number too many before the type over that of an ID or a type with a space in it.
pub(super) const STRAY: u32 = 40;
/// The price of each parameter that is missing or too many, beside that of the error.
pub(super) const MORE_OR_FEWER: u32 = 40;
/// Additional price of a wrong type if the number is the type of other records.
pub(super) const A_TYPE_AFTER_ALL: u32 = 30;
/// Additional price of a token that can be no ID in the place of one.
pub(super) const BAD_ID: u32 = 20;
/// The discount on parameters that are missing or too many: no mistake is more frequent.
pub(super) const ONE_IS_LIKELY: u32 = 20;
/// How much less a lost sign costs than another error.
pub(super) const SIGN_IS_LIKELY: u32 = 20;
/// Additional price of a wrong type over that of another error.
pub(super) const WRONG_TYPE: u32 = 20;
/// The price of each token of a record of no known type.
pub(super) const UNTYPED: u32 = 10;
/// Additional price of a bad token as a piece by itself.
pub(super) const ALONE: u32 = 10;

// Comments. These prices are compared only with each other: an error is about 100.

/// The price of words behind a comment's closing sign, if the comment hides a record or the sign is the first thing on
/// its line: comments turned inside out, as where a `#` on each line is meant to comment the rest of the line. More
/// than two signs that are given up.
pub(super) const INSIDE_OUT: u32 = 2 * UNCLOSED + 5;
/// The price of giving a comment up at the end of its line: an error.
pub(super) const UNCLOSED: u32 = 110;
/// The price of a line with words where code should be: an error too, and the likelier one.
pub(super) const GARBAGE_LINE: u32 = 100;
/// The price of a record inside a comment, for the first few of a comment; people do put whole blocks into comments.
pub(super) const HIDDEN: u32 = 45;

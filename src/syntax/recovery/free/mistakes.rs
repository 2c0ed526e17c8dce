//! The records with one mistake that may begin at a token, and what each of them costs.

use super::super::super::lexer::TokenKind;
use super::super::super::table::{RecordKind, RecordType};
use super::super::diagnosis::Diagnosis;
use super::super::faults::{self, BAD_MAX};
use super::super::heads::type_at;
use super::super::partial_parses::Id;
use super::super::prices::{
    A_TYPE_AFTER_ALL, ALONE, BAD_ID, COULD_BE_ID, CUT_OFF, DOUBTS_OF_FAULT_MAX, FAULT,
    FITS_NO_TYPE, GARBAGE, LIKE_A_NUMBER, MORE_OR_FEWER, NO_RECORD, ONE_IS_LIKELY, OUT_OF_ORDER,
    PARTS_OF_POINTS, SIGN_IS_LIKELY, STRAY, STRAY_TYPE, UNTYPED, WHOLE_POINTS, WRONG_TYPE,
};
use super::{Head, MAX_NUMBERS_OFF, MAX_PARAMS, Search};

/// The most tokens of a piece that count towards its price.
const COUNTED_MAX: usize = 10_000;
/// How many tokens ahead the end of a record is looked for if its type or its number of points is lost.
const REACH: usize = 64;

impl Search<'_, '_> {
    /// Tries the records with one mistake that may begin at a token.
    pub(super) fn faults(&mut self, at: usize) {
        self.garbage(at);
        self.lost_id(at);
        self.too_many_in_front(at);
        if let Some(ty) = type_at(self.stretch, at + 1) {
            match self.id_at(at) {
                Some(id) => {
                    self.wrong_arity(at, id, ty);
                    if ty.is_counted() {
                        self.wrong_point_count(at, id, ty);
                    }
                    self.sign_of_known_type(at, id, ty);
                }
                None => self.bad_id(at, ty),
            }
        } else if let Some(id) = self.id_at(at) {
            self.lost_sign(at, id);
        }
        if let Some(id) = self.id_at(at) {
            self.wrong_type(at, id);
            self.too_many_behind_id(at, id);
        }
    }

    /// Tries pieces that are no records at all. They end where a record may begin or the line ends.
    fn garbage(&mut self, at: usize) {
        let stretch = self.stretch;
        let n = stretch.len();
        let id = self.id_at(at).map_or(Id::Lost, Id::Is);
        if stretch.sigs[at].kind.is_bad() {
            self.offer(
                (at, at + 1),
                FAULT + ALONE,
                (Id::None, None),
                Diagnosis::BadId { ty: None },
            );
        }
        // A real number as an ID is an error by itself.
        let real = if stretch.sigs[at].kind == TokenKind::Real {
            FAULT
        } else {
            0
        };
        self.offer(
            (at, at + 1),
            FAULT + NO_RECORD + real,
            (id, None),
            Diagnosis::MissingType,
        );
        let line_end = stretch.line_end(stretch.line(at));
        let ty = stretch.record_type(at + 1);
        for end in (at + 2..n.min(at + REACH)).chain([n, line_end]) {
            if end > at + 1 && (end == n || end == line_end || stretch.read(end).is_some()) {
                let got = end - at - 2;
                let verdict = match ty.map(|ty| (ty, ty.params.len())) {
                    None => self.type_verdict(at + 1),
                    Some((ty, _)) if ty.is_counted() => Diagnosis::BadPointCount { ty },
                    Some((_, expected)) if expected == got => continue,
                    Some((ty, expected)) => Diagnosis::WrongArity { ty, got, expected },
                };
                let price = FAULT + faults::bad_price(stretch, at, end) + NO_RECORD + real;
                let each = if end == line_end { UNTYPED } else { GARBAGE };
                let price = price + each * (end - at).min(COUNTED_MAX) as u32;
                self.offer((at, end), price, (id, None), verdict);
            }
        }
        if stretch.has_unclosed_comment(at, line_end) {
            let ty = stretch.record_type(at + 1);
            self.offer((at, line_end), CUT_OFF, (id, ty), Diagnosis::CutOff { ty });
        }
    }

    /// The diagnosis of a token that should be a type and is none.
    fn type_verdict(&self, at: usize) -> Diagnosis {
        match self.stretch.sigs.get(at) {
            None => Diagnosis::MissingType,
            Some(sig) if sig.int.is_some() => Diagnosis::UnknownType,
            Some(_) => Diagnosis::BadType,
        }
    }

    /// Tries a record that lacks its ID.
    fn lost_id(&mut self, at: usize) {
        let Some(ty) = self
            .stretch
            .record_type(at)
            .filter(|t| t.kind != RecordKind::Undefined)
        else {
            return;
        };
        let Some(head) = self.head(Id::Lost, ty, at + 1) else {
            return;
        };
        let before = at.checked_sub(1).and_then(|before| self.id_at(before));
        let could_be = before
            .is_some_and(|id| self.ways.id(id, Some(ty), self.here) < OUT_OF_ORDER)
            || self
                .id_at(at)
                .is_some_and(|id| id != 1 && self.ways.is_next(id, self.here));
        let price = FAULT
            + if ty.code > 0 { LIKE_A_NUMBER } else { 0 }
            + if could_be { COULD_BE_ID } else { 0 };
        for end in self.right_ends(&head).filter(|&end| end > at + 1) {
            let doubts = self.params(&head, end);
            if doubts < DOUBTS_OF_FAULT_MAX {
                self.offer(
                    (at, end),
                    price + doubts,
                    (Id::Lost, Some(ty)),
                    Diagnosis::LostId { ty },
                );
            }
        }
    }

    /// Tries a record with a token too many in front, or with an ID that a space cuts in two.
    fn too_many_in_front(&mut self, at: usize) {
        let Some(ty) = self
            .stretch
            .record_type(at + 2)
            .filter(|t| t.kind != RecordKind::Undefined)
        else {
            return;
        };
        let joined = faults::joined(self.stretch, at).and_then(|id| u32::try_from(id).ok());
        let joined = joined.filter(|&id| self.ways.id(id, Some(ty), self.here) < OUT_OF_ORDER);
        for (id, price) in [(joined, 0), (self.id_at(at + 1), STRAY)] {
            let Some(head) = id.and_then(|id| self.head(Id::Is(id), ty, at + 3)) else {
                continue;
            };
            self.surplus(at, &head, at, price);
        }
    }

    /// Tries a record with a token too many between ID and type, or with a type that a space cuts in two.
    fn too_many_behind_id(&mut self, at: usize, id: u32) {
        let joined =
            faults::joined(self.stretch, at + 1).and_then(|code| RecordType::by_code(code.into()));
        // A negative number is likelier to be the type.
        let likely = self.stretch.record_type(at + 1).is_some_and(|t| t.code < 0);
        let stray = if likely { STRAY_TYPE } else { STRAY };
        for (ty, price) in [(joined, 0), (type_at(self.stretch, at + 2), stray)] {
            let Some(ty) = ty.filter(|t| t.kind != RecordKind::Undefined) else {
                continue;
            };
            if let Some(head) = self.head(Id::Is(id), ty, at + 3) {
                self.surplus(at, &head, at + 1, price);
            }
        }
    }

    /// Offers a record that is right but for the token too many at `stray`.
    fn surplus(&mut self, at: usize, head: &Head, stray: usize, more: u32) {
        let Id::Is(id) = head.id else { return };
        for end in self.right_ends(head) {
            let doubts = self.doubts(head, end).min(DOUBTS_OF_FAULT_MAX);
            let verdict = match stray > at && self.stretch.record_type(stray).is_none() {
                true => self.type_verdict(stray),
                false => Diagnosis::Surplus {
                    ty: head.ty,
                    expected: end - head.first,
                    at: stray,
                    id,
                },
            };
            self.offer(
                (at, end),
                FAULT + more + doubts,
                (head.id, Some(head.ty)),
                verdict,
            );
        }
    }

    /// Tries a record with a token in the place of the ID that can be no ID.
    fn bad_id(&mut self, at: usize, ty: &'static RecordType) {
        let Some(head) = self.head(Id::Lost, ty, at + 2) else {
            return;
        };
        let real_type = if self.stretch.record_type(at + 1).is_none() {
            FAULT
        } else {
            0
        };
        for end in self.right_ends(&head) {
            let doubts = self.params(&head, end).min(DOUBTS_OF_FAULT_MAX);
            let verdict = Diagnosis::BadId { ty: Some(ty) };
            self.offer(
                (at, end),
                FAULT + BAD_ID + real_type + doubts,
                (Id::Lost, Some(ty)),
                verdict,
            );
        }
    }

    /// Offers a record with some parameters more or less than its type takes, or with spoiled ones.
    fn wrong_arity(&mut self, at: usize, id: u32, ty: &'static RecordType) {
        let stretch = self.stretch;
        let Some(head) = self.head(Id::Is(id), ty, at + 2) else {
            return;
        };
        let real_type = if stretch.record_type(at + 1).is_none() {
            FAULT
        } else {
            0
        };
        for wanted in self.ends(&head).into_iter().flatten() {
            let nearest = wanted.saturating_sub(MAX_NUMBERS_OFF).max(head.first);
            for end in nearest..=(wanted + MAX_NUMBERS_OFF).min(stretch.len()) {
                let bad = self.bad(ty, head.first, end);
                let doubts = self.doubts(&head, end).min(DOUBTS_OF_FAULT_MAX);
                if end >= wanted && end - bad as usize <= wanted {
                    let kinds = faults::wrong_kinds(stretch, ty, head.first, end);
                    let mistakes = bad.min(BAD_MAX).max(kinds) * FAULT + real_type;
                    if mistakes > 0 {
                        let price = mistakes + if kinds == 0 { doubts } else { 0 };
                        self.offer(
                            (at, end),
                            price,
                            (head.id, Some(ty)),
                            Diagnosis::Damaged { ty },
                        );
                    }
                    continue;
                }
                let verdict = Diagnosis::WrongArity {
                    ty,
                    got: end - head.first,
                    expected: wanted - head.first,
                };
                let off = MORE_OR_FEWER * end.abs_diff(wanted) as u32 - ONE_IS_LIKELY;
                let price = FAULT * (1 + bad.min(BAD_MAX)) + real_type + off + doubts;
                // The way does not name the type, since the type may be the mistake.
                self.offer((at, end), price, (head.id, None), verdict);
            }
        }
    }

    /// Tries a record with a wrong count.
    fn wrong_point_count(&mut self, at: usize, id: u32, ty: &'static RecordType) {
        let stretch = self.stretch;
        let id_price = self.ways.id(id, Some(ty), self.here);
        let head = self.head(Id::Is(id), ty, at + 2);
        let expected = head.map(|head| usize::try_from(ty.arity(head.count)).unwrap_or(usize::MAX));
        for end in at + 2..(at + REACH).min(stretch.len()) + 1 {
            if end < stretch.len() && stretch.read(end).is_none() {
                continue;
            }
            let got = end - at - 2;
            let verdict = match expected {
                Some(expected) if expected.abs_diff(got) <= MAX_NUMBERS_OFF => continue,
                Some(expected) => Diagnosis::WrongArity { ty, got, expected },
                None => Diagnosis::BadPointCount { ty },
            };
            // Whole points, with the count or without it.
            let per = ty.arity(1) as usize - 1;
            let whole = got > 0 && got % per <= 1;
            let price = got as u32 + if whole { WHOLE_POINTS } else { PARTS_OF_POINTS };
            let bad = self.bad(ty, at + 2, end).min(BAD_MAX);
            let price = FAULT * (1 + bad) + price + id_price;
            self.offer((at, end), price, (Id::Is(id), Some(ty)), verdict);
        }
    }

    /// Offers a record whose type number would be right with a minus sign.
    fn lost_sign(&mut self, at: usize, id: u32) {
        let code = self.stretch.sigs.get(at + 1).and_then(|s| s.int);
        let Some(ty) = code.and_then(|code| RecordType::by_code(-i64::from(code))) else {
            return;
        };
        let Some(head) = self.head(Id::Is(id), ty, at + 2) else {
            return;
        };
        for end in self.right_ends(&head) {
            let price = FAULT - SIGN_IS_LIKELY + self.doubts(&head, end).min(DOUBTS_OF_FAULT_MAX);
            self.offer(
                (at, end),
                price,
                (head.id, Some(ty)),
                Diagnosis::UnknownType,
            );
        }
    }

    /// Tries a record whose type would be another one with a minus sign.
    fn sign_of_known_type(&mut self, at: usize, id: u32, ty: &'static RecordType) {
        let meant = RecordType::by_code(-i64::from(ty.code)).filter(|t| t.code < 0);
        let Some(head) = meant.and_then(|meant| self.head(Id::Is(id), meant, at + 2)) else {
            return;
        };
        let count = self.head(head.id, ty, at + 2).map_or(2, |head| head.count);
        let expected = usize::try_from(ty.arity(count)).unwrap_or(usize::MAX);
        for end in self.right_ends(&head) {
            let got = end - head.first;
            let doubts = self.doubts(&head, end);
            if expected > got && doubts < DOUBTS_OF_FAULT_MAX {
                let verdict = Diagnosis::LostSign {
                    ty,
                    meant: head.ty,
                    got,
                    expected,
                };
                self.offer((at, end), FAULT + doubts, (head.id, Some(head.ty)), verdict);
            }
        }
    }

    /// Tries a record whose type is missing or wrong.
    fn wrong_type(&mut self, at: usize, id: u32) {
        let stretch = self.stretch;
        let ty = stretch.record_type(at + 1);
        let id_price = self.ways.id(id, None, self.here);
        for end in at + 2..(at + 2 + MAX_PARAMS).min(stretch.len()) + 1 {
            if end < stretch.len() && stretch.read(end).is_none() {
                continue;
            }
            let got = end - at - 2;
            let verdict = match ty {
                None => self.type_verdict(at + 1),
                Some(ty) if ty.params.len() == got || ty.is_counted() => continue,
                Some(ty) => Diagnosis::WrongArity {
                    ty,
                    got,
                    expected: ty.params.len(),
                },
            };
            // As many parameters as some type takes, with the token in the type's place or without it.
            let fits = [at + 1, at + 2].into_iter().flat_map(|first| {
                let types = self.types.get(end - first).map_or(&[][..], |types| types);
                types.iter().map(move |&ty| Head {
                    id: Id::Is(id),
                    ty,
                    count: 0,
                    first,
                })
            });
            let least = fits
                .map(|head| self.params(&head, end))
                .min()
                .unwrap_or(FITS_NO_TYPE);
            let length = UNTYPED * (end - at).min(COUNTED_MAX) as u32;
            let known = if ty.is_some() { A_TYPE_AFTER_ALL } else { 0 };
            let bad = faults::bad_price(stretch, at + 2, end);
            let price =
                FAULT + WRONG_TYPE + known + bad + id_price + least.min(FITS_NO_TYPE) + length;
            self.offer((at, end), price, (Id::Is(id), None), verdict);
        }
    }
}

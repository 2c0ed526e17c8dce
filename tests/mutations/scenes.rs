//! Scenes for mutants: records of all types, in lines, made from the table.

use super::rng::Rng;
use zpg::internals::syntax::table::{
    Constraint, Effect, Kind, Param, ParamKind, RECORD_TYPES, RecordKind, RecordType,
};

/// The tokens of each record of a scene without errors, of about so many records.
pub fn records(seed: u64, count: usize) -> Vec<Vec<String>> {
    let mut maker = Maker {
        rng: Rng::new(seed),
        records: Vec::new(),
        known: Vec::new(),
        next: 1,
    };
    // What other records refer to.
    for kind in [RecordKind::Colour, RecordKind::Optics, RecordKind::Camera] {
        maker.record(RecordType::of(kind), true);
    }
    let shape = RecordType::by_code(11).unwrap();
    maker.record(shape, true);
    maker.record(shape, true);
    while maker.records.len() + 2 < count {
        let ty = match maker.rng.chance(0.4) {
            true => RecordType::by_code([9, 11, 12, -1, -101, -103, -701][maker.rng.below(7)]),
            false => Some(&RECORD_TYPES[maker.rng.below(RECORD_TYPES.len())]),
        }
        .unwrap();
        // Files beside the scene are read; selections and projections have rules of their own.
        let apart = [
            RecordKind::Undefined,
            RecordKind::Render,
            RecordKind::ImageTexture,
            RecordKind::RotationMatrix,
            RecordKind::ProjectionMatrix,
        ];
        if !apart.contains(&ty.kind) {
            let new = maker.rng.chance(0.6);
            maker.record(ty, new);
        }
    }
    maker.record(RecordType::of(RecordKind::Render), true);
    maker.records
}

struct Maker {
    rng: Rng,
    records: Vec<Vec<String>>,
    known: Vec<(u32, Kind)>,
    next: u32,
}

impl Maker {
    fn any(&mut self, kinds: &[Kind]) -> Option<u32> {
        let of_kind = |k: &&(u32, Kind)| kinds.contains(&k.1);
        let found: Vec<u32> = self.known.iter().filter(of_kind).map(|k| k.0).collect();
        // Mostly what came last.
        let recent = found
            .len()
            .min(if self.rng.chance(0.7) { 4 } else { found.len() });
        (!found.is_empty()).then(|| found[found.len() - 1 - self.rng.below(recent)])
    }

    fn record(&mut self, ty: &'static RecordType, new: bool) {
        let fresh = self.next + 1 + self.rng.below(2) as u32;
        let (id, defines) = match ty.effect {
            Effect::Defines(Kind::Render) => (1, None),
            Effect::Defines(kind) => (fresh, Some(kind)),
            Effect::DefinesOrChanges(kind, _) if new => (fresh, Some(kind)),
            Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds) => match self.any(kinds) {
                Some(id) => (id, None),
                None => return,
            },
        };
        let count = 2 + self.rng.below(5);
        let mut tokens = vec![id.to_string(), ty.code.to_string()];
        let repeated = (ty.repeats.iter())
            .flat_map(|group| std::iter::repeat_n(group.iter(), count).flatten());
        let optional = self.rng.chance(0.5);
        let params: Vec<&'static Param> = (ty.params.iter().chain(repeated))
            .chain(ty.optional.iter().filter(|_| optional))
            .collect();
        for param in &params {
            let token = match param.kind {
                ParamKind::Real => self.real(param),
                ParamKind::Count => count.to_string(),
                ParamKind::Integer => self.integer(param),
                ParamKind::FileName => "a.png".to_owned(),
                ParamKind::Reference { kinds, or_none } => match self.any(kinds) {
                    _ if or_none && self.rng.chance(0.2) => "0".to_owned(),
                    Some(id) => id.to_string(),
                    None => return,
                },
            };
            tokens.push(token);
        }
        if params.len() == 6 && ty.code != -101 {
            self.order(&mut tokens, 3, ty);
        } else if ty.code == 5 {
            self.order(&mut tokens, 2, ty);
        }
        if ty.code == 9999 && params.len() == 8 {
            for i in 4..7 {
                tokens[i] = format!("-{}", 20 + i);
                tokens[i + 3] = format!("{}", 20 + i);
            }
        }
        if let Some(kind) = defines {
            self.next = fresh;
            self.known.push((id, kind));
        }
        self.records.push(tokens);
    }

    /// Lower bounds below upper ones.
    fn order(&mut self, tokens: &mut [String], n: usize, ty: &RecordType) {
        if matches!(ty.code, 5 | 12 | -601) {
            for i in 2..2 + n {
                let low = self.rng.below(9) as f64 - 6.0;
                let high = low + 1.0 + self.rng.below(4) as f64;
                (tokens[i], tokens[i + n]) = (low.to_string(), high.to_string());
            }
        }
    }

    fn real(&mut self, param: &Param) -> String {
        let x = match param.constraint {
            Constraint::Positive | Constraint::NonZeroScale => 0.5 * (1 + self.rng.below(6)) as f64,
            Constraint::ProfileRadius => 0.25 * self.rng.below(12) as f64,
            Constraint::Between(a, b) | Constraint::Within(a, b) => {
                a + (b - a) * (1 + self.rng.below(3)) as f64 / 10.0
            }
            Constraint::AtLeast(a) => a + 0.25 * self.rng.below(4) as f64,
            Constraint::Any | Constraint::Axis => match self.rng.chance(0.4) {
                true => self.rng.below(13) as f64 - 4.0,
                false => (self.rng.below(2000) as f64 - 1000.0) / 100.0,
            },
        };
        x.to_string()
    }

    fn integer(&mut self, param: &Param) -> String {
        let low = match param.constraint {
            Constraint::Within(a, _) | Constraint::AtLeast(a) => a as usize,
            _ => 1,
        };
        (low + self.rng.below(2)).to_string()
    }
}

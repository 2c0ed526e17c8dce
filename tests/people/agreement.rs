//! A finding and its first proposal speak of one thing: the proposal writes where the finding points.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Code, Diagnostic};
use zpg::internals::syntax::table::{Family, ParamKind, RECORD_TYPES, RecordKind, RecordType};

use super::messages::SLIPS;
use super::rules::with;
use super::{WRITERS, read, scenes, slips};
use crate::rng::Rng;
use crate::support::{cases, seeds};

/// What is wrong with the first proposal of a finding; `line`: where the finding's record is.
fn disagreement(d: &Diagnostic, text: &str) -> Option<String> {
    let first = d.fixes.first()?;
    let mut places = vec![d.span];
    places.extend(d.labels.iter().map(|l| l.span));
    let points = |at: zpg::internals::diagnostics::Span| places.iter().any(|p| p.touches(at));
    let agrees = match d.code {
        // Something is missing, or too much, anywhere in the record; or the whole record moves.
        Code::E008 | Code::E009 | Code::E107 => true,
        // A record that is missing goes above the one that needs it.
        Code::E101 if d.case == "missing-union" => true,
        // Nothing but the ID is said to be missing.
        Code::E005 if d.case == "lost" => first.edits.iter().all(|e| e.span.start == d.span.start),
        _ => first.edits.iter().any(|e| points(e.span)),
    };
    (!agrees).then(|| format!("{text}\n{}", super::said(d).join("\n")))
}

fn all_agree(text: &str, tried: &mut usize) {
    let analysis = read(text);
    for d in repair::proposals(&analysis).iter().filter(|d| d.is_error()) {
        *tried += usize::from(!d.fixes.is_empty());
        let wrong = disagreement(d, text);
        assert!(wrong.is_none(), "{}", wrong.unwrap());
    }
}

/// What a line is read as that has an ID, a type and a number too many or too few, where the ID is the type of a shape and
/// all of the line could be that shape without its ID.
#[test]
fn a_type_is_no_coordinate() {
    let mut tried = 0;
    // Operations, properties, textures, lights and cameras.
    let least = RECORD_TYPES.iter().filter(|ty| ty.code < -100);
    for ty in least.filter(|ty| ty.kind != RecordKind::Undefined) {
        for shape in RECORD_TYPES.iter().filter(|ty| ty.family == Family::Shape) {
            let (got, taken) = (shape.params.len().saturating_sub(1), ty.params.len());
            let words = |ty: &RecordType| ty.params.iter().any(|p| p.kind == ParamKind::FileName);
            if got == taken || got.abs_diff(taken) > 2 || shape.is_counted() || words(ty) {
                continue;
            }
            for number in ["1", "0.2"] {
                let line = format!(
                    "{} {}{}",
                    shape.code,
                    ty.code,
                    format!(" {number}").repeat(got)
                );
                let all = repair::proposals(&read(&with(12, &line)));
                let errors: Vec<_> = all.iter().filter(|d| d.is_error()).collect();
                assert!(errors.iter().all(|d| d.code != Code::E005), "{line}");
                tried += 1;
            }
        }
    }
    assert!(tried > 50, "{tried}");
}

#[test]
fn a_finding_speaks_of_what_its_first_proposal_puts_right() {
    let mut tried = 0;
    for &(line, new) in SLIPS {
        all_agree(&with(line, new), &mut tried);
    }
    for line in [
        "2 -401 0.2 0.2 0.2",
        "3 -401 0.2 0.2 0.2",
        "12 -401 0.2 0.2 0.2",
    ] {
        all_agree(&with(12, line), &mut tried);
    }
    for line in ["1 9999 9999 8 0 # all #", "1 9999 21 8 0 # all #"] {
        all_agree(&with(17, line), &mut tried);
    }
    // Two slips in one scene, too: what is said of one may be meant for the other.
    for seed in seeds("PEOPLE_AGREE", cases(0..10, 0..200)) {
        for scene in WRITERS {
            let mut rng = Rng::new(seed);
            let records = scene(&mut rng, 14);
            for slip in slips::ALL {
                let mut lines: Vec<String> = records.iter().map(scenes::Record::line).collect();
                for _ in 0..1 + rng.below(2) {
                    let i = rng.below(records.len());
                    if let Some(written) = (slip.make)(&mut rng, &records, i) {
                        lines[i] = written.line;
                    }
                }
                all_agree(&(lines.join("\n") + "\n"), &mut tried);
            }
        }
    }
    assert!(tried > 100, "{tried}");
}

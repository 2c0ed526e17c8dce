//! Slips that show on many lines, in random scenes.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::render::human::{self, Look};
use zpg::internals::diagnostics::{Code, Diagnostic, fixes};

use super::scenes::{Record, text};
use super::{WRITERS, read, values};
use crate::rng::Rng;
use crate::support::seeds;

/// Calls `each` with random scenes of both writers.
fn scenes(mut each: impl FnMut(&mut Rng, Vec<Record>)) {
    for seed in seeds("PEOPLE_WHOLE", 0..24) {
        for scene in WRITERS {
            let mut rng = Rng::new(seed);
            let records = scene(&mut rng, 8 + (seed as usize * 7) % 43);
            each(&mut rng, records);
        }
    }
}

fn errors(text: &str) -> Vec<Diagnostic> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).collect()
}

/// The only error, and what its first fix makes of a text.
#[track_caller]
fn mended(text: &str) -> (Diagnostic, String) {
    let errors = errors(text);
    let [error] = errors.as_slice() else {
        let found = errors.iter().map(|d| (d.span, super::said(d)));
        panic!("{text}\n{:?}", found.collect::<Vec<_>>());
    };
    let (fixed, _) = fixes::apply(text, error.fixes.first().into_iter());
    (error.clone(), fixed)
}

/// The places of the references of a record among its parameters.
fn references(code: i32) -> std::ops::Range<usize> {
    match code {
        -103..=-101 | -299 | -302 | -503 | 9999 => 0..2,
        -105 | -104 | -502 => 0..1,
        -399 => 2..4,
        _ => 0..0,
    }
}

/// Another ID in the place of one, wherever it is used.
fn renamed(records: &[Record], old: u32, new: u32) -> Vec<Record> {
    let mut all = records.to_vec();
    for r in &mut all {
        if r.id == old {
            r.id = new;
        }
        for p in &mut r.params[references(r.code)] {
            if *p == old.to_string() {
                *p = new.to_string();
            }
        }
    }
    all
}

fn is_definition(records: &[Record], i: usize) -> bool {
    records[..i].iter().all(|r| r.id != records[i].id)
}

#[test]
fn the_minus_of_all_types_or_of_a_kind_is_lost() {
    let mut kinds = 0;
    scenes(|_, records| {
        let codes: Vec<i32> = records.iter().map(|r| r.code).filter(|&c| c < 0).collect();
        let many = codes
            .iter()
            .find(|c| codes.iter().filter(|d| d == c).count() >= 3);
        for kind in [None, many.copied()] {
            let mut lost = records.clone();
            let mut count = 0;
            for r in lost.iter_mut().filter(|r| r.code < 0) {
                if kind.is_none_or(|k| k == r.code) {
                    r.code = -r.code;
                    count += 1;
                }
            }
            // The whole file has them from three on.
            if count < 3 || kind.is_none() && many.is_none() {
                continue;
            }
            let (error, fixed) = mended(&text(&lost));
            let what = (error.code, error.case);
            assert_eq!(what, (Code::E007, "minus"), "{}", text(&lost));
            assert_eq!(values(&fixed), values(&text(&records)));
            kinds += 1;
        }
    });
    assert!(kinds > 40, "{kinds}");
}

#[test]
fn all_minus_signs_are_dashes() {
    scenes(|rng, records| {
        let good = text(&records).replace("---", "*");
        // A few are each an error.
        if good.lines().filter(|l| l.contains('-')).count() < 3 {
            return;
        }
        let dash = if rng.chance(0.5) { "−" } else { "–" };
        let (error, fixed) = mended(&good.replace('-', dash));
        assert_eq!((error.code, error.case), (Code::E003, "dashes"));
        assert_eq!(fixed, good);
    });
}

#[test]
fn definitions_that_need_each_other() {
    let mut count = 0;
    scenes(|rng, records| {
        // Those that use an operation which is defined before.
        let uses: Vec<(usize, usize)> = (0..records.len())
            .flat_map(|i| (0..i).map(move |k| (k, i)))
            .filter(|&(k, i)| {
                let is_operation = |r: &Record| matches!(r.code, -103..=-101);
                let (a, b) = (&records[k], &records[i]);
                is_operation(a) && is_operation(b) && b.params.contains(&a.id.to_string())
            })
            .collect();
        let Some(&(first, second)) = uses.first() else {
            return;
        };
        let mut circle = records.clone();
        let own = records[first].id;
        let later = records[second].id;
        circle[first].params[rng.below(2)] = later.to_string();
        let text = text(&circle);
        let errors = errors(&text);
        let found: Vec<_> = errors.iter().map(|d| (d.code, d.case)).collect();
        assert_eq!(found, [(Code::E107, "cycle")], "{text}");
        let said = super::said(&errors[0]).concat();
        assert!(said.contains(&own.to_string()) && said.contains(&later.to_string()));
        count += 1;
    });
    assert!(count >= 20, "{count}");
}

#[test]
fn the_id_of_the_render_record_is_used_for_an_object() {
    scenes(|rng, records| {
        let definitions: Vec<usize> = (0..records.len() - 1)
            .filter(|&i| is_definition(&records, i))
            .collect();
        let old = records[*rng.pick(&definitions)].id;
        let (error, fixed) = mended(&text(&renamed(&records, old, 1)));
        assert_eq!((error.code, error.case), (Code::E105, "objects"));
        let found: Vec<_> = read(&fixed).findings().iter().map(|d| d.code).collect();
        assert_eq!(found, [], "{fixed}");
    });
}

#[test]
fn two_scenes_in_one_file() {
    scenes(|_, records| {
        let one = text(&records);
        let (error, fixed) = mended(&(one.clone() + &one));
        assert_eq!((error.code, error.case), (Code::E102, "scenes"));
        let analysis = read(&fixed);
        assert!(analysis.is_sound(), "{fixed}");
        let shapes = read(&one).scene.shapes.len();
        assert_eq!(analysis.scene.shapes.len(), 2 * shapes);
        // The second background may be.
        let source = &analysis.source;
        let line = |d: &Diagnostic| source.slice(source.line_span(source.line_index(d.span.start)));
        let is_object = |d: &&Diagnostic| !line(d).contains(" -701");
        let unused = analysis.findings().iter().filter(|d| d.code == Code::W310);
        assert_eq!(unused.filter(is_object).count(), 0, "{fixed}");
    });
}

/// The same where the scenes share no ID but that of the render record.
#[test]
fn two_scenes_with_ids_of_their_own() {
    let second = "102 -701 1 0 0\n104 12 4 0 0 5 1 1\n104 -701 1 0 0\n1 9999 104 102\n";
    let text = super::rules::SCENE.to_owned() + second;
    let (error, fixed) = mended(&text);
    assert_eq!((error.code, error.case), (Code::E102, "renders"));
    let drawn = text
        .replace("1 9999 8 2\n", "1 9999 105 2\n")
        .replace("1 9999 104 102\n", "105 -101 8 104\n");
    assert_eq!(fixed, drawn);
    assert!(read(&fixed).is_sound());
    // A second render record of the same objects makes no second scene.
    let all = repair::proposals(&read(&(super::rules::SCENE.to_owned() + "1 9999 7 0\n")));
    assert!(all.iter().all(|d| d.case != "renders"));
}

/// Twelve in a row lack the same number: twelve findings, of which people are shown the first.
#[test]
fn a_row_of_records_that_lack_the_same() {
    scenes(|rng, mut records| {
        let shape = *rng.pick(&[11, 12, 10, 5, 4]);
        let numbers = [0.5, 1.0, 2.0, 3.0, 4.0, 5.0];
        let count = match shape {
            12 => 6,
            10 => 3,
            _ => 4,
        };
        let most = records.iter().map(|r| r.id).max().unwrap();
        let row = (1..=12).map(|k| Record {
            id: most + k,
            code: shape,
            params: numbers[..count - 1].iter().map(f64::to_string).collect(),
            above: String::new(),
            behind: String::new(),
        });
        let at = records.len() - 1;
        records.splice(at..at, row);
        let text = text(&records);
        let analysis = read(&text);
        let found = repair::proposals(&analysis);
        let errors: Vec<_> = found.iter().filter(|d| d.is_error()).collect();
        assert_eq!(errors.len(), 12, "{text}\n{errors:#?}");
        assert!(errors.iter().all(|d| d.code == Code::E008), "{text}");
        let mut out = Vec::new();
        human::write(&mut out, &analysis.source, &found, Look::default()).unwrap();
        let printed = String::from_utf8(out).unwrap();
        assert_eq!(
            printed.matches("error[E008]: too few").count(),
            1,
            "{printed}"
        );
        assert!(
            printed.contains("11 more records like the one"),
            "{printed}"
        );
    });
}

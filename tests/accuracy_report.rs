//! What the report of `zpg accuracy` says, of rows that are made up.

use unicode_width::UnicodeWidthStr as _;
use zpg::internals::diagnostics::{Complaint, Language};
use zpg::internals::study::accuracy::advice::{advise, in_language};
use zpg::internals::study::accuracy::configurations::Axis;
use zpg::internals::study::accuracy::print::{html, terminal};
use zpg::internals::study::accuracy::report::{
    Budget, Checked, Goal, Machine, Noise, Reference, Report, Row, RowError, Skipped, mark_front,
};

/// A report of these rows: option, times the default, steps, pixels off; the first of each kind is the
/// default.
fn report_of(rows: &[(Axis, &'static str, f64, f64, usize)]) -> Report {
    let row = |&(axis, label, times, steps, off): &(Axis, &'static str, f64, f64, usize),
               default| Row {
        kind: axis.kind().name(),
        axis: axis.name(),
        setting: label.into(),
        seconds: None,
        cpu_seconds: None,
        times_default: Some(times),
        pixels_timed: 1000,
        rays_per_second: None,
        rays: 1000,
        uncertain: 0,
        samples_mean: 1.0,
        error: Some(RowError {
            steps,
            steps_interval: [steps; 2],
            rmse: steps / 255.0,
            relmse: 0.0,
            max: steps / 255.0,
            max_steps: steps,
            flip: 0.0,
            pixels: 1000,
            pixels_off: off,
            pixels_differ: if steps > 0.0 { 500 } else { 0 },
            wrong_object: None,
            median_ulp: None,
            max_ulp: None,
        }),
        default,
        pareto: false,
        same_as: None,
        below_reference: false,
        of: Some((axis.kind(), axis)),
        option: format!("--{} {label}", axis.name()),
    };
    let mut kinds = Vec::new();
    let rows = rows.iter().map(|r| {
        let is_first = !kinds.contains(&r.0.kind());
        kinds.push(r.0.kind());
        row(r, is_first)
    });
    let mut report = Report {
        version: 1,
        scene: "scene.zpg".into(),
        size: [40, 25],
        advice: String::new(),
        advice_parts: Vec::new(),
        goal: Goal {
            steps: 1.0,
            tolerance: 0.15,
        },
        noise: Noise {
            relative: 0.02,
            pairs: 6,
            estimator: "",
        },
        machine: Machine {
            cpu: String::new(),
            cores: 2,
            threads: 1,
            wall_over_cpu: Some(1.0),
            load: Vec::new(),
            build: "",
            version: "",
        },
        budget: Budget {
            asked_seconds: 1.0,
            predicted_seconds: 1.0,
            timed_seconds: 1.0,
            spent_seconds: 1.0,
            pixels_share: 1.0,
            tile: None,
            cut: Vec::new(),
        },
        reference: Default::default(),
        rows: rows.collect(),
        skipped: Vec::new(),
        effects: Vec::new(),
        objects: Vec::new(),
        pictures: Vec::new(),
        maps: None,
        picture: None,
        stopped: false,
    };
    mark_front(&mut report);
    advise(&mut report, Language::English);
    report
}

#[test]
fn advice_names_the_cheapest_way_to_the_goal_with_slack() {
    let report = report_of(&[
        (Axis::Samples, "1", 1.0, 7.4, 400),
        (Axis::Samples, "64", 64.0, 0.9, 20),
        (Axis::Adaptive, "0.02", 25.0, 1.01, 90),
        // More accurate, but not as fast within the noise.
        (Axis::Adaptive, "0.01", 57.0, 0.5, 30),
        (Axis::Depth, "10", 1.0, 0.05, 16),
        (Axis::Depth, "16", 1.04, 0.01, 0),
        (Axis::Precision, "f64", 1.0, 0.0, 0),
        (Axis::Precision, "f32", 1.01, 0.1, 21),
        (Axis::Precision, "dd", 10.0, 0.0, 0),
    ]);
    let text = |what: &str| {
        let part = report.advice_parts.iter().find(|a| a.what == what);
        part.map_or("", |a| a.text.as_str())
    };
    let limit = "The largest error of this picture comes from edges: with the default settings its pixels are off by \
                 7.40 steps (root mean square). A step is 1/255 of white, the smallest difference that an 8-bit \
                 picture can show. With `--adaptive 0.02` this error is 1.01 steps, and the picture takes 25 times as \
                 long as with the default settings. With `--samples 64` it is 0.90 steps, but the picture takes 64 \
                 times as long. With the default settings each other kind of error is below 0.060 steps.";
    assert_eq!(text("limit"), limit);
    assert_eq!(report.advice, limit);
    let change = "In 16 of the 1000 pixels that were looked at, the cut light makes a difference of more than a \
                  step. `--depth 16` puts 16 of them right for 4 % more time.";
    assert_eq!(text("change"), change);
    let numbers = "Doubles are enough here: double-double, which has twice as many digits, takes 10 times as long \
                   and gives the same picture. Single precision gets 21 pixels wrong and takes as long.";
    assert_eq!(text("numbers"), numbers);
    let front: Vec<&str> = (report.rows.iter().filter(|r| r.pareto))
        .map(|r| r.setting.as_str())
        .collect();
    // Of two that are as fast within the noise the more accurate one; 64 samples are dearer than adaptive 0.01.
    assert_eq!(front, ["1", "0.02", "0.01", "10", "16", "f64"]);
}

#[test]
fn advice_where_nothing_is_to_be_done_and_where_nothing_helps() {
    let enough = report_of(&[
        (Axis::Samples, "1", 1.0, 0.4, 0),
        (Axis::Samples, "4", 4.0, 0.1, 0),
        (Axis::Cutoff, "1/4096", 1.0, 0.01, 0),
        // Saves a third of the time unseen.
        (Axis::Cutoff, "1/256", 0.66, 0.05, 0),
        (Axis::Precision, "f64", 1.0, 0.0, 0),
    ]);
    assert!(
        enough.advice.starts_with("The default settings are enough"),
        "{}",
        enough.advice
    );
    let save =
        "`--cutoff 1/256` saves 34 % of the time, and no further pixel is off by more than a step.";
    assert_eq!(enough.advice_parts[1].text, save);
    let stopped = report_of(&[]);
    assert_eq!(
        stopped.advice,
        "No advice can be given: no measurement was finished."
    );
    let hopeless = report_of(&[
        (Axis::Samples, "1", 1.0, 30.0, 900),
        (Axis::Samples, "4", 4.0, 12.0, 800),
    ]);
    assert!(
        hopeless
            .advice
            .contains(
                "Even `--samples 4`, which takes 4.00 times as long as the default settings, leaves an error of \
                 12.0 steps."
            )
    );
    let wrong = {
        let mut report = report_of(&[(Axis::Samples, "1", 1.0, 30.0, 900)]);
        let checked = Checked {
            pixels: 120,
            wrong: 2,
            largest: 0.5,
            wrong_pixels: vec![[3, 4], [5, 6]],
            ..Checked::default()
        };
        let reference = Reference {
            checked: Some(checked),
            ..Reference::default()
        };
        report.reference.insert("numbers", reference);
        advise(&mut report, Language::English);
        report
    };
    // Nothing else is said.
    assert_eq!(wrong.advice_parts.len(), 1);
    assert!(
        wrong.advice.starts_with("The reference is wrong")
            && wrong.advice.contains("(3, 4), (5, 6)")
    );
}

/// Errors that were not measured are not called small.
#[test]
fn advice_about_chosen_axes_speaks_of_these() {
    let mut report = report_of(&[(Axis::Depth, "10", 1.0, 0.02, 0)]);
    let asked = |axis: &&Axis| **axis == Axis::Depth;
    let unasked = Axis::ALL.iter().filter(|axis| !asked(axis));
    report.skipped = unasked
        .map(|axis| Skipped {
            axis: axis.name(),
            why: Complaint::new("accuracy-skip-unasked"),
        })
        .collect();
    let said = [Language::English, Language::Czech].map(|l| in_language(&report, l).advice);
    assert!(
        said[0].starts_with("Of what was measured (depth), nothing reaches 1 step of"),
        "{}",
        said[0]
    );
    assert!(
        said[1].starts_with("Z toho, co se měřilo (depth), nedosahuje"),
        "{}",
        said[1]
    );
    // What the scene does not have needs no measuring.
    for skipped in &mut report.skipped {
        skipped.why = Complaint::new("accuracy-skip-light");
    }
    let said = in_language(&report, Language::English).advice;
    assert!(
        said.contains("no kind of error reaches 1 step of"),
        "{said}"
    );
}

/// Times of a machine whose processor others had are not to be relied on.
#[test]
fn a_busy_machine_is_named() {
    let rows = [
        (Axis::Samples, "1", 1.0, 7.4, 400),
        (Axis::Samples, "64", 64.0, 0.9, 20),
    ];
    let busy = |wall_over_cpu| {
        let mut report = report_of(&rows);
        report.machine.wall_over_cpu = wall_over_cpu;
        advise(&mut report, Language::English);
        let part = report.advice_parts.iter().find(|a| a.what == "busy");
        part.map(|a| a.text.clone())
    };
    for quiet in [None, Some(1.0), Some(1.3)] {
        assert_eq!(busy(quiet), None);
    }
    let said = busy(Some(1.8)).unwrap();
    assert!(
        said.contains("The machine was too busy") && said.contains("1.80 times"),
        "{said}"
    );
}

/// What is said of times is the same everywhere: on a busy machine they are not "sure to ±1 %".
#[test]
fn times_of_a_busy_machine_are_not_sure() {
    let rows = [(Axis::Samples, "1", 1.0, 7.4, 400)];
    for (wall_over_cpu, sure) in [(1.0, true), (2.5, false)] {
        let mut report = report_of(&rows);
        report.machine.wall_over_cpu = Some(wall_over_cpu);
        advise(&mut report, Language::English);
        for text in [
            terminal::text(&report, Language::English, None, 80),
            html::text(&report, Language::English),
        ] {
            assert_eq!(text.contains("times are sure to ±"), sure, "{text}");
            assert_eq!(text.contains("times are rough"), !sure, "{text}");
        }
    }
}

/// All sentences about one time say the same, and none claims a saving on a busy machine.
#[test]
fn sentences_about_times_agree() {
    let said = |rows: &[(Axis, &'static str, f64, f64, usize)], busy: f64| {
        let edges = [(Axis::Samples, "1", 1.0, 7.4, 400)];
        let mut report = report_of(&[&edges, rows].concat());
        report.machine.wall_over_cpu = Some(busy);
        advise(&mut report, Language::English);
        let parts = report.advice_parts.iter();
        parts.map(|a| a.text.clone()).collect::<Vec<_>>().join("\n")
    };
    let none = "No other setting of `zpg render` saves a tenth";
    // Single precision saves a third, and nobody sees it.
    let rows = [
        (Axis::Depth, "10", 1.0, 0.0, 0),
        (Axis::Depth, "3", 1.24, 0.0, 0),
        (Axis::Precision, "f64", 1.0, 0.0, 0),
        (Axis::Precision, "f32", 0.67, 0.3, 0),
    ];
    let text = said(&rows, 1.0);
    assert!(
        !text.contains(none) && text.matches("saves 33 %").count() == 1,
        "{text}"
    );
    assert!(!text.contains("24 %"), "{text}");
    assert!(
        text.contains("is more than enough, but less saves no time"),
        "{text}"
    );
    let text = said(&rows, 2.0);
    assert!(!text.contains(none) && !text.contains("saves"), "{text}");
    // What is written as a tenth is one.
    let rows = [
        (Axis::Depth, "10", 1.0, 0.0, 0),
        (Axis::Depth, "3", 0.904, 0.0, 0),
    ];
    let text = said(&rows, 1.0);
    assert!(
        !text.contains(none) && text.contains("saves 10 %"),
        "{text}"
    );
}

#[test]
fn advice_says_whether_the_depth_is_right() {
    // The first row of a kind is the default.
    let said = |rows: &[(Axis, &'static str, f64, f64, usize)]| {
        let edges = [(Axis::Samples, "1", 1.0, 7.4, 400)];
        let report = report_of(&[&edges, rows].concat());
        let all = report
            .advice_parts
            .iter()
            .filter(|a| a.text.contains("depth"));
        all.map(|a| a.text.clone()).collect::<Vec<_>>().join("|")
    };
    // Three reflections are all that there are, and four take as long.
    let shallow = said(&[
        (Axis::Depth, "10", 1.0, 0.0, 0),
        (Axis::Depth, "2", 0.9, 3.0, 70),
        (Axis::Depth, "3", 0.97, 0.01, 0),
        (Axis::Depth, "4", 1.0, 0.0, 0),
        (Axis::Depth, "16", 1.0, 0.0, 0),
    ]);
    assert_eq!(
        shallow,
        "A depth of 10, the default, is more than enough: `--depth 3` shows the same to the eye and saves 3 %."
    );
    // Glass in glass: dearer than what is proposed as a repair.
    let deep = said(&[
        (Axis::Depth, "10", 1.0, 0.5, 60),
        (Axis::Depth, "8", 0.8, 0.9, 90),
        (Axis::Depth, "16", 1.6, 0.2, 9),
        (Axis::Depth, "32", 2.5, 0.2, 9),
    ]);
    assert_eq!(
        deep,
        "A depth of 10, the default, cuts light that can be seen: `--depth 16` puts 51 of 60 pixels right, and the \
         picture takes 1.60 times as long."
    );
    let right = said(&[
        (Axis::Depth, "10", 1.0, 0.0, 0),
        (Axis::Depth, "8", 0.8, 0.9, 90),
        (Axis::Depth, "16", 1.0, 0.0, 0),
    ]);
    assert_eq!(
        right,
        "A depth of 10, the default, is enough, and with less the picture changes."
    );
    // Where it is said already, as a repair, it is not said again.
    let repaired = said(&[
        (Axis::Depth, "10", 1.0, 0.05, 16),
        (Axis::Depth, "16", 1.04, 0.01, 0),
    ]);
    assert!(
        repaired.starts_with("In 16 of the") && !repaired.contains('|'),
        "{repaired}"
    );
    assert_eq!(said(&[]), "");
}

/// At 80 columns without bars, at 120 with them; entries keep the points between them.
#[test]
fn the_report_fits_the_terminal() {
    let mut report = report_of(&[
        (Axis::Samples, "1", 1.0, 7.4, 400),
        (Axis::Samples, "64", 64.0, 0.9, 20),
        (Axis::Adaptive, "0.02", 25.0, 1.01, 90),
        (Axis::Precision, "plain-f64", 0.8, 0.2, 3),
        (Axis::Precision, "f64", 1.0, 0.0, 0),
    ]);
    report.scene = "scenes/".to_owned() + &"long/".repeat(12) + "scene.zpg";
    report.machine.load = vec![0.5, 1.5];
    report.budget.pixels_share = 0.06;
    for (axis, why) in [
        ("depth", "accuracy-skip-light"),
        ("cutoff", "accuracy-skip-light"),
        ("solver", "accuracy-skip-solver"),
        ("tessellation", "accuracy-skip-flat"),
        ("levels", "accuracy-skip-levels"),
    ] {
        let why = Complaint::new(why);
        report.skipped.push(Skipped { axis, why });
    }
    for language in [Language::English, Language::Czech] {
        let report = in_language(&report, language);
        for width in [80, 120] {
            let page = "The page is scene-accuracy/accuracy.html";
            let text = terminal::text(&report, language, Some(page), width);
            for line in text.lines() {
                assert!(
                    line.width() <= width || line.contains("scenes/long"),
                    "{width}: {line}"
                );
            }
            assert_eq!(text.contains('█'), width == 120, "{text}");
            // What is not run for one reason stands together, and no point alone in a line.
            assert!(text.contains("\n  depth, cutoff: "), "{text}");
            assert!(!text.contains("\n  ·"), "{text}");
            let not_run = text.lines().skip_while(|l| !l.contains("cutoff: "));
            let not_run: Vec<&str> = not_run.take(4).collect();
            let entries = not_run.join(" ").matches(" · ").count()
                + not_run.join("\n").matches(" ·\n").count();
            assert!(entries >= 3, "{not_run:?}");
            assert!(text.matches(" ·").count() >= 3 + 3 + 2, "{text}");
        }
    }
}

/// What is wider than a telephone scrolls in a box of its own: the tables. All else bends.
#[test]
fn tables_of_the_page_scroll_by_themselves() {
    let report = report_of(&[
        (Axis::Samples, "1", 1.0, 7.4, 400),
        (Axis::Samples, "64", 64.0, 0.9, 20),
    ]);
    let page = html::text(&report, Language::English);
    let tables = page.matches("<table>").count();
    assert!(tables >= 1);
    assert_eq!(page.matches("<div class=\"wide\"><table>").count(), tables);
    assert_eq!(page.matches("</table></div>").count(), tables);
    assert!(page.contains(".wide{overflow-x:auto}") && page.contains("max-width:100%"));
    // What may not break is in tables only.
    for rule in page.split('}').filter(|rule| rule.contains("nowrap")) {
        let selector = rule.split('{').next().unwrap();
        assert!(selector.contains("td"), "{rule}");
    }
}

//! The integration tests, in one program: it is linked once, and its tests run side by side.

// What tests share.
mod any_files;
mod campaign;
mod exact;
mod examples;
mod support;
mod trace_support;

pub use campaign::rng;

mod accuracy;
mod accuracy_report;
mod allowing;
mod architecture;
mod check;
mod clean_scenes;
mod cli;
mod commenting;
mod convert_glb;
mod convert_json;
mod convert_mesh;
mod course;
mod crosscheck;
mod czech;
mod drawing;
mod editors;
mod emitted;
mod explain_examples;
mod extension;
mod extreme_numbers;
mod farm;
mod farm_page;
mod features;
mod fixes;
mod formatting;
mod frames;
mod gallery;
mod glossary;
mod grammar;
mod hand_over;
mod handout;
mod hard_cases;
mod hard_scenes;
mod invariance;
mod lamps;
mod licences;
mod lint_generated;
mod lint_large;
mod lint_media;
mod lint_overlaps;
mod lint_rules;
mod lint_views;
mod lsp;
mod memory;
mod mesh;
mod mesh_precision;
mod messages;
mod metamorphic;
mod mitsuba;
mod mutations;
mod never_worse;
mod new;
mod options;
mod outputs;
mod packages;
mod parts;
mod people;
mod picture_files;
mod pictures;
mod places;
mod plan;
mod portable;
mod pov_brightness;
mod pov_contacts;
mod pov_render;
mod pov_scale;
mod pov_scenes;
mod pov_shapes;
mod pov_within;
mod pre_commit;
mod probe;
mod projections;
mod random_lines;
mod readme;
mod recovery;
mod render_output;
mod reports;
mod rewriting;
mod robustness;
mod ruff;
mod sarif;
mod scene_json;
mod scenes_or_not;
mod shapes_doubt;
mod shapes_quadrics;
mod sheet;
mod staging;
mod strangers;
mod stretched;
mod surfaces;
mod trace_pictures;
mod trace_solids;
mod unseen;
mod widths;
mod work;

/// A file that is not listed above would never run.
#[test]
fn every_file_takes_part() {
    let text = include_str!("main.rs");
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if name != "main" && path.extension().is_some_and(|e| e == "rs") {
            assert!(text.contains(&format!("\nmod {name};\n")), "{name}");
        }
    }
}

/// Tests do not depend on the language of whoever runs them.
#[test]
fn the_program_is_run_in_english() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let variable = ["CARGO_BIN", "EXE_zpg"].join("_");
    for entry in ignore::Walk::new(root) {
        let path = entry.unwrap().into_path();
        let is_source = path.extension().is_some_and(|e| e == "rs");
        if is_source {
            let text = std::fs::read_to_string(&path).unwrap();
            let sets_it = text.contains("env(\"LC_ALL\", \"C\")");
            assert!(!text.contains(&variable) || sets_it, "{}", path.display());
        }
    }
}

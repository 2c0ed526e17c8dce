//! The hard cases: scenes and rays that break ray tracers, in every precision.
//!
//! `hard_cases/rows.json` lists them all. A row has single rays with the t of their crossings, or
//! names a function below that makes many rays, or both. Besides the typed answers every one is
//! held to an exact evaluation of the same scene ([`exact`]). Where single precision has an answer
//! of its own, mostly because the numbers of the row do not exist in it, `f32` says which and why.

mod ask;
mod leaving;
mod pictures;
mod programs;
mod sets;

use crate::exact;
use crate::support::cases;
use crate::trace_support;
use ask::{Precision, Ray, ask, data, exact as exact_of, held, orderly};
use serde_json::Value;
use std::collections::BTreeSet;

fn rows() -> Vec<Value> {
    let text = std::fs::read_to_string(data("rows.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// One row's single rays.
fn check(row: &Value, precision: Precision) {
    let scene = data(row["scene"].as_str().unwrap());
    let title = format!("row {}, {}", row["row"], row["title"]);
    let cases = row["rays"].as_array().unwrap();
    let rays: Vec<Ray> = cases
        .iter()
        .map(|c| Ray::parse(c["ray"].as_str().unwrap()))
        .collect();
    let exact = (row["exact"] != false).then(|| exact_of(&scene));
    let answers = ask(&scene, None, &rays, precision);
    for ((case, ray), said) in cases.iter().zip(&rays).zip(&answers) {
        let own = precision == Precision::F32 && !case["f32"].is_null();
        let right = if own { &case["f32"] } else { case };
        let typed = right["t"].as_array().unwrap();
        orderly(said, &title);
        if let (Some(exact), true) = (&exact, right["exact"] != false) {
            held(exact, *ray, said, precision, &title);
        }
        let what = format!(
            "{title} in {}: {:?} for {typed:?}",
            precision.name(),
            said.t()
        );
        assert_eq!(said.hits.len(), typed.len(), "{what}");
        // The typed digits, and in single precision its own rounding of the whole way.
        let rounding = match precision {
            Precision::F32 => 64.0 * precision.epsilon(),
            _ => 0.0,
        };
        let within = right["within"].as_f64().unwrap_or(0.0);
        let far = (0..3).map(|i| ray.origin[i].abs()).fold(1.0, f64::max);
        for (t, typed) in said.t().iter().zip(typed) {
            // Only the exact evaluation knows the others.
            if let Some(typed) = typed.as_f64() {
                let within = within + rounding * far.max(typed);
                assert!((t - typed).abs() <= within, "{what}");
            }
        }
    }
}

fn table(precision: Precision) {
    let mut rays = 0;
    for row in rows().iter().filter(|r| !r["rays"].is_null()) {
        check(row, precision);
        rays += row["rays"].as_array().unwrap().len();
    }
    assert!(rays >= 35, "{rays}");
}

/// Every program in the precisions it is for.
macro_rules! programs {
    ($($module:ident::$name:ident in $($precision:ident)+;)+) => {
        const PROGRAMS: &[&str] = &[$(stringify!($name)),+];
        programs!(@ in_f64 F64 $(($module $name $($precision)+))+);
        programs!(@ in_f32 F32 $(($module $name $($precision)+))+);
        programs!(@ in_dd Dd $(($module $name $($precision)+))+);
    };
    (@ $folder:ident $wanted:ident $($rest:tt)+) => {
        mod $folder {
            use super::*;
            #[test]
            fn table() {
                super::table(Precision::$wanted);
            }
            $(programs!(# $folder $rest);)+
        }
    };
    (# in_f64 ($module:ident $name:ident f64 $($more:ident)*)) => {
        programs!(! $module $name F64);
    };
    (# in_f32 ($module:ident $name:ident f64 f32 $($more:ident)*)) => {
        programs!(! $module $name F32);
    };
    (# in_dd ($module:ident $name:ident f64 $(f32)? dd)) => {
        programs!(! $module $name Dd);
    };
    (# $folder:ident $other:tt) => {};
    (! $module:ident $name:ident $wanted:ident) => {
        #[test]
        fn $name() {
            $module::$name(Precision::$wanted);
        }
    };
}

programs! {
    programs::row_09_hole_of_a_tiny_torus in f64 f32 dd;
    programs::row_10_torus_from_afar in f64 dd;
    programs::row_11_thin_torus_from_afar in f64 dd;
    programs::row_15_sphere_from_afar in f64 dd;
    programs::row_17_rim_of_a_distant_sphere in f64 dd;
    leaving::row_18_leave_a_small_sphere in f64 f32 dd;
    programs::row_22_clipped_paraboloid in f64 f32 dd;
    pictures::row_24_box_above_a_plane in f64 f32 dd;
    pictures::row_25_sheet_above_a_receiver in f64 f32 dd;
    pictures::row_26_corner_of_a_glass_box in f64 f32 dd;
    sets::row_27_to_30_equal_faces in f64 f32 dd;
    programs::row_31_sliver in f64 dd;
    pictures::row_32_equal_spheres_cost_nothing in f64 f32 dd;
    programs::row_34_seams_of_a_lathe in f64 f32 dd;
    programs::row_36_geodesic_vertices_and_edges in f64 f32 dd;
    sets::row_37_identities in f64 f32 dd;
    programs::row_38_scaled_moved_turned in f64 dd;
    leaving::row_39_leave_everything in f64 f32 dd;
}

#[test]
fn every_row_is_tested() {
    let rows = rows();
    let numbers: BTreeSet<u64> = rows.iter().map(|r| r["row"].as_u64().unwrap()).collect();
    assert!(numbers.into_iter().eq(1..=39));
    for row in &rows {
        let program = row["program"].as_str();
        assert!(program.is_some() || !row["rays"].is_null(), "{row}");
        assert!(program.is_none_or(|p| PROGRAMS.contains(&p)), "{row}");
    }
    for program in PROGRAMS {
        assert!(rows.iter().any(|r| r["program"] == *program), "{program}");
    }
}

use super::*;
use crate::solids::bounds::node_bounds;
use crate::solids::staging::Viewpoint;
use crate::syntax::Captions;
use crate::testing::scene;
use crate::trace::selected_camera;
use crate::translate::mitsuba::{self, Integrator};

const SIZE: (u32, u32) = (64, 48);

/// Two balls, one on each half of the picture.
const BALLS: &str = "2 11 -1.5 0 0 1\n3 11 1.5 0 0 1\n4 -101 2 3\n\
                     5 -501 0 0 8 0 0 -1 0 1 0 45\n1 9999 4 0\n";

/// Two boxes, of which the right half of the first is the left half of the second.
const BOXES: &str = "2 12 -2 -1 -1 0.5 1 0\n3 12 -0.5 -1 -2 2 1 0\n4 -101 2 3\n\
                     5 -501 0 0 8 0 0 -1 0 1 0 45\n1 9999 4 0\n";

/// The comparison of the balls once `change` was made to the channels of all pixels.
fn compared(change: impl Fn(&Output, &mut [f32])) -> Comparison {
    compared_in(BALLS, change)
}

/// The comparison with a picture that Mitsuba would draw without a mistake, once `change` was made to the channels
/// of all pixels.
fn compared_in(text: &str, change: impl Fn(&Output, &mut [f32])) -> Comparison {
    let scene = scene(text);
    let tracer = Tracer::new(&scene).unwrap();
    let options = mitsuba::Options {
        size: SIZE,
        viewpoint: Viewpoint::Scene,
        depth: 10,
        tolerance: None,
        memory: None,
        integrator: Integrator::Aov,
        stem: "scene".to_owned(),
        captions: Captions::default(),
    };
    let made = mitsuba::write(&scene, &node_bounds(&scene), &tracer, &options).unwrap();
    let camera = selected_camera(&scene, 4.0 / 3.0);
    let ours = seen(&tracer, &camera, SIZE);
    let mut theirs: Vec<f32> = ours.iter().flat_map(|s| channels(&made, *s)).collect();
    change(&made, &mut theirs);
    compare(&tracer, &camera, &ours, &theirs, SIZE, &made).unwrap()
}

fn channels(made: &Output, seen: Option<VisiblePoint>) -> [f32; CHANNELS] {
    let Some(s) = seen else {
        return [0.0; CHANNELS];
    };
    let same = |i: &ShapeInfo| (i.shape, i.object) == (s.shape, s.object);
    let index = made.shapes.iter().position(same).unwrap() + 1;
    let [x, y, z] = made.frame.place(s.point).map(|x| x as f32);
    let [nx, ny, nz] = s.normal.map(|x| x as f32);
    [x, y, z, nx, ny, nz, index as f32]
}

/// The middle of the left ball.
const MIDDLE: usize = CHANNELS * (24 * 64 + 19);

#[test]
fn the_same_is_right() {
    let all = compared(|_, _| {});
    assert_eq!((all.wrong, all.undecided, all.meshes.pixels), (0, 0, 0));
    assert!(all.exact.pixels > 100, "{:?}", all.exact);
    assert!(all.exact.distance < 1e-6 && all.exact.angle < 0.05);
}

#[test]
fn another_place_is_wrong() {
    // The scene is five long, of which a ten-thousandth is allowed.
    for (towards_us, wrong) in [(4e-4, 0), (7e-4, 1), (-7e-4, 1), (0.5, 1)] {
        let moved = compared(|made, theirs| {
            assert!(theirs[MIDDLE + 6] > 0.0);
            theirs[MIDDLE + 2] += (towards_us * made.frame.scale) as f32;
        });
        assert_eq!(moved.wrong, wrong, "{towards_us}: {:?}", moved.exact);
    }
}

#[test]
fn another_normal_is_wrong() {
    for (turned, wrong) in [(0.1f32, 0), (0.3, 1), (90.0, 1)] {
        let (sin, cos) = turned.to_radians().sin_cos();
        let other = compared(|_, theirs| {
            let [x, z] = [theirs[MIDDLE + 3], theirs[MIDDLE + 5]];
            theirs[MIDDLE + 3] = cos * x + sin * z;
            theirs[MIDDLE + 5] = cos * z - sin * x;
        });
        assert_eq!(other.wrong, wrong, "{turned}: {:?}", other.exact);
    }
    let all = compared(|_, theirs| {
        for pixel in theirs.chunks_mut(CHANNELS) {
            pixel[3..6].copy_from_slice(&[1.0, 0.0, 0.0]);
        }
    });
    assert!(all.wrong > 100);
}

/// A solid's normal points out of it; that of a surface without an inside points to either side.
#[test]
fn the_other_side_of_a_solid_is_wrong() {
    let turned = |_: &Output, theirs: &mut [f32]| {
        for at in &mut theirs[MIDDLE + 3..MIDDLE + 6] {
            *at = -*at;
        }
    };
    assert_eq!(compared(turned).wrong, 1);
    let sheet = "2 5 -2 -1 2 1\n5 -501 0 0 8 0 0 -1 0 1 0 45\n1 9999 2 0\n";
    let all = compared_in(sheet, turned);
    assert_eq!((all.wrong, all.left_out() > 0), (0, true));
    // In the pit of a bitten ball ours points at the eye, out of what is left.
    let bitten = scene(
        "2 11 0 0 0 1\n3 11 0 0 1 0.5\n4 -103 2 3\n5 -501 0 0 8 0 0 -1 0 1 0 45\n1 9999 4 0\n",
    );
    let tracer = Tracer::new(&bitten).unwrap();
    let pixels = seen(&tracer, &selected_camera(&bitten, 4.0 / 3.0), SIZE);
    let pit = pixels[24 * 64 + 32].unwrap();
    assert!(pit.is_of_solid && pit.normal[2] > 0.95, "{pit:?}");
}

#[test]
fn another_shape_is_wrong() {
    let other = compared(|_, theirs| theirs[MIDDLE + 6] = 3.0 - theirs[MIDDLE + 6]);
    assert_eq!((other.wrong, other.undecided), (1, 0));
    let nothing = compared(|_, theirs| theirs[MIDDLE..][..CHANNELS].fill(0.0));
    assert_eq!((nothing.wrong, nothing.undecided), (1, 0));
    let corner = compared(|_, theirs| {
        let (pixels, _) = theirs.split_at_mut(CHANNELS);
        pixels[6] = 1.0;
    });
    assert_eq!((corner.wrong, corner.undecided), (1, 0));
}

#[test]
fn of_surfaces_in_one_place_either_may_be_seen() {
    // In the middle both boxes are; a quarter of the picture to the left, the first alone.
    let middle = CHANNELS * (24 * 64 + 32);
    let swapped = |at: usize, by: f32| {
        compared_in(BOXES, move |_, theirs| {
            theirs[at + 6] = 3.0 - theirs[at + 6];
            theirs[at + 2] += by;
        })
    };
    let both = swapped(middle, 0.0);
    let shared = Shared {
        shapes: [2, 3],
        pixels: 1,
    };
    assert_eq!((both.wrong, both.undecided, both.in_one_place), (0, 0, 1));
    assert_eq!(both.shared, [shared]);
    // Not in that place.
    let behind = swapped(middle, -0.1);
    assert_eq!((behind.wrong, behind.in_one_place), (1, 0));
    let alone = swapped(CHANNELS * (24 * 64 + 20), 0.0);
    assert_eq!((alone.wrong, alone.in_one_place), (1, 0));
}

#[test]
fn what_is_nowhere_certain_is_no_answer() {
    let all = compared_in(BOXES, |_, _| {});
    assert!(all.tells() && all.in_one_place == 0);
    // Two sheets in one place.
    let sheets = "2 5 -2 -1 2 1\n3 5 -2 -1 2 1.5\n4 -101 2 3\n5 -501 0 0 8 0 0 -1 0 1 0 45\n\
                  1 9999 4 0\n";
    let other = compared_in(sheets, |_, theirs| {
        for pixel in theirs.chunks_exact_mut(CHANNELS).filter(|p| p[6] == 1.0) {
            pixel[6] = 2.0;
        }
    });
    assert_eq!(other.wrong, 0);
    assert!(other.in_one_place > 300 && !other.tells(), "{other:?}");
}

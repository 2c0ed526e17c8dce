//! W324: all that is drawn lies behind the camera, or beside what it sees.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::array::{cross, dot, length, sub, unit};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::{angle_in_radians, camera_in_solid};
use crate::lint::spelling::{decimal, near, opposite};
use crate::scene::record::Params;
use crate::scene::target::target_by_comment;
use crate::scene::{Camera, Node, NodeId, Scene, Vec3};
use crate::syntax::quote;
use crate::syntax::table::RecordKind;
use crate::trace::plan::unseen::view::{OutOfView, Parts, USUAL, held, out_of_view};

/// Least cosine of the angle between two directions that are meant as one.
const AIMED: f64 = 0.9;
/// Least cosine of the angle between the direction of a camera and the way to the middle, for a camera that is aimed at
/// the middle.
pub(super) const AIMED_AT_MIDDLE: f64 = 0.97;
/// The greatest length of directions as people write them: most have the length 1, or one component 1 and another one a
/// part of 1.
pub(super) const LONGEST_WRITTEN: f64 = 1.5;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    for (camera, p) in chosen_cameras(context) {
        // Another rule reports an angle of view that looks like radians.
        if angle_in_radians::meant(context, camera, &p).is_some() {
            continue;
        }
        let is_written = p.ty.kind == RecordKind::Camera;
        let seen = |of| out_of_view(scene, context.bounds(), render.root, camera, of);
        let unseen = seen(Parts::All);
        // An endless floor is seen from almost everywhere, so the bounded objects are judged without it.
        let ended = || seen(Parts::Bounded);
        let Some(side) = unseen.or_else(ended) else {
            continue;
        };
        let span = match is_written {
            true => p.span_of(3, 3),
            false => p.span(),
        };
        let finding = Diagnostic::new(Code::W324, span);
        let finding = match unseen {
            Some(side) => finding.with("where", name(side)),
            None => finding.case("unbounded"),
        };
        // A camera in a solid has to be moved first.
        let is_inside = is_written && camera_in_solid::cameras(context).contains(&camera.id);
        let fixes = match is_written && !is_inside {
            true => turned(context, render.root, camera, &p, side),
            false => Vec::new(),
        };
        // A mirror may show what lies behind the camera, so the direction may be meant.
        let may_be_meant = fixes.iter().all(|f| f.title == "fix") && has_mirror(scene);
        if unseen.is_none() && (is_inside || may_be_meant) {
            continue;
        }
        let fixes = match is_written && !is_inside {
            true => with_other_places(context, render.root, camera, &p, fixes),
            false => fixes,
        };
        let finding = match unseen.is_none() && fixes.is_empty() {
            true => {
                (finding.case("unbounded-elsewhere")).with("way", way(context, render.root, camera))
            }
            false => finding,
        };
        let finding = finding
            .with("id", camera.id.to_string())
            .with("width", USUAL[0].to_string())
            .with("height", USUAL[1].to_string());
        out.push(fixes.into_iter().fold(finding, Diagnostic::fix));
    }
}

/// The direction from a camera to the middle of the bounded objects, as a message writes it.
fn way(context: &Context, root: NodeId, camera: &Camera) -> String {
    let middle = context.bounds()[root as usize].bounded().centre();
    let way = sub(middle, camera.position);
    let numbers = way.map(|x| near(x, length(way)));
    quote(&numbers.join(" "))
}

/// Whether a paint of the scene reflects light.
fn has_mirror(scene: &Scene) -> bool {
    scene.nodes.iter().any(|node| match node {
        Node::Paint { paint, .. } => {
            let optics = scene.paints[*paint as usize].optics;
            optics.is_some_and(|o| o.ks != [0.0; 3])
        }
        _ => false,
    })
}

/// The name of a side in messages.
pub(super) fn name(side: OutOfView) -> &'static str {
    match side {
        OutOfView::Behind => "behind",
        OutOfView::Left => "left",
        OutOfView::Right => "right",
        OutOfView::Above => "above",
        OutOfView::Below => "below",
        OutOfView::Beside => "beside",
    }
}

/// Fixes that turn the camera towards what is drawn, or towards the bounded objects: direction and up vector are
/// exchanged, components of the direction get the other sign, the direction is read as a point to look at, or the
/// camera looks at the middle. The point comes first if a comment speaks of one. Empty if a transformation moves the
/// camera.
fn turned(
    context: &Context,
    root: NodeId,
    camera: &Camera,
    p: &Params,
    side: OutOfView,
) -> Vec<Fix> {
    if is_moved(camera, p) {
        return Vec::new();
    }
    let ended = context.bounds()[root as usize].bounded();
    let of = to_be_seen(context, root);
    let swapped = Vec::from_iter(swapped(context, root, camera, p, of));
    let sees = |way: Vec3| sees(context, root, camera, way, of);
    let signs = signs(camera.direction, side, sees);
    let mut fixes = Vec::from_iter(signs.map(|signs| with_signs(signs, p)));
    let to_point = turned_to_point(camera, p, sees);
    let said = to_point.clone().filter(|_| target_by_comment(p).is_some());
    fixes.extend(to_point);
    let way = sub(ended.centre(), camera.position);
    // A direction that is a place among the bounded objects is rather a point to look at, unless the opposite direction
    // aims at the middle.
    let aim = unit(camera.direction)
        .zip(unit(way))
        .map(|(a, b)| -dot(a, b));
    let is_place = ended.contains(camera.direction) && aim.is_some_and(|aim| aim < AIMED);
    // A direction of a length that people write has rather lost a minus.
    let is_lost = signs.is_some_and(|signs| is_one_lost(camera.direction, signs));
    if match is_lost {
        true => length(camera.direction) > LONGEST_WRITTEN,
        false => is_place,
    } {
        fixes.reverse();
    }
    if !ended.is_empty() && sees(way) {
        let numbers = way.map(|x| near(x, length(way)));
        let other = fix("fix", Vec::new(), numbers, p);
        fixes.extend((fixes.iter().all(|f| f.edits != other.edits)).then_some(other));
    }
    let others = [swapped, fixes].concat().into_iter();
    let others = others.filter(|f| said.as_ref().is_none_or(|said| f.edits != said.edits));
    Vec::from_iter(said.clone().into_iter().chain(others))
}

/// Adds fixes that give one coordinate of the camera's place the other sign, if the camera is then in no solid and sees
/// something. The fix comes second if the camera then looks at the middle, and last otherwise.
fn with_other_places(
    context: &Context,
    root: NodeId,
    camera: &Camera,
    p: &Params,
    mut fixes: Vec<Fix>,
) -> Vec<Fix> {
    let of = to_be_seen(context, root);
    let middle = context.bounds()[root as usize].bounded().centre();
    for axis in (0..3).filter(|&i| camera.position[i] != 0.0) {
        let mut there = *camera;
        there.position[axis] = -there.position[axis];
        let holders = held(context.scene, context.bounds(), root, &[there.position]);
        if is_moved(camera, p)
            || holders.iter().any(Option::is_some)
            || !sees(context, root, &there, there.direction, of)
        {
            continue;
        }
        let numbers = [0, 1, 2].map(|i| match i == axis {
            true => opposite(p, i),
            false => p.text_of(i).to_owned(),
        });
        let span = p.span_of(axis, 1);
        let title = "fix-sign-of-place";
        let fix = Fix::replace(title, Applicability::Choice, span, numbers[axis].clone());
        let fix = fix.with("number", quote(&numbers.join(" ")));
        let fix = fix.with("axis", ["x", "y", "z"][axis]);
        let way = unit(sub(middle, there.position)).zip(unit(there.direction));
        if way.is_some_and(|(a, b)| dot(a, b) >= AIMED_AT_MIDDLE) {
            fixes.insert(fixes.len().min(1), fix);
        } else {
            fixes.push(fix);
        }
    }
    fixes
}

/// The fix that exchanges the direction and the up vector. `None` unless the direction is a coordinate axis, as most up
/// vectors are, the up vector is not, and the camera then sees something.
fn swapped(context: &Context, root: NodeId, camera: &Camera, p: &Params, of: Parts) -> Option<Fix> {
    let is_axis = |mut vector: Vec3| {
        vector.sort_by(f64::total_cmp);
        vector == [0.0, 0.0, 1.0]
    };
    let is_one = is_axis(camera.direction) && !is_axis(camera.up);
    let turned = Camera {
        up: camera.direction,
        ..*camera
    };
    if !is_one || !sees(context, root, &turned, camera.up, of) {
        return None;
    }
    let texts: Vec<&str> = [6, 7, 8, 3, 4, 5].map(|i| p.text_of(i)).into();
    let edits = (3..).zip(&texts).map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text: (*text).to_owned(),
    });
    let fix = Fix::guess("fix-view-and-up", edits.collect());
    Some(
        fix.with("number", quote(&texts[..3].join(" ")))
            .with("up", quote(&texts[3..].join(" "))),
    )
}

/// For each component of a direction whether its sign is changed.
type Signs = [bool; 3];

/// The components of the direction that get the other sign so that the camera sees something; `None` if no choice
/// helps. The longest component is tried first, then all of them if the objects are behind the camera, then each
/// positive one, which may have lost its minus.
fn signs(way: Vec3, side: OutOfView, sees: impl Fn(Vec3) -> bool) -> Option<Signs> {
    let longest = longest(way)?;
    let only = |part: usize| [0, 1, 2].map(|i| i == part);
    let all = way.map(|x| x != 0.0);
    let lost = (0..3).filter(|&i| way[i] > 0.0).map(only);
    let all = std::iter::once(all).filter(|_| side == OutOfView::Behind);
    let mut may_be = std::iter::once(only(longest)).chain(all).chain(lost);
    may_be.find(|signs| sees([0, 1, 2].map(|i| if signs[i] { -way[i] } else { way[i] })))
}

fn longest(way: Vec3) -> Option<usize> {
    (0..3).max_by(|&i, &j| way[i].abs().total_cmp(&way[j].abs()))
}

/// Whether a single component changes its sign, which was positive and is not the longest: it has rather lost its
/// minus.
fn is_one_lost(way: Vec3, signs: Signs) -> bool {
    let mut parts = (0..3).filter(|&i| signs[i]);
    let (Some(part), None) = (parts.next(), parts.next()) else {
        return false;
    };
    way[part] > 0.0 && Some(part) != longest(way)
}

/// The fix that gives the chosen components of the direction the other sign.
fn with_signs(signs: Signs, p: &Params) -> Fix {
    let text = |i: usize| match (signs[i], p.text_of(3 + i).strip_prefix('-')) {
        (true, Some(rest)) => rest.to_owned(),
        (true, None) => format!("-{}", p.text_of(3 + i).trim_start_matches('+')),
        (false, _) => p.text_of(3 + i).to_owned(),
    };
    let numbers = [0, 1, 2].map(text);
    let values = vec![("number", quote(&numbers.join(" ")).into())];
    fix("fix-sign", values, numbers, p)
}

/// The fix that reads the direction as a point to look at. `None` if the camera then sees nothing.
pub(super) fn turned_to_point(
    camera: &Camera,
    p: &Params,
    sees: impl Fn(Vec3) -> bool,
) -> Option<Fix> {
    let way = sub(camera.direction, camera.position);
    if !sees(way) {
        return None;
    }
    let numbers = way.map(decimal);
    let written = (3..6).map(|i| p.text_of(i)).collect::<Vec<_>>().join(" ");
    let values = vec![
        ("text", quote(&written).into()),
        ("number", quote(&numbers.join(" ")).into()),
    ];
    Some(fix("fix-point", values, numbers, p))
}

/// The parts of the scene that a camera is meant to see: the bounded ones, or all if there are none.
pub(super) fn to_be_seen(context: &Context, root: NodeId) -> Parts {
    match context.bounds()[root as usize].bounded().is_empty() {
        true => Parts::All,
        false => Parts::Bounded,
    }
}

/// Whether a transformation moves the camera from the place and direction of its record.
pub(super) fn is_moved(camera: &Camera, p: &Params) -> bool {
    p.numbers(0) != camera.position || p.numbers(3) != camera.direction
}

/// A fix that writes another direction.
fn fix(
    title: &'static str,
    values: Vec<(&'static str, Value)>,
    numbers: [String; 3],
    p: &Params,
) -> Fix {
    let edits = (3..).zip(numbers).map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    Fix {
        title,
        values,
        applicability: Applicability::Unsafe,
        edits: edits.collect(),
    }
}

/// Whether the camera would see some of the parts `of` if it looked along `way`. `false` if the up vector is nearly
/// along `way`.
pub(super) fn sees(context: &Context, root: NodeId, camera: &Camera, way: Vec3, of: Parts) -> bool {
    /// The least sine between direction and up.
    const UPRIGHT: f64 = 0.01;
    let (Some(direction), Some(up)) = (unit(way), unit(camera.up)) else {
        return false;
    };
    let turned = Camera {
        direction: way,
        ..*camera
    };
    length(cross(direction, up)) >= UPRIGHT
        && out_of_view(context.scene, context.bounds(), root, &turned, of).is_none()
}

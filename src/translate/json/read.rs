//! Reading of JSON as a model of a scene, with checks of what the types leave open.

use std::collections::HashSet;

use super::model::{self, Node, Scene};
use super::spell::{ID_MAX, ModelElement};
use super::unreadable::Unreadable;
use crate::diagnostics::Complaint;

/// Reads a scene.
///
/// # Errors
///
/// The text is no scene in JSON: the fault, and its place.
pub fn read(text: &str) -> Result<Scene, Unreadable> {
    // Some programs put a byte order mark in front.
    let json = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mark = text.len() - json.len();
    let mut parser = serde_json::Deserializer::from_str(json);
    let scene: Scene = serde_path_to_error::deserialize(&mut parser)
        .map_err(|e| Unreadable::form(json, mark, e.path(), e.inner()))?;
    let nowhere = |e: serde_json::Error| Unreadable::syntax(json, mark, &e);
    parser.end().map_err(nowhere)?;
    check(&scene).map_err(|(at, why)| Unreadable::content(text, at, why))?;
    Ok(scene)
}

/// The element with a fault, and the fault.
type Fault = (ModelElement, Complaint);

fn check(scene: &Scene) -> Result<(), Fault> {
    if scene.version != model::VERSION {
        let why = Complaint::new("json-version")
            .with("found", scene.version.to_string())
            .with("known", model::VERSION.to_string());
        return Err((ModelElement::Head, why));
    }
    check_ids(scene)?;
    for (i, item) in scene.nodes.iter().enumerate() {
        let at = ModelElement::Node(i as u32);
        for child in item.node.children().into_iter().flatten() {
            if child as usize >= i {
                let why = Complaint::new("json-not-before").with("node", child.to_string());
                return Err((at, why));
            }
        }
        check_node(&item.node).map_err(|why| (at, Complaint::new(why)))?;
    }
    let node = |at: ModelElement, n: u32| match scene.nodes.get(n as usize) {
        Some(_) => Ok(()),
        None => {
            let why = Complaint::new("json-no-node").with("node", n.to_string());
            Err((at, why))
        }
    };
    for (i, bound) in scene.bounds.iter().enumerate() {
        node(ModelElement::Bound(i as u32), bound.node)?;
    }
    if let Some(render) = scene.render {
        node(ModelElement::Render, render.root)?;
    }
    let cameras = match scene.view {
        None => vec![],
        Some(model::View::Mono(camera)) => vec![camera],
        Some(model::View::Stereo { left, right }) => vec![left, right],
    };
    for camera in cameras {
        if camera as usize >= scene.cameras.len() {
            let why = Complaint::new("json-no-camera").with("camera", camera.to_string());
            return Err((ModelElement::View, why));
        }
    }
    Ok(())
}

fn check_ids(scene: &Scene) -> Result<(), Fault> {
    let nodes = scene.nodes.iter().map(|n| n.id);
    let ambient = scene.ambient_lights.iter().map(|l| l.id);
    let points = scene.point_lights.iter().map(|l| l.id);
    let cameras = scene.cameras.iter().map(|c| c.id);
    let at = |place: fn(u32) -> ModelElement| move |(i, id)| (place(i as u32), id);
    let all = (nodes.enumerate().map(at(ModelElement::Node)))
        .chain(ambient.enumerate().map(at(ModelElement::AmbientLight)))
        .chain(points.enumerate().map(at(ModelElement::PointLight)))
        .chain(cameras.enumerate().map(at(ModelElement::Camera)));
    let mut seen = HashSet::new();
    for (at, id) in all {
        let Some(id) = id else { continue };
        if !(2..=ID_MAX).contains(&id) {
            let why = Complaint::new("json-id-range")
                .with("max", ID_MAX.to_string())
                .with("id", id.to_string());
            return Err((at, why));
        }
        if !seen.insert(id) {
            let why = Complaint::new("json-id-taken").with("id", id.to_string());
            return Err((at, why));
        }
    }
    Ok(())
}

fn check_node(node: &Node) -> Result<(), &'static str> {
    match node {
        Node::SurfaceOfRevolution { profile, colours }
            if !colours.is_empty() && colours.len() != profile.len() =>
        {
            Err("json-colours")
        }
        Node::Triangle { normals, .. } if ![0, 1, 3].contains(&normals.len()) => {
            Err("json-normals")
        }
        Node::Paint {
            texture: Some(model::Texture::Image(file)),
            ..
        } if file.is_empty() || file.contains(|c: char| c == '"' || c.is_control()) => {
            Err("json-image-name")
        }
        _ => Ok(()),
    }
}

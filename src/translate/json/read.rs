//! JSON as a model of a scene, with all that types cannot say made sure of.

use std::collections::HashSet;
use std::fmt;

use super::model::{self, Node, Scene};
use super::spell::{ID_MAX, Place};

/// Why a text is no scene in JSON.
#[derive(Debug)]
pub enum Unreadable {
    /// It is no JSON, or not of the form that the schema has; with line and column.
    Form(serde_json::Error),
    /// Something refers to what is not there, or cannot be what it is.
    Content { at: Place, why: String },
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unreadable::Form(e) => e.fmt(f),
            Unreadable::Content { at, why } => write!(f, "{at}: {why}"),
        }
    }
}

impl std::error::Error for Unreadable {}

/// Reads a scene.
///
/// # Errors
///
/// What is wrong with it, and where.
pub fn read(text: &str) -> Result<Scene, Unreadable> {
    let scene: Scene = serde_json::from_str(text).map_err(Unreadable::Form)?;
    check(&scene).map_err(|(at, why)| Unreadable::Content { at, why })?;
    Ok(scene)
}

type Complaint = (Place, String);

fn check(scene: &Scene) -> Result<(), Complaint> {
    if scene.version != model::VERSION {
        let why = format!(
            "version {} is not known, only version {}",
            scene.version,
            model::VERSION
        );
        return Err((Place::Head, why));
    }
    check_ids(scene)?;
    for (i, item) in scene.nodes.iter().enumerate() {
        let at = Place::Node(i as u32);
        for child in item.node.children().into_iter().flatten() {
            if child as usize >= i {
                let why = format!("it names node {child}, which does not stand before it");
                return Err((at, why));
            }
        }
        check_node(&item.node).map_err(|why| (at, why.to_owned()))?;
    }
    let node = |at: Place, n: u32| match scene.nodes.get(n as usize) {
        Some(_) => Ok(()),
        None => Err((at, format!("there is no node {n}"))),
    };
    for (i, bound) in scene.bounds.iter().enumerate() {
        node(Place::Bound(i as u32), bound.node)?;
    }
    if let Some(render) = scene.render {
        node(Place::Render, render.root)?;
    }
    let cameras = match scene.view {
        None => vec![],
        Some(model::View::Mono(camera)) => vec![camera],
        Some(model::View::Stereo { left, right }) => vec![left, right],
    };
    for camera in cameras {
        if camera as usize >= scene.cameras.len() {
            return Err((Place::View, format!("there is no camera {camera}")));
        }
    }
    Ok(())
}

fn check_ids(scene: &Scene) -> Result<(), Complaint> {
    let nodes = scene.nodes.iter().map(|n| n.id);
    let ambient = scene.ambient_lights.iter().map(|l| l.id);
    let points = scene.point_lights.iter().map(|l| l.id);
    let cameras = scene.cameras.iter().map(|c| c.id);
    let at = |place: fn(u32) -> Place| move |(i, id)| (place(i as u32), id);
    let all = (nodes.enumerate().map(at(Place::Node)))
        .chain(ambient.enumerate().map(at(Place::AmbientLight)))
        .chain(points.enumerate().map(at(Place::PointLight)))
        .chain(cameras.enumerate().map(at(Place::Camera)));
    let mut seen = HashSet::new();
    for (at, id) in all {
        let Some(id) = id else { continue };
        if !(2..=ID_MAX).contains(&id) {
            return Err((at, format!("an ID is from 2 to {ID_MAX}, not {id}")));
        }
        if !seen.insert(id) {
            return Err((at, format!("the ID {id} is taken")));
        }
    }
    Ok(())
}

fn check_node(node: &Node) -> Result<(), &'static str> {
    match node {
        Node::SurfaceOfRevolution { profile, colours }
            if !colours.is_empty() && colours.len() != profile.len() =>
        {
            Err("there must be a colour for each point of the profile, or none")
        }
        Node::Triangle { normals, .. } if ![0, 1, 3].contains(&normals.len()) => {
            Err("a triangle has no normal, one, or three")
        }
        Node::Paint {
            texture: Some(model::Texture::Image(file)),
            ..
        } if file.is_empty() || file.contains(|c: char| c == '"' || c.is_control()) => {
            Err("this cannot be the name of an image file")
        }
        _ => Ok(()),
    }
}

//! A camera of the scene, by its ID.

use crate::diagnostics::{Complaint, Error};
use crate::scene::{Camera, Scene};

/// So many cameras are named where there is none of the ID that was asked for.
const NAMED: usize = 20;

/// The camera with this ID. If there is none, the error names those that there are.
pub fn camera(scene: &Scene, id: u32) -> Result<Camera, Error> {
    let cameras = &scene.cameras;
    if let Some(camera) = cameras.iter().find(|c| c.id == id) {
        return Ok(*camera);
    }
    let mut named: Vec<String> = (cameras.iter().take(NAMED))
        .map(|c| c.id.to_string())
        .collect();
    if cameras.len() > NAMED {
        named.push("…".to_owned());
    }
    let message = match cameras.len() {
        0 => "no-cameras",
        _ => "no-such-camera",
    };
    let complaint = Complaint::new(message).with("id", id.to_string());
    Err(Error::Request(match named.is_empty() {
        true => complaint,
        false => complaint.with("cameras", named.join(", ")),
    }))
}

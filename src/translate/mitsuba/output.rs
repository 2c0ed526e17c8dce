//! A finished translation.

use super::frame::SceneFrame;
use crate::translate::Report;
use crate::translate::mesh;

/// A shape of the translation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShapeInfo {
    /// The entity whose record made the surface.
    pub shape: u32,
    /// The entity whose properties apply.
    pub object: u32,
    /// Whether the shape is exact: no mesh.
    pub exact: bool,
}

/// A finished translation.
#[derive(Debug)]
pub struct Output {
    /// The documents, one or one for each eye: the end of the file's name before `.xml`, and the text.
    pub documents: Vec<(&'static str, String)>,
    /// Files beside the documents: name and bytes.
    pub meshes: Vec<(String, Vec<u8>)>,
    /// The shapes in the order of Mitsuba's shape index.
    pub shapes: Vec<ShapeInfo>,
    /// How far the meshes may be from the shapes, and where parts without end are cut off.
    pub extent: mesh::Extent,
    /// The frame that the scene was put in.
    pub frame: SceneFrame,
    /// The distance from the middle of the region to which parts without end go on, in the scene's units.
    pub reach: f64,
    pub report: Report,
}

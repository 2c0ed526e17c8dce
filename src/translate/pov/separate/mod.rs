//! Remedies for faces in one place, a file each. POV-Ray takes now one, now the other of two such faces for the nearer
//! one, so one of them is put where nobody sees it, or about a hair away.
//!
//! Faces in one place are found in `model/contacts.rs`: `Face::contact` compares two faces, and `Model::contacts` finds
//! all pairs between two nodes.

pub(super) mod backward_normals;
pub(super) mod coplanar;
pub(super) mod media;
pub(super) mod plates;
pub(super) mod settle;
pub(super) mod tools;

//! What is done about faces in one place: each remedy is a file. POV-Ray takes now one of such faces for the nearer one,
//! now the other, so one of them is put where nobody sees it, or a part of a hair away.

pub mod backward_normals;
mod contacts;
pub mod coplanar;
pub mod media;
pub mod plates;
pub mod settle;
pub mod tools;

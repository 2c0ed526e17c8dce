//! Remedies for faces in one place, a file each. POV-Ray takes now one of such faces for the nearer one, now the other,
//! so one of them is put where nobody sees it, or a part of a hair away.

pub(super) mod backward_normals;
pub(super) mod coplanar;
pub(super) mod media;
pub(super) mod plates;
pub(super) mod settle;
pub(super) mod tools;

//! The scene for other programs.

//! Rules over the tree and the scene, one file a rule.

//! Rules over the tree and the scene, one file a rule. A rule never speaks about a record that is
//! broken: the parser or the resolver has done so.

mod rules;

use crate::diagnostics::Diagnostic;
use crate::scene::Scene;
use crate::syntax::Document;

/// What a rule may look at.
pub struct Context<'a> {
    pub text: &'a str,
    pub document: &'a Document,
    pub scene: &'a Scene,
}

type Rule = fn(&Context, &mut Vec<Diagnostic>);

/// Every rule, in the order of its code.
const RULES: &[Rule] = &[
    rules::energy_gain::check,
    rules::no_camera::check,
    rules::no_light::check,
    rules::notation_separator::check,
    rules::bare_comment::check,
    rules::several_records_per_line::check,
];

/// Runs all rules; the findings are added.
pub fn run(context: &Context, out: &mut Vec<Diagnostic>) {
    for rule in RULES {
        rule(context, out);
    }
}

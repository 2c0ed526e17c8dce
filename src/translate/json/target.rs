//! Translation of the resolved scene into JSON and into records.

use super::model::{Node, Scene};
use super::pictures::{Left, follow};
use super::spell::spell;
use super::verdict::verdict;
use super::write::write;
use crate::diagnostics::Error;
use crate::format;
use crate::syntax;
use crate::syntax::table::RecordKind;
use crate::translate::fidelity::{Fidelity, Report};
use crate::translate::target::{Options, Output, Prepared, Target};

/// The scene as JSON.
#[derive(Debug)]
pub struct Json;

impl Target for Json {
    fn name(&self) -> &'static str {
        "json"
    }

    fn help(&self) -> &'static str {
        "The resolved scene, for programs"
    }

    fn draws(&self) -> bool {
        false
    }

    fn write(&self, scene: &Prepared, options: &Options) -> Result<Output, Error> {
        let mut model = write(scene.scene());
        let left = follow(&mut model, scene, options);
        let mut text = serde_json::to_vec_pretty(&model).unwrap_or_default();
        text.push(b'\n');
        Ok(output(self.name(), scene, options, &left, text))
    }
}

/// The scene as records, in the layout of the formatter.
#[derive(Debug)]
pub struct Zpg;

impl Target for Zpg {
    fn name(&self) -> &'static str {
        "zpg"
    }

    fn help(&self) -> &'static str {
        "The resolved scene as records"
    }

    fn makes_scenes(&self) -> bool {
        true
    }

    fn draws(&self) -> bool {
        false
    }

    fn write(&self, scene: &Prepared, options: &Options) -> Result<Output, Error> {
        let mut model = write(scene.scene());
        let left = follow(&mut model, scene, options);
        let contents = &scene.analysis.document.contents;
        // JSON names every index, so a scene from JSON keeps it.
        if scene.analysis.is_records() && !contents.has(&[RecordKind::RefractiveIndex]) {
            leave_out_default_index(&mut model);
        }
        let records = spell(&model, options.language).text;
        let (document, _) = syntax::parse(&records);
        let text = format::format(&records, &document, &format::Options::default());
        Ok(output(
            self.name(),
            scene,
            options,
            &left,
            text.into_bytes(),
        ))
    }
}

/// Removes the refractive index 1, which assignments of optics give, from all paints. Does nothing if the scene has
/// another index, or one without optics.
fn leave_out_default_index(model: &mut Scene) {
    let is_default = |node: &Node| match node {
        Node::Paint {
            optics: Some(_),
            index,
            ..
        } => index.is_none_or(|index| index == [1.0; 3]),
        Node::Paint { index, .. } => index.is_none(),
        _ => true,
    };
    if model.nodes.iter().all(|item| is_default(&item.node)) {
        for item in &mut model.nodes {
            if let Node::Paint { index, .. } = &mut item.node {
                *index = None;
            }
        }
    }
}

fn output(
    name: &'static str,
    scene: &Prepared,
    options: &Options,
    left: &Left,
    bytes: Vec<u8>,
) -> Output {
    let of = |feature| (left.verdict(feature, options)).unwrap_or_else(|| verdict(feature));
    let mut report = Report::of(name, scene.scene(), of);
    if scene.analysis.document.contents.comments {
        let note = "the resolved scene has none";
        report.state("comments", Fidelity::Dropped, note);
    }
    Output {
        files: vec![(options.output.map(ToOwned::to_owned), bytes)],
        report,
    }
}

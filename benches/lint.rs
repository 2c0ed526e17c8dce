//! Scenes through the rules of the linter: how long reading takes, and all rules together.

use std::time::Instant;

use zpg::diagnostics::SourceFile;
use zpg::{lint, scene, syntax};

fn main() {
    for path in std::env::args().skip(1).filter(|a| a != "--bench") {
        let bytes = std::fs::read(&path).expect("a scene");
        let start = Instant::now();
        let source = SourceFile::new(path.clone(), bytes);
        let (document, mut found) = syntax::parse(&source.text);
        let scene = scene::resolve(&document, &source, &mut found);
        let read = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let context = lint::Context::new(&source.text, &document, &scene);
        lint::run(&context, &mut found);
        let rules = start.elapsed().as_secs_f64();
        println!(
            "{path:<36} {} {read:>6.2} s {rules:>6.2} s {}",
            scene.nodes.len(),
            found.len()
        );
    }
}

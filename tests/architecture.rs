//! The order of modules that `src/lib.rs` and CONTRIBUTING.md give is the one that the imports have.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use syn::visit::{self, Visit};

/// No more files than these may import each other in a circle.
const LARGEST_CIRCLE: usize = 3;

/// Files of the program, which is above all of the library.
const PROGRAM: [&str; 2] = ["main.rs", "machine.rs"];

/// What unit tests share stands beside the layers.
const ASIDE: &str = "testing";

type Module = Vec<String>;

/// What a module imports, each import as the path that is written.
#[derive(Default)]
struct Imports {
    /// Outside of `#[cfg(test)]`.
    code: Vec<Module>,
    tests: Vec<Module>,
    /// Whether what is visited is compiled for tests only, and how many modules of this file it is in.
    in_tests: bool,
    depth: usize,
}

impl Imports {
    fn add(&mut self, mut path: Module) {
        // Within `mod tests { … }` the first `super` is the file's own module.
        for _ in 0..self.depth {
            match path.first().map(String::as_str) {
                Some("super") => drop(path.remove(0)),
                _ => break,
            }
        }
        match self.in_tests {
            true => self.tests.push(path),
            false => self.code.push(path),
        }
    }

    fn add_tree(&mut self, tree: &syn::UseTree, mut path: Module) {
        match tree {
            syn::UseTree::Path(p) => {
                path.push(p.ident.to_string());
                self.add_tree(&p.tree, path);
            }
            syn::UseTree::Name(n) => {
                path.push(n.ident.to_string());
                self.add(path);
            }
            syn::UseTree::Rename(r) => {
                path.push(r.ident.to_string());
                self.add(path);
            }
            syn::UseTree::Glob(_) => self.add(path),
            syn::UseTree::Group(g) => {
                (g.items.iter()).for_each(|item| self.add_tree(item, path.clone()))
            }
        }
    }

    /// Visits what has these attributes.
    fn within(&mut self, attributes: &[syn::Attribute], visit: impl FnOnce(&mut Imports)) {
        let before = self.in_tests;
        self.in_tests |= attributes.iter().any(|a| {
            a.path().is_ident("cfg")
                && (a.parse_args::<syn::Path>()).is_ok_and(|p| p.is_ident("test"))
        });
        visit(self);
        self.in_tests = before;
    }
}

impl<'a> Visit<'a> for Imports {
    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        self.within(&item.attrs, |all| all.add_tree(&item.tree, Module::new()));
    }

    fn visit_item_mod(&mut self, item: &'a syn::ItemMod) {
        self.within(&item.attrs, |all| {
            all.depth += 1;
            visit::visit_item_mod(all, item);
            all.depth -= 1;
        });
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let names: Module = path.segments.iter().map(|s| s.ident.to_string()).collect();
        if names.len() > 1 && matches!(names[0].as_str(), "crate" | "super") {
            self.add(names);
        }
        visit::visit_path(self, path);
    }

    // `pub(in crate::trace)` is no import.
    fn visit_visibility(&mut self, _: &'a syn::Visibility) {}
}

/// The modules of the library and what each imports.
fn modules() -> BTreeMap<Module, Imports> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = BTreeMap::new();
    for entry in ignore::Walk::new(&root).map(Result::unwrap) {
        let path = entry.path();
        let of_program = PROGRAM.iter().any(|file| path == root.join(file));
        if path.extension().is_none_or(|e| e != "rs") || of_program {
            continue;
        }
        let within = path.strip_prefix(&root).unwrap().with_extension("");
        let mut module: Module = (within.iter())
            .map(|part| part.to_str().unwrap().to_owned())
            .collect();
        module.pop_if(|last| matches!(last.as_str(), "mod" | "lib"));
        let file = syn::parse_file(&fs::read_to_string(path).unwrap()).unwrap();
        let mut imports = Imports::default();
        imports.visit_file(&file);
        all.insert(module, imports);
    }
    all
}

/// The module that a path in another module leads to; `None` for other crates.
fn module_of(all: &BTreeMap<Module, Imports>, from: &Module, path: &Module) -> Option<Module> {
    let mut full = from.clone();
    let ups = path.iter().take_while(|part| *part == "super").count();
    match path.first()?.as_str() {
        "crate" => full.clear(),
        "super" => full.truncate(from.len() - ups),
        "self" => {}
        child => {
            let child = [from.as_slice(), &[child.to_owned()]].concat();
            all.contains_key(&child).then_some(())?;
        }
    }
    let names = path
        .iter()
        .filter(|p| !matches!(p.as_str(), "crate" | "super" | "self"));
    full.extend(names.cloned());
    while !all.contains_key(&full) {
        full.pop()?;
    }
    Some(full)
}

/// The layers as `src/lib.rs` declares them, the lowest first.
fn layers() -> Vec<String> {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).unwrap();
    let names = text.lines().filter_map(|line| {
        let name = line.strip_prefix("mod ")?.strip_suffix(';')?;
        (name != "testing").then(|| name.to_owned())
    });
    names.collect()
}

#[test]
fn imports_go_one_way() {
    let (all, layers) = (modules(), layers());
    let rank = |m: &Module| m.first().map(|top| layers.iter().position(|l| l == top));
    let mut wrong = Vec::new();
    for (module, imports) in &all {
        let Some(own) = rank(module) else { continue };
        if module[0] == ASIDE {
            continue;
        }
        let own = own.unwrap_or_else(|| panic!("src/lib.rs does not list {}", module[0]));
        for path in imports.code.iter().chain(&imports.tests) {
            let other = module_of(&all, module, path).filter(|m| !m.is_empty() && m[0] != ASIDE);
            let Some(other) = other else { continue };
            if rank(&other).flatten().is_some_and(|other| other > own) {
                wrong.push(format!(
                    "{} imports {}",
                    module.join("::"),
                    other.join("::")
                ));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "against the order of src/lib.rs:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn circles_are_small() {
    let all = modules();
    let imports = |module: &Module| -> BTreeSet<Module> {
        let named = all[module].code.iter();
        named
            .filter_map(|path| module_of(&all, module, path))
            .collect()
    };
    let graph: BTreeMap<&Module, BTreeSet<Module>> =
        all.keys().map(|module| (module, imports(module))).collect();
    let reached = |from: &Module| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(module) = open.pop() {
            for next in &graph[&module] {
                if seen.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        seen
    };
    let below: BTreeMap<&Module, BTreeSet<Module>> =
        all.keys().map(|module| (module, reached(module))).collect();
    let mut circles = BTreeSet::new();
    for (module, reached) in &below {
        let circle: Vec<String> = (reached.iter())
            .filter(|other| below[other].contains(*module))
            .map(|m| m.join("::"))
            .collect();
        if circle.len() > LARGEST_CIRCLE {
            circles.insert(circle);
        }
    }
    assert!(
        circles.is_empty(),
        "import each other in a circle: {circles:#?}"
    );
}

/// The values of a scene that the printer of POV-Ray's text may know.
const VALUES: [&str; 6] = [
    "CELL_NUDGE",
    "Geometry",
    "Rgb",
    "TriangleNormals",
    "Vec3",
    "Volume",
];

/// What prints POV-Ray's text knows the tree that it prints, and none of the passes before it.
#[test]
fn the_printer_of_pov_ray_sees_no_scene() {
    let all = modules();
    let is_printer = |module: &Module| module.join("::").starts_with("translate::pov::print");
    let printers = all.keys().filter(|module| is_printer(module));
    assert!(printers.clone().count() > 5);
    for printer in printers {
        for path in &all[printer].code {
            let Some(module) = module_of(&all, printer, path) else {
                continue;
            };
            let is_pass = |pass: &str| {
                module
                    .join("::")
                    .starts_with(&format!("translate::pov::{pass}"))
            };
            let is_scene = module.first().is_some_and(|top| top == "scene");
            let is_value = path
                .last()
                .is_some_and(|name| VALUES.contains(&name.as_str()));
            assert!(
                !["lower", "model", "separate", "simplify"]
                    .into_iter()
                    .any(is_pass)
                    && (is_value || !is_scene),
                "{} imports {}",
                printer.join("::"),
                path.join("::")
            );
        }
    }
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    fs::read_to_string(path).unwrap()
}

/// ARCHITECTURE draws the layers in the order of `src/lib.rs`: a floor's name, then its modules, then what they do.
#[test]
fn the_page_draws_the_same_floors() {
    let page = page("ARCHITECTURE.md");
    let drawing = page.split("```").nth(1).unwrap();
    // The column where the modules of a floor begin. Three spaces end them.
    const FLOOR: usize = 13;
    let drawn: Vec<&str> = (drawing.lines())
        .filter_map(|line| line.get(FLOOR..)?.split("   ").next())
        .flat_map(str::split_whitespace)
        .collect();
    assert_eq!(drawn, layers());
}

/// CONTRIBUTING names the layers in the order of `src/lib.rs`.
#[test]
fn the_page_draws_the_same_picture() {
    let line = layers().join(" → ");
    let text = page("CONTRIBUTING.md");
    let plain = text
        .split_whitespace()
        .filter(|word| *word != ">")
        .collect::<Vec<_>>()
        .join(" ");
    assert!(plain.contains(&line), "it does not say: {line}");
}

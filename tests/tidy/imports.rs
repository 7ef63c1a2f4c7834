//! Import graph of a crate's source files, from the parsed code (syn).
//!
//! An import belongs to the file that *defines* the name: `use crate::Name` is an import of the file from which
//! `lib.rs` re-exports `Name`, and of `lib.rs` only if `lib.rs` itself defines `Name`. `mod` declarations are not
//! imports, and neither is the re-export of a name by a parent module of its definition (`pub use child::Name`). An
//! import of a module only binds a name; items reached through the module count. Paths in code count like `use`, also
//! inside macro calls and attributes. Items under `#[cfg(test)]` are omitted.

use super::modules::{Module, Path, is_for_tests, path_attribute};
use std::collections::{BTreeMap, BTreeSet};

/// Names imported by one file from another, by (importing file, imported file).
pub type Imports = BTreeMap<(String, String), BTreeSet<String>>;

/// Imports between the files of one crate. `sources` holds the texts by path below `src`; the crate's roots are
/// `lib.rs`, `main.rs` and the files in `bin/`, if present.
pub fn imports(sources: &BTreeMap<String, String>) -> Imports {
    let mut found = Imports::new();
    let mut reached = BTreeSet::new();
    let is_root = |file: &&String| matches!(file.as_str(), "lib.rs" | "main.rs") || file.starts_with("bin/");
    for root in sources.keys().filter(is_root) {
        let mut tree = Tree { sources, modules: Vec::new(), reached: BTreeSet::new() };
        tree.read_file(root, "", None);
        tree.collect(&mut found);
        reached.append(&mut tree.reached);
    }
    let missed: Vec<_> = sources.keys().filter(|file| !reached.contains(*file)).collect();
    assert!(missed.is_empty(), "no `mod` leads to {missed:?}");
    found
}

/// Limit of a chain of re-exports; `use` declarations may be circular.
const LONGEST_CHAIN: usize = 32;

/// Target of a path: a module, or an item of a module.
#[derive(Clone, Copy, PartialEq)]
enum Target {
    Module(usize),
    Item(usize),
}

struct Tree<'a> {
    sources: &'a BTreeMap<String, String>,
    modules: Vec<Module>,
    reached: BTreeSet<String>,
}

impl Tree<'_> {
    /// Reads a file with its submodules in `folder`.
    fn read_file(&mut self, file: &str, folder: &str, parent: Option<usize>) -> usize {
        self.reached.insert(file.to_string());
        let parsed = syn::parse_file(&self.sources[file]).unwrap_or_else(|e| panic!("{file}: {e}"));
        self.read_items(&parsed.items, file, folder, parent)
    }

    fn read_items(&mut self, items: &[syn::Item], file: &str, folder: &str, parent: Option<usize>) -> usize {
        let id = self.modules.len();
        self.modules.push(Module::new(file, parent, items));
        for item in items {
            if let syn::Item::Mod(module) = item {
                self.read_module(module, is_for_tests(item), file, folder, id);
            } else if !is_for_tests(item) {
                self.modules[id].read(item);
            }
        }
        id
    }

    fn read_module(&mut self, module: &syn::ItemMod, tests: bool, file: &str, folder: &str, parent: usize) {
        let name = module.ident.to_string();
        let below = format!("{folder}{name}/");
        let child = if let Some((_, items)) = &module.content {
            if tests {
                return;
            }
            self.read_items(items, file, &below, Some(parent))
        } else {
            let places = match path_attribute(&module.attrs) {
                Some(path) => {
                    vec![format!("{}{path}", file.rsplit_once('/').map_or("", |(f, _)| &file[..=f.len()]))]
                }
                None => vec![format!("{folder}{name}.rs"), format!("{folder}{name}/mod.rs")],
            };
            let found = places.into_iter().find(|place| self.sources.contains_key(place));
            let found = found.unwrap_or_else(|| panic!("{file}: `mod {name}` has no file"));
            if tests {
                self.reached.insert(found);
                return;
            }
            self.read_file(&found, &below, Some(parent))
        };
        self.modules[parent].children.insert(name, child);
    }

    /// Resolves every `use` and every path in the code to the file that defines the named item.
    fn collect(&self, found: &mut Imports) {
        for (id, module) in self.modules.iter().enumerate() {
            let mut import = |path: &Path, re_exported: bool| {
                let (targets, length) = self.resolve(id, path, 0);
                for target in targets {
                    if let Target::Item(to) = target
                        && self.modules[to].file != module.file
                        && !(re_exported && self.is_below(to, id))
                    {
                        let files = (module.file.clone(), self.modules[to].file.clone());
                        found.entry(files).or_default().insert(path[length - 1].clone());
                    }
                }
            };
            module.bindings.iter().for_each(|binding| import(&binding.path, binding.public));
            for path in &module.paths {
                // A bare name that is also a variable of the module counts as the variable.
                let variable = path.len() == 1 && module.variables.contains(&path[0]);
                if !variable {
                    import(path, false);
                }
            }
        }
    }

    fn is_below(&self, module: usize, above: usize) -> bool {
        let mut at = Some(module);
        while let Some(id) = at {
            if id == above {
                return true;
            }
            at = self.modules[id].parent;
        }
        false
    }

    /// Targets of a path in `module`, and the number of its names up to the target (the rest are variants and methods
    /// of an item); empty for a path outside the crate. A name may denote both a module and an item.
    fn resolve(&self, module: usize, path: &[String], depth: usize) -> (Vec<Target>, usize) {
        if depth > LONGEST_CHAIN {
            return (Vec::new(), 1);
        }
        let mut targets = match path[0].as_str() {
            "crate" => vec![Target::Module(0)],
            "self" => vec![Target::Module(module)],
            "super" => self.modules[module].parent.map(Target::Module).into_iter().collect(),
            name => self.look_up(module, name, depth),
        };
        for (i, name) in path.iter().enumerate().skip(1) {
            let within = targets.iter().find_map(|t| if let Target::Module(m) = t { Some(*m) } else { None });
            let Some(within) = within else { return (targets, i) };
            targets = if name == "super" {
                self.modules[within].parent.map(Target::Module).into_iter().collect()
            } else {
                let found = self.look_up(within, name, depth);
                // A name without definition there is generated by a macro.
                if found.is_empty() { vec![Target::Item(within)] } else { found }
            };
        }
        (targets, path.len())
    }

    fn look_up(&self, module: usize, name: &str, depth: usize) -> Vec<Target> {
        let within = &self.modules[module];
        let mut found: Vec<Target> =
            within.children.get(name).map(|c| Target::Module(*c)).into_iter().collect();
        if within.items.contains(name) {
            found.push(Target::Item(module));
        }
        // `use name::…` inside a module does not bind the first name of its own path.
        for binding in within.bindings.iter().filter(|b| b.name == name && b.path != [name]) {
            found.extend(self.resolve(module, &binding.path, depth + 1).0);
        }
        if found.is_empty() {
            // A glob whose first name is not a module of this crate refers to another crate.
            let is_here = |name: &String| {
                matches!(name.as_str(), "crate" | "self" | "super")
                    || within.children.contains_key(name)
                    || within.bindings.iter().any(|binding| binding.name == *name)
            };
            for glob in within.globs.iter().filter(|glob| is_here(&glob[0])) {
                for target in self.resolve(module, glob, depth + 1).0 {
                    if let Target::Module(other) = target
                        && other != module
                    {
                        found.extend(self.look_up(other, name, depth + 1));
                    }
                }
            }
        }
        found.dedup();
        found
    }
}

//! Public names of a crate, read by syn from its `lib.rs` and the files of its public modules.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Public modules of every public type and trait: `""` is the root, `exports` a module of the root.
pub type Names = BTreeMap<String, BTreeSet<String>>;

/// Public names of the crate whose `lib.rs` is in `source`.
pub fn public_names(source: &Path) -> Names {
    let mut names = Names::new();
    read(&source.join("lib.rs"), source, "", &mut names);
    names
}

fn read(file: &Path, folder: &Path, module: &str, names: &mut Names) {
    let text = fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let parsed = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let mut add = |name: String| {
        // True for a type's name, false for a function, a module or a constant.
        let mut letters = name.chars();
        if letters.next().is_some_and(char::is_uppercase) && letters.any(char::is_lowercase) {
            names.entry(name).or_default().insert(module.to_string());
        }
    };
    let mut below = Vec::new();
    for item in &parsed.items {
        match item {
            syn::Item::Use(item) if is_public(&item.vis) => leaves(&item.tree, &mut add),
            syn::Item::Struct(item) if is_public(&item.vis) => add(item.ident.to_string()),
            syn::Item::Enum(item) if is_public(&item.vis) => add(item.ident.to_string()),
            syn::Item::Trait(item) if is_public(&item.vis) => add(item.ident.to_string()),
            syn::Item::Type(item) if is_public(&item.vis) => add(item.ident.to_string()),
            syn::Item::Mod(item) if is_public(&item.vis) => below.push(item.ident.to_string()),
            _ => {}
        }
    }
    for name in below {
        let inside = folder.join(&name);
        let places = [folder.join(format!("{name}.rs")), inside.join("mod.rs")];
        let file = places.iter().find(|place| place.exists());
        let file = file.unwrap_or_else(|| panic!("no file holds `mod {name}` of {}", folder.display()));
        let path = if module.is_empty() { name } else { format!("{module}::{name}") };
        read(file, &inside, &path, names);
    }
}

fn is_public(visibility: &syn::Visibility) -> bool {
    matches!(visibility, syn::Visibility::Public(_))
}

/// Names bound by a `use`.
fn leaves(tree: &syn::UseTree, add: &mut impl FnMut(String)) {
    match tree {
        syn::UseTree::Path(path) => leaves(&path.tree, add),
        syn::UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, add)),
        syn::UseTree::Name(leaf) => add(leaf.ident.to_string()),
        syn::UseTree::Rename(leaf) => add(leaf.rename.to_string()),
        syn::UseTree::Glob(_) => panic!("`pub use …::*` hides what is public"),
    }
}

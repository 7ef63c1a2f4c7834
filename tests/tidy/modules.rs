//! Definitions, imports and names of one module of a crate, read by syn.

use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};

/// The names of a path: `a::b::C`.
pub type Path = Vec<String>;

/// One module: a file, or an inline `mod` of a file.
pub struct Module {
    pub file: String,
    pub parent: Option<usize>,
    pub children: BTreeMap<String, usize>,
    /// Items defined by the module.
    pub items: BTreeSet<String>,
    /// Names bound by its `use` declarations, with their visibility.
    pub bindings: Vec<Binding>,
    /// Modules imported by `use …::*`.
    pub globs: Vec<Path>,
    /// Paths in its code.
    pub paths: Vec<Path>,
    /// Names of its local variables.
    pub variables: BTreeSet<String>,
}

impl Module {
    /// New module with the names of its items only.
    pub fn new(file: &str, parent: Option<usize>, items: &[syn::Item]) -> Self {
        Self {
            file: file.to_string(),
            parent,
            children: BTreeMap::new(),
            items: items.iter().filter(|i| !is_for_tests(i)).filter_map(defined_name).collect(),
            bindings: Vec::new(),
            globs: Vec::new(),
            paths: Vec::new(),
            variables: BTreeSet::new(),
        }
    }

    /// Reads the content of one item.
    pub fn read(&mut self, item: &syn::Item) {
        Reader(self).visit_item(item);
    }
}

pub struct Binding {
    pub name: String,
    pub path: Path,
    pub public: bool,
}

/// Collects the `use` declarations, paths and variables of one module.
struct Reader<'a>(&'a mut Module);

impl Reader<'_> {
    fn read_use(&mut self, tree: &syn::UseTree, mut before: Path, public: bool) {
        let mut bind = |name: String, path: Path| self.0.bindings.push(Binding { name, path, public });
        match tree {
            syn::UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.read_use(&path.tree, before, public);
            }
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.read_use(tree, before.clone(), public));
            }
            syn::UseTree::Name(leaf) if leaf.ident == "self" => {
                bind(before.last().cloned().unwrap_or_default(), before);
            }
            syn::UseTree::Name(leaf) => {
                before.push(leaf.ident.to_string());
                bind(leaf.ident.to_string(), before);
            }
            syn::UseTree::Rename(leaf) => {
                if leaf.ident != "self" {
                    before.push(leaf.ident.to_string());
                }
                bind(leaf.rename.to_string(), before);
            }
            syn::UseTree::Glob(_) => self.0.globs.push(before),
        }
    }

    /// Paths among tokens that syn does not parse: `a::b`, and names that do not follow a dot.
    fn read_tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is =
            |i: usize, mark: char| matches!(tokens.get(i), Some(TokenTree::Punct(p)) if p.as_char() == mark);
        let mut i = 0;
        while i < tokens.len() {
            match &tokens[i] {
                TokenTree::Group(group) => self.read_tokens(group.stream()),
                TokenTree::Ident(head) => {
                    let field = i > 0 && is(i - 1, '.');
                    let mut path = vec![head.to_string()];
                    while is(i + 1, ':') && is(i + 2, ':') {
                        let Some(TokenTree::Ident(next)) = tokens.get(i + 3) else { break };
                        path.push(next.to_string());
                        i += 3;
                    }
                    if !field {
                        self.0.paths.push(path);
                    }
                }
                _ => {}
            }
            i += 1;
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if item.leading_colon.is_none() {
            let public = !matches!(item.vis, syn::Visibility::Inherited);
            self.read_use(&item.tree, Vec::new(), public);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.0.paths.push(path.segments.iter().map(|s| s.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        self.visit_path(&call.path);
        self.read_tokens(call.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.read_tokens(list.tokens.clone());
        }
    }

    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_pat_ident(&mut self, variable: &'ast syn::PatIdent) {
        self.0.variables.insert(variable.ident.to_string());
        visit::visit_pat_ident(self, variable);
    }
}

fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    use syn::Item;
    match item {
        Item::Const(i) => &i.attrs,
        Item::Enum(i) => &i.attrs,
        Item::Fn(i) => &i.attrs,
        Item::Impl(i) => &i.attrs,
        Item::Macro(i) => &i.attrs,
        Item::Mod(i) => &i.attrs,
        Item::Static(i) => &i.attrs,
        Item::Struct(i) => &i.attrs,
        Item::Trait(i) => &i.attrs,
        Item::Type(i) => &i.attrs,
        Item::Use(i) => &i.attrs,
        _ => &[],
    }
}

/// True if the item has `#[cfg(test)]`.
pub fn is_for_tests(item: &syn::Item) -> bool {
    attributes(item).iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

/// The path of `#[path = "…"]`.
pub fn path_attribute(attributes: &[syn::Attribute]) -> Option<String> {
    attributes.iter().filter(|a| a.path().is_ident("path")).find_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(pair) => match &pair.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(path), .. }) => Some(path.value()),
            _ => None,
        },
        _ => None,
    })
}

fn defined_name(item: &syn::Item) -> Option<String> {
    use syn::Item;
    let name = match item {
        Item::Const(i) => &i.ident,
        Item::Enum(i) => &i.ident,
        Item::Fn(i) => &i.sig.ident,
        Item::Macro(i) => i.ident.as_ref()?,
        Item::Static(i) => &i.ident,
        Item::Struct(i) => &i.ident,
        Item::Trait(i) => &i.ident,
        Item::Type(i) => &i.ident,
        _ => return None,
    };
    Some(name.to_string())
}

//! Numbers in code that are thresholds.

use super::modules::is_for_tests;
use syn::visit::{self, Visit};

/// Numbers with an exponent, wherever they occur, and constants of type `f64`, `[f64; N]` and `u64`. Items under
/// `#[cfg(test)]` and texts are omitted.
pub fn thresholds(text: &str) -> Vec<String> {
    let mut found = Found(Vec::new());
    found.visit_file(&syn::parse_file(text).expect("Rust"));
    found.0
}

struct Found(Vec<String>);

impl<'a> Visit<'a> for Found {
    fn visit_item(&mut self, item: &'a syn::Item) {
        if !is_for_tests(item) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_const(&mut self, item: &'a syn::ItemConst) {
        let element = match &*item.ty {
            syn::Type::Array(array) => &*array.elem,
            other => other,
        };
        let is_number = |name: &str| matches!(element, syn::Type::Path(path) if path.path.is_ident(name));
        if is_number("f64") || is_number("u64") {
            self.0.push(format!("const {}", item.ident));
        } else {
            visit::visit_item_const(self, item);
        }
    }

    fn visit_lit_float(&mut self, literal: &'a syn::LitFloat) {
        if literal.base10_digits().contains(['e', 'E']) {
            self.0.push(literal.to_string());
        }
    }
}

//! The import reader and the search for cycles, on small artificial crates.

use super::circles::{circles, describe};
use super::imports::{Imports, imports};
use std::collections::BTreeMap;

fn read(files: &[(&str, &str)]) -> Imports {
    imports(&files.iter().map(|(path, text)| (path.to_string(), text.to_string())).collect())
}

/// The imports as (importing file, imported file).
fn pairs(imports: &Imports) -> Vec<(&str, &str)> {
    imports.keys().map(|(from, to)| (from.as_str(), to.as_str())).collect()
}

#[test]
fn a_circle_through_a_re_export_is_found() {
    let found = read(&[
        ("lib.rs", "mod a; mod b; pub use a::A; pub use b::B;"),
        ("a.rs", "use crate::B; pub struct A(B);"),
        ("b.rs", "pub struct B; impl B { fn a() -> crate::A { todo!() } }"),
    ]);
    assert_eq!(pairs(&found), [("a.rs", "b.rs"), ("b.rs", "a.rs")]);
    let circles = circles(&found);
    assert_eq!(circles.len(), 1);
    assert_eq!(describe(&circles[0], &found), "    a.rs imports B of b.rs\n    b.rs imports A of a.rs\n");
}

#[test]
fn a_circle_of_three_files_in_nested_modules_is_one_circle() {
    let found = read(&[
        ("lib.rs", "mod a; mod c;"),
        ("a/mod.rs", "mod b; pub use b::B; pub fn top() -> crate::c::C { crate::c::C }"),
        ("a/b.rs", "use super::top; pub struct B; fn f() { top(); }"),
        ("c.rs", "use crate::a::{self}; pub struct C; fn f() -> a::B { a::B }"),
    ]);
    assert_eq!(pairs(&found), [("a/b.rs", "a/mod.rs"), ("a/mod.rs", "c.rs"), ("c.rs", "a/b.rs")]);
    assert_eq!(circles(&found), [["a/b.rs", "a/mod.rs", "c.rs"].into()]);
}

#[test]
fn two_circles_are_two() {
    let found = read(&[
        ("main.rs", "mod a; mod b; mod c; mod d; fn main() { a::f(); }"),
        ("a.rs", "use crate::b::g; pub fn f() { g(); crate::c::f(); }"),
        ("b.rs", "pub fn g() { super::a::f(); }"),
        ("c.rs", "pub fn f() { super::d::g(); }"),
        ("d.rs", "pub fn g() { crate::c::f(); }"),
    ]);
    assert_eq!(circles(&found), [["a.rs", "b.rs"].into(), ["c.rs", "d.rs"].into()]);
}

#[test]
fn a_clean_tree_passes() {
    let found = read(&[
        ("lib.rs", "mod base; mod top; pub use top::Top; pub use base::{Base, number};"),
        ("base.rs", "pub struct Base; pub fn number() {} #[cfg(test)] mod tests { use crate::Top; }"),
        ("top/mod.rs", "mod part; pub use part::Top; mod tests_of_top {}"),
        ("top/part.rs", "use crate::{Base, number}; pub struct Top(Base); fn f() { number(); }"),
    ]);
    assert_eq!(pairs(&found), [("top/part.rs", "base.rs")]);
    assert!(circles(&found).is_empty());
}

#[test]
fn paths_in_macros_attributes_and_globs_count() {
    let found = read(&[
        ("lib.rs", "mod a; mod b; mod c; mod d;"),
        ("a.rs", "fn f() { println!(\"{}\", [super::b::g(), 1][0]); }"),
        ("b.rs", "#[serde(with = crate::c::with)] pub struct B;"),
        ("c.rs", "use super::d::*; pub fn with(d: D) {}"),
        ("d.rs", "pub struct D;"),
    ]);
    assert_eq!(pairs(&found), [("a.rs", "b.rs"), ("b.rs", "c.rs"), ("c.rs", "d.rs")]);
}

#[test]
fn items_defined_by_a_macro_belong_to_its_file() {
    let found = read(&[
        ("lib.rs", "mod a; mod b; pub use a::{Made};"),
        ("a.rs", "macro_rules! make { ($n:ident) => { pub struct $n; } } make!(Made);"),
        ("b.rs", "use crate::Made; fn f(_: Made) {}"),
    ]);
    assert_eq!(pairs(&found), [("b.rs", "a.rs")]);
}

#[test]
fn a_module_that_calls_what_it_re_exports_imports_it() {
    let found = read(&[
        ("lib.rs", "mod a;"),
        ("a/mod.rs", "mod size; pub use size::size; fn f() { size(); } pub struct A;"),
        ("a/size.rs", "use super::A; pub fn size() {} fn g(_: A) {}"),
    ]);
    assert_eq!(circles(&found).len(), 1);
}

#[test]
fn other_crates_and_variables_are_no_imports() {
    let found = read(&[
        ("lib.rs", "mod a; pub mod size; pub use size::size; fn f(size: u32) -> u32 { size }"),
        ("a.rs", "use other::size; use std::fmt; fn g() -> fmt::Result { size::Size; ::b::c(); Ok(()) }"),
        ("size.rs", "pub fn size() {}"),
    ]);
    assert!(found.is_empty(), "{found:?}");
}

#[test]
#[should_panic(expected = "no `mod` leads to [\"lost.rs\"]")]
fn a_file_that_nothing_declares_is_refused() {
    imports(&BTreeMap::from([("lib.rs".to_string(), String::new()), ("lost.rs".to_string(), String::new())]));
}

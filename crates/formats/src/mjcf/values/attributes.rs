//! Typed values of an element's attributes, with the defaults of its class.

use crate::mjcf::values::classes::{ClassId, Classes, DefaultKind};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use crate::urdf::elements::numbers::parse_numbers;

/// Attributes of an element. A value that the element does not have itself comes from its class.
#[derive(Clone, Copy)]
pub(crate) struct Attributes<'t> {
    pub tree: &'t ElementTree,
    pub element: ElementId,
    /// Classes, the class of the element, and its kind; `None` for an element without defaults.
    defaults: Option<(&'t Classes, ClassId, DefaultKind)>,
}

impl<'t> Attributes<'t> {
    /// Attributes without defaults.
    pub fn new(tree: &'t ElementTree, element: ElementId) -> Self {
        Self { tree, element, defaults: None }
    }

    /// Attributes with the defaults of a class.
    pub fn with_defaults(
        tree: &'t ElementTree,
        element: ElementId,
        defaults: (&'t Classes, ClassId, DefaultKind),
    ) -> Self {
        Self { tree, element, defaults: Some(defaults) }
    }

    /// Element that gives a value to one of the attributes: the element itself, or one in its class.
    pub fn source(&self, names: &[&'static str]) -> Option<ElementId> {
        if names.iter().any(|name| self.tree.attribute(self.element, name).is_some()) {
            return Some(self.element);
        }
        let (classes, class, kind) = self.defaults?;
        classes.find(class, kind, names)
    }

    /// Text of an attribute.
    pub fn text(&self, name: &'static str) -> Option<&'t str> {
        self.tree.attribute(self.source(&[name])?, name)
    }

    /// Value of an attribute; `None` if absent, or, with an error, if `parse` returns a defect.
    fn read<T>(
        &self,
        name: &'static str,
        parse: impl FnOnce(&str) -> Result<T, String>,
        findings: &mut Findings<'_>,
    ) -> Option<T> {
        let source = self.source(&[name])?;
        let text = self.tree.attribute(source, name)?;
        let report = |defect| {
            let message = || format!("{name}={}: {defect}", quoted(text));
            findings.attribute_error("bad-number", source, name, message);
        };
        parse(text).map_err(report).ok()
    }

    /// N finite numbers; `None` if absent, or, with an error, if invalid.
    pub fn numbers<const N: usize>(
        &self,
        name: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<[f64; N]> {
        self.read(name, parse_numbers::<N>, findings)
    }

    /// One finite number.
    pub fn number(&self, name: &'static str, findings: &mut Findings<'_>) -> Option<f64> {
        self.numbers::<1>(name, findings).map(|[value]| value)
    }

    /// From 1 to `most` finite numbers; `None` if absent, or, with an error, if invalid.
    pub fn list(&self, name: &'static str, most: usize, findings: &mut Findings<'_>) -> Option<Vec<f64>> {
        let number = |word: &str| parse_numbers::<1>(word).map(|[value]| value);
        let parse = |text: &str| {
            let values = text.split_ascii_whitespace().map(number).collect::<Result<Vec<f64>, String>>()?;
            if (1..=most).contains(&values.len()) {
                Ok(values)
            } else {
                Err(format!("got {} numbers; 1 to {most} are expected", values.len()))
            }
        };
        self.read(name, parse, findings)
    }

    /// One of the given words; `None` if absent, or, with an error, if it is another word.
    pub fn word<T: Copy>(
        &self,
        name: &'static str,
        words: &[(&'static str, T)],
        findings: &mut Findings<'_>,
    ) -> Option<T> {
        let source = self.source(&[name])?;
        let text = self.tree.attribute(source, name)?;
        let found = words.iter().find(|(word, _)| *word == text).map(|(_, value)| *value);
        if found.is_none() {
            findings.attribute_error("bad-keyword", source, name, || {
                let known = || words.iter().map(|(word, _)| *word);
                let guess = similar_name(text, known());
                let list = known().collect::<Vec<_>>().join(", ");
                format!("{name}={} is unknown{guess}; it is one of {list}", quoted(text))
            });
        }
        found
    }

    /// `true` or `false`.
    pub fn flag(&self, name: &'static str, findings: &mut Findings<'_>) -> Option<bool> {
        self.word(name, &[("true", true), ("false", false)], findings)
    }
}

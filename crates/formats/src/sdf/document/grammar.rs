//! Treatments of elements and attributes.

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Treatment {
    /// Part of the mechanism.
    Read,
    /// Ignored without a message: no effect on the mechanics of an impact.
    Silent,
    /// Ignored with a warning; the text gives the reason.
    Warned(&'static str),
    /// Not supported, and the result without this entry would be wrong: an error; the text gives the reason and a remedy.
    Refused(&'static str),
}

/// Entry of the table: an element with the attributes that have a meaning.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementRule {
    pub tag: &'static str,
    pub treatment: Treatment,
    /// True if a parent may have one such element.
    pub single: bool,
    pub attributes: &'static [&'static str],
    /// Rules of the children; `None` if children are not examined.
    pub children: Option<&'static [ElementRule]>,
}

/// Rule of an element that is read; a parent may have several.
pub(super) const fn several(
    tag: &'static str,
    attributes: &'static [&'static str],
    children: &'static [ElementRule],
) -> ElementRule {
    ElementRule { tag, treatment: Treatment::Read, single: false, attributes, children: Some(children) }
}

/// Rule of an element that is read; a parent may have one.
pub(super) const fn single(
    tag: &'static str,
    attributes: &'static [&'static str],
    children: &'static [ElementRule],
) -> ElementRule {
    ElementRule { single: true, ..several(tag, attributes, children) }
}

/// Rule of an element with a value as text; a parent may have one.
pub(super) const fn value(tag: &'static str) -> ElementRule {
    single(tag, &[], &[])
}

/// Rule of an element that is not read.
pub(super) const fn unread(tag: &'static str, treatment: Treatment) -> ElementRule {
    ElementRule { tag, treatment, single: false, attributes: &[], children: None }
}

/// Rule of an element that is read, and whose children other functions examine.
pub(super) const fn unexamined(tag: &'static str) -> ElementRule {
    unread(tag, Treatment::Read)
}

//! Grammar of a format: its elements and attributes with their treatments.

use percuss_mechanism::Severity;

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Treatment {
    /// Part of the mechanism.
    Read,
    /// Element that other functions examine: its attributes and children are not compared with the grammar.
    Unexamined,
    /// Ignored without a message: no effect on the mechanics of an impact.
    Silent,
    /// As `Silent`, and not suggested for an unknown tag.
    Unlisted,
    /// Ignored with a note; the text gives the reason.
    Noted(&'static str),
    /// Ignored with a warning; the text gives the reason.
    Warned(&'static str),
    /// As `Warned`, but silent if the value has no effect: one of these words, or a number of at most 0.
    WarnedUnless(&'static [&'static str], &'static str),
    /// Not supported, and the result without this entry would be wrong: an error with this code; the text gives the reason and a remedy.
    Refused(&'static str, &'static str),
}

impl Treatment {
    /// Severity, code and reason of the finding about an entry with this value; `None` for an entry without a finding.
    pub fn finding(self, value: &str) -> Option<(Severity, &'static str, &'static str)> {
        let value = value.trim_ascii();
        match self {
            Self::Read | Self::Unexamined | Self::Silent | Self::Unlisted => None,
            Self::Noted(reason) => Some((Severity::Note, "ignored", reason)),
            Self::WarnedUnless(harmless, _)
                if harmless.contains(&value) || value.parse::<f64>().is_ok_and(|number| number <= 0.0) =>
            {
                None
            }
            Self::Warned(reason) | Self::WarnedUnless(_, reason) => {
                Some((Severity::Warning, "ignored", reason))
            }
            Self::Refused(code, reason) => Some((Severity::Error, code, reason)),
        }
    }
}

/// Treatment of forces by which Drake holds loops together.
pub(crate) const COMPLIANT: Treatment = Treatment::Warned(
    "a finite stiffness closes no loop in an instantaneous impact; a loop that is closed by nothing else is open here",
);

/// Names of attributes, separated by blanks, with their treatment.
pub(crate) type Attributes = &'static [(&'static str, Treatment)];

/// Entry of a grammar: elements with the same attributes and children.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementRule {
    /// Tags, separated by blanks.
    pub tags: &'static str,
    /// Treatment of the elements.
    pub treatment: Treatment,
    /// True if a parent may have at most one element with each of the tags.
    pub single: bool,
    /// Attributes that are compared with the names of the file.
    pub attributes: Attributes,
    /// True if other attributes have no effect.
    pub open: bool,
    /// Rules of the children; `None` if the children are not compared with the grammar.
    pub children: Option<&'static [ElementRule]>,
}

/// Element that is read; a parent may have several.
pub(crate) const fn element(
    tags: &'static str,
    attributes: Attributes,
    children: &'static [ElementRule],
) -> ElementRule {
    let (single, open, children) = (false, false, Some(children));
    ElementRule { tags, treatment: Treatment::Read, single, attributes, open, children }
}

/// Element with a treatment other than `Read`; its attributes and children are not compared with the grammar.
pub(crate) const fn unread(tags: &'static str, treatment: Treatment) -> ElementRule {
    ElementRule { treatment, open: true, children: None, ..element(tags, &[], &[]) }
}

/// Element without which the result would be wrong: an error; the text gives the reason and a remedy.
pub(crate) const fn refused(tags: &'static str, reason: &'static str) -> ElementRule {
    unread(tags, Treatment::Refused("unsupported", reason))
}

/// Element that is ignored with a warning; the text gives the reason.
pub(crate) const fn warned(tags: &'static str, reason: &'static str) -> ElementRule {
    unread(tags, Treatment::Warned(reason))
}

impl ElementRule {
    /// The rule for an element of which a parent may have one.
    pub const fn single(self) -> Self {
        Self { single: true, ..self }
    }

    /// The rule for an element whose other attributes have no effect.
    pub const fn open(self) -> Self {
        Self { open: true, ..self }
    }

    /// Treatment of an attribute; `None` for an attribute that the rule does not contain.
    pub fn attribute(&self, name: &str) -> Option<Treatment> {
        let contains = |names: &str| names.split_ascii_whitespace().any(|known| known == name);
        self.attributes.iter().find(|(names, _)| contains(names)).map(|(_, treatment)| *treatment)
    }

    /// Names of all attributes.
    pub fn attribute_names(&self) -> impl Iterator<Item = &'static str> {
        self.attributes.iter().flat_map(|(names, _)| names.split_ascii_whitespace())
    }
}

/// Tags of all rules, each with its rule.
pub(crate) fn tags(
    rules: &'static [ElementRule],
) -> impl Iterator<Item = (&'static str, &'static ElementRule)> {
    rules.iter().flat_map(|rule| rule.tags.split_ascii_whitespace().map(move |tag| (tag, rule)))
}

/// Tags that are suggested for an unknown tag.
pub(crate) fn listed_tags(rules: &'static [ElementRule]) -> impl Iterator<Item = &'static str> {
    tags(rules).filter(|(_, rule)| !matches!(rule.treatment, Treatment::Unlisted)).map(|(tag, _)| tag)
}

//! Look-up errors with suggestions of similar names.

use std::fmt;

/// Kind of the named object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameKind {
    /// A link.
    Link,
    /// A joint.
    Joint,
    /// A named contact.
    Contact,
}

/// Error: unknown name, with similar names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName {
    /// Kind of the object.
    pub kind: NameKind,
    /// Requested name.
    pub name: String,
    /// Up to three similar names, most similar first.
    pub near: Vec<String>,
    /// Names that exist, for a message without similar names: of this kind, and for a link the named contacts.
    pub known: Vec<(NameKind, Vec<String>)>,
}

impl UnknownName {
    /// Error for a name without an object; `known`: names of this kind, and other names that the message may list.
    pub(crate) fn new(name: &str, known: &[(NameKind, Vec<&str>)]) -> Self {
        let Some((kind, names)) = known.first() else {
            return Self { kind: NameKind::Link, name: name.to_owned(), near: Vec::new(), known: Vec::new() };
        };
        let near = near_names(name, names.iter().copied());
        let listed = |names: &[&str]| names.iter().take(LISTED + 1).map(|name| (*name).to_owned()).collect();
        let known = known.iter().map(|(kind, names)| (*kind, listed(names))).collect();
        Self { kind: *kind, name: name.to_owned(), near, known }
    }
}

/// Largest number of names that a message lists.
const LISTED: usize = 16;
/// Longest name that a message lists in full, bytes.
const LONGEST_LISTED: usize = 60;

impl NameKind {
    /// Noun for messages.
    fn noun(self) -> &'static str {
        match self {
            NameKind::Link => "link",
            NameKind::Joint => "joint",
            NameKind::Contact => "contact",
        }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no {} is named \"{}\"", self.kind.noun(), self.name)?;
        write_near(f, &self.near)?;
        let known = if self.near.is_empty() { &self.known[..] } else { &[] };
        for (i, (kind, names)) in known.iter().filter(|(_, names)| !names.is_empty()).enumerate() {
            let lead = if i == 0 { "; there are" } else { ", and" };
            let shown = names.iter().take(LISTED).filter(|name| name.len() <= LONGEST_LISTED);
            let shown: Vec<String> = shown.map(|name| format!("\"{name}\"")).collect();
            let more = if names.len() > shown.len() { ", …" } else { "" };
            write!(f, "{lead} the {}s {}{more}", kind.noun(), shown.join(", "))?;
        }
        Ok(())
    }
}

impl std::error::Error for UnknownName {}

/// Writes `; did you mean "a", "b" or "c"?`, or nothing.
pub(crate) fn write_near(f: &mut fmt::Formatter<'_>, near: &[String]) -> fmt::Result {
    for (i, name) in near.iter().enumerate() {
        let lead = match i {
            0 => "; did you mean ",
            _ if i + 1 == near.len() => " or ",
            _ => ", ",
        };
        write!(f, "{lead}\"{name}\"")?;
    }
    if near.is_empty() { Ok(()) } else { f.write_str("?") }
}

/// Returns up to three candidates similar to `name`, most similar first.
///
/// Similar: a Jaro–Winkler similarity of at least 0.8 without regard to case, or one of the two names contains the other
/// (for a `name` of at least three bytes). Names of more than 200 bytes are ignored, and so is `name` itself: a rejected name
/// is no suggestion.
pub fn near_names<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    // Longer names are no typing errors, and the comparison is quadratic.
    const LONGEST: usize = 200;
    let wanted = name.to_lowercase();
    if wanted.is_empty() || wanted.len() > LONGEST {
        return Vec::new();
    }
    let mut scored: Vec<(f64, &str)> = candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= LONGEST && *candidate != name)
        .filter_map(|candidate| {
            let other = candidate.to_lowercase();
            let mut score = strsim::jaro_winkler(&wanted, &other);
            if wanted.len() >= 3 && (other.contains(&wanted) || wanted.contains(&other)) {
                score = score.max(0.85);
            }
            (score >= 0.8).then_some((score, candidate))
        })
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    scored.into_iter().take(3).map(|(_, candidate)| candidate.to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_come_best_first() {
        let names = ["lower_arm", "upper_arm", "wheel", "chassis"];
        assert_eq!(near_names("Lower_arm", names)[0], "lower_arm");
        assert_eq!(near_names("lowerarm", names)[0], "lower_arm");
        assert!(near_names("zzz", names).is_empty());
        assert!(near_names("wheel", names).is_empty(), "a rejected name is no suggestion");
    }

    #[test]
    fn message_reads_as_a_sentence() {
        let unknown = |near: &[&str]| {
            UnknownName {
                kind: NameKind::Link,
                name: "arm".into(),
                near: near.iter().map(|s| (*s).to_owned()).collect(),
                known: Vec::new(),
            }
            .to_string()
        };
        assert_eq!(unknown(&[]), "no link is named \"arm\"");
        let known = [(NameKind::Link, vec!["hub", "rim"]), (NameKind::Contact, vec!["stop"])];
        assert_eq!(
            UnknownName::new("zzz", &known).to_string(),
            "no link is named \"zzz\"; there are the links \"hub\", \"rim\", and the contacts \"stop\""
        );
        assert_eq!(unknown(&["a", "b"]), "no link is named \"arm\"; did you mean \"a\" or \"b\"?");
    }
}

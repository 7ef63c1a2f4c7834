//! Bounds on the text, checked before any parser runs.
//!
//! roxmltree does not recurse on nesting, but it compares every attribute of an element with every other, copies the
//! namespaces in scope, and expands an entity any number of times. A small file could therefore take hours or fill
//! the memory. This scan is a single pass. It recognises comments, CDATA, processing instructions, the DOCTYPE and
//! quotes. The parser checks that the text is well formed.

use crate::reading::limits::{
    DEEPEST_NESTING, MOST_ATTRIBUTES, MOST_ATTRIBUTES_IN_ALL, MOST_ELEMENTS, MOST_ENTITIES, MOST_EXPANDED,
    MOST_NAMESPACES, MOST_NODES, REFERENCES_IN_A_REFERENCE,
};
use crate::reading::report::{Place, Report};

/// True if the text is within the bounds; otherwise reports the excess.
pub(crate) fn check(text: &str, report: &mut Report) -> bool {
    let mut scan = Scan { bytes: text.as_bytes(), at: 0, ..Scan::default() };
    match scan.run() {
        Ok(()) => true,
        Err(excess) => {
            report.error("too-complex", Place::Offset(scan.at), || excess);
            false
        }
    }
}

#[derive(Default)]
struct Scan<'t> {
    bytes: &'t [u8],
    at: usize,
    depth: usize,
    elements: usize,
    attributes: usize,
    namespaces: usize,
    entities: usize,
    /// Length of the longest entity value; true if an entity refers to another.
    longest_entity: usize,
    nested_entities: bool,
}

impl Scan<'_> {
    fn run(&mut self) -> Result<(), String> {
        let tags = self.bytes.iter().filter(|b| **b == b'<').count();
        if tags > MOST_NODES as usize {
            return Err(format!("{tags} tags; at most {MOST_NODES} are read"));
        }
        let mut references = 0usize;
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'<' => self.markup(&mut references)?,
                b'&' => {
                    references += 1;
                    self.at += 1;
                }
                _ => self.at += 1,
            }
        }
        let inner = if self.nested_entities { REFERENCES_IN_A_REFERENCE } else { 1 };
        let expanded = references.saturating_mul(inner).saturating_mul(self.longest_entity);
        if self.entities > 0 && expanded > MOST_EXPANDED {
            self.at = 0;
            return Err(
                "the entities of the DOCTYPE could grow beyond 64 MiB when put in; write their text out"
                    .to_owned(),
            );
        }
        Ok(())
    }

    fn markup(&mut self, references: &mut usize) -> Result<(), String> {
        let rest = &self.bytes[self.at..];
        if rest.starts_with(b"<!--") {
            self.skip_past(4, b"-->");
        } else if rest.starts_with(b"<![CDATA[") {
            self.skip_past(9, b"]]>");
        } else if rest.starts_with(b"<?") {
            self.skip_past(2, b"?>");
        } else if rest.starts_with(b"<!DOCTYPE") {
            self.doctype()?;
        } else if rest.starts_with(b"</") {
            self.depth = self.depth.saturating_sub(1);
            self.at += 2;
        } else {
            self.tag(references)?;
        }
        Ok(())
    }

    /// Advances past `end`, searched from `lead` bytes after the current position.
    fn skip_past(&mut self, lead: usize, end: &[u8]) {
        let from = (self.at + lead).min(self.bytes.len());
        let found = self.bytes[from..].windows(end.len()).position(|w| w == end);
        self.at = found.map_or(self.bytes.len(), |i| from + i + end.len());
    }

    /// Advances past the closing quote of the value at the current position. Returns the byte range of the value.
    fn quoted(&mut self) -> std::ops::Range<usize> {
        let quote = self.bytes[self.at];
        let start = self.at + 1;
        let length = self.bytes[start..].iter().position(|b| *b == quote);
        let end = length.map_or(self.bytes.len(), |n| start + n);
        self.at = (end + 1).min(self.bytes.len());
        start..end
    }

    fn tag(&mut self, references: &mut usize) -> Result<(), String> {
        let start = self.at;
        let mut attributes = 0;
        let mut empty = false;
        self.at += 1;
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'>' => {
                    empty = self.bytes[self.at - 1] == b'/';
                    self.at += 1;
                    break;
                }
                b'"' | b'\'' => {
                    let value = self.quoted();
                    *references += self.bytes[value].iter().filter(|b| **b == b'&').count();
                }
                // Not well formed; the parser reports an error.
                b'<' => break,
                b'=' => {
                    attributes += 1;
                    self.at += 1;
                }
                b'x' if self.bytes[self.at..].starts_with(b"xmlns") => {
                    self.namespaces += 1;
                    self.at += 5;
                }
                _ => self.at += 1,
            }
        }
        let end = std::mem::replace(&mut self.at, start);
        self.elements += 1;
        self.attributes += attributes;
        if !empty {
            self.depth += 1;
        }
        if self.depth > DEEPEST_NESTING {
            return Err(format!("elements are nested deeper than {DEEPEST_NESTING} levels"));
        }
        if self.elements > MOST_ELEMENTS {
            return Err(format!("more than {MOST_ELEMENTS} elements"));
        }
        if attributes > MOST_ATTRIBUTES {
            return Err(format!("an element has more than {MOST_ATTRIBUTES} attributes"));
        }
        if self.attributes > MOST_ATTRIBUTES_IN_ALL {
            return Err(format!("more than {MOST_ATTRIBUTES_IN_ALL} attributes"));
        }
        if self.namespaces > MOST_NAMESPACES {
            return Err(format!("more than {MOST_NAMESPACES} declarations of namespaces"));
        }
        self.at = end;
        Ok(())
    }

    /// Scans the document type declaration with its entities.
    fn doctype(&mut self) -> Result<(), String> {
        let mut in_entity = false;
        let mut inside = false;
        self.at += 9;
        while let Some(&byte) = self.bytes.get(self.at) {
            let rest = &self.bytes[self.at..];
            match byte {
                // As in the parser: quotes count in an entity and before the internal subset, not in other
                // declarations.
                b'"' | b'\'' if in_entity || !inside => {
                    let start = self.at;
                    let value = self.quoted();
                    let value = &self.bytes[value];
                    if in_entity {
                        if value.contains(&b'<') {
                            self.at = start;
                            return Err(
                                "an entity holds tags; only entities that stand for text are read".to_owned()
                            );
                        }
                        self.longest_entity = self.longest_entity.max(value.len());
                        self.nested_entities |= value.contains(&b'&');
                    }
                }
                b'<' if rest.starts_with(b"<!--") => self.skip_past(4, b"-->"),
                b'<' if rest.starts_with(b"<?") => self.skip_past(2, b"?>"),
                b'<' if rest.starts_with(b"<!ENTITY") => {
                    in_entity = true;
                    self.entities += 1;
                    if self.entities > MOST_ENTITIES {
                        return Err(format!("more than {MOST_ENTITIES} entities"));
                    }
                    self.at += 8;
                }
                b'<' if inside => self.skip_past(1, b">"),
                b'>' if inside => {
                    in_entity = false;
                    self.at += 1;
                }
                b'>' => {
                    self.at += 1;
                    break;
                }
                b'[' | b']' => {
                    inside = byte == b'[';
                    self.at += 1;
                }
                _ => self.at += 1,
            }
        }
        Ok(())
    }
}

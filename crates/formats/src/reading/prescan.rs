//! Bounds on the text, checked before any parser runs.
//!
//! roxmltree does not recurse on nesting, but it compares every attribute of an element with every other, copies the
//! namespaces in scope, and expands an entity any number of times. A small file could therefore take hours or fill
//! the memory. This scan is a single pass. It recognises comments, CDATA, processing instructions, the DOCTYPE and
//! quotes. The parser checks that the text is well formed.

use crate::reading::limits::{
    MAX_ATTRIBUTES_PER_ELEMENT, MAX_ELEMENT_DEPTH, MAX_ELEMENTS, MAX_ENTITIES, MAX_EXPANDED_BYTES,
    MAX_NAMESPACES, MAX_NESTED_REFERENCES, MAX_NODES, MAX_TOTAL_ATTRIBUTES,
};
use crate::reading::report::{Place, Report};

/// True if the text is within the bounds; otherwise reports the excess.
pub(crate) fn check_bounds(text: &str, report: &mut Report) -> bool {
    let mut scanner = Scan { bytes: text.as_bytes(), position: 0, ..Scan::default() };
    match scanner.scan_text() {
        Ok(()) => true,
        Err(excess) => {
            report.error("too-complex", Place::Offset(scanner.position), || excess);
            false
        }
    }
}

/// State of the scan.
#[derive(Default)]
struct Scan<'t> {
    bytes: &'t [u8],
    position: usize,
    depth: usize,
    elements: usize,
    attributes: usize,
    namespaces: usize,
    entities: usize,
    references: usize,
    /// Length of the longest entity value, bytes.
    longest_entity: usize,
    /// True if an entity refers to another.
    nested_entities: bool,
}

impl Scan<'_> {
    /// Scans the whole text. An error names the exceeded bound, at the byte offset `position`.
    fn scan_text(&mut self) -> Result<(), String> {
        let tags = self.bytes.iter().filter(|b| **b == b'<').count();
        if tags > MAX_NODES as usize {
            return Err(format!("{tags} tags; at most {MAX_NODES} are read"));
        }
        while let Some(&byte) = self.bytes.get(self.position) {
            match byte {
                b'<' => self.scan_markup()?,
                b'&' => {
                    self.references += 1;
                    self.position += 1;
                }
                _ => self.position += 1,
            }
        }
        let nested = if self.nested_entities { MAX_NESTED_REFERENCES } else { 1 };
        let expanded = self.references.saturating_mul(nested).saturating_mul(self.longest_entity);
        if self.entities > 0 && expanded > MAX_EXPANDED_BYTES {
            self.position = 0;
            return Err(
                "the entities of the DOCTYPE could grow beyond 64 MiB when put in; write their text out"
                    .to_owned(),
            );
        }
        Ok(())
    }

    /// Scans the tag, comment, CDATA section, instruction or DOCTYPE at the current position.
    fn scan_markup(&mut self) -> Result<(), String> {
        let rest = &self.bytes[self.position..];
        if rest.starts_with(b"<!--") {
            self.skip_past(4, b"-->");
        } else if rest.starts_with(b"<![CDATA[") {
            self.skip_past(9, b"]]>");
        } else if rest.starts_with(b"<?") {
            self.skip_past(2, b"?>");
        } else if rest.starts_with(b"<!DOCTYPE") {
            self.scan_doctype()?;
        } else if rest.starts_with(b"</") {
            self.depth = self.depth.saturating_sub(1);
            self.position += 2;
        } else {
            self.scan_tag()?;
        }
        Ok(())
    }

    /// Advances past `end`, searched from `opening_length` bytes after the current position.
    fn skip_past(&mut self, opening_length: usize, end: &[u8]) {
        let from = (self.position + opening_length).min(self.bytes.len());
        let offset = self.bytes[from..].windows(end.len()).position(|w| w == end);
        self.position = offset.map_or(self.bytes.len(), |i| from + i + end.len());
    }

    /// Advances past the closing quote of the value at the current position. Returns the byte range of the value.
    fn skip_quoted(&mut self) -> std::ops::Range<usize> {
        let quote = self.bytes[self.position];
        let start = self.position + 1;
        let length = self.bytes[start..].iter().position(|b| *b == quote);
        let end = length.map_or(self.bytes.len(), |n| start + n);
        self.position = (end + 1).min(self.bytes.len());
        start..end
    }

    /// Scans an opening tag and its attributes.
    fn scan_tag(&mut self) -> Result<(), String> {
        let start = self.position;
        let mut attributes = 0;
        let mut empty = false;
        self.position += 1;
        while let Some(&byte) = self.bytes.get(self.position) {
            match byte {
                b'>' => {
                    empty = self.bytes[self.position - 1] == b'/';
                    self.position += 1;
                    break;
                }
                b'"' | b'\'' => {
                    let value = self.skip_quoted();
                    self.references += self.bytes[value].iter().filter(|b| **b == b'&').count();
                }
                // Not well formed; the parser reports an error.
                b'<' => break,
                b'=' => {
                    attributes += 1;
                    self.position += 1;
                }
                b'x' if self.bytes[self.position..].starts_with(b"xmlns") => {
                    self.namespaces += 1;
                    self.position += 5;
                }
                _ => self.position += 1,
            }
        }
        let end = std::mem::replace(&mut self.position, start);
        self.elements += 1;
        self.attributes += attributes;
        if !empty {
            self.depth += 1;
        }
        if self.depth > MAX_ELEMENT_DEPTH {
            return Err(format!("elements are nested deeper than {MAX_ELEMENT_DEPTH} levels"));
        }
        if self.elements > MAX_ELEMENTS {
            return Err(format!("more than {MAX_ELEMENTS} elements"));
        }
        if attributes > MAX_ATTRIBUTES_PER_ELEMENT {
            return Err(format!("an element has more than {MAX_ATTRIBUTES_PER_ELEMENT} attributes"));
        }
        if self.attributes > MAX_TOTAL_ATTRIBUTES {
            return Err(format!("more than {MAX_TOTAL_ATTRIBUTES} attributes"));
        }
        if self.namespaces > MAX_NAMESPACES {
            return Err(format!("more than {MAX_NAMESPACES} declarations of namespaces"));
        }
        self.position = end;
        Ok(())
    }

    /// Scans the document type declaration; an entity that contains tags is an error.
    fn scan_doctype(&mut self) -> Result<(), String> {
        let mut in_entity = false;
        let mut in_subset = false;
        self.position += 9;
        while let Some(&byte) = self.bytes.get(self.position) {
            let rest = &self.bytes[self.position..];
            match byte {
                // As in the parser: quotes count in an entity and before the internal subset, not in other
                // declarations.
                b'"' | b'\'' if in_entity || !in_subset => {
                    let start = self.position;
                    let value = self.skip_quoted();
                    let value = &self.bytes[value];
                    if in_entity {
                        if value.contains(&b'<') {
                            self.position = start;
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
                    if self.entities > MAX_ENTITIES {
                        return Err(format!("more than {MAX_ENTITIES} entities"));
                    }
                    self.position += 8;
                }
                b'<' if in_subset => self.skip_past(1, b">"),
                b'>' if in_subset => {
                    in_entity = false;
                    self.position += 1;
                }
                b'>' => {
                    self.position += 1;
                    break;
                }
                b'[' | b']' => {
                    in_subset = byte == b'[';
                    self.position += 1;
                }
                _ => self.position += 1,
            }
        }
        Ok(())
    }
}

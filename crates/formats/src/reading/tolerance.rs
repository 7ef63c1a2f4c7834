//! XML that the parsers of robotics programs accept, and a strict parser does not: `--` in comments, and prefixes without a declaration.

use crate::reading::limits::MAX_DECLARED_PREFIXES;
use std::borrow::Cow;

/// Text in which hyphens in comments are blank, and undeclared prefixes are declared in the root element. Byte offsets change only
/// behind the root tag, on its line.
///
/// Prefixes of xacro stay undeclared: a file with its macros is no model yet.
pub(crate) fn tolerant_text(text: &str) -> Cow<'_, str> {
    let comments = blank_hyphens(text);
    let Some(end) = end_of_root_tag(&comments) else { return comments };
    let prefixes = undeclared_prefixes(&comments, &comments[..end]);
    if prefixes.is_empty() {
        return comments;
    }
    let mut declared = comments[..end].to_owned();
    for prefix in prefixes {
        // Elements of Drake have a meaning in URDF and SDFormat.
        let uri = if prefix == "drake" { "http://drake.mit.edu" } else { prefix };
        declared.push_str(&format!(" xmlns:{prefix}=\"{uri}\""));
    }
    declared.push_str(&comments[end..]);
    Cow::Owned(declared)
}

/// Replaces hyphens that make a comment invalid by spaces.
fn blank_hyphens(text: &str) -> Cow<'_, str> {
    let mut changed: Option<Vec<u8>> = None;
    let mut at = 0;
    while let Some(start) = text[at..].find("<!").map(|found| at + found) {
        let (opening, closing) = if text[start..].starts_with("<!--") {
            ("<!--", "-->")
        } else if text[start..].starts_with("<![CDATA[") {
            ("<![CDATA[", "]]>")
        } else {
            at = start + 2;
            continue;
        };
        let inside = start + opening.len();
        let Some(end) = text[inside..].find(closing).map(|found| inside + found) else { break };
        let content = &text[inside..end];
        if opening == "<!--" && (content.contains("--") || content.ends_with('-')) {
            let bytes = changed.get_or_insert_with(|| text.as_bytes().to_vec());
            bytes[inside..end].iter_mut().filter(|byte| **byte == b'-').for_each(|byte| *byte = b' ');
        }
        at = end + closing.len();
    }
    // ASCII was replaced by ASCII.
    match changed.map(String::from_utf8) {
        Some(Ok(changed)) => Cow::Owned(changed),
        Some(Err(_)) | None => Cow::Borrowed(text),
    }
}

/// Byte offset behind the name of the root element.
fn end_of_root_tag(text: &str) -> Option<usize> {
    let name = crate::reading::xml::root_name(text)?;
    // The name is a part of the text.
    let start = name.as_ptr() as usize - text.as_ptr() as usize;
    Some(start + name.len())
}

/// Prefixes of tags and attributes that `head`, the text up to the root tag, and the text itself do not declare.
fn undeclared_prefixes<'t>(text: &'t str, head: &str) -> Vec<&'t str> {
    let is_name = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-' | b'.');
    let bytes = text.as_bytes();
    let mut found: Vec<&str> = Vec::new();
    let mut at = head.len();
    while let Some(colon) = text[at..].find(':').map(|found| at + found) {
        at = colon + 1;
        let length = bytes[..colon].iter().rev().take_while(|byte| is_name(**byte)).count();
        let start = colon - length;
        let before = start.checked_sub(1).map(|i| bytes[i]);
        let is_prefix = length > 0
            && bytes[start].is_ascii_alphabetic()
            && matches!(before, Some(b'<' | b'/' | b' ' | b'\t' | b'\n' | b'\r'))
            && bytes.get(at).is_some_and(|byte| byte.is_ascii_alphabetic() || *byte == b'_');
        let prefix = &text[start..colon];
        if !is_prefix || matches!(prefix, "xml" | "xmlns" | "xacro") || found.contains(&prefix) {
            continue;
        }
        if found.len() == MAX_DECLARED_PREFIXES {
            break;
        }
        if !text.contains(&format!("xmlns:{prefix}")) {
            found.push(prefix);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::tolerant_text;

    #[test]
    fn comments_and_prefixes_are_made_valid() {
        let text = "<!-- a -- b ---><sdf version='1.7'><drake:joint gz:x='1'/><![CDATA[<!-- -- -->]]></sdf>";
        let tolerant = tolerant_text(text);
        assert!(roxmltree::Document::parse(text).is_err());
        assert!(roxmltree::Document::parse(&tolerant).is_ok(), "{tolerant}");
        assert!(tolerant.contains("<![CDATA[<!-- -- -->]]>"));
        let valid = "<!-- - --><robot xmlns:xacro='x'><xacro:a/>https://x y:z</robot>";
        assert_eq!(tolerant_text(valid).matches("xmlns").count(), 2);
        assert!(roxmltree::Document::parse(&tolerant_text(valid)).is_ok());
        assert_eq!(tolerant_text("<robot><xacro:a/></robot>"), "<robot><xacro:a/></robot>");
    }
}

//! XML that the parsers of robotics programs accept, and a strict parser does not: `--` in comments, prefixes without a declaration, white
//! space before the XML declaration, and attributes without a blank between them.

use crate::reading::limits::MAX_DECLARED_PREFIXES;
use crate::reading::report::{Place, Report};
use std::borrow::Cow;

/// Text in which hyphens in comments and a late XML declaration are blank, attributes are separated, and undeclared prefixes are declared in
/// the root element. Byte offsets change only behind the root tag and missing blanks, on the same line. The report gets notes about the
/// declaration and the attributes.
pub(crate) fn tolerant_text<'t>(text: &'t str, report: &mut Report) -> Cow<'t, str> {
    let comments = separate_attributes(blank_hyphens(text), report);
    let comments = blank_late_declaration(comments, report);
    let Some(end) = end_of_root_tag(&comments) else { return comments };
    let prefixes = undeclared_prefixes(&comments, &comments[..end]);
    if prefixes.is_empty() {
        return comments;
    }
    let mut declared = comments[..end].to_owned();
    for prefix in prefixes {
        // Elements of Drake have a meaning in URDF and SDFormat.
        let uri = match prefix {
            "drake" => "http://drake.mit.edu",
            "xacro" => "http://www.ros.org/wiki/xacro",
            other => other,
        };
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

/// Replaces an XML declaration behind white space by spaces.
fn blank_late_declaration<'t>(text: Cow<'t, str>, report: &mut Report) -> Cow<'t, str> {
    let blanks = text.len() - text.trim_ascii_start().len();
    let end = text[blanks..].strip_prefix("<?xml").and_then(|rest| rest.find("?>"));
    let Some(end) = end.filter(|_| blanks > 0).map(|end| blanks + "<?xml".len() + end + "?>".len()) else {
        return text;
    };
    report.note("xml-repaired", Place::Offset(blanks), || {
        "white space before <?xml is skipped; delete it for other programs".to_owned()
    });
    let blank: String = text[..end]
        .chars()
        .map(|c| if c == '\n' { "\n".to_owned() } else { " ".repeat(c.len_utf8()) })
        .collect();
    Cow::Owned(blank + &text[end..])
}

/// Inserts a blank between a value and the next attribute of a tag.
fn separate_attributes<'t>(text: Cow<'t, str>, report: &mut Report) -> Cow<'t, str> {
    let bytes = text.as_bytes();
    let mut joints = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find('<').map(|found| at + found) {
        let rest = &text[start..];
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<!", ">"), ("<?", "?>")];
        if let Some((_, end)) = skipped.iter().find(|(begin, _)| rest.starts_with(begin)) {
            let Some(length) = rest.find(end) else { break };
            at = start + length + end.len();
            continue;
        }
        at = start + 1;
        while let Some(length) =
            bytes[at..].iter().position(|byte| matches!(byte, b'"' | b'\'' | b'<' | b'>'))
        {
            at += length;
            let quote = bytes[at];
            if matches!(quote, b'<' | b'>') {
                break;
            }
            let Some(length) = bytes[at + 1..].iter().position(|byte| *byte == quote) else { return text };
            at += length + 2;
            if bytes.get(at).is_some_and(|byte| byte.is_ascii_alphabetic() || matches!(byte, b'_' | 0x80..)) {
                joints.push(at);
            }
        }
    }
    let Some(first) = joints.first() else { return text };
    report.note("xml-repaired", Place::Offset(*first), || {
        format!("no blank between two attributes ({} places); insert one for other programs", joints.len())
    });
    let mut separated = String::with_capacity(text.len() + joints.len());
    let mut done = 0;
    for joint in joints {
        separated.push_str(&text[done..joint]);
        separated.push(' ');
        done = joint;
    }
    separated.push_str(&text[done..]);
    Cow::Owned(separated)
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
        // Macros that are left in another model are an error.
        let is_macro = prefix == "xacro" && !head.ends_with("<robot");
        if !is_prefix || matches!(prefix, "xml" | "xmlns") || is_macro || found.contains(&prefix) {
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
    use super::*;

    fn repaired(text: &str) -> String {
        tolerant_text(text, &mut Report::default()).into_owned()
    }

    #[test]
    fn comments_and_prefixes_are_made_valid() {
        let text = "<!-- a -- b ---><sdf version='1.7'><drake:joint gz:x='1'/><![CDATA[<!-- -- -->]]></sdf>";
        let tolerant = repaired(text);
        assert!(roxmltree::Document::parse(text).is_err());
        assert!(roxmltree::Document::parse(&tolerant).is_ok(), "{tolerant}");
        assert!(tolerant.contains("<![CDATA[<!-- -- -->]]>"));
        let valid = "<!-- - --><robot xmlns:xacro='x'><xacro:a/>https://x y:z</robot>";
        assert_eq!(repaired(valid).matches("xmlns").count(), 2);
        assert!(roxmltree::Document::parse(&repaired(valid)).is_ok());
        assert_eq!(repaired("<sdf><xacro:a/></sdf>"), "<sdf><xacro:a/></sdf>");
        for (given, expected) in [
            ("\n <?xml version='1.0'?><robot/>", format!("\n {}<robot/>", " ".repeat(21))),
            ("<a b='>'c=\"<!-- '\"d='1'/>", "<a b='>' c=\"<!-- '\" d='1'/>".to_owned()),
            (
                "<a><!-- b='1'c='2' --><?d e='1'f?><g h='1'/>'i'j</a>",
                "<a><!-- b='1'c='2' --><?d e='1'f?><g h='1'/>'i'j</a>".to_owned(),
            ),
        ] {
            assert_eq!(repaired(given), expected);
        }
    }
}

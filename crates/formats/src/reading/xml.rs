//! Parsing of XML text within bounds, with errors in the report.

use crate::reading::limits::{MAX_NODES, MAX_PARSER_MESSAGE};
use crate::reading::prescan;
use crate::reading::report::{Place, Report, cut, shortened};
use roxmltree::{Document, ParsingOptions};

/// Node of a document, with one lifetime for the document and its text.
pub(crate) type Node<'a> = roxmltree::Node<'a, 'a>;

/// Text of an element without the comments beside it. If a comment divides the text, the source from the first to the last part, which no
/// parser of numbers accepts; if elements divide it, the first part.
pub(crate) fn text_of<'a>(node: roxmltree::Node<'a, '_>) -> Option<&'a str> {
    let is_word = |child: &roxmltree::Node<'_, '_>| {
        child.is_text() && child.text().is_some_and(|text| !text.trim_ascii().is_empty())
    };
    let mut texts = node.children().filter(is_word);
    match (texts.next()?, texts.next_back()) {
        (first, Some(last)) if !node.children().any(|child| child.is_element()) => {
            node.document().input_text().get(first.range().start..last.range().end)
        }
        (first, _) => first.text(),
    }
}

/// Parses a text; `None`, with an error in the report, if it exceeds the bounds or is not well-formed.
pub(crate) fn parse<'t>(text: &'t str, report: &mut Report) -> Option<Document<'t>> {
    if !prescan::check_bounds(text, report) {
        return None;
    }
    let parsing = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, entity_resolver: None };
    match Document::parse_with_options(text, parsing) {
        Ok(document) => Some(document),
        Err(error) => {
            report_parse_error(text, &error, report);
            None
        }
    }
}

/// Name of the root element, found without a parser; `None` if the text does not begin as XML.
pub fn root_name(text: &str) -> Option<&str> {
    let mut rest = text.trim_ascii_start();
    loop {
        let end = if rest.starts_with("<!--") {
            rest.find("-->")? + 3
        } else if rest.starts_with("<?") {
            rest.find("?>")? + 2
        } else if rest.starts_with("<!DOCTYPE") {
            // The internal subset may contain tags.
            let (bracket, close) = (rest.find('['), rest.find('>')?);
            match bracket.filter(|at| *at < close) {
                Some(_) => rest.find("]>").or_else(|| rest.find("] >"))? + 2,
                None => close + 1,
            }
        } else {
            break;
        };
        rest = rest[end..].trim_ascii_start().trim_start_matches('>').trim_ascii_start();
    }
    let name = rest.strip_prefix('<')?;
    let end = name.find(|c: char| c.is_ascii_whitespace() || c == '>' || c == '/')?;
    Some(&name[..end])
}

/// Reports text that is not well-formed XML.
fn report_parse_error(text: &str, error: &roxmltree::Error, report: &mut Report) {
    use roxmltree::Error;
    let position = error.pos();
    let place = match error {
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => Place::Offset(text.len()),
        _ => Place::Offset(byte_offset(text, position.row, position.col)),
    };
    let remedy = match error {
        Error::UnknownNamespace(prefix, _) if prefix == "xacro" => {
            report.add_xacro_error(place, "the prefix \"xacro:\"");
            return;
        }
        Error::UnexpectedDeclaration(_) => ": delete what precedes <?xml".to_owned(),
        Error::MalformedEntityReference(_) => ": write &amp; for the character &".to_owned(),
        Error::UnknownEntityReference(..) => ": write the character itself, or declare the entity".to_owned(),
        Error::UnknownToken(position) => after_root(text, byte_offset(text, position.row, position.col)),
        Error::NodesLimitReached => {
            report.error("too-complex", Place::File, || {
                format!("more than {} elements, comments and stretches of text", MAX_NODES)
            });
            return;
        }
        Error::UnknownNamespace(prefix, _) => {
            format!(": declare the prefix in the root element, xmlns:{}=\"...\"", shortened(prefix))
        }
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => {
            ": the file ends too early; was it cut off?".to_owned()
        }
        Error::EntityReferenceLoop(_) => ": entities that grow without bound are refused".to_owned(),
        // `roxmltree::Error` has further variants; for these the parser's message is enough.
        _ => String::new(),
    };
    // The parser's message repeats the position.
    let message = error.to_string().replace(&format!(" at {}:{}", position.row, position.col), "");
    report.error("not-xml", place, || {
        format!("not well-formed XML: {}{remedy}", cut(&message, MAX_PARSER_MESSAGE))
    });
}

/// Remedy for text behind the end tag of the root element; empty at another place.
fn after_root(text: &str, offset: usize) -> String {
    let end = root_name(text).map(|root| format!("</{root}>"));
    match end.filter(|end| text[..offset].trim_end().ends_with(end)) {
        Some(end) => format!(": delete what follows {}", shortened(&end)),
        None => String::new(),
    }
}

/// Byte offset of a line and column (in characters), both from 1.
fn byte_offset(text: &str, row: u32, column: u32) -> usize {
    let start: usize = text.split_inclusive('\n').take(row.saturating_sub(1) as usize).map(str::len).sum();
    let line = &text[start..];
    let within = line.char_indices().nth(column.saturating_sub(1) as usize).map_or(line.len(), |(i, _)| i);
    start + within
}

#[cfg(test)]
mod tests {
    use super::root_name;

    #[test]
    fn the_root_is_found_behind_what_may_stand_before_it() {
        for text in [
            "<mujoco/>",
            "  <?xml version=\"1.0\"?>\n<!-- <robot> -->\n<mujoco model=\"a\">",
            "<!DOCTYPE mujoco [<!ENTITY m \"1\">]><mujoco>",
            "<!DOCTYPE mujoco><mujoco\t>",
        ] {
            assert_eq!(root_name(text), Some("mujoco"), "{text}");
        }
        for text in ["", "mujoco", "<!-- <mujoco/>", "<mujoco"] {
            assert_eq!(root_name(text), None, "{text}");
        }
    }
}

//! Construction of a mechanism from a source in URDF.

use crate::reading::limits;
use crate::reading::prescan;
use crate::reading::report::{Place, Report, cut, shortened};
use crate::urdf::consistency;
use crate::urdf::descriptions;
use crate::urdf::elements::dialect::ROBOT;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::shapes::shape::{Shape, link_shapes};
use crate::urdf::elements::survey::{check_element, report_xacro_elements};
use crate::urdf::texts::Texts;
use crate::{DEFAULT_MAX_SIZE, Diagnostic, LoadError, Source};
use percuss_mechanism::{Accept, Built, Mechanism, MechanismBuilder, Severity, Subject};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::HashSet;

/// Options of the reader.
#[derive(Clone, Copy, Debug, Default)]
pub struct LoadOptions {
    /// Findings that the user accepts.
    pub accept: Accept,
}

/// Mechanism with the findings in its file.
#[derive(Debug)]
pub struct Loaded {
    /// Mechanism of the file.
    pub mechanism: Mechanism,
    /// Shapes of every link, in link order.
    pub shapes: Vec<Vec<Shape>>,
    /// Warnings and notes, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a URDF, closed loops and couplings included.
///
/// Units of URDF: m, kg, kg·m², rad. Inertias in a rotated frame are transformed to the link's axes, I = R I′ Rᵀ. Meshes,
/// packages and external entities are not opened.
///
/// # Errors
/// [`LoadError`] with all findings if a finding is an error (at most 50 findings of each severity; further findings are only
/// counted).
pub fn load(source: &Source, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let mut report = Report::default();
    let Some(text) = source.text(&mut report) else {
        return Err(LoadError { diagnostics: report.finish(&source.name, "") });
    };
    let mechanism = build_mechanism(text, options, &mut report);
    let failed = report.has_errors();
    let diagnostics = report.finish(&source.name, text);
    match mechanism {
        Some((mechanism, shapes)) if !failed => Ok(Loaded { mechanism, shapes, diagnostics }),
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// Reads a URDF or URDF+ file of at most [`DEFAULT_MAX_SIZE`] bytes, with the default options. `-` is the standard
/// input. See [`load`].
///
/// # Errors
/// [`LoadError`], also if the file cannot be read.
pub fn load_file(path: &str) -> Result<Loaded, LoadError> {
    load(&Source::read(path, DEFAULT_MAX_SIZE)?, &LoadOptions::default())
}

/// Builds the mechanism and the shapes of all links; `None` after an error.
fn build_mechanism(
    text: &str,
    options: &LoadOptions,
    report: &mut Report,
) -> Option<(Mechanism, Vec<Vec<Shape>>)> {
    if !prescan::check_bounds(text, report) {
        return None;
    }
    let parsing = ParsingOptions { allow_dtd: true, nodes_limit: limits::MAX_NODES, entity_resolver: None };
    let document = match Document::parse_with_options(text, parsing) {
        Ok(document) => document,
        Err(error) => {
            report_parse_error(text, &error, report);
            return None;
        }
    };
    let robot = document.root_element();
    if !check_root_tag(robot, report) {
        return None;
    }
    report_xacro_elements(robot, report);
    check_element(robot, &ROBOT, report);
    check_robot_attributes(robot, report);
    if report.is_xacro() {
        return None;
    }
    let nodes = Nodes::collect(robot, report);
    if !nodes.check_counts(robot, report) {
        return None;
    }
    let mut texts = Texts::read_elements(&nodes, report);
    consistency::resolve_references(robot, &nodes, &mut texts, report);
    if report.has_errors() {
        return None;
    }
    let name = robot.attribute("name").unwrap_or_default();
    let name =
        if name.len() > limits::LONGEST_NAME { cut(name, limits::LONGEST_NAME) } else { name.to_owned() };
    let builder = MechanismBuilder::new(name).accept(options.accept);
    let builder = texts.links.iter().map(descriptions::describe_link).fold(builder, MechanismBuilder::link);
    let builder =
        texts.joints.iter().map(descriptions::describe_joint).fold(builder, MechanismBuilder::joint);
    let builder = texts.closures.into_iter().fold(builder, MechanismBuilder::closure);
    let builder = texts.couplings.into_iter().fold(builder, MechanismBuilder::coupling);
    let builder = texts.contacts.into_iter().fold(builder, MechanismBuilder::contact);
    let (mechanism, findings) = match builder.build() {
        Ok(Built { mechanism, mut findings }) => {
            findings.extend(mechanism.implausible_inertias(options.accept));
            (Some(mechanism), findings)
        }
        Err(error) => (None, error.findings),
    };
    let known = known_warnings(&document);
    for (subject, problem) in findings {
        let is_known =
            matches!(&subject, Subject::Link { name, .. } if known.contains(&(problem.code(), name)));
        let severity = match problem.severity() {
            Severity::Warning if is_known => Severity::Note,
            severity => severity,
        };
        report.add(severity, problem.code(), nodes.locate(robot, &subject, &problem), || problem.to_string());
    }
    let shapes = nodes.links.iter().map(|link| link_shapes(*link)).collect();
    mechanism.map(|mechanism| (mechanism, shapes))
}

/// Code of the warning that an imported model may mark as known. The importer reports this warning with its position in the
/// suspension file.
pub const KNOWN_WARNING: &str = "triangle-inequality";

/// Code and link name of the warnings that the importer reported before: `<?percuss-known CODE NAME?>` above the robot.
fn known_warnings<'a>(document: &'a Document<'_>) -> HashSet<(&'a str, &'a str)> {
    let instructions = document.root().children().filter_map(|node| node.pi());
    let known = instructions.filter(|pi| pi.target == "percuss-known").filter_map(|pi| pi.value);
    let known = known.filter_map(|value| value.trim().split_once(' '));
    // A file may not silence other warnings.
    known.filter(|(code, _)| *code == KNOWN_WARNING).collect()
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
        Error::NodesLimitReached => {
            report.error("too-complex", Place::File, || {
                format!("more than {} elements, comments and stretches of text", limits::MAX_NODES)
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
        format!("not well-formed XML: {}{remedy}", cut(&message, limits::MAX_PARSER_MESSAGE))
    });
}

/// Byte offset of a line and column (in characters), both from 1.
fn byte_offset(text: &str, row: u32, column: u32) -> usize {
    let start: usize = text.split_inclusive('\n').take(row.saturating_sub(1) as usize).map(str::len).sum();
    let line = &text[start..];
    let within = line.char_indices().nth(column.saturating_sub(1) as usize).map_or(line.len(), |(i, _)| i);
    start + within
}

/// True for `<robot>`; otherwise reports the probable kind of the file.
fn check_root_tag(root: Node<'_, '_>, report: &mut Report) -> bool {
    let name = root.tag_name().name();
    let remark = match name {
        "robot" => return true,
        "sdf" | "gazebo" => {
            "this is an SDF file (Gazebo's), which is not read; `sdf2urdf` of sdformat_tools converts what URDF can hold"
        }
        "mujoco" => {
            "this is an MJCF file (MuJoCo's), which is not read; `mjcf-urdf-simple-converter` (PyPI) converts trees with their inertias"
        }
        "COLLADA" => "this is a COLLADA mesh; the URDF names it, load that",
        "html" | "HTML" => "this is a web page; a download may have gone wrong",
        "mujocoinclude" => {
            "this is a part of an MJCF file (MuJoCo's), which is not read; `mjcf-urdf-simple-converter` (PyPI) converts the whole"
        }
        "launch" => "this is a ROS launch file; load the URDF it names",
        _ => "a URDF's root is <robot>",
    };
    report.error("wrong-root", Place::Element(root), || {
        format!("the root element is <{}>: {remark}", shortened(name))
    });
    false
}

/// Reports an absent name and an unknown version.
fn check_robot_attributes(robot: Node<'_, '_>, report: &mut Report) {
    if robot.attribute("name").is_none() {
        report.note("unnamed-robot", Place::Element(robot), || "<robot> has no name".to_owned());
    }
    if let Some(version) = robot.attribute("version")
        && !["1.0", "1.1", "1.2"].contains(&version.trim_ascii())
    {
        report.add(Severity::Warning, "unknown-version", Place::Attribute(robot, "version"), || {
            format!("URDF version \"{}\" is not known; it is read as 1.2", shortened(version))
        });
    }
}

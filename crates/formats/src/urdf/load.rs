//! Construction of a mechanism from a source in URDF.

use crate::hull::{build_with_shapes, collision_shapes};
use crate::reading::document::files::Files;
use crate::reading::document::qpos::QposLayout;
use crate::reading::findings::Findings;
use crate::reading::limits;
use crate::reading::report::{Place, Report, cut, shortened};
use crate::reading::xml;
use crate::reading::xml::Node;
use crate::shape::Shape;
use crate::urdf::closing_pairs::close_pairs;
use crate::urdf::consistency;
use crate::urdf::elements::dialect::ROBOT;
use crate::urdf::elements::joints::gazebo_joint::ScrewLoop;
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::link::LinkText;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::survey::{check_element, report_xacro_elements};
use crate::urdf::texts::Texts;
use crate::{Diagnostic, LoadError};
use percuss_mechanism::{Accept, Joint, JointKind, Mechanism, MechanismBuilder, Severity, Subject};
use roxmltree::Document;
use std::collections::HashSet;
use std::path::PathBuf;

/// Options of the reader.
#[derive(Clone, Copy, Debug, Default)]
pub struct LoadOptions {
    /// Findings that the user accepts.
    pub accept: Accept,
    /// Pairs of links that mark a loop of an unknown kind (`closing_NAME_1`, `closing_NAME_2` in a URDF) are a warning instead of an
    /// error: the caller closes the loops.
    pub open_pairs: bool,
}

/// Mechanism with the findings in its file.
#[derive(Debug)]
pub struct Loaded {
    /// Mechanism of the file.
    pub mechanism: Mechanism,
    /// Shapes of every link, in link order.
    pub shapes: Vec<Vec<Shape>>,
    /// Poses that the file names: keyframes of MJCF.
    pub poses: Vec<NamedPose>,
    /// Positions of MuJoCo as positions of the mechanism; `None` for other formats than MJCF.
    pub qpos: Option<QposLayout>,
    /// Warnings and notes, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
    /// Findings about parts of the file that are no part of a mechanism, in the order of the file: warnings and notes that `diagnostics`
    /// has too, and a note with the code [`NOT_READ`](crate::NOT_READ) for each kind of element or attribute that has no effect on the
    /// mechanism.
    pub unread: Vec<Diagnostic>,
    /// Further files that were read: included files and meshes.
    pub files: Vec<PathBuf>,
}

impl Loaded {
    /// Mechanism without named poses and findings.
    pub(crate) fn new(mechanism: Mechanism, shapes: Vec<Vec<Shape>>) -> Self {
        let (poses, qpos, files) = (Vec::new(), None, Vec::new());
        Self { mechanism, shapes, poses, qpos, diagnostics: Vec::new(), unread: Vec::new(), files }
    }

    /// Reads a model from its files; the result has their findings and names. After an error of a file the tree may be empty: it is not
    /// read.
    pub(crate) fn from_files(
        Files { tree, reports, .. }: Files,
        read: impl FnOnce(&mut Findings<'_>) -> Option<Self>,
    ) -> Result<Self, LoadError> {
        let failed = reports.iter().any(Report::has_errors);
        let mut findings = Findings::new(&tree, reports);
        let model = if failed { None } else { read(&mut findings) };
        let failed = findings.has_errors();
        let diagnostics = findings.finish();
        match model {
            Some(loaded) if !failed => {
                let included = tree.files.iter().skip(1).map(|file| PathBuf::from(&file.name));
                let files = included.chain(loaded.files).collect();
                Ok(Self { files, diagnostics, ..loaded })
            }
            Some(_) | None => Err(LoadError { diagnostics }),
        }
    }
}

/// Pose of a mechanism with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedPose {
    /// Name, unique in the model.
    pub name: String,
    /// Positions of all joints that are neither fixed nor mimics, by name (layouts of [`JointKind`](percuss_mechanism::JointKind)), rad
    /// or m.
    pub positions: Vec<(String, Vec<f64>)>,
}

impl NamedPose {
    /// Concatenated positions of all joints, in joint order. Joints that the pose does not contain, such as mimics, are as drawn.
    pub fn all_positions(&self, mechanism: &Mechanism) -> Vec<f64> {
        let of = |joint: &Joint| {
            let given = self.positions.iter().find(|(name, _)| name == joint.name());
            match (given, joint.kind()) {
                (Some((_, values)), _) => values.clone(),
                (None, JointKind::Spherical) => vec![1.0, 0.0, 0.0, 0.0],
                (None, JointKind::Floating) => vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                (None, kind) => vec![0.0; kind.positions()],
            }
        };
        mechanism.joints().iter().flat_map(of).collect()
    }
}

/// Reads the text of a URDF, closed loops and couplings included; `report` contains findings about its bytes.
///
/// Units of URDF: m, kg, kg·m², rad. Inertias in a rotated frame are transformed to the link's axes, I = R I′ Rᵀ. Meshes,
/// packages and external entities are not opened.
///
/// # Errors
/// [`LoadError`] with all findings if a finding is an error (at most 50 findings of each severity; further findings are only
/// counted).
pub(crate) fn load_text(
    name: &str,
    text: &str,
    options: &LoadOptions,
    mut report: Report,
) -> Result<Loaded, LoadError> {
    report.accept(options.accept);
    let mechanism = build_mechanism(text, options, &mut report);
    let failed = report.has_errors();
    let diagnostics = report.finish(name, text);
    match mechanism {
        Some((mechanism, shapes)) if !failed => Ok(Loaded { diagnostics, ..Loaded::new(mechanism, shapes) }),
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// Builds the mechanism and the shapes of all links; `None` after an error.
fn build_mechanism(
    text: &str,
    options: &LoadOptions,
    report: &mut Report,
) -> Option<(Mechanism, Vec<Vec<Shape>>)> {
    let document = xml::parse(text, report)?;
    let robot = document.root_element();
    if !check_root_tag(robot, report) {
        return None;
    }
    report_xacro_elements(robot, report);
    check_element(robot, ("robot", &ROBOT), report);
    check_robot_attributes(robot, report);
    if report.is_xacro() {
        return None;
    }
    let mut nodes = Nodes::collect(robot, report);
    if !nodes.check_counts(robot, report) {
        return None;
    }
    let mut texts = Texts::read_elements(&mut nodes, report);
    consistency::resolve_references(robot, &nodes, &mut texts, report);
    close_pairs(&mut nodes, &mut texts, options.open_pairs, report);
    if report.has_errors() {
        return None;
    }
    let name = robot.attribute("name").unwrap_or_default();
    let name =
        if name.len() > limits::LONGEST_NAME { cut(name, limits::LONGEST_NAME) } else { name.to_owned() };
    let builder = MechanismBuilder::new(name);
    let builder = texts.links.iter().map(LinkText::description).fold(builder, MechanismBuilder::link);
    let builder = texts.joints.iter().map(JointText::description).fold(builder, MechanismBuilder::joint);
    let builder = texts.closures.into_iter().fold(builder, MechanismBuilder::closure);
    let builder = texts.couplings.into_iter().fold(builder, MechanismBuilder::coupling);
    let builder = texts.relations.into_iter().fold(builder, MechanismBuilder::relation);
    let builder = texts.contacts.into_iter().fold(builder, MechanismBuilder::contact);
    let builder = texts.bushes.into_iter().fold(builder, MechanismBuilder::bush);
    let builder = texts.screws.into_iter().fold(builder, |builder, ScrewLoop { links, joints, closure }| {
        let builder = links.into_iter().fold(builder, MechanismBuilder::link);
        joints.into_iter().fold(builder, MechanismBuilder::joint).closure(closure)
    });
    let mut shapes: Vec<Vec<Shape>> = texts.links.into_iter().map(|link| link.shapes).collect();
    let (mechanism, findings) =
        build_with_shapes(builder, options.accept, &shapes, |_, own| collision_shapes(own));
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
    let mechanism = mechanism?;
    shapes.resize_with(mechanism.links().len(), Vec::new);
    Some((mechanism, shapes))
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

/// True for `<robot>`; otherwise reports the probable kind of the file.
fn check_root_tag(root: Node<'_>, report: &mut Report) -> bool {
    let name = root.tag_name().name();
    let remark = match name {
        "robot" => return true,
        "gazebo" => {
            "this is an SDF file of an old version (Gazebo's); convert it with \"gz sdf -p FILE\" and load the result"
        }
        "COLLADA" => "this is a COLLADA mesh; the URDF names it, load that",
        "html" | "HTML" => "this is a web page; a download may have gone wrong",
        "mujocoinclude" => "this is a part of an MJCF file (MuJoCo's); load the file that includes it",
        "launch" => "this is a ROS launch file; load the URDF it names",
        _ => "a URDF's root is <robot>",
    };
    report.error("wrong-root", Place::Element(root), || {
        format!("the root element is <{}>: {remark}", shortened(name))
    });
    false
}

/// Reports an absent name and an unknown version.
fn check_robot_attributes(robot: Node<'_>, report: &mut Report) {
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

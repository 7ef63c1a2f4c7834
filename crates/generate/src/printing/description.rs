//! Descriptions that all languages share: layout of the positions and of the results, checks, reference values.

use super::expression_text::{Printer, literal};
use crate::expression::graph::{Expr, Node};
use crate::expression::statements::Statements;
use crate::function::{Functions, NamedOutput, PositionStep};
use crate::request::Request;
use percuss_dynamics::{Base, EffectiveMass};
use percuss_mechanism::JointKind;

/// Generated file.
#[derive(Clone, Debug)]
pub struct GeneratedFile {
    /// File name.
    pub name: String,
    /// Content.
    pub text: String,
}

/// Largest angle, rad, for which the sine and the cosine of the generated code are accurate.
pub(crate) const LARGEST_ANGLE: f64 = 1e5;

/// Most Newton steps of the closing of the loops.
pub(crate) const NEWTON_STEPS: usize = 30;

/// Conditions of a result, each with the status that the code returns if the condition is false. `with_line`: also that of the line of
/// the normal.
pub(crate) fn conditions(
    functions: &Functions,
    printer: &Printer,
    with_line: bool,
) -> Vec<(String, &'static str)> {
    let range = (format!("range <= {}", literal(LARGEST_ANGLE * LARGEST_ANGLE)), "Range");
    let limits = [
        (functions.line.filter(|_| with_line), "Line"),
        (functions.closure, "Open"),
        (functions.choice, "Singular"),
    ];
    let of_limit = |(limit, status): (Option<Expr>, &'static str)| {
        Some((format!("{} <= 1.0", printer.result(limit?)), status))
    };
    [range].into_iter().chain(limits.into_iter().filter_map(of_limit)).collect()
}

/// Tolerance of the self-test relative to the reference value.
const TEST_TOLERANCE: f64 = 1e-12;

/// Reference value of the self-test.
pub(crate) struct Reference<'a> {
    pub inputs: &'a [f64],
    pub mass: f64,
    pub tolerance: f64,
}

impl Functions {
    /// Results of the function of m̄: response, then the checks that apply.
    pub fn mass_results(&self) -> Vec<Expr> {
        [Some(self.response), self.closure, self.choice, self.line].into_iter().flatten().collect()
    }

    /// Statements of the function of m̄.
    pub fn mass_statements(&self) -> Statements {
        Statements::new(&self.graph, &self.mass_results())
    }

    /// Statements of the function of m̄ and further results.
    pub fn statements_with<'a>(&self, further: impl Iterator<Item = &'a NamedOutput>) -> Statements {
        let mut results = self.mass_results();
        results.extend(further.map(|output| output.value));
        Statements::new(&self.graph, &results)
    }

    /// Reference values with a finite m̄.
    pub fn references(&self) -> Vec<Reference<'_>> {
        let finite = self.samples.iter().filter_map(|sample| match sample.outcome {
            EffectiveMass::Finite(mass) => {
                let tolerance = TEST_TOLERANCE + 10.0 * sample.error;
                Some(Reference { inputs: &sample.inputs, mass, tolerance })
            }
            _ => None,
        });
        finite.collect()
    }
}

/// Text without characters that end a comment or a line.
pub(crate) fn plain(text: &str) -> String {
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    text.replace("*/", "* /").replace("/*", "/ *").replace('\\', "/")
}

/// Name and unit of an output: joint, component, and rate per closing speed.
pub(crate) fn output_name(request: &Request, output: &NamedOutput) -> String {
    let unit = if output.turns { "rad/s per m/s" } else { "m/s per m/s" };
    format!("{}, {unit}", coordinate_name(request, output))
}

/// Name of a coordinate: joint and component.
pub(crate) fn coordinate_name(request: &Request, output: &NamedOutput) -> String {
    let mechanism = request.system.mechanism();
    let Some(id) = output.joint else {
        let axis = ["x", "y", "z"][output.component % 3];
        let kind = if output.turns { "rotation about" } else { "translation along" };
        return format!("base, {kind} {axis} of the root link");
    };
    let joint = mechanism.joint(id);
    let name = plain(joint.name());
    match joint.kind().dofs() {
        1 => format!("\"{name}\""),
        _ => format!("\"{name}\" velocity {}", output.component),
    }
}

/// Description of every position.
pub(crate) fn position_rows(request: &Request, functions: &Functions) -> Vec<String> {
    let mechanism = request.system.mechanism();
    let mut rows = Vec::new();
    for input in &functions.tree.input_joints {
        let joint = mechanism.joint(input.joint);
        let parts: &[&str] = match joint.kind() {
            JointKind::Fixed => &[],
            JointKind::Revolute | JointKind::Continuous => &["angle, rad"],
            JointKind::Prismatic => &["distance, m"],
            JointKind::Planar => &["x, m", "y, m", "angle, rad"],
            JointKind::Spherical => &["quaternion w", "quaternion x", "quaternion y", "quaternion z"],
            JointKind::Floating => {
                &["x, m", "y, m", "z, m", "quaternion w", "quaternion x", "quaternion y", "quaternion z"]
            }
        };
        let locked = if request.system.is_locked(input.joint) { " (locked)" } else { "" };
        let kind = joint.kind().name();
        for (k, part) in parts.iter().enumerate() {
            let index = input.inputs.start + k;
            rows.push(format!("q[{index}]  {kind} joint \"{}\"{locked}: {part}", plain(joint.name())));
        }
    }
    rows
}

/// Lines about the model, the contact and the conditions.
pub(crate) fn header_lines(request: &Request) -> Vec<String> {
    let mechanism = request.system.mechanism();
    let contact = &request.contact;
    let link = plain(mechanism.link(contact.link).name());
    let p = contact.point;
    let mut lines = vec![format!(
        "Effective mass m = 1/(J M^-1 J^T) of \"{}\" at a contact of the link \"{link}\".",
        plain(mechanism.name())
    )];
    lines.push(format!("made by percuss {}; do not edit.", env!("CARGO_PKG_VERSION")));
    lines.push(String::new());
    lines.extend(request.origin.iter().map(|line| plain(line)));
    if !request.model_hash.is_empty() {
        lines.push(format!("model        sha256 {}", request.model_hash));
    }
    match &request.wheel {
        None => {
            lines.push(format!("point        {:?}, {:?}, {:?} m in the frame of the link", p.x, p.y, p.z))
        }
        Some(wheel) => lines.push(format!(
            "point        lowest point of the wheel about \"{}\"",
            plain(mechanism.link(wheel.centre).name())
        )),
    }
    lines.push(format!("normal       {}", normal_text(request)));
    let against = contact.against.map_or_else(
        || "the ground".to_owned(),
        |link| format!("link \"{}\"", plain(mechanism.link(link).name())),
    );
    match request.other_mass {
        Some(mass) => lines.push(format!("other side   a free body of {mass:?} kg")),
        None => lines.push(format!("other side   {against}")),
    }
    if request.system.base() == Base::Floating {
        lines.push("base         floating".to_owned());
    }
    for hold in &request.holds {
        let name = plain(mechanism.link(hold.link).name());
        let along = hold.normal.map_or_else(
            || "in all directions".to_owned(),
            |n| format!("along {:?}, {:?}, {:?} in the axes of the root link", n.x, n.y, n.z),
        );
        let p = hold.point;
        lines.push(format!("held         \"{name}\" at {:?}, {:?}, {:?} m, {along}", p.x, p.y, p.z));
    }
    lines
}

/// Description of the normal.
fn normal_text(request: &Request) -> String {
    use percuss_dynamics::{Direction, Frame};
    let mechanism = request.system.mechanism();
    match request.contact.normal {
        Direction::Along(n, frame) | Direction::About(n, frame) => {
            let frame = match frame {
                Frame::Link => "the link",
                Frame::World => "the world",
                Frame::Against => "the other side",
            };
            format!("{:?}, {:?}, {:?} in the frame of {frame}", n.x, n.y, n.z)
        }
        Direction::Toward(link, p) | Direction::TurningToward(link, p) => {
            format!("towards {:?}, {:?}, {:?} m of \"{}\"", p.x, p.y, p.z, plain(mechanism.link(link).name()))
        }
        Direction::TurningAwayFrom(link, p) => {
            format!(
                "away from {:?}, {:?}, {:?} m of \"{}\"",
                p.x,
                p.y,
                p.z,
                plain(mechanism.link(link).name())
            )
        }
    }
}

/// Inputs that the function of m̄ reads.
pub(crate) fn used_inputs(functions: &Functions, statements: &Statements) -> Vec<usize> {
    let graph = &functions.graph;
    let mut used = Vec::new();
    let mut seen = vec![false; graph.len()];
    let mut stack: Vec<Expr> = functions.mass_results();
    stack.extend(&statements.angles);
    while let Some(expression) = stack.pop() {
        if std::mem::replace(&mut seen[expression.index()], true) {
            continue;
        }
        if let Node::Input(i) = graph.node(expression) {
            used.push(i as usize);
        }
        stack.extend(graph.node(expression).operands());
    }
    used.sort_unstable();
    used
}

/// First input and kind of every joint with a quaternion among Newton steps.
pub(crate) fn quaternion_joints(steps: &[PositionStep]) -> Vec<(usize, JointKind)> {
    let with_quaternion =
        |step: &&PositionStep| matches!(step.kind, JointKind::Spherical | JointKind::Floating);
    let mut joints: Vec<(usize, JointKind)> =
        steps.iter().filter(with_quaternion).map(|step| (step.first, step.kind)).collect();
    joints.sort_by_key(|(first, _)| *first);
    joints.dedup();
    joints
}

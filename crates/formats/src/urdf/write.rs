//! Writer of mechanisms as URDF+.

use crate::shape::{Shape, Solid};
use crate::writing::changes::{Change, ModelText, common_changes, lost_poses, lost_shape};
use crate::writing::parts::ModelParts;
use crate::writing::xml_text::{
    append, escape_attribute, escape_comment, format_number, format_numbers, format_vector, scale_text,
};
use percuss_mechanism::{
    Bush, Closure, ClosureKind, ContactNormal, Coupling, Inertial, Joint, JointId, JointKind, Link,
    LinkRatio, LoopFrame, Mechanism, NamedContact,
};
use percuss_spatial::{Matrix3, Transform, Vector3, rpy_from_rotation};
use std::collections::HashMap;

/// Comments of a written file. Each is a single line; characters that XML forbids in comments are replaced.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comments {
    /// Lines at the top of the file.
    pub heading: Vec<String>,
    /// Comment above a link, by link name.
    pub links: HashMap<String, String>,
    /// Comment above a joint, by joint name.
    pub joints: HashMap<String, String>,
    /// Comment above a closure or a coupling, by name.
    pub closures: HashMap<String, String>,
    /// Warnings given when the mechanism was made: code and link name. Each is written as
    /// `<?percuss-known CODE NAME?>`; [`load`](crate::load) then gives a note in place of the warning.
    pub known: Vec<(&'static str, String)>,
}

/// Writes URDF+: links with inertias; joints with limits, mimics, armatures and recommended roles; loops,
/// couplings and named contacts. The result is plain URDF if the mechanism has no loops and couplings.
///
/// Numbers are the shortest decimals that read back as the same bits. Rotations are converted to roll, pitch and yaw
/// and are accurate to a few roundings; all other numbers are reproduced exactly. Shapes are not written; [`write_urdf_model`] writes them.
/// Characters of a name that XML forbids become U+FFFD. A chain of mimics is written as mimics of the last master,
/// and a joint to a second parent as a loop. `effort` and `velocity` are written as 0: a mechanism has no such data,
/// but readers require them.
pub fn write_urdf(mechanism: &Mechanism) -> String {
    write_urdf_with(mechanism, &Comments::default())
}

/// As [`write_urdf`], with comments. Comments for unknown names are left out.
pub fn write_urdf_with(mechanism: &Mechanism, comments: &Comments) -> String {
    write_robot(mechanism, &[], comments)
}

/// Writes URDF+. `shapes`: visuals and collisions of each link as XML, in link order; links beyond the end have none.
fn write_robot(mechanism: &Mechanism, shapes: &[String], comments: &Comments) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Some parsers accept processing instructions only before the first comment. A name that does not fit into an
    // instruction gets its warning again at loading.
    let fits_instruction =
        |name: &str| !name.contains("?>") && !name.chars().any(char::is_control) && name.trim() == name;
    for (code, name) in comments.known.iter().filter(|(_, name)| fits_instruction(name)) {
        append!(out, "<?percuss-known {code} {name}?>\n");
    }
    for line in &comments.heading {
        append!(out, "<!-- {} -->\n", escape_comment(line));
    }
    append!(out, "<robot name=\"{}\">\n", escape_attribute(mechanism.name()));
    for (index, link) in mechanism.links().iter().enumerate() {
        write_comment(&mut out, &comments.links, link.name());
        write_link(&mut out, link, shapes.get(index).map_or("", String::as_str));
    }
    for joint in mechanism.joints() {
        write_comment(&mut out, &comments.joints, joint.name());
        write_joint(&mut out, mechanism, joint);
    }
    for joint in mechanism.joints() {
        if let Some(gear) = joint.gear() {
            let [stiffness, damping] = [gear.stiffness, gear.damping].map(format_number);
            let name = escape_attribute(joint.name());
            append!(out, "  <elastic joint=\"{name}\" stiffness=\"{stiffness}\" damping=\"{damping}\"/>\n");
        }
    }
    for closure in mechanism.closures() {
        write_comment(&mut out, &comments.closures, closure.name());
        write_closure(&mut out, mechanism, closure);
    }
    for coupling in mechanism.couplings() {
        write_comment(&mut out, &comments.closures, coupling.name());
        write_coupling(&mut out, mechanism, coupling);
    }
    for contact in mechanism.contacts() {
        write_contact(&mut out, mechanism, contact);
    }
    for bush in mechanism.bushes().iter().filter(|bush| is_written(bush)) {
        write_bush(&mut out, bush);
    }
    out.push_str("</robot>\n");
    out
}

/// As [`write_urdf`], with shapes and a comment at the head of the file. The result lists everything changed or lost.
pub fn write_urdf_model<'a>(model: impl Into<ModelParts<'a>>, heading: &str) -> ModelText {
    let parts = model.into();
    let mechanism = parts.mechanism;
    let comments = Comments { heading: vec![heading.to_owned()], ..Comments::default() };
    let mut changes = common_changes(mechanism, is_written, true);
    changes.extend(lost_poses(&parts, "URDF"));
    for joint in mechanism.joints() {
        if joint.kind() == JointKind::Spherical {
            let reason = "a type of URDF+, which other readers of URDF refuse";
            changes.push(Change::changed("joint", joint.name(), "type=\"spherical\"", reason));
        }
        if joint.spring().is_some_and(|spring| spring.stiffness > 0.0) {
            let what = "its spring is spring_stiffness and spring_reference of <dynamics>";
            changes.push(Change::changed("joint", joint.name(), what, "most readers of URDF ignore them"));
        }
        if has_armature(joint) {
            let what = "its armature is an attribute of <dynamics>";
            changes.push(Change::changed(
                "joint",
                joint.name(),
                what,
                "URDF has no armature; most readers ignore it",
            ));
        }
    }
    let mut shapes = Vec::with_capacity(parts.shapes.len());
    for (link, own) in mechanism.link_ids().zip(parts.shapes) {
        let mut lines = String::new();
        for shape in own {
            match shape_element(&parts, shape) {
                Ok(element) => lines.push_str(&element),
                Err(reason) => changes.push(lost_shape(mechanism, link, shape, reason)),
            }
        }
        shapes.push(lines);
    }
    ModelText { text: write_robot(mechanism, &shapes, &comments), changes }
}

fn has_armature(joint: &Joint) -> bool {
    joint.armature().iter().any(|armature| *armature != 0.0)
}

/// Element `<visual>` or `<collision>`. The error is the reason why the shape is lost.
fn shape_element(parts: &ModelParts<'_>, shape: &Shape) -> Result<String, String> {
    let number = |x: &f64| format_number(*x);
    let geometry = match &shape.solid {
        Solid::Box { size } => format!("<box size=\"{}\"/>", format_vector(&Vector3::from(*size))),
        Solid::Sphere { radius } => format!("<sphere radius=\"{}\"/>", number(radius)),
        Solid::Cylinder { radius, length } => {
            format!("<cylinder radius=\"{}\" length=\"{}\"/>", number(radius), number(length))
        }
        Solid::Capsule { radius, length } => {
            format!("<capsule radius=\"{}\" length=\"{}\"/>", number(radius), number(length))
        }
        Solid::Mesh { file, scale } => {
            let scale = scale_text(" scale=\"", scale, "\"");
            let name = (parts.find_mesh)(file)?.name;
            format!("<mesh filename=\"{}\"{scale}/>", escape_attribute(&name))
        }
    };
    let tag = shape.purpose.name();
    let origin = match shape.frame == Transform::identity() {
        true => String::new(),
        false => origin_element(&shape.frame),
    };
    Ok(format!("    <{tag}>{origin}<geometry>{geometry}</geometry></{tag}>\n"))
}

fn write_comment(out: &mut String, comments: &HashMap<String, String>, name: &str) {
    if let Some(text) = comments.get(name) {
        append!(out, "  <!-- {} -->\n", escape_comment(text));
    }
}

fn write_link(out: &mut String, link: &Link, shapes: &str) {
    let name = escape_attribute(link.name());
    if link.inertial().is_none() && shapes.is_empty() {
        append!(out, "  <link name=\"{name}\"/>\n");
        return;
    }
    append!(out, "  <link name=\"{name}\">\n");
    if let Some(inertial) = link.inertial() {
        write_inertial(out, inertial);
    }
    out.push_str(shapes);
    out.push_str("  </link>\n");
}

fn write_inertial(out: &mut String, inertial: &Inertial) {
    append!(out, "    <inertial>\n      <origin xyz=\"{}\"/>\n", format_vector(&inertial.com));
    append!(out, "      <mass value=\"{}\"/>\n", format_number(inertial.mass));
    let entries = [("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)];
    out.push_str("      <inertia");
    for (name, row, column) in entries {
        append!(out, " {name}=\"{}\"", format_number(inertial.about_com[(row, column)]));
    }
    out.push_str("/>\n    </inertial>\n");
}

fn write_joint(out: &mut String, mechanism: &Mechanism, joint: &Joint) {
    let (name, kind) = (escape_attribute(joint.name()), joint.kind());
    let link_name = |id| escape_attribute(mechanism.link(id).name());
    let role = joint.independent().map(|i| format!(" independent=\"{i}\"")).unwrap_or_default();
    append!(out, "  <joint name=\"{name}\" type=\"{}\"{role}>\n", kind.name());
    append!(out, "    {}\n", origin_element(joint.origin()));
    append!(out, "    <parent link=\"{}\"/>\n", link_name(joint.parent()));
    append!(out, "    <child link=\"{}\"/>\n", link_name(joint.child()));
    if kind.has_axis() {
        append!(out, "    <axis xyz=\"{}\"/>\n", format_vector(joint.axis()));
    }
    let rate = format_number(joint.rate_limit().unwrap_or(0.0));
    if let Some(limits) = joint.limits() {
        let (lower, upper) = (format_number(limits.lower), format_number(limits.upper));
        append!(out, "    <limit lower=\"{lower}\" upper=\"{upper}\" effort=\"0\" velocity=\"{rate}\"/>\n");
    } else if matches!(kind, JointKind::Revolute | JointKind::Prismatic) || joint.rate_limit().is_some() {
        append!(out, "    <limit effort=\"0\" velocity=\"{rate}\"/>\n");
    }
    let spring = joint.spring();
    if has_armature(joint) || spring.is_some() {
        // urdfdom refuses the element without damping and friction.
        let damping = format_number(spring.map_or(0.0, |spring| spring.damping));
        append!(out, "    <dynamics damping=\"{damping}\" friction=\"0\"");
        if has_armature(joint) {
            append!(out, " armature=\"{}\"", format_numbers(joint.armature()));
        }
        if let Some(spring) = spring.filter(|spring| spring.stiffness > 0.0) {
            let [stiffness, reference] = [spring.stiffness, spring.reference].map(format_number);
            append!(out, " spring_stiffness=\"{stiffness}\" spring_reference=\"{reference}\"");
        }
        out.push_str("/>\n");
    }
    if let Some(mimic) = joint.mimic() {
        let master = escape_attribute(mechanism.joint(mimic.master).name());
        let (multiplier, offset) = (format_number(mimic.multiplier), format_number(mimic.offset));
        append!(out, "    <mimic joint=\"{master}\" multiplier=\"{multiplier}\" offset=\"{offset}\"/>\n");
    }
    out.push_str("  </joint>\n");
}

/// True for a bush whose numbers are finite: URDF has no ideal rows.
fn is_written(bush: &Bush) -> bool {
    bush.description().stiffness.iter().all(|k| k.is_finite())
}

fn write_bush(out: &mut String, bush: &Bush) {
    let of = bush.description();
    let [name, link, against] = [&of.name, &of.link, &of.against].map(|name| escape_attribute(name));
    append!(out, "  <bushing name=\"{name}\" parent=\"{link}\" child=\"{against}\">\n");
    append!(out, "    {}\n", origin_element(&of.frame));
    let rows = |rows: &[f64; 6]| {
        format!("xyz=\"{}\" rpy=\"{}\"", format_numbers(&rows[3..]), format_numbers(&rows[..3]))
    };
    let factors = [("loss_factor", of.loss_factor), ("dynamic_factor", of.dynamic_factor)]
        .map(|(key, value)| format!(" {key}=\"{}\"", format_number(value)));
    append!(out, "    <stiffness {}{}/>\n", rows(&of.stiffness), factors.concat());
    for (tag, values) in [("damping", of.damping), ("preload", of.preload)] {
        if values != [0.0; 6] {
            append!(out, "    <{tag} {}/>\n", rows(&values));
        }
    }
    append!(out, "    <rigid {}/>\n", rows(&of.rigid.map(f64::from)));
    for joint in &of.replaces {
        append!(out, "    <joint name=\"{}\"/>\n", escape_attribute(joint));
    }
    out.push_str("  </bushing>\n");
}

fn write_closure(out: &mut String, mechanism: &Mechanism, closure: &Closure) {
    let (name, kind) = (escape_attribute(closure.name()), closure.kind());
    append!(out, "  <loop name=\"{name}\" type=\"{}\">\n", kind.name());
    for (tag, end) in [("predecessor", closure.predecessor()), ("successor", closure.successor())] {
        let LoopFrame { link, frame } = end;
        let link = link.map_or("world".to_owned(), |id| escape_attribute(mechanism.link(id).name()));
        append!(out, "    <{tag} link=\"{link}\">{}</{tag}>\n", origin_element(frame));
    }
    if kind.has_axis() {
        append!(out, "    <axis xyz=\"{}\"/>\n", format_vector(closure.axis()));
    }
    if kind == ClosureKind::Universal {
        append!(out, "    <axis2 xyz=\"{}\"/>\n", format_vector(closure.axis2()));
    }
    if let Some(distance) = closure.distance() {
        append!(out, "    <distance value=\"{}\"/>\n", format_number(distance));
    }
    out.push_str("  </loop>\n");
}

fn write_coupling(out: &mut String, mechanism: &Mechanism, coupling: &Coupling) {
    let name = escape_attribute(coupling.name());
    let Some(LinkRatio { predecessor, successor, ratio }) = coupling.ratio() else {
        append!(out, "  <relation name=\"{name}\">\n");
        write_terms(out, mechanism, coupling.terms(), "    ");
        append!(out, "    <constant value=\"{}\"/>\n", format_number(coupling.constant()));
        if let Some(curve) = coupling.curve() {
            let offset = format_number(curve.offset());
            let coefficients = format_vector(&curve.coefficients().into());
            append!(out, "    <curve offset=\"{offset}\" coefficients=\"{coefficients}\">\n");
            write_terms(out, mechanism, curve.terms(), "      ");
            out.push_str("    </curve>\n");
        }
        out.push_str("  </relation>\n");
        return;
    };
    append!(out, "  <coupling name=\"{name}\">\n");
    for (tag, link) in [("predecessor", predecessor), ("successor", successor)] {
        append!(out, "    <{tag} link=\"{}\"/>\n", escape_attribute(mechanism.link(link).name()));
    }
    append!(out, "    <ratio value=\"{}\"/>\n  </coupling>\n", format_number(ratio));
}

/// Joints of a relation with their factors.
fn write_terms(out: &mut String, mechanism: &Mechanism, terms: &[(JointId, f64)], indent: &str) {
    for (joint, factor) in terms {
        let (name, factor) = (escape_attribute(mechanism.joint(*joint).name()), format_number(*factor));
        append!(out, "{indent}<joint name=\"{name}\" factor=\"{factor}\"/>\n");
    }
}

fn write_contact(out: &mut String, mechanism: &Mechanism, contact: &NamedContact) {
    let (name, kind) = (escape_attribute(contact.name()), contact.kind().name());
    let link = escape_attribute(mechanism.link(contact.link()).name());
    let other =
        contact.against().map_or("world".to_owned(), |id| escape_attribute(mechanism.link(id).name()));
    let point = format_vector(contact.point());
    append!(out, "  <contact name=\"{name}\" type=\"{kind}\">\n");
    append!(out, "    <body link=\"{link}\" xyz=\"{point}\"/>\n");
    append!(out, "    <other link=\"{other}\"/>\n");
    let (tag, vector) = match contact.normal() {
        ContactNormal::Fixed(normal) => ("normal", normal),
        ContactNormal::Toward(point) => ("toward", point),
        ContactNormal::Away(point) => ("away", point),
    };
    append!(out, "    <{tag} xyz=\"{}\"/>\n", format_vector(vector));
    if let Some(gap) = contact.gap() {
        append!(out, "    <gap value=\"{}\"/>\n", format_number(gap));
    }
    out.push_str("  </contact>\n");
}

/// `<origin>` of a frame; without `rpy` for no rotation.
fn origin_element(frame: &Transform<f64>) -> String {
    let xyz = format_vector(&frame.translation);
    if frame.rotation == Matrix3::identity() {
        return format!("<origin xyz=\"{xyz}\"/>");
    }
    // Adding 0 turns −0 into 0.
    let rpy = format_vector(&Vector3::from(rpy_from_rotation(&frame.rotation).map(|angle| angle + 0.0)));
    format!("<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>")
}

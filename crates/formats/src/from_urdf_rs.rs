//! Robots of the crate urdf-rs, for programs that hold a model of urdf-rs or k.

use crate::load::load;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::writing::xml_text::{append, escape_attribute, format_number, format_numbers};
use crate::{Diagnostic, LoadError, Source};
use percuss_mechanism::Severity;
use urdf_rs::{Geometry, Joint, JointType, Link, Pose, Robot};

/// Name of the robot in messages.
const SOURCE: &str = "urdf_rs::Robot";

/// Mechanism of a [`urdf_rs::Robot`], with the checks and findings of [`load`].
///
/// urdf-rs keeps no loop closures, couplings, armatures and named contacts of a file: they are not in the result, and a note says so.
/// [`load`] on the file itself reads them. Values that urdf-rs has in place of absent ones:
///
/// | value of urdf-rs                    | read as               |
/// |-------------------------------------|-----------------------|
/// | mass 0 and inertia 0                | link without mass     |
/// | limits from 0 to 0, velocity 0      | no limits; with a note for limits of a hinge or a slide |
///
/// Lines in messages are those of the robot written as URDF.
///
/// # Errors
/// [`LoadError`], as for [`load`]: names that are not unique or do not exist, loops of parents, masses and inertias out of range.
pub fn from_urdf_rs(robot: &Robot, options: &LoadOptions) -> Result<Loaded, LoadError> {
    if robot.links.is_empty() {
        return Err(LoadError::of_file(SOURCE, "no-link", "the robot has no links; expected at least one"));
    }
    let mut text = format!("<robot name=\"{}\">\n", escape_attribute(&robot.name));
    robot.links.iter().for_each(|link| write_link(&mut text, link));
    robot.joints.iter().for_each(|joint| write_joint(&mut text, joint));
    text.push_str("</robot>\n");
    let mut loaded = load(&Source::new(SOURCE, text.into_bytes()), options)?;
    loaded.diagnostics.insert(
        0,
        note(
            "not-in-urdf-rs",
            "urdf-rs keeps no loop closures, couplings, armatures and named contacts: those of the file are not in this model; \
             read the file itself if it has some",
        ),
    );
    let unlimited: Vec<String> =
        robot.joints.iter().filter(|joint| lacks_limits(joint)).map(quoted).collect();
    if !unlimited.is_empty() {
        let message = format!("limits from 0 to 0 are read as none: {}", unlimited.join(", "));
        loaded.diagnostics.insert(1, note("zero-limits", &message));
    }
    Ok(loaded)
}

fn note(code: &'static str, message: &str) -> Diagnostic {
    let (path, message) = (SOURCE.to_owned(), message.to_owned());
    Diagnostic { severity: Severity::Note, code, path, line: None, column: None, element: None, message }
}

fn quoted(joint: &Joint) -> String {
    format!("\"{}\"", joint.name)
}

/// True for a hinge or a slide with limits from 0 to 0.
fn lacks_limits(joint: &Joint) -> bool {
    matches!(joint.joint_type, JointType::Revolute | JointType::Prismatic)
        && joint.limit.lower == 0.0
        && joint.limit.upper == 0.0
}

fn origin(pose: &Pose) -> String {
    format!("<origin xyz=\"{}\" rpy=\"{}\"/>", format_numbers(&pose.xyz.0), format_numbers(&pose.rpy.0))
}

fn write_link(out: &mut String, link: &Link) {
    append!(out, "<link name=\"{}\">\n", escape_attribute(&link.name));
    let (inertial, i) = (&link.inertial, &link.inertial.inertia);
    let moments = [i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz];
    if inertial.mass.value != 0.0 || moments.iter().any(|moment| *moment != 0.0) {
        append!(
            out,
            "<inertial>{}<mass value=\"{}\"/><inertia",
            origin(&inertial.origin),
            format_number(inertial.mass.value)
        );
        for (name, moment) in ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].iter().zip(moments) {
            append!(out, " {name}=\"{}\"", format_number(moment));
        }
        out.push_str("/></inertial>\n");
    }
    for visual in &link.visual {
        append!(out, "<visual>{}{}</visual>\n", origin(&visual.origin), geometry(&visual.geometry));
    }
    for collision in &link.collision {
        append!(
            out,
            "<collision>{}{}</collision>\n",
            origin(&collision.origin),
            geometry(&collision.geometry)
        );
    }
    out.push_str("</link>\n");
}

fn geometry(shape: &Geometry) -> String {
    let round = |name: &str, radius: f64, length: f64| {
        format!("<{name} radius=\"{}\" length=\"{}\"/>", format_number(radius), format_number(length))
    };
    let own = match shape {
        Geometry::Box { size } => format!("<box size=\"{}\"/>", format_numbers(&size.0)),
        Geometry::Cylinder { radius, length } => round("cylinder", *radius, *length),
        Geometry::Capsule { radius, length } => round("capsule", *radius, *length),
        Geometry::Sphere { radius } => format!("<sphere radius=\"{}\"/>", format_number(*radius)),
        Geometry::Mesh { filename, scale } => {
            let scale = scale.map(|scale| format!(" scale=\"{}\"", format_numbers(&scale.0)));
            format!("<mesh filename=\"{}\"{}/>", escape_attribute(filename), scale.unwrap_or_default())
        }
    };
    format!("<geometry>{own}</geometry>")
}

fn write_joint(out: &mut String, joint: &Joint) {
    let (kind, has_axis) = match joint.joint_type {
        JointType::Revolute => ("revolute", true),
        JointType::Continuous => ("continuous", true),
        JointType::Prismatic => ("prismatic", true),
        JointType::Planar => ("planar", true),
        JointType::Fixed => ("fixed", false),
        JointType::Floating => ("floating", false),
        JointType::Spherical => ("spherical", false),
    };
    append!(
        out,
        "<joint name=\"{}\" type=\"{kind}\">{}\n",
        escape_attribute(&joint.name),
        origin(&joint.origin)
    );
    append!(out, "<parent link=\"{}\"/>", escape_attribute(&joint.parent.link));
    append!(out, "<child link=\"{}\"/>\n", escape_attribute(&joint.child.link));
    if has_axis {
        append!(out, "<axis xyz=\"{}\"/>\n", format_numbers(&joint.axis.xyz.0));
    }
    let limit = &joint.limit;
    if matches!(joint.joint_type, JointType::Revolute | JointType::Prismatic) || limit.velocity != 0.0 {
        let range = match limit.lower == 0.0 && limit.upper == 0.0 {
            true => String::new(),
            false => {
                format!(" lower=\"{}\" upper=\"{}\"", format_number(limit.lower), format_number(limit.upper))
            }
        };
        append!(out, "<limit{range} effort=\"0\" velocity=\"{}\"/>\n", format_number(limit.velocity));
    }
    if let Some(mimic) = &joint.mimic {
        let (multiplier, offset) = (mimic.multiplier.unwrap_or(1.0), mimic.offset.unwrap_or(0.0));
        let numbers = [multiplier, offset].map(format_number);
        append!(
            out,
            "<mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
            escape_attribute(&mimic.joint),
            numbers[0],
            numbers[1]
        );
    }
    out.push_str("</joint>\n");
}

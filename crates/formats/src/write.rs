//! A mechanism as plain URDF.

use percuss_mechanism::{Joint, JointKind, Link, Mechanism};
use percuss_spatial::{Matrix3, Vector3, rpy_from_rotation};
use std::fmt::Write;

/// Writes plain URDF: links with their inertias, joints with their limits, mimics and armatures.
///
/// Floats are the shortest that read back as the same bits, so that all comes back but the rotations, which go
/// through roll, pitch and yaw and are exact to a few roundings. Shapes and meshes are not written, nor what XML
/// cannot hold in a name; a chain of mimics comes out as mimics of its last master.
/// `effort` and `velocity` are written as 0, since a mechanism does not know them and readers demand them.
pub fn write_urdf(mechanism: &Mechanism) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    put(&mut out, format_args!("<robot name=\"{}\">\n", escaped(mechanism.name())));
    for link in mechanism.links() {
        write_link(&mut out, link);
    }
    for joint in mechanism.joints() {
        write_joint(&mut out, mechanism, joint);
    }
    out.push_str("</robot>\n");
    out
}

fn put(out: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = out.write_fmt(text);
}

fn write_link(out: &mut String, link: &Link) {
    let name = escaped(link.name());
    let Some(inertial) = link.inertial() else {
        put(out, format_args!("  <link name=\"{name}\"/>\n"));
        return;
    };
    put(out, format_args!("  <link name=\"{name}\">\n    <inertial>\n"));
    put(out, format_args!("      <origin xyz=\"{}\"/>\n", triple(&inertial.com)));
    put(out, format_args!("      <mass value=\"{}\"/>\n", number(inertial.mass)));
    let entries = [("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)];
    out.push_str("      <inertia");
    for (name, row, column) in entries {
        put(out, format_args!(" {name}=\"{}\"", number(inertial.about_com[(row, column)])));
    }
    out.push_str("/>\n    </inertial>\n  </link>\n");
}

fn write_joint(out: &mut String, mechanism: &Mechanism, joint: &Joint) {
    let (name, kind) = (escaped(joint.name()), joint.kind());
    let link_name = |id| escaped(mechanism.link(id).name());
    put(out, format_args!("  <joint name=\"{name}\" type=\"{}\">\n", kind.name()));
    let rotation = &joint.origin().rotation;
    let xyz = triple(&joint.origin().translation);
    if *rotation == Matrix3::identity() {
        put(out, format_args!("    <origin xyz=\"{xyz}\"/>\n"));
    } else {
        let rpy = triple(&Vector3::from(rpy_from_rotation(rotation)));
        put(out, format_args!("    <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>\n"));
    }
    put(out, format_args!("    <parent link=\"{}\"/>\n", link_name(joint.parent())));
    put(out, format_args!("    <child link=\"{}\"/>\n", link_name(joint.child())));
    if kind.has_axis() {
        put(out, format_args!("    <axis xyz=\"{}\"/>\n", triple(joint.axis())));
    }
    if let Some(limits) = joint.limits() {
        let (lower, upper) = (number(limits.lower), number(limits.upper));
        put(
            out,
            format_args!("    <limit lower=\"{lower}\" upper=\"{upper}\" effort=\"0\" velocity=\"0\"/>\n"),
        );
    } else if let JointKind::Revolute | JointKind::Prismatic = kind {
        out.push_str("    <limit effort=\"0\" velocity=\"0\"/>\n");
    }
    if joint.armature().iter().any(|a| *a != 0.0) {
        let values: Vec<String> = joint.armature().iter().map(|a| number(*a)).collect();
        put(out, format_args!("    <dynamics armature=\"{}\"/>\n", values.join(" ")));
    }
    if let Some(mimic) = joint.mimic() {
        let master = escaped(mechanism.joint(mimic.master).name());
        let (multiplier, offset) = (number(mimic.multiplier), number(mimic.offset));
        put(
            out,
            format_args!("    <mimic joint=\"{master}\" multiplier=\"{multiplier}\" offset=\"{offset}\"/>\n"),
        );
    }
    out.push_str("  </joint>\n");
}

fn triple(v: &Vector3<f64>) -> String {
    format!("{} {} {}", number(v.x), number(v.y), number(v.z))
}

/// The shortest decimal that reads back as the same bits; an exponent where the digits would run long.
fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || (1e-5..1e16).contains(&size) { format!("{x}") } else { format!("{x:e}") }
}

/// For an attribute in double quotes. What XML 1.0 cannot hold becomes U+FFFD.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' => out.push_str("&#9;"),
            '\n' => out.push_str("&#10;"),
            '\r' => out.push_str("&#13;"),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            other => out.push(other),
        }
    }
    out
}

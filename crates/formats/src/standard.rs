//! The standard part of the dialect, turned into values by `urdf-rs`.
//!
//! `urdf-rs` does not validate, skips words that are no numbers, and stops at the first thing it dislikes, in
//! places that do not matter here. So it is given an extract and not the file: links and joints with their
//! numbers, all known to be good, and no names, shapes or extensions. Names and kinds, references and quaternions
//! stay with what was read beside their places.

use crate::joint::JointText;
use crate::limits::EXTRACT_SIZE;
use crate::link::{InertialText, LinkText, MOMENTS};
use crate::origin::Origin;
use nalgebra::Matrix3;
use percuss_mechanism::{Inertial, JointDescription, JointKind, Limits, LinkDescription, MimicDescription};
use percuss_spatial::{Transform, rotation_from_rpy};
use std::fmt::Write;

/// The links' values.
pub(crate) fn links(texts: &[LinkText<'_>]) -> Result<Vec<LinkDescription>, String> {
    let mut links = Vec::with_capacity(texts.len());
    for chunk in texts.chunks(EXTRACT_SIZE) {
        let mut extract = Extract::new();
        chunk.iter().for_each(|text| extract.link(text));
        let robot = extract.read()?;
        counted(robot.links.len(), chunk.len())?;
        links.extend(chunk.iter().zip(&robot.links).map(|(text, values)| link(text, values)));
    }
    Ok(links)
}

/// The joints' values.
pub(crate) fn joints(texts: &[JointText<'_>]) -> Result<Vec<JointDescription>, String> {
    let mut joints = Vec::with_capacity(texts.len());
    for chunk in texts.chunks(EXTRACT_SIZE) {
        let mut extract = Extract::new();
        chunk.iter().for_each(|text| extract.joint(text));
        let robot = extract.read()?;
        counted(robot.joints.len(), chunk.len())?;
        joints.extend(chunk.iter().zip(&robot.joints).map(|(text, values)| joint(text, values)));
    }
    Ok(joints)
}

fn counted(got: usize, expected: usize) -> Result<(), String> {
    if got == expected { Ok(()) } else { Err(format!("urdf-rs read {got} of {expected} elements")) }
}

fn link(text: &LinkText<'_>, values: &urdf_rs::Link) -> LinkDescription {
    let inertial = text.inertial.as_ref().map(|text| inertial(text, &values.inertial));
    LinkDescription { name: text.name.to_owned(), inertial, geometry: text.geometry }
}

fn inertial(text: &InertialText<'_>, values: &urdf_rs::Inertial) -> Inertial {
    let i = &values.inertia;
    let tensor = Matrix3::new(i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz);
    let origin = transform(&text.origin, &values.origin);
    let turned = origin.rotation * tensor * origin.rotation.transpose();
    // Symmetric again to the last bit; halves first, so that nothing overflows.
    let about_com = turned * 0.5 + turned.transpose() * 0.5;
    Inertial { mass: values.mass.value, com: origin.translation, about_com }
}

fn joint(text: &JointText<'_>, values: &urdf_rs::Joint) -> JointDescription {
    let limit = &values.limit;
    let mimic = text.mimic.as_ref().zip(values.mimic.as_ref()).map(|(text, values)| MimicDescription {
        joint: text.joint.to_owned(),
        multiplier: values.multiplier.unwrap_or(1.0),
        offset: values.offset.unwrap_or(0.0),
    });
    JointDescription {
        name: text.name.to_owned(),
        kind: text.kind,
        parent: text.parent.to_owned(),
        child: text.child.to_owned(),
        origin: transform(&text.origin, &values.origin),
        axis: values.axis.xyz.0.into(),
        limits: text.limits.map(|_| Limits { lower: limit.lower, upper: limit.upper }),
        armature: text.armature.clone(),
        mimic,
        independent: text.independent,
    }
}

fn transform(text: &Origin<'_>, values: &urdf_rs::Pose) -> Transform<f64> {
    let rotation = text.quaternion.unwrap_or_else(|| rotation_from_rpy(values.rpy.0));
    Transform::new(rotation, values.xyz.0.into())
}

/// A URDF of checked numbers. They hold digits, signs, points, `e` and white space, nothing that XML would mind.
struct Extract {
    urdf: String,
}

impl Extract {
    fn new() -> Self {
        Self { urdf: "<robot name=\"\">".to_owned() }
    }

    fn put(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.urdf.write_fmt(text);
    }

    fn origin(&mut self, origin: &Origin<'_>) {
        self.put(format_args!("<origin xyz=\"{}\" rpy=\"{}\"/>", origin.xyz, origin.rpy));
    }

    fn link(&mut self, text: &LinkText<'_>) {
        self.put(format_args!("<link name=\"\">"));
        if let Some(inertial) = &text.inertial {
            self.put(format_args!("<inertial>"));
            self.origin(&inertial.origin);
            self.put(format_args!("<mass value=\"{}\"/><inertia", inertial.mass));
            for ((name, _), value) in MOMENTS.iter().zip(inertial.moments) {
                self.put(format_args!(" {name}=\"{value}\""));
            }
            self.put(format_args!("/></inertial>"));
        }
        self.put(format_args!("</link>"));
    }

    fn joint(&mut self, text: &JointText<'_>) {
        // The kind stays ours; any will do for urdf-rs.
        let kind = JointKind::Fixed.name();
        self.put(format_args!("<joint name=\"\" type=\"{kind}\"><parent link=\"\"/><child link=\"\"/>"));
        self.origin(&text.origin);
        self.put(format_args!("<axis xyz=\"{}\"/>", text.axis));
        if let Some([lower, upper]) = text.limits {
            self.put(format_args!(
                "<limit lower=\"{lower}\" upper=\"{upper}\" effort=\"0\" velocity=\"0\"/>"
            ));
        }
        if let Some(mimic) = &text.mimic {
            let (multiplier, offset) = (mimic.multiplier, mimic.offset);
            self.put(format_args!("<mimic joint=\"\" multiplier=\"{multiplier}\" offset=\"{offset}\"/>"));
        }
        self.put(format_args!("</joint>"));
    }

    fn read(mut self) -> Result<urdf_rs::Robot, String> {
        self.urdf.push_str("</robot>");
        urdf_rs::read_from_string(&self.urdf).map_err(|error| error.to_string())
    }
}

//! Conversion of checked texts to values. Numbers are checked earlier, where their positions are known.

use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::link::{InertialText, LinkText};
use crate::urdf::elements::numbers::{parse_checked_number, parse_numbers};
use nalgebra::Matrix3;
use percuss_mechanism::{Inertial, JointDescription, Limits, LinkDescription, MimicDescription};

/// Description of a link for the builder.
pub(crate) fn describe_link(text: &LinkText<'_>) -> LinkDescription {
    let inertial = text.inertial.as_ref().map(convert_inertial);
    LinkDescription { name: text.name.to_owned(), inertial, geometry: text.geometry }
}

/// Mass, centre of mass and inertia about the centre, in the axes of the link.
fn convert_inertial(text: &InertialText<'_>) -> Inertial {
    let [ixx, ixy, ixz, iyy, iyz, izz] = text.moments.map(parse_checked_number);
    let tensor = Matrix3::new(ixx, ixy, ixz, ixy, iyy, iyz, ixz, iyz, izz);
    let origin = text.origin.transform();
    let turned = origin.rotation * tensor * origin.rotation.transpose();
    // Makes the tensor exactly symmetric. Halving first avoids overflow.
    let about_com = turned * 0.5 + turned.transpose() * 0.5;
    Inertial { mass: parse_checked_number(text.mass), com: origin.translation, about_com }
}

/// Description of a joint for the builder.
pub(crate) fn describe_joint(text: &JointText<'_>) -> JointDescription {
    let mimic = text.mimic.as_ref().map(|text| MimicDescription {
        joint: text.joint.to_owned(),
        multiplier: text.multiplier,
        offset: text.offset,
    });
    JointDescription {
        name: text.name.to_owned(),
        kind: text.kind,
        parent: text.parent.to_owned(),
        child: text.child.to_owned(),
        origin: text.origin.transform(),
        axis: parse_numbers::<3>(text.axis).unwrap_or_default().into(),
        limits: text.limits.map(|[lower, upper]| Limits {
            lower: parse_checked_number(lower),
            upper: parse_checked_number(upper),
        }),
        rate_limit: text.rate_limit,
        armature: text.armature.clone(),
        mimic,
        independent: text.independent,
    }
}

//! Inertias of links: declared, computed from the collisions, or the defaults of the format.

use crate::mjcf::bodies::inertia::{sum, turn};
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::sdf::document::version::Version;
use crate::sdf::elements::geometry::Collision;
use crate::sdf::values::{read_boolean_attribute, read_number_in, read_pose_in};
use percuss_mechanism::{Inertial, Severity};
use percuss_spatial::{Matrix3, Vector3};

/// Mass of a link without `<mass>`, kg, and its moments without `<inertia>`, kg·m². Source: SDFormat, inertial.sdf.
const DEFAULT_MASS: f64 = 1.0;
const DEFAULT_MOMENT: f64 = 1.0;
/// Density of a collision without `<density>`, kg/m³.
const DEFAULT_DENSITY: f64 = 1000.0;
/// First version with inertias from collisions.
const WITH_AUTO: Version = Version(11);

/// Inertia of a link in its frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkInertia {
    pub inertial: Inertial,
    /// True if the moments are the defaults of the format.
    pub is_default: bool,
}

/// Reads the inertia of a link. `is_fixed`: the link cannot move, so that defaults need no warning.
pub(crate) fn read_inertia(
    link: ElementId,
    collisions: &[Collision],
    is_fixed: bool,
    findings: &mut Findings<'_>,
) -> LinkInertia {
    let tree = findings.tree;
    let Some(element) = tree.child(link, "inertial") else {
        if !is_fixed {
            findings.add_once(Severity::Warning, "default-inertia", "link", link, || {
                "the link has no <inertial>: SDFormat gives it 1 kg and moments of 1 kg·m²; give it its own".to_owned()
            });
        }
        return LinkInertia {
            inertial: Inertial::diagonal(DEFAULT_MASS, [0.0; 3], [DEFAULT_MOMENT; 3]),
            is_default: true,
        };
    };
    if read_boolean_attribute(element, "auto", findings)
        && Version::of_element(tree, element) >= WITH_AUTO
        && let Some(inertial) = inertia_of_collisions(element, collisions, is_fixed, findings)
    {
        return LinkInertia { inertial, is_default: false };
    }
    let mass = read_number_in(element, "mass", findings);
    let frame = read_pose_in(element, findings);
    let has_frame =
        |pose: &ElementId| ["relative_to", "frame"].iter().any(|name| tree.attribute(*pose, name).is_some());
    if let Some(pose) = tree.child(element, "pose").filter(has_frame) {
        findings.add_once(Severity::Warning, "ignored", "pose of inertial", pose, || {
            "the pose of an <inertial> is in the frame of its link; relative_to and frame are ignored, as in libsdformat".to_owned()
        });
    }
    let moments = tree.child(element, "inertia");
    if !is_fixed && (mass.is_none() || moments.is_none()) {
        let missing = if mass.is_none() {
            "<mass>: SDFormat takes 1 kg"
        } else {
            "<inertia>: SDFormat takes moments of 1 kg·m²"
        };
        findings.add_once(Severity::Warning, "default-inertia", missing, element, || {
            format!("<inertial> has no {missing}; give the link its own")
        });
    }
    let mut entry = |tag: &str, default: f64| {
        let given = moments.and_then(|moments| read_number_in(moments, tag, findings));
        given.unwrap_or(default)
    };
    let (xx, yy, zz) =
        (entry("ixx", DEFAULT_MOMENT), entry("iyy", DEFAULT_MOMENT), entry("izz", DEFAULT_MOMENT));
    let (xy, xz, yz) = (entry("ixy", 0.0), entry("ixz", 0.0), entry("iyz", 0.0));
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    LinkInertia {
        inertial: Inertial {
            mass: mass.unwrap_or(DEFAULT_MASS),
            com: frame.translation,
            about_com: turn(&frame.rotation, &tensor),
        },
        is_default: moments.is_none(),
    }
}

/// Inertia of the collisions of a link; scaled to the mass where one is given. `None`, with a finding, if a shape has no volume that is
/// computed.
fn inertia_of_collisions(
    inertial: ElementId,
    collisions: &[Collision],
    is_fixed: bool,
    findings: &mut Findings<'_>,
) -> Option<Inertial> {
    let density = read_number_in(inertial, "density", findings).unwrap_or(DEFAULT_DENSITY);
    if let Some(unused) = ["pose", "inertia"].iter().find_map(|tag| findings.tree.child(inertial, tag)) {
        findings.add_once(Severity::Warning, "ignored", "part of an automatic inertia", unused, || {
            "the inertia follows from the collisions (auto=\"true\"), and this element is not used; remove it, or auto".to_owned()
        });
    }
    let mut parts = Vec::new();
    for collision in collisions {
        let Some((unit, centroid)) = collision.shape.unit_inertia() else {
            let severity = if is_fixed { Severity::Note } else { Severity::Error };
            findings.add(severity, "unsupported", collision.element, || {
                "inertias of meshes, planes and height maps are not computed (auto=\"true\"); write <mass> and <inertia>".to_owned()
            });
            return None;
        };
        let own = read_number_in(collision.element, "density", findings);
        let mass = own.unwrap_or(density) * unit.volume;
        let tensor = Matrix3::from_diagonal(&Vector3::from(unit.moments)) * mass;
        parts.push(Inertial {
            mass,
            com: collision.frame.point(&Vector3::new(0.0, 0.0, centroid)),
            about_com: turn(&collision.frame.rotation, &tensor),
        });
    }
    if parts.is_empty() {
        if !is_fixed {
            findings.error("default-inertia", inertial, || {
                "the inertia follows from the collisions (auto=\"true\"), and the link has none; write <mass> and <inertia>".to_owned()
            });
        }
        return None;
    }
    let mut total = sum(&parts);
    if let Some(mass) = read_number_in(inertial, "mass", findings).filter(|_| total.mass > 0.0) {
        findings.add_once(Severity::Note, "auto-inertia", "mass", inertial, || {
            "auto=\"true\" with <mass>: the moments of the collisions are scaled to the mass, as in libsdformat from 14.7 and 15.2 on; \
             earlier versions ignore the mass"
                .to_owned()
        });
        total.about_com *= mass / total.mass;
        total.mass = mass;
    }
    Some(total)
}

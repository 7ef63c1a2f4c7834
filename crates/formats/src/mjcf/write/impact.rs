//! An impact at one contact: two geoms, their contact parameters, and a keyframe at the touch.

use super::body_tree::{BodyTree, pose_attributes};
use super::error::MjcfError;
use crate::mjcf::values::orientation::rotation_to_z;
use crate::writing::state::MechanismState;
use crate::writing::xml_text::{append, format_number, format_numbers, format_vector};
use percuss_mechanism::{JointId, JointKind, LinkId};
use percuss_spatial::{Transform, Vector3};

/// Name of the keyframe and of the contact pair.
pub(super) const NAME: &str = "impact";

/// Impact at a contact or at the stop of a joint, in MuJoCo's parameters.
///
/// At a contact, the contact link gets a sphere about the contact point, and the other side a face at a distance of one radius along the
/// normal: a plane on the ground, a box on a link. The gap is n·(p_face − p) − radius, so its closing speed is that of the contact point
/// along the normal. The normal moves with the other side.
#[derive(Clone, Debug)]
pub struct MjcfImpact {
    /// Pose and velocity at the touch.
    pub state: MechanismState,
    /// Surfaces that touch, or the stop of a joint.
    pub contact: ImpactContact,
    /// `solref` of the contact or of the limit.
    pub solref: Vec<f64>,
    /// `solimp` of the contact or of the limit.
    pub solimp: Vec<f64>,
    /// `solref` and `solimp` of all equality constraints; `None` without constraints.
    pub equality: Option<[Vec<f64>; 2]>,
    /// Time step, s.
    pub time_step: f64,
    /// Restitution, written as the number `restitution`.
    pub restitution: f64,
}

/// Parts that touch in an impact.
#[derive(Clone, Debug)]
pub enum ImpactContact {
    /// Sphere and face.
    Surfaces(ImpactSurfaces),
    /// Stop of a joint with one degree of freedom: the only limit in the file.
    Limit {
        /// The joint.
        joint: JointId,
        /// Its range, rad or m: one of the ends is the stop.
        range: [f64; 2],
    },
}

/// Sphere about the contact point, and face of the other side.
#[derive(Clone, Debug)]
pub struct ImpactSurfaces {
    /// The contact link.
    pub link: LinkId,
    /// Link on the other side; `None` for the ground.
    pub against: Option<LinkId>,
    /// Contact point, m, link frame.
    pub point: Vector3<f64>,
    /// Unit normal out of the contact link, world axes.
    pub normal: Vector3<f64>,
    /// Radius of the sphere, m: more than the greatest penetration.
    pub radius: f64,
    /// Half of the side of the face, m.
    pub extent: f64,
}

impl MjcfImpact {
    /// Adds the two geoms to the bodies, or the only limit to the joints.
    ///
    /// # Errors
    /// [`MjcfError`]: a link without a body in the file.
    pub(super) fn add_contact(&self, tree: &mut BodyTree<'_>) -> Result<(), MjcfError> {
        match &self.contact {
            ImpactContact::Surfaces(surfaces) => self.add_geoms(surfaces, tree),
            ImpactContact::Limit { joint, range } => {
                let attributes = format!(
                    " range=\"{}\" solreflimit=\"{}\" solimplimit=\"{}\"",
                    format_numbers(range),
                    format_numbers(&self.solref),
                    format_numbers(&self.solimp)
                );
                tree.limit_only(*joint, attributes);
                Ok(())
            }
        }
    }

    /// Adds the two geoms to the bodies.
    fn add_geoms(&self, surfaces: &ImpactSurfaces, tree: &mut BodyTree<'_>) -> Result<(), MjcfError> {
        let mechanism = tree.mechanism;
        let moving = |link| moving_link(tree, link);
        let other = surfaces.against.map(moving).filter(|link| *link != mechanism.root());
        let own = moving(surfaces.link);
        if let Some(link) = [Some(own), other].into_iter().flatten().find(|link| !tree.has_body(*link)) {
            return Err(MjcfError::new(
                "link",
                mechanism.link(link).name(),
                "the contact is at a massless link, which has no body of its own in MJCF; give the contact at a link with mass",
            ));
        }
        let attributes = "contype=\"0\" conaffinity=\"0\"";
        let poses = &self.state.link_poses;
        let centre = poses[surfaces.link.index()].point(&surfaces.point);
        let sphere = format!(
            "<geom name=\"{NAME}/point\" type=\"sphere\" size=\"{}\" pos=\"{}\" {attributes}/>\n",
            format_number(surfaces.radius),
            format_vector(&poses[own.index()].inverse_point(&centre))
        );
        tree.append_content(Some(own), &sphere);
        let Some(rotation) = rotation_to_z(-surfaces.normal) else {
            return Err(MjcfError::new(
                "link",
                mechanism.link(surfaces.link).name(),
                "the normal has no direction",
            ));
        };
        let (kind, depth) = match other {
            None => ("plane", 0.0),
            Some(_) => ("box", surfaces.radius),
        };
        // The face is the side of the box towards the contact link.
        let face = Transform::new(rotation, centre + surfaces.normal * (surfaces.radius + depth));
        let holder = other.map_or_else(Transform::identity, |link| poses[link.index()]);
        let size = format_numbers(&[surfaces.extent, surfaces.extent, surfaces.radius]);
        let line = format!(
            "<geom name=\"{NAME}/face\" type=\"{kind}\" size=\"{size}\"{} {attributes}/>\n",
            pose_attributes(&(holder.inverse() * face))
        );
        tree.append_content(other, &line);
        Ok(())
    }

    /// Elements before the bodies: options, defaults and numbers.
    pub(super) fn head(&self) -> String {
        let mut out = format!(
            "  <option timestep=\"{}\" gravity=\"0 0 0\">\n    <flag limit=\"{}\"/>\n  </option>\n",
            format_number(self.time_step),
            match self.contact {
                ImpactContact::Surfaces(_) => "disable",
                ImpactContact::Limit { .. } => "enable",
            }
        );
        if let Some([solref, solimp]) = &self.equality {
            append!(
                out,
                "  <default>\n    <equality solref=\"{}\" solimp=\"{}\"/>\n  </default>\n",
                format_numbers(solref),
                format_numbers(solimp)
            );
        }
        append!(
            out,
            "  <custom>\n    <numeric name=\"restitution\" data=\"{}\"/>\n  </custom>\n",
            format_number(self.restitution)
        );
        out
    }

    /// Section `<contact>` with the pair of geoms; empty for the stop of a joint.
    pub(super) fn pair(&self) -> String {
        match self.contact {
            ImpactContact::Surfaces(_) => format!(
                "  <contact>\n    <pair name=\"{NAME}\" geom1=\"{NAME}/point\" geom2=\"{NAME}/face\" condim=\"1\" solref=\"{}\" \
                 solimp=\"{}\"/>\n  </contact>\n",
                format_numbers(&self.solref),
                format_numbers(&self.solimp)
            ),
            ImpactContact::Limit { .. } => String::new(),
        }
    }
}

/// First link of the chain of fixed joints to a link. MuJoCo estimates the inverse mass at a contact from the body of the geom, and the
/// estimates of welded bodies differ.
fn moving_link(tree: &BodyTree<'_>, mut link: LinkId) -> LinkId {
    let mechanism = tree.mechanism;
    while let Some(joint) = mechanism.parent_joint(link).map(|id| mechanism.joint(id))
        && joint.kind() == JointKind::Fixed
        && tree.has_body(joint.parent())
    {
        link = joint.parent();
    }
    link
}

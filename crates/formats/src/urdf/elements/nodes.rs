//! XML elements of the mechanism, and positions of the builder's findings among them.

use crate::reading::limits::MAX_ELEMENTS_PER_KIND;
use crate::reading::report::{Place, Report};
use crate::reading::xml::Node;
use crate::urdf::elements::closure;
use crate::urdf::elements::joints::gazebo_joint::{fixes_root_to_world, is_relation, joins_any};
use crate::urdf::elements::survey::{child, children, is_gazebo_joint, is_named};
use percuss_mechanism::{Problem, Subject};
use std::collections::HashSet;

/// Elements of links, joints, loops, couplings, relations and contacts, in the order of the file.
pub(crate) struct Nodes<'a> {
    pub links: Vec<Node<'a>>,
    pub joints: Vec<Node<'a>>,
    pub closures: Vec<Node<'a>>,
    pub couplings: Vec<Node<'a>>,
    pub relations: Vec<Node<'a>>,
    pub contacts: Vec<Node<'a>>,
    pub bushes: Vec<Node<'a>>,
    pub gears: Vec<Node<'a>>,
}

impl<'a> Nodes<'a> {
    /// Collects the elements of a robot. Joints that fix the root link to the world are left out.
    pub fn collect(robot: Node<'a>, report: &mut Report) -> Self {
        let names: HashSet<&str> =
            children(robot, "link").filter_map(|link| link.attribute("name")).collect();
        let link = |joint: Node<'a>| child(joint, "child").and_then(|child| child.attribute("link"));
        let child_links: HashSet<&str> = children(robot, "joint").filter_map(link).collect();
        let is_root =
            |link: &str| names.contains(link) && !child_links.contains(link) && !names.contains("world");
        let bodies = |gazebo| children(gazebo, "link").chain(children(gazebo, "model"));
        let in_gazebo: HashSet<&str> =
            children(robot, "gazebo").flat_map(bodies).filter_map(|body| body.attribute("name")).collect();
        Self {
            links: children(robot, "link").collect(),
            joints: children(robot, "joint").collect(),
            closures: robot
                .children()
                .filter(Node::is_element)
                .flat_map(|node| {
                    let loop_element = closure::is_loop_element(node).then_some(node);
                    let joints = node.children().filter(|n| is_gazebo_joint(*n) && !is_relation(*n));
                    loop_element.into_iter().chain(joints)
                })
                .filter(|node| {
                    !is_gazebo_joint(*node)
                        || !joins_any(*node, &in_gazebo) && !fixes_root_to_world(*node, is_root, report)
                })
                .collect(),
            couplings: children(robot, "coupling").collect(),
            relations: robot
                .children()
                .filter(Node::is_element)
                .flat_map(|node| {
                    let relation = is_named(node, "relation").then_some(node);
                    let is_read = |n: &Node<'a>| is_relation(*n) && !joins_any(*n, &in_gazebo);
                    let joints = node.children().filter(|n| is_gazebo_joint(*n)).filter(is_read);
                    relation.into_iter().chain(joints)
                })
                .collect(),
            contacts: children(robot, "contact").collect(),
            bushes: children(robot, "bushing").collect(),
            gears: children(robot, "elastic").collect(),
        }
    }

    /// True if the number of elements of each kind is within the limit; otherwise reports an error.
    pub fn check_counts(&self, robot: Node<'a>, report: &mut Report) -> bool {
        let counts = [
            ("links", self.links.len()),
            ("joints", self.joints.len()),
            ("loops", self.closures.len()),
            ("couplings", self.couplings.len()),
            ("relations", self.relations.len()),
            ("contacts", self.contacts.len()),
            ("bushings", self.bushes.len()),
            ("elastic gears", self.gears.len()),
        ];
        let excess = counts.into_iter().find(|(_, count)| *count > MAX_ELEMENTS_PER_KIND);
        if let Some((kind, count)) = excess {
            report.error("too-complex", Place::Element(robot), || {
                format!("{count} {kind}; at most {MAX_ELEMENTS_PER_KIND} are read")
            });
        }
        excess.is_none()
    }

    /// Position in the file of a problem that the builder found.
    pub fn locate(&self, robot: Node<'a>, subject: &Subject, problem: &Problem) -> Place<'a, 'a> {
        let node = match subject {
            Subject::Mechanism => Some(robot),
            Subject::Bush { index, .. } => self.bushes.get(*index).copied(),
            Subject::Link { index, .. } => self.links.get(*index).copied(),
            Subject::Joint { index, .. } => self.joints.get(*index).copied(),
            Subject::Closure { index, .. } => self.closures.get(*index).copied(),
            Subject::Coupling { index, .. } => {
                self.couplings.iter().chain(&self.relations).nth(*index).copied()
            }
            Subject::Contact { index, .. } => self.contacts.get(*index).copied(),
        };
        let node = node.unwrap_or(robot);
        let within: &[&'static str] = match problem {
            Problem::NotFinite { quantity, .. } | Problem::TooLarge { quantity, .. } => match *quantity {
                "centre of mass" => &["inertial", "origin"],
                "mass" => &["inertial", "mass"],
                "inertia" => &["inertial", "inertia"],
                "origin" | "rotation" => &["origin"],
                "axis" => &["axis"],
                "limit" => &["limit"],
                "mimic" => &["mimic"],
                "armature" => &["dynamics"],
                "distance" => &["distance"],
                "ratio" => &["ratio"],
                "constant" => &["constant"],
                "offset" | "coefficient" => &["curve"],
                "contact point" => &["body"],
                "normal" => &["normal"],
                "point of the line" => &["toward"],
                "gap" => &["gap"],
                // Other names of quantities have no element of their own.
                _ => &[],
            },
            Problem::NegativeMass { .. } => &["inertial", "mass"],
            Problem::IndefiniteInertia { .. }
            | Problem::TriangleInequality { .. }
            | Problem::WideInertia { .. }
            | Problem::DenseInertia { .. }
            | Problem::InertiaBeyondShape { .. } => &["inertial", "inertia"],
            Problem::ComBeyondShape { .. } => &["inertial", "origin"],
            Problem::InertiaWithoutMass { .. } => &["inertial", "mass"],
            Problem::ZeroAxis if matches!(subject, Subject::Contact { .. }) => &["normal"],
            Problem::ZeroAxis | Problem::AxisNotUnit { .. } => &["axis"],
            Problem::LimitsReversed { .. } => &["limit"],
            Problem::NegativeArmature { .. } | Problem::ArmatureCount { .. } => &["dynamics"],
            Problem::MimicKind { .. } | Problem::MimicCycle { .. } | Problem::DanglingMimic { .. } => {
                &["mimic"]
            }
            Problem::SecondParent { .. } | Problem::NoClosure { .. } | Problem::JoinsItself { .. } => {
                &["child"]
            }
            Problem::BadDistance { .. } => &["distance"],
            Problem::ClosesOnItself { .. } if matches!(subject, Subject::Contact { .. }) => &["other"],
            Problem::ClosesOnItself { .. } => std::slice::from_ref(&closure::link_tags(node)[1]),
            // Other problems have no element of their own; the position is the link or joint.
            _ => &[],
        };
        Place::Element(within.iter().try_fold(node, |node, name| child(node, name)).unwrap_or(node))
    }
}

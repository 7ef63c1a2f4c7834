//! Contents of all elements of the mechanism, each checked by itself.

use crate::reading::report::Report;
use crate::reading::xml::Node;
use crate::urdf::elements::bushing;
use crate::urdf::elements::closure;
use crate::urdf::elements::contact;
use crate::urdf::elements::joints::gazebo_joint::{GazeboJointReader, ScrewLoop, ZeroPoseFrames};
use crate::urdf::elements::joints::joint::{self, JointText};
use crate::urdf::elements::link::{self, LinkText};
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::relation;
use crate::urdf::elements::survey::is_gazebo_joint;
use crate::urdf::references::index_by_name;
use percuss_mechanism::{
    BushDescription, ClosureDescription, ContactDescription, CouplingDescription, RelationDescription,
};

/// Contents of the file, in the order of [`Nodes`]. If the report has no error, all numbers are valid.
/// [`consistency::resolve_references`](crate::urdf::consistency::resolve_references) checks the references by name.
pub(crate) struct Texts<'a> {
    pub links: Vec<LinkText<'a>>,
    pub joints: Vec<JointText<'a>>,
    pub closures: Vec<ClosureDescription>,
    pub couplings: Vec<CouplingDescription>,
    pub relations: Vec<RelationDescription>,
    pub contacts: Vec<ContactDescription>,
    pub bushes: Vec<BushDescription>,
    /// Screws that close loops; their parts follow those of the file.
    pub screws: Vec<ScrewLoop>,
}

impl<'a> Texts<'a> {
    /// True if an element closes a loop.
    pub fn has_closures(&self) -> bool {
        !self.closures.is_empty() || !self.screws.is_empty()
    }

    /// Reads all elements. Relations that cannot be read are removed from `nodes`.
    pub fn read_elements(nodes: &mut Nodes<'a>, report: &mut Report) -> Self {
        let links: Vec<LinkText<'a>> = nodes.links.iter().map(|n| link::read_link(*n, report)).collect();
        let mut joints: Vec<JointText<'a>> =
            nodes.joints.iter().map(|n| joint::read_joint(*n, report)).collect();
        nodes.gears.iter().for_each(|node| joint::read_gear(*node, &mut joints, report));
        let has_gazebo_joints = nodes.closures.iter().chain(&nodes.relations).any(|n| is_gazebo_joint(*n));
        let zero_pose = ZeroPoseFrames::new(if has_gazebo_joints { &joints } else { &[] });
        let link_index = index_by_name(links.iter().map(|l| l.name));
        let reader = GazeboJointReader { zero_pose: &zero_pose, links: &link_index };
        let closure = |node: &Node<'a>| {
            if is_gazebo_joint(*node) {
                reader.read_closure(*node, report)
            } else {
                closure::read_loop(*node, report)
            }
        };
        let closures = nodes.closures.iter().map(closure).collect();
        let (mut relations, mut screws) = (Vec::new(), Vec::new());
        nodes.relations.retain(|node| {
            let read = if is_gazebo_joint(*node) {
                reader.read_relation(*node, &mut screws, report)
            } else {
                Some(relation::read_relation(*node, report))
            };
            let is_read = read.is_some();
            relations.extend(read);
            is_read
        });
        Texts {
            closures,
            relations,
            screws,
            links,
            joints,
            couplings: nodes.couplings.iter().map(|n| closure::read_coupling(*n, report)).collect(),
            contacts: nodes.contacts.iter().map(|n| contact::read_contact(*n, report)).collect(),
            bushes: nodes.bushes.iter().map(|n| bushing::read_bushing(*n, report)).collect(),
        }
    }
}

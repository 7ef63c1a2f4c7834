//! Immutable mechanism.

use crate::tree::Tree;
use crate::{
    Bush, Closure, ClosureId, Coupling, Joint, JointId, JointKind, Link, LinkId, NameKind, NamedContact,
    UnknownName, near_names,
};
use std::collections::HashMap;
use std::ops::Range;

/// Spanning tree of links and joints, with loop closures. Immutable, `Send + Sync`; share it by `Arc`.
#[derive(Debug)]
pub struct Mechanism {
    pub(crate) name: String,
    pub(crate) links: Vec<Link>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) closures: Vec<Closure>,
    pub(crate) couplings: Vec<Coupling>,
    pub(crate) contacts: Vec<NamedContact>,
    pub(crate) bushes: Vec<Bush>,
    pub(crate) root: LinkId,
    pub(crate) parent_joint: Vec<Option<JointId>>,
    pub(crate) child_joints: Vec<Vec<JointId>>,
    pub(crate) order: Vec<LinkId>,
    pub(crate) link_by_name: HashMap<String, LinkId>,
    pub(crate) joint_by_name: HashMap<String, JointId>,
    pub(crate) characteristic_length: f64,
}

impl Mechanism {
    /// Mechanism without closures and couplings. `characteristic_length`: m.
    pub(crate) fn new(
        name: String,
        links: Vec<Link>,
        joints: Vec<Joint>,
        tree: Tree,
        characteristic_length: f64,
    ) -> Self {
        let link_by_name =
            links.iter().enumerate().map(|(i, l)| (l.name.clone(), LinkId::new(i, &l.name))).collect();
        let joint_by_name =
            joints.iter().enumerate().map(|(i, j)| (j.name.clone(), JointId::new(i, &j.name))).collect();
        let Tree { root, parent_joint, child_joints, order } = tree;
        Self {
            name,
            links,
            joints,
            closures: Vec::new(),
            couplings: Vec::new(),
            contacts: Vec::new(),
            bushes: Vec::new(),
            root,
            parent_joint,
            child_joints,
            order,
            link_by_name,
            joint_by_name,
            characteristic_length,
        }
    }

    /// Name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All links, in the given order.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// All tree joints, in the given order.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// All closures, in the given order; closures from joints to second parents come last.
    pub fn closures(&self) -> &[Closure] {
        &self.closures
    }

    /// All couplings, in the given order.
    pub fn couplings(&self) -> &[Coupling] {
        &self.couplings
    }

    /// All named contacts, in the given order.
    pub fn contacts(&self) -> &[NamedContact] {
        &self.contacts
    }

    /// All bushes, in the given order.
    pub fn bushes(&self) -> &[Bush] {
        &self.bushes
    }

    /// Indices of all closures.
    pub fn closure_ids(&self) -> impl Iterator<Item = ClosureId> + use<> {
        (0..self.closures.len() as u32).map(ClosureId)
    }

    /// True if the index is of this mechanism, or of one that has a link of the same name there.
    pub fn has_link(&self, id: LinkId) -> bool {
        self.links.get(id.index()).is_some_and(|link| link.mark == id.mark)
    }

    /// As [`has_link`](Self::has_link).
    pub fn has_joint(&self, id: JointId) -> bool {
        self.joints.get(id.index()).is_some_and(|joint| joint.mark == id.mark)
    }

    /// The link with this index.
    ///
    /// # Panics
    /// An index of another mechanism: [`has_link`](Self::has_link) is false.
    pub fn link(&self, id: LinkId) -> &Link {
        assert!(self.has_link(id), "link number {} belongs to another mechanism", id.index());
        &self.links[id.index()]
    }

    /// The joint with this index.
    ///
    /// # Panics
    /// An index of another mechanism: [`has_joint`](Self::has_joint) is false.
    pub fn joint(&self, id: JointId) -> &Joint {
        assert!(self.has_joint(id), "joint number {} belongs to another mechanism", id.index());
        &self.joints[id.index()]
    }

    /// Indices of all links, in the order given.
    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<'_> {
        self.links.iter().enumerate().map(|(index, link)| LinkId { index: index as u32, mark: link.mark })
    }

    /// Indices of all joints, in the order given.
    pub fn joint_ids(&self) -> impl Iterator<Item = JointId> + use<'_> {
        self.joints.iter().enumerate().map(|(index, joint)| JointId { index: index as u32, mark: joint.mark })
    }

    /// Indices of the positions of each joint among those of all joints, in the order given.
    pub fn position_ranges(&self) -> impl Iterator<Item = Range<usize>> + use<'_> {
        self.joints.iter().scan(0, |next, joint| {
            let first = *next;
            *next += joint.kind().positions();
            Some(first..*next)
        })
    }

    /// Link without parent.
    pub fn root(&self) -> LinkId {
        self.root
    }

    /// All links, parents before children.
    pub fn order(&self) -> &[LinkId] {
        &self.order
    }

    /// Joint to the parent; `None` for the root.
    pub fn parent_joint(&self, link: LinkId) -> Option<JointId> {
        self.parent_joint[link.index()]
    }

    /// Joints to the children.
    pub fn child_joints(&self, link: LinkId) -> &[JointId] {
        &self.child_joints[link.index()]
    }

    /// Link with this name. Unlike [`find_link`](Self::find_link), no similar names are searched.
    pub fn link_named(&self, name: &str) -> Option<LinkId> {
        self.link_by_name.get(name).copied()
    }

    /// Joint with this name. Unlike [`find_joint`](Self::find_joint), no similar names are searched.
    pub fn joint_named(&self, name: &str) -> Option<JointId> {
        self.joint_by_name.get(name).copied()
    }

    /// Finds a link by name.
    ///
    /// # Errors
    /// [`UnknownName`] with similar names.
    pub fn find_link(&self, name: &str) -> Result<LinkId, UnknownName> {
        self.link_named(name).ok_or_else(|| {
            let links = (NameKind::Link, self.links.iter().map(Link::name).collect());
            UnknownName::new(name, &[links, self.contact_names()])
        })
    }

    /// Finds a joint by name.
    ///
    /// # Errors
    /// [`UnknownName`] with similar names.
    pub fn find_joint(&self, name: &str) -> Result<JointId, UnknownName> {
        self.joint_named(name).ok_or_else(|| {
            // Fixed joints have no position to name.
            let movable = self.joints.iter().filter(|joint| joint.kind() != JointKind::Fixed);
            let near = near_names(name, self.joints.iter().map(Joint::name));
            UnknownName {
                near,
                ..UnknownName::new(name, &[(NameKind::Joint, movable.map(Joint::name).collect())])
            }
        })
    }

    /// Finds a contact by name.
    ///
    /// # Errors
    /// [`UnknownName`] with similar names.
    pub fn find_contact(&self, name: &str) -> Result<&NamedContact, UnknownName> {
        let found = self.contacts.iter().find(|contact| contact.name == name);
        found.ok_or_else(|| UnknownName::new(name, &[self.contact_names()]))
    }

    /// Names of the contacts.
    fn contact_names(&self) -> (NameKind, Vec<&str>) {
        (NameKind::Contact, self.contacts.iter().map(NamedContact::name).collect())
    }

    /// Total mass of all links, kg.
    pub fn total_mass(&self) -> f64 {
        self.links.iter().map(|l| l.inertia.mass).sum()
    }

    /// Characteristic length of the mechanism, m: the largest distance from a link's origin to its centre of
    /// mass, the end of its shape, a child joint or a loop frame, without the root; if zero, the extent of the
    /// root, a radius of gyration, or 1. Scales rank decisions; does not affect results otherwise.
    pub fn characteristic_length(&self) -> f64 {
        self.characteristic_length
    }
}

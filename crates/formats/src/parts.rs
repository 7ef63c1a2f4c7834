//! Parts of a mechanism with their elements in the file.

use crate::hull::build_with_shapes;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::shape::Shape;
use percuss_mechanism::{
    Accept, ClosureDescription, ContactDescription, CouplingDescription, JointDescription, LinkDescription,
    Mechanism, MechanismBuilder, Problem, RelationDescription, SpringDamper, Subject,
};

/// Parts of a model, each with its element.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub links: Vec<(LinkDescription, LinkOrigin)>,
    pub joints: Vec<(JointDescription, ElementId)>,
    pub closures: Vec<(ClosureDescription, ElementId)>,
    pub couplings: Vec<(CouplingDescription, ElementId)>,
    pub relations: Vec<(RelationDescription, ElementId)>,
    pub contacts: Vec<ContactDescription>,
}

/// Origin of a link of the mechanism.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkOrigin {
    pub element: ElementId,
    /// Index of the link in the model; `None` for links that the model does not have: the ground, frames, and links within a chain of joints.
    pub link: Option<usize>,
    /// True if the inertia has default values of the format.
    pub has_default_inertia: bool,
}

impl Parts {
    /// Adds a massless link that the model does not have.
    pub fn add_auxiliary(&mut self, name: impl Into<String>, element: ElementId) {
        let origin = LinkOrigin { element, link: None, has_default_inertia: false };
        self.links.push((LinkDescription::massless(name), origin));
    }

    /// Builds the mechanism; `None` after an error. `shapes` and `hull_of`: see [`build_with_shapes`]. `place`: element of a finding of the
    /// builder, given the element of its part; `None` for a finding that is left out.
    pub fn build<'s>(
        &self,
        name: String,
        accept: Accept,
        (shapes, hull_of): (&'s [Vec<Shape>], impl Fn(usize, &'s [Shape]) -> Vec<&'s Shape>),
        place: impl Fn(ElementId, &Subject, &Problem) -> Option<ElementId>,
        findings: &mut Findings<'_>,
    ) -> Option<Mechanism> {
        let mut builder = MechanismBuilder::new(name);
        builder = self.links.iter().map(|(link, _)| link.clone()).fold(builder, MechanismBuilder::link);
        builder = self.joints.iter().map(|(joint, _)| joint.clone()).fold(builder, MechanismBuilder::joint);
        let closures = self.closures.iter().map(|(closure, _)| closure.clone());
        builder = closures.fold(builder, MechanismBuilder::closure);
        let couplings = self.couplings.iter().map(|(coupling, _)| coupling.clone());
        builder = couplings.fold(builder, MechanismBuilder::coupling);
        let relations = self.relations.iter().map(|(relation, _)| relation.clone());
        builder = relations.fold(builder, MechanismBuilder::relation);
        builder = self.contacts.iter().cloned().fold(builder, MechanismBuilder::contact);
        let (mechanism, found) = build_with_shapes(builder, accept, shapes, hull_of);
        for (subject, problem) in found {
            let related = || {
                let couplings = self.couplings.iter().map(|(_, element)| *element);
                couplings.chain(self.relations.iter().map(|(_, element)| *element))
            };
            let element = match &subject {
                Subject::Link { index, .. } => self.links.get(*index).map(|(_, origin)| origin.element),
                Subject::Joint { index, .. } => self.joints.get(*index).map(|(_, element)| *element),
                Subject::Closure { index, .. } => self.closures.get(*index).map(|(_, element)| *element),
                Subject::Coupling { index, .. } => related().nth(*index),
                Subject::Mechanism | Subject::Contact { .. } | Subject::Bush { .. } => None,
            };
            let element = element.unwrap_or_else(|| findings.tree.root());
            if let Some(element) = place(element, &subject, &problem) {
                findings.add(problem.severity(), problem.code(), element, || problem.to_string());
            }
        }
        mechanism
    }
}

/// Spring and damper of a joint with a number of velocities: stiffness, damping, position without force. `None` without any effect; an error with the
/// reason why they are left out.
pub(crate) fn joint_spring(
    dofs: usize,
    [stiffness, damping, reference]: [f64; 3],
) -> Result<Option<SpringDamper>, &'static str> {
    match dofs {
        0 => Ok(None),
        _ if stiffness == 0.0 && damping == 0.0 => Ok(None),
        _ if stiffness < 0.0 || damping < 0.0 => {
            Err("its negative stiffness or damping is no spring or damper, and both are left out")
        }
        1 => Ok(Some(SpringDamper { stiffness, damping, reference })),
        _ => Err("its spring and damper are left out: only a joint with one velocity can have them"),
    }
}

/// Code of a finding about a spring that is left out.
pub(crate) const SPRING_LEFT_OUT: &str = "spring-left-out";

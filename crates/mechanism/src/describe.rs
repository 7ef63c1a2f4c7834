//! Converts a mechanism back to a builder, to change parts of it.

use crate::{
    Accept, ClosureDescription, ContactDescription, Coupling, CouplingDescription, CurveDescription,
    JointDescription, JointId, LinkDescription, LinkId, LinkRatio, Mechanism, MechanismBuilder,
    MimicDescription, RelationDescription,
};

impl Mechanism {
    /// Builder with all descriptions of this mechanism. Indefinite and implausible inertias are accepted, as they may have
    /// been accepted when this mechanism was built.
    pub fn to_builder(&self) -> MechanismBuilder {
        let mut builder = self.to_tree_builder(true);
        for closure in &self.closures {
            builder = builder.closure(ClosureDescription {
                name: closure.name.clone(),
                kind: closure.kind,
                predecessor: self.end_name(closure.predecessor.link),
                predecessor_frame: closure.predecessor.frame,
                successor: self.end_name(closure.successor.link),
                successor_frame: closure.successor.frame,
                axis: closure.axis,
                axis2: closure.axis2,
                distance: closure.distance,
            });
        }
        for coupling in &self.couplings {
            builder = match coupling.ratio {
                None => builder.relation(self.describe_relation(coupling)),
                Some(LinkRatio { predecessor, successor, ratio }) => builder.coupling(CouplingDescription {
                    name: coupling.name.clone(),
                    predecessor: self.link(predecessor).name.clone(),
                    successor: self.link(successor).name.clone(),
                    ratio,
                }),
            };
        }
        for contact in &self.contacts {
            builder = builder.contact(ContactDescription {
                name: contact.name.clone(),
                kind: contact.kind,
                link: self.link(contact.link).name.clone(),
                point: contact.point,
                against: self.end_name(contact.against),
                normal: contact.normal,
                gap: contact.gap,
            });
        }
        self.bushes.iter().fold(builder, |builder, bush| builder.bush(bush.description().clone()))
    }

    /// Description of a coupling of this mechanism as a relation of joint positions.
    ///
    /// # Panics
    /// A coupling of another mechanism.
    pub fn describe_relation(&self, coupling: &Coupling) -> RelationDescription {
        let names = |terms: &[(JointId, f64)]| {
            terms.iter().map(|&(id, factor)| (self.joint(id).name.clone(), factor)).collect()
        };
        RelationDescription {
            name: coupling.name.clone(),
            terms: names(&coupling.terms),
            constant: coupling.constant,
            curve: coupling.curve.as_ref().map(|curve| CurveDescription {
                terms: names(&curve.terms),
                offset: curve.offset,
                coefficients: curve.coefficients,
            }),
        }
    }

    /// Builder of the spanning tree alone, without closures, couplings and mimics.
    pub fn to_open_tree(&self) -> MechanismBuilder {
        self.to_tree_builder(false)
    }

    /// Builder with the links and tree joints, without closures and couplings; `mimics`: keep the mimics. Inertias that the
    /// checks reject are accepted.
    fn to_tree_builder(&self, mimics: bool) -> MechanismBuilder {
        let mut builder = MechanismBuilder::new(self.name.clone())
            .accept(Accept { indefinite_inertia: true, ..Accept::default() });
        for link in &self.links {
            let (name, inertial, geometry) = (link.name.clone(), link.inertial, link.geometry);
            builder = builder.link(LinkDescription { name, inertial, geometry });
        }
        for joint in &self.joints {
            builder = builder.joint(JointDescription {
                name: joint.name.clone(),
                kind: joint.kind,
                parent: self.link(joint.parent).name.clone(),
                child: self.link(joint.child).name.clone(),
                origin: joint.origin,
                axis: joint.axis,
                limits: joint.limits,
                rate_limit: joint.rate_limit,
                armature: joint.armature.clone(),
                mimic: joint.mimic.filter(|_| mimics).map(|m| MimicDescription {
                    joint: self.joint(m.master).name.clone(),
                    multiplier: m.multiplier,
                    offset: m.offset,
                }),
                independent: joint.independent,
                spring: joint.spring,
                gear: joint.gear,
            });
        }
        builder
    }

    /// Name of the link at one end of a closure; `world` for `None`.
    fn end_name(&self, link: Option<LinkId>) -> String {
        link.map_or_else(|| "world".into(), |l| self.link(l).name.clone())
    }
}

//! Rotors: massless links at the end of a joint with an armature. A relation couples the joint to others: readers make such a link of the
//! armature of a tendon, and a gear has one.

use percuss_mechanism::{Coupling, Inertial, Joint, JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{Matrix3, Vector3};

/// Ending of the names of the joints of rotors; the rest is the name of the tendon.
const LENGTH: &str = "/length";

/// Form of a rotor in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rotor {
    /// Armature of a fixed tendon instead of this coupling, by its number.
    Tendon(usize),
    /// Armature of a fixed tendon over the joint that the joint of the rotor follows.
    Follower,
    /// A body whose mass is the armature of its slide: MuJoCo leaves the armature of a tendon between different branches out of M.
    Body,
}

impl Rotor {
    /// Form of a link if it is a rotor.
    pub fn of_link(mechanism: &Mechanism, link: LinkId) -> Option<Self> {
        let joint = mechanism.parent_joint(link)?;
        let own = mechanism.joint(joint);
        let has_closure = || {
            let ends = |closure: &percuss_mechanism::Closure| {
                [closure.predecessor().link, closure.successor().link].contains(&Some(link))
            };
            mechanism.closures().iter().any(ends)
        };
        let is_massless = mechanism.link(link).inertial().is_none_or(|i| {
            i.mass == 0.0 && (own.kind() == JointKind::Prismatic || i.about_com == Matrix3::zeros())
        });
        let is_rotor = own.kind().has_axis()
            && own.kind().dofs() == 1
            && armature(own) > 0.0
            && is_massless
            && mechanism.child_joints(link).is_empty()
            && !has_closure();
        if !is_rotor {
            return None;
        }
        if let Some(number) = tendon_coupling(mechanism, joint) {
            return Some(Self::Tendon(number));
        }
        let has_relation =
            || is_followed_by_any(mechanism, joint) || couplings_of(mechanism, joint).next().is_some();
        if own.mimic().is_some() && !has_relation() {
            return Some(Self::Follower);
        }
        let is_body = own.kind() == JointKind::Prismatic && own.parent() == mechanism.root();
        is_body.then_some(Self::Body)
    }
}

/// Armature of a joint with one degree of freedom.
pub(super) fn armature(joint: &Joint) -> f64 {
    joint.armature().first().copied().unwrap_or_default()
}

/// Inertia of a rotor as a body. The body does not rotate, so its moments have no influence.
pub(super) fn rotor_inertial(joint: &Joint) -> Inertial {
    let mass = armature(joint);
    Inertial { mass, com: Vector3::zeros(), about_com: Matrix3::identity() * mass }
}

/// Couplings with a joint, and their numbers.
fn couplings_of(mechanism: &Mechanism, joint: JointId) -> impl Iterator<Item = (usize, &Coupling)> {
    let names = move |coupling: &Coupling| {
        let curve = coupling.curve().map_or(&[][..], |curve| curve.terms());
        coupling.terms().iter().chain(curve).any(|(named, _)| *named == joint)
    };
    mechanism.couplings().iter().enumerate().filter(move |(_, coupling)| names(coupling))
}

/// True if a joint is followed by another.
fn is_followed_by_any(mechanism: &Mechanism, leader: JointId) -> bool {
    mechanism.joints().iter().any(|joint| joint.mimic().is_some_and(|mimic| mimic.master == leader))
}

/// Number of the only relation of a rotor's joint, if it is linear in joints of one branch.
fn tendon_coupling(mechanism: &Mechanism, rotor: JointId) -> Option<usize> {
    let mut found = couplings_of(mechanism, rotor);
    let (number, coupling) = found.next()?;
    if found.next().is_some()
        || coupling.curve().is_some()
        || mechanism.joint(rotor).mimic().is_some()
        || is_followed_by_any(mechanism, rotor)
    {
        return None;
    }
    let others = || tendon_terms(coupling, rotor).map(|(joint, _)| joint);
    let on_one_branch =
        others().all(|a| others().all(|b| is_below(mechanism, a, b) || is_below(mechanism, b, a)));
    on_one_branch.then_some(number)
}

/// True if a joint is another joint, or moves with it.
fn is_below(mechanism: &Mechanism, joint: JointId, other: JointId) -> bool {
    let mut current = Some(joint);
    while let Some(at) = current {
        if at == other {
            return true;
        }
        current = mechanism.parent_joint(mechanism.joint(at).parent());
    }
    false
}

/// Joints and coefficients of the length of a rotor's tendon.
pub(super) fn tendon_terms(coupling: &Coupling, rotor: JointId) -> impl Iterator<Item = (JointId, f64)> + '_ {
    let own = coupling.terms().iter().find(|(joint, _)| *joint == rotor).map_or(1.0, |(_, factor)| *factor);
    coupling
        .terms()
        .iter()
        .filter(move |(joint, factor)| *joint != rotor && *factor != 0.0)
        .map(move |(joint, factor)| (*joint, -factor / own))
}

/// Name of the tendon of a rotor.
pub(super) fn tendon_name(coupling: &Coupling) -> &str {
    coupling.name().strip_suffix(LENGTH).unwrap_or(coupling.name())
}

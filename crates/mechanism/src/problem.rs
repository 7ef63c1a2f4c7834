//! Findings of the validation: errors, warnings and notes.

use crate::names::write_near;
use std::fmt;

/// Findings that the user accepts; accepted errors become warnings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Accept {
    /// Accept inertias with a negative principal moment.
    pub indefinite_inertia: bool,
    /// Inertias far beyond what the size of the links allows.
    pub implausible_inertia: bool,
    /// A second `<inertial>` of a link in a URDF: the first one counts.
    pub second_inertial: bool,
}

/// Severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Information; nothing is wrong.
    Note,
    /// Probable mistake; the message states the assumption used.
    Warning,
    /// No mechanism can be built.
    Error,
}

impl Severity {
    /// `error`, `warning` or `note`.
    pub fn name(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// Subject of a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Whole mechanism.
    Mechanism,
    /// Link with the given index (its name may be a duplicate).
    Link {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// Joint with the given index.
    Joint {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// Closure with the given index.
    Closure {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// Coupling with the given index.
    Coupling {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// Named contact with the given index.
    Contact {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// Bush with the given index.
    Bush {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Subject::Mechanism => f.write_str("the mechanism"),
            Subject::Link { name, .. } => write!(f, "link \"{name}\""),
            Subject::Joint { name, .. } => write!(f, "joint \"{name}\""),
            Subject::Closure { name, .. } => write!(f, "loop \"{name}\""),
            Subject::Coupling { name, .. } => write!(f, "coupling \"{name}\""),
            Subject::Contact { name, .. } => write!(f, "contact \"{name}\""),
            Subject::Bush { name, .. } => write!(f, "bush \"{name}\""),
        }
    }
}

/// A finding of the builder.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Problem {
    /// Mechanism without links.
    NoLinks,
    /// Link or joint without a name.
    EmptyName,
    /// Name used twice.
    DuplicateName {
        /// Index of the first element with this name.
        first: usize,
    },
    /// Joint, closure or contact with a link that does not exist.
    UnknownLink {
        /// `parent`, `child`, `predecessor`, `successor`, `contact` or `other`.
        role: &'static str,
        /// Name of the link.
        link: String,
        /// Similar names.
        near: Vec<String>,
    },
    /// Joint from a link to itself.
    JoinsItself {
        /// The link.
        link: String,
    },
    /// Second joint to the same child link: the first joint belongs to the tree, this one closes a loop.
    SecondParent {
        /// The link.
        link: String,
        /// Name of the first joint.
        first: String,
    },
    /// A radius of gyration beyond the size of the link.
    WideInertia {
        /// Mass, kg; that of all links for a link without mass.
        mass: f64,
        /// Largest radius of gyration, m.
        gyration: f64,
        /// Reach of the link or of the largest link, m.
        reach: f64,
        /// Whether it is so far out that it is an error.
        far: bool,
    },
    /// An inertia without a mass.
    InertiaWithoutMass {
        /// Largest principal moment, kg·m².
        moment: f64,
    },
    /// More mass than any material has at this radius of gyration.
    DenseInertia {
        /// Mass, kg.
        mass: f64,
        /// Largest radius of gyration, m.
        gyration: f64,
        /// Density of the sphere of that, kg/m³.
        density: f64,
    },
    /// A moment of inertia beyond that of any body with the mass inside the shapes of the link.
    InertiaBeyondShape {
        /// Mass, kg.
        mass: f64,
        /// Half trace of the inertia about the centre of mass, kg·m².
        half_trace: f64,
        /// Largest half trace of the mass in the convex hull of the shapes, kg·m².
        bound: f64,
    },
    /// A centre of mass outside the convex hull of the shapes of the link.
    ComBeyondShape {
        /// Least distance from the hull, m.
        distance: f64,
        /// Largest distance of the hull from its middle, m.
        size: f64,
    },
    /// No moving link with a mass.
    NoMovingMass,
    /// Equal inertias of links of different sizes.
    EqualInertias {
        /// Number of links with the same inertia.
        links: usize,
        /// Number of moving links with a mass.
        bodies: usize,
        /// Their mass, kg.
        mass: f64,
    },
    /// Second joint to the same child link that cannot be a closure, by its kind or its properties.
    NoClosure {
        /// The link.
        link: String,
        /// Name of the first joint.
        first: String,
        /// The reason.
        why: &'static str,
    },
    /// Closure, coupling or contact from a link to itself.
    ClosesOnItself {
        /// The link.
        link: String,
    },
    /// Distance closure with a length of 0 or less.
    BadDistance {
        /// Length, m.
        distance: f64,
    },
    /// Joint with more than one degree of freedom on the path of a coupling.
    CouplingKind {
        /// Name of the joint.
        joint: String,
        /// Kind of the joint.
        kind: &'static str,
    },
    /// Coupling of links without a movable joint between them, or of no movable joint.
    CouplingOfNothing,
    /// Relation of a joint that does not exist.
    UnknownJoint {
        /// Given name.
        joint: String,
        /// Similar names.
        near: Vec<String>,
    },
    /// Bush with an invalid number, or in place of joints that it cannot replace.
    BadBush {
        /// The reason.
        why: String,
    },
    /// Spring or elastic gear of a joint with an invalid number, or of a joint that cannot have one.
    BadSpring {
        /// The reason.
        why: &'static str,
    },
    /// Couplings that form a cycle.
    CouplingCycle {
        /// Links at the ends of the coupling that closes the cycle.
        links: [String; 2],
    },
    /// More than one link without a parent.
    SeveralRoots {
        /// Names of these links.
        roots: Vec<String>,
    },
    /// Links that are their own ancestors.
    Cycle {
        /// Names of the links, each the parent of the next.
        links: Vec<String>,
    },
    /// NaN or infinite number.
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Number too large for a length, mass or inertia in SI units.
    TooLarge {
        /// Name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Negative mass.
    NegativeMass {
        /// Mass, kg.
        mass: f64,
    },
    /// Zero axis of a joint that needs one.
    ZeroAxis,
    /// Axis that was normalised.
    AxisNotUnit {
        /// Given length.
        length: f64,
    },
    /// Rotation matrix that is not orthonormal.
    NotARotation {
        /// Largest entry of |RᵀR − 1|.
        defect: f64,
    },
    /// Inertia with a negative principal moment.
    IndefiniteInertia {
        /// Principal moments about the centre of mass, ascending, kg·m².
        principal: [f64; 3],
        /// True if the user accepted the inertia.
        accepted: bool,
    },
    /// Principal moment larger than the sum of the others, which is impossible for a rigid body.
    TriangleInequality {
        /// Principal moments about the centre of mass, ascending, kg·m².
        principal: [f64; 3],
    },
    /// Link without declared inertia.
    Massless,
    /// Negative armature.
    NegativeArmature {
        /// Its value.
        value: f64,
    },
    /// Number of armature values other than one or the number of velocities.
    ArmatureCount {
        /// Number of given values.
        got: usize,
        /// Number of velocities of the joint.
        dofs: usize,
    },
    /// Lower limit above the upper limit; both limits are ignored.
    LimitsReversed {
        /// Lower limit.
        lower: f64,
        /// Upper limit.
        upper: f64,
    },
    /// Mimic of a joint that does not exist; the joint moves freely.
    DanglingMimic {
        /// Given name of the master.
        master: String,
        /// Similar names.
        near: Vec<String>,
    },
    /// Mimic relation with a joint that has not one degree of freedom.
    MimicKind {
        /// Name of this joint.
        joint: String,
        /// Kind of this joint.
        kind: &'static str,
    },
    /// Joints that mimic each other in a cycle.
    MimicCycle {
        /// Names of the joints.
        joints: Vec<String>,
    },
}

impl Problem {
    /// Severity of the finding.
    pub fn severity(&self) -> Severity {
        match self {
            Problem::NoLinks
            | Problem::EmptyName
            | Problem::DuplicateName { .. }
            | Problem::UnknownLink { .. }
            | Problem::JoinsItself { .. }
            | Problem::NoClosure { .. }
            | Problem::ClosesOnItself { .. }
            | Problem::BadDistance { .. }
            | Problem::CouplingKind { .. }
            | Problem::CouplingOfNothing
            | Problem::UnknownJoint { .. }
            | Problem::BadBush { .. }
            | Problem::BadSpring { .. }
            | Problem::CouplingCycle { .. }
            | Problem::SeveralRoots { .. }
            | Problem::Cycle { .. }
            | Problem::NotFinite { .. }
            | Problem::TooLarge { .. }
            | Problem::NegativeMass { .. }
            | Problem::ZeroAxis
            | Problem::NotARotation { .. }
            | Problem::IndefiniteInertia { accepted: false, .. }
            | Problem::WideInertia { far: true, .. }
            | Problem::NegativeArmature { .. }
            | Problem::ArmatureCount { .. }
            | Problem::MimicKind { .. }
            | Problem::MimicCycle { .. } => Severity::Error,
            Problem::IndefiniteInertia { accepted: true, .. }
            | Problem::WideInertia { far: false, .. }
            | Problem::InertiaWithoutMass { .. }
            | Problem::DenseInertia { .. }
            | Problem::InertiaBeyondShape { .. }
            | Problem::ComBeyondShape { .. }
            | Problem::NoMovingMass
            | Problem::EqualInertias { .. }
            | Problem::TriangleInequality { .. }
            | Problem::LimitsReversed { .. }
            | Problem::DanglingMimic { .. } => Severity::Warning,
            Problem::AxisNotUnit { .. } | Problem::Massless | Problem::SecondParent { .. } => Severity::Note,
        }
    }

    /// Stable code for scripts.
    pub fn code(&self) -> &'static str {
        match self {
            Problem::NoLinks => "no-links",
            Problem::EmptyName => "empty-name",
            Problem::DuplicateName { .. } => "duplicate-name",
            Problem::UnknownLink { .. } => "unknown-link",
            Problem::JoinsItself { .. } => "joins-itself",
            Problem::SecondParent { .. } => "second-parent",
            Problem::NoClosure { .. } => "two-parents",
            Problem::ClosesOnItself { .. } => "closes-on-itself",
            Problem::BadDistance { .. } => "bad-distance",
            Problem::CouplingKind { .. } => "coupling-kind",
            Problem::CouplingOfNothing => "coupling-of-nothing",
            Problem::UnknownJoint { .. } => "unknown-joint",
            Problem::BadBush { .. } => "bad-bush",
            Problem::BadSpring { .. } => "bad-spring",
            Problem::CouplingCycle { .. } => "coupling-cycle",
            Problem::SeveralRoots { .. } => "several-roots",
            Problem::Cycle { .. } => "cycle",
            Problem::NotFinite { .. } => "not-finite",
            Problem::TooLarge { .. } => "too-large",
            Problem::NegativeMass { .. } => "negative-mass",
            Problem::ZeroAxis => "zero-axis",
            Problem::AxisNotUnit { .. } => "axis-not-unit",
            Problem::NotARotation { .. } => "not-a-rotation",
            Problem::IndefiniteInertia { .. } => "indefinite-inertia",
            Problem::WideInertia { .. }
            | Problem::InertiaWithoutMass { .. }
            | Problem::DenseInertia { .. }
            | Problem::InertiaBeyondShape { .. }
            | Problem::ComBeyondShape { .. } => "implausible-inertia",
            Problem::NoMovingMass => "no-moving-mass",
            Problem::EqualInertias { .. } => "equal-inertias",
            Problem::TriangleInequality { .. } => "triangle-inequality",
            Problem::Massless => "massless-link",
            Problem::NegativeArmature { .. } => "negative-armature",
            Problem::ArmatureCount { .. } => "armature-count",
            Problem::LimitsReversed { .. } => "limits-reversed",
            Problem::DanglingMimic { .. } => "dangling-mimic",
            Problem::MimicKind { .. } => "mimic-kind",
            Problem::MimicCycle { .. } => "mimic-cycle",
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Problem::NoLinks => f.write_str("no link: a mechanism has at least one"),
            Problem::EmptyName => f.write_str("the name is empty; every link and joint needs one"),
            Problem::DuplicateName { .. } => f.write_str("the name was given before; names must be unique"),
            Problem::UnknownLink { role, link, near } => {
                write!(f, "the {role} link \"{link}\" does not exist")?;
                write_near(f, near)
            }
            Problem::JoinsItself { link } => write!(f, "joins link \"{link}\" to itself"),
            Problem::SecondParent { link, first } => {
                write!(
                    f,
                    "link \"{link}\" is the child of joint \"{first}\" already; this joint closes a loop"
                )
            }
            Problem::NoClosure { link, first, why } => write!(
                f,
                "link \"{link}\" is the child of joint \"{first}\" already, and this joint cannot close a loop: {why}"
            ),
            Problem::ClosesOnItself { link } => write!(f, "holds link \"{link}\" to itself"),
            Problem::BadDistance { distance } => write!(
                f,
                "the distance is {distance} m; more than 0 is expected (for 0, use a spherical loop)"
            ),
            Problem::CouplingKind { joint, kind } => write!(
                f,
                "its joint \"{joint}\" is {kind}; a coupling needs joints with one degree of freedom"
            ),
            Problem::CouplingOfNothing => f.write_str("none of its joints can move"),
            Problem::UnknownJoint { joint, near } => {
                write!(f, "joint \"{joint}\" does not exist")?;
                write_near(f, near)
            }
            Problem::BadBush { why } => f.write_str(why),
            Problem::BadSpring { why } => f.write_str(why),
            Problem::CouplingCycle { links: [a, b] } => write!(
                f,
                "links \"{a}\" and \"{b}\" are coupled already, by way of other couplings: the ratios form a circle"
            ),
            Problem::SeveralRoots { roots } => {
                write!(f, "{} links have no parent, one is expected: ", roots.len())?;
                write_list(f, roots)?;
                f.write_str("; join the others to the root (a fixed joint holds them to it)")
            }
            Problem::Cycle { links } => {
                f.write_str("links are their own ancestors: ")?;
                write_list(f, links)?;
                f.write_str("; remove one joint of the circle, or make it a <loop>")
            }
            Problem::NotFinite { quantity, value } => {
                write!(f, "{quantity} is {value}; a finite number is expected")
            }
            Problem::TooLarge { quantity, value } => {
                write!(f, "{quantity} is {value:e}; more than 1e100 in SI units is not accepted")
            }
            Problem::NegativeMass { mass } => write!(f, "mass is {mass} kg; it must be 0 or more"),
            Problem::ZeroAxis => f.write_str("the axis is zero; it needs a direction, such as 0 0 1"),
            Problem::AxisNotUnit { length } => {
                write!(f, "the axis has length {length}; it was normalised")
            }
            Problem::NotARotation { defect } => {
                write!(f, "the origin's rotation matrix is off by {defect:.1e} from orthonormal")
            }
            Problem::IndefiniteInertia { principal, accepted } => {
                let [a, b, c] = principal;
                write!(
                    f,
                    "the inertia about the centre of mass has principal moments {a:.6e}, {b:.6e}, {c:.6e} kg·m²; \
                     with a negative one, a motion has negative energy"
                )?;
                if *accepted {
                    f.write_str(" (accepted)")
                } else {
                    f.write_str("; correct the file, or accept it with --accept indefinite-inertia")
                }
            }
            Problem::WideInertia { mass, gyration, reach, far } => {
                write!(
                    f,
                    "the inertia with a mass of {mass:.4e} kg has a radius of gyration of {gyration:.4e} m, {:.0} times the \
                     {reach:.4e} m that the links reach: expected kg·m² about the centre of mass, is it in kg·mm² or is the \
                     mass too small?",
                    gyration / reach
                )?;
                if *far {
                    f.write_str(" Correct the file, or accept it with --accept implausible-inertia")?;
                }
                Ok(())
            }
            Problem::InertiaWithoutMass { moment } => write!(
                f,
                "the mass is 0, but the inertia has a principal moment of {moment:.4e} kg·m²: no body has these. Give the \
                 mass; a rotor's inertia can be given as the armature of its joint"
            ),
            Problem::DenseInertia { mass, gyration, density } => write!(
                f,
                "the mass of {mass:.4e} kg with a radius of gyration of {gyration:.4e} m would have a density of {density:.0e} \
                 kg/m³: expected kg and kg·m², is the mass in grams, or the inertia in another unit? (A point mass has inertia 0; a sheet \
                 has inertia_unit)"
            ),
            Problem::InertiaBeyondShape { mass, half_trace, bound } => write!(
                f,
                "half the trace of the inertia about the centre of mass is {half_trace:.4e} kg·m², and a mass of {mass:.4e} kg inside the \
                 shapes of the link has at most {bound:.4e} kg·m²: correct the inertia, the mass or the shapes"
            ),
            Problem::ComBeyondShape { distance, size } => write!(
                f,
                "the centre of mass is {distance:.4e} m outside the shapes of the link, which extend {size:.4e} m from their middle: \
                 correct it or the shapes; it is in the link frame, in m"
            ),
            Problem::NoMovingMass => f.write_str(
                "no moving link has a mass: a file for display has no effective mass. Compute masses from the shapes (--masses \
                 shapes), give them (--link-mass LINK=KG, then --link-inertia), or give an <inertial> to every link",
            ),
            Problem::EqualInertias { links, bodies, mass } => write!(
                f,
                "{links} of {bodies} moving links have the same inertia and the same mass of {mass} kg, and different sizes: placeholders? \
                 Give the masses of the links (--link-mass LINK=KG, --link-inertia)"
            ),
            Problem::TriangleInequality { principal: [a, b, c] } => write!(
                f,
                "the principal moments {a:.6e}, {b:.6e}, {c:.6e} kg·m² break the triangle inequality: no rigid \
                 body has them ({a:.4e} + {b:.4e} < {c:.4e})"
            ),
            Problem::Massless => f.write_str("has no <inertial>: it is massless"),
            Problem::NegativeArmature { value } => write!(f, "armature is {value}; it must be 0 or more"),
            Problem::ArmatureCount { got, dofs } => {
                write!(f, "{got} armature values for {dofs} velocities; give one for each")
            }
            Problem::LimitsReversed { lower, upper } => {
                write!(f, "the lower limit {lower} is above the upper limit {upper}; both are ignored")
            }
            Problem::DanglingMimic { master, near } => {
                write!(f, "mimics joint \"{master}\", which does not exist; it moves freely")?;
                write_near(f, near)
            }
            Problem::MimicKind { joint, kind } => write!(
                f,
                "mimic needs joints with one degree of freedom (revolute, continuous, prismatic); \
                 \"{joint}\" is {kind}"
            ),
            Problem::MimicCycle { joints } => {
                f.write_str("joints mimic one another in a circle: ")?;
                write_list(f, joints)
            }
        }
    }
}

/// Writes `"a", "b", "c"`, at most eight names.
fn write_list(f: &mut fmt::Formatter<'_>, names: &[String]) -> fmt::Result {
    const SHOWN: usize = 8;
    for (i, name) in names.iter().take(SHOWN).enumerate() {
        write!(f, "{}\"{name}\"", if i == 0 { "" } else { ", " })?;
    }
    if names.len() > SHOWN { write!(f, " and {} more", names.len() - SHOWN) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lists_are_cut() {
        let roots: Vec<String> = (0..20).map(|i| format!("r{i}")).collect();
        let text = Problem::SeveralRoots { roots }.to_string();
        assert!(text.contains("20 links") && text.contains("and 12 more"), "{text}");
    }
}

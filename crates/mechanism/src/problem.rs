//! What validation can find, from errors to notes.

use crate::names::write_near;
use std::fmt;

/// How grave a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing; nothing is wrong.
    Note,
    /// Probably not what was meant; the answer uses what the message states.
    Warning,
    /// No mechanism comes of it.
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

/// What a finding is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The whole.
    Mechanism,
    /// The link given as number `index` (its name may be a duplicate).
    Link {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// The joint given as number `index`.
    Joint {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// The closure given as number `index`.
    Closure {
        /// Position in the order given.
        index: usize,
        /// Its name.
        name: String,
    },
    /// The coupling given as number `index`.
    Coupling {
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
        }
    }
}

/// A finding of the builder.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Problem {
    /// There is no link.
    NoLinks,
    /// A link or joint without a name.
    EmptyName,
    /// The name was given before.
    DuplicateName {
        /// Position, in the order given, of the first with this name.
        first: usize,
    },
    /// A joint names a link that does not exist.
    UnknownLink {
        /// `parent`, `child`, `predecessor` or `successor`.
        role: &'static str,
        /// The name.
        link: String,
        /// Similar names.
        near: Vec<String>,
    },
    /// A joint joins a link to itself.
    JoinsItself {
        /// The link.
        link: String,
    },
    /// A link is the child of two joints: the first is the tree's, this one closes a loop.
    SecondParent {
        /// The link.
        link: String,
        /// The joint that came first.
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
    /// A second parent through a joint that cannot close a loop, or that has what a closure cannot have.
    NoClosure {
        /// The link.
        link: String,
        /// The joint that came first.
        first: String,
        /// The reason.
        why: &'static str,
    },
    /// A closure or coupling between a link and itself.
    ClosesOnItself {
        /// The link.
        link: String,
    },
    /// A distance closure of length 0 or less.
    BadDistance {
        /// Its value, m.
        distance: f64,
    },
    /// A joint on a coupling's path has more than one degree of freedom.
    CouplingKind {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: &'static str,
    },
    /// No joint between the links of a coupling can move.
    CouplingOfNothing,
    /// Couplings that close a circle.
    CouplingCycle {
        /// The links at the ends of the coupling that closes it.
        links: [String; 2],
    },
    /// Several links have no parent.
    SeveralRoots {
        /// Their names.
        roots: Vec<String>,
    },
    /// Links that are their own ancestors.
    Cycle {
        /// Their names, each the parent of the next.
        links: Vec<String>,
    },
    /// A number is NaN or infinite.
    NotFinite {
        /// Which number.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is too large to be a length, mass or inertia in SI units, or its products would overflow.
    TooLarge {
        /// Which number.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Mass below zero.
    NegativeMass {
        /// Its value, kg.
        mass: f64,
    },
    /// The joint needs an axis and got a zero one.
    ZeroAxis,
    /// The axis was normalised.
    AxisNotUnit {
        /// Its length.
        length: f64,
    },
    /// A rotation matrix is not orthonormal.
    NotARotation {
        /// Largest entry of |RᵀR − 1|.
        defect: f64,
    },
    /// The inertia has a negative principal moment.
    IndefiniteInertia {
        /// Principal moments about the centre of mass, ascending, kg·m².
        principal: [f64; 3],
        /// Taken all the same, by the user's word.
        accepted: bool,
    },
    /// A principal moment exceeds the sum of the others: no body is like that.
    TriangleInequality {
        /// Principal moments about the centre of mass, ascending, kg·m².
        principal: [f64; 3],
    },
    /// No inertia was declared.
    Massless,
    /// Armature below zero.
    NegativeArmature {
        /// Its value.
        value: f64,
    },
    /// The number of armature values fits neither one nor the joint's velocities.
    ArmatureCount {
        /// How many were given.
        got: usize,
        /// How many velocities the joint has.
        dofs: usize,
    },
    /// Lower limit above the upper one; the limits are ignored.
    LimitsReversed {
        /// Lower limit.
        lower: f64,
        /// Upper limit.
        upper: f64,
    },
    /// The joint mimics one that does not exist; it moves freely.
    DanglingMimic {
        /// The name it gives.
        master: String,
        /// Similar names.
        near: Vec<String>,
    },
    /// Only joints with one degree of freedom can mimic or be mimicked.
    MimicKind {
        /// The joint of the wrong kind.
        joint: String,
        /// Its kind.
        kind: &'static str,
    },
    /// Joints that mimic one another in a circle.
    MimicCycle {
        /// Their names.
        joints: Vec<String>,
    },
}

impl Problem {
    /// How grave it is.
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
            | Problem::TriangleInequality { .. }
            | Problem::LimitsReversed { .. }
            | Problem::DanglingMimic { .. } => Severity::Warning,
            Problem::AxisNotUnit { .. } | Problem::Massless | Problem::SecondParent { .. } => Severity::Note,
        }
    }

    /// A short name that scripts can rely on.
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
            | Problem::DenseInertia { .. } => "implausible-inertia",
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
                "joint \"{joint}\" on its path is {kind}; a coupling needs joints with one degree of freedom"
            ),
            Problem::CouplingOfNothing => f.write_str("no joint between its links can move"),
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
                 kg/m³: expected kg and kg·m², is the mass in grams? (A point mass has inertia 0)"
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

/// `"a", "b", "c"`, cut short after eight.
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

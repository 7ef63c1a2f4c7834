//! Armatures of joints in a `<transmission>`, in the `<actuator>` of a joint and in a `<gazebo>`; removal of armatures from fixed joints.

use crate::reading::findings::did_you_mean;
use crate::reading::limits::ARMATURE_TOLERANCE;
use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::{Node, text_of};
use crate::urdf::elements::joints::armature;
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::survey::{child, children};
use crate::urdf::references::Suggestions;
use percuss_mechanism::{JointKind, Severity};
use std::collections::HashMap;

/// Elements and attributes with the inertia of a rotor, kg·m².
const INERTIAS: [&str; 4] = ["motorInertia", "motor_inertia", "rotorInertia", "rotor_inertia"];

/// Elements and attributes with the rate of a rotor over that of its joint.
const RATIOS: [&str; 5] =
    ["mechanicalReduction", "mechanical_reduction", "gearRatio", "gear_ratio", "drake:gear_ratio"];

const REMEDY: &str =
    "give the reflected inertia I·N² as <dynamics armature=\"...\"/> of the joint, or by --armature";

/// Adds the armatures given outside the `<dynamics>` to their joints.
pub(crate) fn add_transmission_armatures<'a>(
    robot: Node<'a>,
    joints: &mut [JointText<'a>],
    nodes: &[Node<'a>],
    index: &HashMap<&'a str, usize>,
    suggestions: &mut Suggestions,
    report: &mut Report,
) {
    let mut rotors = Rotors { joints, index, suggestions, actuators: HashMap::new() };
    let of_control = children(robot, "ros2_control").flat_map(|control| children(control, "transmission"));
    for transmission in children(robot, "transmission").chain(of_control) {
        rotors.read_transmission(transmission, report);
    }
    for (joint, node) in nodes.iter().enumerate() {
        for actuator in children(*node, "actuator").filter(|actuator| !has_drake_rotor(*actuator)) {
            rotors.read_rotor(actuator, &[actuator], joint, report);
        }
    }
    let armatures = |gazebo| children(gazebo, "armature").map(move |element| (gazebo, element));
    for (gazebo, element) in children(robot, "gazebo").flat_map(armatures) {
        let joint = gazebo.attribute("reference").and_then(|name| index.get(name.trim_ascii()));
        let text = element.attribute("value").or_else(|| text_of(element)).unwrap_or_default();
        match (joint, parse_numbers::<1>(text)) {
            (Some(joint), Ok([value])) if value >= 0.0 => rotors.set(*joint, value, element, report),
            _ => report.warning("rotor-inertia", Place::Element(element), || {
                format!("{} is no armature of a joint of the robot; ignored: {REMEDY}", quoted(text))
            }),
        }
    }
}

/// Reader of rotor inertias.
struct Rotors<'t, 'a> {
    joints: &'t mut [JointText<'a>],
    index: &'t HashMap<&'a str, usize>,
    suggestions: &'t mut Suggestions,
    /// Actuator from which the armature of a joint comes.
    actuators: HashMap<usize, &'a str>,
}

impl<'a> Rotors<'_, 'a> {
    fn read_transmission(&mut self, transmission: Node<'a>, report: &mut Report) {
        let driven: Vec<Node<'a>> = children(transmission, "joint").collect();
        let actuators: Vec<Node<'a>> = children(transmission, "actuator").collect();
        let mut found = Vec::new();
        for joint in &driven {
            let name = joint.attribute("name").unwrap_or_default();
            match self.index.get(name.trim_ascii()) {
                Some(i) => found.push(*i),
                None => {
                    let near = self.suggestions.similar_names(name, self.joints.iter().map(|j| j.name));
                    let guess = did_you_mean(&near);
                    let place = Place::Element(*joint);
                    report.add_once(Severity::Warning, "dangling-armature", String::new(), place, || {
                        format!(
                            "the transmission is for joint {}, which does not exist{guess}; its rotor \
                             inertia, if any, is ignored",
                            quoted(name)
                        )
                    });
                }
            }
        }
        let kind =
            ["type", "plugin"].map(|tag| child(transmission, tag).and_then(text_of).unwrap_or_default());
        let kind = format!("{} {}", kind.join(" "), transmission.attribute("type").unwrap_or_default());
        let holders: Vec<_> = std::iter::once(transmission).chain(driven.clone()).chain(actuators).collect();
        let has_drake = holders.iter().any(|holder| has_drake_rotor(*holder));
        let has_inertia = || {
            has_drake
                || holders.iter().any(|holder| INERTIAS.iter().any(|tag| !values(*holder, tag).is_empty()))
        };
        let couples = ["Differential", "FourBar"].iter().any(|word| kind.contains(word));
        if couples || (driven.len() != 1 && has_inertia()) {
            let severity = if has_inertia() { Severity::Warning } else { Severity::Note };
            report.add_once(severity, "rotor-inertia", kind, Place::Element(transmission), || {
                format!(
                    "this <transmission> does not drive one joint alone; the inertias of its rotors are \
                     not read, and the answer is \
                     without them: {REMEDY}, or write the rotors as links with a <relation> of their joints"
                )
            });
            return;
        }
        let [joint] = found[..] else { return };
        for holder in &holders {
            if let Some(value) = armature::reflected_inertia(*holder, report) {
                armature::merge_armature(&mut self.joints[joint].armature, value, *holder, report);
            }
        }
        if !has_drake {
            self.read_rotor(transmission, &holders, joint, report);
        }
    }

    /// Reads the inertia and the ratio of the rotor that drives a joint, from one of the elements.
    fn read_rotor(&mut self, place: Node<'a>, holders: &[Node<'a>], joint: usize, report: &mut Report) {
        let read = |tags: &[&'static str]| -> Vec<&'a str> {
            holders.iter().flat_map(|holder| tags.iter().flat_map(|tag| values(*holder, tag))).collect()
        };
        let (inertias, ratios) = (read(&INERTIAS), read(&RATIOS));
        let ratio = single_number(&ratios, 1.0);
        let (name, at) = (self.joints[joint].name, Place::Element(place));
        match (single_number(&inertias, 0.0), ratio) {
            (Some(0.0), Some(ratio)) => {
                if ratio.abs() > 1.0
                    && self.joints[joint].armature.is_empty()
                    && self.joints[joint].kind.dofs() > 0
                {
                    report.add_once(Severity::Note, "gear-without-rotor", String::new(), at, || {
                        format!(
                            "joint {} has a gear ratio of {ratio}, and no inertia of its rotor: the \
                             reflected inertia I·N² is missing, which is often the largest part of the effective mass \
                             of a geared arm: {REMEDY}",
                            quoted(name)
                        )
                    });
                }
            }
            (Some(inertia), Some(ratio)) if inertia > 0.0 && ratio != 0.0 => {
                if ratios.is_empty() {
                    report.add_once(Severity::Note, "default-gear", String::new(), at, || {
                        "a rotor inertia without <mechanicalReduction>: the ratio is taken as 1".to_owned()
                    });
                }
                let actuator = holders
                    .iter()
                    .filter(|n| n.tag_name().name() == "actuator")
                    .find_map(|n| n.attribute("name"));
                let actuator = actuator.unwrap_or_default();
                let is_further = |n: &&Node<'a>| {
                    n.tag_name().name() == "actuator"
                        && n.attribute("name").unwrap_or_default() != actuator
                        && INERTIAS.iter().any(|tag| !values(**n, tag).is_empty())
                };
                let is_second = self.actuators.insert(joint, actuator).is_some_and(|first| first != actuator);
                if is_second || holders.iter().any(|holder| is_further(&holder)) {
                    report.warning("rotor-inertia", at, || {
                        format!(
                            "a second motor of joint {}: only the inertia of the first is read; {REMEDY}",
                            quoted(name)
                        )
                    });
                }
                if is_second {
                    return;
                }
                self.set(joint, inertia * ratio * ratio, place, report);
            }
            _ => report.warning("rotor-inertia", at, || {
                format!(
                    "the rotor of joint {} is not read, and the answer is without it: inertia {}, ratio \
                     {}; one positive inertia in kg·m² \
                     and one ratio are expected; {REMEDY}",
                    quoted(name),
                    quoted(&inertias.join(", ")),
                    quoted(&ratios.join(", "))
                )
            }),
        }
    }

    /// Sets the armature of a joint without one; a different value of a joint that has one is ignored with a warning.
    fn set(&mut self, joint: usize, value: f64, place: Node<'_>, report: &mut Report) {
        let joint = &mut self.joints[joint];
        match joint.armature[..] {
            [] if joint.kind.dofs() == 1 => {
                report.note("rotor-inertia", Place::Element(place), || {
                    let unit = if joint.kind == JointKind::Prismatic { "kg" } else { "kg·m²" };
                    format!("read as an armature of {value} {unit} of joint {}", quoted(joint.name))
                });
                joint.armature.push(value);
            }
            [given] if (given - value).abs() <= ARMATURE_TOLERANCE * given.abs().max(value) => {}
            _ => report.warning("rotor-inertia", Place::Element(place), || {
                format!(
                    "an armature of {value} for joint {} is ignored: it has {:?} already, or not one \
                     degree of freedom",
                    quoted(joint.name),
                    joint.armature
                )
            }),
        }
    }
}

/// True for an element with a rotor inertia of Drake, which `armature.rs` reads.
fn has_drake_rotor(actuator: Node<'_>) -> bool {
    child(actuator, "drake:rotor_inertia").is_some()
}

/// Texts of the child elements and of the attribute with a name: the text of an element, or its attribute `value`.
fn values<'a>(holder: Node<'a>, tag: &'static str) -> Vec<&'a str> {
    let elements =
        children(holder, tag).map(|n| n.attribute("value").or_else(|| text_of(n)).unwrap_or_default());
    elements.chain(holder.attribute(tag)).map(str::trim_ascii).collect()
}

/// The number that all texts state; `default` without texts, and `None` for a text that is no number and for different numbers.
fn single_number(texts: &[&str], default: f64) -> Option<f64> {
    let numbers: Option<Vec<f64>> =
        texts.iter().map(|text| parse_numbers::<1>(text).ok().map(|[value]| value)).collect();
    let numbers = numbers?;
    let first = numbers.first().copied().unwrap_or(default);
    numbers.iter().all(|number| *number == first).then_some(first)
}

/// Drops the armature of a fixed joint, which has no velocity.
pub(crate) fn drop_fixed_joint_armature(joint: &mut JointText<'_>, node: Node<'_>, report: &mut Report) {
    if joint.kind == JointKind::Fixed && !joint.armature.is_empty() {
        if joint.armature.iter().any(|a| *a != 0.0) {
            report.warning("fixed-armature", Place::Element(node), || {
                "the joint is fixed; its armature is ignored".to_owned()
            });
        }
        joint.armature.clear();
    }
}

//! Plugins of simulators that join links or couple joints. A plugin is a program: its names and its elements are all that a file states.

use crate::reading::limits::MAX_PLUGIN_NAMES;
use crate::reading::report::{quoted, shortened};

/// Parts of the names of plugins, and of their elements, that join links or couple joints; separated by blanks, as in the other lists.
const JOINING: &str = "mimic detach attach disablelink closedloop closeloop loopclos loopjoint weld constraint coupl \
    gearbox linkage fourbar";

/// The same for parts that occur in the names of sensors and controllers too.
const PERHAPS_JOINING: &str = "loop differential parallel gear pulley belt rackpinion rackandpinion tendon cable rope slave follow \
    synchron jointsync syncjoint lockjoint jointlock fixedjoint fixjoint jointfix rigid glue suction harness underactuated";

/// Parts of the names of elements of plugins that couple joints, also in a plugin with the name of a sensor or controller.
const COUPLING_ELEMENTS: &str = "mimic slave follower driven multiplier";

/// Parts of the names of plugins that measure, publish, control or exert finite forces.
const HARMLESS: &str = "control sensor camera imu laser lidar gpuray raysensor sonar gps navsat magnetometer altimeter \
    barometer depth contact bumper forcetorque p3d f3d groundtruth diffdrive differentialdrive \
    skidsteer tricycle ackermann steering mecanum planarmove wheelslip track publish jointstate odom \
    trajectory thrust motormodel multicopter buoyan hydrodynam liftdrag grasp vacuum";

/// Names of elements that name the two ends of a connection.
const ENDS: [[&str; 2]; 7] = [
    ["parent", "child"],
    ["parentlink", "childlink"],
    ["link1", "link2"],
    ["joint1", "joint2"],
    ["linka", "linkb"],
    ["jointa", "jointb"],
    ["leader", "follower"],
];

/// Parts of names that state an inertia or a coupling of a joint in every format.
const OF_JOINTS: [&str; 2] = ["armature", "mimic"];

/// Parts of names that state, with a number, an inertia or a mass beyond those of the links.
const INERTIAS: [&str; 6] = ["inertia", "rotormass", "motormass", "reflectedmass", "addedmass", "payload"];

/// Elements that state a parameter by the name or key in an attribute.
const KEYED: [&str; 9] =
    ["param", "parameter", "property", "numeric", "config", "entry", "argument", "setting", "option"];

/// True for a name with a value that changes the mass matrix, or couples joints, in a part that is not read. `in_plugin`: couplings of
/// plugins have warnings of their own.
pub(crate) fn changes_joint(name: &str, value: &str, in_plugin: bool) -> bool {
    let word = plain_word(name);
    let has = |part: &&'static str| word.contains(*part);
    let numbers =
        || value.split([' ', ',', '\t', '\n']).filter_map(|number| number.trim_ascii().parse::<f64>().ok());
    if numbers().any(|number| number != 0.0) && INERTIAS.iter().any(has) {
        return true;
    }
    let is_zero = value.trim_ascii().parse::<f64>().is_ok_and(|number| number == 0.0);
    !is_zero && OF_JOINTS.iter().any(|part| has(part) && !(in_plugin && *part == "mimic"))
}

/// Name and value of an element that states a parameter by a name or a key; `None` for other elements.
pub(crate) fn keyed_value<'a>(
    tag: &str,
    attribute: impl Fn(&'static str) -> Option<&'a str>,
    text: &'a str,
) -> Option<(&'a str, &'a str)> {
    let key = ["name", "key"].into_iter().find_map(&attribute).filter(|_| KEYED.contains(&tag))?;
    Some((key, ["value", "data"].into_iter().find_map(&attribute).unwrap_or(text)))
}

/// Message about such a name.
pub(crate) fn unread_joint_message(name: &str, holder: &str) -> String {
    format!(
        "{} in <{}> is not read, and the answer is without it: give the inertia of a rotor as an armature of its joint, a mass in the \
         <inertial> of its link, and a coupling as a mimic of its joint",
        quoted(name),
        shortened(holder)
    )
}

/// Letters and digits in lower case, without separators.
pub(crate) fn plain_word(text: &str) -> String {
    text.chars().filter(char::is_ascii_alphanumeric).map(|c| c.to_ascii_lowercase()).collect()
}

/// True if a plugin joins links or couples joints, by its name and file name, by the names of its elements, or because it names two links
/// or two joints of the model. `values`: name and text of every element and attribute below the plugin; `is_known`: true for a link, and
/// for a joint, of this name.
pub(crate) fn joins_links<'a>(
    name: &str,
    values: &[(&'a str, &'a str)],
    is_known: impl Fn(&str) -> [bool; 2],
) -> bool {
    let word = plain_word(name);
    let contains = |word: &str, parts: &str| parts.split_ascii_whitespace().any(|part| word.contains(part));
    let has = |parts: &str| contains(&word, parts);
    let tags: Vec<String> = values.iter().map(|(tag, _)| plain_word(tag)).collect();
    let has_element = |parts: &str| tags.iter().any(|tag| contains(tag, parts));
    if has(JOINING) || has_element(COUPLING_ELEMENTS) {
        return true;
    }
    if has(HARMLESS) {
        return false;
    }
    let has_ends = |ends: &[&str; 2]| ends.iter().all(|end| tags.iter().any(|tag| tag == end));
    has(PERHAPS_JOINING) || has_element(JOINING) || ENDS.iter().any(has_ends) || {
        let [links, joints] = named_parts(values, is_known);
        links.len() > 1 || joints.len() > 1
    }
}

/// Distinct links, and distinct joints, that the elements of a plugin name. Frames in which a sensor measures are left out.
pub(crate) fn named_parts<'a>(
    values: &[(&'a str, &'a str)],
    is_known: impl Fn(&str) -> [bool; 2],
) -> [Vec<&'a str>; 2] {
    let mut found = [Vec::new(), Vec::new()];
    for (tag, text) in values {
        let tag = plain_word(tag);
        if tag.contains("frame") || tag.contains("topic") {
            continue;
        }
        // A name may have marks of punctuation: the words and their parts are compared.
        let words = text.split(|c: char| c.is_ascii_whitespace() || c == ',');
        let parts = |word: &'a str| word.split(|c: char| ";:=/|()[]{}<>\"'".contains(c));
        for name in words.flat_map(|word| std::iter::once(word).chain(parts(word))) {
            for (names, is_known) in found.iter_mut().zip(is_known(name)) {
                if is_known && names.len() < MAX_PLUGIN_NAMES && !names.contains(&name) {
                    names.push(name);
                }
            }
        }
    }
    found
}

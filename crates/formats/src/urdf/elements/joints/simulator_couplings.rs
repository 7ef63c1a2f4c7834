//! Loops and couplings in elements for simulators: plugins of Gazebo, mimics in `<gazebo>`, and parameters of ros2_control.
//!
//! A mimic with clear numbers is read as the `<mimic>` of its joint. Every other connection is warned about, unless a loop, coupling, relation
//! or mimic of the file holds the same links or joints.

use crate::reading::limits::{MAX_COUPLING_SEARCHES, MAX_MIMIC_CHAIN, MIMIC_TOLERANCE};
use crate::reading::plugins::{
    changes_joint, joins_links, keyed_value, named_parts, plain_word, unread_joint_message,
};
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::reading::xml::{Node, text_of};
use crate::urdf::elements::joints::joint::MimicText;
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::survey::{child, children, is_named};
use crate::urdf::texts::Texts;
use percuss_mechanism::Severity;
use std::cell::Cell;
use std::collections::{HashMap, HashSet};

/// Reads mimics outside the joints, and warns about other loops and couplings. `index`: joints by name; `has_loops`: loops or second
/// parents hold the links.
pub(crate) fn read_couplings<'a>(
    robot: Node<'a>,
    texts: &mut Texts<'a>,
    index: &HashMap<&'a str, usize>,
    has_loops: bool,
    report: &mut Report,
) {
    let links: HashSet<&str> = texts.links.iter().map(|link| link.name).collect();
    let is_known = |name: &str| [links.contains(name), index.contains_key(name)];
    let mut reader = CouplingReader { texts, index, has_loops, searches: Cell::new(MAX_COUPLING_SEARCHES) };
    for gazebo in robot.descendants().filter(|node| is_named(*node, "gazebo")) {
        let own_mimic =
            children(gazebo, "mimic").chain(children(gazebo, "axis").filter_map(|n| child(n, "mimic")));
        for mimic in own_mimic {
            reader.add(
                mimic,
                gazebo.attribute("reference"),
                leader_of_mimic(mimic),
                numbers_of_mimic(mimic),
                report,
            );
        }
    }
    let in_gazebo = |plugin: &Node<'a>| {
        let holder = |node: &Node<'a>| is_named(*node, "sensor") || is_named(*node, "gazebo");
        is_named(*plugin, "plugin")
            && plugin.ancestors().find(holder).is_some_and(|holder| is_named(holder, "gazebo"))
    };
    for plugin in robot.descendants().filter(in_gazebo) {
        reader.read_plugin(plugin, is_known, report);
    }
    for joint in children(robot, "ros2_control").flat_map(|control| children(control, "joint")) {
        reader.read_controlled_joint(joint, report);
    }
}

/// Multiplier and offset; `None` if one of them is no number.
type Numbers = Option<[f64; 2]>;

/// Reader of connections that adds mimics to the joints.
struct CouplingReader<'t, 'a> {
    texts: &'t mut Texts<'a>,
    index: &'t HashMap<&'a str, usize>,
    has_loops: bool,
    /// Number of searches still allowed: each visits all joints and loops.
    searches: Cell<usize>,
}

impl<'a> CouplingReader<'_, 'a> {
    /// Reads a mimic plugin, or warns about a plugin that joins links.
    fn read_plugin(
        &mut self,
        plugin: Node<'a>,
        is_known: impl Fn(&str) -> [bool; 2] + Copy,
        report: &mut Report,
    ) {
        let name = ["name", "filename"].map(|name| plugin.attribute(name).unwrap_or_default()).join(" ");
        let below = plugin.descendants().skip(1).filter(Node::is_element);
        let values: Vec<(&str, &str)> = below
            .flat_map(|node| {
                let tag = node.tag_name().name();
                let text = text_of(node);
                let keyed = keyed_value(tag, |name| node.attribute(name), text.unwrap_or_default());
                node.attributes()
                    .map(|a| (a.name(), a.value()))
                    .chain(text.map(|text| (tag, text)))
                    .chain(keyed)
                    .chain([(tag, "")])
            })
            .collect();
        let value = |wanted: &[&str]| {
            let mut found = values.iter().filter(|(tag, _)| wanted.contains(&plain_word(tag).as_str()));
            found.next().map(|(_, text)| text.trim_ascii())
        };
        let [leader, follower] = [value(&["joint", "leaderjoint"]), value(&["mimicjoint", "followerjoint"])];
        if plain_word(&name).contains("mimic") && leader.is_some() && follower.is_some() {
            let numbers = both(value(&["multiplier"]).unwrap_or("1"), value(&["offset"]).unwrap_or("0"));
            self.add(plugin, follower, leader, numbers, report);
        } else if joins_links(&name, &values, is_known) && !self.is_held(&named_parts(&values, is_known)) {
            let shown = plugin.attribute("name").or_else(|| plugin.attribute("filename")).unwrap_or_default();
            report.add_once(Severity::Warning, "plugin", shown.to_owned(), Place::Element(plugin), || {
                format!(
                    "plugins are not read, and {} joins links or couples joints, by its name or its \
                     elements: the loop or coupling is \
                     missing here. Write a <loop> (a joint that closes a loop) or a <mimic> for it",
                    quoted(shown)
                )
            });
        }
    }

    /// True if a loop joins two of the links, or a coupling, relation or mimic two of the joints.
    fn is_held(&self, [links, joints]: &[Vec<&str>; 2]) -> bool {
        let Some(remaining) = self.searches.get().checked_sub(1) else { return false };
        self.searches.set(remaining);
        let texts = &self.texts;
        let both_links = |a: &str, b: &str| links.contains(&a) && links.contains(&b);
        texts.closures.iter().any(|c| both_links(&c.predecessor, &c.successor))
            || texts.couplings.iter().any(|c| both_links(&c.predecessor, &c.successor))
            || texts
                .relations
                .iter()
                .any(|r| r.terms.iter().filter(|(name, _)| joints.contains(&name.as_str())).count() > 1)
            || texts.joints.iter().any(|joint| {
                joints.contains(&joint.name)
                    && joint.mimic.as_ref().is_some_and(|mimic| joints.contains(&mimic.joint))
            })
    }

    /// Reads the parameters of a mimic in the `<joint>` of a `<ros2_control>`.
    fn read_controlled_joint(&mut self, joint: Node<'a>, report: &mut Report) {
        let name = joint.attribute("name");
        let parameter = |wanted: &str| {
            let mut found = children(joint, "param").filter(|p| p.attribute("name") == Some(wanted));
            found.next().map(|p| text_of(p).unwrap_or_default().trim_ascii())
        };
        let leader = parameter("mimic").or_else(|| parameter("mimic_joint"));
        Self::warn_unread_parameters(joint, leader.is_some(), report);
        if let Some(leader) = leader {
            let numbers = both(parameter("multiplier").unwrap_or("1"), parameter("offset").unwrap_or("0"));
            self.add(joint, name, Some(leader), numbers, report);
        } else if let Some(mimic) = child(joint, "mimic") {
            self.add(mimic, name, leader_of_mimic(mimic), numbers_of_mimic(mimic), report);
        } else if let Some(flag) = joint.attribute("mimic") {
            let of_joint =
                name.and_then(|name| self.index.get(name)).and_then(|i| self.texts.joints[*i].mimic.as_ref());
            let wanted = !["false", "0", "no"].contains(&&*flag.trim_ascii().to_ascii_lowercase());
            if wanted != of_joint.is_some() {
                let (has, needed) = if wanted { ("no", "write") } else { ("a", "remove") };
                report.warning("plugin", Place::Element(joint), || {
                    format!(
                        "mimic={}, and joint {} has {has} <mimic>, which alone counts here: {needed} the \
                         <mimic> of the joint",
                        quoted(flag),
                        quoted(name.unwrap_or_default())
                    )
                });
            }
        }
    }

    /// Warns about parameters of a joint that are not read and change the mass matrix; `is_mimic`: its mimic is read.
    fn warn_unread_parameters(joint: Node<'a>, is_mimic: bool, report: &mut Report) {
        let couples = |name: &str| {
            let word = plain_word(name);
            ["multiplier", "follow", "leader"].iter().any(|part| word.contains(part))
        };
        for param in children(joint, "param") {
            let (name, text) =
                (param.attribute("name").unwrap_or_default(), text_of(param).unwrap_or_default());
            let is_read = is_mimic && ["mimic", "mimic_joint", "multiplier", "offset"].contains(&name);
            if !is_read && (changes_joint(name, text, false) || couples(name)) {
                report.warning("ignored", Place::Element(param), || unread_joint_message(name, "joint"));
            }
        }
    }

    /// Adds a mimic to its joint. Silent if the file states the same relation elsewhere; a warning if it cannot be added.
    fn add(
        &mut self,
        place: Node<'a>,
        follower: Option<&'a str>,
        leader: Option<&'a str>,
        numbers: Numbers,
        report: &mut Report,
    ) {
        let [follower, leader] = [follower, leader].map(|name| name.unwrap_or_default().trim_ascii());
        match self.resolve(follower, leader, numbers) {
            Ok(Some(mimic)) => {
                report.note("plugin", Place::Element(place), || {
                    format!(
                        "read as <mimic joint={} multiplier=\"{}\" offset=\"{}\"/> of joint {}",
                        quoted(mimic.joint),
                        mimic.multiplier,
                        mimic.offset,
                        quoted(follower)
                    )
                });
                self.texts.joints[self.index[follower]].mimic = Some(mimic);
            }
            Ok(None) => {}
            Err(reason) => report.warning("plugin", Place::Element(place), || {
                format!(
                    "the coupling of joint {} to joint {} is not read: {reason}. Write it as <mimic \
                     joint=\"...\" multiplier=\"...\" \
                     offset=\"...\"/> of the joint, or remove it here",
                    quoted(follower),
                    quoted(leader)
                )
            }),
        }
    }

    /// Mimic to be added; `None` if the file holds the relation already. The error is the reason why it cannot be added.
    fn resolve(
        &self,
        follower: &str,
        leader: &str,
        numbers: Numbers,
    ) -> Result<Option<MimicText<'a>>, String> {
        let [multiplier, offset] = numbers.ok_or("its multiplier or its offset is no number")?;
        let find = |name: &str| {
            let joint =
                self.index.get(name).ok_or_else(|| format!("joint {} does not exist", quoted(name)))?;
            match self.texts.joints[*joint].kind.dofs() {
                1 => Ok(*joint),
                _ => Err(format!("joint {} does not have one degree of freedom", shortened(name))),
            }
        };
        let (follower, leader) = (find(follower)?, find(leader)?);
        let too_long = || "the mimics of its joints form a circle or a long chain".to_owned();
        // Position of a joint: (r, a, b) for a·q + b of joint r, which is no mimic.
        let (root, factor, constant) = self.root(follower).ok_or_else(too_long)?;
        let (own_root, own_factor, own_constant) = self.root(leader).ok_or_else(too_long)?;
        let (own_factor, own_constant) = (multiplier * own_factor, multiplier * own_constant + offset);
        let is_near = |a: f64, b: f64| (a - b).abs() <= MIMIC_TOLERANCE * a.abs().max(b.abs()).max(1.0);
        if root == own_root {
            return if is_near(factor, own_factor) && is_near(constant, own_constant) {
                Ok(None)
            } else {
                Err("the <mimic> elements state another ratio or offset, which counts".to_owned())
            };
        }
        let names = [follower, leader].map(|joint| self.texts.joints[joint].name);
        if self.is_held(&[Vec::new(), names.to_vec()]) {
            return Ok(None);
        }
        if self.has_loops {
            return Err("the file has loops, which may hold the joint too".to_owned());
        }
        if root != follower {
            return Err("the joint has a <mimic> of another joint".to_owned());
        }
        Ok(Some(MimicText { joint: names[1], multiplier, offset }))
    }

    /// The joint at the end of a chain of mimics, and the multiplier and offset to it; `None` for a long chain.
    fn root(&self, joint: usize) -> Option<(usize, f64, f64)> {
        let (mut at, mut factor, mut constant) = (joint, 1.0, 0.0);
        for _ in 0..MAX_MIMIC_CHAIN {
            let Some(mimic) = &self.texts.joints[at].mimic else { return Some((at, factor, constant)) };
            at = *self.index.get(mimic.joint)?;
            (factor, constant) = (factor * mimic.multiplier, factor * mimic.offset + constant);
        }
        None
    }
}

/// Joint that a `<mimic>` follows: an attribute or an element.
fn leader_of_mimic<'a>(mimic: Node<'a>) -> Option<&'a str> {
    mimic.attribute("joint").or_else(|| child(mimic, "joint").and_then(text_of))
}

/// Multiplier and offset of an SDF `<mimic>`: elements or attributes. SDF: q = multiplier·(leader − reference) + offset.
fn numbers_of_mimic(mimic: Node<'_>) -> Numbers {
    let value = |name: &'static str, default| {
        mimic.attribute(name).or_else(|| child(mimic, name).and_then(text_of)).unwrap_or(default)
    };
    let [multiplier, offset] = both(value("multiplier", "1"), value("offset", "0"))?;
    let [reference] = parse_numbers(value("reference", "0")).ok()?;
    Some([multiplier, offset - multiplier * reference])
}

fn both(multiplier: &str, offset: &str) -> Numbers {
    let ([multiplier], [offset]) = (parse_numbers(multiplier).ok()?, parse_numbers(offset).ok()?);
    Some([multiplier, offset])
}

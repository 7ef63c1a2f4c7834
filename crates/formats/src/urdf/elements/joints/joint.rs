//! Parser of `<joint>`: kind, links, origin, axis, limits, armature, mimic, spring; and of `<elastic>`.

use crate::parts::{SPRING_LEFT_OUT, joint_spring};
use crate::reading::findings::did_you_mean;
use crate::reading::limits::UNLIMITED;
use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::Node;
use crate::urdf::elements::joints::armature;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{
    optional_numbers, parse_numbers, report_missing_attribute, required_number, required_numbers,
};
use crate::urdf::elements::origin::{self, Origin};
use crate::urdf::elements::survey::child;
use percuss_mechanism::{
    ElasticGear, JointDescription, JointKind, Limits, MimicDescription, Severity, SpringDamper, near_names,
};
use percuss_spatial::Vector3;

/// Checked `<joint>`: every number is valid.
pub(crate) struct JointText<'a> {
    pub name: &'a str,
    pub kind: JointKind,
    pub parent: &'a str,
    pub child: &'a str,
    pub origin: Origin,
    pub axis: Vector3<f64>,
    /// rad or m.
    pub limits: Option<Limits>,
    /// Largest rate, rad/s or m/s. `None` if missing, not positive, or not a finite number; rate limits do not affect effective masses.
    pub rate_limit: Option<f64>,
    /// Empty, one value, or one value per velocity; kg·m² or kg.
    pub armature: Vec<f64>,
    pub mimic: Option<MimicText<'a>>,
    /// Recommended role: `true` to drive the mechanism, `false` to follow; `None` without a recommendation.
    pub independent: Option<bool>,
    /// Spring and damper parallel to the motion.
    pub spring: Option<SpringDamper>,
    /// Elasticity of the gear: `<elastic>` of the robot.
    pub gear: Option<ElasticGear>,
}

impl JointText<'_> {
    /// Description for the builder.
    pub fn description(&self) -> JointDescription {
        let mimic = self.mimic.as_ref().map(|text| MimicDescription {
            joint: text.joint.to_owned(),
            multiplier: text.multiplier,
            offset: text.offset,
        });
        JointDescription {
            name: self.name.to_owned(),
            kind: self.kind,
            parent: self.parent.to_owned(),
            child: self.child.to_owned(),
            origin: self.origin.transform,
            axis: self.axis,
            limits: self.limits,
            rate_limit: self.rate_limit,
            armature: self.armature.clone(),
            mimic,
            independent: self.independent,
            spring: self.spring,
            gear: self.gear,
        }
    }
}

/// Checked `<mimic>`.
pub(crate) struct MimicText<'a> {
    pub joint: &'a str,
    pub multiplier: f64,
    /// rad or m.
    pub offset: f64,
}

/// Default axis of URDF.
const DEFAULT_AXIS: [f64; 3] = [1.0, 0.0, 0.0];

pub(crate) fn read_joint<'a>(node: Node<'a>, report: &mut Report) -> JointText<'a> {
    let name = read_name(node, report);
    let kind = read_joint_type(node, report);
    JointText {
        name,
        kind: kind.unwrap_or(JointKind::Fixed),
        parent: read_link_name(node, "parent", report),
        child: read_link_name(node, "child", report),
        origin: origin::read_origin(node, report),
        axis: read_axis(node, kind, report).into(),
        limits: read_limits(node, kind, report),
        rate_limit: child(node, "limit")
            .and_then(|limit| limit.attribute("velocity")?.trim_ascii().parse().ok())
            .filter(|rate: &f64| rate.is_finite() && *rate > 0.0),
        armature: armature::read_joint_armature(node, report),
        mimic: child(node, "mimic").and_then(|n| read_mimic(n, kind, report)),
        independent: read_independent(node, report),
        spring: read_spring(node, kind, report),
        gear: None,
    }
}

/// Spring and damper of `<dynamics damping="d" spring_stiffness="k" spring_reference="q₀"/>`.
fn read_spring(node: Node<'_>, kind: Option<JointKind>, report: &mut Report) -> Option<SpringDamper> {
    let dynamics = child(node, "dynamics")?;
    let numbers = ["spring_stiffness", "damping", "spring_reference"]
        .map(|name| optional_numbers(dynamics, name, [0.0], report)[0]);
    joint_spring(kind.map_or(0, JointKind::dofs), numbers).unwrap_or_else(|why| {
        report.note(SPRING_LEFT_OUT, Place::Element(dynamics), || why.to_owned());
        None
    })
}

/// Reads `<elastic joint="shoulder" stiffness="9e4" damping="19"/>` of the robot into its joint: the elasticity of the gear between the rotor, the
/// armature of the joint, and the joint.
pub(crate) fn read_gear(node: Node<'_>, joints: &mut [JointText<'_>], report: &mut Report) {
    let Some(name) = node.attribute("joint") else {
        report_missing_attribute(node, "joint", report);
        return;
    };
    let [damping] = optional_numbers(node, "damping", [0.0], report);
    let Some(stiffness) = required_number(node, "stiffness", report) else { return };
    let place = Place::Attribute(node, "joint");
    let near = near_names(name, joints.iter().map(|joint| joint.name));
    match joints.iter_mut().find(|joint| joint.name == name) {
        Some(joint) if joint.gear.is_none() => joint.gear = Some(ElasticGear { stiffness, damping }),
        Some(_) => report.error("two-gears", place, || {
            format!("the joint {} has an <elastic> already; give it once", quoted(name))
        }),
        None => report.error("unknown-joint", place, || {
            format!("the joint {} does not exist{}", quoted(name), did_you_mean(&near))
        }),
    }
}

/// Kind of a joint; `None` if invalid.
fn read_joint_type(node: Node<'_>, report: &mut Report) -> Option<JointKind> {
    let names = || JointKind::ALL.map(JointKind::name);
    let Some(text) = node.attribute("type") else {
        report.error("missing-attribute", Place::Element(node), || {
            format!("<joint> has no attribute \"type\"; it is one of {}", names().join(", "))
        });
        return None;
    };
    let kind = JointKind::ALL.into_iter().find(|k| k.name() == text);
    if kind.is_none() {
        report.error("unknown-joint-type", Place::Attribute(node, "type"), || {
            let guess = did_you_mean(&near_names(text, names()));
            format!("the joint type {} is unknown{guess}; it is one of {}", quoted(text), names().join(", "))
        });
    }
    kind
}

/// True for a recommended driving joint. Upper or lower case: URDF+ files contain `true`, `True` and `TRUE`.
fn read_independent(node: Node<'_>, report: &mut Report) -> Option<bool> {
    let text = node.attribute("independent")?;
    let word = text.trim_ascii();
    let value = [true, false].into_iter().find(|value| word.eq_ignore_ascii_case(&value.to_string()));
    if value.is_none() {
        report.warning("bad-flag", Place::Attribute(node, "independent"), || {
            format!("independent={}: true or false is expected; ignored", quoted(text))
        });
    }
    value
}

/// Warns about a joint that is declared dependent in a file without loops and couplings: the joint moves freely here.
/// The caller excludes files with loops or couplings, in which the dependence follows from the mobility of the
/// mechanism.
pub(crate) fn warn_if_dependence_is_ignored<'a>(joint: &JointText<'a>, node: Node<'a>, report: &mut Report) {
    let moves = joint.kind.dofs() > 0;
    if moves && joint.independent == Some(false) && child(node, "mimic").is_none() {
        let place = Place::Attribute(node, "independent");
        report.add_once(Severity::Warning, "unbound-joint", String::new(), place, || {
            "the joint is declared dependent, but nothing in the file binds it; it moves freely".to_owned()
        });
    }
}

/// Attribute `link` of a child element; empty if absent.
pub(crate) fn read_link_name<'a>(node: Node<'a>, tag: &'static str, report: &mut Report) -> &'a str {
    let Some(element) = child(node, tag) else {
        report.error("missing-element", Place::Element(node), || {
            let parent = node.tag_name().name();
            format!("<{parent}> has no <{tag}>; it needs <{tag} link=\"...\"/>")
        });
        return "";
    };
    element.attribute("link").unwrap_or_else(|| {
        report_missing_attribute(element, "link", report);
        ""
    })
}

/// Axis in the joint frame; the default of URDF if `<axis>` is absent.
fn read_axis(node: Node<'_>, kind: Option<JointKind>, report: &mut Report) -> [f64; 3] {
    match child(node, "axis") {
        Some(axis) if kind == Some(JointKind::Fixed) => {
            let is_valid = axis.attribute("xyz").is_some_and(|text| parse_numbers::<3>(text).is_ok());
            if !is_valid {
                report.warning("unused-element", Place::Element(axis), || {
                    "the axis is not three numbers in \"xyz\"; the joint is fixed, and has no axis".to_owned()
                });
            }
            DEFAULT_AXIS
        }
        Some(axis) => required_numbers(axis, "xyz", DEFAULT_AXIS, report),
        None => {
            if let Some(kind) = kind.filter(|k| k.has_axis()) {
                report.note("default-axis", Place::Element(node), || {
                    format!("the {} joint has no <axis>: 1 0 0 is taken, as URDF says", kind.name())
                });
            }
            DEFAULT_AXIS
        }
    }
}

/// Lower and upper position limit; a missing one is 0, as in URDF. `None` if both are missing, so that a `<limit>` with only
/// effort and speed does not fix the joint at zero, or if one is infinite.
fn read_limits(node: Node<'_>, kind: Option<JointKind>, report: &mut Report) -> Option<Limits> {
    if kind == Some(JointKind::Fixed) {
        return None;
    }
    let limit = child(node, "limit").filter(|n| n.has_attribute("lower") || n.has_attribute("upper"));
    let Some(limit) = limit else {
        if let Some(kind @ (JointKind::Revolute | JointKind::Prismatic)) = kind {
            report.note("no-limits", Place::Element(node), || {
                format!("the {} joint has no position limits", kind.name())
            });
        }
        return None;
    };
    let texts = ["lower", "upper"].map(|name| limit.attribute(name).unwrap_or("0").trim_ascii());
    let is_unlimited = |text: &&str| text.parse::<f64>().is_ok_and(|limit| limit.abs() >= UNLIMITED);
    if texts.iter().any(is_unlimited) {
        let is_number = texts.iter().all(|text| !text.contains(['n', 'N']));
        let severity = if is_number { Severity::Note } else { Severity::Warning };
        report.add(severity, "no-limits", Place::Element(limit), || {
            format!("an infinite limit, or one of {UNLIMITED:e} and more, is none: the joint is taken as without position limits")
        });
        return None;
    }
    let [[lower], [upper]] = ["lower", "upper"].map(|name| optional_numbers(limit, name, [0.0], report));
    Some(Limits { lower, upper })
}

/// `None`, with a warning, for a fixed joint.
fn read_mimic<'a>(node: Node<'a>, kind: Option<JointKind>, report: &mut Report) -> Option<MimicText<'a>> {
    if kind == Some(JointKind::Fixed) {
        // Reduced robot models often fix a joint and keep its other elements.
        report.warning("fixed-mimic", Place::Element(node), || {
            "the joint is fixed; its <mimic> is ignored".to_owned()
        });
        return None;
    }
    let joint = node.attribute("joint").unwrap_or_else(|| {
        report_missing_attribute(node, "joint", report);
        ""
    });
    let [multiplier] = optional_numbers(node, "multiplier", [1.0], report);
    let [offset] = optional_numbers(node, "offset", [0.0], report);
    Some(MimicText { joint, multiplier, offset })
}

//! Findings of the builder, and validation of numbers and names.

use crate::elements::description::{JointDescription, LinkDescription};
use crate::elements::joint::{ElasticGear, Limits};
use crate::limits;
use crate::names::near_names;
use crate::problem::{Problem, Severity, Subject};
use nalgebra::Matrix3;
use std::collections::HashMap;

/// Findings so far.
#[derive(Default)]
pub(crate) struct Check {
    pub findings: Vec<(Subject, Problem)>,
    suggested: usize,
}

impl Check {
    /// Adds a finding about a subject.
    pub fn add(&mut self, subject: Subject, problem: Problem) {
        self.findings.push((subject, problem));
    }

    /// Up to three candidates similar to an unknown name. Returns none after a limited number of calls: the cost of all
    /// comparisons is quadratic.
    pub fn near<'a>(&mut self, name: &str, candidates: impl Iterator<Item = &'a str>) -> Vec<String> {
        self.suggested += 1;
        if self.suggested <= limits::MOST_SUGGESTIONS { near_names(name, candidates) } else { Vec::new() }
    }

    /// True if a finding is an error.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|(_, p)| p.severity() == Severity::Error)
    }

    /// Index of every name. Adds an error for each empty or repeated name; a repeated name keeps the first index.
    /// `subject` makes the subject of the finding from the index and the name.
    pub fn unique<'a>(
        &mut self,
        names: impl Iterator<Item = &'a String>,
        subject: impl Fn(usize, &str) -> Subject,
    ) -> HashMap<String, usize> {
        let mut ids = HashMap::new();
        for (i, name) in names.enumerate() {
            if name.is_empty() {
                self.add(subject(i, name), Problem::EmptyName);
            } else if let Some(&first) = ids.get(name) {
                self.add(subject(i, name), Problem::DuplicateName { first });
            } else {
                ids.insert(name.clone(), i);
            }
        }
        ids
    }

    /// True if the magnitude of every value is finite and at most [`limits::LARGEST_NUMBER`]; otherwise adds an error that
    /// names the `quantity`.
    pub fn is_valid<'a>(
        &mut self,
        subject: &Subject,
        quantity: &'static str,
        values: impl IntoIterator<Item = &'a f64>,
    ) -> bool {
        for &value in values {
            if !value.is_finite() {
                self.add(subject.clone(), Problem::NotFinite { quantity, value });
                return false;
            }
            if value.abs() > limits::LARGEST_NUMBER {
                self.add(subject.clone(), Problem::TooLarge { quantity, value });
                return false;
            }
        }
        true
    }

    /// Checks centre of mass, inertia and mass of a link: finite, not too large, mass ≥ 0.
    pub fn link_numbers(&mut self, subject: Subject, link: &LinkDescription) {
        let Some(inertial) = &link.inertial else { return };
        self.is_valid(&subject, "centre of mass", &inertial.com);
        self.is_valid(&subject, "inertia", &inertial.about_com);
        if self.is_valid(&subject, "mass", [&inertial.mass]) && inertial.mass < 0.0 {
            self.add(subject, Problem::NegativeMass { mass: inertial.mass });
        }
    }

    /// Checks the numbers of a joint: origin, rotation matrix, nonzero axis, armature (count and sign), order of the limits,
    /// mimic.
    pub fn joint_numbers(&mut self, subject: Subject, joint: &JointDescription) {
        self.is_valid(&subject, "origin", &joint.origin.translation);
        if self.is_valid(&subject, "rotation", &joint.origin.rotation) {
            let r = &joint.origin.rotation;
            let defect = (r.transpose() * r - Matrix3::identity()).amax();
            if defect > limits::ROTATION_DEFECT || r.determinant() < 0.0 {
                self.add(subject.clone(), Problem::NotARotation { defect });
            }
        }
        if joint.kind.has_axis() && self.is_valid(&subject, "axis", &joint.axis) {
            let length = joint.axis.norm();
            if joint.axis.amax() < limits::SHORTEST_AXIS {
                self.add(subject.clone(), Problem::ZeroAxis);
            } else if (length - 1.0).abs() > limits::AXIS_NORM_SLACK {
                self.add(subject.clone(), Problem::AxisNotUnit { length });
            }
        }
        if self.is_valid(&subject, "armature", &joint.armature) {
            if let Some(&value) = joint.armature.iter().find(|a| **a < 0.0) {
                self.add(subject.clone(), Problem::NegativeArmature { value });
            }
            let (got, dofs) = (joint.armature.len(), joint.kind.dofs());
            let one_fits = got == 1 && joint.kind.is_homogeneous() && dofs > 0;
            if got != 0 && got != dofs && !one_fits {
                self.add(subject.clone(), Problem::ArmatureCount { got, dofs });
            }
        }
        if let Some(Limits { lower, upper }) = joint.limits {
            self.is_valid(&subject, "limit", [&lower, &upper]);
            if lower > upper {
                self.add(subject.clone(), Problem::LimitsReversed { lower, upper });
            }
        }
        if let Some(mimic) = &joint.mimic {
            self.is_valid(&subject, "mimic", [&mimic.multiplier, &mimic.offset]);
        }
        self.check_elastic_parts(&subject, joint);
    }

    /// Checks the spring and the gear of a joint.
    fn check_elastic_parts(&mut self, subject: &Subject, joint: &JointDescription) {
        let spring = joint.spring.unwrap_or_default();
        let gear = joint.gear.unwrap_or(ElasticGear { stiffness: 1.0, damping: 0.0 });
        let numbers = [spring.stiffness, spring.damping, spring.reference, gear.stiffness, gear.damping];
        let is_single = joint.kind.dofs() == 1;
        let why = if !self.is_valid(subject, "spring", &numbers) {
            return;
        } else if spring.stiffness < 0.0 || spring.damping < 0.0 || gear.damping < 0.0 {
            "stiffness and damping of a spring or a gear must be 0 or more"
        } else if gear.stiffness <= 0.0 {
            "the stiffness of an elastic gear must be above 0"
        } else if !is_single && (joint.spring.is_some() || joint.gear.is_some()) {
            "only a joint with one velocity can have a spring or an elastic gear"
        } else if joint.gear.is_some() && !joint.armature.iter().any(|inertia| *inertia > 0.0) {
            "an elastic gear is between the rotor and the joint: give the inertia of the rotor (armature) too"
        } else {
            return;
        };
        self.add(subject.clone(), Problem::BadSpring { why });
    }
}

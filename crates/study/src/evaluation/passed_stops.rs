//! Stops that a given travel moves beyond their touch.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::motion_ratio::{MotionRatioRecord, wheel_ratios};
use crate::evaluation::named_contact::{NamedContactRecord, named_contact_findings, wheel_travels};
use crate::evaluation::prepared_question::{EvaluatedQuestion, PreparedQuestion};
use crate::model::loading::Model;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::PoseTable;
use crate::question::travel::moved::{Moved, WheelMotion};
use crate::thresholds::PASSED_STOP;
use percuss_dynamics::{Gap, Pose};
use percuss_mechanism::{ContactKind, NamedContact};
use std::sync::OnceLock;

/// Stops of a model, for questions whose pose is given by a travel or by the rows of a sweep.
#[derive(Debug)]
pub(crate) struct PassedStops<'a> {
    model: &'a Model,
    /// Question without its travels.
    question: MassQuestion,
    /// True if the wheels have a single motion: the wheel travel at the touch is then unique, and equal to the result of `--at STOP`.
    has_one_motion: bool,
    /// Pose as drawn.
    drawn: Pose,
    stops: Vec<LimitedStop<'a>>,
}

/// Stop with its gap as a function of the pose.
#[derive(Debug)]
struct LimitedStop<'a> {
    /// Number of the contact.
    number: usize,
    contact: &'a NamedContact,
    gap: Gap,
    /// Wheel travel at the touch, m; computed for the first finding.
    touch: OnceLock<Option<f64>>,
}

/// Findings about the stops that the travels of a question pass.
pub(crate) fn passed_stop_findings(prepared: &PreparedQuestion, pose: &Pose) -> Vec<Finding> {
    let moved = prepared.question.pose.travel.iter().map(|travel| &travel.moved);
    PassedStops::of_travels(prepared, moved).map_or_else(Vec::new, |stops| stops.findings(pose))
}

/// Findings of an answer, with those about the stops that its travels pass and about its named contact.
pub(crate) fn answer_findings(
    evaluated: &EvaluatedQuestion,
    contact: Option<&NamedContactRecord>,
) -> Vec<Finding> {
    let of_wheels = contact.map_or_else(Vec::new, |_| wheel_ratios(evaluated));
    findings_with_ratios(evaluated, contact, &of_wheels)
}

/// Same as [`answer_findings`] with known motion ratios of the wheels.
pub(crate) fn findings_with_ratios(
    evaluated: &EvaluatedQuestion,
    contact: Option<&NamedContactRecord>,
    of_wheels: &[MotionRatioRecord],
) -> Vec<Finding> {
    let passed = passed_stop_findings(&evaluated.prepared, &evaluated.pose);
    let of_contact = contact.map(|contact| named_contact_findings(evaluated, contact, of_wheels));
    let of_contact = of_contact.into_iter().flatten();
    evaluated.result.findings.iter().cloned().chain(passed).chain(of_contact).collect()
}

impl<'a> PassedStops<'a> {
    /// Stops for a question with the travels `moved`; `None` without a travel or without stops.
    pub fn of_travels<'m>(
        prepared: &PreparedQuestion<'a>,
        moved: impl IntoIterator<Item = &'m Moved>,
    ) -> Option<Self> {
        let moved: Vec<&Moved> = moved.into_iter().collect();
        let is_alike = matches!(&moved[..], [Moved::Wheels(WheelMotion::WheelTravel | WheelMotion::Heave)]);
        if moved.is_empty() { None } else { Self::new(prepared, is_alike) }
    }

    /// Stops for the rows of a sweep over positions of joints; `None` without stops.
    pub fn of_joints(prepared: &PreparedQuestion<'a>) -> Option<Self> {
        Self::new(prepared, false)
    }

    fn new(prepared: &PreparedQuestion<'a>, has_one_motion: bool) -> Option<Self> {
        let contacts = prepared.model.mechanism.contacts();
        if contacts.iter().all(|contact| contact.kind() != ContactKind::Stop) {
            return None;
        }
        // The drawn pose gives the constants of every gap; a model that does not close as drawn has no other poses.
        let drawn = prepared.system.pose(&prepared.system.configuration()).ok()?;
        let stops = contacts.iter().enumerate().filter_map(|(number, contact)| {
            let gap = Gap::new(&drawn, contact).filter(|_| contact.kind() == ContactKind::Stop)?;
            Some(LimitedStop { number, contact, gap, touch: OnceLock::new() })
        });
        Some(Self {
            model: prepared.model,
            question: MassQuestion {
                pose: PoseTable { travel: Vec::new(), ..prepared.question.pose.clone() },
                ..prepared.question.clone().into_owned()
            },
            has_one_motion: has_one_motion || drawn.degrees_of_freedom() == 1,
            stops: stops.collect(),
            drawn,
        })
    }

    /// Findings about the stops that are penetrated at a pose.
    pub fn findings(&self, pose: &Pose) -> Vec<Finding> {
        self.findings_of(|gap| gap.at(pose))
    }

    /// Findings about other stops than that of the question that are reached during an impact in time. `states`: time (s) and positions of all
    /// joints; the first state is that at the touch.
    pub fn reached<'m>(&self, states: impl Iterator<Item = (f64, &'m [f64])> + Clone) -> Vec<Finding> {
        let others =
            self.stops.iter().filter(|stop| self.question.contact.at.as_deref() != Some(stop.contact.name()));
        let reached = others.filter_map(|stop| {
            let gaps = states.clone().map(|(time, positions)| (time, stop.gap.at_positions(&self.drawn, positions)));
            let (time, _) = gaps.clone().find(|(_, gap)| *gap < -PASSED_STOP)?;
            let deepest = gaps.map(|(_, gap)| gap).fold(0.0, f64::min);
            (time > 0.0).then(|| {
                let message = format!(
                    "the impact reaches {} {:.2} ms after the touch and goes {} beyond its touch; the force of this stop is not included",
                    stop.contact.name(),
                    1e3 * time,
                    self.model.length_unit().text(0.0 - deepest)
                );
                Finding::new(FindingKind::StopPassed, FindingSubject::Contact(stop.number), message)
            })
        });
        reached.collect()
    }

    /// Findings about the stops that are penetrated at the positions of all joints, in joint order.
    pub fn findings_at(&self, positions: &[f64]) -> Vec<Finding> {
        self.findings_of(|gap| gap.at_positions(&self.drawn, positions))
    }

    fn findings_of(&self, gap_of: impl Fn(&Gap) -> f64) -> Vec<Finding> {
        let passed = self.stops.iter().map(|stop| (stop, gap_of(&stop.gap)));
        let passed = passed.filter(|(_, gap)| *gap < -PASSED_STOP);
        let unit = self.model.length_unit();
        let finding = |(stop, gap): (&LimitedStop, f64)| {
            let name = stop.contact.name();
            let touch = *stop.touch.get_or_init(|| self.touch(name));
            let touch = touch.map_or_else(String::new, |travel| {
                format!("; the touch is at {} of wheel travel", unit.text(travel))
            });
            let message = format!(
                "the pad is {} beyond the touch of {name}, along the direction of the stop{touch}",
                unit.text(0.0 - gap)
            );
            let subject = FindingSubject::Contact(stop.number);
            let finding = Finding::new(FindingKind::StopPassed, subject, message);
            // A question about this stop states the penetration as its result.
            if self.question.contact.at.as_deref() == Some(name) { finding.into_note() } else { finding }
        };
        passed.map(finding).collect()
    }

    /// Wheel travel at the touch of a stop, m.
    fn touch(&self, name: &str) -> Option<f64> {
        if !self.has_one_motion {
            return None;
        }
        let question = MassQuestion { positions: None, ..self.question.at_contact(name) };
        let prepared = PreparedQuestion::new(self.model, &question).ok()?;
        let pose = prepared.pose().ok()?;
        Some(wheel_travels(&prepared, &pose, name).first()?.travel)
    }
}

//! Stops that a given travel moves beyond their touch.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::named_contact::wheel_travels;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::model::loading::Model;
use crate::question::mass_question::MassQuestion;
use crate::question::travel::moved::{Moved, WheelMotion};
use crate::thresholds::PASSED_STOP;
use percuss_dynamics::{Gap, Pose};
use percuss_mechanism::ContactKind;
use std::sync::OnceLock;

/// Stops of a model, for questions whose pose is given by a travel.
#[derive(Debug)]
pub(crate) struct PassedStops<'a> {
    model: &'a Model,
    /// Question without its travels.
    question: MassQuestion,
    /// True if both wheels move alike: the travel at the touch is then that of `--at STOP`.
    is_alike: bool,
    /// Wheel travel at the touch, m, for each contact of the model.
    touches: Vec<OnceLock<Option<f64>>>,
}

impl<'a> PassedStops<'a> {
    /// Stops for a question with the travels `moved`; `None` without a travel, and without stops.
    pub fn new<'m>(
        prepared: &PreparedQuestion<'a>,
        moved: impl IntoIterator<Item = &'m Moved>,
    ) -> Option<Self> {
        let moved: Vec<&Moved> = moved.into_iter().collect();
        let contacts = prepared.model.mechanism.contacts();
        let has_stops = contacts.iter().any(|contact| contact.kind() == ContactKind::Stop);
        (has_stops && !moved.is_empty()).then(|| Self {
            model: prepared.model,
            question: MassQuestion { travel: Vec::new(), ..prepared.question.clone().into_owned() },
            is_alike: matches!(&moved[..], [Moved::Wheels(WheelMotion::WheelTravel | WheelMotion::Heave)]),
            touches: contacts.iter().map(|_| OnceLock::new()).collect(),
        })
    }

    /// Findings about the stops that are penetrated at a pose.
    pub fn findings(&self, pose: &Pose) -> Vec<Finding> {
        let contacts = self.model.mechanism.contacts().iter().zip(&self.touches).enumerate();
        let stops = contacts.filter(|(_, (contact, _))| contact.kind() == ContactKind::Stop);
        let passed = stops.filter_map(|(number, (contact, touch))| {
            let gap = Gap::new(pose, contact)?.at(pose);
            (gap < -PASSED_STOP).then_some((number, contact.name(), touch, gap))
        });
        let finding = |(number, name, touch, gap): (usize, &str, &OnceLock<Option<f64>>, f64)| {
            let touch = *touch.get_or_init(|| self.touch(name));
            let touch = touch.map_or_else(String::new, |travel| {
                format!(", which touches at {:.1} mm of wheel travel", 1e3 * travel)
            });
            let message = format!("the travel goes {:.1} mm beyond the touch of {name}{touch}", -1e3 * gap);
            let finding = Finding::new(FindingKind::StopPassed, FindingSubject::Contact(number), message);
            // A question about this stop states the penetration as its result.
            if self.question.at.as_deref() == Some(name) { finding.into_note() } else { finding }
        };
        passed.map(finding).collect()
    }

    /// Wheel travel at the touch of a stop, m.
    fn touch(&self, name: &str) -> Option<f64> {
        if !self.is_alike {
            return None;
        }
        let question = MassQuestion { pose: None, ..self.question.at_contact(name) };
        let prepared = PreparedQuestion::new(self.model, &question).ok()?;
        let pose = prepared.pose().ok()?;
        Some(wheel_travels(&prepared, &pose, name).first()?.travel)
    }
}

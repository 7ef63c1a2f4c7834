//! Suspension prepared for kinematics: a movable copy of the mechanism and its parts.

use crate::checks::design_variant::DesignError;
use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::prepared_question::{compile, configuration};
use crate::model::loading::Model;
use crate::pose::pose_solver;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::tables::kinematics::KinematicVariable;
use crate::question::travel::given_travel::GivenTravel;
use crate::question::travel::moved::Moved;
use crate::reports::kinematics::errors::KinematicsError;
use crate::values::position::GivenPosition;
use percuss_dynamics::{Pose, System};
use percuss_suspension::kinematics::{RACK, SuspensionParts, sliding_rack};

/// Suspension prepared for kinematics.
#[derive(Debug)]
pub(crate) struct SuspensionKinematics {
    model: Model,
    system: System,
    question: MassQuestion,
    /// Wheels, force elements and rack.
    pub parts: SuspensionParts,
    /// True if the rack of the sheet slides.
    rack_slides: bool,
}

impl SuspensionKinematics {
    /// Prepares a copy of the suspension with joints in place of massless rods, and with all changes of the model. `steers`: the rack
    /// moves.
    pub fn new(model: &Model, steers: bool) -> Result<Self, KinematicsError> {
        let origin = model.origin.sheet.as_deref().ok_or_else(|| KinematicsError::NoSheet {
            path: model.inputs.first().map_or_else(String::new, |input| input.path.clone()),
        })?;
        let rack_slides = sliding_rack(&model.mechanism).is_some();
        let sheet = origin.sheet.as_movable(steers && !rack_slides);
        let built = Model::from_sheet(&sheet, &[], model.inputs.clone()).map_err(DesignError::from)?;
        let model = built.with_changes(&model.origin.changes)?;
        let mut question = MassQuestion::default();
        // A rack that the sheet fixes does not move in the impact.
        let is_locked = sliding_rack(&model.mechanism).is_some() && !rack_slides;
        question.conditions.lock.extend(is_locked.then(|| RACK.to_owned()));
        let system = compile(&model.mechanism, &question, None)?;
        let drawn = system.pose(&system.configuration()).map_err(StudyError::from)?;
        let parts = SuspensionParts::new(drawn, &origin.understood)?;
        Ok(Self { model, system, question, parts, rack_slides })
    }

    /// Finding about a rack that the sheet fixes and that steers in this evaluation.
    pub fn rack_finding(&self, steers: bool) -> Option<Finding> {
        let message = "the sheet fixes the rack (rack.slides = false); it moves for these rows only, and all other commands hold it; \
                       write slides = true in [rack] if the rack can move in an impact";
        let is_moved = steers && self.parts.rack.is_some() && !self.rack_slides;
        is_moved.then(|| Finding::about_result(FindingKind::RackMoved, message))
    }

    /// Pose at given values of the variables, m.
    pub fn pose(&self, state: &[(KinematicVariable, f64)]) -> Result<Pose, KinematicsError> {
        let mut question = self.question.clone();
        for (variable, value) in state {
            match variable {
                KinematicVariable::Wheels(motion) => {
                    let travel = GivenTravel { moved: Moved::Wheels(*motion), distance: *value };
                    question.pose.travel.push(travel);
                }
                KinematicVariable::Steer if self.parts.rack.is_none() => return Err(KinematicsError::NoRack),
                KinematicVariable::Steer => {
                    let position = GivenPosition::from_numbers(&[*value]);
                    let position = position.map_err(|source| {
                        let joint = RACK.to_owned();
                        StudyError::input("pose.set", Fault::Position { joint, source })
                    })?;
                    question.pose.set.push((RACK.to_owned(), position));
                }
            }
        }
        let configuration = configuration(&self.model.mechanism, &question)?;
        Ok(pose_solver::pose(&self.system, &configuration, &question)?)
    }
}

//! Rates of an effective mass by the coordinates of hardpoints, from designs near the pose.

use crate::evaluation::prepared_question::{EvaluatedQuestion, PreparedQuestion};
use crate::model::changes::Changes;
use crate::model::loading::Model;
use crate::pose::pose_solver::moved_points;
use crate::pose::touch::touching_stops;
use crate::question::mass_question::MassQuestion;
use crate::question::travel::moved::MovedPoint;
use crate::thresholds::{
    LARGEST_NEARBY_CHANGE, NEARBY_CURVATURE, NEARBY_ROUNDING, NEARBY_STEP, NEARBY_TRUNCATION,
};
use percuss_dynamics::{NearbyDesigns, PoseCondition};

/// Effective masses of designs near the pose of a question: each takes a new mechanism, but no search for its pose and no response.
pub(crate) struct NearbyMasses<'a> {
    model: &'a Model,
    question: &'a MassQuestion,
    designs: NearbyDesigns,
}

/// Displacement of a hardpoint along an axis of the sheet, m.
pub(crate) fn moved(name: &str, axis: usize, by: f64) -> (String, [f64; 3]) {
    let mut moved = [0.0; 3];
    moved[axis] = by;
    (name.to_owned(), moved)
}

impl<'a> NearbyMasses<'a> {
    /// Designs near an evaluated question; `None` if the pose is not determined by set joints, travels and touching stops, if the contact
    /// is given in the world, or with a free body on the other side.
    pub fn new(evaluated: &'a EvaluatedQuestion, question: &'a MassQuestion) -> Option<Self> {
        let EvaluatedQuestion { prepared, pose, contact, result } = evaluated;
        let own = &prepared.question;
        if own.positions.is_some() || !own.pose.guess.is_empty() || prepared.other_mass().is_some() {
            return None;
        }
        if !prepared.point_is_in_link() && prepared.wheel().is_none() {
            return None;
        }
        let start = prepared.system.pose(&prepared.configuration).ok()?;
        let mechanism = &prepared.model.mechanism;
        let displaced = |MovedPoint { link, point, direction, distance }: MovedPoint| {
            PoseCondition::Displacement { link, point, direction, distance }
        };
        let displaced = moved_points(mechanism, own).ok()?.into_iter().map(displaced);
        let stops = touching_stops(mechanism, own, &start).ok()?;
        let touching = stops.iter().map(|(stop, _)| PoseCondition::Touch(stop.name().to_owned()));
        let conditions: Vec<PoseCondition> = displaced.chain(touching).collect();
        let designs = NearbyDesigns::new(&start, pose, &result.response, contact, &conditions)?;
        Some(Self { model: prepared.model, question, designs })
    }

    /// m̄ of the model with a displaced hardpoint, kg, exact to first order.
    fn mass(&self, name: &str, axis: usize, by: f64) -> Option<f64> {
        let changes = Changes { moves: vec![moved(name, axis, by)], ..Changes::default() };
        let changed = self.model.with_changes(&changes).ok()?;
        let prepared = PreparedQuestion::new(&changed, self.question).ok()?;
        let contact = prepared.contact_in_link();
        self.designs.effective_mass_of(&prepared.system, &contact, prepared.wheel())
    }

    /// Central difference (f(h) − f(−h)) / 2h by a coordinate, kg/m, and an estimate of its error: truncation with f‴ of short parts, and
    /// rounding. `None` if a design is not near, or if f is not smooth.
    pub fn rate(&self, name: &str, axis: usize) -> Option<(f64, f64)> {
        let length = self.model.mechanism.characteristic_length();
        let step = NEARBY_STEP * length;
        let (ahead, behind) = (self.mass(name, axis, step)?, self.mass(name, axis, -step)?);
        let here = self.designs.effective_mass();
        let curvature = (ahead - 2.0 * here + behind).abs();
        let is_smooth =
            (ahead - behind).abs() <= LARGEST_NEARBY_CHANGE * here && curvature <= NEARBY_CURVATURE * here;
        let rate = (ahead - behind) / (2.0 * step);
        let truncation = curvature / length + NEARBY_TRUNCATION * rate.abs();
        is_smooth.then_some((rate, truncation + NEARBY_ROUNDING * here / step))
    }
}

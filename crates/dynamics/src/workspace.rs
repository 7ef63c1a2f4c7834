//! The hot path: many configurations, nothing allocated after the first.

use crate::articulated::Articulated;
use crate::contact::{self, row_over_tree_into};
use crate::kinematics::Kinematics;
use crate::strike::{StrikeError, relative_approach};
use crate::{Contact, EffectiveMass, System};
use percuss_spatial::Transform;

/// Room to pose a system again and again and to ask for m̄ by route B. Belongs to the system it was made for.
#[derive(Clone, Debug)]
pub struct Workspace<'a> {
    system: &'a System,
    kinematics: Kinematics<f64>,
    recursion: Articulated<f64, 1>,
    row: Vec<f64>,
    row_size: Vec<f64>,
}

impl System {
    /// Room for many poses of this system.
    pub fn workspace(&self) -> Workspace<'_> {
        Workspace {
            system: self,
            kinematics: Kinematics::new(self),
            recursion: Articulated::new(self),
            row: vec![0.0; self.follows.len()],
            row_size: vec![0.0; self.follows.len()],
        }
    }
}

impl Workspace<'_> {
    /// Moves to other positions: those of all joints one after another, in joint order (layouts of
    /// [`JointKind`](percuss_mechanism::JointKind)); unit quaternions; entries of mimics are not read.
    ///
    /// # Panics
    /// Where the number of positions is not that of the mechanism.
    pub fn repose(&mut self, positions: &[f64]) {
        self.kinematics.q.copy_from_slice(positions);
        self.kinematics.refill(self.system);
    }

    /// m̄ of a contact at the positions last given, by route B; points and normals in the world are taken with the
    /// root link at the world's origin.
    ///
    /// # Errors
    /// [`StrikeError`]: a contact that means nothing, mimics, a joint that moves no mass.
    pub fn effective_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, StrikeError> {
        let system = self.system;
        system.articulated_support()?;
        let located = contact::locate(system, &self.kinematics, &Transform::identity(), contact)?;
        row_over_tree_into(system, &self.kinematics, &located, &mut self.row, &mut self.row_size);
        self.recursion.load(system, &located);
        self.recursion.eliminate(system, &self.kinematics, &located.point_root);
        system.trusted(&self.recursion.trust())?;
        let approach = relative_approach(system, &self.row, &self.row_size);
        Ok(self.recursion.effective_mass(approach))
    }
}

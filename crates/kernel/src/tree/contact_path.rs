//! Contact of a tree: the bodies between the root and the contact, and those whose twists are computed.

use super::parent_transform::LanePositions;
use super::plan::ScheduledStep;
use crate::columns::LaneContacts;
use crate::contact::ContactConversion;
use crate::tolerances::{LARGEST_AMPLIFICATION, NO_BOUND};
use nalgebra::Matrix3;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{Transform, splat};

/// Contact point and direction of the contact force, in the frames of the plan.
#[derive(Clone, Debug)]
pub(super) struct TreeContact {
    /// Contact point in the frame of the contact link's body, m.
    pub point: [f64; 3],
    /// Unit normal.
    pub normal: [f64; 3],
    pub normal_frame: TreeNormalFrame,
    /// Points and normals of the rows, which replace the two above.
    pub columns: Option<LaneContacts>,
    pub conversion: ContactConversion,
}

impl TreeContact {
    /// Contact points of the lanes, m.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn points<T: Lanes>(&self, at: LanePositions<'_>) -> [T; 3] {
        self.columns.map_or_else(|| splat(&self.point), |rows| rows.points(at.columns, at.first))
    }

    /// Unit normals of the lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn normals<T: Lanes>(&self, at: LanePositions<'_>) -> [T; 3] {
        self.columns.map_or_else(|| splat(&self.normal), |rows| rows.normals(at.columns, at.first))
    }

    /// Distances of the contact points from the origin of the body's frame, m.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn arms<T: Lanes>(&self, at: LanePositions<'_>) -> T {
        let p = self.points::<T>(at);
        p[0].mul_add(p[0], p[1].mul_add(p[1], p[2] * p[2])).sqrt()
    }
}

/// Frame of the normal.
#[derive(Clone, Copy, Debug)]
pub(super) enum TreeNormalFrame {
    /// The frame of the contact link's body.
    Body,
    /// The frame of the root link.
    Root,
}

/// Data of a contact for a tree.
#[derive(Clone, Debug)]
pub(super) struct ContactPath {
    /// Indices of the steps from the ground to the contact link's body.
    pub path: Vec<usize>,
    /// True for every step on this path.
    pub on_path: Vec<bool>,
    /// Body of the path on the ground or with a zero remaining inertia.
    pub subtree_root: usize,
    /// Largest [`amplification`](super::plan::EnergyShare::amplification) of the bodies that affect the result, except light ones.
    pub amplification: f64,
    pub light_bodies: LightBodies,
    /// Reciprocal of the travels in the bounds of sizes, 1/m.
    pub over_travel: f64,
    pub contact: TreeContact,
}

impl ContactPath {
    /// Path before a contact is set, for `steps` steps. `travel`: largest translation of a joint (m) for which the bounds of
    /// sizes hold.
    pub fn none(steps: usize, travel: f64) -> Self {
        let conversion = ContactConversion { point: Transform::identity(), normal: Matrix3::identity() };
        let contact = TreeContact {
            point: [0.0; 3],
            normal: [0.0; 3],
            normal_frame: TreeNormalFrame::Body,
            columns: None,
            conversion,
        };
        Self {
            path: Vec::with_capacity(steps),
            on_path: vec![false; steps],
            subtree_root: 0,
            amplification: NO_BOUND,
            light_bodies: LightBodies::none(steps),
            over_travel: 1.0 / travel,
            contact,
        }
    }
}

/// Bodies whose twists are computed for a contact.
#[derive(Clone, Debug)]
pub(super) struct LightBodies {
    /// Indices of the steps of the light bodies and of the bodies between them and the subtree's root, parents first.
    pub steps: Vec<usize>,
    is_needed: Vec<bool>,
}

impl LightBodies {
    pub fn none(steps: usize) -> Self {
        Self { steps: Vec::with_capacity(steps), is_needed: vec![false; steps] }
    }

    /// Finds the light bodies of a subtree. Returns the largest [`amplification`](super::plan::EnergyShare::amplification) of the
    /// others. Without a bound for a light body, its twist is not computed, and the result is [`NO_BOUND`].
    pub fn find(&mut self, steps: &[ScheduledStep], subtree_root: usize) -> f64 {
        self.steps.clear();
        self.is_needed.fill(false);
        let last = steps.len() - 1;
        let mut amplification = 0.0_f64;
        // Children before parents.
        for (at, placed) in steps.iter().enumerate().filter(|(_, placed)| placed.subtree_root == subtree_root)
        {
            let share = &placed.step.share;
            // The twists of clusters are not computed.
            let in_cluster = placed.step.cluster_joint.is_some();
            let is_needed = share.is_light() || self.is_needed[at];
            if share.amplification > LARGEST_AMPLIFICATION || (in_cluster && is_needed) {
                self.steps.clear();
                return NO_BOUND;
            }
            if !share.is_light() {
                amplification = amplification.max(share.amplification);
            }
            self.is_needed[at] |= share.is_light();
            if let (true, Some(parent)) =
                (self.is_needed[at] && placed.number != subtree_root, placed.step.parent)
            {
                self.is_needed[last - parent] = true;
            }
        }
        self.steps.extend((0..steps.len()).rev().filter(|&at| self.is_needed[at]));
        amplification
    }
}

//! Recursion of a tree in the bodies' own axes, with a fixed or a floating base, in SIMD lanes.
//!
//! The kernel returns only results without doubt. All other cases (massless or immovable contacts and contacts near
//! either, results lost to rounding) are left to the caller, as are loops and contacts between two links.

mod cluster;
mod cluster_joint;
mod contact_path;
mod hinge;
mod light_bodies;
mod parent_transform;
mod plan;
mod prismatic_leaf;
mod propagation;
mod recursion;
mod sizes;

use crate::aligned::Aligned;
use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns, WIDEST};
use crate::contact::{Contact, ContactConversion};
use crate::mechanism::Mechanism;
use cluster::MimicCluster;
use contact_path::{ContactPath, TreeContact, TreeNormalFrame};
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{ScheduledStep, TreePlan};
use propagation::SCRATCH_NUMBERS;
use recursion::{TreeResponse, evaluate};
use std::sync::Arc;

/// Compiled tree, its contact, and a workspace.
#[derive(Clone, Debug)]
pub struct TreeKernel {
    steps: Arc<[ScheduledStep]>,
    clusters: Arc<[MimicCluster]>,
    selection: ContactPath,
    scratch: Aligned,
    /// Instruction set.
    pub instructions: Instructions,
}

impl TreeKernel {
    /// Compiles the kernel of a tree. `None` for fixed joints, negative inertias, and clusters of mimic joints with more than four coordinates,
    /// with joints of several degrees of freedom, or with several joints on the ground.
    pub fn compile(mechanism: &Mechanism) -> Option<Self> {
        let mut plan = TreePlan::of(mechanism)?;
        let clusters = MimicCluster::compile(mechanism, &mut plan)?;
        plan.fill_leaves();
        let selection = ContactPath::none(plan.steps.len(), plan.travel);
        let mut steps = plan.into_schedule();
        prismatic_leaf::find_prismatic_leaves(&mut steps);
        let steps: Arc<[ScheduledStep]> = steps.into();
        let of_clusters = clusters.iter().map(MimicCluster::numbers).sum::<usize>();
        let scratch = Aligned::zeros((steps.len() * SCRATCH_NUMBERS + of_clusters) * WIDEST);
        Some(Self {
            steps,
            clusters: clusters.into(),
            selection,
            scratch,
            instructions: Instructions::best(),
        })
    }

    /// Sets a checked contact; returns false for an unsupported kind. Allocates nothing after the first call.
    pub fn set_contact(&mut self, contact: &Contact) -> bool {
        let Some((body, normal, frame)) = contact.ground_contact() else { return false };
        let last = self.steps.len() - 1;
        let (conversion, turns) = contact.conversion(&self.steps[last - body].step.own.frame, frame);
        let normal_frame = if turns { TreeNormalFrame::Body } else { TreeNormalFrame::Root };
        let [point, normal] = conversion.convert(&contact.point, &normal);
        let ContactPath { path, on_path, .. } = &mut self.selection;
        path.iter().for_each(|&at| on_path[at] = false);
        path.clear();
        let mut next = Some(body);
        while let Some(number) = next {
            path.push(last - number);
            on_path[last - number] = true;
            next = self.steps[last - number].step.parent;
        }
        path.reverse();
        self.selection.subtree_root = self.steps[last - body].subtree_root;
        let root = self.selection.subtree_root;
        self.selection.amplification = self.selection.light_bodies.find(&self.steps, root);
        let (point, normal) = (point.into(), normal.into());
        self.selection.contact = TreeContact { point, normal, normal_frame, columns: None, conversion };
        true
    }

    /// Conversion of points and normals to the frames of the kernel, for the current contact.
    pub fn conversion(&self) -> ContactConversion {
        self.selection.contact.conversion
    }

    /// Reads points and normals from columns (`None`: those of the current contact).
    pub fn set_lane_contacts(&mut self, columns: Option<LaneContacts>) {
        self.selection.contact.columns = columns;
    }

    /// m̄ at one configuration for the current contact, with its rounding error. `None` if m̄ is not finite, or if its
    /// rounding error is not small.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        CertifiedMass::of_one(|answers| {
            let columns = PositionColumns { values: positions, stride: 1 };
            let instructions = self.instructions;
            instructions.run_one(self.groups(columns, 0, answers));
        })
    }

    /// m̄ at the configurations from `first` on, one per element of the output: a multiple of the instruction set's
    /// lanes.
    pub fn effective_masses(&mut self, columns: PositionColumns<'_>, first: usize, answers: MassColumns<'_>) {
        let instructions = self.instructions;
        instructions.run(self.groups(columns, first, answers));
    }

    /// Indices of the positions that the kernel reads.
    pub fn read_positions(&self) -> impl Iterator<Item = usize> + '_ {
        let ContactPath { on_path, subtree_root: top, .. } = &self.selection;
        let steps = self.steps.iter().zip(on_path);
        let read = steps.filter(|(placed, on_path)| placed.subtree_root == *top || **on_path);
        read.flat_map(|(placed, _)| placed.step.positions())
    }

    fn groups<'a>(
        &'a mut self,
        columns: PositionColumns<'a>,
        first: usize,
        answers: MassColumns<'a>,
    ) -> TreeLaneWork<'a> {
        let Self { steps, clusters, selection, scratch, .. } = self;
        TreeLaneWork { steps, clusters, selection, columns, first, scratch, answers }
    }
}

/// Configurations, one per lane.
struct TreeLaneWork<'a> {
    steps: &'a [ScheduledStep],
    clusters: &'a [MimicCluster],
    selection: &'a ContactPath,
    columns: PositionColumns<'a>,
    first: usize,
    scratch: &'a mut [f64],
    answers: MassColumns<'a>,
}

impl Work for TreeLaneWork<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { steps, clusters, selection, columns, first, scratch, mut answers } = self;
        let mut done = 0;
        while done < answers.masses.len() {
            let answer: TreeResponse<T> =
                evaluate((steps, clusters), selection, columns, first + done, scratch);
            answers.store(done, answer.response, answer.error);
            done += T::WIDTH;
        }
    }
}

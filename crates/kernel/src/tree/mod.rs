//! Recursion of a tree in the bodies' own axes, with a fixed or a floating base, in SIMD lanes.
//!
//! The kernel returns only results without doubt. All other cases (massless or immovable contacts and contacts near
//! either, results lost to rounding) are left to the caller, as are loops.

mod branches;
mod cluster;
mod cluster_joint;
mod contact_path;
mod error_bound;
mod hinge;
mod light_bodies;
mod parent_transform;
mod plan;
mod prismatic_leaf;
mod propagation;
mod recursion;
mod workspace;

use crate::aligned::Aligned;
use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns, WIDEST};
use crate::contact::{BodyContact, BodyLine, Contact, ContactConversion, NormalFrame, relative_frame};
use crate::mechanism::Mechanism;
use crate::tolerances::LANES_TRUSTED_ERROR;
use branches::{StepRole, TreeNormalFrame};
use cluster::MimicCluster;
use contact_path::{ContactPath, TreeContact, TreeLine};
use percuss_spatial::Transform;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{ScheduledStep, TreePlan};
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
        let mut clusters = MimicCluster::compile(mechanism, &mut plan)?;
        plan.fill_leaves();
        let travel = plan.travel;
        let (mut steps, mut numbers) = plan.into_schedule();
        prismatic_leaf::find_prismatic_leaves(&mut steps);
        let steps: Arc<[ScheduledStep]> = steps.into();
        clusters.iter_mut().for_each(|cluster| cluster.place(&mut numbers));
        let selection = ContactPath::none(steps.len(), travel);
        let scratch = Aligned::zeros(numbers * WIDEST);
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
        let Some(BodyContact { body, against, normal, frame, line, is_moment }) = contact.body_contact()
        else {
            return false;
        };
        let last = self.steps.len() - 1;
        let own = |body: usize| self.steps[last - body].step.own.frame;
        let conversion =
            contact.conversion(&body.map_or(Transform::identity(), own), against.map(own).as_ref(), frame);
        let normal_frame = match (frame, against) {
            (NormalFrame::Link, _) => TreeNormalFrame::Body,
            (NormalFrame::Against, Some(_)) => TreeNormalFrame::Against,
            (NormalFrame::Against, None) | (NormalFrame::Root, _) => TreeNormalFrame::Root,
        };
        let [point, normal] = conversion.convert(&contact.point, &normal);
        let (point, normal) = (point.into(), normal.into());
        let line = line.map(|BodyLine { end, point, shortest, least_cosine }| {
            let to_body = relative_frame(&end.body.map_or(Transform::identity(), own), &end.frame);
            TreeLine { body: end.body, end: to_body.point(&point).into(), shortest, least_cosine }
        });
        let contact = TreeContact { point, normal, normal_frame, line, is_moment, columns: None, conversion };
        self.selection.select((&self.steps, &self.clusters), contact, body, against);
        true
    }

    /// Conversion of points and normals to the frames of the kernel, for the current contact; `None` for a normal along a line.
    pub fn conversion(&self) -> Option<ContactConversion> {
        let contact = &self.selection.contact;
        contact.line.is_none().then_some(contact.conversion)
    }

    /// Reads points and normals from columns (`None`: those of the current contact).
    pub fn set_lane_contacts(&mut self, columns: Option<LaneContacts>) {
        self.selection.contact.columns = columns;
    }

    /// m̄ at one configuration for the current contact, with its rounding error. `None` if m̄ is not finite, or if its
    /// rounding error is not small.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        CertifiedMass::of_one(LANES_TRUSTED_ERROR, |answers| {
            let columns = PositionColumns { values: positions, stride: 1 };
            let instructions = self.instructions;
            instructions.run_one(self.groups(columns, 0, answers));
        })
    }

    /// m̄ at the configurations from `first` on, one per element of the output: a multiple of the instruction set's
    /// lanes.
    pub fn effective_masses(&mut self, columns: PositionColumns<'_>, first: usize, answers: MassColumns<'_>) {
        let instructions = self.instructions;
        if !self.selection.is_general() || is_compiled_generally(instructions.width()) {
            instructions.run(self.groups(columns, first, answers));
        } else if instructions == Instructions::Avx512 {
            Instructions::Avx2.run(self.groups(columns, first, answers));
        } else {
            instructions.run_one(self.groups(columns, first, answers));
        }
    }

    /// Indices of the positions that the kernel reads.
    pub fn read_positions(&self) -> impl Iterator<Item = usize> + '_ {
        let steps = self.steps.iter().zip(&self.selection.branches.roles);
        let read = steps.filter(|(_, role)| **role != StepRole::Unused);
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

/// True if the general evaluation, for contacts between two bodies and for tracked sizes, is compiled for this number of lanes. Further
/// widths would double the compile time.
const fn is_compiled_generally(width: usize) -> bool {
    width == 1 || width == if cfg!(target_arch = "x86_64") { 4 } else { 2 }
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
            let plan = (steps, clusters);
            let answer: TreeResponse<T> = if is_compiled_generally(T::WIDTH) && selection.is_general() {
                evaluate::<T, true>(plan, selection, columns, first + done, scratch)
            } else {
                evaluate::<T, false>(plan, selection, columns, first + done, scratch)
            };
            answers.store(done, answer.response, answer.error);
            done += T::WIDTH;
        }
    }
}

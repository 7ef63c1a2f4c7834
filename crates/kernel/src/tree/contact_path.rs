//! Contact of a tree: the bodies between the root and the links in contact, and the bound of the rounding error.

use super::branches::{Branches, TreeNormalFrame};
use super::cluster::MimicCluster;
use super::error_bound::ErrorBound;
use super::parent_transform::LanePositions;
use super::plan::ScheduledStep;
use crate::columns::LaneContacts;
use crate::contact::ContactConversion;
use nalgebra::Matrix3;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{Transform, splat};

/// Contact point and direction of the contact force, in the frames of the plan.
#[derive(Clone, Debug)]
pub(super) struct TreeContact {
    /// Contact point in the frame of the contact link's body, m.
    pub point: [f64; 3],
    /// Unit normal; for a line its direction as drawn.
    pub normal: [f64; 3],
    pub normal_frame: TreeNormalFrame,
    /// Line that defines the normal.
    pub line: Option<TreeLine>,
    /// True for a moment about the normal in place of a force.
    pub is_moment: bool,
    /// Points and normals of the rows, which replace the two above.
    pub columns: Option<LaneContacts>,
    pub conversion: ContactConversion,
}

/// Line from the contact point to a point of a body or of the root link.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeLine {
    /// Body of the end; `None` for the root link.
    pub body: Option<usize>,
    /// End in the frame of its body, m.
    pub end: [f64; 3],
    /// Smallest accepted length, m.
    pub shortest: f64,
    /// Smallest accepted cosine of the angle between the line and the line as drawn.
    pub least_cosine: f64,
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

/// Data of a contact for a tree.
#[derive(Clone, Debug)]
pub(super) struct ContactPath {
    pub branches: Branches,
    pub bound: ErrorBound,
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
            line: None,
            is_moment: false,
            columns: None,
            conversion,
        };
        Self {
            branches: Branches::none(steps),
            bound: ErrorBound::none(steps),
            over_travel: 1.0 / travel,
            contact,
        }
    }

    /// True for a contact between two bodies or along a line, or if the sizes of terms are tracked.
    pub fn is_general(&self) -> bool {
        !self.branches.other.is_empty() || self.contact.line.is_some() || self.bound.tracks_sizes
    }

    /// Selects the steps for a contact of two bodies, or of one with the ground. Allocates nothing.
    pub fn select(
        &mut self,
        (steps, clusters): (&[ScheduledStep], &[MimicCluster]),
        contact: TreeContact,
        body: Option<usize>,
        against: Option<usize>,
    ) {
        self.contact = contact;
        self.branches.find(steps, body, against, self.contact.line.map(|line| line.body));
        let rotations = self.rotations(steps);
        self.bound.find((steps, clusters), &self.branches, (rotations, self.contact.is_moment));
    }

    /// Rotations of the normal between the joints; for a line the equivalent number by the rounding of both ends, relative to the
    /// smallest accepted length.
    fn rotations(&self, steps: &[ScheduledStep]) -> f64 {
        let Branches { path, other, shared, line: to_end, line_shared, .. } = &self.branches;
        if let Some(line) = &self.contact.line {
            let routes = [&path[*line_shared..], &to_end[*line_shared..]];
            let reach = routes.into_iter().flatten().map(|&at| steps[at].step.reach).sum::<f64>();
            let far = reach + size(&self.contact.point) + size(&line.end);
            return (1 + routes[0].len() + routes[1].len()) as f64 * (1.0 + 2.0 * far / line.shortest);
        }
        let rotations = match self.contact.normal_frame {
            TreeNormalFrame::Body => 0,
            TreeNormalFrame::Against => path.len() + other.len() - 2 * shared,
            TreeNormalFrame::Root => path.len(),
        };
        rotations as f64
    }
}

/// Sum of the magnitudes of the components, m.
fn size(point: &[f64; 3]) -> f64 {
    point.iter().map(|x| x.abs()).sum()
}

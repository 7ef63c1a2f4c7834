//! Derivatives of trees in SIMD lanes: the gradient of m̄, and the inverse operational inertia Φ of the contact link.
//!
//! In root axes about the contact point, unlike [`crate::tree`]: both results need the twists of the bodies. A lane
//! of which a pivot is small compared with its terms is left to the pose.

mod clusters;
mod plan;
mod recursion;

use crate::aligned::Aligned;
use crate::columns::{LaneContacts, PositionColumns, WIDEST};
use crate::contact::{BodyContact, Contact, ContactConversion, NormalFrame};
use crate::mechanism::Mechanism;
use nalgebra::Vector3;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::Plan;
pub use recursion::INERTIA_NUMBERS;
use recursion::{BODY_NUMBERS, LaneContact, LaneState, Selection, VELOCITY_NUMBERS};
use std::sync::Arc;

/// Quantity that the kernel computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivative {
    /// Gradient of m̄ by the velocities of all joints, kg/rad or kg/m.
    Gradient,
    /// Φ of the contact link at the contact point, 6×6, in root axes.
    InverseInertia,
}

/// Results of lanes.
pub struct DerivativeColumns<'a> {
    /// 1/m̄, 1/kg: one number per configuration.
    pub responses: &'a mut [f64],
    /// Largest ratio of the summed terms of a pivot to the pivot: one number per configuration.
    pub losses: &'a mut [f64],
    /// Number v of configuration c at v · stride + c.
    pub values: &'a mut [f64],
    /// Number of configurations between two values of one configuration.
    pub stride: usize,
}

/// Compiled tree, its contact, and a workspace.
#[derive(Clone, Debug)]
pub struct DerivativeKernel {
    plan: Arc<Plan>,
    selection: Selection,
    conversion: ContactConversion,
    point: Vector3<f64>,
    normal: Vector3<f64>,
    scratch: Aligned,
}

impl DerivativeKernel {
    /// Kernel of a tree for a checked contact with a link of the ground; `None` for other mechanisms and contacts, for lines and for
    /// moments.
    pub fn compile(mechanism: &Mechanism, contact: &Contact) -> Option<Self> {
        let plan = Plan::of(mechanism)?;
        let ground_contact = contact
            .body_contact()
            .filter(|contact| contact.against.is_none() && !contact.is_moment && contact.line.is_none());
        let BodyContact { body: Some(body), normal, frame, .. } = ground_contact? else { return None };
        let conversion = contact.conversion(&plan.frames[body], None, frame);
        let root = plan.steps[body].subtree_root;
        let active = (0..plan.steps.len()).filter(|&b| plan.steps[b].subtree_root == root).collect();
        let mut path = vec![body];
        while let Some(parent) = path.last().and_then(|&b| plan.steps[b].parent) {
            path.push(parent);
        }
        path.reverse();
        let on_path = (0..plan.steps.len()).map(|b| path.contains(&b)).collect();
        let mut ends = vec![None; plan.steps.len()];
        for &b in &path {
            if let Some(member) = plan.steps[b].member {
                ends[member.head] = Some(b);
            }
        }
        let numbers = plan.steps.len() * BODY_NUMBERS + plan.columns * VELOCITY_NUMBERS;
        let [point, normal] = conversion.convert(&contact.point, &normal);
        Some(Self {
            plan: Arc::new(plan),
            selection: Selection { body, turns: frame == NormalFrame::Link, active, path, on_path, ends },
            conversion,
            point,
            normal,
            scratch: Aligned::zeros(numbers * WIDEST),
        })
    }

    /// Conversion of points and normals to the frames of the kernel.
    pub fn conversion(&self) -> ContactConversion {
        self.conversion
    }

    /// Computes a derivative at the configurations from `first` on. The number of configurations is the length of
    /// `results.responses`, a multiple of the lane count. `contacts`: points and normals of the rows, else those of the contact.
    /// Entries of joints that do not respond are not written.
    pub fn run(
        &mut self,
        instructions: Instructions,
        derivative: Derivative,
        columns: PositionColumns<'_>,
        contacts: Option<LaneContacts>,
        results: DerivativeColumns<'_>,
    ) {
        let Self { plan, selection, point, normal, scratch, .. } = self;
        let of_all = [(*point).into(), (*normal).into()];
        instructions.run(LaneWork {
            plan,
            selection,
            of_all,
            derivative,
            columns,
            contacts,
            results,
            scratch,
        });
    }
}

/// Configurations, one per lane.
struct LaneWork<'a> {
    plan: &'a Plan,
    selection: &'a Selection,
    /// Point and normal of the contact.
    of_all: [[f64; 3]; 2],
    derivative: Derivative,
    columns: PositionColumns<'a>,
    contacts: Option<LaneContacts>,
    results: DerivativeColumns<'a>,
    scratch: &'a mut [f64],
}

impl Work for LaneWork<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { plan, selection, of_all, derivative, columns, contacts, results, scratch } = self;
        let DerivativeColumns { responses, losses, values, stride } = results;
        let mut done = 0;
        while done < responses.len() {
            let contact = match contacts {
                Some(rows) => {
                    LaneContact { point: rows.points(columns, done), normal: rows.normals(columns, done) }
                }
                None => LaneContact {
                    point: percuss_spatial::splat::<T>(&of_all[0]),
                    normal: percuss_spatial::splat::<T>(&of_all[1]),
                },
            };
            let mut state = LaneState::new((plan, selection), &contact, columns, done, scratch);
            state.response.store(&mut responses[done..]);
            state.loss.store(&mut losses[done..]);
            match derivative {
                Derivative::Gradient => state.gradient(&mut values[done..], stride),
                Derivative::InverseInertia => state.inverse_inertia(&mut values[done..], stride),
            }
            done += T::WIDTH;
        }
    }
}

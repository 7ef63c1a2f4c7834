//! Loops without any mobility, and the axis that may be the cause.

use crate::analysis::assembly::Assembly;
use crate::kinematics::frames::Kinematics;
use crate::model::{Constraint, ConstraintRows, Model};
use crate::tolerances::{CLOSED_AS_DRAWN, DEPARTING_AXIS};
use nalgebra::Vector3;
use percuss_mechanism::{ClosureKind, JointId, JointKind};

/// Coupled loops and couplings without any mobility at a generic pose, without locks and held contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidLoops {
    /// Names of the loops and couplings.
    pub loops: Vec<String>,
    /// Joints of the loops.
    pub joints: Vec<JointId>,
    /// For each loop that is planar except for one axis: this axis.
    pub departing: Vec<DepartingAxis>,
}

/// The only axis of a loop that does not fit the others. In a planar linkage, revolute axes are parallel, and
/// prismatic axes are normal to these.
#[derive(Clone, Debug, PartialEq)]
pub struct DepartingAxis {
    /// Name of the loop.
    pub closure: String,
    /// Joint of the axis; `None` for the axis of the closure itself.
    pub joint: Option<JointId>,
    /// True for a prismatic axis, which should be normal to `direction`.
    pub slides: bool,
    /// Angular deviation, rad.
    pub angle: f64,
    /// Common direction of the other revolute axes, a unit vector in root axes.
    pub direction: Vector3<f64>,
}

/// An axis of a loop.
struct Axis {
    joint: Option<JointId>,
    slides: bool,
    /// Unit vector in root axes.
    direction: Vector3<f64>,
}

impl Assembly {
    /// Loops without any mobility, irrespective of locks and held contacts: a structure, or a linkage with an error.
    pub fn rigid_loops(&self) -> Vec<RigidLoops> {
        let (model, facts) = (self.pose_model(), self.facts());
        let is_rigid = |(number, group): &(usize, &crate::model::Group)| {
            let all = group.coordinates.len();
            all > 0 && all == group.movable.len() && facts.groups[*number].rank.rank == all
        };
        let mut rigid = model.groups.iter().enumerate().filter(is_rigid).peekable();
        if rigid.peek().is_none() {
            return Vec::new();
        }
        let mut kinematics = Kinematics::zero(model);
        kinematics.q.copy_from_slice(&facts.reference);
        kinematics.refill(model);
        let describe = |(_, group): (usize, &crate::model::Group)| {
            let mut joints: Vec<JointId> = group.joints.iter().copied().flatten().collect();
            joints.sort_unstable();
            joints.dedup();
            let departing = group.constraints.iter().filter_map(|c| departing_axis(model, &kinematics, c));
            RigidLoops { loops: model.group_names(group), joints, departing: departing.collect() }
        };
        rigid.map(describe).collect()
    }
}

/// The only axis of a closure's loop that does not fit a planar motion.
fn departing_axis(
    model: &Model,
    kinematics: &Kinematics,
    constraint: &ConstraintRows,
) -> Option<DepartingAxis> {
    let Constraint::Closure(number) = constraint.constraint else { return None };
    let closure = &model.closures[number];
    let slides = match closure.kind {
        ClosureKind::Revolute | ClosureKind::Cylindrical | ClosureKind::Planar => false,
        ClosureKind::Prismatic => true,
        ClosureKind::Fixed | ClosureKind::Universal | ClosureKind::Spherical | ClosureKind::Distance => {
            return None;
        }
    };
    let along = kinematics.frame_of(&closure.predecessor).vector(&closure.axis).normalize();
    let mut axes = vec![Axis { joint: None, slides, direction: along }];
    let mut is_planar = true;
    model.for_each_support(closure.successor.body, closure.predecessor.body, |i, _| {
        let Some(id) = model.bodies[i].joint else { return is_planar = false };
        let column = kinematics.column(model, i, 0);
        let (slides, own) = match model.mechanism.joint(id).kind() {
            JointKind::Revolute | JointKind::Continuous => (false, column.angular),
            JointKind::Prismatic => (true, column.linear),
            JointKind::Fixed => return,
            JointKind::Planar | JointKind::Spherical | JointKind::Floating => return is_planar = false,
        };
        axes.push(Axis { joint: Some(id), slides, direction: kinematics.frames[i].vector(&own).normalize() });
    });
    if !is_planar {
        return None;
    }
    let (k, angle, direction) = outlier_axis(&axes)?;
    let Axis { joint, slides, .. } = axes[k];
    Some(DepartingAxis { closure: closure.name.clone(), joint, slides, angle, direction })
}

/// The axis whose omission improves the fit of the other axes at least tenfold: its index, its deviation (rad), and
/// the direction of the others.
fn outlier_axis(axes: &[Axis]) -> Option<(usize, f64, Vector3<f64>)> {
    let mut best: Option<(f64, usize, f64, Vector3<f64>)> = None;
    for k in 0..axes.len() {
        let rest = || axes.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, axis)| axis);
        let hinges: Vec<&Axis> = rest().filter(|axis| !axis.slides).collect();
        let [first, _, ..] = hinges[..] else { continue };
        let aligned = |axis: &&Axis| {
            if axis.direction.dot(&first.direction) < 0.0 { -axis.direction } else { axis.direction }
        };
        let direction = hinges.iter().map(aligned).sum::<Vector3<f64>>().normalize();
        let (own, spread) = (
            axis_deviation(&axes[k], &direction),
            rest().map(|a| axis_deviation(a, &direction)).fold(0.0, f64::max),
        );
        let part = spread / own;
        if own > CLOSED_AS_DRAWN && part < DEPARTING_AXIS && best.as_ref().is_none_or(|b| part < b.0) {
            best = Some((part, k, own, direction));
        }
    }
    best.map(|(_, k, angle, direction)| (k, angle, direction))
}

/// Angle of a revolute axis from the direction, or of a prismatic axis from the normal plane, rad.
fn axis_deviation(axis: &Axis, direction: &Vector3<f64>) -> f64 {
    let (along, across) = (axis.direction.dot(direction).abs(), axis.direction.cross(direction).norm());
    if axis.slides { along.atan2(across) } else { across.atan2(along) }
}

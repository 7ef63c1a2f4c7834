//! Forces of the ideal joints in a motion of a mechanism with bushes.

use super::elements::{ElasticRow, ElementMotion, LinearElement};
use super::residual::solve_positive_columns;
use super::subspace::split;
use super::system::{ElasticSystem, closing_row, elastic_rows, stacked};
use super::transient::{ElasticInput, ElasticMotion, ElasticOutput, weight};
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::model::conditions::Conditions;
use crate::tolerances::IN_BALANCE;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_mechanism::{Closure, ClosureKind, JointId, JointKind, LinkId, LoopFrame};
use std::sync::Arc;

/// Force of an ideal joint or of an ideal closure of a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct JointForce {
    /// The joint or closure.
    pub name: String,
    /// Components along root axes, or one along a rod, N: in the place of a displacement.
    pub components: Vec<ElasticOutput>,
}

/// Links and a point, m, root axes: the first link moves relative to the second. `None`: the ground.
type Pair = ([Option<LinkId>; 2], Vector3<f64>);

impl ElasticSystem {
    /// Forces of all ideal joints with a motion and of ideal balls and rods that close loops, without preloads of bushes. `contact`, `inputs`: those of
    /// [`motion`](Self::motion). Empty if the forces are not determined (redundant joints), for other closures, couplings and held contacts, and
    /// with springs or gears at sliding joints.
    ///
    /// ```text
    /// w = D⁻ᵀ (M₆ u̇₆ − Q₆ − A₆ᵀλ),   u₆ = T u,   TᵀA₆ᵀλ = Tᵀ(M₆ u̇₆ − Q₆)
    /// ```
    ///
    /// u₆: velocities with all joints free; D: relative twists of the two links of each joint; A₆: rows of the closures and of ideal rows of bushes.
    pub fn joint_forces(
        &self,
        motion: &ElasticMotion,
        contact: [f64; 2],
        inputs: &[ElasticInput],
    ) -> Vec<JointForce> {
        self.find_joint_forces(motion, contact, inputs).unwrap_or_default()
    }

    fn find_joint_forces(
        &self,
        motion: &ElasticMotion,
        [k, c]: [f64; 2],
        inputs: &[ElasticInput],
    ) -> Option<Vec<JointForce>> {
        let mechanism = &self.model.mechanism;
        // Rows of joints have the directions of rotations once all joints are free.
        let slides = |joint: JointId| mechanism.joint(joint).kind() == JointKind::Prismatic;
        let is_sliding = |element: &LinearElement| match element.motion {
            ElementMotion::Twist(joint, other) => slides(joint) || other.is_some_and(slides),
            ElementMotion::Gear(joint) => slides(joint),
            ElementMotion::Length(_) | ElementMotion::Along(..) => false,
        };
        if self.elements.iter().any(is_sliding) {
            return None;
        }
        let conditions = Conditions::new().base(self.model.base);
        let free = Model::compile(&Arc::new(mechanism.disjointed()), &conditions).ok()?;
        let at_rest = Kinematics::zero(&free);
        let frame = |link: LinkId| self.kinematics.link_frame(&self.model, link);
        let mut pairs: Vec<Pair> = mechanism
            .joints()
            .iter()
            .map(|joint| ([Some(joint.child()), Some(joint.parent())], frame(joint.child()).translation))
            .collect();
        if free.coordinates.len() > 6 * pairs.len() {
            pairs.push(([Some(mechanism.root()), None], Vector3::zeros()));
        }
        let twists = |model: &Model, kinematics: &Kinematics| {
            let mut all = DMatrix::zeros(6 * pairs.len(), model.coordinates.len());
            for (i, pair) in pairs.iter().enumerate() {
                all.rows_mut(6 * i, 6).copy_from(&relative_twist(model, kinematics, pair));
            }
            all
        };
        let of_joints = twists(&free, &at_rest);
        if !of_joints.is_square() {
            return None;
        }
        let t = of_joints.clone().lu().solve(&twists(&self.model, &self.kinematics))?;
        // Forces that the joints supply, per state and per input.
        let (n, m) = (motion.rate.nrows(), motion.rate.nrows() + motion.input.ncols());
        let of_state =
            |r: usize, c: usize| if c < n { motion.rate[(r, c)] } else { motion.input[(r, c - n)] };
        let accelerations = &self.basis * &motion.coordinates.velocity * DMatrix::from_fn(n, m, of_state);
        let mass = free.mass_matrix(&at_rest);
        let mut forces = &mass * &t * &accelerations;
        let mut rows = elastic_rows(&free, &at_rest, None, &self.elements);
        let is_ideal = |row: &ElasticRow| row.stiffness == f64::INFINITY;
        let mut constraints: Vec<DVector<f64>> =
            rows.iter().filter(|row| is_ideal(row)).map(|row| row.row.clone()).collect();
        rows.retain(|row| !is_ideal(row));
        let force = |output: &ElasticOutput, [k, c]: [f64; 2]| {
            let state = &output.position * k + &output.velocity * c;
            let input = &output.position_input * k + &output.velocity_input * c;
            DVector::from_iterator(m, state.iter().chain(input.iter()).copied())
        };
        let closing = closing_row(&free, &at_rest, &self.located);
        forces.ger(1.0, &closing, &force(&motion.contact, [k, c]), 1.0);
        for (row, of) in rows.iter().zip(&motion.rows) {
            forces.ger(1.0, &row.row, &force(&of.output, [of.stiffness, of.damping]), 1.0);
        }
        for (i, input) in inputs.iter().enumerate() {
            let against = match input {
                ElasticInput::Contact => closing.clone(),
                ElasticInput::Element(number) => {
                    rows.iter().find(|row| row.number == Some(*number))?.row.clone()
                }
                ElasticInput::Gravity(gravity) => -weight(&free, &at_rest, gravity),
            };
            let mut column = forces.column_mut(n + i);
            column += against;
        }
        // Closures.
        let mut closures = Vec::new();
        for closure in mechanism.closures() {
            let own = self.closure_rows(&free, &at_rest, closure)?;
            closures.push((closure.name(), constraints.len(), own.len()));
            constraints.extend(own);
        }
        let constraints = stacked(&constraints, free.coordinates.len());
        let reduced = &constraints * &t;
        let independent = split(&reduced, reduced.ncols(), self.floor)?.range.ncols();
        if independent < constraints.nrows() {
            return None;
        }
        let rotors = self.model.mass_matrix(&self.kinematics) - t.tr_mul(&mass) * &t;
        let rest = t.tr_mul(&forces) + rotors * &accelerations;
        let multipliers = solve_positive_columns(&(&reduced * reduced.transpose()), &reduced * &rest)?;
        let left = reduced.tr_mul(&multipliers) - &rest;
        if left.norm() > IN_BALANCE * forces.norm() {
            return None;
        }
        forces -= constraints.tr_mul(&multipliers);
        let wrenches = of_joints.transpose().lu().solve(&forces)?;
        let output = |values: &DMatrix<f64>, row: usize| ElasticOutput {
            position: values.row(row).columns(0, n).transpose(),
            position_input: values.row(row).columns(n, m - n).transpose(),
            velocity: DVector::zeros(n),
            velocity_input: DVector::zeros(m - n),
        };
        let joints = mechanism.joints().iter().enumerate();
        let moving =
            joints.filter(|(_, joint)| !matches!(joint.kind(), JointKind::Fixed | JointKind::Floating));
        let of_joint = moving.map(|(i, joint)| JointForce {
            name: joint.name().to_owned(),
            components: (3..6).map(|row| output(&wrenches, 6 * i + row)).collect(),
        });
        let of_closure = closures.into_iter().map(|(name, first, count)| JointForce {
            name: name.to_owned(),
            components: (first..first + count).map(|row| output(&multipliers, row)).collect(),
        });
        Some(of_joint.chain(of_closure).collect())
    }

    /// Rows of a ball joint along root axes, or of a rod along its line; `None` for other closures.
    fn closure_rows(
        &self,
        free: &Model,
        at_rest: &Kinematics,
        closure: &Closure,
    ) -> Option<Vec<DVector<f64>>> {
        let [(a, at_a), (b, at_b)] = [closure.predecessor(), closure.successor()].map(|end: &LoopFrame| {
            let link = end.link.unwrap_or(self.model.mechanism.root());
            (end.link, self.kinematics.link_frame(&self.model, link).point(&end.frame.translation))
        });
        let translation =
            |link, at| relative_twist(free, at_rest, &([link, None], at)).rows(3, 3).into_owned();
        let relative = translation(b, at_b) - translation(a, at_a);
        match closure.kind() {
            ClosureKind::Spherical => Some((0..3).map(|i| relative.row(i).transpose()).collect()),
            ClosureKind::Distance => Some(vec![relative.tr_mul(&(at_b - at_a).try_normalize(0.0)?)]),
            ClosureKind::Fixed
            | ClosureKind::Revolute
            | ClosureKind::Prismatic
            | ClosureKind::Cylindrical
            | ClosureKind::Universal
            | ClosureKind::Planar => None,
        }
    }
}

/// Twist of a link relative to another one at a point, per coordinate: rotation, then translation of the point, 6×n, root axes.
fn relative_twist(model: &Model, kinematics: &Kinematics, (links, at): &Pair) -> DMatrix<f64> {
    let [own, other] = links.map(|link| {
        let mut twist = DMatrix::zeros(6, model.coordinates.len());
        if let Some(link) = link {
            let point = kinematics.link_frame(model, link).inverse_point(at);
            twist.rows_mut(0, 3).copy_from(&model.angular_jacobian(kinematics, link));
            twist.rows_mut(3, 3).copy_from(&model.point_jacobian(kinematics, link, &point));
        }
        twist
    });
    own - other
}

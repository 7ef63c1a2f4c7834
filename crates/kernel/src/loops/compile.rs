//! Compiles a linkage of few degrees of freedom, and orders its elimination at given positions.

use super::layout::Layout;
use super::plan::{Block, BlockTerm, LoopBody, LoopMotion, LoopPlan, LoopVelocity, RowPivot};
use super::rows::matrix_at;
use crate::mechanism::{
    Body, BodyDirection, BodyPoint, JointMotion, JointPosition, Linkage, Mechanism, RowBlock, RowForm,
};
use crate::tolerances::{
    LANE_ROW_ROUNDINGS, LINKAGE_COORDINATES, LINKAGE_FREEDOMS, LINKAGE_PIVOT, REDUNDANT_ROW,
};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::{SpatialInertia, Transform, plane_basis};

impl LoopPlan {
    /// Plan with rows and columns ordered by the pivots at `positions`; `may_depend(coordinate)`: true if the coordinate may be dependent.
    /// `None` for planar joints, many degrees of freedom, negative inertias, and rows that are not regular at the positions.
    pub fn compile(linkage: &Linkage, positions: &[f64], may_depend: &dyn Fn(usize) -> bool) -> Option<Self> {
        let Linkage {
            mechanism, blocks, rank, lengths, shortest_length, depth, redundancy_threshold, ..
        } = linkage;
        let numbers = column_numbers(mechanism);
        let (columns, bodies) = (numbers.iter().flatten().count(), mechanism.bodies.len());
        if blocks.is_empty()
            || columns > LINKAGE_COORDINATES
            || bodies > LINKAGE_COORDINATES
            || !(1..=LINKAGE_FREEDOMS).contains(&columns.checked_sub(*rank)?)
            || !mechanism.is_positive()
            || !shortest_length.is_finite()
        {
            return None;
        }
        let mut plan = Self {
            bodies: Vec::with_capacity(bodies),
            blocks: Vec::new(),
            pivots: Vec::new(),
            filled_in: Vec::new(),
            remainders: Vec::new(),
            depends_on: Vec::new(),
            scale: 0.0,
            redundant: 0.0,
            length: *shortest_length,
            weight: 0.0,
            root_weights: vec![0.0; columns],
            roundings: 0.0,
            columns,
            freedoms: columns - rank,
            massless: (0..bodies).filter(|&body| mechanism.is_massless_root(body)).collect(),
            centre: mechanism.bodies[0].origin.translation,
            layout: Layout::default(),
        };
        for body in &mechanism.bodies {
            let carrier = body.parent.map_or_else(Transform::identity, |p| plan.bodies[p].frame);
            let mut moving = moving(body, &carrier, lengths, &numbers)?;
            if body.parent.is_none() {
                moving.translation = (Vector3::from(moving.translation) - plan.centre).into();
            }
            let carried = body.parent.map_or(0.0, |p| plan.bodies[p].reach);
            let own = if body.parent.is_some() { Vector3::from(moving.translation).norm() } else { 0.0 };
            let travel = match moving.motion {
                LoopMotion::Floating(_) => mechanism.characteristic_length,
                _ => 0.0,
            };
            moving.reach = carried + own + travel;
            plan.bodies.push(moving);
        }
        plan.weight = plan.bodies.iter().map(|body| weight(body, *shortest_length)).sum();
        // The rounding errors of the frames along a chain are independent: their sum grows with the square root of the depth.
        plan.roundings = LANE_ROW_ROUNDINGS * (1.0 + (*depth as f64).sqrt());
        let mut rows = 0;
        for block in blocks {
            let block = plan.block(block, &mut rows)?;
            plan.blocks.push(block);
        }
        let coordinates: Vec<usize> = (0..numbers.len()).filter(|&c| numbers[c].is_some()).collect();
        plan.order(rows, *rank, positions, &|column| may_depend(coordinates[column]))?;
        plan.redundant = REDUNDANT_ROW * redundancy_threshold * plan.scale;
        plan.fill_root_weights();
        Some(plan)
    }

    /// Plan of [`Self::compile`] for a path of the driving joints. Also `None` if the linkage has couplings, held contacts, floating joints, or
    /// closures that bind the full orientation.
    pub fn compile_driven(
        linkage: &Linkage,
        positions: &[f64],
        may_depend: &dyn Fn(usize) -> bool,
    ) -> Option<Self> {
        let plan = Self::compile(linkage, positions, may_depend)?;
        let binds = |(form, _): &(RowForm, _)| matches!(form, RowForm::Orientation(..));
        let fits = |block: &Block| block.predecessor.is_some() && !block.forms.iter().any(binds);
        let floats = plan.bodies.iter().any(|body| matches!(body.motion, LoopMotion::Floating(_)));
        (!floats && plan.blocks.iter().all(fits)).then_some(plan)
    }

    /// Rows of one constraint in the frames of the plan, numbered from `rows`, which is advanced. `None` if a joint of the
    /// constraint does not move.
    fn block(&self, given: &RowBlock, rows: &mut usize) -> Option<Block> {
        let point = |point: &BodyPoint| self.point(point.body, &point.at.into());
        let heading = |e: &BodyDirection| self.direction(e.body, &e.e.into());
        let mut number = |form: &RowForm| {
            let form = match form {
                RowForm::Along(e) => RowForm::Along(heading(e)),
                RowForm::Cosine(e, b, length) => RowForm::Cosine(heading(e), heading(b), *length),
                RowForm::Orientation(own, other, length) => {
                    RowForm::Orientation(own.each_ref().map(heading), other.each_ref().map(heading), *length)
                }
                form @ (RowForm::Point | RowForm::Distance(_) | RowForm::Constant) => *form,
            };
            let count = if matches!(form, RowForm::Point | RowForm::Orientation(..)) { 3 } else { 1 };
            let first = *rows;
            *rows += count;
            (form, std::array::from_fn(|k| (k < count).then_some(first + k)))
        };
        let forms = given.forms.iter().map(&mut number).collect();
        let mut seen = vec![false; self.columns];
        let term = |term: &crate::mechanism::RowTerm| {
            let body = &self.bodies[term.body];
            let velocity = body.velocities.get(term.component)?;
            Some(BlockTerm {
                body: term.body,
                component: term.component,
                slides: body.motion.translates(term.component),
                column: velocity.column,
                factor: term.factor * velocity.factor,
                is_first: !std::mem::replace(&mut seen[velocity.column], true),
            })
        };
        let terms = given.terms.iter().map(term).collect::<Option<_>>()?;
        Some(Block {
            predecessor: given.predecessor.as_ref().map(point),
            successor: point(&given.successor),
            forms,
            terms,
        })
    }

    /// Fills the bounds of the energy of each coordinate: its rotors, and the bodies of its subtrees at their largest distance from
    /// the joint.
    fn fill_root_weights(&mut self) {
        for (index, joint) in self.bodies.iter().enumerate() {
            for (k, velocity) in joint.velocities.iter().enumerate() {
                let mut weight = velocity.armature;
                for (i, body) in self.bodies.iter().enumerate() {
                    let mut chain = std::iter::successors(Some(i), |&b| self.bodies[b].parent);
                    let Some(own) = body.inertia.filter(|_| chain.any(|b| b == index)) else { continue };
                    weight += match joint.motion.translates(k) {
                        true => own[0],
                        false => {
                            let arm = body.reach - joint.reach;
                            2.0 * (own[0] * arm * arm + own[4] + own[7] + own[9])
                        }
                    };
                }
                self.root_weights[velocity.column] += weight.sqrt() * velocity.factor.abs();
            }
        }
    }

    /// Orders rows and columns by the pivots at a pose, followed by the remaining rows and columns. `None` if the pivots are too
    /// small at this pose.
    fn order(
        &mut self,
        rows: usize,
        rank: usize,
        positions: &[f64],
        may_depend: &dyn Fn(usize) -> bool,
    ) -> Option<()> {
        let columns = self.columns;
        self.layout = Layout::of(self.bodies.len(), rows, columns, self.freedoms);
        let mut matrix = matrix_at(self, positions);
        let (mut row_at, mut column_at) = (vec![None; rows], vec![None; columns]);
        for k in 0..rank {
            let open = (0..rows * columns)
                .filter(|at| row_at[at / columns].is_none() && column_at[at % columns].is_none())
                .filter(|at| may_depend(at % columns));
            let best = open.max_by(|&a, &b| matrix[a].abs().total_cmp(&matrix[b].abs()))?;
            let (r, c, pivot) = (best / columns, best % columns, matrix[best].abs());
            if k == 0 {
                self.scale = pivot;
            }
            // A NaN pivot is refused.
            if !(pivot * LINKAGE_PIVOT >= self.scale && pivot > 0.0) {
                return None;
            }
            (row_at[r], column_at[c]) = (Some(k), Some(k));
            for other in (0..rows).filter(|other| row_at[*other].is_none()) {
                let factor = matrix[other * columns + c] / matrix[best];
                for j in 0..columns {
                    matrix[other * columns + j] -= factor * matrix[r * columns + j];
                }
            }
        }
        for all in [&mut row_at, &mut column_at] {
            for (next, at) in (rank..).zip(all.iter_mut().filter(|at| at.is_none())) {
                *at = Some(next);
            }
        }
        let column = |c: &mut usize| *c = column_at[*c].unwrap_or(0);
        self.bodies.iter_mut().flat_map(|b| &mut b.velocities).for_each(|v| column(&mut v.column));
        for block in &mut self.blocks {
            block.terms.iter_mut().for_each(|term| column(&mut term.column));
            for row in block.forms.iter_mut().flat_map(|(_, rows)| rows) {
                *row = row.and_then(|r| row_at[r]);
            }
        }
        self.find_pattern(rank, rows);
        Some(())
    }

    /// Finds the nonzero pattern of A before and after its elimination, and the bodies that each independent
    /// coordinate moves.
    fn find_pattern(&mut self, rank: usize, rows: usize) {
        let (n, f) = (self.columns, self.freedoms);
        let mut filled = vec![false; rows * n];
        for block in &self.blocks {
            for row in block.forms.iter().flat_map(|(_, rows)| rows).flatten() {
                block.terms.iter().for_each(|term| filled[row * n + term.column] = true);
            }
        }
        let given = filled.clone();
        for k in 0..rank {
            let below: Vec<usize> = (k + 1..rows).filter(|r| filled[r * n + k]).collect();
            let columns: Vec<usize> = (k + 1..n).filter(|c| filled[k * n + c]).collect();
            for r in &below {
                columns.iter().for_each(|c| filled[r * n + c] = true);
            }
            self.pivots.push(RowPivot { rows: below, columns });
        }
        self.remainders = (rank * n..rows * n).filter(|&entry| filled[entry] && entry % n >= rank).collect();
        self.filled_in = (0..rows * n).filter(|&entry| filled[entry] && !given[entry]).collect();
        let mut follows = vec![false; n * f];
        for y in 0..f {
            follows[(rank + y) * f + y] = true;
            for k in (0..rank).rev() {
                follows[k * f + y] = self.pivots[k].columns.iter().any(|c| follows[c * f + y]);
            }
        }
        for i in 0..self.bodies.len() {
            let carried =
                self.bodies[i].parent.map_or_else(|| vec![false; f], |p| self.bodies[p].moved_by.clone());
            let own = |y: usize| self.bodies[i].velocities.iter().any(|v| follows[v.column * f + y]);
            self.bodies[i].moved_by = (0..f).map(|y| carried[y] || own(y)).collect();
        }
        self.depends_on = follows;
    }
}

/// Column of each coordinate; `None` for coordinates of joints between a massless base and the first body with mass.
fn column_numbers(mechanism: &Mechanism) -> Vec<Option<usize>> {
    let mut numbers = vec![None; mechanism.coordinates];
    let bodies = mechanism.bodies.iter().filter(|body| !body.floats);
    for coordinate in bodies.flat_map(|body| &body.velocities).filter_map(|velocity| velocity.coordinate) {
        numbers[coordinate] = Some(0);
    }
    numbers.iter_mut().flatten().enumerate().for_each(|(column, number)| *number = column);
    numbers
}

/// Upper bound of twice the kinetic energy of a body at unit rates (m/s).
fn weight(body: &LoopBody, length: f64) -> f64 {
    let rotors: f64 = body.velocities.iter().map(|v| v.armature * v.factor * v.factor).sum();
    let own = body.inertia.map_or(0.0, |i| {
        let arm = 1.0 + body.reach / length;
        2.0 * (i[0] * arm * arm + (i[4] + i[7] + i[9]) / (length * length))
    });
    rotors + own
}

/// Compiled body: constant transform to the parent, motion, velocities over scaled coordinates, inertia. `carrier`: frame
/// of the parent's compiled body in the parent's body; `numbers`: column of each coordinate. `None` if the kernel does not support the
/// joint.
fn moving(
    body: &Body,
    carrier: &Transform<f64>,
    lengths: &[f64],
    numbers: &[Option<usize>],
) -> Option<LoopBody> {
    let q = body.q;
    let position = body.mimic.unwrap_or(JointPosition { q, multiplier: 1.0, offset: 0.0 });
    let motion = match body.motion {
        JointMotion::Fixed => LoopMotion::Fixed,
        JointMotion::Revolute => LoopMotion::Turn(position),
        JointMotion::Prismatic => LoopMotion::Slide(position),
        JointMotion::Spherical => LoopMotion::Ball(q),
        JointMotion::Base => LoopMotion::Base,
        JointMotion::Floating => LoopMotion::Floating(q),
        JointMotion::Planar => return None,
    };
    let frame = match motion {
        LoopMotion::Turn(_) | LoopMotion::Slide(_) => {
            let (x, y) = plane_basis(&body.axis);
            Transform::new(Matrix3::from_columns(&[x, y, body.axis]), Vector3::zeros())
        }
        LoopMotion::Fixed | LoopMotion::Ball(_) | LoopMotion::Floating(_) | LoopMotion::Base => {
            Transform::identity()
        }
    };
    let origin = carrier.inverse() * body.origin * frame;
    let velocity = |own: &crate::mechanism::Velocity| {
        let coordinate = own.coordinate?;
        let factor = own.multiplier / lengths[coordinate];
        Some(LoopVelocity { column: numbers[coordinate]?, factor, armature: own.armature })
    };
    let velocities = match body.floats {
        true => Vec::new(),
        false => body.velocities.iter().map(velocity).collect::<Option<_>>()?,
    };
    let inertia = frame.inverse().inertia(&body.inertia);
    Some(LoopBody {
        parent: body.parent,
        rotation: std::array::from_fn(|r| std::array::from_fn(|c| origin.rotation[(r, c)])),
        translation: origin.translation.into(),
        motion,
        velocities,
        inertia: components(&inertia),
        moved_by: Vec::new(),
        frame,
        reach: 0.0,
    })
}

/// Mass, first moment and upper triangle of the rotational inertia; `None` if all are zero.
fn components(inertia: &SpatialInertia<f64>) -> Option<[f64; 10]> {
    let (c, i) = (&inertia.first_moment, &inertia.rotational);
    let all = [inertia.mass, c.x, c.y, c.z, i[(0, 0)], i[(0, 1)], i[(0, 2)], i[(1, 1)], i[(1, 2)], i[(2, 2)]];
    all.iter().any(|x| *x != 0.0).then_some(all)
}

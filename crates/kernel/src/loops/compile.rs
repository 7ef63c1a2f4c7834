//! Compiles a linkage of few degrees of freedom, and orders its elimination at given positions.

use super::layout::Layout;
use super::plan::{Block, BlockRow, BlockTerm, LoopBody, LoopMotion, LoopPlan, LoopVelocity, RowPivot};
use super::rows::matrix_at;
use crate::mechanism::{
    Body, BodyDirection, BodyPoint, JointMotion, JointPosition, Linkage, Mechanism, RowBlock, RowForm,
};
use crate::tolerances::{
    LANE_ROW_ROUNDINGS, LINKAGE_COORDINATES, LINKAGE_FREEDOMS, LINKAGE_PIVOT, PIVOT_CHOICE, REDUNDANT_ROW,
};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::{SpatialInertia, Transform, plane_basis};
use std::collections::{BTreeMap, BTreeSet};

impl LoopPlan {
    /// Plan with rows and columns ordered by the pivots at `positions`; `weight(coordinate)`: factor of its entries in the choice of pivots,
    /// 0 if the coordinate may not be dependent.
    /// `None` for many degrees of freedom, negative inertias, and rows that are not regular at the positions.
    pub fn compile(linkage: &Linkage, positions: &[f64], weight: &dyn Fn(usize) -> f64) -> Option<Self> {
        Self::compile_rows(linkage, positions, weight, false)
    }

    /// Plan of [`Self::compile`]. `closes`: with the residuals of linear relations, which do not change their rows.
    fn compile_rows(
        linkage: &Linkage,
        positions: &[f64],
        weight: &dyn Fn(usize) -> f64,
        closes: bool,
    ) -> Option<Self> {
        let Linkage {
            mechanism, blocks, rank, lengths, shortest_length, depth, redundancy_threshold, ..
        } = linkage;
        let numbers = column_numbers(mechanism, blocks.is_empty());
        let (columns, bodies) = (numbers.iter().flatten().count(), mechanism.bodies.len());
        if columns > LINKAGE_COORDINATES
            || bodies > LINKAGE_COORDINATES
            || !(1..=LINKAGE_FREEDOMS).contains(&columns.checked_sub(*rank)?)
            || !mechanism.is_positive()
            || bodies == 0
        {
            return None;
        }
        let mut plan = Self {
            bodies: Vec::with_capacity(bodies),
            blocks: Vec::new(),
            relations: Vec::new(),
            pivots: Vec::new(),
            filled_in: Vec::new(),
            remainders: Vec::new(),
            depends_on: Vec::new(),
            scale: 1.0,
            redundant: 0.0,
            length: *shortest_length,
            weight: 0.0,
            root_weights: vec![0.0; columns],
            chain: 0.0,
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
                LoopMotion::Floating(_) | LoopMotion::Planar(_) => mechanism.characteristic_length,
                _ => 0.0,
            };
            moving.reach = carried + own + travel;
            plan.bodies.push(moving);
        }
        let mut counts = vec![0; bodies];
        for (body, own) in plan.bodies.iter().enumerate() {
            counts[body] = own.parent.map_or(0, |parent| counts[parent]) + own.velocities.len();
        }
        plan.chain = counts.into_iter().max().unwrap_or(0) as f64;
        plan.weight = plan.bodies.iter().map(|body| largest_energy(body, *shortest_length)).sum();
        // The rounding errors of the frames along a chain are independent: their sum grows with the square root of the depth.
        plan.roundings = LANE_ROW_ROUNDINGS * (1.0 + (*depth as f64).sqrt());
        let mut rows = 0;
        for given in blocks {
            let mut block = plan.block(given, &mut rows)?;
            if let Some(relation) = given.relation.as_ref().filter(|own| closes || own.curve != [0.0; 3]) {
                block.relation = Some(plan.relations.len());
                plan.relations.push(relation.clone());
            }
            plan.blocks.push(block);
        }
        let coordinates: Vec<usize> = (0..numbers.len()).filter(|&c| numbers[c].is_some()).collect();
        plan.order(rows, *rank, positions, &|column| weight(coordinates[column]))?;
        plan.redundant = REDUNDANT_ROW * redundancy_threshold * plan.scale;
        plan.fill_root_weights();
        Some(plan)
    }

    /// Plan of [`Self::compile`] for a path of the driving joints. Also `None` if the linkage has held contacts, floating or planar joints, or
    /// closures that bind the full orientation.
    pub fn compile_driven(
        linkage: &Linkage,
        positions: &[f64],
        weight: &dyn Fn(usize) -> f64,
    ) -> Option<Self> {
        let plan = Self::compile_rows(linkage, positions, weight, true)?;
        let binds = |(form, _): &(RowForm, _)| matches!(form, RowForm::Orientation(..));
        let is_closed = |block: &Block| block.predecessor.is_some() || block.relation.is_some();
        let fits = |block: &Block| is_closed(block) && !block.forms.iter().any(binds);
        let floats = plan
            .bodies
            .iter()
            .any(|body| matches!(body.motion, LoopMotion::Floating(_) | LoopMotion::Planar(_)));
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
                form @ (RowForm::Point | RowForm::Distance(_) | RowForm::Relation) => *form,
            };
            let count = if matches!(form, RowForm::Point | RowForm::Orientation(..)) { 3 } else { 1 };
            let first = *rows;
            *rows += count;
            let row = |k: usize| BlockRow { row: first + k, entries: Vec::new() };
            (form, std::array::from_fn(|k| (k < count).then(|| row(k))))
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
                argument: term.argument * velocity.factor,
                is_first: !std::mem::replace(&mut seen[velocity.column], true),
            })
        };
        let terms = given.terms.iter().map(term).collect::<Option<_>>()?;
        Some(Block {
            predecessor: given.predecessor.as_ref().map(point),
            successor: point(&given.successor),
            forms,
            terms,
            relation: None,
        })
    }

    /// Fills the bounds of the energy of each coordinate: its rotors, and the bodies of its subtrees at their largest distance from
    /// the joint.
    fn fill_root_weights(&mut self) {
        let moved = |i: usize, own: &[f64; 10], joint: &LoopBody, k: usize| {
            let arm = self.bodies[i].reach - joint.reach;
            match joint.motion.translates(k) {
                true => own[0],
                false => 2.0 * (own[0] * arm * arm + own[4] + own[7] + own[9]),
            }
        };
        let mut weights: Vec<Vec<f64>> =
            self.bodies.iter().map(|joint| joint.velocities.iter().map(|v| v.armature).collect()).collect();
        for (i, body) in self.bodies.iter().enumerate() {
            let Some(own) = &body.inertia else { continue };
            for b in std::iter::successors(Some(i), |&b| self.bodies[b].parent) {
                let sums = weights[b].iter_mut().enumerate();
                sums.for_each(|(k, sum)| *sum += moved(i, own, &self.bodies[b], k));
            }
        }
        for (velocity, weight) in self.bodies.iter().flat_map(|b| &b.velocities).zip(weights.iter().flatten())
        {
            self.root_weights[velocity.column] += weight.sqrt() * velocity.factor.abs();
        }
    }

    /// Orders rows and columns by the pivots at a pose, followed by the remaining rows and columns. `None` if the pivots are too
    /// small at this pose.
    fn order(
        &mut self,
        rows: usize,
        rank: usize,
        positions: &[f64],
        weight: &dyn Fn(usize) -> f64,
    ) -> Option<()> {
        let columns = self.columns;
        let pattern = self.pattern(rows);
        self.number_entries(&pattern);
        let mut matrix: Vec<BTreeMap<usize, f64>> = vec![BTreeMap::new(); rows];
        let values = matrix_at(self, positions);
        let entries = pattern.iter().enumerate().flat_map(|(r, row)| row.iter().map(move |c| (r, *c)));
        entries.zip(values).for_each(|((r, c), value)| _ = matrix[r].insert(c, value));
        let dependent = matrix.iter().flatten().filter(|(c, _)| weight(**c) > 0.0);
        if rank > 0 {
            self.scale = dependent.map(|(_, x)| x.abs()).fold(0.0, f64::max);
        }
        let (mut row_at, mut column_at) = (vec![None; rows], vec![None; columns]);
        for k in 0..rank {
            let (r, c) = best_pivot(&matrix, &row_at, &column_at, weight)?;
            let pivot_row = matrix[r].clone();
            let pivot = *pivot_row.get(&c)?;
            // A NaN pivot is refused.
            if !(pivot.abs() * LINKAGE_PIVOT >= self.scale && pivot != 0.0) {
                return None;
            }
            (row_at[r], column_at[c]) = (Some(k), Some(k));
            for (_, row) in matrix.iter_mut().enumerate().filter(|(other, _)| row_at[*other].is_none()) {
                let Some(below) = row.get(&c) else { continue };
                let factor = below / pivot;
                pivot_row.iter().for_each(|(j, x)| *row.entry(*j).or_insert(0.0) -= factor * x);
                row.remove(&c);
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
            block.rows_mut().for_each(|own| own.row = row_at[own.row].unwrap_or(0));
        }
        self.find_pattern(rank, rows);
        Some(())
    }

    /// Columns of the nonzero entries of A before its elimination, for each row.
    fn pattern(&self, rows: usize) -> Vec<BTreeSet<usize>> {
        let mut pattern = vec![BTreeSet::new(); rows];
        for block in &self.blocks {
            let columns = || block.terms.iter().map(|term| term.column);
            block.rows().for_each(|own| pattern[own.row].extend(columns()));
        }
        pattern
    }

    /// Numbers the entries of a pattern row by row, stores the numbers in the rows of the blocks, and fills the layout. Returns for each
    /// row the number of the entry in each column.
    fn number_entries(&mut self, pattern: &[BTreeSet<usize>]) -> Vec<BTreeMap<usize, usize>> {
        let mut next = 0..;
        let numbers: Vec<BTreeMap<usize, usize>> =
            pattern.iter().map(|row| row.iter().copied().zip(&mut next).collect()).collect();
        for block in &mut self.blocks {
            let columns: Vec<usize> = block.terms.iter().map(|term| term.column).collect();
            block
                .rows_mut()
                .for_each(|own| own.entries = columns.iter().map(|c| numbers[own.row][c]).collect());
        }
        let counts = (pattern.len(), pattern.iter().map(BTreeSet::len).sum());
        let relations = self.relations.len();
        self.layout = Layout::of(self.bodies.len(), counts, self.columns, self.freedoms, relations);
        numbers
    }

    /// Finds the nonzero pattern of A before and after its elimination, and the bodies that each independent
    /// coordinate moves.
    fn find_pattern(&mut self, rank: usize, rows: usize) {
        let (n, f) = (self.columns, self.freedoms);
        let given = self.pattern(rows);
        let mut filled = given.clone();
        let mut below: Vec<Vec<usize>> = Vec::with_capacity(rank);
        for k in 0..rank {
            let own: Vec<usize> = filled[k].range(k + 1..).copied().collect();
            let rows: Vec<usize> = (k + 1..rows).filter(|r| filled[*r].contains(&k)).collect();
            rows.iter().for_each(|r| filled[*r].extend(&own));
            below.push(rows);
        }
        let numbers = self.number_entries(&filled);
        for (k, below) in below.into_iter().enumerate() {
            let columns: Vec<(usize, usize)> = numbers[k].range(k + 1..).map(|(c, at)| (*c, *at)).collect();
            let changed = below.iter().flat_map(|r| columns.iter().map(|(c, _)| numbers[*r][c])).collect();
            let rows = below.iter().map(|r| (*r, numbers[*r][&k])).collect();
            self.pivots.push(RowPivot { entry: numbers[k][&k], rows, columns, changed });
        }
        self.remainders =
            numbers[rank..].iter().flat_map(|row| row.range(rank..)).map(|(_, at)| *at).collect();
        let new = |(row, given): (&BTreeMap<usize, usize>, &BTreeSet<usize>)| {
            row.iter().filter(|(c, _)| !given.contains(c)).map(|(_, at)| *at).collect::<Vec<_>>()
        };
        self.filled_in = numbers.iter().zip(&given).flat_map(new).collect();
        let mut follows = vec![false; n * f];
        for y in 0..f {
            follows[(rank + y) * f + y] = true;
            for k in (0..rank).rev() {
                follows[k * f + y] = self.pivots[k].columns.iter().any(|(c, _)| follows[c * f + y]);
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

/// Row and column of the pivot with the smallest Markowitz count (the largest possible number of entries that its elimination fills in).
/// A pivot has at least [`PIVOT_CHOICE`] times the largest weighted magnitude of the remaining entries.
fn best_pivot(
    matrix: &[BTreeMap<usize, f64>],
    row_at: &[Option<usize>],
    column_at: &[Option<usize>],
    weight: &dyn Fn(usize) -> f64,
) -> Option<(usize, usize)> {
    let open = || {
        let entries = matrix.iter().enumerate();
        let entries =
            entries.flat_map(|(r, row)| row.iter().map(move |(c, x)| (r, *c, x.abs() * weight(*c))));
        entries.filter(|(r, c, _)| row_at[*r].is_none() && column_at[*c].is_none())
    };
    let mut counts = (vec![0_usize; matrix.len()], vec![0_usize; column_at.len()]);
    let mut largest = 0.0_f64;
    for (r, c, size) in open() {
        counts.0[r] += 1;
        counts.1[c] += 1;
        largest = largest.max(size);
    }
    let fill = |r: usize, c: usize| (counts.0[r] - 1) * (counts.1[c] - 1);
    open()
        .filter(|(_, c, size)| weight(*c) > 0.0 && *size >= PIVOT_CHOICE * largest)
        .min_by(|a, b| {
            let [of_a, of_b] = [a, b].map(|(r, c, _)| fill(*r, *c));
            // Ties go to the last entry: coordinates near the root stay independent, and the energy is eliminated from the root on.
            of_a.cmp(&of_b).then(b.2.total_cmp(&a.2)).then((b.0, b.1).cmp(&(a.0, a.1)))
        })
        .map(|(r, c, _)| (r, c))
}

/// Column of each coordinate; `None` for coordinates of joints between a massless base and the first body with mass. The energy of a tree
/// is eliminated from the tips on: bodies outside the contact path then have no speed in the elimination, and add no rounding.
fn column_numbers(mechanism: &Mechanism, is_tree: bool) -> Vec<Option<usize>> {
    let mut numbers = vec![None; mechanism.coordinates];
    let bodies = mechanism.bodies.iter().filter(|body| !body.floats);
    for coordinate in bodies.flat_map(|body| &body.velocities).filter_map(|velocity| velocity.coordinate) {
        numbers[coordinate] = Some(0);
    }
    let number_all = |(column, number): (usize, &mut usize)| *number = column;
    match is_tree {
        true => numbers.iter_mut().rev().flatten().enumerate().for_each(number_all),
        false => numbers.iter_mut().flatten().enumerate().for_each(number_all),
    }
    numbers
}

/// Upper bound of twice the kinetic energy of a body at unit rates (m/s).
fn largest_energy(body: &LoopBody, length: f64) -> f64 {
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
        JointMotion::Planar => LoopMotion::Planar(q),
    };
    let frame = match motion {
        LoopMotion::Turn(_) | LoopMotion::Slide(_) | LoopMotion::Planar(_) => {
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

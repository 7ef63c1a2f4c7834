//! Compiles a mechanism of few degrees of freedom, and orders its elimination at the assembly's first closed pose.

use super::layout::Layout;
use super::plan::{
    Block, BlockTerm, BodyDirection, BodyPoint, JointPosition, LoopBody, LoopMotion, LoopPlan, RowForm,
    RowPivot, Velocity,
};
use super::rows::matrix_at;
use crate::analysis::assembly::Assembly;
use crate::kernels::estimate::is_positive;
use crate::kernels::massless_root::massless_root;
use crate::model::{Body, CompiledClosure, Constraint, ConstraintRows, LinkFrame, Model};
use crate::tolerances::{
    EXACT_AS_DRAWN, LANE_ROW_ROUNDINGS, LINKAGE_COORDINATES, LINKAGE_FREEDOMS, LINKAGE_PIVOT, REDUNDANT_ROW,
};
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{ClosureKind, JointKind};
use percuss_spatial::{SpatialInertia, Transform, plane_basis};

impl LoopPlan {
    /// `None` for planar joints, redundant rows that contradict each other, many degrees of freedom, several independent subtrees,
    /// or negative inertias.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        // The rows may be singular as drawn.
        let plan = Self::at(assembly, &assembly.facts().reference, &|_| true);
        plan.or_else(|| Self::at(assembly, assembly.generic_positions(), &|_| true))
    }

    /// Same plan, ordered at the given positions; only coordinates with `may(coordinate)` can be dependent. Also
    /// `None` if the mechanism has couplings, held contacts, floating joints, or closures that bind the full orientation.
    pub fn compile_driven(
        assembly: &Assembly,
        positions: &[f64],
        may: &dyn Fn(usize) -> bool,
    ) -> Option<Self> {
        let plan = Self::at(assembly, positions, may)?;
        let binds = |(form, _): &(RowForm, _)| matches!(form, RowForm::Orientation(..));
        let fits = |block: &Block| block.predecessor.is_some() && !block.forms.iter().any(binds);
        let floats = plan.bodies.iter().any(|body| matches!(body.motion, LoopMotion::Floating(_)));
        (!floats && plan.blocks.iter().all(fits)).then_some(plan)
    }

    /// Plan with rows and columns ordered by the pivots at `positions`; only coordinates with `may(coordinate)` can be
    /// dependent. `None` if the kernel does not support the mechanism.
    fn at(assembly: &Assembly, positions: &[f64], may: &dyn Fn(usize) -> bool) -> Option<Self> {
        let model = assembly.model();
        let rank: usize = (0..model.groups.len()).map(|g| assembly.expected_rank(g)).sum();
        let massless = massless_root(model);
        let numbers = column_numbers(model, &massless);
        let (columns, bodies) = (numbers.iter().flatten().count(), model.bodies.len());
        if model.groups.is_empty()
            || columns > LINKAGE_COORDINATES
            || bodies > LINKAGE_COORDINATES
            || !(1..=LINKAGE_FREEDOMS).contains(&columns.checked_sub(rank)?)
            // The rows of a rounded file that are left out would not be satisfied.
            || (model.groups.iter().map(|group| group.rows).sum::<usize>() != rank
                && assembly.misfits().iter().any(|misfit| *misfit > EXACT_AS_DRAWN * model.mechanism.characteristic_length()))
            || model.bodies.iter().any(|body| !is_positive(&body.inertia))
        {
            return None;
        }
        let lengths = lengths(model);
        let length = shortest(model, &lengths);
        if !length.is_finite() {
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
            length,
            weight: 0.0,
            root_weights: vec![0.0; columns],
            roundings: 0.0,
            columns,
            freedoms: columns - rank,
            massless,
            centre: model.bodies[0].origin.translation,
            layout: Layout::default(),
        };
        for body in &model.bodies {
            let carrier = body.parent.map_or_else(Transform::identity, |p| plan.bodies[p].frame);
            let mut moving = moving(model, body, &carrier, &lengths, &numbers)?;
            if body.parent.is_none() {
                moving.translation = (Vector3::from(moving.translation) - plan.centre).into();
            }
            let carried = body.parent.map_or(0.0, |p| plan.bodies[p].reach);
            let own = if body.parent.is_some() { Vector3::from(moving.translation).norm() } else { 0.0 };
            let travel = match moving.motion {
                LoopMotion::Floating(_) => model.mechanism.characteristic_length(),
                _ => 0.0,
            };
            moving.reach = carried + own + travel;
            plan.bodies.push(moving);
        }
        plan.weight = plan.bodies.iter().map(|body| weight(body, length)).sum();
        let deepest = model.coordinates.iter().map(|c| c.depth).max().unwrap_or(0) as f64 + 1.0;
        // The roundings of the frames on the way add up like a random walk.
        plan.roundings = LANE_ROW_ROUNDINGS * (1.0 + deepest.sqrt());
        let mut rows = 0;
        for group in &model.groups {
            for constraint in &group.constraints {
                plan.blocks.push(plan.block(model, constraint, group.size, &mut rows)?);
            }
        }
        let coordinates: Vec<usize> = (0..numbers.len()).filter(|&c| numbers[c].is_some()).collect();
        plan.order(rows, rank, positions, &|column| may(coordinates[column]))?;
        let floor = (0..model.groups.len()).map(|g| assembly.floor(g)).fold(f64::INFINITY, f64::min);
        plan.redundant = REDUNDANT_ROW * floor * plan.scale;
        plan.fill_root_weights();
        Some(plan)
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

    /// Compiled rows of one constraint, numbered from `rows`, which is advanced. `size` (m) scales the rows of directions.
    /// `None` if the kernel does not support the constraint.
    fn block(
        &self,
        model: &Model,
        constraint: &ConstraintRows,
        size: f64,
        rows: &mut usize,
    ) -> Option<Block> {
        let (predecessor, successor, forms) = match constraint.constraint {
            Constraint::Closure(i) => {
                let closure = &model.closures[i];
                let origin = |end: &LinkFrame| self.point(end.body, &end.frame.translation);
                let forms = self.forms(closure, size);
                (Some(origin(&closure.predecessor)), origin(&closure.successor), forms)
            }
            Constraint::Coupling(i) => {
                if model.couplings[i].curve.is_some() {
                    return None;
                }
                let ground = BodyPoint { body: None, at: [0.0; 3] };
                let scale = if model.couplings[i].turns { size } else { 1.0 };
                let terms = self.terms(model, constraint, scale)?;
                let row = *rows;
                *rows += 1;
                let forms = vec![(RowForm::Constant, [Some(row), None, None])];
                return Some(Block { predecessor: None, successor: ground, forms, terms });
            }
            Constraint::Hold(i) => {
                let hold = &model.holds[i];
                let on = &model.link_frames[hold.link.index()];
                let at = self.point(on.body, &on.frame.point(&hold.point));
                let forms =
                    hold.directions().map(|d| RowForm::Along(BodyDirection { body: None, e: d.into() }));
                let forms = forms.into_iter().take(constraint.count).collect();
                (None, at, forms)
            }
        };
        let terms = self.terms(model, constraint, 1.0)?;
        let mut number = |form: RowForm| {
            let count = if matches!(form, RowForm::Point | RowForm::Orientation(..)) { 3 } else { 1 };
            let first = *rows;
            *rows += count;
            (form, std::array::from_fn(|k| (k < count).then_some(first + k)))
        };
        let forms = forms.into_iter().map(&mut number).collect();
        Some(Block { predecessor, successor, forms, terms })
    }

    /// Entries of a constraint's rows: one for each velocity of the bodies on its loop; factors multiplied by `scale`.
    fn terms(&self, model: &Model, constraint: &ConstraintRows, scale: f64) -> Option<Vec<BlockTerm>> {
        let mut seen = vec![false; self.columns];
        let term = |term: &crate::model::ConstraintTerm| {
            let body = &model.bodies[term.body];
            let velocity = self.bodies[term.body].velocities.get(term.component)?;
            Some(BlockTerm {
                body: term.body,
                component: term.component,
                slides: !body.motion.turns(term.component),
                column: velocity.column,
                factor: scale * term.factor * velocity.factor,
                is_first: !std::mem::replace(&mut seen[velocity.column], true),
            })
        };
        constraint.terms.iter().map(term).collect()
    }

    /// Rows of a closure, as in [`crate::kinematics::rows::closure_wrenches`], but the rows of coinciding points are in root
    /// axes. `size` (m) scales the rows of directions.
    fn forms(&self, closure: &CompiledClosure, size: f64) -> Vec<RowForm> {
        let (p, s) = (&closure.predecessor, &closure.successor);
        let direction = |e: &Vector3<f64>| self.direction(p.body, &p.frame.vector(e));
        let along = |e: &Vector3<f64>| RowForm::Along(direction(e));
        let cosine = |e: &Vector3<f64>, b: &Vector3<f64>| {
            RowForm::Cosine(direction(e), self.direction(s.body, &s.frame.vector(b)), size)
        };
        let [n1, n2] = &closure.normals;
        let b = &closure.successor_axis;
        let [first, second] = [cosine(n1, b), cosine(n2, b)];
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let on_successor = axes.map(|e| self.direction(s.body, &s.frame.vector(&e)));
        let orientation = RowForm::Orientation(axes.map(|e| direction(&e)), on_successor, size);
        match closure.kind {
            ClosureKind::Fixed => vec![RowForm::Point, orientation],
            ClosureKind::Prismatic => vec![along(n1), along(n2), orientation],
            ClosureKind::Revolute => vec![RowForm::Point, first, second],
            ClosureKind::Cylindrical => vec![along(n1), along(n2), first, second],
            ClosureKind::Universal => vec![RowForm::Point, cosine(&closure.axis, &closure.axis2)],
            ClosureKind::Planar => vec![along(&closure.axis), first, second],
            ClosureKind::Spherical => vec![RowForm::Point],
            ClosureKind::Distance => vec![RowForm::Distance(closure.distance)],
        }
    }

    /// Orders rows and columns by the pivots at a pose, followed by the remaining rows and columns. `None` if the pivots are too
    /// small at this pose.
    fn order(
        &mut self,
        rows: usize,
        rank: usize,
        positions: &[f64],
        may: &dyn Fn(usize) -> bool,
    ) -> Option<()> {
        let columns = self.columns;
        self.layout = Layout::of(self.bodies.len(), rows, columns, self.freedoms);
        let mut matrix = matrix_at(self, positions);
        let (mut row_at, mut column_at) = (vec![None; rows], vec![None; columns]);
        for k in 0..rank {
            let open = (0..rows * columns)
                .filter(|at| row_at[at / columns].is_none() && column_at[at % columns].is_none())
                .filter(|at| may(at % columns));
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

/// Column of each coordinate; `None` for those of the joints beyond a massless root.
fn column_numbers(model: &Model, massless: &[usize]) -> Vec<Option<usize>> {
    let mut numbers = vec![None; model.coordinates.len()];
    let bodies =
        model.bodies.iter().filter(|body| body.parent.is_none_or(|parent| !massless.contains(&parent)));
    for follows in bodies.flat_map(|body| &model.velocity_coordinates[body.v.clone()]).flatten() {
        numbers[follows.index] = Some(0);
    }
    numbers.iter_mut().flatten().enumerate().for_each(|(column, number)| *number = column);
    numbers
}

/// Length of each coordinate, m: from its group, otherwise from the mechanism.
fn lengths(model: &Model) -> Vec<f64> {
    let size = model.mechanism.characteristic_length();
    let mut lengths: Vec<f64> =
        model.coordinates.iter().map(|c| if c.turns && size > 0.0 { size } else { 1.0 }).collect();
    for group in &model.groups {
        group.coordinates.iter().zip(&group.lengths).for_each(|(&c, length)| lengths[c] = *length);
    }
    lengths
}

/// Smallest length (m) of the coordinates that are rotations; infinite if there is none.
fn shortest(model: &Model, lengths: &[f64]) -> f64 {
    let turns = model.coordinates.iter().zip(lengths).filter(|(c, _)| c.turns).map(|(_, length)| *length);
    turns.fold(f64::INFINITY, f64::min)
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
    model: &Model,
    body: &Body,
    carrier: &Transform<f64>,
    lengths: &[f64],
    numbers: &[Option<usize>],
) -> Option<LoopBody> {
    let q = body.q.start;
    let position = match body.mimic {
        Some(mimic) => JointPosition { q: mimic.master, multiplier: mimic.multiplier, offset: mimic.offset },
        None => JointPosition { q, multiplier: 1.0, offset: 0.0 },
    };
    let motion = match body.motion.kind {
        JointKind::Fixed => LoopMotion::Fixed,
        JointKind::Revolute | JointKind::Continuous => LoopMotion::Turn(position),
        JointKind::Prismatic => LoopMotion::Slide(position),
        JointKind::Spherical => LoopMotion::Ball(q),
        JointKind::Floating if body.joint.is_none() => LoopMotion::Base,
        JointKind::Floating => LoopMotion::Floating(q),
        JointKind::Planar => return None,
    };
    let frame = match motion {
        LoopMotion::Turn(_) | LoopMotion::Slide(_) => {
            let axis = body.motion.axis();
            let (x, y) = plane_basis(&axis);
            Transform::new(Matrix3::from_columns(&[x, y, axis]), Vector3::zeros())
        }
        LoopMotion::Fixed | LoopMotion::Ball(_) | LoopMotion::Floating(_) | LoopMotion::Base => {
            Transform::identity()
        }
    };
    let origin = carrier.inverse() * body.origin * frame;
    let velocity = |(v, armature): (usize, &f64)| {
        let follows = model.velocity_coordinates[v]?;
        let factor = follows.multiplier / lengths[follows.index];
        Some(Velocity { column: numbers[follows.index]?, factor, armature: *armature })
    };
    let moves =
        |v: &usize| model.velocity_coordinates[*v].is_none_or(|follows| numbers[follows.index].is_some());
    let inertia = frame.inverse().inertia(&body.inertia);
    Some(LoopBody {
        parent: body.parent,
        rotation: std::array::from_fn(|r| std::array::from_fn(|c| origin.rotation[(r, c)])),
        translation: origin.translation.into(),
        motion,
        velocities: (body.v.clone().zip(&body.armature))
            .filter(|(v, _)| moves(v))
            .map(velocity)
            .collect::<Option<_>>()?,
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

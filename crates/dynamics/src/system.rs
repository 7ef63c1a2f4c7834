//! A mechanism under conditions, compiled: bodies in order, coordinates numbered.

use crate::joint_motion::JointMotion;
use crate::loops::assembly::{Assembly, AssemblyError};
use crate::loops::freedom::GenericRank;
use crate::loops::{Gear, Group, Held, Loop};
use crate::{Base, Conditions, ConditionsError};
use nalgebra::DMatrix;
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::{Scalar, SpatialInertia, Transform};
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// A body of the tree with the joint above it. Links held together by fixed joints are one body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// The body it hangs on; none: the ground.
    pub parent: Option<usize>,
    /// The joint above it; none: the floating base.
    pub joint: Option<JointId>,
    pub motion: JointMotion,
    /// X_pj: the joint frame in the parent body.
    pub origin: Transform<f64>,
    /// About the body's origin, fixed links included.
    pub inertia: SpatialInertia<f64>,
    /// Where its position stands in the vector of positions.
    pub q: Range<usize>,
    /// Where its velocities stand among the tree's velocities; empty when locked.
    pub v: Range<usize>,
    pub armature: Vec<f64>,
}

/// Where a link sits: its body (none: the ground) and X_bl, its frame in that body.
#[derive(Clone, Debug)]
pub(crate) struct Seat {
    pub body: Option<usize>,
    pub frame: Transform<f64>,
}

/// The coordinate a velocity of the tree follows: v = multiplier · u[index]. Mimics share their master's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Follows {
    pub index: usize,
    pub multiplier: f64,
}

/// A [`Mechanism`] under [`Conditions`], ready to be posed and struck. Immutable and `Send + Sync`.
///
/// Its coordinates u (n of them) are the independent velocities: of the floating base, then of every joint that
/// is neither locked nor a mimic, in tree order.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) mechanism: Arc<Mechanism>,
    pub(crate) base: Base,
    /// Parents before children.
    pub(crate) bodies: Vec<Body>,
    pub(crate) seats: Vec<Seat>,
    /// For every tree velocity.
    pub(crate) follows: Vec<Option<Follows>>,
    pub(crate) locked: Vec<bool>,
    pub(crate) joint_q: Vec<Range<usize>>,
    pub(crate) positions: usize,
    pub(crate) coordinates: usize,
    pub(crate) redundant_locks: usize,
    pub(crate) has_active_mimics: bool,
    pub(crate) loops: Vec<Loop>,
    pub(crate) gears: Vec<Gear>,
    pub(crate) held: Vec<Held>,
    pub(crate) groups: Vec<Group>,
    /// The same without locks, where there are loops to be closed with every joint free.
    pub(crate) unlocked: Option<Arc<System>>,
    /// Found when first asked for.
    pub(crate) assembly: Arc<OnceLock<Result<Assembly, AssemblyError>>>,
    pub(crate) generic_rank: Arc<OnceLock<GenericRank>>,
    /// What the rank would be at zero, while nothing closes.
    pub(crate) open_rank: Arc<OnceLock<GenericRank>>,
    /// The assembly found from the first guess that closed, where nothing closes from zero.
    pub(crate) guided: Arc<OnceLock<Assembly>>,
}

impl System {
    /// Compiles a mechanism with the conditions of an analysis.
    ///
    /// # Errors
    /// [`ConditionsError`]: an unknown joint, a condition given twice, a bad armature.
    pub fn new(
        mechanism: impl Into<Arc<Mechanism>>,
        conditions: &Conditions,
    ) -> Result<Self, ConditionsError> {
        let mechanism = mechanism.into();
        let armatures = conditions.resolve_armatures(&mechanism)?;
        let asked = conditions.resolve_locks(&mechanism)?;
        let (locked, redundant_locks) = effective_locks(&mechanism, &asked);
        let mut joint_q = Vec::with_capacity(mechanism.joints().len());
        let mut positions = 0;
        for joint in mechanism.joints() {
            joint_q.push(positions..positions + joint.kind().positions());
            positions += joint.kind().positions();
        }
        let mut system = Self {
            base: conditions.base,
            bodies: Vec::new(),
            seats: vec![Seat { body: None, frame: Transform::identity() }; mechanism.links().len()],
            follows: Vec::new(),
            locked,
            joint_q,
            positions,
            coordinates: 0,
            redundant_locks,
            has_active_mimics: false,
            loops: Vec::new(),
            gears: Vec::new(),
            held: conditions.resolve_holds(&mechanism)?,
            groups: Vec::new(),
            unlocked: None,
            assembly: Arc::default(),
            generic_rank: Arc::default(),
            open_rank: Arc::default(),
            guided: Arc::default(),
            mechanism: Arc::clone(&mechanism),
        };
        for &link in mechanism.order() {
            system.place(link, &armatures, conditions.keep_fixed_joints);
        }
        system.number_coordinates();
        system.compile_loops();
        // Asked of the conditions, not of the joints: a mimic with multiplier 0 stands still without any lock.
        if !system.groups.is_empty() && !conditions.locked.is_empty() {
            let unlocked = Conditions { locked: Vec::new(), held: Vec::new(), ..conditions.clone() };
            system.unlocked = Some(Arc::new(System::new(mechanism, &unlocked)?));
        }
        Ok(system)
    }

    /// Makes a body of the link, or lets it ride on its parent's.
    fn place(&mut self, link: LinkId, armatures: &[Vec<f64>], keep_fixed_joints: bool) {
        let mechanism = Arc::clone(&self.mechanism);
        let inertia = *mechanism.link(link).inertia();
        let Some(id) = mechanism.parent_joint(link) else {
            if self.base == Base::Floating {
                // Its position is never stored: everything is seen from the root link.
                self.seats[link.index()].body = Some(0);
                self.bodies.push(Body {
                    parent: None,
                    joint: None,
                    motion: JointMotion::floating(),
                    origin: Transform::identity(),
                    inertia,
                    q: 0..0,
                    v: 0..6,
                    armature: vec![0.0; 6],
                });
                self.follows.extend([None; 6]);
            }
            return;
        };
        let joint = mechanism.joint(id);
        let Seat { body: parent, frame } = self.seats[joint.parent().index()].clone();
        let origin = frame * *joint.origin();
        if joint.kind().dofs() == 0 && !keep_fixed_joints {
            if let Some(body) = parent {
                self.bodies[body].inertia += origin.inertia(&inertia);
            }
            self.seats[link.index()] = Seat { body: parent, frame: origin };
            return;
        }
        let first = self.follows.len();
        let dofs = if self.locked[id.index()] { 0 } else { joint.kind().dofs() };
        self.follows.extend(std::iter::repeat_n(None, dofs));
        self.seats[link.index()] = Seat { body: Some(self.bodies.len()), frame: Transform::identity() };
        self.bodies.push(Body {
            parent,
            joint: Some(id),
            motion: JointMotion::of(joint),
            origin,
            inertia,
            q: self.joint_q[id.index()].clone(),
            v: first..first + dofs,
            armature: armatures[id.index()].clone(),
        });
    }

    /// Numbers the coordinates: masters first, in tree order, then lets the mimics follow.
    fn number_coordinates(&mut self) {
        let joint_of = |body: &Body| body.joint.map(|id| self.mechanism.joint(id));
        let mut first_of = vec![None; self.mechanism.joints().len()];
        let mut count = 0;
        for body in &self.bodies {
            if joint_of(body).is_some_and(|j| j.mimic().is_some()) {
                continue;
            }
            if let Some(id) = body.joint {
                first_of[id.index()] = Some(count);
            }
            for v in body.v.clone() {
                self.follows[v] = Some(Follows { index: count, multiplier: 1.0 });
                count += 1;
            }
        }
        for body in &self.bodies {
            let Some(mimic) = joint_of(body).and_then(|j| j.mimic()) else { continue };
            for v in body.v.clone() {
                let index = first_of[mimic.master.index()].expect("a master is a joint with a body");
                self.follows[v] = Some(Follows { index, multiplier: mimic.multiplier });
            }
        }
        self.has_active_mimics =
            self.bodies.iter().any(|b| !b.v.is_empty() && joint_of(b).is_some_and(|j| j.mimic().is_some()));
        self.coordinates = count;
    }

    /// The mechanism it was compiled from.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.mechanism
    }

    /// How the root link stands.
    pub fn base(&self) -> Base {
        self.base
    }

    /// How many coordinates there are: independent velocities of the tree; a floating base counts 6.
    pub fn coordinates(&self) -> usize {
        self.coordinates
    }

    /// What each coordinate is: a joint (none: the floating base) and the number of its velocity.
    pub fn coordinate_joints(&self) -> Vec<(Option<JointId>, usize)> {
        let mut names = vec![(None, 0); self.coordinates];
        for body in &self.bodies {
            if body.joint.is_some_and(|id| self.mechanism.joint(id).mimic().is_some()) {
                continue;
            }
            for (k, v) in body.v.clone().enumerate() {
                if let Some(f) = self.follows[v] {
                    names[f.index] = (body.joint, k);
                }
            }
        }
        names
    }

    /// Whether the joint cannot move: locked itself, or a mimic and its master where either is.
    pub fn is_locked(&self, joint: JointId) -> bool {
        self.locked[joint.index()]
    }

    /// Sums the rows and columns of a matrix over tree velocities into one over the coordinates: GᵀMG.
    pub(crate) fn reduce<T: Scalar>(&self, tree: &DMatrix<T>) -> DMatrix<T> {
        if !self.has_active_mimics {
            return tree.clone();
        }
        let mut reduced = DMatrix::from_element(self.coordinates, self.coordinates, T::zero());
        for (c, to_c) in self.follows.iter().enumerate() {
            for (r, to_r) in self.follows.iter().enumerate() {
                if let (Some(a), Some(b)) = (to_r, to_c) {
                    let factor = T::from_f64(a.multiplier * b.multiplier);
                    reduced[(a.index, b.index)] += tree[(r, c)] * factor;
                }
            }
        }
        reduced
    }

    /// Sums entries over tree velocities into ones over the coordinates, each weighed by a function of its
    /// multiplier: Gᵀ x with the identity.
    pub(crate) fn reduce_vector(&self, tree: &[f64], weight: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut reduced = vec![0.0; self.coordinates];
        for (value, follows) in tree.iter().zip(&self.follows) {
            if let Some(f) = follows {
                reduced[f.index] += value * weight(f.multiplier);
            }
        }
        reduced
    }

    /// Tree velocities at the coordinates `u`: G u.
    pub(crate) fn expand(&self, u: &[f64]) -> Vec<f64> {
        self.follows.iter().map(|f| f.map_or(0.0, |f| f.multiplier * u[f.index])).collect()
    }
}

/// A lock on a mimic holds its master and everything else that follows it. Says which joints stand still, and how
/// many of the rows that were asked for add nothing.
fn effective_locks(mechanism: &Mechanism, asked: &[bool]) -> (Vec<bool>, usize) {
    let mut master_locked = vec![false; asked.len()];
    let (mut rows, mut rank) = (0, 0);
    for (i, joint) in mechanism.joints().iter().enumerate().filter(|(i, _)| asked[*i]) {
        rows += joint.kind().dofs();
        let holds = match joint.mimic() {
            None => Some(i),
            Some(mimic) => (mimic.multiplier != 0.0).then(|| mimic.master.index()),
        };
        if let Some(master) = holds
            && !std::mem::replace(&mut master_locked[master], true)
        {
            rank += joint.kind().dofs();
        }
    }
    let still = |(i, joint): (usize, &percuss_mechanism::Joint)| match joint.mimic() {
        None => master_locked[i],
        Some(mimic) => master_locked[mimic.master.index()] || mimic.multiplier == 0.0,
    };
    (mechanism.joints().iter().enumerate().map(still).collect(), rows - rank)
}

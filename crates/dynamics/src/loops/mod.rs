//! Closed loops: what binds the tree's coordinates, found once; their rows, their rank, and how they are closed.

pub(crate) mod assembly;
mod branches;
mod closer;
pub(crate) mod closing;
mod crossing;
pub(crate) mod following;
pub(crate) mod freedom;
pub(crate) mod limits;
pub(crate) mod posing;
pub(crate) mod rank;
mod redundancy;
mod roles;
pub(crate) mod rows;
mod uncertainty;

use crate::System;
use crate::kinematics::Kinematics;
use crate::system::Seat;
use nalgebra::Vector3;
use percuss_mechanism::{ClosureKind, JointId, LinkId, LoopFrame};

/// A closure, compiled.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    pub name: String,
    pub kind: ClosureKind,
    pub predecessor: Seat,
    pub successor: Seat,
    /// In the predecessor's loop frame.
    pub axis: Vector3<f64>,
    /// What the kinds that compare axes bring onto it, in the successor's loop frame: the same vector, or its reverse.
    pub successor_axis: Vector3<f64>,
    /// Two unit vectors normal to the axis.
    pub normals: [Vector3<f64>; 2],
    /// The successor's pin of a universal closure.
    pub axis2: Vector3<f64>,
    /// m; of a distance closure.
    pub distance: f64,
}

/// Axes with a cosine below this with all joints at 0 were written to point opposite ways.
const REVERSED: f64 = -0.99;

/// A coupling, compiled: Σ factor q = 0.
#[derive(Clone, Debug)]
pub(crate) struct Gear {
    pub name: String,
    /// Position and, unless it is locked, velocity of each joint, with its factor.
    pub terms: Vec<(usize, Option<usize>, f64)>,
    /// Turns the row into metres.
    pub scale: f64,
}

/// A held contact: velocity rows only.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    pub link: LinkId,
    /// In the link's frame, m.
    pub point: Vector3<f64>,
    /// Root axes; none holds three directions.
    pub normal: Option<Vector3<f64>>,
}

/// Loops, couplings and coordinates that bind one another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub loops: Vec<usize>,
    pub gears: Vec<usize>,
    /// Indices of coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// For each coordinate, how far a unit rate moves a point at the characteristic length, m.
    pub lengths: Vec<f64>,
    /// Whether it turns (rad), or slides (m).
    pub turning: Vec<bool>,
    /// The joint each coordinate is a velocity of; none for the floating base.
    pub joints: Vec<Option<JointId>>,
    /// Coordinates (by index into the group's) that change the pose: all but the floating base's, from which
    /// everything is seen.
    pub movable: Vec<usize>,
    /// Bodies on the way from its closures to the root, and of its couplings' joints, parents first.
    bodies: Vec<usize>,
}

impl Group {
    /// How many rows of A it has.
    pub fn rows(&self, system: &System) -> usize {
        self.loops.iter().map(|&l| system.loops[l].kind.rows()).sum::<usize>() + self.gears.len()
    }

    /// Name of the closure or coupling that row `row` belongs to.
    pub fn row_name<'a>(&self, system: &'a System, mut row: usize) -> &'a str {
        for &l in &self.loops {
            let rows = system.loops[l].kind.rows();
            if row < rows {
                return &system.loops[l].name;
            }
            row -= rows;
        }
        &system.gears[self.gears[row]].name
    }
}

impl System {
    /// Compiles the mechanism's closures and couplings, once its bodies and coordinates are numbered.
    pub(crate) fn compile_loops(&mut self) {
        let mechanism = std::sync::Arc::clone(&self.mechanism);
        let zero = self.zero_kinematics();
        for closure in mechanism.closures() {
            let (axis, axis2) = (*closure.axis(), *closure.axis2());
            let (e1, e2) = percuss_spatial::plane_basis(&axis);
            let mut compiled = Loop {
                name: closure.name().to_owned(),
                kind: closure.kind(),
                predecessor: self.loop_seat(closure.predecessor()),
                successor: self.loop_seat(closure.successor()),
                axis,
                successor_axis: axis,
                normals: [e1, e2],
                axis2,
                distance: 0.0,
            };
            compiled.distance = closure.distance().unwrap_or_else(|| {
                let ends =
                    [&compiled.predecessor, &compiled.successor].map(|s| seat_frame(&zero, s).translation);
                (ends[1] - ends[0]).norm()
            });
            let aligned = matches!(
                compiled.kind,
                ClosureKind::Revolute | ClosureKind::Cylindrical | ClosureKind::Planar
            );
            let [a, b] =
                [&compiled.predecessor, &compiled.successor].map(|s| seat_frame(&zero, s).vector(&axis));
            if aligned && a.dot(&b) < REVERSED * axis.norm_squared() {
                compiled.successor_axis = -axis;
            }
            self.loops.push(compiled);
        }
        for coupling in mechanism.couplings() {
            let term = |&(joint, factor): &(percuss_mechanism::JointId, f64)| {
                let body = self.bodies.iter().find(|b| b.joint == Some(joint));
                let v = body.and_then(|b| b.v.clone().next());
                (self.joint_q[joint.index()].start, v, factor)
            };
            let turns = coupling.terms().first().is_some_and(|(joint, _)| {
                mechanism.joint(*joint).kind() != percuss_mechanism::JointKind::Prismatic
            });
            self.gears.push(Gear {
                name: coupling.name().to_owned(),
                terms: coupling.terms().iter().map(term).collect(),
                scale: if turns { mechanism.characteristic_length() } else { 1.0 },
            });
        }
        self.groups = self.find_groups();
        let joints: Vec<Option<JointId>> = self.coordinate_joints().into_iter().map(|(id, _)| id).collect();
        let lengths = self.coordinate_lengths();
        let turning = self.turning_coordinates();
        let mut groups = std::mem::take(&mut self.groups);
        for group in &mut groups {
            group.lengths = group.coordinates.iter().map(|&c| lengths[c]).collect();
            group.turning = group.coordinates.iter().map(|&c| turning[c]).collect();
            group.joints = group.coordinates.iter().map(|&c| joints[c]).collect();
            group.movable = (0..group.joints.len()).filter(|&at| group.joints[at].is_some()).collect();
            group.bodies = self.bodies_of(group);
        }
        self.groups = groups;
    }

    fn bodies_of(&self, group: &Group) -> Vec<usize> {
        let seats = group.loops.iter().flat_map(|&l| [&self.loops[l].predecessor, &self.loops[l].successor]);
        let mut bodies: Vec<usize> = Vec::new();
        for body in seats.filter_map(|seat| seat.body) {
            bodies.extend(std::iter::successors(Some(body), |&b| self.bodies[b].parent));
        }
        let positions: Vec<usize> =
            group.gears.iter().flat_map(|&g| self.gears[g].terms.iter().map(|(q, _, _)| *q)).collect();
        let of_joint = |b: &usize| {
            let body = &self.bodies[*b];
            body.joint.is_some_and(|id| group.joints.contains(&Some(id)))
                || body.q.clone().any(|q| positions.contains(&q))
        };
        bodies.extend((0..self.bodies.len()).filter(of_joint));
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// Frames of a group's bodies at the positions in `q`, mimics filled in.
    pub(crate) fn refill_group(&self, kinematics: &mut Kinematics<f64>, group: &Group) {
        kinematics.refill_bodies(self, &group.bodies);
    }

    /// Whether a loop or a coupling binds a joint.
    pub fn is_bound(&self, joint: JointId) -> bool {
        self.groups.iter().any(|group| group.joints.contains(&Some(joint)))
    }

    /// Closures whose axis points one way in the predecessor's loop frame and the other way in the successor's, with all
    /// joints at 0; they are imposed with the successor's reversed.
    pub fn reversed_axes(&self) -> impl Iterator<Item = &str> {
        self.loops.iter().filter(|l| l.successor_axis != l.axis).map(|l| l.name.as_str())
    }

    /// The coordinates that no loop and no coupling binds.
    pub(crate) fn outside_loops(&self) -> Group {
        let bound = |c: &usize| self.groups.iter().any(|g| g.coordinates.binary_search(c).is_ok());
        let coordinates: Vec<usize> = (0..self.coordinates).filter(|c| !bound(c)).collect();
        let lengths = self.coordinate_lengths();
        Group {
            lengths: coordinates.iter().map(|&c| lengths[c]).collect(),
            coordinates,
            bodies: (0..self.bodies.len()).collect(),
            ..Group::default()
        }
    }

    fn loop_seat(&self, end: &LoopFrame) -> Seat {
        let seat =
            end.link.map_or(Seat { body: None, frame: percuss_spatial::Transform::identity() }, |link| {
                self.seats[link.index()].clone()
            });
        Seat { body: seat.body, frame: seat.frame * end.frame }
    }

    /// Every joint at zero, quaternions at identity.
    pub(crate) fn zero_kinematics(&self) -> Kinematics<f64> {
        let configuration = self.configuration();
        let mut kinematics = Kinematics::new(self);
        for (values, range) in configuration.values.iter().zip(&self.joint_q) {
            kinematics.q[range.clone()].copy_from_slice(values);
        }
        kinematics.refill(self);
        kinematics
    }

    /// Connected components of coordinates that share a closure or a coupling.
    fn find_groups(&self) -> Vec<Group> {
        let mut parent: Vec<usize> = (0..self.coordinates).collect();
        fn root(parent: &mut [usize], mut i: usize) -> usize {
            while parent[i] != i {
                parent[i] = parent[parent[i]];
                i = parent[i];
            }
            i
        }
        let of_loops: Vec<Vec<usize>> = self.loops.iter().map(|l| self.bound_by_loop(l)).collect();
        let of_gears: Vec<Vec<usize>> = self.gears.iter().map(|g| self.bound_by_gear(g)).collect();
        for bound in of_loops.iter().chain(&of_gears) {
            for pair in bound.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|c| root(&mut parent, c));
                parent[a] = b;
            }
        }
        let mut groups: Vec<Group> = Vec::new();
        let mut of_root = vec![None; self.coordinates];
        // A closure that binds no coordinate (all locked, or rigid) is a group of its own.
        let mut place = |bound: &[usize], parent: &mut [usize], groups: &mut Vec<Group>| {
            let slot = bound.first().map(|&c| root(parent, c));
            let known = slot.and_then(|s| of_root[s]);
            known.unwrap_or_else(|| {
                groups.push(Group::default());
                if let Some(slot) = slot {
                    of_root[slot] = Some(groups.len() - 1);
                }
                groups.len() - 1
            })
        };
        for (i, bound) in of_loops.iter().enumerate() {
            let group = place(bound, &mut parent, &mut groups);
            groups[group].loops.push(i);
        }
        for (i, bound) in of_gears.iter().enumerate() {
            let group = place(bound, &mut parent, &mut groups);
            groups[group].gears.push(i);
        }
        for c in 0..self.coordinates {
            if let Some(group) = of_root[root(&mut parent, c)] {
                groups[group].coordinates.push(c);
            }
        }
        groups
    }

    fn bound_by_loop(&self, l: &Loop) -> Vec<usize> {
        let mut bound = Vec::new();
        self.for_each_support(l.successor.body, l.predecessor.body, |i, _| {
            bound.extend(self.bodies[i].v.clone().filter_map(|v| self.follows[v]).map(|f| f.index));
        });
        bound
    }

    fn bound_by_gear(&self, gear: &Gear) -> Vec<usize> {
        gear.terms.iter().filter_map(|(_, v, _)| self.follows[(*v)?]).map(|f| f.index).collect()
    }
}

/// A seat's frame, seen from the root link.
pub(crate) fn seat_frame(kinematics: &Kinematics<f64>, seat: &Seat) -> percuss_spatial::Transform<f64> {
    match seat.body {
        Some(body) => kinematics.frames[body] * seat.frame,
        None => seat.frame,
    }
}

//! Spanning tree of the parts of a dataset, and the joints that close its loops.

use crate::reading::report::{Place, Report};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder,
};
use percuss_spatial::{Transform, Vector3};
use std::collections::{HashMap, HashSet, VecDeque};

/// Largest distance of the two markers of a joint, relative to the size of the model, and largest angle between their axes (rad): the last
/// digits of a dataset.
const OPEN_JOINT: f64 = 1e-6;

/// Marker of a part.
pub(super) struct Marker {
    pub part: String,
    /// Frame in the part.
    pub frame: Transform<f64>,
    /// Argument that is not read and determines the frame.
    pub unread: Option<String>,
}

/// Part of a dataset.
pub(super) struct Part {
    pub id: String,
    pub name: String,
    /// Frame in the ground.
    pub frame: Transform<f64>,
    pub is_ground: bool,
    /// Mass and inertia in the frame of the part.
    pub inertial: Option<Inertial>,
    pub at: usize,
}

/// Kind of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ConnectionKind {
    Revolute,
    Translational,
    Cylindrical,
    Spherical,
    Universal,
    Planar,
    Fixed,
}

/// Joint between two parts.
pub(super) struct Connection {
    pub name: String,
    /// Statement, for messages.
    pub id: String,
    pub kind: ConnectionKind,
    /// Markers I and J: index of the part, frame in the part.
    pub ends: [(usize, Transform<f64>); 2],
    pub at: usize,
}

impl Connection {
    /// Markers as drawn, in the ground.
    fn drawn(&self, parts: &[Part]) -> [Transform<f64>; 2] {
        self.ends.map(|(part, frame)| parts[part].frame * frame)
    }

    /// Distance (m) and angle (rad) by which the drawing violates the joint.
    fn violation(&self, parts: &[Part]) -> [f64; 2] {
        let [i, j] = self.drawn(parts);
        let (zi, zj) = (i.rotation.column(2).into_owned(), j.rotation.column(2).into_owned());
        let apart: Vector3<f64> = i.translation - j.translation;
        let (along, tilt) = (apart.dot(&zj), zi.cross(&zj).norm());
        let tilt = if zi.dot(&zj) < 0.0 { std::f64::consts::PI - tilt } else { tilt };
        let turned = (i.rotation - j.rotation).norm();
        match self.kind {
            ConnectionKind::Spherical => [apart.norm(), 0.0],
            ConnectionKind::Revolute => [apart.norm(), tilt],
            ConnectionKind::Cylindrical => [(apart - along * zj).norm(), tilt],
            ConnectionKind::Translational => [(apart - along * zj).norm(), turned],
            ConnectionKind::Planar => [along.abs(), tilt],
            ConnectionKind::Universal => [apart.norm(), zi.dot(&zj).abs()],
            ConnectionKind::Fixed => [apart.norm(), turned],
        }
    }
}

/// Mechanism under construction.
struct Graph<'p> {
    parts: &'p [Part],
    /// Frame of each link in its part; `None` before the part is in the tree. Its axes are those of the part.
    frames: Vec<Option<Transform<f64>>>,
    builder: MechanismBuilder,
    names: HashSet<String>,
    /// Byte of the statement of each link, joint and closure.
    places: HashMap<String, usize>,
}

/// Builder of the mechanism with the places of its links, joints and closures; `None` after an error. The tree grows from the ground over the joints
/// in the order of the dataset; other parts float.
pub(super) fn mechanism_of(
    title: &str,
    parts: &[Part],
    connections: &[Connection],
    report: &mut Report,
) -> Option<(MechanismBuilder, HashMap<String, usize>)> {
    let size =
        connections.iter().flat_map(|connection| connection.drawn(parts)).map(|at| at.translation.norm());
    let size = size.fold(0.0, f64::max);
    for connection in connections {
        let [distance, angle] = connection.violation(parts);
        if distance > OPEN_JOINT * size || angle > OPEN_JOINT.sqrt() {
            let message = || {
                format!(
                    "its markers I and J are {distance:.3e} m and {angle:.3e} rad off the positions of this joint: save the dataset at the assembled \
                     position"
                )
            };
            report.error("open-loop", Place::Named(connection.at, &connection.id), message);
        }
    }
    if report.has_errors() {
        return None;
    }
    let mut joints_of: Vec<Vec<usize>> = vec![Vec::new(); parts.len()];
    for (k, connection) in connections.iter().enumerate() {
        connection.ends.iter().for_each(|(part, _)| joints_of[*part].push(k));
    }
    let ground = parts.iter().position(|part| part.is_ground)?;
    let mut graph = Graph {
        parts,
        frames: vec![None; parts.len()],
        builder: MechanismBuilder::new(title),
        names: HashSet::new(),
        places: HashMap::new(),
    };
    graph.add_link(ground, Transform::identity());
    let mut is_used = vec![false; connections.len()];
    for start in std::iter::once(ground).chain(0..parts.len()) {
        if graph.frames[start].is_none() {
            graph.add_floating(ground, start);
        }
        let mut queue = VecDeque::from([start]);
        while let Some(parent) = queue.pop_front() {
            for &k in &joints_of[parent] {
                let connection = &connections[k];
                let child_end = usize::from(connection.ends[0].0 == parent);
                if is_used[k] || graph.frames[connection.ends[child_end].0].is_some() {
                    continue;
                }
                is_used[k] = true;
                graph.add_tree_joint(connection, child_end);
                queue.push_back(connection.ends[child_end].0);
            }
        }
    }
    let closing = connections.iter().zip(is_used).filter(|(_, is_used)| !is_used);
    closing.for_each(|(connection, _)| graph.add_closure(connection));
    Some((graph.builder, graph.places))
}

impl Graph<'_> {
    /// Name that no joint has yet, with the place of its statement.
    fn unique(&mut self, wanted: &str, id: &str, at: usize) -> String {
        let mut name = wanted.to_owned();
        if self.names.contains(&name) {
            name = format!("{wanted}_{}", id.rsplit('/').next().unwrap_or_default());
        }
        self.names.insert(name.clone());
        self.places.insert(name.clone(), at);
        name
    }

    /// Adds the link of a part, with its frame in the part.
    fn add_link(&mut self, part: usize, frame: Transform<f64>) {
        let Part { name, inertial, at, is_ground, .. } = &self.parts[part];
        let mut link = LinkDescription::massless(name);
        link.inertial = inertial.map(|own| Inertial { com: own.com - frame.translation, ..own });
        if !is_ground {
            self.places.insert(name.clone(), *at);
        }
        self.frames[part] = Some(frame);
        self.builder = std::mem::take(&mut self.builder).link(link);
    }

    /// Frame of the link of a part in the ground, as drawn.
    fn link_frame(&self, part: usize) -> Transform<f64> {
        self.parts[part].frame * self.frames[part].unwrap_or_else(Transform::identity)
    }

    fn add_joint(&mut self, joint: JointDescription) {
        self.builder = std::mem::take(&mut self.builder).joint(joint);
    }

    /// Adds a part that no joint connects with the ground.
    fn add_floating(&mut self, ground: usize, part: usize) {
        let (name, at) = (format!("{}_free", self.parts[part].name), self.parts[part].at);
        let name = self.unique(&name, &self.parts[part].id, at);
        let origin = self.link_frame(ground).inverse() * self.parts[part].frame;
        let joint = JointDescription::new(
            name,
            JointKind::Floating,
            &self.parts[ground].name,
            &self.parts[part].name,
        );
        self.add_joint(joint.origin(origin));
        self.add_link(part, Transform::identity());
    }

    /// Adds a joint of the tree to the part of an end. The link frame of this part is at its marker, with the axes of the part; a joint between two
    /// motions has a massless link.
    fn add_tree_joint(&mut self, connection: &Connection, child_end: usize) {
        let (parent, child) = (connection.ends[1 - child_end].0, connection.ends[child_end].0);
        let markers = connection.drawn(self.parts);
        let own = Transform::from_translation(connection.ends[child_end].1.translation);
        let frame = self.parts[child].frame * own;
        let above = self.link_frame(parent);
        let name = self.unique(&connection.name, &connection.id, connection.at);
        let [parent_name, child_name] = [parent, child].map(|part| self.parts[part].name.clone());
        let z = |end: usize| markers[end].rotation.column(2).into_owned();
        // Positive: the marker I moves along, or turns about, the z-axis of J.
        let axis = if child_end == 0 { z(1) } else { -z(0) };
        let in_link = |axis: Vector3<f64>| <[f64; 3]>::from(frame.inverse_vector(&axis));
        let joint = |name: String, kind, parent: &str, child: &str, origin, axis: Vector3<f64>| {
            let joint = JointDescription::new(name, kind, parent, child).origin(origin);
            if kind == JointKind::Fixed || kind == JointKind::Spherical {
                joint
            } else {
                joint.axis(in_link(axis))
            }
        };
        let origin = above.inverse() * frame;
        let single = match connection.kind {
            ConnectionKind::Revolute => Some(JointKind::Continuous),
            ConnectionKind::Translational => Some(JointKind::Prismatic),
            ConnectionKind::Spherical => Some(JointKind::Spherical),
            ConnectionKind::Planar => Some(JointKind::Planar),
            ConnectionKind::Fixed => Some(JointKind::Fixed),
            ConnectionKind::Cylindrical | ConnectionKind::Universal => None,
        };
        match single {
            Some(kind) => self.add_joint(joint(name, kind, &parent_name, &child_name, origin, axis)),
            None => {
                let (first, kinds, axes) = if connection.kind == ConnectionKind::Cylindrical {
                    ("slide", [JointKind::Prismatic, JointKind::Continuous], [axis, axis])
                } else {
                    ("cross", [JointKind::Continuous; 2], [z(1 - child_end), z(child_end)])
                };
                let between = format!("{name}_{first}");
                self.builder = std::mem::take(&mut self.builder).link(LinkDescription::massless(&between));
                let second = format!("{name}_second");
                self.places.insert(second.clone(), connection.at);
                self.add_joint(joint(name, kinds[0], &parent_name, &between, origin, axes[0]));
                self.add_joint(joint(
                    second,
                    kinds[1],
                    &between,
                    &child_name,
                    Transform::identity(),
                    axes[1],
                ));
            }
        }
        self.add_link(child, own);
    }

    /// Adds a joint that closes a loop, with the marker J as the frame of the predecessor.
    fn add_closure(&mut self, connection: &Connection) {
        let kind = match connection.kind {
            ConnectionKind::Revolute => ClosureKind::Revolute,
            ConnectionKind::Translational => ClosureKind::Prismatic,
            ConnectionKind::Cylindrical => ClosureKind::Cylindrical,
            ConnectionKind::Spherical => ClosureKind::Spherical,
            ConnectionKind::Universal => ClosureKind::Universal,
            ConnectionKind::Planar => ClosureKind::Planar,
            ConnectionKind::Fixed => ClosureKind::Fixed,
        };
        let name = self.unique(&connection.name, &connection.id, connection.at);
        let [(i, of_i), (j, of_j)] = connection.ends;
        let in_link =
            |part: usize, marker| self.frames[part].unwrap_or_else(Transform::identity).inverse() * marker;
        let (predecessor_frame, successor_frame) = (in_link(j, of_j), in_link(i, of_i));
        let mut closure = ClosureDescription::new(name, kind, &self.parts[j].name, &self.parts[i].name)
            .axis([0.0, 0.0, 1.0])
            .axis2([0.0, 0.0, 1.0]);
        (closure.predecessor_frame, closure.successor_frame) = (predecessor_frame, successor_frame);
        self.builder = std::mem::take(&mut self.builder).closure(closure);
    }
}

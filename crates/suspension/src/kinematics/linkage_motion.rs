//! Velocities and accelerations of all links of a linkage at a pose, exact to rounding.
//!
//! Every rigid group of links has a twist (ω, v of its origin) in world axes. A joint between the bodies P and C gives rows
//! of three kinds; e is a direction fixed in P, c a point of C:
//!
//! | row      | velocity                           | acceleration                                                       |
//! |----------|------------------------------------|--------------------------------------------------------------------|
//! | linear   | e · (v_C(c) − v_P(c)) = 0          | e · (a_C(c) − a_P(c) − 2 ω_P × v_rel) = 0                          |
//! | angular  | e · (ω_C − ω_P) = 0                | e · (α_C − α_P) + (ω_P × e) · (ω_C − ω_P) = 0                      |
//! | distance | d · (v_C(c) − v_P(p)) = 0          | d · (a_C(c) − a_P(p)) + |v_C(c) − v_P(p)|² = 0, d = c − p          |
//!
//! The coordinates of the mechanism do not enter: the rows depend on the frames of the links alone. Source: Shabana,
//! *Dynamics of Multibody Systems*, 2013, §3.3 (constraint Jacobian and its quadratic velocity terms).

use crate::kinematics::wheel_points::RACK;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{DeterminedSystem, Pose};
use percuss_mechanism::{ClosureKind, JointId, JointKind, LinkId, LoopFrame, Mechanism};

/// Point in the world, m, on a link; `None` is the ground.
pub(crate) type LinkedPoint = (Option<LinkId>, Vector3<f64>);

/// Twists of all bodies, or their rates.
#[derive(Clone, Debug)]
struct BodyMotion {
    angular: Vec<Vector3<f64>>,
    linear: Vec<Vector3<f64>>,
}

/// Velocities and accelerations of all bodies along a motion with one parameter.
#[derive(Clone, Debug)]
pub(crate) struct LinkageMotion<'l> {
    linkage: &'l Linkage,
    velocity: BodyMotion,
    acceleration: BodyMotion,
}

/// Geometry of a row; points and directions in the world.
#[derive(Clone, Copy, Debug)]
enum RowKind {
    Linear { along: Vector3<f64>, at: Vector3<f64> },
    Angular { along: Vector3<f64> },
    Distance { from: Vector3<f64>, to: Vector3<f64> },
}

/// Constraint or condition between two bodies; `None` is the ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotionRow {
    first: Option<usize>,
    second: Option<usize>,
    kind: RowKind,
}

/// Rigid groups of links and their constraints at a pose.
#[derive(Clone, Debug)]
pub(crate) struct Linkage {
    /// Body of each link, in link order; `None` for links fixed to the root.
    bodies: Vec<Option<usize>>,
    origins: Vec<Vector3<f64>>,
    rows: Vec<MotionRow>,
}

/// Part of a mechanism for which the rows are not defined.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// Joint or closure of an unsupported kind.
    #[error("\"{name}\" is of a kind that suspensions do not have")]
    Unsupported {
        /// Joint or closure.
        name: String,
    },
    /// The conditions leave a motion free, or exclude one another.
    #[error("the conditions do not determine the motion of the linkage at this pose")]
    Undetermined,
}

/// Two unit vectors normal to a direction and to each other.
fn normals(along: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = along.iamin();
    let mut other = Vector3::zeros();
    other[least] = 1.0;
    let first = along.cross(&other).normalize();
    [first, along.cross(&first)]
}

impl Linkage {
    /// Collects the bodies and the constraints of a pose. The root link is fixed.
    pub fn new(pose: &Pose) -> Result<Self, MotionError> {
        let mechanism = &**pose.mechanism();
        let mut linkage =
            Self { bodies: vec![None; mechanism.links().len()], origins: Vec::new(), rows: Vec::new() };
        for &link in mechanism.order() {
            let Some(joint) = mechanism.parent_joint(link) else { continue };
            let joint = mechanism.joint(joint);
            linkage.bodies[link.index()] = match joint.kind() {
                JointKind::Fixed if joint.name() != RACK => linkage.bodies[joint.parent().index()],
                _ => {
                    linkage.origins.push(pose.link(link).translation);
                    Some(linkage.origins.len() - 1)
                }
            };
        }
        for joint in mechanism.joints() {
            let (parent, child) = (Some(joint.parent()), Some(joint.child()));
            let frame = pose.link(joint.child());
            let (at, axis) = (frame.translation, frame.vector(joint.axis()));
            let unsupported = || MotionError::Unsupported { name: joint.name().to_owned() };
            if joint.mimic().is_some() {
                return Err(unsupported());
            }
            match joint.kind() {
                // The rack of a suspension slides along y, also if it is fixed in the mechanism.
                JointKind::Fixed if joint.name() == RACK => {
                    linkage.add_equal_orientation(parent, child);
                    linkage.add_line(parent, child, at, Vector3::y());
                }
                JointKind::Fixed | JointKind::Floating => {}
                JointKind::Revolute | JointKind::Continuous => {
                    linkage.add_point(parent, child, at);
                    linkage.add_parallel_axes(parent, child, axis);
                }
                JointKind::Spherical => linkage.add_point(parent, child, at),
                JointKind::Prismatic => {
                    linkage.add_equal_orientation(parent, child);
                    linkage.add_line(parent, child, at, axis);
                }
                JointKind::Planar => return Err(unsupported()),
            }
        }
        if let Some(coupling) = mechanism.couplings().first() {
            return Err(MotionError::Unsupported { name: coupling.name().to_owned() });
        }
        for closure in mechanism.closures() {
            let unsupported = || MotionError::Unsupported { name: closure.name().to_owned() };
            let (first, second) = (closure.predecessor(), closure.successor());
            let (one, other) = (first.link, second.link);
            let (from, to) = (loop_frame(pose, mechanism, first), loop_frame(pose, mechanism, second));
            let (at, axis) = (to.translation, from.vector(closure.axis()));
            match closure.kind() {
                ClosureKind::Spherical => linkage.add_point(one, other, at),
                ClosureKind::Distance => {
                    let kind = RowKind::Distance { from: from.translation, to: at };
                    linkage.add(one, other, kind);
                }
                ClosureKind::Cylindrical => {
                    linkage.add_parallel_axes(one, other, axis);
                    linkage.add_line(one, other, at, axis);
                }
                ClosureKind::Revolute => {
                    linkage.add_point(one, other, at);
                    linkage.add_parallel_axes(one, other, axis);
                }
                ClosureKind::Prismatic => {
                    linkage.add_equal_orientation(one, other);
                    linkage.add_line(one, other, at, axis);
                }
                ClosureKind::Fixed => {
                    linkage.add_equal_orientation(one, other);
                    linkage.add_point(one, other, at);
                }
                ClosureKind::Universal | ClosureKind::Planar => return Err(unsupported()),
            }
        }
        Ok(linkage)
    }

    /// Index of the moving body of a link; `None` for the ground.
    fn body(&self, link: Option<LinkId>) -> Option<usize> {
        self.bodies[link?.index()]
    }

    /// Condition on the motion of the second link relative to the first.
    fn row(&self, first: Option<LinkId>, second: Option<LinkId>, kind: RowKind) -> MotionRow {
        MotionRow { first: self.body(first), second: self.body(second), kind }
    }

    /// Adds a condition on the motion of the second link relative to the first.
    fn add(&mut self, first: Option<LinkId>, second: Option<LinkId>, kind: RowKind) {
        let row = self.row(first, second, kind);
        self.rows.push(row);
    }

    /// The points of both links at `at` stay together.
    fn add_point(&mut self, first: Option<LinkId>, second: Option<LinkId>, at: Vector3<f64>) {
        for along in [Vector3::x(), Vector3::y(), Vector3::z()] {
            self.add(first, second, RowKind::Linear { along, at });
        }
    }

    /// The second link turns about the axis only.
    fn add_parallel_axes(&mut self, first: Option<LinkId>, second: Option<LinkId>, axis: Vector3<f64>) {
        for along in normals(&axis) {
            self.add(first, second, RowKind::Angular { along });
        }
    }

    /// The point of the second link stays on a line of the first.
    fn add_line(
        &mut self,
        first: Option<LinkId>,
        second: Option<LinkId>,
        at: Vector3<f64>,
        axis: Vector3<f64>,
    ) {
        for along in normals(&axis) {
            self.add(first, second, RowKind::Linear { along, at });
        }
    }

    /// The links do not turn relative to each other.
    fn add_equal_orientation(&mut self, first: Option<LinkId>, second: Option<LinkId>) {
        for along in [Vector3::x(), Vector3::y(), Vector3::z()] {
            self.add(first, second, RowKind::Angular { along });
        }
    }

    /// Condition on the speed of a point of a link along a fixed direction.
    pub fn point_row(&self, (link, at): LinkedPoint, along: Vector3<f64>) -> MotionRow {
        self.row(None, link, RowKind::Linear { along, at })
    }

    /// Condition on the rate of a turning joint.
    pub fn turn_row(&self, parent: LinkId, child: LinkId, axis: Vector3<f64>) -> MotionRow {
        self.row(Some(parent), Some(child), RowKind::Angular { along: axis })
    }

    /// Condition on the rate of the distance of two points, times the distance.
    pub fn distance_row(&self, (first, from): LinkedPoint, (second, to): LinkedPoint) -> MotionRow {
        self.row(first, second, RowKind::Distance { from, to })
    }

    /// Motion in which each condition has its rate; the second derivatives of the conditions are zero.
    ///
    /// Householder QR with column pivoting of the rows, once for velocities and accelerations.
    pub fn solve(&self, conditions: &[(MotionRow, f64)]) -> Result<LinkageMotion<'_>, MotionError> {
        let (bodies, constraints) = (self.origins.len(), self.rows.len());
        let all: Vec<MotionRow> =
            self.rows.iter().copied().chain(conditions.iter().map(|(row, _)| *row)).collect();
        let mut matrix = DMatrix::zeros(all.len().max(6 * bodies), 6 * bodies);
        for (i, row) in all.iter().enumerate() {
            self.fill_row(&mut matrix, i, row);
        }
        let height = matrix.nrows();
        let system = DeterminedSystem::new(matrix).ok_or(MotionError::Undetermined)?;
        let solution = |target: DVector<f64>| -> Result<BodyMotion, MotionError> {
            let x = system.solve(&target).ok_or(MotionError::Undetermined)?;
            let part = |body: usize, first: usize| x.fixed_rows::<3>(6 * body + first).into_owned();
            Ok(BodyMotion {
                angular: (0..bodies).map(|body| part(body, 0)).collect(),
                linear: (0..bodies).map(|body| part(body, 3)).collect(),
            })
        };
        let mut target = DVector::zeros(height);
        for (i, (_, rate)) in conditions.iter().enumerate() {
            target[constraints + i] = *rate;
        }
        let velocity = solution(target)?;
        let mut target = DVector::zeros(height);
        for (i, row) in all.iter().enumerate() {
            target[i] = -self.quadratic_velocity_term(&velocity, row);
        }
        let acceleration = solution(target)?;
        Ok(LinkageMotion { linkage: self, velocity, acceleration })
    }

    fn fill_row(&self, matrix: &mut DMatrix<f64>, i: usize, row: &MotionRow) {
        let mut add = |body: Option<usize>, angular: Vector3<f64>, linear: Vector3<f64>| {
            let Some(body) = body else { return };
            for k in 0..3 {
                matrix[(i, 6 * body + k)] += angular[k];
                matrix[(i, 6 * body + 3 + k)] += linear[k];
            }
        };
        let arm = |body: Option<usize>, at: &Vector3<f64>| {
            body.map_or_else(Vector3::zeros, |b| at - self.origins[b])
        };
        match row.kind {
            RowKind::Linear { along, at } => {
                add(row.second, arm(row.second, &at).cross(&along), along);
                add(row.first, -arm(row.first, &at).cross(&along), -along);
            }
            RowKind::Angular { along } => {
                add(row.second, along, Vector3::zeros());
                add(row.first, -along, Vector3::zeros());
            }
            RowKind::Distance { from, to } => {
                let along = to - from;
                add(row.second, arm(row.second, &to).cross(&along), along);
                add(row.first, -arm(row.first, &from).cross(&along), -along);
            }
        }
    }

    /// Terms of the acceleration of a row that are quadratic in the velocities.
    fn quadratic_velocity_term(&self, velocity: &BodyMotion, row: &MotionRow) -> f64 {
        let omega = |body: Option<usize>| body.map_or_else(Vector3::zeros, |b| velocity.angular[b]);
        let speed = |body: Option<usize>, at: &Vector3<f64>| {
            body.map_or_else(Vector3::zeros, |b| {
                velocity.linear[b] + velocity.angular[b].cross(&(at - self.origins[b]))
            })
        };
        let centripetal = |body: Option<usize>, at: &Vector3<f64>| {
            body.map_or_else(Vector3::zeros, |b| {
                velocity.angular[b].cross(&velocity.angular[b].cross(&(at - self.origins[b])))
            })
        };
        match row.kind {
            RowKind::Linear { along, at } => {
                let relative = speed(row.second, &at) - speed(row.first, &at);
                let bias = centripetal(row.second, &at) - centripetal(row.first, &at);
                along.dot(&(bias - 2.0 * omega(row.first).cross(&relative)))
            }
            RowKind::Angular { along } => {
                let relative = omega(row.second) - omega(row.first);
                omega(row.first).cross(&along).dot(&relative)
            }
            RowKind::Distance { from, to } => {
                let relative = speed(row.second, &to) - speed(row.first, &from);
                let bias = centripetal(row.second, &to) - centripetal(row.first, &from);
                (to - from).dot(&bias) + relative.norm_squared()
            }
        }
    }
}

/// Frame of a closure in the world.
fn loop_frame(pose: &Pose, mechanism: &Mechanism, frame: &LoopFrame) -> percuss_spatial::Transform<f64> {
    pose.link(frame.link.unwrap_or(mechanism.root())) * frame.frame
}

impl LinkageMotion<'_> {
    /// Angular velocity of a link.
    pub fn angular_velocity(&self, link: LinkId) -> Vector3<f64> {
        self.linkage.body(Some(link)).map_or_else(Vector3::zeros, |body| self.velocity.angular[body])
    }

    /// Velocity of a point.
    pub fn velocity(&self, (link, at): LinkedPoint) -> Vector3<f64> {
        self.linkage.body(link).map_or_else(Vector3::zeros, |body| {
            let arm = at - self.linkage.origins[body];
            self.velocity.linear[body] + self.velocity.angular[body].cross(&arm)
        })
    }

    /// Acceleration of a point, the second derivative with respect to the parameter of the motion.
    pub fn acceleration(&self, (link, at): LinkedPoint) -> Vector3<f64> {
        self.linkage.body(link).map_or_else(Vector3::zeros, |body| {
            let (arm, omega) = (at - self.linkage.origins[body], self.velocity.angular[body]);
            let tangential = self.acceleration.linear[body] + self.acceleration.angular[body].cross(&arm);
            tangential + omega.cross(&omega.cross(&arm))
        })
    }

    /// First and second derivative of the angle of a turning joint: q̇ = a · ω, q̈ = a · α + (ω_P × a) · ω with the axis a, and ω and α of the child
    /// relative to the parent P.
    pub fn hinge_rates(&self, pose: &Pose, joint: JointId) -> [f64; 2] {
        let joint = pose.mechanism().joint(joint);
        let axis = pose.link(joint.child()).vector(joint.axis());
        let difference = |motion: &BodyMotion| {
            let of =
                |link| self.linkage.body(Some(link)).map_or_else(Vector3::zeros, |body| motion.angular[body]);
            of(joint.child()) - of(joint.parent())
        };
        let (omega, alpha) = (difference(&self.velocity), difference(&self.acceleration));
        let turning = self.angular_velocity(joint.parent()).cross(&axis);
        [axis.dot(&omega), axis.dot(&alpha) + turning.dot(&omega)]
    }

    /// First and second derivative of the distance of two points.
    pub fn distance_rates(&self, first: LinkedPoint, second: LinkedPoint) -> [f64; 2] {
        let line = second.1 - first.1;
        let length = line.norm();
        let speed = self.velocity(second) - self.velocity(first);
        let acceleration = self.acceleration(second) - self.acceleration(first);
        let rate = line.dot(&speed) / length;
        [rate, (line.dot(&acceleration) + speed.norm_squared() - rate * rate) / length]
    }
}

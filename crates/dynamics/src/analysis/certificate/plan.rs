//! Bodies and joints for evaluation in intervals and in `f64`: motion, momentum and their derivatives by the position of a joint.

use crate::model::Model;
use crate::tolerances::{POSITION_READING, READING};
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::JointKind;
use percuss_spatial::{
    Interval, Scalar, SpatialInertia, Transform, Twist, Wrench, plane_basis, rotation_from_quaternion,
};

/// Enclosure of a number as written.
pub(super) fn written(x: f64) -> Interval {
    Interval::around(x, READING, 0.0)
}

/// Enclosure of a position as written: a unit of angle may have been converted.
pub(super) fn position(x: f64) -> Interval {
    Interval::around(x, POSITION_READING, 0.0)
}

/// Enclosure of a vector as written, with the roundings of its largest component.
pub(super) fn written_vector(v: &Vector3<f64>) -> Vector3<Interval> {
    v.map(|x| Interval::around(x, READING, v.amax()))
}

/// Enclosure of a transform as written.
pub(super) fn written_transform(x: &Transform<f64>) -> Transform<Interval> {
    Transform::new(x.rotation.map(|r| Interval::around(r, READING, 1.0)), x.translation.map(written))
}

/// Frame on a body; on the ground if the body is `None`.
#[derive(Clone, Copy, Debug)]
pub(super) struct On<T: Scalar> {
    pub body: Option<usize>,
    pub frame: Transform<T>,
}

/// Velocity of a joint: `multiplier` times the rate of a coordinate.
#[derive(Clone, Copy, Debug)]
struct Rate<T> {
    coordinate: usize,
    multiplier: T,
    armature: T,
}

/// A body with the joint to its parent. The axis of the joint is the z-axis of the frame.
#[derive(Clone, Debug)]
pub(super) struct Step<T: Scalar> {
    pub parent: Option<usize>,
    pub kind: JointKind,
    /// X: joint frame in the parent body.
    origin: Transform<T>,
    inertia: SpatialInertia<T>,
    /// Index of the first position.
    pub q: usize,
    /// Master, multiplier and offset of a mimic.
    pub mimic: Option<(usize, T, T)>,
    rates: Vec<Rate<T>>,
}

/// Bodies, parents first.
#[derive(Clone, Debug)]
pub(super) struct Plan<T: Scalar> {
    pub steps: Vec<Step<T>>,
    pub coordinates: usize,
}

/// Rates of the coordinates with the twists and the balances of all bodies.
pub(super) struct Motion<T: Scalar> {
    pub u: Vec<T>,
    pub twists: Vec<Twist<T>>,
    pub balances: Vec<Wrench<T>>,
}

/// Normal that is fixed in the root link.
pub(super) struct Carried<'a, T: Scalar> {
    /// Body of the contact.
    pub body: usize,
    /// Normal in the axes of every body.
    pub normals: &'a [Vector3<T>],
    /// Velocity in the body of the contact that the normal multiplies.
    pub velocity: Vector3<T>,
}

/// Relative placement of a body at a position of its joint.
#[derive(Clone, Copy, Debug)]
pub(super) enum Placement<T: Scalar> {
    /// At the joint frame.
    Still,
    /// Rotation about z: cosine and sine.
    Turn(T, T),
    /// Translation along z.
    Slide(T),
    /// Another motion.
    General(Transform<T>),
}

fn turn_back<T: Scalar>(c: T, s: T, v: &Vector3<T>) -> Vector3<T> {
    Vector3::new(c * v.x + s * v.y, c * v.y - s * v.x, v.z)
}

impl<T: Scalar> Placement<T> {
    fn transform(&self) -> Transform<T> {
        let zero = T::zero();
        match *self {
            Self::Still => Transform::identity(),
            Self::Turn(c, s) => {
                let rotation = Matrix3::new(c, -s, zero, s, c, zero, zero, zero, T::one());
                Transform::new(rotation, Vector3::zeros())
            }
            Self::Slide(x) => Transform::from_translation(Vector3::new(zero, zero, x)),
            Self::General(x) => x,
        }
    }

    /// Components in the child of a vector given in the joint frame.
    fn vector_to_child(&self, v: &Vector3<T>) -> Vector3<T> {
        match *self {
            Self::Still | Self::Slide(_) => *v,
            Self::Turn(c, s) => turn_back(c, s, v),
            Self::General(x) => x.inverse_vector(v),
        }
    }

    /// Components in the joint frame of a vector given in the child.
    fn vector_to_joint(&self, v: &Vector3<T>) -> Vector3<T> {
        match *self {
            Self::Still | Self::Slide(_) => *v,
            Self::Turn(c, s) => turn_back(c, -s, v),
            Self::General(x) => x.vector(v),
        }
    }

    fn twist_to_child(&self, v: &Twist<T>) -> Twist<T> {
        match *self {
            Self::Still => *v,
            Self::Turn(c, s) => Twist::new(turn_back(c, s, &v.angular), turn_back(c, s, &v.linear)),
            Self::Slide(x) => {
                let w = v.angular;
                Twist::new(w, v.linear + Vector3::new(w.y * x, -(w.x * x), T::zero()))
            }
            Self::General(x) => x.inverse_twist(v),
        }
    }

    fn wrench_to_joint(&self, f: &Wrench<T>) -> Wrench<T> {
        match *self {
            Self::Still => *f,
            Self::Turn(c, s) => Wrench::new(turn_back(c, -s, &f.moment), turn_back(c, -s, &f.force)),
            Self::Slide(x) => {
                let force = f.force;
                Wrench::new(f.moment + Vector3::new(-(x * force.y), x * force.x, T::zero()), force)
            }
            Self::General(x) => x.wrench(f),
        }
    }
}

impl<T: Scalar> Step<T> {
    /// Position of a joint with one velocity: q, or multiplier · q of the master + offset.
    fn position(&self, q: &[T]) -> T {
        self.mimic.map_or_else(|| q[self.q], |(master, multiplier, offset)| multiplier * q[master] + offset)
    }

    /// Placement at the positions of all joints.
    fn placement(&self, q: &[T]) -> Placement<T> {
        let turn = |angle: T| {
            let (s, c) = angle.sin_cos();
            Placement::Turn(c, s)
        };
        // The quaternion of a pose is normalised within a rounding.
        let quaternion = |k: usize| rotation_from_quaternion([q[k], q[k + 1], q[k + 2], q[k + 3]]);
        match self.kind {
            JointKind::Fixed => Placement::Still,
            JointKind::Revolute | JointKind::Continuous => turn(self.position(q)),
            JointKind::Prismatic => Placement::Slide(self.position(q)),
            JointKind::Planar => {
                let along = Vector3::new(q[self.q], q[self.q + 1], T::zero());
                Placement::General(Transform::new(turn(q[self.q + 2]).transform().rotation, along))
            }
            JointKind::Spherical => Placement::General(Transform::new(quaternion(self.q), Vector3::zeros())),
            // The floating base has no stored position.
            JointKind::Floating if self.q == usize::MAX => Placement::Still,
            JointKind::Floating => {
                let at = Vector3::new(q[self.q], q[self.q + 1], q[self.q + 2]);
                Placement::General(Transform::new(quaternion(self.q + 3), at))
            }
        }
    }

    /// Column `k` of the motion subspace, in the body's axes at its origin.
    fn column(&self, placement: &Placement<T>, k: usize) -> Twist<T> {
        let unit = |k: usize| {
            let mut e = Vector3::zeros();
            e[k] = T::one();
            e
        };
        match (self.kind, k) {
            (JointKind::Fixed, _) => Twist::zero(),
            (JointKind::Revolute | JointKind::Continuous, _) | (JointKind::Planar, 2..) => {
                Twist::new(unit(2), Vector3::zeros())
            }
            (JointKind::Prismatic, _) => Twist::new(Vector3::zeros(), unit(2)),
            (JointKind::Planar, _) => Twist::new(Vector3::zeros(), placement.vector_to_child(&unit(k))),
            (JointKind::Spherical, _) | (JointKind::Floating, 0..3) => Twist::new(unit(k), Vector3::zeros()),
            (JointKind::Floating, _) => Twist::new(Vector3::zeros(), unit(k - 3)),
        }
    }
}

impl Plan<Interval> {
    /// Bodies of a model, with the frame of every link and the index of every body of the model. All numbers are enclosures of those of
    /// the mechanism: frames and inertias of fixed links are added in intervals.
    ///
    /// A spherical joint becomes three hinges about x, y and z, after its rotation at the positions `q`: their positions are 0 there.
    pub fn of(model: &Model, q: &[f64]) -> (Self, Vec<On<Interval>>, Vec<usize>) {
        let mechanism = &model.mechanism;
        let ground = On { body: None, frame: Transform::identity() };
        let mut links = vec![ground; mechanism.links().len()];
        let (mut plan, mut bodies) =
            (Self { steps: Vec::new(), coordinates: model.coordinates.len() }, Vec::new());
        for &link in mechanism.order() {
            let joint = mechanism.parent_joint(link).map(|id| mechanism.joint(id));
            let mut on = joint.map_or(ground, |joint| {
                let parent = links[joint.parent().index()];
                On { body: parent.body, frame: parent.frame * written_transform(joint.origin()) }
            });
            let index = model.link_frames[link.index()].body.filter(|body| *body == bodies.len());
            if let Some(body) = index.map(|index| &model.bodies[index]) {
                let rate = |(v, armature): (usize, &f64)| {
                    let follows = model.velocity_coordinates[v]?;
                    let multiplier = written(follows.multiplier);
                    Some(Rate { coordinate: follows.index, multiplier, armature: written(*armature) })
                };
                let rates: Vec<_> = body.v.clone().zip(&body.armature).filter_map(rate).collect();
                let first = if body.joint.is_some() { body.q.start } else { usize::MAX };
                let mimic =
                    body.mimic.map(|mimic| (mimic.master, written(mimic.multiplier), written(mimic.offset)));
                let axis = body.motion.kind.has_axis().then(|| body.motion.axis());
                if body.motion.kind == JointKind::Spherical {
                    let quaternion = [0, 1, 2, 3].map(|k| q[first + k]);
                    let turned = Transform::new(rotation_from_quaternion(quaternion), Vector3::zeros());
                    on.frame = on.frame * written_transform(&turned);
                    for (k, axis) in [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().enumerate() {
                        let own = rates.get(k).copied().into_iter().collect();
                        on = plan.attach(on, JointKind::Revolute, Some(axis), (first + k, None), own);
                    }
                } else {
                    on = plan.attach(on, body.motion.kind, axis, (first, mimic), rates);
                }
                bodies.push(plan.steps.len() - 1);
            }
            links[link.index()] = on;
            if let (Some(step), Some(own)) = (on.body, mechanism.link(link).inertial()) {
                let size = own.about_com.amax();
                let about_com = own.about_com.map(|x| Interval::around(x, READING, size));
                let inertia = SpatialInertia::about_com(written(own.mass), own.com.map(written), about_com);
                plan.steps[step].inertia += on.frame.inertia(&inertia);
            }
        }
        (plan, links, bodies)
    }

    /// Adds a body with its joint; returns the frame of the child as given on the new body.
    fn attach(
        &mut self,
        on: On<Interval>,
        kind: JointKind,
        axis: Option<Vector3<f64>>,
        (q, mimic): (usize, Option<(usize, Interval, Interval)>),
        rates: Vec<Rate<Interval>>,
    ) -> On<Interval> {
        let turned = axis.map_or_else(Matrix3::identity, |axis| {
            let (e1, e2) = plane_basis(&axis);
            Matrix3::from_columns(&[e1, e2, axis]).map(|r| Interval::around(r, READING, 1.0))
        });
        self.steps.push(Step {
            parent: on.body,
            kind,
            origin: Transform::new(on.frame.rotation * turned, on.frame.translation),
            inertia: SpatialInertia::zero(),
            q,
            mimic,
            rates,
        });
        let frame = Transform::new(turned.transpose(), Vector3::zeros());
        On { body: Some(self.steps.len() - 1), frame }
    }

    /// Body without mass and velocity, whose position `q` turns it about an axis or moves it along the axis.
    pub fn add_massless_body(
        &mut self,
        on: On<Interval>,
        kind: JointKind,
        axis: Vector3<f64>,
        q: usize,
    ) -> On<Interval> {
        self.attach(on, kind, Some(axis), (q, None), Vec::new())
    }

    /// Turns all bodies about the axes at the ground, the last one first, by the positions: (axis, position).
    pub fn turn_all_bodies(&mut self, turns: &[(Vector3<f64>, usize)]) {
        let bodies = std::mem::take(&mut self.steps);
        let mut on = On { body: None, frame: Transform::identity() };
        for (axis, q) in turns {
            on = self.add_massless_body(on, JointKind::Revolute, *axis, *q);
        }
        let count = self.steps.len();
        self.steps.extend(bodies.into_iter().map(|step| match step.parent {
            Some(parent) => Step { parent: Some(parent + count), ..step },
            None => Step { parent: on.body, origin: on.frame * step.origin, ..step },
        }));
    }

    /// Rows of numbers of [`CertifiedTree::bodies`](super::records::CertifiedTree::bodies); `None` with a joint of several velocities.
    pub fn numbers(&self) -> Option<Vec<Vec<f64>>> {
        let (zero, one) = (Interval::point(0.0), Interval::point(1.0));
        let row = |step: &Step<Interval>| {
            let motion = match step.kind {
                JointKind::Fixed => 0.0,
                JointKind::Revolute | JointKind::Continuous => 1.0,
                JointKind::Prismatic => 2.0,
                _ => return None,
            };
            let (position, factor, offset) = step.mimic.unwrap_or((step.q, one, zero));
            let (coordinate, multiplier, armature) = match step.rates.first() {
                Some(rate) => (rate.coordinate as f64, rate.multiplier, rate.armature),
                None => (-1.0, zero, zero),
            };
            let parent = step.parent.map_or(-1.0, |parent| parent as f64);
            let mut row = vec![parent, motion, position as f64, coordinate];
            let inertia = &step.inertia;
            let [rotation, rotational] = [&step.origin.rotation, &inertia.rotational].map(|m| m.transpose());
            let numbers = [factor, offset, multiplier, armature].into_iter();
            let numbers =
                numbers.chain(rotation.iter().copied()).chain(step.origin.translation.iter().copied());
            let numbers = numbers.chain([inertia.mass]).chain(inertia.first_moment.iter().copied());
            row.extend(numbers.chain(rotational.iter().copied()).flat_map(|x| [x.lo(), x.hi()]));
            Some(row)
        };
        self.steps.iter().map(row).collect()
    }

    /// The same bodies with the middles of all numbers.
    pub fn middle(&self) -> Plan<f64> {
        let mid = |x: &Interval| x.mid();
        let step = |step: &Step<Interval>| Step {
            parent: step.parent,
            kind: step.kind,
            origin: Transform::new(
                step.origin.rotation.map(Interval::mid),
                step.origin.translation.map(Interval::mid),
            ),
            inertia: SpatialInertia {
                mass: step.inertia.mass.mid(),
                first_moment: step.inertia.first_moment.map(Interval::mid),
                rotational: step.inertia.rotational.map(Interval::mid),
            },
            q: step.q,
            mimic: step.mimic.map(|(master, multiplier, offset)| (master, mid(&multiplier), mid(&offset))),
            rates: step
                .rates
                .iter()
                .map(|rate| Rate {
                    coordinate: rate.coordinate,
                    multiplier: rate.multiplier.mid(),
                    armature: rate.armature.mid(),
                })
                .collect(),
        };
        Plan { steps: self.steps.iter().map(step).collect(), coordinates: self.coordinates }
    }
}

impl<T: Scalar> Plan<T> {
    /// Placements of all bodies at positions of the joints.
    pub fn placements(&self, q: &[T]) -> Vec<Placement<T>> {
        self.steps.iter().map(|step| step.placement(q)).collect()
    }

    /// X_rb of every body: body frame in the root link.
    pub fn frames(&self, placements: &[Placement<T>]) -> Vec<Transform<T>> {
        let mut frames: Vec<Transform<T>> = Vec::with_capacity(self.steps.len());
        for (step, placement) in self.steps.iter().zip(placements) {
            let local = step.origin * placement.transform();
            frames.push(step.parent.map_or(local, |parent| frames[parent] * local));
        }
        frames
    }

    /// Twist of every body at the rates `u` of the coordinates, in the body's frame.
    pub fn twists(&self, placements: &[Placement<T>], u: &[T]) -> Vec<Twist<T>> {
        let mut twists: Vec<Twist<T>> = Vec::with_capacity(self.steps.len());
        for (step, placement) in self.steps.iter().zip(placements) {
            let carried = step.parent.map_or_else(Twist::zero, |parent| {
                placement.twist_to_child(&step.origin.inverse_twist(&twists[parent]))
            });
            let own = step.rates.iter().enumerate().fold(carried, |sum, (k, rate)| {
                sum + step.column(placement, k) * (rate.multiplier * u[rate.coordinate])
            });
            twists.push(own);
        }
        twists
    }

    /// Loads minus momenta, summed over the subtree of every body, in the body's frame.
    pub fn balances(
        &self,
        placements: &[Placement<T>],
        twists: &[Twist<T>],
        loads: &[Wrench<T>],
    ) -> Vec<Wrench<T>> {
        let mut sums: Vec<Wrench<T>> = loads.to_vec();
        for i in (0..self.steps.len()).rev() {
            let step = &self.steps[i];
            sums[i] -= step.inertia.momentum(&twists[i]);
            if let Some(parent) = step.parent {
                let carried = step.origin.wrench(&placements[i].wrench_to_joint(&sums[i]));
                sums[parent] += carried;
            }
        }
        sums
    }

    /// Motion at the rates `u`, with loads.
    pub fn motion(&self, placements: &[Placement<T>], u: Vec<T>, loads: &[Wrench<T>]) -> Motion<T> {
        let twists = self.twists(placements, &u);
        let balances = self.balances(placements, &twists, loads);
        Motion { u, twists, balances }
    }

    /// Residual r = j − M u over the coordinates, from the balances.
    pub fn residual(&self, placements: &[Placement<T>], balances: &[Wrench<T>], u: &[T]) -> Vec<T> {
        let mut residual = vec![T::zero(); self.coordinates];
        for ((step, placement), balance) in self.steps.iter().zip(placements).zip(balances) {
            for (k, rate) in step.rates.iter().enumerate() {
                let rotor = rate.multiplier * rate.armature * (rate.multiplier * u[rate.coordinate]);
                residual[rate.coordinate] +=
                    balance.power(&step.column(placement, k)) * rate.multiplier - rotor;
            }
        }
        residual
    }

    /// 2 j·u − u·M u: twice the power of the loads minus twice the kinetic energy.
    pub fn energy_bound(&self, twists: &[Twist<T>], loads: &[Wrench<T>], u: &[T]) -> T {
        let two = T::one() + T::one();
        let mut sum = T::zero();
        for ((step, twist), load) in self.steps.iter().zip(twists).zip(loads) {
            sum += load.power(twist) * two - step.inertia.twice_energy(twist);
            for rate in &step.rates {
                let speed = rate.multiplier * u[rate.coordinate];
                sum -= rate.armature * speed * speed;
            }
        }
        sum
    }

    /// Twists and balances (minus momenta) of the unit rate of each coordinate.
    pub fn unit_motions(&self, placements: &[Placement<T>]) -> Vec<Motion<T>> {
        let none = vec![Wrench::zero(); self.steps.len()];
        let unit = |k: usize| {
            let mut u = vec![T::zero(); self.coordinates];
            u[k] = T::one();
            self.motion(placements, u, &none)
        };
        (0..self.coordinates).map(unit).collect()
    }

    /// Mass matrix M over the coordinates, column by column.
    pub fn mass_columns(&self, placements: &[Placement<T>], units: &[Motion<T>]) -> Vec<Vec<T>> {
        let column = |unit: &Motion<T>| {
            self.residual(placements, &unit.balances, &unit.u).into_iter().map(|r| -r).collect()
        };
        units.iter().map(column).collect()
    }

    /// Motion columns of a body in root axes about `point` (root frame): coordinate and twist, with the multiplier.
    pub fn columns_at(
        &self,
        body: usize,
        placements: &[Placement<T>],
        frames: &[Transform<T>],
        point: &Vector3<T>,
    ) -> impl Iterator<Item = (usize, Twist<T>)> {
        let (step, frame) = (&self.steps[body], frames[body]);
        let arm = frame.translation - point;
        step.rates.iter().enumerate().map(move |(k, rate)| {
            let column = step.column(&placements[body], k);
            let angular = frame.rotation * column.angular;
            let linear = frame.rotation * column.linear + arm.cross(&angular);
            (rate.coordinate, Twist::new(angular, linear) * rate.multiplier)
        })
    }

    /// Bodies on the path from `on` to the common ancestor with +1, and from `against` with −1.
    pub fn support(&self, mut on: Option<usize>, mut against: Option<usize>) -> Vec<(usize, f64)> {
        let mut path = Vec::new();
        // Parents have lower numbers than children.
        while on != against {
            let (end, sign) = if on > against { (&mut on, 1.0) } else { (&mut against, -1.0) };
            let Some(body) = *end else { break };
            path.push((body, sign));
            *end = self.steps[body].parent;
        }
        path
    }

    /// Coordinate and multiplier of each velocity of a body.
    pub fn rates(&self, body: usize) -> impl Iterator<Item = (usize, T)> {
        self.steps[body].rates.iter().map(|rate| (rate.coordinate, rate.multiplier))
    }

    /// Derivatives of j·a + j·b − aᵀM b by the positions of the joints with one velocity, at fixed rates a and b: position index and
    /// derivative, once for each body that the position moves.
    ///
    /// A change of a position moves the subtree as one body: twists change by δ = v × S, and the derivative is δ_a·B + δ_b·A with the
    /// balances A and B, one of which contains the loads. `carried`: normal of the contact, unless it moves with the body of the contact.
    pub fn slopes(
        &self,
        placements: &[Placement<T>],
        a: &Motion<T>,
        b: &Motion<T>,
        carried: Option<Carried<T>>,
    ) -> Vec<(usize, T)> {
        let across = |v: &Vector3<T>| Vector3::new(v.y, -v.x, T::zero());
        let change = |step: &Step<T>, twist: &Twist<T>| match step.kind {
            JointKind::Revolute | JointKind::Continuous => {
                Twist::new(across(&twist.angular), across(&twist.linear))
            }
            JointKind::Prismatic => Twist::new(Vector3::zeros(), across(&twist.angular)),
            _ => Twist::zero(),
        };
        let power = |(i, step): (usize, &Step<T>)| {
            b.balances[i].power(&change(step, &a.twists[i]))
                + a.balances[i].power(&change(step, &b.twists[i]))
        };
        let mut slopes: Vec<T> = self.steps.iter().enumerate().map(power).collect();
        if let Some(Carried { body, normals, mut velocity }) = carried {
            let mut at = Some(body);
            while let Some(i) = at {
                let step = &self.steps[i];
                if matches!(step.kind, JointKind::Revolute | JointKind::Continuous) {
                    slopes[i] += across(&normals[i]).dot(&velocity);
                }
                velocity = step.origin.vector(&placements[i].vector_to_joint(&velocity));
                at = step.parent;
            }
        }
        let of_position = |(step, slope): (&Step<T>, T)| match step.mimic {
            Some((master, multiplier, _)) => (master, slope * multiplier),
            None => (step.q, slope),
        };
        self.steps.iter().zip(slopes).map(of_position).collect()
    }

    /// A vector of the root link in the axes of every body.
    pub fn carried_vectors(&self, placements: &[Placement<T>], vector: &Vector3<T>) -> Vec<Vector3<T>> {
        let mut carried: Vec<Vector3<T>> = Vec::with_capacity(self.steps.len());
        for (step, placement) in self.steps.iter().zip(placements) {
            let parent = step.parent.map_or(*vector, |parent| carried[parent]);
            carried.push(placement.vector_to_child(&step.origin.inverse_vector(&parent)));
        }
        carried
    }
}

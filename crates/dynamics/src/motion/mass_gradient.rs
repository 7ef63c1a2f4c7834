//! Change of the effective mass along the motions of the mechanism.
//!
//! With the response v*, its multipliers λ (M v* + Aᵀλ = m̄ jᵀ) and an admissible motion w,
//!
//! ```text
//! dm̄/dt = v*ᵀ Ṁ v* + 2 λᵀ Ȧ v* − 2 m̄ j̇ v*
//! ```
//!
//! since m̄ is the least value of vᵀMv under Av = 0, jv = 1. In terms of the bodies: let R_k be the impulse that joint k
//! transmits to its child (the momentum of the subtree, plus the wrenches of its closures times λ, less m̄ times the contact
//! wrench), V_p the twist of its parent and s_k its motion column. A unit velocity of the joint turns the twist of the parent
//! relative to the subtree by V_p × s_k. Closures and contact whose wrench F moves relative to the bodies add wrenches Q:
//!
//! ```text
//! g_k = 2 R_k · (V_p × s_k) + 2 s_k · Q_k,    dm̄/dt = Σ g_k w_k
//! ```
//!
//! Cost: O(n), and one sparse solution per group of constraints. Source: derived here; the terms are those of the derivative
//! of inverse dynamics (Featherstone 2008, §5.3), with impulses in place of forces.

use crate::analysis::pose::Pose;
use crate::analysis::response::ContactResponse;
use crate::kinematics::contact::{Contact, Frame};
use crate::kinematics::outcome::{EffectiveMass, ResponseError};
use crate::kinematics::remarks::RemarkFlags;
use crate::kinematics::rows::{MOST, closure_wrench_rates, closure_wrenches};
use crate::model::{Constraint, CouplingTerm, Group, Model};
use nalgebra::Vector3;
use percuss_spatial::{Transform, Twist, Wrench};

/// Gradient of a finite effective mass.
#[derive(Clone, Debug, PartialEq)]
pub struct MassGradient {
    /// m̄, kg. For a moment, kg·m² replaces kg here and in all units below.
    pub effective_mass: f64,
    /// For each joint, in joint order, and each of its velocities: change of m̄ per unit velocity, kg/rad or kg/m. In a mechanism
    /// with loops only sums over admissible motions are defined; see [`rate`](Self::rate).
    pub joints: Vec<Vec<f64>>,
    /// Change of m̄ per unit velocity of the root link with all joints at rest: angular (kg/rad), then linear (kg/m), in root axes. With a
    /// normal n̂ that is fixed in the world, the angular part is 2 m̄ n̂ × u, with the velocity u of the contact link relative to the other
    /// side at the contact point in the response v* (angular velocities for a moment); the linear part is zero. All other normals move with
    /// the root link, and the whole is zero.
    pub base: [f64; 6],
}

impl MassGradient {
    /// dm̄/dt, kg/s, for the velocities of all joints (rad/s, m/s; in joint order) of an admissible motion. Mimics must follow
    /// their masters. Missing joints and the root link are at rest: [`base`](Self::base) has the part of the root link.
    pub fn rate(&self, velocities: &[Vec<f64>]) -> f64 {
        let of_joint = |(g, w): (&Vec<f64>, &Vec<f64>)| g.iter().zip(w).map(|(g, w)| g * w).sum::<f64>();
        self.joints.iter().zip(velocities).map(of_joint).sum()
    }
}

/// Twists and wrenches of all bodies in the response, in root axes about the contact point.
pub(in crate::motion) struct BodyResponse<'a> {
    pose: &'a Pose,
    response: &'a ContactResponse,
    mass: f64,
    /// Tree velocities v*.
    pub velocities: Vec<f64>,
    twists: Vec<Twist<f64>>,
    /// Wrenches on each body: momentum, closure and contact impulses.
    impulses: Vec<Wrench<f64>>,
    /// Wrenches Q of closures and contact that move relative to the bodies.
    turning: Vec<Wrench<f64>>,
    /// For each tree velocity: λᵀȦv* of the curves of couplings at unit velocity.
    bending: Vec<f64>,
}

impl Pose {
    /// Gradient of the effective mass of a contact. `None` unless m̄ is finite with an error of at most 1e-6 m̄
    /// ([`RemarkFlags::of_error`]): a less accurate response v* leaves the gradient no digits.
    ///
    /// ```text
    /// g = ∂m̄/∂q along admissible motions:  dm̄/dt = g · q̇   for every q̇ with A q̇ = 0
    /// ```
    ///
    /// kg/rad for rotations, kg/m for translations; layout of [`MassGradient::joints`]. Accuracy: that of the response v*,
    /// relative to the size of the terms. Cost: one response, and O(n).
    ///
    /// # Errors
    /// [`ResponseError`], as [`respond`](Self::respond).
    pub fn effective_mass_gradient(&self, contact: &Contact) -> Result<Option<MassGradient>, ResponseError> {
        let response = self.respond(contact)?;
        let EffectiveMass::Finite(mass) = response.effective_mass else { return Ok(None) };
        if !RemarkFlags::of_error(response.effective_mass, response.effective_mass_error()).is_empty() {
            return Ok(None);
        }
        let (mut bodies, multipliers) = BodyResponse::with_multipliers(self, &response, mass, contact);
        bodies.add_constraints(&multipliers);
        let base = bodies.base_gradient(contact);
        Ok(Some(MassGradient { effective_mass: mass, joints: bodies.gradient(), base }))
    }
}

/// Wrench whose power on every twist is the linear function `power`.
fn wrench_of(power: impl Fn(&Twist<f64>) -> f64) -> Wrench<f64> {
    let unit = |k: usize| Vector3::from_fn(|i, _| if i == k { 1.0 } else { 0.0 });
    let turn = |k: usize| power(&Twist::new(unit(k), Vector3::zeros()));
    let slide = |k: usize| power(&Twist::new(Vector3::zeros(), unit(k)));
    Wrench::new(Vector3::from_fn(|k, _| turn(k)), Vector3::from_fn(|k, _| slide(k)))
}

/// Frame in axes of the root, relative to a point.
pub(in crate::motion) fn about(frame: &Transform<f64>, point: &Vector3<f64>) -> Transform<f64> {
    Transform::new(frame.rotation, frame.translation - point)
}

impl<'a> BodyResponse<'a> {
    /// Twists, momenta and contact impulses of all bodies, and the multipliers λ of the rows of each group.
    pub fn with_multipliers(
        pose: &'a Pose,
        response: &'a ContactResponse,
        mass: f64,
        contact: &Contact,
    ) -> (Self, Vec<Vec<f64>>) {
        let mut bodies = Self::new(pose, response, mass);
        bodies.add_contact(contact);
        let multipliers = bodies.multipliers();
        (bodies, multipliers)
    }

    /// Twists and momenta of all bodies.
    fn new(pose: &'a Pose, response: &'a ContactResponse, mass: f64) -> Self {
        let (model, kinematics) = (pose.assembly.model(), &pose.kinematics);
        let velocities = pose.tree_velocities(response);
        let point = &response.contact.point_root;
        let (mut twists, mut impulses) = (Vec::<Twist<f64>>::new(), Vec::new());
        for (i, body) in model.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
            for (k, v) in body.v.clone().enumerate() {
                twist += kinematics.column_at(model, i, k, point) * velocities[v];
            }
            let inertia = about(&kinematics.frames[i], point).inertia(&body.inertia);
            impulses.push(inertia.momentum(&twist));
            twists.push(twist);
        }
        let turning = vec![Wrench::zero(); twists.len()];
        let bending = vec![0.0; velocities.len()];
        Self { pose, response, mass, velocities, twists, impulses, turning, bending }
    }

    fn model(&self) -> &'a Model {
        self.pose.assembly.model()
    }

    fn twist(&self, body: Option<usize>) -> Twist<f64> {
        body.map_or_else(Twist::zero, |b| self.twists[b])
    }

    fn add(list: &mut [Wrench<f64>], body: Option<usize>, wrench: Wrench<f64>) {
        if let Some(body) = body {
            list[body] += wrench;
        }
    }

    /// Adds a wrench of which the power on the relative twist of two bodies enters the balance with the factor `factor`.
    /// `rate(b, W)`: change of the wrench while body number b (0: the first, 1: the second, then `others`) has the twist W and all other
    /// bodies are at rest.
    fn add_wrench(
        &mut self,
        (on, against): (Option<usize>, Option<usize>),
        others: &[Option<usize>],
        factor: f64,
        wrench: &Wrench<f64>,
        rate: impl Fn(usize, &Twist<f64>) -> Wrench<f64>,
    ) {
        Self::add(&mut self.impulses, on, *wrench * factor);
        Self::add(&mut self.impulses, against, *wrench * -factor);
        let (first, second) = (self.twist(on), self.twist(against));
        let relative = first - second;
        for (number, &body) in [on, against].iter().chain(others).enumerate() {
            let turning = wrench_of(|motion| {
                let carried = match number {
                    0 => wrench.power(&motion.cross_motion(&first)),
                    1 => -wrench.power(&motion.cross_motion(&second)),
                    _ => 0.0,
                };
                factor * (carried + rate(number, motion).power(&relative))
            });
            Self::add(&mut self.turning, body, turning);
        }
    }

    /// Adds the contact impulse −m̄ on the contact link, and the opposite on the other side.
    fn add_contact(&mut self, contact: &Contact) {
        let model = self.model();
        let located = &self.response.contact;
        let normal = located.normal_root;
        let (on, against) = (model.body_of(contact.link), contact.against.and_then(|l| model.body_of(l)));
        // The contact point is the origin.
        let wrench = located.wrench_root();
        let line = located.line.map(|(link, to)| {
            let end = self.pose.kinematics.link_frame(model, link).point(&to) - located.point_root;
            (model.body_of(link), end)
        });
        let others: Vec<Option<usize>> = line.iter().map(|(body, _)| *body).collect();
        let carrier = match contact.normal.vector() {
            Some((_, Frame::Link)) => Some(0),
            Some((_, Frame::Against)) => Some(1),
            Some((_, Frame::World)) | None => None,
        };
        let rate = |number: usize, motion: &Twist<f64>| {
            // The line turns with the motion of its ends; the far end may be on any link.
            let along_line = |(_, end): (Option<usize>, Vector3<f64>)| {
                let speed = match number {
                    0 => -motion.linear,
                    2 => motion.velocity_at(&end),
                    _ => Vector3::zeros(),
                };
                let sense = normal.dot(&end).signum() / end.norm();
                (speed - normal * normal.dot(&speed)) * sense
            };
            let turn = match line {
                Some(line) => along_line(line),
                None if carrier == Some(number) => motion.angular.cross(&normal),
                None => Vector3::zeros(),
            };
            if located.is_moment {
                return Wrench::new(turn, Vector3::zeros());
            }
            let displaced = if number == 0 { motion.linear.cross(&normal) } else { Vector3::zeros() };
            Wrench::new(displaced, turn)
        };
        self.add_wrench((on, against), &others, -self.mass, &wrench, rate);
    }

    /// Multipliers λ of the rows of each group; 0 for redundant rows.
    fn multipliers(&self) -> Vec<Vec<f64>> {
        let model = self.model();
        if model.groups.is_empty() {
            return Vec::new();
        }
        let mut loads = self.impulses.clone();
        let mut forces = vec![0.0; self.velocities.len()];
        self.for_each_joint(&mut loads, |v, _, column, load, armature| {
            forces[v] = -(load.power(column) + armature * self.velocities[v]);
        });
        let forces = model.reduce_vector(&forces, |multiplier| multiplier);
        let of_group = |(group, known): (&Group, &crate::mobility::GroupMobility)| {
            let own: Vec<f64> = group.coordinates.iter().map(|c| forces[*c]).collect();
            known.multipliers(group, &own)
        };
        model.groups.iter().zip(&self.pose.groups).map(of_group).collect()
    }

    /// Calls `visit` for every tree velocity, children before parents: index, body, motion column, sum of the wrenches on the
    /// subtree, armature.
    fn for_each_joint(
        &self,
        wrenches: &mut [Wrench<f64>],
        mut visit: impl FnMut(usize, usize, &Twist<f64>, &Wrench<f64>, f64),
    ) {
        let (model, point) = (self.model(), &self.response.contact.point_root);
        for (i, body) in model.bodies.iter().enumerate().rev() {
            for (k, v) in body.v.clone().enumerate() {
                let column = self.pose.kinematics.column_at(model, i, k, point);
                visit(v, i, &column, &wrenches[i], body.armature[k]);
            }
            if let Some(parent) = body.parent {
                let wrench = wrenches[i];
                wrenches[parent] += wrench;
            }
        }
    }

    /// Adds the impulses of closures and held contacts. Couplings act on joints only; their rows change with a curve.
    fn add_constraints(&mut self, multipliers: &[Vec<f64>]) {
        let model = self.model();
        for (group, multipliers) in model.groups.iter().zip(multipliers) {
            for rows in &group.constraints {
                let own = &multipliers[rows.first..rows.first + rows.count];
                match rows.constraint {
                    Constraint::Closure(number) => self.add_closure(number, group.size, own),
                    Constraint::Coupling(number) => {
                        own.iter().for_each(|multiplier| self.add_curve(number, group.size, *multiplier));
                    }
                    Constraint::Hold(number) => self.add_hold(number, own),
                }
            }
        }
    }

    /// Adds the change of a coupling's row, d(f − p′(s) g) = −p″(s) ṡ g.
    fn add_curve(&mut self, number: usize, length: f64, multiplier: f64) {
        let model = self.model();
        let coupling = &model.couplings[number];
        let [_, curvature] = coupling.curve_derivatives(&self.pose.kinematics.q);
        let scale = if coupling.turns { length } else { 1.0 };
        // A locked joint has no velocity.
        let entry = |term: &CouplingTerm| Some((model.bodies[term.body].v.clone().next()?, term.argument));
        let entries = coupling.terms.iter().filter_map(entry);
        let rate: f64 = entries.clone().map(|(v, argument)| argument * self.velocities[v]).sum();
        entries.for_each(|(v, argument)| self.bending[v] -= multiplier * scale * curvature * rate * argument);
    }

    /// Adds the impulse of a closure.
    fn add_closure(&mut self, number: usize, length: f64, multipliers: &[f64]) {
        let closure = &self.model().closures[number];
        let point = &self.response.contact.point_root;
        let (predecessor, successor) = (closure.predecessor.body, closure.successor.body);
        let x_rp = about(&self.pose.kinematics.frame_of(&closure.predecessor), point);
        let x_rs = about(&self.pose.kinematics.frame_of(&closure.successor), point);
        let sum = |wrenches: &[Wrench<f64>; MOST]| {
            let own = wrenches.iter().zip(multipliers).fold(Wrench::zero(), |sum, (w, λ)| sum + *w * *λ);
            // From the successor's loop origin to the contact point.
            Wrench::new(own.moment + x_rs.translation.cross(&own.force), own.force)
        };
        let wrench = sum(&closure_wrenches(closure, &x_rp, &x_rs, length));
        let rate = |number: usize, motion: &Twist<f64>| {
            let (mut of_successor, mut of_predecessor) = (Twist::zero(), Twist::zero());
            *(if number == 0 { &mut of_successor } else { &mut of_predecessor }) = *motion;
            let rates = closure_wrench_rates(closure, &x_rp, &x_rs, length, &of_predecessor, &of_successor);
            let turned = sum(&rates);
            let displaced = of_successor.velocity_at(&x_rs.translation).cross(&wrench.force);
            Wrench::new(turned.moment + displaced, turned.force)
        };
        self.add_wrench((successor, predecessor), &[], 1.0, &wrench, rate);
    }

    /// Adds the impulse of a held contact. Its directions are fixed in the root's axes, its point in the link.
    fn add_hold(&mut self, number: usize, multipliers: &[f64]) {
        let hold = &self.model().holds[number];
        let link = self.pose.kinematics.link_frame(self.model(), hold.link);
        let at = link.point(&hold.point) - self.response.contact.point_root;
        let force: Vector3<f64> = hold.directions().iter().zip(multipliers).map(|(d, λ)| d * *λ).sum();
        let rate = |number: usize, motion: &Twist<f64>| {
            let speed = if number == 0 { motion.velocity_at(&at) } else { Vector3::zeros() };
            Wrench::new(speed.cross(&force), Vector3::zeros())
        };
        let body = self.model().body_of(hold.link);
        self.add_wrench((body, None), &[], 1.0, &Wrench::of_force(force, &at), rate);
    }

    /// g of the root link: the link and the normal turn together, less the turn of a normal that is fixed in the world.
    fn base_gradient(&self, contact: &Contact) -> [f64; 6] {
        let is_fixed = match contact.normal.vector() {
            Some((_, Frame::World)) => true,
            Some((_, Frame::Against)) => contact.against.is_none(),
            Some((_, Frame::Link)) | None => false,
        };
        if !is_fixed {
            return [0.0; 6];
        }
        let (model, located) = (self.model(), &self.response.contact);
        let against = contact.against.and_then(|link| model.body_of(link));
        let relative = self.twist(model.body_of(contact.link)) - self.twist(against);
        // The contact point is the origin of the twists.
        let velocity = if located.is_moment { relative.angular } else { relative.linear };
        let turn = 2.0 * self.mass * located.normal_root.cross(&velocity);
        [turn.x, turn.y, turn.z, 0.0, 0.0, 0.0]
    }

    /// g of every joint.
    fn gradient(&self) -> Vec<Vec<f64>> {
        let (model, kinematics) = (self.model(), &self.pose.kinematics);
        let mut tree = vec![0.0; self.velocities.len()];
        let (mut impulses, mut turning) = (self.impulses.clone(), self.turning.clone());
        self.for_each_joint(&mut impulses, |v, i, column, impulse, _| {
            let body = &model.bodies[i];
            let own = &self.velocities[body.v.clone()];
            let bias = body.motion.column_rate(v - body.v.start, &kinematics.q[body.q.clone()], own);
            let bias = Twist::new(Vector3::zeros(), kinematics.frames[i].vector(&bias.linear));
            let parent = self.twist(body.parent);
            tree[v] = 2.0 * (impulse.power(&(parent.cross_motion(column) + bias)) + self.bending[v]);
        });
        self.for_each_joint(&mut turning, |v, _, column, wrench, _| tree[v] += 2.0 * wrench.power(column));
        let of_joint =
            |body: &Option<usize>| body.map_or_else(Vec::new, |b| tree[model.bodies[b].v.clone()].to_vec());
        let mut joints: Vec<Vec<f64>> = model.body_of_joint.iter().map(of_joint).collect();
        for (joint, rates) in model.mechanism.joints().iter().zip(&mut joints) {
            // A locked joint has no velocity.
            rates.resize(joint.kind().dofs(), 0.0);
        }
        joints
    }
}

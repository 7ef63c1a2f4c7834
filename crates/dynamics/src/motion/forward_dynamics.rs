//! Accelerations under given forces, by the articulated-body algorithm in body coordinates, without matrices.

use crate::analysis::pose::Pose;
use crate::kinematics::outcome::RouteError;
use crate::model::Model;
use crate::model::input::foreign_link;
use crate::model::velocities::check_velocities;
use crate::tolerances::ACCELERATION_PIVOT;
use nalgebra::Vector3;
use percuss_mechanism::LinkId;
use percuss_spatial::{ArticulatedInertia, Twist, Wrench};

/// A force (N, root axes) on a point of a link (m, link frame).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// The link.
    pub link: LinkId,
    /// Point of application in the frame of the link, m.
    pub point: Vector3<f64>,
    /// Force in root axes, N.
    pub force: Vector3<f64>,
}

/// Accelerations of a moving mechanism.
#[derive(Clone, Debug)]
pub struct Accelerations {
    /// Spatial velocity and acceleration of every body, in the body's axes at its origin, relative to an inertial
    /// frame.
    motions: Vec<(Twist<f64>, Twist<f64>)>,
    /// Rates of the velocities of every joint, in joint order.
    pub joints: Vec<Vec<f64>>,
}

/// Intermediate values of the recursion for one velocity.
#[derive(Clone)]
struct ForwardStep {
    s: Twist<f64>,
    u: Wrench<f64>,
    d: f64,
    /// Remaining generalised force of this velocity.
    t: f64,
}

/// Refuses held contacts, loops and mimics.
fn refuse_bound(model: &Model) -> Result<(), RouteError> {
    if model.groups.iter().any(|g| g.is_held) {
        Err(RouteError::Bound { what: "held contacts" })
    } else if !model.groups.is_empty() {
        Err(RouteError::Bound { what: "loops" })
    } else if model.has_active_mimics {
        Err(RouteError::Bound { what: "mimics" })
    } else {
        Ok(())
    }
}

fn refuse_foreign(model: &Model, link: LinkId) -> Result<(), RouteError> {
    let links = model.link_frames.len();
    foreign_link(&model.mechanism, [link])
        .map_or(Ok(()), |index| Err(RouteError::ForeignLink { index, links }))
}

impl Pose {
    /// Accelerations at a pose with joint velocities (joint order), under gravity (m/s², root axes) and point forces.
    /// A fixed root link is at rest in the world; a floating root link has the twist `base`.
    ///
    /// pᴬ = v × I v − f; per joint U = Iᴬ S, D = SᵀU + armature, t = −Sᵀpᴬ; q̈ = D⁻¹(t − Uᵀa′). Featherstone 2008,
    /// table 7.1. The velocities of a joint with several velocities are eliminated one after another.
    ///
    /// # Errors
    /// [`RouteError`]: loops, mimics or held contacts; a joint that moves no mass; velocities or a link of another
    /// mechanism.
    pub fn accelerations(
        &self,
        velocities: &[Vec<f64>],
        base: &Twist<f64>,
        gravity: &Vector3<f64>,
        forces: &[PointForce],
    ) -> Result<Accelerations, RouteError> {
        let model = self.assembly.model();
        refuse_bound(model)?;
        check_velocities(&model.mechanism, velocities)?;
        forces.iter().try_for_each(|force| refuse_foreign(model, force.link))?;
        let kinematics = &self.kinematics;
        let n = model.bodies.len();
        let mut motions = vec![Twist::zero(); n];
        let mut biases = vec![Twist::zero(); n];
        let mut inertias = Vec::with_capacity(n);
        let mut wrenches = Vec::with_capacity(n);
        for (i, body) in model.bodies.iter().enumerate() {
            let propagated = body
                .parent
                .map_or_else(Twist::zero, |p| kinematics.parent_transforms[i].inverse_twist(&motions[p]));
            let own = match body.joint {
                None => *base,
                Some(id) => body.v.clone().enumerate().fold(Twist::zero(), |sum, (k, _)| {
                    sum + kinematics.column(model, i, k) * velocities[id.index()][k]
                }),
            };
            motions[i] = propagated + own;
            biases[i] = motions[i].cross_motion(&own);
            if let Some(id) = body.joint.filter(|_| !body.v.is_empty()) {
                biases[i] += body.motion.bias(&kinematics.q[body.q.clone()], &velocities[id.index()]);
            }
            inertias.push(ArticulatedInertia::from(&body.inertia));
            wrenches.push(motions[i].cross_force(&body.inertia.momentum(&motions[i])));
        }
        for force in forces {
            let on = &model.link_frames[force.link.index()];
            if let Some(b) = on.body {
                let in_body = kinematics.frames[b].inverse_vector(&force.force);
                wrenches[b] -= Wrench::of_force(in_body, &on.frame.point(&force.point));
            }
        }
        let steps = self.tips_to_root(&biases, &mut inertias, &mut wrenches)?;
        Ok(self.root_to_tips(&steps, motions, &biases, gravity))
    }

    /// Eliminates the velocities of all joints from the tips to the root.
    fn tips_to_root(
        &self,
        biases: &[Twist<f64>],
        inertias: &mut [ArticulatedInertia<f64>],
        wrenches: &mut [Wrench<f64>],
    ) -> Result<Vec<ForwardStep>, RouteError> {
        let model = self.assembly.model();
        let mut steps = vec![
            ForwardStep { s: Twist::zero(), u: Wrench::zero(), d: 0.0, t: 0.0 };
            model.velocity_coordinates.len()
        ];
        // Size of the subtree inertia about each body's origin: bound for the trace of the rotational part, and mass.
        let mut sizes: Vec<(f64, f64)> =
            model.bodies.iter().map(|b| (b.inertia.rotational.trace().abs(), b.inertia.mass)).collect();
        for (i, body) in model.bodies.iter().enumerate().rev() {
            // The bias acceleration c acts on the child's side of all velocities of the joint.
            wrenches[i] += inertias[i].apply(&biases[i]);
            for (k, v) in body.v.clone().enumerate() {
                let s = self.kinematics.column(model, i, k);
                let u = inertias[i].apply(&s);
                let d = u.power(&s) + body.armature[k];
                let (turn, mass) = sizes[i];
                let d_size =
                    s.angular.norm_squared() * turn + s.linear.norm_squared() * mass + body.armature[k];
                if d <= ACCELERATION_PIVOT * d_size {
                    let least_pivot = if d_size > 0.0 { d / d_size } else { 0.0 };
                    return Err(RouteError::SingularPivot { least_pivot });
                }
                let t = -wrenches[i].power(&s);
                wrenches[i] += u * (t / d);
                inertias[i].subtract_dyad(&(u * (1.0 / d)), &u);
                steps[v] = ForwardStep { s, u, d, t };
            }
            if let Some(parent) = body.parent {
                let step = &self.kinematics.parent_transforms[i];
                let propagated = transformed(step, &inertias[i]);
                inertias[parent] += &propagated;
                let wrench = step.wrench(&wrenches[i]);
                wrenches[parent] += wrench;
                // The trace about the parent's origin is ∫ 2 r² dm, with r at most the sum of the distances.
                let (turn, mass) = sizes[i];
                let shift = step.translation.norm() * (2.0 * mass).sqrt();
                sizes[parent].0 += (turn.sqrt() + shift).powi(2);
                sizes[parent].1 += mass;
            }
        }
        Ok(steps)
    }

    /// Accelerations of all joints and bodies, from the root to the tips.
    fn root_to_tips(
        &self,
        steps: &[ForwardStep],
        motions: Vec<Twist<f64>>,
        biases: &[Twist<f64>],
        gravity: &Vector3<f64>,
    ) -> Accelerations {
        let model = self.assembly.model();
        let mut joints: Vec<Vec<f64>> =
            model.mechanism.joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
        let ground = Twist::new(Vector3::zeros(), -gravity);
        let mut accelerations = vec![Twist::zero(); model.bodies.len()];
        for (i, body) in model.bodies.iter().enumerate() {
            let from = body.parent.map_or(ground, |p| accelerations[p]);
            let mut a = self.kinematics.parent_transforms[i].inverse_twist(&from);
            for (k, v) in body.v.clone().enumerate().rev() {
                let step = &steps[v];
                let rate = (step.t - step.u.power(&a)) / step.d;
                a += step.s * rate;
                if let Some(id) = body.joint {
                    joints[id.index()][k] = rate;
                }
            }
            accelerations[i] = a + biases[i];
        }
        for (i, a) in accelerations.iter_mut().enumerate() {
            a.linear += self.kinematics.frames[i].inverse_vector(gravity);
        }
        Accelerations { motions: motions.into_iter().zip(accelerations).collect(), joints }
    }

    /// Acceleration (m/s², root axes) of a point (m, link frame) of a link.
    ///
    /// # Errors
    /// [`RouteError`]: a link or accelerations of another mechanism.
    pub fn point_acceleration(
        &self,
        accelerations: &Accelerations,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Result<Vector3<f64>, RouteError> {
        let model = self.assembly.model();
        refuse_foreign(model, link)?;
        let (got, expected) = (accelerations.motions.len(), model.bodies.len());
        if got != expected {
            return Err(RouteError::ForeignAccelerations { got, expected });
        }
        let on = &model.link_frames[link.index()];
        let Some(b) = on.body else { return Ok(Vector3::zeros()) };
        let r = on.frame.point(point);
        let (v, a) = &accelerations.motions[b];
        let local = a.velocity_at(&r) + v.angular.cross(&v.velocity_at(&r));
        Ok(self.kinematics.frames[b].vector(&local))
    }
}

/// X Iᴬ X*: articulated inertia in the parent's coordinates, column by column.
fn transformed(
    step: &percuss_spatial::Transform<f64>,
    inertia: &ArticulatedInertia<f64>,
) -> ArticulatedInertia<f64> {
    let mut sum = ArticulatedInertia::zero();
    for k in 0..6 {
        let mut unit = Twist::zero();
        if k < 3 {
            unit.angular[k] = 1.0
        } else {
            unit.linear[k - 3] = 1.0
        }
        let column = step.wrench(&inertia.apply(&step.inverse_twist(&unit)));
        if k < 3 {
            sum.angular.set_column(k, &column.moment);
        } else {
            sum.coupling.set_column(k - 3, &column.moment);
            sum.linear.set_column(k - 3, &column.force);
        }
    }
    sum
}

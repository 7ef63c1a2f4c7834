//! Unit wrenches of a contact on the bodies, in intervals and in `f64`.

use super::plan::{On, Placement, Plan, written, written_transform, written_vector};
use super::records::RangeProof;
use crate::kinematics::contact::{Contact, Direction, Frame};
use nalgebra::Vector3;
use percuss_mechanism::JointKind;
use percuss_spatial::{Interval, Scalar, Transform, Wrench, plane_basis};
use std::f64::consts::PI;

/// Contact with enclosures of its numbers.
#[derive(Clone, Debug)]
pub(super) struct Load<T: Scalar> {
    on: On<T>,
    against: Option<On<T>>,
    /// Contact point in the frame of the contact link, m.
    point: Vector3<T>,
    normal: Normal<T>,
    is_moment: bool,
}

#[derive(Clone, Debug)]
enum Normal<T: Scalar> {
    /// Unit vector in the frame of the contact link.
    Link(Vector3<T>),
    /// Unit vector in the frame of the other side.
    Against(Vector3<T>),
    /// Unit vector in the root link.
    Root(Vector3<T>),
    /// Towards a point (m) of a link; the sign is −1 for the opposite direction.
    Line(On<T>, Vector3<T>, f64),
}

/// Wrenches on all bodies, and the parts of the derivatives that come from a normal fixed in the root link.
pub(super) struct Loads<T: Scalar> {
    pub wrenches: Vec<Wrench<T>>,
    /// Body of the contact with the normal in the axes of every body. `None` if the normal is fixed in this body.
    pub normals: Option<(usize, Vec<Vector3<T>>)>,
    /// True if the wrenches depend on the positions by a line, or by the frames of two bodies: no derivatives.
    pub is_relative: bool,
}

impl Load<Interval> {
    /// Enclosure of a contact. `base`: X_wr of the root link in the world.
    pub fn of(contact: &Contact, links: &[On<Interval>], base: &Transform<f64>) -> Self {
        let unit = |v: &Vector3<f64>| {
            let v = v.map(written);
            let square = v.iter().fold(Interval::point(0.0), |sum, x| sum + x.square());
            let length = square.sqrt();
            v.map(|x| x / length)
        };
        let on = |link: percuss_mechanism::LinkId| links[link.index()];
        let normal = match contact.normal {
            Direction::Along(v, frame) | Direction::About(v, frame) => match (frame, contact.against) {
                (Frame::Link, _) => Normal::Link(unit(&v)),
                (Frame::Against, Some(_)) => Normal::Against(unit(&v)),
                (Frame::World, _) | (Frame::Against, None) => {
                    Normal::Root(written_transform(base).inverse_vector(&unit(&v)))
                }
            },
            Direction::Toward(link, to) | Direction::TurningToward(link, to) => {
                Normal::Line(on(link), written_vector(&to), 1.0)
            }
            Direction::TurningAwayFrom(link, to) => Normal::Line(on(link), written_vector(&to), -1.0),
        };
        Self {
            on: on(contact.link),
            against: contact.against.map(on),
            point: written_vector(&contact.point),
            normal,
            is_moment: contact.normal.is_moment(),
        }
    }

    /// Varies the point along edges and the normal in a cone by bodies without mass, as [`RangeProof`] describes them; `None` if the contact
    /// has no fixed normal against the ground. The numbers of their positions begin at `first`; the result has their ranges.
    ///
    /// A normal of the contact link is turned by the body of the contact. For a normal of the root link all bodies are turned against it.
    pub fn vary(
        &mut self,
        plan: &mut Plan<Interval>,
        proof: &RangeProof,
        first: usize,
    ) -> Option<Vec<(usize, f64, f64)>> {
        self.on.body?;
        if self.against.as_ref().is_some_and(|against| against.body.is_some()) {
            return None;
        }
        let mut varied = Vec::new();
        let frame = self.on.frame * Transform::from_translation(self.point);
        let mut on = On { body: self.on.body, frame };
        if proof.is_disc {
            let Normal::Link(n) = &self.normal else { return None };
            varied.push((first, -PI.next_up(), PI.next_up()));
            on = plan.add_massless_body(on, JointKind::Revolute, n.map(|x| x.mid()).normalize(), first);
        }
        for edge in proof.edges.into_iter().map(Vector3::from).filter(|edge| edge.norm() > 0.0) {
            varied.push((first + varied.len(), 0.0, edge.norm().next_up()));
            on = plan.add_massless_body(on, JointKind::Prismatic, edge.normalize(), varied.last()?.0);
        }
        let [from, to] = proof.cone;
        if to > 0.0 {
            let (psi, theta) = (first + varied.len(), first + varied.len() + 1);
            varied.extend([
                (psi, -PI.next_up(), PI.next_up()),
                (theta, from.next_down().max(0.0), to.next_up()),
            ]);
            match &self.normal {
                Normal::Link(n) => {
                    let n = n.map(|x| x.mid()).normalize();
                    on = plan.add_massless_body(on, JointKind::Revolute, n, psi);
                    on = plan.add_massless_body(on, JointKind::Revolute, plane_basis(&n).0, theta);
                }
                Normal::Root(n) => {
                    let n = n.map(|x| x.mid()).normalize();
                    plan.turn_all_bodies(&[(plane_basis(&n).0, theta), (n, psi)]);
                    on.body = on.body.map(|body| body + 2);
                }
                Normal::Against(_) | Normal::Line(..) => return None,
            }
        } else if matches!(self.normal, Normal::Against(_) | Normal::Line(..)) {
            return None;
        }
        (self.on, self.point) = (on, Vector3::zeros());
        Some(varied)
    }

    /// Row of numbers of [`CertifiedTree::contact`](super::records::CertifiedTree::contact); `None` for a contact against a body, or along a line.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        let (None, Some(body)) = (self.against.as_ref().and_then(|against| against.body), self.on.body)
        else {
            return None;
        };
        let (normal, is_root) = match &self.normal {
            Normal::Link(n) => (self.on.frame.vector(n), 0.0),
            Normal::Root(n) => (*n, 1.0),
            Normal::Against(_) | Normal::Line(..) => return None,
        };
        let mut row = vec![body as f64, f64::from(u8::from(self.is_moment)), is_root];
        let point = self.on.frame.point(&self.point);
        row.extend(point.iter().chain(normal.iter()).flat_map(|x| [x.lo(), x.hi()]));
        Some(row)
    }

    /// The same contact with the middles of all numbers.
    pub fn middle(&self) -> Load<f64> {
        let mid = |v: &Vector3<Interval>| v.map(Interval::mid);
        let on = |on: &On<Interval>| On {
            body: on.body,
            frame: Transform::new(on.frame.rotation.map(Interval::mid), mid(&on.frame.translation)),
        };
        Load {
            on: on(&self.on),
            against: self.against.as_ref().map(on),
            point: mid(&self.point),
            normal: match &self.normal {
                Normal::Link(n) => Normal::Link(mid(n)),
                Normal::Against(n) => Normal::Against(mid(n)),
                Normal::Root(n) => Normal::Root(mid(n)),
                Normal::Line(link, to, sign) => Normal::Line(on(link), mid(to), *sign),
            },
            is_moment: self.is_moment,
        }
    }
}

impl<T: Scalar> Load<T> {
    /// Wrenches of the contact on the bodies: (p × n̂, n̂), or (â, 0) for a moment, and the opposite on the other side.
    pub fn wrenches(&self, plan: &Plan<T>, placements: &[Placement<T>]) -> Loads<T> {
        let mut wrenches = vec![Wrench::zero(); plan.steps.len()];
        let unit = |normal: Vector3<T>, point: &Vector3<T>| match self.is_moment {
            true => Wrench::new(normal, Vector3::zeros()),
            false => Wrench::of_force(normal, point),
        };
        let against = self.against.as_ref().and_then(|against| against.body);
        if let (Some(body), None) = (self.on.body, against) {
            let point = self.on.frame.point(&self.point);
            match &self.normal {
                Normal::Link(n) => {
                    wrenches[body] = unit(self.on.frame.vector(n), &point);
                    return Loads { wrenches, normals: None, is_relative: false };
                }
                Normal::Root(n) => {
                    let normals = plan.carried_vectors(placements, n);
                    wrenches[body] = unit(normals[body], &point);
                    return Loads { wrenches, normals: Some((body, normals)), is_relative: false };
                }
                Normal::Against(_) | Normal::Line(..) => {}
            }
        }
        let frames = plan.frames(placements);
        let root = |on: &On<T>| on.body.map_or(on.frame, |body| frames[body] * on.frame);
        let point = root(&self.on).point(&self.point);
        let normal = match &self.normal {
            Normal::Link(n) => root(&self.on).vector(n),
            Normal::Against(n) => self.against.as_ref().map_or(*n, |against| root(against).vector(n)),
            Normal::Root(n) => *n,
            Normal::Line(link, to, sign) => {
                let line = root(link).point(to) - point;
                line * (T::from_f64(*sign) / (line.x * line.x + line.y * line.y + line.z * line.z).sqrt())
            }
        };
        let wrench = unit(normal, &point);
        for (body, sign) in [(self.on.body, T::one()), (against, -T::one())] {
            let Some(body) = body else { continue };
            let frame = &frames[body];
            let own = Wrench::new(wrench.moment - frame.translation.cross(&wrench.force), wrench.force);
            let own = Wrench::new(frame.inverse_vector(&own.moment), frame.inverse_vector(&own.force));
            wrenches[body] += own * sign;
        }
        Loads { wrenches, normals: None, is_relative: true }
    }

    /// Velocity that the normal multiplies in the closing speed: of the contact point, or the angular velocity for a moment.
    pub fn velocity(&self, twist: &percuss_spatial::Twist<T>) -> Vector3<T> {
        match self.is_moment {
            true => twist.angular,
            false => twist.velocity_at(&self.on.frame.point(&self.point)),
        }
    }
}

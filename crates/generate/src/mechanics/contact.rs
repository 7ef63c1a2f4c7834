//! Contact row: closing speed of the gap at unit tree velocities.

use super::body_frames::Bodies;
use super::motion::WrenchExpr;
use crate::expression::graph::{Expr, Graph};
use crate::expression::vector::Vector;
use crate::request::Request;
use percuss_dynamics::{Direction, Frame, LowestPoint};
use percuss_mechanism::LinkId;
use percuss_spatial::Vector3;

/// Contact in the frame of the contact link's body.
pub(crate) struct ContactExpr {
    /// Row j over the tree velocities.
    pub row: Vec<Expr>,
    /// Square of the length of the line that defines the normal, m²; `None` for a fixed normal.
    pub line_square: Option<Expr>,
}

impl Bodies {
    /// Body of a link, and a point of the link in the body's frame.
    fn point_on(&self, link: LinkId, p: &Vector3<f64>) -> (Option<usize>, Vector3<f64>) {
        let (body, frame) = &self.tree.links[link.index()];
        (*body, self.frame_on(*body, frame).point(p))
    }

    /// Body of a link, and a vector of the link in the body's frame.
    fn vector_on(&self, link: LinkId, v: &Vector3<f64>) -> (Option<usize>, Vector3<f64>) {
        let (body, frame) = &self.tree.links[link.index()];
        (*body, self.frame_on(*body, frame).vector(v))
    }

    /// Body of the contact link, and the contact point in its frame: the lowest point of the wheel of a patch.
    fn contact_point(&self, g: &mut Graph, request: &Request) -> (Option<usize>, Vector) {
        let contact = &request.contact;
        let (body, point) = self.point_on(contact.link, &contact.point);
        let Some(wheel) = &request.wheel else { return (body, g.vector(&point)) };
        let mechanism = request.system.mechanism();
        let (centre_body, centre) = self.point_on(wheel.centre, &Vector3::zeros());
        let spin = mechanism.joint(wheel.spin);
        let (axis_body, axis) = self.vector_on(spin.child(), spin.axis());
        let (root_body, up) = self.vector_on(mechanism.root(), &Vector3::z());
        let centre = g.vector(&centre);
        let centre = self.point_between(g, centre_body, body, centre);
        let axis = g.vector(&axis);
        let axis = self.vector_between(g, axis_body, body, axis);
        let up = g.vector(&up);
        let up = self.vector_between(g, root_body, body, up);
        let cosine = g.dot(axis, up);
        let along = g.scale3(cosine, axis);
        let down = g.sub3(along, up);
        let (square, radius) = (g.dot(down, down), g.constant(wheel_radius(request, wheel)));
        let length = g.sqrt(square);
        let factor = g.div(radius, length);
        let offset = g.scale3(factor, down);
        (body, g.add3(centre, offset))
    }

    /// Contact row of the request's contact.
    pub fn contact(&self, g: &mut Graph, request: &Request) -> ContactExpr {
        let contact = &request.contact;
        let (body, point) = self.contact_point(g, request);
        let mut line_square = None;
        let fixed = |g: &mut Graph, from: Option<usize>, normal: &Vector3<f64>| {
            let normal = g.vector(normal);
            self.vector_between(g, from, body, normal)
        };
        let normal = match contact.normal {
            Direction::Along(normal, frame) | Direction::About(normal, frame) => {
                let unit = normal.normalize();
                match (frame, contact.against) {
                    (Frame::Link, _) => {
                        let (_, unit) = self.vector_on(contact.link, &unit);
                        g.vector(&unit)
                    }
                    (Frame::Against, Some(other)) => {
                        let (from, unit) = self.vector_on(other, &unit);
                        fixed(g, from, &unit)
                    }
                    (Frame::World, _) | (Frame::Against, None) => {
                        let root = request.system.mechanism().root();
                        let (from, unit) = self.vector_on(root, &unit);
                        fixed(g, from, &unit)
                    }
                }
            }
            Direction::Toward(link, to)
            | Direction::TurningToward(link, to)
            | Direction::TurningAwayFrom(link, to) => {
                let (from, end) = self.point_on(link, &to);
                let end = g.vector(&end);
                let end = self.point_between(g, from, body, end);
                let line = g.sub3(end, point);
                let square = g.dot(line, line);
                line_square = Some(square);
                let (one, length) = (g.one(), g.sqrt(square));
                let mut inverse = g.div(one, length);
                if let Direction::TurningAwayFrom(..) = contact.normal {
                    inverse = g.neg(inverse);
                }
                g.scale3(inverse, line)
            }
        };
        let other = contact.against.and_then(|link| self.tree.links[link.index()].0);
        let wrench = WrenchExpr { moment: g.cross(point, normal), force: normal };
        ContactExpr { row: self.wrench_row(g, body, other, wrench), line_square }
    }

    /// Rows of the six unit wrenches at the contact point, in the axes of the contact link: moments, then forces.
    pub fn unit_wrench_rows(&self, g: &mut Graph, request: &Request) -> Vec<Vec<Expr>> {
        let contact = &request.contact;
        let (body, point) = self.contact_point(g, request);
        let other = contact.against.and_then(|link| self.tree.links[link.index()].0);
        let mut rows = Vec::new();
        for k in 0..6 {
            let mut axis = Vector3::zeros();
            axis[k % 3] = 1.0;
            let (_, axis) = self.vector_on(contact.link, &axis);
            let axis = g.vector(&axis);
            let wrench = match k {
                0..3 => WrenchExpr { moment: axis, force: g.zeros() },
                _ => WrenchExpr { moment: g.cross(point, axis), force: axis },
            };
            rows.push(self.wrench_row(g, body, other, wrench));
        }
        rows
    }

    /// Power of a wrench on `body`, and of the opposite wrench on `other`, at unit tree velocities of the paths to the
    /// common ancestor. `wrench`: in the frame of `body`.
    pub fn wrench_row(
        &self,
        g: &mut Graph,
        body: Option<usize>,
        other: Option<usize>,
        mut wrench: WrenchExpr,
    ) -> Vec<Expr> {
        let zero = g.zero();
        let mut row = vec![zero; self.tree.velocities.len()];
        let ancestor = self.tree.common_ancestor(body, other);
        let add = |g: &mut Graph, b: usize, wrench: &WrenchExpr, row: &mut Vec<Expr>, sign: f64| {
            for (k, v) in self.tree.bodies[b].velocities.clone().enumerate() {
                let power = wrench.power(g, &self.bodies[b].columns[k]);
                row[v] = g.scale(power, sign);
            }
        };
        for b in self.path(ancestor, body).into_iter().rev() {
            add(g, b, &wrench, &mut row, 1.0);
            for step in self.bodies[b].steps.iter().rev() {
                wrench = step.wrench_to_parent(g, &wrench);
            }
        }
        for b in self.path(ancestor, other) {
            for step in &self.bodies[b].steps {
                wrench = step.wrench_to_child(g, &wrench);
            }
            add(g, b, &wrench, &mut row, -1.0);
        }
        row
    }
}

/// Distance of the patch from the wheel centre at the design pose, m.
fn wheel_radius(request: &Request, wheel: &LowestPoint) -> f64 {
    let origin = |link| request.pose.link(link).translation;
    (origin(wheel.patch) - origin(wheel.centre)).norm()
}

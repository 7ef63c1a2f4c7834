//! Computation of the groups of a model.

use super::group::{Constraint, ConstraintRows, ConstraintTerm, Group};
use crate::model::Model;
use crate::model::compile::ZeroFrames;
use crate::model::structure::partition::Partition;
use nalgebra::Vector3;
use percuss_mechanism::JointId;

impl Model {
    /// Name of a closure or coupling; for a held contact a text with the name of its link.
    pub fn constraint_name(&self, constraint: Constraint) -> String {
        match constraint {
            Constraint::Closure(i) => self.closures[i].name.clone(),
            Constraint::Coupling(i) => self.couplings[i].name.clone(),
            Constraint::Hold(i) => {
                format!("hold of {}", self.mechanism.link(self.holds[i].link).name())
            }
        }
    }

    /// Name of the constraint of row `row` of a group.
    pub fn row_name(&self, group: &Group, row: usize) -> String {
        let at = group.constraints.partition_point(|c| c.first + c.count <= row);
        group.constraints.get(at).map_or_else(String::new, |c| self.constraint_name(c.constraint))
    }

    /// Names of a group's constraints.
    pub fn group_names(&self, group: &Group) -> Vec<String> {
        group.constraints.iter().map(|c| self.constraint_name(c.constraint)).collect()
    }

    /// Finds the connected components of coordinates that share a constraint.
    pub(in crate::model) fn compile_groups(&mut self) {
        let constraints: Vec<Constraint> = (0..self.closures.len())
            .map(Constraint::Closure)
            .chain((0..self.couplings.len()).map(Constraint::Coupling))
            .chain((0..self.holds.len()).map(Constraint::Hold))
            .collect();
        if constraints.is_empty() {
            return;
        }
        let terms: Vec<Vec<ConstraintTerm>> = constraints.iter().map(|c| self.terms(*c)).collect();
        let mut partition = Partition::new(self.coordinates.len());
        for bound in &terms {
            for pair in bound.windows(2) {
                partition.join(pair[0].column, pair[1].column);
            }
        }
        let mut groups: Vec<Group> = Vec::new();
        let mut of_root = vec![None; self.coordinates.len()];
        for (constraint, terms) in constraints.into_iter().zip(terms) {
            // A constraint without coordinates (all locked, or rigid) forms a group of its own.
            let root = terms.first().map(|t| partition.root(t.column));
            let known = root.and_then(|r| of_root[r]);
            let number = known.unwrap_or_else(|| {
                groups.push(Group::default());
                if let Some(root) = root {
                    of_root[root] = Some(groups.len() - 1);
                }
                groups.len() - 1
            });
            let count = match constraint {
                Constraint::Closure(i) => self.closures[i].kind.rows(),
                Constraint::Coupling(_) => 1,
                Constraint::Hold(i) => self.holds[i].rows(),
            };
            let group = &mut groups[number];
            group.is_held |= matches!(constraint, Constraint::Hold(_));
            group.constraints.push(ConstraintRows { constraint, first: group.rows, count, terms });
            group.rows += count;
        }
        for c in 0..self.coordinates.len() {
            if let Some(group) = of_root[partition.root(c)] {
                groups[group].coordinates.push(c);
            }
        }
        let zero = ZeroFrames::of(self);
        for group in &mut groups {
            self.complete(group, &zero);
        }
        self.groups = groups;
    }

    /// Velocities that a constraint restricts; columns are coordinates of the model.
    fn terms(&self, constraint: Constraint) -> Vec<ConstraintTerm> {
        let mut terms = Vec::new();
        let mut add = |body: usize, factor: f64, argument: f64| {
            for (component, v) in self.bodies[body].v.clone().enumerate() {
                if let Some(f) = self.velocity_coordinates[v] {
                    let (column, multiplier) = (f.index, f.multiplier);
                    terms.push(ConstraintTerm { body, component, factor, argument, column, multiplier });
                }
            }
        };
        match constraint {
            Constraint::Closure(i) => {
                let closure = &self.closures[i];
                self.for_each_support(closure.successor.body, closure.predecessor.body, |b, f| {
                    add(b, f, 0.0)
                });
            }
            Constraint::Coupling(i) => {
                self.couplings[i].terms.iter().for_each(|t| add(t.body, t.factor, t.argument));
            }
            Constraint::Hold(i) => {
                self.for_each_support(self.body_of(self.holds[i].link), None, |b, f| add(b, f, 0.0));
            }
        }
        terms
    }

    /// Fills joints, bodies, size and lengths of a group.
    fn complete(&self, group: &mut Group, zero: &ZeroFrames) {
        for terms in group.constraints.iter_mut().map(|c| &mut c.terms) {
            for term in terms {
                term.column = group.coordinates.partition_point(|&c| c < term.column);
            }
        }
        group.joints = group.coordinates.iter().map(|&c| self.coordinates[c].joint).collect();
        group.movable = (0..group.joints.len()).filter(|&at| group.joints[at].is_some()).collect();
        group.bodies = self.bodies_of(group);
        (group.size, group.far) = self.size_of(group, zero);
        let length = |&c: &usize| if self.coordinates[c].turns { group.size } else { 1.0 };
        group.lengths = group.coordinates.iter().map(length).collect();
    }

    /// Bodies on the constraint paths (locked ones included), and bodies of the group's joints and their masters.
    fn bodies_of(&self, group: &Group) -> Vec<usize> {
        let mut bodies: Vec<usize> = Vec::new();
        for constraint in &group.constraints {
            match constraint.constraint {
                Constraint::Closure(i) => {
                    let closure = &self.closures[i];
                    self.for_each_support(closure.successor.body, closure.predecessor.body, |b, _| {
                        bodies.push(b);
                    });
                }
                Constraint::Coupling(i) => bodies.extend(self.couplings[i].terms.iter().map(|t| t.body)),
                Constraint::Hold(i) => {
                    self.for_each_support(self.body_of(self.holds[i].link), None, |b, _| bodies.push(b));
                }
            }
        }
        let of_joint = |joint: &Option<JointId>| self.body_of_joint[(*joint)?.index()];
        bodies.extend(group.joints.iter().filter_map(of_joint));
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// Largest distance from the first of a group's joints, loop frames and held points, with all joints at 0 (1 m if
    /// all coincide), and largest distance from the root.
    fn size_of(&self, group: &Group, zero: &ZeroFrames) -> (f64, f64) {
        let mut places: Vec<Vector3<f64>> =
            group.bodies.iter().map(|&b| zero.frames[b].translation).collect();
        for constraint in &group.constraints {
            match constraint.constraint {
                Constraint::Closure(i) => {
                    let closure = &self.closures[i];
                    let ends = [&closure.predecessor, &closure.successor];
                    places.extend(ends.map(|end| zero.frame_of(end).translation));
                }
                Constraint::Coupling(_) => {}
                Constraint::Hold(i) => {
                    let hold = &self.holds[i];
                    places.push(zero.frame_of(&self.link_frames[hold.link.index()]).point(&hold.point));
                }
            }
        }
        let Some(first) = places.first().copied() else { return (1.0, 0.0) };
        let far = places.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let spread = places.iter().map(|p| (p - first).norm()).fold(0.0, f64::max);
        // A spread below the rounding of the positions counts as zero.
        (if spread > 64.0 * f64::EPSILON * far { spread } else { 1.0 }, far)
    }
}

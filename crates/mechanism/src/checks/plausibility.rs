//! Search for inertias that are impossible for a body of the link's size. The usual reason is a wrong unit.

use crate::checks::inertias::principal_moments;
use crate::limits::{DENSEST, FAR_GYRATION, LEAST_GYRATION, SPHERE_OVER_GYRATION, WIDE_GYRATION};
use crate::{Accept, Geometry, LinkRatio, Mechanism, Problem, Subject};

impl Mechanism {
    /// Links whose inertia does not fit their mass and size.
    ///
    /// k = √(λ_max/m): largest radius of gyration about the centre of mass; for a link without mass, m is the total mass.
    /// r: the reach of the link, or that of the largest link of the mechanism if larger.
    ///
    /// | severity | condition                                                                                |
    /// |----------|------------------------------------------------------------------------------------------|
    /// | warning  | k > 3 r, mass > 0                                                                        |
    /// | error    | k > 30 r, unless accepted (then a warning)                                               |
    /// | warning  | mass 0 with an inertia, unless a coupling or mimic makes the link a rotor                |
    /// | warning  | a sphere with the same mass and k is denser than 2e5 kg/m³, unless k is tiny against r   |
    ///
    /// Reach of a link: largest distance from its origin to its centre of mass, the end of its declared shape, a child
    /// joint or a loop frame. If no link has a reach, nothing is reported. Cost: O(links).
    pub fn implausible_inertias(&self, accept: Accept) -> Vec<(Subject, Problem)> {
        let (reaches, rotors) = (self.reaches(), self.rotors());
        let largest = reaches.iter().copied().fold(0.0, f64::max);
        let total: f64 = self.links().iter().filter_map(|link| link.inertial()).map(|i| i.mass).sum();
        let mut found = Vec::new();
        for (id, own) in self.link_ids().zip(&reaches) {
            let link = self.link(id);
            let Some(inertial) = link.inertial() else { continue };
            let [_, _, moment] = principal_moments(&inertial.about_com);
            let reach = own.max(largest);
            if reach <= 0.0 || moment <= 0.0 {
                continue;
            }
            // The radius of gyration of a body without mass is computed with the total mass.
            let mass = if inertial.mass > 0.0 { inertial.mass } else { total };
            let gyration = if mass > 0.0 { (moment / mass).sqrt() } else { f64::INFINITY };
            let far = gyration > FAR_GYRATION * reach;
            let problem = if inertial.mass > 0.0 && gyration > WIDE_GYRATION * reach
                || inertial.mass <= 0.0 && far && total > 0.0
            {
                let accepted = accept.implausible_inertia;
                Some(Problem::WideInertia { mass, gyration, reach, far: far && !accepted })
            } else if inertial.mass <= 0.0 {
                (!rotors[id.index()]).then_some(Problem::InertiaWithoutMass { moment })
            } else {
                let radius = SPHERE_OVER_GYRATION * gyration;
                let density = mass / (4.0 / 3.0 * std::f64::consts::PI * radius.powi(3));
                let is_dense = density > DENSEST && gyration > LEAST_GYRATION * reach;
                is_dense.then_some(Problem::DenseInertia { mass, gyration, density })
            };
            let subject = || Subject::Link { index: id.index(), name: link.name().to_owned() };
            found.extend(problem.map(|problem| (subject(), problem)));
        }
        found
    }

    /// Reach of every link, m: largest distance from its origin to its centre of mass, the end of its shape, a child joint
    /// or a loop frame.
    fn reaches(&self) -> Vec<f64> {
        let own = self.links().iter().map(|link| {
            let shape = match link.geometry() {
                Geometry::None | Geometry::Mesh => 0.0,
                Geometry::Within(radius) => radius,
            };
            link.inertial().map_or(0.0, |inertial| inertial.com.norm()).max(shape)
        });
        let mut reaches: Vec<f64> = own.collect();
        for joint in self.joints() {
            let reach = &mut reaches[joint.parent().index()];
            *reach = reach.max(joint.origin().translation.norm());
        }
        for frame in self.closures().iter().flat_map(|c| [c.predecessor(), c.successor()]) {
            if let Some(link) = frame.link {
                let reach = &mut reaches[link.index()];
                *reach = reach.max(frame.frame.translation.norm());
            }
        }
        reaches
    }

    /// Per link: true if the link is part of a coupling, or the child of a joint that mimics or is mimicked. The rotor of a
    /// gear may have an inertia without a mass.
    fn rotors(&self) -> Vec<bool> {
        let mut rotors = vec![false; self.links().len()];
        for coupling in self.couplings() {
            match coupling.ratio() {
                Some(LinkRatio { predecessor, successor, .. }) => {
                    rotors[predecessor.index()] = true;
                    rotors[successor.index()] = true;
                }
                None => {
                    let children = coupling.terms().iter().map(|term| self.joint(term.0).child());
                    children.for_each(|child| rotors[child.index()] = true);
                }
            }
        }
        for joint in self.joints() {
            if let Some(mimic) = joint.mimic() {
                rotors[joint.child().index()] = true;
                rotors[self.joint(mimic.master).child().index()] = true;
            }
        }
        rotors
    }
}

//! Inertias that no body of the link's size has: most come from a wrong unit.

use crate::inertia_check::principal_moments;
use crate::limits::{DENSEST, FAR_GYRATION, LEAST_GYRATION, SPHERE_OVER_GYRATION, WIDE_GYRATION};
use crate::{Accept, Geometry, Mechanism, Problem, Subject};

impl Mechanism {
    /// Links whose inertia does not fit their mass and size, with k = √(λ_max/m) the largest radius of gyration about the
    /// centre of mass:
    ///
    /// | finding                   | condition                                                                    |
    /// |---------------------------|------------------------------------------------------------------------------|
    /// | warning, error far out    | k above 3 times, 30 times the reach of the link and of the mechanism's largest link |
    /// | warning                   | mass 0 with an inertia, unless a coupling or mimic makes the link a rotor    |
    /// | warning                   | the sphere of that k is denser than 2e5 kg/m³, unless k is that of a point   |
    ///
    /// The reach of a link: its centre of mass, its declared shape, joints below it and loop frames on it; nothing is found
    /// where no link has one. Cost: O(links).
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
            // A body without mass is measured by the mass of all others.
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

    /// Per link: the greatest distance of anything on it from its origin, its inertia left out, m.
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

    /// Per link: true if a coupling or a mimic drives it or is driven by it. A gear's rotor may be described by its inertia alone.
    fn rotors(&self) -> Vec<bool> {
        let mut rotors = vec![false; self.links().len()];
        for coupling in self.couplings() {
            rotors[coupling.predecessor().index()] = true;
            rotors[coupling.successor().index()] = true;
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

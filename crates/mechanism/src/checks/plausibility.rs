//! Search for inertias that are impossible for a body of the link's size. The usual reason is a wrong unit.

use crate::checks::inertias::principal_moments;
use crate::limits::{
    DENSEST, DIFFERENT_SIZES, EQUAL_SHARE, FAR_GYRATION, LEAST_EQUAL_LINKS, LEAST_GYRATION, LEAST_SIZE,
    MOMENT_SLACK, SPHERE_OVER_GYRATION, WIDE_GYRATION,
};
use crate::{Accept, Geometry, Inertial, Link, LinkId, LinkRatio, Mechanism, Problem, Subject};

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
    /// joint or a loop frame. If no link has a reach, nothing is reported; if only centres of mass give one, no radius of gyration is.
    /// Further warnings: [`Problem::NoMovingMass`], [`Problem::EqualInertias`]. Cost: O(links).
    pub fn implausible_inertias(&self, accept: Accept) -> Vec<(Subject, Problem)> {
        let (sizes, rotors) = (self.sizes(), self.rotors());
        let is_sized = sizes.iter().any(|size| *size > LEAST_SIZE);
        let com = |link: &Link| link.inertial().map_or(0.0, |inertial| inertial.com.norm());
        let reaches: Vec<f64> =
            self.links().iter().zip(&sizes).map(|(link, size)| size.max(com(link))).collect();
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
            // Without a shape, a joint offset or a loop frame, the size of the links is unknown: a centre of mass may be rounding.
            let problem = if is_sized
                && (inertial.mass > 0.0 && gyration > WIDE_GYRATION * reach
                    || inertial.mass <= 0.0 && far && total > 0.0)
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
        let of_mechanism =
            if self.has_moving_mass() { self.equal_inertias(&sizes) } else { Some(Problem::NoMovingMass) };
        found.extend(of_mechanism.map(|problem| (Subject::Mechanism, problem)));
        found
    }

    /// True if a link that a joint moves has a mass or an inertia, or a joint has an armature. Without joints that move, every link counts.
    pub fn has_moving_mass(&self) -> bool {
        let has_mass = |link: &Link| {
            link.inertial().is_some_and(|inertial| inertial.mass > 0.0 || inertial.about_com.trace() > 0.0)
        };
        self.moving_links().iter().any(|id| has_mass(self.link(*id)))
            || self.joints().iter().any(|joint| joint.armature().iter().any(|a| *a > 0.0))
    }

    /// Links that a joint moves against the root; all links without joints that move.
    fn moving_links(&self) -> Vec<LinkId> {
        let mut moves = vec![false; self.links().len()];
        for &link in self.order() {
            if let Some(joint) = self.parent_joint(link).map(|joint| self.joint(joint)) {
                moves[link.index()] = joint.kind().dofs() > 0 || moves[joint.parent().index()];
            }
        }
        let all = !moves.contains(&true);
        self.link_ids().filter(|link| all || moves[link.index()]).collect()
    }

    /// Equal inertias of nearly all moving links with a mass, although the links have different sizes, or extend from a ball at their origin without a
    /// shape.
    fn equal_inertias(&self, sizes: &[f64]) -> Option<Problem> {
        let bodies = self.moving_links().into_iter();
        let bodies =
            bodies.filter_map(|id| self.link(id).inertial().filter(|i| i.mass > 0.0).map(|i| (id, i)));
        let bodies: Vec<(LinkId, &Inertial)> = bodies.collect();
        // More than half of the bodies are equal, so that one of the two middle ones is among them after sorting.
        let mut masses: Vec<&Inertial> = bodies.iter().map(|(_, inertial)| *inertial).collect();
        masses.sort_by(|a, b| a.mass.total_cmp(&b.mass));
        let common = masses.get(masses.len() / 2)?;
        let is_common = |inertial: &Inertial| {
            let moments = (inertial.about_com - common.about_com).amax();
            inertial.mass == common.mass && moments <= MOMENT_SLACK * common.about_com.amax()
        };
        let equal = bodies.iter().filter(|(_, inertial)| is_common(inertial)).map(|(id, _)| *id);
        let equal: Vec<LinkId> = equal.collect();
        let known: Vec<f64> =
            equal.iter().map(|id| sizes[id.index()]).filter(|size| *size > LEAST_SIZE).collect();
        let least = known.iter().copied().fold(f64::INFINITY, f64::min);
        let most = known.iter().copied().fold(0.0, f64::max);
        let has_shapes = equal.iter().any(|id| matches!(self.link(*id).geometry(), Geometry::Within(_)));
        let are_balls = known.len() + 1 >= LEAST_EQUAL_LINKS && !has_shapes && is_ball_at_origin(common);
        let is_placeholder = equal.len() >= LEAST_EQUAL_LINKS
            && equal.len() as f64 >= EQUAL_SHARE * bodies.len() as f64
            && (most > DIFFERENT_SIZES * least || are_balls);
        is_placeholder.then_some(Problem::EqualInertias {
            links: equal.len(),
            bodies: bodies.len(),
            mass: common.mass,
        })
    }

    /// Size of every link, m: largest distance from its origin to the end of its shape, a child joint or a loop frame.
    fn sizes(&self) -> Vec<f64> {
        let own = self.links().iter().map(|link| match link.geometry() {
            Geometry::None | Geometry::Mesh => 0.0,
            Geometry::Within(radius) => radius,
        });
        let mut sizes: Vec<f64> = own.collect();
        for joint in self.joints() {
            let size = &mut sizes[joint.parent().index()];
            *size = size.max(joint.origin().translation.norm());
        }
        for frame in self.closures().iter().flat_map(|c| [c.predecessor(), c.successor()]) {
            if let Some(link) = frame.link {
                let size = &mut sizes[link.index()];
                *size = size.max(frame.frame.translation.norm());
            }
        }
        sizes
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

/// True for equal moments about all axes, and a centre of mass at the origin of the link.
fn is_ball_at_origin(inertial: &Inertial) -> bool {
    let [least, _, most] = principal_moments(&inertial.about_com);
    inertial.com.amax() == 0.0 && most > 0.0 && most - least <= MOMENT_SLACK * most
}

//! Clusters of joints that mimic one another: joint velocity k is mₖ times the rate of a coordinate of the cluster.
//!
//! The bodies of a cluster are visited from the tips to the parent body. With I the sum of the inertias of a body and of all
//! bodies beyond it, and U_y the momentum of these bodies at a unit rate of coordinate y through the joints beyond the body,
//! a joint with the motion column e and the multiplier m of coordinate x gives
//!
//! ```text
//! D_xy += m e·U_y,  D_xx += m² (e·I e + armature),  U_x += m I e,  t_x += m e·f
//! ```
//!
//! (composite rigid bodies, Featherstone 2008, §6.2). At the parent body, I ← I − U D⁻¹ Uᵀ and f ← f − U D⁻¹ t.

use super::cluster_joint::{ClusterJoint, MOST};
use super::parent_transform::{LanePositions, transform_to_parent};
use super::plan::{ScheduledStep, TreeMotion, TreePlan};
use super::propagation::{PropagatedWrench, add_to_parent};
use super::workspace::{Offsets, SIZES, Sizes};
use crate::mechanism::{Cluster, Mechanism};
use crate::tolerances::COMMON_LOSS;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedWrench};

/// Numbers of a wrench.
const WRENCH: usize = 6;

/// Cluster of joints that mimic one another, with one parent body or the ground.
#[derive(Clone, Debug)]
pub(super) struct MimicCluster {
    /// Number of its coordinates.
    pub freedoms: usize,
    /// Offset of its numbers in the workspace, per lane: D and t with its sizes, then U of the parent body and of each body.
    offset: usize,
    /// Number of its bodies.
    bodies: usize,
    pub parent: Option<usize>,
    /// Bounds of the sums of the terms of the diagonal of D, kg·m² or kg.
    sizes: [f64; MOST],
}

impl MimicCluster {
    /// Compiles the clusters of a plan, without their places in the workspace. `None` if a cluster has more than `MOST` coordinates,
    /// joints of several degrees of freedom, or several bodies on the ground.
    pub fn compile(mechanism: &Mechanism, plan: &mut TreePlan) -> Option<Vec<Self>> {
        let mut clusters = Vec::new();
        for own in &mechanism.clusters {
            let on_ground = own.parent.is_none() && own.parents.iter().filter(|p| p.is_none()).count() > 1;
            let simple = |&body: &usize| {
                matches!(plan.steps[body].motion, TreeMotion::Turn { .. } | TreeMotion::Slide { .. })
            };
            if on_ground || own.coordinates > MOST || !own.bodies.iter().all(simple) {
                return None;
            }
            let cluster = Self {
                freedoms: own.coordinates,
                offset: 0,
                bodies: own.bodies.len(),
                parent: own.parent,
                sizes: sizes(own, plan),
            };
            add_joints(own, plan, clusters.len());
            clusters.push(cluster);
        }
        Some(clusters)
    }

    /// Places the numbers of the cluster at the end of the workspace, which they lengthen.
    pub fn place(&mut self, end: &mut usize) {
        self.offset = *end;
        *end += self.numbers();
    }

    /// Number of values of the workspace per lane.
    fn numbers(&self) -> usize {
        let f = self.freedoms;
        f * f + 2 * f + WRENCH * f * (self.bodies + 1)
    }

    fn diagonal(&self, x: usize, y: usize) -> usize {
        self.offset + x.max(y) * self.freedoms + x.min(y)
    }

    fn test(&self, y: usize) -> usize {
        self.offset + self.freedoms * self.freedoms + y
    }

    fn test_size(&self, y: usize) -> usize {
        self.test(y) + self.freedoms
    }

    /// Offset of U_y of a body; `None` for the parent of the cluster.
    fn momentum(&self, body: Option<usize>, y: usize) -> usize {
        let f = self.freedoms;
        self.offset + f * f + 2 * f + WRENCH * (body.map_or(0, |body| body + 1) * f + y)
    }

    /// Sets the sums over the bodies to zero: D, the test wrench's components and U.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn clear<T: Lanes>(&self, scratch: &mut [f64]) {
        scratch[self.offset * T::WIDTH..(self.offset + self.numbers()) * T::WIDTH].fill(0.0);
    }
}

/// (Σ |mₖ| √sizeₖ)² over the joints of each coordinate, with the bound of eᵀIe of each joint: by Cauchy–Schwarz an upper bound
/// of all terms of D, also of mixed ones; plus the armatures.
fn sizes(own: &Cluster, plan: &TreePlan) -> [f64; MOST] {
    let (mut roots, mut armatures) = ([0.0; MOST], [0.0; MOST]);
    for velocity in &own.velocities {
        let step = &plan.steps[own.bodies[velocity.body]];
        let size = if let TreeMotion::Slide { .. } = step.motion { step.mass } else { step.moment };
        roots[velocity.coordinate] += velocity.multiplier.abs() * size.sqrt();
        armatures[velocity.coordinate] += velocity.multiplier * velocity.multiplier * velocity.armature;
    }
    std::array::from_fn(|y| roots[y] * roots[y] + armatures[y])
}

/// Marks the steps of a cluster. A term of two joints is bounded by the twists of both bodies, so that the bound by the kinetic energy
/// of one body is multiplied by four times the number of bodies.
fn add_joints(own: &Cluster, plan: &mut TreePlan, cluster: usize) {
    let mut beyond = vec![[false; MOST]; own.bodies.len()];
    for (at, &number) in own.bodies.iter().enumerate().rev() {
        let velocity = own.velocities.iter().find(|v| v.body == at);
        let joint = ClusterJoint {
            cluster,
            body: at,
            parent: own.parents[at],
            velocity: velocity.map(|v| (v.coordinate, v.multiplier, v.armature)),
            beyond: beyond[at],
            is_last: at == 0,
        };
        if let Some(parent) = own.parents[at] {
            for y in 0..MOST {
                beyond[parent][y] |= beyond[at][y] || velocity.is_some_and(|v| v.coordinate == y);
            }
        }
        let step = &mut plan.steps[number];
        step.free = [false; 6];
        step.share.amplification *= 4.0 * own.bodies.len() as f64;
        step.cluster_joint = Some(Box::new(joint));
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn get<T: Lanes>(scratch: &[f64], at: usize) -> T {
    T::load(&scratch[at * T::WIDTH..])
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn put<T: Lanes>(scratch: &mut [f64], at: usize, x: T) {
    x.store(&mut scratch[at * T::WIDTH..]);
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn add<T: Lanes>(scratch: &mut [f64], at: usize, x: T) {
    put(scratch, at, get::<T>(scratch, at) + x);
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn get_wrench<T: Lanes>(scratch: &[f64], at: usize) -> PackedWrench<T> {
    let number = |k: usize| get::<T>(scratch, at + k);
    PackedWrench { moment: [number(0), number(1), number(2)], force: [number(3), number(4), number(5)] }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn put_wrench<T: Lanes>(scratch: &mut [f64], at: usize, wrench: &PackedWrench<T>) {
    let mut k = 0;
    while k < 3 {
        put(scratch, at + k, wrench.moment[k]);
        put(scratch, at + 3 + k, wrench.force[k]);
        k += 1;
    }
}

/// Component of a wrench along the axis of a joint.
#[cfg_attr(not(debug_assertions), inline(always))]
fn along_axis<T: Lanes>(wrench: &PackedWrench<T>, slides: bool) -> T {
    if slides { wrench.force[2] } else { wrench.moment[2] }
}

/// Adds a body of a cluster to the sums; at the last body eliminates the coordinates of the cluster.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn eliminate_cluster_joint<T: Lanes>(
    clusters: &[MimicCluster],
    placed: &ScheduledStep,
    joint: &ClusterJoint,
    on_path: bool,
    at: LanePositions<'_>,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let (step, cluster) = (&placed.step, &clusters[joint.cluster]);
    let (offsets, tracks_sizes) = (&placed.offsets, propagated.tracks_sizes);
    let slides = matches!(step.motion, TreeMotion::Slide { .. });
    let mut inertia: PackedInertia<T> = if step.has_child_inertia {
        PackedInertia::load(offsets.inertia::<T>(scratch))
    } else {
        step.own.inertia.cast()
    };
    if tracks_sizes {
        if on_path {
            propagated.sizes.add_share(&step.share, offsets, scratch);
        }
        let sizes = Sizes::of(&inertia, step.has_child_inertia, offsets.inertia::<T>(scratch));
        placed.add_sizes_to_parent(sizes, scratch);
    }
    if let Some((x, multiplier, armature)) = joint.velocity {
        let factor = T::from_f64(multiplier);
        let armature = T::from_f64(armature);
        let pivot =
            if slides { inertia.slide_pivot::<2>(armature) } else { inertia.turn_pivot::<2>(armature) };
        let mut y = 0;
        while y < cluster.freedoms {
            if joint.beyond[y] {
                let momentum = get_wrench::<T>(scratch, cluster.momentum(Some(joint.body), y));
                let entry = factor * along_axis(&momentum, slides);
                // On the diagonal the term occurs twice.
                add(scratch, cluster.diagonal(x, y), if x == y { entry + entry } else { entry });
            }
            y += 1;
        }
        add(scratch, cluster.diagonal(x, x), factor * factor * pivot.d);
        let place = cluster.momentum(Some(joint.body), x);
        let mut momentum = pivot.u.scaled(factor);
        if joint.beyond[x] {
            momentum.add(&get_wrench(scratch, place));
        }
        put_wrench(scratch, place, &momentum);
        if on_path {
            add(scratch, cluster.test(x), factor * along_axis(&propagated.wrench, slides));
            if tracks_sizes {
                let size = propagated.sizes.along_axis(!slides);
                add(scratch, cluster.test_size(x), factor.abs() * size);
            }
        }
    }
    if step.parent.is_some() {
        transform_to_parent(step, &mut inertia, at, offsets.joint::<T>(scratch));
        if on_path {
            transform_to_parent(step, &mut propagated.wrench, at, offsets.joint::<T>(scratch));
            if tracks_sizes {
                propagated.sizes.add_reach(step.reach);
            }
        }
        let slot = offsets.parent_inertia::<T>(scratch);
        add_to_parent(&mut inertia, &placed.parent_inertia, placed.is_first, slot);
        let mut y = 0;
        while y < cluster.freedoms {
            if joint.beyond[y] || joint.velocity.is_some_and(|(x, ..)| x == y) {
                let mut momentum = get_wrench::<T>(scratch, cluster.momentum(Some(joint.body), y));
                transform_to_parent(step, &mut momentum, at, offsets.joint::<T>(scratch));
                let place = cluster.momentum(joint.parent, y);
                momentum.add(&get_wrench(scratch, place));
                put_wrench(scratch, place, &momentum);
            }
            y += 1;
        }
    }
    if joint.is_last {
        eliminate_coordinates::<T>(cluster, offsets, propagated, scratch);
    }
}

/// Eliminates the coordinates of a cluster one after another: D = L diag Lᵀ.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_coordinates<T: Lanes>(
    cluster: &MimicCluster,
    offsets: &Offsets,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let f = cluster.freedoms;
    let mut sizes: [T; MOST] = [T::zero(); MOST];
    let mut k = 0;
    while k < f {
        sizes[k] = T::from_f64(cluster.sizes[k]);
        k += 1;
    }
    let mut largest_loss = T::one();
    k = 0;
    while k < f {
        let over = T::one() / get::<T>(scratch, cluster.diagonal(k, k));
        let loss = sizes[k] * over.abs();
        largest_loss = largest_loss.max(loss);
        let momentum = get_wrench::<T>(scratch, cluster.momentum(None, k));
        let (t, test) = (get::<T>(scratch, cluster.test(k)), get::<T>(scratch, cluster.test_size(k)));
        // t is zero off the contact path.
        let rate = propagated.add_response(t, over);
        propagated.wrench.subtract(&momentum, rate);
        if propagated.tracks_sizes {
            propagated.sizes.add_response(sizes[k], test, rate);
            propagated.sizes.subtract(&momentum, rate);
        }
        if cluster.parent.is_some() {
            let slot = offsets.parent_inertia::<T>(scratch);
            let mut inertia: PackedInertia<T> = PackedInertia::load(slot);
            inertia.subtract_dyad(&momentum, &momentum.scaled(over));
            inertia.store(slot);
        }
        let mut j = k + 1;
        while j < f {
            let factor = get::<T>(scratch, cluster.diagonal(j, k)) * over;
            let mut c = k + 1;
            while c <= j {
                add(scratch, cluster.diagonal(j, c), -(factor * get::<T>(scratch, cluster.diagonal(c, k))));
                c += 1;
            }
            let mut other = get_wrench::<T>(scratch, cluster.momentum(None, j));
            other.subtract(&momentum, factor);
            put_wrench(scratch, cluster.momentum(None, j), &other);
            add(scratch, cluster.test(j), -(factor * t));
            add(scratch, cluster.test_size(j), factor.abs() * test);
            sizes[j] = (factor * factor).mul_add(sizes[k], sizes[j]);
            j += 1;
        }
        k += 1;
    }
    if !propagated.tracks_sizes {
        return;
    }
    propagated.sizes.record_loss(largest_loss);
    if cluster.parent.is_some() {
        let slot = offsets.parent_inertia::<T>(scratch);
        // The factor applies to all terms of the parent, so that those of its other children are overestimated.
        let factor = T::one().max(largest_loss * T::from_f64(1.0 / COMMON_LOSS));
        for k in [SIZES, SIZES + 1] {
            let size: T = T::load(&slot[k * T::WIDTH..]);
            (size * factor).store(&mut slot[k * T::WIDTH..]);
        }
    }
}

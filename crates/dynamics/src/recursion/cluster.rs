//! Elimination of one bound cluster: rates G over its independent coordinates, then block elimination.

use super::Recursion;
use super::elimination::{ClusterElimination, RecursionMotion};
use super::pivoting::Pivoting;
use crate::kinematics::frames::Kinematics;
use crate::mobility::{GroupMobility, Rates};
use crate::model::{Cluster, Model};
use crate::tolerances::LARGE_CLUSTER;
use nalgebra::Vector3;
use percuss_spatial::{ArticulatedInertia, Twist, Wrench};

impl<const K: usize> Recursion<K> {
    /// Eliminates the bound cluster `number`, stored at `clusters[place]`, and adds the remaining inertia and test wrenches to
    /// its parent. `point`: contact point in the root frame.
    #[expect(clippy::too_many_arguments, reason = "one step of `eliminate`, which owns all of these")]
    pub(super) fn eliminate_cluster(
        &mut self,
        model: &Model,
        kinematics: &Kinematics,
        groups: &[GroupMobility],
        number: usize,
        place: usize,
        point: &Vector3<f64>,
        pivoting: &mut Pivoting<K>,
    ) {
        let cluster = &model.clusters[number];
        let mut elimination = std::mem::take(&mut self.clusters[place]);
        elimination.fill_rates(model, kinematics, groups, cluster);
        elimination.fill_motions(model, kinematics, cluster, point);
        elimination.fill_blocks(self, cluster);
        pivoting.start_cluster(model, number, groups, &elimination, &self.armature);
        elimination.order.clear();
        elimination.dropped.clear();
        elimination.open.clear();
        elimination.open.resize(elimination.d, true);
        while let Some(pivot) = pivoting.next_pivot(&elimination) {
            elimination.eliminate(pivot);
        }
        let d = elimination.d;
        let ClusterElimination { open, dropped, .. } = &mut elimination;
        dropped.extend((0..d).filter(|y| open[*y]));
        pivoting.record_dropped(place, &elimination);
        if let Some(parent) = cluster.parent {
            for &b in &cluster.bodies {
                let (lower, upper) = self.inertias.split_at_mut(b);
                lower[parent] += &upper[0];
                for k in 0..K {
                    let f = self.wrenches[b][k];
                    self.wrenches[parent][k] += f;
                }
                pivoting.propagate_sizes(b, parent);
            }
            for &y in &elimination.order {
                let over_d = elimination.u[y] * (1.0 / elimination.factor[y * d + y]);
                self.inertias[parent].subtract_dyad(&over_d, &elimination.u[y]);
                for k in 0..K {
                    self.wrenches[parent][k] -= over_d * elimination.t[y][k];
                }
                pivoting.propagate_wrench_change(parent, &elimination, y);
            }
        }
        self.clusters[place] = elimination;
    }
}

impl<const K: usize> ClusterElimination<K> {
    /// G: the constraints of each group are eliminated; coordinates outside all groups are independent.
    fn fill_rates(
        &mut self,
        model: &Model,
        kinematics: &Kinematics,
        groups: &[GroupMobility],
        cluster: &Cluster,
    ) {
        self.rates.resize_with(cluster.groups.len(), Rates::default);
        let n = cluster.coordinates.len();
        let bound: usize = cluster.groups.iter().map(|g| g.coordinates.len()).sum();
        let free: usize = cluster.groups.iter().map(|g| groups[g.group].independent.len()).sum();
        self.d = n - bound + free;
        let d = self.d;
        self.g.clear();
        self.g.resize(n * d, 0.0);
        self.independent.clear();
        let mut next = 0;
        for (rates, own) in self.rates.iter_mut().zip(&cluster.groups) {
            let known = &groups[own.group];
            let count = known.independent.len();
            let values = if known.rates.is_empty() {
                rates.fill(model, &model.groups[own.group], kinematics, known);
                &rates.values
            } else {
                &known.rates
            };
            for (row, &c) in own.coordinates.iter().enumerate() {
                for y in 0..count {
                    self.g[c * d + next + y] = values[row * count + y];
                }
            }
            next += count;
            self.independent.extend(known.independent.iter().map(|&y| own.coordinates[y]));
        }
        for c in (0..n).filter(|c| !cluster.groups.iter().any(|g| g.coordinates.binary_search(c).is_ok())) {
            self.g[c * d + next] = 1.0;
            self.independent.push(c);
            next += 1;
        }
    }

    /// Motion columns at the contact point `point`, in root axes: S of every velocity, and Ψ of every body (its twist per
    /// independent coordinate, relative to the parent of the cluster).
    fn fill_motions(
        &mut self,
        model: &Model,
        kinematics: &Kinematics,
        cluster: &Cluster,
        point: &Vector3<f64>,
    ) {
        let d = self.d;
        self.s.clear();
        self.psi.clear();
        self.psi.resize(cluster.bodies.len() * d, Twist::zero());
        let mut velocities = cluster.velocities.iter().peekable();
        for (at, parent) in cluster.parents.iter().enumerate() {
            if let Some(parent) = parent {
                self.psi.copy_within(parent * d..(parent + 1) * d, at * d);
            }
            while let Some(v) = velocities.next_if(|v| v.body == at) {
                let s = kinematics.column_at(model, cluster.bodies[at], v.component, point);
                self.s.push(s);
                let multiplier = v.multiplier;
                for y in 0..d {
                    let rate = self.g[v.coordinate * d + y] * multiplier;
                    self.psi[at * d + y] += s * rate;
                }
            }
        }
    }

    /// Computes D, U and t over the independent coordinates from Ψ, the articulated inertias and the test wrenches.
    fn fill_blocks(&mut self, recursion: &Recursion<K>, cluster: &Cluster) {
        let d = self.d;
        if d > LARGE_CLUSTER {
            return self.fill_large_blocks(recursion, cluster);
        }
        self.u.clear();
        self.u.resize(d, Wrench::zero());
        self.t.clear();
        self.t.resize(d, [0.0; K]);
        self.factor.clear();
        self.factor.resize(d * d, 0.0);
        for (at, &b) in cluster.bodies.iter().enumerate() {
            for y in 0..d {
                let psi = self.psi[at * d + y];
                let momentum = recursion.inertias[b].apply(&psi);
                self.u[y] += momentum;
                for x in 0..=y {
                    self.factor[y * d + x] += momentum.power(&self.psi[at * d + x]);
                }
                for (t, f) in self.t[y].iter_mut().zip(&recursion.wrenches[b]) {
                    *t += f.power(&psi);
                }
            }
        }
        for v in &cluster.velocities {
            let armature = recursion.armature[v.index] * v.multiplier * v.multiplier;
            for y in 0..d {
                let weighted = armature * self.g[v.coordinate * d + y];
                for x in 0..=y {
                    self.factor[y * d + x] += weighted * self.g[v.coordinate * d + x];
                }
            }
        }
        for y in 0..d {
            for x in 0..y {
                self.factor[x * d + y] = self.factor[y * d + x];
            }
        }
    }

    /// Alternative with the cluster's own mass matrix M: GᵀMG costs O(n²), the sums over bodies O(n d²). The terms of
    /// its sums can be negative, which costs digits if masses differ by many decades.
    fn fill_large_blocks(&mut self, recursion: &Recursion<K>, cluster: &Cluster) {
        let (n, d) = (cluster.coordinates.len(), self.d);
        let mut composites: Vec<ArticulatedInertia<f64>> =
            cluster.bodies.iter().map(|&b| recursion.inertias[b]).collect();
        let mut wrenches: Vec<[Wrench<f64>; K]> =
            cluster.bodies.iter().map(|&b| recursion.wrenches[b]).collect();
        for at in (0..cluster.bodies.len()).rev() {
            if let Some(parent) = cluster.parents[at] {
                let (upper, lower) = composites.split_at_mut(at);
                upper[parent] += &lower[0];
                let below = wrenches[at];
                wrenches[parent].iter_mut().zip(below).for_each(|(sum, f)| *sum += f);
            }
        }
        // Velocities of a body are adjacent, after those of its parent.
        let mut first = vec![0; cluster.bodies.len() + 1];
        cluster.velocities.iter().for_each(|v| first[v.body + 1] += 1);
        (0..cluster.bodies.len()).for_each(|at| first[at + 1] += first[at]);
        let mut mass = vec![0.0; n * n];
        let mut momenta = vec![Wrench::zero(); n];
        let mut tests = vec![[0.0; K]; n];
        for (i, v) in cluster.velocities.iter().enumerate() {
            let multiplier = v.multiplier;
            let momentum = composites[v.body].apply(&self.s[i]) * multiplier;
            momenta[v.coordinate] += momentum;
            for (test, f) in tests[v.coordinate].iter_mut().zip(&wrenches[v.body]) {
                *test += f.power(&self.s[i]) * multiplier;
            }
            let armature = recursion.armature[v.index] * multiplier * multiplier;
            mass[v.coordinate * n + v.coordinate] += armature;
            let mut at = Some(v.body);
            let mut end = i + 1;
            while let Some(body) = at {
                for l in first[body]..end {
                    let other = &cluster.velocities[l];
                    let entry = momentum.power(&self.s[l]) * other.multiplier;
                    mass[other.coordinate * n + v.coordinate] += entry;
                    if l != i {
                        mass[v.coordinate * n + other.coordinate] += entry;
                    }
                }
                at = cluster.parents[body];
                end = at.map_or(0, |parent| first[parent + 1]);
            }
        }
        self.reduce(n, &mass, &momenta, &tests);
        debug_assert_eq!(self.factor.len(), d * d);
    }

    /// D = GᵀMG, U and t from the same quantities over all coordinates; most rows of G are unit vectors.
    fn reduce(&mut self, n: usize, mass: &[f64], momenta: &[Wrench<f64>], tests: &[[f64; K]]) {
        let d = self.d;
        let mut is_independent = vec![false; n];
        self.independent.iter().for_each(|c| is_independent[*c] = true);
        let dependent: Vec<usize> = (0..n).filter(|c| !is_independent[*c]).collect();
        // M G, n × d.
        let mut product = vec![0.0; n * d];
        for row in 0..n {
            for (y, &c) in self.independent.iter().enumerate() {
                product[row * d + y] = mass[row * n + c];
            }
            for &c in &dependent {
                let entry = mass[row * n + c];
                for y in 0..d {
                    product[row * d + y] += entry * self.g[c * d + y];
                }
            }
        }
        self.factor.clear();
        self.factor.resize(d * d, 0.0);
        self.u.clear();
        self.t.clear();
        for (x, &c) in self.independent.iter().enumerate() {
            self.factor[x * d..(x + 1) * d].copy_from_slice(&product[c * d..(c + 1) * d]);
            self.u.push(momenta[c]);
            self.t.push(tests[c]);
        }
        for &c in &dependent {
            for x in 0..d {
                let rate = self.g[c * d + x];
                for y in 0..d {
                    self.factor[x * d + y] += rate * product[c * d + y];
                }
                self.u[x] += momenta[c] * rate;
                for k in 0..K {
                    self.t[x][k] += tests[c][k] * rate;
                }
            }
        }
    }

    /// Eliminates one pivot from the remaining ones: LDLᵀ, with the updates of U and t.
    fn eliminate(&mut self, pivot: usize) {
        let d = self.d;
        self.order.push(pivot);
        self.open[pivot] = false;
        let over = 1.0 / self.factor[pivot * d + pivot];
        for y in 0..d {
            if !self.open[y] {
                continue;
            }
            let factor = self.factor[y * d + pivot] * over;
            for x in 0..d {
                if self.open[x] {
                    let change = factor * self.factor[pivot * d + x];
                    self.factor[y * d + x] -= change;
                }
            }
            let change = self.u[pivot] * factor;
            self.u[y] -= change;
            for k in 0..K {
                let change = self.t[pivot][k] * factor;
                self.t[y][k] -= change;
            }
            // The column now holds L.
            self.factor[y * d + pivot] = factor;
        }
    }

    pub fn response(&self, a: usize, b: usize) -> f64 {
        let part = |y: &usize| self.t[*y][a] * self.t[*y][b] / self.factor[y * self.d + y];
        self.order.iter().fold(0.0, |sum, y| sum + part(y))
    }

    /// Adds tᵀ D⁻¹ t for wrenches on the bodies and forces on the coordinates; returns the wrench passed to the parent.
    pub fn propagate_wrench(
        &self,
        cluster: &Cluster,
        wrenches: &[Wrench<f64>],
        forces: &[f64],
        sum: &mut f64,
    ) -> Wrench<f64> {
        let d = self.d;
        let mut t = vec![0.0; d];
        let mut passed = Wrench::zero();
        for (at, &b) in cluster.bodies.iter().enumerate() {
            passed += wrenches[b];
            t.iter_mut().zip(&self.psi[at * d..]).for_each(|(t, psi)| *t += wrenches[b].power(psi));
        }
        for (c, force) in forces.iter().enumerate() {
            t.iter_mut().zip(&self.g[c * d..]).for_each(|(t, g)| *t += *g * *force);
        }
        for (i, &y) in self.order.iter().enumerate() {
            let part = t[y] / self.factor[y * d + y];
            *sum += t[y] * part;
            passed -= self.u[y] * part;
            for &x in &self.order[i + 1..] {
                let change = self.factor[x * d + y] * t[y];
                t[x] -= change;
            }
        }
        passed
    }

    /// Rates u of the independent coordinates for a parent with the twist V (`twist`): D u = t − Uᵀ V, with t = 0 unless
    /// `loaded`. Dropped coordinates have the rate 0, except coordinate `free` with the rate 1. Overwrites `u`.
    pub fn fill_independent_rates(
        &self,
        twist: &Twist<f64>,
        loaded: bool,
        free: Option<usize>,
        u: &mut Vec<f64>,
    ) {
        let d = self.d;
        u.clear();
        u.resize(d, 0.0);
        if let Some(y) = free {
            u[y] = 1.0;
        }
        for (i, &y) in self.order.iter().enumerate().rev() {
            let own = if loaded { self.t[y][0] } else { 0.0 };
            let mut rate = (own - self.u[y].power(twist)) / self.factor[y * d + y];
            let later = self.order[i + 1..].iter().chain(&self.dropped);
            for &x in later {
                rate -= self.factor[x * d + y] * u[x];
            }
            u[y] = rate;
        }
    }

    /// Velocities and twists of the cluster; with `free`, those of a massless motion instead of the response.
    pub fn velocities(&self, cluster: &Cluster, motion: &mut RecursionMotion, free: Option<usize>) {
        self.distribute_velocities(cluster, motion, free.is_none(), free);
    }

    /// Velocities and twists without a load: the cluster follows its parent.
    pub fn follow_parent(&self, cluster: &Cluster, motion: &mut RecursionMotion) {
        self.distribute_velocities(cluster, motion, false, None);
    }

    /// Velocities and twists of the cluster's bodies, from the twist of the parent. `loaded`: with the response to test
    /// wrench 0; `free`: dropped coordinate that gets the rate 1.
    fn distribute_velocities(
        &self,
        cluster: &Cluster,
        motion: &mut RecursionMotion,
        loaded: bool,
        free: Option<usize>,
    ) {
        let RecursionMotion { velocities, twists, rates } = motion;
        let parent_twist = cluster.parent.map_or_else(Twist::zero, |p| twists[p]);
        self.fill_independent_rates(&parent_twist, loaded, free, rates);
        let d = self.d;
        for v in &cluster.velocities {
            let row = &self.g[v.coordinate * d..(v.coordinate + 1) * d];
            let rate = row.iter().zip(&*rates).fold(0.0, |sum, (g, u)| sum + *g * *u);
            velocities[v.index] = rate * v.multiplier;
        }
        for (at, &b) in cluster.bodies.iter().enumerate() {
            let mut twist = parent_twist;
            for (psi, u) in self.psi[at * d..(at + 1) * d].iter().zip(&*rates) {
                twist += *psi * *u;
            }
            twists[b] = twist;
        }
    }
}

impl<const K: usize> ClusterElimination<K> {
    /// Part of [`Recursion::for_each_pivot`] for this cluster. For a dropped coordinate the motion has, in each part, the
    /// largest magnitude over the bodies, since only its size is used; for a pivot the motion is zero.
    pub fn for_each_pivot(&self, take: &mut impl FnMut(&[f64; K], Option<f64>, &Twist<f64>) -> bool) -> bool {
        let d = self.d;
        let largest = |y: usize| {
            let bodies = self.psi.chunks_exact(d).map(|psi| &psi[y]);
            let (turn, slide) = bodies.fold((0.0_f64, 0.0_f64), |(turn, slide), psi| {
                (turn.max(psi.angular.norm()), slide.max(psi.linear.norm()))
            });
            Twist::new(Vector3::x() * turn, Vector3::x() * slide)
        };
        self.order.iter().all(|&y| take(&self.t[y], Some(self.factor[y * d + y]), &Twist::zero()))
            && self.dropped.iter().all(|&y| take(&self.t[y], None, &largest(y)))
    }
}

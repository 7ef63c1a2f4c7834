//! Clusters of mimic joints, all of which follow one coordinate.

use super::plan::{Member, Step};
use super::recursion::{
    AXIS, INERTIA, LaneState, OVER_PIVOT, PRODUCT, SIZES, add, apply, dot, load, load_twist, load_wrench,
    store, store_screw,
};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedTwist, PackedWrench};

impl<T: Lanes> LaneState<'_, T> {
    /// Stores the reach of a body of a cluster. The first body has the sums of the cluster in that place, zero at the start.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn fill_reach(&mut self, number: usize, member: &Member) {
        let (plan, zero) = (self.plan, T::zero());
        let step = &plan.steps[number];
        let mut reach = PackedTwist::zero();
        if number != member.head {
            reach = self.own_reach(step, member);
            if let Some(parent) = member.parent {
                let above = self.reach(parent);
                reach.angular = add(&reach.angular, &above.angular);
                reach.linear = add(&reach.linear, &above.linear);
            }
        }
        let to = self.velocity_mut(step, 0);
        store_screw(&reach.angular, &reach.linear, &mut to[PRODUCT * T::WIDTH..]);
        store(&[zero, zero], &mut to[OVER_PIVOT * T::WIDTH..]);
    }

    /// Twist of a body at a unit rate of the coordinate of its cluster, with its parent at rest.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn own_reach(&self, step: &Step, member: &Member) -> PackedTwist<T> {
        let axis = load_twist::<T>(&self.velocity(step, 0)[AXIS * T::WIDTH..]);
        let m = T::from_f64(member.multiplier);
        let (ω, v) = (&axis.angular, &axis.linear);
        PackedTwist { angular: [m * ω[0], m * ω[1], m * ω[2]], linear: [m * v[0], m * v[1], m * v[2]] }
    }

    /// Twist of a body at a unit rate of the coordinate of its cluster, with the parent of the cluster at rest.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn reach(&self, number: usize) -> PackedTwist<T> {
        let plan = self.plan;
        let step = &plan.steps[number];
        match &step.member {
            Some(member) if member.head == number => self.own_reach(step, member),
            _ => load_twist(&self.velocity(step, 0)[PRODUCT * T::WIDTH..]),
        }
    }

    /// Adds a body of a cluster to the sums of the cluster and to the parent of the cluster; the first body, the last one here, then
    /// eliminates the coordinate.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn eliminate_member(&mut self, number: usize, member: &Member, wrench: &mut PackedWrench<T>) {
        let plan = self.plan;
        let (step, head) = (&plan.steps[number], &plan.steps[member.head]);
        let own = self.body(number);
        let inertia = PackedInertia::<T>::load(&own[INERTIA * T::WIDTH..]);
        let [moments, mass] = load::<T, 2>(&own[SIZES * T::WIDTH..]);
        let reach = self.reach(number);
        let u = apply(&inertia, &reach);
        let (ω, v) = (dot(&reach.angular, &reach.angular), dot(&reach.linear, &reach.linear));
        let armature = T::from_f64(member.multiplier * member.multiplier * step.armature[0]);
        let sums = self.velocity(head, 0);
        let mut momentum = load_wrench::<T>(&sums[PRODUCT * T::WIDTH..]);
        let [mut pivot, mut terms] = load::<T, 2>(&sums[OVER_PIVOT * T::WIDTH..]);
        momentum.add(&u);
        pivot += reach.power(&u) + armature;
        terms += ω.mul_add(moments, v * mass);
        let mut last = [pivot, terms];
        if number == member.head {
            let over = T::one() / pivot;
            self.loss = self.loss.max(((terms + terms) * over).abs());
            let mut load = T::zero();
            if let Some(end) = self.selection.ends[number] {
                load = self.reach(end).power(wrench);
                self.response = (load * load).mul_add(over, self.response);
                wrench.subtract(&momentum.scaled(over), load);
            }
            last = [over, load];
        }
        let to = self.velocity_mut(head, 0);
        store_screw(&momentum.moment, &momentum.force, &mut to[PRODUCT * T::WIDTH..]);
        store(&last, &mut to[OVER_PIVOT * T::WIDTH..]);
        let Some(parent) = member.outside else { return };
        let above = self.body_mut(parent);
        let mut sum = PackedInertia::<T>::load(&above[INERTIA * T::WIDTH..]);
        sum.add(&inertia);
        if number == member.head {
            sum.subtract_dyad(&momentum, &momentum.scaled(last[0]));
        }
        sum.store(&mut above[INERTIA * T::WIDTH..]);
        let [a, m] = load::<T, 2>(&above[SIZES * T::WIDTH..]);
        store(&[a + moments, m + mass], &mut above[SIZES * T::WIDTH..]);
    }

    /// Rate of the coordinate of a cluster under the unit force. The first body computes and keeps it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn cluster_rate(&mut self, number: usize, member: &Member, above: &PackedTwist<T>) -> T {
        let plan = self.plan;
        let head = &plan.steps[member.head];
        let sums = self.velocity(head, 0);
        let [over, load] = load::<T, 2>(&sums[OVER_PIVOT * T::WIDTH..]);
        if number != member.head {
            return load;
        }
        let rate = (load - above.power(&load_wrench::<T>(&sums[PRODUCT * T::WIDTH..]))) * over;
        rate.store(&mut self.velocity_mut(head, 0)[(OVER_PIVOT + 1) * T::WIDTH..]);
        rate
    }
}

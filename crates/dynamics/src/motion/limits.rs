//! Limits of m̄ along the branches at a change point. The m̄ at the change point itself is only a lower bound.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::analysis::routes::{RecursionWorkspace, RouteInput};
use crate::dense::direct::Minimum;
use crate::kinematics::contact::{Contact, LocatedContact};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::EffectiveMass;
use crate::linear::dense::dot;
use crate::loops::singular::Surroundings;
use crate::model::Model;
use crate::tolerances::{
    BRANCH_COMBINATIONS, DOUBTFUL_LIMIT, LAGRANGE_EIGHT, LAGRANGE_SIX, LEAST_BRANCH_COSINE, LIMIT_PLACES,
    LIMIT_STEPS, LIMITS_AGREE, LIMITS_BY_DENSE_ROUTE, LIMITS_BY_RECURSION, VANISHING_LIMIT,
};

/// Limits of m̄ at a crossing of branches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BranchLimits {
    /// One limit per branch. If several groups that affect the contact are at crossings of their own: one limit per
    /// combination of branches. For a continuum of branches: the smallest and the largest limit of the samples.
    pub limits: Vec<EffectiveMass>,
    /// True if the branches form a continuum: the limit depends on the direction of approach.
    pub continuous: bool,
    /// True if there is no sign of further branches, and m̄ was extrapolated along every branch.
    pub complete: bool,
}

impl Pose {
    /// Limits of m̄ along the branches that cross at a singular pose. Empty at a regular pose, and if no branch
    /// leaves the pose.
    pub fn branch_limits(&self, contact: &Contact) -> BranchLimits {
        let assembly = self.assembly();
        let Crossings { crossings, complete } = crossings_of(self, contact);
        if crossings.is_empty() {
            return BranchLimits { complete, ..BranchLimits::default() };
        }
        let count = |n: usize, c: &&Surroundings| n.saturating_mul(c.branches.len());
        let combinations = crossings.iter().fold(1, count);
        let route = LimitRoute::of(assembly.model(), combinations.min(BRANCH_COMBINATIONS));
        let limit = |number: usize| limit_along(self, contact, &crossings, route, number);
        let continuous = crossings.iter().any(|c| c.continuous);
        let looked_at = combinations.min(BRANCH_COMBINATIONS).min(route.most_combinations(assembly.model()));
        let mut limits: Vec<EffectiveMass> = (0..looked_at).filter_map(limit).collect();
        let all_followed = limits.len() == combinations;
        if continuous {
            limits.sort_by(|a, b| value(a).total_cmp(&value(b)));
            let last = limits.len().saturating_sub(1);
            limits = limits
                .into_iter()
                .enumerate()
                .filter(|(i, _)| *i == 0 || *i == last)
                .map(|(_, l)| l)
                .collect();
        }
        BranchLimits { limits, continuous, complete: all_followed && complete }
    }
}

/// Method for m̄ at poses near a crossing.
#[derive(Clone, Copy, PartialEq)]
enum LimitRoute {
    /// Dense route, for small mechanisms.
    Dense,
    /// Recursion, with the mobility decided by the assembly at each place.
    Recursion,
}

impl LimitRoute {
    /// Chooses the dense route if its total work is within the limit.
    fn of(model: &Model, combinations: usize) -> Self {
        let work =
            model.velocity_coordinates.len().saturating_pow(3).saturating_mul(LIMIT_PLACES * combinations);
        if work <= LIMITS_BY_DENSE_ROUTE { LimitRoute::Dense } else { LimitRoute::Recursion }
    }

    /// Largest number of combinations of branches within the work limit.
    fn most_combinations(self, model: &Model) -> usize {
        match self {
            LimitRoute::Dense => BRANCH_COMBINATIONS,
            LimitRoute::Recursion => {
                (LIMITS_BY_RECURSION / (LIMIT_PLACES * model.bodies.len().max(1))).max(1)
            }
        }
    }

    /// m̄ at given frames; `None` if m̄ is not a minimum, or the matrices are too large.
    fn mass(
        self,
        assembly: &Assembly,
        kinematics: &Kinematics,
        located: &LocatedContact,
    ) -> Option<EffectiveMass> {
        let model = assembly.model();
        let groups = assembly.decide_mobility(kinematics);
        match self {
            LimitRoute::Dense => match model.least_energy(kinematics, &groups, located).minimum {
                Minimum::Finite(m) => Some(EffectiveMass::Finite(m)),
                Minimum::Immovable => Some(EffectiveMass::Immovable),
                Minimum::Massless => Some(EffectiveMass::Massless),
                Minimum::Stationary(_) => None,
            },
            LimitRoute::Recursion => {
                model.refuse_large_clusters(&groups).ok()?;
                let route_input =
                    RouteInput { model, kinematics, groups: &groups, misfits: assembly.misfits(), located };
                let mut workspace = RecursionWorkspace::new(model);
                route_input.run_recursion(&mut workspace);
                (!workspace.deciding.indefinite).then(|| workspace.mass())
            }
        }
    }
}

/// Groups at crossings that affect the contact.
struct Crossings<'a> {
    /// Groups with branches; groups that move the contact directly come first.
    crossings: Vec<&'a Surroundings>,
    /// True if the search was complete for every group.
    complete: bool,
}

/// Crossings of branches at a pose that affect a contact.
fn crossings_of<'a>(pose: &'a Pose, contact: &Contact) -> Crossings<'a> {
    let known = pose.crossings();
    let of_group = |number| known.iter().find(|(n, _)| *n == number).map(|(_, around)| around);
    let coupled = coupled_groups(pose.assembly().pose_model(), contact).into_iter();
    let all: Vec<&Surroundings> = coupled.filter_map(of_group).filter(|a| !a.regular).collect();
    let complete = all.iter().all(|a| a.complete);
    Crossings { crossings: all.into_iter().filter(|a| !a.branches.is_empty()).collect(), complete }
}

/// Groups of constraints that can affect the contact: on the trees of the contact's two links, or on trees coupled to these
/// by constraints. Groups with an ancestor of these links come first.
fn coupled_groups(model: &Model, contact: &Contact) -> Vec<usize> {
    let mut tree_of: Vec<usize> = Vec::with_capacity(model.bodies.len());
    for (i, body) in model.bodies.iter().enumerate() {
        tree_of.push(body.parent.map_or(i, |p| tree_of[p]));
    }
    let sides = [Some(contact.link), contact.against].into_iter().flatten();
    let bodies: Vec<usize> = sides.filter_map(|link| model.body_of(link)).collect();
    let mut reached: Vec<usize> = bodies.iter().map(|&b| tree_of[b]).collect();
    let trees: Vec<Vec<usize>> =
        model.groups.iter().map(|g| g.bodies.iter().map(|&b| tree_of[b]).collect()).collect();
    let mut found: Vec<usize> = Vec::new();
    loop {
        let next = (0..model.groups.len())
            .find(|g| !found.contains(g) && trees[*g].iter().any(|t| reached.contains(t)));
        let Some(next) = next else { break };
        reached.extend(&trees[next]);
        found.push(next);
    }
    let mut carriers = vec![false; model.bodies.len()];
    for body in bodies {
        std::iter::successors(Some(body), |&b| model.bodies[b].parent).for_each(|b| carriers[b] = true);
    }
    found.sort_by_key(|&g| !model.groups[g].bodies.iter().any(|&b| carriers[b]));
    found
}

/// Limit of m̄ at the crossings along combination `number` of their branches, one branch per crossing. Lagrange's formula
/// interpolates 1/m̄ from four places on each side; a formula of lower order must agree. `None` if they disagree, or if the
/// places cannot be reached.
fn limit_along(
    pose: &Pose,
    contact: &Contact,
    crossings: &[&Surroundings],
    route: LimitRoute,
    number: usize,
) -> Option<EffectiveMass> {
    let assembly: &Assembly = pose.assembly();
    let at = |places: i32, apart: f64| {
        let mut kinematics: Kinematics = pose.kinematics.clone();
        let mut number = number;
        for around in crossings {
            let along = &around.branches[number % around.branches.len()].along;
            number /= around.branches.len();
            let displaced = assembly.pose_model().close_at_distance(
                &mut kinematics,
                around,
                along,
                f64::from(places) * apart * around.group.size,
            )?;
            if dot(&displaced, along) < LEAST_BRANCH_COSINE * dot(&displaced, &displaced).sqrt() {
                return None;
            }
        }
        let located = assembly.model().locate(&kinematics, &pose.base, contact).ok()?;
        route.mass(assembly, &kinematics, &located)
    };
    let mut best: Option<(f64, EffectiveMass)> = None;
    for apart in LIMIT_STEPS {
        let Some((doubt, limit)) = extrapolate_limit(&|places| at(places, apart)) else { continue };
        if best.is_none_or(|(least, _)| doubt < least) {
            best = Some((doubt, limit));
        }
        if doubt < LIMITS_AGREE {
            break;
        }
    }
    best.filter(|(doubt, _)| *doubt <= DOUBTFUL_LIMIT).map(|(_, limit)| limit)
}

/// Sort key of a limit: m̄; infinite if immovable, 0 if massless.
fn value(limit: &EffectiveMass) -> f64 {
    match limit {
        EffectiveMass::Finite(m) => *m,
        EffectiveMass::Immovable => f64::INFINITY,
        EffectiveMass::Massless => 0.0,
    }
}

/// Limit from the values at one to four places on each side, and the difference between two orders of the
/// interpolation. A branch is immovable or massless if all places are.
fn extrapolate_limit(at: &dyn Fn(i32) -> Option<EffectiveMass>) -> Option<(f64, EffectiveMass)> {
    let (mut mobility, mut coarse, mut most_mobile) = (0.0, 0.0, 0.0_f64);
    let (mut mass, mut coarse_mass, mut heaviest) = (0.0, 0.0, 0.0_f64);
    let mut state = None;
    for place in 0..4 {
        for side in [1, -1] {
            let here = at(side * (place as i32 + 1))?;
            let same = |known: &EffectiveMass| std::mem::discriminant(known) == std::mem::discriminant(&here);
            if !same(state.get_or_insert(here)) {
                return None;
            }
            let EffectiveMass::Finite(m) = here else { continue };
            mobility += LAGRANGE_EIGHT[place] / m;
            coarse += LAGRANGE_SIX[place] / m;
            mass += LAGRANGE_EIGHT[place] * m;
            coarse_mass += LAGRANGE_SIX[place] * m;
            most_mobile = most_mobile.max(1.0 / m);
            heaviest = heaviest.max(m);
        }
    }
    match state? {
        EffectiveMass::Finite(_) => {}
        same @ (EffectiveMass::Immovable | EffectiveMass::Massless) => return Some((0.0, same)),
    }
    let doubt = (mobility - coarse).abs() / most_mobile;
    Some(if mobility <= VANISHING_LIMIT * most_mobile {
        (doubt, EffectiveMass::Immovable)
    } else if mass <= VANISHING_LIMIT * heaviest {
        ((mass - coarse_mass).abs() / heaviest, EffectiveMass::Massless)
    } else {
        (doubt * most_mobile / mobility, EffectiveMass::Finite(1.0 / mobility))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_branch_is_carried_on() {
        let Some((doubt, EffectiveMass::Finite(m))) =
            extrapolate_limit(&|place| Some(EffectiveMass::Finite(2.0 + 0.01 * f64::from(place))))
        else {
            panic!("a limit")
        };
        assert!(doubt < LIMITS_AGREE && (m - 2.0).abs() < 1e-7, "{m} ± {doubt:e}");
    }

    #[test]
    fn a_state_is_one_of_all_places() {
        let all = extrapolate_limit(&|_| Some(EffectiveMass::Immovable));
        assert_eq!(all, Some((0.0, EffectiveMass::Immovable)));
        for odd in [-4, -1, 1, 4] {
            let but_one =
                |place| Some(if place == odd { EffectiveMass::Massless } else { EffectiveMass::Finite(2.0) });
            assert_eq!(extrapolate_limit(&but_one), None, "{odd}");
            let but_one = |place| {
                Some(if place == odd { EffectiveMass::Finite(2.0) } else { EffectiveMass::Immovable })
            };
            assert_eq!(extrapolate_limit(&but_one), None, "{odd}");
        }
    }

    #[test]
    fn values_that_jump_have_no_limit() {
        let jumps = |place: i32| Some(EffectiveMass::Finite(if place % 2 == 0 { 1.0 } else { 7.0 }));
        let (doubt, _) = extrapolate_limit(&jumps).expect("numbers");
        assert!(doubt > DOUBTFUL_LIMIT, "{doubt:e}");
    }
}

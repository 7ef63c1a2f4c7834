//! At a change point (D) is a lower bound that no branch attains. The limits of m̄ along each.

use crate::assembly::Assembly;
use crate::careful::Minimum;
use crate::contact::Contact;
use crate::kinematics::Kinematics;
use crate::model::Model;
use crate::outcome::EffectiveMass;
use crate::pose::Pose;
use crate::singular::{Surroundings, dot};

/// How far apart are the places from which m̄ is carried on to the crossing, in parts of the groups' sizes; the next is
/// tried where the values vary too much.
const APART: [f64; 4] = [0.01, 2.5e-3, 6e-4, 1.5e-4];
/// Two orders of the interpolation that agree to this are good: the higher one is much better than that.
const AGREE: f64 = 1e-7;
/// Two orders that differ by more than this part leave no limit to speak of: it would have three digits, where the places
/// are as near as rounding lets them be.
const DOUBTFUL: f64 = 1e-3;
/// Most combinations of branches of several groups that are looked at.
const COMBINATIONS: usize = 256;
/// A limit below this part of the values it is carried on from is zero.
const VANISHING: f64 = 1e-7;
/// Cosine between a branch and where it is at the places.
const BENT: f64 = 0.9;

/// Limits of m̄ where branches cross.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BranchLimits {
    /// One for each branch, or for each combination of branches where several groups that affect the contact stand at
    /// crossings of their own. Of a continuum of branches, the least and the greatest of the samples taken.
    pub limits: Vec<EffectiveMass>,
    /// Whether the branches are a continuum: the limit depends on the direction of approach.
    pub continuous: bool,
    /// Whether no sign of more branches than these was found, and m̄ could be carried on along each.
    pub complete: bool,
}

impl Pose {
    /// Limits of the answer along the branches that cross at a singular pose; none at a regular one, nor where no
    /// branch leads away.
    pub fn branch_limits(&self, contact: &Contact) -> BranchLimits {
        let assembly = self.assembly();
        let crossings = crossings_of(self, contact);
        if crossings.is_empty() {
            return BranchLimits { complete: true, ..BranchLimits::default() };
        }
        let count = |n: usize, c: &&Surroundings| n.saturating_mul(c.branches.len());
        let combinations = crossings.iter().fold(1, count);
        let limit = |number: usize| limit_along(assembly, self, contact, &crossings, number);
        let continuous = crossings.iter().any(|c| c.continuous);
        let mut limits: Vec<EffectiveMass> = (0..combinations.min(COMBINATIONS)).filter_map(limit).collect();
        let answered = limits.len() == combinations;
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
        BranchLimits { limits, continuous, complete: answered && crossings.iter().all(|c| c.complete) }
    }
}

/// The groups at crossings that affect the contact, those that it moves itself first.
fn crossings_of<'a>(pose: &'a Pose, contact: &Contact) -> Vec<&'a Surroundings> {
    let known = pose.crossings();
    let of_group = |number| known.iter().find(|(n, _)| *n == number).map(|(_, around)| around);
    let coupled = coupled_groups(pose.assembly().posing(), contact).into_iter();
    coupled.filter_map(of_group).filter(|a| !a.branches.is_empty() && !a.regular).collect()
}

/// Groups on the trees, or tied to the trees, that the contact's sides stand on; those that move the sides first.
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

/// The limit along a combination of branches: at four places on either side, Lagrange's formula for 1/m̄ carries it
/// on; the order below must agree.
fn limit_along(
    assembly: &Assembly,
    pose: &Pose,
    contact: &Contact,
    crossings: &[&Surroundings],
    number: usize,
) -> Option<EffectiveMass> {
    let at = |places: i32, apart: f64| {
        let mut kinematics: Kinematics<f64> = pose.kinematics.clone();
        let mut number = number;
        for around in crossings {
            let along = &around.branches[number % around.branches.len()].along;
            number /= around.branches.len();
            let way = assembly.posing().go_beside(
                &mut kinematics,
                around,
                along,
                f64::from(places) * apart * around.group.size,
            )?;
            if dot(&way, along) < BENT * dot(&way, &way).sqrt() {
                return None;
            }
        }
        let model = assembly.model();
        let located = model.locate(&kinematics, &pose.base, contact).ok()?;
        let groups = assembly.decide(&kinematics);
        Some(model.least_energy(&kinematics, &groups, &located).minimum)
    };
    let mut best: Option<(f64, EffectiveMass)> = None;
    for apart in APART {
        let Some((doubt, limit)) = carried_on(&|places| at(places, apart)) else { continue };
        if best.is_none_or(|(least, _)| doubt < least) {
            best = Some((doubt, limit));
        }
        if doubt < AGREE {
            break;
        }
    }
    best.filter(|(doubt, _)| *doubt <= DOUBTFUL).map(|(_, limit)| limit)
}

/// For sorting.
fn value(limit: &EffectiveMass) -> f64 {
    match limit {
        EffectiveMass::Finite(m) => *m,
        EffectiveMass::Immovable => f64::INFINITY,
        EffectiveMass::Massless => 0.0,
    }
}

/// The limit from values at one to four places on either side, and how far two orders of the interpolation differ. A branch
/// is immovable or massless where it is at all of them.
fn carried_on(at: &dyn Fn(i32) -> Option<Minimum>) -> Option<(f64, EffectiveMass)> {
    const EIGHT: [f64; 4] = [4.0 / 5.0, -2.0 / 5.0, 4.0 / 35.0, -1.0 / 70.0];
    const SIX: [f64; 4] = [3.0 / 4.0, -3.0 / 10.0, 1.0 / 20.0, 0.0];
    let (mut mobility, mut coarse, mut most_mobile) = (0.0, 0.0, 0.0_f64);
    let (mut mass, mut coarse_mass, mut heaviest) = (0.0, 0.0, 0.0_f64);
    let mut state = None;
    for place in 0..4 {
        for side in [1, -1] {
            let here = at(side * (place as i32 + 1))?;
            let same = |known: &Minimum| std::mem::discriminant(known) == std::mem::discriminant(&here);
            if !same(state.get_or_insert(here)) {
                return None;
            }
            let Minimum::Finite(m) = here else { continue };
            mobility += EIGHT[place] / m;
            coarse += SIX[place] / m;
            mass += EIGHT[place] * m;
            coarse_mass += SIX[place] * m;
            most_mobile = most_mobile.max(1.0 / m);
            heaviest = heaviest.max(m);
        }
    }
    match state? {
        Minimum::Finite(_) => {}
        Minimum::Immovable => return Some((0.0, EffectiveMass::Immovable)),
        Minimum::Massless => return Some((0.0, EffectiveMass::Massless)),
        Minimum::Stationary(_) => return None,
    }
    let doubt = (mobility - coarse).abs() / most_mobile;
    Some(if mobility <= VANISHING * most_mobile {
        (doubt, EffectiveMass::Immovable)
    } else if mass <= VANISHING * heaviest {
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
            carried_on(&|place| Some(Minimum::Finite(2.0 + 0.01 * f64::from(place))))
        else {
            panic!("a limit")
        };
        assert!(doubt < AGREE && (m - 2.0).abs() < 1e-7, "{m} ± {doubt:e}");
    }

    #[test]
    fn a_state_is_one_of_all_places() {
        let all = carried_on(&|_| Some(Minimum::Immovable));
        assert_eq!(all, Some((0.0, EffectiveMass::Immovable)));
        for odd in [-4, -1, 1, 4] {
            let but_one = |place| Some(if place == odd { Minimum::Massless } else { Minimum::Finite(2.0) });
            assert_eq!(carried_on(&but_one), None, "{odd}");
            let but_one = |place| Some(if place == odd { Minimum::Finite(2.0) } else { Minimum::Immovable });
            assert_eq!(carried_on(&but_one), None, "{odd}");
        }
    }

    #[test]
    fn values_that_jump_have_no_limit() {
        let jumps = |place: i32| Some(Minimum::Finite(if place % 2 == 0 { 1.0 } else { 7.0 }));
        let (doubt, _) = carried_on(&jumps).expect("numbers");
        assert!(doubt > DOUBTFUL, "{doubt:e}");
    }
}

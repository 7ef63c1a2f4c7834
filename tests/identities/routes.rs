//! The routes to m̄ agree: the dense route, the recursion and the oracle's C (maximal coordinates), on every mechanism
//! of the zoo and on random mechanisms. Coverage of all relevant mechanisms is checked too.

use percuss_dynamics::{Base, ContactResponse, EffectiveMass, Route, RouteChoice, System};
use percuss_mechanism::JointKind;
use percuss_oracle::maximal::{Answer, Outcome, solve};
use percuss_oracle::{random, zoo};
use percuss_tests::cases::{self, Case};
use percuss_tests::gauge::Gauge;
use percuss_tests::imposed::{Imposed, VARIANTS};
use percuss_tests::judge::{NEAR, near_at, regular_condition};
use rand::{SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// Relative error of route C: its kernel of 6 · links rows is not scaled by masses.
const ORACLE: f64 = 1e-10;
/// Limit of the least over the largest singular value of A: closer to a singular pose, the rank is ambiguous.
const REGULAR: f64 = 1e-4;

/// Number of cases by class.
#[derive(Default, Debug)]
struct Tally {
    finite: usize,
    immovable: usize,
    massless: usize,
    singular_matrices: usize,
    mimics: usize,
    locks: usize,
    armatures: usize,
    floating: usize,
    against_a_link: usize,
}

/// Measurements of one run over many cases.
struct Routes {
    tally: Tally,
    a_b: Gauge,
    a_c: Gauge,
    b_c: Gauge,
    contributions: Gauge,
    sums: Gauge,
    stated: Gauge,
}

impl Routes {
    fn new() -> Self {
        Self {
            tally: Tally::default(),
            a_b: Gauge::new("dense route = recursion"),
            a_c: Gauge::new("dense route = route C"),
            b_c: Gauge::new("recursion = route C"),
            contributions: Gauge::new("contributions, route C"),
            sums: Gauge::new("sum of contributions"),
            stated: Gauge::new("dense route − recursion, in units of what both state"),
        }
    }

    fn run(mut self, cases: &[Case]) -> Tally {
        cases.iter().for_each(|case| self.compare(case));
        let Self { a_b, a_c, b_c, contributions, sums, stated, .. } = &self;
        [a_b, a_c, b_c, contributions, sums, stated].into_iter().for_each(Gauge::report);
        println!("{:?}", self.tally);
        self.tally
    }

    fn compare(&mut self, case: &Case) {
        let name = &case.name;
        let system = case.system();
        let pose = case.pose(&system);
        let by = |choice| {
            pose.respond_by_route(&case.contact(), choice)
                .unwrap_or_else(|error| panic!("{name}: {choice:?}: {error}"))
        };
        let a = by(RouteChoice::Only(Route::Dense));
        let b = by(RouteChoice::Only(Route::Articulated));
        let auto = by(RouteChoice::Auto);
        let c = solve(&case.question());
        assert_eq!((a.route, b.route), (Route::Dense, Route::Articulated), "{name}");
        for response in [&a, &b, &auto] {
            assert_eq!(response.degrees_of_freedom, c.degrees_of_freedom, "{name}: degrees of freedom");
        }
        let redundant = system.reference_or_open().redundant_constraints();
        assert_eq!(redundant, c.redundant_constraints, "{name}: redundant constraints");
        let near = near_at(&pose);
        for (response, by_route) in [(&a, 0), (&b, 1), (&auto, 1)] {
            self.with_the_oracle(name, response, &c, near + ORACLE, by_route == 0);
            self.sum(name, response, near);
        }
        self.with_each_other(name, &a, &b, near);
        self.count(case, &system, regular_condition(&pose).is_none());
        self.tally.finite += usize::from(matches!(c.outcome, Outcome::Finite(_)));
        self.tally.immovable += usize::from(c.outcome == Outcome::Immovable);
        self.tally.massless += usize::from(c.outcome == Outcome::Massless);
    }

    fn with_the_oracle(&mut self, name: &str, ours: &ContactResponse, c: &Answer, near: f64, is_dense: bool) {
        match (ours.effective_mass, c.outcome) {
            (EffectiveMass::Finite(m), Outcome::Finite(m_c)) => {
                let gauge = if is_dense { &mut self.a_c } else { &mut self.b_c };
                gauge.relative(name, m, m_c, near);
                let contributions = ours.contributions.as_ref().expect("finite");
                for (part, energy) in contributions.links.iter().zip(&c.links) {
                    self.contributions.note(name, (part - energy / m_c).abs(), near);
                }
                let mut rotors = vec![0.0; c.rotors.len()];
                contributions.rotors.iter().for_each(|(id, part)| rotors[id.index()] = *part);
                for (part, energy) in rotors.iter().zip(&c.rotors) {
                    self.contributions.note(name, (part - energy / m_c).abs(), near);
                }
            }
            (EffectiveMass::Immovable, Outcome::Immovable) | (EffectiveMass::Massless, Outcome::Massless) => {
            }
            (got, expected) => panic!("{name}: {got:?} by {:?}, {expected:?} by route C", ours.route),
        }
    }

    fn with_each_other(&mut self, name: &str, a: &ContactResponse, b: &ContactResponse, near: f64) {
        match (a.effective_mass, b.effective_mass) {
            (EffectiveMass::Finite(m_a), EffectiveMass::Finite(m_b)) => {
                self.a_b.relative(name, m_b, m_a, near);
                let stated = [a, b].map(|r| r.effective_mass_error().expect("a tree knows its error"));
                self.stated.note(name, (m_a - m_b).abs() / (stated[0] + stated[1]), 1.0);
                let (of_a, of_b) = (a.contributions.as_ref().unwrap(), b.contributions.as_ref().unwrap());
                for (x, y) in of_a.links.iter().zip(&of_b.links) {
                    self.contributions.note(name, (x - y).abs(), near);
                }
            }
            (one, other) => assert_eq!(one, other, "{name}"),
        }
    }

    /// Contributions are divided by the formula's m̄, so this check of the sum is not a tautology.
    fn sum(&mut self, name: &str, response: &ContactResponse, near: f64) {
        let Some(contributions) = &response.contributions else { return };
        let rotors = contributions.rotors.iter().map(|(_, part)| part);
        let sum: f64 = contributions.links.iter().chain(rotors).sum();
        self.sums.note(name, (sum - 1.0).abs(), near);
    }

    fn count(&mut self, case: &Case, system: &System, singular: bool) {
        self.tally.singular_matrices += usize::from(singular);
        self.tally.mimics += usize::from(case.has_moving_mimics(system));
        self.tally.locks += usize::from(!case.locks.is_empty());
        self.tally.armatures += usize::from(!case.armatures.is_empty());
        self.tally.floating += usize::from(case.base == Base::Floating);
        self.tally.against_a_link += usize::from(case.against.is_some());
    }
}

#[test]
fn the_routes_agree_on_the_zoo() {
    let tally = Routes::new().run(&cases::of_the_zoo(1, 12));
    let Tally { finite, immovable, massless, singular_matrices, mimics, .. } = tally;
    let Tally { locks, armatures, floating, against_a_link, .. } = tally;
    let counts =
        [finite, immovable, massless, singular_matrices, mimics, locks, armatures, floating, against_a_link];
    assert!(counts.iter().all(|&n| n > 0), "some class was never tried: {counts:?}");
}

/// One half of the random mechanisms; two tests use two cores.
fn the_routes_agree_at_random(half: usize) {
    let cases = cases::at_random(1000, 200, 60);
    let half: Vec<Case> =
        cases.into_iter().enumerate().filter(|(i, _)| i / 16 % 2 == half).map(|x| x.1).collect();
    let tally = Routes::new().run(&half);
    let Tally { finite, mimics, locks, armatures, floating, against_a_link, .. } = tally;
    let counts = [finite, mimics, locks, armatures, floating, against_a_link];
    assert!(counts.iter().all(|&n| n > 0), "some class was never tried: {counts:?}");
}

#[test]
fn the_routes_agree_on_random_mechanisms() {
    the_routes_agree_at_random(0);
}

#[test]
fn the_routes_agree_on_other_random_mechanisms() {
    the_routes_agree_at_random(1);
}

/// Held contacts constrain trees as loops do; with a lock, an armature or a floating base in some cases.
#[test]
fn the_routes_agree_where_contacts_are_held() {
    let mut masses = Gauge::new("held contacts: both routes and route C");
    let (mut finite, mut unclear) = (0, 0);
    let trees = zoo::all().into_iter().map(|(_, mechanism)| mechanism);
    let at_random =
        (0..60).map(|i| random::mechanism(&mut StdRng::seed_from_u64(9000 + i), 2 + i as usize % 12));
    for (i, mechanism) in trees.chain(at_random).enumerate() {
        let mechanism = Arc::new(mechanism);
        let mut rng = StdRng::seed_from_u64(9100 + i as u64);
        for variant in VARIANTS / 2..VARIANTS {
            let given = Imposed::at_random(&mut rng, &mechanism, variant);
            let system = System::new(Arc::clone(&mechanism), &given.conditions).expect("conditions that fit");
            let base = system.base();
            let name = format!("{} {i}, {}", mechanism.name(), given.name);
            let case = Case::plain(&mut rng, name, Arc::clone(&mechanism), base);
            let pose = case.pose(&system);
            let c = solve(&given.ask(case.question()));
            let counted = c.singular_values.iter().copied().filter(|s| *s > c.threshold);
            if !pose.rank().clear || counted.fold(1.0, f64::min) < REGULAR {
                unclear += 1;
                continue;
            }
            for route in [Route::Dense, Route::Articulated] {
                let response = pose.respond_by_route(&case.contact(), RouteChoice::Only(route));
                let response = response.unwrap_or_else(|error| panic!("{}: {error}", case.name));
                assert_eq!(response.degrees_of_freedom, c.degrees_of_freedom, "{}", case.name);
                match (response.effective_mass, c.outcome) {
                    (EffectiveMass::Finite(m), Outcome::Finite(expected)) => {
                        masses.relative(
                            &format!("{}, {route:?}", case.name),
                            m,
                            expected,
                            NEAR.max(near_at(&pose)),
                        );
                        finite += 1;
                    }
                    (EffectiveMass::Immovable, Outcome::Immovable)
                    | (EffectiveMass::Massless, Outcome::Massless) => {}
                    (got, expected) => panic!("{}: {got:?} by {route:?}, route C {expected:?}", case.name),
                }
            }
        }
    }
    masses.report();
    println!("{finite} finite, {unclear} unclear");
    assert!(finite > 300 && unclear < 100, "{finite} finite, {unclear} unclear");
}

#[test]
fn no_joint_kind_is_left_out() {
    let zoo = zoo::all();
    let cases = cases::at_random(1000, 200, 60);
    let random = cases.iter().map(|case| case.mechanism.as_ref());
    let everywhere = |kind| random.clone().any(|m| m.joints().iter().any(|j| j.kind() == kind));
    for kind in JointKind::ALL {
        assert!(zoo.iter().any(|(_, m)| m.joints().iter().any(|j| j.kind() == kind)), "{kind:?} in the zoo");
        assert!(everywhere(kind), "{kind:?} at random");
    }
    assert!(cases.iter().any(|case| case.mechanism.links().len() == 61), "no large mechanism");
}

#[test]
fn a_system_is_shared_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<percuss_dynamics::System>();
    shared::<percuss_mechanism::Mechanism>();
    shared::<percuss_dynamics::Pose>();
    shared::<percuss_dynamics::ContactResponse>();
}

//! The routes to m̄ agree: A (dense), B (recursion) and the oracle's C (maximal coordinates), on every mechanism of
//! the zoo and on random ones; and nothing that they should be tried on is left out.

use percuss_dynamics::{Base, EffectiveMass, Route, RouteChoice, RouteError, Strike, StrikeError};
use percuss_mechanism::JointKind;
use percuss_oracle::maximal::{Answer, Outcome, solve};
use percuss_oracle::zoo;
use percuss_tests::cases::{self, Case};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{hard, rounding};

/// Routes A and C: the oracle's kernel of 6 links rows is not scaled by masses, which costs it some digits.
const ORACLE: f64 = 1e-9;

/// How many cases of each class were tried.
#[derive(Default, Debug)]
struct Tally {
    finite: usize,
    immovable: usize,
    massless: usize,
    by_recursion: usize,
    mimics: usize,
    singular: usize,
    locks: usize,
    armatures: usize,
    floating: usize,
    against_a_link: usize,
}

/// What is measured in one run over many cases.
struct Routes {
    tally: Tally,
    a_b: Gauge,
    a_c: Gauge,
    shares: Gauge,
    sums: Gauge,
}

impl Routes {
    fn new() -> Self {
        Self {
            tally: Tally::default(),
            a_b: Gauge::new("A = B"),
            a_c: Gauge::new("A = C"),
            shares: Gauge::new("shares, A = C"),
            sums: Gauge::new("sum of shares"),
        }
    }

    fn run(mut self, cases: &[Case]) -> Tally {
        cases.iter().for_each(|case| self.compare(case));
        [&self.a_b, &self.a_c, &self.shares, &self.sums].into_iter().for_each(Gauge::report);
        println!("{:?}", self.tally);
        self.tally
    }

    fn compare(&mut self, case: &Case) {
        let name = &case.name;
        let system = case.system();
        let pose = case.pose(&system);
        let by = |route| system.strike(&pose, &case.contact(), RouteChoice::Only(route));
        let a = by(Route::Dense).unwrap_or_else(|error| panic!("{name}: {error}"));
        let c = solve(&case.question());
        assert_eq!(a.degrees_of_freedom, c.degrees_of_freedom, "{name}: degrees of freedom");
        assert_eq!(system.redundant_constraints(), c.redundant_constraints, "{name}: redundant constraints");
        self.with_the_oracle(name, &a, &c);
        match by(Route::Articulated) {
            Ok(b) => {
                assert!(!case.has_moving_mimics(&system), "{name}: the recursion took a mimic");
                self.with_the_recursion(name, &a, &b);
            }
            Err(StrikeError::Route(RouteError::Mimics)) => {
                assert!(case.has_moving_mimics(&system), "{name}: there is no mimic");
                self.tally.mimics += 1;
            }
            Err(StrikeError::Route(RouteError::SingularPivot { .. })) => {
                // It may decline where ε times the condition, and the number of terms, comes near the 1e-11 it
                // stands for; nowhere else.
                assert!(hard(&a), "{name}: declined at {:?}", a.condition);
                self.tally.singular += 1;
            }
            Err(error) => panic!("{name}: {error}"),
        }
        let auto = system.strike(&pose, &case.contact(), RouteChoice::Auto).expect("one of them holds");
        assert_eq!(kind(&auto), kind(&a), "{name}");
        self.count(case);
    }

    fn with_the_oracle(&mut self, name: &str, a: &Strike, c: &Answer) {
        match (a.effective_mass, c.outcome) {
            (EffectiveMass::Finite(m_a), Outcome::Finite(m_c)) => {
                self.tally.finite += 1;
                // Where the mass matrix leaves fewer digits than that, the strike says so.
                let said = a.effective_mass_error.expect("finite") / m_a;
                let bound = ORACLE.max(said);
                self.a_c.relative(name, m_a, m_c, bound);
                let shares = a.shares.as_ref().expect("finite");
                for (share, energy) in shares.links.iter().zip(&c.links) {
                    self.shares.note(name, (share - energy / m_c).abs(), bound);
                }
                let mut rotors = vec![0.0; c.rotors.len()];
                shares.rotors.iter().for_each(|(id, share)| rotors[id.index()] = *share);
                for (share, energy) in rotors.iter().zip(&c.rotors) {
                    self.shares.note(name, (share - energy / m_c).abs(), bound);
                }
                self.sum(name, a, a);
            }
            (EffectiveMass::Immovable, Outcome::Immovable) => self.tally.immovable += 1,
            (EffectiveMass::Massless, Outcome::Massless) => self.tally.massless += 1,
            (got, expected) => panic!("{name}: {got:?} by route A, {expected:?} by route C"),
        }
    }

    fn with_the_recursion(&mut self, name: &str, a: &Strike, b: &Strike) {
        self.tally.by_recursion += 1;
        assert_eq!((a.route, b.route), (Route::Dense, Route::Articulated), "{name}");
        assert_eq!(a.degrees_of_freedom, b.degrees_of_freedom, "{name}");
        match (a.effective_mass, b.effective_mass) {
            (EffectiveMass::Finite(m_a), EffectiveMass::Finite(m_b)) => {
                assert!(a.condition.is_some(), "{name}: the recursion took a singular mass matrix");
                let bound = rounding(a);
                self.a_b.relative(name, m_b, m_a, bound);
                self.sum(name, b, a);
                let (of_a, of_b) = (a.shares.as_ref().unwrap(), b.shares.as_ref().unwrap());
                for (x, y) in of_a.links.iter().zip(&of_b.links) {
                    self.a_b.note(name, (x - y).abs(), bound);
                }
            }
            (one, other) => assert_eq!(one, other, "{name}"),
        }
    }

    /// Shares are divided by the formula's m̄, so their sum is no tautology.
    fn sum(&mut self, name: &str, strike: &Strike, dense: &Strike) {
        let shares = strike.shares.as_ref().expect("finite");
        let sum: f64 = shares.links.iter().chain(shares.rotors.iter().map(|(_, share)| share)).sum();
        // A singular M has no condition; what is left of it when the massless motions are gone is a matter of the
        // oracle's tolerance.
        let bound = rounding(dense);
        self.sums.note(name, (sum - 1.0).abs(), bound);
    }

    fn count(&mut self, case: &Case) {
        self.tally.locks += usize::from(!case.locks.is_empty());
        self.tally.armatures += usize::from(!case.armatures.is_empty());
        self.tally.floating += usize::from(case.base == Base::Floating);
        self.tally.against_a_link += usize::from(case.against.is_some());
    }
}

fn kind(strike: &Strike) -> u8 {
    match strike.effective_mass {
        EffectiveMass::Finite(_) => 0,
        EffectiveMass::Immovable => 1,
        EffectiveMass::Massless => 2,
    }
}

#[test]
fn the_routes_agree_on_the_zoo() {
    let Tally {
        finite,
        immovable,
        massless,
        by_recursion,
        mimics,
        singular,
        locks,
        armatures,
        floating,
        against_a_link,
    } = Routes::new().run(&cases::of_the_zoo(1, 12));
    let counts = [
        finite,
        immovable,
        massless,
        by_recursion,
        mimics,
        singular,
        locks,
        armatures,
        floating,
        against_a_link,
    ];
    assert!(counts.iter().all(|&n| n > 0), "some class was never tried: {counts:?}");
}

/// Of one half of the random mechanisms; two tests use two cores.
fn the_routes_agree_at_random(half: usize) {
    let cases = cases::at_random(1000, 200, 60);
    let half: Vec<Case> =
        cases.into_iter().enumerate().filter(|(i, _)| i / 16 % 2 == half).map(|x| x.1).collect();
    let tally = Routes::new().run(&half);
    let Tally { finite, by_recursion, mimics, locks, armatures, floating, against_a_link, .. } = tally;
    let counts = [finite, by_recursion, mimics, locks, armatures, floating, against_a_link];
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
    shared::<percuss_dynamics::Strike>();
}

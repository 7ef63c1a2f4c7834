//! Rows, mobility and outcomes of closed loops.

use nalgebra::Vector3;
use percuss_mechanism::{ClosureKind, Mechanism};
use percuss_oracle::alter::{build_with_loops, describe, describe_loops, rebased, scaled, scaled_positions};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::maximal::{Held, Outcome, Question, effective_mass, poses, residual, solve};
use percuss_oracle::{random, zoo};
use percuss_spatial::{Transform, rotation_from_rpy};
use rand::{Rng, SeedableRng, rngs::StdRng};

fn question<'a>(mechanism: &'a Mechanism, positions: &[Vec<f64>], rng: &mut StdRng) -> Question<'a> {
    let (on, against, point, normal) = random::contact(rng, mechanism);
    Question { against, ..Question::new(mechanism, positions.to_vec(), on, point, normal) }
}

fn rows(mechanism: &Mechanism) -> usize {
    let closures: usize = mechanism.closures().iter().map(|c| c.kind().rows()).sum();
    closures + mechanism.couplings().len()
}

#[test]
fn every_kind_of_closure_is_in_the_zoo() {
    let all = linkage::all();
    for kind in ClosureKind::ALL {
        let has = |l: &Linkage| l.mechanism.closures().iter().any(|c| c.kind() == kind);
        assert!(all.iter().any(has), "{kind:?} is missing");
        assert!(has(&linkage::every_closure()), "{kind:?} is missing");
    }
    assert!(all.iter().any(|l| !l.mechanism.couplings().is_empty()));
    let onto_world = |l: &Linkage| l.mechanism.closures().iter().any(|c| c.predecessor().link.is_none());
    assert!(all.iter().any(onto_world));
    for (i, (name, mechanism)) in zoo::linkages().iter().enumerate() {
        assert_eq!(*name, mechanism.name());
        assert!(zoo::linkages()[..i].iter().all(|(other, _)| other != name), "{name} comes twice");
    }
}

/// Mobility on the ground and number of redundant rows of each linkage.
fn counted(name: &str) -> (usize, usize) {
    match name {
        "four_bar" | "slider_crank" | "parallelogram" | "antiparallelogram" | "massless_arm_suspension" => {
            (1, 3)
        }
        "six_bar" => (1, 6),
        "planar_leg" => (2, 3),
        "double_wishbone" => (2, 0),
        "two_point_wishbone" => (2, 2),
        "hooke_shaft" => (1, 3),
        "trammel" | "rack_and_pinion" | "geared_pair" => (1, 0),
        "trammel_with_rod" => (2, 0),
        "planetary_gear" => (1, 5),
        "rocker_bogie" => (9, 0),
        "cam_and_sum" => (3, 0),
        "every_closure" => (10, 0),
        "foot_on_the_world" => (2, 0),
        "ladder" => (1, 12),
        "separate" => (3, 9),
        _ => panic!("count the freedoms of {name}"),
    }
}

#[test]
fn freedoms_and_redundancy_over_the_whole_range() {
    let mut rng = StdRng::seed_from_u64(5);
    let mut least_gap = f64::INFINITY;
    for linkage in linkage::all() {
        let mechanism = &linkage.mechanism;
        let (degrees, redundant) = counted(linkage.name);
        let count = if mechanism.links().len() > 20 { 3 } else { 9 };
        for positions in linkage.sweep(count) {
            let open = residual(mechanism, &positions) / mechanism.characteristic_length();
            assert!(open <= 1e-13, "{}: {open:e}", linkage.name);
            let question = question(mechanism, &positions, &mut rng);
            let answer = solve(&question);
            assert_eq!(
                (answer.degrees_of_freedom, answer.redundant_constraints),
                (degrees, redundant),
                "{}: {:?}",
                linkage.name,
                answer.singular_values
            );
            // Singular values are far from the threshold on both sides.
            let rank = rows(mechanism) - redundant;
            least_gap = least_gap.min(answer.singular_values[rank - 1]);
            assert!(answer.singular_values[rank..].iter().all(|s| *s < 1e-13), "{}", linkage.name);
            // A floating base adds six degrees of freedom and no redundant row.
            let flying = solve(&Question { floating_base: true, ..question });
            assert_eq!(
                (flying.degrees_of_freedom, flying.redundant_constraints),
                (degrees + 6, redundant),
                "{} flying",
                linkage.name
            );
        }
        let spins = usize::from(linkage.name == "trammel_with_rod");
        assert_eq!(linkage.drivers.len() + spins, degrees, "{}", linkage.name);
    }
    println!("smallest singular value that counts: {least_gap:e}");
    assert!(least_gap > 1e-4, "{least_gap:e}");
}

#[test]
fn drivers_go_anywhere_in_their_ranges() {
    let mut rng = StdRng::seed_from_u64(7);
    for linkage in linkage::all() {
        let start = linkage.closed_start();
        for _ in 0..3 {
            let drivers: Vec<f64> = linkage.range.iter().map(|r| rng.random_range(r[0]..r[1])).collect();
            match linkage.move_drivers(&start, &drivers) {
                Ok(other_outcome) => assert_eq!(linkage.drivers_at(&other_outcome), drivers),
                Err(error) => panic!("{} at {drivers:?}: {error}", linkage.name),
            }
        }
    }
}

#[test]
fn units_and_the_position_of_the_world_do_not_matter() {
    let mut rng = StdRng::seed_from_u64(13);
    let mut worst = 0.0f64;
    let x_gr = Transform::new(rotation_from_rpy([0.4, -1.0, 2.2]), Vector3::new(3.0, -2.0, 1.0));
    for linkage in linkage::all() {
        let mechanism = &linkage.mechanism;
        let positions = linkage.closed_start();
        for floating_base in [false, true] {
            let question = Question { floating_base, ..question(mechanism, &positions, &mut rng) };
            let Some(expected) = effective_mass(&question).finite() else { continue };
            let large = scaled(mechanism, 10.0, 3.0);
            let other_outcome = effective_mass(&Question {
                mechanism: &large,
                positions: scaled_positions(mechanism, &positions, 10.0),
                point: question.point * 10.0,
                ..question.clone()
            });
            worst = worst.max((other_outcome.finite().unwrap() / expected / 3.0 - 1.0).abs());
            let moved = rebased(mechanism, x_gr);
            let mut longer = positions.clone();
            longer.push(Vec::new());
            let normal = x_gr.vector(&question.normal);
            let other_outcome =
                effective_mass(&Question { mechanism: &moved, positions: longer, normal, ..question });
            let error = (other_outcome.finite().unwrap() / expected - 1.0).abs();
            assert!(error < 1e-9, "{}: {error:e}", linkage.name);
            worst = worst.max(error);
        }
    }
    println!("worst {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn descriptions_rebuild_the_same_loops() {
    for linkage in linkage::all() {
        let mechanism = &linkage.mechanism;
        let (links, joints) = describe(mechanism);
        let (closures, couplings) = describe_loops(mechanism);
        let again = build_with_loops(linkage.name, links, joints, closures.clone(), couplings.clone());
        let (closures_again, couplings_again) = describe_loops(&again);
        assert_eq!(couplings, couplings_again);
        assert_eq!(closures.len(), closures_again.len());
        let positions = linkage.closed_start();
        assert!(residual(&again, &positions) <= 1e-13 * mechanism.characteristic_length());
    }
}

#[test]
fn locks_and_holds_reduce_the_mobility() {
    let linkage = linkage::four_bar();
    let positions = linkage.closed_start();
    let mechanism = &linkage.mechanism;
    let on = mechanism.find_link("coupler").unwrap();
    let n = linkage::plane().vector(&Vector3::new(0.6, 0.8, 0.0));
    let free = Question::new(mechanism, positions, on, Vector3::new(0.3, 0.1, 0.0), n);
    // No admissible motion out of the plane.
    let across = linkage::plane().vector(&Vector3::z());
    assert_eq!(effective_mass(&Question { normal: across, ..free.clone() }), Outcome::Immovable);
    // One locked joint leaves no motion; the row of a second lock is redundant.
    for joints in [1, 2, 3] {
        let locked = mechanism.joint_ids().take(joints).collect();
        let answer = solve(&Question { locked, ..free.clone() });
        assert_eq!(answer.outcome, Outcome::Immovable);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (0, 3 + joints - 1));
    }
    // A hold in three directions has one independent row and two redundant rows; a hold normal to the plane is redundant.
    let rocker = mechanism.find_link("rocker").unwrap();
    let held = |normal| vec![Held { link: rocker, point: Vector3::new(0.2, 0.0, 0.0), normal }];
    let answer = solve(&Question { held: held(None), ..free.clone() });
    assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (0, 5));
    assert_eq!(answer.outcome, Outcome::Immovable);
    let answer = solve(&Question { held: held(Some(across)), ..free.clone() });
    assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (1, 4));
    assert_eq!(answer.outcome.finite().map(f64::is_finite), Some(true));
    // In a tree: double pendulum with its tip held normal to the lower rod.
    let pendulum = zoo::double_pendulum();
    let tip = Held {
        link: pendulum.find_link("lower").unwrap(),
        point: Vector3::new(0.5, 0.0, 0.0),
        normal: Some(Vector3::y()),
    };
    let bent = vec![vec![0.0], vec![0.0]];
    let elbow = Question::new(&pendulum, bent, tip.link, Vector3::zeros(), Vector3::y());
    let answer = solve(&Question { held: vec![tip], ..elbow });
    // Stretched, with the tip at rest: θ̇₁ l₁ = v, θ̇₂ l₂ = −v; m₁/3 + m₂/3.
    assert!((answer.outcome.finite().unwrap() / (2.3 / 3.0) - 1.0).abs() < 1e-13);
    assert_eq!(answer.degrees_of_freedom, 1);
}

#[test]
fn contacts_that_move_massless_links_only_are_massless() {
    // The rod of a trammel rotates freely about its line; a contact along the line moves both sliders.
    let linkage = linkage::trammel_with_rod();
    let mechanism = &linkage.mechanism;
    let positions = linkage.closed_start();
    let rod = mechanism.find_link("rod").unwrap();
    let x = poses(mechanism, &positions)[rod.index()];
    let axis = |i| x.fixed_view::<3, 1>(0, i).into_owned();
    let off_line = Question::new(mechanism, positions.clone(), rod, Vector3::new(0.4, 0.1, 0.0), axis(2));
    assert_eq!(effective_mass(&off_line), Outcome::Massless);
    let on_line = Question { point: Vector3::new(0.4, 0.0, 0.0), ..off_line.clone() };
    assert_eq!(effective_mass(&on_line), Outcome::Immovable);
    let sideways = Question { normal: axis(1), ..on_line };
    assert!(effective_mass(&sideways).finite().unwrap() > 0.1);
    let locked = vec![mechanism.find_joint("first").unwrap()];
    assert_eq!(effective_mass(&Question { locked, ..sideways }), Outcome::Immovable);

    // A massless parallelogram.
    let light = linkage::massless_arm_suspension();
    let (mut links, joints) = describe(&light.mechanism);
    links.iter_mut().for_each(|link| link.inertial = None);
    let (closures, couplings) = describe_loops(&light.mechanism);
    let light_mechanism = build_with_loops("light", links, joints, closures, couplings);
    let on = light_mechanism.find_link("crank").unwrap();
    let n = linkage::plane().vector(&Vector3::new(0.6, 0.8, 0.0));
    let question = Question::new(&light_mechanism, light.closed_start(), on, Vector3::new(0.2, 0.0, 0.0), n);
    assert_eq!(effective_mass(&question), Outcome::Massless);

    // The rotation of the wheel on its upright has no influence, and neither has the massless strut of the suspension.
    let corner = linkage::two_point_wishbone();
    let piston = corner.mechanism.find_link("piston").unwrap();
    let question =
        Question::new(&corner.mechanism, corner.closed_start(), piston, Vector3::zeros(), Vector3::z());
    assert!(effective_mass(&question).finite().unwrap() > 0.0);
}

#[test]
fn constraints_never_lower_it_and_energies_sum() {
    let mut rng = StdRng::seed_from_u64(17);
    let mut compared = 0;
    for linkage in linkage::all() {
        let mechanism = &linkage.mechanism;
        let positions = linkage.closed_start();
        let closed = question(mechanism, &positions, &mut rng);
        let (links, joints) = describe(mechanism);
        let tree = build_with_loops("tree", links, joints, Vec::new(), Vec::new());
        let open = effective_mass(&Question { mechanism: &tree, ..closed.clone() });
        let answer = solve(&closed);
        let mass = |outcome| match outcome {
            Outcome::Finite(mass) => mass,
            Outcome::Immovable => f64::INFINITY,
            Outcome::Massless => 0.0,
        };
        assert!(mass(answer.outcome) >= mass(open) * (1.0 - 1e-11), "{}", linkage.name);
        if let Outcome::Finite(expected) = answer.outcome {
            let sum: f64 = answer.links.iter().chain(&answer.rotors).sum();
            assert!((sum / expected - 1.0).abs() < 1e-13, "{}", linkage.name);
            compared += 1;
        }
        let link = mechanism.links().len() - 1;
        let held = vec![Held {
            link: mechanism.link_ids().nth(link).unwrap(),
            point: Vector3::from_fn(|_, _| rng.random_range(-0.2..0.2)),
            normal: Some(Vector3::x()),
        }];
        let held = effective_mass(&Question { held, ..closed });
        assert!(mass(held) >= mass(answer.outcome) * (1.0 - 1e-10), "{}", linkage.name);
    }
    assert!(compared > 12, "{compared}");
}

#[test]
#[should_panic(expected = "open by")]
fn an_open_loop_is_no_question() {
    let linkage = linkage::four_bar();
    let zero = random::zero_positions(&linkage.mechanism);
    let on = linkage.mechanism.find_link("crank").unwrap();
    effective_mass(&Question::new(&linkage.mechanism, zero, on, Vector3::x(), Vector3::y()));
}

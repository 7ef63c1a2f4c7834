//! Properties: energy, momentum of every link, restitution, redundant copies, locked ≥ held ≥ free.

use crate::cases::all;
use nalgebra::{DVector, Vector3};
use percuss_dynamics::{
    Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, Pose, Remark, System,
};
use percuss_impact::{
    ImpactWorkspace, Reaction, RigidImpact, closing_speed, held_point_mass, reactions_to_unit_impulse,
    reflected_inertia,
};
use percuss_mechanism::JointKind;
use percuss_oracle::maximal::{Outcome, Question, effective_mass};
use std::sync::Arc;

/// Limit of balances relative to their terms: rounding 1e-16 times the condition of mass matrix and loops, up to 1e4 here.
const BALANCED: f64 = 1e-11;

/// Force and moment about the root's origin of a reaction, in root axes; `None` if a component is indeterminate.
fn wrench(reaction: &Reaction) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let values = |components: &[percuss_impact::Component; 3]| {
        let [a, b, c] = components.map(|component| component.value());
        Some(Vector3::new(a?, b?, c?))
    };
    let force = reaction.frame.rotation * values(&reaction.force)?;
    let moment = reaction.frame.rotation * values(&reaction.moment)?;
    Some((force, moment + reaction.frame.translation.cross(&force)))
}

#[test]
fn momentum_and_energy_are_balanced() {
    let (mut links, mut impacts) = (0, 0);
    for case in all(64) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(_) = response.effective_mass else { continue };
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let impact = RigidImpact::new(pose, &response, 0.7, 0.4, None).expect("an impact");
        // Rates far above the closing speed lose digits; such parts are light and far from the contact.
        let fast = impact.after.joints.iter().flatten().fold(1.0, |most: f64, v| most.max(v.abs()));
        // The restitution is reached.
        let after = closing_speed(pose, &response.contact, &impact.after);
        assert!((after + 0.4 * 0.7).abs() < BALANCED * fast, "{}: {after}", case.name);
        // Energy by the mass matrix at both motions.
        let mass = pose.mass_matrix();
        let energy = |rates: &percuss_impact::JointRates| {
            let u: Vec<f64> = pose
                .coordinate_joints()
                .into_iter()
                .map(|(joint, k)| match joint {
                    Some(joint) => rates.joint(joint)[k],
                    None if k < 3 => rates.base.angular[k],
                    None => rates.base.linear[k - 3],
                })
                .collect();
            let u = DVector::from_vec(u);
            0.5 * u.dot(&(&mass * &u))
        };
        let (start, end) = (energy(&impact.before), energy(&impact.after));
        let error = (start - end - impact.energy_loss).abs() / start;
        assert!(error < BALANCED * fast, "{}: {error:e}", case.name);
        impacts += 1;

        // Momentum of every link whose reactions are all determinate, about the root's origin.
        let mechanism = &case.mechanism;
        let mut twists: Vec<percuss_spatial::Twist<f64>> =
            vec![percuss_spatial::Twist::zero(); mechanism.links().len()];
        let base = impact.after.base - impact.before.base;
        for &link in mechanism.order() {
            twists[link.index()] = match mechanism.parent_joint(link) {
                None => base,
                Some(joint) => {
                    let parent = mechanism.joint(joint).parent();
                    let change = |k: usize| impact.after.joint(joint)[k] - impact.before.joint(joint)[k];
                    let columns = pose.motion_subspace(joint);
                    let frame = pose.link_in_root(link);
                    let own = columns.iter().enumerate().map(|(k, s)| frame.twist(&(*s * change(k))));
                    own.fold(twists[parent.index()], |sum, twist| sum + twist)
                }
            };
        }
        for link in mechanism.link_ids() {
            let mut force = Vector3::zeros();
            let mut moment = Vector3::zeros();
            let mut size = impact.impulse;
            let mut known = true;
            let mut add = |reaction: &Reaction, sign: f64| match wrench(reaction) {
                Some((f, m)) => {
                    force += f * sign;
                    moment += m * sign;
                    size = size.max(f.norm()).max(m.norm());
                }
                None => known = false,
            };
            for joint in &impact.reactions.joints {
                let declared = mechanism.joint(joint.joint);
                if declared.child() == link {
                    add(&joint.reaction, 1.0);
                }
                if declared.parent() == link {
                    add(&joint.reaction, -1.0);
                }
            }
            for (closure, reaction) in mechanism.closures().iter().zip(&impact.reactions.closures) {
                if closure.successor().link == Some(link) {
                    add(reaction, 1.0);
                }
                if closure.predecessor().link == Some(link) {
                    add(reaction, -1.0);
                }
            }
            for (held, reaction) in case.question().held.iter().zip(&impact.reactions.holds) {
                if held.link == link {
                    add(reaction, 1.0);
                }
            }
            if link == mechanism.root() {
                impact.reactions.ground.iter().for_each(|ground| add(ground, 1.0));
            }
            let frame = pose.link_in_root(link);
            let contact = &response.contact;
            let own = pose.link_in_root(contact.link);
            let (point, normal) = (own.point(&contact.point_link), own.vector(&contact.normal_link));
            for (side, sign) in [(Some(contact.link), -1.0), (contact.against, 1.0)] {
                if side == Some(link) {
                    force += normal * (sign * impact.impulse);
                    moment += point.cross(&normal) * (sign * impact.impulse);
                }
            }
            if !known {
                continue;
            }
            let local = mechanism.link(link).inertia().momentum(&frame.inverse_twist(&twists[link.index()]));
            let gained = frame.wrench(&local);
            let error = (gained.force - force).norm().max((gained.moment - moment).norm()) / size;
            assert!(error < BALANCED, "{}, {}: {error:e}", case.name, mechanism.link(link).name());
            links += 1;
        }
    }
    println!("{links} links, {impacts} impacts");
    assert!(links > 900 && impacts > 180, "{links} links, {impacts} impacts");
}

#[test]
fn nothing_reported_changes_along_the_kernel() {
    // Multipliers λ and λ + z with Aᵀz = 0 give the same reports: the combinations z are added to the constraint wrenches
    // of the report, and only indeterminate components may change.
    let mut changed = 0;
    for case in all(48) {
        let response = case.pose.respond(&case.contact).expect("a contact");
        if matches!(response.effective_mass, EffectiveMass::Massless) || !case.pose.rank().clear {
            continue;
        }
        let reactions = reactions_to_unit_impulse(&case.pose, &response).expect("reactions");
        for group in case.pose.constraint_groups() {
            let (m, n) = group.rows.shape();
            if group.rank == m || group.least_singular_value < 1e-4 {
                continue;
            }
            // Left null vectors by an eigenvalue decomposition of A Aᵀ (another method than that of the library).
            let scaled = nalgebra::DMatrix::from_fn(m, n, |r, c| group.rows[(r, c)] / group.lengths[c]);
            let eigen = (&scaled * scaled.transpose()).symmetric_eigen();
            let largest = eigen.eigenvalues.amax().max(1e-300);
            for k in (0..m).filter(|&k| eigen.eigenvalues[k].abs() < 1e-12 * largest) {
                let z = eigen.eigenvectors.column(k);
                for action in group.constraints.iter().filter(|a| !a.wrenches.is_empty()) {
                    let rows = action.first..action.first + action.count;
                    let change = rows.clone().zip(&action.wrenches).fold(
                        (Vector3::zeros(), Vector3::zeros()),
                        |(f, m): (Vector3<f64>, Vector3<f64>), (row, w)| {
                            (f + w.force * z[row], m + w.moment * z[row])
                        },
                    );
                    let reaction = match action.source {
                        percuss_dynamics::ConstraintSource::Closure(i) => &reactions.closures[i],
                        percuss_dynamics::ConstraintSource::Hold(i) => &reactions.holds[i],
                        percuss_dynamics::ConstraintSource::Coupling(_) => continue,
                    };
                    let axes = &reaction.frame.rotation;
                    for k in 0..3 {
                        for (component, by, unit) in
                            [(reaction.force[k], change.0, 1.0), (reaction.moment[k], change.1, group.size)]
                        {
                            let by = axes.column(k).dot(&by).abs() / unit;
                            // Eigenvectors of A Aᵀ are accurate to the square root of rounding over the gap.
                            if component.value().is_some() {
                                assert!(by < 1e-6, "{}: {} changes by {by:e}", case.name, action.name);
                            } else if by > 1e-6 {
                                changed += 1;
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(changed > 200, "only {changed} indeterminate components changed");
}

#[test]
fn held_inertias_are_larger_than_free_ones() {
    let (mut compared, mut larger, mut points) = (0, 0, 0);
    for case in all(48) {
        let pose = &case.pose;
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let hinges = case.mechanism.joint_ids().filter(|id| {
            let kind = case.mechanism.joint(*id).kind();
            matches!(kind, JointKind::Revolute | JointKind::Continuous) && !pose.is_locked(*id)
        });
        for joint in hinges {
            let Ok(found) = reflected_inertia(pose, joint, 0) else { continue };
            let EffectiveMass::Finite(free) = found.free else { continue };
            // A hinge turns one link against another: a contact of both at 1 m from the axis, across the arm, meets the
            // inertia of the hinge. By the oracle.
            let declared = case.mechanism.joint(joint);
            let (e1, e2) = percuss_spatial::plane_basis(declared.axis());
            let contact = Contact {
                link: declared.child(),
                against: Some(declared.parent()),
                point: e1,
                normal: Direction::Along(e2, Frame::Link),
            };
            let located = pose.locate(&contact).expect("a contact");
            let question = Question {
                on: located.link,
                against: located.against,
                point: located.point_link,
                normal: located.normal_world,
                ..case.question()
            };
            if let Outcome::Finite(expected) = effective_mass(&question) {
                assert!((free / expected - 1.0).abs() < 1e-9, "{}: {free} {expected}", case.name);
                compared += 1;
            }
            if let Some(EffectiveMass::Finite(held)) = found.held {
                assert!(held >= free * (1.0 - 1e-9), "{}: {held} < {free}", case.name);
                larger += usize::from(held > 1.01 * free);
            }
        }
        let response = pose.respond(&case.contact).expect("a contact");
        if let (EffectiveMass::Finite(sliding), Ok(EffectiveMass::Finite(sticking))) =
            (response.effective_mass, held_point_mass(pose, &response.contact))
        {
            assert!(sticking >= sliding * (1.0 - 1e-9), "{}: {sticking} < {sliding}", case.name);
            points += 1;
        }
    }
    println!("{compared} hinges, {larger} larger, {points} points");
    assert!(compared > 150 && larger > 50 && points > 20, "{compared} {larger} {points}");
}

#[test]
fn undetermined_rates_are_named() {
    let mut named = 0;
    for case in all(24) {
        let response = case.pose.respond(&case.contact).expect("a contact");
        let Ok(impact) = RigidImpact::new(&case.pose, &response, 1.0, 0.0, None) else { continue };
        let is_open = response.remarks.contains(&Remark::UndeterminedMotion);
        assert!(is_open || impact.undetermined.is_empty(), "{}", case.name);
        named += usize::from(!impact.undetermined.is_empty());
    }
    println!("{named} with undetermined rates");
}

/// A workspace has the results of single impacts, at every pose of every system.
#[test]
fn workspaces_agree_with_single_impacts() {
    let (mut count, mut reused) = (0, RigidImpact::none());
    for case in all(48) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let single = RigidImpact::new(pose, &response, 0.7, 0.4, None);
        let workspace = ImpactWorkspace::new(pose).at(pose).impact(&case.contact, 0.7, 0.4);
        let (single, workspace) = match (single, workspace) {
            (Ok(single), Ok(workspace)) => (single, workspace),
            (Err(a), Err(b)) => {
                assert_eq!(a, b, "{}", case.name);
                continue;
            }
            (a, b) => panic!("{}: {a:?} {b:?}", case.name),
        };
        // Memory of an impact on another mechanism has no effect on the result.
        let mut again = ImpactWorkspace::new(pose);
        again.at(pose).impact_into(&case.contact, 0.7, 0.4, &mut reused).expect("an impact");
        assert_eq!(format!("{reused:?}"), format!("{workspace:?}"), "{}", case.name);
        // The stated error of m̄, kg, bounds the difference of two routes.
        let mass = response.effective_mass.kilograms().expect("a mass");
        let error =
            response.error.and_then(|error| error.known()).map_or(0.0, |error| error / mass).max(BALANCED);
        assert!((workspace.impulse / single.impulse - 1.0).abs() < error, "{}", case.name);
        assert!((workspace.energy_loss / single.energy_loss - 1.0).abs() < error, "{}", case.name);
        let fast = single.after.joints.iter().flatten().fold(1.0, |most: f64, v| most.max(v.abs()));
        for (a, b) in single.after.joints.iter().flatten().zip(workspace.after.joints.iter().flatten()) {
            assert!((a - b).abs() < 1e-9 * fast, "{}: {a} {b}", case.name);
        }
        let size = case.mechanism.characteristic_length().max(1.0);
        for (a, b) in single.reactions.joints.iter().zip(&workspace.reactions.joints) {
            let pairs = a.reaction.force.iter().zip(&b.reaction.force);
            for (a, b) in pairs.chain(a.reaction.moment.iter().zip(&b.reaction.moment)) {
                match (a.value(), b.value()) {
                    (Some(a), Some(b)) => {
                        let scale = single.impulse * size * fast;
                        assert!((a - b).abs() < 1e-9 * scale, "{}: {a} {b}", case.name);
                    }
                    (a, b) => assert_eq!(a, b, "{}", case.name),
                }
            }
        }
        count += 1;
    }
    assert!(count > 150, "{count}");
}

/// A rotor on a joint, and a lock of the joint, cannot make a contact lighter: locked ≥ with a rotor ≥ free, with random linkages and
/// trees.
#[test]
fn locks_and_rotors_make_contacts_heavier() {
    let (mut compared, mut heavier) = (0, 0);
    for case in all(160) {
        let mechanism = &case.mechanism;
        let movable = |id: &percuss_mechanism::JointId| {
            let joint = mechanism.joint(*id);
            joint.kind().dofs() == 1 && joint.mimic().is_none()
        };
        let Some(joint) = mechanism.joint_ids().find(movable) else { continue };
        let name = mechanism.joint(joint).name();
        let mass = |conditions: Conditions| {
            let system = System::new(Arc::clone(mechanism), &conditions).ok()?;
            let positions: Vec<f64> = case.pose.positions().to_vec();
            let configuration = Configuration::from_positions(mechanism, &positions).ok()?;
            let pose = system.pose(&configuration).ok()?;
            let is_clear =
                pose.rank().clear && pose.constraint_groups().iter().all(|g| g.least_singular_value > 1e-4);
            let response = pose.respond(&case.contact).ok().filter(|_| is_clear)?;
            match response.effective_mass {
                EffectiveMass::Finite(mass) => Some(mass),
                EffectiveMass::Immovable => Some(f64::INFINITY),
                EffectiveMass::Massless => Some(0.0),
            }
        };
        let own = mechanism.joint(joint).armature().first().copied().unwrap_or(0.0);
        let (Some(free), Some(rotor), Some(locked)) = (
            mass(Conditions::new()),
            mass(Conditions::new().armature(name, [own + 0.3])),
            mass(Conditions::new().lock(name)),
        ) else {
            continue;
        };
        assert!(rotor >= free * (1.0 - 1e-9), "{}: {rotor} {free}", case.name);
        assert!(locked >= rotor * (1.0 - 1e-9), "{}: {locked} {rotor}", case.name);
        compared += 1;
        heavier += usize::from(locked > 1.01 * rotor && rotor > 1.001 * free);
    }
    println!("{compared} compared, {heavier} heavier");
    assert!(compared > 300 && heavier > 60, "{compared} {heavier}");
}

/// A pose that moves in place and back has its first results, and a refused move changes nothing.
#[test]
fn poses_move_in_place() {
    let mut compared = 0;
    for case in all(24) {
        let mass = |pose: &Pose| pose.respond(&case.contact).expect("a contact").effective_mass;
        let (start, base) = (case.pose.positions().to_vec(), *case.pose.base());
        let other: Vec<f64> = start.iter().map(|q| q + 0.1).collect();
        let mut moved = case.pose.clone();
        moved.move_to(&other, base).expect("positions");
        let there = case.pose.at_positions(&other, base).expect("positions");
        assert_eq!(moved.positions(), there.positions(), "{}", case.name);
        assert!(moved.move_to(&other[1..], base).is_err() || other.is_empty(), "{}", case.name);
        assert_eq!(moved.positions(), there.positions(), "{}", case.name);
        moved.move_to(&start, base).expect("positions");
        assert_eq!(moved.rank().rank, case.pose.rank().rank, "{}", case.name);
        if let (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) = (mass(&case.pose), mass(&moved)) {
            // Both are within their stated errors; a quaternion is normalised again.
            assert!((a / b - 1.0).abs() < 1e-9, "{}: {a} {b}", case.name);
            compared += 1;
        }
    }
    assert!(compared > 50, "{compared}");
}

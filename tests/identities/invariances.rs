//! Invariance of m̄ under changes of the normal's sign, the order of the sides, the world frame, units, frames, merged
//! links.

use nalgebra::Vector3;
use percuss_dynamics::Route;
use percuss_dynamics::{
    Base, Conditions, Contact, ContactResponse, Direction, EffectiveMass, Frame, Pose, RouteChoice, System,
};
use percuss_formats::{LoadOptions, Source, load};
use percuss_oracle::alter;
use percuss_spatial::{Transform, rotation_from_rpy};
use percuss_tests::cases::{self, Case};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{near_at, regular_condition, states_enough};
use percuss_tests::motion::Motion;
use std::sync::Arc;

const FAR: f64 = 1e4;
/// Error of a floating base far from its bodies: ε times the coordinates per unit condition of M about the base, and
/// its upper limit.
const FAR_BASE: (f64, f64) = (1e-14, 1e-2);

/// All cases: models of the zoo and random models.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(5, 2), cases::at_random(5000, 120, 40)].concat()
}

fn respond(pose: &Pose, contact: &Contact, route: Route) -> ContactResponse {
    pose.respond_by_route(contact, RouteChoice::Only(route)).expect("an answer")
}

/// Records the relative deviation of two finite results; other outcomes must be equal.
fn same(gauge: &mut Gauge, name: &str, got: &ContactResponse, expected: &ContactResponse, bound: f64) {
    match (got.effective_mass, expected.effective_mass) {
        (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => gauge.relative(name, a, b, bound),
        (a, b) => assert_eq!(a, b, "{name}"),
    }
}

/// The contact with its normal in the contact link's axes, so that the normal moves with the link.
fn in_link(case: &Case, pose: &Pose) -> Contact {
    let located = pose.locate(&case.contact()).expect("a contact");
    case.contact().normal(Direction::Along(located.normal_link, Frame::Link))
}

/// A line of a micrometre between links of a metre: its ends have the rounding error of their positions, and its
/// direction has this error divided by its length. Copies of the chain at other positions, all with exact numbers,
/// round differently.
#[test]
fn short_lines_state_the_error_of_their_ends() {
    let model = |x: f64| {
        let link = |name: &str, com: f64| {
            format!(
                "<link name='{name}'><inertial><origin xyz='{com} 0.125 0'/><mass value='2'/>\
                 <inertia ixx='.25' iyy='.25' izz='.25' ixy='0' ixz='0' iyz='0'/></inertial></link>"
            )
        };
        let hinge = |name: &str, on: &str, child: &str, at: f64, y: f64| {
            format!(
                "<joint name='{name}' type='continuous'><parent link='{on}'/><child link='{child}'/>\
                 <origin xyz='{at} {y} 0'/><axis xyz='0 0 1'/></joint>"
            )
        };
        let urdf = [
            "<robot name='lines'><link name='ground'/>".to_owned(),
            link("a", 0.25) + &link("b", 0.5) + &link("c", 0.375),
            hinge("first", "ground", "a", x, 0.5) + &hinge("second", "a", "b", 0.75, 0.0),
            hinge("third", "ground", "c", x + 1.5, -0.25) + "</robot>",
        ];
        let source = Source::from_text("lines", urdf.concat());
        let mechanism = load(&source, &LoadOptions::default()).expect("a model").mechanism;
        let system = System::new(mechanism, &Conditions::new()).expect("conditions that fit");
        let mut there = system.configuration();
        for (joint, angle) in [("first", 0.7), ("second", -0.4), ("third", 1.1)] {
            there.set(joint, &[angle]).expect("a joint");
        }
        system.pose(&there).expect("a tree poses")
    };
    let home = model(0.0);
    let named = |name: &str| home.mechanism().find_link(name).expect("a link");
    let (contact_link, end) = (named("b"), named("c"));
    let point = Vector3::new(0.5, 0.125, 0.0);
    let (mut apart, mut most) = (0.0_f64, 0.0_f64);
    // Lines shorter than a tenth of their length as drawn are refused.
    for length in [0.2, 0.5, 1.0, 2.0] {
        for turn in 0..8 {
            let (sin, cos) = (0.4 + f64::from(turn)).sin_cos();
            let point_of_line = home.link(contact_link).point(&point) + Vector3::new(cos, sin, 0.0) * length;
            let at = home.link(end).inverse_point(&point_of_line);
            let contact =
                Contact::new(contact_link, point, Vector3::x()).normal(Direction::TurningToward(end, at));
            let answer = |x: f64| {
                let response = model(x).respond(&contact).expect("an answer");
                let EffectiveMass::Finite(m) = response.effective_mass else { panic!("{response:?}") };
                (m, response.effective_mass_error().expect("known"))
            };
            let (m, stated) = answer(0.0);
            for x in [0.5, -1.25, 3.0, 7.75] {
                let (other, also) = answer(x);
                let off = (other - m).abs();
                assert!(
                    off <= stated + also,
                    "{length:e} m, {turn}, {x}: {m} ± {stated:e}, {other} ± {also:e}"
                );
                (apart, most) = (apart.max(off / m), most.max(stated * length / m));
            }
        }
    }
    println!("apart by {apart:.1e}; stated at most {most:.1e} over the length");
    assert!(apart > 1e-14 && most < 1e-11, "{apart:e}, {most:e}");
}

#[test]
fn the_sign_of_the_normal() {
    let mut gauge = Gauge::new("n̂ → −n̂");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        for route in [Route::Dense, Route::Articulated] {
            let one = respond(&pose, &case.contact(), route);
            let back = case.contact().normal(Direction::Along(-case.normal, Frame::World));
            let other = respond(&pose, &back, route);
            // Bitwise equal for the recursion; the reflections of the least squares have the opposite sign.
            let bound = if route == Route::Articulated { f64::EPSILON } else { near_at(&pose) };
            same(&mut gauge, &case.name, &other, &one, bound);
        }
    }
    gauge.report();
}

#[test]
fn the_order_of_the_two_sides() {
    let mut gauge = Gauge::new("sides swapped");
    for case in all_cases() {
        let Some(other) = case.against else { continue };
        let system = case.system();
        let pose = case.pose(&system);
        let point = pose.link(other).inverse_point(&pose.link(case.on).point(&case.point));
        let swapped = Case { on: other, against: Some(case.on), point, normal: -case.normal, ..case.clone() };
        for route in [Route::Dense, Route::Articulated] {
            let one = respond(&pose, &case.contact(), route);
            let back = respond(&pose, &swapped.contact(), route);
            // The point passes through the other link's frame: an error of ε times the extent, rotated by the response.
            let turned = 8.0 * f64::EPSILON * reach(&case) * Motion::of(&one).size();
            same(&mut gauge, &case.name, &back, &one, near_at(&pose) + turned);
        }
    }
    gauge.report();
}

/// Upper bound of the extent: all links in a line, and the contact point, m.
fn reach(case: &Case) -> f64 {
    let links: f64 = case.mechanism.links().iter().map(percuss_mechanism::Link::extent).sum();
    links + case.point.norm()
}

#[test]
fn a_base_far_away() {
    let x_wr = Transform::new(rotation_from_rpy([0.7, -0.4, 2.1]), Vector3::new(0.6, -0.64, 0.48) * FAR);
    let mut gauge = Gauge::new("point given 10 km away");
    for case in all_cases() {
        let system = case.system();
        let here = case.pose(&system);
        let there = system.pose(case.configuration(&system).set_base(x_wr)).expect("a tree poses");
        let contact = in_link(&case, &here);
        let point_world = there.link(case.on).point(&case.point);
        let point = there.point_in_link(case.on, case.against, Frame::World, point_world);
        let normal_world = x_wr.vector(&case.normal);
        let far = Contact { point, ..case.contact() }.normal(Direction::Along(normal_world, Frame::World));
        for route in [Route::Dense, Route::Articulated] {
            let one = respond(&here, &contact, route);
            // With the normal in the link, the result is bitwise equal: all computations are in the root link's frame.
            let same_bits = respond(&there, &contact, route);
            assert_eq!(one.effective_mass, same_bits.effective_mass, "{}", case.name);
            // With the normal in the world, the point has an error of a few ε of 10 km; dm̄/m̄ = 2 |ω*| times this
            // error, with ω* the angular velocity of the response at unit closing speed.
            let blurred = respond(&there, &far, route);
            let turn = 2.0 * Motion::of(&one).size() * 4.0 * f64::EPSILON * (FAR + reach(&case));
            same(&mut gauge, &case.name, &blurred, &one, near_at(&here) + turn);
        }
    }
    gauge.report();
}

#[test]
fn a_root_far_away() {
    let x_gr = Transform::new(rotation_from_rpy([-0.3, 1.1, 0.5]), Vector3::new(0.48, 0.6, -0.64) * FAR);
    let mut held = Gauge::new("root frame 10 km away, fixed");
    let mut floating = Gauge::new("root frame 10 km away, floating");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let mut far = case.clone();
        far.mechanism = Arc::new(alter::rebased(&case.mechanism, x_gr));
        far.positions.push(Vec::new());
        far.normal = x_gr.vector(&case.normal);
        let far_system = far.system();
        let far_pose = far.pose(&far_system);
        for route in [Route::Dense, Route::Articulated] {
            let one = respond(&pose, &case.contact(), route);
            let other = respond(&far_pose, &far.contact(), route);
            let (EffectiveMass::Finite(m), EffectiveMass::Finite(n)) =
                (one.effective_mass, other.effective_mass)
            else {
                if case.base == Base::Fixed {
                    assert_eq!(one.effective_mass, other.effective_mass, "{}", case.name);
                }
                continue;
            };
            // Every frame has an error e of a few ε of 10 km: j changes by |ω*| e, link speeds by |ω*| e, and dm̄/m̄ ≤
            // 2 |ω*| e (1 + √(mass/m̄)).
            let e = 4.0 * f64::EPSILON * FAR;
            let mass = case.mechanism.total_mass();
            let blur = 2.0 * Motion::of(&one).size() * e * (1.0 + (mass / m).sqrt()) + near_at(&pose);
            match case.base {
                Base::Fixed => held.relative(&case.name, n, m, blur),
                Base::Floating => {
                    // M about a point 10 km away has entries of mass · FAR², with relative error ε.
                    let (each, most) = FAR_BASE;
                    let far =
                        regular_condition(&far_pose).map_or(most, |condition| most.min(each * condition));
                    let name = format!("{}, {route:?}", case.name);
                    floating.relative(&name, n, m, blur + near_at(&pose) + far);
                    assert!(states_enough(&other, m, blur), "{name}: {n} kg, {m} kg");
                }
            }
        }
    }
    held.report();
    floating.report();
}

#[test]
fn the_units() {
    let mut gauge = Gauge::new("millimetres and grams");
    // m̄ in grams is a thousand times m̄ in kilograms; m̄ does not depend on the unit of length.
    for (length, mass) in [(1e3, 1.0), (1.0, 1e3), (0.0254, 0.4536)] {
        for case in all_cases().into_iter().filter(|case| case.armatures.is_empty()) {
            let mut other = case.clone();
            other.mechanism = Arc::new(alter::scaled(&case.mechanism, length, mass));
            other.positions = alter::scaled_positions(&case.mechanism, &case.positions, length);
            other.point *= length;
            let (system, other_system) = (case.system(), other.system());
            let (pose, other_pose) = (case.pose(&system), other.pose(&other_system));
            for route in [Route::Dense, Route::Articulated] {
                let one = respond(&pose, &case.contact(), route);
                let mut two = respond(&other_pose, &other.contact(), route);
                if let EffectiveMass::Finite(m) = &mut two.effective_mass {
                    *m /= mass;
                }
                // The point and the frames are rounded again.
                let blur = 8.0 * f64::EPSILON * reach(&case) * Motion::of(&one).size();
                same(&mut gauge, &case.name, &two, &one, near_at(&pose) + blur);
            }
        }
    }
    gauge.report();
}

#[test]
fn links_held_together_are_one_or_many_bodies() {
    let mut gauge = Gauge::new("merged = unmerged");
    let mut fixed = 0;
    for case in all_cases() {
        let system = case.system();
        let apart = System::new(Arc::clone(&case.mechanism), &case.conditions().keep_fixed_joints()).unwrap();
        let (pose, apart_pose) = (case.pose(&system), case.pose(&apart));
        fixed += case.mechanism.joints().iter().filter(|j| j.kind().dofs() == 0).count();
        for route in [Route::Dense, Route::Articulated] {
            let one = respond(&pose, &case.contact(), route);
            let two = respond(&apart_pose, &case.contact(), route);
            same(&mut gauge, &case.name, &two, &one, near_at(&pose));
            assert_eq!(one.degrees_of_freedom, two.degrees_of_freedom, "{}", case.name);
            if let (Some(one), Some(two)) = (&one.contributions, &two.contributions) {
                for (a, b) in one.links.iter().zip(&two.links) {
                    gauge.note(&case.name, (a - b).abs(), near_at(&pose));
                }
            }
        }
    }
    gauge.report();
    assert!(fixed > 0, "no fixed joint came");
}

#[test]
fn the_frame_a_contact_is_given_in() {
    let x_wr = Transform::new(rotation_from_rpy([0.2, 0.9, -1.3]), Vector3::new(1.0, -2.0, 0.5));
    let mut gauge = Gauge::new("frames of a contact");
    let mut points = Gauge::new("frames of a point");
    for case in all_cases() {
        let system = case.system();
        let pose = system.pose(case.configuration(&system).set_base(x_wr)).expect("a tree poses");
        let contact = in_link(&case, &case.pose(&system));
        let located = pose.locate(&contact).expect("a contact");
        let one = pose.respond(&contact).expect("an answer");
        let x_wa = case.against.map_or_else(Transform::identity, |link| pose.link(link));
        let in_against =
            (x_wa.inverse_point(&located.point_world), x_wa.inverse_vector(&located.normal_world));
        let notations = [
            (Frame::Link, located.point_link, located.normal_link),
            (Frame::World, located.point_world, located.normal_world),
            (Frame::Against, in_against.0, in_against.1),
        ];
        let blur = 16.0 * f64::EPSILON * (3.0 + reach(&case));
        let bound = near_at(&pose) + 2.0 * blur * (1.0 + Motion::of(&one).size());
        for (frame, point, normal) in notations {
            let point = pose.point_in_link(case.on, case.against, frame, point);
            points.note(&case.name, (point - case.point).norm(), blur);
            let again = Contact { point, ..contact }.normal(Direction::Along(normal * 3.0, frame));
            let two = pose.respond(&again).expect("an answer");
            same(&mut gauge, &case.name, &two, &one, bound);
        }
        // Along a line to a point of the root link, two metres away.
        let target = pose.base().inverse_point(&(located.point_world + located.normal_world * 2.0));
        let toward = contact.normal(Direction::TurningToward(case.mechanism.root(), target));
        let two = pose.respond(&toward).expect("an answer");
        same(&mut gauge, &case.name, &two, &one, bound);
    }
    gauge.report();
    points.report();
}

#[test]
fn conditions_are_those_of_the_analysis_only() {
    // Analysis under other conditions leaves no state in the mechanism.
    for case in all_cases().into_iter().step_by(7) {
        let before = case.response().effective_mass;
        let _ = System::new(Arc::clone(&case.mechanism), &Conditions::new().base(Base::Floating)).unwrap();
        assert_eq!(case.response().effective_mass, before, "{}", case.name);
    }
}

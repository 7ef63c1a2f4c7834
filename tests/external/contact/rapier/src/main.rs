//! Impacts in Rapier: one JSON request on the standard input, `[[rebound over speed, penetration], …]` on the output.
//!
//! `{"restitution": e, "dt": s, "speed": v, "gaps": […], "mass": m, "radius": r, "inertia": about the centre,
//!   "centre": x, "lever": l, "rotor": I, "joint": null | "multibody" | "impulse", "damping": of the multibody,
//!   "other": null | {"mass", "radius", "speed"} of a free ball instead of the wall; `speed` is its part of v}`
//!
//! Or a chain in the x-y plane above a wall with the normal +y, as multibody joints; the sphere belongs to the last body:
//! `{"restitution", "dt", "speed", "gaps", "radius", "damping", "point": [x, y], "chain": [{"mass", "inertia", "centre": [x, y],
//!   "hinge": [x, y], "rate": rad/s, relative to the body before}, …]}`
//!
//! `centre` and `lever` are 0 where nothing holds the body; else they are on x, from a hinge along −y. With "multibody" the
//! rotor is an armature, else it is added to the inertia.

use rapier3d_f64::prelude::*;
use serde_json::{Value, json};

/// Largest number of steps of an impact.
const LONGEST: usize = 100_000;

fn main() {
    let request: Value = serde_json::from_reader(std::io::stdin()).expect("JSON");
    let gaps = request["gaps"].as_array().expect("gaps");
    let run = if request["chain"].is_array() { impact_of_chain } else { impact };
    let shown: Vec<[f64; 2]> = gaps.iter().map(|gap| run(&request, gap.as_f64().expect("a gap"))).collect();
    println!("{}", json!(shown));
}

/// The rebound is that of the step of the impact: the speed of a chain changes as it moves on.
fn impact_of_chain(request: &Value, gap: f64) -> [f64; 2] {
    let number = |name: &str| request[name].as_f64().unwrap_or_else(|| panic!("{name}"));
    let pair = |of: &Value| Vector::new(of[0].as_f64().expect("x"), of[1].as_f64().expect("y"), 0.0);
    let (radius, speed, point) = (number("radius"), number("speed"), pair(&request["point"]));
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = number("dt");
    let surface = |collider: ColliderBuilder| {
        collider
            .density(0.0)
            .friction(0.0)
            .restitution(number("restitution"))
            .restitution_combine_rule(CoefficientCombineRule::Average)
    };
    let below = Vector::new(point.x, point.y - radius - gap - 1.0, 0.0);
    world.insert(RigidBodyBuilder::fixed().translation(below), surface(ColliderBuilder::cuboid(9.0, 1.0, 9.0)));
    let (mut before, mut origin) = (world.insert_body(RigidBodyBuilder::fixed()), Vector::ZERO);
    let (mut rates, mut last) = (Vec::new(), None);
    for body in request["chain"].as_array().expect("a chain") {
        let (mass, inertia) = (body["mass"].as_f64().expect("a mass"), body["inertia"].as_f64().expect("an inertia"));
        let hinge = pair(&body["hinge"]);
        let properties = MassProperties::new(pair(&body["centre"]) - hinge, mass, Vector::new(inertia, inertia, inertia));
        let made = world.insert_body(
            RigidBodyBuilder::dynamic().translation(hinge).additional_mass_properties(properties).can_sleep(false),
        );
        let joint = RevoluteJointBuilder::new(Vector::Z).local_anchor1(hinge - origin).local_anchor2(Vector::ZERO);
        last = world.insert_multibody_joint(before, made, joint);
        rates.push(body["rate"].as_f64().expect("a rate"));
        (before, origin) = (made, hinge);
    }
    world.insert_collider(surface(ColliderBuilder::ball(radius).translation(point - origin)), Some(before));
    // In the first step the engine detects that the ground does not move.
    world.step();
    let (multibody, _) = world.multibody_joints.get_mut(last.expect("a tree")).expect("just made");
    multibody.generalized_velocity_mut().copy_from_slice(&rates);
    multibody.damping_mut().fill(number("damping"));
    let (mut depth, mut rebound): (f64, f64) = (0.0, -speed);
    for _ in 0..LONGEST {
        world.step();
        let body = &world.bodies[before];
        let at = body.position().transform_point(point - origin);
        depth = depth.max(point.y - gap - at.y);
        rebound = body.velocity_at_point(at).y;
        // The step before that of the restitution can end with a speed of about 0.
        if rebound > 0.5 * number("restitution") * speed {
            break;
        }
    }
    [rebound / speed, depth]
}

fn impact(request: &Value, gap: f64) -> [f64; 2] {
    let number = |name: &str| request[name].as_f64().unwrap_or_else(|| panic!("{name}"));
    let (lever, radius, speed, dt) = (number("lever"), number("radius"), number("speed"), number("dt"));
    let joint = request["joint"].as_str();
    let multibody = joint == Some("multibody");

    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = dt;
    let surface = |collider: ColliderBuilder| {
        collider
            .density(0.0)
            .friction(0.0)
            .restitution(number("restitution"))
            .restitution_combine_rule(CoefficientCombineRule::Average)
    };
    let of_ball = |name: &str| request["other"][name].as_f64();
    let ball = of_ball("mass").map(|mass| {
        let radius = of_ball("radius").expect("a radius");
        let inertia = 0.4 * mass * radius * radius;
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(lever, 0.0, -number("radius") - gap - radius))
            .additional_mass_properties(MassProperties::new(Vector::ZERO, mass, Vector::new(inertia, inertia, inertia)))
            .can_sleep(false);
        world.insert(body, surface(ColliderBuilder::ball(radius))).0
    });
    if ball.is_none() {
        let below = Vector::new(0.0, 0.0, -radius - gap - 1.0);
        let floor = RigidBodyBuilder::fixed().translation(below);
        world.insert(floor, surface(ColliderBuilder::cuboid(9.0, 9.0, 1.0)));
    }

    let inertia = number("inertia") + if multibody { 0.0 } else { number("rotor") };
    let centre = Vector::new(number("centre"), 0.0, number("offset"));
    let rate = if joint.is_some() { (speed - of_ball("speed").unwrap_or(0.0)) / lever } else { 0.0 };
    let mass = MassProperties::new(centre, number("mass"), Vector::new(inertia, inertia, inertia));
    let velocity = if joint.is_some() {
        Vector::new(rate * number("offset"), 0.0, -rate * number("centre"))
    } else {
        Vector::new(0.0, 0.0, -speed)
    };
    let body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(mass)
        .can_sleep(false)
        .linvel(velocity)
        .angvel(Vector::new(0.0, rate, 0.0));
    let sphere = ColliderBuilder::ball(radius).translation(Vector::new(lever, 0.0, 0.0));
    let (struck, _) = world.insert(body, surface(sphere));
    let hinge = RevoluteJointBuilder::new(-Vector::Y);
    match joint {
        Some("multibody") => {
            let ground = world.insert_body(RigidBodyBuilder::fixed());
            let handle = world.insert_multibody_joint(ground, struck, hinge).expect("a tree");
            // In the first step the engine detects that the ground does not move.
            world.step();
            let (multibody, _) = world.multibody_joints.get_mut(handle).expect("just made");
            multibody.generalized_velocity_mut()[0] = -rate;
            multibody.armature_mut()[0] = number("rotor");
            multibody.damping_mut().fill(number("damping"));
            if let Some((ball, speed)) = ball.zip(of_ball("speed")) {
                world.bodies[ball].set_linvel(Vector::new(0.0, 0.0, speed), true);
            }
        }
        Some(_) => {
            let ground = world.insert_body(RigidBodyBuilder::fixed());
            world.insert_impulse_joint(ground, struck, hinge);
        }
        None => {}
    }

    let (mut depth, mut rebound, mut back): (f64, f64, usize) = (0.0, 0.0, 0);
    for _ in 0..LONGEST {
        world.step();
        let body = &world.bodies[struck];
        let at = body.position().transform_point(Vector::new(lever, 0.0, 0.0));
        rebound = if joint.is_some() { -body.angvel().y * lever } else { body.linvel().z };
        let mut height = at.z + gap;
        if let Some(ball) = ball {
            let ball = &world.bodies[ball];
            height = at.z - ball.translation().z - radius - of_ball("radius").expect("a radius");
            rebound -= ball.linvel().z;
        }
        depth = depth.max(-height);
        back = if rebound > 0.0 { back + 1 } else { 0 };
        if back > 10 || rebound.abs() < 1e-9 {
            break;
        }
    }
    [rebound / speed, depth]
}

//! Newton (newton-physics, on Warp): the penalty contacts of SemiImplicit and Featherstone, and XPBD's restitution.

use crate::exports::export::check_single_precision;
use crate::exports::linear::{Linear, UnclampedLinear};
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::single_precision;
use crate::exports::{Export, ExportError, Facts, Measurement, Request, StopMotion, Tool};
use crate::limits;
use crate::{Separation, kelvin_voigt};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "newton",
    title: "Newton (SemiImplicit, Featherstone, XPBD)",
    aliases: &["newton-physics", "warp"],
    law: "SemiImplicit, Featherstone: linear spring, and a damper that acts on approach only; XPBD: Newton's restitution",
    combines: "the mean of the two sides, of stiffness, damping and restitution",
    measured: &[
        Measurement {
            engine: "Newton 1.8.0",
            solver: "SemiImplicit",
            scenes: "ball of 2 kg",
            worst: [Some(9e-4), Some(8e-4), Some(7e-4)],
            by_hand: Some("2026-11-22"),
        },
        Measurement {
            engine: "Newton 1.8.0",
            solver: "Featherstone",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg; stops of hinges and of an elbow",
            worst: [Some(9e-4), Some(8e-4), Some(7e-4)],
            by_hand: Some("2026-11-22"),
        },
        Measurement {
            engine: "Newton 1.8.0",
            solver: "XPBD",
            scenes: "ball of 2 kg",
            worst: [Some(4e-5), Some(4e-5), Some(4e-5)],
            by_hand: Some("2026-11-22"),
        },
    ],
    caution: "single precision: place the contact near the origin; SemiImplicit and XPBD for free bodies only, \
        XPBD with enable_restitution=True; Featherstone does not close loops, and gives no warning",
    sources: &[
        "Newton 1.8.0, newton/_src/solvers/semi_implicit/kernels_contact.py: _eval_body_contact",
        "Newton 1.8.0, newton/_src/solvers/xpbd/restitution_kernels.py: build_restitution_manifolds",
        "Newton 1.8.0, newton/_src/sim/builder.py: ShapeConfig",
        "Newton, docs/concepts/articulations.rst: Loop closure",
        "Newton 1.8.0, newton/_src/solvers/semi_implicit/kernels_body.py: joint_force; newton/_src/solvers/xpbd/solver_xpbd.py",
    ],
};

/// For both shapes ke = k, kd = 2ζ√(k m̄) with the ζ of e², restitution = e.
///
/// The force of SemiImplicit and Featherstone is k x + c max(0, ẋ) while x > 0: during approach a spring and damper
/// with the depth x_m = (v/ω)√e_b(ζ) of the clamped contact of restitution e_b; during separation a spring alone,
/// with the speed ω x_m. Hence e = √e_b(ζ). Newton takes the mean of the two sides.
///
/// Semi-implicit Euler: the damper force is up to one step late, as in [`Linear::error_bound`] with this ζ.
///
/// XPBD sets the speed of separation of a free body to e v for every mass and step. XPBD has no armature, and a body
/// on a hinge rebounded with 0.29, 0.25, 0.17 for 0.2, 0.5, 0.8: the step of XPBD is exported for free bodies only.
/// The joints of SemiImplicit are springs: a pendulum rebounded with 0.38 for 0.5.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let mut linear = Linear::of(request, TOOL)?;
    let e = linear.restitution;
    if e < 1.0 {
        linear.ratio = kelvin_voigt::ratio(e * e, Separation::ForceVanishes)?;
    }
    let step = linear.explicit_step()?;
    let damping = linear.damping(linear.ratio);
    for (what, value) in [
        ("Newton's ke, N/m", linear.stiffness),
        ("Newton's kd, N·s/m", damping),
        ("Newton's restitution", e),
        ("Newton's time step, s", step),
    ] {
        check_single_precision(what, value)?;
    }
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.error_bound(step));
    export.add_penetration("SemiImplicit, Featherstone", linear.penetration(request.speed));
    export.set("ke", linear.stiffness, "N/m");
    export.set("kd", damping, "N·s/m");
    export.set("kf", 0.0, "N·s/m");
    export.set("mu", 0.0, "");
    export.set("restitution", e, "");
    export.set("dt", step, "s");
    let free = request.is_jointed() != Some(true);
    if let Some(speed) = request.speed.filter(|_| free) {
        export.set("dt_xpbd", limits::RIGID_TRAVEL / speed, "s");
    }
    let mut text = format!(
        "import newton\n\n\
         # For the shapes of both sides.\n\
         shape = newton.ModelBuilder.ShapeConfig(ke={:?}, kd={damping:?}, kf=0.0, ka=0.0, mu=0.0, restitution={e:?})\n\
         dt = {step:?}\n\n\n\
         def solver(model):\n    return newton.solvers.SolverFeatherstone(model, angular_damping=0.0)\n",
        linear.stiffness
    );
    if free {
        text += "\n\ndef solver_of_free_bodies(model):\n    \
                 return newton.solvers.SolverSemiImplicit(model, angular_damping=0.0)\n\n\n\
                 def rigid_solver(model):\n    \
                 return newton.solvers.SolverXPBD(model, enable_restitution=True, angular_damping=0.0)  # step: dt_xpbd\n";
    }
    export.add_snippet("Newton", "python", text);
    export.add_assumption("The shapes of both sides have these values: the mean counts.");
    export.add_assumption("Contacts are found anew at every step (model.collide), and no friction acts.");
    export.add_assumption("Mechanisms in Featherstone, whose joints are exact.");
    if free {
        export.add_assumption(
            "XPBD, for free bodies: stiffness and damping have no effect; restitution is used with \
             enable_restitution=True. Its step is \
             dt_xpbd.",
        );
    }
    single_precision::add(&mut export, TOOL, request, step, "m")?;
    export.cannot.push(
        "mechanisms in SemiImplicit: its joints are springs; mechanisms in XPBD: it has no armature, and bodies on a joint rebounded with \
         0.29, 0.25, 0.17 for 0.2, 0.5, 0.8; XPBD: stiffness, penetration, duration, peak force",
    );
    Ok(export)
}

/// Stop of a joint: `limit_ke` = k, `limit_kd` = 2ζ√(k m̄) with the ζ of a contact that ends at the closed gap.
///
/// Featherstone adds limit_ke (limit − q) − limit_kd q̇ while q is past the limit, also during separation (unlike at
/// contacts) and without a clamp: e = exp(−πζ/√(1−ζ²)). The force is that of the beginning of the step.
///
/// Measured in Newton 1.8.0, hinges with and without a rotor and an elbow whose shoulder is free: within 6.6e-4,
/// 3.7e-4, 3.4e-4. With the link's own inertia the elbow (0.107 for 0.0668 kg·m²) shows 0.118, 0.411, 0.754.
pub(crate) fn stop(request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    let unclamped = UnclampedLinear::of(request, TOOL)?;
    let (step, linear) = (unclamped.explicit_step()?, unclamped.0);
    let damping = linear.damping(linear.ratio);
    for (what, value) in [
        ("Newton's limit_ke", linear.stiffness),
        ("Newton's limit_kd", damping),
        ("Newton's time step, s", step),
    ] {
        check_single_precision(what, value)?;
    }
    let units = motion.units();
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(unclamped.error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("limit_ke", linear.stiffness, units.stiffness);
    export.set("limit_kd", damping, units.damping);
    export.set("dt", step, "s");
    export.add_snippet(
        "Newton",
        "python",
        format!(
            "import newton\n\n\n\
             def set_stop(builder, dof):\n    \"\"\"dof: the joint's, builder.joint_qd_start[joint].\"\"\"\n    \
             builder.joint_limit_ke[dof] = {:?}\n    builder.joint_limit_kd[dof] = {damping:?}\n\n\n\
             dt = {step:?}\n\n\n\
             def solver(model):\n    return newton.solvers.SolverFeatherstone(model, angular_damping=0.0)\n",
            linear.stiffness
        ),
    );
    export.add_assumption("Featherstone: its joints are exact, and it has rotor inertias (armature). No drive and no damping of the joint.");
    export.add_assumption("Both ends of the range have these values: Newton has but one pair for them.");
    single_precision::add(&mut export, TOOL, request, step, units.coordinate)?;
    export.add_assumption("The joint is measured from its stop, where its coordinate is known best.");
    if request.options.closed_loops {
        export.add_assumption(
            "Stops in closed loops had errors of 0.02 to 0.26: Featherstone ignores the joint that \
            closes a loop.",
        );
    }
    export.cannot.push(
        "stops in XPBD: it holds limits rigidly, without restitution, and does not read limit_ke and limit_kd; SemiImplicit: its joints are springs",
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (stiffness, damping) = (given.positive("ke")?, given.number("kd")?);
    let restitution = given.optional("restitution")?;
    given.assume("kf", 0.0)?;
    given.assume("mu", 0.0)?;
    given.optional("dt")?;
    given.optional("dt_xpbd")?;
    let (contact, damper) = given.linear(stiffness, damping, Separation::ForceVanishes)?;
    let penalty = SimulatedContact::of(ContactModel::ApproachDamper(contact, damper));
    let rigid = |restitution| SimulatedContact::of(ContactModel::Rigid { restitution, slowest: 0.0 });
    let free_bodies = restitution.map(|restitution| rigid(restitution).of_solver("XPBD, free bodies"));
    Ok([penalty.of_solver("SemiImplicit, Featherstone")].into_iter().chain(free_bodies).collect())
}

"""Impacts in Newton, on the processor. The phases are run at once, as bodies beside one another."""

import math

import numpy as np
from impacts import PHASES, Outcome
from scenes import Absent, Refused

try:
    import newton
    import warp
except ImportError:
    newton = warp = None

TOOL = "newton"
SOLVERS = {
    "SemiImplicit": lambda model: newton.solvers.SolverSemiImplicit(model, angular_damping=0.0),
    "Featherstone": lambda model: newton.solvers.SolverFeatherstone(model, angular_damping=0.0),
    "XPBD": lambda model: newton.solvers.SolverXPBD(model, enable_restitution=True, angular_damping=0.0),
}
# Steps of free flight before the contact, and how long its end is waited for, in undamped half periods.
FLIGHT, LONGEST = 2, 1.2
# Between the bodies, m.
APART = 1.0
# The kernels take a minute to compile, and are kept in the user's cache.
BY_HAND = True


def engine():
    if not newton:
        raise Absent("newton==1.8.0 and warp-lang==1.19.0")
    warp.config.quiet = True
    return f"Newton {newton.__version__}"


def ball(parameters, solver, ball, speed):
    """As free bodies."""

    def build(builder, i, height):
        about = 0.4 * ball.mass * ball.radius**2
        place = warp.transform((0.0, i * APART, ball.radius + height), warp.quat_identity())
        body = builder.add_body(xform=place, mass=ball.mass, inertia=inertia(about, about, about), lock_inertia=True)
        builder.add_shape_sphere(body, radius=ball.radius, cfg=material(parameters))
        builder.joint_qd[-6:] = [0.0, 0.0, -speed, 0.0, 0.0, 0.0]

    return impacts(build, parameters, solver, 0.0, ball.mass, speed, lambda state: state.body_qd.numpy()[:, 2])


def pendulum(parameters, solver, pendulum, speed):
    """The rotor is the joint's armature."""
    refuse_joints(parameters, solver)

    def build(builder, i, height):
        hinged(builder, pendulum, parameters, i, height, speed)

    def opening(state):
        # Of all that turns, linear first.
        return -state.body_qd.numpy()[:, 4] * pendulum.lever

    return impacts(build, parameters, solver, -pendulum.radius, pendulum.effective_mass, speed, opening)


def two_bodies(parameters, solver, bodies, speed):
    refuse_joints(parameters, solver)
    lever, share = bodies.lever, bodies.share

    def build(builder, i, height):
        hinged(builder, lever, parameters, i, share * height, share * speed)
        about = 0.4 * bodies.mass * bodies.radius**2
        place = warp.transform((lever.lever, i * APART, -bodies.distance - (1 - share) * height), warp.quat_identity())
        body = builder.add_body(xform=place, mass=bodies.mass, inertia=inertia(about, about, about), lock_inertia=True)
        builder.add_shape_sphere(body, radius=bodies.radius, cfg=material(parameters))
        builder.joint_qd[-6:] = [0.0, 0.0, (1 - share) * speed, 0.0, 0.0, 0.0]

    def opening(state):
        moving = state.body_qd.numpy()
        return -moving[0::2, 4] * lever.lever - moving[1::2, 2]

    return impacts(build, parameters, solver, None, bodies.effective_mass, speed, opening)


def refuse_joints(parameters, solver):
    """SemiImplicit: joints are springs, 0.38 for 0.5. XPBD: the export has no step where a joint takes part in the impact; on the lever of
    3.75 kg 0.27, 0.33, 0.22 of 0.2, 0.5, 0.8."""
    if solver is SOLVERS["SemiImplicit"] or (solver is SOLVERS["XPBD"] and "dt_xpbd" not in parameters):
        raise Refused("joints")


def hinged(builder, pendulum, parameters, i, height, speed):
    about = pendulum.inertia
    body = builder.add_link(
        mass=pendulum.mass,
        com=(pendulum.centre, 0.0, pendulum.offset),
        inertia=inertia(about, about, about),
        lock_inertia=True,
    )
    place = warp.transform((pendulum.lever, 0.0, 0.0), warp.quat_identity())
    builder.add_shape_sphere(body, xform=place, radius=pendulum.radius, cfg=material(parameters))
    joint = builder.add_joint_revolute(
        parent=-1,
        child=body,
        axis=(0.0, -1.0, 0.0),
        parent_xform=warp.transform((0.0, i * APART, 0.0), warp.quat_identity()),
        armature=pendulum.rotor,
    )
    builder.add_articulation([joint])
    builder.joint_q[-1] = math.asin(height / pendulum.lever)
    builder.joint_qd[-1] = -speed / pendulum.lever


def stop(parameters, solver, stop, speed):
    """Trees, in Featherstone. Each joint is measured from where it is at the stop."""
    if solver is not SOLVERS["Featherstone"] or not stop.tree:
        raise Refused("no stop")
    step, joints = parameters["dt"], len(stop.joints)
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
    for i, phase in enumerate(PHASES):
        bodies, made = {None: -1}, []
        for number, joint in enumerate(stop.joints):
            body = next(body for body in stop.bodies if body.name == joint.child)
            # Frames of the world's axes at the hinges, as the bodies stand at the stop.
            above = next((j.where for j in stop.joints if j.child == joint.parent), (0.0, 0.0))
            offset = (joint.where[0] - above[0], joint.where[1] - above[1], 0.0 if joint.parent else i * APART)
            bodies[joint.child] = builder.add_link(
                mass=body.mass,
                com=(body.centre[0] - joint.where[0], body.centre[1] - joint.where[1], 0.0),
                inertia=inertia(body.inertia, body.inertia, body.inertia),
                lock_inertia=True,
            )
            _, rate, rotor = stop.tree[number]
            limits = {}
            if number == stop.limited:
                at = stop.end * (FLIGHT + phase) * step * speed
                limits = {"limit_upper": at} if stop.end > 0 else {"limit_lower": at}
                limits |= {"limit_ke": parameters["limit_ke"], "limit_kd": parameters["limit_kd"]}
            made.append(
                builder.add_joint_revolute(
                    parent=bodies[joint.parent],
                    child=bodies[joint.child],
                    axis=(0.0, 0.0, 1.0),
                    parent_xform=warp.transform(offset, warp.quat_identity()),
                    armature=rotor,
                    **limits,
                )
            )
            builder.joint_qd[-1] = rate * speed
        builder.add_articulation(made)
    half = math.pi * math.sqrt(stop.effective_mass / parameters["limit_ke"])

    def opening(state):
        return -stop.end * state.joint_qd.numpy()[stop.limited :: joints]

    return run(builder, step, solver, half, speed, opening)


def impacts(build, parameters, solver, top, mass, speed, opening):
    """Against the plane z = top (None: no plane); mass: for the duration only."""
    step = parameters["dt_xpbd" if solver is SOLVERS["XPBD"] else "dt"]
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
    builder.rigid_gap = 1e-3
    for i, phase in enumerate(PHASES):
        build(builder, i, (FLIGHT + phase) * step * speed)
    if top is not None:
        builder.add_shape_plane(plane=(0.0, 0.0, 1.0, -top), width=0.0, length=0.0, cfg=material(parameters))
    return run(builder, step, solver, math.pi * math.sqrt(mass / parameters["ke"]), speed, opening)


def run(builder, step, solver, half, speed, opening):
    model = builder.finalize(device="cpu")
    solve = solver(model)
    before, after = model.state(), model.state()
    newton.eval_fk(model, model.joint_q, model.joint_qd, before)
    contacts = model.contacts()
    for _ in range(FLIGHT + math.ceil(LONGEST * half / step)):
        before.clear_forces()
        model.collide(before, contacts)
        solve.step(before, after, None, contacts, step)
        before, after = after, before
    return Outcome(opening(before) / speed, 0.0)


def inertia(x, y, z):
    return warp.mat33(x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z)


def material(parameters):
    return newton.ModelBuilder.ShapeConfig(
        density=0.0,
        ke=parameters["ke"],
        kd=parameters["kd"],
        kf=parameters["kf"],
        mu=parameters["mu"],
        restitution=parameters["restitution"],
    )


def pasted(text, parameters):
    names = {}
    exec(text, names)
    if "limit_ke" in parameters:
        return stop_pasted(names, parameters)
    shape = names["shape"]
    for name in ("ke", "kd", "kf", "mu", "restitution"):
        assert getattr(shape, name) == parameters[name], name
    builder = newton.ModelBuilder()
    builder.add_shape_sphere(builder.add_body(mass=1.0), radius=0.1, cfg=shape)
    model = builder.finalize(device="cpu")
    for name in ("solver", "solver_of_free_bodies", "rigid_solver"):
        names[name](model)


def stop_pasted(names, parameters):
    builder = newton.ModelBuilder()
    joint = builder.add_joint_revolute(parent=-1, child=builder.add_link(mass=1.0), limit_upper=0.0)
    builder.add_articulation([joint])
    names["set_stop"](builder, builder.joint_qd_start[joint])
    assert names["dt"] == parameters["dt"]
    model = builder.finalize(device="cpu")
    for name in ("limit_ke", "limit_kd"):
        found = getattr(model, f"joint_{name}").numpy()
        assert found == [np.float32(parameters[name])], (name, found)
    names["solver"](model)


SNIPPETS = {"python": pasted}

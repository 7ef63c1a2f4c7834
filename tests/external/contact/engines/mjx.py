"""Impacts in MJX with MuJoCo's parameters, in double precision. The phases are run at once."""

import importlib.metadata
import math

import numpy as np

from impacts import PHASES, Outcome
from scenes import Absent

try:
    import jax
    import jax.numpy as jnp
    import mujoco
    from mujoco import mjx
except ImportError:
    mjx = None

TOOL = "mujoco"
SOLVERS = {"": None}
BY_HAND = True
# Steps of free flight before the contact, and how long its end is waited for, in undamped half periods.
FLIGHT, LONGEST = 2, 1.2


def engine():
    if not mjx:
        raise Absent("mujoco-mjx==3.17.0")
    jax.config.update("jax_enable_x64", True)
    return f"MJX {importlib.metadata.version('mujoco-mjx')}"


def ball(parameters, solver, ball, speed):
    body = f'<joint type="slide" axis="0 0 1"/><geom type="sphere" size="{ball.radius}" mass="{ball.mass!r}"/>'
    return impacts(f"<body>{body}</body>{plane(ball.radius)}", parameters, [-1.0], [1.0], ball.mass, speed)


def pendulum(parameters, solver, pendulum, speed):
    lever = pendulum.lever
    return impacts(hinged(pendulum) + plane(pendulum.radius), parameters, [-1 / lever], [lever], pendulum.effective_mass, speed)


def two_bodies(parameters, solver, bodies, speed):
    lever, share = bodies.lever.lever, bodies.share
    ball = f'<freejoint/><geom type="sphere" size="{bodies.radius!r}" mass="{bodies.mass!r}"/>'
    body = f'<body pos="{lever!r} 0 {-bodies.distance!r}">{ball}</body>'
    # Hinge; place and velocity of the ball.
    motion, row = [-share / lever, 0, 0, 1 - share, 0, 0, 0], [lever, 0, 0, -1, 0, 0, 0]
    return impacts(hinged(bodies.lever) + body, parameters, motion, row, bodies.effective_mass, speed)


def hinged(pendulum):
    i = pendulum.inertia
    return (
        f'<body><joint type="hinge" axis="0 -1 0" armature="{pendulum.rotor!r}"/>'
        f'<inertial pos="{pendulum.centre!r} 0 {pendulum.offset!r}" mass="{pendulum.mass!r}" diaginertia="{i!r} {i!r} {i!r}"/>'
        f'<geom type="sphere" size="{pendulum.radius!r}" pos="{pendulum.lever!r} 0 0" mass="0"/></body>'
    )


def plane(below):
    return f'<geom type="plane" size="1 1 .1" pos="0 0 {-below!r}"/>'


def impacts(bodies, parameters, motion, row, mass, speed):
    """`motion`: velocities at a closing speed of 1 m/s, without rotation of free bodies; `row`: gap in metres per unit of each velocity; mass:
    for the duration only."""
    spec = mujoco.MjSpec.from_string(f'<mujoco><option gravity="0 0 0"/><worldbody>{bodies}</worldbody></mujoco>')
    step = spec.option.timestep = parameters["timestep"]
    for geom in spec.geoms:
        geom.solref, geom.condim = parameters["solref"], 1
        geom.solimp[:3] = parameters["solimp"]
    compiled = spec.compile()
    model = mjx.put_model(compiled)
    motion, row = np.array(motion), np.array(row)
    # A free body has a quaternion in the place of its rotation.
    places = np.resize(motion, compiled.nq) * (np.arange(compiled.nq) < compiled.nv)
    half = math.pi * math.sqrt(mass / (-parameters["solref"][0] * mass))
    steps = FLIGHT + math.ceil(LONGEST * half / step)

    def run(phase):
        data = mjx.make_data(model)
        before = -(FLIGHT + phase) * step * speed
        data = data.replace(qpos=jnp.array(compiled.qpos0) + before * places, qvel=jnp.array(speed * motion))
        return row @ jax.lax.fori_loop(0, steps, lambda _, d: mjx.step(model, d), data).qvel

    speeds = jax.jit(jax.vmap(run))(jnp.array(PHASES))
    return Outcome(np.asarray(speeds) / speed, 0.0)

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
    return impacts(body, parameters, 1.0, ball.radius, ball.mass, speed)


def pendulum(parameters, solver, pendulum, speed):
    i = pendulum.inertia
    body = (
        f'<joint type="hinge" axis="0 -1 0" armature="{pendulum.rotor!r}"/>'
        f'<inertial pos="{pendulum.centre!r} 0 {pendulum.offset!r}" mass="{pendulum.mass!r}" diaginertia="{i!r} {i!r} {i!r}"/>'
        f'<geom type="sphere" size="{pendulum.radius!r}" pos="{pendulum.lever!r} 0 0" mass="0"/>'
    )
    return impacts(body, parameters, pendulum.lever, pendulum.radius, pendulum.effective_mass, speed)


def impacts(body, parameters, lever, radius, mass, speed):
    """A model of one coordinate; `lever`: metres of gap for each unit of it; mass: for the duration only."""
    spec = mujoco.MjSpec.from_string(
        f'<mujoco><option gravity="0 0 0"/><worldbody><geom type="plane" size="1 1 .1" pos="0 0 {-radius!r}"/>'
        f"<body>{body}</body></worldbody></mujoco>"
    )
    step = spec.option.timestep = parameters["timestep"]
    for geom in spec.geoms:
        geom.solref, geom.condim = parameters["solref"], 1
        geom.solimp[:3] = parameters["solimp"]
    model = mjx.put_model(spec.compile())
    half = math.pi * math.sqrt(mass / (-parameters["solref"][0] * mass))
    steps = FLIGHT + math.ceil(LONGEST * half / step)

    def run(phase):
        data = mjx.make_data(model)
        data = data.replace(
            qpos=jnp.array([(FLIGHT + phase) * step * speed / lever]), qvel=jnp.array([-speed / lever])
        )
        return jax.lax.fori_loop(0, steps, lambda _, d: mjx.step(model, d), data).qvel[0]

    speeds = jax.jit(jax.vmap(run))(jnp.array(PHASES))
    return Outcome(np.asarray(speeds) * lever / speed, 0.0)

"""Bullet in C++: `bullet_cpp.cc` on Debian's libbullet-dev, rigid bodies and hinges in maximal coordinates, in both precisions."""

from engines import _built
from scenes import Absent, Refused

TOOL = "bullet"
# pkg-config's name of each.
SOLVERS = {"rigid bodies, single precision": "bullet-float", "rigid bodies, double precision": "bullet"}
# Those to whose bound the export's single_precision_error is added.
SINGLE = ("rigid bodies, single precision",)


def flags(solver):
    suffix, define = ("", ()) if solver.endswith("-float") else ("-float64", ("-DBT_USE_DOUBLE_PRECISION",))
    return (*define, "-I/usr/include/bullet", *(f"-l{name}{suffix}" for name in ("BulletDynamics", "BulletCollision", "LinearMath")))


def engine():
    _built.needs("libbullet-dev", "c++", "pkg-config")
    try:
        return f"Bullet {_built.output('pkg-config', '--modversion', 'bullet').strip()}"
    except RuntimeError:
        raise Absent("libbullet-dev") from None


def run(parameters, solver, speed, *scene):
    program = _built.c("bullet_cpp.cc", flags(solver), ("c++", "-std=c++17", "-O2"), solver)
    p, step = parameters, parameters["fixedTimeStep"]
    return _built.outcome(program, (p["contactStiffness"], p["contactDamping"], step, speed, *scene), speed * step)


def ball(parameters, solver, ball, speed):
    return run(parameters, solver, speed, "ball", ball.mass, ball.radius)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    return run(parameters, solver, speed, "pendulum", p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius)


def two_bodies(parameters, solver, bodies, speed):
    p = bodies.lever
    lever = (p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius)
    return run(parameters, solver, speed, "two_bodies", *lever, bodies.share, bodies.mass, bodies.radius)


def four_bar(parameters, solver, four_bar, speed):
    """Slow, lest its mass change: in single precision the travel of a step, 4e-8 m, is that of its places' rounding, and the rebound
    is off by 0.13 to 0.37."""
    if solver.endswith("-float"):
        raise Refused("single")
    return linkage(parameters, solver, four_bar, speed)


def linkage(parameters, solver, linkage, speed):
    return run(parameters, solver, speed, "linkage", *_built.linkage(linkage, speed))

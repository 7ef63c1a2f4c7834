"""Bullet in C++: `bullet_cpp.cc` on Debian's libbullet-dev, rigid bodies and hinges in maximal coordinates, in both precisions."""

from engines import _built
from scenes import Absent

TOOL = "bullet"
# pkg-config's name of each.
SOLVERS = {"rigid bodies, single precision": "bullet-float", "rigid bodies, double precision": "bullet"}


def flags(solver):
    suffix, define = ("", ()) if solver.endswith("-float") else ("-float64", ("-DBT_USE_DOUBLE_PRECISION",))
    return (*define, "-I/usr/include/bullet", *(f"-l{name}{suffix}" for name in ("BulletDynamics", "BulletCollision", "LinearMath")))


def engine():
    _built.needs("libbullet-dev", "c++", "pkg-config")
    try:
        return f"Bullet {_built.output('pkg-config', '--modversion', 'bullet').strip()}"
    except RuntimeError:
        raise Absent("libbullet-dev") from None


def run(parameters, solver, speed, *body):
    program = _built.c("bullet_cpp.cc", flags(solver), ("c++", "-std=c++17", "-O2"), solver)
    p, step = parameters, parameters["fixedTimeStep"]
    return _built.outcome(program, (p["contactStiffness"], p["contactDamping"], step, speed, *body), speed * step)


def ball(parameters, solver, ball, speed):
    return run(parameters, solver, speed, ball.mass, 0.4 * ball.mass * ball.radius**2, ball.radius, 0.0, 0.0)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    about_centre = p.effective_mass * p.lever**2 - p.mass * p.centre**2
    return run(parameters, solver, speed, p.mass, about_centre, p.radius, p.centre, p.lever)

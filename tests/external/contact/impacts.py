"""Shared parts of the contact scenes: percuss's results, the outcome of an impact, and the linear law in closed
form."""

import dataclasses
import json
import math
import subprocess

import numpy as np

# The start of the contact within a step is random: a scene runs once for each of these phases.
PHASES = (0.05, 0.25, 0.45, 0.65, 0.85)
# Radius of the spheres that represent the shapes of the contact bodies, m.
RADIUS = 0.02


@dataclasses.dataclass
class Outcome:
    """Result of a simulator: the restitution for each phase, and the deepest penetration of all phases."""

    restitutions: np.ndarray
    depth: float

    @classmethod
    def of(cls, run, phases=PHASES):
        """Outcome from `run(phase)`, which returns a restitution and a penetration."""
        restitutions, depths = np.array([run(phase) for phase in phases]).T
        return cls(restitutions, float(depths.max()))

    @property
    def mean(self):
        return float(np.mean(self.restitutions))

    def error(self, restitution):
        """Worst deviation of all phases."""
        return float(np.max(np.abs(self.restitutions - restitution)))


@dataclasses.dataclass
class Contact:
    """A contact for percuss: the flags of the mass, the spring, the approach speed."""

    flags: tuple
    stiffness: float
    speed: float

    def of_mass(self, mass):
        """The contact with a given mass."""
        return dataclasses.replace(self, flags=("--mass", repr(mass)))

    def along(self, normal):
        """The contact with a normal that is fixed in the world, such as the normal of a plane."""
        pairs = zip(self.flags[::2], self.flags[1::2])
        kept = [flag for pair in pairs if pair[0] not in ("--normal", "--along-line") for flag in pair]
        normal = ",".join(repr(float(x)) for x in normal)
        return dataclasses.replace(self, flags=(*kept, f"--normal={normal}", "--normal-frame", "world"))


def answer(percuss, *arguments):
    run = subprocess.run([percuss, *arguments, "--format", "json"], capture_output=True, text=True)
    if run.returncode:
        raise RuntimeError(f"percuss {' '.join(arguments)}: exit {run.returncode}\n{run.stderr}")
    return json.loads(run.stdout)


def damp(percuss, contact, restitution, *more):
    """The report of `percuss damp`."""
    wanted = ("--restitution", repr(restitution), "--stiffness", repr(contact.stiffness), "--speed", repr(contact.speed))
    return answer(percuss, "damp", *contact.flags, *wanted, *more)


def parameters(report, tool):
    export = report["exports"][tool]
    if export["error"]:
        raise RuntimeError(f"{tool}: {export['error']}")
    return export["parameters"]


def linear_impact(stiffness, damping, speed):
    """Restitution and penetration of ẍ = −max(0, stiffness x + damping ẋ), both per unit of mass: e = exp(−2ζC), C =
    arccos ζ/√(1−ζ²), and (v/ω)√e."""
    frequency = math.sqrt(stiffness)
    ratio = damping / (2 * frequency)
    if ratio < 1:
        arc = math.acos(ratio) / math.sqrt(1 - ratio * ratio)
    else:
        arc = math.acosh(ratio) / math.sqrt(ratio * ratio - 1)
    restitution = math.exp(-2 * ratio * arc)
    return restitution, speed / frequency * math.sqrt(restitution)

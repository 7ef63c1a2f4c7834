"""Impacts in the laws of Adams and Simscape with similar integrators: tests percuss's parameters for tools that
cannot run here.

    integrators.py --percuss PATH     prints a table and `N passed, N failed`

Backward differentiation formulas of variable order and step (SciPy's BDF; similar to GSTIFF in Adams and ode15s in
Simulink), and the trapezoidal rule with error control (similar to ode23t). Adams does not locate the start of the
contact: a step of up to the exported greatest size passes it. Simulink stops at the start (zero-crossing detection).
A mass of 2 kg, no gravity; the worst of nine phases."""

import argparse
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

from impacts import Contact, damp
from tally import Tally

RESTITUTIONS = (0.05, 0.2, 0.3, 0.5, 0.8, 0.95)
MASS = 2.0
# N/m and m/s.
CONTACTS = ((1e5, 0.3), (1e5, 3.0), (1e8, 0.03))
PHASES = np.linspace(0.05, 0.95, 9)
# Flight before the contact, and limit of the duration, in durations of the undamped contact.
FLIGHT, LONGEST = 1.0, 12.0


def smooth(part):
    part = np.clip(part, 0.0, 1.0)
    return part * part * (3 - 2 * part)


def adams(p):
    def force(x, v):
        return max(0.0, p["stiffness"] * x ** p["exponent"] + smooth(x / p["d"]) * p["cmax"] * v) if x > 0 else 0.0

    return force


def simscape(p):
    def force(x, v):
        pressed = p["Stiffness"] * x + p["Damping"] * v
        return max(0.0, smooth(x / p["Transition Region Width"]) * pressed) if x > 0 else 0.0

    return force


def through(force, speed, span, gap, **settings):
    """Integrates from before the contact to after it, without locating it."""
    found = solve_ivp(
        lambda t, s: [s[1], -force(s[0], s[1]) / MASS], (0.0, span), [-gap, speed], method="BDF", **settings
    )
    return -found.y[1, -1] / speed


def from_touch(force, speed, span, method, **settings):
    """Integrates from the known start of the contact to its end."""

    def opened(t, s):
        return s[0] if t > 0 else 1.0

    opened.terminal, opened.direction = True, -1
    if method == "trapezoidal":
        return trapezoidal(force, speed, span, **settings)
    found = solve_ivp(
        lambda t, s: [s[1], -force(s[0], s[1]) / MASS], (0.0, span), [0.0, speed], method=method, events=opened, **settings
    )
    return -found.y[1, -1] / speed


def trapezoidal(force, speed, span, rtol, atol):
    """Error control: difference from two half steps, divided by three."""

    def step(s, h):
        f, x, v = force(*s), s[0], s[1]
        # v⁺ by bisection: the force is monotonic in v⁺.
        low, high = v - h * 10 * (abs(f) / MASS + abs(v) / h), v + abs(v) + 1e-12
        for _ in range(60):
            u = (low + high) / 2
            if u - v + h / 2 / MASS * (f + force(x + h / 2 * (v + u), u)) > 0:
                high = u
            else:
                low = u
        u = (low + high) / 2
        return np.array([x + h / 2 * (v + u), u])

    t, h, s = 0.0, span * 1e-6, np.array([0.0, speed])
    while t < span and (s[0] > 0 or s[1] > 0):
        whole, halves = step(s, h), step(step(s, h / 2), h / 2)
        error = np.max(np.abs(whole - halves) / 3 / (atol + rtol * np.maximum(np.abs(s), np.abs(whole))))
        if error <= 1:
            t, s = t + h, whole
        h *= min(4.0, max(0.2, 0.9 * max(error, 1e-10) ** (-1 / 3)))
    return -s[1] / speed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    percuss, started, tally = parser.parse_args().percuss, time.monotonic(), Tally()
    for stiffness, speed in CONTACTS:
        contact = Contact(("--mass", repr(MASS)), stiffness, speed)
        half = np.pi * np.sqrt(MASS / stiffness)
        worst = {}
        for e in RESTITUTIONS:
            exports = damp(percuss, contact, e, "--for", "all")["exports"]
            a, s = exports["adams"], exports["simscape"]
            p = a["parameters"]
            span = (FLIGHT + LONGEST) * half
            shown = [
                through(adams(p), speed, span, (FLIGHT * half + phase * p["HMAX"]) * speed, max_step=p["HMAX"], rtol=p["ERROR"], atol=p["ERROR"])
                for phase in PHASES
            ]
            found = {"adams, BDF": (max(abs(x - e) for x in shown), a)}
            for name, method in (("BDF", "BDF"), ("trapezoidal", "trapezoidal")):
                shown = from_touch(simscape(s["parameters"]), speed, LONGEST * half, method, rtol=s["parameters"]["RelTol"], atol=s["parameters"]["AbsTol"])
                found[f"simscape, {name}"] = abs(shown - e), s
            for name, (error, given) in found.items():
                tally.within(f"within the stated bound: {name}", f"k = {stiffness:g}, v = {speed}, e = {e}", error / given["error_bound"], 1.0)
                worst.setdefault(name, []).append(error)
        for name, errors in worst.items():
            print(f"{name:24} k = {stiffness:7g} N/m  v = {speed:4} m/s " + " ".join(f"{x:8.1e}" for x in errors), flush=True)
    return tally.report(time.monotonic() - started)


if __name__ == "__main__":
    sys.exit(main())

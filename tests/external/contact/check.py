"""Checks the restitution of simulators with the parameters of `percuss damp`.

    check.py --percuss PATH [--levers COUNT]     prints tables and `N passed, N failed`

A ball and pendulums in MuJoCo and Drake, a four-bar and a double wishbone on its bump stop in MuJoCo. Each runs with
the exported parameters at the recommended time step, and, for comparison, with the contact body's own mass instead
of the effective mass. Run from the repository's root, with tests/external on PYTHONPATH."""

import argparse
import dataclasses
import importlib.metadata
import itertools
import sys
import tempfile
import time
from pathlib import Path

import drake_scenes
import mujoco_scenes
import snippets
import stop_family
from impacts import RADIUS, Contact, answer, damp, linear_impact, parameters
from scenes import BALLS, DOUBLE_PENDULUM, TWO_BODIES, Pendulum, levers
from tally import Tally

RESTITUTIONS = (0.2, 0.5, 0.8)
# Error limit guaranteed by percuss at its time step.
RESTITUTION = 1e-3
# Relative tolerance of the penetration, which is sampled once per step.
DEPTH = 5e-3
# Limits: relative change of the effective mass over the penetration, small enough for a single number; and its
# difference between percuss and MuJoCo.
DRIFT, DRIFT_AGREEMENT = 1e-3, 2e-6
# Relative tolerances: effective mass by MuJoCo's matrices; α = Â m̄.
MASS, ALPHA = 1e-9, 1e-6
# Relative tolerance of percuss's prediction for a damper with the wrong mass.
STATED = 1e-9
# Tolerance of an impact with wrong numbers compared with its prediction: the time step is not designed for it.
WRONG = 0.01

# Other settings for each contact in MuJoCo. With closed loops, implicitfast needs half the step.
OTHERWISE = {
    "implicitfast": lambda p: {
        "integrator": "implicitfast",
        "timestep": p["timestep"] * (0.5 if "equality_solref" in p else 1.0),
    },
    "RK4": lambda p: {"integrator": "RK4"},
    "standard format": lambda p: {"solref": p["solref_standard"]},
}
WRONG_NAMES = ("own mass", "k, c over own mass", "k, c undivided", "loops at default")

BALL = Contact(("--mass", "1.5"), 1e5, 0.4)
LENGTH, ROTORS = 0.8, (0.0, 0.5, 3.0)
PENDULUM = Pendulum(1.5, LENGTH, 0.0, LENGTH, RADIUS, 0.0).urdf
FOUR_BAR = Contact(
    ("--mass-from", "models/four_bar.urdf", "--link", "coupler", "--point", "0.35,0.1,0", "--normal", "0,1,0"), 1e6, 2e-3
)
BUMP_STOP = Contact(
    ("--mass-from", "models/double_wishbone.urdf", "--link", "bump_stop_pad", "--point", "0,0,0")
    + ("--along-line", "bump_stop:0,0,0", "--against", "chassis"),
    1e6,
    2e-2,
)


# Slow for its stiffness, as the other linkages; the rod is oblique to the normal.
SLIDER_CRANK = Contact(
    ("--mass-from", "models/slider_crank.urdf", "--link", "rod", "--point", "0.2,-0.15,0", "--normal", "0,1,0")
    + ("--set", "crank_hinge=1.0"),
    1e6,
    2e-3,
)
# Joints that run into their limits: scene, model, any link, joint, stiffness (N·m/rad or N/m), speed, position,
# conditions. The linkages are so slow that their inertia hardly changes.
STOPS = (
    ("stop of an elbow", "models/planar_2r.urdf", "outer", "elbow", 1e4, 1e-2, "elbow=1.0", "--armature", "elbow=0.4", "--armature", "shoulder=0"),
    ("stop of a crank", "models/four_bar.urdf", "coupler", "crank_hinge", 1e4, 2e-3, "crank_hinge=1.0"),
    ("stop of a slide", "models/slider_crank.urdf", "slider", "guide", 1e6, 1e-3, "crank_hinge=1.0"),
    ("stop of an arm", "models/double_wishbone.urdf", "bump_stop_pad", "lower_arm_hinge", 1e5, 5e-3, "lower_arm_hinge=0.1"),
)


@dataclasses.dataclass
class Row:
    """A line of the printed table: measured restitution, and measured penetration relative to percuss's; the same
    with the wrong parameters."""

    tool: str
    scene: str
    restitution: float
    mean: float
    error: float
    depth: float
    wrong: dict = dataclasses.field(default_factory=dict)

    def __str__(self):
        line = f"{self.tool:22} {self.scene:19} {self.restitution:4} {self.mean:9.5f} {self.error:8.1e} {self.depth:6.3f}"
        for name in WRONG_NAMES:
            line += "   {:6.3f} {:6.3f}".format(*self.wrong[name]) if name in self.wrong else " " * 16
        return line.rstrip()


class Check:
    def __init__(self, percuss):
        self.percuss, self.tally, self.rows = percuss, Tally(), []
        # Missing programs of unread snippets.
        self.absents = set()

    def right(self, tool, scene, report, outcome, linear=True):
        """Records an impact with percuss's parameters."""
        e, where = report["restitution"], f"{scene}, e = {report['restitution']}"
        depth = outcome.depth / report["max_penetration"]
        self.tally.within(f"restitution: {tool}", where, outcome.error(e), RESTITUTION)
        # Compares the export's `measured` values for this solver.
        program, solver = (tool.split(" ", 1) + ["Euler"])[:2]
        for known in report["exports"][program.lower()]["measured"]:
            if known["solver"] == solver and known["engine"].startswith(program):
                limit = known["worst"][RESTITUTIONS.index(e)]
                self.tally.within(f"as measured before: {tool}", where, outcome.error(e) / limit, 1.0)
        if linear:  # percuss states the penetration of the requested law
            self.tally.within(f"penetration: {tool}", where, abs(depth - 1), DEPTH)
        self.rows.append(Row(tool, scene, e, outcome.mean, outcome.error(e), depth))
        return self.rows[-1]

    def wrong(self, row, name, report, outcome, foreseen=None):
        """Records an impact with wrong parameters; the law predicts restitution and penetration."""
        row.wrong[name] = outcome.mean, outcome.depth / report["max_penetration"]
        if foreseen:
            where, (e, depth) = f"{row.tool}, {row.scene}, e = {row.restitution}", foreseen
            self.tally.within(f"as foreseen: {name}", where, abs(outcome.mean - e), WRONG)
            self.tally.within(f"as foreseen: {name}, x", where, abs(outcome.depth / depth - 1), WRONG)

    def damp(self, contact, e, *more):
        return damp(self.percuss, contact, e, *more)

    def mujoco(self, scene, report, impact):
        """`impact(parameters)` returns the outcome."""
        given = parameters(report, "mujoco")
        for name, change in OTHERWISE.items():
            self.right(f"MuJoCo {name}", scene, report, impact(given | change(given)))
        return self.right("MuJoCo", scene, report, impact(given))

    def wrong_in_mujoco(self, row, contact, report, alone, impact):
        """Impacts with the contact body's own mass in all computations; with the contact's k and c over that mass;
        with k and c directly; and, for closed loops, with MuJoCo's default settings of the equality constraints."""
        given, own = parameters(report, "mujoco"), report["body_alone"]["mass"]
        k, c = contact.stiffness, report["damping"]
        for name, solref in (
            ("own mass", parameters(alone, "mujoco")["solref"]),
            ("k, c over own mass", [-k / own, -c / own]),
            ("k, c undivided", [-k, -c]),
        ):
            # The same number of steps per period as with the right stiffness.
            step = given["timestep"] * (given["solref"][0] / solref[0]) ** 0.5
            outcome = impact(given | {"solref": solref, "timestep": step})
            self.wrong(row, name, report, outcome, linear_impact(-solref[0], -solref[1], contact.speed))
        if "equality_solref" in given:
            loose = {name: value for name, value in given.items() if not name.startswith("equality_")}
            self.wrong(row, "loops at default", report, impact(loose))

    def alone(self, contact, report):
        """percuss's prediction for the contact body's own mass; None if this equals the effective mass."""
        own, mass = report["body_alone"], report["effective_mass"]
        if abs(own["mass"] / mass - 1) < MASS:
            return None
        alone = self.damp(contact.of_mass(own["mass"]), report["restitution"])
        e, _ = linear_impact(contact.stiffness / mass, alone["damping"] / mass, contact.speed)
        where = f"m̄ = {mass:.6g} kg, own {own['mass']:.6g} kg, e = {report['restitution']}"
        self.tally.within("stated: what the own mass's damper does", where, abs(own["restitution"] - e), STATED)
        return alone

    def ball(self):
        for e in RESTITUTIONS:
            report = self.damp(BALL, e)
            mass = report["effective_mass"]
            self.mujoco("ball", report, lambda p: mujoco_scenes.ball(p, mass, BALL.speed))
            for mode in drake_scenes.MODES:
                outcome = drake_scenes.ball(parameters(report, "drake"), mode, mass, BALL.speed)
                self.right(f"Drake {mode}", "ball", report, outcome, linear=mode == "sap")

    def pendulum(self, folder, rotor):
        path = Path(folder) / "pendulum.urdf"
        path.write_text(PENDULUM)
        flags = ("--link", "rod", "--point", f"{LENGTH},0,0", "--normal", "0,0,-1", "--armature", f"hinge={rotor}")
        contact = dataclasses.replace(BALL, flags=("--mass-from", str(path), *flags))
        scene = f"pendulum, rotor {rotor}"
        for report, alone in self.mechanism(scene, contact):

            def impact(of, mode):
                return drake_scenes.pendulum(parameters(of, "drake"), mode, PENDULUM, LENGTH, rotor, contact.speed)

            for mode in drake_scenes.MODES:
                row = self.right(f"Drake {mode}", scene, report, impact(report, mode), linear=mode == "sap")
                if alone and mode != "lagged":
                    # SAP integrates k and c directly; the dissipation of the other plants does not depend on a mass. Continuous is run for
                    # both: it is fifty times faster than lagged.
                    mass = report["effective_mass"]
                    foreseen = linear_impact(contact.stiffness / mass, alone["damping"] / mass, contact.speed)
                    self.wrong(row, "own mass", report, impact(alone, mode), foreseen if mode == "sap" else None)

    def mechanism(self, scene, contact):
        """A model's contact in MuJoCo. Returns percuss's report for each restitution, and its prediction for the own
        mass."""
        _, path, *flags = contact.flags
        theirs = mujoco_scenes.Mechanism(path, answer(self.percuss, "mass", path, *flags))
        mass = theirs.effective_mass(theirs.pose)
        for e in RESTITUTIONS:
            where = f"{scene}, e = {e}"
            report = self.damp(contact, e)
            given, ours = parameters(report, "mujoco"), report["effective_mass"]
            self.tally.within("effective mass by MuJoCo's matrices", where, abs(ours / mass - 1), MASS)
            # The direct solref is the solref of an exact diagonal times d + (1 − d)α, with the impedance d.
            d = given["solimp"][0]
            alpha = (-given["solref"][0] * ours / contact.stiffness - d) / (1 - d)
            their_alpha = theirs.inverse_diagonal() * mass
            self.tally.within("α = Â m̄ by MuJoCo's body_invweight0", where, abs(alpha / their_alpha - 1), ALPHA)

            alone = self.alone(contact, report)
            row = self.mujoco(scene, report, lambda p: theirs.impact(p, contact.speed)[0])
            if alone:
                self.wrong_in_mujoco(row, contact, report, alone, lambda p: theirs.impact(p, contact.speed)[0])

            # The plane's normal is fixed; the normal of the contact in the report may turn with the mechanism.
            drift = report["drift"]["over_penetration"]
            on_plane = self.damp(contact.along(theirs.normal), e)["drift"]["over_penetration"]
            their_drift = theirs.effective_mass(theirs.impact(given, contact.speed)[1]) / mass - 1
            self.tally.within("drift of the effective mass", where, max(abs(drift), abs(on_plane)), DRIFT)
            self.tally.within("drift by MuJoCo's matrices", where, abs(on_plane - their_drift), DRIFT_AGREEMENT)
            print(
                f"{where}: m̄ = {ours:.6f} kg (MuJoCo {mass:.6f}), body alone {report['body_alone']['mass']:.6g} kg, "
                f"α = {alpha:.6f} (MuJoCo {their_alpha:.6f}), drift {drift:+.2e}, on a plane {on_plane:+.2e} "
                f"(MuJoCo {their_drift:+.2e})",
                flush=True,
            )
            yield report, alone

    def stops(self):
        """Joints that run into their limits."""
        for scene, path, link, joint, stiffness, speed, *conditions in STOPS:
            with_pose = ("--set", *conditions)
            # Any contact, to get the pose.
            pose = answer(self.percuss, "mass", path, "--link", link, "--point", "0,0,0", "--normal", "1,0,0", *with_pose)
            theirs = mujoco_scenes.LimitedJoint(path, pose, joint)
            contact = Contact(("--mass-from", path, "--limit", joint, *with_pose), stiffness, speed)
            for e in RESTITUTIONS:
                where = f"{scene}, e = {e}"
                report = self.damp(contact, e, "--for", "all")
                self.absents |= snippets.check(report, where, self.tally, snippets.EXPECTED_OF_STOPS)
                ours, their = report["effective_mass"], theirs.effective_mass(theirs.pose)
                self.tally.within("a stop's inertia by MuJoCo's matrices", where, abs(ours / their - 1), MASS)
                given = parameters(report, "mujoco")
                d = given["solimplimit"][0]
                alpha = (-given["solreflimit"][0] * ours / stiffness - d) / (1 - d)
                their_alpha = theirs.inverse_diagonal() * their
                self.tally.within("α by MuJoCo's dof_invweight0", where, abs(alpha / their_alpha - 1), ALPHA)
                self.right("MuJoCo", scene, report, theirs.impact(given, speed)[0])

    def further(self, folder, count):
        """Runs balls, a lever against a free ball, an oblique double pendulum, a slider-crank and compound levers, one restitution each,
        within the error bound of the export."""
        scenes = [(f"double pendulum, e = {e}", DOUBLE_PENDULUM.contact(folder), None, e) for e in (0.3, 0.9)]
        scenes += [(f"slider-crank, e = {e}", SLIDER_CRANK, None, e) for e in (0.15, 0.6)]
        scenes += [(f"lever {i}", lever.contact(folder), lever, e) for i, (lever, e) in enumerate(levers(count))]
        for i, (ball, e) in enumerate(BALLS):
            report = self.damp(ball.contact(folder), e)
            self.bound("MuJoCo", f"ball {i}", report, mujoco_scenes.ball(parameters(report, "mujoco"), ball.mass, ball.speed))
            for mode in drake_scenes.MODES:
                outcome = drake_scenes.ball(parameters(report, "drake"), mode, ball.mass, ball.speed)
                self.bound(f"Drake {mode}", f"ball {i}", report, outcome)
        for i, (bodies, e) in enumerate(TWO_BODIES):
            report = self.damp(bodies.contact(folder), e)
            where = f"two moving bodies {i}"
            self.tally.within("effective mass of two bodies", where, abs(report["effective_mass"] / bodies.effective_mass - 1), MASS)
            self.bound("MuJoCo", where, report, mujoco_scenes.two_bodies(parameters(report, "mujoco"), bodies))
            for mode in drake_scenes.MODES:
                self.bound(f"Drake {mode}", where, report, drake_scenes.two_bodies(parameters(report, "drake"), mode, bodies))
        for scene, contact, lever, e in scenes:
            if lever:
                lever.contact(folder)  # writes the model again: all levers have one file name
            _, path, *flags = contact.flags
            pairs = [pair for pair in zip(flags[::2], flags[1::2]) if pair[0] != "--own-mass"]
            theirs = mujoco_scenes.Mechanism(path, answer(self.percuss, "mass", path, *itertools.chain(*pairs)))
            report = self.damp(contact, e)
            self.bound("MuJoCo", scene, report, theirs.impact(parameters(report, "mujoco"), contact.speed)[0])
            for mode in drake_scenes.MODES if lever else ():
                given = parameters(report, "drake")
                outcome = drake_scenes.pendulum(given, mode, lever.urdf, lever.lever, lever.rotor, lever.speed)
                self.bound(f"Drake {mode}", scene, report, outcome)

    def bound(self, tool, scene, report, outcome):
        stated = report["exports"][tool.split(" ")[0].lower()]["error_bound"]
        error = outcome.error(report["restitution"])
        print(f"{tool:20} {scene:24} e = {report['restitution']:.3f}: {error:.1e}, bound {stated:.1e}", flush=True)
        self.tally.within(f"further scenes within the bound: {tool}", scene, error / stated, 1.0)

    def snippets(self):
        contacts = {
            "ball": dataclasses.replace(BALL, flags=(*BALL.flags, "--own-mass", "1.5")),
            "four-bar": FOUR_BAR,
            "double wishbone": BUMP_STOP,
        }
        for (name, contact), e in itertools.product(contacts.items(), RESTITUTIONS):
            self.absents |= snippets.check(self.damp(contact, e, "--for", "all"), f"{name}, e = {e}", self.tally)

    def table(self):
        print("\nRestitution e: asked for, measured (mean and worst of the phases); penetration x, over what percuss states")
        print("(that of the linear law: Drake's continuous and lagged plants have another). Then e and x with wrong numbers.")
        print(f"{'':69}" + "".join(f"{name:>16}" for name in ("own", "k, c over", "k, c", "loops at")))
        print(
            f"{'tool':22} {'scene':19} {'e':>4} {'measured':>9} {'worst':>8} {'x':>6}"
            + "".join(f"{name:>16}" for name in ("mass", "own mass", "undivided", "default"))
        )
        for row in sorted(self.rows, key=lambda r: (r.scene, r.tool)):
            print(row)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    started = time.monotonic()
    # The exports' `measured` values are compared for any version.
    print("with " + ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("mujoco", "drake")), flush=True)
    parser.add_argument("--levers", type=int, default=5, help="random compound levers (50 in the long run)")
    arguments = parser.parse_args()
    check = Check(arguments.percuss)
    check.snippets()
    list(check.mechanism("four-bar", FOUR_BAR))
    list(check.mechanism("double wishbone", BUMP_STOP))
    check.stops()
    print("\n".join(sorted(check.absents)))
    stop_family.check(check.percuss, check.tally)
    check.ball()
    with tempfile.TemporaryDirectory() as folder:
        for rotor in ROTORS:
            check.pendulum(folder, rotor)
        check.further(folder, arguments.levers)
    check.table()
    return check.tally.report(time.monotonic() - started)


if __name__ == "__main__":
    sys.exit(main())

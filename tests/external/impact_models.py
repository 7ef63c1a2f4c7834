"""Impacts written by `percuss export`, run in MuJoCo by the exported scripts: the restitution is the required one, and the keyframe
satisfies the constraints.

    impact_models.py --percuss PATH    trees, linkages, suspension sheets, random models; prints `N passed, N failed`
"""

import argparse
import collections
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import tempfile

import mujoco
import numpy as np

from mjcf import RandomModel

# The accuracy for which percuss selects the time step.
TOLERANCE = 1e-3
# Rounding of positions of a few metres or radians, and of velocities relative to the fastest joint.
RESIDUAL = 1e-10
WORKERS = 2
# Trees and linkages: contact, restitution, further flags.
MODELS = {
    "physical_pendulum": "--link body --point 0,0,-0.8 --normal 1,0,0",
    "point_mass_pendulum": "--link bob --point 0,0,0 --normal 1,0,0.2",
    "double_pendulum": "--link lower --point 0,0,-0.5 --normal 1,0,0",
    "planar_2r": "--link outer --point 0.4,0,0 --normal 0,1,0",
    "shaped_arm": "--link forearm --point 0.3,0,0 --normal 0.2,0,1",
    "antiparallelogram": "--link coupler --point 0.36,-0.15,0 --normal 0,1,0",
    "two_free_bodies": "--link first --point 0.1,0,0 --normal 1,0.2,0 --against second",
    "four_bar": "--link coupler --point 0.2,0,0 --normal 1,0.3,0 --set crank_hinge=60deg",
    "slider_crank": "--link slider --point 0,0,0 --normal 1,0,0 --set crank_hinge=50deg",
    "six_bar": "--link coupler --point 0.2,0,0 --normal 1,0.3,0",
    "six_r_arm": "--link tool --point 0.08,0,0 --normal 1,0.1,0.3 --set elbow=70deg",
    "rocker_bogie": "--link left_front --point 0,0,0 --normal 0,0,-1",
}
# Stops of joints, and a floating base: contact, stiffness, speed.
MORE = {
    "planar_2r": ("--limit elbow --set elbow=40deg", "2000", "0.1"),
    "four_bar": ("--limit crank_hinge --set crank_hinge=60deg", "20000", "0.1"),
    "double_wishbone": ("--limit lower_arm_hinge", "50000", "0.01"),
    "rocker_bogie": ("--limit left_bogie:lower", "3000", "0.1"),
    "floating_body": ("--base floating --link body --point 0.3,0,0 --normal 0,0,-1", "1e5", "0.1"),
}
RESTITUTIONS = [0.1, 0.3, 0.6, 0.9]
# Number of random models, and the expected numbers of outcomes.
RANDOM = 40
EXPECTED = {"reached": 34, "refused": 6}
# Faster impacts, in which the mass changes, and the expected numbers of outcomes.
FAST = ["300mm/s"]
EXPECTED_FAST = {"reached": 51, "warned": 11, "unknown": 2, "refused": 6}


def run(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True)


class Case:
    """A model with a contact and a required restitution."""

    def __init__(self, name, source, contact, restitution, stiffness="400N/mm", speed="10mm/s"):
        self.name, self.source, self.contact, self.restitution = name, source, contact.split(), restitution
        self.flags = ["--restitution", restitution, "--stiffness", stiffness, f"--speed={speed}"]

    def set_speed(self, speed):
        """The case with another speed and a name for it."""
        self.flags[-1], self.name = f"--speed={speed}", f"{self.name}_{speed.replace('/', '')}"
        return self

    def outcome(self, percuss, folder):
        """Outcome: (kind, difference of the restitution or message)."""
        path = os.path.join(folder, f"{self.name}.xml")
        exported = run(percuss, "export", self.source, *self.contact, *self.flags, "--format", "json", "-o", path)
        if exported.returncode:
            return "refused", exported.stderr.strip().replace("\n", " ")
        report = json.loads(exported.stdout)
        warned = any(finding["code"] == "restitution-not-reached" for finding in report["diagnostics"])
        residual = keyframe_residual(path)
        if not residual < RESIDUAL:
            return "keyframe", f"residual {residual:.1e}"
        script = run(sys.executable, path.replace(".xml", ".py"))
        found = re.search(r"restitution +(\S+) \(required \S+, difference (\S+)\)", script.stdout)
        if not found:
            return "script", (script.stderr or script.stdout).strip()
        difference = float(found[1]) - self.restitution
        if (abs(difference) <= TOLERANCE) != (script.returncode == 0):
            return "exit code", f"{script.returncode} with {difference:+.1e}"
        bound = report["error_bound"]
        if bound is None:
            return ("unknown", difference) if warned else ("no warning", f"{difference:+.1e} without a bound")
        if not abs(difference) <= bound:
            return "bound", f"{difference:+.1e} instead of at most {bound:.1e}"
        if script.returncode and not warned:
            return "no warning", f"{difference:+.1e}"
        return ("reached" if script.returncode == 0 else "warned", difference)


def keyframe_residual(path):
    """Largest violation of the constraints and of the touch by the keyframe: positions, and velocities over the largest one."""
    spec = mujoco.MjSpec.from_file(path)
    spec.option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("impact").id)
    mujoco.mj_fwdPosition(model, data)
    rows = data.efc_J.reshape(data.nefc, model.nv)
    held = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
    positions = np.abs(data.efc_pos[held]).max(initial=0)
    speeds = np.abs(rows[held] @ data.qvel).max(initial=0) / np.abs(data.qvel).max()
    if all(model.geom(number).name != "impact/point" for number in range(model.ngeom)):
        # The stop is an end of the range of the only joint with a limit.
        joint = int(np.flatnonzero(model.jnt_limited)[0])
        return max(positions, speeds, np.abs(data.qpos[model.jnt_qposadr[joint]] - model.jnt_range[joint]).min())
    point, face = model.geom("impact/point").id, model.geom("impact/face").id
    normal = data.geom_xmat[face].reshape(3, 3)[:, 2]
    away = normal @ (data.geom_xpos[point] - data.geom_xpos[face])
    thickness = model.geom_size[face][2] if model.geom_type[face] == mujoco.mjtGeom.mjGEOM_BOX else 0
    return max(positions, speeds, abs(away - thickness - model.geom_size[point][0]))


def cases(percuss, folder):
    for number, (name, contact) in enumerate(MODELS.items()):
        yield Case(name, f"models/{name}.urdf", contact, RESTITUTIONS[number % 4])
    for number, (name, (contact, stiffness, speed)) in enumerate(MORE.items()):
        yield Case(f"{name}_more", f"models/{name}.urdf", contact, RESTITUTIONS[number % 4], stiffness, speed)
    listed = run(percuss, "template", "--list").stdout.splitlines()
    for number, name in enumerate(line.split()[0] for line in listed if line[:1].strip()):
        sheet = os.path.join(folder, f"{name}.toml")
        run(percuss, "template", name, "-o", sheet)
        stops = re.findall(r"^(bump_stop\w*) ", run(percuss, "mass", sheet, "--at", "all").stdout, re.MULTILINE)
        yield Case(name, sheet, f"--at {stops[0]}", RESTITUTIONS[number % 4])


def random_cases(folder, speed="0.1mm/s"):
    """Random models of MJCF: several joints of a body, ball joints, free joints, equalities, rods. The impacts are slow, because a contact
    near an axis rotates its link fast."""
    for seed in range(RANDOM):
        path = os.path.join(folder, f"{seed}.xml")
        model = RandomModel(seed)
        model.write(path)
        rng = np.random.default_rng(seed)
        point, normal = (",".join(f"{x:.3f}" for x in rng.uniform(-0.3, 0.3, 3)) for _ in range(2))
        contact = f"--link {rng.choice(model.bodies)} --point={point} --normal={normal}"
        yield Case(f"random{seed}", path, contact, RESTITUTIONS[seed % 4], speed=speed)


def refuses_another_restitution(percuss):
    """True if the script of a model with another required restitution exits with 1."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "impact.xml")
        case = Case("", "models/four_bar.urdf", MODELS["four_bar"], 0.3)
        run(percuss, "export", case.source, *case.contact, *case.flags, "-o", path)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace('name="restitution" data="0.3"', 'name="restitution" data="0.302"'))
        return run(sys.executable, path.replace(".xml", ".py")).returncode == 1


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        models, random = list(cases(options.percuss, folder)), list(random_cases(folder))
        contacts = [case for case in cases(options.percuss, folder) if not case.name.endswith("_more")]
        fast = [case.set_speed(speed) for speed in FAST for case in [*contacts, *random_cases(folder)]]
        all_cases = [*models, *random, *fast]
        with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
            outcomes = list(pool.map(lambda case: case.outcome(options.percuss, folder), all_cases))
    failures, counts, counts_fast, worst = [], collections.Counter(), collections.Counter(), 0.0
    for case, (kind, detail) in zip(all_cases, outcomes):
        if options.verbose:
            print(f"{case.name:28} {kind:14} {detail}")
        counts[kind] += case in random
        counts_fast[kind] += case in fast
        if kind == "reached":
            worst = max(worst, abs(detail))
        elif case in models or kind not in ("refused", "warned", "unknown"):
            failures.append(f"{case.name}: {kind}: {detail}")
    if not refuses_another_restitution(options.percuss):
        failures.append("a script accepts a restitution that is not reached")
    for title, found, expected in [("random models", counts, EXPECTED), ("fast impacts", counts_fast, EXPECTED_FAST)]:
        if dict(+found) != expected:
            failures.append(f"{title}: {dict(+found)}, expected {expected}")
    print("\n".join(failures))
    print(f"exported impacts: {len(models)} models, {dict(+counts)} of random models, {dict(+counts_fast)} of fast impacts; largest error {worst:.1e}")
    print(f"{len(all_cases) - len(failures)} passed, {len(failures)} failed")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()

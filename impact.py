"""Runs the impact of the keyframe `impact` of a model in MuJoCo and prints the restitution.

Exit code 1 if it differs from the required one by more than 0.001. Requires the package mujoco."""
# made by percuss

import pathlib
import sys

import mujoco
import numpy as np

MODEL = pathlib.Path(__file__).with_suffix(".xml")
TOLERANCE = 1e-3
# Limit of the number of time steps.
STEPS = 2_000_000

model = mujoco.MjModel.from_xml_path(str(MODEL))
data = mujoco.MjData(model)
# True if a sphere hits a face; false if the only joint with a limit hits its stop.
surfaces = any(model.geom(number).name == "impact/point" for number in range(model.ngeom))


def closing_speed():
    """Closing speed of the sphere and the face, m/s, or of the joint and its stop, rad/s or m/s."""
    if not surfaces:
        joint = int(np.flatnonzero(model.jnt_limited)[0])
        position, (lower, upper) = data.qpos[model.jnt_qposadr[joint]], model.jnt_range[joint]
        return float(data.qvel[model.jnt_dofadr[joint]]) * (1 if position - lower > upper - position else -1)
    point, face = model.geom("impact/point").id, model.geom("impact/face").id
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    centre = data.geom_xpos[point]
    ours, theirs = np.zeros((3, model.nv)), np.zeros((3, model.nv))
    mujoco.mj_jac(model, data, ours, None, centre, model.geom_bodyid[point])
    mujoco.mj_jac(model, data, theirs, None, centre, model.geom_bodyid[face])
    # The normal of the face is its z-axis.
    normal = data.geom_xmat[face].reshape(3, 3)[:, 2]
    return float(normal @ (theirs - ours) @ data.qvel)


def penetration():
    """Depth of the contact, m or rad; None without a contact."""
    if surfaces:
        return -data.contact[0].dist if data.ncon else None
    limits = np.flatnonzero(data.efc_type[: data.nefc] == mujoco.mjtConstraint.mjCNSTR_LIMIT_JOINT)
    return -float(data.efc_pos[limits[0]]) if len(limits) else None


mujoco.mj_resetDataKeyframe(model, data, model.key("impact").id)
speed = closing_speed()
touched, depth = False, 0.0
for _ in range(STEPS):
    mujoco.mj_step(model, data)
    now = penetration()
    if now is not None:
        touched, depth = True, max(depth, now)
    elif touched:
        break
else:
    sys.exit("the impact did not end")
restitution = -closing_speed() / speed
required = float(model.numeric("restitution").data[0])
difference = restitution - required
turns = not surfaces and model.jnt_type[np.flatnonzero(model.jnt_limited)[0]] == mujoco.mjtJoint.mjJNT_HINGE
unit = "rad" if turns else "m"
print(f"approach speed   {speed:.6g} {unit}/s")
print(f"penetration      {1e3 * depth:.6g} m{unit}")
print(f"duration         {1e3 * data.time:.6g} ms")
print(f"restitution      {restitution:.5f} (required {required:g}, difference {difference:+.1e})")
if not abs(difference) <= TOLERANCE:
    sys.exit(f"the restitution differs by more than {TOLERANCE:g}")

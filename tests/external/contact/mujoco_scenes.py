"""Impacts in MuJoCo. `parameters` has MuJoCo's own names, as in percuss's export: "solref", "solimp", "timestep",
for closed loops "equality_solref" and "equality_solimp"; and optionally "integrator".

This file contains no contact law: the parameters come from the caller. All other settings are MuJoCo's defaults,
except gravity and friction, which are zero."""

import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np

from impacts import RADIUS, Outcome
from loops import least_energy, mjcf, quaternion

# Limit of the number of steps of an impact.
STEPS = 2_000_000


def dress(spec, parameters):
    """Sets the parameters of all geoms and equality constraints."""
    spec.option.timestep = parameters["timestep"]
    spec.option.integrator = getattr(mujoco.mjtIntegrator, f"mjINT_{parameters.get('integrator', 'Euler').upper()}")
    for geom in spec.geoms:
        geom.condim = 1
        if "solref" in parameters:
            geom.solref = parameters["solref"]
            geom.solimp[:3] = parameters["solimp"]
    for joint in spec.joints if "solreflimit" in parameters else []:
        joint.solref_limit = parameters["solreflimit"]
        joint.solimp_limit[:3] = parameters["solimplimit"]
    if "equality_solref" in parameters:
        for equality in spec.equalities:
            equality.solref = parameters["equality_solref"]
            equality.solimp[:3] = parameters["equality_solimp"]
    return spec.compile()


def ball(parameters, mass, speed):
    """A ball thrown perpendicularly at a plane. Effective mass: `mass`."""
    spec = mujoco.MjSpec.from_string(
        '<mujoco><option gravity="0 0 0"/><worldbody><geom type="plane" size="1 1 .1"/>'
        f'<body pos="0 0 {RADIUS}"><joint type="slide" axis="0 0 1"/>'
        f'<geom type="sphere" size="{RADIUS}" mass="{mass!r}"/></body></worldbody></mujoco>'
    )
    model = dress(spec, parameters)
    depth = lambda data: -data.contact[0].dist if data.ncon else None
    return Impact(model, model.qpos0, np.ones(1), lambda data: data.qvel[0], depth).outcome(speed)


def two_bodies(parameters, bodies):
    """A lever against a free ball below it."""
    p, i = bodies.lever, bodies.lever.inertia
    spec = mujoco.MjSpec.from_string(
        f'''<mujoco><option gravity="0 0 0"/><worldbody>
        <body><joint type="hinge" axis="0 -1 0"/>
        <inertial pos="{p.centre!r} 0 {p.offset!r}" mass="{p.mass!r}" diaginertia="{i!r} {i!r} {i!r}"/>
        <geom type="sphere" size="{p.radius!r}" pos="{p.lever!r} 0 0" mass="0"/></body>
        <body pos="{p.lever!r} 0 {-bodies.distance!r}"><freejoint/>
        <geom type="sphere" size="{bodies.radius!r}" mass="{bodies.mass!r}"/></body>
        </worldbody></mujoco>'''
    )
    model = dress(spec, parameters)
    # Hinge; place of the ball, linear and angular velocity.
    opening = np.array([bodies.share / p.lever, 0, 0, bodies.share - 1, 0, 0, 0])
    depth = lambda data: -data.contact[0].dist if data.ncon else None
    return Impact(model, model.qpos0, opening, lambda data: p.lever * data.qvel[0] - data.qvel[3], depth).outcome(p.speed)


class Mechanism:
    """One of percuss's models, converted to MJCF by loops.py, with a stop in front of the contact of a report of
    `percuss mass`: a small sphere about the contact point and a plane that touches it. Pose, point and normal come
    from the report.

    The sphere belongs to the body to which the contact link is welded, as when MuJoCo reads a URDF (fusestatic)."""

    def __init__(self, path, report):
        text, _ = mjcf(path)
        self.spec = mujoco.MjSpec.from_string(text)
        for joint in ElementTree.parse(path).getroot().findall("joint"):
            dynamics = joint.find("dynamics")
            if joint.get("type") != "fixed" and dynamics is not None:
                self.spec.joint(joint.get("name")).armature = float(dynamics.get("armature", 0))
        for joint, values in report["conditions"]["armature"].items():
            self.spec.joint(joint).armature = values[0] if isinstance(values, list) else values
        bare = self.spec.compile()
        self.pose = bare.qpos0.copy()
        for joint, values in report["pose"].items():
            address = bare.joint(joint).qposadr[0]
            self.pose[address : address + len(values)] = values
        self.stop(bare, report)
        self.model = self.spec.compile()
        self.probed = mujoco.MjData(self.model)

    def stop(self, bare, report):
        """Places the stop in front of the contact."""
        contact = report["contact"]
        self.normal = np.array(contact["normal_world"])
        data = mujoco.MjData(bare)
        data.qpos[:] = self.pose
        mujoco.mj_kinematics(bare, data)
        self.body = bare.body_weldid[bare.body(contact["link"]).id]
        point = np.array(contact["point_world"])
        local = data.xmat[self.body].reshape(3, 3).T @ (point - data.xpos[self.body])
        name = bare.body(self.body).name
        self.spec.body(name).add_geom(name="struck", type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[RADIUS, 0, 0], pos=local, mass=0)
        self.spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_PLANE,
            size=[1, 1, 0.1],
            pos=point + RADIUS * self.normal,
            quat=facing(-self.normal),
        )

    def depth(self, data):
        """Penetration of the contact; None without a contact."""
        return -data.contact[0].dist if data.ncon else None

    def impact(self, parameters, speed):
        """The outcome, and the pose of the deepest penetration."""
        impact = Impact(dress(self.spec.copy(), parameters), self.pose, self.opening(), self.opening_speed, self.depth)
        return impact.outcome(speed), impact.deepest

    def inverse_diagonal(self):
        """Â, MuJoCo's approximation of the contact's inverse mass."""
        return self.model.body_invweight0[self.body][0]

    def effective_mass(self, pose):
        return least_energy(*self.matrices(pose))

    def matrices(self, pose):
        """Mass matrix, rows of the equality constraints, row of the contact."""
        m, d = self.model, self.probed
        d.qpos[:] = pose
        mujoco.mj_fwdPosition(m, d)
        mass = np.zeros((m.nv, m.nv))
        mujoco.mj_fullM(m, d, mass)
        rows = d.efc_J.reshape(d.nefc, m.nv)[d.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]
        return mass, rows, self.row(m, d)

    def row(self, model, data):
        """Opening rate of the gap per joint rate. The sphere's centre and its contact are on one normal."""
        jacobian = np.zeros((3, model.nv))
        mujoco.mj_jacGeom(model, data, jacobian, None, model.geom("struck").id)
        return self.normal @ jacobian

    def opening(self):
        """The motion of least energy that satisfies the loops and opens the gap at 1 m/s: the motion excited by an
        impact."""
        mass, rows, row = self.matrices(self.pose)
        # Stationary energy under both kinds of constraint; least squares, because rows may be redundant.
        held = np.vstack([rows, row])
        n = len(mass)
        system = np.block([[mass, held.T], [held, np.zeros((len(held), len(held)))]])
        wanted = np.zeros(len(system))
        wanted[-1] = -1
        return np.linalg.lstsq(system, wanted)[0][:n]

    def opening_speed(self, data):
        model = data.model
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        return -self.row(model, data) @ data.qvel


class LimitedJoint(Mechanism):
    """One of percuss's models with an end of a joint's range (1 the upper, -1 the lower) at the joint's position in
    a report of `percuss mass`."""

    def __init__(self, path, report, joint, end=1):
        self.joint, self.end = joint, end
        super().__init__(path, report)

    def stop(self, bare, report):
        (at,) = report["pose"][self.joint]
        limited = self.spec.joint(self.joint)
        limited.limited = mujoco.mjtLimited.mjLIMITED_TRUE
        limited.range = [at - 100, at] if self.end > 0 else [at, at + 100]
        self.dof = bare.joint(self.joint).dofadr[0]

    def inverse_diagonal(self):
        return self.model.dof_invweight0[self.dof]

    def row(self, model, data):
        row = np.zeros(model.nv)
        row[self.dof] = self.end
        return row

    def depth(self, data):
        limits = data.efc_pos[data.efc_type == mujoco.mjtConstraint.mjCNSTR_LIMIT_JOINT]
        return -limits[0] if len(limits) else None


def facing(normal):
    """Quaternion of a rotation from z to a direction."""
    x = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    x /= np.linalg.norm(x)
    return [float(q) for q in quaternion(np.column_stack([x, np.cross(normal, x), normal])).split()]


class Impact:
    """A model about to touch: its touching pose, the joint rates that open its gap, and the opening speed."""

    def __init__(self, model, pose, opening, opening_speed, depth):
        self.model, self.pose, self.opening = model, pose, opening
        self.opening_speed, self.depth_of = opening_speed, depth
        self.depth, self.deepest = 0.0, pose

    def outcome(self, speed):
        return Outcome.of(lambda phase: self.run(speed, phase))

    def run(self, speed, phase):
        model, data = self.model, mujoco.MjData(self.model)
        data.qpos[:] = self.pose
        mujoco.mj_integratePos(model, data.qpos, self.opening, phase * speed * model.opt.timestep)
        data.qvel[:] = -speed * self.opening
        depth, touched = 0.0, False
        for _ in range(STEPS):
            mujoco.mj_step(model, data)
            if (now := self.depth_of(data)) is not None:
                touched = True
                depth = max(depth, now)
                if depth > self.depth:
                    self.depth, self.deepest = depth, data.qpos.copy()
            elif touched:
                return self.opening_speed(data) / speed, depth
        raise RuntimeError("the impact did not end")

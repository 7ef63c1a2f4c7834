"""Model of a USD stage in memory (UsdPhysics), written as URDF and read by percuss."""

from __future__ import annotations

import math
import warnings
from collections import deque
from dataclasses import dataclass, field, replace
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from ._from_memory import _numbers, _read, _rpy, _tensor
from ._percuss import Model
from ._usd_shapes import unit_shape
from .errors import InputError, ModelWarning

_Array = NDArray[np.float64]
_GROUND = "world"
_AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
_DEGREES = ("transX", "transY", "transZ", "rotX", "rotY", "rotZ")
# Attributes of an armature, in units of the stage.
_ARMATURES = ("newton:armature", "physxJoint:armature", "mjc:armature")


@dataclass(frozen=True)
class _Coupling:
    """q = factor · q of the leader + offset (rad, m).

    factor: in degrees and lengths of the stage; in_radians: in radians and lengths of the stage.
    """

    leader: str
    degree: str
    factor: float
    offset: float
    in_radians: bool = False


@dataclass(frozen=True)
class _Motion:
    """Part of a joint: kind "hinge", "slide" or "ball". The parts follow each other from body 0 to body 1.

    degree: name of UsdPhysics, such as "rotX". low, high: rad or m. before: placement after the previous part, 4×4, m.
    """

    path: str
    kind: str
    degree: str
    low: float = -math.inf
    high: float = math.inf
    before: _Array = field(default_factory=lambda: np.eye(4))
    armature: float = 0.0
    coupling: _Coupling | None = None

    @property
    def axis(self) -> tuple[float, float, float]:
        return _AXES[self.degree[-1]]


@dataclass(frozen=True)
class _Joint:
    """Joint of the stage. bodies: path of the prim or _GROUND; frames: of the joint in the bodies, 4×4, m.

    sequence: one of several joints of a body, as in MJCF. distance: m, of a distance joint.
    """

    path: str
    bodies: tuple[str, str]
    frames: tuple[_Array, _Array]
    motions: list[_Motion]
    loop: bool
    distance: float | None = None
    sequence: bool = False

    def drawn(self) -> _Array:
        """Placement of body 1 in body 0 with the joint at zero."""
        return self.last() @ _inverse(self.frames[1])

    def last(self) -> _Array:
        """Placement of the last part in body 0 with the joint at zero."""
        frame = self.frames[0]
        for motion in self.motions:
            frame = frame @ motion.before
        return frame


def _held(degree: str, value: float) -> _Array:
    """Placement of a degree of freedom held at a value, rad or m."""
    x, frame = np.asarray(_AXES[degree[-1]]), np.eye(4)
    if degree.startswith("trans"):
        frame[:3, 3] = value * x
        return frame
    cross = np.array([[0.0, -x[2], x[1]], [x[2], 0.0, -x[0]], [-x[1], x[0], 0.0]])
    frame[:3, :3] += math.sin(value) * cross + (1.0 - math.cos(value)) * cross @ cross
    return frame


def _rotation(quaternion: Any) -> _Array:
    """Rotation matrix of a quaternion of USD."""
    w, (x, y, z) = float(quaternion.GetReal()), (float(v) for v in quaternion.GetImaginary())
    n = w * w + x * x + y * y + z * z
    if not n > 0.0:
        raise InputError(f"the quaternion {quaternion} has no length; expected w, x, y, z of a rotation")
    q = np.array([[-y * y - z * z, x * y - w * z, x * z + w * y], [x * y + w * z, -x * x - z * z, y * z - w * x],
                  [x * z - w * y, y * z + w * x, -x * x - y * y]])
    return np.eye(3) + 2.0 / n * q


def _frame(position: Any, rotation: Any, metre: float) -> _Array:
    frame = np.eye(4)
    frame[:3, :3] = _rotation(rotation)
    frame[:3, 3] = metre * np.array([float(x) for x in position])
    return frame


def _inverse(frame: _Array) -> _Array:
    inverse = np.eye(4)
    inverse[:3, :3] = frame[:3, :3].T
    inverse[:3, 3] = -frame[:3, :3].T @ frame[:3, 3]
    return inverse


def _origin(frame: _Array) -> str:
    return f'<origin xyz="{_numbers(frame[:3, 3])}" rpy="{_numbers(_rpy(frame[:3, :3]))}"/>'


class _Names:
    """Names of prims; a path, if several prims have the name."""

    def __init__(self, paths: list[str]) -> None:
        count: dict[str, int] = {_GROUND: 2}
        for path in paths:
            last = path.rsplit("/", 1)[-1]
            count[last] = count.get(last, 0) + 1
        self.of = {path: path if count[path.rsplit("/", 1)[-1]] > 1 else path.rsplit("/", 1)[-1] for path in paths}
        self.of[_GROUND] = _GROUND


class _Reader:
    def __init__(self, stage: Any, prim: str) -> None:
        try:
            from pxr import UsdGeom, UsdPhysics
        except ImportError as error:
            raise InputError("a stage of USD needs the package usd-core: pip install usd-core") from error
        self.physics = UsdPhysics
        self.stage, self.prim = stage, prim
        self.metre = float(UsdGeom.GetStageMetersPerUnit(stage))
        self.kilogram = float(UsdPhysics.GetStageKilogramsPerUnit(stage))
        up = str(UsdGeom.GetStageUpAxis(stage))
        # The vertical of the stage becomes z.
        self.upright = np.eye(4)
        if up == "Y":
            self.upright[:3, :3] = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]
        load = getattr(UsdPhysics, "UsdPhysicsLoadStageFromPrimRange", None) or UsdPhysics.LoadUsdPhysicsFromRange
        self.found: dict[str, list[Any]] = {}
        for kind, (_, descriptions) in load(stage, [prim]).items():
            for description in descriptions:
                if not description.isValid and kind.name.endswith(("Body", "Joint", "Shape")):
                    raise InputError(f'"{description.primPath}" is no valid {kind.name} of UsdPhysics; correct or deactivate it')
            self.found[kind.name] = list(descriptions)
        self.bodies: dict[str, Any] = {}
        self.fixed: dict[str, _Array] = {}
        for body in self.found.get("RigidBody", []):
            path = str(body.primPath)
            if body.rigidBodyEnabled and not body.kinematicBody:
                self.bodies[path] = body
                continue
            self.fixed[path] = self.placement(body)
            if body.rigidBodyEnabled:
                warnings.warn(f'body "{path}" is kinematic: it is part of the ground', ModelWarning, stacklevel=4)
        if not self.bodies:
            raise InputError(
                f'the stage has no rigid body below "{prim}"; expected prims with PhysicsRigidBodyAPI. A stage that refers to '
                "files needs them: Usd.Stage.Open(path)"
            )

    def placement(self, body: Any) -> _Array:
        """Drawn placement of a body in the world, z up, m."""
        return self.upright @ _frame(body.position, body.rotation, self.metre)

    def inertia(self, body: Any) -> str:
        """Text of an inertial: attributes of MassAPI; where they are missing, those of the colliders."""
        shapes = {
            str(shape.primPath): shape
            for kind in self.found
            if kind.endswith("Shape")
            for shape in self.found[kind]
            if str(shape.rigidBody) == str(body.primPath)
        }
        refused: list[str] = []
        physics = self.physics

        def information(prim: Any) -> Any:
            result = physics.RigidBodyAPI.MassInformation()
            result.volume, result.inertia = 0.0, type(result.inertia)(0.0)
            shape = shapes.get(str(prim.GetPath()))
            if shape is None or not shape.collisionEnabled:
                if physics.MassAPI(prim) and physics.MassAPI(prim).GetMassAttr().Get():
                    refused.append(f'collider "{prim.GetPath()}" is disabled and has a mass; give the mass to its body')
                return result
            try:
                volume, centre, tensor, turn = unit_shape(prim, shape)
            except InputError as error:
                refused.append(str(error))
                return result
            result.volume = volume
            result.centerOfMass = type(result.centerOfMass)(*centre.tolist())
            result.inertia = type(result.inertia)(*tensor.ravel().tolist())
            result.localPos, result.localRot = shape.localPos, type(shape.localRot)(*turn)
            return result

        prim = self.stage.GetPrimAtPath(body.primPath)
        mass_api = physics.MassAPI(prim)
        has_mass = bool(mass_api and mass_api.GetMassAttr().Get())
        has_inertia = bool(mass_api and any(mass_api.GetDiagonalInertiaAttr().Get() or ()))
        has_centre = bool(mass_api and all(math.isfinite(x) for x in mass_api.GetCenterOfMassAttr().Get() or (math.inf,)))
        authored = has_mass and has_inertia and has_centre
        if not shapes and not has_mass:
            return ""
        if has_mass and not has_inertia and not any(shape.collisionEnabled for shape in shapes.values()):
            # UsdPhysics would take a sphere of 0.1 units.
            raise InputError(
                f'body "{body.primPath}" has a mass, but neither physics:diagonalInertia nor an enabled collider; expected one of them'
            )
        mass, diagonal, centre, axes = physics.RigidBodyAPI(prim).ComputeMassProperties(information)
        if refused and not authored:
            raise InputError(f'body "{body.primPath}": {refused[0]}')
        if not mass > 0.0:
            return ""
        turn = _rotation(axes)
        tensor = self.kilogram * self.metre**2 * turn @ np.diag([float(x) for x in diagonal]) @ turn.T
        com = self.metre * np.array([float(x) for x in centre])
        mass_text = f'<mass value="{self.kilogram * float(mass)!r}"/>'
        return f'<inertial><origin xyz="{_numbers(com)}"/>{mass_text}{_tensor(tensor)}</inertial>'

    def joints(self) -> list[_Joint]:
        found = []
        for kind, descriptions in self.found.items():
            if not kind.endswith("Joint"):
                continue
            for joint in descriptions:
                if joint.jointEnabled:
                    found.append(self.joint(kind.removesuffix("Joint"), joint))
        order: dict[str, int] = {}
        for prim in self.stage.Traverse():
            order[str(prim.GetPath())] = len(order)
            kind = str(prim.GetTypeName())
            if "Joint" in kind and not prim.IsA(self.physics.Joint) and prim.GetPath().HasPrefix(self.prim):
                raise InputError(f'"{prim.GetPath()}" is a {kind}, which is not read; deactivate it for results without it')
        return sorted((joint for joint in found if joint), key=lambda joint: order.get(joint.path, len(order)))

    def side(self, joint: Any, number: int) -> tuple[str, _Array]:
        """Body and joint frame of one side."""
        body, end = str(getattr(joint, f"body{number}")), str(getattr(joint, f"rel{number}"))
        position, rotation = getattr(joint, f"localPose{number}Position"), getattr(joint, f"localPose{number}Orientation")
        frame = _frame(position, rotation, self.metre)
        if body in self.bodies:
            return body, frame
        if body in self.fixed:
            return _GROUND, self.fixed[body] @ frame
        if body and (prim := self.stage.GetPrimAtPath(body)) and prim.HasAPI(self.physics.RigidBodyAPI):
            raise InputError(f'joint "{joint.primPath}" ends at "{body}", which is outside the given prim; give a prim with both bodies')
        if end and not self.stage.GetPrimAtPath(end):
            raise InputError(f'joint "{joint.primPath}" ends at "{end}", which is no prim of the stage')
        return _GROUND, self.upright @ frame

    def joint(self, kind: str, joint: Any) -> _Joint | None:
        path, prim = str(joint.primPath), self.stage.GetPrimAtPath(joint.primPath)
        (body0, frame0), (body1, frame1) = self.side(joint, 0), self.side(joint, 1)
        if body0 == body1:
            if body0 == _GROUND:
                return None
            raise InputError(f'joint "{path}" joins "{body0}" with itself; expected two bodies')
        distance: float | None = None
        motions: list[_Motion] = []
        if kind == "Revolute":
            motions = [_Motion(path, "hinge", f"rot{joint.axis.name}", *self.range(path, joint.limit, "rot"))]
        elif kind == "Prismatic":
            motions = [_Motion(path, "slide", f"trans{joint.axis.name}", *self.range(path, joint.limit, "trans"))]
        elif kind == "Spherical":
            motions = [_Motion(path, "ball", "rotX")]
            if joint.limit.enabled:
                warnings.warn(f'the cone that limits the joint "{path}" is left out', ModelWarning, stacklevel=5)
        elif kind == "D6":
            motions, after = self.freedoms(joint)
            frame1 = frame1 @ _inverse(after)
        elif kind == "Distance":
            if not (joint.minEnabled and joint.maxEnabled and joint.limit.lower == joint.limit.upper):
                warnings.warn(f'joint "{path}" limits a distance: results are without it', ModelWarning, stacklevel=5)
                return None
            distance = self.metre * float(joint.limit.lower)
        elif kind != "Fixed":
            raise InputError(
                f'joint "{path}" is a {prim.GetTypeName()}, which is not read; expected fixed, revolute, prismatic, spherical, '
                "distance and D6 joints. Set its physics:jointEnabled to false for results without it"
            )
        armature, couplings = self.armature(prim), self.couplings(prim, motions)
        if couplings.keys() - {motion.degree for motion in motions} or (armature and not motions):
            raise InputError(f'joint "{path}" has an armature or a mimic of a degree of freedom that it does not have')
        motions = [
            replace(
                motion,
                armature=armature * (1.0 if motion.kind == "slide" else self.metre**2),
                coupling=couplings.get(motion.degree),
            )
            for motion in motions
        ]
        sequence = any(attribute.GetName().startswith("mjc:") for attribute in prim.GetAuthoredAttributes())
        loop = bool(joint.excludeFromArticulation) or distance is not None
        return _Joint(path, (body0, body1), (frame0, frame1), motions, loop, distance, sequence)

    def armature(self, prim: Any) -> float:
        """Armature in kg and units of length of the stage."""
        found = {name: float(value) for name in _ARMATURES if (value := self.attribute(prim, name))}
        if len(set(found.values())) > 1:
            raise InputError(f'joint "{prim.GetPath()}" has several armatures: {found}; expected one value')
        return self.kilogram * next(iter(found.values()), 0.0)

    @staticmethod
    def attribute(prim: Any, name: str) -> Any:
        attribute = prim.GetAttribute(name)
        return attribute.Get() if attribute else None

    def range(self, path: str, limit: Any, degree: str) -> tuple[float, float]:
        """Limits in rad or m. Without limits: infinite."""
        if not limit.enabled:
            return -math.inf, math.inf
        unit = math.radians(1.0) if degree.startswith("rot") else self.metre
        low, high = (unit * x if abs(x) < 1e30 else x * math.inf for x in (float(limit.lower), float(limit.upper)))
        if math.isinf(low) != math.isinf(high):
            warnings.warn(f'joint "{path}" has a limit on one side, which is left out', ModelWarning, stacklevel=6)
        return low, high

    def freedoms(self, joint: Any) -> tuple[list[_Motion], _Array]:
        """Parts of a D6 joint, and the placement of the second frame after the last part."""
        path = str(joint.primPath)
        limits = {pair.first.name[0].lower() + pair.first.name[1:]: pair.second for pair in joint.jointLimits}
        if "distance" in limits and limits["distance"].enabled:
            raise InputError(f'joint "{path}" limits a distance; expected limits of trans and rot')
        prim = self.stage.GetPrimAtPath(joint.primPath)
        unused = [
            name
            for name in prim.GetPropertyNames()
            if name.startswith("limit:") and name.split(":")[1] in _DEGREES and name.split(":")[1] not in limits
        ]
        if unused:
            raise InputError(
                f'joint "{path}" has {unused[0]}, but not the schema PhysicsLimitAPI of that axis, without which it is free; '
                "expected both or none"
            )
        motions: list[_Motion] = []
        before = np.eye(4)
        for degree in _DEGREES:
            low, high = self.range(path, limits[degree], degree) if degree in limits else (-math.inf, math.inf)
            if low < high:
                kind = "slide" if degree.startswith("trans") else "hinge"
                motions.append(_Motion(path, kind, degree, low, high, before))
                before = np.eye(4)
            elif low == high:
                before = before @ _held(degree, low)
        turns = [motion for motion in motions if motion.kind == "hinge"]
        if len(turns) == 3 and all(math.isinf(motion.low) and math.isinf(motion.high) for motion in turns):
            motions = [*motions[:-3], _Motion(path, "ball", "rotX", before=turns[0].before)]
        return motions, before

    def couplings(self, prim: Any, motions: list[_Motion]) -> dict[str, _Coupling]:
        """Mimics of Newton (q = c₀ + c₁ q of the leader) and PhysX (q + g q of the reference + o = 0), by degree of freedom."""

        def value(name: str, otherwise: float) -> float:
            found = self.attribute(prim, name)
            return otherwise if found is None else float(found)

        def target(name: str) -> str | None:
            relation = prim.GetRelationship(name)
            targets = relation.GetTargets() if relation else []
            return str(targets[0].MakeAbsolutePath(prim.GetPath().GetParentPath())) if targets else None

        def unit(degree: str) -> float:
            return math.radians(1.0) if degree.startswith("rot") else self.metre

        found: dict[str, _Coupling] = {}
        own = motions[0].degree if len(motions) == 1 else ""
        if (leader := target("newton:mimicJoint") or target("mjc:target")) and value("newton:mimicEnabled", 1.0):
            if not own or any(value(f"mjc:coef{n}", 0.0) for n in range(2, 5)):
                raise InputError(
                    f'joint "{prim.GetPath()}" follows "{leader}" by a curve, or has several degrees of freedom; expected one factor and one offset'
                )
            constant = value("newton:mimicCoef0", math.nan) * unit(own)
            metre = self.metre if own.startswith("trans") else 1.0
            offset = metre * value("mjc:coef0", 0.0) if math.isnan(constant) else constant
            factor = value("newton:mimicCoef1", math.nan)
            in_radians = math.isnan(factor)
            found[own] = _Coupling(leader, "", value("mjc:coef1", 1.0) if in_radians else factor, offset, in_radians)
        at = "physxMimicJoint:"
        for degree in sorted({name.split(":")[1] for name in prim.GetPropertyNames() if name.startswith(at)}):
            leader = target(f"{at}{degree}:referenceJoint")
            if leader is None:
                raise InputError(f'joint "{prim.GetPath()}" has {at}{degree} without referenceJoint; expected the joint that leads')
            leads = str(self.attribute(prim, f"{at}{degree}:referenceJointAxis") or "")
            gearing, offset = value(f"{at}{degree}:gearing", 1.0), value(f"{at}{degree}:offset", 0.0)
            if (own or degree) in found:
                raise InputError(f'joint "{prim.GetPath()}" has several mimics; expected one')
            found[own or degree] = _Coupling(leader, leads, -gearing, -offset * unit(own or degree))
        return found


class _Writer:
    """Text of the robot: a tree from the root, closed by loops."""

    def __init__(self, joints: list[_Joint], links: _Names, metre: float) -> None:
        self.lines: list[str] = []
        self.metre = metre
        self.links = links
        freedoms = [motion for joint in joints for motion in joint.motions]
        self.names = _Names(sorted({joint.path for joint in joints} | {motion.path for motion in freedoms}))
        self.coordinates: dict[tuple[str, str], str] = {}
        for motion in freedoms:
            several = sum(other.path == motion.path for other in freedoms) > 1
            self.coordinates[motion.path, motion.degree] = self.names.of[motion.path] + (f":{motion.degree}" if several else "")

    def connect(self, name: str, kind: str, parent: str, child: str, frame: _Array, extra: str = "") -> None:
        self.lines.append(
            f"<joint name={quoteattr(name)} type={quoteattr(kind)}><parent link={quoteattr(parent)}/>"
            f"<child link={quoteattr(child)}/>{_origin(frame)}{extra}</joint>"
        )

    def extras(self, motion: _Motion, reverse: bool) -> str:
        """Limits, axis, armature and mimic of a part."""
        text = ""
        if math.isfinite(motion.low) and math.isfinite(motion.high):
            text = f'<limit lower="{motion.low!r}" upper="{motion.high!r}" effort="0" velocity="0"/>'
        if motion.kind != "ball":
            text += f'<axis xyz="{_numbers(-x if reverse else x for x in motion.axis)}"/>'
        if motion.armature:
            text += f'<dynamics armature="{motion.armature!r}"/>'
        if (coupling := motion.coupling) is not None:
            degrees = [degree for path, degree in self.coordinates if path == coupling.leader]
            if coupling.degree not in degrees and len(degrees) != 1:
                raise InputError(
                    f'joint "{motion.path}" follows "{coupling.leader}", which has the degrees of freedom {degrees}; expected one, or its axis'
                )
            degree = coupling.degree if coupling.degree in degrees else degrees[0]
            angle = 1.0 if coupling.in_radians else math.radians(1.0)
            own, other = (angle if name.startswith("rot") else self.metre for name in (motion.degree, degree))
            leader = self.coordinates[coupling.leader, degree]
            factor = coupling.factor * own / other
            text += f'<mimic joint={quoteattr(leader)} multiplier="{factor!r}" offset="{coupling.offset!r}"/>'
        return text

    def chain(self, joint: _Joint, parent: str, child: str | None, reverse: bool) -> tuple[str, _Array]:
        """Joints from the parent over all parts to the child; without a child: last link, and the joint's second frame in it."""
        # Placements between the parts, from body 0 to body 1.
        between = [joint.frames[0] @ joint.motions[0].before, *(motion.before for motion in joint.motions[1:])] if joint.motions else []
        between.append(_inverse(joint.frames[1]) if joint.motions else joint.drawn())
        motions = joint.motions
        if reverse:
            between, motions = [_inverse(frame) for frame in between[::-1]], motions[::-1]
        here = parent
        for number, motion in enumerate(motions):
            name = self.coordinates[motion.path, motion.degree]
            ends = child is not None and number + 1 == len(motions) and np.array_equal(between[-1], np.eye(4))
            link = child if ends and child is not None else f"{name} (frame)"
            kind = {"hinge": "revolute", "slide": "prismatic", "ball": "spherical"}[motion.kind]
            if kind == "revolute" and not (math.isfinite(motion.low) and math.isfinite(motion.high)):
                kind = "continuous"
            if not ends:
                self.lines.append(f"<link name={quoteattr(link)}/>")
            self.connect(name, kind, here, link, between[number], self.extras(motion, reverse))
            here = link
            if ends:
                return here, np.eye(4)
        if child is not None:
            self.connect(self.names.of[joint.path] + (" (frame)" if motions else ""), "fixed", here, child, between[-1])
        return here, np.eye(4) if motions else joint.frames[0]

    def loop(self, joint: _Joint) -> None:
        one, two = (self.links.of[body] for body in joint.bodies)
        if any(motion.armature or motion.coupling for motion in joint.motions):
            raise InputError(
                f'joint "{joint.path}" closes a loop and has an armature or a mimic, which only joints of the tree have; exclude another '
                "joint of the loop from the articulation"
            )
        first, second = joint.frames
        kinds: dict[tuple[str, ...], str] = {("hinge",): "revolute", ("slide",): "prismatic", ("ball",): "spherical"}
        straight = all(np.array_equal(motion.before, np.eye(4)) for motion in joint.motions)
        kind = kinds.get(tuple(motion.kind for motion in joint.motions)) if straight else None
        axis = f'<axis xyz="{_numbers(joint.motions[0].axis)}"/>' if kind in ("revolute", "prismatic") else ""
        if joint.distance is not None:
            kind, axis = "distance", f'<distance value="{joint.distance!r}"/>'
        elif kind is None:
            kind = "fixed"
            one, first = self.chain(joint, one, None, reverse=False)
        self.lines.append(
            f"<loop name={quoteattr(self.names.of[joint.path] + (' (loop)' if kind == 'fixed' and joint.motions else ''))} type=\"{kind}\">"
            f"<predecessor link={quoteattr(one)}>{_origin(first)}</predecessor>"
            f"<successor link={quoteattr(two)}>{_origin(second)}</successor>{axis}</loop>"
        )


def _merged(joints: list[_Joint]) -> list[_Joint]:
    """Joints, those of one body in sequence as one.

    Joint i places body 1 in body 0 by A_i M_i(q_i) B_i⁻¹ (A, B its frames; M = 1 at zero), with one drawn placement T = A_i B_i⁻¹. As in
    MJCF, joints in sequence are A₁ M₁ A₁⁻¹ A₂ M₂ … A_n⁻¹ T = A₁ M₁ (A₁⁻¹ A₂) M₂ … M_n B_n⁻¹.
    """
    first: dict[frozenset[str], int] = {}
    merged: list[_Joint] = []
    for joint in joints:
        pair = frozenset(joint.bodies)
        if joint.loop or pair not in first:
            if not joint.loop:
                first.setdefault(pair, len(merged))
            merged.append(joint)
            continue
        before = merged[first[pair]]
        same = before.bodies == joint.bodies and before.sequence and joint.sequence and before.motions and joint.motions
        if not (same and np.allclose(before.drawn(), joint.drawn(), rtol=0.0, atol=1e-5)):
            raise InputError(
                f'joints "{before.path}" and "{joint.path}" join the same bodies; expected one joint with both degrees of freedom (D6), '
                "physics:excludeFromArticulation for one that holds in addition to the other, or attributes mjc: for a sequence as in MJCF"
            )
        between = _inverse(before.last()) @ joint.frames[0] @ joint.motions[0].before
        opened = replace(joint.motions[0], before=between)
        merged[first[pair]] = replace(
            before, frames=(before.frames[0], joint.frames[1]), motions=[*before.motions, opened, *joint.motions[1:]]
        )
    return merged


def from_usd(stage: Any, *, prim: str = "/", name: str | None = None) -> Model:
    """Model of a Usd.Stage in memory (package usd-core): rigid bodies, masses, joints, armatures, mimics.

    The stage's metersPerUnit and kilogramsPerUnit give SI units; its vertical becomes z. The link of a body has the frame of the body.
    Mass, centre and inertia are those of MassAPI; where they are missing, those of the enabled colliders with the densities of
    UsdPhysics. Joints with excludeFromArticulation, and joints whose bodies the joints before them have joined, close loops. Zero of a
    joint: its two frames coincide. D6 joints are slides, then hinges about x, y, z (a ball, if all three are free), named "JOINT:rotX".
    Armatures: newton:armature, physxJoint:armature, mjc:armature. prim: path of the robot, if the stage has several. Bodies without a
    joint to the ground: one group becomes the base (Model.system(base="floating"); its link with PhysicsArticulationRootAPI, or the first
    that is the second body of no joint), several have free joints in a link "world".
    Kinematic bodies are part of the ground, with a ModelWarning. Raises InputError for other joints, two joints between the same
    bodies, open meshes without inertia, couplings by curves.

        >>> percuss.from_usd(Usd.Stage.Open("robot.usda"))
    """
    reader = _Reader(stage, prim)
    joints = _merged(reader.joints())
    links = _Names(list(reader.bodies))
    writer = _Writer(joints, links, reader.metre)
    near: dict[str, list[_Joint]] = {}
    for joint in joints:
        if not joint.loop:
            for body in joint.bodies:
                near.setdefault(body, []).append(joint)
    children = {joint.bodies[1] for joint in joints if not joint.loop}
    root = reader.physics.ArticulationRootAPI
    starts = sorted(reader.bodies, key=lambda body: (not stage.GetPrimAtPath(body).HasAPI(root), body in children))
    reached: set[str] = set()
    loops = [joint for joint in joints if joint.loop]
    done: set[str] = set()

    def walk(start: str) -> None:
        reached.add(start)
        queue = deque([start])
        while queue:
            body = queue.popleft()
            for joint in near.get(body, []):
                if joint.path in done:
                    continue
                done.add(joint.path)
                child = joint.bodies[1] if joint.bodies[0] == body else joint.bodies[0]
                if child in reached:
                    loops.append(joint)
                    continue
                writer.chain(joint, links.of[body], links.of[child], reverse=joint.bodies[1] == body)
                reached.add(child)
                queue.append(child)

    groups = []
    if _GROUND in near or any(_GROUND in joint.bodies for joint in loops):
        walk(_GROUND)
    grounded = bool(reached)
    for start in starts:
        if start not in reached:
            groups.append(start)
            walk(start)
    if grounded or len(groups) > 1:
        for start in groups:
            frame = reader.placement(reader.bodies[start])
            writer.connect(f"{links.of[start]} (free)", "floating", _GROUND, links.of[start], frame)
        reached.add(_GROUND)
    for joint in loops:
        writer.loop(joint)
    text = [f"<link name={quoteattr(links.of[body])}>{reader.inertia(reader.bodies[body])}</link>" for body in reader.bodies]
    if _GROUND in reached:
        text.insert(0, f'<link name="{_GROUND}"/>')
    own = name or (stage.GetDefaultPrim().GetName() if stage.GetDefaultPrim() else "") or "usd"
    return _read("\n".join([f"<robot name={quoteattr(own)}>", *text, *writer.lines, "</robot>"]), own)

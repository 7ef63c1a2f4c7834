"""Models of programs in memory, written as URDF or MJCF and read by percuss."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Sequence
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from ._percuss import Model, loads
from .errors import InputError

def _numbers(values: Iterable[float]) -> str:
    return " ".join(repr(float(x)) for x in values)


def _rpy(rotation: Any) -> tuple[float, float, float]:
    """Roll, pitch, yaw of a rotation matrix."""
    r = np.asarray(rotation, dtype=np.float64)
    pitch = math.atan2(-r[2, 0], math.hypot(r[0, 0], r[1, 0]))
    if math.hypot(r[0, 0], r[1, 0]) < 1e-9:
        # Pitch of a right angle: roll and yaw are about one axis.
        return math.atan2(-r[1, 2], r[1, 1]), pitch, 0.0
    return math.atan2(r[2, 1], r[2, 2]), pitch, math.atan2(r[1, 0], r[0, 0])


def _origin(placement: Any) -> str:
    return f'<origin xyz="{_numbers(placement.translation)}" rpy="{_numbers(_rpy(placement.rotation))}"/>'


def _tensor(i: Any) -> str:
    parts = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
    return "<inertia " + " ".join(f'{name}="{float(i[at])!r}"' for name, at in parts.items()) + "/>"


def _read(text: str, name: str) -> Model:
    """Model of a text; its warnings have the line of the caller of from_pinocchio or from_mujoco."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        model = loads(text, name=name)
    for warning in found:
        warnings.warn(str(warning.message), warning.category, stacklevel=3)
    return model


def from_pinocchio(model: Any, *, name: str | None = None) -> Model:
    """Model of a pinocchio.Model in memory: its joints, inertias, armatures, limits, and body frames as links.

    A free-flyer at the root becomes the base: use Model.system(base="floating"). The link of joint J is named as the body
    frame at J's origin, else J. Raises InputError for composite joints, which URDF does not have.

        >>> percuss.from_pinocchio(pinocchio.buildModelFromUrdf("arm.urdf"))
    """
    axes = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    bodies: dict[int, list[tuple[str, Any]]] = {}
    for frame in model.frames:
        if "BODY" in str(frame.type):
            # Later versions of Pinocchio warn of `parent`.
            joint = frame.parentJoint if hasattr(frame, "parentJoint") else frame.parent
            bodies.setdefault(int(joint), []).append((str(frame.name), frame.placement))
    links: dict[int, str] = {}
    lines = [f"<robot name={quoteattr(name or str(model.name) or 'pinocchio')}>"]
    free_base = [i for i in range(1, model.njoints) if model.joints[i].nq == 7 and model.parents[i] == 0]
    root = free_base[0] if free_base else 0
    if free_base and sum(1 for parent in list(model.parents)[1:] if parent == 0) > 1:
        raise InputError("the model has a free-flyer and further joints on the universe; expected one root joint")
    for number in range(int(model.njoints)):
        if number == 0 and root:
            continue
        at_origin = [frame for frame, placed in bodies.get(number, []) if placed.isIdentity(0.0)]
        links[number] = at_origin[0] if at_origin else ("universe" if number == 0 else f"{model.names[number]}_link")
    for number, link in links.items():
        inertia = model.inertias[number]
        mass = float(inertia.mass)
        body = ""
        if mass != 0.0 or np.any(np.asarray(inertia.inertia)):
            com = f'<origin xyz="{_numbers(inertia.lever)}"/>'
            body = f'<inertial>{com}<mass value="{mass!r}"/>{_tensor(np.asarray(inertia.inertia))}</inertial>'
        lines.append(f"<link name={quoteattr(link)}>{body}</link>")
        for frame, placed in bodies.get(number, []):
            if frame != link:
                lines.append(f"<link name={quoteattr(frame)}/>")
                lines.append(
                    f'<joint name={quoteattr(frame + " (frame)")} type="fixed"><parent link={quoteattr(link)}/>'
                    f"<child link={quoteattr(frame)}/>{_origin(placed)}</joint>"
                )
    armature = np.asarray(getattr(model, "armature", np.zeros(model.nv)), dtype=np.float64)
    for number in range(1, int(model.njoints)):
        if number == root:
            continue
        joint, own = model.joints[number], str(model.names[number])
        kind = str(joint.shortname())
        extra = ""
        letters = kind.replace("JointModel", "")
        if letters in ("RX", "RY", "RZ", "RUBX", "RUBY", "RUBZ"):
            axis: Sequence[float] = axes[letters[-1]]
            motion = "continuous" if "UB" in letters else "revolute"
        elif letters in ("PX", "PY", "PZ"):
            axis, motion = axes[letters[-1]], "prismatic"
        elif letters in ("RevoluteUnaligned", "RevoluteUnboundedUnaligned", "PrismaticUnaligned"):
            inner = joint.extract() if hasattr(joint, "extract") else joint
            axis = [float(x) for x in inner.axis]
            motion = "prismatic" if letters.startswith("P") else "continuous" if "Unbounded" in letters else "revolute"
        elif letters == "Spherical":
            axis, motion = (1, 0, 0), "spherical"
        elif letters == "FreeFlyer":
            axis, motion = (1, 0, 0), "floating"
        elif letters == "Planar":
            axis, motion = (0, 0, 1), "planar"
        else:
            raise InputError(
                f'joint "{own}" is a {kind}; expected hinges, slides, balls, planar and free joints. Load the file that the '
                "model was read from"
            )
        if motion in ("revolute", "prismatic"):
            q = int(joint.idx_q)
            low, high = float(model.lowerPositionLimit[q]), float(model.upperPositionLimit[q])
            if math.isfinite(low) and math.isfinite(high) and low <= high:
                extra += f'<limit lower="{low!r}" upper="{high!r}" effort="0" velocity="0"/>'
            elif motion == "revolute":
                motion = "continuous"
        if motion not in ("spherical", "floating"):
            extra += f'<axis xyz="{_numbers(axis)}"/>'
        rotor = armature[int(joint.idx_v) : int(joint.idx_v) + int(joint.nv)]
        if rotor.any() and len(rotor) == 1:
            extra += f'<dynamics armature="{float(rotor[0])!r}"/>'
        parent = links[int(model.parents[number])]
        lines.append(
            f'<joint name={quoteattr(own)} type="{motion}"><parent link={quoteattr(parent)}/>'
            f"<child link={quoteattr(links[number])}/>{_origin(model.jointPlacements[number])}{extra}</joint>"
        )
    lines.append("</robot>")
    return _read("\n".join(lines), name or str(model.name) or "pinocchio")


def from_mujoco(model: Any, *, name: str = "mujoco") -> Model:
    """Model of a mujoco.MjModel in memory: bodies, joints, armatures, limits, and connect, weld and joint equalities.

    A body with several joints has massless links between them, as in a file of MuJoCo. Raises InputError for tendons' and
    flexes' equalities.

        >>> percuss.from_mujoco(mujoco.MjModel.from_xml_path("arm.xml"))
    """
    mujoco_free, mujoco_kinds = 0, ("free", "ball", "slide", "hinge")

    def quoted(kind: str, number: int) -> str:
        return quoteattr(str(getattr(model, kind)(number).name) or f"{kind} {number}")

    children: dict[int, list[int]] = {}
    for number in range(1, int(model.nbody)):
        children.setdefault(int(model.body_parentid[number]), []).append(number)

    def body(number: int) -> list[str]:
        at = f'pos="{_numbers(model.body_pos[number])}" quat="{_numbers(model.body_quat[number])}"'
        lines = [f"<body name={quoted('body', number)} {at}>"]
        mass = float(model.body_mass[number])
        if mass != 0.0:
            lines.append(
                f'<inertial pos="{_numbers(model.body_ipos[number])}" quat="{_numbers(model.body_iquat[number])}" '
                f'mass="{mass!r}" diaginertia="{_numbers(model.body_inertia[number])}"/>'
            )
        first = int(model.body_jntadr[number])
        for joint in range(first, first + int(model.body_jntnum[number])):
            kind = int(model.jnt_type[joint])
            own = f"name={quoted('joint', joint)}"
            armature = float(model.dof_armature[int(model.jnt_dofadr[joint])])
            if kind == mujoco_free:
                lines.append(f"<freejoint {own}/>")
                continue
            text = f'<joint {own} type="{mujoco_kinds[kind]}" pos="{_numbers(model.jnt_pos[joint])}"'
            text += f' axis="{_numbers(model.jnt_axis[joint])}" armature="{armature!r}"'
            if kind > 1:
                text += f' ref="{float(model.qpos0[int(model.jnt_qposadr[joint])])!r}"'
                if model.jnt_limited[joint]:
                    text += f' limited="true" range="{_numbers(model.jnt_range[joint])}"'
            lines.append(text + "/>")
        for child in children.get(number, []):
            lines += body(child)
        return [*lines, "</body>"]

    lines = [f"<mujoco model={quoteattr(name)}>", '<compiler angle="radian" autolimits="false"/>', "<worldbody>"]
    for child in children.get(0, []):
        lines += body(child)
    lines.append("</worldbody>")
    equalities = []
    for number in range(int(model.neq)):
        if not model.eq_active0[number]:
            continue
        kind, data = int(model.eq_type[number]), model.eq_data[number]
        one, two = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        label = f"name={quoted('equality', number)}"
        if kind == 2:
            second = f" joint2={quoted('joint', two)}" if two >= 0 else ""
            equalities.append(
                f'<joint {label} joint1={quoted("joint", one)}{second} polycoef="{_numbers(data[:5])}"/>'
            )
        elif kind in (0, 1) and int(model.eq_objtype[number]) == 1:
            ends = f"body1={quoted('body', one)}" + (f" body2={quoted('body', two)}" if two > 0 else "")
            if kind == 0:
                equalities.append(f'<connect {label} {ends} anchor="{_numbers(data[:3])}"/>')
            else:
                pose = _numbers([*data[3:6], *data[6:10]])
                equalities.append(f'<weld {label} {ends} anchor="{_numbers(data[:3])}" relpose="{pose}"/>')
        else:
            raise InputError(
                f"equality {number} is of type {kind}; expected connect, weld (of bodies) or joint. Load the file that the "
                "model was compiled from"
            )
    if equalities:
        lines += ["<equality>", *equalities, "</equality>"]
    lines.append("</mujoco>")
    return _read("\n".join(lines), name)


__all__ = ["from_mujoco", "from_pinocchio"]
